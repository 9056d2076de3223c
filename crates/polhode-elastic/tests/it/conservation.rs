//! Energy and momentum: what a body that turns and vibrates has is constant; what the floor gives is booked. The
//! ledgers are sums of other terms than the energies and momenta themselves, so that they close to rounding only if
//! forces are the derivative of the energy, internal forces balance, and impulses are where they act.

use crate::rubber;
use polhode_elastic::{Cells, DVec2, ElasticBody, ElasticRun, Guide, NodeStates, QuadMesh, RectangleDrop};
use std::f64::consts::TAU;

/// A rectangle that turns, and begins squeezed.
fn spinning(strain: f64, spin: f64) -> ElasticRun {
    let mesh = QuadMesh::rectangle(1.0, 0.5, Cells { columns: 8, rows: 4 }).unwrap();
    let body = ElasticBody::new(mesh, rubber(), Guide::Free);
    let center = DVec2::new(0.0, 0.25);
    let mut states = NodeStates::moving(&body, DVec2::ZERO);
    for (node, place) in body.mesh().nodes().iter().enumerate() {
        let arm = *place - center;
        states.displacements[node] = arm * strain;
        states.velocities[node] = DVec2::new(arm.y, -arm.x) * (spin * (1.0 + strain));
    }
    let step_s = 0.5 * body.longest_step_s();
    ElasticRun::new(body, None, states, step_s).unwrap()
}

#[test]
fn a_free_body_keeps_energy_and_momenta() {
    let mut run = spinning(-0.05, 2.0);
    let spin = run.momentum().initial.angular;
    for _ in 0..2000 {
        run.step().unwrap();
        let (energy, momentum) = (run.energy(), run.momentum());
        assert!(energy.residual_j().abs() < 1e-11 * energy.initial_j, "{energy:?}");
        assert!(energy.numerical_j.abs() < 1e-2 * energy.initial_j, "{energy:?}");
        assert!(momentum.now.linear.length() < 1e-10, "{momentum:?}");
        assert!((momentum.now.angular - spin).abs() < 1e-11 * spin, "{momentum:?}");
    }
}

#[test]
fn what_the_steps_add_goes_with_their_square() {
    let added = |parts: usize| {
        let start = spinning(-0.05, 2.0);
        let states =
            NodeStates { displacements: start.displacements().to_vec(), velocities: start.velocities().to_vec() };
        let (body, step_s) = (start.body().clone(), start.step_s() / parts as f64);
        let mut run = ElasticRun::new(body, None, states, step_s).unwrap();
        let worst = (0..200 * parts).map(|_| {
            run.step().unwrap();
            run.energy().numerical_j.abs()
        });
        worst.fold(0.0, f64::max)
    };
    let (coarse, fine) = (added(1), added(2));
    assert!((3.0..5.5).contains(&(coarse / fine)), "{coarse} {fine}");
}

#[test]
fn a_body_turns_as_a_rigid_one_while_it_is_stiff() {
    // Slowly, against the speed of its waves: 0.3 m/s at its corners, and 37 m/s.
    let spin = 0.5;
    let mut run = spinning(0.0, spin);
    let nodes = run.body().mesh().nodes().to_vec();
    let (left, right) = (18, 26);
    while run.time_s() < 0.75 * TAU / spin {
        run.step().unwrap();
    }
    let place = |node: usize| nodes[node] + run.displacements()[node];
    let along = place(right) - place(left);
    // About y, z towards x: x goes to -z.
    let angle = libm::atan2(-along.y, along.x).rem_euclid(TAU);
    assert!((angle - spin * run.time_s()).abs() < 5e-3, "{angle}");
    assert!(run.elastic_j() < 1e-3 * run.energy().initial_j);
}

#[test]
fn ledgers_close_over_a_tilted_drop() {
    let drop = RectangleDrop::new(2.0, 1.0, rubber(), 1.0).unwrap().tilted(0.3).unwrap();
    let mut run = drop.start(drop.cells(200)).unwrap();
    let (mass, before) = (run.body().mass(), run.energy().initial_j);
    for _ in 0..400 {
        run.step().unwrap();
        let (energy, residual) = (run.energy(), run.momentum().residual());
        assert!(energy.residual_j().abs() < 1e-12 * before, "{energy:?}");
        assert!(residual.linear.length() < 1e-12 * mass, "{residual:?}");
        assert!(residual.angular.abs() < 1e-12 * mass, "{residual:?}");
    }
    assert!(run.contact_times().is_some());
}
