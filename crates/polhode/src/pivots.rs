//! Pivots: bodies held at a point of the world, by constraint rows or by a reduction to rotation about the point.
//!
//! A pivot keeps the point Q of a body at a point of the world: three bilateral rows `p_Q = const`, with a constraint
//! force of any direction. With the arm `r` from the centre of mass to Q,
//!
//! `u = v + w x r`,  `a_Q = a + alpha x r + w x (w x r)`,
//!
//! the rows are `(e_k, r x e_k)` for the three axes of the world, with the constants `e_k . (w x (w x r))` (thesis 3.2,
//! equations 2 and 3 for a point of a body; Featherstone, chapter 8, for rows of joints). This is the general form: the
//! moving frame of the body has its origin at the centre of mass, as that of any other body, and the pivot is one more
//! [constraint](crate::constraint).
//!
//! If no contact can act on the body, its motion can be reduced to rotation about Q: in a frame with its origin at Q,
//! with the moments of inertia about Q and inverse mass zero ([`RigidBody::pivoted`]). Then no row is needed, and the
//! pivot does not drift. This reduction of the plan is exact and costs less; a test compares it with the rows.
//!
//! | form | when |
//! |---|---|
//! | rows | tier `accurate` with `dop853` or `rk4`, if the body may collide or all effects are asked for |
//! | reduced | otherwise, and in the time steps of a stretch of crowded events |
//!
//! Assumption: the point is fixed in the world and in the body. Fails: never; the scene refuses a point that is not
//! finite.

use crate::accounting::books::{Books, gravity_at, momentum_of};
use crate::constraint::ConstraintId;
use crate::constraint::bilateral::{Bilateral, BilateralRow, Member, RowKind};
use crate::pivot_form::{HeldPoint, PivotRows};
use crate::scene::SceneError;

use crate::Momentum;
use crate::world::World;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::ResponseError;
use polhode_spatial::{DVec3, Pose, Velocity};

impl World {
    /// Whether constraint rows hold any body at a pivot.
    pub(crate) fn has_rows(&self) -> bool {
        !self.held_by_rows.is_empty()
    }

    /// Whether constraint rows hold this body at its pivot.
    pub(crate) fn is_held_by_rows(&self, body: usize) -> bool {
        self.held_by_rows.binary_search(&body).is_ok()
    }

    /// The bilateral constraints of these bodies in these states: the pivots with constraint rows, in the order of the
    /// bodies.
    pub(crate) fn bilaterals<'a>(
        &'a self,
        states: &'a [BodyState],
        bodies: &'a [usize],
    ) -> impl Iterator<Item = Bilateral> + 'a {
        let bodies = if self.held_by_rows.is_empty() { &[] } else { bodies };
        bodies.iter().filter_map(|&body| self.pivot(states, body))
    }

    /// The pivot of a body with constraint rows; none for any other body. Its bias is `w x (w x r)`.
    pub(crate) fn pivot(&self, states: &[BodyState], body: usize) -> Option<Bilateral> {
        let (held, state) = (self.bodies[body].held?, &states[body]);
        let arm = state.pose.rotation.rotate(held.arm);
        let point = state.pose.translation + arm;
        let Velocity { linear, angular } = self.velocity(body, state);
        let gap = (point - held.place).to_array();
        let rate = (linear + angular.cross(arm)).to_array();
        let bias = angular.cross(angular.cross(arm)).to_array();
        let row = |axis: usize| BilateralRow {
            kind: RowKind::Along(DVec3::AXES[axis]),
            gap: gap[axis],
            rate: rate[axis],
            bias: bias[axis],
        };
        let rows = [0, 1, 2].map(row).to_vec();
        let members = vec![Member { body, arm, sign: 1.0 }];
        Some(Bilateral { id: ConstraintId::Pivot { body }, point, members, rows })
    }

    /// The same world, with the motion of all pivoted bodies reduced to rotation about their pivots.
    ///
    /// # Errors
    /// When a shape or a force cannot be expressed in the reduced frame.
    fn without_rows(&self) -> Result<Self, SceneError> {
        let mut reduced = self.clone();
        for body in std::mem::take(&mut reduced.held_by_rows) {
            let scene_body = &self.scene.bodies[body];
            let refused = |source| SceneError::Shape { body: scene_body.name().to_owned(), source };
            let own = &mut reduced.bodies[body];
            let (Some(held), Some(properties)) = (own.held.take(), scene_body.mass_properties()) else { continue };
            own.origin += held.arm;
            own.rigid = Some(RigidBody::pivoted(properties, own.origin));
            own.shape = own.shape.as_ref().map(|shape| shape.translated(-held.arm)).transpose().map_err(refused)?;
        }
        reduced.pivot_rows = PivotRows::None;
        reduced.recompute_from_frames()?;
        Ok(reduced)
    }

    /// The velocity that a body takes when a program gives it `velocity`: a body that constraint rows hold takes the
    /// angular velocity, and the linear one that follows from it.
    pub(crate) fn admitted_velocity(&self, body: usize, pose: &Pose, velocity: Velocity) -> Velocity {
        self.bodies[body].held.map_or(velocity, |held| held.velocity_of_rotation(pose, velocity.angular))
    }

    /// Distance by which a pose (of the moving frame, world) would move a body away from its pivot, m; zero for a body
    /// without a pivot.
    pub(crate) fn leaves_pivot_by(&self, body: usize, now: &BodyState, pose: &Pose) -> f64 {
        let own = &self.bodies[body];
        if let Some(held) = own.held {
            return (pose.transform_point(held.arm) - held.place).length();
        }
        let pivoted = own.rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        if pivoted { (pose.translation - now.pose.translation).length() } else { 0.0 }
    }

    /// Applies the impulse at its pivot to a body that constraint rows hold, so that the held point has no velocity.
    pub(crate) fn hold_velocity(&self, body: usize, state: &mut BodyState) {
        let own = &self.bodies[body];
        let (Some(held), Some(free)) = (own.held, own.rigid) else { return };
        let Some(properties) = self.scene.bodies[body].mass_properties() else { return };
        let turning = RigidBody::pivoted(properties, own.origin + held.arm);
        let w = turning.angular_velocity(&to_pivot_frame(&free, &held, state));
        let velocity = self.admitted_velocity(body, &state.pose, Velocity::new(DVec3::ZERO, w));
        *state = free.at_velocity(state.pose, velocity);
    }
}

/// The state in the frame at the centre of mass, from that in the frame at the pivot.
fn from_pivot_frame(turning: &RigidBody, free: &RigidBody, held: &HeldPoint, state: &BodyState) -> BodyState {
    let pose = Pose::new(state.pose.rotation, held.place - state.pose.rotation.rotate(held.arm));
    free.at_velocity(pose, held.velocity_of_rotation(&pose, turning.angular_velocity(state)))
}

/// The state in the frame at the pivot, from that in the frame at the centre of mass: `L_Q = L - r x m v`.
fn to_pivot_frame(free: &RigidBody, held: &HeldPoint, state: &BodyState) -> BodyState {
    let arm = state.pose.rotation.rotate(held.arm);
    BodyState {
        pose: Pose::new(state.pose.rotation, held.place),
        linear_velocity: DVec3::ZERO,
        angular_momentum: state.angular_momentum - arm.cross(state.linear_velocity * free.mass()),
    }
}

/// Advances bodies over `h` (s) by a method without constraint rows.
///
/// `work` advances them in a world in which the motion of pivoted bodies is reduced to rotation about their pivots; the
/// states are then transformed back. `books` selects the books in the answer of `work`. In the reduced world pivoted
/// bodies pass their momentum on to the world and the books leave it out; it is therefore booked here: the impulse of
/// their weight by the mean of its moment at both ends, and the rest of their change of momentum as support.
///
/// # Errors
/// The errors of `work`; [`ResponseError::NotFinite`] when a shape cannot be expressed in the reduced frame.
pub(crate) fn with_pivots_reduced<T>(
    world: &World,
    states: &mut [BodyState],
    bodies: &[usize],
    h: f64,
    work: impl FnOnce(&World, &mut [BodyState]) -> Result<T, ResponseError>,
    books: impl FnOnce(&mut T) -> &mut Books,
) -> Result<T, ResponseError> {
    if !world.has_rows() {
        return work(world, states);
    }
    let refused = |_| ResponseError::NotFinite { what: "frames of pivoted bodies", index: 0 };
    let reduced = world.without_rows().map_err(refused)?;
    let before: Vec<(usize, BodyState)> = world.held_by_rows.iter().map(|&body| (body, states[body])).collect();
    let parts = |body: usize| Some((world.bodies[body].held?, world.bodies[body].rigid?, reduced.bodies[body].rigid?));
    for &(body, state) in &before {
        if let Some((held, free, _)) = parts(body) {
            states[body] = to_pivot_frame(&free, &held, &state);
        }
    }
    let done = work(&reduced, states);
    let moved = |body: usize| done.is_ok() && bodies.contains(&body);
    for &(body, state) in &before {
        states[body] = match parts(body).filter(|_| moved(body)) {
            Some((held, free, turning)) => from_pivot_frame(&turning, &free, &held, &states[body]),
            None => state,
        };
    }
    let mut done = done?;
    let books = books(&mut done);
    let about = books.ledger.momentum.about;
    let own: Vec<usize> = before.iter().map(|&(body, _)| body).filter(|body| bodies.contains(body)).collect();
    let mut start = states.to_vec();
    for &(body, state) in &before {
        start[body] = state;
    }
    let weight =
        |body: usize| gravity_at(world, &start, body, about, 0.5 * h) + gravity_at(world, states, body, about, 0.5 * h);
    let gravity = own.iter().fold(Momentum::default(), |sum, &body| sum + weight(body));
    let gained =
        momentum_of(world, states, own.iter().copied(), about) - momentum_of(world, &start, own.iter().copied(), about);
    books.ledger.momentum.gravity.add(gravity);
    books.ledger.momentum.support.add(gained - gravity);
    Ok(done)
}
