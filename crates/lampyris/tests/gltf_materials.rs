//! What glTF says of surfaces, and what becomes of it: factors, extensions, sides, coverage.

mod gltf_support;

use gltf_support::Glb;
use lampyris::Rgb;
use lampyris::material::{Bsdf, Coverage, Dielectric, Maps, Material, Pbr, Sides};
use serde_json::{Value, json};

fn with_warnings(material: Value) -> (Material, Vec<String>) {
    let mut glb = Glb::new();
    glb.square(material);
    let loaded = glb.load().unwrap();
    (loaded.scene.materials[0].clone(), loaded.warnings)
}

fn material(json: Value) -> Material {
    let (material, warnings) = with_warnings(json);
    assert_eq!(warnings, Vec::<String>::new());
    material
}

fn pbr(json: Value) -> Pbr {
    match material(json).bsdf {
        Bsdf::Pbr(pbr) => pbr,
        other => panic!("{other:?}"),
    }
}

fn extended(name: &str, extension: Value) -> Value {
    json!({"extensions": {name: extension}})
}

#[test]
fn defaults_are_the_formats() {
    let m = material(json!({"name": "plain"}));
    let want = Material { sides: Sides::EmitFront, ..Material::new("plain", Bsdf::Pbr(Pbr::default())) };
    assert_eq!(m, want);
    // A primitive without a material wears the same, made once and last.
    let mut glb = Glb::new();
    glb.square(json!({}));
    let mut other = glb.json["meshes"][0]["primitives"][0].clone();
    other.as_object_mut().unwrap().remove("material");
    for _ in 0..2 {
        glb.json["meshes"][0]["primitives"].as_array_mut().unwrap().push(other.clone());
    }
    let scene = glb.clean();
    assert_eq!((scene.materials.len(), scene.meshes[0].materials.clone()), (2, vec![0, 0, 1, 1, 1, 1]));
    assert_eq!(scene.materials[1].bsdf, Bsdf::Pbr(Pbr::default()));
}

#[test]
fn factors_arrive_and_are_brought_into_range() {
    let factors =
        json!({"baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.6});
    let want = Pbr { base_color: Rgb::new(0.1, 0.2, 0.3), metallic: 0.5, roughness: 0.6, ..Pbr::default() };
    assert_eq!(pbr(json!({"pbrMetallicRoughness": factors})), want);
    let odd = json!({"baseColorFactor": [-1, 2, 1e38, 1], "metallicFactor": 7, "roughnessFactor": -7});
    let want = Pbr { base_color: Rgb::new(0., 1., 1.), metallic: 1.0, roughness: 0.0, ..Pbr::default() };
    assert_eq!(pbr(json!({"pbrMetallicRoughness": odd})), want);
}

#[test]
fn extensions_change_what_they_say() {
    let specular = json!({"specularFactor": 0.0, "specularColorFactor": [2, 1, 0.5]});
    let got = pbr(extended("KHR_materials_specular", specular));
    assert_eq!((got.specular, got.specular_color), (0.0, Rgb::new(2., 1., 0.5)));
    assert_eq!(pbr(extended("KHR_materials_ior", json!({"ior": 1.33}))).ior, 1.33);
    assert_eq!(
        pbr(extended("KHR_materials_transmission", json!({"transmissionFactor": 0.75}))).transmission,
        0.75
    );
    let (m, warnings) = with_warnings(extended("KHR_materials_unlit", json!({})));
    let Bsdf::Pbr(paint) = m.bsdf else { panic!() };
    assert_eq!((paint.metallic, paint.specular, warnings.len()), (0.0, 0.0, 1));
    let (m, warnings) = with_warnings(extended("KHR_materials_ior", json!({"ior": 0})));
    assert!(matches!(m.bsdf, Bsdf::Pbr(p) if p.ior == 1.5) && warnings.len() == 1);
}

#[test]
fn glass_is_solid_where_it_has_a_thickness() {
    let glass = |volume: Value| {
        json!({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5, "baseColorFactor": [1, 0.5, 0.25, 1]},
            "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1},
                "KHR_materials_ior": {"ior": 1.6}, "KHR_materials_volume": volume}})
    };
    for thin in
        [json!({}), json!({"thicknessFactor": 0, "attenuationDistance": 1, "attenuationColor": [0, 0, 0]})]
    {
        assert!(matches!(material(glass(thin)).bsdf, Bsdf::Pbr(p) if p.transmission == 1.0));
    }
    let clear = material(glass(json!({"thicknessFactor": 0.01})));
    let tint = Rgb::new(1.0, 0.5, 0.25);
    let want = Dielectric { alpha: 0.25, ..Dielectric::new(1.6, tint) };
    assert_eq!(clear.bsdf, Bsdf::Dielectric(want));
    // After two metres of it, the square of the colour remains.
    let tinted = json!({"thicknessFactor": 1, "attenuationDistance": 0.5, "attenuationColor": [0.5, 1, 0]});
    let Bsdf::Dielectric(d) = material(glass(tinted)).bsdf else { panic!() };
    let left = d.attenuation.map(|s| (f64::from(-s) * 0.5) as f32);
    assert!((libm::expf(left.r) - 0.5).abs() < 1e-6 && left.g == 0.0 && libm::expf(left.b) < 2e-6);
    assert!(d.attenuation.is_finite());
    // A metal lets nothing pass, whatever else it says.
    let mut metal = glass(json!({"thicknessFactor": 1}));
    metal["pbrMetallicRoughness"]["metallicFactor"] = json!(1);
    assert!(matches!(material(metal).bsdf, Bsdf::Pbr(_)));
}

#[test]
fn emission_is_radiance_from_the_front_or_from_both_sides() {
    let strength = json!({"KHR_materials_emissive_strength": {"emissiveStrength": 500}});
    let lamp = material(json!({"emissiveFactor": [1, 0.5, 0.25], "extensions": strength}));
    assert_eq!((lamp.emission, lamp.sides), (Rgb::new(500., 250., 125.), Sides::EmitFront));
    assert_eq!(material(json!({"doubleSided": true})).sides, Sides::Both);
    let strength = json!({"KHR_materials_emissive_strength": {"emissiveStrength": 3e38}});
    let blinding = material(json!({"emissiveFactor": [100, 1e-30, 0], "extensions": strength}));
    assert_eq!((blinding.emission.r, blinding.emission.b), (1e18, 0.0));
    assert!((blinding.emission.g - 3e8).abs() < 1e3);
}

#[test]
fn alpha_is_coverage_by_its_mode() {
    let base = json!({"baseColorFactor": [1, 1, 1, 0.25]});
    let coverage = |mode: Value| {
        let mut m = json!({"pbrMetallicRoughness": base, "alphaCutoff": 0.75});
        m["alphaMode"] = mode;
        material(m).coverage
    };
    assert_eq!(coverage(json!("OPAQUE")), Coverage::Full);
    assert_eq!(coverage(json!("MASK")), Coverage::Mask { factor: 0.25, cutoff: 0.75 });
    assert_eq!(coverage(json!("BLEND")), Coverage::Blend { factor: 0.25 });
    let default = material(json!({"alphaMode": "MASK"})).coverage;
    assert_eq!(default, Coverage::Mask { factor: 1.0, cutoff: 0.5 });
}

#[test]
fn a_picture_that_cannot_be_had_leaves_the_factors() {
    let textured = json!({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1],
        "baseColorTexture": {"index": 0}}, "emissiveTexture": {"index": 1}, "normalTexture": {"index": 2},
        "occlusionTexture": {"index": 0}});
    let mut glb = Glb::new();
    glb.square(textured);
    glb.json["textures"] = json!([{"source": 0}, {"extensions": {"EXT_texture_webp": {"source": 0}}}]);
    glb.json["images"] = json!([{"uri": "missing.png"}, {"uri": "unused.png"}]);
    let loaded = glb.load().unwrap();
    let m = &loaded.scene.materials[0];
    assert!(matches!(&m.bsdf, Bsdf::Pbr(p) if p.base_color == Rgb::grey(0.5)) && m.maps == Maps::default());
    assert_eq!(loaded.warnings.len(), 3, "{:?}", loaded.warnings);
    let texts = ["\"missing.png\"", "without a picture", "does not exist"];
    assert!(texts.iter().all(|t| loaded.warnings.iter().any(|w| w.contains(t))), "{:?}", loaded.warnings);
}
