//! Lame's modes: a free square of side L has vibrations in closed form, `u = (-cos kx sin kz, sin kx cos kz) cos(omega
//! t)` with `k = pi / L` and `omega = sqrt(2) k c_s`, whose stress vanishes on all four sides. Their volume does not
//! change, so that the Poisson ratio must not matter. They show the order of convergence of elements, masses and steps
//! together, and that nothing locks. Source: docs/REFERENCES.md, Achenbach 1973.

use polhode_elastic::{Cells, DVec2, ElasticBody, ElasticMaterial, ElasticRun, Guide, NodeStates, QuadMesh};
use std::f64::consts::{FRAC_1_SQRT_2, PI};

/// So small that the motion is linear.
const AMPLITUDE: f64 = 1e-9;

/// What is left of a mode of a square metre after a quarter of its period, when nothing should be, relative.
fn left_after_a_quarter(poisson: f64, cells: usize) -> f64 {
    let material = ElasticMaterial::new(1e6, poisson, 1000.0).unwrap();
    let mesh = QuadMesh::rectangle(1.0, 1.0, Cells { columns: cells, rows: cells }).unwrap();
    let body = ElasticBody::new(mesh, material, Guide::Free);
    let mut states = NodeStates::moving(&body, DVec2::ZERO);
    let mode = |place: &DVec2| {
        let (x, z) = (PI * (place.x + 0.5), PI * place.y);
        DVec2::new(-libm::cos(x) * libm::sin(z), libm::sin(x) * libm::cos(z)) * AMPLITUDE
    };
    states.displacements = body.mesh().nodes().iter().map(mode).collect();
    let quarter_s = 0.5 * FRAC_1_SQRT_2 / material.shear_speed();
    let steps = (quarter_s / (0.9 * body.longest_step_s())).ceil();
    let mut run = ElasticRun::new(body, None, states, quarter_s / steps).unwrap();
    for _ in 0..steps as usize {
        run.step().unwrap();
    }
    run.displacements().iter().fold(0.0, |worst: f64, u| worst.max(u.length())) / AMPLITUDE
}

#[test]
fn a_mode_converges_with_order_two() {
    let errors = [8, 16, 32].map(|cells| left_after_a_quarter(0.3, cells));
    for pair in errors.windows(2) {
        let order = libm::log2(pair[0] / pair[1]);
        assert!((1.8..2.3).contains(&order), "{errors:?}: {order}");
    }
    assert!(errors[2] < 6e-3, "{errors:?}");
}

#[test]
fn a_solid_that_keeps_its_volume_does_not_lock() {
    let (soft, hard) = (left_after_a_quarter(0.3, 8), left_after_a_quarter(0.499, 8));
    assert!(hard < 2.0 * soft, "{soft} {hard}");
}
