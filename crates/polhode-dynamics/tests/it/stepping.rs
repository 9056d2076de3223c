//! What the tests of integrators share: the methods by name, and running them.

use glam::DVec3;
use polhode_dynamics::field::Field;
use polhode_dynamics::integrator::{
    Cf4, ExplicitEuler, ImplicitGyroscopic, ImplicitMidpoint, IntegrationError, Integrator, MoserVeselov,
    MoserVeselov4, Orientation, Rk4, Rkmk4, RotationRate, SemiImplicitEuler, Splitting, Splitting4,
};
use polhode_dynamics::{BodyState, FreeMotion, RigidBody};

/// A method by its name.
pub(crate) type Method = (&'static str, fn() -> Box<dyn Integrator>);

/// The methods of fixed step of these tests, RK4 in its default coordinates.
pub(crate) const METHODS: [Method; 13] = [
    ("explicit-euler", || Box::new(ExplicitEuler::new())),
    ("semi-implicit-euler", || Box::new(SemiImplicitEuler::new())),
    ("implicit-gyroscopic", || Box::new(ImplicitGyroscopic::new())),
    ("rk4", || Box::new(Rk4::default())),
    ("rkmk4", || Box::new(Rkmk4::new())),
    ("cf4", || Box::new(Cf4::new())),
    ("splitting", || Box::new(Splitting::new())),
    ("splitting-4 (Yoshida)", || Box::new(Splitting::of_order_4(Splitting4::Yoshida))),
    ("splitting-4", || Box::new(Splitting::of_order_4(Splitting4::Suzuki))),
    ("splitting-6", || Box::new(Splitting::of_order_6())),
    ("implicit-midpoint", || Box::new(ImplicitMidpoint::new())),
    ("moser-veselov", || Box::new(MoserVeselov::new())),
    ("moser-veselov-4", || Box::new(MoserVeselov4::new())),
];

/// The coordinates that RK4 offers.
pub(crate) const ORIENTATIONS: [Orientation; 6] = [
    Orientation::Quaternion,
    Orientation::QuaternionUnnormalized,
    Orientation::QuaternionThreeNumbers,
    Orientation::Matrix,
    Orientation::MatrixUnorthogonalized,
    Orientation::EulerAngles,
];

/// Both variables of the rate of rotation.
pub(crate) const RATES: [RotationRate; 2] = [RotationRate::AngularMomentum, RotationRate::AngularVelocity];

/// The method of this name.
pub(crate) fn method(name: &str) -> Box<dyn Integrator> {
    METHODS.iter().find(|(n, _)| *n == name).unwrap().1()
}

/// A scene: bodies, gravity, fields, states at t = 0.
#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) bodies: Vec<RigidBody>,
    pub(crate) gravity: DVec3,
    pub(crate) fields: Vec<Box<dyn Field>>,
    pub(crate) states: Vec<BodyState>,
}

impl Scene {
    /// One body on which nothing acts.
    pub(crate) fn free(body: &RigidBody, state: BodyState) -> Self {
        Self { bodies: vec![*body], gravity: DVec3::ZERO, fields: Vec::new(), states: vec![state] }
    }

    pub(crate) fn motion(&self) -> FreeMotion<'_> {
        FreeMotion::new(&self.bodies, self.gravity, &self.fields)
    }

    /// The states after `steps` steps to `end` (s), and each state on the way handed to `look`.
    pub(crate) fn run_looking(
        &self,
        integrator: &mut dyn Integrator,
        end: f64,
        steps: usize,
        mut look: impl FnMut(&[BodyState]),
    ) -> Result<Vec<BodyState>, IntegrationError> {
        let motion = self.motion();
        integrator.start(&motion, 0.0, &self.states);
        for _ in 0..steps {
            integrator.step(&motion, end / steps as f64)?;
            look(integrator.states());
        }
        Ok(integrator.states().to_vec())
    }

    /// The states after `steps` steps to `end` (s).
    pub(crate) fn run(&self, integrator: &mut dyn Integrator, end: f64, steps: usize) -> Vec<BodyState> {
        self.run_looking(integrator, end, steps, |_| ()).unwrap()
    }
}

/// Largest difference of two rows of states: angle (rad), position over 1 m, velocity over 1 m/s, angular momentum over
/// its length.
pub(crate) fn difference(states: &[BodyState], reference: &[BodyState]) -> f64 {
    let one = |(a, b): (&BodyState, &BodyState)| {
        let angle = a.pose.rotation.angle_to(b.pose.rotation);
        let momentum = (a.angular_momentum - b.angular_momentum).length();
        let momentum = if momentum == 0.0 { 0.0 } else { momentum / b.angular_momentum.length() };
        let position = (a.pose.translation - b.pose.translation).length();
        let velocity = (a.linear_velocity - b.linear_velocity).length();
        angle.max(momentum).max(position).max(velocity)
    };
    assert_eq!(states.len(), reference.len());
    states.iter().zip(reference).map(one).fold(0.0, f64::max)
}
