//! A query of a mesh or compound gives the result of its nearest part: the tree over the parts skips none, also where
//! several are equally near. The reference queries every part by itself.

use crate::distances::bounded_shapes;
use crate::support::{Random, ball};
use polhode_contact::{Ray, Shape, SurfaceFeature, closest_point, distance, ray_cast};
use polhode_spatial::{DVec3, Pose, UnitVector};

/// Hills on a grid of half metres, so that many points are equally near.
fn hills(random: &mut Random, sides: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let at = |i: u32, j: u32| j * (sides + 1) + i;
    let mut vertices = Vec::new();
    for j in 0..=sides {
        for i in 0..=sides {
            let height = (random.unit() * 4.0).floor() * 0.5;
            vertices.push(DVec3::new(0.5 * f64::from(i), 0.5 * f64::from(j), height));
        }
    }
    let cells = (0..sides).flat_map(|j| (0..sides).map(move |i| (i, j)));
    let halves = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]);
    (vertices, halves.collect())
}

/// A random vector, every other time from a grid.
fn place(random: &mut Random, reach: f64) -> DVec3 {
    let place = DVec3::splat(2.0) + random.vector() * reach;
    if random.unit() < 0.5 { (place * 2.0).round() * 0.5 } else { place }
}

/// The shape, its parts as shapes of their own, and its pose.
fn check(random: &mut Random, whole: &Shape, parts: &[Shape], pose: &Pose) {
    let point = pose.transform_point(place(random, 3.0));
    let near = closest_point(whole, pose, point).expect("finite");
    let each = parts.iter().map(|part| closest_point(part, pose, point).expect("finite"));
    let least = each.enumerate().fold((f64::INFINITY, 0), |best, (i, found)| {
        if found.distance < best.0 { (found.distance, i as u32) } else { best }
    });
    assert_eq!((near.distance, near.feature.part), least, "closest point {point:?}");

    let toward = pose.transform_point(place(random, 1.5)) - point;
    let toward = UnitVector::new(toward).unwrap_or(UnitVector::Z);
    let ray = Ray::new(point, toward).expect("finite");
    let hit = ray_cast(whole, pose, &ray, f64::INFINITY).map(|hit| hit.distance);
    let hits = parts.iter().filter_map(|part| ray_cast(part, pose, &ray, f64::INFINITY)).map(|hit| hit.distance);
    assert_eq!(hit, hits.min_by(f64::total_cmp), "{ray:?}");

    let shapes = bounded_shapes();
    let (name, other) = &shapes[(random.unit() * shapes.len() as f64) as usize];
    let other_pose = Pose::new(random.rotation(), point);
    let found = distance(whole, pose, other, &other_pose).expect("finite").distance;
    let of_part = |part: &Shape| distance(part, pose, other, &other_pose).expect("finite").distance;
    assert_eq!(found, parts.iter().map(of_part).fold(f64::INFINITY, f64::min), "{name}");
    let swapped = distance(other, &other_pose, whole, pose).expect("finite").distance;
    let of_part = |part: &Shape| distance(other, &other_pose, part, pose).expect("finite").distance;
    assert_eq!(swapped, parts.iter().map(of_part).fold(f64::INFINITY, f64::min), "{name}");
}

fn some_pose(random: &mut Random) -> Pose {
    if random.unit() < 0.5 { Pose::IDENTITY } else { random.pose(10.0) }
}

#[test]
fn queries_of_a_mesh_are_those_of_its_nearest_triangle() {
    let mut random = Random(2718);
    for _ in 0..6 {
        let (vertices, triangles) = hills(&mut random, 8);
        let one = |t: &[u32; 3]| Shape::triangle_mesh(vertices.clone(), vec![*t]).expect("a triangle");
        let parts: Vec<Shape> = triangles.iter().map(one).collect();
        let whole = Shape::triangle_mesh(vertices.clone(), triangles).expect("hills");
        for _ in 0..40 {
            let pose = some_pose(&mut random);
            check(&mut random, &whole, &parts, &pose);
        }
    }
}

#[test]
fn queries_of_a_compound_are_those_of_its_nearest_part() {
    let mut random = Random(3141);
    for _ in 0..6 {
        let kinds = bounded_shapes();
        let mut parts = Vec::new();
        while parts.len() < 40 {
            let (_, shape) = &kinds[(random.unit() * kinds.len() as f64) as usize];
            let whole = !matches!(shape, Shape::TriangleMesh(_) | Shape::HalfSpace(_) | Shape::Compound(_));
            if whole {
                let turn = random.rotation();
                parts.push(shape.placed(&Pose::new(turn, place(&mut random, 3.0))).expect("a part"));
            }
        }
        let whole = Shape::compound(parts.clone()).expect("parts");
        for _ in 0..40 {
            let pose = some_pose(&mut random);
            check(&mut random, &whole, &parts, &pose);
        }
    }
}

/// Queries name features as contacts do; a point of a cloud is a vertex by its number.
#[test]
fn features_of_round_shapes_are_named_as_in_contacts() {
    use SurfaceFeature::{Cap, Face, Rim, Side, Sphere, Vertex};
    let (x, z) = (DVec3::X, DVec3::Z);
    let cases = [
        (Shape::sphere(0.5), x * 2.0, Sphere),
        (Shape::capsule(0.5, 2.0), x * 2.0, Side(0)),
        (Shape::capsule(0.5, 2.0), -z * 3.0, Cap(0)),
        (Shape::cylinder(0.5, 2.0), x * 2.0, Side(0)),
        (Shape::cylinder(0.5, 2.0), z * 3.0, Face(1)),
        (Shape::cylinder(0.5, 2.0), x * 2.0 + z * 3.0, Rim(1)),
        (Shape::cone(0.5, 2.0), z * 3.0, Vertex(0)),
        (Shape::cone(0.5, 2.0), x * 2.0 - z, Rim(0)),
        (Shape::torus(2.0, 0.5), x * 3.0, Rim(0)),
        (Shape::points(vec![z, x]), x * 3.0, Vertex(1)),
    ];
    for (shape, place, expected) in cases {
        let shape = shape.expect("a shape");
        let near = closest_point(&shape, &Pose::IDENTITY, place).expect("finite");
        assert_eq!(near.feature.surface, expected, "{shape:?}");
        let pose = Pose::from_translation(place);
        let ball = ball(0.1);
        let found = distance(&shape, &Pose::IDENTITY, &ball, &pose).expect("finite");
        assert_eq!((found.feature_a.surface, found.feature_b.surface), (expected, Sphere), "{shape:?}");
        let found = distance(&ball, &pose, &shape, &Pose::IDENTITY).expect("finite");
        assert_eq!((found.feature_a.surface, found.feature_b.surface), (Sphere, expected), "{shape:?}");
    }
}
