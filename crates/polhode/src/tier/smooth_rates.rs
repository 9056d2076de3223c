//! Rates of flat states of bodies without contact forces, and of the ledgers by weights and fields: what systems of
//! equations of different tiers have in common.
//!
//! `p' = v`, `q' = w q/2`, `v' = g + F/m`, `L' = M`, with the load `F` (N), `M` (N m) of fields.

use crate::accounting::books::{given_by_fields, gravity_at};
use crate::model::{Loads, Model};
use polhode_dynamics::state::{ANGULAR_MOMENTUM, LINEAR_VELOCITY, POSITION, QUATERNION, WIDTH, quaternion_rate};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{DQuat, DVec3};

/// Places in the ledgers of a flat state: impulse and moment of weights, those of fields, energy to dampers, external
/// work.
const WEIGHTS: usize = 6;
const FIELDS: usize = 12;
const TO_DAMPERS: usize = 18;
const FROM_OUTSIDE: usize = 19;

/// Rates of `bodies`, in the states that they have and in `flat`, under these loads.
pub(crate) fn free_rates(
    model: &Model,
    (bodies, states): (&[usize], &[BodyState]),
    loads: &Loads,
    flat: &[f64],
    rates: &mut [f64],
) {
    let numbers = flat.as_chunks::<WIDTH>().0;
    for ((&body, number), rate) in bodies.iter().zip(numbers).zip(rates.as_chunks_mut::<WIDTH>().0) {
        let velocity = model.velocity(body, &states[body]);
        let [w, x, y, z] = [0, 1, 2, 3].map(|k| number[QUATERNION + k]);
        rate[POSITION..QUATERNION].copy_from_slice(&velocity.linear.to_array());
        let turning = quaternion_rate(DQuat::from_xyzw(x, y, z, w), velocity.angular);
        rate[QUATERNION..LINEAR_VELOCITY].copy_from_slice(&turning);
        let load = loads.of(body);
        let inverse_mass = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass);
        let acceleration = model.free_acceleration(body) + load.force * inverse_mass;
        rate[LINEAR_VELOCITY..ANGULAR_MOMENTUM].copy_from_slice(&acceleration.to_array());
        rate[ANGULAR_MOMENTUM..].copy_from_slice(&load.torque.to_array());
    }
}

/// Adds what weights and fields give to `bodies` to the rates of the ledgers, with moments about a point.
pub(crate) fn add_outside_rates(
    model: &Model,
    t: f64,
    (bodies, states): (&[usize], &[BodyState]),
    about: DVec3,
    ledgers: &mut [f64],
) {
    for &body in bodies {
        let gravity = gravity_at(model, states, body, about, 1.0);
        add(&mut ledgers[WEIGHTS..], gravity.linear);
        add(&mut ledgers[WEIGHTS + 3..], gravity.angular);
    }
    if model.forces.has_fields() {
        let given = given_by_fields(model, t, states, bodies, about);
        add(&mut ledgers[FIELDS..], given.fields.linear);
        add(&mut ledgers[FIELDS + 3..], given.fields.angular);
        ledgers[TO_DAMPERS] += given.damping_j;
        ledgers[FROM_OUTSIDE] += given.external_j;
    }
}

/// Adds a vector to the first three numbers of a slice.
pub(crate) fn add(numbers: &mut [f64], vector: DVec3) {
    for (number, component) in numbers.iter_mut().zip(vector.to_array()) {
        *number += component;
    }
}
