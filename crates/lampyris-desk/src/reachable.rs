//! By which address others reach a desk that listens on all of this machine's: what links and their codes name.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, UdpSocket};

/// Addresses kept for documents (RFC 5737, RFC 3849): nobody is there, and nothing is sent. The way that would be taken there
/// is the way out of this machine, and begins at one of its addresses.
const AWAY: [IpAddr; 2] =
    [IpAddr::V4(Ipv4Addr::new(192, 0, 2, 1)), IpAddr::V6(Ipv6Addr::new(0x2001, 0xdb8, 0, 0, 0, 0, 0, 1))];

/// The same address, or one of this machine's where it stands for all of them: that of the network, else of the machine alone.
pub(crate) fn reachable(address: SocketAddr) -> SocketAddr {
    match address.ip() {
        ip if !ip.is_unspecified() => address,
        IpAddr::V4(_) => {
            SocketAddr::new(own(&AWAY[..1]).unwrap_or(Ipv4Addr::LOCALHOST.into()), address.port())
        }
        IpAddr::V6(_) => SocketAddr::new(own(&AWAY).unwrap_or(Ipv6Addr::LOCALHOST.into()), address.port()),
    }
}

/// Where the way to one of these begins.
fn own(away: &[IpAddr]) -> Option<IpAddr> {
    let begins = |to: &IpAddr| {
        let any: IpAddr =
            if to.is_ipv4() { Ipv4Addr::UNSPECIFIED.into() } else { Ipv6Addr::UNSPECIFIED.into() };
        let socket = UdpSocket::bind((any, 0)).ok()?;
        socket.connect((*to, 9)).ok()?;
        let own = socket.local_addr().ok()?.ip();
        (!own.is_unspecified() && !own.is_loopback()).then_some(own)
    };
    away.iter().find_map(begins)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_name_an_address_that_there_is() {
        for text in ["127.0.0.1:4000", "192.168.1.7:80", "[::1]:4000", "[fe80::1]:4000"] {
            let named: SocketAddr = text.parse().unwrap();
            assert_eq!(reachable(named), named);
        }
        for text in ["0.0.0.0:4000", "[::]:4000"] {
            let all: SocketAddr = text.parse().unwrap();
            let one = reachable(all);
            assert!(!one.ip().is_unspecified() && one.port() == 4000, "{one}");
            assert!(
                one.is_ipv4() || all.is_ipv6(),
                "who listens by the old protocol alone has no address of the new"
            );
            // It is this machine's: one can listen there.
            assert!(UdpSocket::bind((one.ip(), 0)).is_ok(), "{one}");
        }
    }
}
