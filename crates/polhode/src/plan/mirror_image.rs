//! How far a body is from being its own mirror image in a plane: its motion, its mass and its shape.
//!
//! Assumption: a shape is measured by [`mirror_defect`]; one that it does not know has an infinite defect.

use crate::collision::moving_surfaces;
use crate::model::Model;
use polhode_contact::{Shape, is_prism_along, mirror_defect};
use polhode_dynamics::BodyState;
use polhode_spatial::{DVec3, UnitVector};

/// Largest defect of symmetry, relative to the size of the quantity measured: the rounding of poses and mass
/// properties.
pub(super) const SYMMETRY_RELATIVE: f64 = 32.0 * f64::EPSILON;

/// The largest defect of symmetry of a body in a plane.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Defect {
    pub(super) relative: f64,
    what: String,
}

impl std::fmt::Display for Defect {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} (relative defect {:.1e}, limit {:.1e})", self.what, self.relative, SYMMETRY_RELATIVE)
    }
}

impl Defect {
    /// That of gravity.
    pub(super) fn of_gravity(gravity: DVec3, normal: DVec3) -> Self {
        let mut worst = Self::none();
        worst.note(gravity.dot(normal).abs(), gravity.length(), || "gravity is not parallel to the plane".to_owned());
        worst
    }

    /// That of a body in the plane `normal . x = offset`: of its motion, and of its shape where the motion has none.
    pub(super) fn of_body(model: &Model, states: &[BodyState], (normal, offset): (DVec3, f64), number: usize) -> Self {
        let (body, state) = (&model.bodies[number], &states[number]);
        let (name, height) = (&body.name, normal.dot(state.pose.translation) - offset);
        let mut worst = Self::none();
        if let Some(rigid) = &body.rigid {
            let extent = body.size + state.pose.translation.abs().max_element();
            worst.note(height.abs(), extent, || format!("{name} is not centred on the plane"));
            let velocity = rigid.velocity(state);
            let speed = velocity.linear.length();
            worst.note(velocity.linear.dot(normal).abs(), speed, || format!("{name} moves out of the plane"));
            let spin = velocity.angular;
            worst.note(spin.cross(normal).length(), spin.length(), || {
                format!("{name} does not turn about the normal of the plane")
            });
            let axis = state.pose.rotation.inverse_rotate(normal);
            let moment = rigid.inertia() * axis;
            worst.note(moment.cross(axis).length(), rigid.moments().max_element(), || {
                format!("the normal is not a principal axis of {name}")
            });
        }
        let surface = moving_surfaces::surface_velocity(model, states, number);
        worst.note(surface.dot(normal).abs(), surface.length(), || {
            format!("the surface of {name} moves out of the plane")
        });
        if let Some(shape) = body.shape.as_ref().filter(|_| worst.is_rounding()) {
            let axis = UnitVector::new(state.pose.rotation.inverse_rotate(normal));
            let offset = if body.moves() { 0.0 } else { -height };
            let defect = axis.map_or(f64::INFINITY, |axis| mirror_defect(shape, axis, offset));
            let size = if body.size == 0.0 { 1.0 } else { body.size };
            worst.note(defect, size, || format!("the shape of {name} is not its own mirror image"));
        }
        worst
    }

    fn none() -> Self {
        Self { relative: 0.0, what: String::new() }
    }

    /// Takes this defect of a quantity of this size where it is larger.
    fn note(&mut self, defect: f64, size: f64, what: impl FnOnce() -> String) {
        let relative = if defect == 0.0 { 0.0 } else { defect / size };
        let relative = if relative.is_nan() { f64::INFINITY } else { relative };
        if relative > self.relative {
            *self = Self { relative, what: what() };
        }
    }

    /// Whether it is no more than rounding.
    pub(super) fn is_rounding(&self) -> bool {
        self.relative <= SYMMETRY_RELATIVE
    }
}

/// A body by where the normals of its contacts may point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    /// Nothing touches it, or every contact has its own normal.
    HalfSpace,
    Ball,
    /// The same in every plane parallel to the plane of motion.
    Prism,
    Convex,
    Other,
}

impl Form {
    /// That of a body with this normal of the plane of motion in its frame.
    pub(super) fn of(shape: Option<&Shape>, axis: DVec3) -> Self {
        match shape {
            None | Some(Shape::HalfSpace(_)) => Self::HalfSpace,
            Some(Shape::Sphere(_)) => Self::Ball,
            Some(shape) if UnitVector::new(axis).is_ok_and(|axis| is_prism_along(shape, axis)) => Self::Prism,
            Some(Shape::Convex(_) | Shape::Capsule(_) | Shape::Cylinder(_) | Shape::Cone(_)) => Self::Convex,
            Some(_) => Self::Other,
        }
    }

    /// Whether normals of contacts with a body of another form lie in the plane of symmetry of both.
    pub(super) fn keeps_normals(self, other: Self) -> bool {
        match (self, other) {
            (Self::HalfSpace, _) | (_, Self::HalfSpace) | (Self::Prism, Self::Prism) => true,
            (Self::Ball, other) | (other, Self::Ball) => other != Self::Other,
            _ => false,
        }
    }
}
