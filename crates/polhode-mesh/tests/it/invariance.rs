//! What must hold for every solid, on random star-shaped meshes: laws of inertia, and independence of where the mesh
//! lies, how it is turned, how large it is and how it is cut.

use crate::shapes::{assert_matrix, assert_relative, assert_same_body, deformed, icosphere, unit_density};
use polhode_mesh::{
    SolidMesh, TriangleMesh, box_mesh, hollow_mass_properties, solid_box, solid_mass_properties, solid_sphere,
};
use polhode_spatial::{DMat3, DVec3, Density, Mass, MassProperties, Pose, Rotation};
use proptest::prelude::*;

/// Closed meshes that every ray from their middle leaves once: a sphere with random radii, stretched.
fn star_shaped() -> impl Strategy<Value = TriangleMesh> {
    let sphere = icosphere(1);
    let radii = prop::collection::vec(0.2..2.0f64, sphere.vertices().len());
    (radii, stretch()).prop_map(move |(radii, stretch)| {
        let vertices = sphere.vertices().iter().zip(radii).map(|(&v, radius)| v * radius * stretch).collect();
        TriangleMesh::new(vertices, sphere.triangles().to_vec()).unwrap()
    })
}

fn stretch() -> impl Strategy<Value = DVec3> {
    (0.1..3.0f64, 0.1..3.0f64, 0.1..3.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn rotations() -> impl Strategy<Value = Rotation> {
    (-3.0..3.0f64, -3.0..3.0f64, -3.0..3.0f64).prop_map(|(x, y, z)| Rotation::from_rotation_vector(DVec3::new(x, y, z)))
}

fn solid_and_hollow(mesh: &TriangleMesh) -> [MassProperties; 2] {
    [
        solid_mass_properties(&SolidMesh::new(mesh.clone()).unwrap(), unit_density()).unwrap(),
        hollow_mass_properties(mesh, unit_density()).unwrap(),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Principal moments are positive and no one exceeds the sum of the others; the mass is inside the bounding box.
    #[test]
    fn moments_are_those_of_a_body(mesh in star_shaped()) {
        for body in solid_and_hollow(&mesh) {
            let moments = body.principal_axes().moments();
            prop_assert!(moments.x > 0.0 && moments.z <= moments.x + moments.y);
            prop_assert!(mesh.bounds().contains(body.center_of_mass()));
        }
    }

    /// Turning and shifting the mesh turns and shifts the body.
    #[test]
    fn rigid_motion_moves_the_body(mesh in star_shaped(), rotation in rotations(), x in -5.0..5.0f64) {
        let pose = Pose::new(rotation, DVec3::new(x, -2.0 * x, 1.0));
        let moved = solid_and_hollow(&mesh.in_frame(&pose).unwrap());
        for (moved, body) in moved.iter().zip(solid_and_hollow(&mesh)) {
            assert_same_body(moved, &body.in_frame(&pose), mesh.bounds().diagonal(), 1e-12);
        }
    }

    /// A mesh a million sizes away has the same moments to all digits, when its coordinates there are exact.
    #[test]
    fn distance_from_the_origin_costs_no_digits(mesh in star_shaped()) {
        let grid = f64::from(1 << 20);
        let mesh = deformed(&mesh, |v| (v * grid).round() / grid).unwrap();
        let offset = DVec3::new(6.0, -7.0, 5.0) * grid;
        let far = solid_and_hollow(&mesh.translated(offset).unwrap());
        for (far, near) in far.iter().zip(solid_and_hollow(&mesh)) {
            assert_relative(far.mass(), near.mass(), 1e-14);
            assert_matrix(far.inertia().matrix(), near.inertia().matrix(), 1e-13);
            // Here the result itself is rounded to the coordinates at this distance.
            prop_assert!((far.center_of_mass() - offset).distance(near.center_of_mass()) < 4e-9);
        }
    }

    /// Lengths times s: mass s^3 (shell s^2), inertia s^5 (shell s^4).
    #[test]
    fn size_enters_as_a_power(mesh in star_shaped()) {
        for s in [1e-4, 1e4] {
            let scaled = solid_and_hollow(&mesh.scaled(s).unwrap());
            for ((scaled, body), dimension) in scaled.iter().zip(solid_and_hollow(&mesh)).zip([3, 2]) {
                assert_relative(scaled.mass(), body.mass() * s.powi(dimension), 1e-13);
                assert_matrix(scaled.inertia().matrix(), body.inertia().matrix() * s.powi(dimension + 2), 1e-13);
            }
        }
    }

    /// The mirror image of a mesh, its triangles flipped, has the mirrored body: the products change sign.
    #[test]
    fn mirror_image(mesh in star_shaped()) {
        let mirror = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0));
        let image = solid_and_hollow(&deformed(&mesh, |v| mirror * v).unwrap().flipped());
        for (image, body) in image.iter().zip(solid_and_hollow(&mesh)) {
            assert_matrix(image.inertia().matrix(), mirror * body.inertia().matrix() * mirror, 1e-13);
        }
    }

    /// A given mass is the mass; the shape of the inertia is that of any density.
    #[test]
    fn mass_and_density_agree(mesh in star_shaped(), kilograms in 1e-3..1e3f64) {
        let solid = SolidMesh::new(mesh).unwrap();
        let by_mass = solid_mass_properties(&solid, Mass::new(kilograms).unwrap()).unwrap();
        prop_assert_eq!(by_mass.mass(), kilograms);
        let density = Density::new(kilograms / solid.volume_integrals().volume).unwrap();
        let by_density = solid_mass_properties(&solid, density).unwrap();
        assert_same_body(&by_density, &by_mass, 1.0, 1e-14);
    }

    /// A box is the union of the two boxes it is cut into.
    #[test]
    fn a_cut_box_adds_up(size in stretch(), cut in 0.05..0.95f64, rotation in rotations()) {
        let pose = Pose::new(rotation, DVec3::new(3.0, 1.0, -2.0));
        let (left, right) = (size.x * cut, size.x * (1.0 - cut));
        let part = |length: f64, middle: f64| {
            let mesh = box_mesh(DVec3::new(length, size.y, size.z)).unwrap().into_mesh();
            let mesh = mesh.translated(DVec3::X * middle).unwrap().in_frame(&pose).unwrap();
            solid_mass_properties(&SolidMesh::new(mesh).unwrap(), unit_density()).unwrap()
        };
        let whole = solid_box(size, unit_density()).unwrap().in_frame(&pose);
        let sum = part(left, 0.5 * (left - size.x)).combined(&part(right, 0.5 * (size.x - right))).unwrap();
        assert_same_body(&sum, &whole, size.length(), 1e-12);
    }

    /// A meshed ellipsoid of density 1 has less volume than the ellipsoid and tends to it.
    #[test]
    fn ellipsoid_from_a_sphere(stretch in stretch()) {
        let mesh = deformed(&icosphere(3), |v| v * stretch).unwrap();
        let solid = SolidMesh::new(mesh).unwrap();
        let ball = solid_sphere(1.0, unit_density()).unwrap().mass();
        // An affine map scales every volume alike: the ratio is that of the sphere at this level.
        let volume = solid.volume_integrals().volume;
        assert_relative(volume / (ball * stretch.x * stretch.y * stretch.z), 0.9913938426297549, 1e-12);
    }
}
