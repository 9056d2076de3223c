//! A step of an island in reduced coordinates: the same flat states of bodies at its end and within it as in maximal
//! coordinates.
//!
//! DOP853 integrates the coordinates of the joints (`crate::reduced`) with the numbers for the ledgers behind them.
//! What comes out is written as states of bodies, so that all else (sampling, ledgers, snapshots) does not know of it.
//! At both ends of a step these follow from the coordinates; within it from polynomials through eight times.
//!
//! Errors are those of coordinates and speeds. An error `e` of an angle displaces what hangs on it by `e` times its
//! distance, so that the angle is allowed the tolerance over the largest distance in sizes of bodies; likewise a
//! displacement and all speeds.

use super::held_forces::HeldForces;
use super::system::ContactSystem;
use crate::constraint::tree_joint::FreeMotionOfJoint;
use crate::model::Model;
use crate::reduced::Articulated;
use crate::reduced::tree::{Node, Tree};
use polhode_dynamics::error_allowance::{ErrorAllowance, LargestError};
use polhode_dynamics::integrator::dop853::STEP_SHARE;
use polhode_dynamics::state::{LINEAR_VELOCITY, QUATERNION, WIDTH};
use polhode_dynamics::{BodyState, DenseStep, Dop853, System};
use polhode_response::ResponseError;
use polhode_spatial::DVec3;
use polhode_spatial::rounding;
use std::ops::Range;

/// A step in reduced coordinates.
#[derive(Debug)]
pub(super) struct ReducedStep {
    tree: Tree,
    method: Dop853,
    /// Flat state of the bodies at its start and at its end.
    start: Vec<f64>,
    end: Vec<f64>,
    t: f64,
    h: f64,
}

/// The island as the system of its coordinates.
struct ReducedSystem<'s, 'a> {
    bodies: &'s mut ContactSystem<'a>,
    tree: &'s Tree,
    passes: Articulated,
}

impl System for ReducedSystem<'_, '_> {
    type Error = ResponseError;

    fn dimension(&self) -> usize {
        self.tree.numbers + self.bodies.tail()
    }

    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), ResponseError> {
        let Self { bodies, tree, passes } = self;
        let loads = bodies.loads_of_tree(t, tree, state);
        let (own, tail) = rates.split_at_mut(tree.numbers);
        let support = passes.rates((bodies.model(), tree), &loads, state, own, bodies.about());
        bodies.outside_rates(t, &HeldForces::default(), tail);
        for (number, value) in
            tail.iter_mut().zip(support.force.to_array().into_iter().chain(support.moment.to_array()))
        {
            *number += value;
        }
        Ok(())
    }
}

impl ReducedStep {
    /// A step from (`t`, `start`) over `h` (s), a flat state of the island's bodies; none where they are no trees.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn attempt(
        system: &mut ContactSystem<'_>,
        (t, h): (f64, f64),
        start: Vec<f64>,
    ) -> Result<Option<Self>, ResponseError> {
        let Some(tree) = Tree::of(system.model(), system.bodies()) else { return Ok(None) };
        system.set_states(&start);
        let mut flat = tree.coordinates(system.model(), system.states());
        flat.extend(std::iter::repeat_n(0.0, system.tail()));
        let mut method = Dop853::new(flat.len());
        let mut reduced = ReducedSystem { bodies: system, tree: &tree, passes: Articulated::default() };
        method.attempt_unscaled(&mut reduced, t, &flat, h)?;
        let end = of_bodies(system, &tree, method.end_state(), &start);
        Ok(Some(Self { tree, method, start, end, t, h }))
    }

    /// Flat state of the bodies at its end.
    pub(super) fn end_state(&self) -> &[f64] {
        &self.end
    }

    /// The state of the bodies at any time within the step.
    ///
    /// # Errors
    /// Those of the system.
    pub(super) fn dense(&mut self, system: &mut ContactSystem<'_>) -> Result<DenseStep, ResponseError> {
        let mut reduced = ReducedSystem { bodies: system, tree: &self.tree, passes: Articulated::default() };
        let dense = self.method.dense(&mut reduced)?;
        let (t, h) = (self.t, self.h);
        let mut last = self.start.clone();
        let mut flat = vec![0.0; dense.dimension()];
        DenseStep::through_values(t, h, |x| {
            last = if x <= 0.0 {
                self.start.clone()
            } else if x >= 1.0 {
                with_signs(self.end.clone(), &last)
            } else {
                dense.evaluate(t + x * h, &mut flat);
                of_bodies(system, &self.tree, &flat, &last)
            };
            Ok(last.clone())
        })
    }

    /// The largest error of its coordinates and speeds, relative to what the tolerance (no unit) allows.
    pub(super) fn error(&self, model: &Model, tolerance: f64) -> f64 {
        let allowed = STEP_SHARE * tolerance;
        let reaches = reaches(model, &self.tree, &self.start);
        let mut largest = LargestError::default();
        // What rounding alone leaves of a number is no error of the method.
        let end = self.method.end_state();
        let mut include = |numbers: Range<usize>, allowed: f64, scale: f64| {
            let own = end.get(numbers.clone()).unwrap_or_default();
            let rounding = rounding::DOZEN_TERMS * own.iter().fold(scale, |most: f64, number| most.max(number.abs()));
            largest.include(self.method.error_of(numbers), allowed.max(rounding));
        };
        for (node, reach) in self.tree.nodes.iter().zip(reaches) {
            let size = model.bodies[node.body].size;
            let speed = speed_of(model, node, (&self.start, &self.end));
            let (q, u) = (node.first_q..node.first_q + node.coordinates(), node.u());
            let (length, angle) = (allowed * size / reach, allowed / reach);
            let (rate, turning) = (allowed * speed / reach, allowed * speed / (size * reach));
            match node.joint.map(|joint| joint.free) {
                None => {
                    include(q.start..q.start + 3, length, 0.0);
                    include(q.start + 3..q.end, ErrorAllowance::of_angle(angle), 1.0);
                    include(u.start..u.start + 3, rate, speed);
                    include(u.start + 3..u.end, turning, speed / size);
                }
                Some(FreeMotionOfJoint::Ball) => {
                    include(q, ErrorAllowance::of_angle(angle), 1.0);
                    include(u, turning, speed / size);
                }
                Some(FreeMotionOfJoint::Hinge) => {
                    include(q, angle, 1.0);
                    include(u, turning, speed / size);
                }
                Some(FreeMotionOfJoint::Slider) => {
                    include(q, length, size);
                    include(u, rate, speed);
                }
            }
        }
        largest.get()
    }
}

/// The largest of the speeds that the error of a speed is measured by, m/s, at both ends of a step: of the centre of
/// mass, of points of the body, and that of a fall over its size.
fn speed_of(model: &Model, node: &Node, (start, end): (&[f64], &[f64])) -> f64 {
    let size = model.bodies[node.body].size;
    let fall = (model.gravity().length() * size).sqrt();
    let speed = |flat: &[f64]| {
        let state = flat.as_chunks::<WIDTH>().0.get(node.place).map(BodyState::from_array);
        state.map_or(0.0, |state| {
            let velocity = model.velocity(node.body, &state);
            velocity.linear.length().max(velocity.angular.length() * size)
        })
    };
    fall.max(speed(start)).max(speed(end))
}

/// Of each node, how far what hangs on it is from it at the most, in the sizes of those bodies, and at least 1: an
/// upper bound.
fn reaches(model: &Model, tree: &Tree, start: &[f64]) -> Vec<f64> {
    let place = |node: &Node| {
        let numbers = start.get(node.place * WIDTH..node.place * WIDTH + QUATERNION).unwrap_or_default();
        DVec3::from_slice(if numbers.len() < QUATERNION { &[0.0; QUATERNION] } else { numbers })
    };
    let size = |node: &Node| model.bodies[node.body].size;
    let mut reaches = vec![1.0_f64; tree.nodes.len()];
    let mut least: Vec<f64> = tree.nodes.iter().map(size).collect();
    for (own, node) in tree.nodes.iter().enumerate().rev() {
        let Some(parent) = node.parent else { continue };
        let apart = place(node).distance(place(&tree.nodes[parent]));
        least[parent] = least[parent].min(least[own]);
        reaches[parent] = reaches[parent].max(reaches[own] + apart / least[own]);
    }
    reaches
}

/// The flat state of bodies from one of coordinates; the signs of quaternions are those of `last`.
fn of_bodies(system: &ContactSystem<'_>, tree: &Tree, flat: &[f64], last: &[f64]) -> Vec<f64> {
    let mut bodies = vec![0.0; system.bodies().len() * WIDTH];
    tree.states(system.model(), flat, |node, state| {
        bodies[node.place * WIDTH..(node.place + 1) * WIDTH].copy_from_slice(&state.to_array());
    });
    bodies.extend_from_slice(flat.get(tree.numbers..).unwrap_or_default());
    with_signs(bodies, last)
}

/// The same rotations on the side of those of `last`.
fn with_signs(mut flat: Vec<f64>, last: &[f64]) -> Vec<f64> {
    let bodies = flat.as_chunks_mut::<WIDTH>().0;
    for (own, before) in bodies.iter_mut().zip(last.as_chunks::<WIDTH>().0) {
        let (own, before) = (&mut own[QUATERNION..LINEAR_VELOCITY], &before[QUATERNION..LINEAR_VELOCITY]);
        if own.iter().zip(before).map(|(a, b)| a * b).sum::<f64>() < 0.0 {
            for number in own.iter_mut() {
                *number = -*number;
            }
        }
    }
    flat
}
