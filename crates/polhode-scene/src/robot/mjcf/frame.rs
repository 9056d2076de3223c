//! Poses of MJCF: `pos`, and one of several ways to give an orientation.

use super::super::element::Element;
use super::super::finding::RobotDefect;
use super::super::reading::{Reading, turned};
use super::compiler::{Compiler, Turning};
use glam::{DMat3, DQuat, DVec3};
use polhode::spatial::{Pose, Rotation, UnitVector};

/// The pose that an element gives.
pub(super) fn pose(element: &Element, compiler: &Compiler, subject: &str, reading: &mut Reading) -> Pose {
    let translation = reading.vector(element, "pos", subject).unwrap_or_default();
    Pose::new(orientation(element, compiler, subject, reading), translation)
}

/// The orientation that an element gives.
pub(super) fn orientation(element: &Element, compiler: &Compiler, subject: &str, reading: &mut Reading) -> Rotation {
    if let Some(wxyz) = reading.numbers(element, "quat", 4..=4, subject) {
        return of_quaternion([wxyz[0], wxyz[1], wxyz[2], wxyz[3]], element, subject, reading);
    }
    if let Some(numbers) = reading.numbers(element, "axisangle", 4..=4, subject) {
        let axis = reading.direction(element, DVec3::from_slice(&numbers), subject);
        let angle = compiler.radians(numbers[3]);
        return axis.map_or(Rotation::IDENTITY, |axis| turned(axis.get(), angle));
    }
    if let Some(angles) = reading.vector(element, "euler", subject) {
        return of_euler(angles, compiler);
    }
    if let Some(numbers) = reading.numbers(element, "xyaxes", 6..=6, subject) {
        let (x, y) = (DVec3::from_slice(&numbers), DVec3::from_slice(&numbers[3..]));
        let Some(x) = reading.direction(element, x, subject) else { return Rotation::IDENTITY };
        let y = y - x.get() * x.get().dot(y);
        let Some(y) = reading.direction(element, y, subject) else { return Rotation::IDENTITY };
        return Rotation::from_matrix(&DMat3::from_cols(x.get(), y.get(), x.get().cross(y.get())));
    }
    if let Some(axis) = reading.vector(element, "zaxis", subject) {
        let axis = reading.direction(element, axis, subject);
        return axis.map_or(Rotation::IDENTITY, from_z);
    }
    Rotation::IDENTITY
}

/// From a quaternion of any length but zero.
fn of_quaternion([w, x, y, z]: [f64; 4], element: &Element, subject: &str, reading: &mut Reading) -> Rotation {
    let rotation = Rotation::renormalized(DQuat::from_xyzw(x, y, z, w));
    if rotation.is_finite() {
        return rotation;
    }
    let (attribute, value) = ("quat".to_owned(), format!("{w} {x} {y} {z}"));
    let accepted = "four finite numbers, not all zero".to_owned();
    reading.refuse(element, subject, RobotDefect::Numbers { attribute, value, accepted });
    Rotation::IDENTITY
}

/// From Euler angles in the order of the compiler.
fn of_euler(angles: DVec3, compiler: &Compiler) -> Rotation {
    let mut rotation = Rotation::IDENTITY;
    for ((axis, turning), angle) in compiler.euler_axes().into_iter().zip(angles.to_array()) {
        let next = turned(axis, compiler.radians(angle));
        rotation = match turning {
            Turning::Along => rotation * next,
            Turning::Still => next * rotation,
        };
    }
    rotation
}

/// The least rotation that turns the z axis into a direction.
pub(super) fn from_z(axis: UnitVector) -> Rotation {
    let axis = axis.get();
    let across = DVec3::Z.cross(axis);
    let sine = across.length();
    if sine == 0.0 {
        // Half a turn, or none.
        return if axis.z < 0.0 { turned(DVec3::X, std::f64::consts::PI) } else { Rotation::IDENTITY };
    }
    turned(across / sine, libm::atan2(sine, axis.z))
}
