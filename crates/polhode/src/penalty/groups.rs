//! Which bodies may meet within a longest step.
//!
//! Each body has a box that holds it through the step: its box at the start, enlarged by what it may move, at first at
//! its present velocity and under gravity and fields. Bodies whose boxes overlap, or that fields or joints couple, form
//! a group; fixed and kinematic bodies join none. Whether bodies have kept to their boxes is looked at afterwards
//! ([`Margins::grow`]); where one has not, its margin is enlarged and all groups are made and advanced anew. A group's
//! motion depends on its members alone. How it fails: a box that is not finite is refused by the broad phase.

use super::run::{Group, GroupRun};
use crate::collision::boxes::Boxes;
use crate::error::SimulationError;
use crate::model::tolerances;
use crate::tier::core::Core;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::Still;

/// Margin of a body beyond what it moves at its present velocity (1 to 4): contacts accelerate it.
const SLACK: f64 = 1.5;

/// How far bodies may move within a step.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Margins(Vec<f64>);

impl Margins {
    /// For a step of `h` (s) from these states.
    pub(super) fn new(core: &Core, states: &[BodyState], h: f64) -> Self {
        let model = &core.model;
        let loads = model.loads(core.t, states);
        let margin = |body: usize| {
            let speed = tolerances::point_speed(model, states, body);
            let of_field = model.bodies[body].rigid.as_ref().map_or(0.0, RigidBody::inverse_mass);
            let acceleration = model.gravity().length() + loads.of(body).force.length() * of_field;
            SLACK * h * (speed + acceleration * h)
        };
        Self((0..states.len()).map(margin).collect())
    }

    /// Enlarges the margins of bodies that have left them, and returns whether any has.
    pub(super) fn grow(&mut self, core: &Core, states: &[BodyState], runs: &[GroupRun]) -> bool {
        let mut has_grown = false;
        for run in runs {
            for (place, &body) in run.group.bodies.iter().enumerate() {
                let moved = run.moved(place, &states[body], core.model.bodies[body].size);
                if moved > self.0[body] {
                    self.0[body] = SLACK * moved;
                    has_grown = true;
                }
            }
        }
        has_grown
    }
}

/// The groups of a step of `h` (s).
///
/// # Errors
/// When there are more bodies than the broad phase can number.
pub(super) fn groups(
    core: &Core,
    states: &[BodyState],
    (margins, h): (&Margins, f64),
    boxes: &mut Boxes,
) -> Result<Vec<Group>, SimulationError> {
    let model = &core.model;
    for (body, state) in states.iter().enumerate() {
        boxes.set(model, body, &Still(state.pose), (core.t, core.t + h), margins.0[body]);
        if model.bodies[body].removed {
            boxes.put(body, None);
        }
    }
    let mut pairs = Vec::new();
    boxes.all_pairs(model, |a, b| pairs.push((a.min(b), a.max(b))))?;
    pairs.sort_unstable();
    let moves = |body: usize| model.bodies[body].moves();
    let movable: Vec<usize> = (0..states.len()).filter(|&body| moves(body)).collect();
    let mut of_body: Vec<usize> = (0..states.len()).collect();
    let joined = pairs.iter().copied().filter(|&(a, b)| moves(a) && moves(b));
    let coupled = model.couplings_among(&movable).flat_map(|bodies| bodies.windows(2).map(|pair| (pair[0], pair[1])));
    let jointed = model.joints.joints_among(&movable).filter_map(|joint| {
        let mut bodies = joint.bodies();
        bodies.next().zip(bodies.next())
    });
    let links: Vec<(usize, usize)> = joined.chain(coupled).chain(jointed).collect();
    for (a, b) in links {
        let (x, y) = (root(&of_body, a), root(&of_body, b));
        let (low, high) = (x.min(y), x.max(y));
        of_body[high] = low;
    }
    let mut found: Vec<Group> = Vec::new();
    let mut place = vec![usize::MAX; states.len()];
    for &body in &movable {
        let first = root(&of_body, body);
        if place[first] == usize::MAX {
            place[first] = found.len();
            found.push(Group::default());
        }
        found[place[first]].bodies.push(body);
    }
    for (a, b) in pairs {
        let member = if moves(a) { a } else { b };
        if moves(member) {
            found[place[root(&of_body, member)]].pairs.push((a, b));
        }
    }
    Ok(found)
}

/// The first body of a group: links lead to smaller numbers.
fn root(of_body: &[usize], body: usize) -> usize {
    let mut at = body;
    while of_body[at] != at {
        at = of_body[at];
    }
    at
}

impl GroupRun {
    /// How far a body, by its place in the group, has moved from its state at the start of the run, with its rotation
    /// times its size (m), at the ends of all steps.
    fn moved(&self, place: usize, start: &BodyState, size: f64) -> f64 {
        let end = self.ends.get(place).into_iter().copied();
        let within = self.segments.iter().map(|segment| segment.state(place, segment.dense.t0() + segment.dense.h()));
        let distance = |state: BodyState| {
            let turned = start.pose.rotation.angle_to(state.pose.rotation);
            (state.pose.translation - start.pose.translation).length() + turned * size
        };
        end.chain(within).map(distance).fold(0.0, f64::max)
    }
}
