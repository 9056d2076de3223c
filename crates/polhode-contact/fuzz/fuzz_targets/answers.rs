//! The answers of two shapes of any kind agree with each other.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| polhode_contact_fuzz::check_answers(bytes));
