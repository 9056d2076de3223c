//! Mass properties against exact values: rational arithmetic and closed forms (cases MP-01 to MP-09).
//! Inertias are compared element by element where the case says "rel", so a small element may not hide behind a large.

use crate::shapes::{
    L_SHAPE, PYRAMID, assert_matrix, assert_near, assert_relative, assert_vector, icosphere, joined, mesh, solid,
    symmetric, torus, unit_density,
};
use polhode_mesh::{
    SolidMesh, SurfaceIntegrals, TriangleMesh, VolumeIntegrals, box_mesh, hollow_mass_properties, solid_mass_properties,
};
use polhode_spatial::{DMat3, DVec3, Mass, MassProperties};
use std::f64::consts::PI;

/// Moments and products are right to a relative tolerance each; products that are zero, to the tolerance times Ixx.
#[track_caller]
fn assert_inertia(body: &MassProperties, expected: [f64; 6], tolerance: f64) {
    let (found, expected) = (body.inertia().matrix(), symmetric(expected));
    for (f, e) in found.to_cols_array().into_iter().zip(expected.to_cols_array()) {
        assert_near(f, e, if e == 0.0 { expected.x_axis.x } else { e.abs() }, tolerance);
    }
}

#[test]
fn mp_01_box_solid_and_hollow() {
    let brick = box_mesh(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let mass = Mass::new(6.0).unwrap();
    let body = solid_mass_properties(&brick, mass).unwrap();
    assert_inertia(&body, [6.5, 5.0, 2.5, 0.0, 0.0, 0.0], 4e-15);
    assert_eq!(body.center_of_mass(), DVec3::ZERO);
    assert_eq!(body.mass(), 6.0);

    assert_relative(SurfaceIntegrals::of(brick.mesh()).area, 22.0, 1e-14);
    let shell = hollow_mass_properties(brick.mesh(), mass).unwrap();
    assert_inertia(&shell, [9.227272727272727, 7.181818181818182, 4.136363636363637, 0.0, 0.0, 0.0], 1e-14);
}

#[test]
fn mp_02_pyramid_of_figure_8_solid_and_hollow() {
    let pyramid = solid(PYRAMID);
    let body = solid_mass_properties(&pyramid, unit_density()).unwrap();
    assert_relative(body.mass(), 100.0 / 3.0, 1e-15);
    for (found, expected) in body.center_of_mass().to_array().into_iter().zip([2.5, 2.5, 1.0]) {
        assert_relative(found, expected, 1e-15);
    }
    assert_inertia(&body, [185.0 / 3.0, 185.0 / 3.0, 250.0 / 3.0, 0.0, 0.0, 0.0], 1e-14);

    let shell = hollow_mass_properties(pyramid.mesh(), Mass::new(1.0).unwrap()).unwrap();
    assert_relative(SurfaceIntegrals::of(pyramid.mesh()).area, 72.16990566028302, 1e-14);
    assert_relative(shell.center_of_mass().z, 0.8714602987441038, 1e-14);
    let (xx, zz) = (3.0668108785343784, 4.166666666666667);
    assert_inertia(&shell, [xx, xx, zz, 0.0, 0.0, 0.0], 1e-14);
}

/// Also erratum E4: the worked normal of Figure 8 belongs to c = (5, 0, 0).
#[test]
fn figure_8_has_the_normal_of_its_text() {
    let pyramid = mesh(PYRAMID);
    let [a, b, c] = pyramid.corners(pyramid.triangles()[4]);
    assert_eq!((a, b, c), (DVec3::ZERO, DVec3::new(5.0, 5.0, 0.0), DVec3::new(5.0, 0.0, 0.0)));
    assert_eq!((b - a).cross(c - a), DVec3::new(0.0, 0.0, -25.0));
}

/// The published worked example of Tonon 2004; also erratum E1 (1/60, not 1/24).
#[test]
fn mp_03_tetrahedron_of_tonon() {
    let vertices = [[8.3322, -11.86875, 0.93355], [0.75523, 5.0, 16.37072], [52.61236, 5.0, -5.3858], [2.0, 5.0, 3.0]]
        .map(DVec3::from_array);
    let outward = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let given = TriangleMesh::new(vertices.to_vec(), outward).unwrap();
    let given = if VolumeIntegrals::of(&given).volume > 0.0 { given } else { given.flipped() };
    let body = solid_mass_properties(&SolidMesh::new(given).unwrap(), unit_density()).unwrap();
    assert_relative(body.mass(), 1873.2333642164654, 1e-14);
    for (found, expected) in body.center_of_mass().to_array().into_iter().zip([15.9249475, 0.7828125, 3.7296175]) {
        assert_relative(found, expected, 1e-14);
    }
    let expected = [
        43520.3332853933,
        194711.2925907936,
        191168.76488607793,
        -11996.20139323408,
        46343.16738139439,
        -4417.661569685615,
    ];
    // The case lists products of inertia as the matrix holds them, with their minus.
    assert_inertia(&body, expected, 1e-13);
}

const L_INERTIA: [f64; 6] = [41.0 / 12.0, 17.0 / 12.0, 25.0 / 6.0, 0.75, 0.0, 0.0];

#[test]
fn mp_04_l_shape() {
    let body = solid_mass_properties(&solid(L_SHAPE), unit_density()).unwrap();
    assert_relative(body.mass(), 4.0, 1e-15);
    for (found, expected) in body.center_of_mass().to_array().into_iter().zip([0.75, 1.25, 0.5]) {
        assert_relative(found, expected, 1e-15);
    }
    assert_inertia(&body, L_INERTIA, 1e-14);
}

/// Decomposed about the world's origin, Ixx would be -3045 here (erratum E5).
#[test]
fn mp_05_l_shape_far_from_the_origin() {
    let offset = DVec3::new(1e6, -2e6, 3e6);
    let far = SolidMesh::new(mesh(L_SHAPE).translated(offset).unwrap()).unwrap();
    let body = solid_mass_properties(&far, unit_density()).unwrap();
    assert_relative(body.mass(), 4.0, 1e-15);
    assert_vector(body.center_of_mass() - offset, DVec3::new(0.75, 1.25, 0.5), 1.0, 1e-9);
    assert_inertia(&body, L_INERTIA, 1e-14);
}

/// Slivers of aspect 1e9 take part like any other triangle.
#[test]
fn mp_06_box_with_slivers() {
    let sliver = solid(
        b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 1e-9 0 1\nv 0.999999999 0 1\n\
          f 1 4 3 2\nf 8 5 9 10 6 7\nf 1 2 6 10 9 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n",
    );
    let body = solid_mass_properties(&sliver, unit_density()).unwrap();
    assert_relative(body.mass(), 1.0, 1e-14);
    assert_inertia(&body, [1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0, 0.0, 0.0, 0.0], 1e-14);
}

/// A mesh in a sphere has the properties of the mesh, which converge to those of the sphere with the square of the
/// edge.
#[test]
fn mp_07_icosphere() {
    let volume = [
        0.6054613829125257,
        0.8734532000030633,
        0.9661607485985872,
        0.9913938426297549,
        0.9978391716105981,
        0.9994592100828993,
        0.9998647660591581,
    ];
    let solid_moment = [
        0.723606797749979,
        0.9144793057108542,
        0.9773610084260861,
        0.99425746807762,
        0.9985591273707622,
        0.9996394533337989,
        0.9999098427855175,
    ];
    let hollow_moment = [
        0.723606797749979,
        0.914451288944942,
        0.9773588113061089,
        0.9942573245811256,
        0.9985591183099644,
        0.9996394527660751,
        0.9999098427500128,
    ];
    for level in 0..volume.len() {
        let sphere = SolidMesh::new(icosphere(level)).unwrap();
        let body = solid_mass_properties(&sphere, Mass::new(1.0).unwrap()).unwrap();
        assert_relative(sphere.volume_integrals().volume, volume[level] * 4.0 / 3.0 * PI, 1e-12);
        assert_matrix(body.inertia().matrix(), DMat3::IDENTITY * (0.4 * solid_moment[level]), 1e-12);
        let shell = hollow_mass_properties(sphere.mesh(), Mass::new(1.0).unwrap()).unwrap();
        assert_matrix(shell.inertia().matrix(), DMat3::IDENTITY * (2.0 / 3.0 * hollow_moment[level]), 1e-12);
    }
}

/// A hole through the body needs no special care.
#[test]
fn mp_08_torus() {
    for (n, m, volume, moment) in
        [(16, 8, 1.082392200292394, 1.015851792659147), (64, 32, 1.2238205100796165, 1.0448949221477795)]
    {
        let ring = SolidMesh::new(torus(n, m)).unwrap();
        let body = solid_mass_properties(&ring, unit_density()).unwrap();
        assert_relative(body.mass(), volume, 1e-12);
        assert_relative(body.inertia().matrix().z_axis.z / body.mass(), moment, 1e-12);
    }
}

/// A void is subtracted: its surface faces into it. The ratio of meshed to true moments is that of MP-07, level 3.
#[test]
fn mp_09_hollow_ball() {
    let outer = icosphere(3);
    let inner = outer.scaled(0.5).unwrap().flipped();
    let ball = SolidMesh::new(joined(&[&outer, &inner])).unwrap();
    let body = solid_mass_properties(&ball, Mass::new(1.0).unwrap()).unwrap();
    assert_matrix(body.inertia().matrix(), DMat3::IDENTITY * (0.44285714285714284 * 0.99425746807762), 1e-12);
}

/// A hollow mesh need not be closed: a lone square has the moments of a thin plate, and Izz = Ixx + Iyy.
#[test]
fn open_surface_is_a_plate() {
    let square = mesh(b"v 0 0 7\nv 2 0 7\nv 2 2 7\nv 0 2 7\nf 1 2 3 4");
    let plate = hollow_mass_properties(&square, Mass::new(3.0).unwrap()).unwrap();
    assert_inertia(&plate, [1.0, 1.0, 2.0, 0.0, 0.0, 0.0], 1e-15);
    assert_eq!(plate.center_of_mass(), DVec3::new(1.0, 1.0, 7.0));
}
