//! What textures and vertex colours say at one point of a triangle. Nothing here knows what they are multiplied with.
//! A map whose texture, image or coordinates are missing multiplies by one.

use super::{Mesh, Scene};
use crate::color::Rgb;
use crate::material::{Coverage, Map, Maps, Material};
use crate::sampling;
use crate::sequence;
use crate::texture::{Image, Texture};
use glam::{Vec2, Vec3, Vec4};
use std::collections::HashMap;

/// Points of a triangle that its mean is taken over.
const POINTS: u32 = 64;

/// A point of a triangle of a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot<'s> {
    scene: &'s Scene,
    pub(crate) mesh: &'s Mesh,
    pub(crate) vertices: [usize; 3],
    weights: [f32; 3],
}

impl Scene {
    /// The point (u, v) of a triangle of an instance, the weights of its second and third corner.
    pub(crate) fn spot(&self, instance: u32, triangle: u32, u: f32, v: f32) -> Option<Spot<'_>> {
        let mesh = self.meshes.get(self.instances.get(instance as usize)?.mesh as usize)?;
        let vertices = mesh.triangles.get(triangle as usize)?.map(|v| v as usize);
        Some(Spot { scene: self, mesh, vertices, weights: [1.0 - u - v, u, v] })
    }

    /// The texture of a map and its image, where both are there.
    pub(crate) fn textured(&self, map: &Map) -> Option<(&Texture, &Image)> {
        let texture = self.textures.get(map.texture as usize)?;
        let image = self.images.get(texture.image as usize)?;
        image.is_sound().then_some((texture, image))
    }

    /// Mean of what a material sends out of a triangle, its coverage counted [cd/m²].
    pub(crate) fn mean_emission(&self, instance: u32, triangle: u32, material: &Material) -> Rgb {
        if material.maps.emission.is_none() && material.coverage == Coverage::Full {
            return material.emission;
        }
        let at = |i: u32| {
            let [u, v] = sampling::triangle([0, 1].map(|d| sequence::halton(i + 1, d)));
            self.spot(instance, triangle, u, v).map_or(material.emission, |spot| spot.emission(material))
        };
        (0..POINTS).map(at).fold(Rgb::BLACK, |a, b| a + b) * (1.0 / POINTS as f32)
    }
}

impl<'s> Spot<'s> {
    /// The weighted mean of something that each vertex has.
    fn mix<T: Copy + std::ops::Mul<f32, Output = T> + std::ops::Add<Output = T>>(
        &self,
        of: &[T],
    ) -> Option<T> {
        let [a, b, c] = self.vertices.map(|v| of.get(v).copied());
        let [i, j, k] = self.weights;
        Some(a? * i + b? * j + c? * k)
    }

    /// Texture coordinates of each corner, as a map wants them.
    pub(crate) fn corners(&self, map: &Map) -> Option<[Vec2; 3]> {
        let uvs = self.mesh.uvs.get(map.set as usize)?;
        let [a, b, c] = self.vertices.map(|v| uvs.get(v).map(|uv| map.transform.transform_point2(*uv)));
        Some([a?, b?, c?])
    }

    /// What a map says here: red, green, blue and alpha.
    pub(crate) fn look(&self, map: &Map) -> Option<[f32; 4]> {
        let (texture, image) = self.scene.textured(map)?;
        let uv = self.mix(self.mesh.uvs.get(map.set as usize)?)?;
        Some(texture.at(image, map.transform.transform_point2(uv)))
    }

    /// One channel of a map, none of them less than zero.
    pub(crate) fn channel(&self, map: &Option<Map>, channel: usize) -> f32 {
        map.as_ref().and_then(|m| self.look(m)).map_or(1.0, |v| v[channel].max(0.0))
    }

    /// The colour of a map, none of its channels less than zero.
    pub(crate) fn color(&self, map: &Option<Map>) -> Rgb {
        let look = map.as_ref().and_then(|m| self.look(m));
        look.map_or(Rgb::WHITE, |[r, g, b, _]| Rgb::new(r, g, b).map(|v| v.max(0.0)))
    }

    /// The vertices' colour and coverage.
    pub(crate) fn vertex_color(&self) -> Vec4 {
        self.mix(&self.mesh.colors).unwrap_or(Vec4::ONE)
    }

    /// The vertices' tangent in mesh space, and the sign of the bitangent.
    pub(crate) fn tangent(&self) -> Option<(Vec3, f32)> {
        self.mix(&self.mesh.tangents).map(|t| (t.truncate(), if t.w < 0.0 { -1.0 } else { 1.0 }))
    }

    /// What multiplies the factor of a material's coverage.
    fn alpha(&self, maps: &Maps) -> f32 {
        self.channel(&maps.color, 3) * self.channel(&maps.alpha, 0) * self.vertex_color().w
    }

    /// The share of the surface that is there, 0 to 1.
    pub(crate) fn coverage(&self, material: &Material) -> f32 {
        match material.coverage {
            Coverage::Full => 1.0,
            Coverage::Mask { factor, cutoff } => {
                if factor * self.alpha(&material.maps) >= cutoff {
                    1.0
                } else {
                    0.0
                }
            }
            Coverage::Blend { factor } => (factor * self.alpha(&material.maps)).clamp(0.0, 1.0),
        }
    }

    /// Mean radiance that the point sends out, holes counted as black [cd/m²].
    pub(crate) fn emission(&self, material: &Material) -> Rgb {
        material.emission * self.color(&material.maps.emission) * self.coverage(material)
    }
}

/// The least values of maps, each image searched once: bounds for what a map may make of a factor.
#[derive(Clone, Debug, Default)]
pub(crate) struct Least {
    known: HashMap<(u32, usize), f32>,
}

impl Least {
    /// Of one channel, not less than zero; one without a map. All maps are of the same scene.
    pub(crate) fn of(&mut self, scene: &Scene, map: &Option<Map>, channel: usize) -> f32 {
        let Some((map, (texture, image))) = map.as_ref().and_then(|m| Some((m, scene.textured(m)?))) else {
            return 1.0;
        };
        let search = || image.least(texture.encoding, channel).max(0.0);
        *self.known.entry((map.texture, channel)).or_insert_with(search)
    }

    /// False where a material's surface is certainly whole, whatever its textures say.
    pub(crate) fn may_have_holes(&mut self, scene: &Scene, material: &Material, mesh: &Mesh) -> bool {
        let (factor, enough) = match material.coverage {
            Coverage::Full => return false,
            // Rounding of a look-up may lie a little below the least pixel.
            Coverage::Mask { factor, cutoff } => (factor, cutoff * 1.000_01),
            Coverage::Blend { factor } => (factor, 1.0),
        };
        let maps = &material.maps;
        let vertices = mesh.colors.iter().map(|c| c.w).fold(1.0, f32::min);
        factor * self.of(scene, &maps.color, 3) * self.of(scene, &maps.alpha, 0) * vertices < enough
    }
}
