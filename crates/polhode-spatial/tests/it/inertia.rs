//! Inertia: only what a body can have is accepted, and the theorem of parallel axes holds.

use crate::random::{assert_matrix, cloud_properties, clouds, rotations, vectors};
use polhode_spatial::inertia::point_inertia;
use polhode_spatial::{DMat3, DVec3, Inertia, InertiaError};
use proptest::prelude::*;

#[test]
fn what_no_body_has_is_refused() {
    let diagonal = |x, y, z| Inertia::from_diagonal(DVec3::new(x, y, z));
    assert_eq!(diagonal(1.0, f64::NAN, 1.0), Err(InertiaError::NotFinite));
    assert_eq!(diagonal(f64::INFINITY, 1.0, 1.0), Err(InertiaError::NotFinite));
    assert_eq!(diagonal(1.0, 0.0, 1.0), Err(InertiaError::NotPositive(0.0)));
    assert_eq!(diagonal(1.0, 1.0, -2.0), Err(InertiaError::NotPositive(-2.0)));
    assert_eq!(diagonal(3.0, 1.0, 1.0), Err(InertiaError::TriangleInequality(DVec3::new(1.0, 1.0, 3.0))));
    let mut skew = DMat3::IDENTITY;
    skew.z_axis.x = 0.25;
    assert_eq!(Inertia::new(skew), Err(InertiaError::NotSymmetric { row: 0, column: 2, upper: 0.25, lower: 0.0 }));
}

/// A plate is on the edge of the triangle inequality, also with rounded digits; a needle may be as thin as it likes
/// along its axis.
#[test]
fn plates_and_needles_are_bodies() {
    for moments in
        [[1.0, 1.0, 2.0], [0.1, 0.2, 0.3], [1.0, 1.0, 2.0 + 1e-9], [1e-20, 1.0, 1.0], [1e-300, 1e-300, 1e-300]]
    {
        assert!(Inertia::from_diagonal(DVec3::from_array(moments)).is_ok(), "{moments:?}");
    }
}

/// The largest f64 does not overflow on the way in: what is accepted is what was given.
#[test]
fn huge_moments_stay_finite() {
    let huge = Inertia::from_diagonal(DVec3::splat(1.2e308)).unwrap();
    assert_eq!(huge.matrix(), DMat3::from_diagonal(DVec3::splat(1.2e308)));
}

/// A particle a millionth of its distance off the x axis: its small moment has all digits beside one 1e12 larger.
#[test]
fn particle_near_an_axis_keeps_its_small_moment() {
    let small = point_inertia(1.0, DVec3::new(1.0, 3e-6, 4e-6)).x_axis.x;
    assert!((small / 25e-12 - 1.0).abs() < 4e-16, "{small:e}");
}

proptest! {
    /// A rod of particles has no moment about its own axis. In tilted axes rounding makes that a small number of
    /// either sign; it is refused every time, not when the sign happens to be negative.
    #[test]
    fn a_rod_has_no_inertia(direction in vectors(1.0), masses in prop::array::uniform3(0.1..1.0f64)) {
        prop_assume!(direction.length() > 0.1);
        let rod = masses.iter().zip([-1.0, 0.3, 2.0]).fold(DMat3::ZERO, |sum, (&m, at)| {
            sum + point_inertia(m, direction * at)
        });
        prop_assert!(matches!(Inertia::new(rod), Err(InertiaError::NotPositive(_))));
    }

    /// The same rod with a thickness of a millionth of its length is a body.
    #[test]
    fn a_thin_rod_has_inertia(rotation in rotations()) {
        let r = rotation.to_matrix();
        let needle = r * DMat3::from_diagonal(DVec3::new(1e-12, 1.0, 1.0)) * r.transpose();
        prop_assert!(Inertia::new((needle + needle.transpose()) * 0.5).is_ok());
    }

    /// A cloud of particles is a body in any axes; its moments do not change with them.
    #[test]
    fn rotation_keeps_moments(cloud in clouds(), rotation in rotations()) {
        let inertia = *cloud_properties(&cloud).inertia();
        let turned = inertia.rotated(rotation);
        let turned_cloud: Vec<_> = cloud.iter().map(|&(m, p)| (m, rotation.rotate(p))).collect();
        assert_matrix(turned.matrix(), cloud_properties(&turned_cloud).inertia().matrix(), 1e-14);
        let (a, b) = (inertia.principal_axes().moments(), turned.principal_axes().moments());
        prop_assert!((a - b).length() <= 1e-14 * a.z);
        prop_assert!(Inertia::new(turned.matrix()).is_ok());
    }

    /// Theorem of parallel axes: the inertia about another point is the sum over the particles about it.
    #[test]
    fn parallel_axes(cloud in clouds(), point in vectors(5.0)) {
        let body = cloud_properties(&cloud);
        let about = body.inertia().shifted_from_center_of_mass(body.mass(), body.center_of_mass() - point);
        let expected = cloud.iter().fold(DMat3::ZERO, |sum, &(m, p)| sum + point_inertia(m, p - point));
        assert_matrix(about.matrix(), expected, 1e-14);
    }

    /// The particle's inertia gives its angular momentum: `I w = m r x (w x r)`.
    #[test]
    fn particle(r in vectors(2.0), w in vectors(2.0), m in 0.1..3.0f64) {
        let expected = m * r.cross(w.cross(r));
        let error = (point_inertia(m, r) * w - expected).length();
        prop_assert!(error <= 1e-14 * (1.0 + m * r.length_squared() * w.length()));
    }

    /// Nine numbers are an inertia that is positive definite, or an error; none panics.
    #[test]
    fn any_matrix(elements in prop::array::uniform9(any::<f64>())) {
        if let Ok(inertia) = Inertia::new(DMat3::from_cols_array(&elements)) {
            prop_assert!(inertia.matrix().is_finite() && inertia.principal_axes().moments().x > 0.0);
        }
    }
}
