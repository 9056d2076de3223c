//! Any bytes as OFF.
#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode_mesh::MeshFormat;

fuzz_target!(|bytes: &[u8]| polhode_mesh_fuzz::check(bytes, MeshFormat::Off));
