//! Laws that every impact with friction at one contact obeys, over random bodies, slips and coefficients.
//!
//! What a law promises (Newton: velocities; Poisson: impulses; Stronge: work), what Coulomb's law asks for, that energy
//! does not rise, and that turning, mirroring and scaling the problem turns, mirrors and scales the answer. Closed
//! forms: the plane, by an impulse diagram that is written here afresh, and the jam of Painleve's rod.

use crate::cases::few;
use crate::scenes::Noise;
use polhode_response::RestitutionLaw::{self, ChatterjeeRuina, Newton, Poisson, Stronge, Whittaker};
use polhode_response::{
    CollisionMatrix, FrictionalImpact, FrictionalImpactStatus, PhaseKind, SingleFrictionalImpact, SlidingContact,
    SlidingForce,
};
use proptest::prelude::*;

/// Rounding of an outcome relative to its size.
const ROUNDING: f64 = 1e-12;

/// A random rotation by a unit quaternion.
fn rotation(noise: &mut Noise) -> [[f64; 3]; 3] {
    let mut q = [0.0; 4].map(|_: f64| noise.signed());
    let size = q.iter().map(|x| x * x).sum::<f64>().sqrt().max(1e-3);
    q = q.map(|x| x / size);
    let [w, x, y, z] = q;
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

/// `1/m - [r] I^-1 [r]` of a random body: masses over two decades, shapes from rods to spheres, any arm.
fn random_matrix(noise: &mut Noise) -> [[f64; 3]; 3] {
    let mass = 10.0_f64.powf(2.0 * noise.signed());
    let parts = [0, 1, 2].map(|_| mass * 10.0_f64.powf(1.5 * noise.signed()));
    let moments = [parts[1] + parts[2], parts[0] + parts[2], parts[0] + parts[1]];
    let turn = rotation(noise);
    let arm = [0, 1, 2].map(|_| 2.0 * noise.signed());
    let inverse = |i: usize, j: usize| (0..3).map(|k| turn[i][k] * turn[j][k] / moments[k]).sum::<f64>();
    let cross = [[0.0, -arm[2], arm[1]], [arm[2], 0.0, -arm[0]], [-arm[1], arm[0], 0.0]];
    let mut matrix = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            let mut sum = if i == j { 1.0 / mass } else { 0.0 };
            for a in 0..3 {
                for b in 0..3 {
                    sum += cross[i][a] * inverse(a, b) * cross[j][b];
                }
            }
            matrix[i][j] = sum;
        }
    }
    for (i, j) in [(1, 0), (2, 0), (2, 1)] {
        matrix[i][j] = matrix[j][i];
    }
    matrix
}

/// A random impact; slips from none to large, coefficients from none to large.
fn random_impact(seed: u64, law: RestitutionLaw) -> (SingleFrictionalImpact, [[f64; 3]; 3]) {
    let noise = &mut Noise::new(seed);
    let mut matrix = random_matrix(noise);
    if noise.below(2) == 0 {
        let other = random_matrix(noise);
        (0..9).for_each(|k| matrix[k / 3][k % 3] += other[k / 3][k % 3]);
    }
    let slip = [0.0, 1e-6, 0.1, 1.0, 1.0, 10.0][noise.below(6)];
    let friction = [0.0, 0.01, 0.3, 0.6, 1.0, 3.0, 30.0][noise.below(7)] * (1.0 + noise.unit());
    let restitution = [0.0, 0.5, 0.9, 1.0, noise.unit()][noise.below(5)];
    let velocity_before = [-noise.unit().max(1e-3), slip * noise.signed(), slip * noise.signed()];
    let collision = CollisionMatrix::new(matrix).unwrap();
    (SingleFrictionalImpact { collision, velocity_before, friction, restitution, law }, matrix)
}

fn size(v: [f64; 3]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    size([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
}

/// What terms the rounding of an outcome comes from: velocities and `K p`.
fn velocity_size(impact: &SingleFrictionalImpact, outcome: &FrictionalImpact) -> f64 {
    size(impact.velocity_before) + size(impact.collision.times(outcome.impulse))
}

const LAWS: [RestitutionLaw; 6] = [
    Stronge,
    Poisson,
    Newton,
    Whittaker,
    ChatterjeeRuina { tangential_restitution: 0.0 },
    ChatterjeeRuina { tangential_restitution: 0.7 },
];

proptest! {
    #![proptest_config(few(2000))]

    /// Impulse in the cone, velocities after by `u- + K p`, works that sum to the energy, no approach afterwards.
    #[test]
    fn impulses_obey_coulomb_and_energy_is_booked(seed in any::<u64>(), which in 0..LAWS.len()) {
        let (impact, _) = random_impact(seed, LAWS[which]);
        let outcome = impact.resolve().unwrap();
        prop_assert_eq!(outcome.status, FrictionalImpactStatus::Separated);
        let [normal, first, second] = outcome.impulse;
        prop_assert!(normal > 0.0);
        prop_assert!(first.hypot(second) <= impact.friction * normal * (1.0 + ROUNDING));
        let change = impact.collision.times(outcome.impulse);
        let after = [0, 1, 2].map(|k| impact.velocity_before[k] + change[k]);
        let terms = velocity_size(&impact, &outcome);
        prop_assert!(difference(after, outcome.velocity_after) <= ROUNDING * terms, "{:?} {:?}", after, outcome);
        prop_assert!(outcome.velocity_after[0] >= -ROUNDING * terms);
        let works = outcome.normal_work + outcome.friction_work;
        let work_terms = size(outcome.impulse) * terms;
        prop_assert!((works - outcome.energy_change).abs() <= ROUNDING * work_terms, "{} {:?}", works, outcome);
        let phases: f64 = outcome.phases.iter().map(|phase| phase.normal_impulse).sum();
        prop_assert!(outcome.phases.is_empty() || (phases - normal).abs() <= ROUNDING * normal);
        let may_rise = matches!(LAWS[which], Newton | Whittaker);
        if !may_rise {
            prop_assert!(!outcome.energy_rises);
            prop_assert!(outcome.energy_change <= ROUNDING * work_terms, "{:?}", outcome);
        }
        prop_assert_eq!(outcome.energy_rises, outcome.energy_change > 1e-10 * work_terms || outcome.energy_rises);
    }

    /// Each law restores what it says: velocity, impulse or work.
    #[test]
    fn restitution_is_what_the_law_says(seed in any::<u64>()) {
        let e = random_impact(seed, Stronge).0.restitution;
        for law in [Newton, Whittaker, ChatterjeeRuina { tangential_restitution: 0.3 }] {
            let (impact, _) = random_impact(seed, law);
            let outcome = impact.resolve().unwrap();
            let expected = -e * impact.velocity_before[0];
            prop_assert!((outcome.velocity_after[0] - expected).abs() <= ROUNDING * velocity_size(&impact, &outcome));
        }
        let (impact, _) = random_impact(seed, Poisson);
        let outcome = impact.resolve().unwrap();
        let expected = (1.0 + e) * outcome.compression_impulse;
        prop_assert!((outcome.impulse[0] - expected).abs() <= ROUNDING * expected);
        let (impact, matrix) = random_impact(seed, Stronge);
        let restored = impact.resolve().unwrap();
        let compressed = SingleFrictionalImpact { restitution: 0.0, ..impact }.resolve().unwrap();
        // Slip may turn into a jam while the bodies part, which compresses them once more: the last compression counts.
        let once = (restored.compression_impulse - compressed.compression_impulse).abs() <= ROUNDING;
        let expected = (1.0 - e * e) * compressed.normal_work;
        let terms = restored.impulse[0] * velocity_size(&impact, &restored);
        let excess = restored.normal_work - expected;
        prop_assert!(!once || excess.abs() <= ROUNDING * terms, "{:?} {:?}", matrix, restored);
        prop_assert!(restored.normal_work <= ROUNDING * terms);
    }

    /// Turning the tangents turns the answer; mirroring them mirrors it.
    #[test]
    fn tangents_are_a_matter_of_choice(seed in any::<u64>(), angle in 0.0..6.3_f64, mirrored in any::<bool>()) {
        let sign = if mirrored { -1.0 } else { 1.0 };
        let (c, s) = (angle.cos(), angle.sin());
        let turn = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, sign * s, sign * c]];
        let apply = |v: [f64; 3]| [0, 1, 2].map(|i| (0..3).map(|j| turn[i][j] * v[j]).sum::<f64>());
        for law in LAWS {
            let (impact, matrix) = random_impact(seed, law);
            let entry = |i: usize, j: usize| {
                (0..9).map(|k| turn[i][k / 3] * matrix[k / 3][k % 3] * turn[j][k % 3]).sum::<f64>()
            };
            let turned = SingleFrictionalImpact {
                collision: CollisionMatrix::new([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))).unwrap(),
                velocity_before: apply(impact.velocity_before),
                ..impact
            };
            let (one, other) = (impact.resolve().unwrap(), turned.resolve().unwrap());
            // An impact may stand at a border, between stick and slip: there the two may differ in kind, not in number.
            let tolerance = 1e-9 * velocity_size(&impact, &one);
            let apart = difference(apply(one.velocity_after), other.velocity_after);
            prop_assert!(apart <= tolerance, "{:?} {:?}", one, other);
            prop_assert!(difference(apply(one.impulse), other.impulse) <= 1e-9 * size(one.impulse));
        }
    }

    /// Units of mass and speed scale the answer; powers of two, without a bit of difference.
    #[test]
    fn units_are_a_matter_of_choice(seed in any::<u64>(), powers in (-40..40_i32, -40..40_i32)) {
        let (mass, speed) = (2.0_f64.powi(powers.0), 2.0_f64.powi(powers.1));
        for law in LAWS {
            let (impact, matrix) = random_impact(seed, law);
            let scaled = SingleFrictionalImpact {
                collision: CollisionMatrix::new(matrix.map(|row| row.map(|x| x / mass))).unwrap(),
                velocity_before: impact.velocity_before.map(|u| u * speed),
                ..impact
            };
            let (one, other) = (impact.resolve().unwrap(), scaled.resolve().unwrap());
            prop_assert_eq!(one.velocity_after.map(|u| u * speed), other.velocity_after);
            prop_assert_eq!(one.impulse.map(|p| p * (mass * speed)), other.impulse);
        }
    }

    /// The plane: slip, stop, stick or reverse, by the impulse diagram of Wang and Mason, written as text books have
    /// it.
    #[test]
    fn impulse_diagram_in_the_plane(
        inertia in 0.05..5.0_f64,
        arm in (-2.0..2.0_f64, -2.0..2.0_f64),
        slip in -3.0..3.0_f64,
        friction in 0.0..2.5_f64,
        // Below that the diagram, which takes a difference of works, loses digits.
        e in 0.01..1.0_f64,
    ) {
        let [k_nn, k_tt] = [arm.0, arm.1].map(|lever| 1.0 + lever * lever / inertia);
        let k_nt = arm.0 * arm.1 / inertia;
        // Pieces as (length in normal impulse, rate of u_n, rate of u_t, p_t per p_n).
        let sign = if slip > 0.0 { 1.0 } else { -1.0 };
        let rates = |ratio: f64| (k_nn + k_nt * ratio, k_nt + k_tt * ratio, ratio);
        let first = rates(-friction * sign);
        let stops = if first.1 * sign < 0.0 { -slip / first.1 } else { f64::INFINITY };
        let stick = -k_nt / k_tt;
        let second = if stick.abs() <= friction { rates(stick) } else { rates(friction * stick.signum()) };
        // u_n, normal work and p_t after a normal impulse p.
        let at = |p: f64| {
            let (x, y) = (p.min(stops), (p - stops).max(0.0));
            let u = -1.0 + first.0 * x;
            let work = x * (-1.0 + 0.5 * first.0 * x) + y * (u + 0.5 * second.0 * y);
            (u + second.0 * y, work, first.2 * x + second.2 * y)
        };
        let zero = |f: &dyn Fn(f64) -> f64, from: f64| {
            let (mut low, mut high) = (from, from.max(1e-3));
            while f(high) < 0.0 {
                high *= 2.0;
            }
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if f(middle) < 0.0 { low = middle } else { high = middle }
            }
            high
        };
        let compressed = zero(&|p| at(p).0, 0.0);
        let work = at(compressed).1;
        let ends = [
            (Newton, zero(&|p| at(p).0 - e, compressed)),
            (Poisson, (1.0 + e) * compressed),
            (Stronge, zero(&|p| at(p).1 - (1.0 - e * e) * work, compressed)),
        ];
        for (law, end) in ends {
            let impact = SingleFrictionalImpact {
                collision: CollisionMatrix::planar(k_nn, k_nt, k_tt).unwrap(),
                velocity_before: [-1.0, slip, 0.0],
                friction,
                restitution: e,
                law,
            };
            let outcome = impact.resolve().unwrap();
            prop_assert!((outcome.impulse[0] - end).abs() <= ROUNDING * end, "{:?} {:?} {}", impact, outcome, end);
            let tangential = at(end).2;
            prop_assert!((outcome.impulse[1] - tangential).abs() <= ROUNDING * end * (1.0 + friction));
            if law != Newton {
                prop_assert!(outcome.energy_change <= 1e-14 * outcome.impulse[0]);
            }
        }
    }

    /// Painleve's rod above its critical friction: the jam without a collision, in closed form. The slip stops after
    /// `p_1 = s / |g|`, having driven the ends together at `u = a p_1`; then it sticks until the work is given back.
    #[test]
    fn jam_of_a_rod(degrees in 52.0..72.0_f64, speed in 0.01..10.0_f64, e in 0.0..1.0_f64) {
        let (friction, (sin, cos)) = (1.5, degrees.to_radians().sin_cos());
        let (k_nn, k_nt, k_tt) = (1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin);
        let collision = CollisionMatrix::planar(k_nn, k_nt, k_tt).unwrap();
        let contact = SlidingContact { collision, slip: [-speed, 0.0], friction, free_acceleration: -9.0 };
        prop_assert_eq!(contact.forces().unwrap(), SlidingForce::Inconsistent);
        let outcome = contact.impact_without_collision(e, Stronge).unwrap();
        let (a, g) = (k_nn + friction * k_nt, friction * k_tt + k_nt);
        let first = speed / g;
        let driven = a * first;
        let stick = k_nn - k_nt * k_nt / k_tt;
        prop_assert!(a < 0.0 && (k_nt / k_tt).abs() <= friction);
        let work = 0.5 * a * first * first - 0.5 * driven * driven / stick;
        let after = e * (-2.0 * work * stick).sqrt();
        let normal = first - driven / stick + after / stick;
        let kinds: Vec<PhaseKind> = outcome.phases.iter().map(|phase| phase.kind).collect();
        prop_assert_eq!(kinds, vec![PhaseKind::Jam, PhaseKind::Stick]);
        prop_assert!((outcome.impulse[0] - normal).abs() <= 1e-13 * normal);
        prop_assert!((outcome.velocity_after[0] - after).abs() <= 1e-13 * (after - driven));
        prop_assert_eq!(outcome.velocity_after[1], 0.0);
        prop_assert!(outcome.energy_change < 0.0);
        for law in LAWS {
            let outcome = contact.impact_without_collision(e, law).unwrap();
            prop_assert_eq!(outcome.velocity_after[1], 0.0);
            prop_assert!(outcome.velocity_after[0] >= 0.0 && outcome.energy_change < 0.0);
        }
    }
}

/// Newton's law raises the energy of some random impacts, by a lot, and each of them says so.
#[test]
fn newtons_law_is_reported_where_it_raises_the_energy() {
    let (mut reported, mut most) = (0, 0.0_f64);
    for seed in 0..20_000 {
        for law in [Newton, Whittaker] {
            let (impact, matrix) = random_impact(seed, law);
            let outcome = impact.resolve().unwrap();
            let terms = size(outcome.impulse) * velocity_size(&impact, &outcome);
            let rises = outcome.energy_change > 1e-10 * terms;
            assert!(!rises || outcome.energy_rises, "{matrix:?} {outcome:?}");
            reported += usize::from(outcome.energy_rises);
            most = most.max(outcome.energy_change / terms);
        }
    }
    println!("{reported} of 40000, most {most:.2}");
    assert!(reported > 20 && most > 0.01, "{reported} {most}");
}

/// The case of Painleve's rod at rest on a floor, as Coulomb's law sees it.
#[test]
fn forces_of_a_sliding_rod() {
    let (sin, cos) = (0.75_f64.sqrt(), 0.5);
    let collision = CollisionMatrix::planar(1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin).unwrap();
    let contact = |friction: f64, rate: f64| SlidingContact {
        collision,
        slip: [-1.0, 0.0],
        friction,
        free_acceleration: rate * rate * sin - 9.81,
    };
    let force = |found: SlidingForce| match found {
        SlidingForce::Regular(force) | SlidingForce::Indeterminate(force) => force,
        _ => f64::NAN,
    };
    let regular = contact(0.5, 1.0).forces().unwrap();
    assert!(matches!(regular, SlidingForce::Regular(_)));
    assert!((force(regular) / 8.127_332_526_095_617 - 1.0).abs() < 1e-14);
    assert_eq!(contact(1.5, 1.0).forces().unwrap(), SlidingForce::Inconsistent);
    let undecided = contact(1.5, 4.0).forces().unwrap();
    assert!(matches!(undecided, SlidingForce::Indeterminate(_)));
    assert!((force(undecided) / 20.379_051_003_822_65 - 1.0).abs() < 1e-12);
    assert_eq!(contact(0.5, 4.0).forces().unwrap(), SlidingForce::Separates);
    assert!(SlidingContact { slip: [0.0; 2], ..contact(0.5, 1.0) }.forces().is_err());
}
