//! Terms of the contacts of one pair of bodies that do not contradict each other.
//!
//! The contacts of two flush faces are redundant: sticking at all of them asks for the same rigid motion several times.
//! The terms `r` of the rows (`sustained.rs`, `sustained_friction.rs`), read as velocities of the contact points,
//! differ from those of a rigid motion by a part of order `h w^2 d` (`w` angular velocity, `d` distance of the
//! contacts), so that the rows contradict each other a little.
//! Coulomb's law then has a solution only in which some corners slip or part by that little, with forces at the edge of
//! their cones. Here `r` is replaced by that of the nearest rigid motion: with the mean normal `n`, the distances `d_i`
//! of the points from their mean and `r_i` (m/s),
//!
//! `r_i' = m + w x d_i`,  `m = mean r_i`,  `w_n = sum n.(d_i x r_i) / sum |d_i|^2`, `w_T` by least squares of `n.r_i`.
//!
//! Along the normal this is done only where the contradiction is small ([`SMALL`]): separations that differ are no
//! contradiction. Its error is of the order of what it removes; it leaves a penetration that the projection removes.

use polhode_spatial::{DMat3, DVec3};

/// What contradicting normal terms may differ by, as a fraction of the largest of them (no unit, 1e-6 to 1e-3).
const SMALL: f64 = 1e-4;

/// Points whose spread in a direction is below this fraction of that in the other determine no turn about it (no unit).
const IN_LINE: f64 = 1e-12;

/// The weight of normal terms of contacts that press, against those along tangents, in the nearest rigid motion; its
/// inverse is that of the others (no unit, 1e5 to 1e7).
const PRESSING: f64 = 1e6;

/// What is added to the moments of the points about each axis, relative to all (no unit): points in a line, or one
/// alone, determine no turn about it.
const NO_TURN: f64 = 1e-12;

/// A contact: its point (m) and its term `r` along the normal and in the tangent plane, m/s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Term {
    pub(super) point: DVec3,
    pub(super) normal: f64,
    pub(super) tangential: DVec3,
}

/// Replaces the terms of the contacts of a pair, with a common normal `n` (unit vector), by those of the nearest rigid
/// motion.
pub(super) fn make_rigid(n: DVec3, terms: &mut [Term]) {
    let count = terms.len() as f64;
    let centre = terms.iter().map(|term| term.point).sum::<DVec3>() / count;
    let flat = |point: DVec3| {
        let distance = point - centre;
        distance - n * n.dot(distance)
    };
    let mean = terms.iter().map(|term| term.tangential).sum::<DVec3>() / count;
    let squares: f64 = terms.iter().map(|term| flat(term.point).length_squared()).sum();
    let turn: f64 = terms.iter().map(|term| n.dot(flat(term.point).cross(term.tangential))).sum();
    let turn = if squares > 0.0 { turn / squares } else { 0.0 };
    for term in terms.iter_mut() {
        term.tangential = mean + n.cross(flat(term.point)) * turn;
    }
    let Some((middle, slope)) = nearest_plane(n, terms, flat) else { return };
    let fitted: Vec<f64> = terms.iter().map(|term| middle + slope.dot(flat(term.point))).collect();
    let largest = terms.iter().fold(0.0, |most: f64, term| most.max(term.normal.abs()));
    let apart = terms.iter().zip(&fitted).fold(0.0, |most: f64, (term, fit)| most.max((term.normal - fit).abs()));
    if apart <= SMALL * largest {
        for (term, fit) in terms.iter_mut().zip(fitted) {
            term.normal = fit;
        }
    }
}

/// Replaces the terms along the tangents of the contacts of a pair, whose normals may be any, by those of the rigid
/// motion that is nearest to them among those with the normal terms of contacts that press.
pub(super) fn make_tangential_terms_rigid(contacts: &[(DVec3, bool)], terms: &mut [Term]) {
    let centre = terms.iter().map(|term| term.point).sum::<DVec3>() / terms.len() as f64;
    let [mut vv, mut vw, mut ww] = [DMat3::ZERO; 3];
    let (mut v, mut w) = (DVec3::ZERO, DVec3::ZERO);
    for (term, (n, presses)) in terms.iter().zip(contacts) {
        let d = term.point - centre;
        // d x, as a matrix: n.(turn x d) = turn.(d x n).
        let cross = DMat3::from_cols(d.cross(DVec3::X), d.cross(DVec3::Y), d.cross(DVec3::Z));
        let weight = if *presses { PRESSING } else { 1.0 / PRESSING };
        let along = DMat3::from_cols(*n * n.x, *n * n.y, *n * n.z);
        let weights = DMat3::IDENTITY + along * (weight - 1.0);
        let wanted = weights * (*n * term.normal + term.tangential);
        vv += weights;
        vw += weights * cross.transpose();
        ww += cross * weights * cross.transpose();
        v += wanted;
        w += cross * wanted;
    }
    let trace = ww.col(0).x + ww.col(1).y + ww.col(2).z;
    let inverse = vv.inverse();
    let left = ww - vw.transpose() * inverse * vw + DMat3::from_diagonal(DVec3::splat(NO_TURN * trace));
    let turn = left.inverse() * (w - vw.transpose() * (inverse * v));
    let mean = inverse * (v - vw * turn);
    if !(turn.is_finite() && mean.is_finite()) {
        return;
    }
    for (term, (n, _)) in terms.iter_mut().zip(contacts) {
        let rigid = mean + turn.cross(term.point - centre);
        term.tangential = rigid - *n * n.dot(rigid);
    }
}

/// Mean and gradient of the linear function of places in the plane that is nearest to the normal terms; none for points
/// in a line.
fn nearest_plane(n: DVec3, terms: &[Term], flat: impl Fn(DVec3) -> DVec3) -> Option<(f64, DVec3)> {
    let x = n.any_orthonormal_vector();
    let y = n.cross(x);
    let mean = terms.iter().map(|term| term.normal).sum::<f64>() / terms.len() as f64;
    let (mut xx, mut xy, mut yy, mut xr, mut yr) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for term in terms {
        let place = flat(term.point);
        let ([px, py], r) = ([x.dot(place), y.dot(place)], term.normal - mean);
        (xx, xy, yy) = (xx + px * px, xy + px * py, yy + py * py);
        (xr, yr) = (xr + px * r, yr + py * r);
    }
    let determinant = xx * yy - xy * xy;
    if determinant <= IN_LINE * (xx + yy) * (xx + yy) || !determinant.is_finite() {
        return None;
    }
    let slope = (x * (yy * xr - xy * yr) + y * (xx * yr - xy * xr)) / determinant;
    Some((mean, slope))
}
