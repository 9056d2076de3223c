//! The answers as JSON objects.

use super::bisect::Bisection;
use super::mechanism::{Begins, Hinge, Mechanism};
use super::standing::Standing;
use polhode::spatial::DVec3;
use polhode::stability::{Beginning, MovingBody};
use polhode::{BodyId, ContactView, Scene};
use polhode_scene::stability_json;
use serde_json::{Value, json};

/// Everything about a scene as one object.
pub fn standing_json(scene: &Scene, standing: &Standing) -> Value {
    let contact = |own: &ContactView| {
        json!({
            "body_a": name(scene, own.body_a), "body_b": name(scene, own.body_b), "point_m": own.point_m.to_array(),
            "normal": own.normal.to_array(), "normal_force_n": own.normal_force_n,
            "friction_n": own.friction_n.to_array(),
        })
    };
    let first = standing.first();
    json!({
        "scene": scene.name(),
        "stands": standing.stands(),
        "first": first.iter().map(|(body, _)| name(scene, *body)).collect::<Vec<_>>(),
        "how": first.first().map(|(_, beginning)| how(*beginning)),
        "moves": standing.moving.iter().map(|body| name(scene, *body)).collect::<Vec<_>>(),
        "stability": stability_json(scene, &standing.stability),
        "mechanism": standing.mechanism.as_ref().map(|own| mechanism_json(scene, own)),
        "contacts": standing.contacts.iter().map(contact).collect::<Vec<_>>(),
    })
}

/// A limit as one object.
pub fn bisection_json(scene: &str, found: &Bisection) -> Value {
    json!({
        "scene": scene, "key": found.key, "limit": found.limit(), "stands_at": found.stands, "falls_at": found.falls,
        "digits": found.digits, "asked": found.asked,
    })
}

fn mechanism_json(scene: &Scene, mechanism: &Mechanism) -> Value {
    let begins = match mechanism.begins {
        Begins::Now => json!("now"),
        Begins::AtPush { direction, of_weight } => {
            json!({ "push_of_weight": of_weight, "direction": direction.to_array() })
        }
    };
    let body = |own: &MovingBody| {
        json!({
            "body": name(scene, own.body), "velocity": own.velocity.linear.to_array(),
            "angular_velocity": own.velocity.angular.to_array(),
        })
    };
    let hinge = |own: &Hinge| {
        let points: Vec<[f64; 3]> = own.points_m.iter().map(DVec3::to_array).collect();
        json!({ "bodies": own.bodies.map(|body| name(scene, body)), "points_m": points })
    };
    json!({
        "begins": begins,
        "bodies": mechanism.bodies.iter().map(body).collect::<Vec<_>>(),
        "hinges": mechanism.hinges.iter().map(hinge).collect::<Vec<_>>(),
    })
}

/// How a body begins to move, in a word.
fn how(beginning: Option<Beginning>) -> &'static str {
    match beginning {
        Some(Beginning::Slides) => "slides",
        Some(Beginning::Tips) => "tips",
        _ => "moves",
    }
}

fn name(scene: &Scene, body: BodyId) -> &str {
    scene.bodies().get(body.index()).map_or("", polhode::Body::name)
}
