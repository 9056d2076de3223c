//! IFToMM A05: the stiff governor with two balls, against its equations in three coordinates.
//!
//! A shaft of length `L` turns about the vertical. Two rods of length `L`, with balls of mass `b` at their ends, hang
//! by hinges at its head, at the angle `a` to the vertical. A slider of mass `s` lies on the shaft at the depth `u`
//! below the head; springs with dampers (`k`, `c`, length at rest `l0`) join it to the middles of the rods. With `l^2 =
//! (L/2 sin a)^2 + (u - L/2 cos a)^2` and `F = k (l - l0) + c l'`:
//!
//! ```text
//! J w = const,   J(a) = J0 + 2 (I sin^2 a + A cos^2 a)
//! 2 I a'' = J'(a) w^2/2 - 2 (m/2 + b) L g sin a - 2 F dl/da,     s u'' = s g - 2 F dl/du
//! ```
//!
//! `m` mass of a rod, `I` moment of a rod with its ball about the hinge, `A` about itself, `J0` of shaft and slider
//! about the axis (kg m^2), `w` angular velocity (rad/s). Source: IFToMM benchmark library, problem A05. The slider is
//! slow to 1e-5 s on its dampers, which is what makes the problem stiff. The oracle is the classical Runge-Kutta method
//! at a step of 2.5e-6 s, which agrees with that at half the step to 1e-12.

use super::{bodies_at, rows_of_energy, run, scene};
use crate::cases::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::scene::{Attachment, Force, Joint, JointKind};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, BodyId, Scene};

const CASE: &str = "IFToMM A05";

const GRAVITY: f64 = crate::cases::bodies::GRAVITY;

/// Length of shaft and rods, m.
const LENGTH: f64 = 1.0;

/// Edge of the section of shaft and rods, and of the slider, m.
const EDGE: f64 = 0.01;
const SLIDER_EDGE: f64 = 0.1;

const DENSITY: f64 = 3000.0;

/// Mass of a ball, kg.
const BALL: f64 = 5.0;

/// Masses of shaft and of a rod, and of the slider, kg.
const ROD: f64 = DENSITY * LENGTH * EDGE * EDGE;
const SLIDER: f64 = DENSITY * SLIDER_EDGE * SLIDER_EDGE * SLIDER_EDGE;

/// Depth of the slider at the start, m.
const START_DEPTH: f64 = 0.5;

/// Time of comparison, s.
const END_S: f64 = 0.25;

/// Error of depth (m), angle (rad) and angular velocity (rad/s).
const ERROR: f64 = 1e-9;

/// A governor with other springs or another start.
struct Governor {
    stiffness: f64,
    damping: f64,
    rest_length: f64,
    /// Angle of the rods, rad, and angular velocity, rad/s.
    start: (f64, f64),
}

/// Moments of a rod with its ball about its hinge and about itself, kg m^2.
fn moments_of_arm() -> (f64, f64) {
    let across = ROD * (LENGTH * LENGTH + EDGE * EDGE) / 12.0;
    (across + ROD * 0.25 * LENGTH * LENGTH + BALL * LENGTH * LENGTH, ROD * EDGE * EDGE / 6.0)
}

/// Moment of shaft and slider about the axis, kg m^2.
fn moment_of_shaft() -> f64 {
    (ROD * EDGE * EDGE + SLIDER * SLIDER_EDGE * SLIDER_EDGE) / 6.0
}

/// `a`, `a'`, `u`, `u'`.
type Coordinates = [f64; 4];

impl Governor {
    fn moment(angle: f64) -> f64 {
        let (across, along) = moments_of_arm();
        moment_of_shaft() + 2.0 * (across * angle.sin().powi(2) + along * angle.cos().powi(2))
    }

    /// The angular velocity at an angle, rad/s.
    fn spin(&self, angle: f64) -> f64 {
        Self::moment(self.start.0) * self.start.1 / Self::moment(angle)
    }

    fn rates(&self, [angle, swing, depth, speed]: Coordinates) -> Coordinates {
        let (across, along) = moments_of_arm();
        let half = 0.5 * LENGTH;
        let (out, down) = (half * angle.sin(), depth - half * angle.cos());
        let length = out.hypot(down);
        let by_angle = (out * half * angle.cos() + down * half * angle.sin()) / length;
        let by_depth = down / length;
        let force = self.stiffness * (length - self.rest_length) + self.damping * (by_angle * swing + by_depth * speed);
        let spin = self.spin(angle);
        let flung = 2.0 * (across - along) * angle.sin() * angle.cos() * spin * spin;
        let weight = 2.0 * (0.5 * ROD + BALL) * LENGTH * GRAVITY * angle.sin();
        let swinging = (flung - weight - 2.0 * force * by_angle) / (2.0 * across);
        [swing, swinging, speed, GRAVITY - 2.0 * force * by_depth / SLIDER]
    }

    /// The coordinates at a time (s), by so many steps.
    fn at(&self, t: f64, steps: u32) -> Coordinates {
        let h = t / f64::from(steps);
        let moved = |from: Coordinates, by: Coordinates, factor: f64| -> Coordinates {
            std::array::from_fn(|i| from[i] + factor * by[i])
        };
        let mut now = [self.start.0, 0.0, START_DEPTH, 0.0];
        for _ in 0..steps {
            let first = self.rates(now);
            let second = self.rates(moved(now, first, 0.5 * h));
            let third = self.rates(moved(now, second, 0.5 * h));
            let last = self.rates(moved(now, third, h));
            now = std::array::from_fn(|i| now[i] + h / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + last[i]));
        }
        now
    }

    /// The scene: its head is the origin.
    fn scene(&self) -> super::Result<Scene> {
        let (angle, spin) = self.start;
        let turning = |place: DVec3| Velocity::new(DVec3::Z.cross(place) * spin, DVec3::Z * spin);
        let matter = |mass: f64, diagonal: DVec3| -> super::Result<MassProperties> {
            Ok(MassProperties::new(Mass::new(mass)?, DVec3::ZERO, Inertia::from_diagonal(diagonal)?))
        };
        let mut builder = scene("governor").duration_s(END_S).output_interval_s(END_S);
        let across = ROD * (LENGTH * LENGTH + EDGE * EDGE) / 12.0;
        let shaft = matter(ROD, DVec3::new(across, across, ROD * EDGE * EDGE / 6.0))?;
        let middle = DVec3::Z * (-0.5 * LENGTH);
        let shaft = builder
            .add_body(Body::movable("shaft", shaft).pose(Pose::from_translation(middle)).velocity(turning(middle)));
        let slider = matter(SLIDER, DVec3::splat(SLIDER * SLIDER_EDGE * SLIDER_EDGE / 6.0))?;
        let place = DVec3::Z * -START_DEPTH;
        let slider = builder
            .add_body(Body::movable("slider", slider).pose(Pose::from_translation(place)).velocity(turning(place)));
        builder = builder
            .joint(Joint::hinge(shaft, DVec3::ZERO, UnitVector::Z))
            .joint(Joint::new(JointKind::Slider { axis: UnitVector::Z }, slider, place).with(shaft));
        for (name, side) in [("left", -1.0), ("right", 1.0)] {
            // Rod and ball are one body, whose origin is their centre of mass and whose z axis points up along the rod.
            let (about_hinge, about_itself) = moments_of_arm();
            let mass = ROD + BALL;
            let centre = (0.5 * ROD + BALL) * LENGTH / mass;
            let across = about_hinge - mass * centre * centre;
            let rotation = Rotation::from_rotation_vector(DVec3::Y * (-side * angle));
            let place = rotation.rotate(DVec3::Z * -centre);
            let arm = Body::movable(name, matter(mass, DVec3::new(across, across, about_itself))?);
            let arm = builder.add_body(arm.pose(Pose::new(rotation, place)).velocity(turning(place)));
            builder = builder.joint(Joint::hinge(arm, DVec3::ZERO, UnitVector::Y).with(shaft));
            builder = builder.force(self.spring(arm, centre - 0.5 * LENGTH, slider));
        }
        Ok(builder.build()?)
    }

    fn spring(&self, arm: BodyId, above_centre: f64, slider: BodyId) -> Force {
        Force::Spring {
            a: Attachment::Body { body: arm, point: DVec3::Z * above_centre },
            b: Attachment::Body { body: slider, point: DVec3::ZERO },
            stiffness: self.stiffness,
            rest_length: self.rest_length,
            damping: self.damping,
        }
    }
}

/// The governor as published, and one with softer springs.
pub(crate) fn iftomm_a05(_: &Context) -> CaseResult {
    let angle = std::f64::consts::FRAC_PI_6;
    let spin = std::f64::consts::TAU;
    let mut rows = Vec::new();
    let governors = [
        ("as published", Governor { stiffness: 8e5, damping: 4e4, rest_length: 0.5, start: (angle, spin) }),
        ("soft", Governor { stiffness: 2e3, damping: 30.0, rest_length: 0.3, start: (0.7, 9.0) }),
    ];
    for (name, governor) in governors {
        let scene = governor.scene()?;
        let expected = governor.at(END_S, 100_000);
        let bodies = bodies_at(&scene, END_S)?;
        let arm = bodies[3].pose.rotation.rotate(DVec3::Z);
        let row = |what: &str, expected: f64, found: f64| {
            Row::compared(CASE, &format!("{name}: {what}"), expected, found, Tolerance::Absolute(ERROR))
        };
        rows.push(row("depth of the slider, m", expected[2], -bodies[1].pose.translation.z));
        rows.push(row("angle of the rods, rad", expected[0], arm.x.hypot(arm.y).atan2(arm.z)));
        rows.push(row("angular velocity, rad/s", governor.spin(expected[0]), bodies[0].velocity.angular.z));
        if name == "soft" {
            rows.extend(rows_of_energy(CASE, &run(&scene)?.report));
        }
    }
    Ok(rows)
}
