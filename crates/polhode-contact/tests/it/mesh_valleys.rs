//! Valleys of a mesh, where one face ends and the next one rises: a body at the bottom touches both.

use crate::meshes::grid;
use crate::support::Random;
use polhode_contact::{ContactFeature, Shape, Side, SurfaceFeature, evaluate, manifold};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector};

/// Height of the lowest rim point above the bottom, m: touch, and rounding on either side of it.
const HEIGHTS: [f64; 5] = [0.0, 1e-16, -1e-16, 1e-13, -1e-13];

/// The normals of faces of the mesh (A) that a body's contacts have, towards the body.
fn face_normals(valley: &Shape, body: &Shape, pose: &Pose) -> Vec<DVec3> {
    let found = manifold(valley, &Pose::IDENTITY, body, pose, 1e-11);
    let of_face = |feature: &ContactFeature| {
        matches!(
            feature,
            ContactFeature::VertexFace { vertex_of: Side::B, .. }
                | ContactFeature::Elements { a: SurfaceFeature::Face(_), .. }
        )
    };
    found.contacts.iter().filter(|c| of_face(&c.feature)).map(|c| -c.geometry.normal).collect()
}

/// The lowest point of a rim on the bottom line touches both sides of the valley, also where it lies on a vertex of the
/// mesh; with a contact on one side alone it would slide through the other.
#[test]
fn a_rim_in_the_bottom_of_a_valley_touches_both_sides() {
    let valley = grid(10, 10.0, 0.0, &mut Random(3), |x, _| x.abs());
    let shapes = [Shape::cone(0.25, 0.6), Shape::cylinder(0.2, 0.7)];
    for shape in shapes.map(|shape| shape.expect("a shape")) {
        for tilt in [0.83_f64, 1.1, -0.83, -0.95] {
            for y in [0.0, 0.1, 0.5, -1.0] {
                let rotation = Rotation::from_rotation_vector(DVec3::Y * tilt);
                // The rim's lowest place along either wall's normal is the same, because the disc is steeper than both.
                let high = Pose::new(rotation, DVec3::new(0.0, y, 3.0));
                let rim = ContactFeature::Elements { a: SurfaceFeature::Face(0), b: SurfaceFeature::Rim(0) };
                let floor = Shape::half_space(UnitVector::new(DVec3::Z).expect("up"));
                let lowest = evaluate(rim, &floor, &Pose::IDENTITY, &shape, &high).expect("a place");
                let place = lowest.point + DVec3::Z * (0.5 * lowest.separation);
                for height in HEIGHTS {
                    let pose = Pose::new(rotation, high.translation + DVec3::new(-place.x, 0.0, height - place.z));
                    let normals = face_normals(&valley, &shape, &pose);
                    for side in [1.0, -1.0] {
                        let wall = DVec3::new(-side, 0.0, 1.0).normalize();
                        let count = normals.iter().filter(|n| n.dot(wall) > 0.999_999).count();
                        assert_eq!(count, 1, "{shape:?} tilt {tilt} y {y} height {height:e} side {side}: {normals:?}");
                    }
                }
            }
        }
    }
}

/// A disc that lies on one side with its rim in the bottom has all its lowest sample points there, also the one that
/// meets a vertex of the mesh.
#[test]
fn a_disc_that_lies_on_one_side_of_a_valley_keeps_the_point_at_its_bottom() {
    let valley = grid(10, 10.0, 0.0, &mut Random(3), |x, _| x.abs());
    let wall = Shape::half_space(UnitVector::new(DVec3::new(-1.0, 0.0, 1.0)).expect("a normal"));
    let shapes = [Shape::cone(0.25, 0.6), Shape::cylinder(0.25, 0.3)];
    for shape in shapes.map(|shape| shape.expect("a shape")) {
        for y in [0.0, 0.1, 0.5, -1.0] {
            let rotation = Rotation::from_rotation_vector(DVec3::NEG_Y * std::f64::consts::FRAC_PI_4);
            let high = Pose::new(rotation, DVec3::new(0.0, y, 3.0));
            // The rim's end at the bottom is a sample point.
            let ends = (0..16).map(|vertex| ContactFeature::VertexFace { vertex_of: Side::B, vertex, face: 0 });
            let places = ends.filter_map(|f| evaluate(f, &wall, &Pose::IDENTITY, &shape, &high));
            let places = places.map(|g| g.point - g.normal * (0.5 * g.separation));
            let place = places.min_by(|p, q| p.z.total_cmp(&q.z)).expect("a point");
            let pose = Pose::new(rotation, high.translation + DVec3::new(-place.x, 0.0, -place.z));
            let on_plane = manifold(&wall, &Pose::IDENTITY, &shape, &pose, 1e-11).contacts.len();
            let normals = face_normals(&valley, &shape, &pose);
            let on_wall = normals.iter().filter(|n| n.dot(DVec3::new(-1.0, 0.0, 1.0).normalize()) > 0.999_999).count();
            let on_other = normals.iter().filter(|n| n.dot(DVec3::new(1.0, 0.0, 1.0).normalize()) > 0.999_999).count();
            assert_eq!(on_wall, on_plane, "{shape:?} y {y}: {normals:?}");
            assert!(on_other >= 1, "{shape:?} y {y}: {normals:?}");
        }
    }
}
