//! A light made ready for sampling: lamps, one side of an emissive surface, or the environment.
//! One interface serves the walk of particles (`emit`), the gather (`point`), and next-event estimation with
//! multiple importance sampling (`toward`, `pdf`). Choosing among emitters is the world's business.

use super::surface::EmissiveSide;
use super::{Beam, Light, LightKind, Sky};
use crate::color::Rgb;
use crate::geometry::Frame;
use crate::sampling::{concentric_disc, cosine_hemisphere, cosine_power, uniform_cap, uniform_sphere};
use glam::Vec3;
use std::f32::consts::{FRAC_1_PI, PI, TAU};
use std::sync::Arc;

/// A light source with everything that sampling needs.
#[derive(Clone, Debug)]
pub enum Emitter {
    /// A lamp that is no surface of the scene.
    Lamp(LightKind),
    /// One side of all triangles of an instance that share an emitting material.
    Side(EmissiveSide),
    /// The constant environment, as seen from within the sphere that bounds the scene.
    Environment {
        /// Radiance [cd/m²].
        radiance: Rgb,
    },
    /// The environment by picture.
    Sky(Arc<Sky>),
}

/// A particle that leaves a light.
#[derive(Clone, Copy, Debug)]
pub struct Departure {
    /// Where it starts, off the surface [m].
    pub origin: Vec3,
    /// Unit direction.
    pub direction: Vec3,
    /// What it stands for, were it the only one [lm].
    pub flux: Rgb,
}

/// A point of a light as the gather sees it.
#[derive(Clone, Copy, Debug)]
pub struct LightPoint {
    /// Where rays to it end [m]; for a distant light the unit direction toward it.
    pub position: Vec3,
    /// How it shines.
    pub shine: Shine,
    /// Radiance × area toward the normal [cd], or illuminance of a distant light [lx].
    pub intensity: Rgb,
}

/// The angular law of a point that shines.
#[derive(Clone, Copy, Debug)]
pub enum Shine {
    /// cos θ about a normal: an area element. Its geometry term is bounded and compensated.
    Lambert(Vec3),
    /// Alike in all directions.
    Isotropic,
    /// A spot's beam about an axis.
    Beam(Vec3, Beam),
    /// Parallel light: no distance law.
    Distant,
}

/// Light that a point receives from a sampled place of an emitter.
#[derive(Clone, Copy, Debug)]
pub struct Arrival {
    /// Unit direction toward the light.
    pub wi: Vec3,
    /// Where the shadow ray ends; `None` for a distant light.
    pub end: Option<Vec3>,
    /// Radiance ÷ density: illuminance before the receiver's cosine [lx].
    pub weight: Rgb,
    /// Density of `wi` [sr⁻¹]; infinite where no ray can find the light.
    pub pdf: f32,
}

impl Arrival {
    /// How far from `x` the light is [m].
    pub fn distance(&self, x: Vec3) -> f32 {
        self.end.map_or(f32::INFINITY, |end| (end - x).length())
    }
}

/// The sphere around the scene, from which distant light sets out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bounds {
    /// Centre [m].
    pub center: Vec3,
    /// Radius [m].
    pub radius: f32,
}

impl Emitter {
    /// What stands in the place of an emitter that is not there: it sends out nothing.
    pub const NONE: Emitter = Emitter::Lamp(LightKind::Point { position: Vec3::ZERO, intensity: Rgb::BLACK });

    /// Luminous flux [lm] per channel; for distant light, the flux through the scene's bounding sphere.
    pub fn power(&self, bounds: Bounds) -> Rgb {
        let disc = PI * bounds.radius * bounds.radius;
        match self {
            Emitter::Lamp(LightKind::Point { intensity, .. }) => *intensity * (4.0 * PI),
            Emitter::Lamp(LightKind::Spot { intensity, beam, .. }) => *intensity * beam.solid_angle(),
            Emitter::Lamp(LightKind::Directional { illuminance, .. }) => *illuminance * disc,
            Emitter::Lamp(LightKind::Sphere { radius, radiance, .. }) => {
                *radiance * (4.0 * PI * PI * radius * radius)
            }
            Emitter::Lamp(LightKind::Disc { radius, radiance, .. }) => {
                *radiance * (PI * PI * radius * radius)
            }
            Emitter::Side(side) => side.radiance * (PI * side.area),
            Emitter::Environment { radiance } => *radiance * (4.0 * PI * disc),
            Emitter::Sky(sky) => sky.light() * disc,
        }
    }

    /// The flux that its share of the paths should follow [lm]: more than nothing where there may be light.
    pub fn importance(&self, bounds: Bounds) -> f32 {
        match self {
            Emitter::Side(side) => side.importance(),
            _ => self.power(bounds).luminance().max(0.0),
        }
    }

    /// True if it certainly sends out nothing.
    pub fn is_dark(&self) -> bool {
        let bounds = Bounds { center: Vec3::ZERO, radius: 1.0 };
        self.importance(bounds) <= 0.0 && self.power(bounds).is_black()
    }

    /// Area of the shining surface [m²]; 0 for lights that have none.
    pub fn area(&self) -> f32 {
        match self {
            Emitter::Lamp(LightKind::Sphere { radius, .. }) => 4.0 * PI * radius * radius,
            Emitter::Lamp(LightKind::Disc { radius, .. }) => PI * radius * radius,
            Emitter::Side(side) => side.area,
            _ => 0.0,
        }
    }

    /// The box around the emitter's area; `None` where it has none.
    pub fn extent(&self) -> Option<[Vec3; 2]> {
        match self {
            Emitter::Lamp(LightKind::Sphere { center, radius, .. })
            | Emitter::Lamp(LightKind::Disc { center, radius, .. }) => {
                Some([*center - *radius, *center + *radius])
            }
            Emitter::Side(side) => Some(side.extent()),
            _ => None,
        }
    }

    /// A particle of the emitter's light: place by `u[0..2]`, direction by `u[2..4]`, so distributed that each
    /// particle carries the same flux, the emitter's power; nearly the same where a picture says how it glows.
    pub fn emit(&self, u: [f32; 4], bounds: Bounds) -> Departure {
        let (place, turn) = ([u[0], u[1]], [u[2], u[3]]);
        let departure =
            |origin: Vec3, direction: Vec3| Departure { origin, direction, flux: self.power(bounds) };
        let from_infinity = |travel: Vec3| {
            let f = Frame::new(travel);
            let [x, y] = concentric_disc(place);
            departure(bounds.center + (f.s * x + f.t * y - travel) * bounds.radius, travel)
        };
        match self {
            Emitter::Lamp(LightKind::Point { position, .. }) => departure(*position, uniform_sphere(turn)),
            Emitter::Lamp(LightKind::Spot { position, direction, beam, .. }) => {
                departure(*position, Frame::new(*direction).to_world(beam.sample(turn)))
            }
            Emitter::Lamp(LightKind::Directional { direction, .. }) => from_infinity(*direction),
            Emitter::Environment { .. } => from_infinity(uniform_sphere(turn)),
            Emitter::Sky(sky) => {
                let (toward, pdf) = sky.sample(turn);
                let disc = PI * bounds.radius * bounds.radius;
                Departure { flux: sky.radiance(toward) * (disc / pdf), ..from_infinity(-toward) }
            }
            Emitter::Lamp(LightKind::Sphere { center, radius, .. }) => {
                let n = uniform_sphere(place);
                departure(*center + n * *radius, leave(n, turn))
            }
            Emitter::Lamp(LightKind::Disc { center, normal, radius, .. }) => {
                departure(on_disc(*center, *normal, *radius, place), leave(*normal, turn))
            }
            Emitter::Side(side) => {
                let p = side.point(place);
                let flux = p.radiance * (PI * p.area);
                Departure { origin: p.position, direction: leave(p.normal, turn), flux }
            }
        }
    }

    /// The point of the emitter that `u` places: the start of `emit` with the same two numbers.
    pub fn point(&self, u: [f32; 2]) -> LightPoint {
        self.chosen(u).0
    }

    /// [`Self::point`], and one over the density of the choice [m²; sr for distant light]; 0 where there is but one.
    fn chosen(&self, u: [f32; 2]) -> (LightPoint, f32) {
        let point = match self {
            Emitter::Lamp(LightKind::Point { position, intensity }) => {
                LightPoint { position: *position, shine: Shine::Isotropic, intensity: *intensity }
            }
            Emitter::Lamp(LightKind::Spot { position, direction, intensity, beam }) => LightPoint {
                position: *position,
                shine: Shine::Beam(*direction, *beam),
                intensity: *intensity,
            },
            Emitter::Lamp(LightKind::Directional { direction, illuminance }) => {
                LightPoint { position: -*direction, shine: Shine::Distant, intensity: *illuminance }
            }
            Emitter::Lamp(LightKind::Sphere { center, radius, radiance }) => {
                let n = uniform_sphere(u);
                LightPoint {
                    position: *center + n * *radius,
                    shine: Shine::Lambert(n),
                    intensity: *radiance * self.area(),
                }
            }
            Emitter::Lamp(LightKind::Disc { center, normal, radius, radiance }) => LightPoint {
                position: on_disc(*center, *normal, *radius, u),
                shine: Shine::Lambert(*normal),
                intensity: *radiance * self.area(),
            },
            Emitter::Side(side) => {
                let p = side.point(u);
                let intensity = p.radiance * p.area;
                return (
                    LightPoint { position: p.position, shine: Shine::Lambert(p.normal), intensity },
                    p.area,
                );
            }
            Emitter::Sky(sky) => {
                let (position, pdf) = sky.sample(u);
                let intensity = sky.radiance(position) * (1.0 / pdf);
                return (LightPoint { position, shine: Shine::Distant, intensity }, 1.0 / pdf);
            }
            Emitter::Environment { radiance } => {
                let position = uniform_sphere(u);
                let intensity = *radiance * (4.0 * PI);
                return (LightPoint { position, shine: Shine::Distant, intensity }, 4.0 * PI);
            }
        };
        (point, self.area())
    }

    /// A direction from `x` toward the emitter, by `u`; `None` where it shines away from `x`.
    pub fn toward(&self, x: Vec3, u: [f32; 2]) -> Option<Arrival> {
        if let Emitter::Lamp(LightKind::Sphere { center, radius, radiance }) = self {
            // The visible cap's cone: uniform in solid angle.
            let height = cap_of_sphere(*center - x, *radius)?;
            let axis = (*center - x).normalize();
            let wi = Frame::new(axis).to_world(uniform_cap(u, height));
            let t = entry(x, wi, *center, *radius).unwrap_or((*center - x).length() - radius);
            let solid_angle = TAU * height;
            return Some(Arrival {
                wi,
                end: Some(x + wi * t),
                weight: *radiance * solid_angle,
                pdf: 1.0 / solid_angle,
            });
        }
        let (point, around) = self.chosen(u);
        if let Shine::Distant = point.shine {
            let pdf = 1.0 / around;
            return Some(Arrival { wi: point.position, end: None, weight: point.intensity, pdf });
        }
        let d = point.position - x;
        let d2 = d.length_squared();
        if d2 == 0.0 {
            return None;
        }
        let wi = d / d2.sqrt();
        let (share, pdf) = match point.shine {
            Shine::Lambert(n) => {
                let cos = -n.dot(wi);
                (cos, d2 / (cos * around))
            }
            Shine::Beam(axis, beam) => (beam.profile(-axis.dot(wi)), f32::INFINITY),
            _ => (1.0, f32::INFINITY),
        };
        (share > 0.0).then(|| Arrival {
            wi,
            end: Some(point.position),
            weight: point.intensity * (share / d2),
            pdf,
        })
    }

    /// The density of `toward` [sr⁻¹] for the emitter's point that lies `distance` away and is met under
    /// `cosine` (of the angle between the ray back and the emitter's normal there). Pictures need more to tell:
    /// [`Self::around`] and [`EmissiveSide::area_around`].
    pub fn pdf(&self, x: Vec3, distance: f32, cosine: f32) -> f32 {
        match self {
            Emitter::Lamp(LightKind::Sphere { center, radius, .. }) => {
                cap_of_sphere(*center - x, *radius).map_or(0.0, |height| 1.0 / (TAU * height))
            }
            Emitter::Environment { .. } => 0.25 * FRAC_1_PI,
            Emitter::Sky(_) => 0.0,
            Emitter::Lamp(LightKind::Disc { .. }) | Emitter::Side(_) => {
                distance * distance / (cosine * self.area())
            }
            Emitter::Lamp(_) => 0.0,
        }
    }

    /// Radiance from a direction in which nothing is met [cd/m²], and the density of `toward` there [sr⁻¹].
    pub fn around(&self, direction: Vec3) -> (Rgb, f32) {
        match self {
            Emitter::Environment { radiance } => (*radiance, 0.25 * FRAC_1_PI),
            Emitter::Sky(sky) => (sky.radiance(direction), sky.pdf(direction)),
            _ => (Rgb::BLACK, 0.0),
        }
    }

    /// Where a ray meets a lamp's glowing surface, which it then passes: (distance, radiance, cosine).
    ///
    /// `direction` is a unit vector. Only spheres and discs can be met.
    pub fn met_by(&self, origin: Vec3, direction: Vec3, t_max: f32) -> Option<(f32, Rgb, f32)> {
        match self {
            Emitter::Lamp(LightKind::Sphere { center, radius, radiance }) => {
                let t = entry(origin, direction, *center, *radius).filter(|t| *t < t_max)?;
                let n = (origin + direction * t - *center) / *radius;
                Some((t, *radiance, -n.dot(direction)))
            }
            Emitter::Lamp(LightKind::Disc { center, normal, radius, radiance }) => {
                let cosine = -normal.dot(direction);
                let t = (origin - *center).dot(*normal) / cosine;
                let inside = |t: f32| (origin + direction * t - *center).length_squared() <= radius * radius;
                (cosine > 0.0 && t > 0.0 && t < t_max && inside(t)).then_some((t, *radiance, cosine))
            }
            _ => None,
        }
    }
}

impl Beam {
    /// Intensity at an angle off the axis, relative to the axis.
    pub fn profile(&self, cos: f32) -> f32 {
        match *self {
            Beam::Cone { cos_inner, cos_outer } => {
                let ramp = ((cos - cos_outer) / (cos_inner - cos_outer)).clamp(0.0, 1.0);
                ramp * ramp
            }
            Beam::Cosine { exponent } if cos > 0.0 => libm::powf(cos, exponent),
            Beam::Cosine { .. } => 0.0,
        }
    }

    /// ∫ profile dω [sr].
    pub fn solid_angle(&self) -> f32 {
        match *self {
            // Full cap, plus ∫ ramp² over the rim: a third of its width in cosine.
            Beam::Cone { cos_inner, cos_outer } => TAU * ((1.0 - cos_inner) + (cos_inner - cos_outer) / 3.0),
            Beam::Cosine { exponent } => TAU / (exponent + 1.0),
        }
    }

    /// A direction about +z with density profile / solid angle, by inversion of the cosine's distribution.
    pub fn sample(&self, u: [f32; 2]) -> Vec3 {
        match *self {
            Beam::Cone { cos_inner, cos_outer } => {
                let (cap, rim) = (1.0 - cos_inner, (cos_inner - cos_outer) / 3.0);
                let v = u[0] * (cap + rim);
                let cos = if v < cap {
                    1.0 - v
                } else {
                    cos_outer + (cos_inner - cos_outer) * cube_root_of_rest(v - cap, rim)
                };
                let sin = (1.0 - cos * cos).max(0.0).sqrt();
                let (s, c) = libm::sincosf(TAU * u[1]);
                Vec3::new(sin * c, sin * s, cos)
            }
            Beam::Cosine { exponent } => cosine_power(u, exponent),
        }
    }
}

/// Inverse of 1 − r³ = v/rim: the ramp value that leaves the share v/rim of the rim's light above it.
fn cube_root_of_rest(v: f32, rim: f32) -> f32 {
    libm::cbrtf((1.0 - v / rim).clamp(0.0, 1.0))
}

impl From<&Light> for Emitter {
    fn from(light: &Light) -> Emitter {
        let dark = light.state != super::State::On;
        Emitter::Lamp(if dark { light.kind.clone().with_brightness(Rgb::BLACK) } else { light.kind.clone() })
    }
}

/// A direction away from an area element with Lambertian radiance.
fn leave(n: Vec3, u: [f32; 2]) -> Vec3 {
    Frame::new(n).to_world(cosine_hemisphere(u))
}

fn on_disc(center: Vec3, normal: Vec3, radius: f32, u: [f32; 2]) -> Vec3 {
    let f = Frame::new(normal);
    let [x, y] = concentric_disc(u);
    center + (f.s * x + f.t * y) * radius
}

/// 1 − cos of the half-angle under which a sphere is seen; `None` from inside, where it does not shine.
fn cap_of_sphere(to_center: Vec3, radius: f32) -> Option<f32> {
    let sin2 = radius * radius / to_center.length_squared();
    // Not 1 − √(1 − sin²): a hundred radii away that would be wrong by a per mille, and the light with it.
    (sin2 < 1.0).then(|| sin2 / (1.0 + (1.0 - sin2).sqrt()))
}

/// Distance at which a ray enters a sphere from outside.
fn entry(origin: Vec3, direction: Vec3, center: Vec3, radius: f32) -> Option<f32> {
    let to_center = center - origin;
    let b = to_center.dot(direction);
    // Distance of the ray from the centre by the rejected part: no cancellation for far spheres.
    let miss2 = (to_center - direction * b).length_squared();
    let h2 = radius * radius - miss2;
    if h2 < 0.0 {
        return None;
    }
    let t = b - h2.sqrt();
    (t > 0.0).then_some(t)
}
