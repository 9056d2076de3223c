//! Hulls are exact: convex to the last bit, no point left outside, no corner that is a mixture of others, and typed
//! errors for everything that has no hull.

use crate::shapes::{assert_relative, icosphere};
use polhode_mesh::{ConvexHull, DefectKind, HullError, PointLocation, PointLocator, TriangleMesh, convexity, diagnose};
use polhode_spatial::{DVec3, Pose, Rotation};
use proptest::prelude::*;

/// Points of a fixed pseudo-random sequence in [-1, 1]^3.
pub(crate) fn scattered(count: usize, seed: u64) -> Vec<DVec3> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1_u32 << 30) - 1.0
    };
    (0..count).map(|_| DVec3::new(next(), next(), next())).collect()
}

/// A closed convex solid that holds every point, whose corners are some of them; Euler's formula holds for its faces.
#[track_caller]
fn check(points: &[DVec3]) -> ConvexHull {
    let hull = ConvexHull::of(points).unwrap();
    let mesh = hull.solid().mesh();
    // Points that are collinear to rounding only make triangles that are flat to rounding only: harmless, and no
    // others.
    assert!(diagnose(mesh).defects.iter().all(|d| d.kind == DefectKind::DegenerateTriangle), "{:?}", diagnose(mesh));
    assert_eq!(convexity(hull.solid().solid()).excess, 0.0);
    let corners: Vec<DVec3> = hull.sources().iter().map(|&source| points[source as usize]).collect();
    assert_eq!(mesh.vertices(), corners);
    let edges: usize = hull.faces().iter().map(Vec::len).sum::<usize>() / 2;
    assert_eq!(corners.len() + hull.faces().len(), edges + 2);
    assert_eq!(mesh.triangles().len(), hull.faces().iter().map(|face| face.len() - 2).sum::<usize>());
    let step = points.len().div_ceil(200);
    for &point in points.iter().step_by(step) {
        assert_ne!(hull.solid().locate(point), PointLocation::Outside);
    }
    hull
}

/// The hull of points on a sphere has them all as corners, a hundred thousand of them too.
#[test]
fn points_on_a_sphere() {
    let ball = icosphere(4);
    let hull = check(ball.vertices());
    assert_eq!(hull.sources().len(), 2562);
    let start = std::time::Instant::now();
    let sphere: Vec<DVec3> = scattered(100_000, 1).into_iter().map(DVec3::normalize).collect();
    let hull = ConvexHull::of(&sphere).unwrap();
    println!("100000 points on a sphere: {} corners, {:?}", hull.sources().len(), start.elapsed());
    // Rounding to f64 pushes some points inside by a rounding, where their neighbours are 1e-2 away: none is lost.
    assert_eq!(hull.sources().len(), 100_000);
    let start = std::time::Instant::now();
    let hull = ConvexHull::of(&scattered(100_000, 2)).unwrap();
    println!("100000 points in a cube: {} corners, {:?}", hull.sources().len(), start.elapsed());
}

/// Grids are as degenerate as points can be: hundreds in each plane, and still eight corners and six squares.
#[test]
fn grids() {
    for n in [2i32, 3, 7, 20] {
        let grid: Vec<DVec3> = (0..n * n * n)
            .map(|i| DVec3::new(f64::from(i % n), f64::from(i / n % n), f64::from(i / (n * n))))
            .collect();
        let hull = check(&grid);
        assert_eq!((hull.sources().len(), hull.faces().len()), (8, 6));
        assert_eq!(hull.solid().volume_integrals().volume, f64::from((n - 1) * (n - 1) * (n - 1)));
    }
    // The octahedron |x| + |y| + |z| <= 9 in integers.
    let octahedron: Vec<DVec3> = (0..19 * 19 * 19)
        .map(|i| DVec3::new(f64::from(i % 19 - 9), f64::from(i / 19 % 19 - 9), f64::from(i / 361 - 9)))
        .filter(|p| p.abs().element_sum() <= 9.0)
        .collect();
    let hull = check(&octahedron);
    assert_eq!((hull.sources().len(), hull.faces().len()), (6, 8));
    assert_relative(hull.solid().volume_integrals().volume, 4.0 / 3.0 * 729.0, 1e-14);
}

/// A plate a billionth as thick as wide has a hull like any other.
#[test]
fn thin_plates_and_needles() {
    for thickness in [1e-3, 1e-6, 1e-9] {
        let plate: Vec<DVec3> = scattered(500, 3).into_iter().map(|p| p * DVec3::new(1.0, 1.0, thickness)).collect();
        let thick = check(&scattered(500, 3)).solid().volume_integrals().volume;
        assert_relative(check(&plate).solid().volume_integrals().volume, thick * thickness, 1e-12);
        let needle: Vec<DVec3> = plate.iter().map(|&p| p * DVec3::new(1.0, thickness, 1.0)).collect();
        assert_relative(check(&needle).solid().volume_integrals().volume, thick * thickness * thickness, 1e-12);
    }
}

/// Tiny and huge coordinates do not under- or overflow in the predicates.
#[test]
fn tiny_and_huge() {
    let points = scattered(100, 5);
    let expected = ConvexHull::of(&points).unwrap();
    for scale in [2f64.powi(-200), 2f64.powi(200)] {
        let scaled: Vec<DVec3> = points.iter().map(|&p| p * scale).collect();
        assert_eq!(ConvexHull::of(&scaled).unwrap().faces(), expected.faces());
    }
}

#[test]
fn what_has_no_hull() {
    let points = scattered(10, 7);
    assert_eq!(ConvexHull::of(&points[..3]), Err(HullError::TooFewPoints(3)));
    assert_eq!(ConvexHull::of(&[]), Err(HullError::TooFewPoints(0)));
    assert_eq!(ConvexHull::of(&[DVec3::ONE; 9]), Err(HullError::Coplanar(9)));
    let line: Vec<DVec3> = (0..9).map(|i| DVec3::ONE * f64::from(i)).collect();
    assert_eq!(ConvexHull::of(&line), Err(HullError::Coplanar(9)));
    let plane: Vec<DVec3> = points.iter().map(|p| DVec3::new(p.x, p.y, 1.0)).collect();
    assert_eq!(ConvexHull::of(&plane), Err(HullError::Coplanar(10)));
    for bad in [f64::NAN, f64::INFINITY] {
        let mut points = points.clone();
        points[4].y = bad;
        assert!(matches!(ConvexHull::of(&points), Err(HullError::NotFinite { index: 4, .. })));
    }
    // Coplanar to rounding: exactly it has a volume, but not one that its coordinates know.
    let mut nearly = plane;
    nearly[3].z += 1e-16;
    nearly[5].z = 1.0 + f64::EPSILON;
    assert!(matches!(ConvexHull::of(&nearly), Err(HullError::Flat(_))));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    /// Small integers: many points in every plane and on every line, and repeated ones. Turned by a rotation they are
    /// coplanar only to rounding, and the volume stays the same.
    #[test]
    fn integers(points in prop::collection::vec((-3..=3i32, -3..=3i32, -3..=3i32), 4..60), angle in -3.0..3.0f64) {
        let points: Vec<DVec3> =
            points.into_iter().map(|(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z))).collect();
        match ConvexHull::of(&points) {
            Ok(_) => {
                prop_assert!(diagnose(check(&points).solid().mesh()).defects.is_empty());
                let volume = check(&points).solid().volume_integrals().volume;
                let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(angle, 1.0, -angle)), DVec3::splat(7.0));
                let turned: Vec<DVec3> = points.iter().map(|&p| pose.transform_point(p)).collect();
                assert_relative(check(&turned).solid().volume_integrals().volume, volume, 1e-13);
            }
            Err(error) => prop_assert_eq!(error, HullError::Coplanar(points.len())),
        }
    }

    /// The half-space test of a convex solid and the crossings of a ray agree.
    #[test]
    fn half_spaces_equal_crossings(seed in any::<u64>(), count in 4usize..50) {
        let hull = check(&scattered(count, seed));
        let locator = PointLocator::new(hull.solid().solid());
        for point in scattered(50, seed ^ 1).into_iter().chain(scattered(count, seed)) {
            prop_assert_eq!(hull.solid().locate(point), locator.locate(point));
        }
    }

    /// The order of the points changes nothing but the order of the corners.
    #[test]
    fn order_does_not_matter(seed in any::<u64>(), count in 4usize..100) {
        let points = scattered(count, seed);
        let reversed: Vec<DVec3> = points.iter().rev().copied().collect();
        let corners = |points: &[DVec3]| {
            let mut corners: Vec<[f64; 3]> =
                ConvexHull::of(points).unwrap().solid().mesh().vertices().iter().map(DVec3::to_array).collect();
            corners.sort_by(|p, q| p.partial_cmp(q).unwrap());
            corners
        };
        prop_assert_eq!(corners(&points), corners(&reversed));
    }
}

/// A hull of a hull is the same; a solid that is its own hull is convex.
#[test]
fn hull_of_a_hull() {
    let hull = check(&scattered(1000, 11));
    let again = check(hull.solid().mesh().vertices());
    assert_eq!(again.faces(), hull.faces());
    let mesh: &TriangleMesh = again.solid().mesh();
    assert_eq!(mesh, hull.solid().mesh());
}
