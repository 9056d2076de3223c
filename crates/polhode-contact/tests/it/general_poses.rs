//! Random poses: against an independent separating-axis test of boxes, and under the symmetries of space.

use crate::support::{Flight, Random, ball, cuboid, hull, prism, yaw};
use polhode_contact::clearance::touch_tolerance;
use polhode_contact::{
    Contact, ContactFeature, ImpactSearch, Manifold, SeparatingAxis, Shape, Side, manifold, separation, time_of_impact,
};
use polhode_spatial::{DVec3, Pose, Rotation, Still};
use std::f64::consts::PI;

/// Separation of two boxes with half sizes `h1`, `h2` over all fifteen axes, written for boxes only.
fn box_separation(h1: DVec3, h2: DVec3, pose: &Pose) -> f64 {
    let own = [DVec3::X, DVec3::Y, DVec3::Z];
    let turned = own.map(|e| pose.rotation.rotate(e));
    let mut axes: Vec<DVec3> = own.iter().chain(&turned).copied().collect();
    axes.extend(
        own.iter().flat_map(|a| turned.map(|b| a.cross(b))).filter(|c| c.length() > 1e-9).map(DVec3::normalize),
    );
    let mut best = f64::NEG_INFINITY;
    for axis in axes {
        let r1 = h1.dot(axis.abs());
        let r2: f64 = turned.iter().zip(h2.to_array()).map(|(e, h)| h * axis.dot(*e).abs()).sum();
        best = best.max(pose.translation.dot(axis).abs() - r1 - r2);
    }
    best
}

/// Two random boxes moved together until their separation is `target`.
fn pressed_together(random: &mut Random, target: f64) -> (DVec3, DVec3, Pose) {
    let half = |r: &mut Random| DVec3::new(0.2 + r.unit(), 0.2 + r.unit(), 0.2 + r.unit());
    let (h1, h2, turn, direction) = (half(random), half(random), random.rotation(), random.direction());
    let (mut low, mut high) = (0.0, 6.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if box_separation(h1, h2, &Pose::new(turn, direction * middle)) < target {
            low = middle;
        } else {
            high = middle;
        }
    }
    (h1, h2, Pose::new(turn, direction * high))
}

/// Two roofs whose ridges cross at a small angle do not penetrate by more than along the vertical direction between the
/// ridges, whatever the angle and however steep they are: where the ridges are nearly parallel, their common
/// perpendicular is uncertain, but the separation is not (before the fix, ridges that touched at 1e-7 rad gave a
/// penetration of 5e-8 of their length).
#[test]
fn nearly_parallel_ridges_do_not_penetrate_by_more_than_along_the_vertical() {
    let mut random = Random(362_436_069);
    for (steepness, exponent) in [1e-3, 0.03, 1.0].into_iter().flat_map(|s| (2..15).map(move |k| (s, k))) {
        let ends = [-0.7, 0.7].map(|y| [DVec3::Y * y, DVec3::new(-0.5, y, -steepness), DVec3::new(0.5, y, -steepness)]);
        let vertices = ends.as_flattened();
        let roof = hull(vertices);
        for _ in 0..100 {
            let angle = random.between(0.1, 1.0) * 10.0_f64.powi(-exponent);
            let gap = random.between(-1.0, 1.0) * 10.0_f64.powf(-random.between(7.0, 15.0));
            let turn = random.rotation();
            let up = turn.rotate(DVec3::Z);
            let (lower, over) = (Pose::new(turn, DVec3::ZERO), Rotation::from_rotation_vector(DVec3::Y * PI));
            let upper = Pose::new(turn * yaw(angle) * over, up * gap);
            let heights = |pose: &Pose| vertices.iter().map(|&p| pose.transform_point(p).dot(up)).collect::<Vec<_>>();
            let lowest = heights(&upper).into_iter().fold(f64::INFINITY, f64::min);
            let along = lowest - heights(&lower).into_iter().fold(f64::NEG_INFINITY, f64::max);
            let found = separation(&roof, &lower, &roof, &upper);
            assert!(found > along.min(0.0) - 4e-15, "{steepness} {angle:e} {gap:e}: {found:e} and {along:e}");
            // The time of impact is that of a fall through the gap.
            let apart = gap.abs() + 1e-3;
            let from = Pose::new(upper.rotation, up * apart);
            let fall = Flight::new(from, -up, DVec3::ZERO);
            let (still, settings) = (Still(lower), ImpactSearch::default());
            let met = time_of_impact(&roof, &still, &roof, &fall, 0.0, 1.0, &settings)
                .expect("an answer")
                .expect("an impact");
            let touch = touch_tolerance(&roof, &lower, &roof, &from, settings.touch_relative);
            assert!((met - apart).abs() <= touch, "{steepness} {angle:e}: {met} and {apart}");
        }
    }
}

/// Boxes in general poses: the separation is that of an independent test, and the deepest contact has that depth. Where
/// a pair of edges decides, there is one contact, or their crossing is among the contacts.
#[test]
fn boxes_against_an_independent_test() {
    let mut random = Random(88_172_645_463_325_252);
    let (mut crossings, mut faces) = (0, 0);
    for depth in [0.0, -1e-9, -1e-3, -0.05, -0.3] {
        for _ in 0..400 {
            let (h1, h2, pose) = pressed_together(&mut random, depth);
            let (a, b) = (cuboid(2.0 * h1.x, 2.0 * h1.y, 2.0 * h1.z), cuboid(2.0 * h2.x, 2.0 * h2.y, 2.0 * h2.z));
            let expected = box_separation(h1, h2, &pose);
            let result = manifold(&a, &Pose::IDENTITY, &b, &pose, 0.01);
            assert!((result.separation - expected).abs() < 4e-15, "{} {expected}", result.separation);
            let deepest = result.contacts.iter().map(|c| c.geometry.separation).fold(f64::INFINITY, f64::min);
            if let SeparatingAxis::Edges(edge_a, edge_b) = result.axis {
                crossings += 1;
                let single = result.contacts.len() == 1;
                assert!(
                    single || result.contacts.iter().any(|c| c.feature == ContactFeature::EdgeEdge { edge_a, edge_b })
                );
            } else {
                faces += 1;
            }
            assert!((deepest - expected).abs() < 4e-15, "{deepest} {expected} {result:#?}");
        }
    }
    assert!(crossings > 200 && faces > 200, "{crossings} {faces}");
}

/// The contacts of a manifold with A and B swapped.
fn with_bodies_swapped(manifold: &Manifold) -> Vec<Contact> {
    let mut contacts = manifold.contacts.clone();
    for contact in &mut contacts {
        contact.feature = contact.feature.swapped();
        contact.geometry.normal = -contact.geometry.normal;
    }
    contacts.sort_by_key(|c| c.feature);
    contacts
}

fn assert_same(left: &[Contact], right: &[Contact], tolerance: f64, place: impl Fn(DVec3) -> DVec3, turn: Rotation) {
    assert_eq!(left.len(), right.len(), "{left:#?} {right:#?}");
    for (l, r) in left.iter().zip(right) {
        assert_eq!(l.feature, r.feature);
        assert!((place(l.geometry.point) - r.geometry.point).length() <= tolerance);
        assert!((turn.rotate(l.geometry.normal) - r.geometry.normal).length() <= 1e3 * tolerance);
        assert!((l.geometry.separation - r.geometry.separation).abs() <= tolerance);
    }
}

fn bodies(random: &mut Random) -> Vec<Shape> {
    vec![
        cuboid(1.0, 0.8, 0.6),
        prism(5, 0.6, 0.9),
        ball(0.45),
        Shape::points((0..6).map(|_| random.vector() * 0.5).collect()).expect("points"),
        Shape::half_space(polhode_spatial::UnitVector::new(random.direction()).expect("unit")),
    ]
}

/// Swapping the bodies swaps the features and reverses the normals. Moving both by 1e6 m or rotating both moves or
/// rotates the contacts, and changes nothing else.
#[test]
fn symmetries() {
    let mut random = Random(42);
    let mut touching = 0;
    for _ in 0..300 {
        let shapes = bodies(&mut random);
        let (turn_a, turn_b) = (random.rotation(), random.rotation());
        let offset = random.direction() * random.between(0.3, 1.1);
        let (pose_a, pose_b) = (Pose::new(turn_a, DVec3::ZERO), Pose::new(turn_b, offset));
        for a in &shapes {
            for b in &shapes {
                let direct = manifold(a, &pose_a, b, &pose_b, 0.1);
                touching += usize::from(!direct.contacts.is_empty());
                let swapped = manifold(b, &pose_b, a, &pose_a, 0.1);
                let identity = Rotation::IDENTITY;
                assert_same(&with_bodies_swapped(&swapped), &direct.contacts, 1e-14, |p| p, identity);
                let same = |x: f64, y: f64| (x > 0.1 && y > 0.1) || (x - y).abs() <= 1e-14;
                assert!(same(direct.separation, swapped.separation), "{direct:?} {swapped:?}");
                assert!(same(direct.separation, separation(a, &pose_a, b, &pose_b)));

                let far = DVec3::new(1e6, -2e6, 3e6);
                let (far_a, far_b) = (Pose::new(turn_a, far), Pose::new(turn_b, offset + far));
                // The poses themselves are rounded to 2^-31 m here.
                assert_same(
                    &direct.contacts,
                    &manifold(a, &far_a, b, &far_b, 0.1).contacts,
                    4e-9,
                    |p| p + far,
                    identity,
                );

                let turn = random.rotation();
                let (turned_a, turned_b) =
                    (Pose::new(turn * turn_a, DVec3::ZERO), Pose::new(turn * turn_b, turn.rotate(offset)));
                let turned = manifold(a, &turned_a, b, &turned_b, 0.1);
                assert_same(&direct.contacts, &turned.contacts, 1e-14, |p| turn.rotate(p), turn);
            }
        }
    }
    assert!(touching > 2000, "{touching}");
}

/// Scaling both bodies and their distance scales the manifold.
#[test]
fn scaling() {
    let mut random = Random(4711);
    for _ in 0..200 {
        let (turn, direction) = (random.rotation(), random.direction() * 0.8);
        let reference =
            manifold(&cuboid(1.0, 0.8, 0.6), &Pose::IDENTITY, &prism(7, 0.5, 0.4), &Pose::new(turn, direction), 0.1);
        for scale in [1e-4, 1e4] {
            let (a, b) = (cuboid(scale, 0.8 * scale, 0.6 * scale), prism(7, 0.5 * scale, 0.4 * scale));
            let scaled = manifold(&a, &Pose::IDENTITY, &b, &Pose::new(turn, direction * scale), 0.1 * scale);
            assert_eq!(scaled.contacts.len(), reference.contacts.len());
            for (s, r) in scaled.contacts.iter().zip(&reference.contacts) {
                assert!((s.geometry.separation - scale * r.geometry.separation).abs() < 1e-14 * scale, "{s:?} {r:?}");
                assert!((s.geometry.point - scale * r.geometry.point).length() < 1e-12 * scale);
            }
        }
    }
}

/// Aligned stacks keep their identities when both bodies turn together: the rule for vertices on vertices follows the
/// bodies.
#[test]
fn coincident_vertices_turn_with_the_bodies() {
    let mut random = Random(99);
    let cube = cuboid(1.0, 1.0, 1.0);
    let upright = manifold(&cube, &Pose::from_translation(DVec3::Z), &cube, &Pose::IDENTITY, 1e-9);
    for _ in 0..200 {
        let turn = random.rotation();
        let turned =
            manifold(&cube, &Pose::new(turn, turn.rotate(DVec3::Z)), &cube, &Pose::new(turn, DVec3::ZERO), 1e-9);
        let features = |m: &Manifold| m.contacts.iter().map(|c| c.feature).collect::<Vec<_>>();
        assert_eq!(features(&turned), features(&upright));
        let swapped =
            manifold(&cube, &Pose::new(turn, DVec3::ZERO), &cube, &Pose::new(turn, turn.rotate(DVec3::Z)), 1e-9);
        assert_eq!(with_bodies_swapped(&swapped).iter().map(|c| c.feature).collect::<Vec<_>>(), features(&upright));
    }
    assert!(
        upright.contacts.iter().all(|c| matches!(c.feature, ContactFeature::VertexFace { vertex_of: Side::B, .. }))
    );
}
