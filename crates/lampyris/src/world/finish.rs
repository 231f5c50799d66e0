//! A material made ready for shading: what every hit asks is worked out once, or, where textures and vertex colours
//! change it from place to place, once a hit.

use crate::color::Rgb;
use crate::material::{Bsdf, Class, Dielectric, Diffuse, Material, Pbr, Sides, Ward};
use crate::scene::{Least, Scene, Spot};
use glam::Vec3;
use std::ops::Deref;

/// A material with its answers at hand.
#[derive(Clone, Copy, Debug)]
pub struct Finish {
    /// Scattering.
    pub bsdf: Bsdf,
    /// Radiance from each side that glows [cd/m²].
    pub emission: Rgb,
    /// True if the back glows like the front.
    pub both_sides_glow: bool,
    /// Albedo of the sharp lobes at normal incidence.
    pub sharp: Rgb,
    /// Albedo of the dull lobes at normal incidence.
    pub dull: Rgb,
    /// ρ_d if the dull lobes are a Lambertian reflector's.
    pub lambertian: Option<Rgb>,
    /// True if dull lobes send light through the surface.
    pub transmits: bool,
    /// True if it differs from place to place: this is then what the factors say without any map.
    pub painted: bool,
}

/// The finish of a point: its material's, or one of its own where that is painted.
#[derive(Clone, Copy, Debug)]
pub enum Coat<'w> {
    /// The material's.
    Plain(&'w Finish),
    /// The point's alone.
    Own(Finish),
}

impl Deref for Coat<'_> {
    type Target = Finish;

    #[inline(always)]
    fn deref(&self) -> &Finish {
        match self {
            Coat::Plain(finish) => finish,
            Coat::Own(finish) => finish,
        }
    }
}

/// A perfectly white receiver: its radiance is illuminance / π.
pub(super) static WHITE: Finish = Finish {
    bsdf: Bsdf::Diffuse(Diffuse { reflectance: Rgb::WHITE, transmittance: Rgb::BLACK }),
    emission: Rgb::BLACK,
    both_sides_glow: false,
    sharp: Rgb::BLACK,
    dull: Rgb::WHITE,
    lambertian: Some(Rgb::WHITE),
    transmits: false,
    painted: false,
};

impl From<&Material> for Finish {
    fn from(m: &Material) -> Finish {
        let maps = &m.maps;
        Finish {
            painted: *maps != Default::default(),
            ..Finish::new(m.bsdf, m.emission, m.sides == Sides::Both)
        }
    }
}

impl Finish {
    pub(super) fn new(bsdf: Bsdf, emission: Rgb, both_sides_glow: bool) -> Finish {
        Finish {
            bsdf,
            emission,
            both_sides_glow,
            sharp: bsdf.albedo(Class::Sharp, Vec3::Z),
            dull: bsdf.albedo(Class::Dull, Vec3::Z),
            lambertian: bsdf.lambertian(),
            transmits: bsdf.transmits(),
            painted: false,
        }
    }

    /// The finish of one point of a painted material.
    pub(super) fn at(&self, material: &Material, spot: &Spot<'_>) -> Finish {
        let maps = &material.maps;
        let color = spot.color(&maps.color);
        let vertex = spot.vertex_color();
        let share = |v: f32| v.clamp(0.0, 1.0);
        let color = Rgb::new(color.r * vertex.x, color.g * vertex.y, color.b * vertex.z).map(share);
        let bsdf = match tinted(self.bsdf, color) {
            Bsdf::Pbr(m) => Bsdf::Pbr(Pbr {
                roughness: m.roughness * share(spot.channel(&maps.roughness, 1)),
                metallic: m.metallic * share(spot.channel(&maps.roughness, 2)),
                specular: m.specular * share(spot.channel(&maps.specular, 3)),
                specular_color: m.specular_color * spot.color(&maps.specular_color),
                transmission: m.transmission * share(spot.channel(&maps.transmission, 0)),
                ..m
            }),
            other => other,
        };
        let emission =
            if self.emission.is_black() { Rgb::BLACK } else { self.emission * spot.color(&maps.emission) };
        Finish::new(bsdf, emission, self.both_sides_glow)
    }

    /// The mean luminance of its albedo over the image of its colour, to a few per cent.
    pub(super) fn mean_albedo(&self, material: &Material, scene: &Scene) -> f32 {
        let rho = |f: &Finish| (f.sharp + f.dull).luminance().clamp(0.0, 1.0);
        match material.maps.color.as_ref().and_then(|map| scene.textured(map)) {
            None => rho(self),
            Some((texture, image)) => {
                let [r, g, b, _] = image.mean(texture.encoding);
                rho(&Finish::new(tinted(self.bsdf, Rgb::new(r, g, b)), Rgb::BLACK, false))
            }
        }
    }

    /// False only if no point of the material has sharp lobes: a map may polish what its factors leave rough.
    pub(super) fn may_be_sharp(&self, scene: &Scene, material: &Material, least: &mut Least) -> bool {
        let Bsdf::Pbr(m) = self.bsdf else { return !self.sharp.is_black() };
        let map = &material.maps.roughness;
        let roughness = m.roughness * least.of(scene, map, 1);
        [m.metallic, m.metallic * least.of(scene, map, 2)].into_iter().any(|metallic| {
            let polished = Bsdf::Pbr(Pbr { roughness, metallic, ..m });
            !polished.albedo(Class::Sharp, Vec3::Z).is_black()
        })
    }

    /// How likely a path should scatter by each class: (sharp, dull), the brightest channel of either, not negative.
    pub fn weights(&self) -> (f32, f32) {
        (self.sharp.max_channel().max(0.0), self.dull.max_channel().max(0.0))
    }
}

/// The scattering with its base colour multiplied: what is diffuse, or what a body lets through. Of the lobes on top a
/// colour map knows nothing.
fn tinted(bsdf: Bsdf, color: Rgb) -> Bsdf {
    let dyed =
        |d: Diffuse| Diffuse { reflectance: d.reflectance * color, transmittance: d.transmittance * color };
    match bsdf {
        Bsdf::Diffuse(m) => Bsdf::Diffuse(dyed(m)),
        Bsdf::Ward(m) => Bsdf::Ward(Ward { base: dyed(m.base), ..m }),
        Bsdf::Dielectric(m) => Bsdf::Dielectric(Dielectric { transmittance: m.transmittance * color, ..m }),
        Bsdf::Pbr(m) => Bsdf::Pbr(Pbr { base_color: m.base_color * color, ..m }),
    }
}
