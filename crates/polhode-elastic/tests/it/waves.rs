//! Waves in a confined bar: with steps at the limit a wave moves by one element a step, keeping its shape to rounding:
//! its speed is c_p and nothing disperses. At shorter steps the error goes with the square of the size of the elements.

use crate::rubber;
use polhode_elastic::{Cells, DVec2, ElasticBody, ElasticRun, Guide, NodeStates, QuadMesh};
use std::f64::consts::PI;

const ROWS: usize = 64;

/// A bar of one metre.
fn bar(rows: usize) -> ElasticBody {
    let mesh = QuadMesh::rectangle(0.1, 1.0, Cells { columns: 1, rows }).unwrap();
    ElasticBody::new(mesh, rubber(), Guide::Vertical)
}

/// A bump around the middle of the bar, in units of rows.
fn bump(row: f64) -> f64 {
    let place = (row - 20.0) / 8.0;
    if place.abs() < 1.0 { 1e-3 * (1.0 + libm::cos(PI * place)) } else { 0.0 }
}

#[test]
fn a_wave_moves_by_one_element_a_step() {
    let body = bar(ROWS);
    let step_s = body.longest_step_s();
    assert!((step_s * rubber().dilatational_speed() * ROWS as f64 - 1.0).abs() < 1e-10);
    let row = |node: usize| (node / 2) as f64;
    let mut states = NodeStates::moving(&body, DVec2::ZERO);
    for (node, u) in states.displacements.iter_mut().enumerate() {
        u.y = bump(row(node));
        states.velocities[node].y = (bump(row(node) - 1.0) - bump(row(node) + 1.0)) / (2.0 * step_s);
    }
    let mut run = ElasticRun::new(body, None, states, step_s).unwrap();
    for _ in 0..30 {
        run.step().unwrap();
    }
    for (node, u) in run.displacements().iter().enumerate() {
        assert!((u.y - bump(row(node) - 30.0)).abs() < 1e-11, "node {node}: {u}");
    }
}

/// How far the slowest vibration of the bar is from its closed form after a quarter of its period, relative.
fn standing(rows: usize) -> f64 {
    let body = bar(rows);
    let quarter_s = 0.5 / rubber().dilatational_speed();
    let steps = (quarter_s / (0.6 * body.longest_step_s())).round();
    let mut states = NodeStates::moving(&body, DVec2::ZERO);
    for (u, place) in states.displacements.iter_mut().zip(body.mesh().nodes()) {
        u.y = 1e-3 * libm::cos(PI * place.y);
    }
    let mut run = ElasticRun::new(body, None, states, quarter_s / steps).unwrap();
    for _ in 0..steps as usize {
        run.step().unwrap();
    }
    run.displacements().iter().fold(0.0, |worst: f64, u| worst.max(u.y.abs())) / 1e-3
}

#[test]
fn shorter_steps_converge_with_order_two() {
    let errors = [12, 24, 48].map(standing);
    for pair in errors.windows(2) {
        assert!((3.5..4.5).contains(&(pair[0] / pair[1])), "{errors:?}");
    }
}
