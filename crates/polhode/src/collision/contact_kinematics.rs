//! Geometry and rates of a contact in any states: separation, slip, relative rotation.

use crate::collision::{friction, moving_surfaces};
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::{joint_contacts, joint_friction};
use crate::model::{Model, TOUCH_RELATIVE, tolerances};
use polhode_contact::{ContactKinematics, Shape, TangentialKinematics};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Fraction of the touch distance within which two vertices count as meeting, so that a contact of either with a face
/// of the other body is found. A contact is dropped only when it has left its face by the whole touch distance, so that
/// the two rules do not alternate.
pub(super) const COUNTERPART_FRACTION: f64 = 0.25;

/// The shapes of two bodies; none when one has no shape.
pub(crate) fn shapes(model: &Model, a: usize, b: usize) -> Option<(&Shape, &Shape)> {
    Some((model.bodies[a].shape.as_ref()?, model.bodies[b].shape.as_ref()?))
}

/// Geometry of a contact, rate of its separation and bias of its acceleration in these states; none when its
/// features no longer define a contact (edges have become parallel).
pub(crate) fn kinematics(model: &Model, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    kinematics_in_space(model, states, id).map(|kinematics| in_plane(model, id, kinematics))
}

/// A contact as it acts in planar motion: it represents its mirror image too, and the resultant of both acts in the
/// plane.
pub(crate) fn in_plane(model: &Model, id: ContactId, mut kinematics: ContactKinematics) -> ContactKinematics {
    if let Some(plane) = model.planar.of_pair(id.a, id.b) {
        let geometry = &mut kinematics.geometry;
        geometry.point = plane.project_point(geometry.point);
        geometry.normal = plane.project_vector(geometry.normal);
    }
    kinematics
}

pub(crate) fn kinematics_in_space(model: &Model, states: &[BodyState], id: ContactId) -> Option<ContactKinematics> {
    let feature = match id.feature {
        Feature::Shapes(feature) => feature,
        Feature::Stop(_) | Feature::JointFriction(_) => {
            return joint_contacts::joint_contact_kinematics(model, states, id);
        }
    };
    let (shape_a, shape_b) = shapes(model, id.a, id.b)?;
    let (state_a, state_b) = (&states[id.a], &states[id.b]);
    polhode_contact::kinematics(
        feature,
        shape_a,
        &state_a.pose,
        &model.velocity(id.a, state_a),
        shape_b,
        &state_b.pose,
        &model.velocity(id.b, state_b),
    )
}

/// The angular velocity of A relative to B, rad/s.
pub(crate) fn relative_rotation(model: &Model, states: &[BodyState], id: ContactId) -> DVec3 {
    model.velocity(id.a, &states[id.a]).angular - model.velocity(id.b, &states[id.b]).angular
}

/// Slip of a contact and the terms of its derivative, in motion in space; none as for [`Self::kinematics`]. Of
/// contacts with a grain the first tangent is along it; in planar motion it lies in the plane.
pub(crate) fn tangential_kinematics(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
) -> Option<TangentialKinematics> {
    let feature = match id.feature {
        Feature::Shapes(feature) => feature,
        Feature::Stop(_) => return None,
        Feature::JointFriction(of) => return joint_friction::friction_slip(model, states, of),
    };
    let (shape_a, shape_b) = shapes(model, id.a, id.b)?;
    let (state_a, state_b) = (&states[id.a], &states[id.b]);
    let (velocity_a, velocity_b) = (model.velocity(id.a, state_a), model.velocity(id.b, state_b));
    let (a, b) = ((shape_a, &state_a.pose, &velocity_a), (shape_b, &state_b.pose, &velocity_b));
    let found = polhode_contact::kinematics_with_tangential(feature, a.0, a.1, a.2, b.0, b.1, b.2);
    let mut terms = found.map(|(_, terms)| terms)?;
    if model.surfaces.are_driven() {
        moving_surfaces::add_surface_slip(model, states, id, &mut terms);
    }
    if model.surfaces.have_grain()
        && let Some(along) = friction::grain_in_plane(model, states, id, terms.basis)
    {
        let [x, y] = terms.basis;
        terms.basis = [along, x.cross(y).cross(along)];
    }
    if let Some(plane) = model.planar.of_pair(id.a, id.b) {
        let [x, y] = terms.basis;
        terms.basis = plane.tangents(x.cross(y));
        // Rounding may leave a slip out of the plane, which would turn the direction of one that ends.
        terms.slip_velocity = terms.basis[0] * terms.basis[0].dot(terms.slip_velocity);
    }
    Some(terms)
}

/// In planar motion: the vector from the plane to a contact point that represents its mirror image too, m. None for
/// a point that is its own image, and in motion in space.
pub(crate) fn mirrored(model: &Model, states: &[BodyState], id: ContactId) -> Option<DVec3> {
    let plane = model.planar.of_pair(id.a, id.b)?;
    let height = plane.height(kinematics_in_space(model, states, id)?.geometry.point);
    let distance = COUNTERPART_FRACTION * TOUCH_RELATIVE * tolerances::pair_size(model, id.a, id.b);
    (height.abs() > distance).then(|| plane.normal() * height)
}
