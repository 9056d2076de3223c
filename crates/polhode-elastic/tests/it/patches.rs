//! The patch test: a uniform strain, however large and however the body is turned, is reproduced exactly by elements of
//! any shape. Nodes inside have no force, and all elements the same stress. A rotation gives none. Whatever fails this
//! does not converge to the right solution on every mesh.

use crate::rubber;
use polhode_elastic::{DMat2, DVec2, ElasticBody, ElasticRun, Guide, NodeStates, QuadMesh};

/// Five elements around a skew one in the middle of a rectangle (MacNeal and Harder's patch).
fn patch() -> ElasticBody {
    let nodes =
        [[0.0, 0.0], [0.24, 0.0], [0.24, 0.12], [0.0, 0.12], [0.04, 0.02], [0.18, 0.03], [0.16, 0.08], [0.08, 0.08]];
    let corners = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let mesh = QuadMesh::new(nodes.map(DVec2::from_array).to_vec(), &corners).unwrap();
    ElasticBody::new(mesh, rubber(), Guide::Free)
}

/// The patch with every node displaced by H times its place.
fn displaced(h: DMat2) -> ElasticRun {
    let body = patch();
    let mut states = NodeStates::moving(&body, DVec2::ZERO);
    states.displacements = body.mesh().nodes().iter().map(|place| h * *place).collect();
    let step_s = 0.5 * body.longest_step_s();
    ElasticRun::new(body, None, states, step_s).unwrap()
}

fn rotation(angle: f64) -> DMat2 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    DMat2::from_cols_array(&[cos, sin, -sin, cos])
}

#[test]
fn the_outline_of_a_patch_is_its_outline() {
    assert_eq!(patch().mesh().boundary(), [0, 1, 2, 3]);
}

#[test]
fn a_uniform_strain_is_exact_on_any_mesh() {
    for (strain, angle) in [(1e-6, 0.0), (0.2, 0.0), (0.2, 2.5)] {
        let stretch =
            DMat2::from_cols(DVec2::new(1.0 + strain, 0.5 * strain), DVec2::new(-0.3 * strain, 1.0 - 0.7 * strain));
        let run = displaced(rotation(angle) * stretch - DMat2::IDENTITY);
        let scale = strain * rubber().young() * 0.1;
        for (node, force) in run.forces().iter().enumerate().skip(4) {
            assert!(force.length() < 1e-9 * scale, "node {node}: {force}");
        }
        let stresses = run.body().stresses(run.displacements()).unwrap();
        for stress in &stresses {
            let off = (*stress - stresses[0]).to_cols_array().into_iter().fold(0.0, |worst: f64, x| worst.max(x.abs()));
            assert!(off < 1e-9 * strain * rubber().young(), "{off}");
        }
    }
}

#[test]
fn a_rotation_gives_no_force_and_no_energy() {
    for angle in [0.3, 1.5, 3.0] {
        let run = displaced(rotation(angle) - DMat2::IDENTITY);
        assert!(run.forces().iter().all(|force| force.length() < 1e-9), "{angle}");
        assert!(run.elastic_j() < 1e-20, "{angle}: {}", run.elastic_j());
    }
}

#[test]
fn stress_turns_with_the_body() {
    let strain = DMat2::from_diagonal(DVec2::new(0.1, -0.05));
    let upright = displaced(strain).body().stresses(displaced(strain).displacements()).unwrap()[0];
    let turn = rotation(0.7);
    let run = displaced(turn * (DMat2::IDENTITY + strain) - DMat2::IDENTITY);
    let turned = run.body().stresses(run.displacements()).unwrap()[0];
    let off = turned - turn * upright * turn.transpose();
    assert!(off.to_cols_array().into_iter().all(|x| x.abs() < 1e-8), "{off}");
}
