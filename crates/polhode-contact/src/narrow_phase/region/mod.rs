//! The region in which two bodies touch, and its contacts.
//!
//! | module | holds |
//! |---|---|
//! | `upward` | which direction is up |
//! | `same_place` | when two contacts of one pair are at the same place |
//! | `placed_face` | the corners of a face, classified against the sides of another |
//! | `face_contacts` | the geometry of the contacts of two faces |
//! | `pair_buffers` | what a pair keeps from call to call |
//! | `face_pair` | the contacts of two faces that lie on each other |
//! | `tied_faces` | the contacts along each of several faces that separate equally well |
//! | `kept_region` | the contacts of two faces, kept for poses nearby |
//! | `round_region` | the contacts of two bodies, at least one of them round |

pub(crate) mod face_contacts;
pub(crate) mod face_pair;
pub(crate) mod kept_region;
pub(crate) mod pair_buffers;
pub(crate) mod placed_face;
pub(crate) mod round_region;
pub(crate) mod same_place;
pub(crate) mod tied_faces;
pub(crate) mod upward;
