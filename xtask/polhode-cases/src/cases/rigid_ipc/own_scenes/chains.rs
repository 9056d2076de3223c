//! Chains of links that hang in each other. A link is a ring about z of radius [`LINK`] with a tube of radius [`TUBE`];
//! two that stand across each other are taut when their centres are `2 (LINK - TUBE)` apart.

use super::OwnScene;
use serde_json::{Value, json};

/// Radius of the middle line of a link's tube, m.
pub(super) const LINK: f64 = 0.3;
/// Radius of the tube, m.
pub(super) const TUBE: f64 = 0.05;
/// Between the centres of two links at the start: some play, m.
const SPACING: f64 = 0.45;

/// Simulated time of the net, s: it is taut at 0.5 s, and the contacts that change then by the microsecond take
/// minutes.
const NET_S: f64 = 0.5;

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    let scene = |name, bodies| OwnScene::new(name, 10.0, 9.81, &Value::Array(bodies));
    vec![
        scene("chain of 3 links, swinging", (0..3).map(lying).collect()),
        scene("chain of 5 links, swinging", (0..5).map(lying).collect()),
        scene("chain of 10 links", (0..10).map(hanging).collect()),
        OwnScene::new("wrecking ball", 2.0, 9.81, &wrecking_ball()),
        OwnScene::new("net of 4 by 4 rings", NET_S, 9.81, &Value::Array(net(4))),
    ]
}

/// Link `number` of a chain along x; the first one is held.
fn lying(number: u32) -> Value {
    let turn = if number.is_multiple_of(2) { 0.0 } else { 90.0 };
    let x = SPACING * f64::from(number);
    json!({ "mesh": "link.obj", "position": [x, 0, 0], "rotation": [turn, 0, 0], "is_dof_fixed": number == 0 })
}

/// Link `number` of a chain that hangs down; the first one is held.
fn hanging(number: u32) -> Value {
    let turn = if number.is_multiple_of(2) { 0.0 } else { 90.0 };
    let y = -SPACING * f64::from(number);
    json!({ "mesh": "link.obj", "position": [0, y, 0], "rotation": [0, turn, 0], "is_dof_fixed": number == 0 })
}

/// A chain whose last link is a hundred times as heavy as the others together swings into a stack of cubes.
fn wrecking_ball() -> Value {
    let mut bodies: Vec<Value> = (0..4).map(lying).collect();
    let ball = 4.0 * SPACING + LINK;
    bodies.push(json!({ "mesh": "link.obj", "scale": 2.0, "position": [ball, 0, 0], "density": 50_000 }));
    bodies.push(json!({ "mesh": "plane.obj", "position": [-2, -3.5, 0], "type": "static" }));
    for layer in 0..4 {
        bodies.push(
            json!({ "mesh": "cube.obj", "position": [-1.5, -2.99 + 1.01 * f64::from(layer), 0], "density": 100 }),
        );
    }
    Value::Array(bodies)
}

/// A net of `side` by `side` rings that lie level, each joined to its neighbours by rings that stand between them;
/// those at the corners are held.
fn net(side: u32) -> Vec<Value> {
    let pitch = 2.0 * SPACING;
    let at = |row: f64, column: f64| [pitch * row, 0.0, pitch * column];
    let is_end = |index: u32| index == 0 || index + 1 == side;
    let mut bodies = Vec::new();
    for row in 0..side {
        for column in 0..side {
            let (x, z) = (f64::from(row), f64::from(column));
            let held = is_end(row) && is_end(column);
            bodies.push(
                json!({ "mesh": "link.obj", "position": at(x, z), "rotation": [90, 0, 0], "is_dof_fixed": held }),
            );
            if row + 1 < side {
                bodies.push(json!({ "mesh": "link.obj", "position": at(x + 0.5, z) }));
            }
            if column + 1 < side {
                bodies.push(json!({ "mesh": "link.obj", "position": at(x, z + 0.5), "rotation": [0, 90, 0] }));
            }
        }
    }
    bodies
}
