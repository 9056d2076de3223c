//! The tangential force of a face that sticks, shared among its contacts by the pressure on each.
//!
//! Assumption: one normal, and a force without a moment about the centre of pressure; other faces keep their forces.

use crate::collision::touch::Touch;
use polhode_spatial::DVec3;
use std::ops::Range;

/// A moment of tangential forces about the centre of pressure counts as none below this part of what they could have
/// (no unit, 1e-12 to 1e-6).
const NO_MOMENT: f64 = 1e-9;

/// Normals whose components differ by less count as equal (no unit, 1e-14 to 1e-9): the rounding of attitudes.
const SHARED_NORMAL: f64 = 1e-10;

/// A contact that sticks, with its rows along tangents among the forces.
#[derive(Debug)]
pub(super) struct StickingContact {
    pub(super) contact: usize,
    pub(super) rows: Range<usize>,
    pub(super) tangents: Vec<DVec3>,
}

/// Shares the tangential force of each pair of bodies among its contacts in proportion to their normal forces, where
/// they have one normal and the force has no moment about the centre of pressure: least forces are shared evenly, and
/// would leave the cones of contacts with small normal forces although those of all contacts together can bear the
/// force.
pub(super) fn share_by_pressure(contacts: &[Touch], sticking: &[StickingContact], forces: &mut [f64]) {
    let pair = |one: &StickingContact| (contacts[one.contact].id.a, contacts[one.contact].id.b);
    for of_pair in sticking.chunk_by(|x, y| pair(x) == pair(y)) {
        let geometry = |one: &StickingContact| &contacts[one.contact].kinematics.geometry;
        let Some(n) = of_pair.first().map(|first| geometry(first).normal) else { continue };
        let pressure: f64 = of_pair.iter().map(|one| forces[one.contact]).sum();
        let is_flush = |one: &StickingContact| {
            forces[one.contact] >= 0.0 && (geometry(one).normal - n).abs().max_element() <= SHARED_NORMAL
        };
        if of_pair.len() < 2 || pressure <= 0.0 || !of_pair.iter().all(is_flush) {
            continue;
        }
        let along = |one: &StickingContact, forces: &[f64]| {
            one.tangents.iter().zip(&forces[one.rows.clone()]).map(|(tangent, force)| *tangent * *force).sum::<DVec3>()
        };
        let center = of_pair.iter().map(|one| geometry(one).point * (forces[one.contact] / pressure)).sum::<DVec3>();
        let total: DVec3 = of_pair.iter().map(|one| along(one, forces)).sum();
        let arm = |one: &StickingContact| geometry(one).point - center;
        let moment: f64 = of_pair.iter().map(|one| n.dot(arm(one).cross(along(one, forces)))).sum();
        let largest = of_pair.iter().map(|one| arm(one).length()).fold(0.0, f64::max) * total.length();
        if moment.abs() > NO_MOMENT * largest {
            continue;
        }
        for one in of_pair {
            let own = total * (forces[one.contact] / pressure);
            for (row, tangent) in one.rows.clone().zip(&one.tangents) {
                forces[row] = tangent.dot(own);
            }
        }
    }
}
