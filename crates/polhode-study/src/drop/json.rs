//! Everything as one JSON object, and a line of a table for each throw.

use super::facets::Facet;
use super::poses::{RestPoses, Spread, Throws};
use super::setting::Setting;
use super::throw::{Blow, Fate, Throw};
use serde_json::{Value, json};

/// The names of the columns of the table of throws.
pub const THROW_COLUMNS: &str =
    "throw,qw,qx,qy,qz,outcome,face,end_s,impacts,impulse_n_s,deceleration_m_s2,contact_time_s,reason";

/// A throw as a line of the table, without its end. Faces are counted from 1.
pub fn throw_line(throw: &Throw) -> String {
    let [w, x, y, z] = throw.attitude;
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| format!("{value:?}"));
    let face = if let Fate::Rests(facet) = throw.fate { (facet + 1).to_string() } else { String::new() };
    let reason = if let Fate::Failed(why) = &throw.fate { quoted(why) } else { String::new() };
    let impulse = number(throw.strongest.map(|blow| blow.impulse_ns));
    let deceleration = number(throw.hardest.and_then(|blow| blow.deceleration));
    let time = number(throw.hardest.and_then(|blow| blow.time_s));
    let (outcome, end_s, blows) = (throw.fate.word(), throw.end_s, throw.blows);
    let number = throw.number;
    format!(
        "{number},{w:?},{x:?},{y:?},{z:?},{outcome},{face},{end_s:?},{blows},{impulse},{deceleration},{time},{reason}"
    )
}

/// A text on one line, in quotes.
fn quoted(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("\"{}\"", line.replace('"', "\"\""))
}

/// Everything as one object.
pub fn json(setting: &Setting, throws: &Throws, poses: &RestPoses) -> Value {
    let faces = setting.facets().list().iter().zip(&poses.on).enumerate();
    let told = faces.filter(|(_, (facet, on))| facet.holds() || **on > 0);
    json!({
        "scene": setting.scene().name(),
        "body": setting.body().name(),
        "mass_kg": setting.properties().mass(),
        "size_m": setting.facets().size_m(),
        "center_of_mass_m": setting.properties().center_of_mass().to_array(),
        "height_m": setting.is_on_plane().then(|| setting.height_m()),
        "on_plane": setting.is_on_plane(),
        "throws": poses.throws,
        "seed": throws.seed,
        "faces": told.map(|(number, (facet, on))| face(poses, number, facet, *on)).collect::<Vec<_>>(),
        "faces_of_the_hull": setting.facets().list().len(),
        "leaning": poses.leaning,
        "moving": poses.moving,
        "failed": poses.failed,
        "first_failure": poses.reason.as_ref().map(|(throw, why)| json!({ "throw": throw, "reason": why })),
        "rest_time_s": spread(&poses.end_s),
        "peak_impulse_n_s": spread(&poses.impulse_ns),
        "peak_impulse": poses.strongest.map(blow),
        "peak_deceleration_m_s2": spread(&poses.deceleration),
        "peak_deceleration": poses.hardest.map(blow),
    })
}

fn face(poses: &RestPoses, number: usize, facet: &Facet, on: u64) -> Value {
    json!({
        "face": number + 1,
        "normal": facet.normal.to_array(),
        "height_m": facet.height_m,
        "area_m2": facet.area_m2,
        "corners": facet.corners,
        "can_rest": facet.holds(),
        "tilt_rad": facet.tilt_rad,
        "barrier_m": facet.barrier_m,
        "throws": on,
        "share": poses.share(on),
        "standard_error": poses.standard_error(on),
    })
}

fn spread(own: &Spread) -> Option<Value> {
    (own.count > 0).then(|| {
        json!({
            "mean": own.mean, "standard_error": own.standard_error(), "largest": own.most, "throw": own.throw,
        })
    })
}

fn blow(own: Blow) -> Value {
    json!({
        "t_s": own.t_s, "impulse_n_s": own.impulse_ns, "deceleration_m_s2": own.deceleration,
        "contact_time_s": own.time_s,
    })
}
