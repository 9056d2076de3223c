//! Snapshots: a run that goes on from one has the same bits as a run that was never stopped.

use crate::checks::{heavy_brick, particle};
use crate::support::{Sides, accurate, ball, brick, diamond, elastic, floor};
use polhode::contact::Shape;
use polhode::dynamics::integrator::Method as Integrator;
use polhode::mesh::solid_box;
use polhode::scene::{
    Attachment, DragLaw, Force, Frame, Interpolation, Method, MotionTable, PrescribedMotion, Signal, Tier,
};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, SplitMix64, Velocity};
use polhode::{
    Body, BodyId, Effects, ErrorEstimation, Geometry, Recorder, Scene, SceneBuilder, Simulation, SimulationError,
    Snapshot, SnapshotError,
};

/// The samples and events of a run from the given indices on, and its report, with all digits.
fn record_text(recorder: &Recorder, (samples, events): (usize, usize), simulation: &mut Simulation) -> String {
    let report = simulation.run().unwrap();
    format!(
        "{:?} {:?} {:?} {report:?}",
        &recorder.times_s[samples..],
        &recorder.samples[samples..],
        &recorder.events[events..]
    )
}

/// Advances to the end of the run by steps, and returns their number.
fn finish(simulation: &mut Simulation, recorder: &mut Recorder, duration_s: f64) -> usize {
    let mut steps = 0;
    while simulation.time() < duration_s {
        simulation.step_observed(recorder).unwrap();
        steps += 1;
    }
    steps
}

/// A simulation whose error is not estimated: references end by what a run has cost, and that depends on what it keeps
/// in memory, which a snapshot does not hold.
fn begun(scene: &Scene, effects: Effects) -> Simulation {
    Simulation::with_effects(scene, effects).unwrap().estimating(ErrorEstimation::Off)
}

/// A simulation that is restored from the bytes of a snapshot.
fn restored(scene: &Scene, effects: Effects, bytes: &[u8]) -> Simulation {
    let mut simulation = begun(scene, effects);
    let snapshot = Snapshot::from_bytes(bytes).unwrap();
    simulation.restore(&snapshot).unwrap();
    assert_eq!(simulation.snapshot(), snapshot, "a restored simulation gives the snapshot that it was restored from");
    simulation
}

/// Runs that are restored from snapshots give the samples, events and report of the run that was never stopped. The
/// snapshots are taken at the ends of some steps, events among them, and at random times within steps.
pub(crate) fn check_restored_runs(scene: &Scene, effects: Effects) {
    let name = scene.name();
    let duration = scene.duration_s();
    let mut whole = Recorder::default();
    let mut simulation = begun(scene, effects);
    let mut stops = vec![(simulation.snapshot().to_bytes(), 0, 0)];
    let mut after_event = 0;
    let mut steps = 0u32;
    while simulation.time() < duration {
        let event = simulation.step_observed(&mut whole).unwrap().is_event();
        steps += 1;
        after_event += usize::from(event);
        if (event && after_event <= 5) || steps.is_power_of_two() {
            stops.push((simulation.snapshot().to_bytes(), whole.times_s.len(), whole.events.len()));
        }
    }
    for (bytes, samples, events) in &stops {
        let expected = record_text(&whole, (*samples, *events), &mut simulation);
        let mut recorder = Recorder::default();
        let mut other = restored(scene, effects, bytes);
        let t = other.time();
        finish(&mut other, &mut recorder, duration);
        assert!(record_text(&recorder, (0, 0), &mut other) == expected, "{name} from the step that ended at {t} s");
    }
    let mut random = SplitMix64::new(name.len() as u64);
    for _ in 0..3 {
        let t = duration * random.uniform();
        let mut simulation = begun(scene, effects);
        simulation.advance_to(t).unwrap();
        let bytes = simulation.snapshot().to_bytes();
        let mut one = (Box::new(simulation), Recorder::default());
        let mut other = (Box::new(restored(scene, effects, &bytes)), Recorder::default());
        finish(&mut one.0, &mut one.1, duration);
        finish(&mut other.0, &mut other.1, duration);
        assert!(
            record_text(&one.1, (0, 0), &mut one.0) == record_text(&other.1, (0, 0), &mut other.0),
            "{name} stopped at {t} s"
        );
        // Restored in a simulation that has already run further.
        other.0.restore(&Snapshot::from_bytes(&bytes).unwrap()).unwrap();
        let mut again = Recorder::default();
        finish(&mut other.0, &mut again, duration);
        assert!(
            record_text(&one.1, (0, 0), &mut one.0) == record_text(&again, (0, 0), &mut other.0),
            "{name} again from {t} s"
        );
    }
}

/// A nut that tumbles about its middle axis.
fn nut() -> Body {
    let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0)).unwrap();
    let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
    Body::movable("nut", properties).velocity(Velocity::new(DVec3::X, DVec3::new(0.01, 2.0, 0.01)))
}

/// A brick that falls on a corner and bounces.
fn thrown_brick(restitution: f64) -> SceneBuilder {
    let size = DVec3::new(0.6, 0.4, 0.2);
    let pose = Pose::new(Rotation::from_rotation_vector(DVec3::new(0.4, 0.7, 0.1)), DVec3::Z * 0.8);
    let body = Body::movable("brick", solid_box(size, Mass::new(2.0).unwrap()).unwrap())
        .geometry(Geometry::Shape(Shape::cuboid(size).unwrap()))
        .pose(pose)
        .velocity(Velocity::new(DVec3::new(0.3, 0.1, 0.0), DVec3::new(1.0, 3.0, -2.0)))
        .material(elastic(restitution));
    Scene::builder("thrown").method(accurate()).duration_s(1.2).output_interval_s(0.01).body(floor()).body(body)
}

/// Three balls on springs over a floor, in space.
fn chain(method: Method) -> Scene {
    let mut builder = Scene::builder("chain").method(method).duration_s(0.8).output_interval_s(0.013).body(floor());
    for k in 0..3 {
        let x = 0.4 * f64::from(k);
        let body = ball(&format!("b{k}"), 1.0 + x, 0.1, DVec3::new(x, 0.05 * x, 0.6 + 0.1 * x), DVec3::Y * x);
        builder = builder.body(body.material(elastic(0.5)));
    }
    for k in 0..3 {
        let b = Attachment::Body { body: BodyId::new(k + 1), point: DVec3::new(0.0, 0.02, 0.03) };
        let a = if k == 0 {
            Attachment::World(DVec3::Z)
        } else {
            Attachment::Body { body: BodyId::new(k), point: DVec3::ZERO }
        };
        builder = builder.force(Force::Spring { a, b, stiffness: 60.0, rest_length: 0.3, damping: 0.0 });
    }
    builder.build().unwrap()
}

fn by(integrator: Integrator) -> Method {
    Method { integrator: Some(integrator), ..accurate() }
}

#[test]
fn free_flight_goes_on_with_the_same_bits() {
    for effects in [Effects::Planned, Effects::All] {
        let flight = Scene::builder("nut").duration_s(3.0).output_interval_s(0.07).body(nut()).build().unwrap();
        check_restored_runs(&flight, effects);
    }
    for integrator in Integrator::ALL {
        let scene = Scene::builder("stepped nut").method(by(integrator)).duration_s(0.5).output_interval_s(0.007);
        check_restored_runs(&scene.body(nut()).build().unwrap(), Effects::Planned);
    }
}

#[test]
fn bouncing_bodies_go_on_with_the_same_bits() {
    for restitution in [0.0, 0.6, 1.0] {
        let ball = ball("ball", 1.0, 0.1, DVec3::Z * 0.5, DVec3::ZERO).material(elastic(restitution));
        let scene = Scene::builder("bounce").method(accurate()).duration_s(1.5).output_interval_s(0.01).body(floor());
        check_restored_runs(&scene.body(ball).build().unwrap(), Effects::Planned);
    }
    check_restored_runs(&thrown_brick(0.0).build().unwrap(), Effects::Planned);
    check_restored_runs(&thrown_brick(0.5).build().unwrap(), Effects::All);
    for integrator in [Integrator::Dop853, Integrator::Rk4, Integrator::MoserVeselov, Integrator::ExactAdaptive] {
        check_restored_runs(
            &thrown_brick(0.3).method(by(integrator)).duration_s(0.7).build().unwrap(),
            Effects::Planned,
        );
    }
}

/// Drag through the centre of mass exerts no torque: the attitude is that of free rotation, and a snapshot holds its
/// record besides the integrated motion.
#[test]
fn bodies_in_air_go_on_with_the_same_bits() {
    for rotational in [0.0, 0.02] {
        let drag = Force::Drag {
            body: BodyId::new(1),
            law: DragLaw::Quadratic,
            translational: 0.4,
            rotational,
            wind: DVec3::new(3.0, 1.0, 0.0),
        };
        check_restored_runs(&thrown_brick(0.5).force(drag).build().unwrap(), Effects::Planned);
    }
}

#[test]
fn stacks_go_on_with_the_same_bits() {
    for effects in [Effects::Planned, Effects::All] {
        check_restored_runs(&diamond(3, Sides::Touch).duration_s(0.3).build().unwrap(), effects);
    }
    // Two bricks that fall beside each other onto a third.
    let size = DVec3::new(1.0, 0.5, 0.25);
    let mut scene = Scene::builder("falling stack").method(accurate()).duration_s(0.6).body(floor());
    for (k, (x, z)) in [(0.0, 0.125), (-0.55, 0.6), (0.52, 0.7)].into_iter().enumerate() {
        scene = scene.body(brick(&format!("b{k}"), size, DVec3::new(x, 0.0, z)));
    }
    check_restored_runs(&scene.build().unwrap(), Effects::Planned);
}

#[test]
fn chains_with_springs_go_on_with_the_same_bits() {
    check_restored_runs(&chain(accurate()), Effects::Planned);
    for integrator in [
        Integrator::Dop853,
        Integrator::ExactAdaptive,
        Integrator::Exact,
        Integrator::Rk4,
        Integrator::ImplicitMidpoint,
        Integrator::MoserVeselov,
    ] {
        check_restored_runs(&chain(by(integrator)), Effects::Planned);
    }
    let mut free = Scene::builder("free chain").duration_s(0.7).output_interval_s(0.013);
    free = free.body(particle("a", 1.0, DVec3::ZERO, DVec3::X)).body(particle("b", 2.0, DVec3::X, DVec3::Y));
    let [a, b] = [0, 1].map(|body| Attachment::Body { body: BodyId::new(body), point: DVec3::ZERO });
    free = free.force(Force::Spring { a, b, stiffness: 90.0, rest_length: 0.3, damping: 0.0 });
    for integrator in Integrator::ALL {
        check_restored_runs(&free.clone().method(by(integrator)).build().unwrap(), Effects::Planned);
    }
}

/// A spin about the vertical on a floor, a push that begins and ends, and rest.
#[test]
fn planar_pushed_and_resting_bodies_go_on_with_the_same_bits() {
    let size = DVec3::new(0.5, 0.4, 0.2);
    let planar = Scene::builder("planar")
        .method(accurate())
        .duration_s(0.9)
        .body(floor())
        .body(heavy_brick("box", 2.0, size, DVec3::Z * 0.5).velocity(Velocity::new(DVec3::X, DVec3::Y * 2.0)));
    check_restored_runs(&planar.clone().build().unwrap(), Effects::Planned);
    check_restored_runs(&planar.build().unwrap(), Effects::All);
    let force = DVec3::new(3.0, -1.0, 0.0);
    let push = Force::Applied {
        body: BodyId::new(1),
        force,
        torque: DVec3::ZERO,
        frame: Frame::World,
        point: Some(DVec3::Z * 0.07),
        signal: Signal::ONE,
    };
    let pushed = Scene::builder("pushed").method(accurate()).duration_s(0.6).body(floor());
    let pushed = pushed.body(heavy_brick("box", 2.0, size, DVec3::Z * 0.1)).force(push);
    check_restored_runs(&pushed.build().unwrap(), Effects::Planned);
}

/// A brick rests on a slab that stands still until its motion begins. A restored run observes that time too. (Before,
/// it did not: the slab went down and the brick stayed in the air.)
#[test]
fn a_slab_that_begins_to_move_later_moves_after_a_restore_too() {
    let positions = [0.0, -0.1, -0.3].map(|height| DVec3::Z * height).to_vec();
    let (times_s, positions_m) = (vec![0.5, 0.8, 1.0], Some(positions));
    let table = MotionTable { times_s, positions_m, interpolation: Interpolation::Spline, ..MotionTable::default() };
    let shape = Shape::cuboid(DVec3::new(4.0, 4.0, 0.2)).unwrap();
    let slab = Body::kinematic("slab", PrescribedMotion::table(&table).unwrap()).geometry(shape.into());
    let brick = heavy_brick("brick", 2.0, DVec3::new(0.5, 0.4, 0.2), DVec3::Z * 0.2);
    let scene = Scene::builder("lift").method(accurate()).duration_s(1.5).body(slab).body(brick).build().unwrap();
    check_restored_runs(&scene, Effects::Planned);

    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.1).unwrap();
    let mut continued = restored(&scene, Effects::Planned, &simulation.snapshot().to_bytes());
    // At the very time at which the motion begins, whether or not the run has passed it.
    continued.advance_to(0.5).unwrap();
    let mut continued = restored(&scene, Effects::Planned, &continued.snapshot().to_bytes());
    continued.run().unwrap();
    simulation.run().unwrap();
    assert_eq!(continued.bodies(), simulation.bodies());
}

#[test]
fn the_thesis_tier_goes_on_with_the_same_bits() {
    let thesis = Method { tier: Some(Tier::Thesis), step_s: Some(0.004), ..Method::default() };
    check_restored_runs(
        &diamond(2, Sides::Touch).method(thesis.clone()).duration_s(0.2).build().unwrap(),
        Effects::Planned,
    );
    check_restored_runs(&thrown_brick(0.5).method(thesis.clone()).duration_s(0.8).build().unwrap(), Effects::Planned);
    for integrator in Integrator::ALL {
        let method = Method { integrator: Some(integrator), ..thesis.clone() };
        let scene = Scene::builder("nut").method(method).duration_s(0.3).output_interval_s(0.007).body(nut());
        check_restored_runs(&scene.build().unwrap(), Effects::Planned);
    }
}

/// A run may go on after its duration; restored from a snapshot there, it goes on with the same bits.
#[test]
fn a_run_beyond_its_end_goes_on_with_the_same_bits() {
    let scene = thrown_brick(0.2).duration_s(0.5).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    for stop in [0.5, 0.8] {
        simulation.advance_to(stop).unwrap();
        let mut other = restored(&scene, Effects::Planned, &simulation.snapshot().to_bytes());
        for _ in 0..9 {
            simulation.step().unwrap();
            other.step().unwrap();
        }
        assert_eq!(simulation.snapshot().to_bytes(), other.snapshot().to_bytes());
    }
}

fn refusal(result: Result<(), SimulationError>) -> SnapshotError {
    match result.unwrap_err() {
        SimulationError::Snapshot(error) => error,
        other => panic!("{other}"),
    }
}

#[test]
fn bytes_that_are_cut_short_or_altered_are_refused() {
    let scene = thrown_brick(0.5).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.6).unwrap();
    let bytes = simulation.snapshot().to_bytes();
    assert_eq!(Snapshot::from_bytes(&bytes).unwrap(), simulation.snapshot());
    for length in 0..bytes.len() {
        let error = Snapshot::from_bytes(&bytes[..length]).unwrap_err();
        assert!(matches!(error, SnapshotError::Length { .. }), "{length} bytes: {error}");
    }
    for bit in 0..8 * bytes.len() {
        let mut altered = bytes.clone();
        altered[bit / 8] ^= 1 << (bit % 8);
        Snapshot::from_bytes(&altered).unwrap_err();
    }
    let mut longer = bytes.clone();
    longer.push(0);
    assert!(matches!(Snapshot::from_bytes(&longer), Err(SnapshotError::Length { .. })));
    let mut newer = bytes.clone();
    newer[8] += 1;
    assert_eq!(Snapshot::from_bytes(&newer), Err(SnapshotError::Version { found: 21, known: 20 }));
    assert_eq!(Snapshot::from_bytes(b"a text"), Err(SnapshotError::NotASnapshot));
}

/// A refused snapshot changes nothing: the simulation goes on with the bits it would have had.
#[test]
fn snapshots_of_other_scenes_and_effects_are_refused_and_change_nothing() {
    let scene = thrown_brick(0.5).build().unwrap();
    let mut simulation = Simulation::new(&scene).unwrap();
    simulation.advance_to(0.3).unwrap();
    let before = simulation.snapshot().to_bytes();
    let nearly_the_same = thrown_brick(0.5 + f64::EPSILON).build().unwrap();
    let rk4 = thrown_brick(0.5).method(by(Integrator::Rk4)).build().unwrap();
    for other in [nearly_the_same, rk4] {
        let other = Simulation::new(&other).unwrap().snapshot();
        let error = refusal(simulation.restore(&other));
        assert!(matches!(error, SnapshotError::OtherScene { .. }), "{error}");
        assert_eq!(simulation.snapshot().to_bytes(), before);
    }
    let all = Simulation::with_effects(&scene, Effects::All).unwrap().snapshot();
    assert!(matches!(refusal(simulation.restore(&all)), SnapshotError::OtherEffects { .. }));
    assert_eq!(simulation.snapshot().to_bytes(), before);
    let mut untouched = restored(&scene, Effects::Planned, &before);
    simulation.advance_to(1.0).unwrap();
    untouched.advance_to(1.0).unwrap();
    assert_eq!(simulation.snapshot().to_bytes(), untouched.snapshot().to_bytes());
    // Another duration is no other scene: nothing before the end depends on it, and a run can be extended.
    let longer = thrown_brick(0.5).duration_s(2.0).build().unwrap();
    let mut longer = Simulation::new(&longer).unwrap();
    longer.restore(&simulation.snapshot()).unwrap();
    assert_eq!(longer.snapshot().to_bytes(), simulation.snapshot().to_bytes());
}

/// FNV-1a, the checksum of snapshots.
fn signed(mut bytes: Vec<u8>) -> Vec<u8> {
    let mut hash = 0xcbf2_9ce4_8422_2325u64;
    for &byte in bytes[..20].iter().chain(&bytes[28..]) {
        hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    }
    bytes[20..28].copy_from_slice(&hash.to_le_bytes());
    bytes
}

/// Content that no run has written, with a valid checksum, is refused or restored, and never causes a panic.
#[test]
fn forged_content_does_not_panic() {
    let scenes =
        [thrown_brick(0.0).build().unwrap(), chain(by(Integrator::Rk4)), diamond(2, Sides::Touch).build().unwrap()];
    for scene in scenes {
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.45).unwrap();
        let bytes = simulation.snapshot().to_bytes();
        let before = simulation.snapshot();
        let mut random = SplitMix64::new(7);
        let mut refused = 0;
        for _ in 0..2000 {
            let mut altered = bytes.clone();
            let place = 28 + (random.uniform() * (bytes.len() - 28) as f64) as usize;
            altered[place] = (256.0 * random.uniform()) as u8;
            let Ok(snapshot) = Snapshot::from_bytes(&signed(altered)) else {
                refused += 1;
                continue;
            };
            if simulation.restore(&snapshot).is_err() {
                refused += 1;
                assert_eq!(simulation.time().to_bits(), simulation.snapshot().time().to_bits());
            } else {
                simulation.restore(&before).unwrap();
            }
        }
        assert!(refused > 100, "{}: {refused} of 2000 refused", scene.name());
        assert_eq!(simulation.snapshot().to_bytes(), bytes);
    }
}
