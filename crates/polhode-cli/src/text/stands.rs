//! Whether bodies stand, for people and as JSON.

use super::stability::{named_bodies, stability};
use super::table::{Table, number, vector};
use polhode::{BodyId, ContactView, Scene, Stability};
use polhode_scene::stability_json;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Friction needed, of that which there is, up to which bodies stand: the analysis is good to six digits.
const ENOUGH: f64 = 1.0;

/// What was found.
#[derive(Debug)]
pub(crate) struct Standing {
    /// How far they are from moving.
    pub(crate) stability: Stability,
    /// What touches, with its forces.
    pub(crate) contacts: Vec<ContactView>,
    /// Bodies that move in the first step, the fastest first.
    pub(crate) moving: Vec<BodyId>,
}

impl Standing {
    /// Whether they stand.
    pub(crate) fn stands(&self) -> bool {
        let is_held = self.stability.friction.needed.is_some_and(|needed| needed <= ENOUGH);
        self.moving.is_empty() && is_held
    }
}

/// The answer, the margins, and if asked for what each contact carries.
pub(crate) fn page(scene: &Scene, standing: &Standing, with_contacts: bool) -> String {
    let Standing { stability: margins, contacts, moving } = standing;
    let answer = if standing.stands() {
        format!("{} stands", scene.name())
    } else if moving.is_empty() {
        format!("{} does not stand: friction does not hold it", scene.name())
    } else {
        format!("{} does not stand: {} first", scene.name(), named_bodies(scene, moving, "moves"))
    };
    let mut text = format!("{answer}\n\n{}", stability(scene, margins));
    if with_contacts {
        let _ = write!(text, "\ncontacts: what each carries\n{}", loads(scene, contacts));
    }
    text
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

/// Everything as one object.
pub(crate) fn json(scene: &Scene, standing: &Standing) -> Value {
    let contact = |own: &ContactView| {
        json!({
            "body_a": name(scene, own.body_a), "body_b": name(scene, own.body_b), "point_m": own.point_m.to_array(),
            "normal": own.normal.to_array(), "normal_force_n": own.normal_force_n,
            "friction_n": own.friction_n.to_array(),
        })
    };
    json!({
        "scene": scene.name(),
        "stands": standing.stands(),
        "moves": standing.moving.iter().map(|body| name(scene, *body)).collect::<Vec<_>>(),
        "stability": stability_json(scene, &standing.stability),
        "contacts": standing.contacts.iter().map(contact).collect::<Vec<_>>(),
    })
}

fn name(scene: &Scene, body: BodyId) -> &str {
    scene.bodies().get(body.index()).map_or("", polhode::Body::name)
}
