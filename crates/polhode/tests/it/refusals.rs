//! Bad input from a program gives a typed error and leaves the simulation as it was, to the last byte of its snapshot.

use crate::support::{ball, brick, elastic, floor};
use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::{Method, MotionError, MotionTable, PrescribedMotion, SampledOrientations, SceneError, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, Velocity};
use polhode::{ActionError, Body, BodyId, Geometry, Scene, Simulation, SimulationError, Snapshot, SnapshotError};

const TIERS: [Tier; 3] = [Tier::Accurate, Tier::Stepped, Tier::Thesis];

const STRANGE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A floor, a shelf that goes up and down, a brick on the floor and two balls that bounce.
fn scene(tier: Tier) -> Scene {
    let up_and_down = PrescribedMotion::sine(DVec3::Z * 0.05, DVec3::ZERO, 1.5, 0.0).unwrap();
    let shelf = Body::kinematic("shelf", up_and_down).pose(Pose::from_translation(DVec3::new(3.0, 0.0, 0.5)));
    Scene::builder("refusals")
        .method(Method { tier: Some(tier), step_s: Some(0.01), ..Method::default() })
        .duration_s(1.0)
        .body(floor().material(elastic(0.5)))
        .body(shelf.geometry(Geometry::Shape(Shape::cuboid(DVec3::new(1.0, 1.0, 0.2)).unwrap())))
        .body(brick("brick", DVec3::new(0.4, 0.3, 0.2), DVec3::Z * 0.1))
        .body(ball("ball", 1.0, 0.1, DVec3::new(1.0, 0.0, 0.4), DVec3::ZERO).material(elastic(0.5)))
        .body(ball("gone", 1.0, 0.1, DVec3::new(2.0, 0.0, 0.4), DVec3::ZERO).material(elastic(0.5)))
        .build()
        .unwrap()
}

/// A run of the scene at 0.35 s whose body "gone" has been removed, and the handle of that body.
fn running(tier: Tier) -> (Simulation, BodyId) {
    let mut simulation = Simulation::new(&scene(tier)).unwrap();
    simulation.advance_to(0.2).unwrap();
    let gone = simulation.body_id("gone").unwrap();
    simulation.remove_body(gone).unwrap();
    simulation.advance_to(0.35).unwrap();
    (simulation, gone)
}

/// The error of a refused call, after which the simulation must be as it was.
#[track_caller]
fn refused<T: std::fmt::Debug>(
    simulation: &mut Simulation,
    act: impl FnOnce(&mut Simulation) -> Result<T, SimulationError>,
) -> SimulationError {
    let before = simulation.snapshot().to_bytes();
    let error = act(simulation).unwrap_err();
    assert!(simulation.snapshot().to_bytes() == before, "changed by what was refused: {error}");
    error
}

/// The same for an error of an action.
#[track_caller]
fn refused_action<T: std::fmt::Debug>(
    simulation: &mut Simulation,
    act: impl FnOnce(&mut Simulation) -> Result<T, SimulationError>,
) -> ActionError {
    match refused(simulation, act) {
        SimulationError::Action(error) => error,
        other => panic!("{other}"),
    }
}

type Action = Box<dyn FnOnce(&mut Simulation) -> Result<(), SimulationError>>;

/// What a program can do to one body.
fn actions(id: BodyId) -> [Action; 5] {
    [
        Box::new(move |own| own.set_force(id, DVec3::X, DVec3::ZERO)),
        Box::new(move |own| own.apply_impulse(id, DVec3::X, DVec3::ZERO)),
        Box::new(move |own| own.set_velocity(id, Velocity::new(DVec3::X, DVec3::ZERO))),
        Box::new(move |own| own.set_pose(id, Pose::from_translation(DVec3::splat(9.0)))),
        Box::new(move |own| own.remove_body(id)),
    ]
}

#[test]
fn handles_of_removed_unknown_and_immovable_bodies() {
    for tier in TIERS {
        let (mut simulation, gone) = running(tier);
        for act in actions(gone) {
            assert_eq!(refused_action(&mut simulation, act), ActionError::RemovedBody("gone".to_owned()));
        }
        let mut larger = Simulation::new(&scene(tier)).unwrap();
        let beyond = larger.add_body(ball("more", 1.0, 0.1, DVec3::splat(5.0), DVec3::ZERO)).unwrap();
        for act in actions(beyond) {
            let error = refused_action(&mut simulation, act);
            assert_eq!(error, ActionError::UnknownBody { index: 5, bodies: 5 });
        }
        for name in ["floor", "shelf"] {
            let id = simulation.body_id(name).unwrap();
            for act in actions(id).into_iter().take(4) {
                assert_eq!(refused_action(&mut simulation, act), ActionError::FixedBody(name.to_owned()));
            }
        }
    }
}

/// Numbers that are not finite, and finite ones that lead to states that are not.
#[test]
fn numbers_that_are_not_finite() {
    for tier in TIERS {
        let (mut simulation, _) = running(tier);
        let id = simulation.body_id("ball").unwrap();
        let mut not_finite = |act: &dyn Fn(&mut Simulation) -> Result<(), SimulationError>| {
            let error = refused_action(&mut simulation, act);
            assert!(matches!(&error, ActionError::NotFinite { body, .. } if body == "ball"), "{error}");
        };
        for strange in STRANGE.map(|x| DVec3::new(0.0, x, 0.0)) {
            not_finite(&|own| own.set_force(id, strange, DVec3::ZERO));
            not_finite(&|own| own.set_force(id, DVec3::ZERO, strange));
            not_finite(&|own| own.apply_impulse(id, strange, DVec3::ZERO));
            not_finite(&|own| own.apply_impulse(id, DVec3::X, strange));
            not_finite(&|own| own.set_velocity(id, Velocity::new(strange, DVec3::ZERO)));
            not_finite(&|own| own.set_velocity(id, Velocity::new(DVec3::ZERO, strange)));
            not_finite(&|own| own.set_pose(id, Pose::from_translation(strange)));
        }
        not_finite(&|own| own.apply_impulse(id, DVec3::X * f64::MAX, DVec3::splat(1e9)));
        not_finite(&|own| own.set_velocity(id, Velocity::new(DVec3::X * 1e200, DVec3::ZERO)));
        simulation.advance_to(0.5).unwrap();
    }
}

#[test]
fn times_in_the_past() {
    for tier in TIERS {
        let (mut simulation, _) = running(tier);
        for t_s in [0.0, 0.35_f64.next_down(), -1.0].into_iter().chain(STRANGE) {
            let error = refused(&mut simulation, |own| own.advance_to(t_s));
            assert!(matches!(error, SimulationError::TimeInThePast { now_s: 0.35, .. }), "{t_s}: {error}");
        }
    }
}

/// Poses and new bodies that overlap others, names in use, and bodies that a scene would refuse are refused.
#[test]
fn bodies_where_there_is_no_room() {
    for tier in TIERS {
        let (mut simulation, _) = running(tier);
        let id = simulation.body_id("ball").unwrap();
        let overlap = |error: &ActionError| matches!(error, ActionError::Overlap { .. });
        let shelf = simulation.body(simulation.body_id("shelf").unwrap()).pose.translation;
        for place in [DVec3::Z * 0.1, shelf, DVec3::new(1.0, 0.0, 0.05)] {
            let error = refused_action(&mut simulation, |own| own.set_pose(id, Pose::from_translation(place)));
            assert!(overlap(&error), "{error}");
            let inside = ball("inside", 1.0, 0.1, place, DVec3::ZERO);
            assert!(overlap(&refused_action(&mut simulation, |own| own.add_body(inside))));
        }
        let still = PrescribedMotion::constant_velocity(Velocity::ZERO).unwrap();
        let wall = Body::kinematic("wall", still).geometry(Shape::cuboid(DVec3::ONE).unwrap().into());
        assert!(overlap(&refused_action(&mut simulation, |own| own.add_body(wall))));
        let far = DVec3::splat(50.0);
        let again = ball("ball", 1.0, 0.1, far, DVec3::ZERO);
        let error = refused(&mut simulation, |own| own.add_body(again));
        assert_eq!(error, SimulationError::Scene(SceneError::DuplicateName("ball".to_owned())));
        for strange in STRANGE {
            let nowhere = ball("new", 1.0, 0.1, DVec3::X * strange, DVec3::ZERO);
            let error = refused(&mut simulation, |own| own.add_body(nowhere));
            assert!(matches!(error, SimulationError::Scene(SceneError::NotFinite { .. })), "{error}");
            let fast = ball("new", 1.0, 0.1, far, DVec3::Y * strange);
            let error = refused(&mut simulation, |own| own.add_body(fast));
            assert!(matches!(error, SimulationError::Scene(SceneError::NotFinite { .. })), "{error}");
        }
    }
}

/// A kinematic body may be added to a run; motions that are not finite, or that do not begin where the body stands, are
/// refused before there is a body.
#[test]
fn kinematic_motions_that_are_not_finite() {
    for strange in STRANGE {
        let vector = DVec3::new(0.0, strange, 0.0);
        assert!(PrescribedMotion::constant_velocity(Velocity::new(vector, DVec3::ZERO)).is_err());
        assert!(PrescribedMotion::constant_velocity(Velocity::new(DVec3::ZERO, vector)).is_err());
        assert!(PrescribedMotion::sine(vector, DVec3::ZERO, 1.0, 0.0).is_err());
        assert!(PrescribedMotion::sine(DVec3::ZERO, vector, 1.0, 0.0).is_err());
        assert!(PrescribedMotion::sine(DVec3::X, DVec3::ZERO, strange, 0.0).is_err());
        assert!(PrescribedMotion::sine(DVec3::X, DVec3::ZERO, 1.0, strange).is_err());
        let turned = SampledOrientations::RotationVectors(vec![DVec3::ZERO, vector]);
        for (times_s, positions_m, orientations) in [
            (vec![0.0, strange], Some(vec![DVec3::ZERO; 2]), None),
            (vec![0.0, 1.0], Some(vec![DVec3::ZERO, vector]), None),
            (vec![0.0, 1.0], None, Some(turned)),
        ] {
            let table = MotionTable { times_s, positions_m, orientations, ..MotionTable::default() };
            assert!(PrescribedMotion::table(&table).is_err());
        }
    }
    for tier in TIERS {
        let (mut simulation, _) = running(tier);
        let motion = PrescribedMotion::constant_velocity(Velocity::new(DVec3::X, DVec3::ZERO)).unwrap();
        let shape = || Geometry::Shape(Shape::cuboid(DVec3::ONE).unwrap());
        let nowhere = Body::kinematic("wall", motion.clone()).geometry(shape());
        let nowhere = nowhere.pose(Pose::from_translation(DVec3::X * f64::NAN));
        let error = refused(&mut simulation, |own| own.add_body(nowhere));
        assert!(matches!(error, SimulationError::Scene(SceneError::NotFinite { .. })), "{error}");
        let places = MotionTable {
            times_s: vec![0.0, 1.0],
            positions_m: Some(vec![DVec3::splat(20.0), DVec3::splat(21.0)]),
            ..MotionTable::default()
        };
        let elsewhere = Body::kinematic("wall", PrescribedMotion::table(&places).unwrap()).geometry(shape());
        let turned = Pose::new(Rotation::from_rotation_vector(DVec3::X), DVec3::splat(30.0));
        let error = refused(&mut simulation, |own| own.add_body(elsewhere.pose(turned)));
        let is_motion = |source: &MotionError| !source.to_string().is_empty();
        assert!(
            matches!(
                &error,
                SimulationError::Scene(SceneError::Motion { body, source }) if body == "wall" && is_motion(source)
            ),
            "{error}"
        );
        let added = Body::kinematic("wall", motion).geometry(shape()).pose(Pose::from_translation(DVec3::splat(10.0)));
        simulation.add_body(added).unwrap();
        simulation.advance_to(0.6).unwrap();
    }
}

/// Snapshots of other scenes, of other tiers and with other bodies are refused.
#[test]
fn snapshots_of_others() {
    for tier in TIERS {
        let (mut simulation, _) = running(tier);
        for other in TIERS.into_iter().filter(|&other| other != tier) {
            let other = running(other).0.snapshot();
            let error = refused(&mut simulation, |own| own.restore(&other));
            assert!(matches!(error, SimulationError::Snapshot(SnapshotError::OtherScene { .. })), "{error}");
        }
        // One body more, and one that has not been removed.
        let mut more = running(tier).0;
        let brick = Body::movable("more", solid_box(DVec3::ONE, Mass::new(1.0).unwrap()).unwrap());
        more.add_body(brick.pose(Pose::from_translation(DVec3::splat(9.0)))).unwrap();
        let mut before = Simulation::new(&scene(tier)).unwrap();
        before.advance_to(0.2).unwrap();
        for other in [more.snapshot(), before.snapshot()] {
            let error = refused(&mut simulation, |own| own.restore(&other));
            assert!(matches!(error, SimulationError::Snapshot(_)), "{error}");
        }
    }
}

/// The bytes of a snapshot with a valid checksum (FNV-1a over all other bytes).
fn signed(mut bytes: Vec<u8>) -> Vec<u8> {
    let step = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    let hash = bytes[..20].iter().chain(&bytes[28..]).fold(0xcbf2_9ce4_8422_2325, step);
    bytes[20..28].copy_from_slice(&hash.to_le_bytes());
    bytes
}

/// Every byte of a small snapshot is inverted in turn. Without a new checksum the snapshot is refused. With a valid
/// checksum it is refused and the simulation is as it was, or it is restored, and the run continues or ends with an
/// error; it never panics.
#[test]
fn every_byte_of_a_snapshot_inverted() {
    for tier in TIERS {
        let mut simulation = Simulation::new(&scene(tier)).unwrap();
        simulation.advance_to(0.3).unwrap();
        let own = simulation.snapshot();
        let bytes = own.to_bytes();
        for place in 0..bytes.len() {
            let mut altered = bytes.clone();
            altered[place] ^= 0xff;
            Snapshot::from_bytes(&altered).unwrap_err();
            let Ok(snapshot) = Snapshot::from_bytes(&signed(altered)) else { continue };
            if simulation.restore(&snapshot).is_ok() {
                let _ = simulation.step();
                simulation.restore(&own).unwrap();
            }
            assert!(simulation.snapshot().to_bytes() == bytes, "{tier:?}: byte {place}");
        }
    }
}
