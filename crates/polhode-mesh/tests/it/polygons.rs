//! Polygons are cut into triangles that cover them once, whatever their form and however they lie.

use crate::shapes::assert_relative;
use polhode_mesh::{TriangleMesh, obj};
use polhode_spatial::{DVec3, Rotation};
use proptest::prelude::*;
use std::fmt::Write;

/// The mesh of one polygon.
fn polygon(corners: &[DVec3]) -> TriangleMesh {
    let mut text = String::new();
    for v in corners {
        writeln!(text, "v {:?} {:?} {:?}", v.x, v.y, v.z).unwrap();
    }
    text += "f";
    for i in 1..=corners.len() {
        write!(text, " {i}").unwrap();
    }
    obj::read(text.as_bytes()).unwrap()
}

/// Vector area of a polygon, m^2: along its normal.
fn vector_area(corners: &[DVec3]) -> DVec3 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| (*a - corners[0]).cross(*b - corners[0])).sum::<DVec3>() / 2.0
}

/// The triangles run the polygon's way round and their areas add up to its area, so none overlap; they have `n - 2`
/// triangles and use every side once.
#[track_caller]
fn check(corners: &[DVec3]) {
    let mesh = polygon(corners);
    assert_eq!(mesh.triangles().len(), corners.len() - 2);
    let total = vector_area(corners);
    let mut sum = 0.0;
    for [a, b, c] in mesh.corner_positions() {
        let area = (b - a).cross(c - a) / 2.0;
        assert!(area.dot(total) >= -1e-12 * total.length_squared(), "{:?}", mesh.triangles());
        sum += area.length();
    }
    assert_relative(sum, total.length(), 1e-12);
}

fn plane(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect()
}

#[test]
fn forms() {
    // An arrow head whose fan from the first corner would leave the polygon, a comb, a spiral, and a square with a
    // square hole joined to it by a slit.
    check(&plane(&[[0.0, 0.0], [2.0, -1.0], [0.5, 0.0], [2.0, 1.0]]));
    check(&plane(&[[2.0, 1.0], [0.0, 0.0], [2.0, -1.0], [0.5, 0.0]]));
    check(&plane(&[[2.0, -1.0], [0.5, 0.0], [2.0, 1.0], [0.0, 0.0]]));
    check(&plane(&[
        [0.0, 0.0],
        [7.0, 0.0],
        [7.0, 3.0],
        [6.0, 1.0],
        [5.0, 3.0],
        [4.0, 1.0],
        [3.0, 3.0],
        [2.0, 1.0],
        [1.0, 3.0],
    ]));
    check(&plane(&[
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 5.0],
        [1.0, 5.0],
        [1.0, 2.0],
        [3.0, 2.0],
        [3.0, 3.0],
        [2.0, 3.0],
        [2.0, 4.0],
        [4.0, 4.0],
        [4.0, 1.0],
        [0.0, 1.0],
    ]));
    check(&plane(&[
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [0.0, 3.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [2.0, 2.0],
        [2.0, 1.0],
        [1.0, 1.0],
    ]));
    // Corners in the middle of sides.
    check(&plane(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0], [0.0, 1.0]]));
    check(&plane(&[[1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]));
}

/// Faces without a proper cut keep their fan: the mesh is read and its diagnosis can say what is wrong.
#[test]
fn forms_without_a_cut() {
    for corners in [
        plane(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]),
        plane(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0]]),
        plane(&[[1.0, 1.0]; 5]),
    ] {
        assert_eq!(
            polygon(&corners).triangles(),
            (1..corners.len() as u32 - 1).map(|i| [0, i, i + 1]).collect::<Vec<_>>()
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(256) })]

    /// Star-shaped polygons, turned, moved and scaled at random, beginning at any corner.
    #[test]
    fn random_polygons(
        radii in prop::collection::vec(0.05..1.0f64, 4..40),
        turn in prop::array::uniform3(-3.0..3.0f64),
        shift in prop::array::uniform3(-10.0..10.0f64),
        size in prop::sample::select(vec![1e-4, 1.0, 1e4]),
    ) {
        let rotation = Rotation::from_rotation_vector(DVec3::from_array(turn));
        let step = 2.0 * std::f64::consts::PI / radii.len() as f64;
        let corners: Vec<DVec3> = radii
            .iter()
            .enumerate()
            .map(|(i, r)| {
                let flat = DVec3::new(r * (step * i as f64).cos(), r * (step * i as f64).sin(), 0.0);
                size * (rotation.rotate(flat) + DVec3::from_array(shift))
            })
            .collect();
        check(&corners);
    }
}
