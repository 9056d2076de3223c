//! `polhode stands`: its answer against a closed form, the exit code that scripts ask, limits, and tables of boxes.

use super::Place;

const COLUMNS: &str = "name,size_x,size_y,size_z,x,y,z,mass\n";

/// Two boxes, the upper one shifted by `shift` of its length of 0.4 m.
fn two(shift: f64) -> String {
    format!("{COLUMNS}low,0.4,0.3,0.2,0,0,0.1,5\nhigh,0.4,0.3,0.2,{},0,0.3,5\n", 0.4 * shift)
}

/// A box falls over an edge when its centre of mass is beyond it: at half its length.
#[test]
fn a_box_over_an_edge() {
    let place = Place::new();
    for (shift, stands) in [(0.0, true), (0.45, true), (0.499, true), (0.501, false), (0.55, false)] {
        place.write("two.csv", &two(shift));
        let run = place.expect(i32::from(!stands), &["stands", "two.csv"]);
        let first = run.stdout.lines().next().unwrap();
        assert_eq!(first, if stands { "two stands" } else { "two does not stand: high moves first" }, "{shift}");
        let json = place.expect(i32::from(!stands), &["stands", "two.csv", "--json"]).json();
        assert_eq!(json["stands"].as_bool(), Some(stands));
        assert_eq!(json["moves"].as_array().unwrap().len(), usize::from(!stands));
    }
}

/// The forces of contacts hold what stands: those of the floor carry all the weight.
#[test]
fn contacts_carry_the_weight() {
    let place = Place::new();
    place.write("two.csv", &two(0.2));
    let json = place.expect(0, &["stands", "two.csv", "--json"]).json();
    let of_floor =
        json["contacts"].as_array().unwrap().iter().filter(|own| own["body_a"] == "floor" || own["body_b"] == "floor");
    let carried: f64 = of_floor.map(|own| own["normal_force_n"].as_f64().unwrap()).sum();
    assert!((carried - 10.0 * 9.81).abs() < 1e-6, "{carried}");
    let text = place.expect(0, &["stands", "two.csv", "--contacts"]).stdout;
    assert!(text.contains("contacts: what each carries") && text.contains("low, high"), "{text}");
}

/// What touches nothing falls, and is named.
#[test]
fn what_falls_does_not_stand() {
    let place = Place::new();
    place.write("two.csv", &format!("{}air,1,1,1,5,5,5,2\n", two(0.1)));
    let run = place.expect(1, &["stands", "two.csv"]);
    assert!(run.stdout.starts_with("two does not stand: air moves first\n"), "{}", run.stdout);
}

/// A table of boxes is a scene for other commands too; a bad one names its line.
#[test]
fn a_table_of_boxes_is_a_scene() {
    let place = Place::new();
    place.write("two.csv", &two(0.2));
    assert!(place.expect(0, &["run", "two.csv", "--duration", "0.1"]).stdout.starts_with("scene two\n"));
    place.expect(1, &["stands", "two.csv", "--set", "materials.boxes.friction=0", "--set", "gravity=[5, 0, -9.81]"]);
    place.write("bad.csv", &format!("{COLUMNS}low,0.4,0.3,0.2,0,0,x,5\n"));
    let run = place.expect(2, &["stands", "bad.csv"]);
    assert!(run.stderr.contains("bad.csv:2: `z` is `x`") && run.stderr.contains("size_x"), "{}", run.stderr);
}

/// A semicircular arch of 20 plane stones with radial joints that do not slip stands from a thickness of 0.107347744
/// of its mean radius on (the lower bound theorem as a linear programme, computed apart). One that is a little thicker
/// falls by the least push about four hinges, of which the picture has a ring each; a thinner one begins to move now.
#[test]
fn the_least_thickness_of_an_arch() {
    let place = Place::new();
    let arch = "format = 1\n[materials.stone]\nfriction = 10\n[[bodies]]\nname = \"ground\"\nfixed = true\n\
        shape.half_space.normal = [0, 0, 1]\nmaterial = \"stone\"\n[[arrays]]\nname = \"stone\"\ndensity = 2000\n\
        material = \"stone\"\nlayout.arch = { count = 20, radius = 1, thickness = 0.1, width = 0.3 }\n";
    place.write("arch.toml", arch);
    let key = "--bisect=arrays.stone.layout.arch.thickness=0.05..0.2";
    let found = place.expect(0, &["stands", "arch.toml", key, "--digits", "5", "--json"]).json();
    let limit = found["limit"].as_f64().unwrap();
    assert!((limit - 0.107_347_744).abs() < 1e-6, "{found}");
    assert!(found["stands_at"].as_f64().unwrap() > found["falls_at"].as_f64().unwrap());
    let run = place.expect(1, &["stands", "arch.toml", "--picture", "arch.svg", "--json"]).json();
    // It falls by itself about as few joints of its 21: one at the crown, two at the haunches, two at the feet.
    assert!(run["mechanism"]["begins"] == "now", "{}", run["mechanism"]);
    assert!((4..=6).contains(&run["mechanism"]["hinges"].as_array().unwrap().len()), "{}", run["mechanism"]);
    let thicker = ["stands", "arch.toml", "--set", "arrays.stone.layout.arch.thickness=0.115"];
    let run = place.expect(0, &[&thicker[..], &["--picture", "arch.svg", "--json"]].concat()).json();
    assert_eq!(run["mechanism"]["hinges"].as_array().unwrap().len(), 4, "{}", run["mechanism"]);
    let picture = place.read("arch.svg");
    assert!(picture.starts_with("<svg") && picture.contains("hinge"), "{picture}");
}

/// What has no limit between the ends, or is no interval, is refused with what is accepted.
#[test]
fn intervals_without_a_limit_are_refused() {
    let place = Place::new();
    place.write("two.csv", &two(0.1));
    for (interval, told) in [
        ("materials.boxes.friction=0.2..0.8", "it stands at 0.2 and at 0.8"),
        ("bodies.high.position.0=0.3..0.4", "it does not stand at 0.3 and at 0.4"),
        ("bodies.high.position.0=0.4..0.3", "KEY=LOW..HIGH is needed"),
        ("bodies.high.position.0=0.3", "KEY=LOW..HIGH is needed"),
        ("bodies.higher.mass=1..2", "higher"),
    ] {
        let run = place.expect(2, &["stands", "two.csv", "--bisect", interval]);
        assert!(run.stderr.contains(told), "{interval}: {}", run.stderr);
    }
    place.expect(2, &["stands", "two.csv", "--digits", "3"]);
    place.expect(2, &["stands", "two.csv", "--bisect", "bodies.high.position.0=0..1", "--digits", "0"]);
    let run = place.expect(2, &["stands", "two.csv", "--picture", "two.png"]);
    assert!(run.stderr.contains("accepted: .svg"), "{}", run.stderr);
}

/// `view` shows a table of boxes as the scene that it is.
#[test]
fn a_table_of_boxes_is_no_trajectory() {
    let place = Place::new();
    place.write("two.csv", &two(0.1));
    place.expect(0, &["view", "two.csv", "--set", "duration=0.1", "-o", "two.html"]);
}

/// The page of a run that begins with bodies at rest shows what the least push would move.
#[test]
fn pages_show_what_would_move_first() {
    let place = Place::new();
    place.write("two.csv", &two(0.1));
    place.expect(0, &["run", "two.csv", "--duration", "0.1", "-o", "two.html"]);
    let page = place.read("two.html");
    let figure = page.split("<template id=\"polhode-mechanism\">").nth(1).unwrap();
    assert!(figure.starts_with("<p>what begins at a push of") && figure.contains("<svg"), "{}", &figure[..200]);
}
