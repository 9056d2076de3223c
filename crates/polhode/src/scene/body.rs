//! Bodies of a scene.

use super::{ApproximateParts, Geometry, Material, PrescribedMotion, SceneError, Trajectory};
use polhode_contact::Shape;
use polhode_spatial::rounding;
use polhode_spatial::{DVec3, MassProperties, Pose, Velocity};

/// Whether and how a body moves.
#[derive(Debug, Clone, PartialEq)]
pub enum BodyMass {
    /// Immovable: it has infinite mass (thesis 3.3), so that no impact moves it.
    Fixed,
    /// Moved as prescribed: it has infinite mass, so that no impact changes its motion.
    Kinematic(PrescribedMotion),
    /// Moved by forces, with these mass properties in the body's own frame.
    Movable(MassProperties),
}

/// A body: name, mass, shape, material, initial pose and initial velocity.
///
/// `pose` is that of the body's own origin (a primitive's origin is its centre of mass, a mesh's is the file's);
/// `velocity` is that of the centre of mass, in the world. A kinematic body is given neither a mass nor a velocity: its
/// [`Body::trajectory`] determines its pose and velocity at any time.
#[derive(Debug, Clone)]
pub struct Body {
    pub(crate) name: String,
    pub(crate) mass: BodyMass,
    pub(crate) geometry: Option<Geometry>,
    pub(crate) pose: Pose,
    pub(crate) velocity: Velocity,
    pub(crate) material: Material,
    pub(crate) pivot: Option<DVec3>,
    pub(crate) surface_velocity: DVec3,
    pub(crate) approximation: Option<ApproximateParts>,
}

impl Body {
    /// An immovable body at the world's origin, without a shape.
    pub fn fixed(name: impl Into<String>) -> Self {
        Self::with_mass(name.into(), BodyMass::Fixed)
    }

    /// A kinematic body: its pose is prescribed as a function of time, and no force changes it. It has no shape yet.
    ///
    /// A constant velocity and a sine start from the pose given by [`Body::pose`]. A table gives the poses themselves;
    /// a pose that is given as well must be that of the table at t = 0.
    pub fn kinematic(name: impl Into<String>, motion: PrescribedMotion) -> Self {
        let pose = motion.initial_pose(&Pose::IDENTITY);
        Self { pose, ..Self::with_mass(name.into(), BodyMass::Kinematic(motion)) }
    }

    /// A body that forces move, at rest at the world's origin, without a shape.
    pub fn movable(name: impl Into<String>, mass_properties: MassProperties) -> Self {
        Self::with_mass(name.into(), BodyMass::Movable(mass_properties))
    }

    fn with_mass(name: String, mass: BodyMass) -> Self {
        Self {
            name,
            mass,
            geometry: None,
            pose: Pose::IDENTITY,
            velocity: Velocity::ZERO,
            material: Material::default(),
            pivot: None,
            surface_velocity: DVec3::ZERO,
            approximation: None,
        }
    }

    /// With another name.
    pub fn renamed(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// With this shape.
    pub fn geometry(mut self, geometry: Geometry) -> Self {
        self.geometry = Some(geometry);
        self
    }

    /// Held at this point of the world (m), about which it can only turn, as a top or a pendulum does. The angular
    /// velocity determines the velocity of the centre of mass, which need not be given.
    pub fn pivot(mut self, point: DVec3) -> Self {
        self.pivot = Some(point);
        self
    }

    /// With its own origin at this pose in the world.
    pub fn pose(mut self, pose: Pose) -> Self {
        self.pose = pose;
        self
    }

    /// With this velocity of its centre of mass and this angular velocity, in the world.
    pub fn velocity(mut self, velocity: Velocity) -> Self {
        self.velocity = velocity;
        self
    }

    /// Made of this material.
    pub fn material(mut self, material: Material) -> Self {
        self.material = material;
        self
    }

    /// What it is made of.
    pub const fn made_of(&self) -> &Material {
        &self.material
    }

    /// With a surface that moves at this velocity (m/s, frame of the body) while its shape does not: a belt, the tracks
    /// of a vehicle. At a contact its part in the tangent plane counts, and only friction feels it.
    pub fn surface_velocity(mut self, velocity: DVec3) -> Self {
        self.surface_velocity = velocity;
        self
    }

    /// With a shape that only approximates the solid that its mass fills.
    pub fn approximated(mut self, approximation: ApproximateParts) -> Self {
        self.approximation = Some(approximation);
        self
    }

    /// How well its shape fills the solid that its mass fills, where it does so approximately.
    pub fn approximation(&self) -> Option<&ApproximateParts> {
        self.approximation.as_ref()
    }

    /// The velocity of its surface over its shape, m/s, in the frame of the body.
    pub fn velocity_of_surface(&self) -> DVec3 {
        self.surface_velocity
    }

    /// The point of the world at which the body is held, m.
    pub fn pivot_point(&self) -> Option<DVec3> {
        self.pivot
    }

    /// The body's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether no force moves the body: it is fixed or kinematic.
    pub fn is_fixed(&self) -> bool {
        matches!(self.mass, BodyMass::Fixed | BodyMass::Kinematic(_))
    }

    /// The motion of a kinematic body.
    pub fn motion(&self) -> Option<&PrescribedMotion> {
        match &self.mass {
            BodyMass::Kinematic(motion) => Some(motion),
            BodyMass::Fixed | BodyMass::Movable(_) => None,
        }
    }

    /// The motion of a kinematic body with its initial pose: the pose at any time.
    pub fn trajectory(&self) -> Option<Trajectory> {
        self.motion().map(|motion| motion.from_pose(&self.pose))
    }

    /// Mass properties in the body's own frame, when forces move it.
    pub fn mass_properties(&self) -> Option<&MassProperties> {
        match &self.mass {
            BodyMass::Fixed | BodyMass::Kinematic(_) => None,
            BodyMass::Movable(properties) => Some(properties),
        }
    }

    /// The body's shape.
    pub fn shape(&self) -> Option<&Geometry> {
        self.geometry.as_ref()
    }

    /// `X_WB` at the start; for a kinematic body that oscillates, the centre of the oscillation.
    pub fn initial_pose(&self) -> &Pose {
        &self.pose
    }

    /// Velocity at the start: of the centre of mass, and angular, world.
    pub fn initial_velocity(&self) -> &Velocity {
        &self.velocity
    }

    /// Checks body number `number`: that its numbers are finite, and that its parts are consistent.
    ///
    /// # Errors
    /// As [`SceneBuilder::build`](super::SceneBuilder::build).
    pub(super) fn check(&self, number: usize) -> Result<(), SceneError> {
        if self.name.is_empty() {
            return Err(SceneError::EmptyName(number));
        }
        let not_finite = |quantity| Err(SceneError::NotFinite { body: self.name.clone(), quantity });
        if !self.pose.is_finite() {
            return not_finite("its pose");
        }
        if !self.velocity.is_finite() {
            return not_finite("its velocity");
        }
        if !self.surface_velocity.is_finite() {
            return not_finite("its surface velocity");
        }
        if let Some(motion) = self.motion() {
            return self.check_kinematic(motion);
        }
        if let Some(pivot) = self.pivot {
            self.check_pivot(pivot)?;
        }
        if self.is_fixed() && !self.velocity.is_zero() {
            return Err(SceneError::FixedBodyMoves(self.name.clone()));
        }
        match &self.geometry {
            Some(Geometry::Shape(Shape::HalfSpace(_))) if !self.is_fixed() => {
                Err(SceneError::MovingHalfSpace(self.name.clone()))
            }
            Some(Geometry::Shape(Shape::TriangleMesh(_))) if !self.is_fixed() => {
                Err(SceneError::MovingSurface(self.name.clone()))
            }
            _ => Ok(()),
        }
    }

    /// Checks that a kinematic body has no velocity and no pivot, and that its initial pose is that of its motion.
    fn check_kinematic(&self, motion: &PrescribedMotion) -> Result<(), SceneError> {
        if self.pivot.is_some() {
            return Err(SceneError::KinematicBodyPivots(self.name.clone()));
        }
        if !self.velocity.is_zero() {
            return Err(SceneError::KinematicBodyHasVelocity(self.name.clone()));
        }
        motion.check_start(&self.pose).map_err(|source| SceneError::Motion { body: self.name.clone(), source })
    }

    /// Checks a pivoted body: a velocity of the centre of mass, when it is given, must be the one that the angular
    /// velocity gives it about the pivot.
    fn check_pivot(&self, pivot: DVec3) -> Result<(), SceneError> {
        if !pivot.is_finite() {
            return Err(SceneError::NotFinite { body: self.name.clone(), quantity: "its pivot" });
        }
        let Some(properties) = self.mass_properties() else {
            return Err(SceneError::FixedBodyPivots(self.name.clone()));
        };
        let arm = self.pose.transform_point(properties.center_of_mass()) - pivot;
        let turning = self.velocity.angular.cross(arm);
        let difference = (self.velocity.linear - turning).length();
        if self.velocity.linear != DVec3::ZERO
            && difference > rounding::DIGITS_OF_A_FILE * self.velocity.angular.length() * arm.length()
        {
            let needed = turning.to_array();
            return Err(SceneError::PivotMoves { body: self.name.clone(), difference, needed });
        }
        Ok(())
    }
}
