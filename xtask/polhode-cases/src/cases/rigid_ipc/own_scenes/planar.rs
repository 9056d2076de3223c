//! The suite's scenes in the plane, as prisms along z that are 1 m long: Newton's cradles, stacks of planks that are
//! hit, saws, towers, a box that is filled, billiards. Nothing holds them in the plane but their symmetry.

use super::OwnScene;
use super::outlines;
use polhode::mesh::TriangleMesh;
use serde_json::{Value, json};
use std::error::Error;

/// The mesh files that only these scenes name.
pub(super) fn mesh_files() -> Result<Vec<(&'static str, TriangleMesh)>, Box<dyn Error>> {
    Ok(vec![
        ("octagon.obj", outlines::octagon()?),
        ("frame-cradle.obj", outlines::frame([4.8, 4.8], 0.1)?),
        ("frame-stack.obj", outlines::frame([5.5, 8.5475], 0.1)?),
        ("frame-tower.obj", outlines::frame([5.0, 8.0], 0.1)?),
        ("frame-table.obj", outlines::frame([0.99, 0.495], 0.0019)?),
        ("saw.obj", outlines::saw(100)?),
        ("teeth-10.obj", outlines::teeth(10)?),
        ("teeth-100.obj", outlines::teeth(100)?),
        ("funnel.obj", outlines::funnel()?),
        ("vee.obj", outlines::vee()?),
        ("wheel.obj", outlines::wheel()?),
    ])
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    [cradles(), stacks(), saws(), towers(), fillings(), bounces(), others()].into_iter().flatten().collect()
}

/// Octagons in a row, alternately on a corner and on a side; one of 10 m/s hits the first of them.
fn cradles() -> Vec<OwnScene> {
    let cradle = |name, count: u32| {
        let mut bodies =
            vec![json!({ "mesh": "frame-cradle.obj", "position": [0.7, 0, 0], "type": "static" }), octagon(-3.0, 0)];
        bodies[1]["linear_velocity"] = json!([10, 0, 0]);
        bodies.extend((1..count).map(|number| octagon(1.1 * f64::from(number - 1), number)));
        OwnScene::new(name, 5.0, 0.0, &Value::Array(bodies)).with_restitution(1.0)
    };
    vec![cradle("Newton's cradle of 2 octagons", 2), cradle("Newton's cradle of 5 octagons", 5)]
}

/// Octagon `number` of a row.
fn octagon(x: f64, number: u32) -> Value {
    let turn = if number.is_multiple_of(2) { 0.0 } else { 22.5 };
    json!({ "mesh": "octagon.obj", "position": [x, 0, 0], "rotation": [0, 0, turn], "density": 1.414 })
}

/// Ten planks of 10 m by 2 cm, half a metre apart, and a square that is thrown on them.
fn stacks() -> Vec<OwnScene> {
    let stack = |name, speed: f64| {
        let mut bodies = vec![
            json!({ "mesh": "frame-stack.obj", "position": [0, 8.5475, 0], "type": "static" }),
            json!({
                "mesh": "cube.obj", "position": [0, 15.095, 0], "rotation": [0, 0, 10],
                "linear_velocity": [0, -speed, 0], "density": 100
            }),
        ];
        bodies.extend((0..10).map(|plank| {
            let y = 0.505 + 0.51 * f64::from(plank);
            json!({ "mesh": "cube.obj", "scale": [10, 0.02, 1], "position": [0, y, 0], "density": 5 })
        }));
        OwnScene::new(name, 100.0 / speed, 0.0, &Value::Array(bodies)).with_samples_every(0.1 / speed)
    };
    vec![
        stack("10 planks hit at 100 m/s", 100.0),
        stack("10 planks hit at 1,000 m/s", 1_000.0),
        stack("10 planks hit at 10,000 m/s", 10_000.0),
    ]
}

/// A square on a saw, and two saws that fall into each other.
fn saws() -> Vec<OwnScene> {
    let square = |name, restitution: f64| {
        let bodies = json!([
            { "mesh": "saw.obj", "type": "static" },
            { "mesh": "cube.obj", "position": [-0.5, 2.5, 0], "linear_velocity": [1, -1, 0], "density": 10 }
        ]);
        OwnScene::new(name, 5.0, 0.0, &bodies).with_restitution(restitution)
    };
    let interlocking = |name, mesh: &str, teeth: f64| {
        let bodies = json!([
            { "mesh": mesh, "position": [0, 2, 0], "type": "static" },
            { "mesh": mesh, "position": [teeth + 0.5, 5, 0], "rotation": [0, 0, 180], "density": 1 }
        ]);
        OwnScene::new(name, 2.0, 9.81, &bodies)
    };
    vec![
        square("square on a saw", 0.0),
        square("square on a saw, restitution 1", 1.0),
        interlocking("two saws of 10 teeth", "teeth-10.obj", 10.0),
        interlocking("two saws of 100 teeth", "teeth-100.obj", 100.0),
    ]
}

/// Squares that fall on each other: from above one another, from beside one another, each other one on its edge.
fn towers() -> Vec<OwnScene> {
    let tower = |name, count: u32, aside: f64, turn: f64, restitution: f64| {
        let mut bodies = vec![json!({ "mesh": "frame-tower.obj", "position": [0, 8, 0], "type": "static" })];
        bodies.extend((0..count).map(|number| {
            let y = (1.25 + 2.0 * f64::from(number)) * 0.5_f64.sqrt();
            let (x, turn) = if number.is_multiple_of(2) { (0.0, turn) } else { (aside, 0.0) };
            json!({ "mesh": "cube.obj", "position": [x, y, 0], "rotation": [0, 0, turn], "density": 1 })
        }));
        OwnScene::new(name, 2.0, 9.81, &Value::Array(bodies)).with_restitution(restitution)
    };
    vec![
        tower("tower of 4 squares", 4, 0.0, 0.0, 0.0),
        tower("tower of 4 squares, each other one on its edge", 4, 0.0, 45.0, 0.0),
        tower("tower of 4 squares, each other one on its edge, restitution 1", 4, 0.0, 45.0, 1.0),
        tower("tower of 2 squares beside each other", 2, 0.6, 0.0, 0.0),
        tower("tower of 10 squares beside each other", 10, 0.6, 0.0, 0.0),
    ]
}

/// Squares that fall into a box through a funnel, between two walls that are 2 m apart.
fn fillings() -> Vec<OwnScene> {
    let filling = |name, count: u32, restitution: f64, duration: f64| {
        let wall =
            |z: f64| json!({ "mesh": "cube.obj", "scale": [30, 30, 1], "position": [0, 12, z], "type": "static" });
        let mut bodies = vec![json!({ "mesh": "funnel.obj", "type": "static" }), wall(-1.5), wall(1.5)];
        bodies.extend((0..count).map(|number| {
            // Some order that is not regular.
            let [x, turn] = [f64::from(7 * number % 11) * 0.2 - 1.0, f64::from(29 * number % 45)];
            let y = 2.0 + 1.05 * f64::from(number);
            json!({
                "mesh": "cube.obj", "scale": [0.7, 0.7, 1], "position": [x, y, 0], "rotation": [0, 0, turn],
                "density": 2
            })
        }));
        OwnScene::new(name, duration, 9.81, &Value::Array(bodies)).with_restitution(restitution)
    };
    vec![
        filling("filling a box with 2 squares, restitution 1", 2, 1.0, 5.0),
        filling("filling a box with 25 squares", 25, 0.0, 3.0),
    ]
}

/// Squares that bounce without loss on an edge, and beside the end of a plate.
fn bounces() -> Vec<OwnScene> {
    let diamond = |name, speed: f64| {
        let bodies = json!([
            { "mesh": "cube.obj", "scale": [20, 1, 1], "position": [0, 0.5, 0], "type": "static" },
            {
                "mesh": "cube.obj", "scale": [2, 2, 1], "position": [-9, 4, 0], "rotation": [0, 0, 45],
                "linear_velocity": [speed, 0, 0]
            }
        ]);
        OwnScene::new(name, 10.0, 3.0, &bodies).with_restitution(1.0)
    };
    let bypass = json!([
        { "mesh": "cube.obj", "scale": [20, 0.1, 1], "position": [0, 0.05, 0], "type": "static" },
        { "mesh": "cube.obj", "scale": [2, 2, 1], "position": [9.8, 10, 0], "linear_velocity": [0, -80, 0] }
    ]);
    vec![
        diamond("diamond that bounces upright", 0.0),
        diamond("diamond that bounces along", 1.0),
        OwnScene::new("square of 80 m/s at the end of a plate", 1.0, 9.8, &bypass),
    ]
}

/// Billiards, a V that falls on its tip, a wheel that is driven about an axle.
fn others() -> Vec<OwnScene> {
    let ball = |x: f64, y: f64, turn: f64, speed: f64| {
        json!({
            "mesh": "octagon.obj", "scale": [0.057, 0.057, 0.1], "position": [x, y, 0], "rotation": [0, 0, turn],
            "linear_velocity": [speed, 0, 0], "density": 74
        })
    };
    let mut billiards = vec![json!({ "mesh": "frame-table.obj", "type": "static" }), ball(-0.495, 0.0, 0.0, 10.729)];
    for row in 0..5_u32 {
        for place in 0..=row {
            let y = 0.065_55 * (f64::from(place) - 0.5 * f64::from(row));
            let turn = f64::from((29 * row + 17 * place + 24) % 45);
            billiards.push(ball(0.495 + 0.057 * f64::from(row), y, turn, 0.0));
        }
    }
    let vee = json!([
        { "mesh": "plane.obj", "scale": [2, 1, 1], "type": "static" },
        { "mesh": "vee.obj", "linear_velocity": [0, -1, 0] }
    ]);
    let axle = json!([
        { "mesh": "octagon.obj", "scale": [1, 1, 2], "rotation": [0, 0, 22.5], "type": "static" },
        { "mesh": "wheel.obj", "angular_velocity": [0, 0, 31.4], "torque": [0, 0, 1e5], "density": 10.7 }
    ]);
    vec![
        OwnScene::new("billiards", 2.0, 0.0, &Value::Array(billiards)).with_restitution(1.0).with_samples_every(0.001),
        OwnScene::new("V on its tip", 2.0, 0.0, &vee),
        OwnScene::new("wheel about an axle", 2.0, 9.81, &axle),
    ]
}
