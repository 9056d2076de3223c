//! Benches of polhode beside other people's engines and readers, each against the other in one run.
//!
//! | bench | beside | what |
//! |---|---|---|
//! | `narrow_phase` | rapier3d-f64 | broad and narrow phase on the same piles |
//! | `free_bodies` | rapier3d-f64 | ten thousand bodies in flight |
//! | `step` | rapier3d-f64 | a step of ten thousand bodies, with and without their poses read |
//! | `mesh_readers` | tobj | files of triangle meshes |
//!
//! `cargo bench --manifest-path peers/Cargo.toml --bench NAME`. The package is a workspace of its own: whoever builds
//! or tests polhode need not compile what it is held against.

/// Box3D, whose build asks for more than the others: behind a feature, which dev-dependencies cannot have.
#[cfg(feature = "box3d")]
pub use box3d;
