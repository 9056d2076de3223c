//! Rotations keep lengths, angles and handedness, compose like their matrices, and refuse what is no rotation.

use crate::random::{assert_matrix, assert_vector, rotations, vectors};
use polhode_spatial::rotation::NORM_TOLERANCE;
use polhode_spatial::{DMat3, DQuat, DVec3, Rotation, RotationError};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// A quarter turn about z takes x to y: positive is anticlockwise, and the scalar comes first.
#[test]
fn quarter_turn() {
    let quarter = Rotation::from_rotation_vector(DVec3::Z * FRAC_PI_2);
    assert_vector(quarter.rotate(DVec3::X), DVec3::Y, 1.0, 3e-16);
    let h = 0.5f64.sqrt();
    for (found, expected) in quarter.to_wxyz().into_iter().zip([h, 0.0, 0.0, h]) {
        assert!((found - expected).abs() < 2e-16);
    }
    assert_eq!(Rotation::from_wxyz([1.0, 0.0, 0.0, 0.0]).unwrap(), Rotation::IDENTITY);
}

/// No rotation changes no bit of a vector.
#[test]
fn identity_is_exact() {
    let v = DVec3::new(0.1, -1e300, 1e-310);
    assert_eq!(Rotation::IDENTITY.rotate(v), v);
    assert_eq!(Rotation::from_rotation_vector(DVec3::ZERO), Rotation::IDENTITY);
}

/// Digits as typed by a person are normalised; other lengths and values are errors that say which.
#[test]
fn quaternions_are_checked() {
    let typed = Rotation::from_wxyz([0.6000003, 0.0, 0.8, 0.0]).unwrap();
    assert!((typed.quaternion().length() - 1.0).abs() <= f64::EPSILON);
    for (wxyz, length) in
        [([0.0; 4], 0.0), ([1.0, 1.0, 0.0, 0.0], 2f64.sqrt()), ([1e200, 0.0, 0.0, 0.0], f64::INFINITY)]
    {
        assert_eq!(Rotation::from_wxyz(wxyz), Err(RotationError::NotUnit { wxyz, norm: length }));
    }
    assert!(Rotation::from_wxyz([1.0 + 0.9 * NORM_TOLERANCE, 0.0, 0.0, 0.0]).is_ok());
    assert!(Rotation::from_wxyz([1.0 + 1.1 * NORM_TOLERANCE, 0.0, 0.0, 0.0]).is_err());
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(Rotation::from_wxyz([1.0, bad, 0.0, 0.0]), Err(RotationError::NotFinite(_))));
    }
}

/// Every finite quaternion but zero is brought back to the unit sphere, also where its square leaves f64; and zero or
/// NaN does not become a rotation silently.
#[test]
fn renormalisation_covers_all_lengths() {
    for length in [5e-324, 1e-300, 1e-160, 1e-5, 1.0, 1e5, 1e160, 1e308] {
        let q = Rotation::renormalized(DQuat::from_xyzw(0.0, length, 0.0, -length)).quaternion();
        assert!((q.length() - 1.0).abs() <= 2.0 * f64::EPSILON, "{length:e} gives {q}");
        assert_eq!(q.y, -q.w);
    }
    assert!(!Rotation::renormalized(DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)).is_finite());
    assert!(!Rotation::renormalized(DQuat::from_xyzw(0.0, f64::NAN, 0.0, 1.0)).is_finite());
    assert!(!Rotation::from_rotation_vector(DVec3::new(f64::INFINITY, 0.0, 0.0)).is_finite());
}

/// Small angles: no digit is lost on either side of the change from series to sine, down to the smallest number.
#[test]
fn small_angles() {
    for angle in [1e-300, 1e-200, 1e-20, 1e-9, 0.99999e-4, 1.00001e-4, 1e-3] {
        let rotation = Rotation::from_rotation_vector(DVec3::new(0.0, angle, 0.0));
        assert!((rotation.to_wxyz()[2] / (0.5 * angle).sin() - 1.0).abs() < 4e-16);
        // Angles are measured down to the root of the smallest number.
        let found = rotation.angle_to(Rotation::IDENTITY);
        let expected = if angle < 1e-160 { 0.0 } else { angle };
        assert!((found - expected).abs() <= 4e-16 * angle, "{angle:e} gives {found:e}");
    }
}

/// A body turned by 1e5 small steps has turned by their sum; the error grows as the root of their number.
#[test]
fn many_small_rotations_add_up() {
    let axis = DVec3::new(1.0, 2.0, -2.0) / 3.0;
    let step = Rotation::from_rotation_vector(axis * 1e-3);
    let total = (0..100_000).fold(Rotation::IDENTITY, |sum, _| step * sum);
    assert!(total.angle_to(Rotation::from_rotation_vector(axis * 100.0)) < 1e-11);
}

proptest! {
    /// Lengths, inner products and cross products are kept: a proper rotation.
    #[test]
    fn geometry_is_kept(rotation in rotations(), u in vectors(10.0), v in vectors(10.0)) {
        let (ru, rv) = (rotation.rotate(u), rotation.rotate(v));
        let scale = u.length() * v.length();
        prop_assert!((ru.dot(rv) - u.dot(v)).abs() <= 4e-15 * scale);
        assert_vector(ru.cross(rv), rotation.rotate(u.cross(v)), scale, 4e-15);
    }

    /// Rodrigues' formula, with plain trigonometry.
    #[test]
    fn is_the_rotation_about_its_vector(vector in vectors(5.0), v in vectors(1.0)) {
        prop_assume!(vector.length() > 1e-3);
        let (angle, n) = (vector.length(), vector.normalize());
        let expected = v * angle.cos() + n.cross(v) * angle.sin() + n * (n.dot(v) * (1.0 - angle.cos()));
        assert_vector(Rotation::from_rotation_vector(vector).rotate(v), expected, 1.0, 4e-15);
    }

    /// Quaternion, matrix and their products are the same rotation; the inverse undoes it.
    #[test]
    fn composition(a in rotations(), b in rotations(), v in vectors(1.0)) {
        assert_matrix((a * b).to_matrix(), a.to_matrix() * b.to_matrix(), 4e-15);
        assert_vector((a * b).rotate(v), a.rotate(b.rotate(v)), 1.0, 4e-15);
        assert_vector(a.inverse_rotate(a.rotate(v)), v, 1.0, 4e-15);
        assert_matrix((a * a.inverse()).to_matrix(), DMat3::IDENTITY, 4e-15);
        prop_assert!(Rotation::from_matrix(&a.to_matrix()).angle_to(a) < 4e-15);
    }

    /// The angle between rotations is that of the turn that leads from one to the other, by the short way, the same
    /// for q and -q.
    #[test]
    fn angle_between(base in rotations(), vector in vectors(1.8)) {
        let other = base * Rotation::from_rotation_vector(vector);
        let expected = if vector.length() <= PI { vector.length() } else { 2.0 * PI - vector.length() };
        prop_assert!((base.angle_to(other) - expected).abs() < 4e-15);
        let opposite = Rotation::renormalized(-other.quaternion());
        prop_assert!((base.angle_to(opposite) - expected).abs() < 4e-15);
    }

    /// Four numbers make a unit rotation or an error; none panics.
    #[test]
    fn any_numbers(wxyz in prop::array::uniform4(any::<f64>())) {
        if let Ok(rotation) = Rotation::from_wxyz(wxyz) {
            prop_assert!((rotation.quaternion().length() - 1.0).abs() < 1e-15);
        }
        let _ = Rotation::from_rotation_vector(DVec3::new(wxyz[0], wxyz[1], wxyz[2]));
    }
}
