//! Who comes in, and as what: links with secret keys, cookies for those who showed one, and the checks that every request
//! passes. The page itself is no secret.
//!
//! A key is shown once, by the page, which has it from the fragment of its address; afterwards the cookie stands for it.
//! Cookies do not know ports, so this one is named after the instance.

use crate::error::{Error, Result};
use crate::reachable::reachable;
use std::collections::BTreeMap;
use std::net::{IpAddr, SocketAddr};
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};
use subtle::ConstantTimeEq;

/// What a link allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Role {
    /// Everything, one at a time.
    Edit,
    /// To look on.
    Watch,
}

/// A way in.
#[derive(Clone, Debug, serde::Serialize)]
pub(crate) struct Link {
    /// Which one.
    pub(crate) id: u32,
    pub(crate) role: Role,
    /// The secret.
    pub(crate) key: String,
}

/// Who came in by a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pass {
    pub(crate) link: u32,
    pub(crate) role: Role,
}

/// Why a request is refused, as an HTTP status and words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Refusal(pub(crate) u16, pub(crate) &'static str);

/// Random bytes of a key.
const KEY: usize = 24;

/// Wrong keys that are heard in [`PATIENCE`]; then all wait.
const TRIES: usize = 10;
const PATIENCE: Duration = Duration::from_secs(60);

/// Who came in is forgotten when so many others came after.
const GUESTS: usize = 4096;

/// The door.
pub(crate) struct Door {
    address: SocketAddr,
    cookie: String,
    inside: Mutex<Inside>,
}

#[derive(Default)]
struct Inside {
    links: Vec<Link>,
    made: u32,
    /// Of each token the link that it was given for, and when it came.
    guests: BTreeMap<String, (u32, u64)>,
    came: u64,
    wrong: Vec<Instant>,
}

impl Door {
    /// A door at the address that is listened on, with a link to edit. Its key is that of the last time, if a file keeps it,
    /// so that a page that is open finds back.
    pub(crate) fn new(address: SocketAddr, keeps: Option<&Path>) -> Result<Door> {
        let cookie = format!("lampyris-{}", secret(6)?);
        let door = Door { address, cookie, inside: Mutex::default() };
        let key = match keeps.and_then(kept) {
            Some(key) => key,
            None => secret(KEY)?,
        };
        if let Some(file) = keeps {
            // Without it pages must be opened by the new link, and that is all.
            let _ = keep(file, &key);
        }
        door.add(Role::Edit, key);
        Ok(door)
    }

    /// One link more.
    pub(crate) fn make(&self, role: Role) -> Result<Link> {
        Ok(self.add(role, secret(KEY)?))
    }

    fn add(&self, role: Role, key: String) -> Link {
        let mut inside = self.inside();
        inside.made += 1;
        let link = Link { id: inside.made, role, key };
        inside.links.push(link.clone());
        link
    }

    /// A link is not one any more, and nobody is in by it.
    pub(crate) fn revoke(&self, id: u32) {
        let mut inside = self.inside();
        inside.links.retain(|link| link.id != id);
        inside.guests.retain(|_, (link, _)| *link != id);
    }

    /// All links.
    pub(crate) fn links(&self) -> Vec<Link> {
        self.inside().links.clone()
    }

    /// The address that a link's key belongs to.
    pub(crate) fn address_of(&self, link: &Link) -> String {
        format!("http://{}/#{}", reachable(self.address), link.key)
    }

    /// The name of the cookie, which differs from instance to instance.
    pub(crate) fn cookie_name(&self) -> &str {
        &self.cookie
    }

    /// A token for who knows a key.
    pub(crate) fn enter(&self, key: &str, now: Instant) -> std::result::Result<String, Refusal> {
        let token = secret(24).map_err(|_| Refusal(500, "no random numbers"))?;
        let mut inside = self.inside();
        inside.wrong.retain(|then| now.duration_since(*then) < PATIENCE);
        if inside.wrong.len() >= TRIES {
            return Err(Refusal(429, "too many wrong keys: wait a minute"));
        }
        let known = |link: &&Link| bool::from(link.key.as_bytes().ct_eq(key.as_bytes()));
        let Some(link) = inside.links.iter().find(known).map(|link| link.id) else {
            inside.wrong.push(now);
            return Err(Refusal(
                403,
                "no link has this key: it was revoked, or is of a program that has ended",
            ));
        };
        inside.came += 1;
        let came = inside.came;
        inside.guests.insert(token.clone(), (link, came));
        while inside.guests.len() > GUESTS {
            let first =
                inside.guests.iter().min_by_key(|(_, (_, came))| *came).map(|(token, _)| token.clone());
            first.map(|token| inside.guests.remove(&token));
        }
        Ok(token)
    }

    /// What the cookies of a request allow.
    pub(crate) fn admit(&self, cookies: Option<&str>) -> std::result::Result<Pass, Refusal> {
        let own = cookies.unwrap_or_default().split(';').find_map(|pair| {
            let (name, value) = pair.trim().split_once('=')?;
            (name == self.cookie).then_some(value)
        });
        let unknown = Refusal(401, "open the link that the program printed");
        let inside = self.inside();
        let (link, _) = inside.guests.get(own.ok_or(unknown)?).ok_or(unknown)?;
        let link = inside.links.iter().find(|own| own.id == *link).ok_or(unknown)?;
        Ok(Pass { link: link.id, role: link.role })
    }

    /// Whether a pass still counts.
    pub(crate) fn still(&self, pass: Pass) -> bool {
        self.inside().links.iter().any(|link| link.id == pass.link)
    }

    /// Whether a request means this server and, if it `changes` something or upgrades, comes from its own page. Names are
    /// refused but `localhost`: a stranger's name may lead here.
    pub(crate) fn check(
        &self,
        host: Option<&str>,
        origin: Option<&str>,
        changes: bool,
    ) -> std::result::Result<(), Refusal> {
        let host =
            host.filter(|host| self.is_own(host)).ok_or(Refusal(421, "this server has another name"))?;
        let own = |origin: &str| origin.strip_prefix("http://") == Some(host);
        match origin {
            Some(origin) if own(origin) => Ok(()),
            None if !changes => Ok(()),
            _ => Err(Refusal(403, "only this server's own page may ask that")),
        }
    }

    fn is_own(&self, host: &str) -> bool {
        if host == format!("localhost:{}", self.address.port()) {
            return true;
        }
        let Ok(address) = host.parse::<SocketAddr>() else { return false };
        let near = |ip: IpAddr| ip.is_loopback();
        let reached = near(address.ip()) || !near(self.address.ip());
        address.port() == self.address.port() && reached
    }

    fn inside(&self) -> MutexGuard<'_, Inside> {
        self.inside.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The key that a file keeps, if it is one, and nobody else's file.
fn kept(file: &Path) -> Option<String> {
    let data = std::fs::symlink_metadata(file).ok().filter(|data| data.is_file())?;
    #[cfg(unix)]
    if std::os::unix::fs::PermissionsExt::mode(&data.permissions()) & 0o077 != 0 {
        return None;
    }
    let key = std::fs::read_to_string(file).ok().filter(|_| data.len() == 2 * KEY as u64)?;
    key.bytes().all(|b| b.is_ascii_hexdigit()).then_some(key)
}

/// Keeps a key in a file that only the user may read.
fn keep(file: &Path, key: &str) -> std::io::Result<()> {
    file.parent().map_or(Ok(()), std::fs::create_dir_all)?;
    let _ = std::fs::remove_file(file);
    let mut options = std::fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    std::io::Write::write_all(&mut options.open(file)?, key.as_bytes())
}

/// So many random bytes, in hexadecimal digits.
fn secret(bytes: usize) -> Result<String> {
    let mut random = vec![0; bytes];
    getrandom::fill(&mut random)
        .map_err(|e| Error::System { what: "random numbers", reason: e.to_string() })?;
    Ok(random.iter().map(|byte| format!("{byte:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn door(address: &str) -> Door {
        Door::new(address.parse().unwrap(), None).unwrap()
    }

    #[test]
    fn hosts_and_origins() {
        let near = door("127.0.0.1:4000");
        let own = Some("127.0.0.1:4000");
        let ok = [
            (own, None, false),
            (own, Some("http://127.0.0.1:4000"), true),
            (Some("localhost:4000"), Some("http://localhost:4000"), true),
            (Some("[::1]:4000"), None, false),
        ];
        for (host, origin, changes) in ok {
            assert_eq!(near.check(host, origin, changes), Ok(()), "{host:?} {origin:?}");
        }
        let hosts =
            [None, Some("127.0.0.1"), Some("127.0.0.1:80"), Some("evil.example:4000"), Some("10.1.2.3:4000")];
        for host in hosts {
            assert_eq!(near.check(host, None, false).unwrap_err().0, 421, "{host:?}");
        }
        let origins = [
            None,
            Some("null"),
            Some("http://evil.example"),
            Some("https://127.0.0.1:4000"),
            Some("http://localhost:4000"),
        ];
        for origin in origins {
            assert_eq!(near.check(own, origin, true).unwrap_err().0, 403, "{origin:?}");
        }
        let far = door("0.0.0.0:4000");
        assert_eq!(far.check(Some("192.168.1.7:4000"), Some("http://192.168.1.7:4000"), true), Ok(()));
        assert_eq!(far.check(Some("desk.local:4000"), None, false).unwrap_err().0, 421);
    }

    #[test]
    fn links_lead_to_hosts_that_are_let_in() {
        for address in ["127.0.0.1:4000", "0.0.0.0:4000", "[::]:4000"] {
            let door = door(address);
            let link = door.address_of(&door.links()[0]);
            let (host, key) = link.strip_prefix("http://").unwrap().split_once("/#").unwrap();
            assert_eq!(door.check(Some(host), Some(&format!("http://{host}")), true), Ok(()), "{link}");
            assert_eq!(key, door.links()[0].key);
            assert!(!host.starts_with("0.0.0.0") && !host.starts_with("[::]"), "{link}");
        }
    }

    #[test]
    fn keys_open_until_they_are_revoked() {
        let door = door("127.0.0.1:4000");
        let now = Instant::now();
        let watch = door.make(Role::Watch).unwrap();
        let token = door.enter(&watch.key, now).unwrap();
        let cookies = format!("a=b; {}={token}", door.cookie_name());
        let pass = door.admit(Some(&cookies)).unwrap();
        assert_eq!(pass, Pass { link: watch.id, role: Role::Watch });
        assert_eq!(door.admit(Some(&format!("lampyris-0={token}"))).unwrap_err().0, 401);
        assert_eq!(door.admit(None).unwrap_err().0, 401);
        door.revoke(watch.id);
        assert!(!door.still(pass));
        assert_eq!(door.admit(Some(&cookies)).unwrap_err().0, 401);
        assert_eq!(door.enter(&watch.key, now).unwrap_err().0, 403);
    }

    #[test]
    fn guessing_takes_a_lifetime() {
        let door = door("127.0.0.1:4000");
        let now = Instant::now();
        for _ in 0..TRIES {
            assert_eq!(door.enter("guess", now).unwrap_err().0, 403);
        }
        let key = door.links()[0].key.clone();
        assert_eq!(door.enter(&key, now).unwrap_err().0, 429);
        assert!(door.enter(&key, now + PATIENCE).is_ok());
        assert_eq!(key.len(), 48);
    }

    #[test]
    fn a_key_is_kept_where_only_the_user_reads_it() {
        let file = std::env::temp_dir().join(format!("lampyris-key-{}", std::process::id()));
        let key = || {
            let door = Door::new("127.0.0.1:4000".parse().unwrap(), Some(&file)).unwrap();
            door.links()[0].key.clone()
        };
        let first = key();
        assert_eq!(key(), first);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o644)).unwrap();
            assert_ne!(key(), first, "others may have read it");
        }
        std::fs::write(&file, "short").unwrap();
        assert_eq!(key().len(), 48);
        std::fs::remove_file(&file).unwrap();
    }

    #[test]
    fn guests_do_not_fill_the_memory() {
        let door = door("127.0.0.1:4000");
        let key = door.links()[0].key.clone();
        let first = door.enter(&key, Instant::now()).unwrap();
        for _ in 0..GUESTS {
            door.enter(&key, Instant::now()).unwrap();
        }
        assert_eq!(door.inside().guests.len(), GUESTS);
        assert!(!door.inside().guests.contains_key(&first));
    }
}
