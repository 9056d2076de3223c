//! Bad robot files are refused with file, line, column, what is wrong and what is accepted; several faults are told at
//! once; no input is a panic: random bytes, shipped files cut off or changed at any place, deep nesting.

use crate::robots::{Folder, joint, link, shipped, urdf};
use polhode_scene::load_with;
use polhode_scene::robot::{RobotFileError, read_text};
use proptest::prelude::*;
use std::path::Path;

fn refused(text: &str) -> String {
    match read_text(Path::new("r.urdf"), text, &[]) {
        Ok(_) => panic!("accepted: {text}"),
        Err(error) => error.to_string(),
    }
}

const UNIT: [f64; 3] = [1.0, 1.0, 1.0];

#[test]
fn trees() {
    let parts = || ["a", "b", "c"].map(|name| link(name, 1.0, [0.0; 3], UNIT)).to_vec();
    let with = |joints: &[String]| urdf(&[parts(), joints.to_vec()].concat());
    let pin = |name: &str, ends: [&str; 2]| joint(name, "continuous", ends, "");
    let circle = refused(&with(&[pin("ab", ["a", "b"]), pin("bc", ["b", "c"]), pin("ca", ["c", "a"])]));
    assert!(circle.contains("it hangs at itself, over `") && circle.contains("r.urdf:"), "{circle}");
    let own = refused(&with(&[pin("aa", ["a", "a"]), pin("bc", ["b", "c"])]));
    assert!(own.contains("link `a`: it hangs at itself, over its own joint"), "{own}");
    let twice = refused(&with(&[pin("ac", ["a", "c"]), pin("bc", ["b", "c"])]));
    assert!(twice.contains("joint `bc`, link `c`: it is the child of two joints, `ac` and this one"), "{twice}");
    let roots = refused(&with(&[pin("ab", ["a", "b"])]));
    assert!(roots.contains("link `c`: it hangs at no joint, as `a` does not either"), "{roots}");
    let unknown = refused(&with(&[pin("ab", ["a", "d"])]));
    assert!(unknown.contains("joint `ab`: no link is named `d`"), "{unknown}");
    assert!(refused("<robot name=\"r\"/>").contains("it has no links"));
    let named = refused(&urdf(&[link("a", 1.0, [0.0; 3], UNIT), link("a", 1.0, [0.0; 3], UNIT)]));
    assert!(named.contains("r.urdf:3:1: error: link `a`: a second link of this name"), "{named}");
}

#[test]
fn values() {
    for (from, to, message) in [
        ("value=\"1.0\"", "value=\"heavy\"", "value=\"heavy\" is not accepted\n  cure: accepted: a finite number"),
        ("value=\"1.0\"", "value=\"inf\"", "accepted: a finite number"),
        ("value=\"1.0\"", "", "attribute `value` is missing"),
        ("<mass", "<mess", "<mass> is missing"),
        ("xyz=\"0.0 0.0 0.0\"", "xyz=\"0 0\"", "accepted: 3 finite numbers"),
        ("ixy=\"0\"", "", "attribute `ixy` is missing"),
        ("name=\"a\"", "", "attribute `name` is missing"),
        ("<link", "<xacro:link", "is written in xacro"),
        ("</link>", "", "not XML"),
    ] {
        let text = urdf(&[link("a", 1.0, [0.0; 3], UNIT)]);
        assert!(text.contains(from), "{from}");
        let error = refused(&text.replacen(from, to, 1));
        assert!(error.contains(message) && error.contains("r.urdf:"), "{from} -> {to}: {error}");
    }
    let negative = Folder::new().with("r.urdf", &urdf(&[link("a", -1.0, [0.0; 3], UNIT)]));
    assert!(negative.scene("r.urdf", "").unwrap_err().contains("link `a`: mass -1 kg is no mass"));
    let macros = "<robot name=\"r\" xmlns:xacro=\"http://wiki.ros.org/xacro\"><xacro:include filename=\"x\"/></robot>";
    assert!(
        refused(macros).contains("xacro robot.xacro") || refused(macros).contains("`xacro FILE.xacro > FILE.urdf`")
    );
    assert!(refused("<sdf/>").contains("accepted: <robot> (URDF) or <mujoco> (MJCF)"));
    // Two faults, both told.
    let both = urdf(&[link("a", 1.0, [0.0; 3], UNIT).replace("ixy=\"0\"", "").replace("value=\"1.0\"", "value=\"x\"")]);
    assert!(refused(&both).ends_with("2 errors"), "{}", refused(&both));
}

/// What is wrong with a file is told at once, though each of it alone refuses the file: an axis without length, an
/// inertia that no body has, limits that contradict each other, a link that moves without mass, and links that make no
/// tree.
#[test]
fn all_that_is_wrong_is_told_at_once() {
    let bad_axis = "<axis xyz=\"0 0 0\"/><limit lower=\"1\" upper=\"-1\"/>";
    let bad_limits = "<limit lower=\"2\" upper=\"1\"/>";
    let parts = |moments: [f64; 3]| {
        vec![
            link("a", 1.0, [0.0; 3], UNIT),
            link("b", 1.0, [0.0; 3], moments),
            link("c", -2.0, [0.0; 3], UNIT),
            joint("ab", "revolute", ["a", "b"], bad_axis),
            joint("bc", "prismatic", ["b", "c"], bad_limits),
        ]
    };
    let told = refused(&urdf(&parts([1.0, 1.0, 9.0])));
    for expected in [
        "joint `ab`: its axis [0, 0, 0] has no length",
        "joint `ab`: its limits contradict each other: the lower one is 1, the upper one -1",
        "joint `bc`: its limits contradict each other: the lower one is 2, the upper one 1",
        "link `b`: no body can have this inertia",
        "link `c`: mass -2 kg is no mass",
        "5 errors",
    ] {
        assert!(told.contains(expected), "{expected}: {told}");
    }
    // A joint of no kind takes its links apart, which is no fault of theirs; what else is wrong is told.
    let mut others = parts([1.0, 1.0, 9.0]);
    others.push(link("d", 0.0, [0.0; 3], [0.0; 3]));
    others.push(joint("cd", "elbow", ["c", "d"], bad_limits));
    let told = refused(&urdf(&others));
    assert!(told.contains("type=\"elbow\" is not known") && told.contains("no body can have this inertia"), "{told}");
    assert!(!told.contains("hangs at no joint"), "{told}");
    // What only the assembly finds is told beside what the reading finds.
    let massless = urdf(&[
        link("a", 1.0, [0.0; 3], UNIT),
        "<link name=\"b\"/>".to_owned(),
        link("c", 1.0, [0.0; 3], UNIT),
        link("d", 1.0, [0.0; 3], [1.0, 1.0, 9.0]),
        joint("ab", "floating", ["a", "b"], ""),
        joint("bc", "continuous", ["b", "c"], ""),
        joint("cd", "revolute", ["c", "d"], bad_limits),
    ]);
    let told = refused(&massless);
    assert!(told.contains("joint `cd`: its limits") && told.contains("link `d`: no body can have"), "{told}");
    assert!(told.contains("no joint of this engine together"), "{told}");
}

/// Files in xacro are told as such, with what to do: whether the prefix is declared or not, the element is deep in the
/// file, or an attribute is an expression.
#[test]
fn xacro_is_told_as_such() {
    let whole = |inside: &str, root: &str| format!("<robot name=\"r\"{root}><link name=\"a\">{inside}</link></robot>");
    let declared = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"";
    for (inside, root, named) in [
        ("<xacro:inertia mass=\"1\"/>", declared, "<xacro:inertia>"),
        ("<xacro:inertia mass=\"1\"/>", "", "<xacro:..>"),
        ("<visual><geometry><sphere radius=\"${r}\"/></geometry></visual>", "", "radius=\"${r}\""),
        (
            "<visual><geometry><mesh filename=\"$(find p)/a.stl\"/></geometry></visual>",
            "",
            "filename=\"$(find p)/a.stl\"",
        ),
    ] {
        let told = refused(&whole(inside, root));
        assert!(told.contains(named) && told.contains("is written in xacro"), "{told}");
        assert!(told.contains("`xacro FILE.xacro > FILE.urdf`") && !told.contains("errors"), "{told}");
    }
    // The name of such a file says nothing of a scene.
    let folder = Folder::new().with("r.urdf.xacro", &whole("<xacro:inertia/>", declared));
    let told = load_with(&folder.path("r.urdf.xacro"), &[]).unwrap_err().to_string();
    assert!(told.contains("is written in xacro"), "{told}");
    // A default namespace, or a prefix of another program, is none of xacro.
    for root in [" xmlns=\"http://www.ros.org\"", " xmlns:tool=\"http://tool\""] {
        let inertial = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" \
            izz=\"1\"/></inertial>";
        assert!(read_text(Path::new("r.urdf"), &whole(inertial, root), &[]).is_ok(), "{root}");
    }
}

#[test]
fn files_that_are_not_there() {
    let error = load_with(Path::new("no-such.urdf"), &[]).unwrap_err();
    assert!(error.is_input_output() && error.to_string().contains("no-such.urdf"), "{error}");
    let seen = "<collision><geometry><mesh filename=\"package://none/part.stl\"/></geometry></collision></link>";
    let text = urdf(&[link("a", 1.0, [0.0; 3], UNIT).replace("</link>", seen)]);
    let folder = Folder::new().with("r.urdf", &text);
    let error = folder.scene("r.urdf", "").unwrap_err();
    assert!(error.contains("mesh package://none/part.stl is not found") && error.contains("`packages`"), "{error}");
    // A package is found in a folder that is named, and in one above the robot file.
    let mesh = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    let text = text.replace("part.stl", "part.off");
    let named = Folder::new().with("r.urdf", &text).with("elsewhere/none/part.off", mesh);
    named.scene("r.urdf", "packages = [\"elsewhere\"]").unwrap();
    let above = Folder::new().with("none/robots/r.urdf", &text).with("none/part.off", mesh);
    above.scene("none/robots/r.urdf", "").unwrap();
}

#[test]
fn deep_nesting_ends() {
    let deep = format!("<robot>{}{}</robot>", "<a>".repeat(100_000), "</a>".repeat(100_000));
    assert!(refused(&deep).contains("elements are nested deeper than 256"));
    let chain = |count: usize| {
        format!(
            "<mujoco><worldbody>{}{}</worldbody></mujoco>",
            "<body><joint/><geom size=\"0.1\"/>".repeat(count),
            "</body>".repeat(count)
        )
    };
    assert!(refused(&chain(300)).contains("elements are nested deeper than 256"));
    let read = read_text(Path::new("r.xml"), &chain(200), &[]).unwrap();
    assert_eq!(read.robot.links.len(), 201);
}

/// Reads a text and places what is read in a scene; whatever happens, it is no panic.
fn survives(text: &str) {
    if let Err(error) = read_text(Path::new("r.urdf"), text, &[]) {
        assert!(matches!(error, RobotFileError::Refused(ref findings) if !findings.is_empty()), "{error}");
    }
    let folder = Folder::new().with("r.urdf", text);
    let _ = folder.scene("r.urdf", "").map(|loaded| loaded.examine_robots());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn random_text_is_no_panic(text in "\\PC{0,200}") {
        survives(&text);
    }

    #[test]
    fn files_cut_off_are_no_panic(which in 0..2_usize, part in 0.0..1.0_f64) {
        let text = std::fs::read_to_string(shipped(["arm.urdf", "leg.xml"][which])).unwrap();
        survives(&text[..(part * text.len() as f64) as usize]);
    }

    #[test]
    fn changed_files_are_no_panic(which in 0..2_usize, at in 0.0..1.0_f64, word in prop::sample::select(vec![
        "0", "-1", "1e308", "nan", "\"", "<", "/>", "<link name=\"x\"/>", "<body><joint/></body>", "1 2 3", "",
        " limited=\"true\"",
        "world", "post", "fixed", "<joint type=\"ball\"/>", "<frame/>", "type=\"mesh\" mesh=\"a\"",
    ]), length in 0..12_usize) {
        let text = std::fs::read_to_string(shipped(["arm.urdf", "leg.xml"][which])).unwrap();
        let from = (at * text.len() as f64) as usize;
        let to = (from + length).min(text.len());
        survives(&format!("{}{word}{}", &text[..from], &text[to..]));
    }
}
