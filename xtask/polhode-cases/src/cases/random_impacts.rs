//! Random impacts with friction: boxes on some of their corners, balls in a heap, bodies that touch anywhere.

use glam::DVec3;
use polhode::response::Law;
use polhode::response::friction::FrictionProblem;
use polhode::response::{
    ContactProblem, MultipleFrictionalImpact, MultipleImpact, MultipleImpactLaw, MultipleImpactSettings, RestitutionLaw,
};
use polhode_oracles::random::Random;
use std::error::Error;

/// Most contacts of an impact.
const MOST_CONTACTS: usize = 8;

/// The laws that never raise the energy.
const LAWS: [RestitutionLaw; 3] =
    [RestitutionLaw::Stronge, RestitutionLaw::Poisson, RestitutionLaw::ChatterjeeRuina { tangential_restitution: 0.6 }];

/// A body: mass, principal moments along the axes of the world, velocities.
#[derive(Debug, Clone, Copy)]
struct Body {
    mass: f64,
    moments: DVec3,
    linear: DVec3,
    angular: DVec3,
}

/// A contact on body `a`, against body `b` or the ground, at arms from the centres of mass; normal towards `a`.
#[derive(Debug, Clone, Copy)]
struct Touch {
    a: (usize, DVec3),
    b: Option<(usize, DVec3)>,
    normal: DVec3,
    friction: f64,
    restitution: f64,
}

/// A random impact.
#[derive(Debug)]
pub(super) struct RandomImpact {
    bodies: Vec<Body>,
    touches: Vec<Touch>,
}

/// The largest rise of energy so far, relative to the energy before, and where it was.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Rise {
    pub(super) amount: f64,
    pub(super) seed: u64,
}

impl Rise {
    /// Another one. What is not a number stays.
    pub(super) fn include(&mut self, amount: f64, seed: u64) {
        if amount > self.amount || amount.is_nan() {
            *self = Self { amount, seed };
        }
    }
}

impl RandomImpact {
    /// The next of a sequence.
    pub(super) fn new(random: &mut Random) -> Self {
        let mut impact = Self { bodies: Vec::new(), touches: Vec::new() };
        match random.below(3) {
            0 => impact.cuboid(random),
            1 => impact.heap(random),
            _ => impact.anything(random),
        }
        impact
    }

    /// Number of contacts.
    pub(super) fn contacts(&self) -> usize {
        self.touches.len()
    }

    /// Resolves it by a law that never raises the energy; the seed chooses which. Returns the rise of the kinetic
    /// energy of the bodies, relative to that before.
    pub(super) fn strike(&self, seed: u64) -> Result<(f64, MultipleImpact), Box<dyn Error>> {
        let law = if seed.is_multiple_of(4) { MultipleImpactLaw::Sequence } else { MultipleImpactLaw::Simultaneous };
        self.resolve(law, LAWS[(seed / 4 % 3) as usize])
    }

    /// Resolves it one contact at a time by Newton's law.
    pub(super) fn strike_by_newton(&self) -> Result<(f64, MultipleImpact), Box<dyn Error>> {
        self.resolve(MultipleImpactLaw::Sequence, RestitutionLaw::Newton)
    }

    fn resolve(&self, law: MultipleImpactLaw, single: RestitutionLaw) -> Result<(f64, MultipleImpact), Box<dyn Error>> {
        let problem = self.problem()?;
        let before: Vec<f64> =
            self.bodies.iter().flat_map(|body| [body.linear.to_array(), body.angular.to_array()].concat()).collect();
        let (delassus, size) = (problem.delassus(), problem.len());
        let entries: Vec<f64> = (0..size).flat_map(|row| delassus.row(row).to_vec()).collect();
        let contact = |touch: &Touch| Law::Cone { rows: 3, friction: touch.friction };
        let blocks = self.touches.iter().map(contact).collect();
        let contacts = FrictionProblem::from_dense(blocks, &entries, problem.row_velocities(&before)?)?;
        let restitution: Vec<f64> = self.touches.iter().map(|touch| touch.restitution).collect();
        let settings = MultipleImpactSettings::default();
        let impact = MultipleFrictionalImpact {
            contacts: &contacts,
            restitution: &restitution,
            stand_for_several: &[],
            law,
            single,
            settings: &settings,
        };
        let outcome = impact.resolve()?;
        let change = problem.response(&outcome.impulses)?;
        let after: Vec<f64> = before.iter().zip(change).map(|(before, change)| before + change).collect();
        Ok(((self.kinetic_energy(&after) - self.kinetic_energy(&before)) / self.kinetic_energy(&before), outcome))
    }

    fn problem(&self) -> Result<ContactProblem, Box<dyn Error>> {
        let mut inverse_masses = Vec::new();
        for body in &self.bodies {
            let diagonal = [[1.0 / body.mass; 3], (1.0 / body.moments).to_array()].concat();
            for (row, value) in diagonal.iter().enumerate() {
                inverse_masses.extend((0..6).map(|column| if row == column { *value } else { 0.0 }));
            }
        }
        let mut problem = ContactProblem::new(6, inverse_masses)?;
        for touch in &self.touches {
            let first = touch.normal.any_orthonormal_vector();
            for axis in [touch.normal, first, touch.normal.cross(first)] {
                let block = |arm: DVec3, axis: DVec3| [axis.to_array(), arm.cross(axis).to_array()].concat();
                let (own, other) = (block(touch.a.1, axis), touch.b.map(|(body, arm)| (body, block(arm, -axis))));
                let mut entries: Vec<(usize, &[f64])> = vec![(touch.a.0, &own)];
                entries.extend(other.iter().map(|(body, block)| (*body, &block[..])));
                problem.push_row(&entries)?;
            }
        }
        Ok(problem)
    }

    fn kinetic_energy(&self, velocities: &[f64]) -> f64 {
        let of = |(body, v): (&Body, &[f64])| {
            let (linear, angular) = (DVec3::from_slice(v), DVec3::from_slice(&v[3..]));
            0.5 * (body.mass * linear.length_squared() + angular.dot(body.moments * angular))
        };
        self.bodies.iter().zip(velocities.chunks_exact(6)).map(of).sum()
    }

    fn body(&mut self, random: &mut Random, mass: f64, moments: DVec3) {
        let (linear, angular) = (random.vector(-1.0, 1.0), random.vector(-1.0, 1.0));
        self.bodies.push(Body { mass, moments, linear, angular });
    }

    /// A box on 1 to 4 of its lower corners.
    fn cuboid(&mut self, random: &mut Random) {
        let half = random.vector(0.1, 1.1);
        let squares = half * half / 3.0;
        let sum = squares.element_sum();
        self.body(random, 1.0, DVec3::splat(sum) - squares);
        let (friction, restitution) = coefficients(random);
        for corner in 0..4 {
            if corner == 0 || random.below(4) > 0 {
                let sign = |bit: usize| if corner & bit == 0 { 1.0 } else { -1.0 };
                let arm = DVec3::new(sign(1), sign(2), -1.0) * half;
                self.touches.push(Touch { a: (0, arm), b: None, normal: DVec3::Z, friction, restitution });
            }
        }
    }

    /// Balls in a heap, each touching some others and perhaps the ground.
    fn heap(&mut self, random: &mut Random) {
        let count = 2 + random.below(4);
        let centres: Vec<DVec3> = (0..count).map(|_| random.vector(-1.0, 1.0)).collect();
        for _ in 0..count {
            let mass = libm::exp10(random.between(-1.0, 1.0));
            self.body(random, mass, DVec3::splat(0.4 * mass));
        }
        let (alike, differ) = (coefficients(random), random.below(2) == 0);
        for a in 0..count {
            for b in (0..a).map(Some).chain([None]) {
                if self.touches.len() == MOST_CONTACTS || random.below(2) == 0 {
                    continue;
                }
                let (friction, restitution) = if differ { coefficients(random) } else { alike };
                let normal = b.map_or(DVec3::Z, |b| (centres[a] - centres[b]).normalize());
                let touch = Touch { a: (a, -normal), b: b.map(|b| (b, normal)), normal, friction, restitution };
                self.touches.push(touch);
            }
        }
        if self.touches.is_empty() {
            let (friction, restitution) = alike;
            self.touches.push(Touch { a: (0, -DVec3::Z), b: None, normal: DVec3::Z, friction, restitution });
        }
    }

    /// Bodies that touch anywhere.
    fn anything(&mut self, random: &mut Random) {
        let count = 1 + random.below(3);
        for _ in 0..count {
            let parts = random.vector(-1.0, 1.0).to_array().map(libm::exp10);
            let moments = DVec3::new(parts[1] + parts[2], parts[0] + parts[2], parts[0] + parts[1]);
            let mass = libm::exp10(random.between(-1.0, 1.0));
            self.body(random, mass, moments);
        }
        for _ in 0..=random.below(MOST_CONTACTS) {
            let (friction, restitution) = coefficients(random);
            let (a, b) = (random.below(count), random.below(count + 1));
            let normal = (random.vector(-1.0, 1.0) + 1.2 * DVec3::Z).normalize();
            let (arm, other) = (random.vector(-1.0, 1.0), random.vector(-1.0, 1.0));
            let b = (b < count && b > a).then_some((b, other));
            self.touches.push(Touch { a: (a, arm), b, normal, friction, restitution });
        }
    }
}

/// Coefficients of friction, from none to large, and of restitution.
fn coefficients(random: &mut Random) -> (f64, f64) {
    let friction = random.one_of(&[0.0, 0.1, 0.5, 1.0, 3.0]) * random.between(0.5, 1.5);
    let any = random.unit();
    (friction, random.one_of(&[0.0, 0.5, 0.9, 1.0, any]))
}
