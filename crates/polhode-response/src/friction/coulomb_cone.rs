//! Coulomb's cone and the law of one contact: projection, the correction of De Saxce, and the natural map.
//!
//! `K = { r : |r_t| <= mu r_n }` holds the reactions, `K* = { u : u_n >= mu |u_t| }` is its dual. With the corrected velocity
//! `u' = u + mu |u_t| n` the whole of Coulomb's law, with Signorini's condition, reads `K* contains u' _|_ r in K`: open
//! (`r = 0`), stick (`u = 0`), slide (`u_n = 0`, `r_t = -mu r_n u_t / |u_t|`). It holds if and only if the natural map
//! `r - P_K(r - rho u')` is zero, for any one `rho > 0`.
//!
//! Sources: De Saxce and Feng 1998 (the correction), Acary, Bremond and Huber 2018 (the natural map for this problem).
//! Symbols: `r` reaction (N, or N s), `u` velocity (m/s^2, or m/s), `mu` coefficient of friction, `rho` (kg).

use crate::friction::block::{FrictionBlock, MOST_ROWS};

/// Rows of a block, filled up with zeros.
pub(crate) type Rows = [f64; MOST_ROWS];

/// The first rows of a slice, filled up with zeros.
pub(crate) fn rows_of(values: &[f64]) -> Rows {
    let mut rows = [0.0; MOST_ROWS];
    for (row, value) in rows.iter_mut().zip(values) {
        *row = *value;
    }
    rows
}

/// Length of the tangential part.
pub(crate) fn tangential_length(x: Rows) -> f64 {
    // A plane contact has one tangent: its length is exact.
    if x[2] == 0.0 { x[1].abs() } else { (x[1] * x[1] + x[2] * x[2]).sqrt() }
}

/// The point of `K` nearest to `x`.
pub(crate) fn project(friction: f64, x: Rows) -> Rows {
    let length = tangential_length(x);
    if length <= friction * x[0] {
        return x;
    }
    if friction * length <= -x[0] {
        return [0.0; MOST_ROWS];
    }
    let normal = (x[0] + friction * length) / (1.0 + friction * friction);
    if normal <= 0.0 {
        return [0.0; MOST_ROWS];
    }
    let scale = if length > 0.0 { friction * normal / length } else { 0.0 };
    [normal, scale * x[1], scale * x[2]]
}

/// `u + mu |u_t| n`.
pub(crate) fn corrected_velocity(friction: f64, u: Rows) -> Rows {
    [u[0] + friction * tangential_length(u), u[1], u[2]]
}

/// Length of the natural map of one block, in units of velocity: `|r - P_K(r - rho u')| / rho`, and `|u|` for rows that are held.
/// For a contact that slides already it is that of its normal, with `r_t + mu r_n` as the tangential part.
/// `inverse_mass` is `1 / rho`.
pub(crate) fn natural_map(block: FrictionBlock, inverse_mass: f64, r: Rows, u: Rows) -> f64 {
    let friction = match block {
        FrictionBlock::Contact { friction, .. } => friction,
        FrictionBlock::Sliding { friction } => {
            let normal = r[0] * inverse_mass - (r[0] * inverse_mass - u[0]).max(0.0);
            let tangential = (r[1] + friction * r[0]) * inverse_mass;
            return (normal * normal + tangential * tangential).sqrt();
        }
        FrictionBlock::Bilateral { .. } => return (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt(),
    };
    let corrected = corrected_velocity(friction, u);
    // Everything is multiplied by the inverse mass: no division, and no trouble where it is tiny.
    let scaled = r.map(|value| value * inverse_mass);
    let projected = project(friction, std::array::from_fn(|k| scaled[k] - corrected[k]));
    (0..MOST_ROWS).map(|k| (scaled[k] - projected[k]) * (scaled[k] - projected[k])).sum::<f64>().sqrt()
}
