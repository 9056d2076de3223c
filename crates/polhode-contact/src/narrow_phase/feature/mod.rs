//! Features of shapes: what a contact may name.

pub(crate) mod closest_feature;
pub mod counterpart;
pub(crate) mod element;
pub(crate) mod mesh_feature;
pub(crate) mod part_feature;
