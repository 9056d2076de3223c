//! A contact of given features at any poses: its geometry, the first two time derivatives of its separation, and the
//! velocity of the contact point.
//!
//! Except for two edges and for pairs of curved elements, a contact is a point of a body V (a vertex, a point of a
//! cloud, a sphere's centre) against a feature of the other body E. Let `y` be the point's position in E's frame,
//! `phi(y)` its distance from the feature and `rho` the sum of the radii; then `chi = phi(y) - rho`, and with the
//! gradient `g` and Hessian `H` of `phi`
//!
//! `chi'  = g . u`,  `chi'' = g . (a_V - a_E) + 2 u . (w_E x g) + u . H u`,
//!
//! where `u = v_V - v_E` and `a_V - a_E` are the velocity and acceleration of the point relative to the material point
//! of E that coincides with it: thesis 3.4, `chi''` before equation (18), extended to curved distances and to
//! separations that are not zero. `H` is 0 for a face, `(1 - g g^T - e e^T)/phi` for an edge along `e` and
//! `(1 - g g^T)/phi` for a vertex or a sphere.
//!
//! The contact point is `x_V - (rho_V + chi/2) g`, and the gradient turns at the rate `g' = w_E x g + H u`: the
//! tangential terms follow from the rates of these two (`tangential.rs`).
//!
//! Two edges have a formula of their own (`crossed_edges.rs`), and so have capsules, cylinders, cones and tori
//! (`stationary.rs`).

use crate::clearance::{joint_size, place_tolerance};
use crate::narrow_phase::feature::contact_name::surface_parts;
use crate::narrow_phase::feature::element::Element;
use crate::narrow_phase::feature::part_feature::{Local, localized};
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::narrow_phase::terms::point_on_surface::PointOnSurface;
use crate::narrow_phase::terms::stationary::Stationary;
use crate::shape::round::is_round;
use crate::{ContactFeature, ContactGeometry, ContactKinematics, Shape, TangentialKinematics};
use glam::DVec3;
use polhode_spatial::{Pose, Velocity};

/// The geometry of a contact of these features at these poses. The manifold is computed with this function.
///
/// None when the shapes have no such features, when two edges are parallel ([`crate::clearance::PARALLEL_SINE`]), or
/// when a distance that gives the normal is zero.
pub fn evaluate(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> Option<ContactGeometry> {
    by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| Some(crossed.geometry()),
        |stationary| Some(stationary.geometry(pose_a.translation)),
        |point| Some(point.geometry()),
    )
}

/// The contact with the rate of its separation and the part of the second derivative that does not depend on the
/// accelerations ([`ContactKinematics`]). Linear velocities are those of the centres of mass.
///
/// None in the same cases as [`evaluate`].
pub fn kinematics(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<ContactKinematics> {
    by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| Some(crossed.kinematics(velocity_a, velocity_b)),
        |stationary| stationary.kinematics(pose_a.translation, velocity_a, velocity_b),
        |point| Some(point.kinematics(velocity_a, velocity_b)),
    )
}

/// The result of [`kinematics`], bit for bit, and the tangential terms that friction needs ([`TangentialKinematics`]),
/// from one evaluation.
///
/// None in the same cases as [`evaluate`].
///
/// A ball that slides without spin slips with its own velocity; one that rolls does not slip:
/// ```
/// use polhode_contact::{ContactFeature, Shape, Side, SurfaceFeature, kinematics_with_tangential};
/// use polhode_contact::{DVec3, Pose, UnitVector, Velocity};
/// let (ball, floor) = (Shape::sphere(0.5)?, Shape::half_space(UnitVector::Z));
/// let feature = ContactFeature::Smooth { center_of: Side::A, center: 0, against: SurfaceFeature::Face(0) };
/// let pose = Pose::from_translation(DVec3::Z * 0.5);
/// let slip = |spin: DVec3| {
///     let velocity = Velocity::new(DVec3::X, spin);
///     kinematics_with_tangential(feature, &ball, &pose, &velocity, &floor, &Pose::IDENTITY, &Velocity::ZERO)
///         .map(|(_, terms)| terms.slip_velocity)
/// };
/// assert_eq!(slip(DVec3::ZERO), Some(DVec3::X));
/// assert_eq!(slip(DVec3::Y * 2.0), Some(DVec3::ZERO));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn kinematics_with_tangential(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<(ContactKinematics, TangentialKinematics)> {
    let (a, b) = (velocity_a, velocity_b);
    let (kinematics, motion) = by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| {
            let kinematics = crossed.kinematics(a, b);
            Some((kinematics, crossed.motion(&kinematics, a, b)))
        },
        |stationary| {
            let kinematics = stationary.kinematics(pose_a.translation, a, b)?;
            Some((kinematics, stationary.motion(&kinematics, a, b)?))
        },
        |point| {
            let kinematics = point.kinematics(a, b);
            Some((kinematics, point.motion(&kinematics, a, b)))
        },
    )?;
    Some((kinematics, motion.tangential(a, b)))
}

/// Calls the closure for the kind of a contact's features, with the contact; a feature of compounds is evaluated on the
/// parts that own it.
#[inline]
fn by_kind<T>(
    feature: ContactFeature,
    (shape_a, pose_a): (&Shape, &Pose),
    (shape_b, pose_b): (&Shape, &Pose),
    of_edges: impl FnOnce(CrossedEdges) -> Option<T>,
    of_round: impl FnOnce(Stationary) -> Option<T>,
    of_point: impl FnOnce(PointOnSurface) -> Option<T>,
) -> Option<T> {
    let Local { feature, shapes: [shape_a, shape_b], .. } = localized(feature, shape_a, shape_b)?;
    if let ContactFeature::EdgeEdge { edge_a, edge_b } = feature {
        let (a, b) = (shape_a.edge_line(edge_a)?, shape_b.edge_line(edge_b)?);
        return of_edges(CrossedEdges::between(&a, pose_a, &b, pose_b)?);
    }
    if has_elements(shape_a) || has_elements(shape_b) {
        return of_round(of_elements(feature, shape_a, pose_a, shape_b, pose_b)?);
    }
    of_point(PointOnSurface::new(feature, shape_a, pose_a, shape_b, pose_b)?)
}

/// Whether the contacts of a shape are evaluated as common normals of elements (`stationary.rs`).
fn has_elements(shape: &Shape) -> bool {
    is_round(shape) || shape.is_ring()
}

/// The elements of a contact of a round shape, in world axes relative to A's centre of mass.
fn of_elements(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> Option<Stationary> {
    let (part_a, part_b) = surface_parts(feature, shape_a, shape_b)?;
    let origin_b = pose_b.translation - pose_a.translation;
    let a = Element::of(shape_a, part_a, &Pose::new(pose_a.rotation, DVec3::ZERO))?;
    let b = Element::of(shape_b, part_b, &Pose::new(pose_b.rotation, origin_b))?;
    let sizes = shape_a.size().max(shape_b.size());
    Stationary::new(&a, &b, origin_b, place_tolerance(joint_size(shape_a, shape_b), sizes, origin_b))
}
