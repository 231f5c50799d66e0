//! OBJ, with a library of materials.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| lampyris_fuzz::scene("scene.obj", "part.mtl", input));
