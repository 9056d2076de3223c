//! Programs that use the public interface as its names suggest. A run has the same bits however it is divided into
//! steps or restored from snapshots, in every tier; the answers of queries are compared with sums computed in the test.

use crate::pivot_rows::seesaw;
use crate::support::{accurate, ball, brick, elastic, floor};
use polhode::contact::Shape;
use polhode::scene::{Attachment, Force, Interpolation, Material, Method, MotionTable, PrescribedMotion, Tier};
use polhode::spatial::{DVec3, Pose, Rotation, SplitMix64, UnitVector, Velocity};
use polhode::{
    Body, BodyId, ErrorEstimation, Geometry, MotionKind, Recorder, RunReport, Scene, SceneBuilder, Simulation, Snapshot,
};

const G: f64 = 9.81;
const TIERS: [Tier; 3] = [Tier::Accurate, Tier::Stepped, Tier::Thesis];

fn by(tier: Tier) -> Method {
    Method { tier: Some(tier), ..Method::default() }
}

fn start(scene: &Scene) -> Simulation {
    Simulation::new(scene).unwrap()
}

/// Two bricks and a ball that fall on a moving slab, whose top is at z = 0 at the start.
fn on_slab(name: &str, motion: PrescribedMotion) -> SceneBuilder {
    let shape = Geometry::Shape(Shape::cuboid(DVec3::new(2.0, 2.0, 0.2)).unwrap());
    let slab = Body::kinematic("slab", motion).geometry(shape);
    let given = slab.initial_pose().translation;
    let slab = if given == DVec3::ZERO { slab.pose(Pose::from_translation(DVec3::Z * -0.1)) } else { slab };
    let size = DVec3::new(0.4, 0.3, 0.2);
    Scene::builder(name)
        .duration_s(0.4)
        .body(slab.material(elastic(0.3)))
        .body(brick("low", size, DVec3::new(0.0, 0.0, 0.15)).material(elastic(0.3)))
        .body(brick("high", size, DVec3::new(0.13, 0.05, 0.45)).material(elastic(0.3)))
        .body(ball("ball", 0.5, 0.1, DVec3::new(-0.1, 0.02, 0.7), DVec3::ZERO).material(elastic(0.3)))
}

/// A simulation may be made in one thread and run in another, in every tier: it is `Send`, and has the same bits there.
#[test]
fn a_simulation_runs_in_another_thread() {
    let motion = PrescribedMotion::sine(DVec3::Z * 0.02, DVec3::ZERO, 3.0, 0.0).unwrap();
    for tier in TIERS {
        let scene = on_slab("threads", motion.clone()).method(by(tier)).build().unwrap();
        let run = |mut simulation: Simulation| {
            simulation.run().unwrap();
            simulation.snapshot().to_bytes()
        };
        let here = run(start(&scene));
        let simulation = start(&scene);
        let there = std::thread::spawn(move || run(simulation)).join().unwrap();
        assert_eq!(here, there, "{tier:?}");
    }
}

/// A rod on a pivot, and a ball that hangs on it by a spring and reaches the floor.
fn pendulum() -> SceneBuilder {
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::Y * 1.3), DVec3::Z * 0.9);
    let rod = brick("rod", DVec3::new(0.1, 0.1, 0.6), DVec3::ZERO).pose(pose);
    let spring = Force::Spring {
        a: Attachment::Body { body: BodyId::new(1), point: DVec3::Z * -0.3 },
        b: Attachment::Body { body: BodyId::new(2), point: DVec3::Z * 0.05 },
        stiffness: 40.0,
        rest_length: 0.3,
        damping: 0.0,
    };
    Scene::builder("pendulum")
        .duration_s(0.6)
        .body(floor())
        .body(rod.pivot(pose.transform_point(DVec3::Z * 0.3)))
        .body(ball("ball", 0.5, 0.1, DVec3::new(-0.6, 0.1, 0.3), DVec3::ZERO).material(elastic(0.4)))
        .force(spring)
}

/// Balls that fall into a valley.
fn valley() -> SceneBuilder {
    let side = |name: &str, x: f64| {
        let normal = UnitVector::new(DVec3::new(x, 0.1 * x, 1.0)).unwrap();
        Body::fixed(name).geometry(Geometry::Shape(Shape::half_space(normal))).material(elastic(0.5))
    };
    let mut scene = Scene::builder("valley").duration_s(1.0).body(side("left", 0.6)).body(side("right", -0.6));
    for k in 0..4 {
        let k = f64::from(k);
        let at = DVec3::new(0.11 * k - 0.15, 0.01 * k, 0.3 + 0.23 * k);
        let name = if k == 3.0 { "ball".to_owned() } else { format!("b{k}") };
        scene = scene.body(ball(&name, 1.0, 0.1, at, DVec3::ZERO).material(elastic(0.5)));
    }
    scene
}

/// Scenes with a conveyor, a turntable, a shaker, a lift, a pivot with a spring, and balls whose bounces accumulate.
fn scenes(tier: Tier) -> Vec<Scene> {
    let steady = |linear, angular| PrescribedMotion::constant_velocity(Velocity::new(linear, angular)).unwrap();
    let heights = [0.0, 0.0, 0.1, 0.05].map(|height| DVec3::Z * (height - 0.1));
    let (times_s, positions_m) = (vec![0.0, 0.1, 0.4, 0.6], Some(heights.to_vec()));
    let table = MotionTable { times_s, positions_m, interpolation: Interpolation::Spline, ..MotionTable::default() };
    let scenes = [
        on_slab("conveyor", steady(DVec3::X * 0.3, DVec3::ZERO)),
        on_slab("turntable", steady(DVec3::ZERO, DVec3::Z * 0.7)),
        on_slab("shaker", PrescribedMotion::sine(DVec3::Z * 0.02, DVec3::ZERO, 3.0, 0.0).unwrap()),
        on_slab("lift", PrescribedMotion::table(&table).unwrap()),
        pendulum(),
        valley(),
    ];
    scenes.map(|scene| scene.output_interval_s(0.023).method(by(tier)).build().unwrap()).into()
}

/// All samples and events that an observer received, with all digits.
fn record_text(recorder: &Recorder) -> String {
    format!("{:?} {:?} {:?}", recorder.times_s, recorder.samples, recorder.events)
}

/// A report without its number of steps, to which calls of `advance_to` add while all bodies fly.
fn report_text(report: &RunReport) -> String {
    let mut report = report.clone();
    report.steps = 0;
    format!("{report:?}")
}

/// The answers to all queries at the present time, with all digits.
fn query_text(simulation: &Simulation) -> String {
    let views = (simulation.contacts(), simulation.pivots(), simulation.islands(), simulation.frame());
    format!("{views:?} {:?} {:?} {:?}", simulation.energy(), simulation.momentum(), simulation.plan())
}

/// Calling `step` in a loop gives the run, bit for bit, in each tier. So do calls of `advance_to` at irregular times,
/// each made twice, in the tier `accurate`. The error is not estimated: it is compared where a program stops.
#[test]
fn steps_and_stops_change_no_bit() {
    let start = |scene: &Scene| start(scene).estimating(ErrorEstimation::Off);
    for scene in TIERS.into_iter().flat_map(scenes) {
        let (mut whole, mut stepped, mut cut) = (Recorder::default(), Recorder::default(), Recorder::default());
        let report = start(&scene).run_observed(&mut whole).unwrap();
        let mut simulation = start(&scene);
        while simulation.time() < scene.duration_s() {
            simulation.step_observed(&mut stepped).unwrap();
        }
        assert_eq!(report_text(&simulation.run_observed(&mut stepped).unwrap()), report_text(&report));
        assert!(record_text(&whole) == record_text(&stepped), "{}", scene.name());
        if scene.method().tier != Some(Tier::Accurate) {
            continue;
        }
        let mut random = SplitMix64::new(5);
        let mut times: Vec<f64> = (0..30).map(|_| scene.duration_s() * random.uniform()).collect();
        times.sort_by(f64::total_cmp);
        let mut simulation = start(&scene);
        for t in times {
            simulation.advance_to_observed(t, &mut cut).unwrap();
            simulation.advance_to_observed(t, &mut cut).unwrap();
            assert_eq!(simulation.time(), t);
        }
        assert_eq!(report_text(&simulation.run_observed(&mut cut).unwrap()), report_text(&report));
        assert!(record_text(&whole) == record_text(&cut), "{}", scene.name());
    }
}

/// What a program does: it pushes, strikes, throws and moves a body, adds another one and takes it away.
fn act(simulation: &mut Simulation) -> BodyId {
    let ball = simulation.body_id("ball").unwrap();
    simulation.advance_to(0.05).unwrap();
    simulation.set_force(ball, DVec3::new(0.2, 0.1, 0.3), DVec3::new(0.01, 0.0, 0.02)).unwrap();
    simulation.advance_to(0.07).unwrap();
    let at = simulation.body(ball).pose.translation;
    simulation.apply_impulse(ball, DVec3::new(0.1, 0.2, 0.4), at + DVec3::X * 0.05).unwrap();
    simulation.advance_to(0.1).unwrap();
    simulation.set_velocity(ball, Velocity::new(DVec3::Z, DVec3::X)).unwrap();
    simulation.set_pose(ball, Pose::from_translation(DVec3::new(0.05, 0.1, 2.0))).unwrap();
    let added = add(simulation);
    simulation.advance_to(0.12).unwrap();
    simulation.remove_body(added).unwrap();
    added
}

fn add(simulation: &mut Simulation) -> BodyId {
    simulation.add_body(ball("added", 1.0, 0.1, DVec3::Z * 4.0, DVec3::Z * -3.0)).unwrap()
}

/// A simulation restored from bytes that were taken at a random time continues as the original: its queries, samples,
/// events and report have the same bits, in each tier, with and without actions of a program.
#[test]
fn restored_simulations_go_on_with_the_same_bits() {
    for (number, scene) in TIERS.into_iter().flat_map(scenes).enumerate() {
        let mut random = SplitMix64::new(number as u64);
        for acts in [false, true, false, true] {
            let (mut one, mut other) = (start(&scene), start(&scene));
            if acts {
                act(&mut one);
                let added = add(&mut other);
                other.remove_body(added).unwrap();
            }
            let from = one.time();
            let t = from + (scene.duration_s() - from) * random.uniform();
            one.advance_to(t).unwrap();
            let kept = Snapshot::from_bytes(&one.snapshot().to_bytes()).unwrap();
            other.restore(&kept).unwrap();
            assert_eq!(query_text(&one), query_text(&other), "{} {t}", scene.name());
            let (mut first, mut second) = (Recorder::default(), Recorder::default());
            let (one, other) = (one.run_observed(&mut first).unwrap(), other.run_observed(&mut second).unwrap());
            assert_eq!(format!("{one:?}"), format!("{other:?}"), "{} {t}", scene.name());
            assert!(record_text(&first) == record_text(&second), "{} {t}", scene.name());
            let closure = (one.ledger.closure_relative(), one.ledger.momentum.closure_relative());
            assert!(closure.0 < 1e-12 && closure.1 < 1e-12, "{} {closure:?}", scene.name());
        }
    }
}

/// Twelve balls with friction that fall into a bin and roll against each other: their crowds fall into parts, whose
/// bodies have joined and left them at different times.
fn rough_balls() -> SceneBuilder {
    let rough = || Material::new("rough").with_friction(0.5).unwrap().with_restitution(0.5).unwrap();
    let mut scene = Scene::builder("rough balls").duration_s(1.2).body(floor().material(rough()));
    for (k, inward) in [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y].into_iter().enumerate() {
        let wall = Geometry::Shape(Shape::half_space(UnitVector::new(inward).unwrap()));
        let place = Pose::from_translation(inward * -0.55);
        scene = scene.body(Body::fixed(format!("wall {k}")).geometry(wall).pose(place).material(rough()));
    }
    let mut random = SplitMix64::new(7);
    for k in 0..12_u32 {
        let cell = DVec3::new(f64::from(k % 2) - 0.5, f64::from(k / 2 % 2) - 0.5, 1.0 + f64::from(k / 4));
        let shift = DVec3::new(random.uniform(), random.uniform(), random.uniform()) * 0.05;
        let name = format!("ball {k}");
        scene = scene.body(ball(&name, 1.0, 0.2, cell * 0.5 + shift, DVec3::ZERO).material(rough()));
    }
    scene
}

/// A run that is stopped within a stretch of crowded events, and continued from a snapshot taken there, has the bits of
/// one that was never stopped.
#[test]
fn runs_restored_in_crowded_stretches_have_the_same_bits() {
    for scene in [seesaw().duration_s(1.0), rough_balls()] {
        restored_in_stretches(&scene.build().unwrap());
    }
}

fn restored_in_stretches(scene: &Scene) {
    let start = |scene: &Scene| start(scene).estimating(ErrorEstimation::Off);
    let mut whole = Recorder::default();
    let report = start(scene).run_observed(&mut whole).unwrap();
    assert!(report.crowded.len() > 1, "{:?}", report.crowded);
    let (mut simulation, mut record) = (start(scene), Recorder::default());
    for stretch in &report.crowded {
        for share in [0.3, 0.7] {
            let t = stretch.from_s + share * (stretch.to_s - stretch.from_s);
            if t < simulation.time() {
                continue;
            }
            simulation.advance_to_observed(t, &mut record).unwrap();
            let kept = Snapshot::from_bytes(&simulation.snapshot().to_bytes()).unwrap();
            let views = query_text(&simulation);
            simulation = start(scene);
            simulation.restore(&kept).unwrap();
            assert_eq!(query_text(&simulation), views, "{t}");
        }
    }
    assert_eq!(report_text(&simulation.run_observed(&mut record).unwrap()), report_text(&report));
    assert!(record_text(&whole) == record_text(&record));
}

/// Energies and momenta are the textbook sums over bodies, before and after an impulse beside the centre of mass.
#[test]
fn energies_and_momenta_are_sums_over_bodies() {
    let bodies = [("a", 2.0, 0.1, DVec3::Z), ("b", 3.0, 0.2, DVec3::new(3.0, 0.0, 2.0))];
    for tier in TIERS {
        let mut scene = Scene::builder("sums").method(by(tier)).body(floor());
        for (name, mass, radius, place) in bodies {
            scene = scene.body(ball(name, mass, radius, place, DVec3::new(mass - 2.5, 2.0, 3.0)));
        }
        let mut simulation = start(&scene.build().unwrap());
        let about = simulation.run().unwrap().ledger.momentum.about;
        for t in [1.0, 1.1, 1.35] {
            simulation.advance_to(t).unwrap();
            let (mut kinetic, mut potential, mut linear, mut angular) = (0.0, 0.0, DVec3::ZERO, DVec3::ZERO);
            for (name, mass, radius, _) in bodies {
                let now = simulation.body(simulation.body_id(name).unwrap());
                let (place, v, w) = (now.pose.translation, now.velocity.linear, now.velocity.angular);
                let inertia = 0.4 * mass * radius * radius;
                kinetic += 0.5 * (mass * v.length_squared() + inertia * w.length_squared());
                potential += mass * G * place.z;
                linear += v * mass;
                angular += (place - about).cross(v * mass) + w * inertia;
            }
            let (energy, momentum) = (simulation.energy(), simulation.momentum());
            assert!((energy.kinetic_j - kinetic).abs() < 1e-12 && (energy.potential_j - potential).abs() < 1e-12);
            assert!((energy.final_j - kinetic - potential).abs() < 1e-12);
            assert!((momentum.linear - linear).length() < 1e-12);
            assert!((momentum.angular - angular).length() < 1e-12, "{tier:?} {:?} {angular}", momentum.angular);
            let a = simulation.body_id("a").unwrap();
            let edge = simulation.body(a).pose.translation + DVec3::Y * 0.1;
            simulation.apply_impulse(a, DVec3::X, edge).unwrap();
        }
    }
}

/// Two stacks of two bricks, 5 m apart.
fn stacks(tier: Tier) -> Simulation {
    let mut scene = Scene::builder("stacks").method(by(tier)).body(floor());
    for (name, x, z) in [("a0", 0.0, 0.1), ("a1", 0.0, 0.3), ("b0", 5.0, 0.1), ("b1", 5.0, 0.3)] {
        scene = scene.body(brick(name, DVec3::new(0.4, 0.3, 0.2), DVec3::new(x, 0.0, z)));
    }
    start(&scene.build().unwrap())
}

/// Bodies on the floor press on it with their weight, from the first instant on.
#[test]
fn contacts_bear_the_weight() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let mut simulation = stacks(tier);
        let floor = simulation.body_id("floor").unwrap();
        for t in [0.0, 0.2, 0.203] {
            simulation.advance_to(t).unwrap();
            let contacts = simulation.contacts();
            let on_floor = contacts.iter().filter(|contact| contact.body_a == floor || contact.body_b == floor);
            let (forces, torques): (Vec<f64>, Vec<DVec3>) = on_floor
                .map(|contact| {
                    let up = if contact.body_b == floor { contact.normal } else { -contact.normal };
                    assert!((up - DVec3::Z).length() < 1e-12 && contact.separation_m.abs() < 1e-12);
                    (contact.normal_force_n, contact.point_m.cross(up * contact.normal_force_n))
                })
                .unzip();
            assert!((forces.iter().sum::<f64>() - 4.0 * G).abs() < 1e-9, "{tier:?} {t} {forces:?}");
            let torque: DVec3 = torques.into_iter().sum();
            assert!((torque + DVec3::Y * 10.0 * G).length() < 1e-9, "{tier:?} {t} {torque}");
        }
    }
}

/// Two stacks on one floor are two islands: at rest, before and after the first step, and when pushed. When the lower
/// brick of a stack is removed, the upper one flies and belongs to no island.
#[test]
fn stacks_are_islands() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let mut simulation = stacks(tier);
        let [a0, a1, b0, b1] = ["a0", "a1", "b0", "b1"].map(|name| simulation.body_id(name).unwrap());
        let islands =
            |simulation: &Simulation| simulation.islands().into_iter().map(|island| island.bodies).collect::<Vec<_>>();
        assert_eq!(islands(&simulation), [[a0, a1], [b0, b1]], "{tier:?}");
        simulation.advance_to(0.1).unwrap();
        assert_eq!(islands(&simulation), [[a0, a1], [b0, b1]], "{tier:?}");
        for body in [a0, b0] {
            simulation.set_force(body, DVec3::X * 0.5, DVec3::ZERO).unwrap();
        }
        simulation.advance_to(0.2).unwrap();
        assert_eq!(islands(&simulation), [[a0, a1], [b0, b1]], "{tier:?}");
        let height = simulation.body(a1).pose.translation.z;
        simulation.remove_body(a0).unwrap();
        simulation.advance_to(0.3).unwrap();
        if tier == Tier::Accurate {
            assert_eq!(islands(&simulation), [[b0, b1]]);
            assert_eq!(simulation.frame().motions[a1.index()], MotionKind::Flight);
        }
        let fallen = height - simulation.body(a1).pose.translation.z;
        assert!((fallen - 0.5 * G * 0.01).abs() < 1e-12, "{tier:?} {fallen}");
    }
}

/// Before the first step a frame says that a ball in the air flies and that a brick on the floor does not.
#[test]
fn frames_give_kinds_of_motion_from_the_start() {
    let scene = Scene::builder("start").method(accurate()).body(floor());
    let scene = scene.body(ball("ball", 1.0, 0.1, DVec3::Z * 2.0, DVec3::ZERO));
    let simulation = start(&scene.body(brick("brick", DVec3::splat(0.2), DVec3::Z * 0.1)).build().unwrap());
    assert_eq!(simulation.frame().motions, [MotionKind::Given, MotionKind::Flight, MotionKind::Integrated]);
}

/// A plan derived during a run counts the bodies that are there then, and names its time.
#[test]
fn plans_count_the_bodies_that_are_there() {
    let scene = Scene::builder("counts").method(accurate()).body(floor());
    let mut simulation = start(&scene.body(ball("ball", 1.0, 0.1, DVec3::Z, DVec3::ZERO)).build().unwrap());
    simulation.advance_to(0.25).unwrap();
    let added = add(&mut simulation);
    simulation.remove_body(added).unwrap();
    let facts: Vec<&str> = simulation.plan().effects.iter().map(|effect| effect.fact.as_str()).collect();
    assert!(facts.contains(&"0 bodies with different principal moments, 1 with equal ones"), "{facts:?}");
    assert!(facts.contains(&"1 of 1 movable bodies are under gravity alone between contacts"), "{facts:?}");
    assert!(facts.contains(&"1 pairs may collide, 0 touch at t = 0.25"), "{facts:?}");
}

/// A ball on the floor that is hit from above rebounds with the restitution of the pair.
#[test]
fn struck_ball_bounces() {
    for tier in [Tier::Accurate, Tier::Stepped] {
        let scene = Scene::builder("struck").method(by(tier)).body(floor().material(elastic(0.5)));
        let scene = scene.body(ball("ball", 2.0, 0.1, DVec3::Z * 0.1, DVec3::ZERO).material(elastic(0.5)));
        let mut simulation = start(&scene.build().unwrap());
        let id = simulation.body_id("ball").unwrap();
        simulation.advance_to(0.2).unwrap();
        simulation.apply_impulse(id, DVec3::Z * -4.0, DVec3::Z * 0.2).unwrap();
        simulation.advance_to(0.25).unwrap();
        let rise = simulation.body(id).pose.translation.z - 0.1;
        assert!((rise - (0.05 - 0.5 * G * 0.0025)).abs() < 1e-9, "{tier:?} {rise}");
        let ledger = simulation.run().unwrap().ledger;
        assert!((ledger.external.value() - 4.0).abs() < 1e-12 && ledger.closure_relative() < 1e-12);
    }
}

/// When the floor is removed, all bricks that stood on it fall freely.
#[test]
fn stack_falls_without_its_floor() {
    for tier in TIERS {
        let mut simulation = stacks(tier);
        simulation.advance_to(0.1).unwrap();
        let floor = simulation.body_id("floor").unwrap();
        simulation.remove_body(floor).unwrap();
        simulation.advance_to(0.5).unwrap();
        for (name, z) in [("a0", 0.1), ("a1", 0.3), ("b0", 0.1), ("b1", 0.3)] {
            let fallen = z - simulation.body(simulation.body_id(name).unwrap()).pose.translation.z;
            assert!((fallen - 0.5 * G * 0.16).abs() < 1e-9, "{tier:?} {name} {fallen}");
        }
    }
}
