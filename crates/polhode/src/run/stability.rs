//! How far bodies at rest are from moving, and how they would begin to.
//!
//! For every group of bodies at rest that touch each other or are joined, with the forces that act on them (`G`), limit
//! analysis (`polhode_response::friction::Structure`) answers two questions.
//!
//! - **Friction.** To which part `m` of themselves may all coefficients fall before no forces within the cones hold the
//!   bodies?
//! - **Pushes.** Each body is pushed by `l` times its weight in a direction across gravity. From which `l` on do no
//!   forces hold them? Where gravity is the only load, that is the tangent of the angle by which the whole scene may be
//!   tilted: contact forces scale with the load, and a tilt by `atan l` changes it to `cos(atan l)` times such a push.
//!
//! Both come with the motion that begins there: which bodies move, how fast against each other, and whether they slide
//! or tip. Symbols: `m`, `l` (no unit). Sources: Heyman 1966; Livesley 1978.
//!
//! Assumptions: those of limit analysis. Friction of rolling and spinning is left out, so that what it holds counts as
//! loose; a scene in planar motion is analysed in its plane. Bodies that move, that a motion carries, on whose surfaces
//! a belt runs, or whose joints have limits are left out, with all that touches them.

use crate::collision::contact_kinematics;
use crate::collision::contact_modes::ContactModes;
use crate::collision::touch::Touch;
use crate::error::SimulationError;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::{ContactId, Feature};
use crate::report::frame::ContactView;
use crate::rows::assembly::Assembly;
use crate::rows::frictional_contact::FrictionalContact;
use crate::rows::groups::coupled_groups;
use crate::solve::accelerations::blocks_of;
use crate::tier::core::Core;
use crate::tier::executor::{Executor, Task};
use polhode_dynamics::BodyState;
use polhode_response::ResponseError;
use polhode_response::friction::{Limit, MOST_FACTOR, Structure};
use polhode_spatial::{DVec3, Velocity};
use std::f64::consts::FRAC_1_SQRT_2;

/// A body belongs to a motion that begins when it moves at least this fast against the fastest one (no unit, 1e-4 to
/// 1e-2): the tolerance of the analysis is far below. It tips when its points move by its rotation at least this fast
/// against its centre of mass; otherwise it slides. High up in a wall that leans over a brick hardly turns as it moves.
const MOVES_RELATIVE: f64 = 1e-3;

/// A slip above this part of the speed that gravity gives in a second is none of a body at rest (no unit).
const SLIP_RELATIVE: f64 = 1e-9;

/// A direction of which less than this lies in the plane of a planar motion is none of it (no unit).
const IN_PLANE: f64 = 1e-6;

/// The directions of pushes, as parts of two axes across gravity.
const DIRECTIONS: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [FRAC_1_SQRT_2, FRAC_1_SQRT_2],
    [0.0, 1.0],
    [-FRAC_1_SQRT_2, FRAC_1_SQRT_2],
    [-1.0, 0.0],
    [-FRAC_1_SQRT_2, -FRAC_1_SQRT_2],
    [0.0, -1.0],
    [FRAC_1_SQRT_2, -FRAC_1_SQRT_2],
];

/// How a body begins to move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Beginning {
    /// Without turning, or hardly.
    Slides,
    /// It turns.
    Tips,
}

/// A body in a motion that begins.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct MovingBody {
    /// The body.
    pub body: BodyId,
    /// How it begins.
    pub beginning: Beginning,
    /// Its speed against that of the fastest body (no unit): of its centre of mass, or of its points by its rotation.
    pub speed: f64,
    /// The direction in which its centre of mass moves (unit vector, world); none where that stays.
    pub direction: Option<DVec3>,
    /// The velocity of its centre of mass and its angular velocity, world, up to a common factor of all bodies: the
    /// speed of the fastest is 1 m/s.
    pub velocity: Velocity,
}

/// How far friction may fall.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FrictionMargin {
    /// The part of the coefficients of friction that is needed (no unit): 0 where none is, above 1 where there is not
    /// enough. None where friction alone does not hold the bodies.
    pub needed: Option<f64>,
    /// What begins to move below that, or now where friction does not hold the bodies, the fastest first; empty where
    /// none is needed.
    pub begins: Vec<MovingBody>,
}

/// How far bodies may be pushed in one direction.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PushMargin {
    /// The direction (unit vector, world), across gravity.
    pub direction: DVec3,
    /// The largest push on each body, as a part of its weight (no unit); none where nothing holds the bodies as they
    /// are, and infinite where no push moves them.
    pub of_weight: Option<f64>,
    /// What begins to move beyond it, the fastest first.
    pub begins: Vec<MovingBody>,
}

impl PushMargin {
    /// The angle by which the scene may be tilted in this direction, where gravity is the only load, rad.
    pub fn tilt_rad(&self) -> Option<f64> {
        self.of_weight.map(libm::atan)
    }
}

/// How far the bodies at rest are from moving: the worst over all groups of them.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Stability {
    /// How many bodies were looked at: those at rest that touch something.
    pub bodies: usize,
    /// Their contacts.
    pub contacts: usize,
    /// How far friction may fall.
    pub friction: FrictionMargin,
    /// How far they may be pushed; empty without gravity.
    pub pushes: Vec<PushMargin>,
}

impl Stability {
    /// The direction in which they may be pushed least.
    pub fn worst_push(&self) -> Option<&PushMargin> {
        let value = |push: &&PushMargin| push.of_weight.unwrap_or(0.0);
        self.pushes.iter().min_by(|a, b| value(a).total_cmp(&value(b)))
    }
}

/// Which margins are sought.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Margins {
    /// Of friction, and of pushes.
    All,
    /// Of friction: whether the bodies stand.
    OfFriction,
}

/// The bodies at rest among those with these contacts.
///
/// # Errors
/// When rows cannot be made of the contacts.
pub(crate) fn of_contacts(
    core: &Core,
    states: &[BodyState],
    contacts: &[ContactView],
    margins: Margins,
) -> Result<Stability, SimulationError> {
    let refused = |source: ResponseError| SimulationError::of_response(core.t, source);
    let of_view = |view| Some((view, touch(core, states, view)?));
    let (views, touches): (Vec<&ContactView>, Vec<Touch>) = contacts.iter().filter_map(of_view).unzip();
    let at_rest: Vec<usize> = (0..states.len()).filter(|&body| is_at_rest(core, &states[body], body)).collect();
    let ids = touches.iter().enumerate().map(|(index, touch)| (index, touch.id.a, touch.id.b));
    let mut stability = Stability {
        bodies: 0,
        contacts: 0,
        friction: FrictionMargin { needed: Some(0.0), begins: Vec::new() },
        pushes: Vec::new(),
    };
    if margins == Margins::All {
        let any = |direction| PushMargin { direction, of_weight: Some(f64::INFINITY), begins: Vec::new() };
        stability.pushes.extend(directions(core).map(any));
    }
    for group in coupled_groups(&core.model, ids, &at_rest) {
        let members: Vec<Touch> = group.contacts.iter().map(|&index| touches[index]).collect();
        let is_still = group.bodies.iter().all(|body| at_rest.binary_search(body).is_ok());
        let has_limits = core.model.joints.joint_contact_pairs_among(&group.bodies).next().is_some();
        if members.is_empty() || !is_still || has_limits || members.iter().any(|touch| slips(core, states, touch)) {
            continue;
        }
        let views = group.contacts.iter().map(|&index| views[index]).collect();
        let group = Group { core, states, bodies: &group.bodies, touches: &members, views };
        group.narrow(&mut stability).map_err(refused)?;
    }
    Ok(stability)
}

/// The contact of a view.
fn touch(core: &Core, states: &[BodyState], view: &ContactView) -> Option<Touch> {
    let id = ContactId { a: view.body_a.index(), b: view.body_b.index(), feature: Feature::Shapes(view.feature) };
    Some(Touch::held(id, contact_kinematics::kinematics(&core.model, states, id)?, ContactModes::default()))
}

fn is_at_rest(core: &Core, state: &BodyState, body: usize) -> bool {
    let is_still = state.linear_velocity == DVec3::ZERO && state.angular_momentum == DVec3::ZERO;
    core.model.bodies[body].moves() && is_still
}

/// Whether the surfaces of a contact move over each other: a belt, or a body that a motion carries.
fn slips(core: &Core, states: &[BodyState], touch: &Touch) -> bool {
    let limit = SLIP_RELATIVE * core.model.gravity().length().max(1.0);
    let tangential = contact_kinematics::tangential_kinematics(&core.model, states, touch.id);
    tangential.is_some_and(|terms| terms.slip_velocity.length() > limit)
        || touch.kinematics.separation_rate.abs() > limit
}

/// Directions across gravity: none without it.
fn directions(core: &Core) -> impl Iterator<Item = DVec3> + use<> {
    let down = core.model.gravity().try_normalize();
    let plane = core.model.planar.of_group(&core.model.movable);
    let axes = down.map(|down| {
        let along = if down.x.abs() < FRAC_1_SQRT_2 { DVec3::X } else { DVec3::Y };
        let first = along.reject_from(down).normalize_or_zero();
        [first, first.cross(down)]
    });
    let of = move |[first, second]: [DVec3; 2]| {
        DIRECTIONS.map(|[a, b]| first * a + second * b).into_iter().filter(move |direction| {
            plane.is_none_or(|plane| {
                let [x, y, _] = plane.coordinates(*direction, DVec3::ZERO);
                (libm::hypot(x, y) - 1.0).abs() < IN_PLANE
            })
        })
    };
    axes.into_iter().flat_map(of)
}

/// How far a structure is from moving, each found by programmes of its own.
struct Limits {
    friction: Option<Limit>,
    /// Of the loads, in their order.
    loads: Vec<Option<Limit>>,
}

impl Limits {
    /// Of the friction of a structure, and of these loads.
    fn found(structure: &Structure<'_>, loads: &[Vec<f64>], executor: &dyn Executor) -> Result<Self, ResponseError> {
        let mut friction = Ok(None);
        let mut limits: Vec<Result<Option<Limit>, ResponseError>> = loads.iter().map(|_| Ok(None)).collect();
        // The first takes longest.
        let mut tasks: Vec<Task<'_>> = vec![Box::new(|| friction = structure.friction_limit())];
        for (limit, live) in limits.iter_mut().zip(loads) {
            tasks.push(Box::new(|| *limit = structure.load_limit(live)));
        }
        executor.run(tasks);
        Ok(Self { friction: friction?, loads: limits.into_iter().collect::<Result<_, _>>()? })
    }
}

/// Bodies at rest that hold each other.
struct Group<'a> {
    core: &'a Core,
    states: &'a [BodyState],
    bodies: &'a [usize],
    touches: &'a [Touch],
    /// The contacts with the forces that the run has found.
    views: Vec<&'a ContactView>,
}

impl Group<'_> {
    /// Takes the margins of this group where they are narrower.
    fn narrow(self, stability: &mut Stability) -> Result<(), ResponseError> {
        let (model, states) = (&self.core.model, self.states);
        let frictional: Vec<_> =
            self.touches.iter().map(|touch| FrictionalContact::of_touch(model, states, touch)).collect();
        let rows = self.touches.iter().map(|touch| (touch.id, touch.kinematics.geometry));
        let mut assembly = Assembly::new(model, states, self.bodies, rows)?;
        let blocks = blocks_of(&mut assembly, states, &frictional)?;
        let loads = model.loads_on(self.core.t, states, self.bodies);
        let free = assembly.free_accelerations(model, states, &loads);
        let near = self.known_forces(&assembly, &frictional);
        let structure = Structure::new(&assembly.problem, &blocks, &free, &near)?;
        stability.bodies += self.bodies.len();
        stability.contacts += self.touches.len();
        // Where the analysis finds no forces and the run has some the bodies stand by rounding, at the very limit.
        let is_certified = is_balanced(&assembly, &free, &near)?;
        let lives: Vec<Vec<f64>> = (stability.pushes.iter())
            .map(|push| assembly.uniform_accelerations(push.direction * model.gravity().length()))
            .collect();
        let Limits { friction, loads } = Limits::found(&structure, &lives, self.core.executor.as_ref())?;
        let needed = match friction.as_ref().map(|limit| limit.factor) {
            Some(needed) if needed <= 1.0 => Some(needed),
            _ if is_certified => Some(1.0),
            needed => needed,
        };
        let stands = needed.is_some_and(|needed| needed <= 1.0);
        if is_above(needed, stability.friction.needed) {
            // What no friction holds has no limit.
            let begins = friction.map_or_else(|| structure.collapse(), |limit| Ok(Some(limit)))?;
            let begins = begins.map_or_else(Vec::new, |limit| self.begins(&assembly, &limit));
            stability.friction = FrictionMargin { needed, begins };
        }
        for (push, limit) in stability.pushes.iter_mut().zip(loads) {
            // What cannot stand bears no push, though one might hold it; a push against which everything is wedged has
            // no limit.
            let factor = limit.as_ref().map_or(0.0, |limit| limit.factor.max(0.0));
            let of_weight = stands.then_some(factor);
            let is_wedged = of_weight.is_some_and(|factor| factor >= WEDGED_PART * MOST_FACTOR);
            if !is_wedged && is_below(of_weight, push.of_weight) {
                let begins = limit.map_or_else(Vec::new, |limit| self.begins(&assembly, &limit));
                *push = PushMargin { direction: push.direction, of_weight, begins };
            }
        }
        Ok(())
    }

    /// The forces that the run has found, in the order of the rows, N; zero where they are not known.
    fn known_forces(&self, assembly: &Assembly, frictional: &[Option<FrictionalContact>]) -> Vec<f64> {
        let known = |force: f64| if force.is_finite() { force } else { 0.0 };
        let mut forces = vec![0.0; assembly.problem.len()];
        let mut first = assembly.first_tangent();
        for (normal, (view, friction)) in self.views.iter().zip(frictional).enumerate() {
            forces[normal] = known(view.normal_force_n);
            for tangent in friction.iter().flat_map(FrictionalContact::tangents) {
                forces[first] = known(view.friction_n.dot(tangent));
                first += 1;
            }
        }
        forces
    }

    /// The bodies that move in a mechanism, the fastest first.
    fn begins(&self, assembly: &Assembly, limit: &Limit) -> Vec<MovingBody> {
        let motions = assembly.split(&limit.mechanism);
        in_motion(self.core, motions.map(|(body, linear, angular)| (body, Velocity::new(linear, angular))))
    }
}

/// The bodies of a motion, the fastest first, without those that hardly belong to it.
pub(crate) fn in_motion(core: &Core, motions: impl Iterator<Item = (usize, Velocity)>) -> Vec<MovingBody> {
    let mut moving: Vec<MovingBody> = motions
        .map(|(body, velocity)| {
            let Velocity { linear, angular } = velocity;
            let turning = 0.5 * core.model.bodies[body].size * angular.length();
            let beginning =
                if turning > MOVES_RELATIVE * linear.length() { Beginning::Tips } else { Beginning::Slides };
            let speed = linear.length().max(turning);
            let direction = linear.try_normalize().filter(|_| linear.length() > MOVES_RELATIVE * speed);
            MovingBody { body: BodyId::new(body), beginning, speed, direction, velocity }
        })
        .collect();
    let fastest = moving.iter().fold(0.0, |most: f64, body| most.max(body.speed));
    moving.retain(|body| body.speed > MOVES_RELATIVE * fastest);
    for body in &mut moving {
        body.speed /= fastest;
        body.velocity = Velocity::new(body.velocity.linear / fastest, body.velocity.angular / fastest);
    }
    moving.sort_by(|a, b| b.speed.total_cmp(&a.speed));
    moving
}

/// Whether forces hold all bodies: what they leave is rounding of the largest acceleration without them.
fn is_balanced(assembly: &Assembly, free: &[f64], forces: &[f64]) -> Result<bool, ResponseError> {
    let largest = |of: &[f64]| of.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let mut left = assembly.problem.response(forces)?;
    left.iter_mut().zip(free).for_each(|(left, free)| *left += free);
    Ok(largest(&left) <= HOLDING_RELATIVE * largest(free))
}

/// What forces may leave of accelerations where bodies are held (no unit, 1e-10 to 1e-7).
const HOLDING_RELATIVE: f64 = 1e-9;

/// From this part of the largest factor on bodies count as wedged (no unit): the tolerance of the analysis.
const WEDGED_PART: f64 = 0.99;

/// Whether more friction is needed: none at all counts as most.
fn is_above(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => one > other,
        (None, Some(_)) => true,
        (_, None) => false,
    }
}

/// Whether less is borne: nothing at all counts as least.
fn is_below(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => one < other,
        (None, Some(_)) => true,
        (_, None) => false,
    }
}
