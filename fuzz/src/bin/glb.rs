//! glTF in its binary container.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| lampyris_fuzz::scene("scene.glb", "part.bin", input));
