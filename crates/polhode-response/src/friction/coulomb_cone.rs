//! Coulomb's cone and the law of one contact: projection, the correction of De Saxce, and the natural map.
//!
//! `K = { r : |r_t| <= mu r_n }` holds the reactions, `K* = { u : u_n >= mu |u_t| }` is its dual. With the corrected
//! velocity `u' = u + mu |u_t| n` the whole of Coulomb's law, with Signorini's condition, reads
//! `K* contains u' _|_ r in K`: open (`r = 0`), stick (`u = 0`), slide (`u_n = 0`, `r_t = -mu r_n u_t / |u_t|`). It
//! holds if and only if the natural map `r - P_K(r - rho u')` is zero, for any one `rho > 0`.
//!
//! Sources: De Saxce and Feng 1998 (the correction), Acary, Bremond and Huber 2018 (the natural map for this problem).
//! Symbols: `r` reaction (N, or N s), `u` velocity (m/s^2, or m/s), `mu` coefficient of friction, `rho` (kg).

use crate::law::{CONTACT_ROWS, Law, MOST_ROWS, Resistance};
use std::ops::Range;

/// Rows of a contact that resists its slip alone, filled up with zeros.
pub(crate) type Rows = [f64; CONTACT_ROWS];

/// Rows of a block, filled up with zeros.
pub(crate) type BlockRows = [f64; MOST_ROWS];

/// The first rows of a slice, filled up with zeros.
pub(crate) fn rows_of(values: &[f64]) -> Rows {
    filled_up(values)
}

/// The first rows of a slice, filled up with zeros.
pub(crate) fn filled_up<const N: usize>(values: &[f64]) -> [f64; N] {
    let mut rows = [0.0; N];
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
    if x[0] >= 0.0 && length <= friction * x[0] {
        return x;
    }
    if friction * length <= -x[0] {
        return [0.0; CONTACT_ROWS];
    }
    let normal = (x[0] + friction * length) / (1.0 + friction * friction);
    if normal <= 0.0 {
        return [0.0; CONTACT_ROWS];
    }
    let scale = if length > 0.0 { friction * normal / length } else { 0.0 };
    [normal, scale * x[1], scale * x[2]]
}

/// `u + mu |u_t| n`.
pub(crate) fn corrected_velocity(friction: f64, u: Rows) -> Rows {
    [u[0] + friction * tangential_length(u), u[1], u[2]]
}

/// Takes what is beyond the disc of each part out of the reaction of a contact.
pub(crate) fn put_parts_into_discs(block: Law, r: &mut [f64]) {
    let normal = r.first().map_or(0.0, |normal| normal.max(0.0));
    if let Some(first) = r.first_mut() {
        *first = normal;
    }
    for (rows, resists) in block.parts() {
        let (own, most) = (&mut r[rows], resists.friction * normal);
        let size = own.iter().map(|r| r * r).sum::<f64>().sqrt();
        if resists.slides {
            own.fill(-most);
        } else if size > most {
            for r in own {
                *r *= most / size;
            }
        }
    }
}

/// Length of the natural map of one block, in units of velocity: `|r - P_K(r - rho u')| / rho`, and `|u|` for rows that
/// are held. For a contact that slides already it is that of its normal, with `r_t + mu r_n` as the tangential part;
/// rotations that are resisted add `|r_i - P(r_i - rho u_i)| / rho`, with `P` the projection onto the disc
/// `|r_i| <= mu_i r_n`. `inverse_mass` is `1 / rho`; `r` and `u` are all rows of the block.
pub(crate) fn natural_map(block: Law, inverse_mass: f64, r: &[f64], u: &[f64]) -> f64 {
    match block {
        Law::Push => map_of_slip(0.0, inverse_mass, rows_of(r), rows_of(u)),
        Law::Cone { friction, .. } => map_of_slip(friction, inverse_mass, rows_of(r), rows_of(u)),
        Law::Slide { friction } => map_of_sliding(friction, inverse_mass, rows_of(r), rows_of(u)),
        Law::Hold { .. } => {
            let u = rows_of(u);
            (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt()
        }
        Law::Resist { .. } => {
            let [(slip, resists), turns @ ..] = block.parts();
            let (own_r, own_u) = (rows_of(&r[..slip.end]), rows_of(&u[..slip.end]));
            let of_slip = if resists.slides {
                map_of_sliding(resists.friction, inverse_mass, own_r, own_u)
            } else {
                map_of_slip(resists.friction, inverse_mass, own_r, own_u)
            };
            let squares = turns.into_iter().map(|(rows, resists)| square_of_turn(&rows, resists, inverse_mass, (r, u)));
            squares.fold(of_slip * of_slip, |sum, square| sum + square).sqrt()
        }
    }
}

fn map_of_slip(friction: f64, inverse_mass: f64, r: Rows, u: Rows) -> f64 {
    let corrected = corrected_velocity(friction, u);
    // Everything is multiplied by the inverse mass: no division, and no trouble where it is tiny.
    let scaled = r.map(|value| value * inverse_mass);
    let projected = project(friction, std::array::from_fn(|k| scaled[k] - corrected[k]));
    (0..CONTACT_ROWS).map(|k| (scaled[k] - projected[k]) * (scaled[k] - projected[k])).sum::<f64>().sqrt()
}

fn map_of_sliding(friction: f64, inverse_mass: f64, r: Rows, u: Rows) -> f64 {
    let normal = r[0] * inverse_mass - (r[0] * inverse_mass - u[0]).max(0.0);
    let tangential = (r[1] + friction * r[0]) * inverse_mass;
    (normal * normal + tangential * tangential).sqrt()
}

/// The square of the map of a rotation that is resisted.
fn square_of_turn(rows: &Range<usize>, resists: Resistance, inverse_mass: f64, (r, u): (&[f64], &[f64])) -> f64 {
    let radius = resists.friction * r[0].max(0.0) * inverse_mass;
    if resists.slides {
        return rows.clone().map(|row| r[row] * inverse_mass + radius).map(|left| left * left).sum();
    }
    let wanted = |row: usize| r[row] * inverse_mass - u[row];
    let length = rows.clone().map(|row| wanted(row) * wanted(row)).sum::<f64>().sqrt();
    let share = if length > radius { radius / length } else { 1.0 };
    rows.clone().map(|row| r[row] * inverse_mass - share * wanted(row)).map(|left| left * left).sum()
}

#[cfg(test)]
mod tests {
    use super::project;

    /// The cone without friction is a ray: what pulls is projected onto zero. It was left as it is, so that a contact
    /// without friction that parts was never solved.
    #[test]
    fn what_pulls_on_a_contact_without_friction_is_projected_onto_zero() {
        assert_eq!(project(0.0, [-3.0, 0.0, 0.0]), [0.0; 3]);
        assert_eq!(project(0.0, [-3.0, 1.0, 2.0]), [0.0; 3]);
        assert_eq!(project(0.0, [3.0, 4.0, 0.0]), [3.0, 0.0, 0.0]);
        assert_eq!(project(0.5, [-3.0, 1.0, 0.0]), [0.0; 3]);
    }
}
