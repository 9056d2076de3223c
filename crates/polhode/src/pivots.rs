//! Bodies held at a point of the world: by rows, or by a frame in which nothing but turning is left.
//!
//! A pivot keeps the point Q of a body at a place of the world: three bilateral rows `p_Q = const` with a force of
//! constraint that may have any direction. With the arm `r` from the centre of mass to Q,
//!
//! `u = v + w x r`,  `a_Q = a + alpha x r + w x (w x r)`,
//!
//! rows `(e_k, r x e_k)` for the three axes of the world, and the constant part `e_k . (w x (w x r))` (thesis 3.2,
//! equations 2 and 3 for a point of a body; Featherstone, chapter 8, for rows of joints). That is the general path: the
//! body is one like any other, its frame at the centre of mass, and the pivot is one more
//! [constraint](crate::interaction::constraint).
//!
//! Where no contact can act on the body, the constraint can be solved once and for all: in a frame with its origin at
//! Q, with the moments about Q and no inverse mass, turning is all that is left ([`RigidBody::pivoted`]), no row is
//! needed and the pivot does not drift. That is a reduction of the plan: it is exact, costs less, and a test holds it
//! against the rows.
//!
//! | how | when |
//! |---|---|
//! | rows | tier `accurate`, by `dop853` or `rk4`: something may touch the body, or all effects are asked for |
//! | reduced | otherwise; over time steps of a stretch in which events crowd too |
//!
//! Assumption: the point is fixed in the world and in the body. Fails: never; a point that is not finite is refused
//! with the scene.

use crate::accounting::books::{Books, gravity_at, momentum_of};
use crate::interaction::constraint::ConstraintId;
use crate::pivot_form::{HeldPoint, PivotRows};
use crate::scene::SceneError;

use crate::Momentum;
use crate::world::World;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_response::ResponseError;
use polhode_spatial::{DVec3, Pose, Velocity};

/// A pivot at the present states.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PivotKinematics {
    pub(crate) body: usize,
    /// Where the point is, world, m.
    pub(crate) point: DVec3,
    /// From the centre of mass to it, world, m.
    pub(crate) arm: DVec3,
    /// How far it has drifted from where it is held, m.
    pub(crate) gap: DVec3,
    /// Its velocity, m/s.
    pub(crate) velocity: DVec3,
    /// `w x (w x r)`, m/s^2: its acceleration but for that of the centre of mass and the angular one.
    pub(crate) acceleration_bias: DVec3,
}

impl PivotKinematics {
    /// The pivot's identity among constraints.
    pub(crate) fn id(&self) -> ConstraintId {
        ConstraintId::Pivot { body: self.body }
    }
}

impl World {
    /// Whether rows hold any body.
    pub(crate) fn has_rows(&self) -> bool {
        !self.held_by_rows.is_empty()
    }

    /// Whether rows hold a body at a pivot.
    pub(crate) fn is_held_by_rows(&self, body: usize) -> bool {
        self.held_by_rows.binary_search(&body).is_ok()
    }

    /// The pivots that hold some bodies by rows, in the order of the bodies, as they stand at these states.
    pub(crate) fn pivots<'a>(
        &'a self,
        states: &'a [BodyState],
        bodies: &'a [usize],
    ) -> impl Iterator<Item = PivotKinematics> + 'a {
        let bodies = if self.held_by_rows.is_empty() { &[] } else { bodies };
        bodies.iter().filter_map(|&body| self.pivot(states, body))
    }

    /// The pivot that holds a body by rows.
    pub(crate) fn pivot(&self, states: &[BodyState], body: usize) -> Option<PivotKinematics> {
        let (held, state) = (self.bodies[body].held?, &states[body]);
        let arm = state.pose.rotation.rotate(held.arm);
        let point = state.pose.translation + arm;
        let Velocity { linear, angular } = self.velocity(body, state);
        Some(PivotKinematics {
            body,
            point,
            arm,
            gap: point - held.place,
            velocity: linear + angular.cross(arm),
            acceleration_bias: angular.cross(angular.cross(arm)),
        })
    }

    /// The same world with turning alone left of the bodies that rows hold.
    ///
    /// # Errors
    /// When a shape or a force cannot be put into another frame.
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

    /// A velocity that a program gives to a body: of one that rows hold the angular part, and what follows from it.
    pub(crate) fn admitted_velocity(&self, body: usize, pose: &Pose, velocity: Velocity) -> Velocity {
        self.bodies[body].held.map_or(velocity, |held| held.turning(pose, velocity.angular))
    }

    /// How far a pose (of the moving frame, world) would carry a body away from its pivot, m; zero without one.
    pub(crate) fn leaves_pivot_by(&self, body: usize, now: &BodyState, pose: &Pose) -> f64 {
        let own = &self.bodies[body];
        if let Some(held) = own.held {
            return (pose.transform_point(held.arm) - held.place).length();
        }
        let pivoted = own.rigid.as_ref().is_some_and(RigidBody::is_pivoted);
        if pivoted { (pose.translation - now.pose.translation).length() } else { 0.0 }
    }

    /// Takes from the velocity of a body that rows hold what would carry its pivot away, by an impulse at the pivot.
    pub(crate) fn hold_velocity(&self, body: usize, state: &mut BodyState) {
        let own = &self.bodies[body];
        let (Some(held), Some(free)) = (own.held, own.rigid) else { return };
        let Some(properties) = self.scene.bodies[body].mass_properties() else { return };
        let turning = RigidBody::pivoted(properties, own.origin + held.arm);
        let w = turning.angular_velocity(&to_turning(&free, &held, state));
        let velocity = self.admitted_velocity(body, &state.pose, Velocity::new(DVec3::ZERO, w));
        *state = free.at_velocity(state.pose, velocity);
    }
}

/// Of a body in a frame at its pivot, the state in the frame at its centre of mass.
fn from_turning(turning: &RigidBody, free: &RigidBody, held: &HeldPoint, state: &BodyState) -> BodyState {
    let pose = Pose::new(state.pose.rotation, held.place - state.pose.rotation.rotate(held.arm));
    free.at_velocity(pose, held.turning(&pose, turning.angular_velocity(state)))
}

/// Of a body in a frame at its centre of mass, the state in the frame at its pivot: `L_Q = L - r x m v`.
fn to_turning(free: &RigidBody, held: &HeldPoint, state: &BodyState) -> BodyState {
    let arm = state.pose.rotation.rotate(held.arm);
    BodyState {
        pose: Pose::new(state.pose.rotation, held.place),
        linear_velocity: DVec3::ZERO,
        angular_momentum: state.angular_momentum - arm.cross(state.linear_velocity * free.mass()),
    }
}

/// Does something to bodies over `h` seconds that knows no rows, in a world in which turning alone is left of pivoted
/// bodies; `books` finds the books in its answer. There pivoted bodies pass their momentum on to the world; what they
/// do not is booked here: their weight by its moment at both ends, and as support what is left of the change of their
/// momentum.
///
/// # Errors
/// Those of `work`; when a shape cannot be put into the other frame, a number that is not finite.
pub(crate) fn with_turning_alone<T>(
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
            states[body] = to_turning(&free, &held, &state);
        }
    }
    let done = work(&reduced, states);
    let moved = |body: usize| done.is_ok() && bodies.contains(&body);
    for &(body, state) in &before {
        states[body] = match parts(body).filter(|_| moved(body)) {
            Some((held, free, turning)) => from_turning(&turning, &free, &held, &states[body]),
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
