//! Queries of many bodies give the same results as queries of each body.

use crate::distances::bounded_shapes;
use crate::support::{Random, at, cuboid, floor};
use polhode_contact::{Aabb, QueryError, QueryScene, Ray, Shape, closest_point, overlap, ray_cast};
use polhode_spatial::{DVec3, Pose, UnitVector};

#[test]
fn trees_give_the_results_of_brute_force() {
    let mut random = Random(99);
    let shapes = bounded_shapes();
    let floor = floor();
    let mut bodies: Vec<(&Shape, Pose)> = vec![(&floor, at(0.0, 0.0, -4.0))];
    for _ in 0..300 {
        let (_, shape) = &shapes[(random.unit() * shapes.len() as f64) as usize];
        bodies.push((shape, random.pose(5.0)));
    }
    let scene = QueryScene::new(bodies.clone()).expect("finite poses");
    assert_eq!(scene.len(), 301);
    for _ in 0..300 {
        let point = random.vector() * 6.0;
        let (body, found) = scene.nearest(point).expect("finite").expect("bodies");
        let mut least = (f64::INFINITY, 0);
        for (i, (shape, pose)) in bodies.iter().enumerate() {
            let distance = closest_point(shape, pose, point).expect("finite").distance;
            least = if (distance, i) < least { (distance, i) } else { least };
        }
        assert_eq!((found.distance, body), least);

        let ray = Ray::new(point, UnitVector::new(random.direction()).expect("unit")).expect("finite");
        let mut hits: Vec<(f64, usize)> = Vec::new();
        for (i, (shape, pose)) in bodies.iter().enumerate() {
            hits.extend(ray_cast(shape, pose, &ray, 8.0).map(|hit| (hit.distance, i)));
        }
        hits.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
        let all: Vec<(f64, usize)> = scene.all_hits(&ray, 8.0).iter().map(|(i, hit)| (hit.distance, *i)).collect();
        assert_eq!(all, hits);
        assert_eq!(scene.first_hit(&ray, 8.0).map(|(i, hit)| (hit.distance, i)), hits.first().copied());

        let (_, probe) = &shapes[(random.unit() * shapes.len() as f64) as usize];
        let pose = Pose::new(random.rotation(), point);
        let touched: Vec<usize> =
            (0..bodies.len()).filter(|&i| overlap(bodies[i].0, &bodies[i].1, probe, &pose)).collect();
        assert_eq!(scene.overlapping(probe, &pose).expect("finite"), touched);

        let size = DVec3::new(random.between(0.1, 2.0), random.between(0.1, 2.0), random.between(0.1, 2.0));
        let aabb = Aabb::new(point - 0.5 * size, point + 0.5 * size).expect("in order");
        let brick = cuboid(size.x, size.y, size.z);
        let inside: Vec<usize> = (0..bodies.len())
            .filter(|&i| overlap(bodies[i].0, &bodies[i].1, &brick, &Pose::from_translation(point)))
            .collect();
        assert_eq!(scene.overlapping_box(&aabb).expect("a box"), inside);
    }
}

#[test]
fn scenes_without_bodies_and_input_that_is_not_finite() {
    let empty = QueryScene::new([]).expect("no bodies");
    let down = Ray::new(DVec3::Z, UnitVector::Z).expect("finite");
    assert!(empty.is_empty() && empty.nearest(DVec3::ZERO) == Ok(None) && empty.first_hit(&down, 1.0).is_none());
    assert!(empty.nearest(DVec3::X * f64::NAN).is_err());
    let brick = cuboid(1.0, 1.0, 1.0);
    assert!(matches!(QueryScene::new([(&brick, at(f64::NAN, 0.0, 0.0))]), Err(QueryError::NotFinite { .. })));
    let scene = QueryScene::new([(&brick, Pose::IDENTITY)]).expect("finite");
    assert!(scene.nearest(DVec3::X * f64::NAN).is_err() && scene.overlapping(&brick, &at(f64::NAN, 0.0, 0.0)).is_err());
    assert_eq!(scene.overlapping_box(&Aabb::UNBOUNDED), Err(QueryError::FlatBox));
    let flat = Aabb::new(DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)).expect("in order");
    assert_eq!(scene.overlapping_box(&flat), Err(QueryError::FlatBox));
}
