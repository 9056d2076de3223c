//! After some steps that fill the buffers, steps of the broad and the narrow phase allocate nothing, whatever the
//! shapes.
//!
//! It is a separate binary, because the counting allocator of `allocation-counter` replaces that of the whole program.

use polhode_contact::{
    Aabb, BroadPhase, Bvh, ConvexPolyhedron, Manifold, PairMemory, Shape, ShapeError, Workspace, near_manifold_with,
    swept_aabb,
};
use polhode_spatial::{DVec3, Pose, Rotation, Still, UnitVector};
use std::collections::BTreeMap;

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

/// Steps after which the motion of the bodies repeats; contacts and pairs begin and end all the time.
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

/// Buffers and memory that are kept from step to step.
#[derive(Default)]
struct Detection {
    boxes: Vec<Aabb>,
    pairs: Vec<(u32, u32)>,
    broad_phase: Bvh,
    workspace: Workspace,
    remembered: BTreeMap<(u32, u32), PairMemory>,
    found: Manifold,
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
        for &pair in &self.pairs {
            let memory = self.remembered.entry(pair).or_default();
            near_manifold_with(&mut self.workspace, memory, placed(pair.0), placed(pair.1), REACH, &mut self.found);
            self.contacts += self.found.contacts.len();
        }
    }
}

/// Cylinders, cones, capsules, tori, compounds and boxes on a ground, with every pair of kinds as neighbours.
fn mixture(ground: Shape) -> (Vec<Shape>, Vec<Pose>) {
    let part = |shape: Result<Shape, ShapeError>, x: f64| {
        shape.and_then(|part| part.translated(DVec3::X * x)).expect("a small part")
    };
    let bracket = vec![
        part(Shape::cuboid(DVec3::new(0.5, 1.0, 0.9)), -0.25),
        part(Shape::cuboid(DVec3::new(0.5, 0.5, 1.0)), 0.25),
        part(Shape::sphere(0.3), 0.3),
        part(Shape::cylinder(0.2, 1.0), 0.4),
    ];
    let kinds = [
        Shape::cylinder(0.5, 1.0),
        Shape::cone(0.5, 1.0),
        Shape::capsule(0.35, 0.4),
        Shape::torus(0.35, 0.15),
        Shape::compound(bracket),
        Shape::cuboid(DVec3::ONE),
    ];
    let kinds = kinds.map(|kind| kind.expect("positive sizes"));
    let (mut shapes, mut poses) = (vec![ground], vec![Pose::IDENTITY]);
    for k in 0..36_u32 {
        let (x, y, z) = (k % 3, k / 3 % 4, k / 12);
        // The kinds of neighbours differ by one along x, by two along y, and by three and none along z.
        shapes.push(kinds[((x + 2 * y + [0, 3, 3][z as usize]) % 6) as usize].clone());
        let turn = Rotation::from_rotation_vector(DVec3::X * (f64::from(k % 2) * std::f64::consts::FRAC_PI_2));
        poses.push(Pose::new(turn, (DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + 0.5) * 0.97));
    }
    (shapes, poses)
}

/// A surface of triangles that is plane on one side and has waves on the other.
fn rolling_ground() -> Shape {
    let place = |k: u32| f64::from(k) * 0.5 - 1.0;
    let height = |x: f64| if x < 1.0 { 0.0 } else { 0.05 * libm::sin(5.0 * x) };
    let vertex = |k: u32| DVec3::new(place(k % 13), place(k / 13), height(place(k % 13)));
    let halves = |k: u32| {
        let low = k / 12 * 13 + k % 12;
        [[low, low + 1, low + 14], [low, low + 14, low + 13]]
    };
    let triangles = (0..144).flat_map(halves).collect();
    Shape::triangle_mesh((0..169).map(vertex).collect(), triangles).expect("a mesh")
}

/// Frames of the motion in one step, so that fewer steps complete a period.
const STRIDE: u32 = 5;

/// Rounds of the motion until the buffers are full.
const ROUNDS: u32 = 8;

/// Runs the motion until the buffers are full. Returns the allocations of further steps and the number of contacts.
fn allocations_of(shapes: &[Shape], start: &[Pose]) -> (u64, usize) {
    let mut detection = Detection::default();
    for step in 0..ROUNDS * PERIOD / STRIDE {
        let poses = frame(start, STRIDE * step);
        detection.find_pairs(shapes, &poses);
        detection.find_contacts(shapes, &poses);
    }
    let mut allocations = 0;
    detection.contacts = 0;
    for step in 0..PERIOD / STRIDE {
        let poses = frame(start, STRIDE * step);
        let info = allocation_counter::measure(|| {
            detection.find_pairs(shapes, &poses);
            detection.find_contacts(shapes, &poses);
        });
        allocations += info.count_total;
    }
    (allocations, detection.contacts / (PERIOD / STRIDE) as usize)
}

#[test]
fn round_shapes_and_compounds_on_a_half_space_allocate_nothing() {
    let (shapes, start) = mixture(Shape::half_space(UnitVector::Z));
    let (allocations, contacts) = allocations_of(&shapes, &start);
    assert_eq!(allocations, 0);
    assert!(contacts > 100, "{contacts}");
}

#[test]
fn round_shapes_and_compounds_on_a_mesh_allocate_nothing() {
    let (shapes, start) = mixture(rolling_ground());
    let (allocations, contacts) = allocations_of(&shapes, &start);
    assert_eq!(allocations, 0);
    assert!(contacts > 100, "{contacts}");
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
