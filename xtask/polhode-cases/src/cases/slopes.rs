//! FC-01, FC-02, FC-21: boxes on slopes with friction, and slopes of any angle, coefficient, size and direction.
//!
//! A box sticks if `mu >= tan(alpha)`; else it slides with `a = g (sin(alpha) - mu cos(alpha))`.

use super::bodies::GRAVITY;
use super::motion::zero;
use super::rough_plane::{Plane, end_of, first_acceleration, is_in_equilibrium, rough, threshold};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::scene::Method;
use polhode::spatial::Velocity;
use polhode::{BodySample, Effects, Scene, Simulation};
use polhode_oracles::random::Random;
use std::error::Error;
use std::f64::consts::TAU;

/// Tolerance of speeds and distances, as in the catalogue of cases, relative.
const RELATIVE: f64 = 1e-9;

/// How far a coefficient is from the tangent of the slope, relative.
const BESIDE_THRESHOLD: f64 = 1e-9;

/// A body that moves by less has stuck, m.
const STUCK_M: f64 = 1e-12;

/// Tolerance of the acceleration on the incline of Rigid IPC, relative.
const SUITE: f64 = 1e-6;

/// Limit of the creep in ten hours, m.
const CREEP_M: f64 = 1e-9;

/// Length, depth and height of the box, m.
const SIZE: DVec3 = DVec3::new(1.0, 0.5, 0.5);

/// The slope of these cases, rad.
fn twenty_degrees() -> f64 {
    20.0f64.to_radians()
}

/// A box at rest on a slope.
fn box_on(angle: f64, friction: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let plane = Plane::inclined(angle);
    Ok(plane.with(plane.lying_box(SIZE, 0.0, DVec3::ZERO)?, friction)?.duration_s(duration_s).build()?)
}

/// How far the first body has moved along a plane since the start, in the plane's directions, m.
fn moved(plane: Plane, scene: &Scene) -> Result<DVec3, Box<dyn Error>> {
    let start = scene.bodies().first().ok_or("the scene has no body")?.initial_pose().translation;
    Ok(plane.local(end_of(scene)?.pose.translation - start))
}

/// A box on a slope: sticks, slides, tips; the forces on its lower and upper edge.
pub(super) fn fc_01(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let angle = twenty_degrees();
    let plane = Plane::inclined(angle);
    // The friction at which a box that slides keeps its speed.
    let steady = zero([0.3, 0.4], |friction| {
        let sliding = plane.lying_box(SIZE, 0.0, DVec3::X)?;
        let scene = plane.with(sliding, friction)?.build()?;
        Ok(plane.local(first_acceleration(&scene)?.linear).x)
    })?;
    let holds = threshold(0.4, 0.3, |friction| is_in_equilibrium(&box_on(angle, friction, 1.0)?))?;
    let slide = |friction, duration_s: f64| -> Result<f64, Box<dyn Error>> {
        Ok(2.0 * moved(plane, &box_on(angle, friction, duration_s)?)?.x / (duration_s * duration_s))
    };
    let tips = |degrees: f64| -> Result<bool, Box<dyn Error>> {
        let plane = Plane::inclined(degrees.to_radians());
        let scene = plane.with(plane.lying_box(DVec3::ONE, 0.0, DVec3::ZERO)?, 2.0)?.duration_s(0.5).build()?;
        Ok(end_of(&scene)?.velocity.angular.length() > 0.0)
    };
    Ok(vec![
        reference.row("FC-01", "tan 20deg (threshold)", steady)?,
        Row::compared(
            "FC-01",
            "smallest friction that holds a box at rest",
            angle.tan(),
            holds,
            Tolerance::Relative(RELATIVE),
        ),
        reference.row("FC-01", "mu=0.3, 20deg: a", slide(0.3, 1.0)?)?,
        reference.row("FC-01", "mu=0.36 slides: a", slide(0.36, 1.0)?)?,
        reference.row(
            "FC-01",
            "mu=0.37: displacement after 100 s",
            moved(plane, &box_on(angle, 0.37, 100.0)?)?.length(),
        )?,
        reference.row("FC-01", "1x1 box, 44.9/45.1 deg, mu=2: tips?", vec![tips(44.9)?, tips(45.1)?])?,
        reference.row(
            "FC-01",
            "2D box w=1,h=0.5, slope 20deg, mu=0.37: f_downhill corner, f_uphill corner normal forces / (m g)",
            edge_forces(plane, 0.37)?,
        )?,
    ])
}

/// Normal forces on the lower and on the upper edge of the box, of its weight.
fn edge_forces(plane: Plane, friction: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let scene = plane.with(plane.lying_box(SIZE, 0.0, DVec3::ZERO)?, friction)?.build()?;
    let contacts = Simulation::new(&scene)?.contacts();
    let edge = |is_lower: bool| -> f64 {
        let at_edge = contacts.iter().filter(|contact| (plane.local(contact.point_m).x > 0.0) == is_lower);
        at_edge.map(|contact| contact.normal_force_n).sum::<f64>() / GRAVITY
    };
    Ok([edge(true), edge(false)])
}

/// A flat box launched level along a slope, whose friction is that at which it keeps its speed.
pub(super) fn puck(angle: f64, speed: f64, duration_s: f64) -> Result<Scene, Box<dyn Error>> {
    let plane = Plane::inclined(angle);
    let body = plane.lying_box(DVec3::new(0.4, 0.4, 0.1), 0.0, DVec3::Y * speed)?;
    Ok(plane.with(body, angle.tan())?.duration_s(duration_s).build()?)
}

/// A box launched level along a slope whose friction is that at which it keeps its speed: it turns downhill and ends
/// with half its speed.
pub(super) fn fc_02(context: &Context) -> CaseResult {
    let reference = &context.reference;
    let angle = 30.0f64.to_radians();
    let plane = Plane::inclined(angle);
    let at = |t: f64| -> Result<(DVec3, DVec3), Box<dyn Error>> {
        let end: BodySample = end_of(&puck(angle, 1.0, t)?)?;
        Ok((plane.local(end.pose.translation), plane.local(end.velocity.linear)))
    };
    let (place, velocity) = at(0.2)?;
    let (end, last) = at(6.0)?;
    // Other slopes and speeds, after times in which the direction has come within 1e-10 of downhill.
    let mut worst = 0.0f64;
    for (degrees, speed) in [(3.0, 0.3), (12.0, 2.0), (25.0, 0.5), (44.0, 5.0f64)] {
        let angle: f64 = f64::to_radians(degrees);
        let last = end_of(&puck(angle, speed, 15.0 * speed / (GRAVITY * angle.sin()))?)?;
        worst = worst.max((last.velocity.linear.length() / speed - 0.5).abs());
    }
    Ok(vec![
        Row::at_most("FC-02", "slopes of 3 to 44 deg, v0 0.3 to 5: error of terminal speed / v0", RELATIVE, worst),
        reference.row("FC-02", "terminal speed / v0", last.length())?,
        reference.row(
            "FC-02",
            "total sideways travel = int_0^{pi/2} dphi/(1+cos)^2 / (g sin al) = (2/3) v0^2/(g sin al)",
            end.y,
        )?,
        reference.row("FC-02", "t=0.2: v_side, v_down", [velocity.y, velocity.x])?,
        reference.row("FC-02", "t=0.2: side, down displacement", [place.y, place.x])?,
    ])
}

/// Friction above and below that of the slope by a billionth.
pub(super) fn fc_21(context: &Context) -> CaseResult {
    let angle = twenty_degrees();
    let plane = Plane::inclined(angle);
    let speed = |friction: f64| -> Result<f64, Box<dyn Error>> {
        let scene = plane.with(plane.lying_box(SIZE, 0.0, DVec3::ZERO)?, friction)?;
        // Nothing happens in these seconds that shorter steps would see.
        let method = Method { step_s: Some(1.0), ..Method::default() };
        let scene = scene.method(method).duration_s(1000.0).output_interval_s(1.0).build()?;
        Ok(end_of(&scene)?.velocity.linear.length())
    };
    let speeds = [speed(angle.tan() * (1.0 - BESIDE_THRESHOLD))?, speed(angle.tan() * (1.0 + BESIDE_THRESHOLD))?];
    Ok(vec![context.reference.row("FC-21", "mu-,: speed after 1000 s (slides), mu+: 0", speeds)?])
}

/// A box at rest on a slope, and what it does.
pub(crate) struct OnSlope {
    /// The box is its first body.
    pub(crate) scene: Scene,
    plane: Plane,
    /// Downhill, without what friction holds, m/s^2; none where it stays.
    acceleration: Option<f64>,
}

impl OnSlope {
    /// A box of any size on a slope of any angle and direction, turned about the normal.
    pub(crate) fn random(random: &mut Random) -> Result<Self, Box<dyn Error>> {
        let angle = random.between(0.02, 1.2);
        let plane = Plane::inclined(angle).turned(random.between(0.0, TAU));
        // A flat box does not tip.
        let height = random.between(0.05, 0.3);
        let size = DVec3::new(random.between(1.0, 2.0), random.between(1.0, 2.0), height);
        let friction = angle.tan() * random.between(0.0, 2.0);
        let scene = plane.with(plane.lying_box(size, random.between(0.0, TAU), DVec3::ZERO)?, friction)?;
        let acceleration = GRAVITY * (angle.sin() - friction * angle.cos());
        let acceleration = (friction < angle.tan()).then_some(acceleration);
        Ok(Self { scene: scene.duration_s(1.0).build()?, plane, acceleration })
    }

    /// How far it has moved after a time (s), world, m.
    pub(crate) fn moved(&self, t: f64) -> DVec3 {
        self.plane.world(DVec3::X * (0.5 * self.acceleration.unwrap_or_default() * t * t))
    }
}

/// Boxes of any size and mass on slopes of any angle and direction, turned about the normal: at rest, and sliding.
pub(super) fn random_slopes(context: &Context) -> CaseResult {
    /// Slopes at full count.
    const SLOPES: usize = 1000;
    let case = "random slopes";
    let mut random = Random(18);
    let (mut worst, mut crept, mut wrong) = (0.0f64, 0.0f64, 0u64);
    let count = context.amount.of(SLOPES);
    for _ in 0..count {
        let slope = OnSlope::random(&mut random)?;
        let distance = moved(slope.plane, &slope.scene)?;
        if let Some(acceleration) = slope.acceleration {
            let error = (distance - DVec3::X * (0.5 * acceleration)).length() / acceleration;
            worst = worst.max(error);
        } else {
            crept = crept.max(distance.length());
            wrong += u64::from(distance.length() > STUCK_M);
        }
    }
    Ok(vec![
        Row::at_most(case, &format!("creep of boxes that stick in 1 s, {count} slopes, m"), STUCK_M, crept),
        Row::exact(case, "boxes that should stick and move", 0, wrong),
        Row::at_most(case, "error of the distance of boxes that slide, relative", RELATIVE, worst),
    ])
}

/// A slope of 26.565 degrees (Rigid IPC): friction 0.5 holds a box, 0.49 does not.
pub(super) fn rigid_ipc_slope(_: &Context) -> CaseResult {
    let case = "slope of 26.565 degrees";
    let angle = 26.565f64.to_radians();
    let plane = Plane::inclined(angle);
    let held = Run::of(&box_on(angle, 0.5, 10.0)?, Effects::Planned)?;
    let slid = moved(plane, &box_on(angle, 0.49, 1.0)?)?.x;
    let acceleration = GRAVITY * (angle.sin() - 0.49 * angle.cos());
    Ok(vec![
        Row::at_most(case, "friction 0.5: movement in 10 s, m", STUCK_M, held.largest_movement_m()),
        Row::compared(case, "friction 0.49: acceleration, m/s^2", acceleration, 2.0 * slid, Tolerance::Relative(SUITE)),
    ])
}

/// Ten hours at rest on a slope of 20 degrees with friction 0.5.
pub(super) fn ten_hours_on_a_slope(_: &Context) -> CaseResult {
    let case = "ten hours on a slope";
    let plane = Plane::inclined(twenty_degrees());
    let block = plane.lying_box(SIZE, 0.3, DVec3::ZERO)?.material(rough(0.5)?);
    // It is set down with a speed, so that it comes to rest by itself.
    let block = block.velocity(Velocity::new(plane.world(DVec3::new(0.3, 0.2, 0.0)), DVec3::ZERO));
    let scene = plane.with(block, 0.5)?.duration_s(36_000.0).output_interval_s(1.0).build()?;
    let run = Run::of(&scene, Effects::Planned)?;
    let at_rest = run.record.samples.get(10).and_then(|row| row.first()).ok_or("no sample")?;
    let crept = (run.last("box")?.pose.translation - at_rest.pose.translation).length();
    Ok(vec![Row::at_most(case, "creep from the tenth second on, m", CREEP_M, crept)])
}
