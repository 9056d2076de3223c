//! Orders of convergence of every method with a step, in contact.
//!
//! The order is the slope of the error of a position at a fixed time between halved steps. What moves, and what the
//! error is of:
//!
//! | scene | motion | exact |
//! |---|---|---|
//! | ladder | a smooth ladder on a wall, before it leaves it: two turning contacts | tier `accurate`, tolerance 1e-13 |
//! | off-centre ball | a ball that rolls to and fro about its lowest place | the same |
//! | rolling | a ball down a slope | `5/14 g sin(a) t^2` |
//! | sliding and spinning | a ball whose slip keeps its direction | a parabola |
//! | stop | a box that slides to rest | `v^2/(2 mu g)` |
//! | bounce | a ball after one impact | two parabolas |
//!
//! Springs have a law of their own: their fixed steps are compared with the same springs under error control. Where
//! contacts begin or end within a step, nothing that does not locate them is better than of first order, and how much
//! it is off depends on where in the step they do: no slope is asked there, but the bound of first order `(1 + e) v h`
//! of a late impact.

use super::bodies::{GRAVITY, cuboid, half_space};
use super::rough_plane::{Plane, rough, sphere};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::scene::{Integrator, Material, Method, PenaltyMethod, Response, Tier};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, Scene, SceneBuilder};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

const CASE: &str = "orders in contact";
/// How far a measured order may be from the one claimed.
const ORDER: f64 = 0.1;
/// Error below which rounding may be what is measured, m.
const ROUNDING_M: f64 = 1e-13;
/// Of the motions that are compared with.
const TIGHT: f64 = 1e-13;
/// Inclination of the slope, rad.
const SLOPE: f64 = 0.3;
/// Radius of the balls, m.
const RADIUS: f64 = 0.1;
/// Stiffness of springs, N/m: some 60 ms for one swing of 1 kg.
const STIFFNESS: f64 = 1e4;
/// Moment of the ladder about its axis, about which it does not turn, kg m^2.
const AXIAL: f64 = 1e-3;
/// Restitution of springs, whose dampers reach none of zero.
const SPRUNG: f64 = 0.5;

/// What moves.
#[derive(Debug, Clone, Copy)]
enum Motion {
    Ladder,
    OffCentre,
    Rolling,
    Spinning,
    Sliding,
    Stop,
    Bounce,
}

impl Motion {
    fn name(self) -> &'static str {
        match self {
            Self::Ladder => "ladder on a wall",
            Self::OffCentre => "off-centre ball",
            Self::Rolling => "ball down a slope",
            Self::Spinning => "sliding and spinning ball",
            Self::Sliding => "sliding box",
            Self::Stop => "box slides to a stop",
            Self::Bounce => "bounce",
        }
    }

    fn duration_s(self) -> f64 {
        match self {
            Self::Ladder => 0.4,
            Self::OffCentre => 0.3,
            Self::Rolling | Self::Spinning | Self::Sliding => 0.2,
            Self::Stop => 1.0,
            Self::Bounce => 0.7,
        }
    }

    fn scene(self) -> Result<SceneBuilder, Box<dyn Error>> {
        let box_of = |speed: f64| Plane::LEVEL.lying_box(DVec3::new(0.4, 0.3, 0.2), 0.0, DVec3::X * speed);
        Ok(match self {
            Self::Ladder => ladder()?,
            Self::OffCentre => Plane::LEVEL.with(off_centre()?, 0.8)?,
            Self::Rolling => {
                let slope = Plane::inclined(SLOPE);
                slope.with(slope.round(sphere(RADIUS)?, RADIUS, Velocity::default()), 0.5)?
            }
            Self::Spinning => {
                let velocity = Velocity::new(DVec3::X * 2.0, DVec3::new(30.0, 0.0, 5.0));
                Plane::LEVEL.with(Plane::LEVEL.round(sphere(RADIUS)?, RADIUS, velocity), 0.3)?
            }
            Self::Sliding | Self::Stop => Plane::LEVEL.with(box_of(2.0)?, 0.3)?,
            Self::Bounce => {
                let ball = sphere(RADIUS)?.pose(Pose::from_translation(DVec3::Z * (RADIUS + 1.0)));
                let bouncy = Material::new("bouncy").with_restitution(0.8)?;
                let ball = ball.material(bouncy);
                Scene::builder("bounce").body(ball).body(half_space("floor", UnitVector::Z))
            }
        })
    }

    /// Where the origin of the body is at the end, m; of some only under error control.
    fn exact(self) -> Result<DVec3, Box<dyn Error>> {
        let t = self.duration_s();
        Ok(match self {
            Self::Ladder | Self::OffCentre => {
                self.end(Method { tier: Some(Tier::Accurate), tolerance: Some(TIGHT), ..Method::default() })?
            }
            Self::Rolling => {
                let way = 5.0 / 14.0 * GRAVITY * SLOPE.sin() * t * t;
                Plane::inclined(SLOPE).world(DVec3::new(way, 0.0, RADIUS))
            }
            Self::Spinning => {
                let slip = DVec3::new(2.0, 30.0 * RADIUS, 0.0);
                let force = slip.normalize() * (-0.3 * GRAVITY);
                DVec3::new(2.0 * t, 0.0, RADIUS) + force * (0.5 * t * t)
            }
            Self::Sliding => DVec3::new(2.0 * t - 0.15 * GRAVITY * t * t, 0.0, 0.1),
            Self::Stop => DVec3::new(4.0 / (0.6 * GRAVITY), 0.0, 0.1),
            Self::Bounce => {
                let fall = (2.0 / GRAVITY).sqrt();
                let up = t - fall;
                DVec3::Z * (RADIUS + 0.8 * GRAVITY * fall * up - 0.5 * GRAVITY * up * up)
            }
        })
    }

    fn end(self, method: Method) -> Result<DVec3, Box<dyn Error>> {
        let t = self.duration_s();
        let scene = self.scene()?.method(method).duration_s(t).output_interval_s(t).build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        Ok(run.report.bodies.first().ok_or("no body")?.state.pose.translation)
    }
}

/// A rod of 2 m and 1 kg with round ends, at rest at 60 degrees between floor and wall.
fn ladder() -> Result<SceneBuilder, Box<dyn Error>> {
    let (length, radius) = (2.0, 0.02);
    let across = length * length / 12.0;
    let moments = Inertia::from_diagonal(DVec3::new(across, across, AXIAL))?;
    let centre = DVec3::new(0.5 * length * FRAC_PI_3.cos() + radius, 0.0, 0.5 * length * FRAC_PI_3.sin() + radius);
    let turn = Rotation::from_rotation_vector(DVec3::Y * (FRAC_PI_3 - FRAC_PI_2));
    let rod = Body::movable("ladder", MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments))
        .geometry(Shape::capsule(radius, length)?.into())
        .pose(Pose::new(turn, centre));
    let scene = Scene::builder("ladder").body(rod).body(half_space("floor", UnitVector::Z));
    Ok(scene.body(half_space("wall", UnitVector::X)))
}

/// A ball whose centre of mass is 3 cm from its centre.
fn off_centre() -> Result<Body, Box<dyn Error>> {
    let moments = Inertia::from_diagonal(DVec3::splat(0.004))?;
    let turn = Rotation::from_rotation_vector(DVec3::Y * 0.5);
    Ok(Body::movable("ball", MassProperties::new(Mass::new(1.0)?, DVec3::Z * 0.03, moments))
        .geometry(Shape::sphere(RADIUS)?.into())
        .pose(Pose::new(turn, DVec3::Z * RADIUS)))
}

fn of_tier(tier: Tier, step_s: f64) -> Method {
    let integrator = (tier == Tier::Accurate).then_some(Integrator::Rk4);
    Method { tier: Some(tier), integrator, step_s: Some(step_s), ..Method::default() }
}

/// The row of the slope between a step and its half.
fn slope_row(what: &str, claimed: f64, errors: [f64; 2]) -> Row {
    let measured = if errors[1] > ROUNDING_M { (errors[0] / errors[1]).log2() } else { f64::NAN };
    Row::compared(CASE, &format!("{what}: order"), claimed, measured, Tolerance::Absolute(ORDER))
}

/// The tiers with rigid laws: tier, motion, the longer step (s), the order claimed.
const SMOOTH: [(Tier, Motion, f64, f64); 13] = [
    (Tier::Accurate, Motion::Ladder, 0.01, 4.0),
    (Tier::Accurate, Motion::OffCentre, 0.01, 4.0),
    (Tier::Stepped, Motion::Ladder, 0.005, 2.0),
    (Tier::Stepped, Motion::OffCentre, 0.005, 2.0),
    (Tier::Stepped, Motion::Rolling, 0.005, 2.0),
    (Tier::Stepped, Motion::Spinning, 0.005, 2.0),
    (Tier::Fast, Motion::Ladder, 0.005, 1.0),
    (Tier::Fast, Motion::OffCentre, 0.005, 1.0),
    (Tier::Fast, Motion::Rolling, 0.005, 1.0),
    (Tier::Fast, Motion::Spinning, 0.005, 1.0),
    (Tier::Fast, Motion::Stop, 0.005, 1.0),
    (Tier::Thesis, Motion::Ladder, 0.00125, 1.0),
    // A micro-collision reverses the slip: its mean over a step is that of rolling.
    (Tier::MicroCollisions, Motion::Rolling, 0.0025, 2.0),
];

/// Rows of the tiers, of springs, and of impacts within a step.
pub(super) fn rows(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for (tier, motion, step_s, claimed) in SMOOTH {
        let exact = motion.exact()?;
        let mut errors = [0.0; 2];
        for (error, step_s) in errors.iter_mut().zip([step_s, 0.5 * step_s]) {
            *error = (motion.end(of_tier(tier, step_s))? - exact).length();
        }
        let with = if tier == Tier::Accurate { " with rk4" } else { "" };
        rows.push(slope_row(&format!("{}{with}, {}", tier.name(), motion.name()), claimed, errors));
    }
    rows.extend(springs()?);
    rows.extend(within_a_step()?);
    Ok(rows)
}

/// Springs with fixed steps against springs under error control: integrator, motion, the longer step (s), the order
/// claimed.
const SPRINGS: [(Integrator, Motion, f64, f64); 4] = [
    (Integrator::Rk4, Motion::Rolling, 5e-4, 4.0),
    (Integrator::SemiImplicitEuler, Motion::Rolling, 1.25e-4, 1.0),
    (Integrator::SemiImplicitEuler, Motion::Sliding, 5e-4, 1.0),
    (Integrator::ImplicitMidpoint, Motion::Rolling, 5e-4, 2.0),
];

/// Rows of springs.
fn springs() -> CaseResult {
    let sprung = |motion: Motion, method: Method| -> Result<DVec3, Box<dyn Error>> {
        let t = motion.duration_s();
        let penalty = PenaltyMethod { stiffness_n_m: Some(STIFFNESS), ..PenaltyMethod::default() };
        let method = Method { response: Some(Response::Penalty), penalty: Some(penalty), ..method };
        let plane = if let Motion::Rolling = motion { Plane::inclined(SLOPE) } else { Plane::LEVEL };
        let material = rough(0.5)?.with_restitution(SPRUNG)?;
        let body = match motion {
            Motion::Rolling => plane.round(sphere(RADIUS)?, RADIUS, Velocity::default()),
            _ => cuboid("box", DVec3::new(0.4, 0.3, 0.2), 1.0, DVec3::Z * 0.1)?
                .velocity(Velocity::new(DVec3::X * 2.0, DVec3::ZERO)),
        };
        let scene = Scene::builder("springs").body(body.material(material)).body(plane.ground(0.5)?);
        let scene = scene.method(method).duration_s(t).output_interval_s(t).build()?;
        Ok(Run::of(&scene, Effects::Planned)?.report.bodies.first().ok_or("no body")?.state.pose.translation)
    };
    let mut rows = Vec::new();
    for (integrator, motion, step_s, claimed) in SPRINGS {
        let exact = sprung(motion, Method { tolerance: Some(TIGHT), ..Method::default() })?;
        let mut errors = [0.0; 2];
        for (error, step_s) in errors.iter_mut().zip([step_s, 0.5 * step_s]) {
            let method = Method { integrator: Some(integrator), step_s: Some(step_s), ..Method::default() };
            *error = (sprung(motion, method)? - exact).length();
        }
        rows.push(slope_row(&format!("penalty with {integrator}, {}", motion.name()), claimed, errors));
    }
    Ok(rows)
}

/// Impacts that are not located: late by a step at most. Stops within a step, and what locates them.
fn within_a_step() -> CaseResult {
    let steps = [0.01, 0.005, 0.0025, 0.00125, 0.000625];
    let late = 1.8 * (2.0 * GRAVITY).sqrt();
    let exact = Motion::Bounce.exact()?;
    let mut rows = Vec::new();
    for tier in [Tier::Fast, Tier::MicroCollisions, Tier::Thesis] {
        let mut worst = 0.0f64;
        for step_s in steps {
            let error = (Motion::Bounce.end(of_tier(tier, step_s))? - exact).length();
            worst = worst.max(error / (late * step_s));
        }
        rows.push(Row::at_most(
            CASE,
            &format!("{}, bounce: error over (1 + e) v h, worst of five steps", tier.name()),
            1.0,
            worst,
        ));
    }
    for tier in [Tier::Accurate, Tier::Stepped] {
        let error = (Motion::Bounce.end(of_tier(tier, 0.01))? - exact).length();
        rows.push(Row::at_most(
            CASE,
            &format!("{}, bounce at a step of 0.01 s: error, m", tier.name()),
            ROUNDING_M,
            error,
        ));
    }
    // The box stops within a step, at a speed of at most mu g h: a way of at most mu g h^2/2 is not told.
    let exact = Motion::Stop.exact()?;
    for tier in [Tier::Stepped, Tier::MicroCollisions] {
        let mut worst = 0.0f64;
        for step_s in steps {
            let error = (Motion::Stop.end(of_tier(tier, step_s))? - exact).length();
            worst = worst.max(error / (0.3 * GRAVITY * step_s));
        }
        rows.push(Row::info(
            CASE,
            &format!("{}, stop: error over mu g h, worst of five steps, s", tier.name()),
            "",
            worst,
        ));
    }
    Ok(rows)
}
