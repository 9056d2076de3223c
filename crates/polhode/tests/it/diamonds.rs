//! The frictionless diamonds of Videos 12-15: m = 2, 3, 4 stand, m = 5 falls, and falls symmetrically.

use crate::support::{Sides, diamond, run};
use polhode::{Effects, Simulation};

/// Standing diamonds do not move, to 1e-9 m, with every effect computed at every step; the planned effects give the
/// same bits.
#[test]
fn stable_diamonds_stand_still() {
    for m in 2..=4 {
        let scene = diamond(m, Sides::Touch).duration_s(1.0).output_interval_s(0.5).build().unwrap();
        let (report, recorder) = run(&scene, Effects::All);
        for (start, end) in recorder.samples[0].iter().zip(recorder.samples.last().unwrap()) {
            assert!((start.pose.translation - end.pose.translation).length() < 1e-9);
        }
        assert!(report.certificate.max_penetration_m <= 1e-12);
        assert!(report.ledger.closure_relative() < 1e-12);
        let (planned, _) = run(&scene, Effects::Planned);
        assert_eq!(planned.bodies, report.bodies);
    }
}

/// Cases RC-02 and RC-03: the accelerations of the 5-diamond at the first instant, without and with contact between the
/// bricks of a row. They are unique, although the contact forces are not.
#[test]
fn five_diamond_accelerates_as_the_exact_problem_says() {
    for (sides, rightmost_brick, power) in [
        (Sides::Ignore, [0.0, -2.571_776_332_899_87, -2.939_172_951_885_565_6], 21.624_964_993_498_05),
        (
            Sides::Touch,
            [0.357_087_967_644_084_96, -2.499_615_773_508_594_4, -2.856_703_741_152_679_7],
            21.018_197_775_530_84,
        ),
    ] {
        let scene = diamond(5, sides).build().unwrap();
        let accelerations = Simulation::new(&scene).unwrap().accelerations().unwrap();
        let right = scene.bodies().iter().position(|body| body.name() == "r5c5").unwrap();
        let found = accelerations[right];
        // Anticlockwise about the axis that points away from the reader of the plane x-z is -y.
        for (value, expected) in [found.linear.x, found.linear.z, -found.angular.y].into_iter().zip(rightmost_brick) {
            assert!((value - expected).abs() < 1e-10, "{found:?}");
        }
        let sum: f64 = accelerations.iter().map(|a| -9.81 * a.linear.z).sum();
        assert!((sum / power - 1.0).abs() < 1e-10);
    }
}

/// The 5-diamond falls, and the motion stays mirror symmetric: left to right, and front to back.
#[test]
fn five_diamond_falls_symmetrically() {
    let scene = diamond(5, Sides::Touch).duration_s(0.7).output_interval_s(0.01).build().unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    let mut moved = 0.0f64;
    let mut asymmetry = 0.0f64;
    for sample in &recorder.samples {
        moved = moved.max(
            sample
                .iter()
                .zip(&recorder.samples[0])
                .map(|(s, s0)| (s.pose.translation - s0.pose.translation).length())
                .fold(0.0, f64::max),
        );
        for (i, body) in sample.iter().enumerate().skip(1) {
            let p = body.pose.translation;
            let start = recorder.samples[0][i].pose.translation;
            let twin = (1..sample.len())
                .find(|&j| {
                    let s = recorder.samples[0][j].pose.translation;
                    (s.x + start.x).abs() < 1e-9 && (s.z - start.z).abs() < 1e-9
                })
                .unwrap();
            let q = sample[twin].pose.translation;
            asymmetry = asymmetry.max((p.x + q.x).abs()).max((p.z - q.z).abs()).max(p.y.abs());
        }
        if moved > 0.5 {
            break;
        }
    }
    assert!(moved > 0.5);
    assert!(report.certificate.max_penetration_m <= 1e-12);
    assert!(report.ledger.closure_relative() < 1e-12);
    assert!(asymmetry < 1e-9, "{asymmetry:e}");
}
