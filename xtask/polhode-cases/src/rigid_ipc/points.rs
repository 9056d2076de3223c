//! Bodies of corners alone: given in the scene by `vertices`, or by a mesh file without faces.
//!
//! Edges without faces have no counterpart here and are refused.

use super::error::ImportError;
use super::table::Table;
use glam::DVec3;
use serde_json::Value;
use std::fs;
use std::path::Path;

const EDGES: &str = "bodies of edges without faces are not available";

/// The corners of a body that names no mesh file.
pub(super) fn of_scene(body: &mut Table<'_>) -> Result<Vec<DVec3>, ImportError> {
    let Some(positions) = body.vectors("vertices")?.filter(|positions| !positions.is_empty()) else {
        return Err(body.refuse("mesh", "absent, and there are no `vertices` either"));
    };
    for key in ["faces", "polygons", "edges"] {
        if body.value(key).and_then(Value::as_array).is_some_and(|list| !list.is_empty()) {
            let message =
                if key == "edges" { EDGES } else { "bodies given by `vertices` have points alone: name a mesh file" };
            return Err(body.refuse(key, message));
        }
    }
    Ok(positions)
}

/// The corners of an OBJ file that has no faces; nothing when it has, or when it cannot be read: the reader of meshes
/// then says why.
pub(super) fn of_file(path: &Path, body: &Table<'_>) -> Result<Option<Vec<DVec3>>, ImportError> {
    if path.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("obj")) {
        return Ok(None);
    }
    let Ok(bytes) = fs::read(path) else { return Ok(None) };
    let text = String::from_utf8_lossy(&bytes);
    let mut positions = Vec::new();
    let mut has_edges = false;
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("f") => return Ok(None),
            Some("l") => has_edges = true,
            Some("v") => {
                let numbers: Vec<f64> = words.take(3).map_while(|word| word.parse().ok()).collect();
                let &[x, y, z] = numbers.as_slice() else { return Ok(None) };
                positions.push(DVec3::new(x, y, z));
            }
            _ => {}
        }
    }
    if has_edges { Err(body.refuse("mesh", EDGES)) } else { Ok(Some(positions).filter(|found| !found.is_empty())) }
}

#[cfg(test)]
mod tests {
    //! What a body without faces is taken over as, and what of it is refused.
    use crate::rigid_ipc::{HeldRotations, import};
    use serde_json::{Value, json};
    use std::fs;

    /// The text of a scene of one body, or why it is refused; `cloud.obj` and `wire.obj` lie beside it.
    fn of_body(body: &Value) -> Result<String, String> {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("written");
        write("cloud.obj", "# three\nv 0 0 0\nv 1 0 0.5\nv 0 2 0\n");
        write("wire.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
        write("scene.json", &json!({ "max_time": 1, "rigid_body_problem": { "rigid_bodies": [body] } }).to_string());
        import(&folder.path().join("scene.json"), None, HeldRotations::Refused)
            .map(|imported| imported.text)
            .map_err(|error| error.to_string())
    }

    #[test]
    fn corners_without_faces_become_points_at_their_size() {
        let corners = json!([[0, 0, 0], [1, 0, 0.5], [0, 2, 0]]);
        let given = of_body(&json!({ "vertices": corners, "scale": [2, 1, 4], "type": "static" })).expect("taken over");
        let read = of_body(&json!({ "mesh": "cloud.obj", "dimensions": [2, 2, 2], "type": "static" })).expect("too");
        let positions = |text: &str| text.lines().find(|line| line.starts_with("positions")).map(str::to_owned);
        assert_eq!(
            positions(&given).as_deref(),
            Some("positions = [[0.0, 0.0, 0.0], [2.0, 0.0, 2.0], [0.0, 2.0, 0.0]]")
        );
        assert_eq!(positions(&read), positions(&given));
    }

    #[test]
    fn edges_without_faces_and_points_that_move_are_refused_by_name() {
        let corners = json!([[0, 0, 0], [1, 0, 0]]);
        for (body, told) in [
            (json!({ "vertices": corners, "edges": [[0, 1]], "type": "static" }), "[0].edges: bodies of edges"),
            (json!({ "mesh": "wire.obj", "type": "static" }), "[0].mesh: bodies of edges"),
            (json!({ "vertices": corners }), "[0].type: points without faces"),
            (json!({ "type": "static" }), "[0].mesh: absent, and there are no `vertices`"),
        ] {
            let error = of_body(&body).expect_err("refused");
            assert!(error.contains(told), "{error}");
        }
    }
}
