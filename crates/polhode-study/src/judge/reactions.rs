//! Which part of the impulses that bodies need contacts and joints can give, by their laws.
//!
//! ```text
//! minimise  |P - H^T l|^2 in the metric of M^-1,   l within the cones of a law;   left over:  u = M^-1 (P - H^T l)
//! ```
//!
//! A law is a cone of directions at each contact: with friction `n + mu t` for all unit tangents `t`. The least is
//! looked for over a few of them, by the complementarity problem `0 <= l _|_ H u <= 0`; then the direction in which
//! what is left grows most is added, until nothing is left or nothing is gained. Symbols: `P` impulses (N s, N m s),
//! `H` directions, `l` their impulses (N s), `M` masses, `mu` coefficient of friction, `n` normal.
//!
//! Source: the dual of Gauss's principle of least constraint; directions are generated as in the fully corrective
//! method of Frank and Wolfe 1956.

use polhode::response::{Ask, ContactProblem, Memory, ResponseError, RowProblem, solve};
use polhode::spatial::{DMat3, DVec3};

/// A round that leaves more than this part of what the last one left gains nothing (no unit, 0.9 to 0.999).
const GAINS: f64 = 0.99;

/// Bodies that need impulses.
#[derive(Debug, Clone, Default)]
pub(super) struct Needs {
    /// Inverse masses (1/kg) and inverse inertias (1/(kg m^2)).
    pub(super) masses: Vec<(f64, DMat3)>,
    /// What each needs: N s, and N m s about the point that its arms begin at.
    pub(super) impulses: Vec<[DVec3; 2]>,
    /// The size of each, m.
    pub(super) sizes: Vec<f64>,
}

/// Bodies of a contact among those of [`Needs`], with their arms to it (m), A first; none for one that no force moves.
pub(super) type Ends = [Option<(usize, DVec3)>; 2];

/// What can act.
#[derive(Debug, Clone)]
pub(super) enum Reaction {
    /// A contact: normal, coefficient of friction.
    Cone { ends: Ends, normal: DVec3, friction: f64 },
    /// One direction: a contact that slides.
    Along { ends: Ends, direction: DVec3 },
    /// Any impulse whose part along the normal pushes.
    Push { ends: Ends, normal: DVec3 },
    /// Both signs along a row: bodies with their entries.
    Row(Vec<(usize, [DVec3; 2])>),
}

/// What is left of the needs, and which impulses were found.
#[derive(Debug, Clone)]
pub(super) struct Left {
    /// Velocities that nothing explains, of each body: m/s and rad/s.
    pub(super) velocities: Vec<[DVec3; 2]>,
    /// The largest impulse of each reaction along its directions, summed, N s.
    pub(super) impulses: Vec<f64>,
}

impl Left {
    /// The largest velocity that is left, m/s, and of which body.
    pub(super) fn largest(&self, needs: &Needs) -> (f64, usize) {
        let speed = |(body, own): (usize, &[DVec3; 2])| (own[0].length() + own[1].length() * needs.sizes[body], body);
        self.velocities
            .iter()
            .enumerate()
            .map(speed)
            .fold((0.0, 0), |most, own| if own.0 > most.0 { own } else { most })
    }
}

impl Needs {
    /// What nothing explains where nothing acts.
    pub(super) fn alone(&self) -> Left {
        let of = |((mass, inertia), own): (&(f64, DMat3), &[DVec3; 2])| [own[0] * *mass, *inertia * own[1]];
        Left { velocities: self.masses.iter().zip(&self.impulses).map(of).collect(), impulses: Vec::new() }
    }

    /// What is left where these act; `enough` (m/s) is nothing.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn left(&self, reactions: &[Reaction], enough: f64) -> Result<Left, ResponseError> {
        let free = self.alone();
        if reactions.is_empty() || free.largest(self).0 <= enough {
            return Ok(Left { impulses: vec![0.0; reactions.len()], ..free });
        }
        let mut problem = Problem::of(self, reactions)?;
        let mut last = f64::INFINITY;
        loop {
            let left = problem.solved(self, &free, reactions.len())?;
            let (largest, _) = left.largest(self);
            if largest <= enough || largest > GAINS * last || !problem.add_directions(reactions, &left, enough)? {
                return Ok(left);
            }
            last = largest;
        }
    }
}

/// The row of a direction at a contact.
fn along(ends: Ends, direction: DVec3) -> Vec<(usize, [DVec3; 2])> {
    let row = |(end, sign): (Option<(usize, DVec3)>, f64)| {
        let (body, arm) = end?;
        let force = direction * sign;
        Some((body, [force, arm.cross(force)]))
    };
    ends.into_iter().zip([1.0, -1.0]).filter_map(row).collect()
}

/// The directions that are tried, as rows.
struct Problem {
    rows: ContactProblem,
    /// The reaction of each row.
    of_reaction: Vec<usize>,
    entries: Vec<Vec<(usize, [DVec3; 2])>>,
}

impl Problem {
    fn of(needs: &Needs, reactions: &[Reaction]) -> Result<Self, ResponseError> {
        let mut inverse_masses = Vec::with_capacity(36 * needs.masses.len());
        for (mass, inertia) in &needs.masses {
            for row in 0..6 {
                for column in 0..6 {
                    inverse_masses.push(match (row < 3, column < 3) {
                        (true, true) if row == column => *mass,
                        (false, false) => inertia.col(column - 3)[row - 3],
                        _ => 0.0,
                    });
                }
            }
        }
        let rows = ContactProblem::new(6, inverse_masses)?;
        let mut problem = Self { rows, of_reaction: Vec::new(), entries: Vec::new() };
        for (number, reaction) in reactions.iter().enumerate() {
            match reaction {
                Reaction::Cone { ends, normal, friction } => {
                    problem.push(number, along(*ends, *normal))?;
                    for tangent in tangents(*normal).into_iter().filter(|_| *friction > 0.0) {
                        problem.push(number, along(*ends, *normal + tangent * *friction))?;
                    }
                }
                Reaction::Along { ends, direction } => {
                    problem.push(number, along(*ends, *direction))?;
                }
                Reaction::Push { ends, normal } => {
                    problem.push(number, along(*ends, *normal))?;
                    for tangent in tangents(*normal).into_iter().step_by(2) {
                        problem.hold(number, along(*ends, tangent))?;
                    }
                }
                Reaction::Row(entries) => problem.hold(number, entries.clone())?,
            }
        }
        Ok(problem)
    }

    /// A direction in which something pushes.
    fn push(&mut self, reaction: usize, entries: Vec<(usize, [DVec3; 2])>) -> Result<(), ResponseError> {
        self.add(reaction, entries, ContactProblem::push_row)
    }

    /// One in which it pulls too.
    fn hold(&mut self, reaction: usize, entries: Vec<(usize, [DVec3; 2])>) -> Result<(), ResponseError> {
        self.add(reaction, entries, ContactProblem::push_held_row)
    }

    fn add(
        &mut self,
        reaction: usize,
        entries: Vec<(usize, [DVec3; 2])>,
        push: impl FnOnce(&mut ContactProblem, &[(usize, &[f64])]) -> Result<usize, ResponseError>,
    ) -> Result<(), ResponseError> {
        if entries.is_empty() {
            return Ok(());
        }
        let numbers: Vec<(usize, [f64; 6])> = (entries.iter())
            .map(|(body, [force, moment])| (*body, [force.x, force.y, force.z, moment.x, moment.y, moment.z]))
            .collect();
        let slices: Vec<(usize, &[f64])> = numbers.iter().map(|(body, row)| (*body, row.as_slice())).collect();
        push(&mut self.rows, &slices)?;
        self.of_reaction.push(reaction);
        self.entries.push(entries);
        Ok(())
    }

    /// What is left with the directions so far.
    fn solved(&self, needs: &Needs, free: &Left, reactions: usize) -> Result<Left, ResponseError> {
        let rate = |entries: &Vec<(usize, [DVec3; 2])>| {
            let of = |(body, [force, moment]): &(usize, [DVec3; 2])| {
                let [linear, angular] = free.velocities[*body];
                force.dot(linear) + moment.dot(angular)
            };
            -entries.iter().map(of).sum::<f64>()
        };
        let constants: Vec<f64> = self.entries.iter().map(rate).collect();
        let mut memory = Memory::default();
        let found = solve(&RowProblem::new(&self.rows, &constants), Ask::Instant, &mut memory)?;
        let mut impulses = vec![0.0; reactions];
        let mut left: Vec<[DVec3; 2]> = needs.impulses.clone();
        for ((entries, impulse), reaction) in self.entries.iter().zip(&found.reactions).zip(&self.of_reaction) {
            impulses[*reaction] += impulse.abs();
            for (body, [force, moment]) in entries {
                left[*body][0] -= *force * *impulse;
                left[*body][1] -= *moment * *impulse;
            }
        }
        let needs = Needs { impulses: left, ..needs.clone() };
        Ok(Left { impulses, ..needs.alone() })
    }

    /// Adds the direction of each cone in which what is left grows most; whether there was any.
    fn add_directions(&mut self, reactions: &[Reaction], left: &Left, enough: f64) -> Result<bool, ResponseError> {
        let mut is_added = false;
        for (number, reaction) in reactions.iter().enumerate() {
            let Reaction::Cone { ends, normal, friction } = reaction else { continue };
            let at = |end: &Option<(usize, DVec3)>| {
                end.map_or(DVec3::ZERO, |(body, arm)| {
                    let [linear, angular] = left.velocities[body];
                    linear + angular.cross(arm)
                })
            };
            let leaves = at(&ends[0]) - at(&ends[1]);
            let Some(tangent) = leaves.reject_from(*normal).try_normalize() else { continue };
            let direction = *normal + tangent * *friction;
            if *friction > 0.0 && leaves.dot(direction) > f64::EPSILON * enough {
                let entries = along(*ends, direction);
                self.push(number, entries)?;
                is_added = true;
            }
        }
        Ok(is_added)
    }
}

/// Tangents of a normal, in four directions.
fn tangents(normal: DVec3) -> [DVec3; 4] {
    let [x, y] = polhode::contact::tangent_basis(normal);
    [x, -x, y, -y]
}
