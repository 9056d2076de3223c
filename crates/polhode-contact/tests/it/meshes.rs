//! Triangle meshes as ground. A plane of triangles must give the results of the plane: the same contacts however it is
//! divided, none twice and none at an inner edge, because wrong normals at inner edges make bodies catch on flat
//! ground.

use crate::compounds::{assert_same, touching};
use crate::support::{Random, ball, cuboid, cylinder, floor, hull, prism, ring, yaw};
use polhode_contact::{ConvexPolyhedron, Shape, ShapeError, aabb_of, evaluate, manifold, mirror_defect, separation};
use polhode_spatial::{DVec3, Pose, Rotation, UnitVector};

/// A square of `n` by `n` cells about the origin with this side; inner vertices are moved within the plane by up to
/// `jitter` cells, diagonals are random, heights are given by a function.
pub(crate) fn grid(n: u32, side: f64, jitter: f64, random: &mut Random, height: impl Fn(f64, f64) -> f64) -> Shape {
    let cell = side / f64::from(n);
    let mut vertices = Vec::new();
    for i in 0..=n {
        for j in 0..=n {
            let mut place = DVec3::new(f64::from(i) * cell - 0.5 * side, f64::from(j) * cell - 0.5 * side, 0.0);
            if i % n != 0 && j % n != 0 {
                place += DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0) * (jitter * cell);
            }
            vertices.push(DVec3::new(place.x, place.y, height(place.x, place.y)));
        }
    }
    let mut triangles = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let at = |i: u32, j: u32| i * (n + 1) + j;
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            if random.unit() < 0.5 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    Shape::triangle_mesh(vertices, triangles).expect("a grid")
}

fn tetrahedron() -> Shape {
    let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(0.2, 0.3, 0.9)].map(|p| p - DVec3::new(0.3, 0.3, 0.2));
    hull(&points)
}

fn scaled(shape: &Shape, by: f64) -> Shape {
    match shape {
        Shape::Convex(p) => {
            let points: Vec<DVec3> = p.vertices().iter().map(|v| *v * by).collect();
            let faces = p.faces().map(|f| f.vertices.to_vec()).collect();
            Shape::convex(ConvexPolyhedron::from_faces(points, faces).expect("a polyhedron"))
        }
        _ => panic!("a polyhedron"),
    }
}

/// The lowest height of a shape's vertices.
fn lowest(shape: &Shape, rotation: Rotation) -> f64 {
    let Shape::Convex(p) = shape else { panic!("a polyhedron") };
    p.vertices().iter().map(|v| rotation.rotate(*v).z).fold(f64::INFINITY, f64::min)
}

#[test]
fn polyhedra_on_a_flat_grid_have_the_contacts_of_a_half_space() {
    let mut random = Random(31);
    let floor = floor();
    let bodies = [cuboid(1.0, 0.6, 0.4), tetrahedron(), prism(5, 0.4, 0.3), prism(12, 0.5, 0.3)];
    for case in 0..240 {
        let scale = [1.0, 1e-4, 1e4][case % 3];
        let jitter = if case % 2 == 0 { 0.0 } else { 0.3 };
        let mesh = grid(10, 4.0 * scale, jitter, &mut random, |_, _| 0.0);
        let body = scaled(&bodies[case % 4], scale);
        let spin = if case % 8 == 0 { Rotation::IDENTITY } else { yaw(random.between(-3.0, 3.0)) };
        let turn = if case % 5 == 4 { random.rotation() } else { spin };
        let gap = [0.0, 1e-13, -1e-13][case / 3 % 3] * scale;
        let shift = if case % 8 == 0 { DVec3::ZERO } else { random.vector() };
        let place = DVec3::new(shift.x * scale, shift.y * scale, gap - lowest(&body, turn));
        // The ground is rotated as a whole, and far from the origin.
        let ground = Pose::new(
            if case % 7 < 3 { Rotation::IDENTITY } else { random.rotation() },
            if case % 4 == 1 { DVec3::new(1e6, 2e6, -1e6) } else { DVec3::ZERO },
        );
        let pose = Pose::new(ground.rotation * turn, ground.translation + ground.rotation.rotate(place));
        let reach = 1e-9 * scale;
        let far = if case % 4 == 1 { 1e-9 } else { 0.0 };
        let expected = manifold(&body, &pose, &floor, &ground, reach + far);
        let found = manifold(&body, &pose, &mesh, &ground, reach + far);
        let tolerance = 1e-12 * scale + far;
        assert_same(&found.contacts, &expected.contacts, tolerance, &format!("case {case}"));
        assert!((found.separation - expected.separation).abs() <= 1e-13 * scale + far, "case {case}");
        let swapped = manifold(&mesh, &ground, &body, &pose, reach + far);
        assert_eq!(swapped.contacts.len(), found.contacts.len());
        for contact in &found.contacts {
            let twin = swapped.contacts.iter().find(|c| c.feature == contact.feature.swapped()).expect("the contact");
            assert_eq!(twin.geometry.normal, -contact.geometry.normal);
            assert!(contact.geometry.margin > 0.0, "case {case}: {contact:?}");
        }
    }
}

/// The same with the ground's vertices rotated and moved, so that no two triangles have the same bits of the normal.
#[test]
fn polyhedra_on_a_sloped_grid_have_the_contacts_of_the_slope() {
    let mut random = Random(101);
    let bodies = [cuboid(1.0, 0.6, 0.4), tetrahedron(), prism(5, 0.4, 0.3), prism(12, 0.5, 0.3)];
    for case in 0..200 {
        let jitter = if case % 2 == 0 { 0.0 } else { 0.3 };
        let slope = random.pose(1.0);
        let mesh = grid(10, 4.0, jitter, &mut random, |_, _| 0.0).placed(&slope).expect("a mesh");
        let floor = floor().placed(&slope).expect("a half-space");
        let body = &bodies[case % 4];
        let turn = if case % 8 == 0 { Rotation::IDENTITY } else { yaw(random.between(-3.0, 3.0)) };
        let shift = if case % 8 == 0 { DVec3::ZERO } else { random.vector() };
        let place = DVec3::new(shift.x, shift.y, -lowest(body, turn));
        let pose = Pose::new(slope.rotation * turn, slope.transform_point(place));
        let expected = manifold(body, &pose, &floor, &Pose::IDENTITY, 1e-9);
        let found = manifold(body, &pose, &mesh, &Pose::IDENTITY, 1e-9);
        assert_same(&found.contacts, &expected.contacts, 1e-12, &format!("case {case}"));
        // The normal of the plane that the rotated vertices span: a rounded rotation is not exactly orthogonal.
        let normal = slope.rotation.rotate(DVec3::X).cross(slope.rotation.rotate(DVec3::Y)).normalize();
        // The rotated vertices have the rounding of a dozen operations on lengths up to 4 m (4e-16 m each) over a
        // ground of 4 m; all contacts have the one normal of the patch.
        let off = found.contacts.iter().map(|c| c.geometry.normal.distance(normal)).fold(0.0, f64::max);
        let first = found.contacts[0].geometry.normal;
        assert!(found.contacts.iter().all(|c| c.geometry.normal == first), "case {case}");
        assert!(off < 16.0 * f64::EPSILON, "case {case}: {off:e} {found:#?}");
    }
}

/// A corner of a body on the tip of a spike, and on a vertex and an edge of a ridge: the separating axis is not unique,
/// but there must be a contact with an upward normal.
#[test]
fn a_corner_on_a_spike_or_a_ridge_has_a_contact() {
    let mut random = Random(103);
    let body = cuboid(1.0, 1.0, 1.0);
    for case in 0..100 {
        let turn = random.rotation();
        let Shape::Convex(polyhedron) = &body else { panic!("a box") };
        let corners = polyhedron.vertices().iter().map(|v| turn.rotate(*v));
        let corner = corners.min_by(|a, b| a.z.total_cmp(&b.z)).expect("a corner");
        let spike = grid(10, 4.0, 0.0, &mut random, |x, y| if x.abs() + y.abs() < 0.1 { 1.0 } else { 0.0 });
        let ridge = folded(-3.0, &mut random);
        for (mesh, tip) in
            [(&spike, DVec3::Z), (&ridge, DVec3::ZERO), (&ridge, DVec3::Y * 0.4), (&ridge, DVec3::Y * 0.1)]
        {
            let found = manifold(&body, &Pose::new(turn, tip - corner), mesh, &Pose::IDENTITY, 1e-9);
            assert!(found.separation.abs() < 1e-12, "case {case} at {tip}: {}", found.separation);
            assert!(!found.contacts.is_empty(), "case {case} at {tip}: {found:#?}");
            for contact in &found.contacts {
                assert!(contact.geometry.normal.z > 0.0 && contact.geometry.point.distance(tip) < 1e-12);
            }
        }
    }
}

/// A plateau smaller than the body: the crossings and corners of its border are contacts too.
#[test]
fn polyhedra_on_a_small_plateau_have_the_contacts_of_a_box_of_its_outline() {
    let mut random = Random(37);
    let body = cuboid(1.0, 0.6, 0.4);
    let table = cuboid(0.8, 0.8, 0.2);
    for case in 0..200 {
        let mesh = grid(4, 0.8, 0.3, &mut random, |_, _| 0.1);
        let turn = if case % 4 == 0 { Rotation::IDENTITY } else { yaw(random.between(-3.0, 3.0)) };
        let shift = if case % 8 == 0 { DVec3::ZERO } else { random.vector() * 0.6 };
        let pose = Pose::new(turn, DVec3::new(shift.x, shift.y, 0.3));
        let expected = manifold(&body, &pose, &table, &Pose::IDENTITY, 1e-9);
        let found = manifold(&body, &pose, &mesh, &Pose::IDENTITY, 1e-9);
        assert_same(&found.contacts, &expected.contacts, 1e-12, &format!("case {case}"));
        // From below, the sheet's other side.
        let below = Pose::new(turn, DVec3::new(shift.x, shift.y, -0.1));
        let under = manifold(&body, &below, &mesh, &Pose::IDENTITY, 1e-9);
        assert_eq!(under.contacts.len(), expected.contacts.len(), "case {case}");
        assert!(under.contacts.iter().all(|c| c.geometry.normal.distance(-DVec3::Z) < 1e-15));
    }
}

#[test]
fn a_ball_on_a_flat_grid_has_one_contact_with_the_plane_s_normal() {
    let mut random = Random(41);
    let ball = ball(0.5);
    let mesh = grid(10, 4.0, 0.0, &mut random, |_, _| 0.0);
    let cell = 0.4;
    for case in 0..300 {
        let (i, j) = (f64::from(case % 5), f64::from(case / 5 % 5));
        // Over a vertex, over an edge, or at a random point.
        let x = if case % 3 < 2 { i * cell } else { random.between(-1.5, 1.5) };
        let y = if case % 3 < 1 { j * cell } else { random.between(-1.5, 1.5) };
        let gap = [0.0, 1e-13, -1e-13, -0.1, 1e-3][case as usize % 5];
        let pose = Pose::from_translation(DVec3::new(x, y, 0.5 + gap));
        let found = manifold(&ball, &pose, &mesh, &Pose::IDENTITY, 2e-3);
        assert_eq!(found.contacts.len(), 1, "case {case}: {found:#?}");
        assert_eq!(found.contacts[0].geometry.normal, DVec3::Z);
        assert!((found.contacts[0].geometry.separation - gap).abs() < 1e-15);
        assert!((found.separation - gap).abs() < 1e-15);
    }
}

/// A ground with one fold along y: a ridge where the slope `up` is negative, a valley where it is positive.
fn folded(up: f64, random: &mut Random) -> Shape {
    grid(10, 4.0, 0.0, random, |x, _| up * x.abs())
}

#[test]
fn a_ball_touches_a_valley_twice_a_ridge_once_and_a_spike_at_its_tip() {
    let mut random = Random(43);
    let ball = ball(0.5);
    let deep = 0.5 * std::f64::consts::SQRT_2;
    for y in [0.0, 0.1, 0.4, 0.53] {
        let valley = folded(1.0, &mut random);
        let found = manifold(&ball, &Pose::from_translation(DVec3::new(0.0, y, deep)), &valley, &Pose::IDENTITY, 1e-9);
        assert_eq!(found.contacts.len(), 2, "valley at {y}: {found:#?}");
        let ridge = folded(-1.0, &mut random);
        let found = manifold(&ball, &Pose::from_translation(DVec3::new(0.0, y, 0.5)), &ridge, &Pose::IDENTITY, 1e-9);
        assert_eq!(found.contacts.len(), 1, "ridge at {y}: {found:#?}");
        assert!(found.contacts[0].geometry.normal.distance(DVec3::Z) < 1e-15);
    }
    let spike = grid(10, 4.0, 0.0, &mut random, |x, y| if x.abs() + y.abs() < 0.1 { 1.0 } else { 0.0 });
    let pose = Pose::from_translation(DVec3::new(0.01, 0.0, 1.5));
    let found = manifold(&ball, &pose, &spike, &Pose::IDENTITY, 1e-3);
    assert_eq!(found.contacts.len(), 1, "{found:#?}");
    assert!(found.contacts[0].geometry.normal.distance((DVec3::new(0.01, 0.0, 0.5)).normalize()) < 1e-14);
}

#[test]
fn boxes_on_a_ridge_in_a_valley_and_over_a_crack() {
    let mut random = Random(47);
    let body = cuboid(1.0, 0.6, 0.4);
    let count = |found: &polhode_contact::Manifold, n: DVec3| {
        found.contacts.iter().filter(|c| c.geometry.normal.distance(n) < 1e-12).count()
    };
    // Flat on a ridge: the ridge leaves the body's face at two places.
    let ridge = folded(-1.0, &mut random);
    let found = manifold(&body, &Pose::from_translation(DVec3::new(0.1, 0.05, 0.2)), &ridge, &Pose::IDENTITY, 1e-9);
    assert_eq!((count(&found, DVec3::Z), found.contacts.len()), (2, 2), "{found:#?}");
    // In a valley, turned by 45 degrees: two faces, four corners each.
    let valley = folded(1.0, &mut random);
    let turn = Rotation::from_rotation_vector(DVec3::Y * (0.25 * std::f64::consts::PI));
    let corners = [0.5, -0.5].map(|x| turn.rotate(DVec3::new(x, 0.0, -0.2)));
    let lowest = corners.into_iter().min_by(|a, b| a.z.total_cmp(&b.z)).expect("a corner");
    let pose = Pose::new(turn, DVec3::new(-lowest.x, 0.05, -lowest.z));
    let found = manifold(&body, &pose, &valley, &Pose::IDENTITY, 1e-9);
    let slope = std::f64::consts::FRAC_1_SQRT_2;
    let sides = [DVec3::new(-slope, 0.0, slope), DVec3::new(slope, 0.0, slope)].map(|n| count(&found, n));
    assert_eq!((sides, found.contacts.len()), ([4, 4], 8), "{found:#?}");
    // A vertical step down: the body rests on its upper plane and sticks out.
    let cliff = grid(10, 4.0, 0.0, &mut random, |x, _| if x < 0.1 { 0.0 } else { -1.0 });
    let found = manifold(&body, &Pose::from_translation(DVec3::new(0.0, 0.05, 0.2)), &cliff, &Pose::IDENTITY, 1e-9);
    assert_eq!((count(&found, DVec3::Z), found.contacts.len()), (4, 4), "{found:#?}");
    // Over a crack: two corners on either side, and its borders.
    let crack = grid(10, 4.0, 0.0, &mut random, |x, _| if x.abs() < 0.1 { -1.0 } else { 0.0 });
    let found = manifold(&body, &Pose::from_translation(DVec3::new(0.0, 0.05, 0.2)), &crack, &Pose::IDENTITY, 1e-9);
    assert_eq!((count(&found, DVec3::Z), found.contacts.len()), (8, 8), "{found:#?}");
}

/// Contacts of a body that touches a curved ground in any attitude: at each the two surfaces touch, and no vertex of
/// one is inside the other.
#[test]
fn bodies_touch_a_hilly_ground_without_wrong_normals() {
    let mut random = Random(53);
    let bodies = [cuboid(0.5, 0.4, 0.3), tetrahedron(), prism(7, 0.4, 0.3), ball(0.4)];
    for case in 0..300 {
        let mesh = grid(8, 4.0, 0.3, &mut random, |x, y| 0.3 * libm::sin(2.0 * x) * libm::cos(1.7 * y));
        let body = &bodies[case % 4];
        let turn = random.rotation();
        // Raised from the height of the ground, where it penetrates, to touch.
        let mut height = [0.07, 4.0];
        let at = |z: f64| Pose::new(turn, DVec3::new(0.13, -0.21, z));
        for _ in 0..100 {
            let middle = 0.5 * (height[0] + height[1]);
            height[usize::from(separation(body, &at(middle), &mesh, &Pose::IDENTITY) > 0.0)] = middle;
        }
        let pose = at(height[1]);
        let found = manifold(body, &pose, &mesh, &Pose::IDENTITY, 1e-10);
        assert!(!found.contacts.is_empty(), "case {case} {found:?}");
        for contact in &found.contacts {
            let g = contact.geometry;
            assert!(g.separation.abs() < 1e-10 && g.margin > -1e-10, "case {case}: {contact:?}");
            assert!(g.normal.z > 0.0, "case {case}: {contact:?}");
            // Moved along the normal, the body is separated.
            let clear = Pose { translation: pose.translation + g.normal * 1e-6, ..pose };
            if found.contacts.len() == 1 {
                let apart = separation(body, &clear, &mesh, &Pose::IDENTITY);
                assert!((apart - 1e-6).abs() < 1e-8, "case {case}: {apart} by {contact:?}");
            }
        }
    }
}

#[test]
fn a_closed_mesh_has_the_contacts_of_its_solid_from_outside() {
    let mut random = Random(59);
    let solid = polhode_mesh::box_mesh(DVec3::new(2.0, 1.0, 0.5)).expect("a box");
    let mesh =
        Shape::triangle_mesh(solid.mesh().vertices().to_vec(), solid.mesh().triangles().to_vec()).expect("a mesh");
    let whole = cuboid(2.0, 1.0, 0.5);
    let others = [cuboid(0.7, 0.9, 1.1), prism(7, 0.5, 0.8), ball(0.4)];
    for case in 0..300 {
        let other = &others[case % 3];
        let start = random.pose(0.2);
        let pose = touching(other, start, &whole, &Pose::IDENTITY, random.direction());
        let expected = manifold(other, &pose, &whole, &Pose::IDENTITY, 1e-10);
        let found = manifold(other, &pose, &mesh, &Pose::IDENTITY, 1e-10);
        assert_same(&found.contacts, &expected.contacts, 1e-9, &format!("case {case}"));
    }
}

#[test]
fn points_just_below_a_sheet_touch_its_outer_side() {
    let mut random = Random(61);
    let frame = Shape::points(vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z]).expect("points");
    let mesh = grid(10, 4.0, 0.3, &mut random, |_, _| 0.0);
    let found = manifold(&frame, &Pose::from_translation(DVec3::new(0.1, 0.1, -1e-13)), &mesh, &Pose::IDENTITY, 1e-9);
    assert_eq!(found.contacts.len(), 3, "{found:#?}");
    assert!(found.contacts.iter().all(|c| c.geometry.normal == DVec3::Z));
    let single = Shape::points(vec![DVec3::ZERO]).expect("a point");
    let found = manifold(&single, &Pose::from_translation(DVec3::Z * -1e-14), &mesh, &Pose::IDENTITY, 1e-9);
    assert_eq!(found.contacts.len(), 1);
    assert_eq!(found.contacts[0].geometry.normal, DVec3::Z);
}

#[test]
fn a_compound_on_a_grid_has_the_contacts_of_its_whole() {
    let mut random = Random(67);
    let half = |x: f64| cuboid(0.5, 0.6, 0.4).translated(DVec3::X * x).expect("a place");
    let body = Shape::compound(vec![half(-0.25), half(0.25)]).expect("two halves");
    let whole = cuboid(1.0, 0.6, 0.4);
    for case in 0..60 {
        let mesh = grid(10, 4.0, 0.3, &mut random, |_, _| 0.0);
        let pose = Pose::new(yaw(random.between(-3.0, 3.0)), DVec3::new(0.1, 0.2, 0.2));
        let expected = manifold(&whole, &pose, &mesh, &Pose::IDENTITY, 1e-9);
        let found = manifold(&body, &pose, &mesh, &Pose::IDENTITY, 1e-9);
        assert_same(&found.contacts, &expected.contacts, 1e-12, &format!("case {case}"));
    }
}

/// A vertex of no triangle (a fuzz finding: at 10^19 m) is not part of the mesh: it affects no tolerance and no bound,
/// and every result is that of the mesh without it, bit for bit.
#[test]
fn a_far_vertex_of_no_triangle_changes_no_result() {
    let mut random = Random(19);
    let Shape::TriangleMesh(ground) = grid(4, 2.0, 0.2, &mut random, |x, y| 0.3 * x * y) else { panic!("a mesh") };
    let (mut vertices, triangles) = (ground.vertices().to_vec(), ground.triangles().to_vec());
    vertices.push(DVec3::new(5e19, 3.0, -1.0));
    let with = Shape::triangle_mesh(vertices, triangles).expect("a mesh");
    let without = Shape::TriangleMesh(ground);
    assert_eq!((with.size(), with.radius()), (without.size(), without.radius()));
    assert_eq!(aabb_of(&with, &Pose::IDENTITY), aabb_of(&without, &Pose::IDENTITY));
    let bodies = [cylinder(0.1, 0.3), cuboid(0.4, 0.5, 0.2), ball(0.3), ring(0.3, 0.1)];
    for case in 0..400 {
        let (body, pose) = (&bodies[case % 4], random.pose(1.0));
        let found = [&with, &without].map(|mesh| manifold(mesh, &Pose::IDENTITY, body, &pose, 0.2));
        assert_eq!(found[0], found[1], "{case}");
    }
}

#[test]
fn invalid_meshes_are_refused_and_extreme_poses_have_results() {
    let corners = || vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::X * 2.0];
    let of = |triangles: Vec<[u32; 3]>| Shape::triangle_mesh(corners(), triangles);
    assert!(matches!(of(Vec::new()), Err(ShapeError::NoPart { .. })));
    assert!(matches!(of(vec![[0, 1, 9]]), Err(ShapeError::NoSuchVertex { triangle: 0, vertex: 9, .. })));
    assert!(matches!(of(vec![[0, 1, 2], [0, 1, 3]]), Err(ShapeError::NoArea { triangle: 1, .. })));
    assert!(matches!(of(vec![[0, 1, 2], [1, 1, 2]]), Err(ShapeError::NoArea { triangle: 1, .. })));
    assert!(matches!(of(vec![[0, 1, 2], [2, 1, 0]]), Err(ShapeError::Double { triangle: 1, of: 0 })));
    let nan = Shape::triangle_mesh(vec![DVec3::NAN, DVec3::X, DVec3::Y], vec![[0, 1, 2]]);
    assert!(matches!(nan, Err(ShapeError::NotFinite { .. })));
    let mesh = of(vec![[0, 1, 2]]).expect("a triangle");
    let body = cuboid(1.0, 1.0, 1.0);
    assert!(separation(&body, &Pose::from_translation(DVec3::NAN), &mesh, &Pose::IDENTITY).is_nan());
    let huge = Pose::from_translation(DVec3::splat(1e300));
    assert!(!separation(&body, &huge, &mesh, &Pose::IDENTITY).is_nan());
    assert_eq!(separation(&mesh, &Pose::IDENTITY, &mesh, &Pose::IDENTITY), f64::INFINITY);
    let floor = floor();
    assert_eq!(manifold(&mesh, &Pose::IDENTITY, &floor, &Pose::IDENTITY, 1.0).contacts.len(), 0);
    assert!(mirror_defect(&mesh, UnitVector::Z, 0.0) < 1e-15);
    assert!(mirror_defect(&mesh, UnitVector::X, 0.0) > 0.5);
    let inside = manifold(&body, &Pose::IDENTITY, &mesh, &Pose::IDENTITY, 1.0);
    for contact in &inside.contacts {
        assert!(evaluate(contact.feature, &body, &Pose::IDENTITY, &mesh, &Pose::IDENTITY).is_some());
    }
}
