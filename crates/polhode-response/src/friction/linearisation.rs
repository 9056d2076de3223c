//! Coulomb's law of one contact, linearised: the rows of Newton's method.
//!
//! With `w = r_n - rho u_n` and `t = r_t - rho u_t` (Alart and Curnier) a contact is open where `w <= 0`, sticks where
//! `|t| <= mu w`, and slides otherwise. Its function, in units of velocity, is zero exactly where the natural map is:
//!
//! | status | function | unknowns of a step | what they ask for |
//! |---|---|---|---|
//! | open | `r / rho` | none: `dr = -r` | |
//! | stick | `u` | `dr` | `du = -u` |
//! | slide | `u_n` | `dr_n` | `du_n = -u_n` |
//! | slide | `(r_t - mu w t/\|t\|) / rho` | `dr_p` across the slip | `du_p + c dr_p = -r_p / (rho k)` |
//!
//! Rotations that are resisted have the rows of stick or slide of their own, `mu_i` in the place of `mu`.
//!
//! where `d = t/|t|`, `p` is across `d`, `k = mu w / |t|`, `c = (1 - k) / (k rho)`; along `d` the cone's boundary gives
//! `dr_d = mu dr_n + (mu r_n - r_d)`. Source: Alart and Curnier 1991; the elimination of `dr_d` is exact.

use crate::friction::coulomb_cone::{BlockRows, tangential_length};
use crate::law::{CONTACT_ROWS, Law, MOST_ROWS, PARTS, Resistance};
use std::ops::Range;

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

impl ContactStatus {
    /// The name in words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::Slide => "slide",
        }
    }
}

/// One block's part of a step.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Linearised {
    /// Which branch of the law.
    pub(crate) status: ContactStatus,
    /// That of each part that resists: slip, rolling, spinning.
    pub(crate) parts: [ContactStatus; PARTS],
    /// Unknowns `y`.
    pub(crate) unknowns: usize,
    /// `dr = T y + shift`: the columns of `T`.
    pub(crate) columns: [BlockRows; MOST_ROWS],
    /// The rows `S` in `S du + D y = right`.
    pub(crate) rows: [BlockRows; MOST_ROWS],
    /// The diagonal `D` (1/kg).
    pub(crate) diagonal: BlockRows,
    /// `1 / rho` of each unknown.
    pub(crate) inverse_masses: BlockRows,
    /// `right`.
    pub(crate) right: BlockRows,
    /// `shift`.
    pub(crate) shift: BlockRows,
    /// Square of the function, in units of velocity.
    pub(crate) square: f64,
}

/// `1 / rho` along the normal and of each part that resists.
pub(crate) type InverseMasses = [f64; 1 + PARTS];

const NORMAL: BlockRows = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
const AXES: [BlockRows; MOST_ROWS] = [
    NORMAL,
    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
];

/// Linearises a block at reaction `r` and velocity `u`.
pub(crate) fn linearise(block: Law, inverse_masses: InverseMasses, r: BlockRows, u: BlockRows) -> Linearised {
    let (rows, friction) = match block {
        Law::Push => (1, 0.0),
        Law::Cone { rows, friction } => (rows, friction),
        Law::Slide { friction } => return sliding(friction, inverse_masses, r, u),
        Law::Hold { rows } => return hold(rows, inverse_masses, u),
        Law::Resist { .. } => return resisted(block, inverse_masses, r, u),
    };
    let [g_n, g_t, ..] = inverse_masses;
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
        return hold(rows, inverse_masses, u);
    }
    let mut slide = along_the_normal(inverse_masses, u);
    if rows == 1 || length <= radius || friction == 0.0 {
        slide.status = if rows == 1 { ContactStatus::Stick } else { ContactStatus::Slide };
        slide.parts[0] = slide.status;
        slide.shift = [0.0, -r[1], -r[2], 0.0, 0.0, 0.0];
        slide.square = square_of([u[0], g_t * r[1], g_t * r[2]]);
        return slide;
    }
    let d = [0.0, t[1] / length, t[2] / length];
    let p = [0.0, -d[2], d[1], 0.0, 0.0, 0.0];
    let (along, across) = (r[1] * d[1] + r[2] * d[2], r[1] * p[1] + r[2] * p[2]);
    slide.columns[0] = [1.0, friction * d[1], friction * d[2], 0.0, 0.0, 0.0];
    let missing = friction * r[0] - along;
    slide.shift = [0.0, missing * d[1], missing * d[2], 0.0, 0.0, 0.0];
    slide.square = square_of([u[0], g_t * along - radius, g_t * across]);
    if rows == CONTACT_ROWS {
        let share = radius / length;
        slide.unknowns = 2;
        slide.columns[1] = p;
        slide.rows[1] = p;
        slide.diagonal[1] = g_t * (1.0 - share) / share;
        slide.right[1] = -across * g_t / share;
    }
    slide
}

/// A contact that bears, of which only the normal row is asked for.
fn along_the_normal([g_n, g_t, ..]: InverseMasses, u: BlockRows) -> Linearised {
    let (status, parts) = (ContactStatus::Slide, [ContactStatus::Slide, ContactStatus::Open, ContactStatus::Open]);
    let mut law = Linearised { status, parts, unknowns: 1, rows: AXES, ..Linearised::default() };
    law.columns[0] = NORMAL;
    law.right[0] = -u[0];
    law.inverse_masses = [g_n, g_t, g_t, 0.0, 0.0, 0.0];
    law
}

/// A contact that slides already: open, or `u_n = 0` with `r_t = -mu r_n`.
fn sliding(friction: f64, inverse_masses: InverseMasses, r: BlockRows, u: BlockRows) -> Linearised {
    let [g_n, g_t, ..] = inverse_masses;
    if g_n * r[0] - u[0] <= 0.0 {
        let square = square_of([g_n * r[0], g_t * r[1], 0.0]);
        return Linearised { shift: r.map(|value| -value), square, ..Linearised::default() };
    }
    let missing = -friction * r[0] - r[1];
    let mut slide = along_the_normal(inverse_masses, u);
    slide.columns[0] = [1.0, -friction, 0.0, 0.0, 0.0, 0.0];
    slide.shift = [0.0, missing, 0.0, 0.0, 0.0, 0.0];
    slide.square = square_of([u[0], g_t * missing, 0.0]);
    slide
}

fn hold(rows: usize, [g_n, g_t, ..]: InverseMasses, u: BlockRows) -> Linearised {
    let right = u.map(|value| -value);
    let square = square_of([u[0], u[1], u[2]]);
    let inverse_masses = [g_n, g_t, g_t, g_t, g_t, g_t];
    let (status, parts) = (ContactStatus::Stick, [ContactStatus::Stick, ContactStatus::Open, ContactStatus::Open]);
    let (columns, rows_of_laws) = (AXES, AXES);
    Linearised {
        status,
        parts,
        unknowns: rows,
        columns,
        rows: rows_of_laws,
        inverse_masses,
        right,
        square,
        ..Linearised::default()
    }
}

/// A contact that resists rotations as well as slip.
fn resisted(block: Law, inverse_masses: InverseMasses, r: BlockRows, u: BlockRows) -> Linearised {
    let [g_n, of_parts @ ..] = inverse_masses;
    let w = g_n * r[0] - u[0];
    let parts = block.parts();
    if w <= 0.0 {
        let mut square = (g_n * r[0]) * (g_n * r[0]);
        for ((rows, _), g) in parts.into_iter().zip(of_parts) {
            square += rows.map(|row| (g * r[row]) * (g * r[row])).sum::<f64>();
        }
        return Linearised { shift: r.map(|value| -value), square, ..Linearised::default() };
    }
    let mut law = along_the_normal(inverse_masses, u);
    law.rows = [[0.0; MOST_ROWS]; MOST_ROWS];
    law.rows[0] = NORMAL;
    law.square = u[0] * u[0];
    for (place, ((rows, resists), g)) in parts.into_iter().zip(of_parts).enumerate() {
        let part = ResistedPart { rows, resists, inverse_mass: g, radius: resists.friction * (w * g / g_n) };
        law.parts[place] = part.add_to(&mut law, r, u);
    }
    law.status = if parts_stick(law.parts[0]) { ContactStatus::Stick } else { ContactStatus::Slide };
    law
}

/// Whether a contact sticks whose slip is resisted like this: without a row of slip it does.
const fn parts_stick(slip: ContactStatus) -> bool {
    matches!(slip, ContactStatus::Stick | ContactStatus::Open)
}

/// A part of a contact that resists, whose normal bears.
#[derive(Debug, Clone)]
struct ResistedPart {
    rows: Range<usize>,
    resists: Resistance,
    /// `1 / rho` of its rows.
    inverse_mass: f64,
    /// Of the disc of its reactions, in units of velocity.
    radius: f64,
}

impl ResistedPart {
    /// Adds its unknowns and equations to those of the contact; the first unknown is that of the normal.
    fn add_to(&self, law: &mut Linearised, r: BlockRows, u: BlockRows) -> ContactStatus {
        let Self { rows, resists: Resistance { friction, slides, .. }, inverse_mass: g, radius } = self;
        let (rows, g, radius) = (rows.clone(), *g, *radius);
        if rows.is_empty() {
            return ContactStatus::Open;
        }
        if *slides {
            for row in rows {
                let missing = -friction * r[0] - r[row];
                law.columns[0][row] = -friction;
                law.shift[row] = missing;
                law.square += (g * missing) * (g * missing);
            }
            return ContactStatus::Slide;
        }
        let t = |row: usize| g * r[row] - u[row];
        let length = rows.clone().map(|row| t(row) * t(row)).sum::<f64>().sqrt();
        if length <= radius && *friction > 0.0 {
            for row in rows {
                push_unknown(law, AXES[row], [-u[row], 0.0, g]);
                law.square += u[row] * u[row];
            }
            return ContactStatus::Stick;
        }
        if length <= radius || *friction == 0.0 {
            for row in rows {
                law.shift[row] = -r[row];
                law.square += (g * r[row]) * (g * r[row]);
            }
            return ContactStatus::Slide;
        }
        let along: f64 = rows.clone().map(|row| r[row] * t(row) / length).sum();
        let missing = friction * r[0] - along;
        law.square += (g * along - radius) * (g * along - radius);
        for row in rows.clone() {
            law.columns[0][row] = friction * t(row) / length;
            law.shift[row] = missing * t(row) / length;
        }
        if rows.len() == 2 {
            let (first, second) = (rows.start, rows.start + 1);
            let mut p = [0.0; MOST_ROWS];
            (p[first], p[second]) = (-t(second) / length, t(first) / length);
            let across = r[first] * p[first] + r[second] * p[second];
            let share = radius / length;
            push_unknown(law, p, [-across * g / share, g * (1.0 - share) / share, g]);
            law.square += (g * across) * (g * across);
        }
        ContactStatus::Slide
    }
}

/// Adds an unknown along a direction of the rows, with the right side and the diagonal of its equation, and its
/// `1 / rho`.
fn push_unknown(law: &mut Linearised, along: BlockRows, [right, diagonal, inverse_mass]: [f64; 3]) {
    let k = law.unknowns;
    law.columns[k] = along;
    law.rows[k] = along;
    law.right[k] = right;
    law.diagonal[k] = diagonal;
    law.inverse_masses[k] = inverse_mass;
    law.unknowns += 1;
}

fn square_of(x: [f64; CONTACT_ROWS]) -> f64 {
    x[0] * x[0] + x[1] * x[1] + x[2] * x[2]
}
