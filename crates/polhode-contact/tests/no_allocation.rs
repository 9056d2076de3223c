//! After some steps that fill the buffers, steps of the broad and the narrow phase allocate nothing.
//!
//! A binary of its own: the counting allocator that `allocation-counter` installs serves the whole program.

use polhode_contact::{Aabb, BroadPhase, Bvh, ConvexPolyhedron, NarrowPhase, Shape, swept_aabb};
use polhode_spatial::{DVec3, Pose, Rotation, Still};

const REACH: f64 = 0.05;

/// A pile of boxes, prisms and balls on a slab.
fn pile() -> (Vec<Shape>, Vec<Pose>) {
    let ring = (0..24).map(|k| {
        let angle = f64::from(k / 2) / 12.0 * std::f64::consts::TAU;
        DVec3::new(0.5 * libm::cos(angle), 0.5 * libm::sin(angle), if k % 2 == 0 { -0.5 } else { 0.5 })
    });
    let prism = ConvexPolyhedron::from_points(&ring.collect::<Vec<_>>()).expect("a prism");
    let kinds = [
        Shape::cuboid(DVec3::ONE).expect("positive sizes"),
        Shape::convex(prism),
        Shape::sphere(0.5).expect("a positive radius"),
    ];
    let mut shapes = vec![Shape::cuboid(DVec3::new(20.0, 20.0, 1.0)).expect("positive sizes")];
    let mut poses = vec![Pose::from_translation(DVec3::Z * -0.5)];
    for k in 0..125_u32 {
        let place = DVec3::new(f64::from(k % 5), f64::from(k / 5 % 5), f64::from(k / 25));
        shapes.push(kinds[k as usize % 3].clone());
        poses.push(Pose::from_translation(place * 1.01 + DVec3::Z * 0.5));
    }
    (shapes, poses)
}

/// A motion of the bodies that comes back to where it began after `PERIOD` steps, during which contacts and pairs begin and
/// end all the time.
const PERIOD: u32 = 50;

fn frame(start: &[Pose], step: u32) -> Vec<Pose> {
    let phase = f64::from(step % PERIOD) / f64::from(PERIOD) * std::f64::consts::TAU;
    let moved = |(k, pose): (usize, &Pose)| {
        if k == 0 {
            return *pose;
        }
        let own = phase + k as f64;
        let (s, c) = (libm::sin(own), libm::cos(own));
        let turn = Rotation::from_rotation_vector(DVec3::new(s, c, s * c) * 0.03);
        Pose::new(turn, pose.translation + DVec3::new(c, s, -s * c) * 0.03)
    };
    start.iter().enumerate().map(moved).collect()
}

/// What is kept from step to step.
#[derive(Default)]
struct Detection {
    boxes: Vec<Aabb>,
    pairs: Vec<(u32, u32)>,
    broad_phase: Bvh,
    narrow_phase: NarrowPhase<f64>,
    contacts: usize,
}

impl Detection {
    fn find_pairs(&mut self, shapes: &[Shape], poses: &[Pose]) {
        self.boxes.clear();
        for (shape, pose) in shapes.iter().zip(poses) {
            let tight = swept_aabb(shape, &Still(*pose), 0.0, 0.0).expect("a finite pose");
            self.boxes.push(tight.inflated(0.5 * REACH).expect("a positive reach"));
        }
        self.broad_phase.pairs(&self.boxes, &mut self.pairs).expect("few boxes");
    }

    fn find_contacts(&mut self, shapes: &[Shape], poses: &[Pose]) {
        let placed = |body: u32| (&shapes[body as usize], &poses[body as usize]);
        self.narrow_phase.update(&self.pairs, REACH, placed).expect("sorted pairs");
        self.narrow_phase.for_each_mut(|_, manifold, data| {
            self.contacts += manifold.contacts.len();
            for impulse in data {
                *impulse += 1.0;
            }
        });
        self.contacts += self.narrow_phase.pairs().flat_map(|pair| pair.changes()).count();
    }
}

#[test]
fn steps_of_a_moving_pile_allocate_nothing() {
    let counts_at_all = allocation_counter::measure(|| drop(std::hint::black_box(vec![1.0; 10])));
    assert_eq!(counts_at_all.count_total, 1);
    let (shapes, start) = pile();
    let mut detection = Detection::default();
    for step in 0..2 * PERIOD {
        let poses = frame(&start, step);
        detection.find_pairs(&shapes, &poses);
        detection.find_contacts(&shapes, &poses);
    }
    let (mut lists, mut allocations) = (Vec::new(), 0);
    for step in 0..100 {
        let poses = frame(&start, step);
        detection.contacts = 0;
        let info = allocation_counter::measure(|| {
            detection.find_pairs(&shapes, &poses);
            detection.find_contacts(&shapes, &poses);
        });
        lists.push(detection.pairs.len());
        allocations += info.count_total;
        assert!(detection.contacts > 500, "{}", detection.contacts);
    }
    assert_eq!(allocations, 0);
    assert!(lists.windows(2).any(|two| two[0] != two[1]), "pairs must begin and end for the test to mean anything");
}
