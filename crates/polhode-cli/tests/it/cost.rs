//! `polhode cost`: error against time. What is timed is only shown, never judged.

use crate::{FLIGHT, Place};
use serde_json::Value;

/// Two tiers over two steps, in few and short runs.
const VARIED: [&str; 10] = [
    "cost",
    "scene.toml",
    "--vary",
    "method.tier=accurate,thesis",
    "--vary",
    "method.step=0.05,0.0125",
    "--samples",
    "20",
    "--rounds",
    "2",
];

fn varied<'a>(more: &[&'a str]) -> Vec<&'a str> {
    VARIED.iter().chain(more).copied().collect()
}

/// The closed form is the reference of a flight; RK4 converges to it at order 4, and the table says so in every form.
#[test]
fn a_flight() {
    let place = Place::with_scene(FLIGHT);
    let files = ["--csv", "a.csv", "--svg", "a.svg", "--html", "a.html"];
    let json = place.expect(0, &varied(&[&files[..], &["--json"]].concat())).json();
    assert_eq!(place.list(), ["a.csv", "a.html", "a.svg", "scene.toml"]);
    assert_eq!(json["references"][0]["kind"], "exact");
    let floor = json["references"][0]["error"].as_f64().unwrap();
    assert!(floor > 0.0 && floor < 1e-12, "{floor}");

    let candidates = json["candidates"].as_array().unwrap();
    let number = |candidate: usize, key: &str| candidates[candidate][key].as_f64().unwrap();
    let names: Vec<_> = candidates.iter().map(|candidate| candidate["method"].as_str().unwrap()).collect();
    assert_eq!(names, ["accurate", "accurate", "thesis", "thesis"]);
    assert!(number(0, "error") <= 1e-13 && number(0, "known_error") >= floor);
    let ratio = number(2, "error") / number(3, "error");
    assert!((100.0..600.0).contains(&ratio), "order 4 in a quarter of the step is 256: {ratio}");
    assert!(candidates.iter().all(|candidate| candidate["time_ratio"].as_f64().unwrap() > 0.0));
    assert!(candidates.iter().any(|candidate| candidate["pareto"] == true));

    let csv = place.read("a.csv");
    let header: Vec<_> = csv.lines().next().unwrap().split(',').collect();
    assert_eq!(csv.lines().count(), 5);
    assert!(csv.lines().all(|line| line.split(',').count() == header.len()), "{csv}");
    let svg = place.read("a.svg");
    for part in ["<svg", "thesis", "Pareto front", "microseconds for each simulated second", ">mm<", ">degrees<"] {
        assert!(svg.contains(part), "{part}");
    }
    let html = place.read("a.html");
    assert!(html.contains(svg.trim_end()) && html.contains("<script>") && html.matches("<tr").count() == 5);
}

/// The error that a run tells of itself stands beside the true one, which a closed form knows: it is at least a tenth
/// of it, or both are rounding. A run that hides its error tenfold is the fault that this finds.
#[test]
fn told_errors_stand_beside_true_ones() {
    let place = Place::with_scene(FLIGHT);
    let vary = ["--vary", "method.tier=thesis,stepped", "--vary", "method.integrator=rk4,semi-implicit-euler"];
    let rest = ["--vary", "method.step=0.05,0.01", "--samples", "5", "--rounds", "1", "--json", "--csv", "a.csv"];
    let json = place.expect(0, &[&["cost", "scene.toml"][..], &vary, &rest].concat()).json();
    assert_eq!(json["references"][0]["kind"], "exact");
    let candidates = json["candidates"].as_array().unwrap();
    let ran: Vec<_> = candidates.iter().filter(|candidate| candidate["failure"].is_null()).collect();
    assert!(ran.len() >= 4, "{json}");
    for candidate in &ran {
        let [error, estimated] = ["error", "estimated_error"].map(|key| candidate[key].as_f64().unwrap());
        assert!(estimated >= 0.1 * error || error < 1e-13, "{candidate}");
    }
    assert!(ran.iter().any(|candidate| candidate["error"].as_f64().unwrap() > 1e-6), "{json}");
    assert!(place.read("a.csv").lines().next().unwrap().contains(",error,estimated_error,"));
    let text = place.expect(0, &varied(&[])).stdout;
    assert!(text.contains("the error that the run tells of itself"), "{text}");
}

/// A target is reached by a method that is named with the lines that select it, or the exit code is 1.
#[test]
fn target() {
    let place = Place::with_scene(FLIGHT);
    let run = place.expect(0, &varied(&["--target", "1e-10", "--svg", "target.svg"]));
    let svg = place.read("target.svg");
    assert!(svg.contains(">target 1e-10<") && svg.contains("cheapest for target"), "{svg}");
    for part in ["reference", "exact", "cheapest method", "[method]", "tier = \"", "Pareto front"] {
        assert!(run.stdout.contains(part), "{part}\n{}", run.stdout);
    }
    let run = place.expect(1, &varied(&["--target", "1e-30"]));
    assert!(run.stderr.contains("no method reaches an error of 1e-30"), "{}", run.stderr);
}

/// Errors stand in the table in millimetres and degrees too, times in microseconds; two rounds say nothing about noise,
/// so that methods within a fifth of each other are ties, here one method twice.
#[test]
fn units_and_ties() {
    let place = Place::with_scene(FLIGHT);
    let args = ["cost", "scene.toml", "--vary", "output.interval=0.125,0.25", "--rounds", "2", "--target", "1e-3"];
    let json = place.expect(0, &[&args[..], &["--json"]].concat()).json();
    let candidates = json["candidates"].as_array().unwrap();
    let length_m = json["references"][0]["length_m"].as_f64().unwrap();
    for candidate in candidates {
        let number = |key: &str| candidate[key].as_f64().unwrap();
        assert!((number("position_error_mm") - 1e3 * length_m * number("position_error")).abs() < 1e-15);
        assert!((number("attitude_error_deg") - number("attitude_error_rad").to_degrees()).abs() < 1e-15);
        let [low, high] = [0, 1].map(|end| candidate["time_ratio_spread"][end].as_f64().unwrap());
        assert!(low <= number("time_ratio") && number("time_ratio") <= high && number("us_per_simulated_s") > 0.0);
    }
    assert!(json["target"]["ties"].is_array());
    let text = place.expect(0, &args).stdout;
    for part in ["mm", "degrees", "noise", "us/s", "us for each simulated second"] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let help = place.expect(0, &["cost", "--help"]).stdout;
    assert!(help.contains("middle half") && help.contains("overlap"), "{help}");
}

/// Without `--vary` every integrator is there: those that run in the table, the others with the reason.
#[test]
fn default_candidates() {
    let place = Place::with_scene(FLIGHT);
    let args =
        ["cost", "scene.toml", "--duration", "0.25", "--samples", "5", "--rounds", "1", "--budget", "1", "--json"];
    let json = place.expect(0, &args).json();
    let candidates = json["candidates"].as_array().unwrap();
    for name in ["exact", "rk4"] {
        assert!(candidates.iter().any(|candidate| candidate["method"] == name), "{name}");
    }
    let told = |candidate: &Value| candidate["error"].is_number() != candidate["failure"].is_string();
    assert!(candidates.iter().all(told), "{json}");
}

/// A candidate that is refused is listed with its reason; another mass is another motion, with a reference of its own.
#[test]
fn refused_and_other_models() {
    let place = Place::with_scene(FLIGHT);
    let args = ["cost", "scene.toml", "--rounds", "1", "--samples", "5"];
    let run = place.expect(0, &[&args[..], &["--vary", "method.step=0.1,-1"]].concat());
    assert!(run.stdout.contains("not in the table") && run.stdout.contains("step -1"), "{}", run.stdout);
    let vary = ["--vary", "bodies.0.velocity=[1, 0, 0],[2, 0, 0]", "--json"];
    let json = place.expect(0, &[&args[..], &vary[..]].concat()).json();
    assert_eq!(json["references"].as_array().unwrap().len(), 2);
    for candidate in json["candidates"].as_array().unwrap() {
        assert!(candidate["error"].as_f64().unwrap() < 1e-12, "{candidate}");
    }
}

/// A ball strikes two that touch: laws of impact differ there. The tier of another law is judged by the limit of that
/// law, and the difference of the laws is told beside; it counts where a target is asked for.
#[test]
fn another_law_is_no_error_of_a_method() {
    let ball = |name: &str, place: &str, velocity: &str| {
        format!(
            "[[bodies]]\nname = \"{name}\"\nmass = 1\nshape.sphere.radius = 0.5\nmaterial = \"ivory\"\n\
             position = {place}\n\
             velocity = {velocity}\n"
        )
    };
    let balls = [
        ball("cue", "[-1.5, 0, 0]", "[1, 0, 0]"),
        ball("left", "[0, 0.5, 0]", "[0, 0, 0]"),
        ball("right", "[0, -0.5, 0]", "[0, 0, 0]"),
    ];
    let head =
        "format = 1\nname = \"break\"\nduration = 1.5\ngravity = [0, 0, 0]\n[materials.ivory]\nrestitution = 1.0\n";
    let place = Place::with_scene(&format!("{head}{}", balls.concat()));
    let csv = ["--json", "--csv", "a.csv", "--svg", "a.svg"];
    let json = place.expect(0, &varied(&[&csv[..], &["--target", "1e-6"]].concat())).json();
    assert_eq!(json["references"].as_array().unwrap().len(), 2);
    let candidates = json["candidates"].as_array().unwrap();
    let number = |candidate: usize, key: &str| candidates[candidate][key].as_f64().unwrap();
    assert!(candidates[0]["law"].is_null() && candidates[1]["law_difference"].is_null());
    for thesis in [2, 3] {
        assert_eq!(candidates[thesis]["law"], "propagation");
        assert!(number(thesis, "law_difference") > 0.1, "{}", candidates[thesis]);
        assert!(number(thesis, "error") < 0.1 * number(thesis, "law_difference"), "{}", candidates[thesis]);
    }
    assert!(number(3, "error") < number(2, "error"));
    let cheapest = json["target"]["cheapest"]["name"].as_str().unwrap();
    assert!(cheapest.starts_with("accurate"), "{cheapest}");
    assert!(place.read("a.svg").contains("difference of law: propagation"));
    assert!(place.read("a.csv").lines().next().unwrap().contains("law,law_difference"));
}

/// `--scale` gives the arrays of a scene other numbers of bodies, and says how the time grows; a scene without arrays
/// is refused.
#[test]
fn growth_with_the_bodies() {
    let balls = "format = 1\nname = \"rain\"\nduration = 0.1\n[[arrays]]\nname = \"drop\"\nmass = 1\n\
        shape.sphere.radius = 0.1\n\
                 layout.drop = { count = 5, size = [4, 4, 4] }\n";
    let place = Place::with_scene(balls);
    let args = ["cost", "scene.toml", "--scale", "5,10,20", "--vary", "method.tier=accurate,stepped"];
    let json = place.expect(0, &[&args[..], &["--json", "--csv", "a.csv"]].concat()).json();
    let rows = json["rows"].as_array().unwrap();
    let bodies: Vec<u64> = rows.iter().map(|row| row["bodies"].as_u64().unwrap()).collect();
    assert_eq!(bodies, [5, 10, 20, 5, 10, 20]);
    assert!(
        rows[0]["exponent"].is_null() && rows[1]["exponent"].is_number() && rows[5]["time_s"].as_f64().unwrap() > 0.0
    );
    assert_eq!(place.read("a.csv").lines().count(), 7);
    let flight = Place::with_scene(FLIGHT);
    let run = flight.expect(2, &["cost", "scene.toml", "--scale", "5"]);
    assert!(run.stderr.contains("[[arrays]]"), "{}", run.stderr);
}

/// `run --accuracy` runs by the cheapest method that the search finds, and says which.
#[test]
fn run_to_an_accuracy() {
    let place = Place::with_scene(FLIGHT);
    // One integrator is searched for its step, which is enough here.
    let rk4 = ["run", "scene.toml", "--set", "method.integrator=rk4"];
    let run = place.expect(0, &[&rk4[..], &["--accuracy", "1e-8", "--json"]].concat());
    assert!(run.stderr.contains("rk4 step"), "{}", run.stderr);
    assert!(run.stderr.contains("cheapest method with an error of at most 1e-8"), "{}", run.stderr);
    assert_eq!(run.json()["simulated_s"], 0.5);
    // What none reaches is asked of the most accurate one, which says how far off it is.
    let run = place.expect(1, &[&rk4[..], &["--accuracy", "1e-30", "--json"]].concat());
    assert!(run.stderr.contains("no method reaches"), "{}", run.stderr);
    let report = run.json();
    assert_eq!((&report["outcome"], &report["simulated_s"]), (&"degraded".into(), &0.5.into()));
    assert!(report["error"]["largest"]["relative"].as_f64().unwrap() > 1e-30);
}

/// Mistakes have exit code 2, files that cannot be written 3, before anything is run.
#[test]
fn mistakes() {
    let place = Place::with_scene(FLIGHT);
    for more in [
        &["--target", "0"][..],
        &["--target", "nan"],
        &["--budget", "-1"],
        &["--rounds", "0"],
        &["--samples", "0"],
        &["--vary", "method.step"],
        &["--vary", "method.step=1,,2"],
        &["--vary", "method.step=1", "--vary", "method.step=2"],
        &["--set", "duration=-1"],
    ] {
        let run = place.expect(2, &[&["cost", "scene.toml"], more].concat());
        assert!(run.stdout.is_empty() && !run.stderr.is_empty(), "{more:?}");
    }
    place.expect(2, &["run", "scene.toml", "--accuracy", "-1"]);
    place.expect(3, &["cost", "scene.toml", "--svg", "missing/a.svg"]);
    place.expect(3, &["cost", "missing.toml"]);
    assert_eq!(place.list(), ["scene.toml"]);
}

/// Two boxes that fall on a floor: every broad phase is timed and finds the same pairs, in every form of the table.
#[test]
fn broad_phases() {
    let scene = "format = 1\nduration = 0.1\n\
                 [[bodies]]\nname = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\n\
                 [[bodies]]\nname = \"a\"\nshape.box.size = [1, 1, 1]\nmass = 1\nposition = [0, 0, 0.5]\n\
                 [[bodies]]\nname = \"b\"\nshape.box.size = [1, 1, 1]\nmass = 1\nposition = [5, 0, 3]\n";
    let place = Place::with_scene(scene);
    let arguments = ["cost", "scene.toml", "--broad-phase", "--samples", "10", "--rounds", "2"];
    let json = place.expect(0, &[&arguments[..], &["--csv", "b.csv", "--html", "b.html", "--json"]].concat()).json();
    assert_eq!(place.list(), ["b.csv", "b.html", "scene.toml"]);
    let names: Vec<_> = json["broad_phases"].as_array().unwrap().iter().map(|row| &row["broad_phase"]).collect();
    let expected = ["bvh", "voxel-grid", "octree", "kd-tree", "binary-space-partition", "sweep-and-prune", "none"];
    assert_eq!(names, expected);
    // The floor has no bounds, so that it meets both boxes at each of eleven samples; the boxes never meet.
    assert_eq!((&json["boxes"], &json["samples"], &json["pairs"]), (&3.into(), &11.into(), &22.into()));
    assert_eq!(json["broad_phases"][3]["rounds"], 2);
    place.expect(2, &[&arguments[..], &["--svg", "b.svg"]].concat());
}

/// A box of rubber that falls flat onto a rigid floor: finite elements stand beside the impact laws on the same drop.
/// Laws that strike all corners at once leave with the coefficient that they are told, in no time; the elastic body
/// with 0.82, after a wave up and down (2 H/c_p = 0.0545 s).
#[test]
fn an_elastic_body_stands_beside_the_laws() {
    let scene = |rubber: &str| {
        format!(
            "format = 1\nname = \"drop\"\nduration = 0.3\n[materials.rubber]\nrestitution = 0.5\n{rubber}[[bodies]]\n\
             name = \"floor\"\n\
             fixed = true\nshape.half_space.normal = [0, 0, 1]\n[[bodies]]\nname = \"box\"\n\
             shape.box.size = [2, 0.5, 1]\n\
             density = 1000\nposition = [0, 0, 0.55098581]\nmaterial = \"rubber\"\n"
        )
    };
    let place = Place::with_scene(&scene("youngs_modulus_pa = 1e6\npoisson_ratio = 0.3\n"));
    let few = ["cost", "scene.toml", "--rounds", "1", "--samples", "5", "--budget", "1", "--json"];
    let json = place.expect(0, &few).json();
    let elastic = &json["elastic"];
    let limit = |key: &str| elastic["limit"][key].as_f64().unwrap();
    assert!((limit("restitution") - 0.8195).abs() < 0.002, "{elastic}");
    assert!(
        (limit("contact_time_s") / 0.0545 - 1.0).abs() < 0.03 && (limit("impulse_n_s") / 1819.5 - 1.0).abs() < 0.002
    );
    let (laws, speed) = (elastic["laws"].as_array().unwrap(), elastic["speed_m_s"].as_f64().unwrap());
    assert_eq!((laws.len(), elastic["meshes"].as_array().unwrap().len()), (6, 3));
    // Propagation strikes one corner after the other, so that a flat box leaves slower.
    for law in laws.iter().filter(|law| law["law"] != "propagation") {
        let number = |key: &str| law[key].as_f64().unwrap();
        assert!((number("restitution") - 0.5).abs() < 1e-6 && number("contact_time_s") == 0.0, "{law}");
        assert!((number("impulse_n_s") / (1500.0 * speed) - 1.0).abs() < 1e-6, "{law}");
    }

    // Without moduli there is nothing to compute, which is told where it is asked for.
    let place = Place::with_scene(&scene(""));
    let run = place.expect(2, &[&few[..], &["--elastic"]].concat());
    assert!(run.stderr.contains("material of body box has no youngs_modulus_pa"), "{}", run.stderr);
    let place = Place::with_scene(FLIGHT);
    let run = place.expect(2, &["cost", "scene.toml", "--elastic"]);
    assert!(run.stderr.contains("no elastic body stands for this scene"), "{}", run.stderr);
}
