//! A scene and its copies: how far apart their samples are, and how far they may be.

use polhode_oracles::judge::{State, Track};
use polhode_oracles::random_scene::copies::SceneCopy;
use polhode_oracles::random_scene::model::Model;

/// By this part of themselves the velocities at the start of the disturbed run differ.
pub(super) const DISTURBED: f64 = 1e-11;
/// How many times the disturbance a copy may differ by, as it grows.
const TIMES: f64 = 300.0;
/// Difference that is allowed in any case, relative to the size of a body: the steps are made to a tolerance of 1e-11.
const FLOOR: f64 = 1e-8;
/// The same in runs with stretches of crowded events, in which errors of 1e-6 are allowed and told.
const CROWDED_FLOOR: f64 = 1e-4;
/// Once the disturbance has grown to this part of the size of a body, nothing more is compared.
const HORIZON: f64 = 1e-6;

/// The distance of the states of one body, relative to its size.
fn distance(size: f64, a: &State, b: &State) -> f64 {
    if a.position == b.position && a.orientation == b.orientation {
        return 0.0;
    }
    let turned = (a.orientation.inverse() * b.orientation).normalize();
    let angle = 2.0 * libm::hypot(libm::hypot(turned.x, turned.y), turned.z);
    (a.position - b.position).length() / size + angle
}

/// For every sample the largest difference of any body moved by forces, so far.
pub(super) fn differences(model: &Model, copy: SceneCopy, original: &Track, other: &Track) -> Vec<f64> {
    let mut most = 0.0f64;
    let rows = original.states.iter().zip(&other.states);
    rows.map(|(before, after)| {
        for (body, (a, b)) in model.bodies.iter().zip(before.iter().zip(after)).filter(|(body, _)| body.is_free()) {
            let expected =
                State { position: copy.point(a.position), orientation: copy.orientation(a.orientation), ..*a };
            let apart = distance(body.form.reach() * copy.length(), &expected, b);
            most = if apart <= most { most } else { apart };
        }
        most
    })
    .collect()
}

/// The first sample at which a copy is farther from the original than its disturbed run lets rounding grow, and by how
/// much.
pub(super) fn departure(found: &[f64], disturbed: &[f64], is_crowded: bool) -> Option<(usize, f64)> {
    let floor = if is_crowded { CROWDED_FLOOR } else { FLOOR };
    let compared = found.iter().zip(disturbed).take_while(|(_, grown)| **grown < HORIZON);
    compared
        .enumerate()
        .find(|(_, (found, grown))| **found > floor + TIMES * **grown)
        .map(|(sample, (found, _))| (sample, *found))
}
