//! One body of the model: mass properties, shape and prescribed motion in its moving frame.

use crate::model::pivot_form::{HeldPoint, PivotForm};
use crate::model::prescribed_state;
use crate::scene::{Body, Geometry, SceneError, Trajectory};
use polhode_contact::{Shape, ShapeError};
use polhode_dynamics::{BodyState, RigidBody};
use polhode_mesh::{SolidMesh, convexity};
use polhode_spatial::{DVec3, MassProperties, Pose};

/// A body of the model.
#[derive(Debug, Clone)]
// The fields that samples and ledgers read of every body come first and are next to each other in memory.
#[repr(C)]
pub(crate) struct ModelBody {
    /// Whether a program has removed the body. Its index is kept so that other bodies keep theirs.
    pub(crate) removed: bool,
    /// Largest extent of the body, m; zero for a half-space.
    pub(crate) size: f64,
    /// `p_BC`: origin of the moving frame in the body's own frame, m.
    pub(crate) origin: DVec3,
    /// The point of the body that constraint rows hold at a pivot, if any.
    pub(crate) held: Option<HeldPoint>,
    /// Centre of mass at the start, world, m.
    pub(super) start: DVec3,
    /// Mass properties; none for a fixed or kinematic body.
    pub(crate) rigid: Option<RigidBody>,
    /// Shape in the moving frame.
    pub(crate) shape: Option<Shape>,
    /// Prescribed motion of the moving frame; none unless the body is kinematic.
    pub(crate) trajectory: Option<Trajectory>,
    pub(crate) name: String,
}

impl ModelBody {
    /// The body of a scene, with its pivot treated in this form; a mesh gets a shape only if the body may collide.
    ///
    /// # Errors
    /// When its shape cannot be expressed in its moving frame.
    pub(super) fn new(body: &Body, form: PivotForm, may_collide: impl Fn() -> bool) -> Result<Self, SceneError> {
        let refused = |source| SceneError::Shape { body: body.name().to_owned(), source };
        let center_of_mass = body.mass_properties().map_or(DVec3::ZERO, MassProperties::center_of_mass);
        let held = HeldPoint::of(body).filter(|_| form == PivotForm::Rows);
        let pivot = body.pivot_point().filter(|_| form == PivotForm::Reduced);
        let pivot = pivot.map(|point| body.initial_pose().inverse_transform_point(point));
        let origin = pivot.unwrap_or(center_of_mass);
        let shape = match body.shape() {
            Some(Geometry::Shape(shape)) => Some(shape.translated(-origin).map_err(refused)?),
            Some(Geometry::Mesh(mesh)) if may_collide() => {
                Some(colliding(mesh, body.is_fixed()).and_then(|shape| shape.translated(-origin)).map_err(refused)?)
            }
            Some(Geometry::Mesh(_)) | None => None,
        };
        Ok(Self {
            name: body.name().to_owned(),
            rigid: body.mass_properties().map(|properties| match pivot {
                Some(pivot) => RigidBody::pivoted(properties, pivot),
                None => RigidBody::new(properties),
            }),
            start: (*body.initial_pose()).transform_point(center_of_mass),
            trajectory: body.trajectory(),
            size: size_of(body, shape.as_ref()),
            shape,
            origin,
            held,
            removed: false,
        })
    }

    /// The state in which the scene gives the body, at `t` (s): prescribed motions are functions of the time of the
    /// run.
    pub(super) fn state_at(&self, body: &Body, t: f64) -> BodyState {
        let pose = *body.initial_pose() * Pose::from_translation(self.origin);
        match (&self.rigid, &self.trajectory) {
            (Some(rigid), _) => {
                let given = *body.initial_velocity();
                rigid.at_velocity(pose, self.held.map_or(given, |held| held.velocity_of_rotation(&pose, given.angular)))
            }
            (None, Some(trajectory)) => prescribed_state::state_at(trajectory, t),
            (None, None) => BodyState::at_rest(pose),
        }
    }

    /// Whether forces can move the body.
    pub(crate) fn moves(&self) -> bool {
        self.rigid.is_some() && !self.removed
    }
}

/// The shape that represents a solid mesh in collisions: its convex parts, or its surface when no force moves it and it
/// is not convex.
fn colliding(mesh: &SolidMesh, is_fixed: bool) -> Result<Shape, ShapeError> {
    if !is_fixed || convexity(mesh).is_convex() {
        return Shape::solid(mesh);
    }
    let mesh = mesh.mesh();
    Shape::triangle_mesh(mesh.vertices().to_vec(), mesh.triangles().to_vec())
}

/// Size of a body, m: that of its shape. For a point and for a body without a shape it is twice the largest radius of
/// gyration.
fn size_of(body: &Body, shape: Option<&Shape>) -> f64 {
    let size = shape.map_or(0.0, Shape::size);
    match body.mass_properties() {
        Some(properties) if size == 0.0 => 2.0 * (properties.principal_axes().moments().z / properties.mass()).sqrt(),
        _ => size,
    }
}
