//! Machines whose parts only touch: a lever, a compactor, gears.

use super::OwnScene;
use serde_json::{Value, json};

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    vec![
        OwnScene::new("lever arm", 3.0, 9.81, &lever_arm()),
        OwnScene::new("compactor of one cube", 3.0, 0.0, &compactor(&[([0.0; 3], [32.0, 247.0, 53.0])])),
        OwnScene::new(
            "compactor of four cubes",
            3.0,
            0.0,
            &compactor(&[
                ([0.0, 0.0, 0.0], [32.0, 247.0, 53.0]),
                ([-1.0, 0.0, -2.0], [13.0, 111.0, 111.0]),
                ([0.5, -1.0, -2.0], [94.0, 23.0, 161.0]),
                ([1.0, 1.0, 1.0], [76.0, 57.0, 172.0]),
            ]),
        ),
        OwnScene::new("rack and two gears", 2.0, 9.81, &gears()),
    ]
}

/// A beam of 15 m on a knife's edge and a block of ten times its density that falls on its end.
fn lever_arm() -> Value {
    json!([
        { "mesh": "knife.obj", "type": "static" },
        { "mesh": "beam.obj", "density": 1 },
        { "mesh": "cube.obj", "position": [7, 6, 0], "scale": 3, "density": 10 },
        { "mesh": "plane.obj", "position": [0, -5, 0], "scale": 3, "type": "static" }
    ])
}

/// Four plates, each pushed inwards by 1e6 N, and cubes between them. Plates do not meet each other.
fn compactor(cubes: &[([f64; 3], [f64; 3])]) -> Value {
    let plates = [[-1, 0], [1, 0], [0, -1], [0, 1]].map(|[x, y]| {
        json!({
            "mesh": "cube.obj", "scale": if x == 0 { [10.0, 0.1, 10.0] } else { [0.1, 10.0, 10.0] },
            "position": [2.05 * f64::from(x), 2.05 * f64::from(y), 0.0], "force": [-1_000_000 * x, -1_000_000 * y, 0],
            "is_dof_fixed": [false, false, false, true, true, true], "group_id": 0
        })
    });
    let cubes =
        cubes.iter().map(|(position, turn)| json!({ "mesh": "cube.obj", "position": position, "rotation": turn }));
    Value::Array(plates.into_iter().chain(cubes).collect())
}

/// A rack that falls between a wall and a gear drives it, and it drives another. Gears turn about fixed pins with 2 mm
/// to 4 mm of play.
fn gears() -> Value {
    json!([
        { "mesh": "pin.obj", "type": "static" },
        { "mesh": "gear.obj", "density": 100 },
        { "mesh": "pin.obj", "position": [2.05, 0, 0], "type": "static" },
        { "mesh": "gear.obj", "position": [2.05, 0, 0], "rotation": [0, 0, 15], "density": 100 },
        { "mesh": "rack.obj", "position": [-1.02, 2, 0], "density": 100 },
        { "mesh": "cube.obj", "position": [-2.42, 0, 0], "scale": [2, 12, 2], "type": "static" }
    ])
}
