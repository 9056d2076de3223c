//! Forces on bodies besides uniform gravity and contact.
//!
//! A scene names bodies by their handles, and points in the bodies' own frames. The engine makes fields
//! ([`polhode_dynamics::field`]) from the forces once the moving frames of the bodies are known. A spring that is
//! fastened to a fixed body is anchored in the world; any other force on a fixed body has no effect.

use super::{Body, Integrator, SceneError};
use crate::identity::body_id::BodyId;
use polhode_dynamics::field::{
    Account, Anchor, AppliedForce, AppliedTorque, Damper, Dependence, Drag, DragLaw, Field, FieldError, ForceResponse,
    Frame, MutualGravity, PointGravity, Signal, Spring, Wrench,
};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::DVec3;
use std::sync::Arc;

/// The point at which an end of a spring is fastened.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Attachment {
    /// At a point of the world, m.
    World(DVec3),
    /// At a point of a body.
    Body {
        /// The body.
        body: BodyId,
        /// `p_BQ`, m, in the body's own frame.
        point: DVec3,
    },
}

/// A force on one body, all bodies, or between two.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Force {
    /// Attraction of every body by a fixed point: `mu/d^2` (m/s^2).
    PointGravity {
        /// The point, m, world.
        center: DVec3,
        /// Gravitational parameter G M, m^3/s^2.
        mu: f64,
    },
    /// Attraction between the centres of mass of all pairs of movable bodies.
    MutualGravity {
        /// The gravitational constant, m^3/(kg s^2).
        constant: f64,
    },
    /// A force and a torque on one body, constant or varying by a signal.
    Applied {
        /// The body.
        body: BodyId,
        /// Force, N.
        force: DVec3,
        /// Torque, N m.
        torque: DVec3,
        /// The axes in which force and torque are given: the world's or the body's.
        frame: Frame,
        /// Where the force acts, `p_BQ`, m, in the body's own frame; the centre of mass when absent.
        point: Option<DVec3>,
        /// Factor of force and torque, as a function of time.
        signal: Signal,
    },
    /// Drag on one body by a medium.
    Drag {
        /// The body.
        body: BodyId,
        /// Linear or quadratic in the velocity.
        law: DragLaw,
        /// Coefficient of translation: N s/m, or N s^2/m^2.
        translational: f64,
        /// Coefficient of rotation: N m s, or N m s^2.
        rotational: f64,
        /// Velocity of the medium, m/s, world.
        wind: DVec3,
    },
    /// A spring with a damper along it.
    Spring {
        /// One end.
        a: Attachment,
        /// The other end.
        b: Attachment,
        /// Stiffness, N/m.
        stiffness: f64,
        /// Length without force, m.
        rest_length: f64,
        /// Damping coefficient, N s/m.
        damping: f64,
    },
    /// A field that the program defines, over the movable bodies in the order of the scene.
    Field(Arc<dyn Field>),
}

/// What a force needs to know about the moving frames of the bodies.
pub(crate) trait MovingFrames {
    /// Slot of a body: its place among the movable ones; none for a fixed or kinematic body.
    fn movable(&self, body: usize) -> Option<usize>;
    /// Whether a body has not been removed.
    fn is_there(&self, body: usize) -> bool;
    /// Slots of the bodies that have been removed, ascending.
    fn removed(&self) -> Vec<usize>;
    /// A point given in a body's own frame, in its moving frame (origin at the centre of mass or the pivot).
    fn in_moving_frame(&self, body: usize, point: DVec3) -> DVec3;
    /// A point given in a fixed body's own frame, in the world.
    fn in_world(&self, body: usize, point: DVec3) -> DVec3;
}

impl Force {
    /// The fields that make up the force; none when a body that it names has been removed.
    ///
    /// # Errors
    /// When a number is out of range.
    pub(crate) fn fields(&self, frames: &impl MovingFrames) -> Result<Vec<Box<dyn Field>>, FieldError> {
        let mut fields: Vec<Box<dyn Field>> = Vec::new();
        if self.bodies().into_iter().any(|body| !frames.is_there(body)) {
            return Ok(fields);
        }
        match self {
            Self::PointGravity { center, mu } => {
                fields.push(Box::new(PointGravity::new(*mu, *center)?.without(frames.removed())));
            }
            Self::MutualGravity { constant } => {
                fields.push(Box::new(MutualGravity::new(*constant)?.without(frames.removed())));
            }
            Self::Applied { body, force, torque, frame, point, signal } => {
                let Some(index) = frames.movable(body.index()) else { return Ok(fields) };
                let mut push = AppliedForce::new(index, *force, *frame)?.following(signal.clone());
                if let Some(point) = point {
                    push = push.at_point(frames.in_moving_frame(body.index(), *point))?;
                }
                let turn = AppliedTorque::new(index, *torque, *frame)?.following(signal.clone());
                if *force != DVec3::ZERO {
                    fields.push(Box::new(push));
                }
                if *torque != DVec3::ZERO {
                    fields.push(Box::new(turn));
                }
            }
            Self::Drag { body, law, translational, rotational, wind } => {
                let Some(index) = frames.movable(body.index()) else { return Ok(fields) };
                let mut drag = Drag::new(index, *law, *translational, *rotational)?;
                if *wind != DVec3::ZERO {
                    drag = drag.in_wind(*wind)?;
                }
                fields.push(Box::new(drag));
            }
            Self::Spring { a, b, stiffness, rest_length, damping } => {
                let (a, b) = (a.anchor(frames), b.anchor(frames));
                fields.push(Box::new(Spring::new(a, b, *stiffness, *rest_length)?));
                let damper = Damper::new(a, b, *damping)?;
                if *damping > 0.0 {
                    fields.push(Box::new(damper));
                }
            }
            Self::Field(field) => fields.push(Box::new(Shared(Arc::clone(field)))),
        }
        Ok(fields)
    }

    /// Whether the force may change with time while all bodies rest.
    pub(crate) fn changes_with_time(&self) -> bool {
        match self {
            Self::Applied { signal, .. } => !signal.is_constant(),
            // A field that depends on velocities may depend on time too.
            Self::Field(field) => field.dependence() != Dependence::Poses,
            Self::PointGravity { .. } | Self::MutualGravity { .. } | Self::Drag { .. } | Self::Spring { .. } => false,
        }
    }

    /// The first kinematic body that the force names.
    fn kinematic_body<'a>(&self, bodies: &'a [Body]) -> Option<&'a Body> {
        self.bodies().into_iter().filter_map(|body| bodies.get(body)).find(|body| body.motion().is_some())
    }

    /// The bodies that the force names.
    fn bodies(&self) -> Vec<usize> {
        match self {
            Self::Applied { body, .. } | Self::Drag { body, .. } => vec![body.index()],
            Self::Spring { a, b, .. } => [a, b].iter().filter_map(|end| end.body()).collect(),
            Self::PointGravity { .. } | Self::MutualGravity { .. } | Self::Field(_) => Vec::new(),
        }
    }
}

impl Attachment {
    fn body(&self) -> Option<usize> {
        match self {
            Self::World(_) => None,
            Self::Body { body, .. } => Some(body.index()),
        }
    }

    fn anchor(&self, frames: &impl MovingFrames) -> Anchor {
        match *self {
            Self::World(point) => Anchor::World(point),
            Self::Body { body, point } => match frames.movable(body.index()) {
                Some(index) => Anchor::Body { body: index, point: frames.in_moving_frame(body.index(), point) },
                None => Anchor::World(frames.in_world(body.index(), point)),
            },
        }
    }
}

/// Checks force number `number` against the bodies of its scene.
///
/// # Errors
/// When it names a body that does not exist, a number is out of range, or a spring is fastened to a kinematic body.
pub(super) fn check(number: usize, force: &Force, bodies: &[Body]) -> Result<(), SceneError> {
    if let Some(body) = force.bodies().into_iter().find(|&body| body >= bodies.len()) {
        return Err(SceneError::ForceOnUnknownBody { force: number, body });
    }
    if let (Force::Spring { .. }, Some(body)) = (force, force.kinematic_body(bodies)) {
        // The anchor would have to follow the motion, and the potential energy would be a function of time.
        return Err(SceneError::NotYetAvailable {
            what: format!("a spring fastened to a kinematic body ({})", body.name()),
            instead: "a spring fastened to the world or to a body that forces move".to_owned(),
        });
    }
    force.fields(&OwnFrames).map(|_| ()).map_err(|source| SceneError::Force { force: number, source })
}

/// Checks that the integrator which the scene names can integrate its forces.
///
/// # Errors
/// When a force depends on velocities and the integrator splits forces from motion.
pub(super) fn check_integrator(integrator: Option<Integrator>, forces: &[Force]) -> Result<(), SceneError> {
    let fields = forces.iter().filter_map(|force| force.fields(&OwnFrames).ok()).flatten();
    let dependence = fields.map(|field| field.dependence()).max().unwrap_or(Dependence::Poses);
    match integrator {
        Some(integrator) if !integrator.takes(dependence) => {
            Err(SceneError::IntegratorTakesNoVelocities { integrator: integrator.name() })
        }
        _ => Ok(()),
    }
}

/// Frames for the check of a force's numbers: every body is movable, and its moving frame is its own.
struct OwnFrames;

impl MovingFrames for OwnFrames {
    fn movable(&self, body: usize) -> Option<usize> {
        Some(body)
    }

    fn is_there(&self, _body: usize) -> bool {
        true
    }

    fn removed(&self) -> Vec<usize> {
        Vec::new()
    }

    fn in_moving_frame(&self, _body: usize, point: DVec3) -> DVec3 {
        point
    }

    fn in_world(&self, _body: usize, point: DVec3) -> DVec3 {
        point
    }
}

/// A field that several copies of a scene share.
#[derive(Debug)]
struct Shared(Arc<dyn Field>);

impl Field for Shared {
    fn dependence(&self) -> Dependence {
        self.0.dependence()
    }

    fn account(&self) -> Account {
        self.0.account()
    }

    fn acts_on(&self, body: usize) -> bool {
        self.0.acts_on(body)
    }

    fn bodies(&self) -> Option<Vec<usize>> {
        self.0.bodies()
    }

    fn turns(&self, body: usize) -> bool {
        self.0.turns(body)
    }

    fn couples(&self) -> bool {
        self.0.couples()
    }

    fn corner_between(&self, from: f64, to: f64) -> Option<f64> {
        self.0.corner_between(from, to)
    }

    fn add_wrenches(&self, t: f64, bodies: &[RigidBody], states: &[BodyState], wrenches: &mut [Wrench]) {
        self.0.add_wrenches(t, bodies, states, wrenches);
    }

    fn responses(&self, bodies: &[RigidBody], states: &[BodyState]) -> Option<Vec<ForceResponse>> {
        self.0.responses(bodies, states)
    }

    fn potential_energy(&self, bodies: &[RigidBody], states: &[BodyState]) -> f64 {
        self.0.potential_energy(bodies, states)
    }
}
