//! What can go wrong with a desk, sorted by what the user can do about it.

use std::net::SocketAddr;

/// Every failure of the desk.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Scene, settings or files: as the library says.
    #[error(transparent)]
    Library(#[from] lampyris::Error),
    /// The address cannot be listened on: take another.
    #[error("cannot listen on {address}: {reason}; choose another with --port or --listen")]
    CannotListen {
        /// What was asked for.
        address: SocketAddr,
        /// Why not.
        reason: String,
    },
    /// The address can be reached from other machines, and nobody said that this is meant.
    #[error(
        "{0} can be reached from other machines, and what is said there is not encrypted: who reads along learns the \
         links and may edit; if that is meant, say --expose too"
    )]
    Exposed(SocketAddr),
    /// The system gives no random numbers, threads or the like.
    #[error("the system refuses {what}: {reason}")]
    System {
        /// What was asked for.
        what: &'static str,
        /// Why not.
        reason: String,
    },
}

/// Shorthand for results of this crate.
pub type Result<T> = std::result::Result<T, Error>;
