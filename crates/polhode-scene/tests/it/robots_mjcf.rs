//! Robots from MJCF files: the same robot as URDF and as MJCF is the same scene; classes, angles, frames, several
//! joints of one body and masks of collision mean what the reference of the format says.

use crate::robots::{Folder, joint, link, shipped, urdf};
use glam::DVec3;
use polhode::scene::{Coordinate, JointKind, SceneError};
use polhode::{Body, Simulation};
use polhode_scene::load_with;

fn mujoco(inside: &str) -> String {
    format!("<mujoco model=\"test\">\n{inside}\n</mujoco>")
}

/// A body with a mass of 1 kg, and what else stands in it.
fn body(name: &str, inside: &str) -> String {
    format!("<body name=\"{name}\"><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>{inside}</body>")
}

/// One robot in both formats moves to the same bits.
#[test]
fn formats_agree() {
    let of_urdf = urdf(&[
        "<link name=\"world\"/>".to_owned(),
        link("upper", 2.0, [0.2, 0.0, 0.0], [0.002, 0.028, 0.028]),
        link("fore", 1.0, [0.15, 0.0, 0.0], [0.0008, 0.008, 0.008]),
        joint(
            "shoulder",
            "revolute",
            ["world", "upper"],
            "<origin xyz=\"0 0 0.5\"/><axis xyz=\"0 1 0\"/><limit lower=\"-2\" upper=\"1.5\"/><dynamics \
             damping=\"0.2\"/>",
        ),
        joint("elbow", "continuous", ["upper", "fore"], "<origin xyz=\"0.4 0 0\"/><axis xyz=\"0 1 0\"/>"),
    ]);
    let of_mjcf = mujoco(
        "<compiler angle=\"radian\"/><worldbody>
         <body name=\"upper\" pos=\"0 0 0.5\">
           <inertial pos=\"0.2 0 0\" mass=\"2\" diaginertia=\"0.002 0.028 0.028\"/>
           <joint name=\"shoulder\" axis=\"0 1 0\" range=\"-2 1.5\" damping=\"0.2\"/>
           <body name=\"fore\" pos=\"0.4 0 0\">
             <inertial pos=\"0.15 0 0\" mass=\"1\" diaginertia=\"0.0008 0.008 0.008\"/>
             <joint name=\"elbow\" axis=\"0 1 0\"/>
           </body></body></worldbody>",
    );
    let folder = Folder::new().with("r.urdf", &of_urdf).with("r.xml", &of_mjcf);
    let ends = ["r.urdf", "r.xml"].map(|file| {
        let scene = folder.scene(file, "").unwrap().scene;
        let mut simulation = Simulation::new(&scene).unwrap();
        simulation.advance_to(0.7).unwrap();
        let id = simulation.body_id("fore").unwrap();
        simulation.body(id).pose
    });
    assert_eq!(ends[0], ends[1]);
}

/// Capsules from end to end have the masses of their volumes, classes reach the elements below them, degrees become
/// radians.
#[test]
fn the_shipped_leg() {
    let loaded = load_with(&shipped("leg.xml"), &[]).unwrap();
    let names: Vec<_> = loaded.scene.bodies().iter().map(Body::name).collect();
    assert_eq!(names, ["ground", "hip", "thigh", "shank"]);
    let thigh = loaded.scene.bodies()[2].mass_properties().unwrap();
    let pi = std::f64::consts::PI;
    let volume = pi * 0.03_f64.powi(2) * 0.3 + 4.0 / 3.0 * pi * 0.03_f64.powi(3);
    assert!((thigh.mass() / (800.0 * volume) - 1.0).abs() < 1e-14);
    assert!((thigh.center_of_mass() - DVec3::new(0.0, 0.0, -0.15)).length() < 1e-15);
    let knee = loaded.scene.joints()[1].freedom(Coordinate::Angle).unwrap();
    let limits = knee.limits().unwrap();
    assert!((limits.lower() + 2.0 * pi / 3.0).abs() < 1e-15 && (limits.upper() - pi / 36.0).abs() < 1e-15);
    assert_eq!((knee.damping(), knee.stiffness()), (0.5, 40.0));
    let mut simulation = Simulation::new(&loaded.scene).unwrap();
    let report = simulation.run().unwrap();
    assert!(report.ledger.closure_relative().abs() < 1e-12);
}

/// Several joints of one body are the joint of their freedoms; limits that it has no coordinate for are told.
#[test]
fn joints_of_one_body() {
    let cases = [
        ("<joint axis=\"1 0 0\"/><joint axis=\"0 1 0\" range=\"-5 5\"/>", "universal"),
        ("<joint axis=\"1 0 0\"/><joint axis=\"0 1 0\"/><joint axis=\"0 0 1\" pos=\"0 0 2\"/>", "ball"),
        (
            "<joint type=\"slide\" axis=\"1 0 0\"/><joint type=\"slide\" axis=\"0 0 1\"/><joint axis=\"0 1 0\"/>",
            "planar",
        ),
        ("<joint axis=\"0 0 1\"/><joint type=\"slide\" axis=\"0 0 1\"/>", "cylindrical"),
        ("<joint type=\"ball\"/>", "ball"),
    ];
    for (joints, kind) in cases {
        let folder = Folder::new().with("r.xml", &mujoco(&format!("<worldbody>{}</worldbody>", body("a", joints))));
        let loaded = folder.scene("r.xml", "").unwrap();
        let joint = loaded.scene.joints()[0];
        assert_eq!((joint.kind().name(), loaded.scene.bodies().len()), (kind, 1), "{joints}");
        if let JointKind::Universal { axes: [own, _] } = joint.kind() {
            assert_eq!(own.get(), DVec3::Y);
            assert!(loaded.findings().any(|told| told.to_string().contains("universal joint")));
        }
    }
    let sliders = "<joint type=\"slide\" axis=\"1 0 0\"/><joint type=\"slide\" axis=\"0 1 0\"/><joint type=\"slide\" \
        axis=\"0 0 1\"/><joint type=\"ball\"/>";
    let folder = Folder::new().with("r.xml", &mujoco(&format!("<worldbody>{}</worldbody>", body("a", sliders))));
    assert!(folder.scene("r.xml", "").unwrap().scene.joints().is_empty());
    for refused in [
        "<joint axis=\"1 0 0\"/><joint axis=\"1 1 0\"/>",
        "<joint axis=\"1 0 0\"/><joint axis=\"0 1 0\" pos=\"0 0 1\"/>",
    ] {
        let folder = Folder::new().with("r.xml", &mujoco(&format!("<worldbody>{}</worldbody>", body("a", refused))));
        let error = folder.scene("r.xml", "").unwrap_err();
        assert!(error.contains("its 2 joints are no joint of this engine together"), "{error}");
    }
}

/// Euler angles turn about axes that turn along (small letters) or stand still (capitals); other ways give the same
/// orientation.
#[test]
fn orientations() {
    let ways = [
        ("euler=\"0 0 90\"", "xyz"),
        ("euler=\"90 0 0\"", "zxy"),
        ("euler=\"0 0 90\"", "XYZ"),
        ("axisangle=\"0 0 2 90\"", "xyz"),
        ("quat=\"1 0 0 1\"", "xyz"),
        ("xyaxes=\"0 1 0 -1 0.5 0\"", "xyz"),
    ];
    for (way, sequence) in ways {
        let text = mujoco(&format!(
            "<compiler eulerseq=\"{sequence}\"/><worldbody><body name=\"a\" {way}><freejoint/><inertial pos=\"0 0 0\" \
             mass=\"1\" diaginertia=\"1 1 1\"/></body></worldbody>"
        ));
        let folder = Folder::new().with("r.xml", &text);
        let scene = folder.scene("r.xml", "").unwrap().scene;
        let x = scene.bodies()[0].initial_pose().rotation.rotate(DVec3::X);
        assert!((x - DVec3::Y).length() < 1e-15, "{way} {sequence}: {x}");
    }
}

/// A loop that closes is a joint that bears the name of its file, in columns and in what is refused; one that does not
/// says by how much.
#[test]
fn loops() {
    let arms = |anchor: &str| {
        let arm = |name: &str, x: &str| {
            format!(
                "<body name=\"{name}\" pos=\"{x} 0 0\"><inertial pos=\"0 0 -0.5\" mass=\"1\" diaginertia=\"1 1 \
                 1\"/><joint axis=\"0 1 0\"/><site name=\"at_{name}\" pos=\"{anchor}\"/></body>"
            )
        };
        mujoco(&format!(
            "<worldbody>{}{}</worldbody><equality><connect name=\"ring\" site1=\"at_left\" \
             site2=\"at_right\"/></equality>",
            arm("left", "0"),
            arm("right", "1")
        ))
    };
    let open = Folder::new().with("r.xml", &arms("0.25 0 -1"));
    let error = open.scene("r.xml", "").unwrap_err();
    assert!(error.contains("loop `ring`: its loop does not close: at the start its ends are 1 m apart"), "{error}");
    let closed = arms("0.5 0 -1").replace("name=\"at_right\" pos=\"0.5 0 -1\"", "name=\"at_right\" pos=\"-0.5 0 -1\"");
    let folder = Folder::new().with("r.xml", &closed);
    let loaded = folder.scene("r.xml", "").unwrap();
    assert_eq!(loaded.scene.joints().len(), 3);
    assert_eq!(loaded.scene.joints()[2].anchor(), DVec3::new(0.5, 0.0, -1.0));
    assert_eq!(loaded.joint_names()[2], "ring");
    let refused = loaded.explain(SceneError::JointMoves { number: 2, apart_m_s: 1.0 }).to_string();
    assert!(refused.contains("joints.ring"), "{refused}");
}

/// Geometries collide by their masks: what meets nothing is only seen, and pairs that do not meet do not collide.
#[test]
fn masks() {
    let ball = |name: &str, x: &str, mask: &str| {
        format!("<body name=\"{name}\" pos=\"{x} 0 0.4\"><freejoint/><geom size=\"0.5\" {mask}/></body>")
    };
    let floor = "<geom type=\"plane\" size=\"1 1 1\"/>";
    let text = |mask: &str| mujoco(&format!("<worldbody>{floor}{}</worldbody>", ball("a", "0", mask)));
    let sunk = Folder::new().with("r.xml", &text(""));
    let error = Simulation::new(&sunk.scene("r.xml", "").unwrap().scene).unwrap_err().to_string();
    assert!(error.contains("ground and a overlap"), "{error}");
    let unmet = Folder::new().with("r.xml", &text("contype=\"0\" conaffinity=\"0\""));
    let scene = unmet.scene("r.xml", "").unwrap().scene;
    assert!(scene.bodies()[1].shape().is_none());
    Simulation::new(&scene).unwrap();
}

/// A class that the file does not have is refused.
#[test]
fn unknown_classes() {
    let text = mujoco("<worldbody><geom class=\"limb\" size=\"1\"/></worldbody>");
    let error = Folder::new().with("r.xml", &text).scene("r.xml", "").unwrap_err();
    assert!(error.contains("<geom>: no class of <default> is named `limb`"), "{error}");
}

/// Files that are included stand in the place of `<include>`, and files that include each other end.
#[test]
fn includes() {
    let inner = mujoco(&body("a", "<freejoint/>"));
    let folder = Folder::new()
        .with("r.xml", &mujoco("<worldbody><include file=\"sub/a.xml\"/></worldbody>"))
        .with("sub/a.xml", &inner)
        .with("circle.xml", &mujoco("<include file=\"circle.xml\"/>"))
        .with("missing.xml", &mujoco("<include file=\"none.xml\"/>"));
    assert_eq!(folder.scene("r.xml", "").unwrap().scene.bodies()[0].name(), "a");
    let error = folder.scene("circle.xml", "").unwrap_err();
    assert!(error.contains("included files are nested deeper than 16"), "{error}");
    let error = folder.scene("missing.xml", "").unwrap_err();
    assert!(error.contains("cannot read") && error.contains("missing.xml:2:1"), "{error}");
}
