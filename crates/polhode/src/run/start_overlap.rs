//! Bodies that overlap at the start: all of them named in one error, or moved apart when the scene allows it. Starts of
//! all tiers are judged here, and by `polhode check` with them.
//!
//! A scene that another program has exported in few digits has bodies that overlap by its rounding, far more than
//! counts as touch. With `Scene::start_separation_m` > 0 overlaps up to that depth are removed before anything else, by
//! the smallest displacement in the mass metric (`solve::overlap`): velocities stay, and the energy of the start is
//! that of the separated bodies. Deeper overlaps are refused.

use crate::collision::boxes::Boxes;
use crate::collision::contact_set;
use crate::error::SimulationError;
use crate::model::{INITIAL_OVERLAP_RELATIVE, Model, tolerances};
use crate::scene::few_digits::length;
use crate::scene::{OverlapAtStart, SceneError};
use crate::solve::overlap::Overlaps;
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_response::Memory;
use polhode_spatial::Still;

/// Refuses a start at which bodies overlap by more than counts as touch. Those that overlap by at most the scene's
/// `start_separation_m` are moved apart; what to report of it, if any were moved.
///
/// # Errors
/// When bodies overlap by more, or cannot be separated by as little.
pub(crate) fn judge(
    model: &Model,
    settings: &Settings,
    states: &mut [BodyState],
) -> Result<Option<String>, SimulationError> {
    let limit_m = model.scene.start_separation_m;
    let found = overlaps(model, settings, states)?;
    let Some(deepest) = found.iter().max_by(|x, y| x.depth_m.total_cmp(&y.depth_m)) else { return Ok(None) };
    if deepest.depth_m > limit_m {
        return Err(SceneError::InitialOverlap(found).into());
    }
    let (count, depth_m) = (found.len(), deepest.depth_m);
    let moved_m = move_apart(model, settings, (0.0, states))?;
    let left = overlaps(model, settings, states)?;
    if !left.is_empty() {
        return Err(SceneError::InitialOverlap(left).into());
    }
    let what = format!(
        "{count} pairs of bodies overlapped by up to {} at the start, which start.separate = {limit_m:e} m allows: \
         they were moved apart, by at most {}",
        length(depth_m),
        length(moved_m)
    );
    Ok(Some(what))
}

/// Moves bodies apart that overlap at `t` (s). Returns by how much at most, m.
///
/// # Errors
/// When they cannot be separated.
pub(super) fn move_apart(
    model: &Model,
    settings: &Settings,
    (t, states): (f64, &mut [BodyState]),
) -> Result<f64, SimulationError> {
    let movable: Vec<usize> = (0..states.len()).filter(|&body| model.bodies[body].moves()).collect();
    let pairs = near_pairs(model, settings, states)?;
    let solvers = &mut Memory::default();
    let removed = Overlaps::find(model, states, &pairs).remove(model, states, (&movable, &pairs), solvers);
    removed.map(|removed| removed.moved_m).map_err(|source| SimulationError::of_response(t, source))
}

/// Pairs that overlap by more than counts as touch, in the order of the scene.
fn overlaps(model: &Model, settings: &Settings, states: &[BodyState]) -> Result<Vec<OverlapAtStart>, SimulationError> {
    let mut found = Vec::new();
    for (a, b) in near_pairs(model, settings, states)? {
        let Some(separation) = contact_set::separation_without_memory(model, states, a, b) else { continue };
        let allowed_m =
            INITIAL_OVERLAP_RELATIVE * tolerances::pair_size(model, a, b) + tolerances::rounding(model, states, a, b);
        if separation < -allowed_m {
            let touch_distance = tolerances::touch_distance(model, states, a, b);
            let contacts = contact_set::contacts_of_pair(model, states, a, b, touch_distance);
            let deepest = contacts.iter().fold(separation, |s, touch| s.min(touch.kinematics.geometry.separation));
            let [body_a, body_b] = [a, b].map(|body| model.bodies[body].name.clone());
            found.push(OverlapAtStart { body_a, body_b, depth_m: -deepest, allowed_m });
        }
    }
    Ok(found)
}

/// Pairs whose boxes, enlarged by the touch distance, overlap.
fn near_pairs(
    model: &Model,
    settings: &Settings,
    states: &[BodyState],
) -> Result<Vec<(usize, usize)>, SimulationError> {
    let mut boxes = Boxes::new(settings.broad_phase, states.len());
    for (body, state) in states.iter().enumerate() {
        boxes.set(model, body, &Still(state.pose), (0.0, 0.0), tolerances::touch_distance(model, states, body, body));
    }
    let mut pairs = Vec::new();
    boxes.all_pairs(model, |a, b| pairs.push((a, b)))?;
    Ok(pairs)
}
