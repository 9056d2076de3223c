//! Rotations given by three angles.
//!
//! The suite's reader (`read_rb_scene.cpp`) turns a body by `R = Rz(c) Ry(b) Rx(a)` about the origin of its mesh, for
//! `rotation = [a, b, c]` in degrees: about the axes of the world, first x, then y, then z.

use glam::{DQuat, DVec3};
use polhode_spatial::Rotation;
use std::f64::consts::FRAC_PI_2;

/// Degrees in a right angle.
const RIGHT_ANGLE_DEG: f64 = 90.0;

/// Degrees after which a half angle comes back to itself.
const TWO_TURNS_DEG: f64 = 720.0;

/// `Rz Ry Rx` for angles in degrees.
pub(super) fn of_degrees(angles: DVec3) -> Rotation {
    let [x, y, z] = angles.to_array().map(half_angle);
    let about_x = DQuat::from_xyzw(x.0, 0.0, 0.0, x.1);
    let about_y = DQuat::from_xyzw(0.0, y.0, 0.0, y.1);
    let about_z = DQuat::from_xyzw(0.0, 0.0, z.0, z.1);
    Rotation::renormalized(about_z * about_y * about_x)
}

/// Sine and cosine of half an angle in degrees; exact at multiples of half a turn, where the sine of a rounded multiple
/// of pi would tilt a face that is meant to be level.
fn half_angle(degrees: f64) -> (f64, f64) {
    let half = 0.5 * libm::fmod(degrees, TWO_TURNS_DEG);
    let quarters = libm::rint(half / RIGHT_ANGLE_DEG);
    let (sine, cosine) = libm::sincos((half - quarters * RIGHT_ANGLE_DEG) / RIGHT_ANGLE_DEG * FRAC_PI_2);
    match quarters.rem_euclid(4.0) as u32 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

#[cfg(test)]
mod tests {
    //! Against vectors turned by hand.
    use super::*;

    #[test]
    fn half_a_turn_is_exact() {
        let turned = of_degrees(DVec3::new(0.0, 0.0, 180.0)).rotate(DVec3::new(1.0, 2.0, 3.0));
        assert_eq!(turned, DVec3::new(-1.0, -2.0, 3.0));
    }

    #[test]
    fn angles_are_about_the_axes_of_the_world_x_first() {
        let turned = of_degrees(DVec3::new(90.0, 0.0, 90.0)).rotate(DVec3::Y);
        // About x the y axis goes to z, which the turn about z leaves.
        assert!((turned - DVec3::Z).length() < 1e-15, "{turned}");
        let turned = of_degrees(DVec3::new(90.0, 90.0, 0.0)).rotate(DVec3::Y);
        assert!((turned - DVec3::X).length() < 1e-15, "{turned}");
        let turned = of_degrees(DVec3::new(0.0, -450.0, 0.0)).rotate(DVec3::Z);
        assert!((turned + DVec3::X).length() < 1e-15, "{turned}");
    }
}
