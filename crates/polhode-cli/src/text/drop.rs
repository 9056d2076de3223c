//! On which faces a body comes to rest, in a table.

use super::table::{Table, number, vector};
use polhode_study::drop::{Blow, RestPoses, Setting, Spread, Throws};
use std::fmt::Write as _;

/// Rows of faces that are printed at most: more nobody reads; JSON has all of them.
const MOST_ROWS: usize = 20;

/// The table of faces, what became of the other throws, and how hard the body was struck.
pub(crate) fn page(setting: &Setting, throws: &Throws, poses: &RestPoses) -> String {
    let (name, count, seed) = (setting.body().name(), poses.throws, throws.seed);
    let from = if setting.is_on_plane() {
        format!("on a plane, from {} m above it", number(setting.height_m()))
    } else {
        format!("in {}", setting.scene().name())
    };
    let mut text = format!("drop of {name}: {count} throws {from}; seed {seed}\n");
    text.push_str(&faces(setting, poses));
    let mut others = Table::default();
    let told = [
        (poses.leaning, "came to rest on no face alone"),
        (poses.moving, "still moved when the time had run out"),
        (poses.failed, "failed"),
    ];
    for (count, what) in told.into_iter().filter(|(count, _)| *count > 0) {
        let share = format!("{} +- {}", number(poses.share(count)), error(poses.standard_error(count)));
        others.row([&count.to_string(), what, &share]);
    }
    text.push_str(&others.print());
    if let Some((throw, why)) = &poses.reason {
        let _ = writeln!(text, "  first failure: throw {throw}: {why}");
    }
    text.push('\n');
    text.push_str(&struck(poses));
    text
}

fn faces(setting: &Setting, poses: &RestPoses) -> String {
    let list = setting.facets().list();
    let (held, all) = (list.iter().filter(|facet| facet.holds()).count(), list.len());
    // Faces that nothing came to rest on are told where they are few.
    let is_told = |face: &usize| poses.on[*face] > 0 || (list[*face].holds() && held <= MOST_ROWS);
    let mut order: Vec<usize> = (0..all).filter(is_told).collect();
    order.sort_by_key(|&face| std::cmp::Reverse(poses.on[face]));
    let weight_n = setting.properties().mass() * setting.scene().gravity().length();
    let mut table = Table::default();
    table.row(["face", "throws", "share", "standard error", "tilt, degrees", "barrier, J", "normal in the body"]);
    for &face in order.iter().take(MOST_ROWS) {
        let (own, on) = (&list[face], poses.on[face]);
        table.row([
            &(face + 1).to_string(),
            &on.to_string(),
            &number(poses.share(on)),
            &error(poses.standard_error(on)),
            &number(own.tilt_rad.to_degrees()),
            &number(own.barrier_m * weight_n),
            &vector(own.normal),
        ]);
    }
    let mut text = table.print();
    let more = order.len().saturating_sub(MOST_ROWS);
    if more > 0 {
        let on: u64 = order.iter().skip(MOST_ROWS).map(|&face| poses.on[face]).sum();
        let _ = writeln!(text, "  and {more} more faces, with {on} throws: --json has all");
    }
    let _ = writeln!(text, "  it can rest on {held} of the {all} faces of its hull");
    text
}

fn struck(poses: &RestPoses) -> String {
    let mut table = Table::default();
    if poses.end_s.count > 0 {
        table.row(["came to rest", &told(&poses.end_s, "s")]);
    }
    if poses.impulse_ns.count > 0 {
        table.row(["peak impulse", &told(&poses.impulse_ns, "N s")]);
    }
    if poses.deceleration.count > 0 {
        table.row(["peak deceleration", &told(&poses.deceleration, "m/s^2")]);
    }
    if let Some(Blow { time_s: Some(time_s), .. }) = poses.hardest {
        table.row(["contact time there", &format!("{} s (Hertz)", number(time_s))]);
    }
    let mut text = table.print();
    if poses.impulse_ns.count > 0 && poses.deceleration.count == 0 {
        text.push_str(
            "  no deceleration: a rigid body is struck in no time; --young and --corner-radius give the contact one\n",
        );
    }
    text
}

fn told(own: &Spread, unit: &str) -> String {
    let spread = own.standard_error().map_or_else(String::new, |own| format!(" +- {}", error(own)));
    format!("mean {}{spread} {unit}, largest {} {unit} (throw {})", number(own.mean), number(own.most), own.throw)
}

/// An error in two digits.
fn error(value: f64) -> String {
    number(format!("{value:.1e}").parse().unwrap_or(value))
}
