//! Impulse and work of gravity and force fields over a step of an integrator that does not compute them itself.
//!
//! Impulse and work are integrals over the step, computed by Simpson's rule from the states at both ends and in the
//! middle. The middle state is that of the cubic Hermite polynomial through states and rates at the ends,
//! `x(h/2) = (x0 + x1)/2 + h/8 (x0' - x1')`, with attitudes as rotation vectors from the start; the integrator needs no
//! further evaluation. The error of an integral is of order h^5 in the step, and zero for bodies under gravity alone.
//! Source: docs/REFERENCES.md, Hairer, Norsett and Wanner, II.6.

use crate::accounting::books::{Received, given_by_fields};
use crate::model::Model;
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::rows::assembly::free_acceleration;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, Pose, Rotation};

/// The ends of a step: times (s) and states of all bodies.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ends<'a> {
    pub(crate) t: [f64; 2],
    pub(crate) states: [&'a [BodyState]; 2],
}

/// Impulse and work of gravity and the fields on `bodies` over the step, moments about `about`.
pub(crate) fn received(model: &Model, ends: Ends<'_>, bodies: &[usize], about: DVec3) -> Received {
    let mut received = Received { gravity: gravity(model, ends, bodies, about), ..Received::default() };
    if !model.forces.has_fields() {
        return received;
    }
    let [t0, t1] = ends.t;
    let h = t1 - t0;
    let middle = middle_states(model, ends, bodies);
    let mut fields = MomentumSum::default();
    let samples = [(t0, ends.states[0], 1.0), (0.5 * (t0 + t1), &middle, 4.0), (t1, ends.states[1], 1.0)];
    for (t, states, weight) in samples {
        let given = given_by_fields(model, t, states, bodies, about);
        let share = weight * h / 6.0;
        fields.add(Momentum { linear: given.fields.linear * share, angular: given.fields.angular * share });
        received.damping_j += given.damping_j * share;
        received.external_j += given.external_j * share;
    }
    received.fields = fields.value();
    received
}

/// Impulse of the weights, and its moment by the integral of the cubic path.
fn gravity(model: &Model, ends: Ends<'_>, bodies: &[usize], about: DVec3) -> Momentum {
    let h = ends.t[1] - ends.t[0];
    let mut sum = MomentumSum::default();
    for &body in bodies.iter().filter(|&&body| model.carries_momentum(body)) {
        let Some(rigid) = &model.bodies[body].rigid else { continue };
        let [start, end] = ends.states.map(|states| &states[body]);
        let mean = (start.pose.translation + end.pose.translation) * 0.5
            + (start.linear_velocity - end.linear_velocity) * (h / 12.0);
        let linear = model.gravity() * (rigid.mass() * h);
        sum.add(Momentum { linear, angular: (mean - about).cross(linear) });
    }
    sum.value()
}

/// States in the middle of the step.
fn middle_states(model: &Model, ends: Ends<'_>, bodies: &[usize]) -> Vec<BodyState> {
    let h = ends.t[1] - ends.t[0];
    let loads = [0, 1].map(|end| model.loads(ends.t[end], ends.states[end]));
    let mut middle = ends.states[0].to_vec();
    for &body in bodies {
        let Some(rigid) = &model.bodies[body].rigid else { continue };
        let [start, end] = ends.states.map(|states| &states[body]);
        let linear = [0, 1].map(|k| free_acceleration(model, ends.states[k], &loads[k], body).0);
        let torque = [0, 1].map(|k| loads[k].of(body).torque);
        let half = |x: [DVec3; 2], rate: [DVec3; 2]| (x[0] + x[1]) * 0.5 + (rate[0] - rate[1]) * (h / 8.0);
        let turn = (end.pose.rotation * start.pose.rotation.inverse()).to_rotation_vector();
        let w = rigid.angular_velocity(end);
        // Rate of the rotation vector: the inverse of the differential of the exponential, to third order.
        let turn_rate = w - turn.cross(w) * 0.5 + turn.cross(turn.cross(w)) / 12.0;
        let half_turn = half([DVec3::ZERO, turn], [rigid.angular_velocity(start), turn_rate]);
        middle[body] = BodyState {
            pose: Pose::new(
                Rotation::from_rotation_vector(half_turn) * start.pose.rotation,
                half([start.pose.translation, end.pose.translation], [start.linear_velocity, end.linear_velocity]),
            ),
            linear_velocity: half([start.linear_velocity, end.linear_velocity], linear),
            angular_momentum: half([start.angular_momentum, end.angular_momentum], torque),
        };
    }
    middle
}
