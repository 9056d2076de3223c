//! Judges: they say of contacts, structures and whole runs whether they are right, and share no code with what they
//! judge.
//!
//! What they take are data: poses, triangles, samples and terms of the ledger. The house checks that none of them names
//! a crate that it judges. Random scenes and mechanisms are here too, since they are what is judged.
//!
//! | module | holds |
//! |---|---|
//! | [`exact`] | exact geometry of convex polyhedra, to judge contacts by |
//! | [`interpenetration`] | whether bodies are in each other, without the contact crate |
//! | [`judge`] | whether the run of a random scene keeps the laws of physics |
//! | [`statics`] | static equilibrium of structures of blocks, from their geometry alone |
//! | [`random`] | random numbers with a fixed seed |
//! | [`random_mechanism`] | random mechanisms and small piles, which several tiers compute |
//! | [`random_scene`] | random scenes, and the command that writes one |

pub mod exact;
pub mod interpenetration;
pub mod judge;
pub mod random;
pub mod random_mechanism;
pub mod random_scene;
pub mod statics;
