//! How a mechanism is set in the world: turned about any axis, moved, with bodies and joints in another order, or
//! started with masses, gravity and loose bodies a little different. What grows from such a difference grows from
//! rounding.

use super::model::{Mechanism, Value};
use crate::random::Random;
use glam::{DQuat, DVec3};

/// A placement.
#[derive(Debug, Clone, Copy)]
pub struct Placement {
    /// The scene is turned about the origin by this, and then moved by this, m.
    pub rotation: DQuat,
    /// A displacement, m.
    pub shift: DVec3,
    /// Whether bodies and joints stand in the opposite order.
    pub is_reversed: bool,
}

impl Placement {
    /// As it is.
    pub const AS_IS: Self = Self { rotation: DQuat::IDENTITY, shift: DVec3::ZERO, is_reversed: false };

    pub(super) fn point(&self, p: DVec3) -> DVec3 {
        self.rotation * p + self.shift
    }

    pub(super) fn direction(&self, v: DVec3) -> DVec3 {
        self.rotation * v
    }

    pub(super) fn value(&self, value: &Value) -> Value {
        match value {
            Value::Point(p) => Value::Point(self.point(*p)),
            Value::Points(all) => Value::Points(all.iter().map(|&p| self.point(p)).collect()),
            Value::Direction(v) => Value::Direction(self.direction(*v)),
            Value::Text(text) => Value::Text(text.clone()),
        }
    }

    /// A state of a body in this placement, as it would be in the scene as it is.
    pub fn undone(&self, position: DVec3, orientation: DQuat) -> (DVec3, DQuat) {
        let back = self.rotation.inverse();
        (back * (position - self.shift), back * orientation)
    }
}

impl Mechanism {
    /// Started a little elsewhere: masses and gravity differ by about this part of themselves, and loose bodies start
    /// as much of their size aside and with as much of their velocities more.
    pub fn disturbed(&self, part: f64) -> Self {
        let mut random = Random(self.seed ^ 0x5EED);
        let mut scene = self.clone();
        scene.gravity += random.direction() * scene.gravity.length() * part;
        for body in &mut scene.bodies {
            if let super::model::Role::Free(mass, inertia) = &mut body.role {
                *mass *= 1.0 + part * random.between(-1.0, 1.0);
                if let Some(inertia) = inertia {
                    *inertia *= 1.0 + part * random.between(-1.0, 1.0);
                }
            }
            if body.is_loose {
                body.position += random.direction() * body.size * part;
                body.velocity += random.direction() * body.velocity.length() * part;
                body.angular_velocity += random.direction() * body.angular_velocity.length() * part;
            }
        }
        scene
    }
}
