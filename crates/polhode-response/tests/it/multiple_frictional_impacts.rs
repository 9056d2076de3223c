//! Impacts with friction at several contacts: energy, Coulomb's law, and what they must agree with.
//!
//! Random structures of 1 to 8 contacts: boxes on some of their corners, balls in rows and heaps, bodies that touch
//! anywhere. Without friction the answer is that of the reflection; contacts that do not move each other have the
//! answers of single contacts; a row of balls with friction still passes momentum on.

use crate::cases::few;
use crate::free_bodies::{Vector, cross, free_bodies, random_vector, tangents, unit};
use crate::scenes::Noise;
use polhode_response::Law;
use polhode_response::friction::FrictionProblem;
use polhode_response::{
    CollisionMatrix, ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings, ImpactStatus,
    MultipleFrictionalImpact, MultipleImpact, MultipleImpactLaw, MultipleImpactSettings, RestitutionLaw,
    SingleFrictionalImpact,
};
use proptest::prelude::*;

/// Bodies in contact, with velocities and coefficients.
#[derive(Debug, Clone)]
struct Structure {
    problem: ContactProblem,
    velocities: Vec<f64>,
    frictions: Vec<f64>,
    restitutions: Vec<f64>,
}

impl Structure {
    /// Bodies with these masses and principal moments along the axes of the world.
    fn of(bodies: &[(f64, Vector)], velocities: Vec<f64>) -> Self {
        let problem = free_bodies(bodies);
        Self { problem, velocities, frictions: Vec::new(), restitutions: Vec::new() }
    }

    /// A contact with a normal from B (none: the ground) to A, at arms from the centres of mass.
    fn touch(
        &mut self,
        a: (usize, Vector),
        b: Option<(usize, Vector)>,
        normal: Vector,
        friction: f64,
        restitution: f64,
    ) {
        let [first, second] = tangents(normal);
        for axis in [normal, first, second] {
            let block =
                |arm: Vector, sign: f64| [axis, cross(arm, axis)].concat().iter().map(|x| sign * x).collect::<Vec<_>>();
            let own = block(a.1, 1.0);
            let other = b.map(|(body, arm)| (body, block(arm, -1.0)));
            let mut entries: Vec<(usize, &[f64])> = vec![(a.0, &own)];
            if let Some((body, block)) = &other {
                entries.push((*body, block));
            }
            self.problem.push_row(&entries).unwrap();
        }
        self.frictions.push(friction);
        self.restitutions.push(restitution);
    }

    fn contacts(&self) -> FrictionProblem {
        let delassus = self.problem.delassus();
        let rows = self.problem.len();
        let entries: Vec<f64> = (0..rows * rows).map(|k| delassus.get(k / rows, k % rows)).collect();
        let blocks = self.frictions.iter().map(|&friction| Law::Cone { rows: 3, friction }).collect();
        FrictionProblem::from_dense(blocks, &entries, self.problem.row_velocities(&self.velocities).unwrap()).unwrap()
    }

    fn strike(&self, law: MultipleImpactLaw, single: RestitutionLaw) -> (FrictionProblem, MultipleImpact) {
        let contacts = self.contacts();
        let settings = MultipleImpactSettings::default();
        let (contacts_ref, restitution) = (&contacts, &self.restitutions[..]);
        let impact = MultipleFrictionalImpact {
            contacts: contacts_ref,
            restitution,
            stand_for_several: &[],
            law,
            single,
            settings: &settings,
        };
        let outcome = impact.resolve().unwrap();
        (contacts, outcome)
    }
}

fn coefficients(noise: &mut Noise) -> (f64, f64) {
    let friction = [0.0, 0.1, 0.5, 1.0, 3.0][noise.below(5)] * (0.5 + noise.unit());
    (friction, [0.0, 0.5, 0.9, 1.0, noise.unit()][noise.below(5)])
}

/// A box on 1 to 4 of its lower corners.
fn random_box(noise: &mut Noise) -> Structure {
    let half = [0, 1, 2].map(|_| 0.1 + noise.unit());
    let moments = [0, 1, 2].map(|k| (half[(k + 1) % 3].powi(2) + half[(k + 2) % 3].powi(2)) / 3.0);
    let velocities = [random_vector(noise), random_vector(noise)].concat();
    let mut structure = Structure::of(&[(1.0, moments)], velocities);
    let (friction, restitution) = coefficients(noise);
    for corner in 0..4_u32 {
        if noise.below(4) == 0 && corner > 0 {
            continue;
        }
        let sign = |bit: u32| if corner & bit == 0 { 1.0 } else { -1.0 };
        let arm = [sign(1) * half[0], sign(2) * half[1], -half[2]];
        structure.touch((0, arm), None, [0.0, 0.0, 1.0], friction, restitution);
    }
    structure
}

/// Balls in a heap, each touching some others and perhaps the ground. Normals follow from the places of the centres, so
/// that the heap can always fly apart.
fn random_balls(noise: &mut Noise) -> Structure {
    let count = 2 + noise.below(4);
    let bodies: Vec<(f64, Vector)> = (0..count)
        .map(|_| {
            let mass = 10.0_f64.powf(noise.signed());
            (mass, [0.4 * mass; 3])
        })
        .collect();
    let centres: Vec<Vector> = (0..count).map(|_| random_vector(noise)).collect();
    let velocities = (0..6 * count).map(|_| noise.signed()).collect();
    let mut structure = Structure::of(&bodies, velocities);
    let (friction, restitution) = coefficients(noise);
    let differ = noise.below(2) == 0;
    let pairs = (0..count).flat_map(|a| (0..a).map(move |b| (a, Some(b))).chain([(a, None)]));
    for (a, b) in pairs {
        if structure.frictions.len() == 8 || noise.below(2) == 0 {
            continue;
        }
        let (friction, restitution) = if differ { coefficients(noise) } else { (friction, restitution) };
        let normal = match b {
            Some(b) => unit([0, 1, 2].map(|k| centres[a][k] - centres[b][k])),
            None => [0.0, 0.0, 1.0],
        };
        structure.touch((a, normal.map(|x| -x)), b.map(|b| (b, normal)), normal, friction, restitution);
    }
    if structure.frictions.is_empty() {
        structure.touch((0, [0.0, 0.0, -1.0]), None, [0.0, 0.0, 1.0], friction, restitution);
    }
    structure
}

/// Bodies that touch anywhere, with random moments.
fn random_bodies(noise: &mut Noise) -> Structure {
    let count = 1 + noise.below(3);
    let bodies: Vec<(f64, Vector)> = (0..count)
        .map(|_| {
            let parts = [0, 1, 2].map(|_| 10.0_f64.powf(noise.signed()));
            (10.0_f64.powf(noise.signed()), [parts[1] + parts[2], parts[0] + parts[2], parts[0] + parts[1]])
        })
        .collect();
    let velocities = (0..6 * count).map(|_| noise.signed()).collect();
    let mut structure = Structure::of(&bodies, velocities);
    for _ in 0..=noise.below(8) {
        let (friction, restitution) = coefficients(noise);
        let (a, b) = (noise.below(count), noise.below(count + 1));
        let tilted = random_vector(noise);
        let normal = unit([tilted[0], tilted[1], 1.2 + tilted[2]]);
        let other = (b < count && b > a).then(|| (b, random_vector(noise)));
        structure.touch((a, random_vector(noise)), other, normal, friction, restitution);
    }
    structure
}

fn random_structure(seed: u64) -> Structure {
    let noise = &mut Noise::new(seed);
    match noise.below(3) {
        0 => random_box(noise),
        1 => random_balls(noise),
        _ => random_bodies(noise),
    }
}

/// Impulses in the cones, velocities `u- + G p`, no approach, no rise of energy, and works that sum to its change.
fn check(structure: &Structure, law: MultipleImpactLaw, single: RestitutionLaw) -> ImpactStatus {
    let (contacts, outcome) = structure.strike(law, single);
    let after = contacts.velocities(&outcome.impulses).unwrap();
    let speeds = |u: &[f64]| u.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let size = speeds(contacts.constant());
    let work: f64 = outcome.impulses.iter().map(|p| p.abs() * size).sum();
    assert!(outcome.energy_change <= 1e-10 * work, "{outcome:?}");
    // And by the velocities that the impulses lead to, whatever the outcome says of them.
    let pairs = contacts.constant().iter().zip(&after).zip(&outcome.impulses);
    let change: f64 = pairs.map(|((before, after), impulse)| 0.5 * impulse * (before + after)).sum();
    assert!(change <= 1e-14 * work, "{change:e} {work:e} {outcome:?}");
    assert!(!outcome.energy_rises);
    let works: f64 = outcome.normal_work.iter().chain(&outcome.friction_work).sum();
    assert!((works - outcome.energy_change).abs() <= 1e-9 * work, "{works} {outcome:?}");
    if outcome.status == ImpactStatus::NotSolved {
        return outcome.status;
    }
    for (block, friction) in structure.frictions.iter().enumerate() {
        let range = contacts.range(block);
        let [normal, first, second] = [0, 1, 2].map(|k| outcome.impulses[range.start + k]);
        assert!(normal >= 0.0 && first.hypot(second) <= friction * normal * (1.0 + 1e-9) + 1e-12 * work, "{outcome:?}");
        assert!(outcome.velocities_after[range.start] >= 0.0);
    }
    for (found, expected) in outcome.velocities_after.iter().zip(&after) {
        assert!((found - expected).abs() <= 1e-8 * size, "{found} {expected} {outcome:?}");
    }
    outcome.status
}

proptest! {
    #![proptest_config(few(600))]

    #[test]
    fn contacts_struck_together_do_not_gain_energy(seed in any::<u64>()) {
        check(&random_structure(seed), MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
    }

    #[test]
    fn contacts_struck_in_order_do_not_gain_energy(seed in any::<u64>(), which in 0..3_usize) {
        let single = [
            RestitutionLaw::Stronge,
            RestitutionLaw::Poisson,
            RestitutionLaw::ChatterjeeRuina { tangential_restitution: 0.5 },
        ][which];
        check(&random_structure(seed), MultipleImpactLaw::Sequence, single);
    }
}

/// Random impacts are solved together, save some with large friction, which are struck in order; none is left unsolved.
#[test]
fn random_impacts_are_solved() {
    let mut in_order = 0;
    for seed in 0..1000 {
        let status = check(&random_structure(seed), MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
        assert_ne!(status, ImpactStatus::NotSolved, "{seed}");
        in_order += usize::from(status == ImpactStatus::StruckInOrder);
    }
    println!("{in_order} in order");
    assert!(in_order <= 20, "{in_order}");
}

/// Without friction the impact is the reflection.
#[test]
fn without_friction_it_is_the_reflection() {
    let mut compared = 0;
    for seed in 0..300 {
        let mut structure = random_structure(seed);
        structure.frictions.fill(0.0);
        let restitution = structure.restitutions[0];
        structure.restitutions.fill(restitution);
        let (contacts, outcome) = structure.strike(MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
        let normals: Vec<usize> = (0..contacts.len()).map(|block| 3 * block).collect();
        let delassus = structure.problem.delassus();
        let entry = |i: usize, j: usize| delassus.get(normals[i], normals[j]);
        let reflected =
            reflect(&normals.iter().map(|&row| contacts.constant()[row]).collect::<Vec<_>>(), &entry, restitution);
        let Some(reflected) = reflected else { continue };
        if outcome.status != ImpactStatus::Separated {
            continue;
        }
        compared += 1;
        for (&row, expected) in normals.iter().zip(&reflected) {
            assert!((outcome.velocities_after[row] - expected).abs() < 1e-9, "{seed} {outcome:?} {reflected:?}");
        }
    }
    assert!(compared > 200, "{compared}");
}

/// The reflection of contacts with this Delassus matrix, through a problem of one body whose inverse mass is the
/// matrix.
fn reflect(u_before: &[f64], entry: &dyn Fn(usize, usize) -> f64, restitution: f64) -> Option<Vec<f64>> {
    let count = u_before.len();
    let inverse = (0..count * count).map(|k| entry(k / count, k % count)).collect();
    let mut contacts = ContactProblem::new(count, inverse).ok()?;
    for k in 0..count {
        let row: Vec<f64> = (0..count).map(|j| if j == k { 1.0 } else { 0.0 }).collect();
        contacts.push_row(&[(0, &row)]).unwrap();
    }
    let (delassus, settings) = (contacts.delassus(), ImpactSettings::default());
    let restitution = vec![restitution; count];
    let problem = ImpactProblem {
        contacts: &contacts,
        delassus: &delassus,
        u_before,
        restitution: &restitution,
        settings: &settings,
    };
    let outcome = ImpactLaw::Reflection.resolve(&problem, &mut ComplementaritySolver::default()).unwrap();
    (outcome.status == ImpactStatus::Separated).then_some(outcome.velocities_after)
}

/// Contacts that do not move each other are struck each by the law of a single contact, with all digits.
#[test]
fn separate_contacts_are_single_impacts() {
    for seed in 0..100 {
        let noise = &mut Noise::new(seed);
        let bodies: Vec<(f64, Vector)> = (0..4).map(|_| (1.0, [0, 1, 2].map(|_| 0.5 + 0.4 * noise.unit()))).collect();
        let velocities: Vec<f64> = (0..24).map(|_| noise.signed()).collect();
        let mut structure = Structure::of(&bodies, velocities);
        for body in 0..4 {
            let (friction, restitution) = coefficients(noise);
            let normal = unit(random_vector(noise));
            structure.touch((body, random_vector(noise)), None, normal, friction, restitution);
        }
        let (contacts, outcome) = structure.strike(MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
        let delassus = structure.problem.delassus();
        for body in 0..4 {
            let rows = [3 * body, 3 * body + 1, 3 * body + 2];
            let single = SingleFrictionalImpact {
                collision: CollisionMatrix::of_rows(&delassus, rows).unwrap(),
                velocity_before: rows.map(|row| contacts.constant()[row]),
                friction: structure.frictions[body],
                restitution: structure.restitutions[body],
                law: RestitutionLaw::Stronge,
            };
            let expected = single.resolve().unwrap();
            assert_eq!(rows.map(|row| outcome.impulses[row]), expected.impulse);
            assert_eq!(rows.map(|row| outcome.velocities_after[row]), expected.velocity_after);
        }
    }
}

/// A cradle of five rough balls passes the momentum on; the ball that was hit last leaves, and friction has no slip to
/// act on.
#[test]
fn cradle_of_rough_balls() {
    let mut velocities = vec![0.0; 30];
    velocities[0] = 1.0;
    let mut cradle = Structure::of(&[(1.0, [0.4; 3]); 5], velocities);
    for k in 0..4 {
        cradle.touch((k + 1, [-1.0, 0.0, 0.0]), Some((k, [1.0, 0.0, 0.0])), [1.0, 0.0, 0.0], 0.3, 1.0);
    }
    let (_, outcome) = cradle.strike(MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
    let change = cradle.problem.response(&outcome.impulses).unwrap();
    for ball in 0..5 {
        let after = cradle.velocities[6 * ball] + change[6 * ball];
        assert!((after - if ball == 4 { 1.0 } else { 0.0 }).abs() < 1e-12, "{ball}: {after}");
    }
    assert!(outcome.energy_change.abs() < 1e-12);
}

/// A ball that hits two touching ones between them (Bernoulli), with friction: mirror images stay mirror images.
#[test]
fn symmetric_impacts_stay_symmetric() {
    let (c, s) = (0.75_f64.sqrt(), 0.5);
    let mut velocities = vec![0.0; 18];
    velocities[0] = 1.0;
    let mut balls = Structure::of(&[(1.0, [0.4; 3]); 3], velocities);
    for (ball, sign) in [(1, 1.0), (2, -1.0)] {
        let normal = [c, sign * s, 0.0];
        balls.touch((ball, normal.map(|x| -x)), Some((0, normal)), normal, 0.4, 0.8);
    }
    let (_, outcome) = balls.strike(MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
    let change = balls.problem.response(&outcome.impulses).unwrap();
    let [first, second] = [1, 2].map(|ball| change[6 * ball..6 * ball + 6].to_vec());
    assert!(
        (first[0] - second[0]).abs() < 1e-12
            && (first[1] + second[1]).abs() < 1e-12
            && (first[5] + second[5]).abs() < 1e-12
    );
    assert!(change[1].abs() < 1e-12 && change[5].abs() < 1e-12);
    assert!(outcome.energy_change < 0.0);
}

/// Painleve's rod beside a wall that its upper end leaves: two contacts, of which one jams. The impulse is that of the
/// foot alone, in closed form. Below the critical friction finite forces exist, and nothing happens.
#[test]
fn jam_beside_a_wall() {
    let (sin, cos) = (0.75_f64.sqrt(), 0.5);
    for friction in [0.5, 1.5] {
        // Slender rod of 1 kg and 2 m in the plane of x and z.
        let velocities = vec![-1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mut rod = Structure::of(&[(1.0, [1.0 / 3.0; 3])], velocities);
        rod.touch((0, [-cos, 0.0, -sin]), None, [0.0, 0.0, 1.0], friction, 0.3);
        rod.touch((0, [cos, 0.0, sin]), None, [-1.0, 0.0, 0.0], friction, 0.3);
        let contacts = rod.contacts();
        let (restitution, settings) = ([0.3; 2], MultipleImpactSettings::default());
        let impact = MultipleFrictionalImpact {
            contacts: &contacts,
            restitution: &restitution,
            stand_for_several: &[],
            law: MultipleImpactLaw::Simultaneous,
            single: RestitutionLaw::Stronge,
            settings: &settings,
        };
        // Pressed down, and off the wall.
        let fall = rod.problem.row_velocities(&[-1.0, 0.0, -9.81, 0.0, 0.0, 0.0]).unwrap();
        let outcome = impact.without_collision(&fall).unwrap();
        if friction < 1.0 {
            assert_eq!((outcome.status, outcome.impulses), (ImpactStatus::NoApproach, vec![0.0; 6]));
            continue;
        }
        let (k_nn, k_nt, k_tt) = (1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin);
        let first = 1.0 / (friction * k_tt + k_nt);
        let normal = first - (k_nn + friction * k_nt) * first / (k_nn - k_nt * k_nt / k_tt);
        assert!((outcome.impulses[0] / normal - 1.0).abs() < 1e-10, "{normal} {outcome:?}");
        assert_eq!(outcome.impulses[3..], [0.0; 3]);
        assert!(outcome.velocities_after[..3].iter().all(|u| u.abs() < 1e-10), "{outcome:?}");
        assert!(outcome.energy_change < 0.0);
        // And resolve() says that nothing approaches.
        assert_eq!(impact.resolve().unwrap().status, ImpactStatus::NoApproach);
    }
}

/// Turning the tangents of every contact, and other units of mass and speed, turn and scale the answer: boxes and heaps
/// of balls with common friction.
#[test]
fn tangents_and_units_are_a_matter_of_choice() {
    let mut compared = 0;
    for seed in 0..300 {
        let noise = &mut Noise::new(seed);
        let structure = if seed % 2 == 0 { random_box(noise) } else { random_balls(noise) };
        // With many contacts or much friction there may be several answers.
        if structure.frictions.len() > 3 || structure.frictions.iter().any(|friction| *friction > 1.0) {
            continue;
        }
        let (contacts, plain) = structure.strike(MultipleImpactLaw::Simultaneous, RestitutionLaw::Stronge);
        let (mass, speed, angle) = (3.0, 7.0, 6.3 * noise.unit());
        let (rows, delassus) = (contacts.rows(), structure.problem.delassus());
        // Row by row: the normal stays, the tangents turn.
        let turn = |row: usize| -> Vec<(usize, f64)> {
            let (c, s, first) = (angle.cos(), angle.sin(), row - row % 3);
            [vec![(first, 1.0)], vec![(first + 1, c), (first + 2, s)], vec![(first + 1, -s), (first + 2, c)]][row % 3]
                .clone()
        };
        let mut entries = vec![0.0; rows * rows];
        for i in 0..rows {
            for j in 0..rows {
                let terms = turn(i).into_iter().flat_map(|(a, x)| turn(j).into_iter().map(move |(b, y)| (a, b, x * y)));
                entries[i * rows + j] = terms.map(|(a, b, x)| x * delassus.get(a, b) / mass).sum();
            }
        }
        let turned = |values: &[f64]| -> Vec<f64> {
            (0..rows).map(|row| turn(row).into_iter().map(|(k, x)| x * values[k]).sum()).collect()
        };
        let constant = turned(contacts.constant()).iter().map(|u| u * speed).collect();
        let other = FrictionProblem::from_dense(contacts.blocks().to_vec(), &entries, constant).unwrap();
        let impact = MultipleFrictionalImpact {
            contacts: &other,
            restitution: &structure.restitutions,
            stand_for_several: &[],
            law: MultipleImpactLaw::Simultaneous,
            single: RestitutionLaw::Stronge,
            settings: &MultipleImpactSettings::default(),
        };
        let found = impact.resolve().unwrap();
        assert_eq!(found.status, plain.status, "{seed}");
        for (found, expected) in found.velocities_after.iter().zip(turned(&plain.velocities_after)) {
            assert!((found / speed - expected).abs() < 1e-7, "{seed}: {found} {expected}");
        }
        compared += 1;
    }
    assert!(compared > 80, "{compared}");
}
