//! Contacts as CSV: one row per contact point and sample.

use super::Sink;
use crate::csv::{write_field, write_number};
use polhode::{BodyId, ContactSample};
use std::io;

/// Columns of the contacts file: time (s), the two bodies, the point (m) and the normal from B to A in the world, the
/// separation (m), the force on A along the normal (N) and of friction (N, world); and what of these forces is not
/// unique, because statics does not determine it (`normal`, `friction`, `normal and friction`): those of least norm are
/// told then.
pub const CONTACT_COLUMNS: [&str; 15] = [
    "t",
    "body_a",
    "body_b",
    "px",
    "py",
    "pz",
    "nx",
    "ny",
    "nz",
    "separation",
    "normal_force",
    "friction_x",
    "friction_y",
    "friction_z",
    "not_unique",
];

/// Writes the first line.
pub(super) fn begin(out: &mut dyn Sink) -> io::Result<()> {
    writeln!(out, "{}", CONTACT_COLUMNS.join(","))
}

/// Writes the contacts at one time; `bodies` are the names in the order of the scene.
pub(super) fn rows(out: &mut dyn Sink, t_s: f64, contacts: &[ContactSample], bodies: &[String]) -> io::Result<()> {
    let name = |body: BodyId| bodies.get(body.index()).map_or("", String::as_str);
    for contact in contacts {
        let own = &contact.view;
        write!(out, "{t_s:?},")?;
        write_field(out, name(own.body_a))?;
        out.write_all(b",")?;
        write_field(out, name(own.body_b))?;
        let (p, n, f) = (own.point_m, own.normal, own.friction_n);
        for number in [p.x, p.y, p.z, n.x, n.y, n.z, own.separation_m, own.normal_force_n, f.x, f.y, f.z] {
            write_number(out, number)?;
        }
        writeln!(out, ",{}", contact.not_unique())?;
    }
    Ok(())
}
