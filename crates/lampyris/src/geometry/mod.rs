//! Rays, triangles and the hierarchy that finds where they meet.
//! Positions are in metres in world space unless a name says otherwise; nothing here knows of light.

pub mod frame;
pub mod ray;

pub use frame::Frame;
pub use ray::{Hit, Ray};
