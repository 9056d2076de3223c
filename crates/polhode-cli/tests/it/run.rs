//! `polhode run`.

use crate::{FLIGHT, Place};

/// The report has every key that programs rely on, and the state at the end is that of a thrown stone.
#[test]
fn json() {
    let report = Place::with_scene(FLIGHT).expect(0, &["run", "scene.toml", "--json"]).json();
    for key in [
        "scene",
        "tier",
        "duration_s",
        "simulated_s",
        "steps",
        "wall_s",
        "plan",
        "energy",
        "ledger",
        "max_penetration_m",
        "max_residual",
        "events",
        "warnings",
        "bodies",
    ] {
        assert!(!report[key].is_null(), "{key} is missing");
    }
    for key in ["initial_j", "final_j", "kinetic_j", "potential_j"] {
        assert!(report["energy"][key].is_number(), "energy.{key} is missing");
    }
    for key in [
        "impact_j",
        "friction_j",
        "rest_j",
        "damping_j",
        "external_j",
        "projection_j",
        "numerical_j",
        "closure_relative",
    ] {
        assert!(report["ledger"][key].is_number(), "ledger.{key} is missing");
    }
    assert_eq!((report["scene"].as_str(), report["simulated_s"].as_f64()), (Some("flight"), Some(0.5)));
    let body = &report["bodies"][0];
    assert_eq!(body["name"], "stone, \"flat\"");
    let number = |key: &str, i: usize| body[key][i].as_f64().unwrap();
    assert!((number("position", 0) - 1.5).abs() < 1e-12);
    assert!((number("position", 2) - (2.0 - 0.5 * 9.81 * 0.25)).abs() < 1e-12);
    assert!((number("velocity", 2) - (4.0 - 9.81 * 0.5)).abs() < 1e-12);
    assert_eq!(body["orientation"].as_array().unwrap().len(), 4);
    assert_eq!(body["angular_velocity"].as_array().unwrap().len(), 3);
}

/// The report for people.
#[test]
fn text() {
    let run = Place::with_scene(FLIGHT).expect(0, &["run", "scene.toml", "--full"]);
    for part in ["plan", "what happened", "energy", "ledger", "certificate", "at the end", "0.5 of 0.5 s"] {
        assert!(run.stdout.contains(part), "{part}\n{}", run.stdout);
    }
    assert!(run.stderr.is_empty(), "{}", run.stderr);
}

/// What a scene says of itself stands in its report, for people and as JSON; without it, its name is its title.
#[test]
fn description() {
    let says = "title = \"A stone\"\ndescription = \"\"\"\nIt flies.\n  Look up.\"\"\"\n";
    let place = Place::with_scene(&FLIGHT.replace("duration", &format!("{says}duration")));
    let report = place.expect(0, &["run", "scene.toml", "--json"]).json();
    assert_eq!(
        (report["title"].as_str(), report["description"].as_str()),
        (Some("A stone"), Some("It flies. Look up."))
    );
    let text = place.expect(0, &["run", "scene.toml"]).stdout;
    assert!(text.starts_with("scene flight: A stone\n  simulated"), "{text}");
    let text = place.expect(0, &["run", "scene.toml", "--full"]).stdout;
    assert!(text.contains("\n\nIt flies. Look up.\n\nwhat happened\n"), "{text}");
    let plain = Place::with_scene(FLIGHT).expect(0, &["run", "scene.toml", "--json"]).json();
    assert_eq!((plain["title"].as_str(), plain["description"].is_null()), (Some("flight"), true));
}

/// Trajectories: the first sample is t = 0, the last exactly the duration; names are quoted.
#[test]
fn trajectories() {
    let place = Place::with_scene(FLIGHT);
    let args = ["run", "scene.toml", "-o", "a.csv", "-o", "a.npy", "--output", "a.json", "--events", "events.csv"];
    place.expect(0, &args);
    assert_eq!(place.list(), ["a.csv", "a.json", "a.npy", "events.csv", "scene.toml"]);
    let text = place.read("a.csv");
    let rows: Vec<_> = text.lines().skip(1).collect();
    let times: Vec<_> = rows.iter().map(|row| row.split_once(',').unwrap().0).collect();
    assert_eq!(times, ["0.0", "0.125", "0.25", "0.375", "0.5"]);
    assert!(rows.iter().all(|row| row.contains(",\"stone, \"\"flat\"\"\",")));
    assert!(place.read("events.csv").starts_with("t,kind,body_a,body_b,px,py,pz,nx,ny,nz,impulse,energy_change_j\n"));
}

/// The command line sets values before the scene is validated.
#[test]
fn settings() {
    let place = Place::with_scene(FLIGHT);
    let set = |args: &[&str]| place.expect(0, &[&["run", "scene.toml", "--json"], args].concat()).json();
    assert_eq!(set(&["--duration", "0.25"])["duration_s"], 0.25);
    assert_eq!(set(&["--set", "duration=0.25"])["simulated_s"], 0.25);
    assert_eq!(set(&["--set", "name=\"other\""])["scene"], "other");
    assert_eq!(set(&["--set", "gravity=[0,0,0]"])["bodies"][0]["velocity"][2], 4.0);
    assert_eq!(set(&["--set", "method.impact=propagation"])["plan"]["impact"], "propagation");
    assert_eq!(set(&["--effects", "all"])["scene"], "flight");
}

/// What cannot be written is known before the run, and nothing is left behind.
#[test]
fn outputs_that_cannot_be_written() {
    let place = Place::with_scene(FLIGHT);
    for (code, name, message) in [
        (2, "a.txt", "accepted: .csv, .npy, .json"),
        (2, "a", "accepted: .csv, .npy, .json, .html"),
        (3, "missing/a.html", "cannot write"),
        (3, "missing/a.csv", "cannot write"),
    ] {
        let run = place.expect(code, &["run", "scene.toml", "-o", name]);
        assert!(run.stderr.contains(message), "{}", run.stderr);
    }
    place.expect(2, &["run", "scene.toml", "-o", "a.csv", "-o", "a.csv"]);
    assert_eq!(place.list(), ["scene.toml"]);
}

/// A file that stands under the name is replaced by a whole one; a bad scene leaves it alone.
#[test]
fn replacing() {
    let place = Place::with_scene(FLIGHT);
    place.write("a.csv", "before");
    place.expect(2, &["run", "scene.toml", "-o", "a.csv", "--step", "-1"]);
    assert_eq!(place.read("a.csv"), "before");
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    assert_eq!(place.read("a.csv").lines().count(), 6);
}

/// A ball that falls on a ring, off its axis.
const BALL_ON_RING: &str = r#"
format = 1
name = "ball on a ring"
duration = 3
[materials.m]
restitution = 0.2
[[bodies]]
name = "torus"
fixed = true
shape.torus = { major = 0.5, minor = 0.1 }
material = "m"
[[bodies]]
name = "ball"
shape.sphere.radius = 0.5
mass = 1
position = [0.05, 0.0, 1.0]
material = "m"
"#;

/// With a tolerance of a hundredth, projections give a ball that settles in a ring more of its energy than that: the
/// run ends, and says by outcome, warning and exit code that it has not kept its promise.
#[test]
fn run_that_breaks_its_promise_is_degraded() {
    let place = Place::with_scene(BALL_ON_RING);
    let run = place.expect(1, &["run", "scene.toml", "--json", "-o", "a.csv", "--set", "method.tolerance=1e-2"]);
    let report = run.json();
    assert_eq!((report["outcome"].as_str(), report["simulated_s"].as_f64()), (Some("degraded"), Some(3.0)));
    assert!(report["ledger"]["projection_j"].as_f64().unwrap().abs() > 0.1);
    assert_eq!(report["max_projection_j_at"]["body_a"], "torus");
    let warning = report["warnings"][0].as_str().unwrap();
    for part in ["t = ", "degraded", "torus", "ball", "promised"] {
        assert!(warning.contains(part), "{part}: {warning}");
    }
    assert!(run.stderr.contains("degraded"), "{}", run.stderr);
    // What was asked for is written all the same.
    assert!(place.read("a.csv").lines().count() > 2);
}

/// A run that keeps its promise says so, and how closely.
#[test]
fn run_that_keeps_its_promise_is_completed() {
    let report = Place::with_scene(FLIGHT).expect(0, &["run", "scene.toml", "--json"]).json();
    assert_eq!((report["outcome"].as_str(), report["fallbacks"].as_u64()), (Some("completed"), Some(0)));
    assert!(report["tolerated"].as_array().unwrap().is_empty());
    for key in ["max_projection_m", "max_projection_j", "max_projection_relative", "max_penetration_of_limit"] {
        assert_eq!(report[key].as_f64(), Some(0.0), "{key}");
    }
}

/// What was lost stands before what only checks the book-keeping.
#[test]
fn losses_come_first() {
    let run = Place::new().expect(0, &["run", "example:box-drop", "--full"]);
    let place = |part: &str| run.stdout.find(part).unwrap_or_else(|| panic!("{part} is missing: {}", run.stdout));
    let order = ["numerical loss", "taken by projection", "largest projection", "largest penetration", "closure"];
    assert!(order.is_sorted_by_key(|part| place(part)), "{}", run.stdout);
}

/// Every sample has its estimated error: known in each row, at least a tenth of the distance from the parabola and no
/// more than rounding. The option comes before the scene; with `off` the columns are absent. What reads trajectories
/// takes both, and does not compare errors.
#[test]
fn samples_have_their_errors() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv", "-o", "a.npy", "-o", "a.json"]);
    let text = place.read("a.csv");
    let mut lines = text.lines();
    assert!(lines.next().unwrap().ends_with(",wz,error_m,error_rad"), "{text}");
    for line in lines {
        // The name of the body has a comma.
        let mut numbers = line.rsplit(',').map(str::parse::<f64>);
        let numbers: [f64; 15] = std::array::from_fn(|_| numbers.next().unwrap().unwrap());
        let [error_rad, error_m, ..] = numbers;
        let t: f64 = line.split(',').next().unwrap().parse().unwrap();
        let (x, z) = (numbers[14], numbers[12]);
        let apart = (x - 3.0 * t).hypot(z - (4.0 * t - 0.5 * 9.81 * t * t));
        assert!(
            error_m >= 0.1 * apart && (0.0..1e-13).contains(&error_m) && (0.0..1e-12).contains(&error_rad),
            "{line}"
        );
    }
    place.expect(0, &["run", "scene.toml", "-o", "off.csv", "--error", "off"]);
    assert!(place.read("off.csv").lines().next().unwrap().ends_with(",wz"));
    place.expect(0, &["compare", "a.csv", "off.csv"]);
    place.expect(0, &["compare", "a.csv", "a.csv", "-o", "a.svg"]);
    for file in ["a.csv", "a.npy", "a.json", "off.csv"] {
        place.expect(0, &["view", "scene.toml", file, "-o", "page.html"]);
    }
    let scene = FLIGHT.replace("format = 1\n", "format = 1\nmethod.error = \"off\"\n");
    place.write("scene.toml", &scene);
    let streamed = place.expect(0, &["run", "scene.toml", "-o", "-"]).stdout;
    assert_eq!(streamed, place.read("off.csv"));
    let streamed = place.expect(0, &["run", "scene.toml", "-o", "-", "--error", "quick"]).stdout;
    assert_eq!(streamed, text);
    place.write("scene.toml", &scene.replace("\"off\"", "\"best\""));
    let refused = place.expect(2, &["check", "scene.toml"]).stderr;
    assert!(["best", "off", "quick", "full"].iter().all(|word| refused.contains(word)), "{refused}");
}
