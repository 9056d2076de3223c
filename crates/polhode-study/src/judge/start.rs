//! Units and orders of quaternions that are not those of the scene, told by the first sample.
//!
//! A trajectory that begins with the scene has its bodies where the scene has them. Where it does not, and would if its
//! lengths were millimetres or its quaternions had the scalar last, that is what is wrong.

use super::error::JudgeError;
use super::given::Given;
use polhode::Scene;
use polhode::spatial::Rotation;

/// Units of length that are mistaken for metres: how many there are in one.
const UNITS: [(&str, f64); 3] = [("millimetres", 1000.0), ("centimetres", 100.0), ("inches", 1.0 / 0.0254)];

/// How near a first sample must come to the start of the scene to be told as its, relative to the largest distance (no
/// unit, 1e-3 to 0.05): files have few digits.
const ALIKE: f64 = 0.01;

/// Refuses what is written in other units.
///
/// # Errors
/// What it is, and what is accepted.
pub(super) fn check(given: &Given, scene: &Scene) -> Result<(), JudgeError> {
    let refused = |what: String| Err(JudgeError::Units { path: given.name.clone(), what });
    let starts = scene.bodies().iter().zip(&given.samples[0]).filter(|(body, _)| !body.is_fixed());
    let pairs: Vec<_> = starts.map(|(body, sample)| (body.name(), *body.initial_pose(), sample.pose)).collect();
    let largest = pairs.iter().map(|(_, start, _)| start.translation.length()).fold(0.0, f64::max);
    let fits = |factor: f64| {
        pairs
            .iter()
            .all(|(_, start, own)| (own.translation - start.translation * factor).length() <= ALIKE * largest * factor)
    };
    if largest > 0.0 && !fits(1.0) {
        for (unit, factor) in UNITS {
            if fits(factor) {
                let far = |own: &&(&str, polhode::spatial::Pose, polhode::spatial::Pose)| own.1.translation.length();
                let (name, start, own) = pairs.iter().max_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(&pairs[0]);
                let [own, start] = [own, start].map(|pose| pose.translation.to_array());
                return refused(format!(
                    "lengths look like {unit}: body `{name}` begins at {own:?}, and the scene has it at {start:?} m; \
                     metres, seconds and radians are accepted: divide lengths and velocities by {factor}"
                ));
            }
        }
    }
    let apart = |of: &dyn Fn(Rotation) -> Option<Rotation>| {
        let angles = pairs
            .iter()
            .map(|(_, start, own)| of(own.rotation).map_or(f64::INFINITY, |own| own.angle_to(start.rotation)));
        angles.fold(0.0, f64::max)
    };
    let scalar_last = |own: Rotation| {
        let [x, y, z, w] = own.to_wxyz();
        Rotation::from_wxyz([w, x, y, z]).ok()
    };
    if apart(&|own| Some(own)) > ALIKE && apart(&scalar_last) <= ALIKE {
        return refused(
            "quaternions look as if the scalar came last (x, y, z, w): bodies do not begin as the scene has them, and \
             would in that order; qw, qx, qy, qz are accepted, scalar first"
                .to_owned(),
        );
    }
    Ok(())
}
