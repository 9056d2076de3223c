//! Any bytes as two shapes at poses.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| polhode_contact_fuzz::check(bytes));
