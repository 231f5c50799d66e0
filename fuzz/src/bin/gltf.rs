//! glTF as JSON, with a buffer beside it.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| lampyris_fuzz::scene("scene.gltf", "part.bin", input));
