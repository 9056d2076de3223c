//! Primitives in closed form against the mesh integrals and against exact values.

use crate::shapes::{assert_matrix, assert_relative, assert_same_body, unit_density};
use polhode_mesh::{
    Capsule, Cone, Cuboid, Cylinder, Ellipsoid, HalfBall, Primitive, PrimitiveError, Refinement, Sphere, Torus,
    box_mesh, hollow_box, hollow_mass_properties, hollow_sphere, solid_box, solid_mass_properties, solid_sphere,
};
use polhode_spatial::{DMat3, DVec3, Density, Mass, MassProperties, MassPropertiesError};
use proptest::prelude::*;
use std::f64::consts::PI;

fn sizes() -> impl Strategy<Value = DVec3> {
    (0.01..10.0f64, 0.01..10.0f64, 0.01..10.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

proptest! {
    /// Closed form and mesh are two ways to the same box, solid and hollow.
    #[test]
    fn box_equals_its_mesh(size in sizes(), density in 1e-3..1e4f64) {
        let mesh = box_mesh(size).unwrap();
        let density = Density::new(density).unwrap();
        let solid = solid_mass_properties(&mesh, density).unwrap();
        assert_same_body(&solid, &solid_box(size, density).unwrap(), size.length(), 1e-14);
        let hollow = hollow_mass_properties(mesh.mesh(), density).unwrap();
        assert_same_body(&hollow, &hollow_box(size, density).unwrap(), size.length(), 1e-14);
    }

    /// A thick shell is a ball less a ball; as it thins out it becomes the hollow sphere, with an error of first order.
    #[test]
    fn hollow_sphere_is_the_limit_of_a_thick_shell(radius in 0.1..10.0f64) {
        let unit = unit_density();
        let moment = |r: f64| solid_sphere(r, unit).unwrap().inertia().matrix().x_axis.x;
        let thin = hollow_sphere(radius, unit).unwrap();
        let error = |wall: f64| {
            let shell = (moment(radius + 0.5 * wall) - moment(radius - 0.5 * wall)) / wall;
            (shell / thin.inertia().matrix().x_axis.x - 1.0).abs()
        };
        // The wall is centred on the radius, so the first order cancels and the second remains: a factor of 4.
        let ratio = error(0.1 * radius) / error(0.05 * radius);
        prop_assert!((ratio - 4.0).abs() < 0.05, "ratio {ratio}");
    }
}

/// Case MP-01 in closed form.
#[test]
fn mp_01_box() {
    let (size, mass) = (DVec3::new(1.0, 2.0, 3.0), Mass::new(6.0).unwrap());
    let solid = solid_box(size, mass).unwrap().inertia().matrix();
    assert_matrix(solid, DMat3::from_diagonal(DVec3::new(6.5, 5.0, 2.5)), 4e-15);
    let hollow = hollow_box(size, mass).unwrap().inertia().matrix();
    let expected = DVec3::new(9.227272727272727, 7.181818181818182, 4.136363636363637);
    assert_matrix(hollow, DMat3::from_diagonal(expected), 1e-14);
}

/// Case MP-12: the small moment of a needle and of a plate is right to the last digit, beside one 5e11 times larger.
#[test]
fn mp_12_needle_and_plate() {
    let mass = Mass::new(1.0).unwrap();
    let needle = solid_box(DVec3::new(1.0, 1e-6, 1e-6), mass).unwrap().principal_axes().moments();
    assert_relative(needle.x, 1.6666666666666667e-13, 1e-15);
    assert_relative(needle.y, 0.08333333333341668, 1e-15);
    assert_relative(needle.z, 0.08333333333341668, 1e-15);
    let plate = solid_box(DVec3::new(1.0, 1.0, 1e-6), mass).unwrap().principal_axes().moments();
    assert_relative(plate.x, 0.08333333333341668, 1e-15);
    assert_relative(plate.z, 0.16666666666666666, 1e-15);
}

#[test]
fn spheres() {
    let solid = solid_sphere(2.0, Density::new(3.0).unwrap()).unwrap();
    assert_relative(solid.mass(), 32.0 * PI, 1e-15);
    assert_matrix(solid.inertia().matrix(), DMat3::IDENTITY * (0.4 * 32.0 * PI * 4.0), 1e-15);
    let hollow = hollow_sphere(2.0, Density::new(3.0).unwrap()).unwrap();
    assert_relative(hollow.mass(), 48.0 * PI, 1e-15);
    assert_matrix(hollow.inertia().matrix(), DMat3::IDENTITY * (2.0 / 3.0 * 48.0 * PI * 4.0), 1e-15);
}

/// Sizes that are no sizes, and bodies beyond f64, are errors that name the value.
#[test]
fn impossible_primitives_are_refused() {
    let unit = unit_density();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let size = DVec3::new(1.0, bad, 1.0);
        assert!(matches!(solid_box(size, unit), Err(PrimitiveError::Size(_))));
        assert!(matches!(hollow_box(size, unit), Err(PrimitiveError::Size(_))));
        assert!(matches!(box_mesh(size), Err(PrimitiveError::Size(_))));
        assert!(matches!(solid_sphere(bad, unit), Err(PrimitiveError::Radius(_))));
        assert!(matches!(hollow_sphere(bad, unit), Err(PrimitiveError::Radius(_))));
    }
    let huge = solid_sphere(1e200, unit).unwrap_err();
    assert_eq!(huge, PrimitiveError::MassProperties(MassPropertiesError::Mass(f64::INFINITY)));
    assert!(matches!(solid_sphere(1e-200, unit), Err(PrimitiveError::MassProperties(_))));
    assert!(matches!(box_mesh(DVec3::new(1.0, 1.0, 1e-18)), Err(PrimitiveError::Mesh(_))));
}

/// One of each kind with curved faces, none of them symmetric by chance.
fn curved() -> Vec<Primitive> {
    vec![
        Primitive::Sphere(Sphere::new(0.7).unwrap()),
        Primitive::Ellipsoid(Ellipsoid::new(DVec3::new(0.5, 1.0, 1.7)).unwrap()),
        Primitive::Cylinder(Cylinder::new(0.6, 1.9).unwrap()),
        Primitive::Cone(Cone::new(0.8, 1.3).unwrap()),
        Primitive::Capsule(Capsule::new(0.4, 1.1).unwrap()),
        Primitive::Torus(Torus::new(1.2, 0.35).unwrap()),
        Primitive::HalfBall(HalfBall::new(1.4).unwrap()),
    ]
}

/// Differences of two bodies of density 1: of mass and moments relative, of the centres in m.
fn differences(found: &MassProperties, expected: &MassProperties) -> [f64; 5] {
    let diagonal = |body: &MassProperties| {
        let m = body.inertia().matrix();
        [m.x_axis.x, m.y_axis.y, m.z_axis.z]
    };
    let (f, e) = (diagonal(found), diagonal(expected));
    let center = found.center_of_mass().distance(expected.center_of_mass());
    [found.mass() / expected.mass() - 1.0, center, f[0] / e[0] - 1.0, f[1] / e[1] - 1.0, f[2] / e[2] - 1.0]
}

/// The thesis's warning about curved surfaces, with its order: the properties of the meshes tend to the closed forms,
/// and their errors fall by 4 when edges are halved. It is also the check of every closed form, solid and hollow, by
/// integrals that know nothing of it: Richardson's extrapolation of two levels, of which the next order remains.
#[test]
fn meshes_converge_to_the_closed_forms_with_order_two() {
    let density = unit_density();
    for primitive in curved() {
        let [coarse, fine] = [4, 5].map(|level| {
            let mesh = primitive.mesh(Refinement::new(level).unwrap()).unwrap();
            let solid = solid_mass_properties(&mesh, density).unwrap();
            let hollow = hollow_mass_properties(mesh.mesh(), density).unwrap();
            [
                differences(&solid, &primitive.solid(density).unwrap()),
                differences(&hollow, &primitive.hollow(density).unwrap()),
            ]
        });
        for (filling, (coarse, fine)) in ["solid", "hollow"].into_iter().zip(coarse.iter().zip(&fine)) {
            for (quantity, (c, f)) in coarse.iter().zip(fine).enumerate() {
                let name = primitive.name();
                println!("{name} {filling} {quantity}: {c:e} {f:e}, ratio {}", c / f);
                // The centre of a symmetric body is exact, to rounding, at every level.
                if quantity == 1 && c.abs() < 1e-15 {
                    continue;
                }
                assert!((c / f - 4.0).abs() < 0.02, "{name} {filling} {quantity}: ratio {}", c / f);
                let extrapolated = (4.0 * f - c) / 3.0;
                assert!(extrapolated.abs() < 2e-5, "{name} {filling} {quantity}: {extrapolated:e}");
            }
        }
    }
}

/// A mesh of a primitive is a solid, inscribed where the body is convex, and its origin is where it is documented.
#[test]
fn meshes_lie_where_the_primitive_does() {
    let mesh = |primitive: Primitive| primitive.mesh(Refinement::COARSEST).unwrap().into_mesh();
    let heights = |primitive: Primitive| {
        let bounds = mesh(primitive).bounds();
        [bounds.min.z, bounds.max.z]
    };
    assert_eq!(heights(Primitive::Cone(Cone::new(1.0, 4.0).unwrap())), [-1.0, 3.0]);
    assert_eq!(heights(Primitive::HalfBall(HalfBall::new(8.0).unwrap())), [-3.0, 5.0]);
    assert_eq!(heights(Primitive::Capsule(Capsule::new(1.0, 4.0).unwrap())), [-3.0, 3.0]);
    assert_eq!(heights(Primitive::Cylinder(Cylinder::new(1.0, 4.0).unwrap())), [-2.0, 2.0]);
    assert_eq!(heights(Primitive::Torus(Torus::new(2.0, 0.5).unwrap())), [-0.5, 0.5]);
    assert_eq!(heights(Primitive::Box(Cuboid::new(DVec3::splat(2.0)).unwrap())), [-1.0, 1.0]);
}

/// A hollow ellipsoid against what is known in closed form: the sphere; the prolate and oblate spheroid's area; a disc
/// of no thickness (twice a disc whose mass per area is uniform); and the sum rule between its three moments.
#[test]
fn hollow_ellipsoids() {
    let unit = unit_density();
    let hollow = |x: f64, y: f64, z: f64| Ellipsoid::new(DVec3::new(x, y, z)).unwrap().hollow(unit).unwrap();
    for radius in [1e-3, 1.0, 7.0] {
        let (found, expected) = (hollow(radius, radius, radius), hollow_sphere(radius, unit).unwrap());
        assert_same_body(&found, &expected, radius, 1e-15);
    }
    for ratio in [1.0 + 1e-3, 1.5, 10.0, 1e4_f64] {
        // Neither asin nor atanh of the eccentricity, which lose digits near 1.
        let e: f64 = f64::sqrt((ratio - 1.0) * (ratio + 1.0)) / ratio;
        let prolate = 2.0 * PI * (1.0 + ratio / e * (1.0 / ratio).acos());
        assert_relative(hollow(1.0, 1.0, ratio).mass(), prolate, 2e-14);
        let oblate = 2.0 * PI * ratio * ratio * (1.0 + ratio.acosh() / (ratio * ratio * e));
        assert_relative(hollow(ratio, 1.0, ratio).mass(), oblate, 2e-14);
    }
    let disc = hollow(3.0, 3.0, 1e-9);
    assert_relative(disc.mass(), 2.0 * PI * 9.0, 1e-14);
    assert_relative(disc.inertia().matrix().z_axis.z, disc.mass() * 4.5, 1e-14);
    // Turned axes, same numbers; scaled, the right powers; a needle as thin as f64 goes is no obstacle.
    let (a, b) = (hollow(1.0, 2.0, 3.0), hollow(2.0, 4.0, 6.0));
    assert_relative(b.mass(), 4.0 * a.mass(), 1e-15);
    assert_relative(b.inertia().matrix().y_axis.y, 16.0 * a.inertia().matrix().y_axis.y, 1e-15);
    assert_relative(hollow(3.0, 1.0, 2.0).inertia().matrix().x_axis.x, a.inertia().matrix().z_axis.z, 1e-15);
    let needle = hollow(1e-70, 1e-70, 1.0);
    assert_relative(needle.mass(), PI * PI * 1e-70, 1e-14);
}

/// Cases MP-08 and MP-11 in closed form, and half a hollow ball with and without its flat face.
#[test]
fn mp_08_and_mp_11() {
    let mass = Mass::new(1.0).unwrap();
    let diagonal = |body: &MassProperties| body.inertia().matrix();
    let torus = Torus::new(1.0, 0.25).unwrap();
    assert_relative(torus.solid(unit_density()).unwrap().mass(), 1.2337005501361697, 1e-15);
    assert_relative(diagonal(&torus.solid(mass).unwrap()).z_axis.z, 1.046875, 1e-15);
    assert_relative(diagonal(&torus.solid(mass).unwrap()).x_axis.x, 0.5390625, 1e-15);
    assert_relative(torus.hollow(unit_density()).unwrap().mass(), 9.869604401089358, 1e-15);
    assert_relative(diagonal(&torus.hollow(mass).unwrap()).z_axis.z, 1.09375, 1e-15);
    assert_relative(diagonal(&torus.hollow(mass).unwrap()).x_axis.x, 0.578125, 1e-15);
    let cone = Cone::new(1.0, 1.0).unwrap().solid(mass).unwrap();
    assert_relative(diagonal(&cone).z_axis.z, 0.3, 1e-15);
    assert_relative(diagonal(&cone).x_axis.x, 0.1875, 1e-15);
    let half = HalfBall::new(1.0).unwrap();
    assert_relative(diagonal(&half.solid(mass).unwrap()).x_axis.x, 0.259375, 1e-15);
    let dome = half.dome(mass).unwrap();
    assert_relative(dome.center_of_mass().z + 0.375, 0.5, 1e-15);
    assert_relative(diagonal(&dome).x_axis.x, 0.4166666666666667, 1e-15);
    // The dome and the flat face together are the hollow half-ball.
    let density = unit_density();
    let disc = MassProperties::new(
        Mass::new(PI).unwrap(),
        DVec3::Z * -0.375,
        polhode_spatial::Inertia::from_diagonal(PI * DVec3::new(0.25, 0.25, 0.5)).unwrap(),
    );
    let both = half.dome(density).unwrap().combined(&disc).unwrap();
    assert_same_body(&both, &half.hollow(density).unwrap(), 1.0, 1e-15);
}

/// Sizes that are no sizes.
#[test]
fn impossible_curved_primitives_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(Cylinder::new(bad, 1.0), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Cylinder::new(1.0, bad), Err(PrimitiveError::Height(_))));
        assert!(matches!(Cone::new(bad, 1.0), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Cone::new(1.0, bad), Err(PrimitiveError::Height(_))));
        assert!(matches!(Capsule::new(bad, 1.0), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Capsule::new(1.0, bad), Err(PrimitiveError::Height(_))));
        assert!(matches!(Torus::new(bad, 1.0), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Torus::new(1.0, bad), Err(PrimitiveError::Radius(_))));
        assert!(matches!(HalfBall::new(bad), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Sphere::new(bad), Err(PrimitiveError::Radius(_))));
        assert!(matches!(Ellipsoid::new(DVec3::new(1.0, bad, 1.0)), Err(PrimitiveError::SemiAxes(_))));
    }
    assert_eq!(Torus::new(1.0, 1.0), Err(PrimitiveError::Tube { major: 1.0, minor: 1.0 }));
    assert_eq!(Refinement::new(9), Err(PrimitiveError::Refinement(9)));
}
