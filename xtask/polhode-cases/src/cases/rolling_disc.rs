//! FC-16, FC-17: a coin that rolls on its rim, and a sphere with its centre of mass off its centre (tippe top).
//!
//! Euler's disc: a thin disc of radius r whose centre of mass rests rolls without slip on its rim at the rate
//! `Omega^2 sin(alpha) = 4 g/r`, turning about the diameter through its contact. Rolling upright, or spinning about a
//! vertical diameter, a disc or hoop is stable above a critical speed: below it a small lean
//! grows, above it oscillates.

use super::bodies::GRAVITY;
use super::rough_plane::{Plane, rough};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::scene::Method;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, Velocity};
use polhode::{Body, BodySample, Effects, Scene};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Local error of a step, near the rounding unit: the precession is compared to 1e-9 over many turns.
const STEP_TOLERANCE: f64 = 1e-13;

/// Tolerance of the rate of precession, as in the catalogue of cases, relative.
const PRECESSION: f64 = 1e-9;

/// Friction that lets nothing slip.
const ROUGH: f64 = 5.0;

/// A disc of radius 1 m and 1 kg that rolls with its centre of mass at rest, its plane at `inclination` (rad) to the
/// floor. A cylinder whose centre of mass lies in its lower face has the rim of a thin disc.
fn euler_disc(inclination: f64, duration_s: f64) -> Result<(Scene, f64), Box<dyn Error>> {
    let height = 0.01;
    let rate = (4.0 * GRAVITY / inclination.sin()).sqrt();
    let moments = Inertia::from_diagonal(DVec3::new(0.25, 0.25, 0.5))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::Z * (-0.5 * height), moments);
    let turn = Rotation::from_rotation_vector(DVec3::Y * inclination);
    // The diameter through the contact, from the contact up.
    let up = turn.rotate(-DVec3::X);
    let center_of_mass = DVec3::Z * inclination.sin();
    let origin = center_of_mass + turn.rotate(DVec3::Z * (0.5 * height));
    let body = Body::movable("disc", properties)
        .geometry(Shape::cylinder(1.0, height)?.into())
        .pose(Pose::new(turn, origin))
        .velocity(Velocity::new(DVec3::ZERO, up * (rate * inclination.sin())));
    Ok((Plane::LEVEL.with(body, ROUGH)?.duration_s(duration_s).output_interval_s(0.01).build()?, rate))
}

/// The rate at which the contact of a disc goes round, rad/s.
fn precession(inclination: f64, duration_s: f64) -> Result<f64, Box<dyn Error>> {
    let (scene, _) = euler_disc(inclination, duration_s)?;
    let run = Run::of(&scene, Effects::Planned)?;
    let axes = run.record.samples.iter().filter_map(|row| row.first()).map(|s| s.pose.rotation.rotate(DVec3::Z));
    let turned = super::motion::counted_on(axes.map(|axis| axis.y.atan2(axis.x)));
    let start = run.record.samples.first().and_then(|row| row.first()).ok_or("no sample")?;
    let axis = start.pose.rotation.rotate(DVec3::Z);
    Ok((turned - axis.y.atan2(axis.x)) / duration_s)
}

/// A ring of radius 1 m, so thin that its tube does not count, with the moments of a disc or a hoop.
fn ring(axial: f64, pose: Pose, velocity: Velocity) -> Result<Body, Box<dyn Error>> {
    let moments = Inertia::from_diagonal(DVec3::new(0.5 * axial, 0.5 * axial, axial))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments);
    let body = Body::movable("ring", properties).geometry(Shape::torus(1.0 - TUBE, TUBE)?.into());
    Ok(body.pose(pose).velocity(velocity))
}

/// Radius of the tube, m: critical speeds change by less than that, relatively.
const TUBE: f64 = 1e-6;

/// Lean at the start of the search for critical speeds, rad.
const LEAN: f64 = 1e-5;

/// A ring that stands upright, leaning by `LEAN` towards +y, rolls along x at `speed` (m/s) and spins about the
/// vertical at `spin` (rad/s).
fn upright(axial: f64, speed: f64, spin: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    // The ring's axis, its z, points to -y when it stands; the lean turns it about x.
    let lean = Rotation::from_rotation_vector(DVec3::X * -LEAN);
    let turn = lean * Rotation::from_rotation_vector(DVec3::X * FRAC_PI_2);
    let center = lean.rotate(DVec3::Z * (1.0 - TUBE)) + DVec3::Z * TUBE;
    let axis = turn.rotate(DVec3::Z);
    // Rolling along x turns about +y, that is against the axis.
    let angular = axis * -speed + lean.rotate(DVec3::Z) * spin;
    let linear = angular.cross(center);
    let body = ring(axial, Pose::new(turn, center), Velocity::new(linear, angular))?;
    let method = Method { tolerance: Some(STEP_TOLERANCE), ..Method::default() };
    Ok(Plane::LEVEL.with(body, ROUGH)?.method(method).duration_s(duration_s).output_interval_s(0.02).build()?)
}

/// The square of the angular frequency of the lean, from its course: `l'' = -k (l - c)`, by its second differences.
/// Negative where the lean grows.
fn stiffness(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    let run = Run::of(scene, Effects::Planned)?;
    let leans: Vec<f64> = run.record.samples.iter().filter_map(|row| row.first()).map(lean_of).collect();
    let h = scene.output_interval_s();
    // Least squares of l(t+h) - 2 l(t) + l(t-h) = -2 (1 - cos(w h)) (l(t) - c) over all inner samples.
    let pairs: Vec<(f64, f64)> = leans.windows(3).map(|l| (l[1], l[2] - 2.0 * l[1] + l[0])).collect();
    let count = pairs.len() as f64;
    let (mean_x, mean_y) = pairs.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
    let (xy, xx) = pairs
        .iter()
        .fold((0.0, 0.0), |(xy, xx), p| (xy + (p.0 - mean_x) * (p.1 - mean_y), xx + (p.0 - mean_x) * (p.0 - mean_x)));
    let cosine = 1.0 + 0.5 * xy / xx;
    let angle = if cosine <= 1.0 { cosine.acos().powi(2) } else { -cosine.acosh().powi(2) };
    Ok(angle / (h * h))
}

/// How far the plane of a ring leans from the vertical, rad.
fn lean_of(sample: &BodySample) -> f64 {
    sample.pose.rotation.rotate(DVec3::Z).z.asin()
}

/// The speed at which the lean neither grows nor oscillates: its stiffness is linear in the square of the speed.
fn critical(scene: impl Fn(f64) -> Result<Scene, Box<dyn Error>>, slow: f64, fast: f64) -> Result<f64, Box<dyn Error>> {
    let (a, b) = (stiffness(&scene(slow)?)?, stiffness(&scene(fast)?)?);
    let (x, y) = (slow * slow, fast * fast);
    Ok((x - a * (y - x) / (b - a)).sqrt())
}

/// Coins and hoops: the rate of Euler's disc, and the speeds below which upright ones fall.
pub(super) fn fc_16(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let rate = precession(10.0f64.to_radians(), 2.0)?;
    let mut rows =
        vec![reference.row("FC-16", "Omega at alpha=10deg (disc plane to floor), contact point rate", rate)?];
    for degrees in [5.0, 20.0, 40.0, 60.0, 80.0f64] {
        let expected = (4.0 * GRAVITY / degrees.to_radians().sin()).sqrt();
        let found = precession(degrees.to_radians(), 2.0)?;
        let quantity = format!("Omega at alpha={degrees}deg");
        rows.push(Row::compared("FC-16", &quantity, expected, found, crate::row::Tolerance::Relative(PRECESSION)));
    }
    let rolling = |axial: f64| critical(|speed| upright(axial, speed, 0.0, 2.0), 1.3, 2.3);
    rows.push(reference.row("FC-16", "critical rolling speed disc", rolling(0.5)?)?);
    rows.push(reference.row("FC-16", "critical rolling speed hoop sqrt(g r/4)", rolling(1.0)?)?);
    let spinning = critical(|spin| upright(0.5, 0.0, spin, 2.0), 2.0, 4.0)?;
    rows.push(reference.row("FC-16", "critical spin about vertical diameter, disc, rolling contact", spinning)?);
    Ok(rows)
}

/// A sphere of radius 2 cm and 20 g whose centre of mass is 2 mm from its centre.
pub(super) fn tippe_top(friction: f64, spin: f64, lean: f64, slide: f64) -> Result<Scene, Box<dyn Error>> {
    let (radius, offset, mass) = (0.02, 0.002, 0.02);
    let moment = 0.4 * mass * radius * radius;
    let moments = Inertia::from_diagonal(DVec3::new(0.95 * moment, 0.95 * moment, moment))?;
    let properties = MassProperties::new(Mass::new(mass)?, DVec3::Z * -offset, moments);
    let turn = Rotation::from_rotation_vector(DVec3::new(lean, 0.3 * lean, 0.0));
    // The centre of the sphere keeps its height: its velocity is level.
    let angular = turn.rotate(DVec3::Z) * spin;
    let linear = DVec3::X * slide + angular.cross(turn.rotate(DVec3::Z * -offset));
    let body = Body::movable("top", properties)
        .geometry(Shape::sphere(radius)?.into())
        .pose(Pose::new(turn, DVec3::Z * radius))
        .velocity(Velocity::new(linear, angular));
    let scene = Scene::builder("tippe top").body(body.material(rough(friction)?)).body(Plane::LEVEL.ground(friction)?);
    Ok(scene.duration_s(2.0).output_interval_s(0.01).build()?)
}

/// Jellett's number `-L . p`, `L` about the centre of mass and `p` from there to the contact, kg m^3/s.
fn jellett(scene: &Scene, sample: &BodySample) -> Result<f64, Box<dyn Error>> {
    let body = scene.bodies().first().ok_or("no body")?;
    let properties = body.mass_properties().ok_or("no mass")?;
    let rotation = sample.pose.rotation;
    let momentum = rotation.rotate(properties.inertia().matrix() * rotation.inverse_rotate(sample.velocity.angular));
    let radius = match body.shape() {
        Some(polhode::Geometry::Shape(shape)) => shape.radius(),
        _ => return Err("no shape".into()),
    };
    let arm = DVec3::Z * -radius - rotation.rotate(properties.center_of_mass());
    Ok(-momentum.dot(arm))
}

/// The largest change of Jellett's number in a run, relative.
fn drift(scene: &Scene) -> Result<f64, Box<dyn Error>> {
    let run = Run::of(scene, Effects::Planned)?;
    let mut values = Vec::new();
    for row in &run.record.samples {
        values.push(jellett(scene, row.first().ok_or("no sample")?)?);
    }
    let first = *values.first().ok_or("no sample")?;
    Ok(values.iter().map(|value| (value / first - 1.0).abs()).fold(0.0, f64::max))
}

/// Jellett's number of tippe tops, whatever the friction.
pub(super) fn fc_17(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let mut rows = Vec::new();
    for (friction, spin, lean, slide) in [
        (0.3, 30.0 * TAU, 0.2, 0.0),
        (0.05, 20.0 * TAU, 0.7, 0.4),
        (1.0, 10.0 * TAU, 1.4, -0.2),
        (0.0, 20.0 * TAU, 0.5, 0.3),
    ] {
        let mut row =
            reference.row("FC-17", "relative drift of J", drift(&tippe_top(friction, spin, lean, slide)?)?)?;
        row.quantity = format!("friction {friction}, {:.0} turns/s: {} in 2 s", spin / TAU, row.quantity);
        rows.push(row);
    }
    Ok(rows)
}
