//! Closed forms of scenes that were reported as wrong.

use super::known::{Motion, Place};
use crate::cases::bodies::GRAVITY;
use glam::DVec3;
use polhode::Scene;
use polhode::spatial::Pose;

/// What the body of a scene does; it does not turn.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Answer {
    /// It keeps its velocity.
    KeepsOn,
    /// It falls freely.
    Falls,
    /// It falls freely until its origin is at this height (m), and rests.
    FallsTo(f64),
}

/// The scenes.
const ANSWERS: [(&str, Answer); 8] = [
    ("seam-ball", Answer::KeepsOn),
    ("seam-ball-e1", Answer::KeepsOn),
    ("seam-cone", Answer::KeepsOn),
    ("seam-puck", Answer::KeepsOn),
    ("seam-wheel", Answer::KeepsOn),
    ("wall-ball-beside", Answer::Falls),
    ("wall-box-beside", Answer::Falls),
    // What a force of 100 N moves 1 kg at 1 GHz, 16 nm each second, is added to the fall.
    ("sigfast", Answer::FallsTo(0.5)),
];
/// Mean velocity of a body of 1 kg under a force of 100 N sin(2 pi t 1 GHz), m/s.
const DRIFT_M_S: f64 = 100.0 / (std::f64::consts::TAU * GIGA);
const GIGA: f64 = 1e9;

/// The motion of the last body of a scene of this name; none where it is not known.
pub(super) fn motion(name: &str, scene: &Scene) -> Option<Motion> {
    let (_, answer) = *ANSWERS.iter().find(|(known, _)| *known == name)?;
    let number = scene.bodies().len().checked_sub(1)?;
    let body = &scene.bodies()[number];
    let (start, velocity) = (*body.initial_pose(), body.initial_velocity().linear);
    Some(Box::new(move |t| {
        let fallen = DVec3::Z * (-0.5 * GRAVITY * t * t);
        let mut place = start.translation + velocity * t;
        match answer {
            Answer::KeepsOn => {}
            Answer::Falls => place += fallen,
            Answer::FallsTo(height) => {
                place += fallen + DVec3::Z * (DRIFT_M_S * t);
                place.z = place.z.max(height);
            }
        }
        vec![Place::pose(number, Pose::new(start.rotation, place))]
    }))
}
