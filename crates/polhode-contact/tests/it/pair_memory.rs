//! The narrow phase with a memory of each pair gives the same result as without, bit for bit, however the bodies move.

use crate::support::{Random, at, ball, cuboid, floor, hull, prism, yaw};
use polhode_contact::{Manifold, PairMemory, Shape, Workspace, manifold, near_manifold, near_manifold_with};
use polhode_spatial::{DVec3, Pose, Rotation};
use std::collections::BTreeMap;

/// All numbers of the contacts as bits, so that even signs of zeros count.
fn bits(manifold: &Manifold) -> Vec<(polhode_contact::ContactFeature, [u64; 8])> {
    let of = |c: &polhode_contact::Contact| {
        let g = c.geometry;
        let numbers = [g.point.to_array(), g.normal.to_array(), [g.separation, g.margin, 0.0]].concat();
        let mut all = [0; 8];
        all.iter_mut().zip(numbers).for_each(|(bits, number)| *bits = number.to_bits());
        (c.feature, all)
    };
    manifold.contacts.iter().map(of).collect()
}

/// Bodies whose pairs are queried with and without memory.
struct World {
    shapes: Vec<Shape>,
    poses: Vec<Pose>,
    workspace: Workspace,
    memories: BTreeMap<(u32, u32), PairMemory>,
    found: Manifold,
    /// How many contacts have been compared.
    compared: usize,
}

impl World {
    fn new(shapes: Vec<Shape>, poses: Vec<Pose>) -> Self {
        let (workspace, memories, found) = (Workspace::default(), BTreeMap::new(), Manifold::default());
        Self { shapes, poses, workspace, memories, found, compared: 0 }
    }

    /// Finds the contacts of a pair with its memory.
    fn find(&mut self, pair: (u32, u32), reach: f64) {
        let Self { shapes, poses, workspace, memories, found, .. } = self;
        let placed = |body: u32| (&shapes[body as usize], &poses[body as usize]);
        let memory = memories.entry(pair).or_default();
        near_manifold_with(workspace, memory, placed(pair.0), placed(pair.1), reach, found);
    }

    /// Updates the pairs and compares every one with a fresh search.
    fn check(&mut self, pairs: &[(u32, u32)], reach: f64, context: &str) {
        for &pair in pairs {
            self.find(pair, reach);
            let placed = |body: u32| (&self.shapes[body as usize], &self.poses[body as usize]);
            let ((shape_a, pose_a), (shape_b, pose_b)) = (placed(pair.0), placed(pair.1));
            let fresh = manifold(shape_a, pose_a, shape_b, pose_b, reach);
            assert_eq!(bits(&self.found), bits(&fresh), "{context}, pair {pair:?}");
            if fresh.separation <= reach {
                assert_eq!(self.found.separation.to_bits(), fresh.separation.to_bits(), "{context}");
                assert_eq!(self.found.axis, fresh.axis, "{context}");
            } else {
                assert!(self.found.separation > reach, "{context}: {}", self.found.separation);
            }
            self.compared += fresh.contacts.len();
        }
    }

    /// All pairs of bodies.
    fn all_pairs(&self) -> Vec<(u32, u32)> {
        let count = self.shapes.len() as u32;
        (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))).collect()
    }
}

fn random_hull(random: &mut Random, points: usize) -> Shape {
    let points: Vec<DVec3> = (0..points).map(|_| random.direction() * 0.6).collect();
    hull(&points)
}

fn moved(pose: &Pose, random: &mut Random, step: f64) -> Pose {
    let turn = Rotation::from_rotation_vector(random.vector() * step);
    Pose::new(turn * pose.rotation, pose.translation + random.vector() * step)
}

/// Bodies of every kind in random walks near each other, from steps so small that the memory stays valid for long to
/// steps that invalidate it every time.
#[test]
fn random_walks() {
    let mut random = Random(17);
    for step in [0.0, 1e-13, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1] {
        for round in 0..8 {
            let shapes = vec![
                cuboid(6.0, 6.0, 1.0),
                cuboid(1.0, 0.8, 0.6),
                prism(3 + round, 0.5, 0.7),
                prism(32, 0.5, 0.8),
                random_hull(&mut random, 12),
                random_hull(&mut random, 40),
                ball(0.4),
                floor(),
                Shape::points(vec![DVec3::ZERO, DVec3::X * 0.3]).expect("two points"),
            ];
            let scatter = |random: &mut Random| random.pose(0.8);
            let poses = shapes.iter().map(|_| scatter(&mut random)).collect();
            let mut world = World::new(shapes, poses);
            let pairs = world.all_pairs();
            for k in 0..40 {
                world.check(&pairs, 0.05, &format!("step {step}, round {round}, {k}"));
                world.poses.iter_mut().for_each(|pose| *pose = moved(pose, &mut random, step));
            }
            assert!(world.compared > 500, "{}", world.compared);
        }
    }
}

/// One pair with a memory, queried at poses to and fro, as a search for a time does, and with a different reach each
/// time: the result is that of `near_manifold`.
#[test]
fn one_pair_with_changing_reach() {
    let mut random = Random(23);
    let mut compared = 0;
    for step in [1e-13, 1e-9, 1e-5, 1e-3, 0.05] {
        for round in 0..12 {
            let shapes = [random_hull(&mut random, 14), prism(3 + round, 0.5, 0.7), cuboid(1.0, 0.8, 0.6)];
            let (a, b) = (&shapes[round as usize % 3], &shapes[(round as usize + 1) % 3]);
            let (mut workspace, mut memory, mut found) =
                (Workspace::default(), PairMemory::default(), Manifold::default());
            let mut poses = [Pose::IDENTITY, random.pose(0.7)];
            for k in 0..60 {
                let back = poses;
                poses = poses.map(|pose| moved(&pose, &mut random, step));
                let reach = [1e-11, 0.01, 0.3][k % 3];
                near_manifold_with(&mut workspace, &mut memory, (a, &poses[0]), (b, &poses[1]), reach, &mut found);
                let fresh = near_manifold(a, &poses[0], b, &poses[1], reach);
                assert_eq!(bits(&found), bits(&fresh), "step {step}, round {round}, {k}");
                assert!(found.separation == fresh.separation || found.separation.min(fresh.separation) > reach);
                compared += fresh.contacts.len();
                if k % 2 == 0 {
                    poses = back;
                }
            }
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// Stacks at rest, aligned, turned, and rocking by amounts from rounding to visible: where several axes are equally
/// good.
#[test]
fn resting_stacks() {
    let mut random = Random(23);
    for rocking in [0.0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-5, 1e-3] {
        for turn in [0.0, std::f64::consts::FRAC_PI_4, 0.3, 1e-9] {
            for size in [1e-6, 1.0, 1e4] {
                let cube = || cuboid(size, size, size);
                let gon = |sides| prism(sides, 0.5 * size, size);
                let slab = cuboid(10.0 * size, 10.0 * size, size);
                let shapes = vec![slab, cube(), gon(6), cube(), gon(32), gon(32), gon(8), cube()];
                let resting: Vec<Pose> = (0..shapes.len())
                    .map(|k| Pose::new(yaw(turn * k as f64), DVec3::new(0.1, 0.05, 1.0) * k as f64 * size))
                    .collect();
                let mut world = World::new(shapes, resting.clone());
                let pairs: Vec<(u32, u32)> = (0..7).map(|k| (k, k + 1)).collect();
                for k in 0..12 {
                    world.check(&pairs, 0.01 * size, &format!("rocking {rocking}, turn {turn}, size {size}, {k}"));
                    for (pose, rest) in world.poses.iter_mut().zip(&resting) {
                        *pose = moved(rest, &mut random, rocking);
                        pose.translation = rest.translation + (pose.translation - rest.translation) * size;
                    }
                }
                assert!(world.compared > 200);
            }
        }
    }
}

/// A box that slides over the edge of a slab and tips, and a prism that rolls on its side: the features in contact
/// change.
#[test]
fn sliding_and_rolling() {
    let shapes = vec![cuboid(4.0, 4.0, 1.0), cuboid(1.0, 1.0, 1.0), prism(32, 0.5, 2.0), prism(5, 0.5, 2.0)];
    let mut world = World::new(shapes, vec![Pose::IDENTITY; 4]);
    let flat = Rotation::from_rotation_vector(DVec3::X * std::f64::consts::FRAC_PI_2);
    for k in 0..2000 {
        let s = f64::from(k) * 2e-3;
        let tip = (s - 2.0).max(0.0);
        let slide = Rotation::from_rotation_vector(DVec3::new(0.0, tip, 0.02 * s));
        world.poses[1] = Pose::new(slide, DVec3::new(s, 0.1, 1.0 - 0.5 * tip * tip));
        let roll = |angle: f64| Rotation::from_rotation_vector(DVec3::Y * angle) * flat;
        world.poses[2] = Pose::new(roll(s / 0.5), DVec3::new(s - 2.0, -1.0, 0.999));
        world.poses[3] = Pose::new(roll(s / 0.45), DVec3::new(s - 2.0, 1.0, 0.95));
        let pairs = world.all_pairs();
        world.check(&pairs, 0.02, &format!("{k}"));
    }
    assert!(world.compared > 5000, "{}", world.compared);
}

/// Two faces whose corners slowly pass the reach, the sides and each other's corners, in steps from far below the place
/// tolerance to steps that pass it at once: a list of contacts is not kept after it has become invalid. Both orders of
/// the bodies.
#[test]
fn corners_that_pass_limits_slowly() {
    let at_edge = |tilt: f64, x: f64, z: f64| {
        let rotation = Rotation::from_rotation_vector(DVec3::Y * tilt);
        // The lower edge at x = -0.5 stays where it is.
        Pose::new(rotation, DVec3::new(x, 0.1, z) - rotation.rotate(DVec3::new(-0.5, 0.0, -0.5)))
    };
    let reach = 0.05;
    let mut compared = 0;
    for order in [[0, 1], [1, 0]] {
        let ordered = |bodies: [Pose; 2]| order.map(|k| bodies[k]).to_vec();
        let shapes = [cuboid(3.0, 3.0, 1.0), cuboid(1.0, 1.0, 1.0)];
        let rising = World::new(order.map(|k| shapes[k].clone()).to_vec(), Vec::new());
        let passing = World::new(vec![cuboid(1.0, 1.0, 1.0); 2], Vec::new());
        for (mut world, steps) in [(rising, [1e-6, 1e-5, 1e-4]), (passing, [1e-15, 1e-14, 1e-13])] {
            for (k, step) in steps.into_iter().flat_map(|step| (-60..60).map(move |k| (k, step))) {
                let by = -f64::from(k) * step;
                world.poses = match steps[0] {
                    // The far corners come down through the reach.
                    1e-6 => ordered([at(0.0, 0.0, 0.0), at_edge(-(reach + by), -0.3, 0.5)]),
                    // Two cubes that overlap by their corners alone move apart.
                    _ => ordered([at(0.0, 0.0, 0.0), at(1.0 - by, 1.0 - 0.8 * by, 1.0)]),
                };
                world.check(&[(0, 1)], reach, &format!("{order:?}, step {step}, {k}"));
            }
            compared += world.compared;
        }
    }
    assert!(compared > 2000, "{compared}");
}

/// Boxes that were so far apart that the rounding of their distance exceeded the reach, and are back: the bound from
/// that separation minus the motion must not be used.
#[test]
fn boxes_that_were_far_apart_touch_again() {
    let (mut random, mut compared) = (Random(47), 0);
    for far in (6..40).map(|k| 10.0_f64.powi(k)) {
        let mut world = World::new(vec![cuboid(1.0, 0.9, 0.8), cuboid(1.0, 1.0, 1.0)], vec![Pose::IDENTITY; 2]);
        for round in 0..20 {
            let near = random.pose(0.8);
            let away = if round % 2 == 0 { DVec3::X } else { random.direction() };
            for place in [away * far, DVec3::ZERO] {
                world.poses[1] = Pose::new(near.rotation, near.translation + place);
                let reach = if round % 4 < 2 { 0.01 } else { -0.05 };
                world.check(&[(0, 1)], reach, &format!("{far} m, round {round}, {place}"));
            }
        }
        compared += world.compared;
    }
    assert!(compared > 500, "{compared}");
}

/// Pairs that appear and disappear, changes of reach and shape, poses that are not finite: no outdated memory is used.
#[test]
fn pairs_that_come_and_go() {
    let mut random = Random(31);
    let shapes: Vec<Shape> =
        (0..12).map(|k| if k % 3 == 0 { prism(7, 0.5, 0.8) } else { cuboid(1.0, 0.9, 0.8) }).collect();
    let poses = (0..12).map(|_| random.pose(1.0)).collect();
    let mut world = World::new(shapes, poses);
    for k in 0..300 {
        let all = world.all_pairs();
        let pairs: Vec<_> = all.into_iter().filter(|_| random.unit() < 0.6).collect();
        let reach = [0.01, 0.2, 0.0, -0.01][k % 4];
        if k % 50 == 20 {
            world.shapes[k % 12] = random_hull(&mut random, 9);
            let changed = (k % 12) as u32;
            world.memories.retain(|&(a, b), _| a != changed && b != changed);
        }
        if k % 50 == 30 {
            let kept = world.poses[3];
            world.poses[3].translation.x = f64::NAN;
            for &pair in pairs.iter().filter(|pair| pair.0 == 3 || pair.1 == 3) {
                world.find(pair, reach);
                assert!(world.found.contacts.is_empty());
            }
            world.poses[3] = kept;
        }
        world.check(&pairs, reach, &format!("{k}"));
        world.poses.iter_mut().for_each(|pose| *pose = moved(pose, &mut random, 3e-3));
    }
    assert!(world.compared > 1000);
}
