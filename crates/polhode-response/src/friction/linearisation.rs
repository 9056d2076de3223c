//! Coulomb's law of one contact, linearised: the rows of Newton's method.
//!
//! With `w = r_n - rho u_n` and `t = r_t - rho u_t` (Alart and Curnier) a contact is open where `w <= 0`, sticks where
//! `|t| <= mu w`, and slides otherwise. Its function, in units of velocity, is zero exactly where the natural map is:
//!
//! | status | function | unknowns of a step | what they ask for |
//! |---|---|---|---|
//! | open | `r / rho` | none: `dr = -r` | |
//! | stick | `u` | `dr` | `du = -u` |
//! | slide | `u_n`, `(r_t - mu w t/\|t\|) / rho` | `dr_n` and `dr_p` across the slip | `du_n = -u_n`, `du_p + c dr_p = -r_p / (rho k)` |
//!
//! where `d = t/|t|`, `p` is across `d`, `k = mu w / |t|`, `c = (1 - k) / (k rho)`; along `d` the cone's boundary gives
//! `dr_d = mu dr_n + (mu r_n - r_d)`. Source: Alart and Curnier 1991; the elimination of `dr_d` is exact.

use crate::friction::block::{FrictionBlock, MOST_ROWS};
use crate::friction::coulomb_cone::{Rows, tangential_length};

/// What a contact does, as the last step of a method sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactStatus {
    /// No reaction.
    #[default]
    Open,
    /// A reaction within the cone, no velocity. Also rows that are held.
    Stick,
    /// A reaction on the boundary of the cone, against the slip.
    Slide,
}

/// One block's part of a step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Linearised {
    /// Which branch of the law.
    pub(crate) status: ContactStatus,
    /// Unknowns `y`.
    pub(crate) unknowns: usize,
    /// `dr = T y + shift`: the columns of `T`.
    pub(crate) columns: [Rows; MOST_ROWS],
    /// The rows `S` in `S du + D y = right`.
    pub(crate) rows: [Rows; MOST_ROWS],
    /// The diagonal `D` (1/kg).
    pub(crate) diagonal: Rows,
    /// `right`.
    pub(crate) right: Rows,
    /// `shift`.
    pub(crate) shift: Rows,
    /// Square of the function, in units of velocity.
    pub(crate) square: f64,
}

const NORMAL: Rows = [1.0, 0.0, 0.0];
const AXES: [Rows; MOST_ROWS] = [NORMAL, [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Linearises a block at reaction `r` and velocity `u`. `inverse_masses` are `1 / rho` along the normal and the tangents.
pub(crate) fn linearise(block: FrictionBlock, inverse_masses: [f64; 2], r: Rows, u: Rows) -> Linearised {
    let (rows, friction) = match block {
        FrictionBlock::Contact { rows, friction } => (rows, friction),
        FrictionBlock::Sliding { friction } => return sliding(friction, inverse_masses, r, u),
        FrictionBlock::Bilateral { rows } => return hold(rows, u),
    };
    let [g_n, g_t] = inverse_masses;
    let w = g_n * r[0] - u[0];
    if w <= 0.0 {
        let scaled = [g_n * r[0], g_t * r[1], g_t * r[2]];
        return Linearised { shift: r.map(|value| -value), square: square_of(scaled), ..Linearised::default() };
    }
    let t = [0.0, g_t * r[1] - u[1], g_t * r[2] - u[2]];
    let length = tangential_length(t);
    // Radius of the disc of tangential reactions, in units of velocity.
    let radius = friction * (w * g_t / g_n);
    if rows > 1 && length <= radius && friction > 0.0 {
        return hold(rows, u);
    }
    let mut slide = Linearised { status: ContactStatus::Slide, unknowns: 1, rows: AXES, ..Linearised::default() };
    slide.columns[0] = NORMAL;
    slide.right[0] = -u[0];
    if rows == 1 || length <= radius || friction == 0.0 {
        slide.status = if rows == 1 { ContactStatus::Stick } else { ContactStatus::Slide };
        slide.shift = [0.0, -r[1], -r[2]];
        slide.square = square_of([u[0], g_t * r[1], g_t * r[2]]);
        return slide;
    }
    let d = [0.0, t[1] / length, t[2] / length];
    let p = [0.0, -d[2], d[1]];
    let (along, across) = (r[1] * d[1] + r[2] * d[2], r[1] * p[1] + r[2] * p[2]);
    slide.columns[0] = [1.0, friction * d[1], friction * d[2]];
    let missing = friction * r[0] - along;
    slide.shift = [0.0, missing * d[1], missing * d[2]];
    slide.square = square_of([u[0], g_t * along - radius, g_t * across]);
    if rows == MOST_ROWS {
        let share = radius / length;
        slide.unknowns = 2;
        slide.columns[1] = p;
        slide.rows[1] = p;
        slide.diagonal[1] = g_t * (1.0 - share) / share;
        slide.right[1] = -across * g_t / share;
    }
    slide
}

/// A contact that slides already: open, or `u_n = 0` with `r_t = -mu r_n`.
fn sliding(friction: f64, [g_n, g_t]: [f64; 2], r: Rows, u: Rows) -> Linearised {
    if g_n * r[0] - u[0] <= 0.0 {
        let square = square_of([g_n * r[0], g_t * r[1], 0.0]);
        return Linearised { shift: r.map(|value| -value), square, ..Linearised::default() };
    }
    let missing = -friction * r[0] - r[1];
    let mut slide = Linearised { status: ContactStatus::Slide, unknowns: 1, rows: AXES, ..Linearised::default() };
    slide.columns[0] = [1.0, -friction, 0.0];
    slide.right[0] = -u[0];
    slide.shift = [0.0, missing, 0.0];
    slide.square = square_of([u[0], g_t * missing, 0.0]);
    slide
}

fn hold(rows: usize, u: Rows) -> Linearised {
    let right = u.map(|value| -value);
    let (status, square) = (ContactStatus::Stick, square_of(u));
    Linearised { status, unknowns: rows, columns: AXES, rows: AXES, right, square, ..Linearised::default() }
}

fn square_of(x: Rows) -> f64 {
    x[0] * x[0] + x[1] * x[1] + x[2] * x[2]
}
