//! Bytes as two shapes at poses: every result exists or is refused with an error, and follows the conventions.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| polhode_contact_fuzz::check(bytes));
