//! What a contact must be expected to bear, from which the stiffness of a linear spring follows.
//!
//! A spring that stops a body gives back its kinetic energy E and the work of the load W on the way: with the greatest
//! overlap d that is stated, `k d^2/2 = E + W d`. W and E are shared by the points of a pair that are within d of
//! touching. For a contact that begins
//!
//! - W is the weight of the movable bodies whose centres are then not below that of the upper of its bodies: they may
//!   rest on it;
//! - E is `m v^2/2` of the approach v that it begins with (m the reduced mass), and the hardest blow `m_c v_c^2/2` of a
//!   third body c, which the contact may pass on. `v_c^2 = v^2 + 2 g h` with the speed at the start and the drop h: how
//!   far the body falls straight down until it meets the one below it, which may fall itself. A kinematic body strikes
//!   with the mass of the pair.
//!
//! Drops are found by boxes aligned with gravity at the start. What has nothing below falls through the height of the
//! scene at most. Symbols: masses kg, speeds m/s, lengths m. Assumptions: blows come along gravity or at the speeds of
//! the start. How it fails: a resting contact that is struck by what first rolled, toppled or was thrown elsewhere, or
//! wedges that multiply a weight, overlaps by more than stated; the report gives both.

use crate::identity::contact_id::ContactId;
use crate::model::{Model, tolerances};
use polhode_contact::{Aabb, Shape, aabb_of};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DQuat, DVec3, Pose, Rotation};

/// Speed of a contact that no weight loads, relative to the greatest speed of the scene (0.01 to 1): one that begins
/// more slowly would be so soft that it lasts while its bodies move as far as they are long.
const SLOWEST_APPROACH: f64 = 0.1;

/// Squares of the speeds (m^2/s^2) with which the bodies may strike others, from their states at the start.
pub(super) fn blows(model: &Model, states: &[BodyState]) -> Vec<f64> {
    let gravity = model.gravity().length();
    let drops = drops(model, states);
    let square = |body: usize| {
        let speed = tolerances::point_speed(model, states, body);
        speed * speed + 2.0 * gravity * drops[body]
    };
    (0..states.len()).map(square).collect()
}

/// Weight (N) and kinetic energy (J) that the contacts of a pair which begins at a rate of approach (m/s) must take up.
pub(super) fn burden(
    model: &Model,
    states: &[BodyState],
    id: ContactId,
    (approach, fastest): (f64, f64),
    blows: &[f64],
) -> [f64; 2] {
    let pair_mass = reduced_mass(model, id);
    let load = load_on(model, states, id);
    let slowest = if load > 0.0 { 0.0 } else { SLOWEST_APPROACH * fastest };
    let speed = approach.max(slowest);
    let others = blows.iter().enumerate().filter(|(body, _)| *body != id.a && *body != id.b);
    let blow = others.map(|(body, square)| {
        let mass = model.bodies[body].rigid.as_ref().map_or(pair_mass, RigidBody::mass);
        0.5 * mass * square
    });
    [load, (0.5 * pair_mass * speed * speed).max(blow.fold(0.0, f64::max))]
}

/// Weight of the bodies that may rest on a contact, N.
pub(super) fn load_on(model: &Model, states: &[BodyState], id: ContactId) -> f64 {
    let gravity = model.gravity();
    let depth = |body: usize| states[body].pose.translation.dot(gravity);
    let moves = |body: &usize| model.bodies[*body].moves();
    let upper = [id.a, id.b].into_iter().filter(moves).map(depth).fold(f64::INFINITY, f64::min);
    let resting = model.movable.iter().copied().filter(|body| moves(body) && depth(*body) <= upper);
    let mass: f64 = resting.filter_map(|body| model.bodies[body].rigid.as_ref()).map(RigidBody::mass).sum();
    mass * gravity.length()
}

/// Reduced mass of two bodies, kg.
pub(super) fn reduced_mass(model: &Model, id: ContactId) -> f64 {
    let inverse: f64 = [id.a, id.b]
        .into_iter()
        .map(|body| model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass))
        .sum();
    if inverse > 0.0 { 1.0 / inverse } else { 1.0 }
}

/// How far bodies may fall before they meet what is below them, m; zero for those that forces do not move.
fn drops(model: &Model, states: &[BodyState]) -> Vec<f64> {
    let mut drops = vec![0.0; states.len()];
    let Some(down) = model.gravity().try_normalize() else { return drops };
    let upright = Rotation::renormalized(DQuat::from_rotation_arc(down, DVec3::NEG_Z));
    let boxes: Vec<Option<Aabb>> =
        (0..states.len()).map(|body| upright_box(model, &states[body], body, upright)).collect();
    let highest = boxes.iter().flatten().map(|own| own.max().z).fold(f64::NEG_INFINITY, f64::max);
    let lowest = boxes.iter().flatten().map(|own| own.min().z).fold(f64::INFINITY, f64::min);
    let planes: Vec<_> = (0..states.len()).filter_map(|body| plane(model, &states[body], body, upright)).collect();
    let mut falling: Vec<(usize, &Aabb)> = (0..states.len())
        .filter(|&body| model.bodies[body].moves())
        .filter_map(|body| Some((body, boxes[body].as_ref()?)))
        .collect();
    // From the lowest up, so that what is below a body has its drop already.
    falling.sort_by(|(_, x), (_, y)| x.min().z.total_cmp(&y.min().z));
    for &(body, own) in &falling {
        let onto = boxes.iter().enumerate().filter_map(|(below, other)| {
            let other = other.as_ref().filter(|other| below != body && is_below(own, other))?;
            Some((own.min().z - other.max().z).max(0.0) + drops[below])
        });
        let onto_planes = planes.iter().map(|(normal, offset)| {
            let center = 0.5 * (own.min() + own.max());
            let half = 0.5 * (own.max() - own.min());
            let gap = normal.dot(center) - offset - normal.abs().dot(half);
            (gap / normal.z).max(0.0)
        });
        drops[body] = onto.chain(onto_planes).fold(highest - lowest, f64::min);
    }
    drops
}

/// Whether a box is in the way of another one that falls along -z.
fn is_below(falling: &Aabb, other: &Aabb) -> bool {
    let overlaps = |axis: usize| falling.min()[axis] < other.max()[axis] && other.min()[axis] < falling.max()[axis];
    overlaps(0) && overlaps(1) && other.min().z < falling.min().z
}

/// The box of a body in axes whose -z is along gravity; none of what is unbounded, has no shape or was removed.
fn upright_box(model: &Model, state: &BodyState, body: usize, upright: Rotation) -> Option<Aabb> {
    let own = &model.bodies[body];
    let shape = own.shape.as_ref().filter(|_| !own.removed)?;
    let pose = Pose::new(upright * state.pose.rotation, upright.rotate(state.pose.translation));
    aabb_of(shape, &pose).ok().filter(Aabb::is_finite)
}

/// Normal and offset of a half-space on which bodies can fall, in axes whose -z is along gravity.
fn plane(model: &Model, state: &BodyState, body: usize, upright: Rotation) -> Option<(DVec3, f64)> {
    let Some(Shape::HalfSpace(plane)) = &model.bodies[body].shape else { return None };
    let normal = upright.rotate(state.pose.rotation.rotate(plane.normal()));
    let point = upright.rotate(state.pose.translation) + normal * plane.offset();
    (normal.z > 0.0).then(|| (normal, normal.dot(point)))
}
