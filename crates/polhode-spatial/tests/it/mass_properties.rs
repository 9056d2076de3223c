//! Mass properties of unions and moved bodies against sums over particles, and the mechanics they must give.

use crate::random::{assert_same_body, cloud_properties, clouds, poses, vectors};
use polhode_spatial::{DVec3, Density, Inertia, InertiaError, Mass, MassProperties, MassPropertiesError};
use proptest::prelude::*;

#[test]
fn masses_and_densities_are_positive() {
    for bad in [0.0, -0.0, -1.0, f64::INFINITY] {
        assert_eq!(Mass::new(bad), Err(MassPropertiesError::Mass(bad)));
        assert_eq!(Density::new(bad), Err(MassPropertiesError::Density(bad)));
    }
    assert!(Mass::new(f64::NAN).is_err() && Density::new(f64::NAN).is_err());
    assert_eq!(Mass::new(1e-300).map(Mass::get), Ok(1e-300));
    assert!(Mass::new(-2.0).unwrap_err().to_string().contains("-2"));
}

/// Two unions beyond f64: the sum of the masses, and the arm between the centres.
#[test]
fn overflow_is_an_error() {
    let body = |mass: f64, at: f64| {
        let inertia = Inertia::from_diagonal(DVec3::ONE).unwrap();
        MassProperties::new(Mass::new(mass).unwrap(), DVec3::X * at, inertia)
    };
    let heavy = body(1.5e308, 0.0);
    assert_eq!(heavy.combined(&heavy), Err(MassPropertiesError::Mass(f64::INFINITY)));
    let apart = body(1.0, -1e200).combined(&body(1.0, 1e200));
    assert_eq!(apart, Err(MassPropertiesError::Inertia(InertiaError::NotFinite)));
}

proptest! {
    /// The union of two clouds is the cloud of all their particles, in either order.
    #[test]
    fn union(first in clouds(), second in clouds()) {
        let both: Vec<_> = first.iter().chain(&second).copied().collect();
        let (first, second) = (cloud_properties(&first), cloud_properties(&second));
        assert_same_body(&first.combined(&second).unwrap(), &cloud_properties(&both), 1e-14);
        assert_same_body(&second.combined(&first).unwrap(), &cloud_properties(&both), 1e-14);
    }

    /// A grain of dust joined to a heavy body moves its centre by the ratio of the masses, with all digits.
    #[test]
    fn extreme_mass_ratio(cloud in clouds(), at in vectors(3.0), exponent in 0..15i32) {
        let dust = 10f64.powi(-exponent);
        let heavy = cloud_properties(&cloud);
        let heavy = MassProperties::new(Mass::new(heavy.mass()).unwrap(), DVec3::ZERO, *heavy.inertia());
        let grain = Inertia::from_diagonal(DVec3::splat(dust)).unwrap();
        let grain = MassProperties::new(Mass::new(dust).unwrap(), at, grain);
        let union = heavy.combined(&grain).unwrap();
        let expected = at * (dust / (heavy.mass() + dust));
        prop_assert!((union.center_of_mass() - expected).length() <= 1e-15 * expected.length());
    }

    /// Moving the frame moves the particles; moving it back restores the body.
    #[test]
    fn change_of_frame(cloud in clouds(), pose in poses(5.0)) {
        let body = cloud_properties(&cloud);
        let moved_cloud: Vec<_> = cloud.iter().map(|&(m, p)| (m, pose.transform_point(p))).collect();
        let moved = body.in_frame(&pose);
        assert_same_body(&moved, &cloud_properties(&moved_cloud), 4e-14);
        assert_same_body(&moved.in_frame(&pose.inverse()), &body, 4e-14);
    }

    /// Kinetic energy of the rigid cloud: `m v^2 / 2 + w . I w / 2`, with v of the centre of mass, is the sum over the
    /// particles.
    #[test]
    fn kinetic_energy(cloud in clouds(), v in vectors(2.0), w in vectors(2.0)) {
        let body = cloud_properties(&cloud);
        let energy = 0.5 * body.mass() * v.length_squared() + 0.5 * w.dot(body.inertia().matrix() * w);
        let expected: f64 = cloud
            .iter()
            .map(|&(m, p)| 0.5 * m * (v + w.cross(p - body.center_of_mass())).length_squared())
            .sum();
        prop_assert!((energy / expected - 1.0).abs() < 1e-13);
    }
}
