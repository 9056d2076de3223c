//! Tangential terms of contacts: the tangent basis, closed forms, and the symmetries of space, of all kinds of shapes
//! at random poses and velocities.

use crate::support::{Random, ball, capsule, cone, cuboid, cylinder, floor, prism, ring, tangential};
use polhode_contact::{
    Contact, ContactFeature, ContactKinematics, Shape, Side, SurfaceFeature, TangentialKinematics, kinematics,
    kinematics_with_tangential, manifold, tangent_basis,
};
use polhode_spatial::{DVec3, Pose, Rotation, Velocity};

/// Cosine between normal and x axis above which the basis is made from the y axis, as in the crate.
const NEAR_AXIS_COSINE: f64 = 0.9;

const MIRRORS: [DVec3; 3] = [DVec3::new(-1.0, 1.0, 1.0), DVec3::new(1.0, -1.0, 1.0), DVec3::new(1.0, 1.0, -1.0)];

/// The basis is orthonormal and right-handed to rounding, whatever the normal; of the floor it is x and y, exactly.
#[test]
fn a_tangent_basis_is_right_handed_and_orthonormal() {
    let mut random = Random(31);
    let axes = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
    let near = |cosine: f64| DVec3::new(cosine, (1.0 - cosine * cosine).sqrt(), 0.0);
    let border = [NEAR_AXIS_COSINE, NEAR_AXIS_COSINE + 1e-12, -NEAR_AXIS_COSINE].map(near);
    let normals: Vec<DVec3> = axes.chain(border).chain((0..10_000).map(|_| random.direction())).collect();
    for n in normals {
        let [first, second] = tangent_basis(n);
        assert!((first.cross(second) - n).length() < 1e-15, "{n}");
        let lengths = (first.length() - 1.0).abs().max((second.length() - 1.0).abs());
        let products = first.dot(n).abs().max(second.dot(n).abs()).max(first.dot(second).abs());
        assert!(lengths.max(products) < 1e-15, "{n}: {lengths:e} {products:e}");
    }
    assert_eq!(tangent_basis(DVec3::Z), [DVec3::X, DVec3::Y]);
    assert_eq!(tangent_basis(DVec3::X), [DVec3::Y, DVec3::Z]);
    assert_eq!(tangent_basis(DVec3::Y), [DVec3::X, -DVec3::Z]);
}

/// Swapping the bodies keeps the first tangent and reverses the second one; mirroring them in a coordinate plane
/// mirrors each tangent, up to its sign. Both hold bit for bit.
#[test]
fn a_tangent_basis_of_swapped_and_of_mirrored_bodies() {
    let mut random = Random(37);
    for _ in 0..10_000 {
        let n = random.direction();
        let [first, second] = tangent_basis(n);
        assert_eq!(tangent_basis(-n), [first, -second]);
        for mirror in MIRRORS {
            let [image_first, image_second] = tangent_basis(n * mirror);
            assert!(image_first == first * mirror || image_first == -first * mirror);
            assert!(image_second == second * mirror || image_second == -second * mirror);
        }
    }
}

/// While the x component of the normal does not cross 0.9 or -0.9, the basis turns at most a little more than twice as
/// far as the normal.
#[test]
fn a_tangent_basis_is_smooth_within_either_part_of_the_sphere() {
    let mut random = Random(41);
    let mut largest = 0.0_f64;
    for _ in 0..10_000 {
        let n = random.direction();
        let other = (n + random.direction() * 1e-6).normalize();
        if (n.x.abs() <= NEAR_AXIS_COSINE) != (other.x.abs() <= NEAR_AXIS_COSINE) {
            continue;
        }
        let ([first, _], [moved, _]) = (tangent_basis(n), tangent_basis(other));
        largest = largest.max((moved - first).length() / (other - n).length());
    }
    assert!((1.5..2.3).contains(&largest), "{largest}");
}

/// Normals that are not finite give NaN and no panic.
#[test]
fn input_that_is_not_finite() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(tangent_basis(DVec3::splat(bad)).iter().all(|t| t.is_nan()));
        let (ball, floor) = (ball(0.5), floor());
        let feature = ContactFeature::Smooth { center_of: Side::A, center: 0, against: SurfaceFeature::Face(0) };
        let fast = Velocity::new(DVec3::splat(bad), DVec3::ZERO);
        let pose = Pose::from_translation(DVec3::Z * 0.5);
        let terms = tangential(feature, &ball, &pose, &fast, &floor, &Pose::IDENTITY, &Velocity::ZERO);
        assert!(terms.is_none_or(|terms| !terms.slip_velocity.is_finite()));
        let nowhere = Pose::from_translation(DVec3::splat(bad));
        let none = tangential(feature, &ball, &nowhere, &Velocity::ZERO, &floor, &Pose::IDENTITY, &Velocity::ZERO);
        assert!(none.is_none_or(|terms| !terms.point_velocity.is_finite()));
    }
    let features = ContactFeature::EdgeEdge { edge_a: 0, edge_b: 99 };
    let cube = cuboid(1.0, 1.0, 1.0);
    let pose = Pose::IDENTITY;
    assert_eq!(tangential(features, &cube, &pose, &Velocity::ZERO, &cube, &pose, &Velocity::ZERO), None);
}

/// A ball that rolls on a plane does not slip, its contact point runs below its centre, and nothing but accelerations
/// makes it slip: v = w R, u_T' = v' + w' x r.
#[test]
fn a_ball_that_rolls_on_a_plane() {
    let (ball, floor) = (ball(0.5), floor());
    let feature = ContactFeature::Smooth { center_of: Side::A, center: 0, against: SurfaceFeature::Face(0) };
    let pose = Pose::from_translation(DVec3::new(3.0, 1.0, 0.5));
    // The spin about the vertical changes nothing.
    let velocity = Velocity::new(DVec3::new(2.0, 1.0, 0.0), DVec3::new(-2.0, 4.0, 7.0));
    let terms = tangential(feature, &ball, &pose, &velocity, &floor, &Pose::IDENTITY, &Velocity::ZERO).expect("rolls");
    assert_eq!(terms.basis, [DVec3::X, DVec3::Y]);
    assert_eq!(terms.slip_velocity, DVec3::ZERO);
    assert_eq!(terms.acceleration_bias, DVec3::ZERO);
    assert_eq!(terms.point_velocity, DVec3::new(2.0, 1.0, 0.0));
    assert_eq!(terms.normal_rate, DVec3::ZERO);
}

/// A block at rest on a rotating table slips at a constant -W x r; one that moves with the table does not slip, and
/// would need the centripetal acceleration W x (W x r) to stay so: bias = -W x (W x r).
#[test]
fn a_block_on_a_turning_table() {
    let (cube, table) = (cuboid(0.2, 0.2, 0.2), floor());
    let feature = ContactFeature::VertexFace { vertex_of: Side::A, vertex: 0, face: 0 };
    let pose = Pose::from_translation(DVec3::new(0.6, 0.3, 0.1));
    let turn = DVec3::Z * 3.0;
    let at = |velocity: Velocity| {
        let spin = Velocity::new(DVec3::ZERO, turn);
        kinematics_with_tangential(feature, &cube, &pose, &velocity, &table, &Pose::IDENTITY, &spin).expect("a corner")
    };
    let (normal_terms, still) = at(Velocity::ZERO);
    let r = normal_terms.geometry.point;
    assert!((still.slip_velocity + turn.cross(r)).length() < 1e-15);
    assert!(still.acceleration_bias.length() < 1e-14, "{}", still.acceleration_bias);
    let (_, carried) = at(Velocity::new(turn.cross(pose.translation), turn));
    assert!(carried.slip_velocity.length() < 1e-15);
    // With the acceleration -W x (W x c) of the centre of mass, the corner moves with the table.
    let given = turn.cross(turn.cross(pose.translation));
    assert!((carried.acceleration_bias + given).length() < 1e-14, "{}", carried.acceleration_bias);
}

/// A ball of radius r rolls over a fixed ball of radius R: its centre revolves at the rate W with the speed W (R + r),
/// its spin is W (R + r)/r, the contact point moves at W R, and under the centripetal acceleration alone no slip
/// begins.
#[test]
fn a_ball_that_rolls_over_a_ball() {
    let (big, small) = (0.7, 0.3);
    for angle in [0.0, 0.4, 2.0, 4.0] {
        let up = DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
        let around = DVec3::Y.cross(up);
        let pace = 1.7;
        let center = up * (big + small);
        let velocity = Velocity::new(around * (pace * (big + small)), DVec3::Y * (pace * (big + small) / small));
        let terms = tangential(
            ContactFeature::SphereSphere,
            &ball(small),
            &Pose::from_translation(center),
            &velocity,
            &ball(big),
            &Pose::IDENTITY,
            &Velocity::ZERO,
        )
        .expect("two balls");
        assert!(terms.slip_velocity.length() < 1e-14);
        assert!((terms.point_velocity - around * (pace * big)).length() < 1e-14);
        assert!((terms.normal_rate - around * pace).length() < 1e-14);
        // The given acceleration is along the normal, which the projection takes away.
        assert!(terms.acceleration_bias.length() < 1e-13, "{}", terms.acceleration_bias);
    }
}

fn shapes() -> Vec<Shape> {
    let ridge = vec![
        DVec3::new(-1.0, -1.0, 0.0),
        DVec3::new(1.0, -1.0, 0.0),
        DVec3::new(1.0, 1.0, 0.2),
        DVec3::new(-1.0, 1.0, -0.1),
    ];
    let moved = |shape: Shape, by: DVec3| shape.translated(by).expect("moved");
    vec![
        cuboid(0.5, 0.4, 0.3),
        prism(6, 0.3, 0.4),
        ball(0.2),
        capsule(0.1, 0.6),
        cylinder(0.3, 0.5),
        cone(0.3, 0.5),
        ring(0.3, 0.1),
        floor(),
        Shape::triangle_mesh(ridge, vec![[0, 1, 2], [0, 2, 3]]).expect("mesh"),
        Shape::points(vec![DVec3::new(0.3, 0.2, 0.1), DVec3::new(-0.2, 0.1, 0.4)]).expect("points"),
        Shape::compound(vec![cuboid(0.5, 0.4, 0.3), moved(ball(0.2), DVec3::X * 0.4)]).expect("compound"),
    ]
}

/// Two bodies that move.
#[derive(Clone, Copy)]
struct Pair<'a> {
    shapes: [&'a Shape; 2],
    poses: [Pose; 2],
    velocities: [Velocity; 2],
}

impl Pair<'_> {
    fn both(&self, feature: ContactFeature) -> Option<(ContactKinematics, TangentialKinematics)> {
        let Self { shapes: [a, b], poses: [pose_a, pose_b], velocities: [v_a, v_b] } = self;
        kinematics_with_tangential(feature, a, pose_a, v_a, b, pose_b, v_b)
    }

    fn contacts(&self) -> Vec<Contact> {
        let Self { shapes: [a, b], poses: [pose_a, pose_b], .. } = self;
        manifold(a, pose_a, b, pose_b, 0.3).contacts
    }

    fn swapped(&self) -> Self {
        let [a, b] = self.shapes;
        let ([pose_a, pose_b], [v_a, v_b]) = (self.poses, self.velocities);
        Self { shapes: [b, a], poses: [pose_b, pose_a], velocities: [v_b, v_a] }
    }

    fn mapped(&self, pose: impl Fn(Pose) -> Pose, velocity: impl Fn(Velocity) -> Velocity) -> Self {
        Self { shapes: self.shapes, poses: self.poses.map(pose), velocities: self.velocities.map(velocity) }
    }
}

/// Calls `visit` with every contact of pairs of all kinds at random poses and velocities.
fn each_contact(seed: u64, rounds: u32, mut visit: impl FnMut(&Pair<'_>, ContactFeature, &mut Random)) {
    let (shapes, mut random, mut count) = (shapes(), Random(seed), 0);
    for a in &shapes {
        for b in &shapes {
            for _ in 0..rounds {
                let pose_a = random.pose(1.0);
                let apart = random.direction() * random.between(0.2, 0.7);
                let pose_b = Pose::new(random.rotation(), pose_a.translation + apart);
                let mut velocity = || Velocity::new(random.vector(), random.vector() * 2.0);
                let velocities = [velocity(), velocity()];
                let pair = Pair { shapes: [a, b], poses: [pose_a, pose_b], velocities };
                for contact in pair.contacts() {
                    visit(&pair, contact.feature, &mut random);
                    count += 1;
                }
            }
        }
    }
    assert!(count > 100 * rounds, "{count}");
}

/// Size of the summands of the terms: the speed of the contact point and the rate of the normal.
fn rate(terms: &TangentialKinematics) -> f64 {
    1.0 + terms.point_velocity.length() + terms.normal_rate.length()
}

/// Every vector of `found` is that of `reference` under a map, within a tolerance relative to the size of its summands.
fn assert_same(
    what: &str,
    found: &TangentialKinematics,
    reference: &TangentialKinematics,
    map: impl Fn(DVec3) -> DVec3,
    tolerance: f64,
) {
    let rate = rate(reference);
    let pairs = [
        (found.slip_velocity, reference.slip_velocity),
        (found.normal_rate, reference.normal_rate),
        (found.point_velocity, reference.point_velocity),
        (found.acceleration_bias, reference.acceleration_bias),
    ];
    for (index, (found, expected)) in pairs.into_iter().enumerate() {
        let error = (found - map(expected)).length() / (rate * rate);
        assert!(error < tolerance, "{what}, vector {index}: {error:e} ({rate:.1})");
    }
}

/// With the rates of point and normal chi' = n.V has the derivative that the normal terms give by another formula:
/// n.(w_A x (p' - v_A) - w_B x (p' - v_B)) + n'.V. And the slip lies in the tangent plane, as the rate of the normal
/// does.
#[test]
fn rates_of_point_and_normal_agree_with_the_normal_terms() {
    each_contact(43, 20, |pair, feature, _| {
        let Some((normal_terms, terms)) = pair.both(feature) else { return };
        let [a, b] = pair.velocities;
        let (n, p) = (normal_terms.geometry.normal, normal_terms.geometry.point);
        let velocity = a.at(p - pair.poses[0].translation) - b.at(p - pair.poses[1].translation);
        let carried =
            a.angular.cross(terms.point_velocity - a.linear) - b.angular.cross(terms.point_velocity - b.linear);
        let bias = n.dot(carried) + terms.normal_rate.dot(velocity);
        let rate = rate(&terms);
        let error = (bias - normal_terms.acceleration_bias).abs() / (rate * rate);
        assert!(error < 2e-14, "{feature:?}: {error:e} ({rate:.1})");
        assert!((velocity - n * n.dot(velocity) - terms.slip_velocity).length() < 1e-14, "{feature:?}");
        assert!(n.dot(terms.slip_velocity).abs() < 2e-15 * (1.0 + velocity.length()), "{feature:?}");
        assert!(n.dot(terms.normal_rate).abs() < 2e-14 * rate, "{feature:?}");
        // With the slip the bias turns out of the tangent plane.
        let out = n.dot(terms.acceleration_bias) + terms.normal_rate.dot(velocity);
        assert!(out.abs() < 2e-14 * rate * rate, "{feature:?}: {out:e}");
        assert_eq!(terms.basis, tangent_basis(n));
    });
}

/// The normal terms are those of [`kinematics`], bit for bit.
#[test]
fn normal_terms_are_those_of_kinematics() {
    each_contact(47, 5, |pair, feature, _| {
        let Pair { shapes: [a, b], poses: [pose_a, pose_b], velocities: [v_a, v_b] } = pair;
        let both = pair.both(feature);
        assert_eq!(both.map(|both| both.0), kinematics(feature, a, pose_a, v_a, b, pose_b, v_b));
    });
}

/// Swapping the bodies reverses slip, bias and rate of the normal; the velocity of the point stays the same.
#[test]
fn swapped_bodies() {
    each_contact(53, 20, |pair, feature, _| {
        let (Some((_, terms)), Some((_, swapped))) = (pair.both(feature), pair.swapped().both(feature.swapped()))
        else {
            return;
        };
        let turned = TangentialKinematics { point_velocity: -swapped.point_velocity, ..swapped };
        assert_same(&format!("{feature:?}"), &turned, &terms, |v| -v, 2e-13);
        let [first, second] = terms.basis;
        let found = (swapped.basis[0] - first).length().max((swapped.basis[1] + second).length());
        assert!(found < 1e-11, "{feature:?}: {found:e}");
    });
}

/// Far from the origin only the rounding of the poses changes the terms, and a common velocity of both bodies, however
/// large, does not change them.
#[test]
fn translation_and_common_velocity() {
    let (far, fast) = (DVec3::new(1e6, -2e6, 3e6), DVec3::new(4096.0, -8192.0, 1024.0));
    each_contact(59, 10, |pair, feature, _| {
        // Velocities on a grid, so that the common one is added without rounding.
        let grid = |v: DVec3| (v * 1024.0).round() / 1024.0;
        let pair = pair.mapped(|pose| pose, |v| Velocity::new(grid(v.linear), v.angular));
        let Some((_, terms)) = pair.both(feature) else { return };
        let moved = pair.mapped(|pose| pose, |v| Velocity::new(v.linear + fast, v.angular));
        let (_, carried) = moved.both(feature).expect("the same contact");
        assert_eq!(carried.slip_velocity, terms.slip_velocity);
        assert_eq!(carried.acceleration_bias, terms.acceleration_bias);
        assert!((carried.point_velocity - fast - terms.point_velocity).length() < 1e-11);
        let moved = pair.mapped(|pose| Pose::new(pose.rotation, pose.translation + far), |v| v);
        let Some((_, shifted)) = moved.both(feature) else { return };
        // Poses are rounded to 2^-31 m there, which matters over the distance from where a contact has no normal.
        assert_same(&format!("{feature:?}"), &shifted, &terms, |v| v, 1e-6);
    });
}

/// When both bodies and their velocities are rotated, all vectors rotate with them.
#[test]
fn rotation() {
    each_contact(61, 20, |pair, feature, random| {
        let Some((_, terms)) = pair.both(feature) else { return };
        let turn = random.rotation();
        let turned = pair.mapped(
            |pose| Pose::new(turn * pose.rotation, turn.rotate(pose.translation)),
            |v| Velocity::new(turn.rotate(v.linear), turn.rotate(v.angular)),
        );
        let Some((_, found)) = turned.both(feature) else { return };
        assert_same(&format!("{feature:?}"), &found, &terms, |v| turn.rotate(v), 1e-12);
    });
}

/// The mirror image of two bodies in a coordinate plane has the mirror images of all vectors. The test uses shapes that
/// are their own mirror image; the mirrored contacts have other names, and are identified by their points.
#[test]
fn mirror_images() {
    let mut matched = 0;
    each_contact(67, 20, |pair, feature, _| {
        let symmetric =
            |shape: &Shape| !matches!(shape, Shape::TriangleMesh(_) | Shape::Points(_) | Shape::Compound(_));
        let Some((normal_terms, terms)) = pair.both(feature) else { return };
        if !pair.shapes.iter().all(|shape| symmetric(shape)) {
            return;
        }
        for mirror in MIRRORS {
            let image = |pose: Pose| Pose::new(mirrored_rotation(pose.rotation, mirror), pose.translation * mirror);
            let image_of_velocity = |v: Velocity| Velocity::new(v.linear * mirror, -(v.angular * mirror));
            let mirrored = pair.mapped(image, image_of_velocity);
            let there = normal_terms.geometry.point * mirror;
            let same = |contact: &Contact| {
                contact.geometry.point.distance(there) < 1e-9
                    && contact.geometry.normal.distance(normal_terms.geometry.normal * mirror) < 1e-9
            };
            let Some(contact) = mirrored.contacts().into_iter().find(same) else { continue };
            let Some((_, found)) = mirrored.both(contact.feature) else { continue };
            assert_same(&format!("{feature:?}"), &found, &terms, |v| v * mirror, 1e-11);
            matched += 1;
        }
    });
    assert!(matched > 2000, "{matched}");
}

/// `M R M_x`: the image of a body that is its own mirror image in the plane x = 0 of its frame.
fn mirrored_rotation(rotation: Rotation, mirror: DVec3) -> Rotation {
    let columns = [DVec3::NEG_X, DVec3::Y, DVec3::Z].map(|axis| rotation.rotate(axis) * mirror);
    Rotation::from_matrix(&polhode_spatial::DMat3::from_cols(columns[0], columns[1], columns[2]))
}
