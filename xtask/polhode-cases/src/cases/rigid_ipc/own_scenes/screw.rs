//! A screw that turns itself down in a nut. Both are helices of flat triangles: a profile in the plane of axis and
//! radius goes round the axis, y, in steps and rises by a pitch in a turn, where its end meets its start of one turn
//! on.

use super::OwnScene;
use super::meshes::{Made, on_circle};
use glam::DVec3;
use polhode::mesh::TriangleMesh;
use serde_json::json;
use std::error::Error;
use std::f64::consts::TAU;

/// Steps of a turn.
const STEPS: u32 = 12;
/// How far a turn rises, m.
const PITCH: f64 = 0.8;
/// Radius of the screw at the ground of its thread and at its crest, m.
const RADII: [f64; 2] = [0.6, 1.0];
/// How much wider the nut is, m: corners of the screw are farther out than sides of the nut of the same radius.
const PLAY: f64 = 0.06;
/// Turns of both.
const TURNS: [u32; 2] = [2, 1];

/// The mesh files that only this scene names.
pub(super) fn mesh_files() -> Result<Vec<(&'static str, TriangleMesh)>, Box<dyn Error>> {
    Ok(vec![("screw.obj", screw()?), ("nut.obj", nut()?)])
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    let bodies = json!([
        { "mesh": "nut.obj", "position": [0, 0.4, 0], "rotation": [0, 180, 0], "type": "static" },
        { "mesh": "screw.obj", "density": 8050 }
    ]);
    vec![OwnScene::new("screw in a nut", 2.0, 9.81, &bodies)]
}

/// A helix of so many turns, as a surface that is open at its ends.
struct Helix {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Corners of its lower and its upper rim, in order.
    rims: [Vec<u32>; 2],
}

/// Corners of the profile: radius as a part of the way from ground to crest, height as a part of the pitch.
const PROFILE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.35], [1.0, 0.45], [0.0, 0.8]];

impl Helix {
    fn new(turns: u32, wider: f64) -> Self {
        let (steps, corners) = (turns * STEPS, PROFILE.len() as u32);
        // Corners of the profile after each step, then the first ones alone of one turn more.
        let first_of_last_turn = (steps + 1) * corners;
        let index = |step: u32, corner: u32| {
            // The profile ends where it starts one turn on.
            let (step, corner) = if corner == corners { (step + STEPS, 0) } else { (step, corner) };
            if step > steps { first_of_last_turn + step - steps - 1 } else { step * corners + corner }
        };
        let mut vertices = Vec::new();
        for step in 0..=steps + STEPS {
            let count = if step <= steps { PROFILE.len() } else { 1 };
            let part = f64::from(step) / f64::from(STEPS);
            for &[out, up] in &PROFILE[..count] {
                let radius = RADII[0] + wider + out * (RADII[1] - RADII[0]);
                let [x, z] = on_circle(radius, TAU * f64::from(step % STEPS) / f64::from(STEPS));
                vertices.push(DVec3::new(x, PITCH * (part + up), -z));
            }
        }
        let mut triangles = Vec::new();
        for step in 0..steps {
            for corner in 0..corners {
                let [a, b] = [index(step, corner), index(step + 1, corner)];
                let [c, d] = [index(step, corner + 1), index(step + 1, corner + 1)];
                triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        let along = |from: u32| (from..=from + STEPS).map(move |step| index(step, 0));
        let beside = |step: u32| (1..corners).rev().map(move |corner| index(step, corner));
        let lower = along(0).chain(beside(0)).collect();
        let upper = along(steps).chain(beside(steps)).collect();
        Self { vertices, triangles, rims: [lower, upper] }
    }
}

/// The helix closed at both ends by triangles to a corner on the axis.
fn screw() -> Made {
    let Helix { mut vertices, mut triangles, rims: [lower, upper] } = Helix::new(TURNS[0], 0.0);
    let ends = [0.0, PITCH * f64::from(TURNS[0] + 1)];
    for (rim, (y, is_upper)) in [lower, upper].into_iter().zip(ends.into_iter().zip([false, true])) {
        let apex = vertices.len() as u32;
        vertices.push(DVec3::Y * y);
        for (place, &corner) in rim.iter().enumerate() {
            let next = rim[(place + 1) % rim.len()];
            triangles.push(if is_upper { [corner, next, apex] } else { [next, corner, apex] });
        }
    }
    Ok(TriangleMesh::new(vertices, triangles)?)
}

/// The surface that the screw turns in, a sheet, seen from the axis.
fn nut() -> Made {
    let Helix { vertices, triangles, .. } = Helix::new(TURNS[1], PLAY);
    Ok(TriangleMesh::new(vertices, triangles)?.flipped())
}

#[cfg(test)]
mod tests {
    //! The screw is closed, and as large as a solid is whose cross-section turns.
    use super::*;
    use polhode::mesh::SolidMesh;

    #[test]
    fn the_screw_is_a_solid_of_between_its_two_radii() {
        let solid = SolidMesh::new(screw().expect("a mesh")).expect("a solid");
        let polygon = 0.5 * f64::from(STEPS) * libm::sin(TAU / f64::from(STEPS));
        let [least, most] = RADII.map(|radius| polygon * radius * radius * PITCH * f64::from(TURNS[0]));
        let volume = solid.volume_integrals().volume;
        assert!(least < volume && volume < most, "{volume}, expected between {least} and {most}");
    }
}
