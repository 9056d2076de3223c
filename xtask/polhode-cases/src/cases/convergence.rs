//! Orders of convergence and work against precision of every integrator, as users run them.
//!
//! The order is the slope of the error at a fixed time between halved steps, where truncation is far above rounding.
//! Methods that are exact in free motion show theirs on a heavy top. The work-precision table is that of an independent
//! prototype of each method: agreement within a factor of two says that the constant of the error is right, too.

use super::bodies::rotor;
use super::heavy_tops::top;
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::dynamics::integrator::Tolerance as StepTolerance;
use polhode::dynamics::{BodyState, Dop853, FreeMotion, FreeRotation, RigidBody};
use polhode::scene::{Integrator, Method};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation};
use polhode::{BodySample, Effects, Scene, SceneBuilder};
use std::error::Error;
use std::f64::consts::FRAC_PI_6;

/// How far a measured order may be from that of theory.
const ORDER: f64 = 0.1;
/// The rotation whose convergence is measured: principal moments, kg m^2, and angular velocity, rad/s.
const MOMENTS: DVec3 = DVec3::new(2.3, 3.1, 4.7);
const SPIN: DVec3 = DVec3::new(0.9, -1.1, 0.7);
/// Time at which errors are taken, s.
const DURATION_S: f64 = 20.0;
/// Error that DOP853 may leave: ten times its tolerance, the default of 1e-11, rad.
const CONTROLLED: f64 = 1e-10;
/// Error below which rounding may be what is measured, rad.
const ROUNDING: f64 = 1e-13;

/// Whether the error of free rotation does not depend on the step: it is exact, or under error control.
fn ignores_the_step(integrator: Integrator) -> bool {
    integrator.is_exact_without_loads() || integrator.controls_error()
}

/// Steps per second at which a method of this order is in its asymptotic range, and twice as many.
fn rates(order: u32) -> [u32; 2] {
    match order {
        1 => [2000, 4000],
        2 => [200, 400],
        4 => [50, 100],
        _ => [16, 32],
    }
}

/// The first body at the end of a run of so many steps.
fn end(scene: SceneBuilder, integrator: Integrator, duration_s: f64, steps: u32) -> Result<BodySample, Box<dyn Error>> {
    let step_s = Some(duration_s / f64::from(steps));
    let method = Method { integrator: Some(integrator), step_s, ..Method::default() };
    let scene = scene.duration_s(duration_s).output_interval_s(duration_s).method(method).build()?;
    Ok(Run::of(&scene, Effects::Planned)?.report.bodies.first().ok_or("no body")?.state)
}

fn free(moments: DVec3, spin: DVec3) -> Result<SceneBuilder, Box<dyn Error>> {
    Ok(Scene::builder("free rotation").gravity(DVec3::ZERO).body(rotor("rotor", moments, spin)?))
}

fn order_row(what: &str, theory: u32, errors: [f64; 2]) -> Row {
    let measured = (errors[0] / errors[1]).log2();
    let measured = if errors[1] > ROUNDING { measured } else { f64::NAN };
    Row::compared("convergence", &format!("{what}: order"), f64::from(theory), measured, Tolerance::Absolute(ORDER))
}

/// Orders of all integrators.
pub(super) fn orders(_context: &Context) -> CaseResult {
    let exact = FreeRotation::new(MOMENTS, Rotation::IDENTITY, MOMENTS * SPIN).at(DURATION_S);
    let mut rows = Vec::new();
    for integrator in Integrator::ALL.into_iter().filter(|&integrator| !ignores_the_step(integrator)) {
        let theory = integrator.order();
        let mut errors = [0.0; 2];
        for (error, rate) in errors.iter_mut().zip(rates(theory)) {
            let end = end(free(MOMENTS, SPIN)?, integrator, DURATION_S, 20 * rate)?;
            *error = end.pose.rotation.angle_to(exact);
        }
        rows.push(order_row(&format!("{integrator}, free rotation"), theory, errors));
    }
    rows.push(order_row("dop853, fixed step, leading term", 8, dop853_leading_terms(exact)?));
    rows.extend(orders_of_exact_under_forces()?);
    Ok(rows)
}

/// The leading term of DOP853's error for 2 and 4 fixed steps a second, which only the crate that has it offers: the
/// steps of a scene are under error control. In free rotation the next term, of order 9, is the larger one down to
/// rounding (the slope of the whole error is 8.7); `2^9 e(h/2) - e(h)` is free of it.
fn dop853_leading_terms(exact: Rotation) -> Result<[f64; 2], Box<dyn Error>> {
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(MOMENTS)?);
    let bodies = [RigidBody::new(&properties)];
    let start = BodyState { pose: Pose::IDENTITY, angular_momentum: MOMENTS * SPIN, ..BodyState::default() };
    let mut errors = [0.0; 3];
    for (error, rate) in errors.iter_mut().zip([2, 4, 8]) {
        let mut motion = FreeMotion::new(&bodies, DVec3::ZERO, &[]);
        let mut method = Dop853::new(start.to_array().len());
        let mut state = start;
        for step in 0..20 * rate {
            let h = 1.0 / f64::from(rate);
            method.attempt_unscaled(&mut motion, f64::from(step) * h, &state.to_array(), h)?;
            // As users have it: the quaternion is normalised after each step.
            state = BodyState::from_slice(method.end_state())?;
        }
        *error = state.pose.rotation.angle_to(exact);
    }
    Ok([512.0 * errors[1] - errors[0], 512.0 * errors[2] - errors[1]])
}

/// On the top of HT-02, against error control at a tolerance far below.
fn orders_of_exact_under_forces() -> CaseResult {
    /// Of the motion that is compared with.
    const TIGHT: f64 = 1e-13;
    let scene = || top(FRAC_PI_6, Rotation::from_rotation_vector(DVec3::X * FRAC_PI_6).rotate(DVec3::Z) * 20.0);
    let tolerance = Some(StepTolerance::new(TIGHT)?.get());
    let method = Method { integrator: Some(Integrator::Dop853), tolerance, ..Method::default() };
    let reference = Run::of(&scene()?.duration_s(2.0).method(method).build()?, Effects::Planned)?.last("top")?;
    let mut rows = Vec::new();
    for integrator in [Integrator::Exact, Integrator::ExactStrang] {
        let theory = integrator.order();
        let mut errors = [0.0; 2];
        for (error, rate) in errors.iter_mut().zip([100, 200]) {
            let end = end(scene()?, integrator, 2.0, 2 * rate)?;
            *error = end.pose.rotation.angle_to(reference.pose.rotation);
        }
        rows.push(order_row(&format!("{integrator}, heavy top"), theory, errors));
    }
    Ok(rows)
}

/// Attitude errors of the table, rad, in 100, 400 and 1600 steps of 10 s together.
const TABLE: [(Integrator, [f64; 3]); 12] = [
    (Integrator::ExplicitEuler, [3.4e-1, 8.4e-2, 2.1e-2]),
    (Integrator::SemiImplicitEuler, [3.3e-1, 8.1e-2, 2.0e-2]),
    (Integrator::ImplicitGyroscopic, [3.2e-1, 8.3e-2, 2.1e-2]),
    (Integrator::Rk4, [3.4e-6, 1.4e-8, 5.5e-11]),
    (Integrator::Rkmk4, [1.6e-6, 7.7e-9, 3.2e-11]),
    (Integrator::Cf4, [4.3e-6, 1.7e-8, 6.5e-11]),
    (Integrator::Splitting, [9.8e-4, 6.2e-5, 3.8e-6]),
    (Integrator::Splitting4, [9.7e-8, 3.8e-10, 1.4e-12]),
    (Integrator::Splitting6, [3.7e-9, 9.2e-13, ROUNDING]),
    (Integrator::ImplicitMidpoint, [9.8e-3, 6.1e-4, 3.8e-5]),
    (Integrator::MoserVeselov, [1.6e-2, 1.0e-3, 6.2e-5]),
    (Integrator::MoserVeselov4, [9.8e-6, 3.8e-8, 1.5e-10]),
];

/// Errors of all integrators in so many steps, against the table.
pub(super) fn work_precision(_context: &Context) -> CaseResult {
    let (moments, spin) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(0.4, 0.8, 0.4));
    let exact = FreeRotation::new(moments, Rotation::IDENTITY, moments * spin).at(10.0);
    let errors = |integrator: Integrator| -> Result<[f64; 3], Box<dyn Error>> {
        let mut errors = [0.0; 3];
        for (error, steps) in errors.iter_mut().zip([100, 400, 1600]) {
            *error = end(free(moments, spin)?, integrator, 10.0, steps)?.pose.rotation.angle_to(exact);
        }
        Ok(errors)
    };
    let mut rows = Vec::new();
    for (integrator, table) in TABLE {
        let errors = errors(integrator)?;
        let ratios = [0, 1, 2].map(|k| (errors[k].max(ROUNDING) / table[k].max(ROUNDING)).log2());
        let what = format!("{integrator}: log2(error/table), 100, 400, 1600 steps");
        rows.push(Row::compared("work-precision", &what, [0.0; 3], ratios, Tolerance::Absolute(1.0)));
        rows.push(Row::info("work-precision", &format!("{integrator}: errors, rad"), table, errors));
    }
    for integrator in Integrator::ALL.into_iter().filter(|&integrator| ignores_the_step(integrator)) {
        let what = format!("{integrator}: errors in 100, 400, 1600 steps, rad");
        let limit = if integrator == Integrator::Dop853 { CONTROLLED } else { ROUNDING };
        let row = Row::compared("work-precision", &what, [0.0; 3], errors(integrator)?, Tolerance::Absolute(limit));
        rows.push(row);
    }
    Ok(rows)
}
