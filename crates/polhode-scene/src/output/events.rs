//! Events as CSV: one row per event, in order of time.
//!
//! An impact has one row per impulse at one contact point, in the order applied.

use super::Sink;
use crate::csv::{write_field, write_number};
use polhode::{BodyId, Event};
use std::io;

/// Columns of the events file: time (s), kind, the two bodies (the second empty where there is none), the place (m) and
/// the normal from B to A in the world, the impulse on A along it (N s) and the change of kinetic energy (J).
pub const EVENT_COLUMNS: [&str; 12] =
    ["t", "kind", "body_a", "body_b", "px", "py", "pz", "nx", "ny", "nz", "impulse", "energy_change_j"];

/// Writes the first line.
pub(super) fn begin(out: &mut dyn Sink) -> io::Result<()> {
    writeln!(out, "{}", EVENT_COLUMNS.join(","))
}

/// Writes one event; `bodies` are the names in the order of the scene.
pub(super) fn row(out: &mut dyn Sink, event: &Event, bodies: &[String]) -> io::Result<()> {
    let name = |body: BodyId| bodies.get(body.index()).map_or("", String::as_str);
    write!(out, "{:?},{},", event.t_s, event.kind.word())?;
    write_field(out, name(event.body_a))?;
    out.write_all(b",")?;
    write_field(out, event.body_b.map_or("", name))?;
    let (p, n) = (event.point, event.normal);
    for number in [p.x, p.y, p.z, n.x, n.y, n.z, event.impulse, event.energy_change_j] {
        write_number(out, number)?;
    }
    out.write_all(b"\n")
}
