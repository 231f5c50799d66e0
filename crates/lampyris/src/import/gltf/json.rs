//! glTF's JSON as data: of each object the few fields that are used, everything else is skipped.
//!
//! Elements of arrays are small and keep what is rare in boxes, because a file may hold a `{}` for each three of its
//! bytes. Nothing is checked here: an index may point anywhere, a number be anything.

use serde::Deserialize;

/// Gives derived readers of plain structs their common attributes.
macro_rules! objects {
    ($($(#[$meta:meta])* struct $name:ident { $($(#[$field_meta:meta])* $field:ident: $kind:ty = $default:expr,)* })*) => {$(
        $(#[$meta])*
        #[derive(Clone, Debug, Deserialize)]
        #[serde(default, rename_all = "camelCase")]
        pub(super) struct $name { $($(#[$field_meta])* pub(super) $field: $kind,)* }

        impl Default for $name {
            fn default() -> Self {
                $name { $($field: $default,)* }
            }
        }
    )*};
}

objects! {
    /// The whole file.
    struct Document {
        asset: Option<Asset> = None,
        extensions_used: Vec<String> = Vec::new(),
        extensions_required: Vec<String> = Vec::new(),
        scene: Option<u32> = None,
        scenes: Vec<SceneNodes> = Vec::new(),
        nodes: Vec<Node> = Vec::new(),
        meshes: Vec<Mesh> = Vec::new(),
        materials: Vec<Material> = Vec::new(),
        textures: Vec<Texture> = Vec::new(),
        images: Vec<Image> = Vec::new(),
        samplers: Vec<Sampler> = Vec::new(),
        cameras: Vec<Camera> = Vec::new(),
        accessors: Vec<Accessor> = Vec::new(),
        buffer_views: Vec<BufferView> = Vec::new(),
        buffers: Vec<Buffer> = Vec::new(),
        #[serde(deserialize_with = "count")]
        animations: usize = 0,
        extensions: DocumentExtensions = DocumentExtensions::default(),
    }
    struct Asset {
        version: String = String::new(),
        min_version: Option<String> = None,
    }
    struct DocumentExtensions {
        #[serde(rename = "KHR_lights_punctual")]
        lights: Lights = Lights::default(),
    }
    struct Lights { lights: Vec<Light> = Vec::new(), }
    struct Light {
        name: Option<Box<str>> = None,
        #[serde(rename = "type")]
        kind: Box<str> = Box::from(""),
        color: [f32; 3] = [1.0; 3],
        intensity: f32 = 1.0,
        spot: Spot = Spot::default(),
    }
    struct Spot {
        inner_cone_angle: f32 = 0.0,
        outer_cone_angle: f32 = std::f32::consts::FRAC_PI_4,
    }
    struct SceneNodes { nodes: Vec<u32> = Vec::new(), }
    struct Node {
        name: Option<Box<str>> = None,
        children: Box<[u32]> = Box::default(),
        mesh: Option<u32> = None,
        camera: Option<u32> = None,
        #[serde(deserialize_with = "present")]
        skin: bool = false,
        matrix: Option<Box<[f64; 16]>> = None,
        translation: Option<Box<[f64; 3]>> = None,
        rotation: Option<Box<[f64; 4]>> = None,
        scale: Option<Box<[f64; 3]>> = None,
        extensions: Option<Box<NodeExtensions>> = None,
    }
    struct NodeExtensions {
        #[serde(rename = "KHR_lights_punctual")]
        light: Option<LightOf> = None,
        #[serde(rename = "KHR_node_visibility")]
        visibility: Visibility = Visibility::default(),
    }
    struct LightOf { light: u32 = u32::MAX, }
    struct Visibility { visible: bool = true, }
    struct Camera {
        #[serde(rename = "type")]
        kind: Box<str> = Box::from(""),
        perspective: Perspective = Perspective::default(),
    }
    struct Perspective { yfov: f32 = 0.0, }
    struct Mesh {
        name: Option<Box<str>> = None,
        primitives: Vec<Primitive> = Vec::new(),
    }
    struct Primitive {
        attributes: Attributes = Attributes::default(),
        indices: Option<u32> = None,
        material: Option<u32> = None,
        mode: u32 = 4,
        #[serde(deserialize_with = "present")]
        targets: bool = false,
    }
    /// Accessors of the attributes that are read.
    #[derive(Copy)]
    struct Attributes {
        #[serde(rename = "POSITION")]
        position: Option<u32> = None,
        #[serde(rename = "NORMAL")]
        normal: Option<u32> = None,
        #[serde(rename = "TANGENT")]
        tangent: Option<u32> = None,
        #[serde(rename = "TEXCOORD_0")]
        uv0: Option<u32> = None,
        #[serde(rename = "TEXCOORD_1")]
        uv1: Option<u32> = None,
        #[serde(rename = "COLOR_0")]
        color: Option<u32> = None,
    }
    struct Accessor {
        buffer_view: Option<u32> = None,
        byte_offset: u64 = 0,
        component_type: u32 = 0,
        count: u64 = 0,
        normalized: bool = false,
        #[serde(rename = "type")]
        shape: Shape = Shape::Other,
        sparse: Option<Box<Sparse>> = None,
    }
    struct Sparse {
        count: u64 = 0,
        indices: SparseIndices = SparseIndices::default(),
        values: SparseValues = SparseValues::default(),
    }
    struct SparseIndices {
        buffer_view: u32 = u32::MAX,
        byte_offset: u64 = 0,
        component_type: u32 = 0,
    }
    struct SparseValues {
        buffer_view: u32 = u32::MAX,
        byte_offset: u64 = 0,
    }
    struct BufferView {
        buffer: u32 = u32::MAX,
        byte_offset: u64 = 0,
        byte_length: u64 = 0,
        byte_stride: Option<u32> = None,
        extensions: Option<Box<ViewExtensions>> = None,
    }
    struct ViewExtensions {
        #[serde(rename = "EXT_meshopt_compression")]
        meshopt: Option<Compressed> = None,
    }
    /// A view whose bytes are made from others.
    struct Compressed {
        buffer: u32 = u32::MAX,
        byte_offset: u64 = 0,
        byte_length: u64 = 0,
        byte_stride: u32 = 0,
        count: u64 = 0,
        mode: String = String::new(),
        filter: Option<String> = None,
    }
    struct Buffer {
        uri: Option<Box<str>> = None,
        byte_length: u64 = 0,
    }
    struct Image {
        name: Option<Box<str>> = None,
        uri: Option<Box<str>> = None,
        buffer_view: Option<u32> = None,
    }
    struct Sampler {
        mag_filter: Option<u32> = None,
        wrap_s: u32 = 10497,
        wrap_t: u32 = 10497,
    }
    struct Texture {
        sampler: Option<u32> = None,
        source: Option<u32> = None,
    }
    struct Material {
        name: Option<Box<str>> = None,
        pbr_metallic_roughness: Option<Box<MetallicRoughness>> = None,
        normal_texture: Option<Box<TextureInfo>> = None,
        emissive_texture: Option<Box<TextureInfo>> = None,
        emissive_factor: [f32; 3] = [0.0; 3],
        alpha_mode: AlphaMode = AlphaMode::Opaque,
        alpha_cutoff: f32 = 0.5,
        double_sided: bool = false,
        extensions: Option<Box<MaterialExtensions>> = None,
    }
    struct MetallicRoughness {
        base_color_factor: [f32; 4] = [1.0; 4],
        base_color_texture: Option<TextureInfo> = None,
        metallic_factor: f32 = 1.0,
        roughness_factor: f32 = 1.0,
        metallic_roughness_texture: Option<TextureInfo> = None,
    }
    /// A texture with how it is laid; `scale` belongs to normal maps.
    struct TextureInfo {
        index: u32 = u32::MAX,
        tex_coord: u32 = 0,
        scale: f32 = 1.0,
        extensions: TextureInfoExtensions = TextureInfoExtensions::default(),
    }
    struct TextureInfoExtensions {
        #[serde(rename = "KHR_texture_transform")]
        transform: Option<TextureTransform> = None,
    }
    struct TextureTransform {
        offset: [f32; 2] = [0.0; 2],
        rotation: f32 = 0.0,
        scale: [f32; 2] = [1.0; 2],
        tex_coord: Option<u32> = None,
    }
    struct MaterialExtensions {
        #[serde(rename = "KHR_materials_emissive_strength")]
        strength: EmissiveStrength = EmissiveStrength::default(),
        #[serde(rename = "KHR_materials_ior")]
        ior: Ior = Ior::default(),
        #[serde(rename = "KHR_materials_specular")]
        specular: Specular = Specular::default(),
        #[serde(rename = "KHR_materials_transmission")]
        transmission: Transmission = Transmission::default(),
        #[serde(rename = "KHR_materials_volume")]
        volume: Volume = Volume::default(),
        #[serde(rename = "KHR_materials_unlit", deserialize_with = "present")]
        unlit: bool = false,
    }
    struct EmissiveStrength { emissive_strength: f32 = 1.0, }
    struct Ior { ior: f32 = 1.5, }
    struct Specular {
        specular_factor: f32 = 1.0,
        specular_texture: Option<TextureInfo> = None,
        specular_color_factor: [f32; 3] = [1.0; 3],
        specular_color_texture: Option<TextureInfo> = None,
    }
    struct Transmission {
        transmission_factor: f32 = 0.0,
        transmission_texture: Option<TextureInfo> = None,
    }
    struct Volume {
        thickness_factor: f32 = 0.0,
        attenuation_distance: f32 = f32::INFINITY,
        attenuation_color: [f32; 3] = [1.0; 3],
    }
}

/// How many components an element has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub(super) enum Shape {
    #[serde(rename = "SCALAR")]
    Scalar,
    #[serde(rename = "VEC2")]
    Vec2,
    #[serde(rename = "VEC3")]
    Vec3,
    #[serde(rename = "VEC4")]
    Vec4,
    /// Matrices, which no attribute read here has, and names unknown.
    #[serde(other)]
    Other,
}

/// What alpha means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "UPPERCASE")]
pub(super) enum AlphaMode {
    Opaque,
    Mask,
    Blend,
    #[serde(other)]
    Other,
}

/// True for whatever is there.
fn present<'de, D: serde::Deserializer<'de>>(from: D) -> Result<bool, D::Error> {
    serde::de::IgnoredAny::deserialize(from).map(|_| true)
}

/// The length of an array that is not kept.
fn count<'de, D: serde::Deserializer<'de>>(from: D) -> Result<usize, D::Error> {
    struct Count;
    impl<'de> serde::de::Visitor<'de> for Count {
        type Value = usize;
        fn expecting(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
            out.write_str("an array")
        }
        fn visit_seq<A: serde::de::SeqAccess<'de>>(self, mut seq: A) -> Result<usize, A::Error> {
            let mut n = 0;
            while seq.next_element::<serde::de::IgnoredAny>()?.is_some() {
                n += 1;
            }
            Ok(n)
        }
    }
    from.deserialize_seq(Count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_an_array_may_repeat_is_small() {
        let sizes = [
            size_of::<Node>(),
            size_of::<Mesh>(),
            size_of::<Material>(),
            size_of::<Accessor>(),
            size_of::<BufferView>(),
            size_of::<Primitive>(),
            size_of::<Light>(),
            size_of::<Image>(),
        ];
        assert!(sizes.iter().all(|&s| s <= 96), "{sizes:?}");
    }

    #[test]
    fn defaults_are_those_of_the_format() {
        let text = r#"{"asset":{"version":"2.0"},"materials":[{"extensions":{"KHR_materials_unlit":{}}}],
            "animations":[{},{"a":[1]}],"accessors":[{"type":"MAT4"},{"type":"VEC3"}]}"#;
        let d: Document = serde_json::from_str(text).unwrap();
        assert_eq!((d.animations, d.materials[0].alpha_cutoff), (2, 0.5));
        assert!(d.materials[0].extensions.as_ref().unwrap().unlit);
        assert_eq!((d.accessors[0].shape, d.accessors[1].shape), (Shape::Other, Shape::Vec3));
        assert_eq!(d.materials[0].extensions.as_ref().unwrap().ior.ior, 1.5);
    }
}
