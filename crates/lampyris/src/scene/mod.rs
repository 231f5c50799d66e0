//! The scene as data: what an importer makes and what an edit changes. Plain, serialisable, without acceleration.

mod camera;
mod edit;
mod paint;
mod reference;
mod rooms;
mod sight;
mod summary;
mod upward;
mod viewpoint;

pub use camera::{Camera, View};
pub use edit::Edit;
pub(crate) use paint::{Least, Spot};
pub use reference::{Group, Reference, Share, Source};
pub use sight::Seen;
pub use summary::Summary;
pub use upward::upward;
pub use viewpoint::{Found, find_view};

use crate::color::Rgb;
use crate::light::Light;
use crate::material::Material;
use crate::texture::{Image, Texture};
use glam::{Affine3A, Vec2, Vec3, Vec4};
use serde::{Deserialize, Serialize};

/// Everything that is to be lit.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Scene {
    /// Triangle meshes, each in its own space.
    pub meshes: Vec<Mesh>,
    /// The meshes placed in the world.
    pub instances: Vec<Instance>,
    /// Materials that triangles name by index.
    pub materials: Vec<Material>,
    /// Light sources beside the emissive surfaces.
    pub lights: Vec<Light>,
    /// Radiance of the environment [cd/m²]; black for none. It multiplies `environment_image`, where there is one.
    pub environment: Rgb,
    /// Which of the images surrounds the scene: a map of longitude and latitude, its upper edge along `up`, or +y where
    /// that is not stated. Then its middle lies at −z and its right quarter at +x. Bytes are sRGB.
    pub environment_image: Option<u32>,
    /// Pictures that textures and environment are made of.
    pub images: Vec<Image>,
    /// Textures that materials name by index.
    pub textures: Vec<Texture>,
    /// Views stored in the file.
    pub cameras: Vec<Camera>,
    /// The upward direction where the format states one.
    pub up: Option<Vec3>,
    /// From where it is looked at, where that is decided.
    #[serde(default)]
    pub view: Option<Camera>,
    /// What the shares of the light paths are fixed by; [`crate::world::World::new`] fills in what is missing.
    #[serde(default)]
    pub reference: Reference,
    /// Light groups; none where all light is summed together. [`crate::world::World::separate`] makes them.
    #[serde(default)]
    pub groups: Vec<Group>,
}

/// Triangles that move together.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Mesh {
    /// Vertex positions [m, mesh space].
    pub positions: Vec<Vec3>,
    /// Unit shading normals, one a vertex, or none at all; a zero vector means "use the triangle's".
    pub normals: Vec<Vec3>,
    /// Two sets of texture coordinates, one pair a vertex, each set whole or empty; (0, 0) is the upper left corner.
    pub uvs: [Vec<Vec2>; 2],
    /// Unit tangents in x, y, z and the sign of the bitangent in w, one a vertex, or none: they then follow from the
    /// texture coordinates.
    pub tangents: Vec<Vec4>,
    /// Linear red, green, blue and alpha that multiply base colour and coverage, one a vertex, or none.
    pub colors: Vec<Vec4>,
    /// Vertex indices, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// Material of each triangle.
    pub materials: Vec<u32>,
}

/// A mesh in its place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Instance {
    /// Name in the file: object names from the outside in, joined by `/`.
    pub name: String,
    /// Which mesh; [`Instance::AWAY`] where the object was taken away and only its number is left.
    pub mesh: u32,
    /// Mesh space → world.
    pub transform: Affine3A,
}

impl Instance {
    /// The number of no mesh.
    pub const AWAY: u32 = u32::MAX;
}
