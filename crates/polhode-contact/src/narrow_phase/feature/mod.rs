//! Features of shapes: what a contact may name.
//!
//! | module | holds |
//! |---|---|
//! | `part_feature` | numbers among all parts of a compound, and within one part |
//! | `contact_name` | the name of a contact of two surface features |
//! | `alike` | the angle within which two normals belong to one region |
//! | `edge_line` | an edge of a polyhedron or of a mesh |
//! | `placed` | a shape at a pose |
//! | `face_border` | the distance of a point from the border of a polyhedron's face |
//! | `mesh_feature` | faces, edges and vertices of a triangle mesh |
//! | `branch` | which of two points of a circle a feature names |
//! | `element` | features as Minkowski sums of a locus and a ball |
//! | `closest_feature` | the feature of a polyhedron that is nearest to a point |
//! | `counterpart` | the second contact of two vertices that coincide |

pub(crate) mod alike;
pub(crate) mod branch;
pub(crate) mod closest_feature;
pub(crate) mod contact_name;
pub mod counterpart;
pub(crate) mod edge_line;
pub(crate) mod element;
pub(crate) mod face_border;
pub(crate) mod mesh_feature;
pub(crate) mod part_feature;
pub(crate) mod placed;
