//! Convex parts fill a solid exactly: volumes, centres and inertias add up, whatever the solid.

use crate::convex_hull::scattered;
use crate::real_meshes::real_mesh;
use crate::shapes::{L_SHAPE, assert_matrix, assert_vector, icosphere, joined, solid, torus, unit_density};
use polhode_mesh::{
    Convexity, Decomposition, DecompositionError, DecompositionSettings, PointLocation, PointLocator, SolidMesh,
    TriangleMesh, box_mesh, convex_decomposition, convexity, diagnose, solid_mass_properties,
};
use polhode_spatial::{DMat3, DVec3, Pose, Rotation};
use proptest::prelude::*;

/// What the issue asks for: the parts add up to the whole to 1e-12.
const TOLERANCE: f64 = 1e-12;

fn decomposed(solid: &SolidMesh) -> Decomposition {
    convex_decomposition(solid, DecompositionSettings::default()).unwrap()
}

/// Mass, centre of mass and inertia of the parts together against the whole; every part is a convex solid.
#[track_caller]
fn check(solid: &SolidMesh) -> Decomposition {
    let found = decomposed(solid);
    assert_eq!(found.unresolved, 0);
    let size = solid.mesh().bounds().diagonal();
    let whole = solid_mass_properties(solid, unit_density()).unwrap();
    assert!(found.volume_error.abs() <= TOLERANCE, "{:e} with {} parts", found.volume_error, found.parts.len());
    let (mut mass, mut moment) = (0.0, DVec3::ZERO);
    for part in &found.parts {
        assert!(diagnose(part.mesh()).is_solid());
        assert_eq!(
            convexity(part.solid()),
            Convexity { excess: 0.0, worst: None, size: part.mesh().bounds().diagonal() }
        );
        let integrals = part.volume_integrals();
        mass += integrals.volume;
        moment += integrals.volume * (integrals.centroid - whole.center_of_mass());
    }
    assert!((mass / whole.mass() - 1.0).abs() <= TOLERANCE);
    assert_vector(moment / mass, DVec3::ZERO, size, TOLERANCE);
    let mut second = DMat3::ZERO;
    for part in &found.parts {
        let integrals = part.volume_integrals();
        let d = integrals.centroid - whole.center_of_mass();
        let outer = DMat3::from_cols(d * d.x, d * d.y, d * d.z);
        second += integrals.second_moment + outer * integrals.volume;
    }
    let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
    assert_matrix(DMat3::from_diagonal(DVec3::splat(trace)) - second, whole.inertia().matrix(), TOLERANCE);
    found
}

fn solid_of(mesh: TriangleMesh) -> SolidMesh {
    SolidMesh::new(mesh).unwrap()
}

/// An L is two boxes: one cut, no volume lost at all.
#[test]
fn l_shape_is_two_boxes() {
    let found = check(&solid(L_SHAPE));
    assert_eq!((found.parts.len(), found.cuts, found.volume_error), (2, 1, 0.0));
}

/// What is convex stays as it is, with its coordinates; what lies apart comes apart without a cut.
#[test]
fn convex_solids_are_not_cut() {
    let ball = icosphere(2);
    let found = check(&solid_of(ball.clone()));
    assert_eq!((found.parts.len(), found.cuts), (1, 0));
    let two = joined(&[&ball, &ball.translated(DVec3::X * 3.0).unwrap()]);
    let found = check(&solid_of(two));
    assert_eq!((found.parts.len(), found.cuts), (2, 0));
}

/// A torus has a hole; a hollow ball a void.
#[test]
fn holes_and_voids() {
    for (n, m) in [(8, 4), (16, 8), (32, 16)] {
        let found = check(&solid_of(torus(n, m)));
        println!("torus {n} x {m}: {} parts, {} cuts, {:e}", found.parts.len(), found.cuts, found.volume_error);
    }
    let ball = icosphere(1);
    let hollow = joined(&[&ball, &ball.scaled(0.5).unwrap().flipped()]);
    let found = check(&solid_of(hollow));
    println!("hollow ball: {} parts, {} cuts, {:e}", found.parts.len(), found.cuts, found.volume_error);
    let brick = box_mesh(DVec3::ONE).unwrap().into_mesh();
    let hollow = joined(&[&brick, &brick.scaled(0.5).unwrap().flipped()]);
    let found = check(&solid_of(hollow));
    println!("hollow box: {} parts, {} cuts, {:e}", found.parts.len(), found.cuts, found.volume_error);
}

/// Real closed meshes of thousands of triangles; those that do not cross themselves (of these the cow does) to 1e-12.
#[test]
fn real_closed_meshes() {
    for name in ["spot", "cow", "fandisk"] {
        let Some(mesh) = real_mesh(name) else { continue };
        let found = decomposed(&solid_of(mesh));
        println!(
            "{name}: {} reflex edges, {} parts, {} cuts, {} flat, {} unresolved, volume {:e}",
            found.reflex_edges,
            found.parts.len(),
            found.cuts,
            found.flat_parts,
            found.unresolved,
            found.volume_error,
        );
        if name != "cow" {
            assert!(found.unresolved == 0 && found.volume_error.abs() <= TOLERANCE);
        }
    }
}

/// A box of n by n columns of different heights, each column of boxes a level apart: many coplanar faces and edges.
fn columns(heights: &[i32], n: usize) -> TriangleMesh {
    // Unit cubes, and between them the faces that only one of two cubes has.
    let is_full = |x: i32, y: i32, z: i32| {
        let within = |i: i32| (0..n as i32).contains(&i);
        within(x) && within(y) && z >= 0 && z < heights[y as usize * n + x as usize]
    };
    let corner = |p: [i32; 3]| p.map(|i| i as u32);
    let side = 12;
    let number = |[x, y, z]: [u32; 3]| (z * side + y) * side + x;
    let vertices = (0..side * side * side)
        .map(|i| DVec3::new(f64::from(i % side), f64::from(i / side % side), f64::from(i / (side * side))))
        .collect();
    let mut triangles = Vec::new();
    let highest = heights.iter().copied().max().unwrap();
    for (x, y, z) in (0..n as i32).flat_map(|x| (0..n as i32).flat_map(move |y| (0..highest).map(move |z| (x, y, z)))) {
        for axis in 0..3 {
            for sign in [0, 1] {
                let mut next = [x, y, z];
                next[axis] += 2 * sign - 1;
                if !is_full(x, y, z) || is_full(next[0], next[1], next[2]) {
                    continue;
                }
                let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
                let at = |du: i32, dv: i32| {
                    let mut p = [x, y, z];
                    p[axis] += sign;
                    p[u] += du;
                    p[v] += dv;
                    number(corner(p))
                };
                let square = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
                let [a, b, c, d] = if sign == 1 { square } else { [square[3], square[2], square[1], square[0]] };
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    TriangleMesh::new(vertices, triangles).unwrap()
}

/// A limit is kept, and the error says how hard the solid is.
#[test]
fn too_many_parts() {
    let solid = solid_of(torus(32, 16));
    let settings = |max_parts| DecompositionSettings { max_parts, ..DecompositionSettings::default() };
    let error = convex_decomposition(&solid, settings(8)).unwrap_err();
    let DecompositionError::TooManyParts { limit, reflex_edges } = error else { panic!("{error}") };
    assert!(limit == 8 && reflex_edges > 8);
    assert!(convex_decomposition(&solid_of(icosphere(0)), settings(0)).is_ok());
}

/// The same solid gives the same parts, bit by bit.
#[test]
fn repeats_bit_by_bit() {
    let solid = solid_of(torus(12, 6));
    assert_eq!(decomposed(&solid), decomposed(&solid));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    /// Star-shaped solids with wild radii, turned and far from the origin. Far away the coordinates know less.
    #[test]
    fn star_shaped(radii in prop::collection::vec(0.2..2.0f64, 42), angle in -3.0..3.0f64, far in 0u32..2) {
        let sphere = icosphere(1);
        let vertices = sphere.vertices().iter().zip(&radii).map(|(&v, &radius)| v * radius).collect();
        let offset = DVec3::new(1e2, -2e2, 5e1) * f64::from(far);
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(angle, 0.3, -1.0)), offset);
        let mesh = TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap().in_frame(&pose).unwrap();
        let solid = solid_of(mesh);
        let found = check(&solid);
        prop_assert!(found.parts.len() > 1);
    }

    /// Convex solids with convex voids of any shape inside.
    #[test]
    fn voids(radii in prop::collection::vec(0.1..0.7f64, 12), x in -0.1..0.1f64) {
        let (ball, sphere) = (icosphere(1), icosphere(0));
        let vertices = sphere.vertices().iter().zip(&radii).map(|(&v, &radius)| v * radius + DVec3::X * x).collect();
        let void = TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap().flipped();
        check(&solid_of(joined(&[&ball, &void])));
    }

    /// Columns of boxes: coplanar faces, edges in one line, many reflex edges in one plane; exact coordinates lose
    /// nothing.
    #[test]
    fn boxes_with_notches(heights in prop::collection::vec(1..4i32, 9), angle in -3.0..3.0f64) {
        let mesh = columns(&heights, 3);
        // Two columns that touch along an edge only are not a manifold.
        let Ok(solid) = SolidMesh::new(mesh.clone()) else { return Ok(()) };
        prop_assert_eq!(check(&solid).volume_error, 0.0);
        let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(angle, 0.3, -1.0)), DVec3::splat(angle));
        check(&solid_of(mesh.in_frame(&pose).unwrap()));
    }

    /// Every point lies in as many parts as the solid winds around it.
    #[test]
    fn points_are_in_one_part(radii in prop::collection::vec(0.3..1.5f64, 12), seed in any::<u64>()) {
        let sphere = icosphere(0);
        let vertices = sphere.vertices().iter().zip(&radii).map(|(&v, &radius)| v * radius).collect();
        let solid = solid_of(TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap());
        let (found, locator) = (decomposed(&solid), PointLocator::new(&solid));
        for point in scattered(100, seed) {
            let holders = found.parts.iter().filter(|part| part.locate(point) == PointLocation::Inside).count();
            prop_assert_eq!(holders, usize::from(locator.locate(point) == PointLocation::Inside));
        }
    }
}
