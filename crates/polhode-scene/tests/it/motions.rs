//! Prescribed motions: what is accepted, what absent keys mean, and what is refused.

use crate::{BASE, check, refused, scene};
use polhode::scene::Trajectory;
use polhode::spatial::{DVec3, Motion, Pose, Rotation};
use polhode_scene::Refusal;

/// `BASE` with lines put to a kinematic body that stands before the others.
fn with(lines: &str) -> String {
    BASE.replace(
        "[[bodies]]\nname = \"floor\"",
        &format!("[[bodies]]\nname = \"mover\"\n{lines}\n\n[[bodies]]\nname = \"floor\""),
    )
}

/// The trajectory of the kinematic body with these lines.
fn trajectory(lines: &str) -> Trajectory {
    scene(&with(lines)).bodies()[0].trajectory().unwrap()
}

/// The position of a motion at a time.
fn position(trajectory: &Trajectory, t: f64) -> [f64; 3] {
    trajectory.pose(t).translation.to_array()
}

/// A constant velocity, an angular velocity, or both, from the body's position.
#[test]
fn constant() {
    let moving = trajectory("position = [1, 0, 0]\nmotion.constant = { velocity = [0, 2, 0] }");
    assert_eq!(position(&moving, 3.0), [1.0, 6.0, 0.0]);
    assert_eq!(moving.pose(3.0).rotation, Rotation::IDENTITY);
    let turning = trajectory("shape.sphere.radius = 1\nmotion.constant.angular_velocity = [0, 0, 0.5]");
    assert_eq!(position(&turning, 3.0), [0.0; 3]);
    assert!(turning.pose(3.0).rotation.angle_to(Rotation::from_rotation_vector(DVec3::Z * 1.5)) < 1e-15);
    let both = trajectory("motion.constant = { velocity = [1, 0, 0], angular_velocity = [0, 1, 0] }");
    assert_eq!(both.velocity(0.0).linear, DVec3::X);
    assert_eq!(both.velocity(0.0).angular, DVec3::Y);
}

/// An oscillation about the body's position and orientation, without phase unless it is given; the axis may be of any
/// length.
#[test]
fn sine() {
    let shaken = trajectory("position = [0, 0, 1]\nmotion.sine = { amplitude = [0, 0, 0.5], frequency = 2 }");
    assert_eq!(position(&shaken, 0.0), [0.0, 0.0, 1.0]);
    assert_eq!(position(&shaken, 0.125), [0.0, 0.0, 1.5]);
    let quarter = std::f64::consts::FRAC_PI_2;
    let swung = format!("motion.sine = {{ axis = [0, 0, 7], angle = 0.25, frequency = 2, phase = {quarter} }}");
    let swung = trajectory(&format!("rotation_vector = [1, 0, 0]\n{swung}"));
    let start = Rotation::from_rotation_vector(DVec3::Z * 0.25) * Rotation::from_rotation_vector(DVec3::X);
    assert!(swung.pose(0.0).rotation.angle_to(start) < 1e-15);
    assert_eq!(swung.pose(0.3).translation, DVec3::ZERO);
    let all = "motion.sine = { amplitude = [1, 0, 0], axis = [0, 1, 0], angle = 1, frequency = 0.5, phase = 0.1 }";
    assert!(trajectory(all).velocity(0.0).linear.x > 3.0);
}

/// Samples are where the body is; what the table leaves out comes from the body, and what the body leaves out from the
/// table.
#[test]
fn tables() {
    let places = "motion.table = { times = [0, 1, 2], positions = [[1, 0, 0], [2, 0, 0], [2, 3, 0]] }";
    let moved = trajectory(&format!("orientation = [0, 0, 0, 1]\n{places}"));
    assert_eq!([0.0, 1.0, 2.0, 9.0].map(|t| position(&moved, t)[1]), [0.0, 0.0, 3.0, 3.0]);
    assert!(moved.pose(0.7).rotation.angle_to(Rotation::from_rotation_vector(DVec3::Z * std::f64::consts::PI)) < 1e-15);
    assert_eq!(*scene(&with(places)).bodies()[0].initial_pose(), Pose::from_translation(DVec3::X));
    let quaternions = "motion.table.orientations = [[1, 0, 0, 0], [0.8, 0.6, 0, 0]]";
    let turned = trajectory(&format!("position = [7, 0, 0]\nmotion.table.times = [-1, 1]\n{quaternions}"));
    assert_eq!(position(&turned, 0.3), [7.0, 0.0, 0.0]);
    assert_eq!(turned.pose(1.0).rotation, Rotation::from_wxyz([0.8, 0.6, 0.0, 0.0]).unwrap());
    let vectors = "motion.table = { times = [0, 1, 2], rotation_vectors = [[0, 0, 0], [0, 0, 3], [0, 0, 6]] }";
    assert!(trajectory(vectors).velocity(1.0).angular.z > 3.0);
    // A pose given besides is that of the table at t = 0.
    trajectory(&format!("position = [1, 0, 0]\n{places}"));
    trajectory("position = [1, 0, 0]\nmotion.table = { times = [-1, 1], positions = [[0, 0, 0], [2, 0, 0]] }");
}

/// Any shape that a fixed body may have; no force of the scene acts on the body, and drag on all bodies leaves it out.
#[test]
fn shapes_and_forces() {
    for shape in ["half_space.normal = [0, 0, 1]", "sphere.radius = 1", "box.size = [1, 2, 3]"] {
        scene(&with(&format!("shape.{shape}\nposition = [0, 0, -9]\nmotion.constant.velocity = [1, 0, 0]")));
    }
    let still = with("motion.constant.velocity = [1, 0, 0]");
    let forces = |force: &str| format!("{still}\n[[forces]]\n{force}\n");
    let drag = scene(&forces("type.drag = { law = \"linear\", translational = 1 }"));
    assert_eq!(drag.forces().len(), 1);
    let torque = forces("type.torque = { body = \"mover\", torque = [0, 0, 1] }");
    check(&torque, "forces.0.type.torque.body", "mover", "no meaning for a body with a prescribed motion");
    let springs = [
        ("type.spring = { bodies = [\"mover\", \"brick\"], stiffness = 1 }", "forces.0.type.spring.bodies.0"),
        ("type.spring = { body = \"mover\", anchor = [0, 0, 0], stiffness = 1 }", "forces.0.type.spring.body"),
    ];
    for (spring, key) in springs {
        check(&forces(spring), key, "mover", "not yet available: a spring fastened to a body with a prescribed motion");
    }
}

/// Keys of bodies that forces move, or that do not move, have no meaning beside a motion.
#[test]
fn meaningless_keys() {
    let cases = [
        ("mass = 1", "mass"),
        ("density = 1", "density"),
        ("inertia = [1, 1, 1]", "inertia"),
        ("hollow = true", "hollow"),
        ("velocity = [0, 0, 0]", "velocity"),
        ("angular_velocity = [0, 0, 1]", "angular_velocity"),
        ("pivot = [0, 0, 0]", "pivot"),
    ];
    for (line, key) in cases {
        let text = with(&format!("{line}\nmotion.constant.velocity = [1, 0, 0]"));
        check(&text, &format!("bodies.mover.{key}"), line, "no meaning for a body with a prescribed motion");
    }
    let fixed = with("fixed = true\nmotion.constant.velocity = [1, 0, 0]");
    check(&fixed, "bodies.mover.motion", "motion", "`motion` and `fixed` cannot both be given");
}

/// Kinds and keys that there are not, several kinds, wrong types and missing keys.
#[test]
fn kinds_and_types() {
    let cases = [
        ("motion = 3", "motion", "constant"),
        ("motion = \"sine\"", "motion", "motion.constant.velocity"),
        ("motion = {}", "motion", "accepted: one of constant, sine or table"),
        ("motion.circle = { radius = 1 }", "motion.circle", "`constant`, `sine`"),
        ("motion = { constant = { velocity = [1, 0, 0] }, sine = { frequency = 1 } }", "motion", "exactly one"),
        ("motion.constant = { speed = 1 }", "motion.constant.speed", "accepted: `velocity`"),
        ("motion.constant = {}", "motion.constant", "`velocity` or `angular_velocity`"),
        ("motion.constant = 3", "motion.constant", "accepted: a table"),
        ("motion.constant = { velocity = [1, 0] }", "motion.constant.velocity", "an array of length 3"),
        ("motion.sine = { amplitude = [1, 0, 0] }", "motion.sine", "missing key `frequency`"),
        ("motion.sine = { frequency = 1 }", "motion.sine", "`amplitude`, or `axis` and `angle`"),
        ("motion.sine = { frequency = 1, axis = [1, 0, 0] }", "motion.sine", "a sine with an axis needs `angle`"),
        ("motion.sine = { frequency = 1, angle = 1 }", "motion.sine", "a sine with an angle needs `axis`"),
        ("motion.sine = { frequency = 1, axis = [0, 0, 0], angle = 1 }", "motion.sine.axis", "no direction"),
        ("motion.table = { positions = [[0, 0, 0], [1, 0, 0]] }", "motion.table", "missing key `times`"),
        ("motion.table = { times = [0, 1] }", "motion.table", "neither positions nor orientations"),
    ];
    for (line, key, message) in cases {
        check(&with(line), &format!("bodies.mover.{key}"), line, message);
    }
    assert!(matches!(refused(&with("motion = {}")).cause, Refusal::MotionKinds));
}

/// Numbers that prescribe no motion are refused where they stand.
#[test]
fn numbers() {
    let sine = |rest: &str| format!("motion.sine = {{ amplitude = [1, 0, 0], {rest} }}");
    let table = |rest: &str| format!("motion.table = {{ {rest} }}");
    let two = "positions = [[0, 0, 0], [1, 0, 0]]";
    let cases = [
        ("motion.constant.velocity = [0, nan, 0]".to_owned(), "motion.constant.velocity.1", "a finite number"),
        ("motion.constant.velocity = [1e101, 0, 0]".to_owned(), "motion.constant", "at most 1e100"),
        (sine("frequency = 0"), "motion.sine.frequency", "a positive number is needed"),
        (sine("frequency = -1"), "motion.sine.frequency", "a positive number is needed"),
        (sine("frequency = inf"), "motion.sine.frequency", "a finite number"),
        (sine("frequency = 1, phase = nan"), "motion.sine.phase", "a finite number"),
        (sine("frequency = 1e60"), "motion.sine", "an acceleration in m/s^2"),
        (table(&format!("times = [0, nan], {two}")), "motion.table.times.1", "a finite number"),
        (table(&format!("times = [1, 1], {two}")), "motion.table.times.1", "sample 1 has 1 s after 1 s"),
        (table(&format!("times = [1, 0.5], {two}")), "motion.table.times.1", "must rise"),
        (table("times = [], positions = []"), "motion.table.times", "has 0 samples: two or more"),
        (table("times = [0], positions = [[0, 0, 0]]"), "motion.table.times", "two or more"),
        (table(&format!("times = [0, 1, 2], {two}")), "motion.table.positions", "2 positions for 3 times"),
        (
            table("times = [0, 1], positions = [[0, 0, 0], [inf, 0, 0]]"),
            "motion.table.positions.1.0",
            "a finite number",
        ),
        (table("times = [0, 1], orientations = [[1, 0, 0, 0]]"), "motion.table.orientations", "1 orientations"),
        (
            table("times = [0, 1], orientations = [[1, 0, 0, 0], [1, 1, 0, 0]]"),
            "motion.table.orientations.1",
            "which must be 1",
        ),
        (
            table("times = [0, 1], orientations = [[1, 0, 0, 0], [0, 1, 0, 0]]"),
            "motion.table.orientations.1",
            "half a turn may go either way",
        ),
        (
            table("times = [0, 1], rotation_vectors = [[0, 0, 0], [0, 0, 6.5]]"),
            "motion.table.rotation_vectors.1",
            "add samples between them",
        ),
        (
            table("times = [0, 1], orientations = [[1, 0, 0, 0]], rotation_vectors = [[0, 0, 0]]"),
            "motion.table.rotation_vectors",
            "cannot both be given",
        ),
    ];
    for (line, key, message) in cases {
        check(&with(&line), &format!("bodies.mover.{key}"), &line, message);
    }
}

/// A pose that contradicts the table is refused at its key, with the one that is needed.
#[test]
fn poses_that_contradict_the_table() {
    let table = "motion.table = { times = [0, 1], positions = [[1, 0, 0], [2, 0, 0]], rotation_vectors = [[0, 0, 0], \
        [0, 0, 1]] }";
    let cases = [
        ("position = [1.1, 0, 0]", "position", "[1.0, 0.0, 0.0]"),
        ("orientation = [0, 1, 0, 0]", "orientation", "[1.0, 0.0, 0.0, 0.0]"),
        ("rotation_vector = [0, 0, 0.1]", "rotation_vector", "give that orientation, or leave it out"),
    ];
    for (line, key, message) in cases {
        check(&with(&format!("{line}\n{table}")), &format!("bodies.mover.{key}"), line, message);
    }
}

/// A hold of two equal samples stands still unless a spline is asked for, which is warned of; what is between the
/// samples can be named.
#[test]
fn interpolations() {
    let table = |more: &str| {
        format!("motion.table = {{ times = [0, 5, 5.05], positions = [[0, 0, 3], [0, 0, 3], [0, 0, 1]]{more} }}")
    };
    let highest = |more: &str| {
        let moving = trajectory(&table(more));
        (0..=505).map(|k| position(&moving, 0.01 * f64::from(k))[2]).fold(0.0, f64::max)
    };
    for more in ["", ", interpolation = \"monotone\"", ", interpolation = \"linear\""] {
        assert_eq!(highest(more), 3.0, "{more}");
        assert_eq!(scene(&with(&table(more))).warnings(), [""; 0], "{more}");
    }
    let spline = ", interpolation = \"spline\"";
    assert!(highest(spline) > 42.0);
    let warnings = scene(&with(&table(spline))).warnings();
    let [warning] = &warnings[..] else { panic!("one warning") };
    for part in ["mover", "z = 42.8 m", "between sample 0 and sample 1", "39.8 m beyond", "\"monotone\""] {
        assert!(warning.contains(part), "{part}: {warning}");
    }
    let unknown = table(", interpolation = \"cubic\"");
    check(&with(&unknown), "bodies.mover.motion.table.interpolation", "\"cubic\"", "cubic");
}

/// A linear table of a body that others may touch is refused with the reason, and accepted where nothing can touch it
/// or where it does not jump during the run.
#[test]
fn jumps_of_bodies_that_may_be_touched_are_refused() {
    let lift = |times: &str, name: &str| {
        with(&format!(
            "shape.box.size = [1, 1, 1]\nmotion.table = {{ times = {times}, positions = [[9, 0, 0], [9, 0, 1], [9, 0, \
             1]], interpolation = \"linear\" }}"
        )) + &format!("\n[[bodies]]\nname = \"{name}\"\nshape.sphere.radius = 0.1\nmass = 1\nposition = [20, 0, 20]\n")
    };
    let error = refused(&lift("[0, 0.5, 2]", "free"));
    assert!(error.cause.to_string().contains("its velocity jumps at t = 0.5 s"), "{}", error.cause);
    scene(&lift("[0, 50, 60]", "free"));
}
