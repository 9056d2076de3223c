//! The rates at which force fields and rotations change the motion of bodies: what decides which fixed step is short
//! enough.

use super::bodies::Model;
use crate::joints::soft_rows;
use polhode_dynamics::field::{ForceResponse, ResponseEnd};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::DMat3;

/// The fastest rates of some bodies, bounded from above, 1/s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Rates {
    /// Of oscillations under springs, and of rotation.
    pub(crate) oscillation: f64,
    /// Of decay under drag and dampers.
    pub(crate) decay: f64,
}

impl Rates {
    /// Whether nothing oscillates or decays.
    pub(crate) fn is_zero(&self) -> bool {
        self.oscillation == 0.0 && self.decay == 0.0
    }
}

/// The fastest rates in these states; fields that do not say how they respond are left out.
pub(crate) fn fastest_rates(model: &Model, states: &[BodyState]) -> Rates {
    let mut sums = vec![Rates::default(); model.bodies.len()];
    for (_, response) in &model
        .responses_on(states, &model.movable, &soft_rows::kicks_of_joints(model, states, &model.movable))
        .of_fields
    {
        for end in response.ends.iter().flatten() {
            let lightness = lightness(model, end);
            sums[end.body].oscillation += lightness * largest_eigenvalue(&response.stiffness);
            sums[end.body].decay += lightness * largest_eigenvalue(&response.damping);
        }
        sums = with_rotation(model, sums, response);
    }
    let mut rates = Rates::default();
    for &body in &model.movable {
        let turning = model.velocity(body, &states[body]).angular.length();
        rates.oscillation = rates.oscillation.max(sums[body].oscillation.sqrt()).max(turning);
        rates.decay = rates.decay.max(sums[body].decay);
    }
    rates
}

fn with_rotation(model: &Model, mut sums: Vec<Rates>, response: &ForceResponse) -> Vec<Rates> {
    let turned = response.ends[0].and_then(|end| Some((end.body, model.bodies[end.body].rigid.as_ref()?)));
    if let Some((body, rigid)) = turned {
        sums[body].decay += largest_eigenvalue(&response.rotational_damping) / rigid.moments().min_element();
    }
    sums
}

/// The largest inverse mass that a force meets at a point of a body, 1/kg.
pub(crate) fn lightness(model: &Model, end: &ResponseEnd) -> f64 {
    let Some(rigid) = &model.bodies[end.body].rigid else { return 0.0 };
    rigid.inverse_mass() + end.arm.length_squared() / rigid.moments().min_element()
}

/// The energy that would lift every body by its size, J: the scale for scenes with hardly any energy.
pub(crate) fn lifting_energy_j(model: &Model) -> f64 {
    let lift_j = |body: &super::ModelBody| {
        let mass = body.rigid.as_ref().map_or(0.0, RigidBody::mass);
        mass * model.gravity().length() * body.size
    };
    model.bodies.iter().map(lift_j).sum()
}

/// The energy that the fields at `t` (s) would give the bodies, each along its size and over one radian, J: the
/// scale for bodies that forces press against others, and that hold still.
pub(crate) fn pressing_energy_j(model: &Model, t: f64, states: &[BodyState]) -> f64 {
    if model.forces.fields.is_empty() {
        return 0.0;
    }
    let loads = model.loads_on(t, states, &model.movable);
    let of_body = |&body: &usize| {
        let load = loads.of(body);
        load.force.length() * model.bodies[body].size + load.torque.length()
    };
    model.movable.iter().map(of_body).sum()
}

/// The largest eigenvalue of a symmetric matrix without negative ones, bounded by its trace; that of a multiple of the
/// unit matrix exactly.
pub(crate) fn largest_eigenvalue(matrix: &DMat3) -> f64 {
    if *matrix == DMat3::IDENTITY * matrix.x_axis.x {
        return matrix.x_axis.x;
    }
    matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z
}
