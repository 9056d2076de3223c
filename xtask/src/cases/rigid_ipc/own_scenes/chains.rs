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

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    let links = (0..3).map(lying).collect();
    vec![OwnScene::new("chain of 3 links, swinging", 10.0, 9.81, &Value::Array(links))]
}

/// Link `number` of a chain along x; the first one is held.
fn lying(number: u32) -> Value {
    let turn = if number.is_multiple_of(2) { 0.0 } else { 90.0 };
    let x = SPACING * f64::from(number);
    json!({ "mesh": "link.obj", "position": [x, 0, 0], "rotation": [turn, 0, 0], "is_dof_fixed": number == 0 })
}
