//! Whether bodies stand, and up to which value of a key, for people.

use super::stability::{named_bodies, stability};
use super::table::{Table, number, vector};
use polhode::{BodyId, ContactView, Scene};
use polhode_study::stands::{Begins, Bisection, Mechanism, Numbers, Standing};
use std::fmt::Write as _;

/// The answer, the margins, the hinges of what begins, and if asked for what each contact carries.
pub(crate) fn page(scene: &Scene, standing: &Standing, with_contacts: bool) -> String {
    let mut text = format!("{}\n\n{}", answer(scene, standing), stability(scene, &standing.stability));
    if let Some(mechanism) = standing.mechanism.as_ref().filter(|own| !own.hinges.is_empty()) {
        let _ = write!(text, "\nhinges of what begins {}\n{}", when(mechanism), hinges(scene, mechanism));
    }
    if with_contacts {
        let _ = write!(text, "\ncontacts: what each carries\n{}", loads(scene, &standing.contacts));
    }
    text
}

/// Which motion begins, in a line.
pub(crate) fn what_begins(scene: &Scene, mechanism: &Mechanism) -> String {
    let bodies: Vec<BodyId> = mechanism.bodies.iter().map(|own| own.body).collect();
    let hinges = match mechanism.hinges.len() {
        0 => String::new(),
        1 => ", on 1 hinge".to_owned(),
        count => format!(", on {count} hinges"),
    };
    format!("what begins {}: {}{hinges}", when(mechanism), named_bodies(scene, &bodies, "moves"))
}

/// The limit of a key, with the values on both sides of it.
pub(crate) fn limit(scene: &str, found: &Bisection) -> String {
    let is_whole = found.numbers == Numbers::Whole;
    let shown = |value: f64| if is_whole { format!("{value:.0}") } else { format!("{value:?}") };
    let digits = found.digits as usize;
    let limit = if is_whole { shown(found.limit()) } else { significant(found.limit(), digits) };
    let Bisection { key, asked, .. } = found;
    let (stands, falls) = (shown(found.stands), shown(found.falls));
    format!("{scene}: the limit of {key} is {limit}\n  it stands at {stands}, and not at {falls}; {asked} scenes\n")
}

/// A number in so many digits.
fn significant(value: f64, digits: usize) -> String {
    // Rust writes as many digits after the point as are asked for, and an exponent: read again it is a plain number.
    let rounded = format!("{value:.prec$e}", prec = digits.saturating_sub(1));
    rounded.parse().map_or(rounded, |value: f64| format!("{value:?}"))
}

pub(crate) fn answer(scene: &Scene, standing: &Standing) -> String {
    if standing.stands() {
        format!("{} stands", scene.name())
    } else if standing.moving.is_empty() {
        format!("{} does not stand: friction does not hold it", scene.name())
    } else {
        format!("{} does not stand: {} first", scene.name(), named_bodies(scene, &standing.moving, "moves"))
    }
}

fn when(mechanism: &Mechanism) -> String {
    match mechanism.begins {
        Begins::AtPush { direction, of_weight } => {
            format!("at a push of {of_weight:.4} of the weight towards {}", vector(direction))
        }
        _ => "now".to_owned(),
    }
}

/// Where bodies turn about each other.
fn hinges(scene: &Scene, mechanism: &Mechanism) -> String {
    let mut table = Table::default();
    table.row(["bodies", "middle, m"]);
    for hinge in &mechanism.hinges {
        let [a, b] = hinge.bodies.map(|body| name(scene, body));
        table.row([&format!("{a}, {b}"), &vector(hinge.middle_m())]);
    }
    table.print()
}

/// The contacts with their forces, the largest first.
fn loads(scene: &Scene, contacts: &[ContactView]) -> String {
    let mut order: Vec<&ContactView> = contacts.iter().collect();
    order.sort_by(|a, b| b.normal_force_n.total_cmp(&a.normal_force_n));
    let mut table = Table::default();
    table.row(["bodies", "point, m", "normal force, N", "friction, N"]);
    for own in order {
        let [a, b] = [own.body_a, own.body_b].map(|body| name(scene, body));
        let (point, friction) = (vector(own.point_m), number(own.friction_n.length()));
        table.row([&format!("{a}, {b}"), &point, &number(own.normal_force_n), &friction]);
    }
    table.print()
}

fn name(scene: &Scene, body: BodyId) -> &str {
    scene.bodies().get(body.index()).map_or("", polhode::Body::name)
}
