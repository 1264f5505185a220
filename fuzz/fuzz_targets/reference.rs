//! Reference pictures of `cost --reference`: PNG, JPEG, PNM and PFM.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| heliodon_fuzz::reference(bytes));
