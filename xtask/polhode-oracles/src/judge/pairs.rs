//! Separations of all pairs of bodies at every sample.

use super::judged::{Findings, Judged, Track};
use super::piece::{Piece, Placed, pieces};
use super::separation::separation;
use crate::random_scene::model::Body;
use glam::DVec3;
use std::collections::BTreeMap;

/// Depth that counts as none, relative to the reach of the smaller body: ten times what the program promises.
const RELATIVE: f64 = 1e-11;
/// And in units in the last place of the largest coordinate.
const ULPS: f64 = 60.0;

/// The least separation of every pair of bodies, or a lower bound of it, at every sample: `near[sample][(a, b)]` with
/// a < b. Pairs of which neither is moved by forces are left out.
pub(super) type Near = Vec<BTreeMap<(usize, usize), f64>>;

/// Whether two bodies are apart by more than a gap, m.
pub fn are_apart(a: &Body, b: &Body, gap: f64) -> bool {
    let place = |body: &Body| -> Vec<Placed> {
        pieces(&body.form).iter().map(|piece| piece.placed(body.position, body.orientation)).collect()
    };
    let (of_a, of_b) = (place(a), place(b));
    of_a.iter().all(|one| of_b.iter().all(|other| pieces_apart(one, other, gap)))
}

fn pieces_apart(a: &Placed, b: &Placed, gap: f64) -> bool {
    let spheres = (a.center - b.center).length() - a.reach - b.reach;
    spheres > gap || {
        let mut hint = DVec3::Z;
        separation(a, b, 2.0 * gap, &mut hint) > gap
    }
}

/// Holds the depth of every pair at every sample against what counts as none.
pub(super) fn penetration(judged: &Judged<'_>, track: &Track, findings: &mut Findings) -> Near {
    let bodies = &judged.model.bodies;
    let shapes: Vec<Vec<Piece>> = bodies.iter().map(|body| pieces(&body.form)).collect();
    let reaches: Vec<f64> = bodies.iter().map(|body| body.form.reach()).collect();
    let mut hints: BTreeMap<[usize; 4], DVec3> = BTreeMap::new();
    let mut near = Near::new();
    for (&t, states) in track.times.iter().zip(&track.states) {
        let placed: Vec<Vec<Placed>> = shapes
            .iter()
            .zip(states)
            .map(|(shape, state)| shape.iter().map(|p| p.placed(state.position, state.orientation)).collect())
            .collect();
        let mut at = BTreeMap::new();
        for b in 0..bodies.len() {
            for a in 0..b {
                if !bodies[a].is_free() && !bodies[b].is_free() {
                    continue;
                }
                let largest = states[a].position.abs().max(states[b].position.abs()).max_element();
                let smaller = reaches[a].min(reaches[b]);
                let limit = RELATIVE * smaller + ULPS * f64::EPSILON * (largest + smaller);
                let mut least = f64::INFINITY;
                for (i, one) in placed[a].iter().enumerate() {
                    for (j, other) in placed[b].iter().enumerate() {
                        let spheres = (one.center - other.center).length() - one.reach - other.reach;
                        let found = if spheres > 0.0 {
                            spheres
                        } else {
                            separation(one, other, -limit, hints.entry([a, i, b, j]).or_insert(DVec3::Z))
                        };
                        least = least.min(found);
                    }
                }
                at.insert((a, b), least);
                findings.hold("penetration", -least, limit, || {
                    format!(
                        "t = {t} s: {} and {} are {:.3e} m in each other (limit {limit:.1e})",
                        bodies[a].name, bodies[b].name, -least
                    )
                });
            }
        }
        near.push(at);
    }
    near
}
