//! Forces of contacts at one instant, with the accelerations that they give.

use crate::collision::touch::Touch;
use crate::report::frame::JointView;
use crate::solve::joint_loads::ContactForce;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Forces on body A of some contacts, in their order, and accelerations of their bodies.
#[derive(Debug, Clone, Default)]
pub(super) struct PresentForces {
    /// Along the normals, N.
    pub(super) normal: Vec<f64>,
    /// Of friction, world, N.
    pub(super) friction: Vec<DVec3>,
    /// Of bodies: linear, m/s^2, and angular, rad/s^2.
    pub(super) accelerations: Vec<BodyAcceleration>,
    /// What joints bear, by their numbers.
    pub(super) joints: BTreeMap<usize, JointView>,
}

/// Acceleration of one body, of the origin of its moving frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct BodyAcceleration {
    pub(super) body: usize,
    /// m/s^2.
    pub(super) linear: DVec3,
    /// rad/s^2.
    pub(super) angular: DVec3,
}

/// The forces on the bodies A of contacts.
pub(super) fn forces_on<'a>(
    contacts: &'a [Touch],
    normal: &'a [f64],
    friction: &'a [DVec3],
) -> impl Iterator<Item = ContactForce> + 'a {
    contacts.iter().zip(normal).zip(friction).map(|((touch, normal), friction)| {
        let geometry = &touch.kinematics.geometry;
        ContactForce { id: touch.id, point: geometry.point, force: geometry.normal * *normal + *friction }
    })
}
