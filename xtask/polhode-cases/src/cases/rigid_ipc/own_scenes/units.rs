//! The suite's unit tests.

use super::OwnScene;
use serde_json::{Value, json};

/// A scene of one second.
fn scene(name: &'static str, gravity: f64, bodies: &Value) -> OwnScene {
    OwnScene::new(name, 1.0, gravity, bodies)
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    [features(), degenerate(), tunnels(), planes(), stacks(), rotations()].into_iter().flatten().collect()
}

/// Two tetrahedra, one falling on the other so that the features of the name meet.
fn features() -> Vec<OwnScene> {
    let pair = |name, falling: Value, mesh: &str, turn: [f64; 3]| {
        scene(
            name,
            9.8,
            &json!([falling, { "mesh": mesh, "position": [0, -0.5, 0], "rotation": turn, "type": "static" }]),
        )
    };
    let upright = [0.0; 3];
    vec![
        pair(
            "vertex-vertex",
            json!({"mesh": "pyramid.obj", "position": [0, 0.75, 0], "rotation": [0, 0, 180]}),
            "pyramid.obj",
            upright,
        ),
        pair(
            "vertex-face",
            json!({"mesh": "pyramid.obj", "position": [0, 0.5, 0], "rotation": [0, 0, 180]}),
            "pyramid.obj",
            [0.0, 0.0, 180.0],
        ),
        pair("face-vertex", json!({"mesh": "pyramid.obj", "position": [0, 0.5, -0.1]}), "pyramid.obj", upright),
        pair("edge-edge", json!({"mesh": "crossed.obj", "position": [0, 0.5, 0]}), "crossed.obj", upright),
        pair(
            "edge-edge-parallel",
            json!({"mesh": "crossed.obj", "position": [0, 0.5, 0], "rotation": [0, 90, 0]}),
            "crossed.obj",
            upright,
        ),
        pair("corner on corner", json!({"mesh": "corner.obj", "position": [0, 0.7, 0]}), "corner.obj", upright),
        scene(
            "corner among cubes",
            9.81,
            &json!([
                { "mesh": "plane.obj", "position": [0, -0.5, 0], "type": "static" },
                { "mesh": "cube.obj", "position": [-1, 0, 0], "type": "static" },
                { "mesh": "cube.obj", "position": [0, 0, -1], "type": "static" },
                { "mesh": "cube.obj", "position": [1, 0, 0], "type": "static" },
                { "mesh": "corner.obj", "position": [-0.4995, 0.6, -0.4995], "scale": 0.999 }
            ]),
        ),
        scene(
            "cube on edge",
            9.8,
            &json!([
                { "mesh": "cube.obj", "position": [0, 3, 0], "rotation": [0, 0, 30] },
                { "mesh": "cube.obj", "position": [0, 1, 0], "rotation": [0, 0, -30], "scale": [2, 1, 1] },
                { "mesh": "plane.obj", "position": [0, -1, 0], "type": "static" }
            ]),
        ),
    ]
}

/// What Erleben finds hard: spikes, wedges, cracks, cliffs, edges within a face.
fn degenerate() -> Vec<OwnScene> {
    let pair = |name, falling: &str, height: f64, ground: &str, depth: f64| {
        scene(
            name,
            9.8,
            &json!([
                { "mesh": falling, "position": [0, height, 0], "rotation": [0, 0, 180] },
                { "mesh": ground, "position": [0, -depth, 0], "type": "static" }
            ]),
        )
    };
    let sliding = |name, mesh: &str, speed: f64| {
        scene(
            name,
            0.0,
            &json!([
                {
                    "mesh": mesh, "position": [-0.49 * speed, 2.0001, 0], "rotation": [0, 0, 180],
                    "linear_velocity": [speed, 0, 0]
                },
                { "mesh": "plane.obj", "position": [0, -1, 0], "type": "static" }
            ]),
        )
    };
    vec![
        pair("spikes", "spike.obj", 3.0001, "spike.obj", 3.0),
        pair("wedges", "wedge.obj", 3.0001, "wedge.obj", 3.0),
        pair("spike and wedge", "spike.obj", 3.0001, "wedge.obj", 3.0),
        scene(
            "spike in crack",
            9.8,
            &json!([
                {
                    "mesh": "spike.obj", "position": [0, 2.0001, 0], "rotation": [0, 0, 180],
                    "linear_velocity": [1, 0, 0], "force": [1, 0, 0]
                },
                { "mesh": "crack.obj", "position": [0, -1, 0], "type": "static" }
            ]),
        ),
        scene(
            "wedge in crack",
            9.8,
            &json!([
                {
                    "mesh": "wedge.obj", "position": [0, 2.001, 0], "rotation": [0, 0, 180],
                    "linear_velocity": [1, 0, 0], "force": [10, 0, 0]
                },
                { "mesh": "crack.obj", "position": [0, -1, 0], "type": "static" }
            ]),
        ),
        sliding("sliding spike", "spike.obj", 10.0),
        sliding("sliding wedge", "wedge.obj", -10.0),
        pair("cliff edges", "cube.obj", 0.05, "cliff.obj", 1.0),
        pair("internal edges", "cube.obj", 0.05, "internal-edges.obj", 1.0),
    ]
}

/// Cubes between walls that are 1 mm from them, and a cube of 1000 m/s at a surface without a thickness.
fn tunnels() -> Vec<OwnScene> {
    let held = json!([false, false, false, true, true, true]);
    let floor = json!({ "mesh": "plane.obj", "position": [0, -0.501, 0], "scale": [0.5, 1, 1], "type": "static" });
    let roof = json!({ "mesh": "plane.obj", "position": [0, 0.501, 0], "scale": [0.5, 1, 1], "type": "static" });
    let wall = |x: f64, turn: f64| {
        json!({
            "mesh": "plane.obj", "position": [x, 0, 0], "rotation": [0, 0, turn], "type": "static"
        })
    };
    vec![
        scene(
            "tunnel of 2 walls",
            0.0,
            &json!([
                floor, roof,
                {
                    "mesh": "cube.obj", "position": [0, 0, -4], "rotation": [0, 90, 0],
                    "linear_velocity": [0, 0, 25], "is_dof_fixed": held
                }
            ]),
        ),
        scene(
            "tunnel of 2 walls of 8192 triangles",
            0.0,
            &json!([
                { "mesh": "plane-8192.obj", "position": [0, -0.501, 0], "type": "static" },
                { "mesh": "plane-8192.obj", "position": [0, 0.501, 0], "type": "static" },
                {
                    "mesh": "cube.obj", "position": [0, 0, -4], "rotation": [0, 90, 0],
                    "linear_velocity": [0, 0, 100], "is_dof_fixed": held
                }
            ]),
        ),
        scene(
            "tunnel of 3 walls",
            0.0,
            &json!([
                floor, wall(-0.501, 90.0), wall(0.501, -90.0),
                { "mesh": "cube.obj", "position": [0, 0, -4.5], "linear_velocity": [0, 0, 25], "is_dof_fixed": held }
            ]),
        ),
        scene(
            "cube of 1000 m/s at a plane",
            0.0,
            &json!([
                { "mesh": "plane.obj", "rotation": [0, 0, 90], "type": "static" },
                {
                    "mesh": "cube.obj", "position": [-5, 0, 0], "rotation": [32, 247, 53],
                    "linear_velocity": [1000, 0, 0]
                }
            ]),
        ),
    ]
}

/// A cube and a tetrahedron that fall on one square in ever more triangles.
fn planes() -> Vec<OwnScene> {
    let on = |name, plane: &str, falling: Value| {
        scene(name, 9.8, &json!([{ "mesh": plane, "position": [0, -0.5, 0], "type": "static" }, falling]))
    };
    let cube = || json!({ "mesh": "cube.obj", "position": [0, 1, 0] });
    vec![
        on("cube on 2 triangles", "plane.obj", cube()),
        on("cube on 8 triangles", "plane-8.obj", cube()),
        on("cube on 512 triangles", "plane-512.obj", cube()),
        on("cube on 8192 triangles", "plane-8192.obj", cube()),
        on(
            "corner on 2 triangles",
            "plane.obj",
            json!({ "mesh": "corner.obj", "position": [0, 1, 0], "rotation": [0, 180, 0] }),
        ),
    ]
}

/// Cubes on each other.
fn stacks() -> Vec<OwnScene> {
    let floor =
        |y: f64, scale: f64| json!({ "mesh": "plane.obj", "position": [0, y, 0], "scale": scale, "type": "static" });
    let cube = |y: f64, scale: f64| json!({ "mesh": "cube.obj", "position": [0, y, 0], "scale": scale });
    vec![
        scene("mass ratio of 1000", 9.8, &json!([floor(-0.5, 2.0), cube(0.1, 1.0), cube(6.0, 10.0)])),
        scene(
            "5 cubes",
            9.8,
            &json!([cube(1.0, 1.0), cube(3.0, 1.0), cube(5.0, 1.0), cube(7.0, 1.0), cube(9.0, 1.0), floor(-1.0, 1.0)]),
        ),
        scene(
            "spinning cube over a plane",
            0.0,
            &json!([
                { "mesh": "cube.obj", "angular_velocity": [0, 180, 0], "density": 7680 },
                { "mesh": "plane.obj", "position": [2, -0.5001, -2], "type": "static" }
            ]),
        ),
    ]
}

/// Bodies that turn and meet nothing.
fn rotations() -> Vec<OwnScene> {
    let alone = |name, body: Value| scene(name, 0.0, &json!([body]));
    let ellipsoid = |spin: [f64; 3]| json!({ "mesh": "ellipsoid.obj", "angular_velocity": spin });
    vec![
        alone(
            "spin about the middle axis",
            json!({
                "mesh": "cube.obj", "scale": [2, 1, 0.5], "rotation": [-3, 0, 0], "angular_velocity": [0, 180, 0]
            }),
        ),
        alone("ellipsoid about its long axis", ellipsoid([180.0, 0.0, 0.0])),
        alone("ellipsoid about its middle axis", ellipsoid([0.0, 180.0, 0.0])),
        alone("ellipsoid about its short axis", ellipsoid([0.0, 0.0, 180.0])),
        alone("cube about an axis of its own", json!({ "mesh": "cube.obj", "angular_velocity": [0.1, 180, 0] })),
        alone("torque", json!({ "mesh": "wedge.obj", "rotation": [90, 0, 0], "torque": [0, 90, 0], "density": 1 })),
    ]
}
