//! The friction of two bodies at a contact: of slip, along and across a grain, and of rolling and spinning.

use super::friction_mode::{FrictionCoefficients, RotationalFriction};
use crate::identity::contact_id::{ContactId, Feature};
use crate::model::Model;
use crate::scene::{FrictionEllipse, GrainOf};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// The sine of the angle between a grain and the normal of a contact below which it stands on end (no unit, 1e-12 to
/// 1e-6): the direction of its projection would be rounding.
const GRAIN_ON_END: f64 = 1e-9;

/// The coefficients of friction of a contact; none without friction.
pub(crate) fn friction_of(model: &Model, id: ContactId) -> Option<FrictionCoefficients> {
    match id.feature {
        Feature::Shapes(_) => friction_of_surfaces(model, (id.a, id.b)),
        Feature::Stop(_) => None,
        Feature::JointFriction(of) => model.joints.friction_of_joint(of),
    }
}

fn friction_of_surfaces(model: &Model, (a, b): (usize, usize)) -> Option<FrictionCoefficients> {
    if !model.has_friction() {
        return None;
    }
    let material = model.scene.pair_material(a, b);
    let coefficients =
        FrictionCoefficients { at_rest: material.static_ellipse(), sliding: material.friction_ellipse() };
    let resists_rotation = model.surfaces.have_rotational_friction() && rotational_friction_of(model, a, b).is_some();
    (coefficients.at_rest.largest() > 0.0 || resists_rotation).then_some(coefficients)
}

/// The coefficients of friction of a contact whose tangents are these; none without friction. Where the grain
/// stands on end, every direction is across it.
pub(crate) fn friction_at(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    basis: [DVec3; 2],
) -> Option<FrictionCoefficients> {
    let coefficients = friction_of(model, id)?;
    if !model.surfaces.have_grain() || grain_in_plane(model, states, id, basis).is_some() {
        return Some(coefficients);
    }
    let across = |ellipse: FrictionEllipse| FrictionEllipse::circle(ellipse.across);
    Some(FrictionCoefficients { at_rest: across(coefficients.at_rest), sliding: across(coefficients.sliding) })
}

/// The direction of the grain of a contact in its tangent plane (unit vector, world); none without a grain, and
/// where it stands on end.
pub(super) fn grain_in_plane(model: &Model, states: &[BodyState], id: ContactId, basis: [DVec3; 2]) -> Option<DVec3> {
    let grain = model.scene.pair_material(id.a, id.b).grain()?;
    let body = if grain.of == GrainOf::Second { id.b } else { id.a };
    let direction = states[body].pose.rotation.rotate(grain.direction);
    let [x, y] = basis.map(|tangent| tangent * tangent.dot(direction));
    let in_plane = x + y;
    let length = in_plane.length();
    (length > GRAIN_ON_END).then(|| in_plane / length)
}

/// The friction of rolling and spinning of two bodies; none without either.
pub(crate) fn rotational_friction_of(model: &Model, a: usize, b: usize) -> Option<RotationalFriction> {
    if !model.surfaces.have_rotational_friction() || !model.joints.joint_contacts_of_pair((a, b)).is_empty() {
        return None;
    }
    let material = model.scene.pair_material(a, b);
    let lengths = RotationalFriction { rolling: material.rolling_friction(), spinning: material.spinning_friction() };
    (lengths.rolling > 0.0 || lengths.spinning > 0.0).then_some(lengths)
}
