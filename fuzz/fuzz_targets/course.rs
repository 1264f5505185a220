//! Scenes in the course's block grammar.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heliodon_fuzz::course(bytes));
