//! How much a photon counts by its distance: kernels that weigh 1 in the mean over the disc, so that evenly lit is evenly
//! lit by each of them.

use std::f32::consts::FRAC_1_PI;

/// Of photons in a disc, which count how much.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Kernel {
    /// All alike [Jarosz05, eq. 9; Keller96, eq. 4.3].
    #[default]
    Constant,
    /// 1 − d/r of what the one in the middle does: edges of caustics are sharper.
    Cone,
    /// exp(−2 d²/r²): the normal distribution up to two standard deviations.
    Gaussian,
}

/// e⁻².
const END: f32 = 0.135_335_28;

impl Kernel {
    /// All kernels.
    pub const ALL: [Kernel; 3] = [Kernel::Constant, Kernel::Cone, Kernel::Gaussian];

    /// Weight of a photon at a squared distance, in units of the squared radius, 0 to 1.
    #[inline]
    pub fn weight(self, t: f32) -> f32 {
        match self {
            Kernel::Constant => 1.0,
            Kernel::Cone => 3.0 * (1.0 - t.sqrt()).max(0.0),
            // ∫₀¹ e^(−2t) dt = (1 − e⁻²)/2.
            Kernel::Gaussian => 2.0 / (1.0 - END) * libm::expf(-2.0 * t),
        }
    }

    /// One over the area of the disc of a squared radius [m⁻²].
    #[inline]
    pub(super) fn per_area(radius2: f32) -> f32 {
        FRAC_1_PI / radius2
    }

    /// Squared radius of a disc in which a photon at its rim leaves no infinity behind [m²].
    pub(super) const LEAST_RADIUS2: f32 = 1e-24;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ weight dA over the disc is its area, and no kernel rises outwards or is ever negative. The midpoint rule errs by
    /// less than 1e-6 but for the cone's root at the middle, where one of 10⁵ steps errs by less than its width.
    #[test]
    fn kernels_weigh_one_in_the_mean() {
        const STEPS: u32 = 100_000;
        for kernel in Kernel::ALL {
            let at = |k: u32| kernel.weight((k as f32 + 0.5) / STEPS as f32);
            let mean = (0..STEPS).map(|k| f64::from(at(k))).sum::<f64>() / f64::from(STEPS);
            assert!((mean - 1.0).abs() < 1e-5, "{kernel:?}: {mean}");
            assert!((1..STEPS).all(|k| at(k) <= at(k - 1)) && kernel.weight(1.0) >= 0.0);
        }
        assert!((END - libm::expf(-2.0)).abs() < 1e-8);
    }
}
