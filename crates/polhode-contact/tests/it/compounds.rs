//! Compounds: parts that fill a body are that body. Two boxes side by side must give the results of the one box they
//! make up, with the same contacts and none at the seam, because a body must slide over the seam as over one plane
//! surface.

use crate::derivatives::assert_rate;
use crate::support::{Flight, Random, at, ball, cuboid, floor, l_prism, prism, yaw};
use polhode_contact::{
    Contact, ContactFeature, ImpactSearch, Shape, ShapeError, Side, evaluate, find_impact, manifold, mirror_defect,
    near_manifold, separation, swept_aabb, time_of_further_impact, time_of_impact,
};
use polhode_mesh::{DecompositionSettings, convex_decomposition};
use polhode_spatial::{DVec3, Motion, Pose, Rotation, Still, UnitVector};

/// Rounding of a position or a separation of bodies of size one, m: some operations on coordinates near one.
const ROUNDING: f64 = 1e-13;

/// A box of these sizes about the origin, cut at `x`, `y` into four.
fn quartered(size: DVec3, x: f64, y: f64) -> Shape {
    let mut parts = Vec::new();
    for (low_x, high_x) in [(-0.5 * size.x, x), (x, 0.5 * size.x)] {
        for (low_y, high_y) in [(-0.5 * size.y, y), (y, 0.5 * size.y)] {
            let part = cuboid(high_x - low_x, high_y - low_y, size.z);
            let middle = DVec3::new(0.5 * (low_x + high_x), 0.5 * (low_y + high_y), 0.0);
            parts.push(part.translated(middle).expect("a finite place"));
        }
    }
    Shape::compound(parts).expect("four parts")
}

/// Asserts that two sets of contacts have the same points, normals and separations.
pub(crate) fn assert_same(found: &[Contact], expected: &[Contact], tolerance: f64, what: &str) {
    let same = |a: &Contact, b: &Contact| {
        let (a, b) = (a.geometry, b.geometry);
        a.point.distance(b.point) <= tolerance
            && a.normal.distance(b.normal) <= 1e-9
            && (a.separation - b.separation).abs() <= tolerance
    };
    let missing: Vec<_> = expected.iter().filter(|e| !found.iter().any(|f| same(f, e))).collect();
    let extra: Vec<_> = found.iter().filter(|f| !expected.iter().any(|e| same(f, e))).collect();
    assert!(
        missing.is_empty() && extra.is_empty() && found.len() == expected.len(),
        "{what}: missing {missing:#?}, extra {extra:#?}, found {} of {}",
        found.len(),
        expected.len()
    );
}

/// Moves a pose at which two shapes overlap along a direction until they only touch.
pub(crate) fn touching(shape: &Shape, mut pose: Pose, other: &Shape, other_pose: &Pose, away: DVec3) -> Pose {
    let at = |d: f64, pose: &Pose| Pose { translation: pose.translation + away * d, ..*pose };
    let (mut near, mut far) = (0.0, 20.0);
    for _ in 0..200 {
        let middle = 0.5 * (near + far);
        if separation(shape, &at(middle, &pose), other, other_pose) > 0.0 { far = middle } else { near = middle }
    }
    pose.translation += away * far;
    pose
}

#[test]
fn four_quarters_resting_on_a_plane_or_a_box_have_the_contacts_of_the_whole() {
    let mut random = Random(17);
    let size = DVec3::new(2.0, 1.0, 0.5);
    let whole = cuboid(size.x, size.y, size.z);
    let table = cuboid(1.3, 3.0, 0.4);
    let floor = floor();
    for case in 0..200 {
        let parts = quartered(size, random.between(-0.9, 0.9), random.between(-0.4, 0.4));
        let turn = yaw(if case % 4 == 0 { 0.0 } else { random.between(-3.0, 3.0) });
        let shift = DVec3::new(random.between(-0.9, 0.9), random.between(-0.9, 0.9), 0.0);
        let far = if case % 3 == 0 { DVec3::new(1e6, -1e6, 0.0) } else { DVec3::ZERO };
        let gap = [0.0, 1e-13, -1e-13][case % 3];
        for (name, other, height) in [("floor", &floor, 0.25), ("table", &table, 0.45)] {
            let pose = Pose::new(turn, DVec3::new(0.0, 0.0, height + gap) + shift + far);
            let below = Pose::from_translation(far);
            let expected = manifold(&whole, &pose, other, &below, 1e-9);
            let found = manifold(&parts, &pose, other, &below, 1e-9);
            // Far away a position has the rounding of its coordinates.
            let tolerance = if case % 3 == 0 { 1e-9 } else { 1e-12 };
            assert_same(&found.contacts, &expected.contacts, tolerance, &format!("case {case} on the {name}"));
            assert!((found.separation - expected.separation).abs() <= ROUNDING);
        }
    }
}

/// Contacts within reach are the same, bit for bit; beyond it the separation is not computed, and some value above the
/// reach is given.
#[test]
fn a_near_manifold_is_the_manifold_within_reach() {
    let mut random = Random(29);
    let other = prism(7, 0.5, 0.8);
    let mut within = 0;
    for case in 0..300 {
        let parts = quartered(DVec3::new(2.0, 1.0, 0.5), 0.1, -0.2);
        let pose = random.pose(1.5);
        let whole = manifold(&parts, &pose, &other, &Pose::IDENTITY, 0.1);
        let near = near_manifold(&parts, &pose, &other, &Pose::IDENTITY, 0.1);
        if whole.separation <= 0.1 {
            within += 1;
            assert_eq!(near, whole, "case {case}");
        } else {
            assert!(near.separation > 0.1 && near.contacts.is_empty(), "case {case}: {near:?}");
        }
    }
    assert!((50..250).contains(&within), "{within} of 300 within reach");
}

#[test]
fn quarters_have_the_contacts_of_the_whole_in_both_orders() {
    let mut random = Random(23);
    let size = DVec3::new(2.0, 1.0, 0.5);
    let whole = cuboid(size.x, size.y, size.z);
    let others = [cuboid(0.7, 0.9, 1.1), prism(7, 0.5, 0.8), ball(0.4)];
    for case in 0..300 {
        let parts = quartered(size, random.between(-0.9, 0.9), random.between(-0.4, 0.4));
        let other = &others[case % 3];
        let other_pose = random.pose(1.0);
        let start = Pose::new(random.rotation(), other_pose.translation + 0.1 * random.vector());
        let pose = touching(&whole, start, other, &other_pose, random.direction());
        let expected = manifold(&whole, &pose, other, &other_pose, 1e-10);
        let found = manifold(&parts, &pose, other, &other_pose, 1e-10);
        assert!((found.separation - expected.separation).abs() <= ROUNDING, "case {case}: {}", found.separation);
        assert_same(&found.contacts, &expected.contacts, 1e-9, &format!("case {case}"));
        let swapped = manifold(other, &other_pose, &parts, &pose, 1e-10);
        assert_eq!(swapped.contacts.len(), found.contacts.len());
        for contact in &found.contacts {
            let twin =
                swapped.contacts.iter().find(|c| c.feature == contact.feature.swapped()).expect("the same contact");
            assert!(twin.geometry.normal.distance(-contact.geometry.normal) <= 1e-15);
        }
    }
}

#[test]
fn quarters_have_the_time_of_impact_of_the_whole() {
    let mut random = Random(5);
    let size = DVec3::new(2.0, 1.0, 0.5);
    let whole = cuboid(size.x, size.y, size.z);
    let target = cuboid(3.0, 2.0, 1.0);
    let settings = ImpactSearch::default();
    let mut hits = 0;
    for case in 0..60 {
        let parts = quartered(size, random.between(-0.9, 0.9), random.between(-0.4, 0.4));
        let start = Pose::new(random.rotation(), random.direction() * 5.0);
        let flight = Flight::new(start, -start.translation * 2.0 + random.vector(), random.vector() * 6.0);
        let still = Still(random.pose(1.0));
        let expected = time_of_impact(&whole, &flight, &target, &still, 0.0, 1.0, &settings).expect("an answer");
        let found = find_impact(&parts, &flight, &target, &still, 0.0, 1.0, &settings).expect("an answer");
        match (expected, found.time) {
            (Some(e), Some(f)) => assert!((e - f).abs() <= 1e-13, "case {case}: {e} and {f}"),
            (e, f) => assert_eq!(e, f, "case {case}"),
        }
        hits += usize::from(found.time.is_some());
        let swapped = time_of_impact(&target, &still, &parts, &flight, 0.0, 1.0, &settings).expect("an answer");
        assert!((swapped.unwrap_or(2.0) - found.time.unwrap_or(2.0)).abs() <= 1e-13);
    }
    assert!(hits > 30, "only {hits} of 60 shots hit");
}

/// A body that rests on one part and slides over the seam has no impact there; a step on the way is one. A search of
/// only the parts that are clear at the start gives the same result, and none for a ground of one part.
#[test]
fn sliding_over_a_seam_is_no_impact_and_a_step_is() {
    let settings = ImpactSearch::default();
    let brick = cuboid(0.4, 0.4, 0.2);
    let ground = quartered(DVec3::new(6.0, 2.0, 1.0), 0.1, 0.05);
    let ground_pose = Still(at(0.0, 0.0, -0.5));
    let slide = Flight::new(at(-1.0, 0.0, 0.1), DVec3::X * 2.0, DVec3::ZERO);
    let found = time_of_impact(&brick, &slide, &ground, &ground_pose, 0.0, 1.0, &settings).expect("an answer");
    assert_eq!(found, None);
    let Shape::Compound(compound) = &ground else { panic!("a compound") };
    let mut parts = compound.parts().to_vec();
    // A step of 5 cm whose face is at x = 0.5: the brick's front reaches it after 1.3 m.
    parts.push(cuboid(0.2, 2.0, 0.05).translated(DVec3::new(0.6, 0.0, 0.525)).expect("a place"));
    let stepped = Shape::compound(parts).expect("five parts");
    let hit = time_of_impact(&brick, &slide, &stepped, &ground_pose, 0.0, 1.0, &settings).expect("an answer");
    assert!((hit.expect("a hit") - 0.65).abs() < 1e-12, "{hit:?}");
    let further =
        |of: &Shape| time_of_further_impact(&brick, &slide, of, &ground_pose, 0.0, 1.0, &settings).expect("an answer");
    assert!((further(&stepped).expect("a hit") - 0.65).abs() < 1e-12);
    assert_eq!([further(&ground), further(&cuboid(6.0, 2.0, 1.0))], [None; 2]);
}

/// An L of two exact parts: a brick in its inner corner touches the floor with its four corners and the wall with the
/// part of its side that faces it.
#[test]
fn a_brick_in_the_corner_of_an_l_touches_floor_and_wall() {
    let solid = l_prism([[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]], 2.0);
    let pieces = convex_decomposition(&solid, DecompositionSettings::default()).expect("parts");
    let parts = pieces
        .parts
        .iter()
        .map(|part| Shape::convex(polhode_contact::ConvexPolyhedron::from_mesh(part.solid()).expect("a convex part")));
    let l = Shape::compound(parts.collect()).expect("parts");
    let brick = cuboid(0.5, 0.5, 0.8);
    // Between x = 1 and 1.5, on y = 1, the middle of the depth.
    let found = manifold(&brick, &at(1.25, 1.25, 1.0), &l, &Pose::IDENTITY, 1e-9);
    let count = |n: DVec3| found.contacts.iter().filter(|c| c.geometry.normal.distance(n) < 1e-12).count();
    assert_eq!((count(DVec3::X), count(DVec3::Y), found.contacts.len()), (4, 4, 8), "{:#?}", found.contacts);
    // Away from the wall only the floor.
    let found = manifold(&brick, &at(2.0, 1.25, 1.0), &l, &Pose::IDENTITY, 1e-9);
    assert_eq!(found.contacts.len(), 4, "{:#?}", found.contacts);
    assert!(found.contacts.iter().all(|c| c.geometry.normal == DVec3::Y));
}

/// Every contact's derivatives against differences of its separation along the motion.
#[test]
fn kinematics_of_contacts_of_parts_are_the_derivatives_of_their_separation() {
    let mut random = Random(7);
    let dumbbell = Shape::compound(vec![
        Shape::sphere(0.3).and_then(|s| s.translated(DVec3::X)).expect("a ball"),
        cuboid(1.4, 0.2, 0.2),
        Shape::sphere(0.4).and_then(|s| s.translated(-DVec3::X)).expect("a ball"),
    ])
    .expect("three parts");
    let ball = ball(0.5);
    let mut kinds = std::collections::BTreeSet::new();
    for other in [&dumbbell, &ball, &cuboid(1.0, 1.0, 1.0)] {
        for _ in 0..40 {
            let flights = [(); 2].map(|()| {
                let start = random.pose(0.8);
                Flight::new(start, random.vector(), random.vector())
            });
            let poses = flights.map(|f| f.pose(0.0));
            for contact in manifold(&dumbbell, &poses[0], other, &poses[1], 0.5).contacts {
                kinds.insert(
                    std::mem::discriminant(&contact.feature)
                        == std::mem::discriminant(&ContactFeature::Spheres { center_a: 0, center_b: 0 }),
                );
                assert_rate(contact.feature, [&dumbbell, other], &flights);
            }
        }
    }
    assert_eq!(kinds.len(), 2, "contacts of two spheres and others must both occur");
}

#[test]
fn sizes_boxes_and_mirror_images() {
    let size = DVec3::new(2.0, 1.0, 0.5);
    let parts = quartered(size, 0.3, 0.1);
    assert!((parts.size() - size.length()).abs() < 1e-15);
    assert!((parts.radius() - 0.5 * size.length()).abs() < 1e-15);
    let flight = Flight::new(Pose::IDENTITY, DVec3::X, DVec3::Z);
    let swept = swept_aabb(&parts, &flight, 0.0, 0.1).expect("a box");
    assert!(swept.min().x <= -1.0 && swept.max().x >= 1.1);
    assert!(mirror_defect(&parts, UnitVector::Z, 0.0) < 1e-15);
    assert!(mirror_defect(&parts, UnitVector::X, 0.0) > 0.1);
}

/// Boxes on boxes of any attitude: edges that lie in the other body's plane give no spurious axis by rounding.
#[test]
fn boxes_on_sloped_boxes_have_four_contacts() {
    let mut random = Random(107);
    for case in 0..2000 {
        let turn = random.rotation();
        let (lower, upper) =
            (cuboid(2.0, 2.0, 1.0).placed(&Pose::new(turn, DVec3::ZERO)).expect("a box"), cuboid(0.7, 0.5, 0.4));
        let place = turn.rotate(DVec3::new(random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0.7));
        let pose = Pose::new(turn * yaw(random.between(-3.0, 3.0)), place);
        let found = manifold(&upper, &pose, &lower, &Pose::IDENTITY, 1e-9);
        assert!(found.separation.abs() < 1e-14, "case {case}: {}", found.separation);
        assert_eq!(found.contacts.len(), 4, "case {case}: {found:#?}");
    }
}

#[test]
fn invalid_compounds_are_refused() {
    assert!(matches!(Shape::compound(Vec::new()), Err(ShapeError::NoPart { .. })));
    let floor = floor();
    assert!(matches!(Shape::compound(vec![floor]), Err(ShapeError::NotAPart { .. })));
    let parts = quartered(DVec3::ONE, 0.1, 0.1);
    let lost = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 32, face: 0 };
    assert_eq!(evaluate(lost, &parts, &Pose::IDENTITY, &cuboid(1.0, 1.0, 1.0), &at(0.0, 0.0, 1.0)), None);
    let nan = Pose::from_translation(DVec3::NAN);
    assert!(separation(&parts, &nan, &parts, &Pose::IDENTITY).is_nan());
}

/// A body rocks on an edge, one end of which is a corner of two of its parts. Whichever end is lower, by more than the
/// rounding of places but less than the touch distance, both ends are contacts, as of the body without parts: a contact
/// at the lower end alone would let the other end fall until the two change places, step by step.
#[test]
fn both_ends_of_an_edge_on_which_a_body_of_parts_rocks_are_contacts() {
    let placed = |size: DVec3| cuboid(size.x, size.y, size.z).translated(0.5 * size).expect("a finite place");
    let whole = placed(DVec3::new(2.0, 1.0, 1.0));
    let parts = Shape::compound(vec![placed(DVec3::ONE), whole.clone()]).expect("two parts");
    let on_edge = Rotation::from_rotation_vector(DVec3::X * 0.5);
    for tilt in [-1e-9, -1e-11, -1e-12, 0.0, 1e-12, 1e-11, 1e-9] {
        let turn =
            Rotation::renormalized(Rotation::from_rotation_vector(DVec3::Y * tilt).quaternion() * on_edge.quaternion());
        let pose = Pose::new(turn, DVec3::ZERO);
        let below = Pose::IDENTITY;
        let expected = manifold(&whole, &pose, &floor(), &below, 1e-8);
        assert_eq!(expected.contacts.len(), 2, "tilt {tilt}");
        let found = manifold(&parts, &pose, &floor(), &below, 1e-8);
        assert_same(&found.contacts, &expected.contacts, 1e-12, &format!("tilt {tilt}"));
    }
}
