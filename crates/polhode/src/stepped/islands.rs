//! Islands of a time step: bodies that may touch within it, or that force fields couple.

use crate::collision::touch::Touch;
use crate::model::{Model, prescribed, tolerances};
use crate::rows::groups::coupled_groups;
use polhode_contact::{Aabb, BroadPhase, BroadPhaseError, swept_aabb};
use polhode_dynamics::BodyState;
use polhode_spatial::{DisjointSets, Still};

/// Factor by which the swept boxes of a step allow for impulses, which may double a speed (dimensionless).
const SWEEP_FACTOR: f64 = 2.0;

/// Bodies that one time step advances together.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Island {
    /// The movable bodies, ascending.
    pub(super) bodies: Vec<usize>,
    /// The pairs of its bodies, and of them with fixed and kinematic ones, that may touch; A < B, ascending.
    pub(super) pairs: Vec<(usize, usize)>,
}

/// Searches the pairs of a step; it keeps its buffers from step to step.
#[derive(Debug)]
pub(super) struct IslandSearch {
    broad_phase: Box<dyn BroadPhase>,
    colliders: Vec<usize>,
    boxes: Vec<Aabb>,
    box_pairs: Vec<(u32, u32)>,
}

impl IslandSearch {
    pub(super) fn new(model: &Model, broad_phase: Box<dyn BroadPhase>) -> Self {
        let colliders = (0..model.bodies.len()).filter(|&body| model.bodies[body].shape.is_some()).collect();
        Self { broad_phase, colliders, boxes: Vec::new(), box_pairs: Vec::new() }
    }

    /// Leaves a removed body out of further searches.
    pub(super) fn forget(&mut self, body: usize) {
        self.colliders.retain(|&other| other != body);
    }

    /// Pairs that may touch from `t` to `t + h` (s), A < B, ascending.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn pairs(
        &mut self,
        model: &Model,
        states: &[BodyState],
        interval: (f64, f64),
    ) -> Result<Vec<(usize, usize)>, BroadPhaseError> {
        if !model.surfaces.may_collide() {
            return Ok(model.joints.joint_contact_pairs().collect());
        }
        let mut pairs = self.pairs_of_boxes(model, |body| swept_box(model, states, body, interval))?;
        pairs.extend(model.joints.joint_contact_pairs());
        pairs.sort_unstable();
        Ok(pairs)
    }

    /// Pairs that may collide and whose boxes overlap, A < B.
    ///
    /// # Errors
    /// When there are more bodies than the broad phase can number.
    pub(super) fn pairs_of_boxes(
        &mut self,
        model: &Model,
        of: impl Fn(usize) -> Aabb,
    ) -> Result<Vec<(usize, usize)>, BroadPhaseError> {
        self.boxes.clear();
        self.boxes.extend(self.colliders.iter().map(|&body| of(body)));
        self.broad_phase.pairs(&self.boxes, &mut self.box_pairs)?;
        let pairs = self.box_pairs.iter().map(|&(i, j)| (self.colliders[i as usize], self.colliders[j as usize]));
        let pairs = pairs.map(|(a, b)| (a.min(b), a.max(b)));
        Ok(pairs.filter(|&(a, b)| model.scene.may_collide(a, b)).collect())
    }
}

/// The box of a body, enlarged by the distance that it may travel from `t` to `t + h` (s).
fn swept_box(model: &Model, states: &[BodyState], body: usize, (t, h): (f64, f64)) -> Aabb {
    let state = &states[body];
    let Some(shape) = &model.bodies[body].shape else { return Aabb::UNBOUNDED };
    let travel = tolerances::touch_distance(model, states, body, body) + travel_of(model, states, body, h);
    let swept = match prescribed::trajectory(model, body) {
        Some(trajectory) => swept_aabb(shape, trajectory, t, t + h),
        None => swept_aabb(shape, &Still(state.pose), 0.0, 0.0),
    };
    // A motion without bounds gets an unbounded box.
    swept.and_then(|aabb| aabb.inflated(travel)).unwrap_or(Aabb::UNBOUNDED)
}

/// How far a body that is free may travel within `h` (s), m; impulses included. Zero where it does not move or follows
/// a motion.
pub(super) fn travel_of(model: &Model, states: &[BodyState], body: usize, h: f64) -> f64 {
    let own = &model.bodies[body];
    if !own.moves() {
        return 0.0;
    }
    let velocity = model.velocity(body, &states[body]);
    let speed = velocity.linear.length() + velocity.angular.length() * own.size;
    SWEEP_FACTOR * h * (speed + model.gravity().length() * h)
}

/// The islands: connected components of the movable bodies by pairs and couplings, ordered by their first bodies. A
/// body without a pair is in no island, unless a field acts on it; then it is at least an island of its own.
pub(super) fn islands(model: &Model, pairs: &[(usize, usize)]) -> Vec<Island> {
    let mut sets = DisjointSets::new(model.bodies.len());
    let mut taken = vec![false; model.bodies.len()];
    for together in &model.forces.couplings {
        for &body in together {
            sets.join(together[0], body);
        }
    }
    for &body in &model.movable {
        taken[body] = model.is_loaded(body) && model.bodies[body].moves();
    }
    for &(a, b) in pairs {
        let moves = [a, b].map(|body| model.bodies[body].moves());
        taken[a] |= moves[0];
        taken[b] |= moves[1];
        if moves == [true, true] {
            sets.join(a, b);
        }
    }
    let mut slots: Vec<Option<usize>> = vec![None; model.bodies.len()];
    let mut islands: Vec<Island> = Vec::new();
    for body in (0..taken.len()).filter(|&body| taken[body]) {
        let slot = *slots[sets.smallest(body)].get_or_insert_with(|| {
            islands.push(Island::default());
            islands.len() - 1
        });
        islands[slot].bodies.push(body);
    }
    for &(a, b) in pairs {
        let member = if model.bodies[a].moves() { a } else { b };
        if let Some(slot) = slots[sets.smallest(member)] {
            islands[slot].pairs.push((a, b));
        }
    }
    islands
}

/// Groups of bodies that these contacts and joints connect, with their contacts.
pub(super) fn joined(model: &Model, touches: &[Touch]) -> Vec<(Vec<usize>, Vec<Touch>)> {
    let all = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
    let members = |contacts: &[usize]| contacts.iter().map(|&index| touches[index]).collect();
    let held = model.joints.held_among(&model.movable);
    coupled_groups(model, all, &held).into_iter().map(|group| (group.bodies, members(&group.contacts))).collect()
}
