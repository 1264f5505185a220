//! Textures: PNG, JPEG, PGM and PPM.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heliodon_fuzz::texture(bytes));
