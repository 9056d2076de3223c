//! The OBJ reader reads what it should, bit by bit.

use crate::shapes::{L_SHAPE, mesh};
use polhode_mesh::{diagnose, obj};
use polhode_spatial::DVec3;
use proptest::prelude::*;
use std::fmt::Write;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The triangles of a file that begins with the four vertices of a square.
#[track_caller]
fn faces(text: &str) -> Vec<[u32; 3]> {
    mesh(format!("{SQUARE}{text}").as_bytes()).triangles().to_vec()
}

#[test]
fn corners_in_every_form() {
    for face in
        ["f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//2 3//3", "f 1/1/1 2/2/2 3/3/3", "f -4 -3 -2", "f -4/-1/-1 2//7 3"]
    {
        assert_eq!(faces(face), [[0, 1, 2]], "{face}");
    }
}

#[test]
fn a_polygon_is_a_fan_from_its_first_vertex() {
    assert_eq!(faces("f 2 3 4 1"), [[1, 2, 3], [1, 3, 0]]);
    assert_eq!(mesh(L_SHAPE).triangles().len(), 20);
}

/// Negative indices count back from the vertices read so far, not from the last of the file.
#[test]
fn negative_indices_are_relative_to_the_line() {
    let moving = mesh(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -3 -2 -1\n");
    assert_eq!(moving.triangles(), [[0, 1, 2], [1, 2, 3]]);
}

/// A face may come before its vertices.
#[test]
fn forward_references() {
    assert_eq!(mesh(b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").triangles(), [[0, 1, 2]]);
}

#[test]
fn what_is_not_shape_is_ignored() {
    let text = b"\xEF\xBB\xBF# caf\xE9 \xFF\xFE not UTF-8, and a path C:\\models\\\nmtllib a b.mtl\no thing\n\n\
        v 0 0 0 1.0\n\
        v 1 0 0 0.5 0.5 0.5\nv 0 1 0 1.0 0.1 0.2 0.3\nvt 0 nan\nvn 0 0 one\nvp 1\ng a b \\\nc\ns off\nusemtl m\xFF#1\n\
        l 1 2\np 1\n\
        \t f\t1 2   3 # face\n";
    let read = mesh(text);
    assert_eq!(read.vertices(), [DVec3::ZERO, DVec3::X, DVec3::Y]);
    assert_eq!(read.triangles(), [[0, 1, 2]]);
}

/// Unix, DOS and old Macintosh line ends, with continuation in each, give the same mesh.
#[test]
fn line_ends_and_continuation() {
    let text = "v 0 0 \\\n0\nv 1\\\n 0 0\nv 0 1 0\nf 1 \\\n\\\n2 3\\\n";
    let unix = mesh(text.as_bytes());
    assert_eq!(unix.vertices(), [DVec3::ZERO, DVec3::X, DVec3::Y]);
    assert_eq!(unix, mesh(text.replace('\n', "\r\n").as_bytes()));
    assert_eq!(unix, mesh(text.replace('\n', "\r").as_bytes()));
}

/// Numbers are read to the nearest f64: 0.1 is not the f32 that other readers make of it.
#[test]
fn numbers_are_f64() {
    let read = mesh(b"v 0.1 -1e-300 +.5\nv 1. 2E3 -0\nv 123456789.12345679 0 0\nf 1 2 3");
    assert_eq!(read.vertices()[0], DVec3::new(0.1, -1e-300, 0.5));
    assert_eq!(read.vertices()[1], DVec3::new(1.0, 2000.0, 0.0));
    assert_eq!(read.vertices()[2].x, 123456789.12345679);
}

proptest! {
    /// Written with round-trip digits and read back, every coordinate has the same bits and every face its corners.
    #[test]
    fn round_trip(
        points in prop::collection::vec(prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO), 3..40),
        picks in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 1..40),
    ) {
        let mut text = String::new();
        for [x, y, z] in &points {
            writeln!(text, "v {x:?} {y:e} {z}").unwrap();
        }
        let triangles: Vec<[u32; 3]> = picks.iter().map(|t| t.map(|i| i.index(points.len()) as u32)).collect();
        for [a, b, c] in &triangles {
            writeln!(text, "f {}/5 -{} {}//2", a + 1, points.len() as u32 - b, c + 1).unwrap();
        }
        let read = obj::read(text.as_bytes()).unwrap();
        let bits = |v: [f64; 3]| v.map(f64::to_bits);
        prop_assert_eq!(
            read.vertices().iter().map(|v| bits(v.to_array())).collect::<Vec<_>>(),
            points.iter().map(|&v| bits(v)).collect::<Vec<_>>()
        );
        prop_assert_eq!(read.triangles(), &triangles[..]);
        let _ = diagnose(&read);
    }
}
