//! A point of a surface as light meets it: position, the two normals, and scattering in world directions.
//!
//! Shading normals bend the BSDF, not the geometry: f_r is black unless `wi` lies on the same side of the shading
//! and of the geometric normal; which side `wo` is on, the geometric normal alone decides.
//! The receiver's cosine is the shading normal's, the emitting side's cosine the geometric one.
//!
//! What a body of glass absorbs is asked at its interface: a straight way runs inside a body if either of its ends lies
//! on the inner side of one. (Of a way between two things cast into the same glass no end knows.)

use super::finish::{Coat, Finish, WHITE};
use crate::color::Rgb;
use crate::geometry::{Frame, SurfacePoint};
use crate::material::{Bsdf, Class, Scatter, Transport};
use crate::sampling::cosine_hemisphere;
use glam::Vec3;
use std::f32::consts::FRAC_1_PI;

/// A surface point seen from `wo`.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'w> {
    /// Where [m, world].
    pub position: Vec3,
    /// Bound of the position's rounding error, axis by axis [m].
    pub error: Vec3,
    /// Unit geometric normal on the side of `wo`.
    pub normal: Vec3,
    /// Unit shading normal on the side of `wo`, save at a dielectric, whose normal stays outward.
    pub shading: Vec3,
    /// Unit direction back along the ray that met the surface.
    pub wo: Vec3,
    /// Material.
    pub finish: Coat<'w>,
    /// True if `wo` is on the front side.
    pub front: bool,
    /// Which instance of the scene.
    pub instance: u32,
    /// Which triangle of its mesh.
    pub triangle: u32,
    /// Which material of the scene.
    pub material: u32,
    /// Which planar mirror of the world it lies in.
    pub mirror: Option<u8>,
}

impl<'w> Surface<'w> {
    /// An ideal illuminance meter lying at `position`: π times its radiance is the illuminance [lx].
    pub fn meter(position: Vec3, normal: Vec3) -> Surface<'static> {
        Surface {
            position,
            normal,
            shading: normal,
            wo: normal,
            error: Vec3::ZERO,
            finish: Coat::Plain(&WHITE),
            front: true,
            instance: u32::MAX,
            triangle: u32::MAX,
            material: u32::MAX,
            mirror: None,
        }
    }

    /// The same point of two materials that add up to its own: one scatters evenly, the other about a direction. `None` where
    /// they cannot be told apart.
    pub fn parted(&self) -> Option<[Surface<'w>; 2]> {
        let Bsdf::Ward(ward) = self.finish.bsdf else { return None };
        let of = |part| Finish::new(Bsdf::Ward(part), self.finish.emission, self.finish.both_sides_glow);
        Some(ward.parted().map(|part| Surface { finish: Coat::Own(of(part)), ..*self }))
    }

    /// Radiance that the surface itself sends toward `wo` [cd/m²].
    pub fn emission(&self) -> Rgb {
        if self.front || self.finish.both_sides_glow { self.finish.emission } else { Rgb::BLACK }
    }

    /// Where a ray in `direction` leaves without meeting this surface again.
    pub fn spawn(&self, direction: Vec3) -> Vec3 {
        let side = if direction.dot(self.normal) >= 0.0 { self.normal } else { -self.normal };
        SurfacePoint { position: self.position, error: self.error }.spawn(side)
    }

    /// What Beer's law leaves of light on a straight way of `distance` [m] between this surface, which it meets from or
    /// leaves in `direction`, and `other`.
    pub fn clear_to(&self, direction: Vec3, distance: f32, other: Option<&Surface<'_>>) -> Rgb {
        let sigma = self.attenuation(direction).or_else(|| other?.attenuation(-direction));
        sigma.map_or(Rgb::WHITE, |sigma| beer(sigma, distance))
    }

    /// What Beer's law leaves of light on its way to here from `origin`, where `start` may have reflected it.
    pub fn clear_from(&self, origin: Vec3, start: Option<&Surface<'_>>) -> Rgb {
        self.clear_to(self.wo, (self.position - origin).length(), start)
    }

    /// σ [m⁻¹] of the body that `direction` leads into.
    fn attenuation(&self, direction: Vec3) -> Option<Rgb> {
        let Bsdf::Dielectric(body) = &self.finish.bsdf else { return None };
        // `normal` is on the side of `wo`, which `front` tells from the inside.
        let inside = (self.normal.dot(direction) > 0.0) != self.front;
        (inside && !body.attenuation.is_black()).then_some(body.attenuation)
    }

    /// Cosine between a direction and the shading normal, without sign.
    pub fn cosine(&self, wi: Vec3) -> f32 {
        self.shading.dot(wi).abs()
    }

    /// f_r of the lobes of `class` for light arriving from `wi` and leaving toward `wo` [sr⁻¹].
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        if let Some(rho) = self.lambertian(class) {
            let same = self.arrives_above(wi) == Some(self.leaves_above(wo));
            return if same { rho * FRAC_1_PI } else { Rgb::BLACK };
        }
        match self.local_incident(wi) {
            Some(l) => self.finish.bsdf.eval(class, self.local_outgoing(wo), l),
            None => Rgb::BLACK,
        }
    }

    /// Density of [`Self::sample`] [sr⁻¹].
    pub fn pdf(&self, class: Class, wi: Vec3) -> f32 {
        self.local_incident(wi).map_or(0.0, |l| self.finish.bsdf.pdf(class, self.local_outgoing(self.wo), l))
    }

    /// Share of the light arriving from `wo` that the lobes of `class` send on, to a few per cent.
    pub fn albedo(&self, class: Class) -> Rgb {
        self.finish.bsdf.albedo(class, self.local_outgoing(self.wo))
    }

    /// Of the numbers `choice` in [0, 1) with which [`Self::sample`] draws a direction from the sharp lobes by `u`, the share,
    /// from 0 on, for which it is a reflection.
    pub fn reflected_sharply(&self, u: [f32; 2]) -> f32 {
        self.finish.bsdf.reflected_sharply(self.local_outgoing(self.wo), u)
    }

    /// Draws where the light that leaves toward `wo` came from; world direction, weight f_r·cos/pdf.
    pub fn sample(&self, class: Class, u: [f32; 2], choice: f32) -> Option<Scatter> {
        if let Some(rho) = self.lambertian(class).filter(|rho| !rho.is_black()) {
            let up = cosine_hemisphere(u);
            let side = if self.leaves_above(self.wo) { 1.0 } else { -1.0 };
            let wi = Frame::new(self.shading).to_world(Vec3::new(up.x, up.y, up.z * side));
            let scatter = Scatter { wi, weight: rho, pdf: up.z * FRAC_1_PI };
            return self.arrives_above(wi).map(|_| scatter);
        }
        let s =
            self.finish.bsdf.sample(class, self.local_outgoing(self.wo), u, choice, Transport::Radiance)?;
        let wi = Frame::new(self.shading).to_world(s.wi);
        self.local_incident(wi).map(|_| Scatter { wi, ..s })
    }

    /// Draws where a particle that arrived from `wo` goes on to; weight is the factor on its flux.
    ///
    /// Particles meet the adjoint of the BSDF: the arriving cosine is the shading normal's over the geometric
    /// normal's, the leaving one the other way round [Veach 1997, §5.3].
    pub fn scatter_flux(&self, class: Class, u: [f32; 2], choice: f32) -> Option<Scatter> {
        let arrived = self.flux_density()?;
        if let Some(rho) = self.lambertian(class) {
            // Exact for Lambert: the leaving cosine is the geometric one.
            let wi = Frame::new(self.normal).to_world(cosine_hemisphere(u));
            return Some(Scatter { wi, weight: rho * arrived, pdf: self.normal.dot(wi) * FRAC_1_PI });
        }
        let s = self.finish.bsdf.sample(
            class,
            Frame::new(self.shading).to_local(self.wo),
            u,
            choice,
            Transport::Flux,
        )?;
        let wi = Frame::new(self.shading).to_world(s.wi);
        let (geometric, shading) = (self.normal.dot(wi), self.shading.dot(wi));
        let same_side = (geometric > 0.0) == (shading * self.shading.dot(self.normal) > 0.0);
        (same_side && shading != 0.0).then(|| Scatter {
            wi,
            weight: s.weight * (arrived * (geometric / shading).abs()),
            ..s
        })
    }

    /// What the flux of a particle arriving from `wo` is multiplied by to be the flux that the BSDF sees;
    /// `None` where shading and geometric normal disagree about the side.
    pub fn flux_density(&self) -> Option<f32> {
        self.local_incident(self.wo)?;
        Some(self.cosine(self.wo) / self.normal.dot(self.wo).abs().max(f32::MIN_POSITIVE))
    }

    /// ρ_d of the lobes of `class` if they are a Lambertian reflector's: most surfaces, which need no frame.
    #[inline]
    fn lambertian(&self, class: Class) -> Option<Rgb> {
        self.finish.lambertian.filter(|_| class == Class::Dull)
    }

    /// Whether light arrives on the side of the shading normal, if both normals agree about that.
    #[inline]
    fn arrives_above(&self, wi: Vec3) -> Option<bool> {
        let cosine = self.shading.dot(wi);
        let outward = self.shading.dot(self.normal) >= 0.0;
        ((cosine > 0.0) == ((self.normal.dot(wi) > 0.0) == outward) && cosine != 0.0).then_some(cosine > 0.0)
    }

    /// Whether light leaves on the side of the shading normal, as the geometric normal has it.
    #[inline]
    fn leaves_above(&self, wo: Vec3) -> bool {
        (self.normal.dot(wo) >= 0.0) == (self.shading.dot(self.normal) >= 0.0)
    }

    /// A direction of arriving light in the shading frame, if both normals agree about its side.
    fn local_incident(&self, wi: Vec3) -> Option<Vec3> {
        self.arrives_above(wi).map(|_| Frame::new(self.shading).to_local(wi))
    }

    /// A direction of leaving light in the shading frame, on the side that the geometric normal says.
    fn local_outgoing(&self, wo: Vec3) -> Vec3 {
        let l = Frame::new(self.shading).to_local(wo);
        Vec3::new(l.x, l.y, l.z.abs().max(1e-4) * if self.leaves_above(wo) { 1.0 } else { -1.0 })
    }
}

/// exp(−σ d) channel by channel; a body without end leaves nothing but what it does not absorb at all.
fn beer(sigma: Rgb, distance: f32) -> Rgb {
    sigma.map(|s| if s == 0.0 { 1.0 } else { libm::expf(-s * distance) })
}
