//! What the tests of forces, pivots and integrators share: bodies, runs that must end, and ledgers that must close.

use crate::support::brick;
use polhode::Flow;
use polhode::dynamics::integrator::Method as Integrator;
use polhode::mesh::Amount;
use polhode::scene::Method;
use polhode::spatial::{DVec3, Density, Inertia, Mass, MassProperties, Pose, Velocity};
use polhode::{Body, BodySample, Event, Observer, Recorder, RunReport, Scene, Simulation, SimulationError};

/// The largest closure error of a ledger, relative to its scale: compensated sums leave some roundings.
pub(crate) const CLOSURE: f64 = 1e-12;

/// A body without a shape, with three different moments about its centre of mass.
pub(crate) fn particle(name: &str, mass: f64, position: DVec3, velocity: DVec3) -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(0.2, 0.3, 0.4) * mass).unwrap();
    Body::movable(name, MassProperties::new(Mass::new(mass).unwrap(), DVec3::ZERO, inertia))
        .pose(Pose::from_translation(position))
        .velocity(Velocity::new(velocity, DVec3::ZERO))
}

/// A box of uniform density and of this mass.
pub(crate) fn heavy_brick(name: &str, mass: f64, size: DVec3, center: DVec3) -> Body {
    solid_brick(name, Mass::new(mass).unwrap(), size, center)
}

/// A box of this density.
pub(crate) fn dense_brick(name: &str, density: f64, size: DVec3, center: DVec3) -> Body {
    solid_brick(name, Density::new(density).unwrap(), size, center)
}

fn solid_brick(name: &str, amount: impl Into<Amount>, size: DVec3, center: DVec3) -> Body {
    let shape = brick(name, size, center).shape().unwrap().clone();
    let properties = polhode::mesh::primitives::solid_box(size, amount).unwrap();
    Body::movable(name, properties).geometry(shape).pose(Pose::from_translation(center))
}

/// A method with this integrator and this step.
pub(crate) fn by(integrator: Integrator, step_s: f64) -> Method {
    Method { integrator: Some(integrator), step_s: Some(step_s), ..Method::default() }
}

/// The error of the integrator in the energy, relative to the largest energy of the run.
pub(crate) fn numerical_relative(report: &RunReport) -> f64 {
    report.ledger.numerical.value().abs() / report.ledger.scale_j
}

/// Both ledgers close.
pub(crate) fn assert_closes(report: &RunReport) {
    let (energy, momentum) = (report.ledger.closure_relative(), report.ledger.momentum.closure_relative());
    assert!(energy < CLOSURE && momentum < CLOSURE, "energy {energy:e}, momentum {momentum:e}");
}

/// The largest distance of a recorded body from the position that `expected` gives for its time, m.
pub(crate) fn max_position_error(recorder: &Recorder, body: usize, expected: impl Fn(f64) -> DVec3) -> f64 {
    let rows = recorder.times_s.iter().zip(&recorder.samples);
    rows.map(|(&t, row)| (row[body].pose.translation - expected(t)).length()).fold(0.0, f64::max)
}

/// The largest difference of the velocity of its centre of mass from what `expected` gives for its time, m/s.
pub(crate) fn max_velocity_error(recorder: &Recorder, body: usize, expected: impl Fn(f64) -> DVec3) -> f64 {
    let rows = recorder.times_s.iter().zip(&recorder.samples);
    rows.map(|(&t, row)| (row[body].velocity.linear - expected(t)).length()).fold(0.0, f64::max)
}

/// The complete elliptic integral of the first kind of modulus `k`, by the arithmetic-geometric mean.
pub(crate) fn complete_elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, (1.0 - k * k).sqrt());
    while (a - b).abs() > 1e-15 * a {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    std::f64::consts::PI / (a + b)
}

/// The zero, found by bisection, of a function that is positive at `low` and not at `high`.
pub(crate) fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Keeps everything, and stops a run that takes more steps than it should.
pub(crate) struct Budget {
    pub(crate) recorder: Recorder,
    steps_left: u32,
}

impl Observer for Budget {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        self.recorder.sample(t, bodies);
    }

    fn event(&mut self, event: &Event) {
        self.recorder.event(event);
    }

    fn progress(&mut self, _t: f64) -> Flow {
        self.steps_left = self.steps_left.saturating_sub(1);
        if self.steps_left == 0 { Flow::Stop } else { Flow::Continue }
    }
}

/// Runs a scene for at most so many steps. Returns the error of a scene that is refused or of a run that fails.
pub(crate) fn try_run(scene: &Scene, steps: u32) -> Result<(RunReport, Recorder), SimulationError> {
    let mut budget = Budget { recorder: Recorder::default(), steps_left: steps };
    let report = Simulation::new(scene)?.run_observed(&mut budget)?;
    Ok((report, budget.recorder))
}
