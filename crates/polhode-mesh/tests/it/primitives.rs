//! Primitives in closed form against the mesh integrals and against exact values.

use crate::shapes::{assert_matrix, assert_relative, assert_same_body, unit_density};
use polhode_mesh::{
    PrimitiveError, box_mesh, hollow_box, hollow_mass_properties, hollow_sphere, solid_box, solid_mass_properties,
    solid_sphere,
};
use polhode_spatial::{DMat3, DVec3, Density, Mass, MassPropertiesError};
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
