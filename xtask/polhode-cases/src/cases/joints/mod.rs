//! Joints: pendulums (JT-01 to JT-03), chains (JT-04, JT-05, JT-09), closed loops (JT-06 to JT-08, IFToMM A05) and a
//! Cardan joint (JT-11); joints of the shipped scenes.
//!
//! Bodies hang at joints, not at pivots, so that what is measured are rows of joints. Angles from hanging are positive
//! towards +x, those about z anticlockwise. All is measured in the tier `accurate` with its default settings.
//!
//! | module | holds |
//! |---|---|
//! | `pendulums` | JT-01 to JT-03 |
//! | `chains` | JT-04, JT-05 and JT-09 |
//! | `loops` | JT-06 and JT-07 |
//! | `squeezer` | JT-08 |
//! | `cardan` | JT-11 |
//! | `governor` | IFToMM A05 |
//! | `shipped` | how far the joints of the shipped scenes are from what they keep |

pub(crate) mod cardan;
pub(crate) mod chains;
mod governor;
pub(crate) mod loops;
pub(crate) mod pendulums;
mod shipped;
mod squeezer;

pub(super) use cardan::jt_11;
pub(super) use chains::{heavy_end, jt_04, jt_05, jt_09};
pub(super) use governor::iftomm_a05;
pub(super) use loops::{jt_06, jt_07, linkage};
pub(super) use pendulums::{jt_01, jt_02, jt_03};
pub(super) use shipped::drift;
pub(super) use squeezer::jt_08;

use crate::cases::motion::{counted_on, zero};
use crate::cases::run::Run;
use crate::row::Row;
use glam::DVec3;
use polhode::scene::{Joint, JointKind, Method, Tier};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, BodySample, Effects, RunReport, Scene, SceneBuilder, Simulation};
use std::error::Error;

type Result<T> = std::result::Result<T, Box<dyn Error>>;

/// What joints may do to the energy over a run, relative to its scale: projections and the integrator, which are all
/// that is left.
const WORK_OF_JOINTS: f64 = 1e-12;

/// Moment of a thin rod about itself, kg m^2: it does not turn about itself.
const AXIAL: f64 = 0.01;

/// A scene of the tier `accurate` with gravity along -z.
fn scene(name: &str) -> SceneBuilder {
    let method = Method { tier: Some(Tier::Accurate), ..Method::default() };
    Scene::builder(name).method(method).gravity(DVec3::Z * -super::bodies::GRAVITY)
}

/// A uniform rod of this mass between two points.
fn rod(name: &str, mass_kg: f64, [from, to]: [DVec3; 2]) -> Result<Body> {
    let way = to - from;
    let across = mass_kg * way.length_squared() / 12.0;
    let inertia = Inertia::from_diagonal(DVec3::new(AXIAL * across, across, across))?;
    let properties = MassProperties::new(Mass::new(mass_kg)?, DVec3::ZERO, inertia);
    let direction = way.normalize();
    let rotation = Rotation::from_rotation_vector(turn_from_x(direction));
    Ok(Body::movable(name, properties).pose(Pose::new(rotation, (from + to) * 0.5)))
}

/// The rotation vector of the least turn from the x axis to a direction.
fn turn_from_x(direction: DVec3) -> DVec3 {
    let axis = DVec3::X.cross(direction);
    let (sine, cosine) = (axis.length(), direction.x);
    if sine == 0.0 {
        return if cosine > 0.0 { DVec3::ZERO } else { DVec3::Z * std::f64::consts::PI };
    }
    axis * (sine.atan2(cosine) / sine)
}

/// A body of 1 kg at a point, which a rod without mass holds: it does not turn, and moves as a particle.
fn particle(name: &str, place: DVec3, velocity: DVec3) -> Result<Body> {
    let inertia = Inertia::from_diagonal(DVec3::splat(0.1))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia);
    let body = Body::movable(name, properties).pose(Pose::from_translation(place));
    Ok(body.velocity(Velocity::new(velocity, DVec3::ZERO)))
}

/// A rod without mass from a body to a point of the world, or of another body.
fn massless_rod(body: BodyId, from: DVec3, to: DVec3) -> Joint {
    Joint::new(JointKind::Rod { to }, body, from)
}

/// A point of hinges about an axis.
fn hinge(body: BodyId, place: DVec3, axis: UnitVector) -> Joint {
    Joint::hinge(body, place, axis)
}

/// The bodies at a time, s: at the end of a run of its own.
fn bodies_at(scene: &Scene, t: f64) -> Result<Vec<BodySample>> {
    let report = Simulation::new(&scene.clone().with_duration(t)?)?.run()?;
    Ok(report.bodies.iter().map(|body| body.state).collect())
}

/// The first time in a run (after its first sample) at which a function of its bodies is zero, s.
fn first_zero(run: &Run, function: impl Fn(&[BodySample]) -> f64) -> Result<f64> {
    Ok(zeros(run, 1, function)?[0])
}

/// The first zeros of a function of the bodies of a run, s.
fn zeros(run: &Run, count: usize, function: impl Fn(&[BodySample]) -> f64) -> Result<Vec<f64>> {
    let values: Vec<f64> = run.record.samples.iter().map(|bodies| function(bodies)).collect();
    let mut found = Vec::new();
    // The first sample may be a zero itself.
    for (times, values) in run.record.times_s.windows(2).zip(values.windows(2)).skip(1) {
        if found.len() < count && values[0] * values[1] <= 0.0 && values[0] != 0.0 {
            found.push(zero([times[0], times[1]], |t| bodies_at(&run.scene, t).map(|bodies| function(&bodies)))?);
        }
    }
    if found.len() < count {
        return Err(format!("{}: only {} of {count} zeros", run.scene.name(), found.len()).into());
    }
    Ok(found)
}

/// The last of some angles of a run, with all its revolutions, rad.
fn whole_angle(run: &Run, angle: impl Fn(&[BodySample]) -> f64) -> f64 {
    counted_on(run.record.samples.iter().map(|bodies| angle(bodies)))
}

/// The angle of a rod along its x axis from hanging, positive towards +x, rad.
fn from_hanging(body: &BodySample) -> f64 {
    let along = body.pose.rotation.rotate(DVec3::X);
    along.x.atan2(-along.z)
}

/// Rows about a run: what joints and the integrator do to the energy, and whether the ledger closes.
fn rows_of_energy(case: &str, report: &RunReport) -> [Row; 2] {
    let ledger = &report.ledger;
    let work = (ledger.projection.value().abs() + ledger.numerical.value().abs()) / ledger.scale_j;
    [
        Row::at_most(case, "work of joints and integrator, relative to the energy", WORK_OF_JOINTS, work),
        Row::at_most(case, "closure of the ledger", WORK_OF_JOINTS, ledger.closure_relative()),
    ]
}

/// A finished run with planned effects.
fn run(scene: &Scene) -> Result<Run> {
    Run::of(scene, Effects::Planned)
}
