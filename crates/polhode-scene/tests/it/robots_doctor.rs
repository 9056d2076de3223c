//! Each finding of the doctor, on a file that has it: with its place, its size and its cure.
//!
//! What no body can have is refused; what can be simulated and is likely a mistake of a unit, a frame or a mesh is
//! warned of; a sound robot has no findings.

use crate::robots::{Folder, joint, link, shipped, urdf};
use glam::DVec3;
use polhode_scene::load_with;
use polhode_scene::robot::Severity;
use std::fmt::Write as _;

/// A tetrahedron with corners at the origin and at 0.1 m along each axis, as OFF; some of its faces.
fn tetrahedron(faces: &[[u32; 3]]) -> String {
    let mut text = format!("OFF\n4 {} 0\n0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n", faces.len());
    for [a, b, c] in faces {
        let _ = writeln!(text, "3 {a} {b} {c}");
    }
    text
}

const OUTWARD: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
const INWARD: [[u32; 3]; 4] = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];

/// A link of a tetrahedron with the mass of water: 1000/6 (0.1)^3 kg, and moments near those of its shape.
fn with_mesh(mass: f64, center: [f64; 3], moments: [f64; 3], mesh: &str) -> String {
    let collision = format!("<collision><geometry><mesh filename=\"{mesh}\"/></geometry></collision></link>");
    urdf(&[link("part", mass, center, moments).replace("</link>", &collision)])
}

const MASS: f64 = 1.0 / 6.0;
const CENTER: [f64; 3] = [0.025, 0.025, 0.025];
const MOMENTS: [f64; 3] = [1.2e-4, 1.2e-4, 1.2e-4];

/// All that is told of a robot that is loaded: while it is read, and by the doctor.
fn told(folder: &Folder, keys: &str) -> Vec<(Severity, String)> {
    let loaded = folder.scene("r.urdf", keys).unwrap_or_else(|error| panic!("{error}"));
    let examined = loaded.examine_robots();
    loaded.findings().chain(&examined).map(|told| (told.severity(), told.to_string())).collect()
}

#[track_caller]
fn warned(folder: &Folder, expected: &str, cure: &str) {
    let told = told(folder, "");
    let found = told.iter().find(|(severity, told)| *severity == Severity::Warning && told.contains(expected));
    let (_, found) = found.unwrap_or_else(|| panic!("{told:?}"));
    assert!(found.contains("r.urdf:") && found.contains("\n  cure: ") && found.contains(cure), "{found}");
}

fn folder(text: &str, faces: &[[u32; 3]]) -> Folder {
    Folder::new().with("r.urdf", text).with("part.off", &tetrahedron(faces))
}

#[test]
fn a_sound_robot_has_no_findings() {
    assert_eq!(told(&folder(&with_mesh(MASS, CENTER, MOMENTS, "part.off"), &OUTWARD), ""), []);
    let arm = load_with(&shipped("arm.urdf"), &[]).unwrap();
    assert!(arm.examine_robots().is_empty());
    assert!(arm.findings().all(|told| told.severity() == Severity::Ignored));
}

#[test]
fn mass_against_volume() {
    // Grams for kilograms.
    let text = with_mesh(1e3 * MASS, CENTER, MOMENTS.map(|moment| 1e3 * moment), "part.off");
    warned(
        &folder(&text, &OUTWARD),
        "kg in a shape of 0.000166667 m^3 are 1000000 kg/m^3",
        "check the unit of the mass",
    );
}

#[test]
fn center_of_mass_against_shape() {
    // Centimetres for metres.
    let text = with_mesh(MASS, CENTER.map(|x| 100.0 * x), MOMENTS, "part.off");
    warned(&folder(&text, &OUTWARD), "its centre of mass is 4.15692 m", "check the origin of <inertial>");
}

#[test]
fn inertia_against_shape() {
    // kg mm^2 for kg m^2.
    let text = with_mesh(MASS, CENTER, MOMENTS.map(|moment| 1e6 * moment), "part.off");
    warned(&folder(&text, &OUTWARD), "times those of its shape evenly filled", "check the unit (kg m^2)");
}

#[test]
fn open_inverted_and_mirrored_meshes() {
    let text = with_mesh(MASS, CENTER, MOMENTS, "part.off");
    warned(&folder(&text, &OUTWARD[..3]), "bounds no solid: 3 open edges", "--repair");
    warned(&folder(&text, &INWARD), "faces inward: its volume is -0.000166667 m^3", "--repair");
    let mirrored = text.replace("part.off\"", "part.off\" scale=\"-1 1 1\"").replace("xyz=\"0.025", "xyz=\"-0.025");
    warned(&folder(&mirrored, &OUTWARD), "is mirrored by its scale [-1, 1, 1]", "faces outward");
    // Mirrored and turned, it is as sound as before.
    assert_eq!(told(&folder(&mirrored, &OUTWARD), "").len(), 1);
}

#[test]
fn flat_meshes_and_formats_that_are_not_read() {
    let flat = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    let text = with_mesh(MASS, CENTER, MOMENTS, "part.off");
    warned(
        &Folder::new().with("r.urdf", &text).with("part.off", flat),
        "the hull of mesh part.off has no volume",
        "thickness",
    );
    let dae = with_mesh(MASS, CENTER, MOMENTS, "part.dae");
    warned(
        &Folder::new().with("r.urdf", &dae).with("part.dae", ""),
        "is in a format that is not read",
        "OBJ, STL, OFF or PLY",
    );
}

#[test]
fn limits_that_leave_nothing() {
    let arm = |limit: &str| {
        let parts = [
            "<link name=\"world\"/>".to_owned(),
            link("a", 1.0, [0.0; 3], [1.0; 3]),
            joint("pin", "revolute", ["world", "a"], limit),
        ];
        Folder::new().with("r.urdf", &urdf(&parts))
    };
    warned(&arm("<limit lower=\"0\" upper=\"0\"/>"), "its limits leave it one value, 0", "`fixed`");
    warned(&arm("<limit lower=\"-1\" upper=\"1\" effort=\"0\"/>"), "its effort is at most 0", "largest effort");
    let error = arm("<limit lower=\"1\" upper=\"-1\"/>").scene("r.urdf", "").unwrap_err();
    assert!(error.contains("the lower one is 1, the upper one -1") && error.contains("r.urdf:4:"), "{error}");
    let error = arm("<limit lower=\"-1\" upper=\"1\"/>").scene("r.urdf", "configuration = { pin = 2 }").unwrap_err();
    assert!(error.contains("it is at 2, outside its limits from -1 to 1"), "{error}");
    let error = arm("<limit lower=\"-1\" upper=\"1\"/>").scene("r.urdf", "configuration = { pen = 2 }").unwrap_err();
    assert!(error.contains("no joint is named `pen`"), "{error}");
    let error = arm("<limit lower=\"-1\" upper=\"1\"/><axis xyz=\"0 0 0\"/>").scene("r.urdf", "").unwrap_err();
    assert!(error.contains("its axis [0, 0, 0] has no length"), "{error}");
}

/// Inertias that no body can have are refused, or replaced by the nearest that one can have: that whose second moments
/// of mass are those of the matrix without their negative part.
#[test]
fn inertias_that_no_body_can_have() {
    let part = |moments: [f64; 3]| Folder::new().with("r.urdf", &urdf(&[link("part", 1.0, [0.0; 3], moments)]));
    for (moments, message) in [
        ([1.0, 1.0, 3.0], "break the triangle inequality"),
        ([1.0, -1.0, 1.0], "must be positive"),
        ([-1.0, -1.0, -1.0], "must be positive"),
    ] {
        let error = part(moments).scene("r.urdf", "").unwrap_err();
        assert!(error.contains("link `part`: no body can have this inertia") && error.contains(message), "{error}");
        assert!(error.contains("r.urdf:2:") && error.contains("unphysical=repair"), "{error}");
    }
    let folder = part([1.0, 1.0, 3.0]);
    let told = told(&folder, "unphysical = \"repair\"\nbase = \"free\"");
    assert!(told[0].1.contains("principal moments [1, 1, 3]: they are replaced by [1.5, 1.5, 3] kg m^2"), "{told:?}");
    let scene = folder.scene("r.urdf", "unphysical = \"repair\"\nbase = \"free\"").unwrap().scene;
    let made = scene.bodies()[0].mass_properties().unwrap().principal_axes().moments();
    assert!((made - DVec3::new(1.5, 1.5, 3.0)).length() < 1e-14, "{made}");
    let massless = Folder::new().with("r.urdf", &urdf(&[link("part", 0.0, [0.0; 3], [1.0; 3])]));
    let error = massless.scene("r.urdf", "").unwrap_err();
    assert!(error.contains("it has inertia and a mass of 0"), "{error}");
}
