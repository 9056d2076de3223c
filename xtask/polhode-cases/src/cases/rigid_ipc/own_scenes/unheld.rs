//! Scenes that friction holds in the suite and that nothing holds here: what stood there falls. What rolls there slides
//! here, and what is piled up spreads.

use super::OwnScene;
use super::round;
use polhode::mesh::TriangleMesh;
use serde_json::{Value, json};
use std::error::Error;

/// The mesh files that only these scenes name.
pub(super) fn mesh_files() -> Result<Vec<(&'static str, TriangleMesh)>, Box<dyn Error>> {
    Ok(vec![
        ("coin.obj", round::coin()?),
        ("ball.obj", round::ball()?),
        ("cone.obj", round::cone()?),
        ("oloid.obj", round::oloid()?),
        ("sphericon.obj", round::sphericon()?),
        ("stone.obj", round::stone()?),
    ])
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    [inclines(), card_houses(), arches(), rolling(), piles()].into_iter().flatten().collect()
}

/// A cube that falls on a plane that is inclined, and one that starts 5 mm above one with all of its face.
fn inclines() -> Vec<OwnScene> {
    let falling = |name, degrees: f64, place: [f64; 3]| {
        let bodies = json!([
            { "mesh": "cube.obj", "position": place },
            { "mesh": "plane.obj", "position": [0, -1, 0], "rotation": [0, 0, -degrees], "type": "static" }
        ]);
        OwnScene::new(name, 3.0, 9.8, &bodies)
    };
    let flush = json!([
        { "mesh": "cube.obj", "rotation": [0, 0, -26.565] },
        { "mesh": "plane.obj", "position": [2, -1.565, 0], "rotation": [0, 0, -26.565], "type": "static" }
    ]);
    vec![
        falling("cube on an incline of 15 degrees", 15.0, [-3.0, 1.5, 0.0]),
        falling("cube on an incline of 30 degrees", 30.0, [-3.0, 3.0, 0.0]),
        falling("cube on an incline of 45 degrees", 45.0, [-2.5, 3.0, 0.0]),
        falling("cube on an incline of 85 degrees", 85.0, [0.25, 5.0, 0.0]),
        OwnScene::new("cube flush on an incline of 26.565 degrees", 3.0, 9.8, &flush),
    ]
}

/// Height of the middle of a leaning card above what it stands on, m: half of its height and some air.
const CARD_RISE: f64 = 1.208_303_084_885_93;

fn card(x: f64, y: f64, turn: f64) -> Value {
    json!({
        "mesh": "cube.obj", "scale": [2.5, 0.02, 1.25], "position": [x, y, 0], "rotation": [0, 0, turn], "density": 100
    })
}

/// A house of cards of 2.5 m by 1.25 m and 2 cm that lean by 65 degrees. Cards that lie are turned by a degree, so that
/// the end of one lies over that of the next.
fn card_house(levels: u32) -> Value {
    let mut bodies = vec![json!({ "mesh": "plane.obj", "type": "static" })];
    for level in 0..levels {
        let tents = levels - level;
        let y = CARD_RISE * (1.0 + 2.0 * f64::from(level));
        let middle = |count: u32, index: u32| 2.2 * (f64::from(index) - 0.5 * f64::from(count - 1));
        for tent in 0..tents {
            let x = middle(tents, tent);
            bodies.extend([card(x - 0.55, y, 65.0), card(x + 0.55, y, -65.0)]);
        }
        bodies.extend((1..tents).map(|lying| card(middle(tents - 1, lying - 1), y + CARD_RISE, -1.0)));
    }
    Value::Array(bodies)
}

fn card_houses() -> Vec<OwnScene> {
    vec![
        OwnScene::new("card house of 2 levels", 2.0, 9.8, &card_house(2)),
        OwnScene::new("card house of 3 levels", 2.0, 9.8, &card_house(3)),
    ]
}

/// A half circle of stones.
fn arches() -> Vec<OwnScene> {
    let mut bodies = vec![json!({ "mesh": "plane.obj", "scale": 10, "type": "static" })];
    bodies.extend((0..round::STONES).map(|stone| {
        let turn = 180.0 * (f64::from(stone) + 0.5) / f64::from(round::STONES);
        json!({ "mesh": "stone.obj", "rotation": [0, 0, turn], "density": 1000 })
    }));
    vec![OwnScene::new("arch of 25 stones", 3.0, 9.8, &Value::Array(bodies))]
}

/// A coin that spins on its rim, an oloid, a cone, a sphericon.
fn rolling() -> Vec<OwnScene> {
    let on = |name, duration: f64, height: f64, size: f64, body: Value| {
        let ground = json!({ "mesh": "plane.obj", "position": [0, height, 0], "scale": size, "type": "static" });
        OwnScene::new(name, duration, 9.8, &json!([ground, body]))
    };
    vec![
        on(
            "spolling coin",
            1.25,
            -0.0123,
            0.01,
            json!({
                "mesh": "coin.obj", "scale": [0.024_26, 0.024_26, 0.001_75], "rotation": [-5, 0, 0],
                "angular_velocity": [0, 900, 0], "density": 8900
            }),
        ),
        on(
            "rolling oloid",
            2.0,
            -0.05,
            0.1,
            json!({
                "mesh": "oloid.obj", "scale": 0.05, "position": [-0.4, 0, 0], "rotation": [60, 0, 0],
                "linear_velocity": [0.5, 0, 0], "force": [0.05, 0, 0]
            }),
        ),
        on(
            "rolling cone",
            2.0,
            -0.074,
            0.05,
            json!({
                "mesh": "cone.obj", "position": [-0.1, -0.039, 0], "rotation": [27, 0, 0],
                "linear_velocity": [0.3, 0, 0]
            }),
        ),
        on(
            "rolling sphericon",
            5.0,
            -1.0,
            2.0,
            json!({ "mesh": "sphericon.obj", "position": [0, 0.5, 0], "rotation": [10, 20, 45] }),
        ),
    ]
}

/// Bodies of several forms that fall into an open box of 2 m.
fn piles() -> Vec<OwnScene> {
    let wall = |x: f64, z: f64| {
        let scale = if x == 0.0 { [2.2, 3.0, 0.1] } else { [0.1, 3.0, 2.0] };
        json!({ "mesh": "cube.obj", "position": [x, 1.5, z], "scale": scale, "type": "static" })
    };
    let pile = |name, count: u32, duration: f64| {
        let mut bodies = vec![json!({ "mesh": "plane.obj", "type": "static" })];
        bodies.extend([wall(1.05, 0.0), wall(-1.05, 0.0), wall(0.0, 1.05), wall(0.0, -1.05)]);
        let forms = [("cube.obj", 0.5), ("pyramid.obj", 0.7), ("wedge.obj", 0.25), ("ball.obj", 0.3)];
        bodies.extend((0..count).map(|number| {
            let (mesh, scale) = forms[number as usize % forms.len()];
            let at = |step: u32| f64::from(step * number % 7) * 0.1 - 0.3;
            let turn = [37, 53, 71].map(|step| f64::from(step * number % 90));
            let y = 0.6 + 0.9 * f64::from(number);
            json!({ "mesh": mesh, "scale": scale, "position": [at(3), y, at(5)], "rotation": turn })
        }));
        OwnScene::new(name, duration, 9.8, &Value::Array(bodies))
    };
    vec![pile("pile of 8 bodies", 8, 3.0), pile("pile of 16 bodies", 16, 3.0)]
}
