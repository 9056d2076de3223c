//! Robots from URDF files are the bodies and joints that a scene would give by hand, and move as these do.
//!
//! Welded links have the sum of the mass properties of their parts about the common centre of mass (theorem of parallel
//! axes, computed here from particles); joints stand where their chain of frames puts them; a small pendulum swings
//! with the period of its inertia; a robot turned and moved as a whole moves the same.

use glam::{DMat3, DVec3};
use polhode::scene::{Coordinate, JointKind};
use polhode::spatial::{Pose, Rotation};
use polhode::{Scene, Simulation};
use polhode_scene::robot::Severity;
use polhode_scene::{LoadedScene, load_text, load_with};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A folder for robot files and meshes.
pub(crate) struct Folder(tempfile::TempDir);

impl Folder {
    pub(crate) fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// With a file.
    pub(crate) fn with(self, name: &str, text: &str) -> Self {
        let path = self.0.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
        self
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A scene of one model with these further keys.
    pub(crate) fn scene(&self, file: &str, keys: &str) -> Result<LoadedScene, String> {
        let text = format!("format = 1\n[[models]]\nfile = {file:?}\n{keys}\n");
        let origin = self.path("scene.toml");
        load_text(&origin.to_string_lossy(), &text, &[]).map_err(|error| error.to_string())
    }
}

pub(crate) fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/robots").join(name)
}

fn body<'a>(scene: &'a Scene, name: &str) -> &'a polhode::Body {
    scene.bodies().iter().find(|body| body.name() == name).unwrap_or_else(|| panic!("no body {name}"))
}

/// A link with mass properties and no shape.
pub(crate) fn link(name: &str, mass: f64, center: [f64; 3], moments: [f64; 3]) -> String {
    let ([x, y, z], [xx, yy, zz]) = (center, moments);
    format!(
        "<link name=\"{name}\"><inertial><origin xyz=\"{x:?} {y:?} {z:?}\"/><mass value=\"{mass:?}\"/><inertia \
         ixx=\"{xx:?}\" ixy=\"0\" ixz=\"0\" iyy=\"{yy:?}\" iyz=\"0\" izz=\"{zz:?}\"/></inertial></link>"
    )
}

/// A joint at an origin, with what else stands in it.
pub(crate) fn joint(name: &str, kind: &str, [parent, child]: [&str; 2], inside: &str) -> String {
    format!(
        "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>{inside}</joint>"
    )
}

pub(crate) fn urdf(parts: &[String]) -> String {
    format!("<robot name=\"test\">\n{}\n</robot>", parts.join("\n"))
}

const UNIT: [f64; 3] = [1.0, 1.0, 1.0];

/// The hand of the shipped arm is part of its forearm: mass, centre of mass and inertia are those of the two together.
#[test]
fn welded_links_are_one_body() {
    let scene = load_with(&shipped("arm.urdf"), &[]).unwrap().scene;
    let names: Vec<_> = scene.bodies().iter().map(polhode::Body::name).collect();
    assert_eq!(names, ["post", "upper", "forearm"]);
    let properties = body(&scene, "forearm").mass_properties().unwrap();
    // 1 kg at 0.15 m and 0.5 kg at 0.35 m: the centre at 0.65/3 m, the reduced mass 1/3 kg at 0.2 m from each other.
    assert!((properties.mass() - 1.5).abs() < 1e-15);
    assert!((properties.center_of_mass() - DVec3::X * (0.65 / 3.0)).length() < 1e-15);
    let across = 0.008 + 0.0005 + 0.2 * 0.2 / 3.0;
    // The hand is turned by 0.3 rad, which its equal moments do not show.
    let expected = DMat3::from_diagonal(DVec3::new(0.0008 + 0.0005, across, across));
    let difference = properties.inertia().matrix() - expected;
    assert!(difference.to_cols_array().iter().all(|x| x.abs() < 1e-16), "{difference}");
    assert!(body(&scene, "post").is_fixed());
}

/// A chain of three frames, each turned, puts the joint where the product of the frames does, and a rotated inertia is
/// turned.
#[test]
fn frames_multiply() {
    let turned = "<link name=\"c\"><inertial><origin xyz=\"0.1 0.2 0.3\" rpy=\"0 0 1.5707963267948966\"/><mass \
        value=\"2\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"2\" iyz=\"0\" izz=\"2.5\"/></inertial></link>";
    let text = urdf(&[
        link("a", 1.0, [0.0; 3], UNIT),
        link("b", 1.0, [0.0; 3], UNIT),
        turned.to_owned(),
        joint(
            "ab",
            "continuous",
            ["a", "b"],
            "<origin xyz=\"1 0 0\" rpy=\"0 0 1.5707963267948966\"/><axis xyz=\"0 0 2\"/>",
        ),
        joint(
            "bc",
            "continuous",
            ["b", "c"],
            "<origin xyz=\"1 0 0\" rpy=\"1.5707963267948966 0 0\"/><axis xyz=\"0 0 1\"/>",
        ),
    ]);
    let folder = Folder::new().with("r.urdf", &text);
    let scene = folder.scene("r.urdf", "position = [0, 0, 5]\nbase = \"free\"").unwrap().scene;
    // b is at (1, 0, 5), its x along the y of the world; c is one further along it; its z along -y of b, which is x of
    // the world.
    let joint = scene.joints()[1];
    assert!((joint.anchor() - DVec3::new(1.0, 1.0, 5.0)).length() < 1e-15, "{}", joint.anchor());
    let JointKind::Hinge { axis } = joint.kind() else { panic!("{:?}", joint.kind()) };
    assert!((axis.get() - DVec3::X).length() < 1e-15, "{}", axis.get());
    let properties = body(&scene, "c").mass_properties().unwrap();
    let moments = properties.inertia().matrix();
    // A quarter of a turn about z exchanges the moments about x and y.
    assert!((moments.x_axis.x - 2.0).abs() < 1e-15 && (moments.y_axis.y - 1.0).abs() < 1e-15);
    assert_eq!(properties.center_of_mass(), DVec3::new(0.1, 0.2, 0.3));
}

/// A rod on a hinge swings with the period of a physical pendulum, `2 pi sqrt(I / (m g l))`, for small angles.
#[test]
fn a_pendulum_swings() {
    let (mass, arm, inertia) = (2.0, 0.4, 0.1);
    let text = urdf(&[
        "<link name=\"world\"/>".to_owned(),
        link("rod", mass, [0.0, 0.0, -arm], [inertia, inertia, 0.01]),
        joint("pin", "continuous", ["world", "rod"], "<axis xyz=\"0 1 0\"/>"),
    ]);
    let folder = Folder::new().with("r.urdf", &text);
    let scene = folder.scene("r.urdf", "configuration = { pin = 1e-4 }").unwrap().scene;
    let mut simulation = Simulation::new(&scene).unwrap();
    let about_pin = inertia + mass * arm * arm;
    let period = 2.0 * std::f64::consts::PI * (about_pin / (mass * 9.81 * arm)).sqrt();
    simulation.advance_to(period).unwrap();
    let rod = simulation.body_id("rod").unwrap();
    let angle = simulation.body(rod).pose.rotation.to_rotation_vector().y;
    // The period grows by a^2/16 of itself, which is of second order in the angle again.
    assert!((angle - 1e-4).abs() < 1e-10, "{angle:e}");
}

/// A robot that stands elsewhere and is turned about the vertical moves the same, seen from itself.
#[test]
fn a_robot_moves_the_same_elsewhere() {
    let at = |keys: &str, pose: Pose| {
        let file = shipped("arm.urdf").display().to_string();
        let text = format!("format = 1\nduration = 0.5\n[[models]]\nfile = {file:?}\n{keys}");
        let scene = load_text("scene.toml", &text, &[]).unwrap().scene;
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.4).unwrap();
        let hand = simulation.body_id("forearm").unwrap();
        pose.inverse().transform_point(simulation.body(hand).pose.translation)
    };
    let here = at("", Pose::IDENTITY);
    let rotation = Rotation::from_rotation_vector(DVec3::Z * 1.2);
    let place = Pose::new(rotation, DVec3::new(3.0, -2.0, 1.0));
    let there = at("position = [3, -2, 1]\nrotation_vector = [0, 0, 1.2]", place);
    assert!((here - there).length() < 1e-12, "{here} {there}");
}

/// Limits count from where the joint starts; what spans a revolution, or starts elsewhere, is told.
#[test]
fn limits_move_with_the_start() {
    let text = urdf(&[
        "<link name=\"world\"/>".to_owned(),
        link("a", 1.0, [0.1, 0.0, 0.0], UNIT),
        link("b", 1.0, [0.1, 0.0, 0.0], UNIT),
        link("c", 1.0, [0.1, 0.0, 0.0], UNIT),
        joint("given", "revolute", ["world", "a"], "<limit lower=\"-1\" upper=\"2\"/>"),
        joint(
            "moved",
            "prismatic",
            ["a", "b"],
            "<limit lower=\"0.5\" upper=\"0.75\"/><dynamics damping=\"3\" friction=\"2\"/>",
        ),
        joint("wide", "revolute", ["b", "c"], "<limit lower=\"-6.3\" upper=\"6.3\"/>"),
    ]);
    let folder = Folder::new().with("r.urdf", &text);
    let loaded = folder.scene("r.urdf", "configuration = { given = 0.5 }").unwrap();
    let limits = |number: usize, coordinate| {
        let freedom = loaded.scene.joints()[number].freedom(coordinate).unwrap();
        freedom.limits().map(|limits| (limits.lower(), limits.upper()))
    };
    assert_eq!(limits(0, Coordinate::Angle), Some((-1.5, 1.5)));
    assert_eq!(limits(1, Coordinate::Displacement), Some((0.0, 0.25)));
    assert_eq!(limits(2, Coordinate::Angle), None);
    let told: Vec<String> = loaded.findings().map(ToString::to_string).collect();
    assert!(
        told.iter()
            .any(|told| told.contains("joint `moved`: zero is outside its limits from 0.5 to 0.75: it starts at 0.5")),
        "{told:?}"
    );
    assert!(told.iter().any(|told| told.contains("joint `wide`: its limits span 12.6 rad")), "{told:?}");
    let freedom = loaded.scene.joints()[1].freedom(Coordinate::Displacement).unwrap();
    assert_eq!((freedom.damping(), freedom.friction().map(|friction| friction.effort())), (3.0, Some(2.0)));
}

/// What is not simulated is listed with the place where it stands first and how often.
#[test]
fn what_is_ignored_is_listed() {
    let follows = "<mimic joint=\"lead\" multiplier=\"2\"/><dynamics friction=\"0.5\"/><calibration/>";
    let text = urdf(&[
        link("a", 1.0, [0.0; 3], UNIT),
        link("b", 1.0, [0.0; 3], UNIT),
        link("c", 1.0, [0.0; 3], UNIT),
        joint("lead", "continuous", ["a", "b"], "<dynamics friction=\"0.5\"/>"),
        joint("follow", "continuous", ["b", "c"], follows),
        "<gazebo/><transmission name=\"t\"/>".to_owned(),
    ]);
    let folder = Folder::new().with("robot.urdf", &text);
    let loaded = folder.scene("robot.urdf", "").unwrap();
    let mut told = String::new();
    for finding in loaded.findings() {
        assert_eq!(finding.severity(), Severity::Ignored);
        let _ = writeln!(told, "{finding}");
    }
    for expected in ["<gazebo> of <robot>", "<transmission> of <robot>", "<calibration> of joints"] {
        assert!(told.contains(expected), "{told}");
    }
    assert!(told.contains("robot.urdf:6:"), "{told}");
}

/// A joint that follows another one by nothing is held where its offset says: by the joint it follows or, in MJCF, by
/// none. Its link is one body with the one that it hangs at.
#[test]
fn a_joint_that_follows_by_nothing_is_held() {
    let text = urdf(&[
        link("a", 1.0, [0.0; 3], UNIT),
        link("b", 1.0, [0.0; 3], UNIT),
        link("c", 1.0, [1.0, 0.0, 0.0], UNIT),
        joint("lead", "continuous", ["a", "b"], "<axis xyz=\"0 0 1\"/>"),
        joint(
            "follow",
            "continuous",
            ["b", "c"],
            "<axis xyz=\"0 0 1\"/><mimic joint=\"lead\" multiplier=\"0\" offset=\"1.5707963267948966\"/>",
        ),
    ]);
    let folder = Folder::new().with("robot.urdf", &text);
    let loaded = folder.scene("robot.urdf", "name = \"r\"\nbase = \"fixed\"\n").unwrap();
    assert!(loaded.scene.gears().is_empty() && loaded.scene.joints().len() == 1);
    // A quarter of a turn puts the centre of c at (0, 1, 0), and that of both at half of it.
    let center = body(&loaded.scene, "r/b").mass_properties().unwrap().center_of_mass();
    assert!((center - DVec3::new(0.0, 0.5, 0.0)).length() < 1e-12, "{center}");
    let beyond = text.replace("\"follow\" type=\"continuous\"", "\"follow\" type=\"revolute\"");
    let beyond = beyond.replace("<mimic", "<limit lower=\"-1\" upper=\"1\"/><mimic");
    let refused = Folder::new().with("robot.urdf", &beyond).scene("robot.urdf", "").unwrap_err();
    assert!(refused.contains("outside its limits from -1 to 1"), "{refused}");
    let unknown = text.replace("mimic joint=\"lead\"", "mimic joint=\"nobody\"");
    let refused = Folder::new().with("robot.urdf", &unknown).scene("robot.urdf", "").unwrap_err();
    assert!(refused.contains("nobody"), "{refused}");
    let arm = |equality: &str| {
        format!(
            "<mujoco><compiler angle=\"radian\"/><worldbody><body name=\"b\"><joint name=\"lead\" axis=\"0 0 \
             1\"/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/><body name=\"c\"><joint name=\"own\" \
             axis=\"0 0 1\"/><inertial pos=\"1 0 0\" mass=\"1\" diaginertia=\"1 1 \
             1\"/></body></body></worldbody><equality><joint {equality}/></equality></mujoco>"
        )
    };
    for equality in [
        "joint1=\"own\" joint2=\"lead\" polycoef=\"1.5707963267948966 0 0 0 0\"",
        "joint1=\"own\" polycoef=\"1.5707963267948966\"",
    ] {
        let folder = Folder::new().with("robot.xml", &arm(equality));
        let scene = folder.scene("robot.xml", "").unwrap().scene;
        let center = body(&scene, "b").mass_properties().unwrap().center_of_mass();
        assert!((center - DVec3::new(0.0, 0.5, 0.0)).length() < 1e-12, "{equality}: {center}");
    }
}

/// A joint that follows another one is a gear of the scene: it starts where the other one says, and moves with it.
/// Joints of robots have names in the scene.
#[test]
fn a_joint_that_follows_another_is_a_gear() {
    let text = urdf(&[
        link("a", 1.0, [0.0; 3], UNIT),
        link("b", 1.0, [0.0; 3], UNIT),
        link("c", 1.0, [0.0; 3], UNIT),
        link("d", 1.0, [0.0; 3], UNIT),
        joint("lead", "continuous", ["a", "b"], "<axis xyz=\"0 0 1\"/>"),
        joint(
            "follow",
            "continuous",
            ["a", "c"],
            "<axis xyz=\"0 0 1\"/><mimic joint=\"lead\" multiplier=\"-2\" offset=\"0.5\"/>",
        ),
        joint("slide", "prismatic", ["a", "d"], "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\"/>"),
    ]);
    let folder = Folder::new().with("robot.urdf", &text);
    let more = "name = \"r\"\nbase = \"fixed\"\nconfiguration.lead = 0.25\n[[gears]]\n\
        joints = [\"r/slide\", \"r/lead\"]\nratio = 0.1\n";
    let loaded = folder.scene("robot.urdf", more).unwrap();
    let gears: Vec<_> =
        loaded.scene.gears().iter().map(|gear| (gear.joints().map(polhode::JointId::index), gear.ratio())).collect();
    assert_eq!(gears, [([2, 0], 0.1), ([1, 0], -2.0)]);
    // -2 of 0.25 rad and 0.5 rad are zero: the follower stands as in the file.
    let follower = loaded.scene.bodies().iter().find(|body| body.name() == "r/c").unwrap();
    assert!(follower.initial_pose().rotation.angle_to(Rotation::IDENTITY) < 1e-12);
    let unknown = text.replace("mimic joint=\"lead\"", "mimic joint=\"nobody\"");
    let error = Folder::new().with("robot.urdf", &unknown).scene("robot.urdf", "").unwrap_err();
    assert!(error.contains("nobody"), "{error}");
    let contradicts = "configuration.lead = 0.25\nconfiguration.follow = 0.3\n";
    let error = folder.scene("robot.urdf", contradicts).unwrap_err();
    assert!(error.contains("it follows `lead`"), "{error}");
}

/// A part without mass between two hinges whose axes cross is a universal joint; at the end of a branch it is left out.
#[test]
fn parts_without_mass() {
    let text = urdf(&[
        "<link name=\"world\"/><link name=\"cross\"/><link name=\"tip\"/>".to_owned(),
        link("a", 1.0, [0.0; 3], UNIT),
        joint("first", "continuous", ["world", "cross"], "<axis xyz=\"1 0 0\"/>"),
        joint("second", "revolute", ["cross", "a"], "<axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\"/>"),
        joint("end", "continuous", ["a", "tip"], ""),
    ]);
    let folder = Folder::new().with("r.urdf", &text);
    let loaded = folder.scene("r.urdf", "").unwrap();
    assert_eq!(loaded.scene.bodies().len(), 1);
    let JointKind::Universal { axes: [own, other] } = loaded.scene.joints()[0].kind() else { panic!() };
    assert_eq!((own.get(), other.get()), (DVec3::Y, DVec3::X));
    let told: Vec<String> = loaded.findings().map(ToString::to_string).collect();
    assert!(told.iter().any(|told| told.contains("joint `second`: it is part of a universal joint")), "{told:?}");
    assert!(told.iter().any(|told| told.contains("link `tip`: it has no mass and carries none")), "{told:?}");
}

/// Several robots of one file stand in one scene, with names of their own, joined by the scene; their links do not
/// collide.
#[test]
fn several_robots_in_a_scene() {
    let text = r#"
format = 1
duration = 0.1
[[models]]
name = "left"
file = "../../fixtures/robots/arm.urdf"
position = [0, 1, 0]
[[models]]
name = "right"
file = "../../fixtures/robots/arm.urdf"
configuration = { shoulder = -0.5, elbow = 1 }
[[bodies]]
name = "lamp"
shape.sphere.radius = 0.05
mass = 0.3
position = [0.3, 1, 0.4]
[[joints]]
type.rope = { bodies = ["lamp", "left/upper"], anchors = [[0.3, 1, 0.4], [0.3, 1, 0.5]] }
"#;
    let scene = load_text("scene.toml", text, &[]).unwrap_or_else(|error| panic!("{error}")).scene;
    let names: Vec<_> = scene.bodies().iter().map(polhode::Body::name).collect();
    let expected = ["lamp", "left/post", "left/upper", "left/forearm", "right/post", "right/upper", "right/forearm"];
    assert_eq!(names, expected);
    assert_eq!(scene.joints().len(), 5);
    Simulation::new(&scene).unwrap().advance_to(0.1).unwrap();
    let twice = text.replace("name = \"right\"", "name = \"left\"");
    let error = load_text("scene.toml", &twice, &[]).unwrap_err().to_string();
    assert!(error.contains("two bodies are named `left/post`") && error.contains("models.1"), "{error}");
}

/// A robot file stands for a scene: what the world holds has no floor, what falls has one below its lowest point.
#[test]
fn a_robot_file_is_a_scene() {
    let held = load_with(&shipped("arm.urdf"), &[]).unwrap();
    assert_eq!((held.scene.name(), held.scene.duration_s()), ("arm", 2.0));
    assert!(held.scene.bodies().iter().all(|body| body.name() != "floor"));
    let text = urdf(&["<link name=\"ball\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" \
        iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial><collision><origin xyz=\"0 0 2\"/><geometry><sphere \
        radius=\"0.5\"/></geometry></collision></link>"
        .to_owned()]);
    let folder = Folder::new().with("ball.urdf", &text);
    let free = load_with(&folder.path("ball.urdf"), &[]).unwrap();
    let floor = body(&free.scene, "floor").initial_pose().translation.z;
    assert!((floor - 1.5).abs() < 1e-12, "{floor}");
    let mut simulation = Simulation::new(&free.scene).unwrap();
    simulation.advance_to(0.5).unwrap();
    let ball = simulation.body_id("ball").unwrap();
    assert!(simulation.body(ball).pose.translation.z > -1e-6);
}

/// The links of a robot collide with each other only where that is asked for, and never across a joint.
#[test]
fn links_collide_when_asked() {
    let ball = |name: &str| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" \
             iyz=\"0\" izz=\"0.1\"/></inertial><collision><geometry><sphere \
             radius=\"0.3\"/></geometry></collision></link>"
        )
    };
    let text = urdf(&[
        ball("a"),
        ball("b"),
        ball("c"),
        joint("ab", "continuous", ["a", "b"], "<origin xyz=\"0.5 0 0\"/>"),
        joint("bc", "continuous", ["b", "c"], "<origin xyz=\"-0.1 0 0\"/>"),
    ]);
    let folder = Folder::new().with("r.urdf", &text);
    let off = folder.scene("r.urdf", "").unwrap();
    Simulation::new(&off.scene).unwrap();
    let told: Vec<String> = off.examine_robots().iter().map(ToString::to_string).collect();
    // a and c stand 0.4 m apart, and their radii add up to 0.6 m.
    assert!(told.iter().any(|told| told.contains("link `c`: it overlaps `a` by 0.2 m")), "{told:?}");
    let on = folder.scene("r.urdf", "self_collision = true").unwrap();
    let error = Simulation::new(&on.scene).unwrap_err().to_string();
    assert!(error.contains("a and c overlap"), "{error}");
}

/// A robot whose files are given by name, without their folders, is the robot of the files on disk: a page has only
/// what was dropped on it.
#[test]
fn a_robot_of_given_files_is_that_of_the_files_on_disk() {
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    let part = "<mujoco><asset><mesh name=\"solid\" file=\"solid.obj\"/></asset></mujoco>";
    let robot = "<mujoco model=\"m\"><compiler meshdir=\"meshes\"/><include file=\"parts/part.xml\"/><worldbody>\
        <body pos=\"0 0 2\"><freejoint/><geom type=\"mesh\" mesh=\"solid\"/></body></worldbody></mujoco>";
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("robot.xml", robot), ("parts/part.xml", part), ("meshes/solid.obj", cube)] {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let files: &'static [(&'static str, &'static [u8])] =
        vec![("robot.xml", robot.as_bytes()), ("part.xml", part.as_bytes()), ("solid.obj", cube.as_bytes())].leak();
    let of_disk = load_with(&folder.path().join("robot.xml"), &[]).unwrap();
    let text = polhode_scene::scene_text_of("robot.xml", files).unwrap();
    assert_eq!(text, of_disk.text());
    let given = polhode_scene::load_with_files("page", &text, files, &[]).unwrap();
    assert_eq!(format!("{:?}", given.scene.bodies()), format!("{:?}", of_disk.scene.bodies()));
    assert_eq!(given.examine_robots().len(), of_disk.examine_robots().len());
    let error = polhode_scene::scene_text_of("robot.xml", &files[..2]).unwrap_err().to_string();
    assert!(error.contains("solid.obj"), "{error}");
    // Of two files that the name could mean none is taken.
    let two: &'static [(&'static str, &'static [u8])] =
        vec![files[0], files[1], ("a/meshes/solid.obj", files[2].1), ("b/meshes/solid.obj", files[2].1)].leak();
    assert!(polhode_scene::scene_text_of("robot.xml", two).is_err());
}
