//! Impact laws: closed forms of the thesis and of the catalogue, energy, separation.

use crate::cases::few;
use crate::degenerate::{Small, small};
use crate::scenes::{Noise, Row, Scene, pile, tower};
use polhode_response::{
    ComplementaritySolver, ContactProblem, ImpactLaw, ImpactOutcome, ImpactProblem, ImpactSettings, ImpactStatus,
    PulseExponent, SolverSettings, SolverStatus, single_contact_impulse, solve_complementarity,
};
use proptest::prelude::*;

const LINEAR: ImpactLaw = ImpactLaw::Pulse(PulseExponent::Linear);
const HERTZ: ImpactLaw = ImpactLaw::Pulse(PulseExponent::Hertz);
const LAWS: [ImpactLaw; 7] = [
    ImpactLaw::Propagation,
    ImpactLaw::Simultaneous,
    ImpactLaw::Reflection,
    ImpactLaw::Poisson,
    ImpactLaw::Energetic,
    LINEAR,
    HERTZ,
];

/// Resolves an impact of a scene at the velocities `v`; returns the outcome and the velocities afterwards.
fn strike(scene: &Scene, law: ImpactLaw, v: &[f64], restitution: &[f64]) -> (ImpactOutcome, Vec<f64>) {
    let u = scene.problem.row_velocities(v).unwrap();
    let mut solver = ComplementaritySolver::default();
    let delassus = scene.problem.delassus();
    let settings = ImpactSettings { limit: 20_000, ..ImpactSettings::default() };
    let (contacts, delassus, settings) = (&scene.problem, &delassus, &settings);
    let problem = ImpactProblem { contacts, delassus, u_before: &u, restitution, settings };
    let outcome = law.resolve(&problem, &mut solver).unwrap();
    let after = scene.problem.response(&outcome.impulses).unwrap();
    (outcome, v.iter().zip(after).map(|(before, change)| before + change).collect())
}

fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let worst = found.iter().zip(expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(worst <= tolerance, "{found:?} {expected:?}: {worst:e}");
}

/// Each number to its own size; zero to zero within the tolerance.
fn assert_relative(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        let size = if *b == 0.0 { 1.0 } else { b.abs() };
        assert!((a - b).abs() <= tolerance * size, "{found:?} {expected:?}: {:e}", (a - b).abs() / size);
    }
}

/// The stick of Appendix C: mass 1, length 2, inertia `inertia`; components (v, w), rows right end, left end.
fn stick(inertia: f64) -> Scene {
    let rows: Vec<Row> = vec![vec![(0, vec![1.0, 1.0])], vec![(0, vec![1.0, -1.0])]];
    Scene::new(2, &[vec![1.0, inertia]], &rows, &[0.0, 0.0])
}

/// Balls on a line, each touching the next.
fn cradle(masses: &[f64]) -> Scene {
    let rows: Vec<Row> = (1..masses.len()).map(|k| vec![(k, vec![1.0]), (k - 1, vec![-1.0])]).collect();
    let diagonals: Vec<Vec<f64>> = masses.iter().map(|mass| vec![*mass]).collect();
    Scene::new(1, &diagonals, &rows, &[0.0])
}

/// The contact of case IM-01: two bodies with tilted inertia.
fn tilted_pair() -> ContactProblem {
    use polhode_spatial::{DMat3, DVec3};
    let inertia_a = DMat3::from_cols_array_2d(&[[2.0, 0.25, 0.0], [0.25, 3.0, 0.5], [0.0, 0.5, 4.0]]);
    let inertia_b = DMat3::from_cols_array_2d(&[[5.0, 0.0, 1.0], [0.0, 4.0, 0.0], [1.0, 0.0, 6.0]]);
    let mut inverse = Vec::new();
    for (mass, inertia) in [(2.0, inertia_a), (3.0, inertia_b)] {
        let turned = inertia.inverse();
        let turned = 0.5 * (turned + turned.transpose());
        for row in 0..6 {
            for column in 0..6 {
                inverse.push(match (row < 3, column < 3) {
                    (true, true) => f64::from(u8::from(row == column)) / mass,
                    (false, false) => turned.col(column - 3)[row - 3],
                    _ => 0.0,
                });
            }
        }
    }
    let (normal, r_a, r_b) = (DVec3::new(1.0, 2.0, 2.0) / 3.0, DVec3::new(1.0, -0.5, -2.0), DVec3::new(0.5, 1.0, 1.5));
    let block = |r: DVec3, sign: f64| [(sign * normal).to_array(), (sign * r.cross(normal)).to_array()].concat();
    let mut problem = ContactProblem::new(6, inverse).unwrap();
    problem.push_row(&[(0, &block(r_a, 1.0)), (1, &block(r_b, -1.0))]).unwrap();
    problem
}

/// Case IM-01: equation (14) for two bodies with tilted inertia; impulse, velocities after and energy lost for e = 1/2
/// and e = 1.
#[test]
fn two_bodies_by_equation_14() {
    let problem = tilted_pair();
    let v = [1.0, -2.0, -3.0, 0.5, 1.0, -1.0, 0.0, 1.0, 1.0, -1.0, 0.0, 2.0];
    let u = problem.row_velocities(&v).unwrap();
    let (delassus, settings) = (problem.delassus(), ImpactSettings::default());
    let cases = [
        (
            0.5,
            307_458.0 / 76927.0,
            973_617.0 / 153_854.0,
            [
                1.666_125_027_623_591_3,
                -0.667_749_944_752_817_6,
                -1.667_749_944_752_817_7,
                2.766_973_884_331_899,
                -1.148_790_411_689_003_8,
                0.101_255_085_990_614_47,
                -0.444_083_351_749_060_8,
                0.111_833_296_501_878_4,
                0.111_833_296_501_878_4,
                -0.724_362_057_535_065_7,
                -0.166_531_256_905_897_8,
                1.954_060_342_922_511,
            ],
        ),
        (
            1.0,
            409_944.0 / 76927.0,
            0.0,
            [
                1.888_166_703_498_121_5,
                -0.223_666_593_003_756_8,
                -1.223_666_593_003_757,
                3.522_631_845_775_865_4,
                -1.865_053_882_252_005,
                0.468_340_114_654_152_65,
                -0.592_111_135_665_414_4,
                -0.184_222_271_330_828_8,
                -0.184_222_271_330_828_8,
                -0.632_482_743_380_087_6,
                -0.222_041_675_874_530_4,
                1.938_747_123_896_681_4,
            ],
        ),
    ];
    for (e, impulse, lost, after) in cases {
        let closed = single_contact_impulse(delassus.get(0, 0), u[0], e).unwrap();
        assert!((closed - impulse).abs() <= 1e-14 * impulse, "{closed} {impulse}");
        for law in LAWS {
            let mut solver = ComplementaritySolver::default();
            let (contacts, delassus, settings) = (&problem, &delassus, &settings);
            let impact = ImpactProblem { contacts, delassus, u_before: &u, restitution: &[e], settings };
            let outcome = law.resolve(&impact, &mut solver).unwrap();
            assert!((outcome.impulses[0] - impulse).abs() <= 1e-14 * impulse);
            assert!((outcome.energy_change + lost).abs() <= 1e-13, "{}", outcome.energy_change);
            let change = problem.response(&outcome.impulses).unwrap();
            let found: Vec<f64> = v.iter().zip(change).map(|(v, change)| v + change).collect();
            assert_close(&found, &after, 1e-13);
        }
    }
}

/// Case IM-02: the stick of Appendix C under the propagation law: number of impulses, end velocities, motion.
#[test]
fn stick_of_appendix_c() {
    // Inertia, N, velocities of the end hit last and of the other, v', |w'|.
    let table = [
        (0.02, 11, 1.357_900_442_942_394_9, 0.639_517_520_210_672_5, 0.998_708_981_576_533_8, 0.359_191_461_365_861_2),
        (0.05, 7, 1.274_121_293_185_219_3, 0.722_065_501_720_384_3, 0.998_093_397_452_801_9, 0.276_027_895_732_417_54),
        (0.1, 5, 1.245_884_843_931_425_4, 0.747_905_942_837_983, 0.996_895_393_384_704_2, 0.248_989_450_546_721_22),
        (0.2, 4, 13.0 / 27.0, 119.0 / 81.0, 79.0 / 81.0, 40.0 / 81.0),
        (1.0 / 3.0, 3, 1.0, 1.0, 1.0, 0.0),
        (0.5, 3, 1.0 / 9.0, 43.0 / 27.0, 23.0 / 27.0, 20.0 / 27.0),
        (0.75, 2, 9.0 / 7.0, 31.0 / 49.0, 47.0 / 49.0, 16.0 / 49.0),
        (1.0, 2, 1.0, 1.0, 1.0, 0.0),
    ];
    for (inertia, count, last, other, v, w) in table {
        let (outcome, after) = strike(&stick(inertia), ImpactLaw::Propagation, &[-1.0, 0.0], &[1.0; 2]);
        assert_eq!(outcome.applications.len(), count, "I = {inertia}");
        assert_eq!(outcome.status, ImpactStatus::Separated);
        let struck = outcome.applications[count - 1].row;
        let ends = [outcome.velocities_after[struck], outcome.velocities_after[1 - struck]];
        assert_relative(&ends, &[last, other], 1e-13);
        assert_relative(&[after[0], after[1].abs()], &[v, w], 1e-13);
        assert!(outcome.energy_change.abs() < 1e-14);
    }
    let (outcome, _) = strike(&stick(1.0 / 3.0), ImpactLaw::Propagation, &[-1.0, 0.0], &[1.0; 2]);
    let impulses: Vec<f64> = outcome.applications.iter().map(|application| application.impulse).collect();
    assert_relative(&impulses, &[0.5, 1.0, 0.5], 1e-14);
}

/// Case IM-02, borderline: for I = tan^2(pi / (2k + 1)) the other end stops at exactly 0 after k impulses; the sign of
/// rounding must not add one, nor pass for a sequence that was cut off.
#[test]
fn borderline_stick_stops_at_zero() {
    for k in 2..=4_u32 {
        let inertia = (std::f64::consts::PI / f64::from(2 * k + 1)).tan().powi(2);
        let (outcome, _) = strike(&stick(inertia), ImpactLaw::Propagation, &[-1.0, 0.0], &[1.0; 2]);
        assert_eq!(outcome.applications.len(), k as usize);
        assert_eq!(outcome.status, ImpactStatus::Separated);
        let struck = outcome.applications[k as usize - 1].row;
        assert_eq!(outcome.velocities_after[1 - struck], 0.0);
        if k == 2 {
            assert_close(&[outcome.velocities_after[struck]], &[1.618_033_988_749_895], 1e-14);
        }
    }
}

/// Case IM-03: with e < 1 the propagation law ends when e is above tan^2(pi/4 - theta/2), after the counts of the
/// catalogue; below it never ends, is cut off with a warning, and the total is the plastic impulse.
#[test]
fn stick_with_restitution() {
    let table = [
        (1.0 / 3.0, 0.5, 3, [0.40625, 0.265_625]),
        (1.0 / 3.0, 0.1, 6, [35311.0 / 32e6, 41219.0 / 64e6]),
        (1.0 / 3.0, 0.08, 11, [1.991_853_000_286_208e-7, 3.493_155_155_154_33e-6]),
        (0.1, 0.5, 6, [0.133_495_076_870_059_8, 0.112_619_948_946_155_4]),
    ];
    for (inertia, e, count, ends) in table {
        let (outcome, _) = strike(&stick(inertia), ImpactLaw::Propagation, &[-1.0, 0.0], &[e; 2]);
        assert_eq!((outcome.applications.len(), outcome.status), (count, ImpactStatus::Separated));
        let struck = outcome.applications[count - 1].row;
        let found = [outcome.velocities_after[struck], outcome.velocities_after[1 - struck]];
        for (found, expected) in found.iter().zip(ends) {
            assert!((found / expected - 1.0).abs() <= 1e-12, "{found} {expected}");
        }
    }
    // The threshold: tan^2(pi/4 - theta/2) with tan^2(theta/2) = I.
    for (inertia, threshold) in [
        (0.1, 0.269_873_863_612_238_36),
        (1.0 / 3.0, 0.071_796_769_724_490_82),
        (0.5, 0.029_437_251_522_859_413),
        (0.9, 0.000_693_481_609_512_304_3),
    ] {
        let cos = (1.0 - inertia) / (1.0 + inertia);
        let sin = (1.0_f64 - cos * cos).sqrt();
        assert!((((1.0 - sin) / cos).powi(2) / threshold - 1.0).abs() < 1e-12);
        let (below, after) = strike(&stick(inertia), ImpactLaw::Propagation, &[-1.0, 0.0], &[0.97 * threshold; 2]);
        assert_eq!(below.status, ImpactStatus::StoppedAtThreshold, "I = {inertia}");
        assert!(!below.finishing.is_empty());
        assert_eq!(below.velocities_after, [0.0; 2]);
        assert_close(&after, &[0.0; 2], 1e-14);
        assert_close(&[below.impulses.iter().sum()], &[1.0], 1e-14);
        assert_close(&[below.energy_change], &[-0.5], 1e-14);
        let (above, _) = strike(&stick(inertia), ImpactLaw::Propagation, &[-1.0, 0.0], &[1.2 * threshold; 2]);
        assert_eq!(above.status, ImpactStatus::Separated, "I = {inertia}");
    }
}

/// Case IM-04 and the like: Newton's cradle by the three laws (thesis, Figure 16).
#[test]
fn cradles() {
    use ImpactLaw::{Propagation, Reflection, Simultaneous};
    /// Masses, velocities before, restitution, law, velocities after.
    type Cradle<'a> = (&'a [f64], &'a [f64], f64, ImpactLaw, Vec<f64>);
    let third = 1.0 / 3.0;
    let cases: Vec<Cradle<'_>> = vec![
        (&[1.0; 3], &[1.0, 0.0, 0.0], 1.0, Propagation, vec![0.0, 0.0, 1.0]),
        (&[1.0; 3], &[1.0, 0.0, 0.0], 1.0, Reflection, vec![0.0, 0.0, 1.0]),
        (&[1.0; 3], &[1.0, 0.0, 0.0], 1.0, Simultaneous, vec![-third, 2.0 * third, 2.0 * third]),
        (&[1.0; 4], &[1.0, 0.0, 0.0, 0.0], 1.0, Simultaneous, vec![-0.5, 0.5, 0.5, 0.5]),
        (&[1.0; 5], &[1.0, 0.0, 0.0, 0.0, 0.0], 1.0, Simultaneous, vec![-0.6, 0.4, 0.4, 0.4, 0.4]),
        (&[1.0; 5], &[1.0, 1.0, 0.0, 0.0, 0.0], 1.0, Propagation, vec![0.0, 0.0, 0.0, 1.0, 1.0]),
        (&[1.0; 5], &[1.0, 1.0, 0.0, 0.0, 0.0], 1.0, Reflection, vec![0.0, 0.0, 0.0, 1.0, 1.0]),
        (&[1.0; 5], &[1.0, 1.0, 0.0, 0.0, 0.0], 1.0, Simultaneous, vec![-0.2, -0.2, 0.8, 0.8, 0.8]),
        (&[1.0; 3], &[1.0, 0.0, 0.0], 0.5, Propagation, vec![13.0 / 64.0, 15.0 / 64.0, 9.0 / 16.0]),
        (&[1.0; 3], &[1.0, 0.0, 0.0], 0.5, Simultaneous, vec![0.0, 0.5, 0.5]),
        (&[1.0; 3], &[1.0, 0.0, 0.0], 0.5, Reflection, vec![0.5 * third, 0.5 * third, 2.0 * third]),
        (&[1.0, 2.0, 4.0], &[1.0, 0.0, 0.0], 1.0, Propagation, vec![-third, -2.0 / 9.0, 4.0 / 9.0]),
        (&[1.0, 2.0, 4.0], &[1.0, 0.0, 0.0], 1.0, Simultaneous, vec![-5.0 / 7.0, 2.0 / 7.0, 2.0 / 7.0]),
    ];
    for (masses, before, e, law, after) in cases {
        let (outcome, found) = strike(&cradle(masses), law, before, &vec![e; masses.len() - 1]);
        assert_relative(&found, &after, 1e-14);
        assert_eq!(outcome.status, ImpactStatus::Separated, "{law:?}");
    }
}

/// Poisson's and Stronge's laws on the cradles: with one restitution for all contacts both are Moreau's law; they
/// differ from it and from each other where restitution does.
#[test]
fn cradles_by_compression_and_expansion() {
    for masses in [vec![1.0; 3], vec![1.0; 5], vec![1.0, 2.0, 4.0]] {
        for e in [0.0, 0.5, 0.8, 1.0] {
            let mut before = vec![0.0; masses.len()];
            before[0] = 1.0;
            let restitution = vec![e; masses.len() - 1];
            let (_, moreau) = strike(&cradle(&masses), ImpactLaw::Simultaneous, &before, &restitution);
            for law in [ImpactLaw::Poisson, ImpactLaw::Energetic] {
                let (outcome, found) = strike(&cradle(&masses), law, &before, &restitution);
                assert_close(&found, &moreau, 1e-14);
                assert_eq!(outcome.status, ImpactStatus::Separated, "{law:?}");
            }
        }
    }
    // One ball into two, e = 1/2 and 1: compression to 1/3 by the impulses 2/3 and 1/3.
    let (outcome, found) = strike(&cradle(&[1.0; 3]), ImpactLaw::Poisson, &[1.0, 0.0, 0.0], &[0.5, 1.0]);
    assert_close(&outcome.impulses, &[1.0, 2.0 / 3.0], 1e-14);
    assert_close(&found, &[0.0, 1.0 / 3.0, 2.0 / 3.0], 1e-14);
    // A stick whose ends have restitution 1 and 0, of inertia 1/3: G = [[4, -2], [-2, 4]], compression p = 1/2 at each
    // end, W = 1/4 J at each. The end without restitution ends at once; the other gives back 1/4 J by G p^2/2: p =
    // 8^(-1/2), and closes the first one by 2 p. Another round stops that end by p = 8^(-1/2)/2: the whole work of it
    // is lost.
    let (outcome, found) = strike(&stick(1.0 / 3.0), ImpactLaw::Energetic, &[-1.0, 0.0], &[1.0, 0.0]);
    let p = 0.125_f64.sqrt();
    assert_close(&outcome.impulses, &[0.5 + p, 0.5 + 0.5 * p], 1e-14);
    assert_close(&found, &[1.5 * p, 1.5 * p], 1e-14);
    assert_close(&[outcome.energy_change], &[-0.5 + 0.5 * (1.5 * p).powi(2) * (1.0 + 1.0 / 3.0)], 1e-14);
}

/// Balls between springs: two balls rebound as equation (14) says; a ball into two resting ones disperses as Newton's
/// equations for the springs say. For linear springs and e = 1 these are oscillators of the frequencies 1 and sqrt(3):
/// while both contacts are closed, d_1 - d_2 = sin(sqrt(3) t)/sqrt(3) and d_1 + d_2 = sin(t).
#[test]
fn springs_disperse_the_momentum() {
    let (_, two) = strike(&cradle(&[1.0, 3.0]), HERTZ, &[1.0, 0.0], &[0.7]);
    assert_close(&two, &[1.0 - 0.75 * 1.7, 0.25 * 1.7], 1e-14);
    // The first contact opens where d_1 = (sin t + sin(sqrt(3) t)/sqrt(3))/2 = 0 and from then on the second alone
    // gives back what it has stored.
    let (d1, d1_rate) = (
        |t: f64| 0.5 * (t.sin() + (3.0_f64.sqrt() * t).sin() / 3.0_f64.sqrt()),
        |t: f64| 0.5 * (t.cos() + (3.0_f64.sqrt() * t).cos()),
    );
    let mut t: f64 = 2.5;
    for _ in 0..60 {
        t -= d1(t) / d1_rate(t);
    }
    let d2 = 0.5 * (t.sin() - (3.0_f64.sqrt() * t).sin() / 3.0_f64.sqrt());
    // u_2 = -d_2'. Afterwards two bodies with the energy d_2^2/2 between them: u_2+^2 = u_2^2 + G d_2^2 with G = 2.
    let (u1, u2) = (-d1_rate(t), -0.5 * (t.cos() - (3.0_f64.sqrt() * t).cos()));
    let momentum_of_the_first = {
        // v_1 = 1 - int d_1 dt over the pulse.
        let integral = 0.5 * (1.0 - t.cos()) + 0.5 * (1.0 - (3.0_f64.sqrt() * t).cos()) / 3.0;
        1.0 - integral
    };
    let v2 = momentum_of_the_first + u1;
    let v3 = v2 + u2;
    let apart = (u2 * u2 + 2.0 * d2 * d2).sqrt();
    let mean = 0.5 * (v2 + v3);
    let expected = [momentum_of_the_first, mean - 0.5 * apart, mean + 0.5 * apart];
    let (outcome, found) = strike(&cradle(&[1.0; 3]), LINEAR, &[1.0, 0.0, 0.0], &[1.0; 2]);
    assert_eq!(outcome.status, ImpactStatus::Separated);
    assert_close(&found, &expected, 1e-10);
    // Hertz's springs pass more of it on, and neither law sends the last ball alone.
    let (_, hertz) = strike(&cradle(&[1.0; 3]), HERTZ, &[1.0, 0.0, 0.0], &[1.0; 2]);
    assert!(hertz[2] > found[2] && hertz[2] < 1.0 && hertz[0] < 0.0, "{found:?} {hertz:?}");
}

/// The order of propagation is what is asked for: struck from the other end first, the stick turns the other way, with
/// the same number of impulses; an order that does not name each row is refused.
#[test]
fn propagation_in_another_order() {
    let scene = stick(0.05);
    let u = scene.problem.row_velocities(&[-1.0, 0.0]).unwrap();
    let (delassus, settings) = (scene.problem.delassus(), ImpactSettings::default());
    let (contacts, delassus, settings) = (&scene.problem, &delassus, &settings);
    let problem = ImpactProblem { contacts, delassus, u_before: &u, restitution: &[1.0; 2], settings };
    let mut solver = ComplementaritySolver::default();
    let first = ImpactLaw::Propagation.resolve_in_order(&problem, &mut solver, &[0, 1]).unwrap();
    let second = ImpactLaw::Propagation.resolve_in_order(&problem, &mut solver, &[1, 0]).unwrap();
    assert_eq!(first, ImpactLaw::Propagation.resolve(&problem, &mut solver).unwrap());
    assert_eq!(first.impulses, [second.impulses[1], second.impulses[0]]);
    assert_eq!((first.applications[0].row, second.applications[0].row), (0, 1));
    for bad in [&[0, 0][..], &[0], &[0, 2]] {
        assert!(ImpactLaw::Propagation.resolve_in_order(&problem, &mut solver, bad).is_err());
    }
}

/// Case IM-12: head-on at mass ratios 1e-6 and 1e6.
#[test]
fn head_on_at_mass_ratio() {
    for law in LAWS {
        let (_, light) = strike(&cradle(&[1.0, 1e6]), law, &[1.0, 0.0], &[1.0]);
        assert_relative(&light, &[-999_999.0 / 1_000_001.0, 2.0 / 1_000_001.0], 1e-14);
        let (_, heavy) = strike(&cradle(&[1e6, 1.0]), law, &[1.0, 0.0], &[1.0]);
        assert_relative(&heavy, &[999_999.0 / 1_000_001.0, 2e6 / 1_000_001.0], 1e-14);
    }
}

/// Bernoulli's problem: a ball hits two at once. Propagation breaks the symmetry; the other laws keep it, and agree.
#[test]
fn bernoulli_keeps_its_symmetry() {
    let (c, s) = (0.75_f64.sqrt(), 0.5);
    let rows: Vec<Row> = vec![vec![(1, vec![c, s]), (0, vec![-c, -s])], vec![(2, vec![c, -s]), (0, vec![-c, s])]];
    let scene = Scene::new(2, &vec![vec![1.0, 1.0]; 3], &rows, &[0.0; 2]);
    let before = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let (_, broken) = strike(&scene, ImpactLaw::Propagation, &before, &[1.0; 2]);
    let (q, h) = (c / 4.0, c / 2.0);
    assert_close(&broken, &[-0.125, -q, 0.75, h, 0.375, -q], 1e-15);
    for law in [ImpactLaw::Simultaneous, ImpactLaw::Reflection, ImpactLaw::Poisson, ImpactLaw::Energetic] {
        let (_, even) = strike(&scene, law, &before, &[1.0; 2]);
        assert_close(&even, &[-0.2, 0.0, 0.6, 0.4 * c, 0.6, -0.4 * c], 1e-15);
        assert_eq!((even[1], even[3]), (0.0, -even[5]));
    }
}

/// The flat stick leaves without spin under the symmetric laws; with e = 1/2 they lose 75 % of the
/// energy, propagation 99.95 %.
#[test]
fn flat_stick_by_the_symmetric_laws() {
    for law in [ImpactLaw::Simultaneous, ImpactLaw::Reflection, ImpactLaw::Poisson, ImpactLaw::Energetic] {
        for (e, after) in [(1.0, 1.0), (0.5, 0.5), (0.0, 0.0)] {
            let (outcome, found) = strike(&stick(0.05), law, &[-1.0, 0.0], &[e; 2]);
            assert_close(&found, &[after, 0.0], 1e-14);
            assert_close(&[outcome.energy_change], &[-0.5 * (1.0 - e * e)], 1e-14);
        }
    }
    let (outcome, _) = strike(&stick(0.05), ImpactLaw::Propagation, &[-1.0, 0.0], &[0.5; 2]);
    assert_eq!(outcome.applications.len(), 11);
    assert!((outcome.energy_change / -0.5 - 0.9995).abs() < 5e-5);
}

/// Kinetic energy, J.
fn energy(scene: &Scene, v: &[f64]) -> f64 {
    0.5 * scene.squared(v)
}

/// Thesis, Appendix B, for every law on random impacts of piles and towers, restitutions equal or not: no row
/// approaches afterwards, impulses push, the energy does not rise beyond rounding, it is conserved for e = 1 by the
/// laws that promise it, and the booked change is the change.
#[test]
fn no_law_raises_the_energy() {
    let mut noise = Noise::new(31);
    for round in 0..1000 {
        let scene = if round % 3 == 0 {
            tower(&vec![1.0; 1 + noise.below(4)], if round % 2 == 0 { 0.0 } else { 0.3 }, &mut noise)
        } else {
            pile(1 + noise.below(5), 1 + noise.below(4), [1.0, 1e3][round % 2], &mut noise)
        };
        let v: Vec<f64> = scene.free.iter().map(|_| noise.signed()).collect();
        let rows = scene.problem.len();
        let even = [0.0, 0.5, 1.0, noise.unit()][round % 4];
        let uneven: Vec<f64> = (0..rows).map(|_| noise.unit()).collect();
        for restitution in [vec![even; rows], uneven] {
            // Springs take a thousand times as long as the other laws.
            for law in LAWS.into_iter().filter(|law| round % 10 == 0 || !matches!(law, ImpactLaw::Pulse(_))) {
                let (outcome, after) = strike(&scene, law, &v, &restitution);
                let (start, end) = (energy(&scene, &v), energy(&scene, &after));
                let label = format!("round {round}, {law:?}, e = {restitution:?}: {:?}", outcome.status);
                assert_ne!(outcome.status, ImpactStatus::NotSolved, "{label}");
                // Propagation with little restitution converges slowly, as relaxation does; the others end.
                let ended = outcome.status != ImpactStatus::LimitReached;
                let springs = matches!(law, ImpactLaw::Pulse(_));
                assert!(ended || law == ImpactLaw::Propagation || springs, "{label}");
                assert!(outcome.impulses.iter().all(|impulse| *impulse >= 0.0), "{label}");
                assert!(outcome.velocities_after.iter().all(|u| *u >= 0.0), "{label}");
                let rows_after = scene.problem.row_velocities(&after).unwrap();
                for (claimed, true_one) in outcome.velocities_after.iter().zip(&rows_after) {
                    assert!((claimed - true_one).abs() < 1e-12, "{label}: {claimed} {true_one}");
                }
                // The law itself; then with the rounding of the velocities, sums over up to 20 impulses a body.
                let law_rise = outcome.energy_change / start / f64::EPSILON;
                assert!(law_rise <= 4.0, "{label}: {law_rise} eps");
                let rise = (end - start) / start / f64::EPSILON;
                assert!(rise <= 20.0, "{label}: {rise} eps");
                assert!((end - start - outcome.energy_change).abs() <= 1e-14 * start, "{label}");
                let listed: f64 = outcome.applications.iter().map(|application| application.energy_change).sum();
                if outcome.finishing.is_empty() {
                    assert!((listed - outcome.energy_change).abs() <= 1e-13 * start, "{label}");
                }
                // The expansions of Poisson and of Stronge are stopped where they would push bodies together elsewhere.
                let may_lose = matches!(law, ImpactLaw::Poisson | ImpactLaw::Energetic);
                if restitution.iter().all(|e| *e == 1.0) && !may_lose {
                    // Springs keep the energy to the error of their steps.
                    let kept = if matches!(law, ImpactLaw::Pulse(_)) { 1e-9 } else { 1e-13 };
                    assert!((end - start).abs() <= kept * start, "{label}: {:e}", (end - start) / start);
                }
            }
        }
    }
}

/// Newton's law row by row: with one restitution every row that the simultaneous law strikes leaves at least as fast
/// as -e times its approach.
#[test]
fn simultaneous_law_is_newtons_law_with_inequality() {
    let mut noise = Noise::new(61);
    for _ in 0..100 {
        let scene = cradle(&[1.0 + noise.unit(), 1.0 + noise.unit(), 1.0 + noise.unit(), 1.0 + noise.unit()]);
        let v: Vec<f64> = (0..4).map(|_| noise.signed()).collect();
        let before = scene.problem.row_velocities(&v).unwrap();
        let (outcome, _) = strike(&scene, ImpactLaw::Simultaneous, &v, &[0.6; 3]);
        if outcome.solves == 1 {
            for (u, after) in before.iter().zip(&outcome.velocities_after) {
                assert!(*u >= 0.0 || *after >= -0.6 * u - 1e-14);
            }
        }
    }
}

/// Nothing happens where nothing approaches; bad arguments are refused; extreme ones end.
#[test]
fn edge_cases_of_impacts() {
    for law in LAWS {
        let (outcome, after) = strike(&cradle(&[1.0; 3]), law, &[0.0, 1.0, 1.0], &[1.0; 2]);
        assert_eq!((outcome.status, outcome.applications.len()), (ImpactStatus::NoApproach, 0));
        assert_eq!(after, [0.0, 1.0, 1.0]);
        let scene = cradle(&[1.0; 3]);
        let (delassus, settings) = (scene.problem.delassus(), ImpactSettings::default());
        let mut solver = ComplementaritySolver::default();
        let (contacts, delassus, settings) = (&scene.problem, &delassus, &settings);
        let mut resolve = |u_before: &[f64], restitution: &[f64]| {
            law.resolve(&ImpactProblem { contacts, delassus, u_before, restitution, settings }, &mut solver)
        };
        assert!(resolve(&[-1.0, f64::NAN], &[1.0; 2]).is_err());
        assert!(resolve(&[-1.0, 0.0], &[1.0, 1.5]).is_err());
        assert!(resolve(&[-1.0, 0.0], &[1.0, f64::NAN]).is_err());
        assert!(resolve(&[-1.0], &[1.0]).is_err());
        for huge in [1e300, 1e-300] {
            let outcome = resolve(&[-huge, 0.0], &[1.0; 2]).unwrap();
            assert!(outcome.velocities_after.iter().all(|u| *u >= 0.0), "{law:?} {outcome:?}");
        }
    }
}

/// One body of three equal masses at rows of its own.
fn lone_body(rows: &[[f64; 3]]) -> Scene {
    let rows: Vec<Row> = rows.iter().map(|row| vec![(0, row.to_vec())]).collect();
    Scene::new(3, &[vec![1.0; 3]], &rows, &[0.0; 3])
}

/// A body that fits exactly between two walls of different restitution cannot leave both: the smallest is used.
#[test]
fn walls_of_different_restitution_on_both_sides() {
    let scene = lone_body(&[[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]);
    let (outcome, after) = strike(&scene, ImpactLaw::Simultaneous, &[0.0, 0.0, -1.0], &[0.0, 0.5]);
    assert_eq!(outcome.status, ImpactStatus::RestitutionLowered);
    assert_eq!(after, [0.0; 3]);
}

/// Where only rest is possible, no reflection ends: it is given up early, not after the limit of rounds.
#[test]
fn reflections_between_walls_on_all_sides_are_given_up() {
    let scene = lone_body(&[[0.0, 0.0, -1.0], [-1.0, 1.0, 0.0], [1.0, 0.0, 1.0], [0.0, -1.0, 0.0]]);
    let (outcome, after) = strike(&scene, ImpactLaw::Reflection, &[0.0, 0.0, 1.0], &[1.0; 4]);
    assert_eq!(outcome.status, ImpactStatus::LimitReached);
    assert!(outcome.solves < 100, "{}", outcome.solves);
    assert_close(&after, &[0.0; 3], 1e-13);
}

/// What many impulses between two walls leave of a velocity is 1e-13 with a rounding of 1e-16: the walls must not pass
/// for a squeeze.
#[test]
fn rounding_of_many_impulses_is_no_squeeze() {
    let scene = lone_body(&[[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]);
    let (outcome, _) = strike(&scene, ImpactLaw::Propagation, &[0.0, 0.0, -1.0], &[0.3; 2]);
    assert_eq!(outcome.status, ImpactStatus::StoppedAtThreshold);
    assert_eq!(outcome.velocities_after, [0.0; 2]);
}

/// What every law promises, for rows that repeat, oppose or depend on each other: see [`degenerate_impacts_end_well`].
fn check_degenerate(small: &Small, v: &[f64], restitution: &[f64]) -> Result<(), TestCaseError> {
    let scene = small.scene();
    let (v, restitution) = (&v[..scene.free.len()], &restitution[..scene.problem.len()]);
    let start = energy(&scene, v);
    let delassus = scene.problem.delassus();
    let root = |row: usize| delassus.get(row, row).sqrt();
    let before = scene.problem.row_velocities(v).unwrap();
    let (apart, settings) = (vec![-1.0; scene.problem.len()], SolverSettings::default());
    let separable = solve_complementarity(&scene.problem, &delassus, &apart, None, &settings).unwrap();
    let separable = separable.report.status == SolverStatus::Solved;
    for law in LAWS {
        let (outcome, after) = strike(&scene, law, v, restitution);
        let label = format!("{small:?}\n{law:?}, v = {v:?}, e = {restitution:?}: {:?}", outcome.status);
        prop_assert!(outcome.status != ImpactStatus::NotSolved, "{label}");
        let ended = outcome.status != ImpactStatus::LimitReached;
        let springs = matches!(law, ImpactLaw::Pulse(_));
        prop_assert!(ended || law == ImpactLaw::Propagation || !separable || springs, "{label}");
        prop_assert!(outcome.impulses.iter().all(|impulse| *impulse >= 0.0), "{label}");
        prop_assert!(outcome.velocities_after.iter().all(|u| *u >= 0.0), "{label}");
        // The terms that make up a velocity; impulses of opposite rows cancel in it.
        let terms: f64 = outcome.impulses.iter().enumerate().map(|(row, impulse)| root(row) * impulse).sum();
        let rows_after = scene.problem.row_velocities(&after).unwrap();
        for (row, (claimed, found)) in outcome.velocities_after.iter().zip(&rows_after).enumerate() {
            let scale = before[row].abs() + root(row) * (terms + (2.0 * start).sqrt());
            prop_assert!((claimed - found).abs() <= 1e-12 * scale, "{label}: row {row}: {claimed:e} {found:e}");
        }
        let end = energy(&scene, &after);
        let size = start + terms * terms;
        prop_assert!(outcome.energy_change <= 4.0 * f64::EPSILON * size, "{label}: {:e}", outcome.energy_change);
        prop_assert!((end - start - outcome.energy_change).abs() <= 1e-13 * size, "{label}: {start} {end}");
        let may_lose = matches!(law, ImpactLaw::Poisson | ImpactLaw::Energetic);
        // A body that just fits between two others can have no velocity: springs that keep all energy never end there.
        let keeps = outcome.finishing.is_empty() && !may_lose && ended;
        let elastic = restitution.iter().all(|e| *e == 1.0) && keeps;
        let kept = if matches!(law, ImpactLaw::Pulse(_)) { 1e-9 } else { 1e-12 };
        prop_assert!(!elastic || (end - start).abs() <= kept * size, "{label}: {start} {end}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(few(100))]

    /// Impacts of up to three bodies at up to 14 rows of whole numbers, repeated, opposite or zero, mass ratios up to
    /// 60: every law ends, leaves no row approaching and does not raise the energy. Rest is always possible, so no
    /// impact is infeasible.
    #[test]
    fn degenerate_impacts_end_well(
        small in small(vec![1.0, 1e1]),
        v in prop::collection::vec((-3_i8..=3).prop_map(f64::from), 9),
        even in prop::sample::select(vec![0.0, 0.5, 1.0, 0.3]),
        uneven in prop::collection::vec(prop::sample::select(vec![0.0, 0.5, 1.0, 0.9]), 14),
    ) {
        check_degenerate(&small, &v, &[even; 14])?;
        check_degenerate(&small, &v, &uneven)?;
    }
}
