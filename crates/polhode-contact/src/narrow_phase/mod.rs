//! Narrow phase: whether, where and how two shapes touch.

mod closest_feature;
mod coherence;
pub(crate) mod composite;
mod compound_surface;
pub mod convex_method;
pub mod counterpart;
pub(crate) mod crossed_edges;
mod edge_axes;
pub(crate) mod epa;
pub mod evaluate;
pub(crate) mod face_contacts;
pub(crate) mod face_pair;
pub(crate) mod gjk;
pub mod manifold;
mod mesh_contacts;
mod mesh_feature;
pub(crate) mod mesh_pair;
pub(crate) mod part_feature;
pub mod persistent;
mod region_coherence;
pub(crate) mod ridge_ends;
pub(crate) mod round;
pub mod separating_axis;
pub mod separation;
pub(crate) mod simplex;
pub mod tangential;
mod tied_faces;
mod triangle_axes;

pub(crate) use closest_feature::nearest_feature;
