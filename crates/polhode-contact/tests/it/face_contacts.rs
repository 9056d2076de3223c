//! Face-face contacts of known cases.

use crate::support::{at, cuboid, yaw};
use polhode_contact::{Contact, ContactFeature, Manifold, Side, manifold};
use polhode_spatial::{DVec3, Pose, Rotation};

fn count(result: &Manifold, kind: impl Fn(&ContactFeature) -> bool) -> usize {
    result.contacts.iter().filter(|c| kind(&c.feature)).count()
}

fn is_vertex_of(side: Side) -> impl Fn(&ContactFeature) -> bool {
    move |f| matches!(f, ContactFeature::VertexFace { vertex_of, .. } if *vertex_of == side)
}

fn is_edge_edge(f: &ContactFeature) -> bool {
    matches!(f, ContactFeature::EdgeEdge { .. })
}

fn has_point(contacts: &[Contact], point: DVec3) -> bool {
    contacts.iter().any(|c| (c.geometry.point - point).length() < 1e-14)
}

/// Thesis figure 17: a turned box over the border of another has a contact region with five corners: two crossings of
/// edges and three vertices on faces.
#[test]
fn figure_17() {
    let lower = cuboid(2.0, 2.0, 1.0);
    let upper = cuboid(1.0, 1.0, 1.0);
    let pose = Pose::new(yaw(0.2), DVec3::new(0.58, 0.6, 1.0));
    let result = manifold(&upper, &pose, &lower, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 5, "{result:#?}");
    assert_eq!(count(&result, is_edge_edge), 2);
    assert_eq!((count(&result, is_vertex_of(Side::A)), count(&result, is_vertex_of(Side::B))), (2, 1));
    for contact in &result.contacts {
        assert!((contact.geometry.normal - DVec3::Z).length() < 1e-15);
        assert!((contact.geometry.point.z - 0.5).abs() < 1e-15);
    }
}

/// Bricks of the diamond scenes, overlapping by half and flush in y: four contacts, two vertices of each brick.
#[test]
fn half_overlap_flush() {
    let brick = cuboid(1.0, 0.5, 0.25);
    let result = manifold(&brick, &at(0.5, 0.0, 0.25), &brick, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 4);
    assert_eq!(count(&result, is_vertex_of(Side::A)), 2);
    assert_eq!(count(&result, is_vertex_of(Side::B)), 2);
    for x in [0.0, 0.5] {
        for y in [-0.25, 0.25] {
            assert!(has_point(&result.contacts, DVec3::new(x, y, 0.125)));
        }
    }
}

/// A box over the border of a table: its two rear vertices on the table, and two crossings on the table's edge.
#[test]
fn over_a_table_edge() {
    let table = cuboid(4.0, 4.0, 1.0);
    let brick = cuboid(1.0, 0.5, 0.25);
    let result = manifold(&brick, &at(1.75, 0.0, 0.625), &table, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 4);
    assert_eq!(count(&result, is_vertex_of(Side::A)), 2);
    assert_eq!(count(&result, is_edge_edge), 2);
    for y in [-0.25, 0.25] {
        assert!(has_point(&result.contacts, DVec3::new(1.25, y, 0.5)));
        assert!(has_point(&result.contacts, DVec3::new(2.0, y, 0.5)));
    }
}

/// Equal boxes exactly on each other: four contacts, one for each coincident pair of vertices, all with vertices of the
/// same box.
#[test]
fn aligned_boxes() {
    let brick = cuboid(1.0, 0.5, 0.25);
    let result = manifold(&brick, &at(0.0, 0.0, 0.25), &brick, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 4);
    assert!(count(&result, is_vertex_of(Side::A)) == 4 || count(&result, is_vertex_of(Side::B)) == 4);
}

/// Overhangs from rounding to almost everything keep four contacts at the corners of the overlap.
#[test]
fn overhangs() {
    let cube = cuboid(1.0, 1.0, 1.0);
    for overhang in [1e-15, 1e-12, 1e-9, 1e-3, 0.5, 0.999, 0.999_999] {
        let result = manifold(&cube, &at(overhang, 0.0, 1.0), &cube, &Pose::IDENTITY, 1e-9);
        assert_eq!(result.contacts.len(), 4, "{overhang}: {result:#?}");
        for x in [overhang - 0.5, 0.5] {
            for y in [-0.5, 0.5] {
                let near = |c: &Contact| (c.geometry.point - DVec3::new(x, y, 0.5)).length() < 2e-12;
                assert!(result.contacts.iter().any(near), "{overhang}");
            }
        }
        let diagonal = manifold(&cube, &at(overhang, overhang, 1.0), &cube, &Pose::IDENTITY, 1e-9);
        assert_eq!(diagonal.contacts.len(), 4, "diagonal {overhang}: {diagonal:#?}");
    }
}

/// A box balanced on its edge: the two vertices of the edge, and across the border of a table one vertex and a
/// crossing.
#[test]
fn standing_on_an_edge() {
    let table = cuboid(4.0, 4.0, 1.0);
    let cube = cuboid(1.0, 1.0, 1.0);
    let turn = Rotation::from_rotation_vector(DVec3::Y * std::f64::consts::FRAC_PI_4);
    let height = 0.5 + 0.5 * 2.0_f64.sqrt();
    let result = manifold(&cube, &Pose::new(turn, DVec3::Z * height), &table, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 2);
    assert_eq!(count(&result, is_vertex_of(Side::A)), 2);
    let across = manifold(&cube, &Pose::new(turn, DVec3::new(0.0, 1.75, height)), &table, &Pose::IDENTITY, 1e-9);
    assert_eq!((count(&across, is_vertex_of(Side::A)), count(&across, is_edge_edge)), (1, 1));
    // Along the table's border, edge on edge: the ends are vertices on edges, and there is no crossing.
    let along = manifold(&cube, &Pose::new(turn, DVec3::new(2.0, 0.0, height)), &table, &Pose::IDENTITY, 1e-9);
    assert_eq!((along.contacts.len(), count(&along, is_edge_edge)), (2, 0));
}

/// A cube diagonally above another, with one edge of each along the other: the two ends of the edge, with the vertical
/// normal. Corner to corner: one contact.
#[test]
fn edge_along_edge() {
    let cube = cuboid(1.0, 1.0, 1.0);
    let result = manifold(&cube, &at(1.0, 0.0, 1.0), &cube, &Pose::IDENTITY, 1e-9);
    assert_eq!(result.contacts.len(), 2);
    assert!(result.contacts.iter().all(|c| c.geometry.normal == DVec3::Z), "{result:#?}");
    let corner = manifold(&cube, &at(1.0, 1.0, 1.0), &cube, &Pose::IDENTITY, 1e-9);
    assert_eq!(corner.contacts.len(), 1);
}

/// Two bricks that lean apart with their lower edges together, each the other's mirror image: the edge touches along
/// its whole length, so that both of its ends are contacts, at any angle, whichever brick is called A.
#[test]
fn edges_that_meet_keep_both_ends() {
    let brick = cuboid(1.0, 0.5, 0.25);
    for tilt in [1e-6, 1e-3, 4.9e-3, 5.1e-3, 0.02, 0.2, 0.7] {
        // The lower edge that faces the other brick comes to x = z = 0.
        let pose = |sign: f64| {
            let rotation = Rotation::from_rotation_vector(DVec3::Y * (sign * tilt));
            Pose::new(rotation, -rotation.rotate(DVec3::new(-0.5 * sign, 0.0, -0.125)))
        };
        let (right, left) = (pose(1.0), pose(-1.0));
        for (a, b) in [(&left, &right), (&right, &left)] {
            let result = manifold(&brick, a, &brick, b, 1e-11);
            for y in [-0.25, 0.25] {
                assert!(has_point(&result.contacts, DVec3::new(0.0, y, 0.0)), "tilt {tilt}: {result:#?}");
            }
        }
    }
}

/// A bar that lies almost flat across a corner of a plate, deep in it, slides along: the contact region has four
/// corners at every step. Where a corner of the plate comes to an edge of the bar, the crossing there lies beyond the
/// end of an edge along its own normal, which differs by the small angle from that of the faces; it must stay a
/// contact.
#[test]
fn no_corner_is_missing_where_faces_at_a_small_angle_overlap_deeply() {
    let (bar, plate) = (cuboid(2.0, 0.1, 0.1), cuboid(1.0, 1.0, 1.0));
    let tilt = Rotation::from_rotation_vector(DVec3::new(0.004, 0.003, 0.0));
    for k in 0..200 {
        let pose = Pose::new(tilt * yaw(0.2), DVec3::new(0.24 + 2e-4 * f64::from(k), 0.4, 0.35));
        let result = manifold(&bar, &pose, &plate, &Pose::IDENTITY, 0.0);
        assert_eq!(result.contacts.len(), 4, "at step {k}: {result:#?}");
    }
}

/// Two crossed bars, each tilted along its length by less than the place tolerance: the contacts are those of the
/// faces, and the separation is that of the edges, which is larger. The tilts `alpha` and `beta` reduce the separation
/// of the long edges by the half widths times the tilts, that of the faces by the half lengths times the tilts.
#[test]
fn the_separation_is_not_that_of_a_face_where_edges_in_a_tie_separate_by_more() {
    let (along_x, along_y) = (cuboid(2.0, 0.25, 0.25), cuboid(0.25, 2.0, 0.25));
    let (alpha, beta) = (2e-13, 3e-13);
    let upper = Pose::new(Rotation::from_rotation_vector(DVec3::Y * -alpha), DVec3::Z * 0.25);
    let lower = Pose::new(Rotation::from_rotation_vector(DVec3::X * beta), DVec3::ZERO);
    let result = manifold(&along_x, &upper, &along_y, &lower, 1e-9);
    assert_eq!(result.contacts.len(), 4, "{result:#?}");
    // To a rounding of the sum of half heights.
    let expected = -0.125 * (alpha + beta);
    assert!((result.separation - expected).abs() <= 1e-16, "{:e} for {expected:e}", result.separation);
    let mirrored = manifold(&along_y, &lower, &along_x, &upper, 1e-9);
    assert_eq!(mirrored.separation, result.separation);
}
