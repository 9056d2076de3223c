//! Inside, on the surface or outside: exact where arithmetic is, also for rays through edges and vertices, for voids
//! and for parts that overlap.

use crate::convex_hull::scattered;
use crate::shapes::{L_SHAPE, icosphere, joined, solid, torus};
use PointLocation::{Inside, OnSurface, Outside};
use polhode_mesh::{PointLocation, PointLocator, SolidMesh, TriangleMesh, box_mesh, winding_number};
use polhode_spatial::{DVec3, Pose, Rotation};
use proptest::prelude::*;

fn solid_of(mesh: TriangleMesh) -> SolidMesh {
    SolidMesh::new(mesh).unwrap()
}

/// The L is [0, 2] x [0, 1] and [0, 1] x [1, 3], one metre high. On a grid of half metres every ray along z runs
/// through edges, vertices or diagonals, and the answer is known.
#[test]
fn l_shape_on_a_grid() {
    let locator = PointLocator::new(&solid(L_SHAPE));
    for (i, j, k) in (-1..6).flat_map(|i| (-1..8).flat_map(move |j| (-1..4).map(move |k| (i, j, k)))) {
        let p = DVec3::new(f64::from(i), f64::from(j), f64::from(k)) * 0.5;
        let within = |low: DVec3, high: DVec3| {
            (p.cmpge(low).all() && p.cmple(high).all(), p.cmpgt(low).all() && p.cmplt(high).all())
        };
        let (foot, arm) =
            (within(DVec3::ZERO, DVec3::new(2.0, 1.0, 1.0)), within(DVec3::ZERO, DVec3::new(1.0, 3.0, 1.0)));
        let expected = match (foot.0 || arm.0, foot.1 || arm.1) {
            (false, _) => Outside,
            (true, true) => Inside,
            (true, false) => OnSurface,
        };
        assert_eq!(locator.locate(p), expected, "{p}");
    }
}

/// One rounding off a face is off the face.
#[test]
fn one_rounding_decides() {
    let locator = PointLocator::new(&box_mesh(DVec3::ONE).unwrap());
    for axis in DVec3::AXES {
        for sign in [-1.0, 1.0] {
            let at = |distance: f64| locator.locate(axis * sign * distance);
            assert_eq!([at(0.5f64.next_down()), at(0.5), at(0.5f64.next_up())], [Inside, OnSurface, Outside]);
        }
    }
    assert_eq!(locator.locate(DVec3::splat(0.5)), OnSurface);
    assert_eq!(locator.locate(DVec3::NAN), Outside);
    assert_eq!(locator.locate(DVec3::INFINITY), Outside);
}

/// Voids are outside; a ball in the void is inside; where two balls overlap the surface winds twice.
#[test]
fn voids_and_overlaps() {
    let ball = icosphere(2);
    let at = |mesh: &TriangleMesh, x: f64| PointLocator::new(&solid_of(mesh.clone())).winding_number(DVec3::X * x);
    let shell = joined(&[&ball, &ball.scaled(0.5).unwrap().flipped(), &ball.scaled(0.25).unwrap()]);
    assert_eq!([0.0, 0.4, 0.75, 2.0].map(|x| at(&shell, x)), [Some(1), Some(0), Some(1), Some(0)]);
    // Two overlapping balls of different parts: 0, 1 and 2 layers.
    let overlap = joined(&[&ball, &ball.translated(DVec3::new(1.0, 0.1, 0.2)).unwrap()]);
    assert_eq!([-0.5, 0.5, 1.5, 3.0].map(|x| at(&overlap, x)), [Some(1), Some(2), Some(1), Some(0)]);
    for x in [-0.5, 0.5, 1.5, 3.0] {
        let exact = f64::from(at(&overlap, x).unwrap());
        assert!((winding_number(&overlap, DVec3::X * x) - exact).abs() < 1e-14);
    }
}

/// On the surface the generalised winding number is a half; without one triangle of a ball it still tells the sides
/// apart.
#[test]
fn generalised_winding_number() {
    let ball = icosphere(2);
    let [a, b, c] = ball.corners(ball.triangles()[7]);
    assert!((winding_number(&ball, (a + b + c) / 3.0) - 0.5).abs() < 1e-14);
    let open = TriangleMesh::new(ball.vertices().to_vec(), ball.triangles()[1..].to_vec()).unwrap();
    assert!(winding_number(&open, DVec3::ZERO) > 0.99);
    assert!(winding_number(&open, DVec3::X * 1.5).abs() < 0.01);
    assert!(winding_number(&ball, DVec3::NAN).is_nan());
}

/// A million points in a mesh of ten thousand triangles: the share inside is the volume.
#[test]
fn a_million_points() {
    let ball = icosphere(5);
    let locator = PointLocator::new(&solid_of(ball.clone()));
    let start = std::time::Instant::now();
    let inside = scattered(1_000_000, 5).into_iter().filter(|&p| locator.contains(p)).count() as f64;
    println!("1e6 points, {} triangles: {:?}", ball.triangles().len(), start.elapsed());
    let expected = solid_of(ball).volume_integrals().volume / 8.0;
    // Five standard errors of a share of about a half.
    assert!((inside / 1e6 - expected).abs() < 5.0 * 0.5e-3);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    /// Exact crossings and solid angles agree away from the surface, on random star-shaped solids and a torus.
    #[test]
    fn crossings_equal_solid_angles(
        radii in prop::collection::vec(0.3..1.5f64, 42),
        seed in any::<u64>(),
        angle in -3.0..3.0f64,
    ) {
        let sphere = icosphere(1);
        let vertices = sphere.vertices().iter().zip(radii).map(|(&v, radius)| v * radius).collect();
        let star = TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap();
        let turn = Pose::new(Rotation::from_rotation_vector(DVec3::new(angle, 0.3, 1.0)), DVec3::ZERO);
        for mesh in [star, torus(12, 6).in_frame(&turn).unwrap()] {
            let locator = PointLocator::new(&solid_of(mesh.clone()));
            for point in scattered(50, seed) {
                let winding = winding_number(&mesh, point);
                prop_assert!((winding - f64::from(locator.winding_number(point).unwrap())).abs() < 1e-9);
            }
        }
    }

    /// Vertices and middles of edges with exact coordinates are on the surface.
    #[test]
    fn vertices_and_edges_are_on_the_surface(x in 1..20i32, y in 1..20i32, z in 1..20i32) {
        let size = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
        let brick = box_mesh(size).unwrap();
        let locator = PointLocator::new(&brick);
        for [a, b, c] in brick.mesh().corner_positions() {
            for point in [a, (a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5, a * 0.5 + b * 0.25 + c * 0.25] {
                prop_assert_eq!(locator.locate(point), OnSurface);
            }
        }
    }
}
