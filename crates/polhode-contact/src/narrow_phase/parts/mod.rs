//! Compounds and triangle meshes: the results of pairs of their parts, combined.
//!
//! | module | holds |
//! |---|---|
//! | `same_places` | one contact for each place and normal |
//! | `surface_probe` | how the surface is sampled beside a contact |
//! | `ridge_ends` | edge-edge contacts at the vertices of bent ridges |
//! | `triangle_axes` | separating axes of a triangle and a polyhedron |
//! | `mesh_contacts` | the contacts of one triangle |
//! | `mesh_pair` | a mesh against another body |
//! | `compound_surface` | which contacts of a part are contacts of the whole |
//! | `compound_pair` | compounds, and any pair part by part |

pub(crate) mod compound_pair;
pub(crate) mod compound_surface;
pub(crate) mod mesh_contacts;
pub(crate) mod mesh_pair;
pub(crate) mod ridge_ends;
pub(crate) mod same_places;
mod surface_probe;
pub(crate) mod triangle_axes;
