//! The rates at which force fields and rotations change the motion of bodies: what decides which fixed step is short
//! enough.

use super::bodies::Model;
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

impl Model {
    /// The fastest rates in these states; fields that do not say how they respond are left out.
    pub(crate) fn fastest_rates(&self, states: &[BodyState]) -> Rates {
        let mut sums = vec![Rates::default(); self.bodies.len()];
        for (_, response) in
            &self.responses_on(states, &self.movable, &self.kicks_of_joints(states, &self.movable)).of_fields
        {
            for end in response.ends.iter().flatten() {
                let lightness = self.lightness(end);
                sums[end.body].oscillation += lightness * largest_eigenvalue(&response.stiffness);
                sums[end.body].decay += lightness * largest_eigenvalue(&response.damping);
            }
            sums = self.with_rotation(sums, response);
        }
        let mut rates = Rates::default();
        for &body in &self.movable {
            let turning = self.velocity(body, &states[body]).angular.length();
            rates.oscillation = rates.oscillation.max(sums[body].oscillation.sqrt()).max(turning);
            rates.decay = rates.decay.max(sums[body].decay);
        }
        rates
    }

    fn with_rotation(&self, mut sums: Vec<Rates>, response: &ForceResponse) -> Vec<Rates> {
        let turned = response.ends[0].and_then(|end| Some((end.body, self.bodies[end.body].rigid.as_ref()?)));
        if let Some((body, rigid)) = turned {
            sums[body].decay += largest_eigenvalue(&response.rotational_damping) / rigid.moments().min_element();
        }
        sums
    }

    /// The largest inverse mass that a force meets at a point of a body, 1/kg.
    pub(crate) fn lightness(&self, end: &ResponseEnd) -> f64 {
        let Some(rigid) = &self.bodies[end.body].rigid else { return 0.0 };
        rigid.inverse_mass() + end.arm.length_squared() / rigid.moments().min_element()
    }

    /// The energy that would lift every body by its size, J: the scale for scenes with hardly any energy.
    pub(crate) fn lifting_energy_j(&self) -> f64 {
        let lift_j = |body: &super::ModelBody| {
            let mass = body.rigid.as_ref().map_or(0.0, RigidBody::mass);
            mass * self.gravity().length() * body.size
        };
        self.bodies.iter().map(lift_j).sum()
    }
}

impl Model {
    /// The energy that the fields at `t` (s) would give the bodies, each along its size and over one radian, J: the
    /// scale for bodies that forces press against others, and that hold still.
    pub(crate) fn pressing_energy_j(&self, t: f64, states: &[BodyState]) -> f64 {
        if self.forces.fields.is_empty() {
            return 0.0;
        }
        let loads = self.loads_on(t, states, &self.movable);
        let of_body = |&body: &usize| {
            let load = loads.of(body);
            load.force.length() * self.bodies[body].size + load.torque.length()
        };
        self.movable.iter().map(of_body).sum()
    }
}

/// The largest eigenvalue of a symmetric matrix without negative ones, bounded by its trace; that of a multiple of the
/// unit matrix exactly.
pub(crate) fn largest_eigenvalue(matrix: &DMat3) -> f64 {
    if *matrix == DMat3::IDENTITY * matrix.x_axis.x {
        return matrix.x_axis.x;
    }
    matrix.x_axis.x + matrix.y_axis.y + matrix.z_axis.z
}
