//! The impulses of sustained contacts over a step: one complementarity problem at velocity level.
//!
//! In the middle of the step, after a free flight of h/2, let `chi` be the separation of a contact, `u-` its rate
//! before the kick of fields and `u+` after all impulses, `a` the part of `chi''` that is due to neither. Flight for
//! the other half gives `chi_end = chi + h/2 u+ + h^2/8 a` and `u_end = u+ + h/2 a`. A contact must not penetrate at
//! the end:
//!
//! `0 <= p _|_ u+ + r >= 0`,  `r = max(2 chi/h + h/4 a, h/2 a, u-)`:
//!
//! - the first term is the gap: the contact may approach as long as it does not penetrate at the end, and its gap
//!   closes exactly;
//! - the second applies to bodies that already touch and approach: they end at rest relative to each other;
//! - the third ensures that no energy is gained: `p (u- + u+)/2 = p (u- - r)/2 <= 0`, row by row (`shared_work.rs`).
//!
//! For bodies that rest, all three agree: `u- = -g h/2` and `u+ = g h/2`, and they end exactly where they began. Since
//! velocities that are reversed, `u+ = -u-`, satisfy all rows, the problem always has a solution.
//!
//! A kinematic body is one of infinite mass whose velocity and acceleration are given: they are in `u-`, `u+` and `a`.
//! The energy condition holds for relative rates. The work of the prescribed motion, `-p` times its part of the rate,
//! is booked as external work.
//!
//! Friction adds the rows of `sustained_friction.rs`.
//!
//! A row of a bilateral constraint is held at `u+ = -u-`: its impulse does no work, and the second half of the step
//! takes back the gap that the first has opened, but for its curvature (of order `h^3`), which the projection at the
//! end of the step removes (`projection.rs`). Rows of closed loops are those of their closed poses
//! (`crate::solve::closed_loops`).
//!
//! Rows of the problem: contacts that would penetrate at the end, and touching contacts; of pairs with many contacts
//! only some of them (`rows/many_contacts.rs`). Contacts that close because of the impulses are added until there are
//! none.

use super::cone_problem::KnownOfGroup;
use super::contacts::{NearContact, with_rate_at_point};
use super::middle::{Middle, Problem, Stops};
use super::row::Row;
use super::shared_work::{ContactWork, Kicked};
use super::solved_group::{Found, SolvedGroup};
use super::step::TimeStepper;
use super::step_rows::rows;
use super::sustained_friction::{self, TangentialRow};
use crate::accounting::time_step_report::{ContactImpulse, Stop, TimeStepReport};
use crate::constraint::row::BilateralRow;
use crate::joints::bilateral::Bilateral;
use crate::joints::soft_rows;
use crate::model::states_of::{set_states, states_of};
use crate::model::{Model, tolerances};
use crate::rows::assembly::Assembly;
use crate::rows::groups::{Group, coupled_groups};
use crate::rows::many_contacts::furthest_out;
use crate::solve::closed_loops::ClosedLoops;
use crate::solve::joint_loads::ContactForce;
use crate::solve::reactions::TangentReaction;
use polhode_dynamics::BodyState;
use polhode_response::solve::way;
use polhode_response::{ResponseError, WarmStart};
use polhode_spatial::DVec3;

/// Whether bilateral constraints hold bodies of an island.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Held {
    Nothing,
    ByJoints,
}

impl TimeStepper {
    /// Finds and applies the impulses of a step in its middle, after the first half of the free flight. The report
    /// names slips that end within the step; then nothing has been booked.
    /// `slips` are the speeds of slip of `near` at the start of the step
    /// ([`slips_at_start`](super::contacts::slips_at_start)). Returns the contacts (by index) that carry an impulse.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(super) fn sustain(
        &mut self,
        model: &Model,
        states: &mut [BodyState],
        bodies: &[usize],
        (near, slips): (&[NearContact], &[f64]),
        middle: Middle<'_>,
        report: &mut TimeStepReport,
    ) -> Result<Vec<usize>, ResponseError> {
        let Middle { problem, t, h, stops, kick } = middle;
        let loops = &ClosedLoops::of(model, states, bodies)?;
        let mut rows = rows(model, Kicked { states, bodies, kick, loops }, (near, slips), (problem, t, h))?;
        if let Stops::At(ids) = stops {
            for row in rows.iter_mut().filter(|row| ids.contains(&near[row.contact].id)) {
                row.friction = row.friction.map(TangentialRow::coming_to_rest);
            }
        }
        let before = states_of(states, bodies);
        let held = model.joints.held_among(bodies);
        let of_joints = if held.is_empty() { Held::Nothing } else { Held::ByJoints };
        let mut taken = self.first_choice(model, states, near, &rows, (h, of_joints));
        let mut solved: Vec<SolvedGroup> = Vec::new();
        loop {
            let members = || rows.iter().enumerate().filter(|(index, _)| taken[*index]);
            let id = |row: &Row| near[row.contact].id;
            let members: Vec<_> = members().map(|(index, row)| (index, id(row).a, id(row).b)).collect();
            if members.is_empty() && held.is_empty() {
                return Ok(Vec::new());
            }
            let mut last = std::mem::take(&mut solved);
            for group in coupled_groups(model, members.iter().copied(), &held) {
                let closes = |&index: &usize| rows[index].closes(rows[index].kinematics.separation_rate);
                if problem == Problem::Closing && !group.contacts.iter().any(closes) {
                    // Nothing strikes it.
                    continue;
                }
                // One that no contact has been added to has the answer that it had.
                let known = last.iter().position(|solved| solved.group == group);
                solved.push(if let Some(place) = known {
                    last.swap_remove(place)
                } else {
                    let kicked = Kicked { states, bodies, kick, loops };
                    self.solve_group(model, kicked, group, &rows, (near, middle), report)?
                });
            }
            for group in &mut solved {
                group.apply(model, states, (bodies, kick, loops), &rows, near);
            }
            if add_closing(model, states, near, &rows, &mut taken) {
                set_states(states, bodies, &before);
                continue;
            }
            let mut ending: Vec<Stop> = solved.iter().flat_map(|group| &group.found.stops).copied().collect();
            if stops == Stops::Sought {
                let kicked = Kicked { states, bodies, kick, loops };
                ending.extend(self.stops_of_lost(model, kicked, &solved, &rows, (near, middle), report)?);
            }
            if !ending.is_empty() {
                report.stops = ending;
                return Ok(Vec::new());
            }
            for group in &solved {
                group.found.tell(report);
            }
            report.contacts = report.contacts.max(members.len());
            let kicked = Kicked { states, bodies, kick, loops };
            return Ok(note(model, kicked, near, &rows, &solved, (t, h), report));
        }
    }

    /// The slips that end within the step, whatever static friction holds, of groups no part of whose impulses takes
    /// energy.
    fn stops_of_lost(
        &mut self,
        model: &Model,
        kicked: Kicked<'_>,
        solved: &[SolvedGroup],
        rows: &[Row],
        (near, middle): (&[NearContact], Middle<'_>),
        report: &mut TimeStepReport,
    ) -> Result<Vec<Stop>, ResponseError> {
        let middle = Middle { stops: Stops::SoughtOfAll, ..middle };
        let mut stops = Vec::new();
        for lost in solved.iter().filter(|group| group.share == 0.0) {
            let again = self.solve_group(model, kicked, lost.group.clone(), rows, (near, middle), report)?;
            stops.extend(again.found.stops);
        }
        Ok(stops)
    }

    /// Which rows are in the problem of a step of `h` (s) from the beginning. In a heap, and where joints hold
    /// (`holds`), the contacts that bore a force in the last step are among them: without, they would be found again
    /// one layer after the other, each by a problem of its own; what presses a limit of a joint may be far away.
    fn first_choice(
        &self,
        model: &Model,
        states: &[BodyState],
        near: &[NearContact],
        rows: &[Row],
        (h, holds): (f64, Held),
    ) -> Vec<bool> {
        // A blow reaches few of the contacts of a heap.
        let is_sustained = rows.iter().all(Row::is_sustained);
        let is_heap = is_sustained && self.resolves_together(near.len());
        let goes_on = is_heap || (is_sustained && holds == Held::ByJoints);
        let choose = |row: &Row| {
            let contact = &near[row.contact];
            (goes_on && self.carried.contains(contact.id)) || row.is_first_choice(model, states, contact, h)
        };
        let mut taken: Vec<bool> = rows.iter().map(choose).collect();
        if is_heap {
            // What is deflected closes other contacts, about as fast: with them one problem is enough.
            let speed = |row: &Row| row.kinematics.separation_rate + row.bound;
            let fastest = rows.iter().map(speed).fold(0.0, f64::min);
            for (row, taken) in rows.iter().zip(&mut taken) {
                *taken |= speed(row) < -fastest;
            }
        }
        thin_out(near, rows, &mut taken);
        taken
    }

    fn solve_group(
        &mut self,
        model: &Model,
        kicked: Kicked<'_>,
        group: Group,
        rows: &[Row],
        (near, middle): (&[NearContact], Middle<'_>),
        report: &mut TimeStepReport,
    ) -> Result<SolvedGroup, ResponseError> {
        let states = kicked.states;
        let Middle { problem: of_step, h, stops, .. } = middle;
        let members: Vec<&Row> = group.contacts.iter().map(|&index| &rows[index]).collect();
        let geometries = members.iter().map(|row| (near[row.contact].id, row.kinematics.geometry));
        let bilaterals = kicked.loops.bilaterals(model, states, &group.bodies).collect();
        let mut assembly = Assembly::with_bilaterals(model, (states, &group.bodies), geometries, bilaterals)?;
        let kick_of_row = |of: &Bilateral, row: &BilateralRow| kicked.change_of_row(of, row);
        if of_step == Problem::Sustained {
            let soft = soft_rows::soft_rows(model, (states, &group.bodies), h, &kicked.kick.of_joints, kick_of_row);
            assembly.push_soft(states, soft)?;
        }
        if kicked.loops.hold_any(&group.bodies) {
            assembly.find_supports();
        }
        let of_contacts = members.iter().map(|row| row.kinematics.separation_rate + row.bound);
        let constants = assembly.step_constants(of_contacts, kick_of_row);
        let friction: Vec<_> = members.iter().map(|row| row.friction).collect();
        let carried = (0..members.len()).filter(|&i| self.carried.contains(near[members[i].contact].id)).collect();
        // Rates of joints are differences of velocities, whatever the impulses are that follow from them.
        let noise_floor = if assembly.bilaterals().is_empty() {
            0.0
        } else {
            tolerances::velocity_rounding(model, states, &group.bodies)
        };
        let known = KnownOfGroup { contacts: members.len(), carried: WarmStart::new(carried), noise_floor };
        let cones = match of_step {
            Problem::Closing => &mut self.cones_at_start,
            Problem::Sustained => &mut self.cones,
        };
        let found = sustained_friction::solve(assembly, states, constants, &friction, &known, (cones, h, stops))?;
        report.factorisations += found.factorisations as u64;
        let sustained_friction::FrictionalImpulses { reactions, rubbing, .. } = found;
        let found = Found { residual: found.report.residual, violation: found.violation, stops: found.stops };
        Ok(SolvedGroup { group, reactions, rubbing, found, share: 1.0 })
    }
}

/// Rows of the same two bodies, which stand beside each other.
fn pairs<'a>(near: &'a [NearContact], rows: &'a [Row]) -> impl Iterator<Item = std::ops::Range<usize>> + 'a {
    let pair = |row: &Row| (near[row.contact].id.a, near[row.contact].id.b);
    rows.chunk_by(move |x, y| pair(x) == pair(y)).scan(0, |start, of_pair| {
        let range = *start..*start + of_pair.len();
        *start = range.end;
        Some(range)
    })
}

/// Leaves of the rows of pairs with many contacts those that are furthest out.
fn thin_out(near: &[NearContact], rows: &[Row], taken: &mut [bool]) {
    for of_pair in pairs(near, rows) {
        if way::are_many_of_a_pair(of_pair.clone().filter(|&index| taken[index]).count()) {
            let some = of_pair.clone().filter(|&index| taken[index]);
            let points: Vec<_> = some.map(|index| (index, rows[index].kinematics.geometry.point)).collect();
            let outer = furthest_out(&points);
            taken[of_pair].fill(false);
            for index in outer {
                taken[index] = true;
            }
        }
    }
}

/// Adds the rows that close with the present velocities; of pairs with many contacts the one that closes most. Rows
/// that are near to closing are left out: most of them stay open, and each makes the next problem larger. Returns
/// whether any closes.
fn add_closing(model: &Model, states: &[BodyState], near: &[NearContact], rows: &[Row], taken: &mut [bool]) -> bool {
    // Impulses have moved nothing: the contact is where it was.
    let rate = |row: &Row| with_rate_at_point(model, states, near[row.contact].id, row.kinematics).separation_rate;
    let mut added = false;
    for of_pair in pairs(near, rows) {
        let is_crowd = way::are_many_of_a_pair(of_pair.len());
        let open = of_pair.filter(|&index| !taken[index]).map(|index| (index, rate(&rows[index])));
        let mut closing: Vec<(usize, f64)> = open.filter(|&(index, rate)| rows[index].closes(rate)).collect();
        if is_crowd {
            let speed = |&(index, rate): &(usize, f64)| rate + rows[index].bound;
            closing = closing.into_iter().min_by(|a, b| speed(a).total_cmp(&speed(b))).into_iter().collect();
        }
        added |= !closing.is_empty();
        for (index, _) in closing {
            taken[index] = true;
        }
    }
    added
}

/// Books and records the impulses. Returns the contacts that carry one.
fn note(
    model: &Model,
    kicked: Kicked<'_>,
    near: &[NearContact],
    rows: &[Row],
    solved: &[SolvedGroup],
    (t, h): (f64, f64),
    report: &mut TimeStepReport,
) -> Vec<usize> {
    let states = kicked.states;
    let mut carrying = Vec::new();
    for group in solved {
        let (reactions, contacts) = (&group.reactions, || group.geometries(rows, near));
        report.told.take(model, states, reactions.of_bilaterals());
        let about = report.books.ledger.momentum.about;
        let given = reactions.support(model, about, contacts());
        let work = reactions.work(model, states, contacts());
        let friction_j = group.lost_to_friction_j(model, states);
        let acting = ContactWork { normal_j: group.energy_change(model, states, rows, near), friction_j };
        let shared = ContactWork {
            normal_j: kicked.shared_j(reactions.along_normals(contacts())),
            friction_j: kicked.shared_j(reactions.along_tangents())
                + kicked.shared_by_moments_j(reactions.of_rotations()),
        };
        let (work_j, of_integrator_j) = acting.in_symmetric_order(shared);
        report.books.impact((work_j.normal_j, work_j.friction_j), given, work);
        report.books.stray(kicked.loops.stray_momentum(states, about, reactions.of_bilaterals()));
        report.books.ledger.numerical.add(of_integrator_j);
        // Reactions do no work but for what the solver leaves.
        let after = kicked.loops.bilaterals(model, states, &group.group.bodies);
        let (rigid, yielding): (Vec<_>, Vec<_>) =
            reactions.bilaterals.iter().partition(|(of, _)| of.softness.is_none());
        let by_reactions = rigid.iter().zip(after).map(|((of, impulse), after)| of.work(&after, *impulse));
        report.books.ledger.numerical.add(-by_reactions.sum::<f64>());
        let shared_j = yielding.iter().map(|(of, impulse)| kicked.shared_by_reaction_j(of, *impulse)).sum::<f64>();
        report.books.ledger.numerical.add(-shared_j);
        let soft = group.soft_work();
        // What a spring gives is taken from its potential, which changes with the poses.
        report.books.ledger.numerical.add(-soft.spring);
        report.books.ledger.damping.add(-soft.damper);
        report.books.ledger.external.add(soft.motor);
        // In the order of the contacts, of which only some have friction.
        let mut rubbing = group.rubbing.of_contacts(reactions).peekable();
        for (&index, &impulse) in group.group.contacts.iter().zip(&reactions.normal) {
            let row = &rows[index];
            let contact = &near[row.contact];
            let own = rubbing.next_if(|(row, _)| row.id() == contact.id);
            let friction = own.map_or(DVec3::ZERO, |(_, own)| own.iter().map(TangentReaction::vector).sum());
            if impulse <= 0.0 {
                continue;
            }
            let kind = row.kind_of_impulse(contact, impulse, h);
            let geometry = row.kinematics.geometry;
            let force = geometry.normal * impulse + friction;
            let force = ContactForce { id: contact.id, point: geometry.point, force };
            report.told.take_contact(model, states, (force, false));
            report.impulses.push(ContactImpulse { t, id: contact.id, geometry, impulse, friction, kind });
            carrying.push(row.contact);
        }
    }
    carrying.sort_unstable();
    carrying
}
