//! Rows of the contacts of one pair of bodies that are made consistent with each other, by the terms of
//! `rigid_terms.rs`.

use super::rigid_terms::{Term, make_rigid, make_tangential_terms_rigid};
use super::row::Row;
use polhode_contact::ContactKinematics;
use polhode_spatial::DVec3;

/// Normals whose components differ by less count as equal (no unit, 1e-14 to 1e-9): the rounding of attitudes.
const FLUSH_NORMAL: f64 = 1e-12;

/// Contacts of a pair whose normals differ by less are one patch where many bodies lie on each other (no unit, 1e-3 to
/// 3e-2): faces that lean a little on each other press at several points, whose rows would contradict each other.
const NEARLY_FLUSH_NORMAL: f64 = 1e-2;

/// The normals of the contacts of a pair whose terms are to be those of a rigid motion, at most so far from the first
/// one (no unit); none where there is nothing to contradict, or a contact without friction.
fn flush_normals(of_pair: &[Row], most: f64) -> Option<Vec<DVec3>> {
    let normals: Vec<DVec3> = of_pair.iter().map(|row| row.kinematics.geometry.normal).collect();
    let first = *normals.first()?;
    let apart = normals.iter().map(|n| (*n - first).abs().max_element()).fold(0.0, f64::max);
    let is_plane = first != DVec3::ZERO && of_pair.iter().all(|row| row.friction.is_some());
    let is_flush = apart <= most && normals.len() > 1 && is_plane;
    is_flush.then_some(normals)
}

/// Makes the terms of the contacts with friction of a pair, one of many, consistent: contacts whose normals are nearly
/// the same become those of one patch, with one pair of tangents, and their rows along these act in one plane.
pub(super) fn make_consistent(of_pair: &mut [Row]) {
    let is_isotropic = |row: &Row| row.friction.is_none_or(|friction| friction.is_isotropic());
    if flush_normals(of_pair, FLUSH_NORMAL).is_some() && !of_pair.iter().all(is_isotropic) {
        return remove_contradictions(of_pair);
    }
    let normals = flush_normals(of_pair, NEARLY_FLUSH_NORMAL).filter(|_| of_pair.iter().all(is_isotropic));
    let Some(normals) = normals else {
        let Some(normals) = flush_normals(of_pair, f64::INFINITY) else { return };
        let presses = |row: &Row| row.kinematics.separation_rate + row.bound <= 0.0;
        let contacts: Vec<(DVec3, bool)> = normals.into_iter().zip(of_pair.iter().map(presses)).collect();
        return with_terms(of_pair, |terms| make_tangential_terms_rigid(&contacts, terms));
    };
    let n = normals.iter().sum::<DVec3>().normalize();
    let points = of_pair.iter().map(|row| row.kinematics.geometry.point);
    let centre = points.sum::<DVec3>() / normals.len() as f64;
    let Some(tangents) = of_pair.iter().find_map(|row| Some(row.friction?.tangents_of_patch(n))) else { return };
    for row in of_pair.iter_mut() {
        let ContactKinematics { geometry, separation_rate, .. } = row.kinematics;
        let point = geometry.point - n * n.dot(geometry.point - centre);
        let approach = geometry.normal * separation_rate;
        row.friction = row.friction.map(|friction| friction.on_patch(tangents, point, approach));
    }
    with_terms(of_pair, |terms| make_rigid(n, terms));
}

/// Makes the terms of the contacts with friction of a pair those of a rigid motion, where their normals are the same.
pub(super) fn remove_contradictions(of_pair: &mut [Row]) {
    if let Some(normals) = flush_normals(of_pair, FLUSH_NORMAL) {
        with_terms(of_pair, |terms| make_rigid(normals[0], terms));
    }
}

/// Changes the terms of the contacts of a pair, as far as that gains no energy.
fn with_terms(of_pair: &mut [Row], change: impl FnOnce(&mut [Term])) {
    let term = |row: &Row| Term {
        point: row.kinematics.geometry.point,
        normal: row.bound,
        tangential: row.friction.map_or(DVec3::ZERO, |friction| friction.half_change()),
    };
    let mut terms: Vec<Term> = of_pair.iter().map(term).collect();
    change(&mut terms);
    for (row, term) in of_pair.iter_mut().zip(&terms) {
        row.bound = term.normal.max(row.least_bound);
        row.friction = row.friction.map(|friction| friction.with_half_change(term.tangential));
    }
    let share = of_pair.iter().filter_map(|row| Some(row.friction?.share())).fold(1.0, f64::min);
    for (row, term) in of_pair.iter_mut().zip(&terms) {
        row.friction = row.friction.map(|friction| friction.with_half_change(term.tangential * share));
    }
}
