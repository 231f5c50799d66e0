//! A million triangles: what loading them holds at once, beside what is kept of them.
//! A test binary of its own, because its allocator counts for the whole process.

mod gltf_support;

use gltf_support::{Folder, Glb};
use lampyris::import::{Options, load};
use peak_alloc::PeakAlloc;
use serde_json::json;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// A wavy sheet of 2·n² triangles with normals.
fn sheet(n: u32) -> Glb {
    let mut glb = Glb::new();
    let side = n + 1;
    let at = |k: u32| [(k % side) as f32, (k / side) as f32, (k % 7) as f32 * 0.1];
    let points: Vec<f32> = (0..side * side).flat_map(at).collect();
    let normals: Vec<f32> = (0..side * side).flat_map(|_| [0.0, 0.0, 1.0]).collect();
    let corner = |x: u32, y: u32| y * side + x;
    let square = |k: u32| {
        let (x, y) = (k % n, k / n);
        let [a, b, c, d] = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
        [a, b, c, a, c, d]
    };
    let indices: Vec<u32> = (0..n * n).flat_map(square).collect();
    let position = glb.floats("VEC3", &points);
    let normal = glb.floats("VEC3", &normals);
    let index = glb.indices(&indices);
    glb.mesh(json!({"attributes": {"POSITION": position, "NORMAL": normal}, "indices": index}));
    glb
}

#[test]
fn the_file_and_one_copy_are_all_that_is_held() {
    let folder = Folder::new();
    let bytes = sheet(775).bytes();
    let path = folder.write("main.glb", &bytes);
    let file = bytes.len();
    drop(bytes);
    let before = MEMORY.current_usage();
    MEMORY.reset_peak_usage();
    let loaded = load(&path, &Options::default()).unwrap();
    let (peak, kept) = (MEMORY.peak_usage() - before, MEMORY.current_usage() - before);
    let mesh = &loaded.scene.meshes[0];
    assert_eq!((mesh.triangles.len(), mesh.positions.len()), (2 * 775 * 775, 776 * 776));
    // 12 bytes a position and a normal, 12 and 4 a triangle; for a moment, the indices once more.
    let exact = 24 * mesh.positions.len() + 16 * mesh.triangles.len();
    assert!(kept <= exact + (64 << 10), "{kept} bytes kept of {exact}");
    let most = file + exact + 12 * mesh.triangles.len() + (64 << 10);
    assert!(peak <= most && peak <= 70 * mesh.triangles.len(), "{peak} bytes at most, {most} expected");
}
