//! `polhode play`: one page with the scene, its meshes and the hash of its run in it; what it refuses.

use super::{Place, fixture};
use std::fs;

/// The JSON that a page begins with.
fn given(page: &str) -> serde_json::Value {
    let (_, rest) = page.split_once("<script id=\"polhode-play\" type=\"application/json\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// The page holds the text as it stands, and the hash that the golden trajectory of the scene has.
#[test]
fn a_page_with_a_scene_and_its_hash() {
    let place = Place::new();
    let scene = fixture("scenes/box-drop.toml");
    assert_eq!(place.expect(0, &["play", &scene, "-o", "play.html"]).stdout, "play.html\n");
    let page = place.read("play.html");
    let begins = given(&page);
    assert_eq!(begins["text"].as_str().unwrap(), fs::read_to_string(&scene).unwrap());
    let golden = fs::read_to_string(fixture("golden/box-drop.snap")).unwrap();
    let hash = begins["native"]["hash"].as_str().unwrap();
    assert!(golden.contains(&format!("strict-hash {hash}\n")) && begins["native"]["ended"] == true, "{hash}");
    assert_eq!(place.expect(0, &["play", &scene, "--hash"]).stdout, format!("{hash}\n"));
    assert_eq!(begins["native"]["marks"][1][0], 2);
}

/// The meshes of a scene are in the page by the names that the scene gives them.
#[test]
fn a_page_with_meshes() {
    let place = Place::new();
    place.expect(0, &["new", "ramp", "--from", "box-down-ramp"]);
    place.expect(0, &["play", "ramp.toml", "-o", "play.html"]);
    let begins = given(&place.read("play.html"));
    let meshes: Vec<&String> = begins["files"].as_object().unwrap().keys().collect();
    assert!(!meshes.is_empty());
    let text = begins["text"].as_str().unwrap();
    assert!(meshes.iter().all(|name| text.contains(&format!("\"{name}\""))), "{meshes:?}");
}

/// A robot file stands for a scene, in a page as elsewhere; the page holds its meshes, wherever they are, and names no
/// folder of this machine.
#[test]
fn a_page_with_a_robot() {
    let place = Place::new();
    let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::create_dir_all(place.path("parts/meshes")).unwrap();
    fs::create_dir_all(place.path("parts/urdf")).unwrap();
    place.write("parts/meshes/link.obj", cube);
    let robot = "<robot name=\"one\"><link name=\"base\"><inertial><mass value=\"1\"/>\
        <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial><collision><geometry>\
        <mesh filename=\"package://parts/meshes/link.obj\"/></geometry></collision></link></robot>";
    place.write("parts/urdf/one.urdf", robot);
    place.expect(0, &["play", "parts/urdf/one.urdf", "-o", "play.html"]);
    let begins = given(&place.read("play.html"));
    let files: Vec<&String> = begins["files"].as_object().unwrap().keys().collect();
    assert_eq!(files, ["meshes/link.obj", "one.urdf"]);
    assert!(begins["text"].as_str().unwrap().contains("file = \"one.urdf\""));
    assert!(begins["native"]["hash"].is_string());
}

/// Without a scene the page has none, and shipped scenes to choose from; text that ends elements ends none of the page.
#[test]
fn a_page_without_a_scene_and_one_with_a_trap() {
    let place = Place::new();
    place.expect(0, &["play", "-o", "play.html"]);
    let page = place.read("play.html");
    let begins = given(&page);
    assert!(begins["text"].is_null() && begins["native"].is_null());
    // Packed; the check in the browser counts them and chooses one.
    let (_, examples) = page.split_once("<script id=\"polhode-examples\" type=\"text/plain\">").unwrap();
    assert!(!examples.starts_with("</script>"));
    let trap = format!("{}\n# </script><script>stop()</script>\n", super::FLIGHT);
    place.write("trap.toml", &trap);
    place.expect(0, &["play", "trap.toml", "-o", "trap.html"]);
    assert_eq!(given(&place.read("trap.html"))["text"].as_str().unwrap(), trap);
}

/// What is refused says why, and writes nothing.
#[test]
fn what_is_refused() {
    let place = Place::with_scene("format = 1\nduration = -1\n");
    for (args, words) in [
        (&["play"][..], "--output"),
        (&["play", "scene.toml", "-o", "play.html"], "duration"),
        (&["play", "example:box-drop", "-o", "play.png"], "accepted: .html"),
        (&["play", "example:no-such", "-o", "play.html"], "no example is named"),
        (&["play", "-o", "play.html", "--hash"], "SCENE"),
    ] {
        let run = place.expect(2, args);
        assert!(run.stderr.contains(words), "{args:?}: {}", run.stderr);
    }
    assert_eq!(place.list(), ["scene.toml"]);
}
