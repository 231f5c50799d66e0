//! MGF, with a file that it may include.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| lampyris_fuzz::scene("scene.mgf", "part.mgf", input));
