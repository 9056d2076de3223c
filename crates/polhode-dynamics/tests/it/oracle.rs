//! The exact rotation against 320 free rotations computed to 40 digits (recipe at the top of the file of data):
//! momentum to 5e-14, attitude to 1e-13 rad, whichever branch computes it.

use glam::{DQuat, DVec3};
use polhode_dynamics::FreeRotation;
use polhode_dynamics::exact_rotation::drift;
use polhode_spatial::Rotation;

const CASES: &str = include_str!("data/free_rotation.csv");

struct Case {
    kind: &'static str,
    moments: DVec3,
    momentum: DVec3,
    h: f64,
    attitude: Rotation,
    momentum_after: DVec3,
}

fn cases() -> Vec<Case> {
    CASES
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| {
            let (kind, numbers) = line.split_once(',').unwrap();
            let n: Vec<f64> = numbers.split(',').map(|x| x.parse().unwrap()).collect();
            Case {
                kind,
                moments: DVec3::new(n[0], n[1], n[2]),
                momentum: DVec3::new(n[3], n[4], n[5]),
                h: n[6],
                attitude: Rotation::renormalized(DQuat::from_xyzw(n[8], n[9], n[10], n[7])),
                momentum_after: DVec3::new(n[11], n[12], n[13]),
            }
        })
        .collect()
}

/// Errors of attitude (rad) and momentum (relative).
fn errors(case: &Case, attitude: Rotation) -> (f64, f64) {
    let momentum = attitude.inverse_rotate(case.momentum);
    (attitude.angle_to(case.attitude), (momentum - case.momentum_after).length() / case.momentum.length())
}

#[test]
fn every_case_is_met() {
    let cases = cases();
    assert_eq!(cases.len(), 320);
    let mut worst = (0.0f64, 0.0f64);
    for case in &cases {
        let flight = FreeRotation::new(case.moments, Rotation::IDENTITY, case.momentum);
        let chosen = flight.at(case.h);
        let others = [flight.at_by_elliptic_functions(case.h), flight.at_by_taylor(case.h)];
        for attitude in others.into_iter().flatten().chain([chosen]) {
            let (angle, momentum) = errors(case, attitude);
            assert!(
                angle <= 1e-13,
                "{}: attitude off by {angle:e} rad at {} {}",
                case.kind,
                case.moments,
                case.momentum
            );
            assert!(
                momentum <= 5e-14,
                "{}: momentum off by {momentum:e} at {} {}",
                case.kind,
                case.moments,
                case.momentum
            );
            worst = (worst.0.max(angle), worst.1.max(momentum));
        }
        let once = drift(case.moments, Rotation::IDENTITY, case.momentum, case.h);
        assert_eq!(once.to_wxyz().map(f64::to_bits), chosen.to_wxyz().map(f64::to_bits), "drift and at differ");
    }
    println!("worst attitude {:.1e} rad, momentum {:.1e} of {} cases", worst.0, worst.1, cases.len());
}
