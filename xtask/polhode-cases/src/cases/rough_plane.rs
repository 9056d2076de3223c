//! What the cases of friction share: a rough plane, level or inclined, bodies on it, and thresholds.
//!
//! Directions of a plane: x downhill, y level, z its outward normal.

use super::bodies::cuboid;
use super::run::Run;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::Material;
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity};
use polhode::{Acceleration, Body, BodySample, Effects, Scene, SceneBuilder, Simulation};
use std::error::Error;

/// Halvings of an interval in the search for a threshold: to the last bit.
const HALVINGS: usize = 60;

/// A body of a scene at rest whose points accelerate by less than this is in equilibrium, m/s^2. Rounding errors are
/// some 1e-14.
const EQUILIBRIUM: f64 = 1e-10;

/// A material of this coefficient of friction, static and kinetic. Two materials combine to the geometric mean.
pub(super) fn rough(friction: f64) -> Result<Material, Box<dyn Error>> {
    Ok(Material::new(format!("mu = {friction}")).with_friction(friction)?)
}

/// A plane through the origin.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    /// Turns the plane's directions into the world's.
    turn: Rotation,
}

impl Plane {
    /// The level plane z = 0.
    pub(super) const LEVEL: Self = Self { turn: Rotation::IDENTITY };

    /// A plane at this angle (rad) to the level one, downhill along x.
    pub(crate) fn inclined(angle: f64) -> Self {
        Self { turn: Rotation::from_rotation_vector(DVec3::Y * angle) }
    }

    /// The same turned about the vertical by this angle, rad.
    pub(super) fn turned(self, azimuth: f64) -> Self {
        Self { turn: Rotation::from_rotation_vector(DVec3::Z * azimuth) * self.turn }
    }

    /// A vector given in the plane's directions, world.
    pub(crate) fn world(self, vector: DVec3) -> DVec3 {
        self.turn.rotate(vector)
    }

    /// A vector of the world in the plane's directions.
    pub(super) fn local(self, vector: DVec3) -> DVec3 {
        self.turn.inverse_rotate(vector)
    }

    /// The half-space below the plane.
    pub(super) fn ground(self, friction: f64) -> Result<Body, Box<dyn Error>> {
        let shape = Shape::half_space(UnitVector::new(self.world(DVec3::Z))?);
        Ok(Body::fixed("ground").geometry(shape.into()).material(rough(friction)?))
    }

    /// Sets a body on the plane: `pose` and `velocity` are given in the plane's directions.
    pub(super) fn place(self, body: Body, pose: Pose, velocity: Velocity) -> Body {
        body.pose(Pose::new(self.turn * pose.rotation, self.world(pose.translation)))
            .velocity(Velocity::new(self.world(velocity.linear), self.world(velocity.angular)))
    }

    /// A scene of the ground and one body on it, with this coefficient between them.
    pub(super) fn with(self, body: Body, friction: f64) -> Result<SceneBuilder, Box<dyn Error>> {
        Ok(Scene::builder("body on a rough plane").body(body.material(rough(friction)?)).body(self.ground(friction)?))
    }

    /// A box of 1 kg that lies on the plane, turned by `heading` (rad) about its normal, with this velocity.
    pub(super) fn lying_box(self, size: DVec3, heading: f64, velocity: DVec3) -> Result<Body, Box<dyn Error>> {
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::Z * heading), DVec3::Z * (0.5 * size.z));
        Ok(self.place(cuboid("box", size, 1.0, DVec3::ZERO)?, pose, Velocity::new(velocity, DVec3::ZERO)))
    }

    /// A body on the plane that is round in a vertical plane: its centre stands one radius above its contact.
    pub(super) fn round(self, body: Body, radius: f64, velocity: Velocity) -> Body {
        self.place(body, Pose::from_translation(DVec3::Z * radius), velocity)
    }
}

/// A solid sphere of 1 kg.
pub(super) fn sphere(radius: f64) -> Result<Body, Box<dyn Error>> {
    let shape = Shape::sphere(radius)?;
    Ok(Body::movable("ball", solid_sphere(radius, Mass::new(1.0)?)?).geometry(shape.into()))
}

/// A sphere of 1 kg of which any moment about the centre is `inertia`, kg m^2.
pub(super) fn sphere_of_inertia(radius: f64, inertia: f64) -> Result<Body, Box<dyn Error>> {
    let moments = Inertia::from_diagonal(DVec3::splat(inertia))?;
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, moments);
    Ok(Body::movable("ball", properties).geometry(Shape::sphere(radius)?.into()))
}

/// The acceleration of the first body at the start.
pub(super) fn first_acceleration(scene: &Scene) -> Result<Acceleration, Box<dyn Error>> {
    let accelerations = Simulation::new(scene)?.accelerations()?;
    Ok(*accelerations.first().ok_or("the scene has no body")?)
}

/// Whether no body of a scene accelerates at the start.
pub(super) fn is_in_equilibrium(scene: &Scene) -> Result<bool, Box<dyn Error>> {
    let accelerations = Simulation::new(scene)?.accelerations()?;
    Ok(accelerations.iter().all(|a| a.linear.length() <= EQUILIBRIUM && a.angular.length() <= EQUILIBRIUM))
}

/// The parameter at which a property of scenes changes, to its last bit; it must hold at `with` and not at `without`.
pub(super) fn threshold(
    with: f64,
    without: f64,
    mut has: impl FnMut(f64) -> Result<bool, Box<dyn Error>>,
) -> Result<f64, Box<dyn Error>> {
    let ends = [has(with)?, has(without)?];
    if ends != [true, false] {
        return Err(format!("the property at {with} and {without}: {ends:?}").into());
    }
    let (mut with, mut without) = (with, without);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (with + without);
        if has(middle)? {
            with = middle;
        } else {
            without = middle;
        }
    }
    Ok(0.5 * (with + without))
}

/// The times at which steps of a run ended at events, with the states of the first body there.
pub(super) fn events_of(scene: &Scene) -> Result<Vec<(f64, BodySample)>, Box<dyn Error>> {
    let mut simulation = Simulation::new(scene)?;
    let mut found = Vec::new();
    while simulation.time() < scene.duration_s() {
        let outcome = simulation.step()?;
        if outcome.is_event() {
            found.push((outcome.t_s, *simulation.bodies().first().ok_or("the scene has no body")?));
        }
    }
    Ok(found)
}

/// The first event of a run after which the first body is as described, s, and its state there.
pub(super) fn first_event(
    scene: &Scene,
    is_meant: impl Fn(&BodySample) -> bool,
) -> Result<(f64, BodySample), Box<dyn Error>> {
    let found = events_of(scene)?.into_iter().find(|(_, sample)| is_meant(sample));
    found.ok_or_else(|| "no such event".into())
}

/// The last state of the first body.
pub(super) fn end_of(scene: &Scene) -> Result<BodySample, Box<dyn Error>> {
    let run = Run::of(scene, Effects::Planned)?;
    Ok(run.report.bodies.first().ok_or("the scene has no body")?.state)
}
