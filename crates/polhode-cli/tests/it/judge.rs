//! `polhode judge`: errors that are put into a trajectory are found, with their size in closed form.
//!
//! - The energy that leapfrog with a long step loses on a spring is known at every step from the numbers of the file.
//! - A body that floats by a micrometre is told with its height.
//! - A block that slides evenly down a slope which would hold it breaks Coulomb's law.
//! - What the program itself has computed keeps all laws.
//! - Other units, orders, gaps and bodies are refused or told.

use super::Place;
use std::fmt::Write as _;

const HEAD: &str = "t,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";

const SPRING: &str = r#"
format = 1
name = "oscillator"
duration = 1.0
gravity = [0, 0, 0]
[[bodies]]
name = "bob"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0.3, 0, 0]
[[forces]]
type.spring = { body = "bob", anchor = [0, 0, 0], stiffness = 8.0, rest_length = 0.0 }
"#;

const BOX: &str = r#"
format = 1
name = "resting"
duration = 0.1
[materials.wood]
friction = 0.5
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"
[[bodies]]
name = "box"
shape.box.size = [0.4, 0.4, 0.2]
mass = 3.0
position = [0, 0, 0.1]
material = "wood"
"#;

/// Rows of the floor and of the box at a height, standing.
fn standing(heights: impl Iterator<Item = f64>) -> String {
    let mut text = HEAD.to_owned();
    for (number, z) in heights.enumerate() {
        let t = 0.01 * number as f64;
        let _ = writeln!(text, "{t:?},floor,0,0,0,1,0,0,0,0,0,0,0,0,0");
        let _ = writeln!(text, "{t:?},box,0,0,{z:?},1,0,0,0,0,0,0,0,0,0");
    }
    text
}

/// `v += -h w^2 x / 2` before and after `x += h v`, with w = 2 1/s: energy `m v^2/2 + k x^2/2`.
#[test]
fn the_energy_that_leapfrog_loses_is_told_to_nine_digits() {
    let place = Place::with_scene(SPRING);
    for h in [0.02, 0.1, 0.17] {
        let (mut x, mut v, mut text) = (0.3_f64, 0.0_f64, HEAD.to_owned());
        let energy = |x: f64, v: f64| 0.5 * 2.0 * v * v + 0.5 * 8.0 * x * x;
        let (first, mut last) = (energy(x, v), 0.0);
        for step in 0..=30 {
            let _ = writeln!(text, "{:?},bob,{x:?},0,0,1,0,0,0,{v:?},0,0,0,0,0", h * f64::from(step));
            last = energy(x, v);
            v -= 0.5 * h * 4.0 * x;
            x += h * v;
            v -= 0.5 * h * 4.0 * x;
        }
        place.write("leapfrog.csv", &text);
        let json = place.expect(1, &["judge", "leapfrog.csv", "scene.toml", "--json"]).json();
        let told = json["energy"]["unexplained_j"].as_f64().unwrap();
        assert!((told - (last - first)).abs() <= 1e-9 * first, "{h}: {told} of {}", last - first);
        assert!(json["broken"].as_array().unwrap().iter().any(|law| law == "energy"), "{h}");
    }
}

#[test]
fn a_body_that_floats_by_a_micrometre_is_told_with_its_height() {
    let place = Place::with_scene(BOX);
    place.write("rests.csv", &standing((0..11).map(|_| 0.1)));
    place.expect(0, &["judge", "rests.csv", "scene.toml"]);
    for height in [1e-6, 1e-7, 2e-3] {
        place.write("floats.csv", &standing((0..11).map(|_| 0.1 + height)));
        let run = place.expect(1, &["judge", "floats.csv", "scene.toml", "--json"]).json();
        let laws = run["laws"].as_array().unwrap();
        let floating = laws.iter().find(|own| own["law"] == "floating").unwrap();
        assert!((floating["worst"].as_f64().unwrap() - height).abs() < 1e-12, "{height}: {floating}");
        assert_eq!(floating["bodies"][0], "box");
    }
}

#[test]
fn bodies_that_overlap_are_told_with_their_depth() {
    let place = Place::with_scene(BOX);
    place.write("deep.csv", &standing((0..11).map(|_| 0.1 - 1e-4)));
    let run = place.expect(1, &["judge", "deep.csv", "scene.toml", "--no-truth"]);
    assert!(run.stdout.starts_with("deep.csv breaks laws of resting: penetration first, at t = 0 s"), "{}", run.stdout);
}

/// A block of friction 0.5 stays on a slope of 0.3; one that slides down evenly bears less friction than what slides.
#[test]
fn a_slide_that_friction_would_hold_breaks_coulombs_law() {
    let place = Place::with_scene(&BOX.replace("name = \"resting\"", "name = \"resting\"\ngravity = [3, 0, -10]"));
    let mut text = HEAD.to_owned();
    for step in 0..11 {
        let (t, x) = (0.01 * f64::from(step), 0.002 * f64::from(step));
        let _ = writeln!(text, "{t:?},floor,0,0,0,1,0,0,0,0,0,0,0,0,0\n{t:?},box,{x:?},0,0.1,1,0,0,0,0.2,0,0,0,0,0");
    }
    place.write("slides.csv", &text);
    let json = place.expect(1, &["judge", "slides.csv", "scene.toml", "--no-truth", "--json"]).json();
    let broken: Vec<&str> = json["broken"].as_array().unwrap().iter().filter_map(|law| law.as_str()).collect();
    assert!(broken.contains(&"friction"), "{broken:?}");
}

#[test]
fn what_the_program_has_computed_keeps_all_laws() {
    let place = Place::new();
    place.write("scene.toml", BOX);
    for format in ["own.csv", "own.npy", "own.json"] {
        place.expect(0, &["run", "scene.toml", "-o", format]);
        let run = place.expect(0, &["judge", format, "scene.toml", "-o", &format!("{format}.svg")]);
        assert!(run.stdout.starts_with(&format!("{format} keeps the laws of resting")), "{}", run.stdout);
    }
}

/// What tier `accurate` computes breaks no law: strikes between samples, at another edge or a fold too, prescribed
/// coordinates, gears, rough bearings, joints that break, loads on what turns anyhow, friction with a grain.
#[test]
fn runs_by_the_laws_are_not_accused() {
    for scene in [
        "box-drop",
        "book-off-desk",
        "bouncing-ball",
        "box-down-ramp",
        "billiard-draw",
        "slider-crank",
        "slider-crank-driven",
        "gear-train",
        "rough-hinge",
        "trebuchet",
        "thrown-plate-in-air",
        "sledges",
    ] {
        let (place, example) = (Place::new(), format!("example:{scene}"));
        place.expect(0, &["run", &example, "--error", "off", "-o", "own.csv"]);
        let run = place.expect(0, &["judge", "own.csv", &example, "--no-truth"]);
        assert!(run.stdout.starts_with(&format!("own.csv keeps the laws of {scene}")), "{}", run.stdout);
    }
}

/// Poses alone are a trajectory too; velocities are then differences, and how well they are known is told.
#[test]
fn velocities_may_be_absent() {
    let place = Place::with_scene(BOX);
    let whole = standing((0..11).map(|_| 0.1));
    let poses: Vec<String> = whole.lines().map(|line| line.split(',').take(9).collect::<Vec<_>>().join(",")).collect();
    place.write("poses.csv", &format!("{}\n", poses.join("\n")));
    let run = place.expect(0, &["judge", "poses.csv", "scene.toml"]);
    assert!(run.stdout.contains("velocities from differences of the poses"), "{}", run.stdout);
}

#[test]
fn other_units_orders_and_bodies_are_refused_with_what_is_accepted() {
    let place = Place::with_scene(BOX);
    let whole = standing((0..5).map(|_| 0.1));
    for (text, says) in [
        (standing((0..5).map(|_| 100.0)), "lengths look like millimetres"),
        (whole.replace("0.1,1,0,0,0,", "0.1,0,0,0,1,"), "scalar came last"),
        (whole.replace("box", "crate"), "no body `crate`"),
        (
            whole.lines().filter(|line| !line.contains("floor")).fold(String::new(), |all, line| all + line + "\n"),
            "missing",
        ),
        (whole.replace("0.02,", "0.005,"), "times must be finite and ascend"),
        (whole.replace("0,0,0.1,", "0,0,nan,"), "must be finite"),
        (String::new(), "the file is empty"),
        (HEAD.to_owned(), "no samples"),
        (standing(std::iter::once(0.1)), "one sample"),
    ] {
        place.write("bad.csv", &text);
        let run = place.expect(2, &["judge", "bad.csv", "scene.toml"]);
        assert!(run.stderr.contains(says), "{says}: {}", run.stderr);
    }
    place.write("motion.txt", &whole);
    assert!(place.expect(2, &["judge", "motion.txt", "scene.toml"]).stderr.contains(".csv, .json, .npy"));
    place.write("good.csv", &whole);
    assert!(place.expect(2, &["judge", "good.csv", "scene.toml", "--tolerance", "-1"]).stderr.contains("tolerance"));
    place.expect(2, &["judge", "good.csv", "scene.toml", "-o", "good.csv"]);
}

#[test]
fn a_gap_is_told() {
    let place = Place::with_scene(BOX);
    let text: Vec<String> = standing((0..11).map(|_| 0.1))
        .lines()
        .filter(|line| !["0.04,", "0.05,"].iter().any(|t| line.starts_with(t)))
        .map(str::to_owned)
        .collect();
    place.write("gap.csv", &format!("{}\n", text.join("\n")));
    let run = place.expect(0, &["judge", "gap.csv", "scene.toml"]);
    assert!(run.stdout.contains("gaps: 1 intervals"), "{}", run.stdout);
}
