//! The pulse law with friction: contacts as springs, while friction stops, turns and reverses the slip.
//!
//! One contact has a closed form, Routh's path to Stronge's end. Given twice, at the same place, it is two springs that
//! move each other, so that the integration must meet the closed form. Without friction the law is that of the chains.
//! It never raises the energy, keeps Coulomb's cone, and knows neither left nor right.

use crate::cases::few;
use polhode_response::friction::FrictionProblem;
use polhode_response::impact::PulseExponent;
use polhode_response::{
    CollisionMatrix, ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings, ImpactStatus,
    Law, MultipleFrictionalImpact, MultipleImpact, MultipleImpactLaw, MultipleImpactSettings, Resistance,
    RestitutionLaw, SingleFrictionalImpact,
};
use proptest::prelude::*;

/// The integration is of steps with an error of 1e-12, in units of the approach; some hundred add up.
const OF_STEPS: f64 = 2e-10;

const EXPONENTS: [PulseExponent; 2] = [PulseExponent::Linear, PulseExponent::Hertz];

/// Contacts of a body, by their rows over its coordinates (with unit masses): normal, tangents, normal, tangents.
fn struck(
    rows: &[Vec<f64>],
    tangents: usize,
    before: &[f64],
    (friction, restitution): (f64, f64),
    exponent: PulseExponent,
) -> MultipleImpact {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let matrix: Vec<f64> = rows.iter().flat_map(|a| rows.iter().map(|b| dot(a, b))).collect();
    let contacts = rows.len() / (1 + tangents);
    let laws = vec![Law::Cone { rows: 1 + tangents, friction }; contacts];
    let problem = FrictionProblem::from_dense(laws, &matrix, before.to_vec()).unwrap();
    let impact = MultipleFrictionalImpact {
        contacts: &problem,
        restitution: &vec![restitution; contacts],
        stand_for_several: &[],
        law: MultipleImpactLaw::Pulse(exponent),
        single: RestitutionLaw::Stronge,
        settings: &MultipleImpactSettings::default(),
    };
    impact.resolve().unwrap()
}

/// Velocities of all rows of a body with this velocity.
fn rates(rows: &[Vec<f64>], velocity: &[f64]) -> Vec<f64> {
    rows.iter().map(|row| row.iter().zip(velocity).map(|(a, b)| a * b).sum()).collect()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// The falling rod of IM-07: slip that goes on, that reverses, that sticks.
#[test]
fn rod_given_twice_is_the_rod_of_the_closed_form() {
    let (normal, tangent) = (vec![1.0, 0.0, 1.5f64.sqrt()], vec![0.0, 1.0, -1.5f64.sqrt()]);
    let rows = [&normal, &tangent, &normal, &tangent].map(Clone::clone);
    let before = rates(&rows, &[-1.0, 0.6, 0.0]);
    for exponent in EXPONENTS {
        for friction in [0.1, 0.5, 0.6, 1.0] {
            for restitution in [0.0, 0.1, 0.5, 0.9, 1.0] {
                let single = SingleFrictionalImpact {
                    collision: CollisionMatrix::planar(2.5, -1.5, 2.5).unwrap(),
                    velocity_before: [-1.0, 0.6, 0.0],
                    friction,
                    restitution,
                    law: RestitutionLaw::Stronge,
                };
                let expected = single.resolve().unwrap();
                let found = struck(&rows, 1, &before, (friction, restitution), exponent);
                assert_eq!(found.status, ImpactStatus::Separated);
                let of_first = distance(&found.velocities_after[..2], &expected.velocity_after[..2]);
                assert!(of_first < OF_STEPS, "{exponent:?} mu={friction} e={restitution}: {of_first:e}");
                let change = (found.energy_change - expected.energy_change).abs();
                assert!(change < OF_STEPS, "{exponent:?} mu={friction} e={restitution}: energy {change:e}");
                let works = found.friction_work.iter().sum::<f64>() - expected.friction_work;
                assert!(works.abs() < OF_STEPS, "{exponent:?} mu={friction} e={restitution}: work {works:e}");
            }
        }
    }
}

/// The rod that jams (Painleve): driven into the floor until its slip has ended.
#[test]
fn rod_that_jams_given_twice_is_that_of_the_closed_form() {
    let (sin, cos) = (0.75f64.sqrt(), 0.5);
    let (normal, tangent) = (vec![1.0, 0.0, 3f64.sqrt() * cos], vec![0.0, 1.0, -3f64.sqrt() * sin]);
    let rows = [&normal, &tangent, &normal, &tangent].map(Clone::clone);
    let before = rates(&rows, &[-0.1, -1.0, 0.0]);
    let collision = CollisionMatrix::planar(1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin).unwrap();
    for exponent in EXPONENTS {
        let velocity_before = [-0.1, -1.0, 0.0];
        let law = RestitutionLaw::Stronge;
        let single = SingleFrictionalImpact { collision, velocity_before, friction: 1.5, restitution: 0.5, law };
        let expected = single.resolve().unwrap().velocity_after;
        let found = struck(&rows, 1, &before, (1.5, 0.5), exponent);
        // The jam grows from an approach of 0.1 m/s.
        assert!(distance(&found.velocities_after[..2], &expected[..2]) < 10.0 * OF_STEPS);
    }
}

/// In space, where the slip turns while it ends.
#[test]
fn slip_that_turns_is_that_of_the_closed_form() {
    let rows_of = |arm: [f64; 3], inverse: [f64; 3]| {
        let row = |axis: [f64; 3]| {
            let turn = [
                arm[1] * axis[2] - arm[2] * axis[1],
                arm[2] * axis[0] - arm[0] * axis[2],
                arm[0] * axis[1] - arm[1] * axis[0],
            ];
            let turn = [0, 1, 2].map(|k| turn[k] * inverse[k].sqrt());
            [axis, turn].concat()
        };
        [row([0.0, 0.0, 1.0]), row([1.0, 0.0, 0.0]), row([0.0, 1.0, 0.0])]
    };
    let rows = rows_of([0.3, -0.2, -0.5], [4.0, 7.0, 9.0]);
    let twice: Vec<Vec<f64>> = rows.iter().chain(&rows).cloned().collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(&rows[i], &rows[j])));
    for exponent in EXPONENTS {
        for (friction, slip) in [(0.2, [0.4, 0.9]), (0.3, [0.1, -0.2]), (0.6, [0.3, 0.2]), (1.2, [0.1, 0.1])] {
            let velocity_before = [-1.0, slip[0], slip[1]];
            let collision = CollisionMatrix::new(matrix).unwrap();
            let law = RestitutionLaw::Stronge;
            let single = SingleFrictionalImpact { collision, velocity_before, friction, restitution: 0.6, law };
            let expected = single.resolve().unwrap().velocity_after;
            let before = [velocity_before, velocity_before].concat();
            let found = struck(&twice, 2, &before, (friction, 0.6), exponent);
            let off = distance(&found.velocities_after[..3], &expected);
            // A direction of slip is followed up to slips of 1e-10, and from 1e-6 on where it starts anew.
            assert!(off < 5e-9, "{exponent:?} mu={friction} {slip:?}: {off:e}");
        }
    }
}

/// Rows of a box of 1 kg and edge 1 m on the two corners of its lower edge, in the plane.
fn box_on_two_corners() -> [Vec<f64>; 4] {
    let row = |x: f64, z: f64, moment: f64| vec![x, z, 6f64.sqrt() * moment];
    [row(0.0, 1.0, -0.5), row(1.0, 0.0, 0.5), row(0.0, 1.0, 0.5), row(1.0, 0.0, 0.5)]
}

/// A mirror image is struck as the mirror image.
#[test]
fn mirror_images_stay_so() {
    let rows = box_on_two_corners();
    for exponent in EXPONENTS {
        for friction in [0.1, 0.4, 0.9] {
            for (slide, turn) in [(0.3, 0.0), (0.8, 0.4), (-0.2, 0.7)] {
                let one = rates(&rows, &[slide, -1.0, turn]);
                let other = rates(&rows, &[-slide, -1.0, -turn]);
                let one = struck(&rows, 1, &one, (friction, 0.5), exponent).velocities_after;
                let other = struck(&rows, 1, &other, (friction, 0.5), exponent).velocities_after;
                let mirrored = [other[2], -other[3], other[0], -other[1]];
                assert!(distance(&one, &mirrored) < OF_STEPS, "{one:?} {mirrored:?}");
            }
        }
    }
}

/// Balls in a row without friction: the law without friction.
#[test]
fn without_friction_it_is_the_law_of_the_chains() {
    for masses in [vec![1.0, 1.0, 1.0], vec![1.0, 2.0, 4.0], vec![2.0, 1.0, 1.0, 1.0, 5.0]] {
        let count = masses.len();
        let row = |k: usize| -> Vec<f64> {
            let share = |i: usize| f64::from(u8::from(i == k)) - f64::from(u8::from(i + 1 == k));
            (0..count).map(|i| share(i) / f64::sqrt(masses[i])).collect()
        };
        let rows: Vec<Vec<f64>> = (1..count).map(row).collect();
        let velocity: Vec<f64> = (0..count).map(|i| if i == 0 { f64::sqrt(masses[0]) } else { 0.0 }).collect();
        let before = rates(&rows, &velocity);
        for exponent in EXPONENTS {
            for restitution in [0.3, 0.8, 1.0] {
                let rough = struck(&rows, 0, &before, (0.0, restitution), exponent);
                let smooth = smooth(&rows, &before, restitution, exponent);
                assert!(distance(&rough.velocities_after, &smooth) < OF_STEPS);
            }
        }
    }
}

/// The same by the law without friction.
fn smooth(rows: &[Vec<f64>], before: &[f64], restitution: f64, exponent: PulseExponent) -> Vec<f64> {
    let (status, after) = smooth_with_status(rows, before, restitution, exponent);
    assert_eq!(status, ImpactStatus::Separated, "{before:?} e={restitution} {exponent:?}");
    after
}

fn smooth_with_status(
    rows: &[Vec<f64>],
    before: &[f64],
    restitution: f64,
    exponent: PulseExponent,
) -> (ImpactStatus, Vec<f64>) {
    let size = rows[0].len();
    let mut inverse = vec![0.0; size * size];
    (0..size).for_each(|i| inverse[i * (size + 1)] = 1.0);
    let mut contacts = ContactProblem::new(size, inverse).unwrap();
    for row in rows {
        contacts.push_row(&[(0, row)]).unwrap();
    }
    let problem = ImpactProblem {
        contacts: &contacts,
        delassus: &contacts.delassus(),
        u_before: before,
        restitution: &vec![restitution; rows.len()],
        settings: &ImpactSettings::default(),
    };
    let outcome = ImpactLaw::Pulse(exponent).resolve(&problem, &mut ComplementaritySolver::default()).unwrap();
    (outcome.status, outcome.velocities_after)
}

/// Rows of four balls in a line, the second of this mass, and their velocities when the first comes at 1 m/s.
fn light_between_heavy(light: f64) -> (Vec<Vec<f64>>, Vec<f64>) {
    let masses: [f64; 4] = [1.0, light, 1.0, 0.5];
    let row = |k: usize| -> Vec<f64> {
        let share = |i: usize| f64::from(u8::from(i == k)) - f64::from(u8::from(i + 1 == k));
        (0..4).map(|i| share(i) / masses[i].sqrt()).collect()
    };
    let rows: Vec<Vec<f64>> = (1..4).map(row).collect();
    let before = rates(&rows, &[1.0, 0.0, 0.0, 0.0]);
    (rows, before)
}

/// A light ball between two heavy ones is compressed hundreds of times, and the impact still ends by itself; so do
/// contacts that lose nearly all that they take.
#[test]
fn light_bodies_and_lossy_contacts_end_by_themselves() {
    for (light, restitution) in [(1e-4, 1.0), (1e-6, 1.0), (1e-2, 0.5), (1e-2, 0.0), (1.0, 0.0), (1.0, 0.03)] {
        let (rows, before) = light_between_heavy(light);
        for exponent in EXPONENTS {
            let after = smooth(&rows, &before, restitution, exponent);
            assert!(after.iter().all(|u| *u >= 0.0), "{after:?}");
        }
    }
}

/// Where a light body loses much of its energy between heavy ones, it is compressed as often as the ratio of masses
/// says: the law gives up, says so, and what is left is stopped, which is what the law tends to.
#[test]
fn a_light_body_that_loses_energy_between_heavy_ones_is_told() {
    let (rows, before) = light_between_heavy(1e-4);
    let (status, after) = smooth_with_status(&rows, &before, 0.5, PulseExponent::Hertz);
    assert_eq!(status, ImpactStatus::LimitReached);
    assert!(after.iter().all(|u| *u >= 0.0), "{after:?}");
}

/// A body that resists rolling is refused, by name.
#[test]
fn rolling_is_refused() {
    let rows = box_on_two_corners();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let matrix: Vec<f64> = rows.iter().flat_map(|a| rows.iter().map(|b| dot(a, b))).collect();
    let rolls = Resistance { rows: 1, friction: 0.1, slides: false };
    let law = Law::Resist { parts: [Resistance::default(), rolls, Resistance::default()] };
    let problem = FrictionProblem::from_dense(vec![law, law], &matrix, vec![-1.0, 0.1, -1.0, 0.1]).unwrap();
    let impact = MultipleFrictionalImpact {
        contacts: &problem,
        restitution: &[0.5, 0.5],
        stand_for_several: &[],
        law: MultipleImpactLaw::Pulse(PulseExponent::Linear),
        single: RestitutionLaw::Stronge,
        settings: &MultipleImpactSettings::default(),
    };
    assert!(impact.resolve().unwrap_err().to_string().contains("rolling or spinning"));
}

proptest! {
    #![proptest_config(few(8))]

    /// Bodies of six coordinates with one to four contacts anywhere: the energy falls, impulses are in their cones,
    /// nothing approaches.
    #[test]
    fn energy_never_rises(
        numbers in prop::collection::vec(-1.0f64..1.0, 4 * 3 * 6 + 6),
        contacts in 2usize..=4,
        friction in 0.0f64..1.5,
        restitution in 0.05f64..1.0,
    ) {
        let rows: Vec<Vec<f64>> = numbers.chunks_exact(6).take(3 * contacts).map(<[f64]>::to_vec).collect();
        let before = rates(&rows, &numbers[72..]);
        for exponent in EXPONENTS {
            let found = struck(&rows, 2, &before, (friction, restitution), exponent);
            let size = numbers[72..].iter().map(|v| 0.5 * v * v).sum::<f64>();
            prop_assert!(found.energy_change <= 1e-12 * size, "{}", found.energy_change);
            for block in 0..contacts {
                let [n, x, y] = [0, 1, 2].map(|k| found.impulses[3 * block + k]);
                prop_assert!(n >= 0.0 && x.hypot(y) <= friction * n * (1.0 + 1e-9) + 1e-12);
                prop_assert!(found.velocities_after[3 * block] >= 0.0);
                prop_assert!(found.friction_work[block] <= 1e-12 * size);
            }
        }
    }
}
