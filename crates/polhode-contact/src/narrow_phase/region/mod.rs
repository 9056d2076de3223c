//! The region in which two bodies touch, and its contacts.

pub(crate) mod face_contacts;
pub(crate) mod face_pair;
pub(crate) mod kept_region;
pub(crate) mod round_region;
pub(crate) mod tied_faces;
