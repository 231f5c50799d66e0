//! Holes in triangles: whether a hit is one, whoever built the tracer decides. It must be a pure function of the hit, or
//! the kernels, which ask in different orders and as often as they like, would disagree.

use std::sync::Arc;

/// Which hits go through: (instance, triangle, u, v), the last two the weights of the second and third corner.
type Open = dyn Fn(u32, u32, f32, f32) -> bool + Send + Sync;

/// The holes of a tracer's triangles; none by default.
#[derive(Clone, Default)]
pub struct Screen(Option<Arc<Open>>);

impl Screen {
    /// With holes where `open` says so: (instance, triangle, u, v).
    pub fn new(open: impl Fn(u32, u32, f32, f32) -> bool + Send + Sync + 'static) -> Screen {
        Screen(Some(Arc::new(open)))
    }

    #[cold]
    #[inline(never)]
    pub(super) fn open(&self, instance: u32, triangle: u32, u: f32, v: f32) -> bool {
        self.0.as_ref().is_some_and(|open| open(instance, triangle, u, v))
    }
}

impl std::fmt::Debug for Screen {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.0.is_some() { "Screen(…)" } else { "Screen" })
    }
}
