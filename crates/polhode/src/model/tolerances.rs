//! The distances that decide whether two bodies touch or overlap: each relative to the size of the pair, with an
//! allowance for the rounding of their poses; and the rounding of the velocities of contacts.

use super::bodies::Model;
use polhode_dynamics::BodyState;
use polhode_spatial::Velocity;

/// Distance that counts as touch, relative to the size of the smaller body: contacts this close at an impact are
/// struck together (docs/NOTATION.md, "touch").
pub(crate) const TOUCH_RELATIVE: f64 = 1e-11;

/// Depth that bodies at rest have where a tier lets them in and the scene states none, relative to the smallest body
/// that moves (no unit, 1e-4 to 1e-2): it is not seen, and large beside the rounding of positions.
pub(crate) const STATED_DEPTH_RELATIVE: f64 = 1e-3;

/// What a sum or a division of equal steps may be off by, relative to a step (no unit, 1e-12 to 1e-6): rounding must
/// not leave a tiny step.
pub(crate) const SAME_TIME_RELATIVE: f64 = 1e-9;

/// Collisions one after the other stop when every speed of approach is below this fraction of the first ones (no unit;
/// thesis 3.3: "an artificial threshold for the approach velocity").
pub(crate) const PROPAGATION_THRESHOLD: f64 = 1e-6;

/// Most collisions one after the other in one step; beyond them what still approaches is stopped at once.
pub(crate) const MOST_COLLISIONS: usize = 20_000;

/// Overlap that is tolerated where bodies are placed, at the start and by actions of a program, relative to the size of
/// the smaller body. It is larger than the touch distance; at the start a projection removes it.
pub(crate) const INITIAL_OVERLAP_RELATIVE: f64 = 1e-9;

/// Displacement of a surface by the rounding of its pose, in units in the last place of the largest coordinate.
const ROUNDING_ULPS: f64 = 8.0;

/// Allowance for rounding in the penetration that a tier promises, in units in the last place of the largest
/// coordinate: a contact may be held at a depth that cannot be told from touch, another penetration is seen only beyond
/// the same depth, and two units for the depth that is measured.
const PENETRATION_ULPS: f64 = 2.0 * ROUNDING_ULPS + 2.0;

/// Error of the velocity of a contact by rounding, in rounding units of the largest speed of a point of its bodies.
const VELOCITY_UNITS: f64 = 4.0;

/// Size that the tolerances of a pair are relative to, m: that of the smaller body. A half-space has none and does
/// not count.
pub(crate) fn pair_size(model: &Model, a: usize, b: usize) -> f64 {
    let (size_a, size_b) = (model.bodies[a].size, model.bodies[b].size);
    if size_a == 0.0 {
        size_b
    } else if size_b == 0.0 {
        size_a
    } else {
        size_a.min(size_b)
    }
}

/// The length (m) that makes velocities of rotations of a pair on each other: the largest power of two that is not
/// above the pair's size.
pub(crate) fn turning_length(model: &Model, a: usize, b: usize) -> f64 {
    let (_, exponent) = libm::frexp(pair_size(model, a, b));
    libm::scalbn(1.0, exponent - 1)
}

/// Distance within which two bodies touch, m.
pub(crate) fn touch_distance(model: &Model, states: &[BodyState], a: usize, b: usize) -> f64 {
    TOUCH_RELATIVE * pair_size(model, a, b) + rounding(model, states, a, b)
}

/// Largest displacement of two surfaces by the rounding of their poses, m.
pub(crate) fn rounding(model: &Model, states: &[BodyState], a: usize, b: usize) -> f64 {
    ROUNDING_ULPS * ulp(model, states, a, b)
}

/// Allowance for rounding in the penetration of a pair that a tier promises, m.
pub(crate) fn penetration_rounding(model: &Model, states: &[BodyState], a: usize, b: usize) -> f64 {
    PENETRATION_ULPS * ulp(model, states, a, b)
}

/// Unit in the last place of the largest coordinate of two bodies, m.
fn ulp(model: &Model, states: &[BodyState], a: usize, b: usize) -> f64 {
    let coordinate = |i: usize| {
        let body = &model.bodies[i];
        // A half-space has no size. Its plane may be far from its origin, and only the other body's coordinates
        // count.
        if body.size == 0.0 { 0.0 } else { states[i].pose.translation.abs().max_element() + body.size }
    };
    f64::EPSILON * coordinate(a).max(coordinate(b))
}

/// Largest speed of any point of a body, m/s, bounded by its size.
pub(crate) fn point_speed(model: &Model, states: &[BodyState], body: usize) -> f64 {
    fastest_point(model, body, &model.velocity(body, &states[body]))
}

/// [`Self::point_speed`] of a body with a velocity.
pub(crate) fn fastest_point(model: &Model, body: usize, velocity: &Velocity) -> f64 {
    velocity.linear.length() + velocity.angular.length() * model.bodies[body].size
}

/// Error of the centripetal terms in accelerations of these bodies by rounding, m/s^2.
pub(crate) fn acceleration_rounding(model: &Model, states: &[BodyState], bodies: &[usize]) -> f64 {
    let term = |&body: &usize| {
        let velocity = model.velocity(body, &states[body]);
        velocity.angular.length() * fastest_point(model, body, &velocity)
    };
    VELOCITY_UNITS * f64::EPSILON * bodies.iter().map(term).fold(0.0, f64::max)
}

/// Error of the velocities of contacts of these bodies by rounding, m/s.
pub(crate) fn velocity_rounding(model: &Model, states: &[BodyState], bodies: &[usize]) -> f64 {
    let speed = bodies.iter().fold(0.0, |most, &body| point_speed(model, states, body).max(most));
    VELOCITY_UNITS * f64::EPSILON * speed
}
