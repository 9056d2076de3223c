//! A run in real time: steps, what is booked of them, and queries at the present.

use super::course::Course;
use super::held::{HeldJoint, HeldLimit};
use super::impacts::impacts;
use super::rest::settle;
use super::rules::Rules;
use super::step::step;
use crate::accounting::Accounts;
use crate::accounting::books::{Received, SoftStep};
use crate::accounting::measures::Measure;
use crate::collision::face_patches::{FoundAt, PairPatches, Patch, PatchPoint};
use crate::collision::touch::{FoundContact, Touch};
use crate::collision::{contact_kinematics, contact_view};
use crate::constraint::ConstraintId;
use crate::constraint::joint::ModelJoint;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::{ContactId, Feature};
use crate::identity::joint_id::JointId;
use crate::joints::{added, joint_contacts, turns};
use crate::model::{Model, prescribed, reported, tolerances};
use crate::report::acceleration::Acceleration;
use crate::report::event::{Event, EventKind};
use crate::report::frame::{ContactView, IslandView, JointView, MotionKind};
use crate::report::joint_efforts::EffortsAlong;
use crate::report::momentum_ledger::{Momentum, MomentumSum};
use crate::report::observer::Observer;
use crate::snapshot::numbers::{Contact, read_states, write_states};
use crate::snapshot::parts::{restored_id, save_contact};
use crate::snapshot::{SnapshotError, content};
use crate::tier::core::Core;
use crate::tier::free_stage::{self, Ends};
use crate::tier::sampling::emit_samples_before;
use crate::tier::{Reached, Tier};
use polhode_contact::ContactKinematics;
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, DisjointSets, Pose, Rotation};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Times that differ by less than this part of a step are the same (no unit): some rounding of times of a long run.
const SAME_TIME: f64 = 1e-6;

/// A run in progress.
#[derive(Debug)]
pub(crate) struct FastEngine {
    course: Course,
    /// Pairs that pressed on each other in the last step, ascending.
    touching: Vec<(usize, usize)>,
    /// Index of the last step that ended on the grid of multiples of the step, and whether any step has been made.
    grid: u64,
    begun: bool,
}

impl FastEngine {
    /// Prepares a run.
    pub(crate) fn new(core: &Core, states: Vec<BodyState>) -> Self {
        let course = Course::new(&core.settings, states);
        Self { course, touching: Vec::new(), grid: 0, begun: false }
    }

    /// The engine of a snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene.
    pub(crate) fn restored(core: &Core, saved: &content::Fast) -> Result<Self, SnapshotError> {
        let bodies = core.model.bodies.len();
        let mut course = Course::new(&core.settings, read_states(&saved.states, bodies)?);
        course.pairs = saved.pairs.iter().map(|pair| restored_pair(core, pair)).collect::<Result<_, _>>()?;
        if !course.pairs.is_sorted_by_key(|pair| (pair.a, pair.b))
            || [saved.resting.len(), saved.quiet.len()] != [bodies; 2]
        {
            return Err(SnapshotError::Invalid("its pairs are not in order"));
        }
        course.held = saved.held.iter().map(|held| restored_held(core, held)).collect::<Result<_, _>>()?;
        if !course.held.is_sorted_by_key(|held| held.id) {
            return Err(SnapshotError::Invalid("its joints are not in order"));
        }
        course.limits = saved.limits.iter().map(|limit| restored_limit(core, limit)).collect::<Result<_, _>>()?;
        if !course.limits.is_sorted_by_key(|limit| limit.id) {
            return Err(SnapshotError::Invalid("its limits of joints are not in order"));
        }
        course.last_h = saved.last_h;
        course.resting.clone_from(&saved.resting);
        course.quiet.clone_from(&saved.quiet);
        Ok(Self { course, touching: saved.touching.clone(), grid: saved.grid, begun: saved.begun })
    }

    fn rules(core: &Core, step_s: f64) -> Rules {
        let settings = &core.settings;
        let rules = Rules::new(step_s, settings.step_s, settings.substeps, &core.model);
        rules.by(settings.contact).after(core.accounts.steps())
    }

    /// One step to `t_next`.
    fn step(&mut self, core: &mut Core, t_next: f64, observer: &mut dyn Observer) -> Result<(), SimulationError> {
        let h = t_next - core.t;
        emit_samples_before(t_next, self, core, observer, |engine, core, t| engine.states_within(core, t).map(Some))?;
        let rules = Self::rules(core, h);
        let executor = Arc::clone(&core.executor);
        let Core { model, accounts, .. } = core;
        let mut overlaps = Vec::new();
        step(&mut self.course, model, &*executor, (core.t, &rules), |course, times, before, rules| {
            book(course, (model, accounts), before, times, rules.h);
            overlaps.extend(course.deepest().map(|(pair, depth)| (times[1], pair, depth)));
            for event in impacts(course, model, before, (times[1], rules)) {
                accounts.add_event(event);
            }
        })?;
        for (t, pair, value) in overlaps {
            let allowed = core.penetration_allowed(t, &self.course.states, pair, 0.0);
            core.accounts.measures.penetration.note(Measure { t, pair, value, allowed });
        }
        core.t = t_next;
        turns::count_all_turns(&mut core.model, &self.course.states)?;
        core.accounts.count_step();
        settle(&mut self.course, core, &rules)?;
        self.report_pairs(core);
        core.accounts.emit_events(core.t, observer);
        core.accounts.observe(&core.model, &self.course.states, core.t)?;
        Ok(())
    }

    /// States at `t` (s) within the coming step: those after a shorter one.
    fn states_within(&self, core: &Core, t: f64) -> Result<Arc<Vec<BodyState>>, SimulationError> {
        if t <= core.t {
            return Ok(Arc::new(self.course.states.clone()));
        }
        let mut course = self.course.copy(&core.settings);
        step(&mut course, &core.model, &*core.executor, (core.t, &Self::rules(core, t - core.t)), |_, _, _, _| {})?;
        Ok(course.into())
    }

    /// Adds an event for every pair that has begun or ceased to press on each other.
    fn report_pairs(&mut self, core: &mut Core) {
        let now = self.course.pairs.iter().filter(|pair| pair.presses).map(|pair| (pair.a, pair.b));
        if now.clone().eq(self.touching.iter().copied()) {
            self.begun = true;
            return;
        }
        let now = now.collect();
        let before = std::mem::replace(&mut self.touching, now);
        if !std::mem::replace(&mut self.begun, true) {
            return;
        }
        let without = |from: &[(usize, usize)], others: &[(usize, usize)]| -> Vec<(usize, usize)> {
            from.iter().copied().filter(|pair| others.binary_search(pair).is_err()).collect()
        };
        let ended = without(&before, &self.touching).into_iter().map(|pair| (EventKind::ContactEnd, pair));
        let begun = without(&self.touching, &before).into_iter().map(|pair| (EventKind::ContactBegin, pair));
        for (kind, (a, b)) in ended.chain(begun).collect::<Vec<_>>() {
            let (point, normal) = self.place_of(a, b);
            core.accounts.add_event(Event {
                t_s: core.t,
                kind,
                body_a: BodyId::new(a),
                body_b: Some(BodyId::new(b)),
                point,
                normal,
                impulse: 0.0,
                energy_change_j: 0.0,
            });
        }
    }

    /// Where two bodies touch; the first one's centre where they do not any more.
    fn place_of(&self, a: usize, b: usize) -> (DVec3, DVec3) {
        let states = &self.course.states;
        let place = self.course.pairs.binary_search_by_key(&(a, b), |pair| (pair.a, pair.b));
        let found = place.ok().and_then(|place| {
            let pair = &self.course.pairs[place];
            Some((pair, pair.patches.first()?))
        });
        found.map_or((states[a].pose.translation, DVec3::ZERO), |(pair, patch)| {
            let normal = pair.normal(states, patch);
            (states[a].pose.transform_point(patch.points()[0].on_a), normal)
        })
    }
}

/// Books a step that began with these states.
fn book(
    course: &Course,
    (model, accounts): (&Model, &mut Accounts),
    before: &[BodyState],
    times: [f64; 2],
    substep_s: f64,
) {
    let about = accounts.books.ledger.momentum.about;
    let moving: Vec<usize> = model.movable.iter().copied().filter(|&body| !course.resting[body]).collect();
    let balances = [before, &course.states].map(|states| accounts.books.balance(model, states, &moving));
    let ends = Ends { t: times, states: [before, &course.states] };
    let mut received = free_stage::received(model, ends, &moving, about);
    let mut soft = SoftStep::default();
    let mut residual = 0.0_f64;
    let smallest = model.gravity().length() * substep_s;
    for report in course.reports() {
        let works = report.works;
        soft.impact_j -= works.colliding_j;
        soft.projection_j -= works.resting_j;
        soft.friction_j -= works.friction_j;
        soft.given_j += report.given_j;
        let speed = report.residual.speed.max(smallest);
        if report.residual.map > 0.0 {
            residual = residual.max(report.residual.map / speed);
        }
    }
    let of_fields = received.external_j;
    support((course, model), before, about, (&mut received, times[1] - times[0]));
    soft.driven_j = received.external_j - of_fields;
    let resting = model.movable.iter().copied().filter(|&body| course.resting[body] && model.bodies[body].moves());
    let weight = accounts.books.weight_of(model, before, resting);
    accounts.note_residual(times[1], residual);
    accounts.books.soft_step(balances, received, soft);
    accounts.books.borne(weight, times[1] - times[0]);
}

/// Momentum from fixed and kinematic bodies over a step of `h` (s), and the work of the latter.
fn support(
    (course, model): (&Course, &Model),
    states: &[BodyState],
    about: DVec3,
    (received, h): (&mut Received, f64),
) {
    let carries: Vec<bool> = (0..states.len()).map(|body| model.carries_momentum(body)).collect();
    let mut sum = MomentumSum::default();
    for report in course.reports() {
        received.external_j += report.driven_j;
        let Momentum { linear, angular } = report.support;
        sum.add(Momentum { linear, angular: angular - about.cross(linear) });
    }
    for pair in &course.pairs {
        let carries = [carries[pair.a], carries[pair.b]];
        if pair.patches.is_empty()
            || carries == [true, true]
            || [pair.a, pair.b].iter().any(|&body| course.resting[body])
        {
            continue;
        }
        let sign = f64::from(carries[0]) - f64::from(carries[1]);
        for (point, patch) in pair.patches.iter().flat_map(|patch| patch.points().iter().map(move |p| (p, patch))) {
            let normal = pair.normal(states, patch);
            let on_a = (normal * point.normal_force + point.friction_force) * h;
            if on_a == DVec3::ZERO {
                continue;
            }
            let [x, y] =
                [(pair.a, point.on_a), (pair.b, point.on_b)].map(|(body, at)| states[body].pose.transform_point(at));
            let place = x + (y - x) * pair.acting_part(model, normal.dot(x - y));
            let linear = on_a * sign;
            sum.add(Momentum { linear, angular: (place - about).cross(linear) });
        }
    }
    received.support = sum.value();
}

impl Tier for FastEngine {
    fn advance(
        &mut self,
        core: &mut Core,
        limit_s: f64,
        observer: &mut dyn Observer,
    ) -> Result<Reached, SimulationError> {
        let step = core.settings.step_s;
        while self.grid as f64 * step <= core.t + SAME_TIME * step {
            self.grid += 1;
        }
        let next = self.grid as f64 * step;
        // A limit that differs from the end of a step by rounding is that end.
        let t_next = if next >= limit_s - SAME_TIME * step { limit_s } else { next };
        if t_next > core.t {
            self.step(core, t_next, observer)?;
        }
        Ok(if core.t >= limit_s { Reached::Limit } else { Reached::StepEnd })
    }

    fn stride(&self, core: &Core) -> f64 {
        // The step ends at the next multiple of its length at the latest; a rounding may lie between.
        2.0 * core.settings.step_s
    }

    fn states(&self, _core: &Core) -> Vec<BodyState> {
        self.course.states.clone()
    }

    fn state(&self, _core: &Core, body: usize) -> BodyState {
        self.course.states[body]
    }

    fn accelerations(&mut self, core: &mut Core) -> Result<Vec<Acceleration>, SimulationError> {
        // By the method of the tier: the mean over the coming step.
        let h = core.settings.step_s;
        let ends = self.states_within(core, core.t + h)?;
        let model = &core.model;
        let of = |(body, (start, end)): (usize, (&BodyState, &BodyState))| {
            if prescribed::trajectory(model, body).is_some() {
                let (linear, angular) = prescribed::prescribed_acceleration(model, body, core.t);
                return reported::reported_acceleration(model, body, start, linear, angular);
            }
            let [v0, v1] = [start, end].map(|state| model.velocity(body, state));
            let (linear, angular) = ((v1.linear - v0.linear) / h, (v1.angular - v0.angular) / h);
            reported::reported_acceleration(model, body, start, linear, angular)
        };
        Ok(self.course.states.iter().zip(ends.iter()).enumerate().map(of).collect())
    }

    fn contacts(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<ContactView> {
        let mut views = Vec::new();
        for pair in &self.course.pairs {
            let distance = tolerances::touch_distance(&core.model, states, pair.a, pair.b);
            for patch in &pair.patches {
                for point in patch.points() {
                    let id = ContactId { a: pair.a, b: pair.b, feature: Feature::Shapes(point.feature) };
                    let geometry = pair.geometry(states, patch, point);
                    if point.normal_force > 0.0 || geometry.separation <= distance {
                        let kinematics = ContactKinematics { geometry, separation_rate: 0.0, acceleration_bias: 0.0 };
                        let touch = Touch::from(FoundContact { id, kinematics });
                        contact_view::view_contact(
                            &core.model,
                            states,
                            &touch,
                            (point.normal_force, point.friction_force),
                            &mut views,
                        );
                    }
                }
            }
        }
        views
    }

    fn joint_loads(&self, core: &Core, _t: f64, states: &[BodyState]) -> Vec<JointView> {
        let model = &core.model;
        let view = |held: &HeldJoint| {
            let ConstraintId::Joint { joint, bodies } = held.id else { return None };
            let own = model.joints.list.iter().find(|own| own.number() == joint)?;
            let point_m = joint_contacts::anchor_of(model, states, own);
            let moment = held.moment - (point_m - states[held.body].pose.translation).cross(held.force);
            // Of a joint of the world with its second body the first end is the world.
            let sign = if core.model.scene.joints().get(joint)?.body().index() == held.body { 1.0 } else { -1.0 };
            debug_assert!(bodies.0 == held.body || bodies.1 == held.body);
            Some(JointView {
                joint: JointId::new(joint),
                point_m,
                force_n: held.force * sign,
                moment_n_m: moment * sign,
                // Only limits act along coordinates here, and what they give is not kept.
                along: if own.stops() > 0 { EffortsAlong::UNKNOWN_LIMITS } else { EffortsAlong::default() },
            })
        };
        self.course.held.iter().filter_map(view).collect()
    }

    fn motions(&self, core: &Core) -> Vec<MotionKind> {
        let kind = |body: usize| match self.course.group_of[body] {
            _ if !core.model.bodies[body].moves() => MotionKind::Given,
            _ if self.course.resting[body] => MotionKind::Rest,
            _ => MotionKind::Integrated,
        };
        (0..self.course.states.len()).map(kind).collect()
    }

    fn islands(&self, core: &Core) -> Vec<IslandView> {
        // Bodies that may touch within a step, or that joints connect; those that rest too.
        let (model, bodies) = (&core.model, self.course.states.len());
        let moves = |body: usize| model.bodies[body].moves();
        let mut sets = DisjointSets::new(bodies);
        let mut is_in_one = vec![false; bodies];
        let pairs = self.course.pairs.iter().filter(|pair| !pair.patches.is_empty()).map(|pair| (pair.a, pair.b));
        let joints = model.joints.list.iter().map(ModelJoint::pair);
        for (a, b) in pairs.chain(joints) {
            (is_in_one[a], is_in_one[b]) = (is_in_one[a] | moves(a), is_in_one[b] | moves(b));
            if moves(a) && moves(b) {
                sets.join(a, b);
            }
        }
        let mut islands: BTreeMap<usize, Vec<BodyId>> = BTreeMap::new();
        for body in (0..bodies).filter(|&body| is_in_one[body]) {
            islands.entry(sets.smallest(body)).or_default().push(BodyId::new(body));
        }
        islands.into_values().map(|bodies| IslandView { bodies }).collect()
    }

    fn interrupt(&mut self, _core: &mut Core, _bodies: &[usize]) -> Result<(), SimulationError> {
        // All states are those of the present between two steps.
        self.course.wake_all();
        Ok(())
    }

    fn states_mut(&mut self) -> &mut [BodyState] {
        &mut self.course.states
    }

    fn add_body(&mut self, _core: &Core, state: BodyState) {
        self.course.add_body(state);
    }

    fn remove_body(&mut self, body: usize) {
        self.course.remove_body(body);
        self.course.wake_all();
        self.touching.retain(|&(a, b)| a != body && b != body);
        self.course.held.retain(|held| ![held.id.bodies().0, held.id.bodies().1].contains(&body));
    }

    fn change_joint(&mut self, core: &mut Core, pair: (usize, usize)) {
        self.course.change_joint(&core.model, pair);
        self.course.wake_all();
        self.touching.retain(|&own| own != pair || added::may_touch(&core.model, own));
    }

    fn touching_pairs(&self) -> usize {
        self.touching.len()
    }

    fn save(&self) -> content::Tier {
        content::Tier::Fast(content::Fast {
            states: write_states(&self.course.states),
            pairs: self.course.pairs.iter().filter(|pair| pair.found_at().is_some()).map(save_pair).collect(),
            last_h: self.course.last_h,
            resting: self.course.resting.clone(),
            quiet: self.course.quiet.clone(),
            touching: self.touching.clone(),
            held: self.course.held.iter().map(save_held).collect(),
            limits: self.course.limits.iter().map(|limit| (save_contact(limit.id), limit.multiplier)).collect(),
            grid: self.grid,
            begun: self.begun,
        })
    }
}

fn save_held(held: &HeldJoint) -> content::HeldJoint {
    let (kind, number) = match held.id {
        ConstraintId::Joint { joint, .. } => (content::HeldKind::Joint, joint),
        _ => (content::HeldKind::Pivot, held.body),
    };
    let load = [held.force.to_array(), held.moment.to_array()];
    content::HeldJoint { kind, number, body: held.body, multipliers: held.multipliers, load }
}

fn restored_held(core: &Core, saved: &content::HeldJoint) -> Result<HeldJoint, SnapshotError> {
    let invalid = || SnapshotError::Invalid("it has a joint that the scene has not");
    let model = &core.model;
    let id = match saved.kind {
        content::HeldKind::Pivot => ConstraintId::Pivot { body: saved.number },
        content::HeldKind::Joint => {
            let joint = model.joints.list.iter().find(|own| own.number() == saved.number).ok_or_else(invalid)?;
            let mut held = joint.bodies();
            let first = held.next().ok_or_else(invalid)?;
            ConstraintId::Joint { joint: saved.number, bodies: (first, held.next().unwrap_or(first)) }
        }
    };
    if saved.body >= model.bodies.len() {
        return Err(invalid());
    }
    let [force, moment] = saved.load.map(DVec3::from_array);
    Ok(HeldJoint { id, multipliers: saved.multipliers, body: saved.body, force, moment })
}

fn restored_limit(core: &Core, (id, multiplier): &(Contact, f64)) -> Result<HeldLimit, SnapshotError> {
    Ok(HeldLimit { id: restored_id(&core.model, id)?, multiplier: *multiplier })
}

fn save_pair(pair: &PairPatches) -> content::PairPatches {
    let contact = |point: &PatchPoint| ContactId { a: pair.a, b: pair.b, feature: Feature::Shapes(point.feature) };
    let point = |point: &PatchPoint| content::PatchPoint {
        id: save_contact(contact(point)),
        on: [point.on_a.to_array(), point.on_b.to_array()],
        normal: [point.normal_impulse, point.normal_force],
        friction: [point.friction_impulse.to_array(), point.friction_force.to_array()],
    };
    let patch = |patch: &Patch| (patch.normal.to_array(), patch.points().iter().map(point).collect());
    let found = pair.found_at().map(|found| {
        let pose = (found.pose.rotation.to_wxyz(), found.pose.translation.to_array());
        content::FoundAt { pose, reach: found.reach, separation: found.separation }
    });
    content::PairPatches { pair: (pair.a, pair.b), found, patches: pair.patches.iter().map(patch).collect() }
}

fn restored_pair(core: &Core, saved: &content::PairPatches) -> Result<PairPatches, SnapshotError> {
    let (a, b) = saved.pair;
    let model = &core.model;
    if a >= b || b >= model.bodies.len() || contact_kinematics::shapes(model, a, b).is_none() {
        return Err(SnapshotError::Invalid("a contact is not of two bodies that can touch"));
    }
    let point = |saved: &content::PatchPoint| {
        let id = restored_id(model, &saved.id)?;
        let Feature::Shapes(feature) = id.feature else {
            return Err(SnapshotError::Invalid("a contact is not of two bodies that can touch"));
        };
        let [on_a, on_b] = saved.on.map(DVec3::from_array);
        let [friction_impulse, friction_force] = saved.friction.map(DVec3::from_array);
        let [normal_impulse, normal_force] = saved.normal;
        Ok(PatchPoint { feature, on_a, on_b, normal_impulse, friction_impulse, normal_force, friction_force })
    };
    let patch = |(normal, points): &([f64; 3], Vec<content::PatchPoint>)| {
        let points = points.iter().map(point).collect::<Result<Vec<_>, _>>()?;
        let patch = Patch::restored(DVec3::from_array(*normal), &points);
        patch.ok_or(SnapshotError::Invalid("a patch of contacts has no point, or too many"))
    };
    let patches = saved.patches.iter().map(patch).collect::<Result<Vec<_>, _>>()?;
    let found = saved.found.as_ref().map(|found| {
        let rotation = Rotation::from_stored_wxyz(found.pose.0);
        let rotation = rotation.map_err(|_| SnapshotError::Invalid("the attitude of a body is not a rotation"))?;
        let pose = Pose::new(rotation, DVec3::from_array(found.pose.1));
        Ok(FoundAt { pose, reach: found.reach, separation: found.separation })
    });
    Ok(PairPatches::new(model, (a, b)).with_patches(found.transpose()?, patches))
}
