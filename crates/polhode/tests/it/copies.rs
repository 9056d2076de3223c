//! Scenes set otherwise: turned, shifted, mirrored, in another order. The motion is the same, seen from elsewhere.

use crate::support::{accurate, ball, brick, elastic, floor, run};
use polhode::contact::{ConvexPolyhedron, Shape};
use polhode::mesh::Cylinder;
use polhode::scene::motion::SampledOrientations;
use polhode::scene::{
    Attachment, Coordinate, CoordinateMotion, CopyError, DragLaw, Drive, Follows, Force, Frame, Freedom,
    FrictionEllipse, Gear, ImpactLaw, Interpolation, Joint, JointKind, Limits, ListOrder, Material, Method,
    MotionTable, Motor, PairRule, PrescribedMotion, PropagationOrder, SceneCopy, Signal, TrackEnds, TrackHold,
};
use polhode::spatial::curve::{Coil, Curve};
use polhode::spatial::{
    DMat3, DVec3, Handedness, Inertia, Isometry, Mass, MassProperties, Pose, Rotation, UnitVector, Velocity,
};
use polhode::{Body, BodySample, Effects, Scene, SceneBuilder, Simulation};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

/// What bodies of a copy may be from those of its scene after 0.3 s, m and rad.
const SAME_MOTION: f64 = 1e-9;

fn new(name: &str) -> SceneBuilder {
    Scene::builder(name).method(accurate()).duration_s(0.3).output_interval_s(0.05)
}

fn turned(x: f64, y: f64, z: f64) -> Rotation {
    Rotation::from_rotation_vector(DVec3::new(x, y, z))
}

/// A body without any symmetry, whose origin is not its centre of mass, and without a shape.
fn lump(name: &str, at: DVec3) -> Body {
    let inertia = DMat3::from_cols(
        DVec3::new(0.020, 0.002, -0.001),
        DVec3::new(0.002, 0.030, 0.003),
        DVec3::new(-0.001, 0.003, 0.025),
    );
    let center = DVec3::new(0.05, -0.02, 0.03);
    Body::movable(name, MassProperties::new(Mass::new(2.0).unwrap(), center, Inertia::new(inertia).unwrap()))
        .pose(Pose::new(turned(0.3, -0.4, 0.8), at))
}

/// A wedge without a plane of symmetry.
fn wedge(name: &str, at: DVec3) -> Body {
    let points = [[-0.1, -0.1, -0.1], [0.2, -0.1, -0.08], [-0.1, 0.3, -0.1], [-0.06, 0.0, 0.2], [0.12, 0.1, 0.02]];
    let shape = ConvexPolyhedron::from_points(&points.map(DVec3::from_array)).unwrap();
    lump(name, at).geometry(Shape::convex(shape).into())
}

fn free_rotation() -> Scene {
    let velocity = Velocity::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(3.0, -5.0, 2.0));
    let other = lump("other", DVec3::X * 3.0).velocity(Velocity::new(DVec3::Y, DVec3::Z * 7.0));
    new("free rotation").body(lump("lump", DVec3::ZERO).velocity(velocity)).body(other).build().unwrap()
}

/// Two arms at hinges, the first with a motor and limits, and a lump at a pivot.
fn pendulums() -> Scene {
    let mut scene = new("pendulums");
    let arm = scene.add_body(lump("arm", DVec3::X * 0.3));
    let fore = scene.add_body(lump("fore", DVec3::X * 0.8));
    let motor = Motor::new(Drive::Velocity { velocity: 3.0, gain: 0.5 }).unwrap();
    let free = Freedom::default().with_limits(Limits::new(-2.0, 0.15).unwrap()).with_spring(0.4, -0.2).unwrap();
    let axis = UnitVector::new(DVec3::new(0.2, 1.0, 0.1)).unwrap();
    scene
        .joint(Joint::hinge(arm, DVec3::ZERO, axis).along(Coordinate::Angle, free.with_motor(motor)))
        .joint(Joint::ball(fore, DVec3::X * 0.6).with(arm))
        .body(lump("top", DVec3::Y * 2.0).pivot(DVec3::new(0.0, 2.1, -0.1)))
        .build()
        .unwrap()
}

fn bouncing() -> Scene {
    let rough = Material::new("rough").with_friction(0.4).unwrap().with_restitution(0.5).unwrap();
    let velocity = Velocity::new(DVec3::new(1.0, 0.5, -1.0), DVec3::new(2.0, -1.0, 0.5));
    let block = brick("box", DVec3::new(0.3, 0.2, 0.1), DVec3::Z * 0.25).material(rough.clone());
    let block = block.pose(Pose::new(turned(0.4, 0.2, 0.1), DVec3::Z * 0.25)).velocity(velocity);
    let wedge = wedge("wedge", DVec3::new(2.0, 0.0, 0.3)).material(rough.clone()).velocity(velocity);
    new("bouncing").body(floor().material(rough)).body(block).body(wedge).build().unwrap()
}

/// A nut that turns on a screw, a bush that turns and slides, a gear between it and a hinge, and a driven slider.
fn screws() -> Scene {
    let mut scene = new("screws");
    let [nut, bush, wheel, carriage] =
        ["nut", "bush", "wheel", "carriage"].map(|name| scene.add_body(lump(name, DVec3::ZERO)));
    let axis = UnitVector::new(DVec3::new(0.1, 0.3, 1.0)).unwrap();
    let angle = Freedom::default().with_motor(Motor::new(Drive::Effort(0.3)).unwrap());
    let slide = Freedom::default()
        .with_spring(80.0, 0.05)
        .unwrap()
        .with_damping(2.0)
        .unwrap()
        .with_limits(Limits::new(-0.2, 0.06).unwrap());
    scene.add_joint(Joint::new(JointKind::Screw { axis, lead: 0.4 }, nut, DVec3::Z * 0.1));
    let bush_joint = Joint::new(JointKind::Cylindrical { axis }, bush, DVec3::X * 0.2);
    let bush_joint = bush_joint.along(Coordinate::Angle, angle).along(Coordinate::Displacement, slide);
    let bush_joint = scene.add_joint(bush_joint);
    let wheel = scene.add_joint(Joint::hinge(wheel, DVec3::Y * 0.1, axis));
    let carriage = scene.add_joint(Joint::new(JointKind::Slider { axis }, carriage, DVec3::ZERO));
    scene
        .gear(Gear::new(bush_joint, wheel, 0.2).unwrap().between(Coordinate::Displacement, Coordinate::Angle))
        .coordinate_motion(carriage, Coordinate::Displacement, CoordinateMotion::sine(0.1, 2.0, FRAC_PI_2).unwrap())
        .build()
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The same with the displacement of a cylindrical joint prescribed.
fn prescribed_slide() -> Scene {
    let mut scene = new("prescribed slide");
    let rate = 0.7;
    let axis = UnitVector::new(DVec3::new(0.1, 0.3, 1.0)).unwrap();
    let bush = scene.add_body(lump("bush", DVec3::ZERO).velocity(Velocity::new(axis.get() * rate, DVec3::ZERO)));
    let joint = scene.add_joint(Joint::new(JointKind::Cylindrical { axis }, bush, DVec3::X * 0.2));
    scene.coordinate_motion(joint, Coordinate::Displacement, CoordinateMotion::rate(rate).unwrap()).build().unwrap()
}

/// Kinematic bodies by each kind of motion, on one of which a ball falls, slips and rolls.
fn driven() -> Scene {
    let table = MotionTable {
        times_s: vec![0.0, 0.1, 0.2, 0.4],
        positions_m: Some(
            [[5.0, 0.0, 0.0], [5.0, 0.1, 0.05], [5.2, 0.1, 0.0], [5.2, 0.3, 0.1]].map(DVec3::from).into(),
        ),
        orientations: Some(SampledOrientations::RotationVectors(
            [[0.0, 0.0, 0.0], [0.1, 0.5, 0.0], [0.2, 0.9, -0.4], [0.2, 1.0, 0.3]].map(DVec3::from).into(),
        )),
        interpolation: Interpolation::Monotone,
    };
    let steady = Velocity::new(DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.0, 2.0, -0.5));
    let rough = Material::new("rough").with_friction(0.6).unwrap();
    let shaken = PrescribedMotion::sine(DVec3::new(0.02, 0.01, 0.005), DVec3::Z * 0.2, 3.0, 0.4).unwrap();
    let plate = Body::kinematic("plate", shaken).geometry(Shape::cuboid(DVec3::new(1.0, 1.0, 0.1)).unwrap().into());
    new("driven")
        .body(Body::kinematic("table", PrescribedMotion::table(&table).unwrap()))
        .body(
            Body::kinematic("steady", PrescribedMotion::constant_velocity(steady).unwrap())
                .pose(Pose::new(turned(1.0, 0.2, 0.3), DVec3::Y * 4.0)),
        )
        .body(plate.material(rough.clone()))
        .body(ball("ball", 1.0, 0.1, DVec3::new(0.1, 0.05, 0.2), DVec3::X * 0.5).material(rough))
        .build()
        .unwrap()
}

/// Wind, a fixed centre of gravity, a spring, and pushes in the axes of the world and of a body.
fn forces() -> Scene {
    let mut scene = new("forces").gravity(DVec3::new(1.0, 0.0, -9.0));
    let [a, b] = [DVec3::ZERO, DVec3::X].map(|at| scene.add_body(lump(&format!("at {}", at.x), at)));
    let push = |frame, body| Force::Applied {
        body,
        force: DVec3::new(3.0, 1.0, -2.0),
        torque: DVec3::new(0.1, 0.2, 0.3),
        frame,
        point: Some(DVec3::new(0.1, 0.2, -0.1)),
        signal: Signal::sinusoid(1.0, 3.0, 0.3).unwrap(),
    };
    let drag =
        |law| Force::Drag { body: a, law, translational: 0.7, rotational: 0.02, wind: DVec3::new(5.0, -2.0, 1.0) };
    let spring = Force::Spring {
        a: Attachment::World(DVec3::new(0.5, 0.5, 0.5)),
        b: Attachment::Body { body: b, point: DVec3::new(0.1, 0.0, 0.2) },
        stiffness: 50.0,
        rest_length: 0.3,
        damping: 1.0,
    };
    let between = Force::Spring {
        a: Attachment::Body { body: a, point: DVec3::Y * 0.1 },
        b: Attachment::Body { body: b, point: DVec3::X * 0.1 },
        stiffness: 20.0,
        rest_length: 0.4,
        damping: 0.0,
    };
    scene
        .force(Force::PointGravity { center: DVec3::new(-2.0, 1.0, 0.5), mu: 4.0 })
        .force(drag(DragLaw::Linear))
        .force(drag(DragLaw::Quadratic))
        .force(push(Frame::World, a))
        .force(push(Frame::Body, b))
        .force(spring)
        .force(between)
        .build()
        .unwrap()
}

/// A bead on a helix, which keeps a direction of the body along it, and one that turns freely.
fn beads() -> Scene {
    let mut scene = new("beads");
    let helix = Curve::helix(DVec3::ZERO, UnitVector::Z, DVec3::X, Coil { advance: -1.0, turns: 3.0 }).unwrap();
    let places = [1.2, 3.0].map(|arc| helix.at(arc).point);
    let track = scene.add_track(helix);
    for (place, follows) in places.into_iter().zip([Follows::Point, Follows::Frame { up: Some(UnitVector::Z) }]) {
        let body = scene.add_body(lump(&format!("bead at {}", place.z), place));
        let kind = JointKind::Track { track, hold: TrackHold::Both(follows), ends: TrackEnds::Stops(0.5) };
        scene = scene.joint(Joint::new(kind, body, place));
    }
    scene.build().unwrap_or_else(|error| panic!("{error}"))
}

/// A sledge with runners on a slanted belt, and one on boards with a grain of their own.
fn grains() -> Scene {
    let ellipse = |along, across| FrictionEllipse { along, across };
    let runners = Material::new("runners").with_grain(DVec3::new(1.0, 0.4, 0.0), ellipse(0.05, 0.6)).unwrap();
    let direction = Some(DVec3::new(0.3, 1.0, 0.0));
    let rule = PairRule::new(["boards".to_owned(), "ice".to_owned()]);
    let rule = rule.with_grain(direction, ellipse(0.1, 0.3)).unwrap();
    let thrown = Velocity::new(DVec3::new(1.0, 0.7, 0.0), DVec3::Z * 0.4);
    let belt = floor().material(Material::new("belt").with_friction(0.3).unwrap());
    new("grains")
        .body(belt.surface_velocity(DVec3::new(0.5, 0.2, 0.0)))
        .body(brick("sledge", DVec3::new(0.4, 0.3, 0.1), DVec3::Z * 0.05).material(runners).velocity(thrown))
        .body(
            Body::fixed("boards")
                .geometry(Shape::cuboid(DVec3::new(4.0, 4.0, 1.0)).unwrap().into())
                .pose(Pose::from_translation(DVec3::new(6.0, 0.0, 0.5)))
                .material(Material::new("boards")),
        )
        .body(
            brick("slab", DVec3::new(0.3, 0.4, 0.1), DVec3::new(6.0, 0.0, 1.05))
                .material(Material::new("ice"))
                .velocity(thrown),
        )
        .pair_rule(rule)
        .build()
        .unwrap()
}

/// Round shapes, a compound and a wedge fall onto a surface of triangles that is no mirror image of itself.
fn shapes() -> Scene {
    let valley = Shape::triangle_mesh(
        [[-3.0, -3.0, 0.4], [3.0, -3.0, 0.1], [3.0, 3.0, 0.0], [-3.0, 3.0, 0.2], [0.1, 0.2, -0.2]]
            .map(DVec3::from_array)
            .to_vec(),
        vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    );
    let cap = Shape::cone(0.1, 0.3).unwrap().placed(&Pose::new(turned(0.3, 0.2, 0.5), DVec3::Y * 0.1)).unwrap();
    let stem = Shape::capsule(0.05, 0.2).unwrap().placed(&Pose::new(turned(1.0, 0.2, 0.0), DVec3::X * 0.1)).unwrap();
    let mushroom = Shape::compound(vec![cap, stem]).unwrap();
    let can = Body::movable("can", Cylinder::new(0.1, 0.2).unwrap().solid(Mass::new(1.0).unwrap()).unwrap());
    let can = can.geometry(Shape::cylinder(0.1, 0.2).unwrap().into());
    new("shapes")
        .body(Body::fixed("valley").geometry(valley.unwrap().into()).material(elastic(0.4)))
        .body(can.pose(Pose::new(turned(0.5, 0.4, 0.3), DVec3::new(-0.8, 0.3, 0.2))))
        .body(lump("mushroom", DVec3::new(0.8, -0.5, 0.25)).geometry(mushroom.into()))
        .body(wedge("wedge", DVec3::new(0.1, 1.2, 0.3)))
        .body(ball("ball", 1.0, 0.1, DVec3::new(1.5, 1.5, 0.3), DVec3::X))
        .no_contact([polhode::BodyId::new(1), polhode::BodyId::new(3)])
        .build()
        .unwrap()
}

fn scenes() -> Vec<Scene> {
    vec![
        free_rotation(),
        pendulums(),
        bouncing(),
        screws(),
        prescribed_slide(),
        driven(),
        forces(),
        beads(),
        grains(),
        shapes(),
    ]
}

fn everything(handedness: Handedness) -> SceneCopy {
    let space = Isometry::new(turned(0.7, -1.1, 0.4), DVec3::new(0.5, -0.3, 0.8), handedness);
    SceneCopy::new(space, ListOrder::Reversed)
}

/// The largest distance of two samples of all bodies, m and rad.
fn apart(own: &[BodySample], other: &[BodySample]) -> f64 {
    assert_eq!(own.len(), other.len());
    own.iter().zip(other).fold(0.0, |most: f64, (own, other)| {
        let turned = own.pose.rotation.angle_to(other.pose.rotation);
        most.max(own.pose.translation.distance(other.pose.translation)).max(turned)
    })
}

#[track_caller]
fn moves_alike(scene: &Scene, copy: &SceneCopy) {
    let (_, own) = run(scene, Effects::Planned);
    let (_, other) = run(&copy.of(scene).unwrap(), Effects::Planned);
    assert_eq!(own.times_s, other.times_s);
    for ((t_s, own), other) in own.times_s.iter().zip(&own.samples).zip(&other.samples) {
        let other = copy.undone(other);
        let difference = apart(own, &other);
        assert!(difference < SAME_MOTION, "{}: {difference:e} at t = {t_s} s {copy:?}", scene.name());
        for (own, other) in own.iter().zip(other) {
            let difference = (own.velocity.linear - other.velocity.linear).length();
            assert!(difference < 1e-8, "{}: {difference:e} m/s at t = {t_s} s", scene.name());
        }
    }
}

/// Turned, shifted and in the opposite order everything moves as it did.
#[test]
fn turned_scenes_move_alike() {
    for scene in scenes() {
        moves_alike(&scene, &everything(Handedness::Kept));
    }
}

/// So it does in a mirror: spins change their sense, threads their hand, grains their slant.
#[test]
fn mirrored_scenes_move_alike() {
    for scene in scenes() {
        moves_alike(&scene, &SceneCopy::new(mirror(), ListOrder::Kept));
        moves_alike(&scene, &everything(Handedness::Mirrored));
    }
}

fn mirror() -> Isometry {
    Isometry::new(Rotation::IDENTITY, DVec3::ZERO, Handedness::Mirrored)
}

/// The mirror image of the mirror image is the scene, to the last bit of every sample.
#[test]
fn the_image_of_the_image_is_the_scene() {
    let copy = SceneCopy::new(mirror(), ListOrder::Reversed);
    for scene in [free_rotation(), pendulums(), screws(), forces(), shapes()] {
        let again = copy.of(&copy.of(&scene).unwrap()).unwrap();
        assert_eq!(run(&scene, Effects::Planned).1.samples, run(&again, Effects::Planned).1.samples);
    }
}

/// A monotone table, whose samples it does not leave, is not warned of when it is turned.
#[test]
fn turned_monotone_tables_are_not_warned_of() {
    let turned = everything(Handedness::Kept).of(&driven()).unwrap();
    assert!(turned.warnings().is_empty(), "{:?}", turned.warnings());
}

/// A screw in a mirror has the other thread: it goes the other way for the same turn about its axis.
#[test]
fn screws_change_hands() {
    let scene = SceneCopy::new(mirror(), ListOrder::Kept).of(&screws()).unwrap();
    let leads = scene.joints().iter().filter_map(|joint| match joint.kind() {
        JointKind::Screw { lead, .. } => Some(lead),
        _ => None,
    });
    assert_eq!(leads.collect::<Vec<_>>(), [-0.4]);
}

/// Where impacts pass from contact to contact by the numbers of bodies, another order is another scene.
#[test]
fn order_of_bodies_is_refused_where_impacts_follow_it() {
    let propagated = |order| {
        let method = Method { impact: Some(ImpactLaw::Propagation), propagation_order: Some(order), ..accurate() };
        bouncing().with_method(method)
    };
    let [turned, reversed] = [ListOrder::Kept, ListOrder::Reversed].map(|order| SceneCopy::new(mirror(), order));
    let by_key = propagated(PropagationOrder::Key);
    assert!(turned.of(&by_key).is_ok());
    assert!(matches!(reversed.of(&by_key), Err(CopyError::StruckByNumber)));
    let drawn = propagated(PropagationOrder::Random { seed: 3 });
    assert!(matches!(turned.of(&drawn), Err(CopyError::StruckAtRandom)));
}

/// A field of the program is refused by its number.
#[test]
fn fields_of_programs_are_refused() {
    use polhode::dynamics::field::PointGravity;
    let field = Force::Field(std::sync::Arc::new(PointGravity::new(1.0, DVec3::Z).unwrap()));
    let scene = new("field").body(lump("lump", DVec3::ZERO)).force(field).build().unwrap();
    let refused = everything(Handedness::Kept).of(&scene).unwrap_err();
    assert!(refused.to_string().starts_with("force number 0 (counted from 0) is a field"), "{refused}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// At the start a copy undone is the scene, for any turn and shift.
    #[test]
    fn a_copy_undone_is_the_scene(
        turn in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-5.0..5.0_f64),
        handedness in prop_oneof![Just(Handedness::Kept), Just(Handedness::Mirrored)],
        order in prop_oneof![Just(ListOrder::Kept), Just(ListOrder::Reversed)],
    ) {
        let turn = Rotation::from_rotation_vector(DVec3::from_array(turn));
        let copy = SceneCopy::new(Isometry::new(turn, DVec3::from_array(shift), handedness), order);
        for scene in scenes() {
            let own = Simulation::new(&scene).unwrap().bodies();
            let other = Simulation::new(&copy.of(&scene).unwrap()).unwrap().bodies();
            let difference = apart(&own, &copy.undone(&other));
            prop_assert!(difference < 1e-13, "{}: {difference:e}", scene.name());
            let there = apart(&copy.samples(&own), &other);
            prop_assert!(there < 1e-13, "{}: {there:e}", scene.name());
        }
    }

    /// The motion is the same for any turn and shift.
    #[test]
    fn a_thrown_lump_moves_alike(
        turn in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-5.0..5.0_f64),
        handedness in prop_oneof![Just(Handedness::Kept), Just(Handedness::Mirrored)],
    ) {
        let turn = Rotation::from_rotation_vector(DVec3::from_array(turn));
        let space = Isometry::new(turn, DVec3::from_array(shift), handedness);
        for scene in [free_rotation(), pendulums(), forces()] {
            moves_alike(&scene, &SceneCopy::new(space, ListOrder::Reversed));
        }
    }
}
