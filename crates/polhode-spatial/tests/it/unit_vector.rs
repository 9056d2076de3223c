//! Directions have length one, whatever the length they are made from.

use crate::random::vectors;
use polhode_spatial::{DVec3, UnitVector};
use proptest::prelude::*;

#[test]
fn no_direction() {
    for bad in [DVec3::ZERO, -DVec3::ZERO, DVec3::new(0.0, f64::NAN, 1.0), DVec3::new(f64::INFINITY, 0.0, 0.0)] {
        assert!(UnitVector::new(bad).is_err());
    }
    let message = UnitVector::new(DVec3::ZERO).unwrap_err().to_string();
    assert_eq!(message, "(0, 0, 0) has no direction: a finite vector that is not zero is needed");
}

/// Lengths whose squares leave f64.
#[test]
fn extreme_lengths() {
    for length in [5e-324, 1e-308, 1e-200, 1e200, 1e308] {
        let direction = UnitVector::new(DVec3::new(length, -length, 0.0)).unwrap().get();
        assert!((direction - DVec3::new(1.0, -1.0, 0.0) * 0.5f64.sqrt()).length() < 3e-16);
    }
    assert_eq!(-UnitVector::X, UnitVector::new(DVec3::new(-7.0, 0.0, 0.0)).unwrap());
}

proptest! {
    /// Of length one to round-off, in the direction of what it was made from, and the same for any positive multiple
    /// by a power of two.
    #[test]
    fn direction_of_its_vector(vector in vectors(1.0), exponent in -900i32..900) {
        prop_assume!(vector.length() > 1e-6);
        let direction = UnitVector::new(vector).unwrap();
        prop_assert!((direction.get().length() - 1.0).abs() < 4e-16);
        prop_assert!(direction.get().cross(vector).length() <= 4e-16 * vector.length());
        prop_assert!(direction.get().dot(vector) > 0.0);
        prop_assert_eq!(UnitVector::new(vector * 2f64.powi(exponent)).unwrap(), direction);
    }
}
