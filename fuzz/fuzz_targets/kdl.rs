//! Scenes in KDL.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heliodon_fuzz::kdl(bytes));
