//! Two shapes without parts.
//!
//! | module | holds |
//! |---|---|
//! | `clipped_boxes` | the contacts of two boxes by clipping, for methods that let bodies overlap |
//! | `measure` | evaluates features at the poses of the bodies |
//! | `facing` | the pair of faces of two polyhedra that lie on each other |
//! | `polyhedra` | the contacts of two polyhedra whose best axes are known |
//! | `pair_separation` | the separation of any two |
//! | `pair_manifold` | the contacts of any two |

pub mod clipped_boxes;
pub(crate) mod facing;
pub(crate) mod measure;
pub(crate) mod pair_manifold;
pub(crate) mod pair_separation;
pub(crate) mod polyhedra;
