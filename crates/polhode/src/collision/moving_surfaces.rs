//! Surfaces that move while their shapes do not: belts, tracks of a vehicle, rollers.
//!
//! The surface of a body moves at `s` (m/s) in the frame of the body, the same everywhere; the part of it in the
//! tangent plane of a contact counts. With `w = R_A s_A - R_B s_B` and `P = 1 - n n^T` the slip of the contact gains
//! `P w`, and its rate
//!
//! `(P w)' = P (omega_A x R_A s_A - omega_B x R_B s_B) - n (n'.w) - n' (n.w)`.
//!
//! A force `f` of friction on A gives both bodies the power `f.(v_A - v_B) = f.u - f.w` (`v` velocities of the bodies
//! at the contact, `u` the slip): the drives of the surfaces give `-f.w`. Assumes that a surface moves steadily, and
//! that no momentum of what moves matters.

use crate::identity::contact_id::ContactId;
use crate::model::Model;
use polhode_contact::{ContactGeometry, TangentialKinematics};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Whether the surface of a body moves.
pub(crate) fn has_moving_surface(model: &Model, body: usize) -> bool {
    model.scene.bodies().get(body).is_some_and(|body| body.velocity_of_surface() != DVec3::ZERO)
}

/// `R s`, m/s.
pub(crate) fn surface_velocity(model: &Model, states: &[BodyState], body: usize) -> DVec3 {
    states[body].pose.rotation.rotate(model.scene.bodies()[body].velocity_of_surface())
}

/// `w`, m/s.
fn relative_surface_velocity(model: &Model, states: &[BodyState], id: ContactId) -> DVec3 {
    surface_velocity(model, states, id.a) - surface_velocity(model, states, id.b)
}

/// Adds what the surfaces of the bodies of a contact do to its slip.
pub(super) fn add_surface_slip(model: &Model, states: &[BodyState], id: ContactId, terms: &mut TangentialKinematics) {
    let turned = |body: usize| {
        let own = surface_velocity(model, states, body);
        if own == DVec3::ZERO { own } else { model.velocity(body, &states[body]).angular.cross(own) }
    };
    let w = relative_surface_velocity(model, states, id);
    let rate = turned(id.a) - turned(id.b);
    let [x, y] = terms.basis;
    let in_plane = |vector: DVec3| x * x.dot(vector) + y * y.dot(vector);
    let (n, n_rate) = (x.cross(y), terms.normal_rate);
    terms.slip_velocity += in_plane(w);
    terms.acceleration_bias += in_plane(rate) - n * n_rate.dot(w) - n_rate * n.dot(w);
}

/// Work (J) of the drives of surfaces by impulses (N s) on A along tangents, which stand in the place of normals;
/// from forces (N), their power, W.
pub(crate) fn surface_work<'a>(
    model: &Model,
    states: &[BodyState],
    tangential: impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)>,
) -> f64 {
    if !model.surfaces.are_driven() {
        return 0.0;
    }
    let work = |(id, along, p): (ContactId, &ContactGeometry, f64)| {
        -p * along.normal.dot(relative_surface_velocity(model, states, id))
    };
    tangential.map(work).sum()
}
