//! Bilateral constraints: what holds two bodies, or a body and the world, together by forces of either sign.
//!
//! | row | velocity | reaction |
//! |---|---|---|
//! | along a direction `d` (unit vector) | `u = d.(v_A + w_A x r_A - v_B - w_B x r_B)` | `l d` at the point, on A |
//! | about an axis `n` (a length times a vector) | `u = n.(w_A - w_B)` | moment `l n` on A |
//!
//! B bears the opposite; the world as B has no entry. Each row has a gap (m), its rate (m/s), and what its second
//! derivative contains beside the accelerations of the bodies (m/s^2), here called its bias; a reaction keeps all three
//! at zero. The row of a tie (`tie.rs`) has a part along each of two coordinates; its reaction here is what it does
//! along the first one. Rows of rotations are multiplied by a length, so that all rows have one unit. Sources: thesis
//! 3.2, equations 2 and 3; Featherstone 2008, chapter 8 (rows of joints).
//!
//! A kinematic member contributes known terms to rates (by its velocity in the states) and to the second derivatives
//! ([`Model::driven_acceleration`]), and does work on the other one ([`Model::driven_work`]). Rows are made in
//! `point.rs`, `line.rs` and `perpendicular.rs`, and put together in one file for each kind of joint.

use crate::constraint::ConstraintId;
use crate::constraint::row::{Action, BilateralRow, Member, Part, RowKind, RowsAt};
use crate::constraint::softness::Softness;
use crate::model::{Model, prescribed};
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// A bilateral constraint in given states.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bilateral {
    pub(crate) id: ConstraintId,
    /// Where its force acts, world, m.
    pub(crate) point: DVec3,
    /// The movable ones of its bodies.
    pub(crate) members: Vec<Member>,
    /// The kinematic ones.
    pub(crate) drivers: Vec<Member>,
    pub(crate) rows: Vec<BilateralRow>,
    /// Of a spring, a damper or a motor at a joint in a time step: its one row is soft.
    pub(crate) softness: Option<Softness>,
}

/// What a constraint does to its first body, and the opposite of what it does to the second: a force at its point (N;
/// an impulse, N s) and a moment (N m, N m s), world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Reaction {
    pub(crate) force: DVec3,
    pub(crate) moment: DVec3,
}

impl Bilateral {
    /// The constraint of this identity with these rows.
    pub(crate) fn new(id: ConstraintId, RowsAt { point, members, drivers, rows }: RowsAt) -> Self {
        Self { id, point, members, drivers, rows, softness: None }
    }

    /// A soft row.
    pub(crate) fn soft(id: ConstraintId, rows: RowsAt, softness: Softness) -> Self {
        Self { softness: Some(softness), ..Self::new(id, rows) }
    }

    /// How far the bodies are from where they are held, m.
    pub(crate) fn gap(&self) -> f64 {
        length(self.rows.iter().map(|row| row.gap))
    }

    /// How fast they leave it, m/s.
    pub(crate) fn speed(&self) -> f64 {
        length(self.rows.iter().map(|row| row.rate))
    }

    /// Whether nothing in it moves.
    pub(crate) fn stands(&self) -> bool {
        self.rows.iter().all(|row| row.rate == 0.0)
    }

    /// The reaction of these multipliers of its rows.
    pub(crate) fn reaction(&self, multipliers: &[f64]) -> Reaction {
        let mut reaction = Reaction::default();
        for (row, &multiplier) in self.rows.iter().zip(multipliers) {
            match row.kind {
                RowKind::Along(direction) => reaction.force += direction * multiplier,
                RowKind::About(axis) | RowKind::Tied { first: Action::Moment(axis), .. } => {
                    reaction.moment += axis * multiplier;
                }
                RowKind::Helix { along, about } | RowKind::Turning { along, about } => {
                    reaction.force += along * multiplier;
                    reaction.moment += about * multiplier;
                }
                RowKind::Tied { first: Action::Force { direction, .. }, .. } => {
                    reaction.force += direction * multiplier;
                }
            }
        }
        reaction
    }

    /// The multiplier of its first row in a reaction.
    pub(crate) fn multiplier(&self, reaction: Reaction) -> f64 {
        self.rows.first().map_or(0.0, |row| row.multiplier(reaction))
    }

    /// Work of an impulse of this constraint, J, where its rows had the rates of `self` before it and have those of
    /// `after`: `l (u- + u+)/2` of each row. Directions are orthogonal to each other, and so are axes.
    pub(crate) fn work(&self, after: &Self, impulse: Reaction) -> f64 {
        let work =
            |(row, after): (&BilateralRow, &BilateralRow)| 0.5 * row.multiplier(impulse) * (row.rate + after.rate);
        self.rows.iter().zip(&after.rows).map(work).sum()
    }

    /// What a reaction does to its movable bodies: (body, force, moment about the centre of mass).
    pub(crate) fn loads(&self, reaction: Reaction) -> impl Iterator<Item = (usize, DVec3, DVec3)> + '_ {
        let tied = self.tied().map(|row| (row, row.multiplier(reaction)));
        self.members.iter().map(move |member| {
            if let Some((row, multiplier)) = tied {
                let (along, about) = row.entries(member);
                return (member.body, along * multiplier, about * multiplier);
            }
            let force = reaction.force * member.sign;
            (member.body, force, member.arm.cross(force) + reaction.moment * member.sign)
        })
    }

    /// Bounds of the force (N) and the moment (N m) of a reaction on each of its movable bodies.
    pub(crate) fn magnitudes(&self, reaction: Reaction) -> impl Iterator<Item = (usize, f64, f64)> + '_ {
        let tied = self.tied().map(|row| (row, row.multiplier(reaction)));
        self.members.iter().map(move |member| {
            if let Some((row, multiplier)) = tied {
                let (along, about) = row.entries(member);
                return (member.body, (along * multiplier).length(), (about * multiplier).length());
            }
            let force = reaction.force.length();
            (member.body, force, force * member.arm.length() + reaction.moment.length())
        })
    }

    /// Its row if it is a tie.
    fn tied(&self) -> Option<&BilateralRow> {
        self.rows.first().filter(|row| matches!(row.kind, RowKind::Tied { .. }))
    }
}

impl BilateralRow {
    /// Its multiplier in a reaction, where directions of a constraint are orthogonal to each other, and so are axes.
    pub(crate) fn multiplier(&self, reaction: Reaction) -> f64 {
        match self.kind {
            RowKind::Along(direction) | RowKind::Helix { along: direction, .. } => reaction.force.dot(direction),
            RowKind::About(axis)
            | RowKind::Turning { about: axis, .. }
            | RowKind::Tied { first: Action::Moment(axis), .. } => reaction.moment.dot(axis) / axis.length_squared(),
            RowKind::Tied { first: Action::Force { direction, .. }, .. } => {
                reaction.force.dot(direction) / direction.length_squared()
            }
        }
    }
}

fn length(parts: impl Iterator<Item = f64>) -> f64 {
    parts.fold(0.0, |sum: f64, part| sum + part * part).sqrt()
}

/// Term of prescribed accelerations at `t` (s) in the second derivative of the gap of a row, m/s^2.
pub(crate) fn driven_acceleration(model: &Model, t: f64, bilateral: &Bilateral, row: &BilateralRow) -> f64 {
    let term = |driver: &Member| {
        let (along, about) = row.entries(driver);
        let (linear, angular) = prescribed::prescribed_acceleration(model, driver.body, t);
        along.dot(linear) + about.dot(angular)
    };
    bilateral.drivers.iter().map(term).reduce(|sum, own| sum + own).unwrap_or(0.0)
}

/// Work of kinematic bodies on those that constraints hold to them, J, by these impulses; of forces their power, W.
pub(crate) fn driven_work<'a>(
    model: &Model,
    states: &[BodyState],
    reactions: impl Iterator<Item = (&'a Bilateral, Reaction)>,
) -> f64 {
    let by_driver = |bilateral: &Bilateral, reaction: Reaction, driver: &Member| {
        let velocity = model.velocity(driver.body, &states[driver.body]);
        if let Some(row) = bilateral.tied() {
            let (along, about) = row.entries(driver);
            return -row.multiplier(reaction) * (along.dot(velocity.linear) + about.dot(velocity.angular));
        }
        let at_point = velocity.linear + velocity.angular.cross(driver.arm);
        -driver.sign * (reaction.force.dot(at_point) + reaction.moment.dot(velocity.angular))
    };
    let work = |(bilateral, reaction): (&'a Bilateral, Reaction)| {
        bilateral.drivers.iter().map(move |driver| by_driver(bilateral, reaction, driver))
    };
    reactions.flat_map(work).sum()
}

/// Momentum that reactions of constraints with the world, or with kinematic bodies (N s, N) give to the bodies that
/// they hold, angular about a point: between movable bodies they cancel.
pub(crate) fn bilateral_support<'a>(
    about: DVec3,
    reactions: impl Iterator<Item = (&'a Bilateral, Reaction)>,
) -> Momentum {
    let mut sum = MomentumSum::default();
    for (constraint, reaction) in reactions {
        if let Some(row) = constraint.tied() {
            for own in tie_support(constraint, row, reaction, about) {
                sum.add(own);
            }
            continue;
        }
        let [member] = constraint.members[..] else { continue };
        let linear = reaction.force * member.sign;
        let moment = reaction.moment * member.sign;
        sum.add(Momentum { linear, angular: (constraint.point - about).cross(linear) + moment });
    }
    sum.value()
}

/// The same of a tie: of those of its coordinates that have one movable body.
fn tie_support(constraint: &Bilateral, row: &BilateralRow, reaction: Reaction, about: DVec3) -> [Momentum; 2] {
    let none = Momentum { linear: DVec3::ZERO, angular: DVec3::ZERO };
    let RowKind::Tied { first, second } = row.kind else { return [none; 2] };
    let multiplier = row.multiplier(reaction);
    [(Part::First, first), (Part::Second, second)].map(|(part, action)| {
        let mut members = constraint.members.iter().filter(|member| member.part == part);
        let (Some(member), None) = (members.next(), members.next()) else { return none };
        let signed = multiplier * member.sign;
        match action {
            Action::Force { direction, point } => {
                let linear = direction * signed;
                Momentum { linear, angular: (point - about).cross(linear) }
            }
            Action::Moment(axis) => Momentum { linear: DVec3::ZERO, angular: axis * signed },
        }
    })
}

/// Applies impulses of constraints to the momenta of their bodies.
pub(crate) fn apply_reactions<'a>(
    model: &Model,
    states: &mut [BodyState],
    impulses: impl Iterator<Item = (&'a Bilateral, Reaction)>,
) {
    for (constraint, impulse) in impulses {
        for (body, linear, angular) in constraint.loads(impulse) {
            if let Some(rigid) = &model.bodies[body].rigid {
                let state = &mut states[body];
                state.linear_velocity += linear * rigid.inverse_mass();
                state.angular_momentum += angular;
            }
        }
    }
}
