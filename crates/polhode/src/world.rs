//! The scene as the engine sees it: bodies in their central frames.
//!
//! The central frame C of a body has the axes of the body and its origin at the centre of mass (thesis 3.2: "we can
//! offset all the values so that the origin is forced to coincide with the centre of mass"). Shapes are moved into it
//! once, here; results are moved back when they are sampled.

use crate::observer::BodySample;
use crate::scene::{Body, Geometry, Scene, SceneError};
use polhode_contact::Shape;
use polhode_dynamics::energy::potential_energy;
use polhode_dynamics::{BodyState, RigidBody};
use polhode_spatial::{CompensatedSum, DVec3, MassProperties, Pose};

/// Distance that counts as touch, relative to the size of the smaller body: contacts this close at an impact are
/// struck together (docs/ARCHITECTURE.md, "Tolerances").
pub(crate) const TOUCH_RELATIVE: f64 = 1e-11;

/// Overlap at the start that counts as touch and is moved out, relative to the size of the smaller body.
pub(crate) const INITIAL_OVERLAP_RELATIVE: f64 = 1e-9;

/// Units in the last place of the largest coordinate that rounding of poses may move a surface by.
const ROUNDING_ULPS: f64 = 8.0;

/// A body of the engine.
#[derive(Debug, Clone)]
pub(crate) struct WorldBody {
    pub(crate) name: String,
    /// Mass properties; none for a body that never moves.
    pub(crate) rigid: Option<RigidBody>,
    /// Shape in the central frame.
    pub(crate) shape: Option<Shape>,
    /// `p_BBcm`: centre of mass in the body's own frame, m.
    center_of_mass: DVec3,
    /// Centre of mass at the start, world, m.
    start: DVec3,
    /// Largest extent of the body, m; zero for a half-space.
    pub(crate) size: f64,
}

/// All bodies, and the scene they came from.
#[derive(Debug, Clone)]
pub(crate) struct World {
    pub(crate) scene: Scene,
    pub(crate) bodies: Vec<WorldBody>,
}

impl World {
    /// The engine's view of a scene, with the states of the bodies at t = 0.
    ///
    /// # Errors
    /// When a shape cannot be moved into its central frame.
    pub(crate) fn new(scene: &Scene) -> Result<(Self, Vec<BodyState>), SceneError> {
        let bodies = scene.bodies().iter().map(WorldBody::new).collect::<Result<Vec<_>, _>>()?;
        let states = scene.bodies().iter().zip(&bodies).map(|(body, world)| world.initial_state(body)).collect();
        Ok((Self { scene: scene.clone(), bodies }, states))
    }

    /// Acceleration of gravity, m/s^2.
    pub(crate) fn gravity(&self) -> DVec3 {
        self.scene.gravity()
    }

    /// Size that tolerances of a pair are relative to, m: that of the smaller of the two that has one.
    pub(crate) fn pair_size(&self, a: usize, b: usize) -> f64 {
        let (size_a, size_b) = (self.bodies[a].size, self.bodies[b].size);
        if size_a == 0.0 {
            size_b
        } else if size_b == 0.0 {
            size_a
        } else {
            size_a.min(size_b)
        }
    }

    /// Distance within which two bodies touch, m.
    pub(crate) fn touch_distance(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        TOUCH_RELATIVE * self.pair_size(a, b) + self.rounding(states, a, b)
    }

    /// What the rounding of two poses may move surfaces by, m.
    pub(crate) fn rounding(&self, states: &[BodyState], a: usize, b: usize) -> f64 {
        let coordinate = |i: usize| {
            let body = &self.bodies[i];
            // A fixed half-space far away moves nothing: only its plane matters, through the other body.
            if body.size == 0.0 { 0.0 } else { states[i].pose.translation.abs().max_element() + body.size }
        };
        ROUNDING_ULPS * f64::EPSILON * coordinate(a).max(coordinate(b))
    }

    /// A body's pose and velocity as they are reported.
    pub(crate) fn sample(&self, index: usize, state: &BodyState) -> BodySample {
        let body = &self.bodies[index];
        let velocity = body.rigid.as_ref().map_or_else(Default::default, |rigid| rigid.velocity(state));
        BodySample { pose: state.pose * Pose::from_translation(-body.center_of_mass), velocity }
    }

    /// Names of all bodies and their states as they are reported.
    pub(crate) fn named_samples(&self, states: &[BodyState]) -> Vec<(String, BodySample)> {
        let named = self.bodies.iter().zip(states).enumerate();
        named.map(|(index, (body, state))| (body.name.clone(), self.sample(index, state))).collect()
    }

    /// Kinetic energy of one body, and its potential energy against that at the start, J: far from the origin the
    /// potential itself would drown in its rounding.
    pub(crate) fn energies(&self, index: usize, state: &BodyState) -> (f64, f64) {
        let body = &self.bodies[index];
        body.rigid.as_ref().map_or((0.0, 0.0), |rigid| {
            let risen = state.pose.translation - body.start;
            (rigid.kinetic_energy(state), potential_energy(rigid.mass(), self.gravity(), risen))
        })
    }

    /// Potential energy of the scene at the start, J, zero at the world's origin.
    pub(crate) fn initial_potential(&self) -> f64 {
        let bodies = self.bodies.iter();
        let potentials =
            bodies.filter_map(|body| Some(potential_energy(body.rigid.as_ref()?.mass(), self.gravity(), body.start)));
        potentials.collect::<CompensatedSum>().value()
    }
}

impl WorldBody {
    fn new(body: &Body) -> Result<Self, SceneError> {
        let center_of_mass = body.mass_properties().map_or(DVec3::ZERO, MassProperties::center_of_mass);
        let shape = match body.shape() {
            Some(Geometry::Shape(shape)) => Some(
                shape
                    .translated(-center_of_mass)
                    .map_err(|source| SceneError::Shape { body: body.name().to_owned(), source })?,
            ),
            Some(Geometry::Mesh(_)) | None => None,
        };
        Ok(Self {
            name: body.name().to_owned(),
            rigid: body.mass_properties().map(RigidBody::new),
            start: (*body.initial_pose()).transform_point(center_of_mass),
            size: size_of(body, shape.as_ref()),
            shape,
            center_of_mass,
        })
    }

    fn initial_state(&self, body: &Body) -> BodyState {
        let pose = *body.initial_pose() * Pose::from_translation(self.center_of_mass);
        match &self.rigid {
            Some(rigid) => rigid.at_velocity(pose, *body.initial_velocity()),
            None => BodyState::at_rest(pose),
        }
    }

    /// Whether the body can move.
    pub(crate) fn moves(&self) -> bool {
        self.rigid.is_some()
    }
}

/// Size of a body, m: of its shape, or, for a point and for a body without a shape, twice its radius of gyration.
fn size_of(body: &Body, shape: Option<&Shape>) -> f64 {
    let size = shape.map_or(0.0, Shape::size);
    match body.mass_properties() {
        Some(properties) if size == 0.0 => 2.0 * (properties.principal_axes().moments().z / properties.mass()).sqrt(),
        _ => size,
    }
}
