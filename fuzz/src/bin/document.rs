//! Saved edits of a small scene.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| lampyris_fuzz::document(input));
