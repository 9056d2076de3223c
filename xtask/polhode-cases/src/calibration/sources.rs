//! All scenes whose motion is known, in the order of their sources.

use super::known::{Known, Place, Truth};
use super::setting::ALL_TIERS;
use super::{by_runs, closed, mechanisms, published};
use std::path::Path;

/// The number of the body that moves in a closed form.
const BODY: usize = 1;

/// All of them, of the workspace in this folder; random ones are those of a draw, the first of which is 0.
pub fn all(root: &Path, draw: u64) -> Vec<Known> {
    let mut all = closed_forms(draw);
    let made = [
        ("throws", published::throws(draw)),
        ("slopes", published::slopes(draw)),
        ("shots", published::shots(draw)),
        ("rotations", published::rotations(root)),
        ("tops", mechanisms::tops(draw)),
        ("joints", mechanisms::pendulums()),
        ("joints", mechanisms::chains()),
        ("impacts", published::impacts(draw)),
        ("seams", published::over_seams()),
        ("still", published::standing(draw)),
    ];
    for (source, made) in made {
        all.extend(made.unwrap_or_else(|error| vec![Known::failed(source, error.to_string())]));
    }
    all.extend(by_runs::all(root, draw));
    all
}

/// Scenes of contact and friction in closed form.
fn closed_forms(draw: u64) -> Vec<Known> {
    let known = |form: closed::ClosedForm| {
        let closed::ClosedForm { name, text, position, .. } = form;
        let origin = name.clone();
        Known {
            name: format!("closed form/{name}"),
            scene: Box::new(move || Ok(polhode_scene::load_text(&origin, &text, &[])?.scene)),
            truth: Truth::Motion(Box::new(move |t| vec![Place::at(BODY, position(t))])),
            tiers: ALL_TIERS.to_vec(),
            step_s: None,
        }
    };
    closed::corpus(draw).into_iter().map(known).collect()
}
