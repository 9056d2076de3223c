//! Where two parts of a compound meet in a re-entrant edge, the bottom of a groove or an inner corner, the body's own
//! normals are those of the two faces beside it and no others. A body at the bottom touches both faces, with contacts
//! over the whole common region; edges of a part that the other part covers have no contacts.

use crate::support::{Random, at, cuboid, hull};
use polhode_contact::{Manifold, Shape, manifold};
use polhode_spatial::{DVec3, Pose};

/// Half the width of the groove at its opening, and its depth, m: its sides have a slope of 45 degrees.
const GROOVE: f64 = 0.3;

/// Largest separation of a touch, m.
const REACH: f64 = 1e-10;

/// The prism over a convex outline in x and y, extended by `half` to either side along z.
fn over(outline: &[[f64; 2]], half: f64) -> Shape {
    let points = [half, -half].map(|z| outline.iter().map(move |&[x, y]| DVec3::new(x, y, z)));
    hull(&points.into_iter().flatten().collect::<Vec<_>>())
}

/// A beam along x in two parts with a groove from below, whose bottom is on the z axis.
fn grooved() -> Shape {
    let right = [[0.0, 0.0], [GROOVE, -GROOVE], [7.5, -GROOVE], [7.5, 0.7], [0.0, 0.7]];
    let left = right.map(|[x, y]| [-x, y]);
    Shape::compound(vec![over(&left, 0.5), over(&right, 0.5)]).expect("two parts")
}

/// How many contacts have this normal.
fn count(found: &Manifold, normal: DVec3) -> usize {
    found.contacts.iter().filter(|contact| contact.geometry.normal.distance(normal) < 1e-9).count()
}

/// Asserts the number of contacts with each normal (towards the body), and that there are no others, for both orders of
/// the pair and for poses rotated and moved together.
fn assert_counts(body: &Shape, pose: Pose, compound: &Shape, normals: &[(DVec3, usize)], what: &str) {
    let mut random = Random(5);
    for turn in 0..20 {
        let whole = if turn == 0 { Pose::IDENTITY } else { random.pose(1.0) };
        let placed = whole * pose;
        let one = manifold(body, &placed, compound, &whole, REACH);
        let other = manifold(compound, &whole, body, &placed, REACH);
        let all: usize = normals.iter().map(|(_, number)| number).sum();
        for &(normal, number) in normals {
            let normal = whole.rotation.rotate(normal);
            assert_eq!(count(&one, normal), number, "{what}, turn {turn}, {normal}: {:#?}", one.contacts);
            assert_eq!(count(&other, -normal), number, "{what}, swapped, turn {turn}: {:#?}", other.contacts);
        }
        assert_eq!((one.contacts.len(), other.contacts.len()), (all, all), "{what}, turn {turn}: {:#?}", one.contacts);
    }
}

#[test]
fn a_knife_at_the_bottom_of_a_groove_touches_both_sides() {
    let knife = over(&[[0.0, 0.0], [0.2, -1.5], [-0.2, -1.5]], 1.0);
    let sides = [DVec3::new(1.0, -1.0, 0.0).normalize(), DVec3::new(-1.0, -1.0, 0.0).normalize()];
    let both = sides.map(|side| (side, 2));
    for shift in [0.0, 3e-13, -3e-13] {
        assert_counts(&knife, at(shift, 0.0, 0.0), &grooved(), &both, &format!("shifted by {shift} m"));
    }
    // A knife shorter than the groove, whose ends are the ends of the contact region.
    let short = over(&[[0.0, 0.0], [0.2, -1.5], [-0.2, -1.5]], 0.25);
    assert_counts(&short, Pose::IDENTITY, &grooved(), &both, "short");
    // A spike that touches the bottom with its tip alone.
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, z)| DVec3::new(0.1 * x, -1.0, 0.1 * z));
    let spike = hull(&[corners.as_slice(), &[DVec3::ZERO]].concat());
    assert_counts(&spike, Pose::IDENTITY, &grooved(), &sides.map(|side| (side, 1)), "spike");
}

#[test]
fn a_brick_that_is_wider_than_an_inner_corner_touches_all_of_it() {
    let wall = cuboid(1.0, 3.0, 0.8).translated(DVec3::new(-0.5, 0.5, 0.0)).expect("a part");
    let floor = cuboid(2.0, 1.0, 0.8).translated(DVec3::new(1.0, -0.5, 0.0)).expect("a part");
    let corner = Shape::compound(vec![wall, floor]).expect("two parts");
    for (width, what) in [(2.0, "wider"), (0.8, "as wide"), (0.5, "narrower")] {
        let brick = cuboid(0.6, 0.5, width);
        assert_counts(&brick, at(0.3, 0.25, 0.0), &corner, &[(DVec3::X, 4), (DVec3::Y, 4)], what);
    }
}

/// Two blocks edge on edge, the edges collinear but one longer: the contacts are the ends of the common part.
#[test]
fn collinear_edges_touch_along_their_common_part() {
    let block = over(&[[0.0, 0.0], [GROOVE, -GROOVE], [7.5, -GROOVE], [7.5, 0.7], [0.0, 0.7]], 0.5);
    let knife = |half: f64| over(&[[0.0, 0.0], [0.2, -1.5], [-0.2, -1.5]], half);
    for (half, shift) in [(0.25, 0.0), (0.25, 0.1), (1.0, 0.0), (0.5, 0.0), (0.5_f64, 0.3_f64)] {
        let (low, high) = ((shift - half).max(-0.5), (shift + half).min(0.5));
        let (knife, pose) = (knife(half), at(0.0, 0.0, shift));
        for found in [
            manifold(&knife, &pose, &block, &Pose::IDENTITY, REACH),
            manifold(&block, &Pose::IDENTITY, &knife, &pose, REACH),
        ] {
            let mut places: Vec<DVec3> = found.contacts.iter().map(|contact| contact.geometry.point).collect();
            places.sort_by(|p, q| p.z.total_cmp(&q.z));
            let expected = [DVec3::Z * low, DVec3::Z * high];
            let apart = |(p, q): (&DVec3, &DVec3)| p.distance(*q) > 1e-12;
            let wrong = places.len() != 2 || places.iter().zip(&expected).any(apart);
            assert!(!wrong, "{half} m, shifted by {shift} m: {places:?}, expected {expected:?}");
        }
    }
}
