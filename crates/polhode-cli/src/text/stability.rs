//! How far bodies at rest are from moving.

use super::table::{Table, vector};
use polhode::stability::{Beginning, FrictionMargin, MovingBody, PushMargin, Stability};
use polhode::{BodyId, Scene};

use std::fmt::Write as _;

/// Most bodies named that begin to move: more do not help.
const MOST_NAMED: usize = 3;

/// Digits of margins: the analysis is good to six.
const DIGITS: usize = 4;

/// All margins: friction, and a line for each direction.
pub(crate) fn stability(scene: &Scene, stability: &Stability) -> String {
    if stability.bodies == 0 {
        return "stability\n  no body at rest touches another one\n".to_owned();
    }
    let mut table = Table::default();
    table.row(["friction", &friction(scene, &stability.friction)]);
    let [least, begins] = stability.worst_push().map_or_else(Default::default, |push| worst(scene, push));
    table.row(["tilt", &format!("{least}, the least of {} directions{begins}", stability.pushes.len())]);
    let mut directions = Table::default();
    directions.row(["towards", "tilt, degrees", "push, of the weight", "begins"]);
    for push in &stability.pushes {
        let of_weight = push.of_weight.map_or_else(|| "does not stand".to_owned(), margin);
        let tilt = degrees(scene, push).unwrap_or_else(|| "-".to_owned());
        directions.row([&vector(push.direction), &tilt, &of_weight, &named(scene, &push.begins)]);
    }
    let (bodies, contacts) = (stability.bodies, stability.contacts);
    let head = format!("stability of {bodies} bodies at rest, {contacts} contacts\n{}", table.print());
    if stability.pushes.is_empty() { head } else { format!("{head}\n{}", directions.print()) }
}

/// The same in a line; none where nothing rests.
pub(crate) fn stability_line(scene: &Scene, stability: &Stability) -> Option<String> {
    let push = stability.worst_push().filter(|_| stability.bodies > 0)?;
    let [least, begins] = worst(scene, push);
    Some(format!(
        "{} at rest; friction {}; tilt {least}{begins}",
        stability.bodies,
        friction(scene, &stability.friction)
    ))
}

fn friction(scene: &Scene, margin: &FrictionMargin) -> String {
    let then = |word: &str| match named(scene, &margin.begins) {
        names if names.is_empty() => String::new(),
        names => format!(" ({word} {names})"),
    };
    match margin.needed {
        None => "does not hold them, however large".to_owned(),
        Some(0.0) => "is not needed".to_owned(),
        Some(needed) if needed <= 1.0 => format!("may fall to {needed:.DIGITS$} of itself{}", then("then")),
        Some(needed) => format!("would have to be {needed:.DIGITS$} of itself{}", then("now")),
    }
}

/// The least tilt, or push where gravity is not the only load, and what begins then.
fn worst(scene: &Scene, push: &PushMargin) -> [String; 2] {
    let towards = vector(push.direction);
    let least = match (degrees(scene, push), push.of_weight) {
        (_, None) => "none, they do not stand".to_owned(),
        (_, Some(f64::INFINITY)) => "any".to_owned(),
        (Some(degrees), _) => format!("{degrees} degrees towards {towards}"),
        (None, Some(of_weight)) => {
            format!("is no measure, with other forces: a push of {} of the weight towards {towards}", margin(of_weight))
        }
    };
    let names = named(scene, &push.begins);
    [least, if names.is_empty() { String::new() } else { format!(" (then {names})") }]
}

/// The tilt, where gravity is the only load.
fn degrees(scene: &Scene, push: &PushMargin) -> Option<String> {
    let tilt = push.tilt_rad().filter(|_| scene.forces().is_empty())?;
    Some(format!("{:.DIGITS$}", tilt.to_degrees()))
}

fn margin(of_weight: f64) -> String {
    if of_weight.is_finite() { format!("{of_weight:.DIGITS$}") } else { "any".to_owned() }
}

/// Names of bodies of which each does this, as many as help.
pub(super) fn named_bodies(scene: &Scene, bodies: &[BodyId], does: &str) -> String {
    let name = |body: &BodyId| scene.bodies().get(body.index()).map_or("", polhode::Body::name);
    let names: Vec<&str> = bodies.iter().take(MOST_NAMED).map(name).collect();
    let more =
        if bodies.len() > MOST_NAMED { format!(" and {} more", bodies.len() - MOST_NAMED) } else { String::new() };
    format!("{}{more} {}", names.join(", "), if bodies.len() > 1 { does.trim_end_matches('s') } else { does })
}

/// The bodies that begin to move, the fastest first.
fn named(scene: &Scene, begins: &[MovingBody]) -> String {
    let one = |moving: &MovingBody| {
        let name = scene.bodies().get(moving.body.index()).map_or("", polhode::Body::name);
        let how = match moving.beginning {
            Beginning::Slides => "slides",
            Beginning::Tips => "tips",
            _ => "moves",
        };
        format!("{name} {how}")
    };
    let mut text = begins.iter().take(MOST_NAMED).map(one).collect::<Vec<_>>().join(", ");
    if begins.len() > MOST_NAMED {
        let _ = write!(text, " and {} more", begins.len() - MOST_NAMED);
    }
    text
}
