//! The results for two shapes of any kind are consistent.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| polhode_contact_fuzz::check_answers(bytes));
