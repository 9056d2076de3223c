//! Exact geometry of two convex polyhedra, to judge the contact crate by: no code is shared with it.
//!
//! What goes in are points and poses; faces and edges are found from the points alone, and the tolerances that the
//! crate promises are stated here again. Features have numbers of their own, which the cases translate at one place
//! (`cases/feature_numbers.rs`).
//!
//! Vertices, quaternions and positions are numbers of f64, and sums and products of them are computed without rounding
//! ([`dyadic`]). A quaternion `q` turns by `q v q*/|q|^2`, whatever its length is, so that the poses meant are exactly
//! those that the numbers say; the divisions are left out by scaling both bodies alike ([`pair`]). A separation along
//! an axis is compared as its square with its sign, and its root is taken last, to 160 binary places.
//!
//! | module | holds |
//! |---|---|
//! | [`dyadic`] | numbers `m 2^e` with a whole `m` of any length, and vectors of them |
//! | `orientation` | on which side of a plane a point lies |
//! | [`polyhedron`] | the convex hull of points with its faces and edges |
//! | [`feature`] | the features of a contact |
//! | [`pair`] | two polyhedra in one exact frame: separations along faces, edges and any direction; the best axis |
//! | [`expected`] | the contacts of a pair in a general pose |
//! | [`overlap`] | the vertices of the overlap of two faces that lie on each other |

pub mod dyadic;
pub mod expected;
pub mod feature;
mod orientation;
pub mod overlap;
pub mod pair;
pub mod polyhedron;
