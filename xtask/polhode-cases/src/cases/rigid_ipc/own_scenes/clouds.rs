//! Bodies that fall on fixed points without edges and faces: the suite's codimensional points.

use super::OwnScene;
use serde_json::json;
use std::fmt::Write;

/// Files of corners without faces.
pub(super) fn files() -> Vec<(&'static str, String)> {
    vec![
        ("plane-of-points.obj", grid(20, 0.2, |_, _| 0.0)),
        ("hills-of-points.obj", grid(20, 0.1, |x, z| 0.125 * libm::sin(4.0 * x) * libm::cos(4.0 * z))),
    ]
}

/// The corners of `cells` by `cells` squares about the origin, at these heights.
fn grid(cells: u32, pitch: f64, height: impl Fn(f64, f64) -> f64) -> String {
    let at = |index: u32| pitch * (f64::from(index) - 0.5 * f64::from(cells));
    let mut text = String::new();
    for (x, z) in (0..=cells).flat_map(|row| (0..=cells).map(move |column| (at(row), at(column)))) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "v {x:?} {:?} {z:?}", height(x, z));
    }
    text
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    let plane = json!([
        { "mesh": "pyramid.obj", "position": [0.1, 1, 0.1] },
        { "mesh": "plane-of-points.obj", "type": "static" }
    ]);
    let hole = json!([
        { "mesh": "pyramid.obj", "position": [0, 1, 0], "rotation": [0, 0, 180] },
        {
            "vertices": [[0, 0, 0.433_012_701_9], [-0.5, 0, -0.433_012_701_9], [0.5, 0, -0.433_012_701_9]],
            "scale": 0.25, "type": "static"
        }
    ]);
    let hills = json!([
        { "mesh": "ball.obj", "position": [0.4, 1, 0.1], "scale": 0.25 },
        { "mesh": "hills-of-points.obj", "type": "static" }
    ]);
    vec![
        OwnScene::new("tetrahedron on a plane of points", 3.0, 9.8, &plane),
        OwnScene::new("tetrahedron on three points", 3.0, 9.8, &hole),
        OwnScene::new("ball on hills of points", 3.0, 9.8, &hills),
    ]
}
