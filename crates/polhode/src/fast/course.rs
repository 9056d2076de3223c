//! The course of the bodies: their states, where they touch, and one step of all of them.
//!
//! | stage | what |
//! |---|---|
//! | boxes | which pairs may touch in this step |
//! | patches | where: kept, or found anew; pairs are divided among the tasks of the executor |
//! | groups | islands of bodies that patches and joints connect |
//! | solve | each group for itself: substeps (`group.rs`) |
//! | flight | bodies that touch nothing |
//! | impulses | go back to the points of the patches |

use super::group::{FULL, Given, Group, GroupReport, PatchPlace};
use super::held::{HeldJoint, HeldLimit};
use super::passage::{LEAST_WAY, Middles};
use super::rules::{OVERLAP_GROWTH, Rules};
use super::turning::turn;
use crate::collision::contact_set;
use crate::collision::face_patches::{LastingBoxes, PairPatches, Tools, follow_pairs};
use crate::collision::inner_borders::leave_out_inner_borders;
use crate::constraint::ConstraintId;
use crate::constraint::joint::ModelJoint;
use crate::error::SimulationError;
use crate::joints::added;
use crate::model::{Model, prescribed, tolerances};
use crate::tier::executor::{Executor, Task};
use crate::tier::settings::Settings;
use polhode_dynamics::BodyState;
use polhode_response::law::MOST_ROWS;
use polhode_spatial::{DVec3, DisjointSets, Pose};
use std::sync::Arc;

/// Fewest pairs for which a task is worth its start.
const LEAST_PAIRS: usize = 64;

/// A step shorter than this part of the last one leaves the impulses that the next one starts from as they are (no
/// unit).
const LEAST_OF_LAST: f64 = 0.5;

/// What a step may not do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    /// One body of a pair comes through the other, or their overlap grows: how deep it is, m.
    Overlap { pair: (usize, usize), depth: f64 },
    /// A body leaves its box, so that pairs may be missing.
    LeftBox,
}

impl Fault {
    /// That of a pair of which one has come through the other.
    fn passage(model: &Model, pair: &PairPatches) -> Self {
        Self::Overlap { pair: (pair.a, pair.b), depth: tolerances::pair_size(model, pair.a, pair.b) }
    }

    /// The pair that overlaps, and how deep, m.
    const fn overlap(self) -> Option<((usize, usize), f64)> {
        match self {
            Self::Overlap { pair, depth } => Some((pair, depth)),
            Self::LeftBox => None,
        }
    }
}

/// States and contacts.
#[derive(Debug)]
pub(super) struct Course {
    pub(super) states: Vec<BodyState>,
    pub(super) pairs: Vec<PairPatches>,
    /// Length of a substep of the last step, s; zero before it.
    pub(super) last_h: f64,
    /// Which bodies rest, and how often in a row each of the others was slow.
    pub(super) resting: Vec<bool>,
    pub(super) quiet: Vec<u32>,
    /// Joints and pivots after the last step, ascending.
    pub(super) held: Vec<HeldJoint>,
    /// Limits that pressed in the last step, ascending.
    pub(super) limits: Vec<HeldLimit>,
    boxes: LastingBoxes,
    /// Empty between steps: memory for a new list of pairs.
    spare_pairs: Vec<PairPatches>,
    groups: Vec<Group>,
    /// How many of them the step has.
    pub(super) used: usize,
    /// Number of each body in its group.
    numbers: Vec<u32>,
    /// The pair that overlaps most at the end of the last step, by its place, and how deep, m.
    deepest_after: Option<(usize, f64)>,
    /// What the last step has done to a pair although no piece of it could be divided further.
    pub(super) fault: Option<Fault>,
    /// Of each body, and the least depth of all (m).
    middles: Vec<Middles>,
    least_middle: f64,
    /// Pairs that overlap by more than that at the end of the last step, by their places.
    deep: Vec<usize>,
    /// Bound of the speed of every point of a body relative to its origin, m/s.
    spins: Vec<f64>,
    tools: Vec<Tools>,
    /// The group of each body; none in flight or at rest.
    pub(super) group_of: Vec<Option<u32>>,
}

impl Course {
    /// Nothing known yet but the states.
    pub(super) fn new(settings: &Settings, states: Vec<BodyState>) -> Self {
        Self {
            resting: vec![false; states.len()],
            quiet: vec![0; states.len()],
            group_of: vec![None; states.len()],
            states,
            pairs: Vec::new(),
            held: Vec::new(),
            limits: Vec::new(),
            last_h: 0.0,
            boxes: LastingBoxes::new(settings.broad_phase),
            spare_pairs: Vec::new(),
            groups: Vec::new(),
            used: 0,
            numbers: Vec::new(),
            deepest_after: None,
            fault: None,
            middles: Vec::new(),
            least_middle: 0.0,
            deep: Vec::new(),
            spins: Vec::new(),
            tools: Vec::new(),
        }
    }

    /// A copy for a shorter step, without buffers.
    pub(super) fn copy(&self, settings: &Settings) -> Self {
        Self {
            pairs: self.pairs.clone(),
            held: self.held.clone(),
            limits: self.limits.clone(),
            last_h: self.last_h,
            resting: self.resting.clone(),
            quiet: self.quiet.clone(),
            group_of: self.group_of.clone(),
            middles: self.middles.clone(),
            least_middle: self.least_middle,
            ..Self::new(settings, self.states.clone())
        }
    }

    /// The groups of the last step.
    pub(super) fn groups(&self) -> &[Group] {
        &self.groups[..self.used]
    }

    /// Takes up a body that has been added.
    pub(super) fn add_body(&mut self, state: BodyState) {
        self.states.push(state);
        self.resting.push(false);
        self.quiet.push(0);
        self.group_of.push(None);
        self.middles.clear();
    }

    /// Drops a body.
    pub(super) fn remove_body(&mut self, body: usize) {
        self.boxes.forget(body);
        self.pairs.retain(|pair| pair.a != body && pair.b != body);
        self.limits.retain(|limit| limit.id.a != body && limit.id.b != body);
        self.resting[body] = false;
        self.group_of[body] = None;
    }

    /// Drops contacts and loads that are there no more, after a joint between two bodies was added or taken away.
    pub(super) fn change_joint(&mut self, model: &Model, pair: (usize, usize)) {
        self.pairs.retain(|own| (own.a, own.b) != pair || added::may_touch(model, pair));
        self.limits.retain(|limit| added::may_have(model, limit.id));
        self.held.retain(|held| match held.id {
            ConstraintId::Joint { joint, .. } => model.joints.pair_of_joint(joint).is_some(),
            _ => true,
        });
    }

    /// Whether nothing moves.
    pub(super) fn is_all_at_rest(&self, model: &Model) -> bool {
        model.prescribed.is_empty()
            && model.movable.iter().all(|&body| self.resting[body] || !model.bodies[body].moves())
    }

    /// Wakes all bodies.
    pub(super) fn wake_all(&mut self) {
        self.resting.fill(false);
        self.quiet.fill(0);
    }

    /// The pairs that may touch in the step.
    pub(super) fn find_pairs(&mut self, model: &Model, rules: &Rules) -> Result<(), SimulationError> {
        let step = rules.h * f64::from(rules.substeps);
        let fall = model.gravity().length() * step * step;
        self.spins.clear();
        let mut travels = Vec::with_capacity(self.states.len());
        for (body, state) in self.states.iter().enumerate() {
            let is_still =
                self.resting[body] || (!model.bodies[body].moves() && prescribed::trajectory(model, body).is_none());
            if is_still {
                self.spins.push(0.0);
                travels.push(0.0);
                continue;
            }
            let velocity = model.velocity(body, state);
            let spin = velocity.angular.length() * model.bodies[body].size;
            self.spins.push(spin);
            travels.push((velocity.linear.length() + spin) * step + fall);
        }
        let found = self.boxes.renew(model, &self.states, |body| travels[body]);
        if found.map_err(SimulationError::BroadPhase)? {
            follow_pairs(model, (&mut self.pairs, &mut self.spare_pairs), &self.boxes.pairs);
        }
        Ok(())
    }

    /// Brings the patches of all pairs to the present poses.
    pub(super) fn find_patches(&mut self, model: &Model, executor: &dyn Executor, rules: &Rules) {
        let step = rules.h * f64::from(rules.substeps);
        let fall = model.gravity().length() * step * step;
        let width = executor.width().get().min(self.pairs.len() / LEAST_PAIRS + 1);
        self.tools.resize_with(width.max(self.tools.len()), Tools::default);
        let share = self.pairs.len().div_ceil(width).max(1);
        let (states, spins, resting) = (&self.states, &self.spins, &self.resting);
        let still: Vec<bool> = (0..states.len()).map(|body| resting[body] || !model.bodies[body].moves()).collect();
        let nothing_is_driven = model.prescribed.is_empty();
        let renew = |pair: &mut PairPatches, tools: &mut Tools| {
            if still[pair.a] && still[pair.b] && nothing_is_driven {
                return;
            }
            let [a, b] = [pair.a, pair.b].map(|body| states[body].linear_velocity);
            let travel = ((a - b).length() + spins[pair.a] + spins[pair.b]) * step + fall;
            pair.renew(model, states, travel, tools);
        };
        if width == 1 {
            let tools = &mut self.tools[0];
            self.pairs.iter_mut().for_each(|pair| renew(pair, tools));
        } else {
            let renew = &renew;
            let tasks = self.pairs.chunks_mut(share).zip(&mut self.tools).map(|(pairs, tools)| {
                Box::new(move || pairs.iter_mut().for_each(|pair| renew(pair, tools))) as Task<'_>
            });
            executor.run(tasks.collect());
        }
        leave_out_inner_borders(model, &self.states, &mut self.pairs);
    }

    /// Puts bodies that patches and joints connect into groups, islands in the order of their first bodies. Force
    /// fields may couple any bodies: with them there is one group.
    pub(super) fn make_groups(&mut self, model: &Model, rules: &Rules) {
        let bodies = self.states.len();
        let moved: Vec<bool> = (0..bodies).map(|body| model.bodies[body].moves() && !self.resting[body]).collect();
        let is_moved = |body: usize| moved[body];
        let mut sets = DisjointSets::new(bodies);
        // The patches and joints of each island, at its smallest body.
        let mut work = vec![0_u32; bodies];
        let together = rules.has_fields;
        for pair in self.pairs.iter().filter(|pair| !pair.patches.is_empty()) {
            if is_moved(pair.a) && is_moved(pair.b) {
                sets.join(pair.a, pair.b);
            }
        }
        for (a, b) in model.joints.list.iter().map(ModelJoint::pair) {
            if is_moved(a) && is_moved(b) {
                sets.join(a, b);
            }
        }
        let of_pairs = self.pairs.iter().map(|pair| ((pair.a, pair.b), pair.patches.len()));
        let of_joints = model.joints.list.iter().map(|joint| (joint.pair(), 1));
        for ((a, b), count) in of_pairs.chain(of_joints).filter(|(_, count)| *count > 0) {
            let Some(own) = [a, b].into_iter().find(|&body| is_moved(body)) else { continue };
            work[sets.smallest(own)] += count as u32;
        }
        // The group of each island, at its smallest body.
        let mut group_of_island: Vec<Option<u32>> = vec![None; bodies];
        (self.used, self.numbers) = (0, vec![0; bodies]);
        let mut load = FULL;
        for body in 0..bodies {
            self.group_of[body] = None;
            if !is_moved(body) {
                continue;
            }
            let island = sets.smallest(body);
            if work[island] == 0 && !(rules.has_loads && model.is_loaded(body)) {
                continue;
            }
            let group = *group_of_island[island].get_or_insert_with(|| {
                if load >= FULL && (self.used == 0 || !together) {
                    self.used += 1;
                    load = 0;
                    self.groups.resize_with(self.used.max(self.groups.len()), Group::default);
                    self.groups[self.used - 1].clear();
                }
                load += work[island] as usize;
                self.used as u32 - 1
            });
            self.group_of[body] = Some(group);
            let own = &mut self.groups[group as usize].bodies;
            own.push(body);
            self.numbers[body] = own.len() as u32;
        }
        for (place, pair) in self.pairs.iter().enumerate() {
            if let Some(group) = [pair.a, pair.b].into_iter().find_map(|body| self.group_of[body]) {
                let own = &mut self.groups[group as usize].patches;
                own.extend((0..pair.patches.len()).map(|patch| PatchPlace { pair: place, patch }));
            }
        }
    }

    /// How many patches the groups of the step have.
    pub(super) fn patches(&self) -> usize {
        self.groups[..self.used].iter().map(|group| group.patches.len()).sum()
    }

    /// How many joints were solved in the step, each as often as it was.
    pub(super) fn joints_solved(&self) -> usize {
        self.groups[..self.used].iter().map(Group::joints_solved).sum()
    }

    /// The step of each group for itself.
    pub(super) fn solve(&mut self, model: &Model, executor: &dyn Executor, (t, rules): (f64, &Rules)) {
        let warm = if self.last_h > 0.0 { rules.h / self.last_h } else { 0.0 };
        let (states, pairs, numbers) = (&self.states, &self.pairs, &self.numbers);
        let held = (&self.held[..], &self.limits[..]);
        let given = Given { model, states, pairs, numbers, held, t, warm, rules };
        let groups = &mut self.groups[..self.used];
        if groups.len() == 1 || executor.width().get() == 1 {
            for group in groups {
                group.step(&given);
            }
        } else {
            let given = &given;
            executor.run(groups.iter_mut().map(|group| Box::new(move || group.step(given)) as Task<'_>).collect());
        }
        for group in &self.groups[..self.used] {
            for (body, state) in group.states() {
                self.states[body] = *state;
                model.keep_in_plane(body, &mut self.states[body]);
            }
        }
    }

    /// Bodies that touch nothing, under gravity alone: a parabola, and free rotation.
    pub(super) fn fly(&mut self, model: &Model, rules: &Rules) {
        let step = rules.h * f64::from(rules.substeps);
        for &body in &model.movable {
            if self.group_of[body].is_some() || self.resting[body] || !model.bodies[body].moves() {
                continue;
            }
            let Some(rigid) = &model.bodies[body].rigid else { continue };
            let state = &mut self.states[body];
            let gain = model.free_acceleration(body) * step;
            let translation = state.pose.translation + (state.linear_velocity + gain * 0.5) * step;
            state.linear_velocity += gain;
            let momentum = state.angular_momentum;
            let (mut rotation, mut angular) = (state.pose.rotation, rigid.angular_velocity(state));
            if angular != DVec3::ZERO {
                for _ in 0..rules.substeps {
                    let turned = turn(rigid, rotation, (momentum, angular), rules.h);
                    (rotation, angular) = (turned.rotation, turned.angular);
                }
            }
            state.pose = Pose::new(rotation, translation);
            model.keep_in_plane(body, state);
        }
    }

    /// What a step from these states on has done that it may not: the pair that has come through each other, or whose
    /// overlap has grown by more than a part of the smaller one, deepest. Bodies are looked at that came elsewhere than
    /// at their velocities and under gravity, and those that have come farther than a middle is deep.
    pub(super) fn fault_since(&mut self, model: &Model, before: &[BodyState], rules: &Rules) -> Option<Fault> {
        if self.middles.len() != model.bodies.len() {
            self.middles = model.bodies.iter().map(|body| Middles::of(body.shape.as_ref())).collect();
            self.least_middle = self.middles.iter().map(Middles::least_depth).fold(f64::INFINITY, f64::min);
        }
        let changes: Vec<Moved> =
            before.iter().zip(&self.states).map(|(start, end)| Moved::between(start, end)).collect();
        let passed = self.passage_since(model, before, &changes);
        // Pieces of a substep are for what passes: overlaps that grow in a pile are those of the substeps.
        passed.or_else(|| (rules.substeps > 1).then(|| self.growth_since(model, before, (rules, &changes))).flatten())
    }

    /// A pair of which one has come through the surface of the other since these states.
    fn passage_since(&self, model: &Model, before: &[BodyState], changes: &[Moved]) -> Option<Fault> {
        let moved = |body: usize| changes[body].way + changes[body].turned * model.bodies[body].size;
        let farthest = (0..changes.len()).map(moved).fold(0.0, f64::max);
        // Two bodies that move towards each other.
        if farthest + farthest <= LEAST_WAY * self.least_middle {
            return None;
        }
        let has_passed = |body: usize, other: usize| {
            let middles = &self.middles[body];
            moved(body) + moved(other) > LEAST_WAY * middles.least_depth()
                && middles.have_passed(model, [before, &self.states], (body, other))
        };
        let found = self.pairs.iter().find(|pair| has_passed(pair.a, pair.b) || has_passed(pair.b, pair.a))?;
        Some(Fault::passage(model, found))
    }

    /// A pair of which one is behind the surface of the other at the end of the last step.
    pub(super) fn inside_now(&self, model: &Model) -> Option<Fault> {
        let is_inside = |body: usize, other: usize| self.middles[body].are_inside(model, &self.states, (body, other));
        let mut deep = self.deep.iter().map(|&place| &self.pairs[place]);
        let found = deep.find(|pair| is_inside(pair.a, pair.b) || is_inside(pair.b, pair.a))?;
        Some(Fault::passage(model, found))
    }

    /// A pair whose overlap has grown by more than a part of the smaller body since these states, or a body that has
    /// left its box, with which pairs may be missing.
    fn growth_since(&self, model: &Model, before: &[BodyState], (rules, changes): (&Rules, &[Moved])) -> Option<Fault> {
        let step = rules.h * f64::from(rules.substeps);
        let fall = model.gravity().length() * step * step;
        let mut aside = vec![0.0; before.len()];
        let mut is_any = false;
        for &body in model.movable.iter().filter(|&&body| self.group_of[body].is_some()) {
            let (start, end, size) = (&before[body], &self.states[body], model.bodies[body].size);
            let changed = (end.linear_velocity - start.linear_velocity).length() * step - fall;
            // A hit makes it turn, or turned it has; or it flies on.
            aside[body] = changed.max(0.0) + changes[body].turned * size;
            is_any |= aside[body] > OVERLAP_GROWTH * size;
        }
        if !is_any {
            return None;
        }
        let has_sunk = |pair: &PairPatches| {
            let (a, b) = (pair.a, pair.b);
            let least = OVERLAP_GROWTH * tolerances::pair_size(model, a, b);
            if aside[a] + aside[b] <= least {
                return None;
            }
            let now = contact_set::separation_without_memory(model, &self.states, a, b).filter(|now| *now < -least)?;
            let then = contact_set::separation_without_memory(model, before, a, b);
            then.is_none_or(|then| now < then.min(0.0) - least).then_some(((a, b), -now))
        };
        let deepest = self.pairs.iter().filter_map(has_sunk).max_by(|x, y| x.1.total_cmp(&y.1));
        let left = || {
            let far = |body: usize| aside[body] > OVERLAP_GROWTH * model.bodies[body].size;
            self.boxes.has_left(model, &self.states, far).then_some(Fault::LeftBox)
        };
        deepest.map(|(pair, depth)| Fault::Overlap { pair, depth }).or_else(left)
    }

    /// The impulses of the step go to the points of the patches. Those of a step that a program has cut short do not:
    /// they are those of overlaps and rounding, and say nothing about the next step.
    pub(super) fn write_back(&mut self, rules: &Rules) {
        let is_whole = rules.h >= LEAST_OF_LAST * self.last_h;
        if is_whole {
            self.last_h = rules.h;
        }
        let inverse_step = 1.0 / (rules.h * f64::from(rules.substeps));
        let after = self.groups[..self.used].iter().flat_map(|group| group.held.after(inverse_step));
        let resting = self.held.iter().copied().filter(|held| self.resting[held.body]);
        let mut after: Vec<HeldJoint> = after.chain(resting).collect();
        after.sort_by_key(|held| held.id);
        if !is_whole {
            for own in &mut after {
                let known = self.held.binary_search_by_key(&own.id, |held| held.id);
                own.multipliers = known.map_or([0.0; MOST_ROWS], |place| self.held[place].multipliers);
            }
        }
        self.held = after;
        if is_whole {
            let after = self.groups[..self.used].iter().flat_map(|group| group.held.limits_after());
            let resting = self.limits.iter().copied().filter(|limit| self.resting[limit.id.a]);
            let mut after: Vec<HeldLimit> = after.chain(resting).collect();
            after.sort_by_key(|limit| limit.id);
            self.limits = after;
        }
        self.deepest_after = None;
        self.deep.clear();
        for group in &self.groups[..self.used] {
            for (number, (place, manifold)) in group.patches.iter().zip(group.solver.manifolds()).enumerate() {
                let [n, x] = [manifold.normal, manifold.tangent];
                let y = n.cross(x);
                let pair = &mut self.pairs[place.pair];
                let patch = &mut pair.patches[place.patch];
                for (point, impulse) in patch.points_mut().iter_mut().zip(group.solver.impulses(number)) {
                    if is_whole {
                        // The impulse of a blow is over: given again it would leave what the sweeps of a substep do not
                        // take back. What bore before, and gives way softly, goes on.
                        let is_new = point.normal_impulse == 0.0;
                        let is_struck = is_new && impulse.rate < -rules.soft.colliding && impulse.total[0] > 0.0;
                        let [along, first, second] = if is_struck { [0.0; 3] } else { impulse.last };
                        point.normal_impulse = along;
                        point.friction_impulse = x * first + y * second;
                    }
                    if -impulse.separation > self.deepest_after.map_or(0.0, |(_, depth)| depth) {
                        self.deepest_after = Some((place.pair, -impulse.separation));
                    }
                    if -impulse.separation > self.least_middle && self.deep.last() != Some(&place.pair) {
                        self.deep.push(place.pair);
                    }
                    point.normal_force = impulse.total[0] * inverse_step;
                    point.friction_force = (x * impulse.total[1] + y * impulse.total[2]) * inverse_step;
                }
                // The patches of a pair come one after the other, the first one first.
                pair.presses = (pair.presses && place.patch > 0) || patch.presses();
            }
        }
    }

    /// The deepest overlap of the last step, m, with its pair: where contacts were found at its start, and where they
    /// are at its end. The second sees what has passed through a
    /// thin body, too.
    pub(super) fn deepest(&self) -> Option<((usize, usize), f64)> {
        let all = self.groups().iter().filter_map(|group| group.report.deepest).chain(self.deepest_after);
        let deepest = all.fold(None, |worst: Option<(usize, f64)>, one| match worst {
            Some(known) if known.1 >= one.1 => Some(known),
            _ => Some(one),
        });
        let of_patches = deepest.map(|(pair, depth)| ((self.pairs[pair].a, self.pairs[pair].b), depth));
        match (of_patches, self.fault.and_then(Fault::overlap)) {
            (Some(known), Some(fault)) if known.1 >= fault.1 => Some(known),
            (known, None) => known,
            (_, fault) => fault,
        }
    }

    /// What the groups did.
    pub(super) fn reports(&self) -> impl Iterator<Item = &GroupReport> {
        self.groups().iter().map(|group| &group.report)
    }
}

/// How a body has moved between two states.
#[derive(Debug, Clone, Copy)]
struct Moved {
    /// m.
    way: f64,
    /// How far a point at unit distance has come by turning, at most.
    turned: f64,
}

impl Moved {
    fn between(start: &BodyState, end: &BodyState) -> Self {
        let [q, r] = [start, end].map(|state| state.pose.rotation.quaternion());
        let cosine = q.dot(r);
        Self {
            way: (end.pose.translation - start.pose.translation).length(),
            turned: 2.0 * (1.0 - cosine * cosine).max(0.0).sqrt(),
        }
    }
}

/// For the states of a copy that nobody else has.
impl From<Course> for Arc<Vec<BodyState>> {
    fn from(course: Course) -> Self {
        Self::new(course.states)
    }
}
