//! Rays, triangles and the hierarchy that finds where they meet.
//! Positions are in metres in world space unless a name says otherwise; nothing here knows of light.

mod bvh;
pub mod frame;
mod offset;
mod packet;
pub mod ray;
mod replace;
mod screen;
mod simd_dispatch;
mod tracer;

pub use bvh::Kernel;
pub use frame::Frame;
pub use offset::SurfacePoint;
pub(crate) use offset::{ERROR, away};
pub use packet::{Hits16, LANES, Occluder};
pub(crate) use packet::{lane, lanes};
pub use ray::{Hit, Ray};
pub use screen::Screen;
pub(crate) use simd_dispatch::sum_of_lanes;
pub use simd_dispatch::{Wide, positive};
pub use tracer::{MeshGeometry, Placement, Report, Tracer};
