//! `polhode drop`: a die is fair, statics of a bracket is that of its section, a body that can rest on one face alone
//! always does; what cannot be thrown is said; and nothing depends on the number of workers.

use super::{Place, fixture};
use serde_json::Value;

fn faces(json: &Value) -> &Vec<Value> {
    json["faces"].as_array().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// The face whose normal is this.
fn face_at(json: &Value, normal: [f64; 3]) -> &Value {
    let is_at = |face: &&Value| (0..3).all(|axis| (number(&face["normal"][axis]) - normal[axis]).abs() < 1e-9);
    faces(json).iter().find(is_at).unwrap()
}

/// Six faces, each with a sixth of the throws; a cube tips at 45 degrees.
#[test]
fn a_die_is_fair() {
    let json = Place::new().expect(0, &["drop", "box:0.016,0.016,0.016", "-n", "180", "--json"]).json();
    assert_eq!((faces(&json).len(), json["failed"].as_u64(), json["moving"].as_u64()), (6, Some(0), Some(0)));
    let chi: f64 = faces(&json).iter().map(|face| (number(&face["throws"]) - 30.0).powi(2) / 30.0).sum();
    // Chi-squared of five degrees of freedom: exceeded once in a thousand times.
    assert!(chi < 20.5, "{json}");
    assert!(faces(&json).iter().all(|face| (number(&face["tilt_rad"]) - std::f64::consts::FRAC_PI_4).abs() < 1e-12));
}

/// Opposite faces of a box have equal shares, within their errors; its broad faces the largest.
#[test]
fn opposite_faces_of_a_box_are_alike() {
    let json = Place::new().expect(0, &["drop", "box:0.03,0.02,0.01", "-n", "1000", "--seed", "4", "--json"]).json();
    let mut shares = Vec::new();
    for axis in 0..3 {
        let [low, high] = [-1.0, 1.0].map(|sign| {
            let mut normal = [0.0; 3];
            normal[axis] = sign;
            let face = face_at(&json, normal);
            (number(&face["share"]), number(&face["standard_error"]))
        });
        assert!((low.0 - high.0).abs() <= 4.0 * low.1.hypot(high.1), "{json}");
        shares.push(low.0 + high.0);
    }
    assert!(shares[2] > shares[1] && shares[1] > shares[0], "{shares:?}");
}

/// The L of the fixtures: its tilts follow from the centre of mass of the section.
#[test]
fn a_bracket_from_a_file() {
    let place = Place::new();
    let mesh = fixture("meshes/l-shape.obj");
    let args = ["drop", &mesh, "-n", "40", "-o", "throws.csv", "--pictures", "poses", "--json"];
    let json = place.expect(0, &args).json();
    let told: u64 = faces(&json).iter().map(|face| face["throws"].as_u64().unwrap()).sum();
    let others = ["leaning", "moving", "failed"].map(|what| json[what].as_u64().unwrap());
    assert_eq!(told + others.iter().sum::<u64>(), 40);
    assert_eq!(others[2], 0, "{json}");
    let table = place.read("throws.csv");
    assert_eq!(table.lines().count(), 41);
    assert!(table.lines().skip(1).all(|line| line.contains(",rests,") || line.contains(",leans,")), "{table}");
    let drawn = std::fs::read_dir(place.path("poses")).unwrap().count();
    assert_eq!(drawn, faces(&json).iter().filter(|face| face["throws"] != 0).count());
    // In the file's own frame the height of the centre of mass above a face is its distance.
    let center: Vec<f64> = (0..3).map(|axis| number(&json["center_of_mass_m"][axis])).collect();
    let below = face_at(&json, [0.0, 0.0, -1.0]);
    assert!((number(&below["height_m"]) - center[2]).abs() < 1e-12 || center[2] == 0.0, "{json}");
}

/// What a throw is, depends on its number and the seed alone: more throws begin with those of fewer.
#[test]
fn throws_are_the_same_for_any_number_of_workers() {
    let place = Place::new();
    let of = |workers: &str| {
        let args =
            ["drop", "box:0.03,0.02,0.01", "-n", "12", "--seed", "7", "--json", "--workers", workers, "-o", "t.csv"];
        (place.expect(0, &args).json(), place.read("t.csv"))
    };
    assert_eq!(of("1"), of("3"));
    let more = place.expect(0, &["drop", "box:0.03,0.02,0.01", "-n", "16", "--seed", "7", "-o", "more.csv"]);
    assert!(more.stdout.starts_with("drop of box: 16 throws on a plane"), "{}", more.stdout);
    assert!(place.read("more.csv").starts_with(&of("2").1));
}

/// A tetrahedron, loaded so that it can rest on one face alone, always comes to rest there (Almadi, Dawson and Domokos
/// 2025: such tetrahedra exist).
#[test]
fn a_monostable_tetrahedron_always_lands_on_one_face() {
    let place = Place::with_scene(MONOSTABLE);
    let json = place.expect(0, &["drop", "scene.toml", "-n", "60", "--json"]).json();
    assert_eq!((faces(&json).len(), faces(&json)[0]["throws"].as_u64()), (1, Some(60)), "{json}");
    assert_eq!(json["faces_of_the_hull"].as_u64(), Some(4));
}

/// Four points, with the mass of lead and straw: its centre of mass, the origin, lies beyond an edge of three faces.
const MONOSTABLE: &str = r#"
format = 1
name = "monostable"
duration = 1.0
[materials.m]
friction = 0.4
restitution = 0.2
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "m"
[[bodies]]
name = "tetrahedron"
shape.points.positions = [
    [-0.00065, -0.023137, -0.001714], [-0.003403, 0.016079, 0.001442], [0.00065, -0.042614, 0.012813],
    [0.001277, 0.006812, 0.000405],
]
mass = 1
inertia = [
    [2.199e-4, -2.944e-7, 1.758e-7], [-2.944e-7, 6.28e-6, -1.562e-5], [1.758e-7, -1.562e-5, 2.214e-4],
]
position = [0, 0, 0.1]
material = "m"
"#;

/// On a slope a box rests on the face that lies on the slope, where friction holds it.
#[test]
fn a_body_falls_on_a_scene() {
    let place = Place::with_scene(
        r#"
format = 1
duration = 1.0
[materials.rough]
friction = 0.9
restitution = 0.1
[[bodies]]
name = "slope"
fixed = true
shape.half_space.normal = [0.1, 0, 0.995]
material = "rough"
[[bodies]]
name = "crate"
shape.box.size = [0.4, 0.3, 0.2]
mass = 2
position = [0, 0, 1]
material = "rough"
"#,
    );
    for args in [
        &["drop", "box:0.04,0.03,0.01", "--on", "scene.toml", "--at", "0.5,0,0.3", "-n", "10", "--friction", "0.9"][..],
        &["drop", "scene.toml", "-n", "10"],
        &["drop", "scene.toml", "--body", "crate", "-n", "10"],
    ] {
        let json = place.expect(0, &[args, &["--json"]].concat()).json();
        assert_eq!(json["failed"].as_u64(), Some(0), "{json}");
        let on: u64 = faces(&json).iter().map(|face| face["throws"].as_u64().unwrap()).sum();
        assert!(on >= 9, "{json}");
    }
}

/// With Young's modulus and a radius impacts have a duration: a harder material stops a body in less time.
#[test]
fn stiffer_parts_are_struck_harder() {
    let place = Place::new();
    let of = |young: &str| {
        let args = ["drop", "box:0.02,0.02,0.02", "-n", "6", "--young", young, "--corner-radius", "0.0005", "--json"];
        let json = place.expect(0, &args).json();
        (number(&json["peak_deceleration_m_s2"]["mean"]), number(&json["peak_deceleration"]["contact_time_s"]))
    };
    let [(soft, long), (hard, short)] = ["1e9", "32e9"].map(of);
    // Force grows with the power 2/5 of the modulus, and time falls with it: 32^(2/5) = 4.
    assert!((hard / soft - 4.0).abs() < 1e-9 && (long / short - 4.0).abs() < 1e-6, "{soft} {hard} {long} {short}");
    let plain = place.expect(0, &["drop", "box:0.02,0.02,0.02", "-n", "2"]).stdout;
    assert!(plain.contains("no deceleration"), "{plain}");
}

#[test]
fn what_cannot_be_thrown_is_said() {
    let place = Place::with_scene(super::FLIGHT);
    place.write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
    for (code, args, told) in [
        (2, &["sphere:0.1"][..], "it rolls"),
        (2, &["cylinder:0.1,0.2"], "round"),
        (2, &["box:1,1,1", "-n", "0"], "1 to 10000000"),
        (2, &["box:1,1,1", "-n", "1000000000"], "1 to 10000000"),
        (2, &["box:1,1,0"], "positive"),
        (2, &["box:1,1,1", "--height", "-1"], "positive"),
        (2, &["box:1,1,1", "--density", "-1"], "density"),
        (2, &["box:1,1,1", "--corner-radius", "0.1"], "youngs_modulus_pa"),
        (2, &["box:1,1,1", "--scale", "2"], "metres"),
        (2, &["box:1,1,1", "--body", "a"], "--body"),
        (2, &["box:1,1,1", "--set", "gravity=[0,0,0]"], "nothing falls"),
        (2, &["scene.toml", "--density", "2"], "--density"),
        (2, &["scene.toml", "--body", "nut"], "stone"),
        (2, &["scene.toml"], "no shape"),
        (2, &["open.obj"], "--repair"),
        (3, &["missing.obj"], "missing.obj"),
        (3, &["missing.toml"], "missing.toml"),
    ] {
        let run = place.expect(code, &[&["drop"][..], args].concat());
        assert!(run.stderr.contains(told), "{args:?}: {}", run.stderr);
    }
}
