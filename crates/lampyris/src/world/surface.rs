//! A point of a surface as light meets it: position, the two normals, and scattering in world directions.
//!
//! Shading normals bend the BSDF, not the geometry: f_r is black unless `wi` lies on the same side of the shading
//! and of the geometric normal; which side `wo` is on, the geometric normal alone decides.
//! The receiver's cosine is the shading normal's, the emitting side's cosine the geometric one.

use crate::color::Rgb;
use crate::geometry::{Frame, Hit, SurfacePoint};
use crate::material::{Bsdf, Class, Diffuse, Scatter, Sides, Transport};
use crate::scene::Scene;
use glam::Vec3;

/// A surface point seen from `wo`.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'w> {
    /// Where [m, world].
    pub position: Vec3,
    /// Unit geometric normal on the side of `wo`.
    pub normal: Vec3,
    /// Shading frame; its normal is on the side of `wo`, save at a dielectric, whose normal stays outward.
    pub frame: Frame,
    /// Unit direction back along the ray that met the surface.
    pub wo: Vec3,
    /// Bound of the position's rounding error, axis by axis [m].
    pub error: Vec3,
    /// Scattering.
    pub bsdf: &'w Bsdf,
    /// Radiance that the surface itself sends toward `wo` [cd/m²].
    pub emission: Rgb,
    /// True if `wo` is on the front side.
    pub front: bool,
    /// Which instance of the scene.
    pub instance: u32,
    /// Which material of the scene.
    pub material: u32,
}

/// A perfectly white receiver: its radiance is illuminance / π.
static WHITE: Bsdf = Bsdf::Diffuse(Diffuse { reflectance: Rgb::WHITE, transmittance: Rgb::BLACK });

impl<'w> Surface<'w> {
    pub(super) fn new(scene: &'w Scene, direction: Vec3, hit: &Hit) -> Surface<'w> {
        let instance = &scene.instances[hit.instance as usize];
        let mesh = &scene.meshes[instance.mesh as usize];
        let corners = mesh.triangles[hit.triangle as usize].map(|k| k as usize);
        let vertices = corners.map(|k| instance.transform.transform_point3(mesh.positions[k]));
        let [a, b, c] = vertices;
        let mirrored = instance.transform.matrix3.determinant() < 0.0;
        let outward =
            (b - a).cross(c - a).normalize_or(-direction.normalize()) * if mirrored { -1.0 } else { 1.0 };
        let wo = -direction.normalize();
        let front = wo.dot(outward) >= 0.0;
        let normal = if front { outward } else { -outward };

        let weights = [1.0 - hit.u - hit.v, hit.u, hit.v];
        let smooth = (0..3)
            .map(|k| mesh.normals.get(corners[k]).copied().unwrap_or_default() * weights[k])
            .sum::<Vec3>();
        // Normals transform by the inverse transpose, here the cofactors: no division, no trouble with mirrors.
        let m = instance.transform.matrix3;
        let cofactors = [m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis)];
        let smooth = Vec3::from(cofactors[0] * smooth.x + cofactors[1] * smooth.y + cofactors[2] * smooth.z)
            .normalize_or(outward);
        let smooth = if smooth.dot(outward) < 0.0 { -smooth } else { smooth };

        let number = mesh.materials[hit.triangle as usize];
        let material = &scene.materials[number as usize];
        let solid = material.bsdf.is_solid_interface();
        let point = SurfacePoint::new(&vertices, hit.u, hit.v);
        let glows = front || material.sides == Sides::Both;
        Surface {
            position: point.position,
            normal,
            frame: Frame::new(if front || solid { smooth } else { -smooth }),
            wo,
            error: point.error,
            bsdf: &material.bsdf,
            emission: if glows { material.emission } else { Rgb::BLACK },
            front,
            instance: hit.instance,
            material: number,
        }
    }

    /// An ideal illuminance meter lying at `position`: π times its radiance is the illuminance [lx].
    pub fn meter(position: Vec3, normal: Vec3) -> Surface<'static> {
        Surface {
            position,
            normal,
            frame: Frame::new(normal),
            wo: normal,
            error: Vec3::ZERO,
            bsdf: &WHITE,
            emission: Rgb::BLACK,
            front: true,
            instance: u32::MAX,
            material: u32::MAX,
        }
    }

    /// Where a ray in `direction` leaves without meeting this surface again.
    pub fn spawn(&self, direction: Vec3) -> Vec3 {
        let side = if direction.dot(self.normal) >= 0.0 { self.normal } else { -self.normal };
        SurfacePoint { position: self.position, error: self.error }.spawn(side)
    }

    /// Cosine between a direction and the shading normal, without sign.
    pub fn cosine(&self, wi: Vec3) -> f32 {
        self.frame.n.dot(wi).abs()
    }

    /// f_r of the lobes of `class` for light arriving from `wi` and leaving toward `wo` [sr⁻¹].
    pub fn eval(&self, class: Class, wo: Vec3, wi: Vec3) -> Rgb {
        match self.local_incident(wi) {
            Some(l) => self.bsdf.eval(class, self.local_outgoing(wo), l),
            None => Rgb::BLACK,
        }
    }

    /// Density of [`Self::sample`] [sr⁻¹].
    pub fn pdf(&self, class: Class, wi: Vec3) -> f32 {
        self.local_incident(wi).map_or(0.0, |l| self.bsdf.pdf(class, self.local_outgoing(self.wo), l))
    }

    /// Draws where the light that leaves toward `wo` came from; world direction, weight f_r·cos/pdf.
    pub fn sample(&self, class: Class, u: [f32; 2], choice: f32) -> Option<Scatter> {
        let s = self.bsdf.sample(class, self.local_outgoing(self.wo), u, choice, Transport::Radiance)?;
        let wi = self.frame.to_world(s.wi);
        self.local_incident(wi).map(|_| Scatter { wi, ..s })
    }

    /// Draws where a particle that arrived from `wo` goes on to; weight is the factor on its flux.
    ///
    /// Particles meet the adjoint of the BSDF: the arriving cosine is the shading normal's over the geometric
    /// normal's, the leaving one the other way round [Veach 1997, §5.3].
    pub fn scatter_flux(&self, class: Class, u: [f32; 2], choice: f32) -> Option<Scatter> {
        let arrived = self.flux_density()?;
        if let (Class::Dull, Some(rho)) = (class, self.bsdf.lambertian()) {
            // Exact for Lambert: the leaving cosine is the geometric one.
            let wi = Frame::new(self.normal).to_world(crate::sampling::cosine_hemisphere(u));
            return Some(Scatter {
                wi,
                weight: rho * arrived,
                pdf: self.normal.dot(wi) * std::f32::consts::FRAC_1_PI,
            });
        }
        let s = self.bsdf.sample(class, self.frame.to_local(self.wo), u, choice, Transport::Flux)?;
        let wi = self.frame.to_world(s.wi);
        let (geometric, shading) = (self.normal.dot(wi), self.frame.n.dot(wi));
        let same_side = (geometric > 0.0) == (shading * self.frame.n.dot(self.normal) > 0.0);
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

    /// A direction of arriving light in the shading frame, if both normals agree about its side.
    fn local_incident(&self, wi: Vec3) -> Option<Vec3> {
        let l = self.frame.to_local(wi);
        let outward = self.frame.n.dot(self.normal) >= 0.0;
        ((l.z > 0.0) == ((self.normal.dot(wi) > 0.0) == outward) && l.z != 0.0).then_some(l)
    }

    /// A direction of leaving light in the shading frame, on the side that the geometric normal says.
    fn local_outgoing(&self, wo: Vec3) -> Vec3 {
        let l = self.frame.to_local(wo);
        let outward = self.frame.n.dot(self.normal) >= 0.0;
        let up = (self.normal.dot(wo) >= 0.0) == outward;
        Vec3::new(l.x, l.y, l.z.abs().max(1e-4) * if up { 1.0 } else { -1.0 })
    }
}
