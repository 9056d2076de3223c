//! Collision shapes, broad phase, contact manifolds and rigorous times of impact of rigid bodies.
//!
//! The crate takes shapes, poses and motions; it knows no mass and no force. Shapes stand in the body's central frame
//! (axes of the body, origin at its centre of mass, [`Shape::translated`]), and a pose is `X_WC`. All lengths are in
//! metres. A contact normal is of unit length, in world axes, and points from B to A; a separation is negative when
//! the bodies overlap. Swapping A and B mirrors every answer: normals turn round, features change sides.
//!
//! Everything is computed from the difference of the two poses, so that a pair far from the origin loses nothing
//! beyond the rounding of its poses, and every tolerance is relative to the size of the pair ([`clearance`]).
//!
//! | module | holds |
//! |---|---|
//! | [`shape`] | [`Shape`], [`Sphere`], [`HalfSpace`], [`PointCloud`] |
//! | [`polyhedron`] | [`ConvexPolyhedron`]: faces of any number of vertices, edges, neighbours |
//! | [`feature`] | [`ContactFeature`]: which features touch, the persistent identity of a contact |
//! | [`contact`] | [`Contact`], [`ContactGeometry`], [`ContactKinematics`], [`Manifold`] |
//! | [`manifold()`](manifold::manifold) | all contacts of a pair at given poses |
//! | [`evaluate()`](evaluate::evaluate) | the same contact at other poses; its first and second time derivatives |
//! | [`separation()`](separation::separation) | signed separation of a pair |
//! | [`time_of_impact()`](time_of_impact::time_of_impact) | first time at which two moving shapes close |
//! | [`clearance`] | the tolerances, each relative to the size of the pair |
//! | [`broad_phase`] | [`BroadPhase`], [`Bvh`]: which pairs may touch |
//! | [`mod@approximate_decomposition`] | [`approximate_decomposition()`]: few convex parts that nearly fill a solid |
//! | [`aabb`] | [`Aabb`], [`swept_aabb`]: bounds of a moving shape |
//!
//! ```
//! use polhode_contact::{Shape, manifold};
//! use polhode_spatial::{DVec3, Pose, UnitVector};
//! let brick = Shape::cuboid(DVec3::new(1.0, 0.5, 0.25))?;
//! let floor = Shape::half_space(UnitVector::Z);
//! let resting = manifold(&brick, &Pose::from_translation(DVec3::Z * 0.125), &floor, &Pose::IDENTITY, 1e-9);
//! assert_eq!(resting.contacts.len(), 4);
//! assert_eq!(resting.contacts[0].geometry.normal, DVec3::Z);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod aabb;
pub mod approximate_decomposition;
mod backend;
pub mod broad_phase;
pub mod clearance;
mod closest_feature;
pub mod contact;
mod crossed_edges;
pub mod evaluate;
mod face_pair;
pub mod feature;
mod hull;
mod impact_bounds;
pub mod manifold;
pub mod mirror;
pub mod polyhedron;
mod quadratic_bound;
mod root_bracket;
mod separating_axis;
pub mod separation;
pub mod shape;
pub mod time_of_impact;
mod topology;

pub use aabb::{Aabb, AabbError, swept_aabb};
pub use approximate_decomposition::{
    ApproximateDecomposition, ApproximateError, ApproximateSettings, approximate_decomposition,
};
pub use broad_phase::{BroadPhase, BroadPhaseError, Bvh};
pub use contact::{Contact, ContactGeometry, ContactKinematics, Manifold, SeparatingAxis};
pub use evaluate::{evaluate, kinematics};
pub use feature::{ContactFeature, Side, SurfaceFeature};
pub use manifold::{manifold, manifold_with};
pub use mirror::mirror_defect;
pub use polyhedron::{ConvexPolyhedron, Edge, Face};
pub use separating_axis::Workspace;
pub use separation::{separation, separation_with};
pub use shape::{HalfSpace, PointCloud, Shape, ShapeError, Sphere};
pub use time_of_impact::{ImpactError, ImpactReport, ImpactSearch, find_impact, time_of_impact};
