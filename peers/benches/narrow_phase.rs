//! Broad and narrow phase against rapier3d-f64's, in one run, on the same shapes, poses and reach.
//! `cargo bench --manifest-path peers/Cargo.toml --bench narrow_phase`.
//!
//! Every scene is a pile that rapier's own solver has settled (so that it is rapier that chose where the bodies lie).
//! From there every body walks at random by the stated step (m, and rad per metre of size) for [`FRAMES`] frames, which
//! are then gone through to and fro: what contact detection meets in a pile that settles. Three rows for each scene:
//!
//! | row | one step is |
//! |---|---|
//! | `persistent` | boxes of all bodies, [`Bvh`], `near_manifold_with` for every pair: exact, with its memory |
//! | `fresh` | the same with `manifold_into` for every pair, nothing kept but buffers |
//! | `rapier` | `CollisionPipeline::step`: its boxes, tree, pairs and manifolds, caches warm; no solver |
//!
//! Setting the poses is not timed on either side, but rapier's step carries them from bodies to colliders. Rapier
//! reuses the points of a manifold while they slide less than 1 mm and its normals turn less than 1 degree, and cuts a
//! face to four vertices; polhode evaluates every contact at the given poses and gives all of them.
//!
//! Build it without `CARGO_INCREMENTAL`, as is the default: that cuts this crate, but not rapier, into pieces between
//! which nothing is inlined, and makes it some 8 % slower.
//!
//! On a machine that others use too, the rows of one scene may be measured under different loads: before them rapier
//! and `persistent` therefore walk in turns, and the ratio of their least times is printed.

use criterion::{Criterion, criterion_group, criterion_main};
use polhode_contact::{
    Aabb, BroadPhase, Bvh, Manifold, PairMemory, Shape, Workspace, manifold_into, near_manifold_with, swept_aabb,
};
use polhode_spatial::{DVec3, Pose, Rotation, Still};
use rapier3d::prelude as rapier;
use std::cell::{Cell, RefCell};
use std::time::{Duration, Instant};

/// Frames of a walk.
const FRAMES: usize = 32;

/// Steps of a walk to and fro.
const WALK: u64 = 2 * FRAMES as u64 - 2;

/// Walks of each when they take turns.
const TURNS: usize = 20;

/// Contacts up to this separation are asked for, m.
const REACH: f64 = 0.01;

/// Steps of 1/60 s for which a pile settles.
const SETTLING: usize = 240;

/// Whether contacts with triangle meshes are there to be measured; the row is written for when they are.
const MESHES: bool = true;

/// One kind of body, and how many of it.
struct Scene {
    name: &'static str,
    shape: Shape,
    collider: rapier::ColliderBuilder,
    count: u32,
    ground: (Shape, rapier::ColliderBuilder),
}

fn slab() -> (Shape, rapier::ColliderBuilder) {
    let shape = Shape::cuboid(DVec3::new(80.0, 80.0, 2.0)).expect("positive sizes");
    (shape, rapier::ColliderBuilder::cuboid(40.0, 40.0, 1.0))
}

fn boxes() -> Scene {
    let shape = Shape::cuboid(DVec3::ONE).expect("positive sizes");
    Scene {
        name: "a 1000 boxes",
        shape,
        collider: rapier::ColliderBuilder::cuboid(0.5, 0.5, 0.5),
        count: 1000,
        ground: slab(),
    }
}

fn spheres() -> Scene {
    let shape = Shape::sphere(0.5).expect("a positive radius");
    Scene { name: "b 1000 spheres", shape, collider: rapier::ColliderBuilder::ball(0.5), count: 1000, ground: slab() }
}

fn prisms() -> Scene {
    let points: Vec<DVec3> = (0..64)
        .map(|k| {
            let angle = f64::from(k / 2) / 32.0 * std::f64::consts::TAU;
            DVec3::new(0.5 * angle.cos(), 0.5 * angle.sin(), if k % 2 == 0 { -0.4 } else { 0.4 })
        })
        .collect();
    let shape = Shape::convex(polhode_contact::ConvexPolyhedron::from_points(&points).expect("a prism"));
    let collider = rapier::ColliderBuilder::convex_hull(&points).expect("a hull");
    Scene { name: "c 200 32-sided prisms", shape, collider, count: 200, ground: slab() }
}

/// One box on a rolling ground of 100,352 triangles.
fn mesh() -> Scene {
    const CELLS: u32 = 224;
    let place = |k: u32| (f64::from(k) / f64::from(CELLS) - 0.5) * 20.0;
    let height = |x: f64, y: f64| 1.0 + 0.1 * ((0.9 * x).sin() + (1.1 * y).cos());
    let vertex = |k: u32| (place(k % (CELLS + 1)), place(k / (CELLS + 1)));
    let vertices: Vec<DVec3> =
        (0..(CELLS + 1).pow(2)).map(vertex).map(|(x, y)| DVec3::new(x, y, height(x, y))).collect();
    let corner = |k: u32| k / CELLS * (CELLS + 1) + k % CELLS;
    let halves = |k: u32| {
        let (low, high) = (corner(k), corner(k) + CELLS + 1);
        [[low, low + 1, high + 1], [low, high + 1, high]]
    };
    let triangles: Vec<[u32; 3]> = (0..CELLS * CELLS).flat_map(halves).collect();
    let ground = Shape::triangle_mesh(vertices.clone(), triangles.clone()).expect("a mesh");
    let flags = rapier::TriMeshFlags::FIX_INTERNAL_EDGES | rapier::TriMeshFlags::ORIENTED;
    let collider = rapier::ColliderBuilder::trimesh_with_flags(vertices, triangles, flags).expect("a mesh");
    Scene { name: "d box on 100,352 triangles", count: 1, ground: (ground, collider), ..boxes() }
}

/// Rapier's world of a scene.
struct Peer {
    bodies: rapier::RigidBodySet,
    colliders: rapier::ColliderSet,
    handles: Vec<rapier::RigidBodyHandle>,
    islands: rapier::IslandManager,
    broad_phase: rapier::BroadPhaseBvh,
    narrow_phase: rapier::NarrowPhase,
    pipeline: rapier::CollisionPipeline,
}

fn to_rapier(pose: &Pose) -> rapier::Pose {
    rapier::Pose::from_parts(pose.translation, pose.rotation.quaternion())
}

impl Peer {
    /// The ground, then the bodies at their poses.
    fn new(scene: &Scene, poses: &[Pose]) -> Self {
        let (mut bodies, mut colliders) = (rapier::RigidBodySet::new(), rapier::ColliderSet::new());
        let ground = bodies.insert(rapier::RigidBodyBuilder::fixed().pose(to_rapier(&poses[0])));
        colliders.insert_with_parent(scene.ground.1.clone(), ground, &mut bodies);
        let mut handles = vec![ground];
        for pose in &poses[1..] {
            let body = rapier::RigidBodyBuilder::dynamic().pose(to_rapier(pose)).can_sleep(false);
            let handle = bodies.insert(body);
            colliders.insert_with_parent(scene.collider.clone(), handle, &mut bodies);
            handles.push(handle);
        }
        Self {
            bodies,
            colliders,
            handles,
            islands: rapier::IslandManager::new(),
            broad_phase: rapier::BroadPhaseBvh::new(),
            narrow_phase: rapier::NarrowPhase::new(),
            pipeline: rapier::CollisionPipeline::new(),
        }
    }

    /// Poses of all bodies after they have fallen and settled.
    fn settled(mut self) -> Vec<Pose> {
        let mut pipeline = rapier::PhysicsPipeline::new();
        let (mut impulse_joints, mut multibody_joints) =
            (rapier::ImpulseJointSet::new(), rapier::MultibodyJointSet::new());
        let (mut soft_bodies, mut ccd) = (rapier::SoftBodySet::new(), rapier::CCDSolver::new());
        for _ in 0..SETTLING {
            pipeline.step(
                DVec3::NEG_Z * 9.81,
                &rapier::IntegrationParameters::default(),
                &mut self.islands,
                &mut self.broad_phase,
                &mut self.narrow_phase,
                &mut self.bodies,
                &mut self.colliders,
                &mut impulse_joints,
                &mut multibody_joints,
                &mut soft_bodies,
                &mut ccd,
                &(),
                &(),
            );
        }
        let pose = |&handle: &rapier::RigidBodyHandle| {
            let pose = self.bodies[handle].position();
            Pose::new(Rotation::renormalized(pose.rotation), pose.translation)
        };
        self.handles.iter().map(pose).collect()
    }

    fn place(&mut self, poses: &[Pose]) {
        for (handle, pose) in self.handles.iter().zip(poses).skip(1) {
            self.bodies[*handle].set_position(to_rapier(pose), false);
        }
    }

    fn step(&mut self) {
        self.pipeline.step(
            REACH,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &(),
            &(),
        );
    }

    /// Pairs whose boxes overlap, and contacts within reach.
    fn counts(&self) -> (usize, usize) {
        let pairs = self.narrow_phase.contact_pairs();
        let points = |pair: &rapier::ContactPair| {
            let points = pair.manifolds().iter().flat_map(|m| &m.points);
            points.filter(|p| p.dist <= REACH).count()
        };
        pairs.fold((0, 0), |(n, c), pair| (n + 1, c + points(pair)))
    }
}

/// A small generator with a fixed seed.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    }

    fn vector(&mut self) -> DVec3 {
        DVec3::new(self.unit(), self.unit(), self.unit())
    }
}

/// Loose layers above the ground.
fn poured(count: u32) -> Vec<Pose> {
    let mut random = Random(5);
    let side = f64::from(count).cbrt().round() as u32;
    let place = |k: u32| DVec3::new(f64::from(k % side), f64::from(k / side % side), f64::from(k / side / side));
    let middle = DVec3::new(0.5, 0.5, 0.0) * f64::from(side - 1);
    let body = |k| {
        let turn = Rotation::from_rotation_vector(DVec3::Z * (0.3 * random.unit()));
        Pose::new(turn, (place(k) - middle) * 1.08 + 0.1 * random.vector() + DVec3::Z * 0.6)
    };
    std::iter::once(Pose::from_translation(DVec3::NEG_Z)).chain((0..count).map(body)).collect()
}

/// Frames of a random walk from these poses; the ground stays.
fn walk(start: Vec<Pose>, step: f64) -> Vec<Vec<Pose>> {
    let mut random = Random(9);
    let mut frames = vec![start];
    while let Some(last) = frames.last().filter(|_| frames.len() < FRAMES) {
        let mut next = last.clone();
        for pose in next.iter_mut().skip(1) {
            let turn = Rotation::from_rotation_vector(random.vector() * step);
            *pose = Pose::new(turn * pose.rotation, pose.translation + random.vector() * step);
        }
        frames.push(next);
    }
    frames
}

/// Time of `steps` steps, going through the frames to and fro.
fn timed(steps: u64, mut place: impl FnMut(usize), mut step: impl FnMut()) -> Duration {
    // The first steps fill the caches and are not timed.
    let mut total = Duration::ZERO;
    for k in 0..steps + FRAMES as u64 {
        let phase = (k % (2 * FRAMES as u64 - 2)) as usize;
        place(if phase < FRAMES { phase } else { 2 * FRAMES - 2 - phase });
        let start = Instant::now();
        step();
        if k >= FRAMES as u64 {
            total += start.elapsed();
        }
    }
    total
}

fn aabbs(shapes: &[&Shape], poses: &[Pose], boxes: &mut Vec<Aabb>) {
    boxes.clear();
    for (shape, pose) in shapes.iter().zip(poses) {
        let tight = swept_aabb(shape, &Still(*pose), 0.0, 0.0).expect("finite poses");
        boxes.push(tight.inflated(0.5 * REACH).expect("a positive reach"));
    }
}

/// A pair of the persistent row.
#[derive(Default)]
struct Remembered {
    bodies: (u32, u32),
    memory: PairMemory,
    manifold: Manifold,
}

/// What the persistent row keeps from step to step.
#[derive(Default)]
struct Persistent {
    boxes: Vec<Aabb>,
    broad_phase: Bvh,
    pairs: Vec<(u32, u32)>,
    workspace: Workspace,
    /// Sorted; in boxes, which move in and out of the list.
    remembered: Vec<Box<Remembered>>,
}

impl Persistent {
    /// One step; when its three parts end.
    fn step(&mut self, shapes: &[&Shape], poses: &[Pose]) -> [Instant; 3] {
        aabbs(shapes, poses, &mut self.boxes);
        let boxed = Instant::now();
        self.broad_phase.pairs(&self.boxes, &mut self.pairs).expect("few boxes");
        let paired = Instant::now();
        let placed = |body: u32| (shapes[body as usize], &poses[body as usize]);
        let now = Vec::with_capacity(self.pairs.len());
        let mut before = std::mem::replace(&mut self.remembered, now).into_iter().peekable();
        for &bodies in &self.pairs {
            while before.next_if(|pair| pair.bodies < bodies).is_some() {}
            let known = before.next_if(|pair| pair.bodies == bodies);
            let mut pair = known.unwrap_or_else(|| Box::new(Remembered { bodies, ..Remembered::default() }));
            let Remembered { memory, manifold, .. } = &mut *pair;
            near_manifold_with(&mut self.workspace, memory, placed(bodies.0), placed(bodies.1), REACH, manifold);
            self.remembered.push(pair);
        }
        [boxed, paired, Instant::now()]
    }
}

/// Time of each part of a step, of the persistent row.
fn split(shapes: &[&Shape], frames: &[Vec<Pose>]) {
    let (mut ours, mut parts) = (Persistent::default(), [Duration::ZERO; 3]);
    for round in 0..21 {
        for poses in frames.iter().chain(frames.iter().rev()) {
            let mut start = Instant::now();
            for (part, end) in parts.iter_mut().zip(ours.step(shapes, poses)) {
                *part += if round > 0 { end - start } else { Duration::ZERO };
                start = end;
            }
        }
    }
    let [boxes, pairs, contacts] = parts.map(|part| part.as_secs_f64() * 1e6 / (40 * frames.len()) as f64);
    println!("of one step: boxes {boxes:.0} us, pairs {pairs:.0} us, contacts {contacts:.0} us");
}

/// Prints the time of a step of rapier and of the persistent row: each walks all frames in its turn, and the least time
/// of each counts.
fn in_turns(what: &str, peer: &mut Peer, shapes: &[&Shape], frames: &[Vec<Pose>]) {
    let (peer, mut ours, frame) = (RefCell::new(peer), Persistent::default(), Cell::new(0));
    let mut least = [Duration::MAX; 2];
    for _ in 0..TURNS {
        let theirs = timed(WALK, |k| peer.borrow_mut().place(&frames[k]), || peer.borrow_mut().step());
        let own = timed(WALK, |k| frame.set(k), || _ = ours.step(shapes, &frames[frame.get()]));
        least = [least[0].min(theirs), least[1].min(own)];
    }
    let [rapier, persistent] = least.map(|time| time.as_secs_f64() * 1e6 / WALK as f64);
    println!("{what}, in turns: rapier {rapier:.1} us, persistent {persistent:.1} us: {:.2}", persistent / rapier);
}

fn peers(criterion: &mut Criterion) {
    for scene in [boxes(), spheres(), prisms()].into_iter().chain(MESHES.then(mesh)) {
        let settled = Peer::new(&scene, &poured(scene.count)).settled();
        let shapes: Vec<&Shape> =
            std::iter::once(&scene.ground.0).chain(std::iter::repeat_n(&scene.shape, scene.count as usize)).collect();
        for step in [1e-4, 1e-3] {
            let frames = walk(settled.clone(), step);
            let name = format!("{}, {step} m per step", scene.name);
            let mut group = criterion.benchmark_group(&name);
            let mut peer = Peer::new(&scene, &settled);
            peer.step();
            println!("rapier: {:?} pairs, contacts", peer.counts());
            in_turns(&name, &mut peer, &shapes, &frames);
            group.bench_function("rapier", |bencher| {
                let peer = RefCell::new(&mut peer);
                bencher.iter_custom(|n| timed(n, |k| peer.borrow_mut().place(&frames[k]), || peer.borrow_mut().step()));
            });
            let (mut bvh, mut workspace, mut manifold) = (Bvh::default(), Workspace::default(), Manifold::default());
            let (mut boxes, mut contacts, mut pairs) = (Vec::new(), 0, Vec::new());
            group.bench_function("fresh", |bencher| {
                let frame = Cell::new(0);
                bencher.iter_custom(|n| {
                    timed(
                        n,
                        |k| frame.set(k),
                        || {
                            let poses = &frames[frame.get()];
                            aabbs(&shapes, poses, &mut boxes);
                            contacts = 0;
                            bvh.pairs(&boxes, &mut pairs).expect("few boxes");
                            for &(i, j) in &pairs {
                                let (i, j) = (i as usize, j as usize);
                                let (a, b) = ((shapes[i], &poses[i]), (shapes[j], &poses[j]));
                                manifold_into(&mut workspace, a.0, a.1, b.0, b.1, REACH, &mut manifold);
                                contacts += manifold.contacts.len();
                            }
                        },
                    )
                });
            });
            println!("fresh: {} pairs, {contacts} contacts", pairs.len());
            let mut ours = Persistent::default();
            group.bench_function("persistent", |bencher| {
                let frame = Cell::new(0);
                bencher.iter_custom(|n| timed(n, |k| frame.set(k), || _ = ours.step(&shapes, &frames[frame.get()])));
            });
            let contacts: usize = ours.remembered.iter().map(|pair| pair.manifold.contacts.len()).sum();
            println!("persistent: {} pairs, {contacts} contacts", ours.pairs.len());
            if std::env::var_os("POLHODE_SPLIT").is_some() {
                split(&shapes, &frames);
            }
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = peers
}
criterion_main!(benches);
