//! CD-02 to CD-04 and CD-06: a scene is the same scene whatever its size and mass, wherever it is, in a moving frame,
//! turned, and backwards.
//!
//! Default settings throughout: the step of 0.01 s does not shrink with the scene. What is not here: in a moving frame
//! RC-10 and the pendulum, whose table and pivot would have to move.

use super::bodies::{GRAVITY, ball_on_x, bouncy, rotor};
use super::heavy_tops::top_on_floor;
use super::run::Run;
use super::setting::{Setting, largest_difference};
use super::{CaseResult, Context};
use glam::{DQuat, DVec3};
use polhode::scene::Method;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, BodySample, Effects, Scene};
use std::error::Error;

/// A pendulum: a uniform rod of 1 m held at its end, at this angle from hanging (rad), about y. It is not thin: the
/// rounding of its angular momentum turns a rod about its own axis, the more the smaller that moment is.
pub(super) fn pendulum(angle: f64) -> Result<Body, Box<dyn Error>> {
    /// Moment of the rod about its own axis, kg m^2, which plays no part in the motion.
    const AXIAL: f64 = 0.01;
    let inertia = Inertia::from_diagonal(DVec3::new(1.0 / 12.0, 1.0 / 12.0, AXIAL))?;
    let rod = Body::movable("rod", MassProperties::new(Mass::new(1.0)?, DVec3::Z * -0.5, inertia));
    Ok(rod.pose(Pose::new(Rotation::from_rotation_vector(DVec3::Y * angle), DVec3::ZERO)).pivot(DVec3::ZERO))
}

/// The scenes that are set elsewhere, each with the case whose scene it is.
fn scenes(context: &Context, names: &[&'static str]) -> Result<Vec<(&'static str, Scene)>, Box<dyn Error>> {
    let mut scenes = Vec::new();
    for &name in names {
        let scene = match name {
            "FR-02" => context.shipped.load("dzhanibekov")?,
            "FR-04" => Scene::builder("free rotation")
                .gravity(DVec3::ZERO)
                .body(rotor("rotor", DVec3::new(1.0, 2.0, 3.0), DVec3::ONE)?)
                .duration_s(10.0)
                .build()?,
            "HT-02" => context.shipped.load("heavy-top")?,
            "HT-04" => top_on_floor()?.duration_s(1.0).build()?,
            "IM-05" => context.shipped.load("bouncing-ball")?,
            "RC-10" => context.shipped.load("box-off-table")?,
            "JT-01" => {
                let scene = Scene::builder("pendulum").gravity(DVec3::Z * -GRAVITY);
                scene.body(pendulum(1.5)?).duration_s(10.0).build()?
            }
            "two balls" => two_balls()?,
            other => return Err(format!("no scene {other}").into()),
        };
        scenes.push((name, scene));
    }
    Ok(scenes)
}

/// A spinning ball hits another one elastically.
fn two_balls() -> Result<Scene, Box<dyn Error>> {
    let first = ball_on_x("first", 0.5, 1.0, -1.0, 1.0)?.material(bouncy(1.0)?);
    let second = ball_on_x("second", 0.5, 2.0, 0.3, -0.5)?;
    Ok(Scene::builder("two balls").gravity(DVec3::ZERO).body(first).body(second).duration_s(1.0).build()?)
}

/// One row per scene: the worst of some settings against the reference's quantity.
fn rows(
    context: &Context,
    (case, quantity): (&str, &str),
    scenes: &[(&str, Scene)],
    settings: &[(String, Setting)],
) -> CaseResult {
    let mut rows = Vec::new();
    for (name, scene) in scenes {
        for (how, setting) in settings {
            let mut row = context.reference.row(case, quantity, largest_difference(scene, setting)?)?;
            row.quantity = if how.is_empty() { format!("{name}: {quantity}") } else { format!("{name}, {how}") };
            rows.push(row);
        }
    }
    Ok(rows)
}

/// Another size and mass.
pub(super) fn cd_02(context: &Context) -> CaseResult {
    /// Factors of lengths, and of masses.
    const LENGTHS: [f64; 2] = [1e-4, 1e4];
    const MASSES: [f64; 2] = [1e-9, 1e9];
    let mut settings = Vec::new();
    for length in LENGTHS {
        for mass in MASSES {
            let setting = Setting { length, mass, ..Setting::default() };
            settings.push((format!("lengths x {length:e}, masses x {mass:e}: difference"), setting));
        }
    }
    let quantity = ("CD-02", "largest relative difference of the dimensionless trajectory");
    rows(context, quantity, &scenes(context, &["FR-04", "HT-02", "HT-04", "IM-05", "RC-10"])?, &settings)
}

/// Far from the origin.
pub(super) fn cd_03(context: &Context) -> CaseResult {
    let setting = Setting { offset: DVec3::splat(1e6), ..Setting::default() };
    let quantity = ("CD-03", "largest difference of relative positions, m");
    let scenes = scenes(context, &["FR-02", "IM-05", "JT-01", "RC-10"])?;
    rows(context, quantity, &scenes, &[(String::new(), setting)])
}

/// In a frame that moves at 1000 m/s.
pub(super) fn cd_04(context: &Context) -> CaseResult {
    let setting = Setting { boost: DVec3::X * 1000.0, ..Setting::default() };
    let quantity = ("CD-04", "largest difference in relative coordinates over 1 s");
    let mut scenes = scenes(context, &["FR-02", "IM-05", "HT-04", "two balls"])?;
    for (_, scene) in &mut scenes {
        *scene = scene.clone().with_duration(1.0)?;
    }
    rows(context, quantity, &scenes, &[(String::new(), setting)])
}

/// Backwards, and turned.
pub(super) fn cd_06(context: &Context) -> CaseResult {
    /// Local error for the orbit, whose tumbling satellite makes 200 radians near its middle axis.
    const TIGHT: f64 = 1e-13;
    let mut rows_found = Vec::new();
    let mut smooth = scenes(context, &["FR-04", "HT-02", "JT-01"])?;
    let orbit = context.shipped.load("kepler-orbit")?;
    let tight = Method { tolerance: Some(TIGHT), ..orbit.method().clone() };
    smooth.push(("Kepler, tolerance 1e-13", orbit.clone().with_method(tight)));
    smooth.push(("Kepler, default", orbit));
    for (name, scene) in smooth {
        let mut row = context.reference.row("CD-06", "return error", return_error(&scene)?)?;
        row.quantity = format!("{name}: return error");
        rows_found.push(row);
    }
    let turn = Rotation::renormalized(DQuat::from_xyzw(2.0, 3.0, 4.0, 1.0));
    let setting = Setting { turn, ..Setting::default() };
    let turned = scenes(context, &["FR-04", "HT-02", "HT-04", "IM-05", "JT-01", "RC-10"])?;
    rows_found.extend(rows(context, ("CD-06", "covariance error"), &turned, &[(String::new(), setting)])?);
    Ok(rows_found)
}

/// How far from its start a scene of one body is that runs to its end and back with its velocities turned round:
/// position relative to the start's distance from the origin (m where that is less than one), attitude (rad).
fn return_error(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    let there = Run::of(scene, Effects::Planned)?;
    let mut back = Scene::builder("back")
        .gravity(scene.gravity())
        .duration_s(scene.duration_s())
        .output_interval_s(scene.output_interval_s())
        .method(scene.method().clone());
    for (body, polhode::ReportedBody { state: end, .. }) in scene.bodies().iter().zip(&there.report.bodies) {
        back = back.body(turned_round(body, end));
    }
    for force in scene.forces() {
        back = back.force(force.clone());
    }
    let returned = Run::of(&back.build()?, Effects::Planned)?;
    let mut most = 0.0f64;
    for (body, polhode::ReportedBody { state: end, .. }) in scene.bodies().iter().zip(&returned.report.bodies) {
        let start = body.initial_pose();
        let size = start.translation.length().max(1.0);
        let apart = (end.pose.translation - start.translation).length() / size;
        let distance = apart.max(end.pose.rotation.angle_to(start.rotation));
        most = if distance <= most { most } else { distance };
    }
    Ok(most)
}

fn turned_round(body: &Body, end: &BodySample) -> Body {
    let linear = if body.pivot_point().is_some() { DVec3::ZERO } else { -end.velocity.linear };
    body.clone().pose(end.pose).velocity(Velocity::new(linear, -end.velocity.angular))
}
