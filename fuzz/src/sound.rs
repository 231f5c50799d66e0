//! What scenes and pictures promise, whatever their files were.

use lampyris::scene::{Instance, Scene};
use lampyris::texture::{Image, Pixels};

/// Panics unless all numbers are finite and all references lead somewhere.
pub(crate) fn check(scene: &Scene) {
    for mesh in &scene.meshes {
        let n = mesh.positions.len();
        assert!(mesh.positions.iter().chain(&mesh.normals).all(|p| p.is_finite()));
        assert!(mesh.uvs.iter().flatten().all(|uv| uv.is_finite()));
        assert!(mesh.tangents.iter().chain(&mesh.colors).all(|v| v.is_finite()));
        let [first, second] = &mesh.uvs;
        let lengths = [mesh.normals.len(), first.len(), second.len(), mesh.tangents.len(), mesh.colors.len()];
        assert!(lengths.iter().all(|l| *l == 0 || *l == n), "{lengths:?} for {n} vertices");
        assert!(mesh.triangles.iter().flatten().all(|corner| (*corner as usize) < n));
        assert_eq!(mesh.triangles.len(), mesh.materials.len());
        assert!(mesh.materials.iter().all(|m| (*m as usize) < scene.materials.len()));
    }
    for instance in &scene.instances {
        let there = (instance.mesh as usize) < scene.meshes.len() || instance.mesh == Instance::AWAY;
        assert!(there && instance.transform.is_finite());
    }
    assert!(scene.materials.iter().all(|m| m.emission.is_finite()));
    assert!(scene.textures.iter().all(|t| (t.image as usize) < scene.images.len()));
    scene.images.iter().for_each(check_image);
}

/// Panics unless all pixels are there.
pub(crate) fn check_image(image: &Image) {
    let pixels = match &image.pixels {
        Pixels::Byte(pixels) => pixels.len(),
        Pixels::Float(pixels) => pixels.len(),
    };
    assert!(pixels > 0 && pixels as u64 == u64::from(image.width) * u64::from(image.height));
}
