//! Compounds and triangle meshes: what pairs of their parts give, put together.

pub(crate) mod composite;
pub(crate) mod compound_surface;
pub(crate) mod mesh_contacts;
pub(crate) mod mesh_pair;
pub(crate) mod ridge_ends;
pub(crate) mod triangle_axes;
