//! Collision shapes, broad phase, contact manifolds and rigorous times of impact of rigid bodies.
//!
//! The crate takes shapes, poses and motions; it knows no mass and no force. The coordinates of shapes are in the
//! body's central frame (axes of the body, origin at its centre of mass, see [`Shape::translated`]), and a pose is
//! `X_WC`. All lengths are in metres. A contact normal is of unit length, in world axes, and points from B to A; a
//! separation is negative when the bodies overlap. Swapping A and B reverses every normal and exchanges the features
//! of A and B in every contact.
//!
//! Everything is computed from the difference of the two poses, so that a pair far from the origin loses nothing
//! beyond the rounding of its poses, and every tolerance is relative to the size of the pair ([`clearance`]).
//!
//! | module | holds |
//! |---|---|
//! | [`mod@shape`] | [`Shape`] and its kinds: polyhedra, spheres, capsules, cylinders, cones, tori, |
//! | | half-spaces, points, meshes, compounds |
//! | [`feature`] | [`ContactFeature`]: which features touch, the persistent identity of a contact |
//! | [`contact`] | [`Contact`], [`ContactGeometry`], [`ContactKinematics`], [`TangentialKinematics`], [`Manifold`] |
//! | [`narrow_phase`] | [`manifold()`]: all contacts of a pair |
//! | | [`near_manifold()`]: the same, cheaper for a pair that is likely apart |
//! | | [`near_manifold_with()`]: the same, faster with a [`PairMemory`] that is kept from step to step |
//! | | [`evaluate()`], [`kinematics()`]: one contact at other poses, and its time derivatives |
//! | | [`kinematics_with_tangential()`]: also its slip and the terms of the slip's derivative |
//! | | [`tangent_basis()`]: the directions in which the slip is measured |
//! | | [`separation()`]: how far apart a pair is; [`separation_by()`]: by a chosen [`ConvexMethod`] |
//! | | [`counterpart()`]: the second contact of two vertices that coincide |
//! | [`query`] | [`distance()`], [`ray_cast()`], [`overlap()`], [`contains()`], [`closest_point()`] |
//! | | [`QueryScene`]: the same for many bodies |
//! | [`impact`] | [`time_of_impact()`], [`find_impact()`]: first time at which two moving shapes touch |
//! | | [`time_of_further_impact()`]: the next impact of shapes that touch already |
//! | [`clearance`] | the tolerances, each relative to the size of the pair |
//! | [`bounding`] | [`Aabb`], [`aabb_of`], [`swept_aabb`]: boxes around still and moving shapes |
//! | [`broad_phase`] | [`BroadPhase`], chosen by [`BroadPhaseMethod`]: which pairs may touch |
//! | `backend` | the one module that names parry3d |
//!
//! A program needs to depend on this crate alone: the types in its signatures are exported here, the rest of
//! polhode-spatial under [`spatial`], that of polhode-mesh under [`mesh`]. A moving body is given by a [`Motion`];
//! motions in closed form are [`Still`], [`ConstantVelocity`], [`ConstantScrew`] and [`SteadyFlight`]. Programs of ten
//! lines are in the folder `examples` of the crate: `contacts_of_two_boxes`, `impact_of_two_boxes` and
//! `impact_of_a_box_on_a_turntable`.
//!
//! ```
//! use polhode_contact::{DVec3, Pose, Shape, UnitVector, manifold};
//! let brick = Shape::cuboid(DVec3::new(1.0, 0.5, 0.25))?;
//! let floor = Shape::half_space(UnitVector::Z);
//! let resting = manifold(&brick, &Pose::from_translation(DVec3::Z * 0.125), &floor, &Pose::IDENTITY, 1e-9);
//! assert_eq!(resting.contacts.len(), 4);
//! assert_eq!(resting.contacts[0].geometry.normal, DVec3::Z);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Words
//!
//! "The thesis" is the document that the project implements; `docs/REFERENCES.md` of the repository lists its errata
//! (E1 to E25) and the other sources that are cited by name. The crate uses the terms of the field, and these in a
//! narrower sense:
//!
//! | word | meaning |
//! |---|---|
//! | element | a feature as the Minkowski sum of a point, line, circle, plane or the side of a cone with a ball |
//! | place | a point of contact: a common normal of two features, with its point on each |
//! | in one place, to coincide | of features: nearer to each other than the place tolerance |
//! | reach | the largest separation at which contacts are reported, m |
//! | region | all features that touch around one separating axis |
//! | part | a convex shape of a compound, or a triangle of a mesh |
//! | patch | neighbouring triangles of a mesh that lie in one plane |
//! | round shape | a capsule, cylinder or cone |
//! | ring | a torus; its centre circle is the middle of its tube |
//! | smooth shape | a sphere, a round shape or a ring |
//! | locus | the point, line, circle, plane or side of a cone of an element, without the ball |
//! | branch | one of two halves of a circle; a feature names it by `RimExit` or `RimEntry` |
//! | best axis, face or edges | those with the largest separation |
//! | deciding axis, face or edges | the best ones after ties are decided: the contacts follow from them |
//! | clear | separated, in the search for impacts |
//! | closing | reaching a separation of zero |
//!
//! # Stages
//!
//! In the order of the calls; paths are in `src`. The contacts of many bodies:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | shape | checks a shape, and stores what queries need: faces, edges, hull | `shape/construction.rs` |
//! | boxes | bounds each body over an interval of time | `bounding/around_shape.rs` |
//! | broad phase | finds the pairs whose boxes overlap | `broad_phase` |
//! | dispatch | chooses the algorithm by the kinds of the two shapes | `narrow_phase/dispatch/manifold.rs` |
//! | | holds the buffers and the memory of the pair | `narrow_phase/dispatch/pair_memory.rs` |
//! | parts | splits compounds and meshes into pairs of parts | `narrow_phase/parts/compound_pair.rs` |
//! | | keeps the contacts that lie on the whole surface | `narrow_phase/parts/mesh_pair.rs` |
//! | axis | searches for the axis of largest separation | `narrow_phase/axis/separating_axis.rs` |
//! | | | `narrow_phase/axis/gap.rs`, `narrow_phase/axis/ring.rs` |
//! | region | collects the features that touch around that axis | `narrow_phase/region/face_pair.rs` |
//! | | | `narrow_phase/region/round_region.rs` |
//! | terms | evaluates each contact: point, normal, separation, derivatives | `narrow_phase/terms/evaluate.rs` |
//!
//! The time at which two moving shapes touch:
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | search | checks arguments | `impact/time_of_impact.rs` |
//! | | splits compounds and meshes into pairs of parts | `impact/composite_impact.rs` |
//! | separation | evaluates the separation at a time, with the axis that attains it | `impact/pair_impact.rs` |
//! | bound | computes how long the pair certainly stays separated along that axis | `impact/impact_bounds.rs` |
//! | | | `impact/quadratic_bound.rs` |
//! | advancement | advances by that time and repeats, | `impact/pair_impact.rs` |
//! | | until the separation is no larger than its rounding error | `impact/pair_impact.rs` |
//! | refinement | resolves the time more finely than the rounding of poses would allow | `impact/fine_time.rs` |

mod backend;
pub mod bounding;
pub mod broad_phase;
pub mod clearance;
pub mod contact;
pub mod feature;
pub mod impact;
pub mod narrow_phase;
pub mod query;
pub mod shape;

pub use bounding::aabb::{Aabb, AabbError};
pub use bounding::around_shape::{aabb_of, swept_aabb};
pub use broad_phase::{BroadPhase, BroadPhaseError, BroadPhaseMethod, Bvh, UnknownBroadPhase};
pub use contact::{Contact, ContactGeometry, ContactKinematics, Manifold, SeparatingAxis, TangentialKinematics};
pub use feature::{ContactFeature, Side, SurfaceFeature};
pub use impact::time_of_impact::{
    ImpactError, ImpactReport, ImpactSearch, find_impact, time_of_further_impact, time_of_impact,
};
pub use narrow_phase::clipped_boxes::clipped_manifold;
pub use narrow_phase::convex_method::{ConvexMethod, separation_by};
pub use narrow_phase::counterpart::counterpart;
pub use narrow_phase::evaluate::{evaluate, kinematics, kinematics_with_tangential};
pub use narrow_phase::manifold::{manifold, manifold_into, near_manifold};
pub use narrow_phase::open_face::Moving;
pub use narrow_phase::pair_memory::{PairMemory, near_manifold_with};
pub use narrow_phase::passing::Passing;
pub use narrow_phase::separation::{separation, separation_with};
pub use narrow_phase::tangential::tangent_basis;
pub use narrow_phase::workspace::Workspace;
pub use query::{
    ClosestPoints, QueryError, QueryFeature, QueryScene, Ray, RayHit, SurfacePoint, closest_point, contains, distance,
    overlap, ray_cast,
};
pub use shape::approximate_decomposition::{
    ApproximateDecomposition, ApproximateError, ApproximateSettings, approximate_decomposition,
};
pub use shape::mirror::mirror_defect;
pub use shape::polyhedron::{ConvexPolyhedron, Edge, Face};
pub use shape::prism::is_prism_along;
pub use shape::{
    Capsule, Compound, Cone, Cylinder, HalfSpace, PointCloud, Shape, ShapeError, Sphere, Torus, TriangleMesh,
};

pub use polhode_mesh as mesh;
pub use polhode_spatial as spatial;
pub use spatial::{
    ConstantScrew, ConstantVelocity, DMat3, DVec3, Motion, MotionBounds, MotionError, Pose, Rotation, RotationError,
    SteadyFlight, Still, UnitVector, UnitVectorError, Velocity,
};

// The program in the README is compiled and run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
