//! Pearson's χ² test, and bins on the sphere for it whose expected counts come from quadrature of the density.
//! The quadrature refines itself, so that narrow lobes and horizons cost accuracy nowhere. It is no sampler.

use super::special::incomplete_gamma;
use crate::geometry::Frame;
use glam::Vec3;
use std::f64::consts::TAU;

/// Probability that χ² of so many degrees of freedom is at least `chi2`.
pub fn chi_square_p_value(chi2: f64, freedom: f64) -> f64 {
    1.0 - incomplete_gamma(0.5 * freedom, 0.5 * chi2)
}

/// p-value of observed against expected counts, cells pooled until each expects five; `fitted` parameters cost a
/// degree of freedom each beside the total's. 0 if anything was observed where exactly nothing is expected.
pub fn chi_square_test(observed: &[f64], expected: &[f64], fitted: usize) -> f64 {
    let mut cells: Vec<(f64, f64)> = expected.iter().copied().zip(observed.iter().copied()).collect();
    if cells.iter().any(|&(e, o)| e == 0.0 && o > 0.0) {
        return 0.0;
    }
    cells.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut chi2, mut used, mut pool) = (0.0, 0usize, (0.0, 0.0));
    let mut rest: f64 = cells.iter().map(|c| c.0).sum();
    for (e, o) in cells {
        rest -= e;
        pool = (pool.0 + e, pool.1 + o);
        // The last cells stay together if what follows could not make a cell of its own.
        if pool.0 >= 5.0 && (rest >= 5.0 || rest <= 1e-9) {
            chi2 += (pool.1 - pool.0).powi(2) / pool.0;
            used += 1;
            pool = (0.0, 0.0);
        }
    }
    // So little was expected in all that it makes no cell: judged as one nevertheless.
    if pool.0 > 1e-6 {
        chi2 += (pool.1 - pool.0).powi(2) / pool.0;
        used += 1;
    }
    match used.saturating_sub(1 + fitted) {
        0 => f64::from(u8::from(chi2 < 1e-6)),
        freedom => chi_square_p_value(chi2, freedom as f64),
    }
}

/// A partition of the sphere about an axis: `rings` × `sectors`, each hemisphere cut at its own rings.
#[derive(Clone, Copy, Debug)]
pub struct SphereBins {
    /// Rings of one hemisphere.
    pub rings: usize,
    /// Sectors of each ring.
    pub sectors: usize,
    /// Rings lie at 1 − |cos θ| = t^power for t = 0 … 1: 1 makes equal areas, more is finer at the poles.
    pub power: i32,
    /// The pole, a unit vector.
    pub axis: Vec3,
}

impl SphereBins {
    /// 16 × 32 cells of equal area on each hemisphere about +z.
    pub const EVEN: SphereBins = SphereBins { rings: 16, sectors: 32, power: 1, axis: Vec3::Z };

    /// p-value of "`sample` follows `pdf`" [sr⁻¹] from `samples` calls with their number. `None` is a sample lost: what
    /// `pdf` lacks to an integral of 1 must be lost just as often.
    pub fn test(
        &self,
        samples: u32,
        mut sample: impl FnMut(u32) -> Option<Vec3>,
        pdf: impl Fn(Vec3) -> f32,
    ) -> f64 {
        let mut observed = vec![0.0; 2 * self.rings * self.sectors + 1];
        let lost = observed.len() - 1;
        for i in 0..samples {
            observed[sample(i).map_or(lost, |w| self.bin(w))] += 1.0;
        }
        let mut expected: Vec<f64> =
            self.integrals(|w| f64::from(pdf(w))).iter().map(|p| p * f64::from(samples)).collect();
        // Never exactly 0: quadrature cannot tell that no sample is ever lost.
        expected.push((f64::from(samples) - expected.iter().sum::<f64>()).max(f64::MIN_POSITIVE));
        chi_square_test(&observed, &expected, 0)
    }

    /// ∫ f dω over the whole sphere.
    pub fn integral(&self, f: impl Fn(Vec3) -> f64) -> f64 {
        self.integrals(f).iter().sum()
    }

    /// ∫ f dω over each bin.
    pub fn integrals(&self, f: impl Fn(Vec3) -> f64) -> Vec<f64> {
        let mut integrals = Vec::with_capacity(2 * self.rings * self.sectors);
        let (r, s) = (self.rings as f64, self.sectors as f64);
        for k in 0..2 * self.rings * self.sectors {
            let (side, ring) = (k / self.sectors / self.rings, k / self.sectors % self.rings);
            let side = if side == 0 { 1.0 } else { -1.0 };
            let g = |t: f64, phi: f64| f(self.direction(side, t, phi)) * self.jacobian(t);
            let (t, phi) = (ring as f64 / r, (k % self.sectors) as f64 * TAU / s);
            integrals.push(cubature(&g, [t, phi], [1.0 / r, TAU / s]));
        }
        integrals
    }

    fn direction(&self, side: f64, t: f64, phi: f64) -> Vec3 {
        let gap = t.powi(self.power);
        let (sin, cos) = libm::sincos(phi);
        let r = (gap * (2.0 - gap)).max(0.0).sqrt();
        let [s, u, n] = self.axes();
        s * (r * cos) as f32 + u * (r * sin) as f32 + n * (side * (1.0 - gap)) as f32
    }

    /// |dω/(dt dφ)|.
    fn jacobian(&self, t: f64) -> f64 {
        f64::from(self.power) * t.powi(self.power - 1)
    }

    fn bin(&self, w: Vec3) -> usize {
        let [s, u, n] = self.axes();
        let (x, y) = (f64::from(w.dot(s)), f64::from(w.dot(u)));
        let z = f64::from(w.dot(n));
        // 1 − |cos θ| from the sine: the cosine of a narrow lobe has no digits left.
        let gap = (x * x + y * y) / (1.0 + z.abs());
        let t = libm::pow(gap.max(0.0), 1.0 / f64::from(self.power));
        let ring = ((t * self.rings as f64) as usize).min(self.rings - 1);
        let turn = libm::atan2(y, x) / TAU;
        let sector = ((turn - turn.floor()) * self.sectors as f64) as usize;
        let side = usize::from(z < 0.0);
        (side * self.rings + ring) * self.sectors + sector.min(self.sectors - 1)
    }

    fn axes(&self) -> [Vec3; 3] {
        let frame = Frame::new(self.axis);
        [frame.s, frame.t, frame.n]
    }
}

/// ∫ g over the rectangle at `origin` with `size`: Gauss's rule with 3 × 3 nodes against its own on four quarters,
/// until they agree to 1e-6 or the quarters are 4⁻⁷ of the whole.
fn cubature(g: &impl Fn(f64, f64) -> f64, origin: [f64; 2], size: [f64; 2]) -> f64 {
    fn gauss(g: &impl Fn(f64, f64) -> f64, [x, y]: [f64; 2], [w, h]: [f64; 2]) -> f64 {
        // √0.6, the outer node.
        let nodes = [
            (-0.774_596_669_241_483_4, 5.0 / 18.0),
            (0.0, 8.0 / 18.0),
            (0.774_596_669_241_483_4, 5.0 / 18.0),
        ];
        let mut sum = 0.0;
        for (a, wa) in nodes {
            for (b, wb) in nodes {
                sum += wa * wb * g(x + 0.5 * w * (1.0 + a), y + 0.5 * h * (1.0 + b));
            }
        }
        sum * w * h
    }
    fn refine(
        g: &impl Fn(f64, f64) -> f64,
        [x, y]: [f64; 2],
        [w, h]: [f64; 2],
        whole: f64,
        depth: u32,
    ) -> f64 {
        let half = [0.5 * w, 0.5 * h];
        let corners = [[x, y], [x + half[0], y], [x, y + half[1]], [x + half[0], y + half[1]]];
        let parts = corners.map(|c| gauss(g, c, half));
        let sum: f64 = parts.iter().sum();
        // The first division is always tried: a narrow peak may hide between the nodes.
        if depth == 0 || (depth < 7 && (sum - whole).abs() < 1e-6) {
            return sum;
        }
        corners.iter().zip(parts).map(|(c, p)| refine(g, *c, half, p, depth - 1)).sum()
    }
    refine(g, origin, size, gauss(g, origin, size), 7)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chi_square_tells_right_from_wrong() {
        use crate::sampling::{cosine_hemisphere, uniform_sphere};
        use crate::sequence::uniform;
        let u = |i| [uniform(1, i, 0), uniform(1, i, 1)];
        let cosine = |w: Vec3| w.z.max(0.0) * std::f32::consts::FRAC_1_PI;
        assert!(SphereBins::EVEN.test(100_000, |i| Some(cosine_hemisphere(u(i))), cosine) > 0.01);
        assert!(SphereBins::EVEN.test(100_000, |i| Some(uniform_sphere(u(i))), cosine) < 1e-9);
        // A density 3 % too large, and losses that the density does not admit.
        let lossy = |i| (uniform(1, i, 2) < 0.97).then(|| cosine_hemisphere(u(i)));
        assert!(SphereBins::EVEN.test(100_000, lossy, cosine) < 1e-9);
        assert!(SphereBins::EVEN.test(100_000, lossy, |w| 0.97 * cosine(w)) > 0.01);
    }
}
