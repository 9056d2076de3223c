//! What drives the joints of robots: drives of the scene and actuators of MJCF.
//!
//! A pendulum with a position actuator is the damped oscillator of its closed form, rests under gravity where
//! `kp (u - q) = m g l sin q`, and turns by a motor as `q'' = tau / I` says; a motor is bounded as its file or the
//! scene says; a prescribed motion is followed exactly from velocities that fit it. Classes, gears and ranges of
//! actuators mean what MuJoCo takes them for; keyframes put robots where they say. What is wrong with either is told at
//! its line.

use crate::robots::{Folder, joint, link, shipped, urdf};
use glam::DVec3;
use polhode::scene::{Coordinate, Drive, Motor};
use polhode::{Scene, Simulation};
use polhode_scene::robot::Severity;
use polhode_scene::{LoadedScene, Override, load_with};

/// Mass, kg; distance of its centre, m; moment about the centre, kg m^2, of the pendulum.
const PENDULUM: [f64; 3] = [2.0, 0.4, 0.1];

/// Its moment of inertia about the pin.
const INERTIA: f64 = PENDULUM[2] + PENDULUM[0] * PENDULUM[1] * PENDULUM[1];

/// A pendulum whose pin has these attributes, with what else the file holds. `q` is zero where it hangs.
fn pendulum(pin: &str, option: &str, rest: &str) -> String {
    let [mass, arm, moment] = PENDULUM;
    format!(
        "<mujoco model=\"p\"><compiler angle=\"radian\"/><option {option}/>\n<worldbody><body name=\"rod\"><joint \
         name=\"pin\" axis=\"0 1 0\" {pin}/><inertial pos=\"0 0 {}\" mass=\"{mass}\" diaginertia=\"{moment} {moment} \
         0.01\"/></body></worldbody>\n{rest}</mujoco>",
        -arm
    )
}

/// The same pendulum as a URDF.
fn pendulum_urdf(limit: &str) -> String {
    let [mass, arm, moment] = PENDULUM;
    urdf(&[
        "<link name=\"world\"/>".to_owned(),
        link("rod", mass, [0.0, 0.0, -arm], [moment, moment, 0.01]),
        joint("pin", "revolute", ["world", "rod"], &format!("<axis xyz=\"0 1 0\"/><limit {limit}/>")),
    ])
}

fn actuator(inside: &str) -> String {
    format!("<actuator>{inside}</actuator>")
}

/// The scene of a robot without gravity that forces its motion to be as exact as the engine has it.
fn weightless(folder: &Folder, file: &str, keys: &str) -> LoadedScene {
    let text =
        format!("{keys}\n[[bodies]]\nname = \"far\"\nfixed = true\nshape.sphere.radius = 1\nposition = [9, 0, 0]");
    let text = format!("format = 1\ngravity = [0, 0, 0]\n[[models]]\nfile = {file:?}\n{text}\n");
    let origin = folder.path("scene.toml");
    polhode_scene::load_text(&origin.to_string_lossy(), &text, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// Value and rate of the coordinate of a joint after some seconds.
fn after(scene: &Scene, number: usize, t: f64) -> (f64, f64) {
    let coordinate = scene.joints()[number].kind().coordinates()[0];
    let mut simulation = Simulation::new(scene).unwrap_or_else(|error| panic!("{error}"));
    simulation.advance_to(t).unwrap();
    let own = simulation.coordinate(polhode::JointId::new(number), coordinate).unwrap();
    (own.value, own.rate)
}

fn motor(scene: &Scene, number: usize) -> Option<Motor> {
    scene.joints()[number].freedom(Coordinate::Angle).and_then(|freedom| freedom.motor())
}

fn told(loaded: &LoadedScene) -> Vec<String> {
    loaded.findings().map(ToString::to_string).collect()
}

/// Text of what is told, when one of it holds these words.
#[track_caller]
fn told_of(loaded: &LoadedScene, words: &str) {
    let told = told(loaded);
    assert!(told.iter().any(|told| told.contains(words)), "no `{words}` in {told:#?}");
}

/// `I q'' = kp (u - q) - (kv + d) q'`: a damped oscillator about the control.
#[test]
fn a_position_actuator_is_a_damped_oscillator() {
    let (kp, kv, d, u) = (30.0, 0.5, 0.2, 0.7);
    let servo = actuator(&format!("<position name=\"servo\" joint=\"pin\" kp=\"{kp}\" kv=\"{kv}\"/>"));
    let text = pendulum(&format!("damping=\"{d}\""), "gravity=\"0 0 0\"", &servo);
    let folder = Folder::new().with("p.xml", &text);
    let scene = weightless(&folder, "p.xml", &format!("controls = {{ servo = {u} }}")).scene;
    let (delta, square) = ((kv + d) / (2.0 * INERTIA), kp / INERTIA);
    let omega = (square - delta * delta).sqrt();
    for t in [0.3, 1.0, 2.0] {
        let turn = omega * t;
        let expected = u - u * (-delta * t).exp() * (turn.cos() + delta / omega * turn.sin());
        let (found, _) = after(&scene, 0, t);
        assert!((found - expected).abs() < 1e-9, "{t}: {found} for {expected}");
    }
}

/// A servo with stiffness holds a load where its effort is that of the weight: `q = u - m g / kp` of a slider,
/// `kp (u - q) = m g l sin q` of a pendulum, which stays where it starts there.
#[test]
fn a_servo_holds_a_weight() {
    let slide = "<mujoco><worldbody><body name=\"load\"><joint name=\"lift\" type=\"slide\" axis=\"0 0 1\"/><inertial \
        pos=\"0 0 0\" mass=\"3\" diaginertia=\"1 1 1\"/></body></worldbody><actuator><position name=\"servo\" \
        joint=\"lift\" kp=\"1500\" kv=\"100\" gear=\"2\"/></actuator></mujoco>";
    // The gear doubles what the servo measures and what it exerts: K = 4 kp, E = 2 kp u.
    let (control, weight) = (0.3, 3.0 * 9.81);
    let rest = 0.5 * control - weight / (4.0 * 1500.0);
    let folder = Folder::new().with("s.xml", slide);
    let keys = format!("controls = {{ servo = {control} }}\nconfiguration = {{ lift = {rest:?} }}");
    let loaded = folder.scene("s.xml", &keys).unwrap();
    let (moved, rate) = after(&loaded.scene, 0, 1.0);
    assert!(moved.abs() < 1e-12 && rate.abs() < 1e-12, "{moved} {rate}");
    told_of(&loaded, "read: actuator `servo`: <position> at joint `lift`, control 0.3: to 0.15 m, stiffness 6000 N/m");

    let [mass, arm, _] = PENDULUM;
    let (kp, q) = (40.0, 0.9_f64);
    let control = q + mass * 9.81 * arm * q.sin() / kp;
    let servo = actuator(&format!("<position name=\"servo\" joint=\"pin\" kp=\"{kp}\" kv=\"8\"/>"));
    let folder = Folder::new().with("p.xml", &pendulum("", "", &servo));
    let keys = format!("controls = {{ servo = {control:?} }}\nconfiguration = {{ pin = {q} }}");
    let scene = folder.scene("p.xml", &keys).unwrap().scene;
    let (moved, rate) = after(&scene, 0, 1.0);
    assert!(moved.abs() < 1e-9 && rate.abs() < 1e-9, "{moved} {rate}");
}

/// A torque turns the pendulum by `q'' = tau / I`; a servo of velocity reaches it as `1 - exp(-gain t / I)`.
#[test]
fn motors_of_the_scene() {
    let folder = Folder::new().with("p.urdf", &pendulum_urdf("lower=\"-3\" upper=\"3\" effort=\"5\" velocity=\"9\""));
    let drive = |motor: &str| weightless(&folder, "p.urdf", &format!("drives.pin.motor = {{ {motor} }}"));
    let (torque, t) = (1.5, 0.5);
    let (angle, rate) = after(&drive(&format!("effort = {torque}")).scene, 0, t);
    assert!((angle - 0.5 * torque / INERTIA * t * t).abs() < 1e-12, "{angle}");
    assert!((rate - torque / INERTIA * t).abs() < 1e-12, "{rate}");
    let (goal, gain) = (2.0, 1.2);
    let (_, rate) = after(&drive(&format!("velocity = {goal}, gain = {gain}")).scene, 0, t);
    let expected = goal * (1.0 - (-gain * t / INERTIA).exp());
    assert!((rate - expected).abs() < 1e-9, "{rate} for {expected}");
    // The target of a servo is a value of the joint as its file counts it, wherever it starts.
    let keys = "configuration = { pin = 0.4 }\ndrives.pin.motor = { position = 1.0, stiffness = 50, damping = 9 }";
    let scene = weightless(&folder, "p.urdf", keys).scene;
    let (turned, _) = after(&scene, 0, 4.0);
    assert!((turned - 0.6).abs() < 1e-6, "{turned}");
}

/// The effort that a file allows bounds a drive that names none; one that does is bounded by its own.
#[test]
fn efforts_are_bounded() {
    let folder = Folder::new().with("p.urdf", &pendulum_urdf("lower=\"-3\" upper=\"3\" effort=\"5\" velocity=\"9\""));
    let drive = |motor: &str| weightless(&folder, "p.urdf", &format!("drives.pin.motor = {{ {motor} }}"));
    let loaded = drive("effort = 50");
    assert_eq!(motor(&loaded.scene, 0).unwrap().most(), 5.0);
    told_of(&loaded, "read: joint `pin`: driven by the scene: 50 N m, at most 5 N m (`effort` of <limit> in its file)");
    assert!(told(&loaded).iter().all(|told| !told.contains("`effort` of <limit>: it bounds")), "{:?}", told(&loaded));
    let (angle, _) = after(&loaded.scene, 0, 0.5);
    assert!((angle - 0.5 * 5.0 / INERTIA * 0.25).abs() < 1e-12, "{angle}");
    assert_eq!(motor(&drive("effort = 50, most = 20").scene, 0).unwrap().most(), 20.0);
    assert_eq!(motor(&drive("effort = 50, most = inf").scene, 0).unwrap().most(), f64::INFINITY);
    let of_joint = pendulum(
        "actuatorfrcrange=\"-3 3\"",
        "",
        &actuator("<motor joint=\"pin\" name=\"m\" gear=\"2\" ctrlrange=\"-4 4\"/>"),
    );
    let folder = Folder::new().with("p.xml", &of_joint);
    let loaded = folder.scene("p.xml", "controls = { m = 9 }").unwrap();
    let own = motor(&loaded.scene, 0).unwrap();
    assert_eq!((own.drive(), own.most()), (Drive::Effort(8.0), 3.0));
    told_of(&loaded, "warning: actuator `m`: its control is 9, outside its range from -4 to 4: it is moved into it");
}

/// A joint whose motion is prescribed follows it, the bodies behind it start with the velocities that go with it, and
/// other joints are as they were.
#[test]
fn prescribed_motions() {
    let arm = shipped("servo-arm.xml").display().to_string();
    let scene = |motion: &str| {
        let keys = format!("drives.shoulder.motion.{motion}\ndrives.elbow.motion.rate = 0.5");
        let text = format!("format = 1\nduration = 1.0\n[[models]]\nfile = {arm:?}\n{keys}\n");
        polhode_scene::load_text("scene.toml", &text, &[]).unwrap_or_else(|error| panic!("{error}"))
    };
    let (amplitude, frequency, t) = (0.4, 1.5, 0.37);
    let loaded = scene(&format!("sine = {{ amplitude = {amplitude}, frequency = {frequency} }}"));
    let turn = std::f64::consts::TAU * frequency * t;
    let (angle, _) = after(&loaded.scene, 0, t);
    assert!((angle - amplitude * turn.sin()).abs() < 1e-9, "{angle}");
    let (angle, rate) = after(&loaded.scene, 1, t);
    assert!((angle - 0.5 * t).abs() < 1e-9 && (rate - 0.5).abs() < 1e-9, "{angle} {rate}");
    told_of(&loaded, "read: joint `shoulder`: driven by the scene: its motion is prescribed");
    told_of(&loaded, "read: joint `shoulder`: its limits are not kept: its motion is prescribed");
    told_of(&loaded, "ignored: joint `shoulder`: <position> `shoulder_servo`: the scene drives the joint in its place");
    let loaded = scene("table = { times = [0, 0.5, 1], values = [0, 0.2, -0.3] }");
    let (angle, _) = after(&loaded.scene, 0, 0.5);
    assert!((angle - 0.2).abs() < 1e-9, "{angle}");
}

/// Names with `*` drive all joints that they stand for; the name of a joint comes before them.
#[test]
fn patterns() {
    let drives = "drives.'*'.motor = { effort = 1 }\ndrives.wrist.motor = { effort = 2 }";
    let text = std::fs::read_to_string(shipped("servo-arm.xml")).unwrap();
    let folder = Folder::new().with("a.xml", &text);
    let scene = folder.scene("a.xml", drives).unwrap().scene;
    let efforts: Vec<_> = (0..3).map(|number| motor(&scene, number).unwrap().drive()).collect();
    assert_eq!(efforts, [Drive::Effort(1.0), Drive::Effort(1.0), Drive::Effort(2.0)]);
    let twice = "drives.'*o*'.motor = { effort = 1 }\ndrives.'sh*'.motor = { effort = 2 }";
    let error = folder.scene("a.xml", twice).unwrap_err();
    assert!(error.contains("joint `shoulder` is driven by `*o*` too"), "{error}");
    assert!(error.contains("models.0.drives.\"sh*\""), "{error}");
}

/// What a drive, a control or a keyframe of the scene names must be there, and nearest names come first.
#[test]
fn names_that_nothing_bears() {
    let text = std::fs::read_to_string(shipped("servo-arm.xml")).unwrap();
    let folder = Folder::new().with("a.xml", &text);
    let refused = |keys: &str, parts: &[&str]| {
        let error = folder.scene("a.xml", keys).unwrap_err();
        for part in parts {
            assert!(error.contains(part), "{keys}: {error}");
        }
    };
    refused("drives.sholder.motor = { effort = 1 }", &["no hinge or slider is named `sholder`", "`shoulder`"]);
    refused("drives.'knee*'.motor = { effort = 1 }", &["no hinge or slider is named `knee*`"]);
    refused("controls.wrist_moter = 1", &["no actuator is named `wrist_moter`", "did you mean `wrist_motor`?"]);
    refused("controls.wrist_motor = nan", &["NaN is not accepted"]);
    refused("keyframe = 'rised'", &["no keyframe is named `rised`", "did you mean `raised`?"]);
    refused("drives.wrist = {}", &["a drive needs `motor` or `motion`"]);
    refused("drives.wrist.motor = {}", &["a motor is exactly one of `effort`, `velocity` and `position`"]);
    refused("drives.wrist.moter = { effort = 1 }", &["unknown key `moter`"]);
    refused("drives.wrist = { motor.effort = 1, motion.rate = 1 }", &["`motion` and `motor` cannot both be given"]);
    refused("drives.wrist.motor = { position = 1 }", &["missing key `stiffness`"]);
}

/// What MuJoCo (3.17) makes of classes and of the ways to write an actuator: gain, `biasprm[1]`, `biasprm[2]`, gear 1.
#[test]
fn classes_of_actuators() {
    let position = "<position kp=\"10\" kv=\"2\" ctrlrange=\"-1 1\"/>";
    let general = "<general gainprm=\"100\" biasprm=\"3 -100 -10\" biastype=\"affine\"/>";
    let cases = [
        ("", "<position joint=\"pin\" kp=\"10\" kv=\"2\"/>", [10.0, -10.0, -2.0]),
        (position, "<position joint=\"pin\"/>", [10.0, -10.0, -2.0]),
        (position, "<general joint=\"pin\"/>", [10.0, -10.0, -2.0]),
        (position, "<motor joint=\"pin\"/>", [1.0, 0.0, 0.0]),
        (position, "<velocity joint=\"pin\"/>", [1.0, 0.0, -1.0]),
        ("<velocity kv=\"3\"/>", "<position joint=\"pin\" kv=\"1\"/>", [1.0, -1.0, -1.0]),
        (general, "<position joint=\"pin\"/>", [100.0, -100.0, -10.0]),
        (general, "<velocity joint=\"pin\"/>", [100.0, 0.0, -100.0]),
        (general, "<motor joint=\"pin\"/>", [1.0, 0.0, 0.0]),
        (general, "<general joint=\"pin\"/>", [100.0, -100.0, -10.0]),
        ("<position kp=\"10\" kv=\"2\"/>", "<position joint=\"pin\" kp=\"5\"/>", [5.0, -5.0, -2.0]),
        ("<position kp=\"10\"/><general gear=\"1\"/>", "<velocity joint=\"pin\"/>", [10.0, 0.0, -10.0]),
        ("<velocity kv=\"3\"/>", "<position joint=\"pin\" kp=\"5\"/>", [5.0, -5.0, 0.0]),
        ("", "<general joint=\"pin\" biasprm=\"1 2 3\"/>", [1.0, 0.0, 0.0]),
    ];
    for (class, own, [gain, of_value, of_rate]) in cases {
        let text = pendulum("", "", &format!("<default>{class}</default>{}", actuator(own)));
        let read = polhode_scene::robot::read_text("p.xml".as_ref(), &text, &[]).unwrap();
        let found = &read.robot.actuators[0];
        assert_eq!((found.gain[0], found.bias[1], found.bias[2]), (gain, of_value, of_rate), "{class} {own}");
        let has_range = class.contains("ctrlrange");
        assert_eq!(found.control_range, has_range.then_some([-1.0, 1.0]), "{class} {own}");
    }
}

/// A damper's control is its constant; `dampratio` is that of critical damping with the inertia about the pin.
#[test]
fn dampers_and_damping_ratios() {
    let text = pendulum("", "", &actuator("<damper name=\"d\" joint=\"pin\" kv=\"3\" ctrlrange=\"0 2\"/>"));
    let folder = Folder::new().with("p.xml", &text);
    let scene = folder.scene("p.xml", "controls.d = 2").unwrap().scene;
    assert_eq!(motor(&scene, 0).unwrap().drive(), Drive::Velocity { velocity: 0.0, gain: 6.0 });
    let text = pendulum("", "", &actuator("<position joint=\"pin\" kp=\"2\" dampratio=\"0.5\" gear=\"5\"/>"));
    let folder = Folder::new().with("p.xml", &text);
    let scene = folder.scene("p.xml", "").unwrap().scene;
    let Drive::Position { stiffness, damping, .. } = motor(&scene, 0).unwrap().drive() else { panic!() };
    assert!((stiffness - 50.0).abs() < 1e-12 && (damping - (50.0 * INERTIA).sqrt()).abs() < 1e-12, "{damping}");
}

/// Several actuators of one joint add up: a servo of position and one of velocity regulate together.
#[test]
fn actuators_add_up() {
    let text = pendulum(
        "",
        "",
        &actuator(
            "<position name=\"p\" joint=\"pin\" kp=\"20\" forcerange=\"-5 5\"/><velocity name=\"v\" joint=\"pin\" \
             kv=\"4\" forcerange=\"-2 3\"/><motor name=\"m\" joint=\"pin\" forcerange=\"-1 6\"/>",
        ),
    );
    let folder = Folder::new().with("p.xml", &text);
    let loaded = folder.scene("p.xml", "controls = { p = 0.5, v = 1, m = 9 }").unwrap();
    let own = motor(&loaded.scene, 0).unwrap();
    // 20 (0.5 - q) + 4 (1 - q') + 6, the motor within its range.
    assert_eq!(own.drive(), Drive::Position { position: 1.0, stiffness: 20.0, damping: 4.0 });
    told_of(&loaded, "warning: actuator `v`: its effort is bounded by -2 and 3: here by 2 to both sides");
    told_of(&loaded, "warning: joint `pin`: 3 actuators drive it, each with its own bound");
}

/// A keyframe puts coordinates, rates and controls where it says; what the scene names comes before it.
#[test]
fn keyframes() {
    let text = std::fs::read_to_string(shipped("servo-arm.xml")).unwrap();
    let folder = Folder::new().with("a.xml", &text);
    let scene = folder.scene("a.xml", "keyframe = 'raised'").unwrap().scene;
    // The servos aim at where it starts; the engine counts from there.
    let drives: Vec<_> = (0..3).map(|number| motor(&scene, number).unwrap().drive()).collect();
    assert!(matches!(drives[0], Drive::Position { position: 0.0, stiffness: 200.0, damping: 12.0 }), "{drives:?}");
    assert_eq!(drives[2], Drive::Effort(0.1));
    let elbow = scene.bodies()[1].initial_pose().translation;
    assert!((elbow - DVec3::new(0.4 * 0.8_f64.cos(), 0.0, 1.0 + 0.4 * 0.8_f64.sin())).length() < 1e-12, "{elbow}");
    let scene = folder.scene("a.xml", "keyframe = 'raised'\nconfiguration.shoulder = 0.0").unwrap().scene;
    assert!((scene.bodies()[1].initial_pose().translation - DVec3::new(0.4, 0.0, 1.0)).length() < 1e-12);
    let scene = folder.scene("a.xml", "keyframe = 'swinging'").unwrap().scene;
    let rates: Vec<f64> = (0..3).map(|number| after(&scene, number, 0.0).1).collect();
    for (found, expected) in rates.iter().zip([1.0, -2.0, 0.5]) {
        assert!((found - expected).abs() < 1e-12, "{rates:?}");
    }
}

/// A free body and a ball joint in a keyframe: positions, quaternions of any length, angular velocities along the axes
/// of the body.
#[test]
fn keyframes_of_free_and_ball_joints() {
    let inertial = "<inertial pos=\"0.1 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>";
    let text = format!(
        "<mujoco><worldbody><body name=\"a\"><freejoint name=\"float\"/>{inertial}<body name=\"b\" pos=\"0 0 1\">\
         <joint type=\"ball\" name=\"neck\"/>{inertial}</body></body></worldbody>\n<keyframe><key name=\"k\" \
         qpos=\"1 2 3 2 0 \
         0 2 0 1 0 0\" qvel=\"0 0 5 1 0 0 0 0 3\"/></keyframe></mujoco>"
    );
    let folder = Folder::new().with("r.xml", &text);
    let scene = folder.scene("r.xml", "keyframe = 'k'").unwrap().scene;
    let (a, b) = (&scene.bodies()[0], &scene.bodies()[1]);
    assert!((a.initial_pose().translation - DVec3::new(1.0, 2.0, 3.0)).length() < 1e-15);
    // A quarter of a turn about z: x of the body is y of the world.
    assert!((a.initial_pose().rotation.rotate(DVec3::X) - DVec3::Y).length() < 1e-15);
    assert!((a.initial_velocity().angular - DVec3::Y).length() < 1e-15);
    // Its centre of mass is on the axis of its rotation.
    assert!((a.initial_velocity().linear - DVec3::Z * 5.0).length() < 1e-15);
    // The second body is turned by half a turn about x in the first one: its z is -z.
    assert!((b.initial_pose().translation - DVec3::new(1.0, 2.0, 4.0)).length() < 1e-15);
    assert!((b.initial_pose().rotation.rotate(DVec3::Z) + DVec3::Z).length() < 1e-15);
    assert!((b.initial_velocity().angular - (DVec3::Y - DVec3::Z * 3.0)).length() < 1e-15);
    Simulation::new(&scene).unwrap();
}

/// What cannot be read of actuators and keyframes refuses the file at its line.
#[test]
fn refused_at_their_line() {
    let refused = |rest: &str, parts: &[&str]| {
        let folder = Folder::new().with("p.xml", &pendulum("", "", rest));
        let error = folder.scene("p.xml", "").map(|_| rest.to_owned()).unwrap_err();
        for part in parts.iter().chain(&["p.xml:3:"]) {
            assert!(error.contains(part), "{rest}: {error}");
        }
    };
    let unknown = actuator("<motor name=\"m\" joint=\"pim\"/>");
    refused(&unknown, &["actuator `m`: no joint is named `pim`", "known: `pin`"]);
    refused(&actuator("<motor name=\"m\"/>"), &["actuator `m`: attribute `joint` is missing"]);
    let reversed = actuator("<motor name=\"m\" joint=\"pin\" forcerange=\"5 -5\"/>");
    refused(&reversed, &["actuator `m`: its forcerange goes from 5 to -5", "the smaller one first"]);
    let reversed = actuator("<motor name=\"m\" joint=\"pin\" ctrlrange=\"1 1\"/>");
    refused(&reversed, &["its ctrlrange goes from 1 to 1"]);
    refused(&actuator("<position name=\"m\" joint=\"pin\" kp=\"stiff\"/>"), &["kp=\"stiff\" is not accepted"]);
    let twice = actuator("<motor name=\"m\" joint=\"pin\"/><motor name=\"m\" joint=\"pin\"/>");
    refused(&twice, &["a second actuator of this name"]);
    refused(&actuator("<motor name=\"m\" joint=\"pin\" class=\"none\"/>"), &["no class of <default> is named `none`"]);
    let key = "<keyframe><key name=\"k\" qpos=\"1 2 3\"/></keyframe>";
    refused(key, &["keyframe `k`: `qpos` has 3 numbers, and the robot needs 1", "one for a hinge"]);
    let key = "<keyframe><key name=\"k\" ctrl=\"1\"/></keyframe>";
    refused(key, &["keyframe `k`: `ctrl` has 1 numbers, and the robot needs 0"]);
}

/// Actuators that are not simulated are told by name and line, and the robot runs without them.
#[test]
fn told_and_left_out() {
    let cases = [
        ("<muscle name=\"m\" joint=\"pin\"/>", "<muscle> is an actuator of a kind that is not simulated"),
        ("<cylinder name=\"m\" joint=\"pin\"/>", "<cylinder> is an actuator of a kind"),
        ("<adhesion name=\"m\" body=\"rod\"/>", "<adhesion> is an actuator of a kind"),
        ("<intvelocity name=\"m\" joint=\"pin\"/>", "<intvelocity> is an actuator of a kind"),
        ("<motor name=\"m\" tendon=\"t\"/>", "it acts on a tendon, and joints alone are driven"),
        ("<general name=\"m\" joint=\"pin\" dyntype=\"integrator\"/>", "its activation is of the kind \"integrator\""),
        ("<general name=\"m\" joint=\"pin\" gaintype=\"muscle\"/>", "is of the kind \"muscle\""),
        ("<position name=\"m\" joint=\"pin\" kp=\"-3\"/>", "servos that push away from their target"),
    ];
    for (own, why) in cases {
        let folder = Folder::new().with("p.xml", &pendulum("", "", &actuator(own)));
        let loaded = folder.scene("p.xml", "").unwrap();
        told_of(&loaded, "p.xml:3:");
        told_of(&loaded, "warning: actuator `m`: ");
        told_of(&loaded, why);
        told_of(&loaded, "it is left out and exerts nothing");
        assert_eq!(motor(&loaded.scene, 0), None, "{own}");
    }
    let filtered = actuator("<position name=\"m\" joint=\"pin\" kp=\"3\" timeconst=\"0.1\"/>");
    let folder = Folder::new().with("p.xml", &pendulum("", "", &filtered));
    told_of(&folder.scene("p.xml", "").unwrap(), "its filter is not simulated: its effort follows its control at once");
}

/// `<option>`: gravity is that of a scene for which the file stands, and told beside another one; what another engine
/// steps by is told.
#[test]
fn options() {
    let option = "gravity=\"0 0 -1.62\" timestep=\"0.004\" integrator=\"RK4\"";
    let folder = Folder::new().with("p.xml", &pendulum("", option, ""));
    let loaded = load_with(&folder.path("p.xml"), &[]).unwrap();
    assert_eq!(loaded.scene.gravity(), DVec3::Z * -1.62);
    for words in ["`timestep=\"0.004\"` of <option>: steps and integrator are chosen by the method", "RK4"] {
        told_of(&loaded, words);
    }
    told_of(&loaded, "read: robot: gravity [0, 0, -1.62] m/s^2");
    let beside = folder.scene("p.xml", "").unwrap();
    assert_eq!(beside.scene.gravity(), DVec3::Z * -9.81);
    told_of(&beside, "ignored: robot: gravity [0, 0, -1.62] m/s^2 of <option>: that of the scene counts");
    let text = pendulum("", "", &actuator("<motor name=\"m\" joint=\"pin\"/>"))
        .replace("<option />", "<option><flag gravity=\"disable\" actuation=\"disable\"/></option>");
    let folder = Folder::new().with("p.xml", &text);
    let settings = [Override::new("test", "models.0.drives.pin.motor.effort", "1.5")];
    let loaded = load_with(&folder.path("p.xml"), &settings).unwrap();
    assert_eq!(loaded.scene.gravity(), DVec3::ZERO);
    told_of(&loaded, "all actuators: <flag> of <option> takes them out");
    assert_eq!(motor(&loaded.scene, 0).unwrap().drive(), Drive::Effort(1.5));
    assert!(loaded.findings().all(|own| own.severity() != Severity::Warning));
}
