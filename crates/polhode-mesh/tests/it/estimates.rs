//! Monte Carlo estimates and plain sums about other reference points, against the exact integrals.

use crate::shapes::{L_SHAPE, assert_near, assert_relative, icosphere, mesh, solid, torus, unit_density};
use polhode_mesh::{
    Bounds, MonteCarlo, MonteCarloError, ReferencePoint, SolidMesh, VolumeIntegrals, compare_reference_points,
    compare_reference_points_hollow, plain_volume_integrals, solid_mass_properties,
};
use polhode_spatial::{DVec3, Mass};

/// Every quantity is within a few of its stated errors of the truth, for a body that is not convex and for one with a
/// hole; in the mean over seeds the squares of the deviations are one, so the stated errors are neither too small nor
/// too large. 40 runs of 8 quantities that are not independent know that mean to about a fifth.
#[test]
fn stated_errors_are_the_true_ones() {
    for body in [solid(L_SHAPE), SolidMesh::new(torus(16, 8)).unwrap()] {
        let exact = solid_mass_properties(&body, unit_density()).unwrap();
        let m = exact.inertia().matrix();
        let (mut squares, mut count) = (0.0, 0.0);
        for seed in 0..40 {
            let found = MonteCarlo::new(4000, seed).unwrap().estimate(&body, unit_density()).unwrap();
            let mut pairs = vec![(found.volume, exact.mass()), (found.mass, exact.mass())];
            pairs.extend(found.center_of_mass.into_iter().zip(exact.center_of_mass().to_array()));
            let elements = [m.x_axis.x, m.y_axis.y, m.z_axis.z, m.y_axis.z, m.x_axis.z, m.x_axis.y];
            pairs.extend(found.inertia.into_iter().zip(elements));
            for (estimate, truth) in pairs {
                let deviation = (estimate.value - truth) / estimate.standard_error;
                assert!(deviation.abs() < 5.0, "seed {seed}: {estimate:?}, exact {truth}");
                squares += deviation * deviation;
                count += 1.0;
            }
        }
        assert_near(squares / count, 1.0, 1.0, 0.3);
    }
}

/// Case MP-10: the error of Ixx/m of a ball is 0.2619 / sqrt(N). With a given mass the mass has no error.
#[test]
fn mp_10_unit_ball() {
    let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };
    let monte_carlo = MonteCarlo::new(100_000, 3).unwrap();
    let estimate = monte_carlo.estimate_region(bounds, |p| p.length_squared() < 1.0, Mass::new(1.0).unwrap()).unwrap();
    assert_eq!((estimate.mass.value, estimate.mass.standard_error), (1.0, 0.0));
    assert_relative(estimate.inertia[0].standard_error * (estimate.inside as f64).sqrt(), 0.26186146828319085, 0.05);
    // Same seed, same bits.
    let again = monte_carlo.estimate_region(bounds, |p| p.length_squared() < 1.0, Mass::new(1.0).unwrap()).unwrap();
    assert_eq!(again, estimate);
}

/// The ray along z meets exactly one of two triangles at a common edge: on a mesh with many edges at the points'
/// coordinates no point is lost. The share of points in the icosphere is its volume's.
#[test]
fn the_inside_test_is_watertight() {
    let ball = SolidMesh::new(icosphere(3)).unwrap();
    let found = MonteCarlo::new(50_000, 5).unwrap().estimate(&ball, unit_density()).unwrap();
    let volume = ball.volume_integrals().volume;
    assert!((found.volume.value - volume).abs() < 4.0 * found.volume.standard_error);
}

#[test]
fn too_few_points() {
    assert_eq!(MonteCarlo::new(1, 0), Err(MonteCarloError::Samples(1)));
    let bounds = Bounds { min: DVec3::ZERO, max: DVec3::ONE };
    let nothing = MonteCarlo::new(10, 0).unwrap().estimate_region(bounds, |_| false, unit_density());
    assert_eq!(nothing, Err(MonteCarloError::Inside { inside: 0, samples: 10 }));
}

/// The reference point does not matter, but for rounding: near the body all choices agree to rounding, solid and
/// hollow, and any other point near it does too.
#[test]
fn near_the_body_every_reference_point_will_do() {
    let shape = mesh(L_SHAPE);
    for cost in compare_reference_points(&shape).into_iter().chain(compare_reference_points_hollow(&shape)) {
        let worst = cost.measure_error.max(cost.centroid_error_m).max(cost.second_moment_error);
        assert!(worst < 1e-14, "{cost:?}");
    }
    let exact = VolumeIntegrals::of(&shape);
    let found = plain_volume_integrals(&shape, ReferencePoint::At(DVec3::new(3.0, -2.0, 1.0)));
    assert_relative(found.volume, exact.volume, 1e-14);
}

/// Erratum E5: far from the origin it is a ruinous reference point, the average of the vertices and the centre of mass
/// are as good as at home. The error of the inertia grows with the square of the distance at the least.
#[test]
fn far_away_the_origin_is_ruinous() {
    let errors = |distance: f64| {
        let far = mesh(L_SHAPE).translated(DVec3::new(1.0, -2.0, 3.0) * distance).unwrap();
        compare_reference_points(&far).iter().map(|cost| cost.second_moment_error).collect::<Vec<_>>()
    };
    let (near, far) = (errors(1024.0), errors(1048576.0));
    assert!(far[0] > 1.0 && far[0] > 1e6 * near[0], "{near:?} {far:?}");
    assert!(far[1] < 1e-13 && far[2] < 1e-13, "{far:?}");
}
