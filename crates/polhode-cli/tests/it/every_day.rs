//! What a day's use needs: scenes from stdin and from inside the program, CSV on stdout, new scenes, completions, a
//! report that leads with the result, failures as JSON, and results that are never lost.

use crate::{FLIGHT, Place, Run};
use std::io::Write as _;
use std::process::Stdio;

/// Runs the program with this text on stdin.
fn with_stdin(place: &Place, args: &[&str], text: &str) -> Run {
    let mut command = place.command(args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    child.wait_with_output().unwrap().into()
}

/// A scene comes from stdin and its trajectory goes to stdout: the same bytes as from file to file. The report is on
/// stderr, and with -q nowhere.
#[test]
fn stdin_and_stdout() {
    let place = Place::with_scene(FLIGHT);
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    let run = with_stdin(&place, &["run", "-", "-o", "-"], FLIGHT);
    assert_eq!((run.code, run.stdout.as_str()), (Some(0), place.read("a.csv").as_str()));
    assert!(run.stderr.starts_with("scene flight\n"), "{}", run.stderr);
    let quiet = with_stdin(&place, &["run", "-", "-o", "-", "-q"], FLIGHT);
    assert_eq!((quiet.stdout, quiet.stderr.as_str()), (run.stdout, ""));
    let refused = with_stdin(&place, &["check", "-"], &FLIGHT.replace("mass", "mas"));
    assert!(refused.code == Some(2) && refused.stderr.contains("--> <stdin>:11:1"), "{}", refused.stderr);
    let refused = with_stdin(&place, &["run", "-", "--checkpoint", "kept"], FLIGHT);
    assert!(refused.code == Some(2) && refused.stderr.contains("a checkpoint names the file"), "{}", refused.stderr);
    assert_eq!(place.list(), ["a.csv", "scene.toml"]);
}

/// Every shipped scene is listed and is inside the program, with its meshes, and nothing else that lies beside them.
#[test]
fn examples() {
    let place = Place::new();
    let listed = place.expect(0, &["scenes"]).stdout;
    let files = std::fs::read_dir(crate::fixture("scenes")).unwrap().map(|entry| entry.unwrap().path());
    // `polhode view` writes its page beside the scene.
    let shipped = files.filter(|file| file.extension().is_some_and(|ending| ending == "toml")).count();
    assert_eq!(listed.lines().filter(|line| line.starts_with("  ")).count(), shipped, "{listed}");
    assert!(listed.contains("diamond-4 "), "{listed}");
    for example in ["example:diamond-4", "example:thrown-l-shape", "example:box-down-ramp"] {
        place.expect(0, &["check", example]);
    }
    let args = ["run", "example:thrown-l-shape", "--duration", "0.1", "-o", "-", "-q"];
    let inside = place.expect(0, &args).stdout;
    let file = crate::fixture("scenes/thrown-l-shape.toml");
    let outside = place.expect(0, &["run", &file, "--duration", "0.1", "-o", "-", "-q"]).stdout;
    assert_eq!(inside, outside);
}

/// A new scene runs as it is; one that begins with an example has its meshes beside it. Nothing is replaced.
#[test]
fn new_scenes() {
    let place = Place::new();
    assert_eq!(place.expect(0, &["new", "mine"]).stdout, "mine.toml\n");
    assert!(place.expect(0, &["run", "mine.toml", "--duration", "0.1"]).stdout.starts_with("scene mine: "));
    place.expect(0, &["new", "l.toml", "--from", "thrown-l-shape"]);
    assert_eq!(place.list(), ["l-shape.obj", "l.toml", "mine.toml"]);
    place.expect(0, &["check", "l.toml"]);
    place.expect(2, &["new", "mine"]);
}

/// Each shell gets a script that knows the commands.
#[test]
fn completions() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = Place::new().expect(0, &["completions", shell]).stdout;
        assert!(script.contains("resume") && script.contains("polhode"), "{shell}");
    }
}

/// The help of every command shows how it is used.
#[test]
fn help_has_examples() {
    let place = Place::new();
    let help = place.expect(0, &["--help"]).stdout;
    let commands = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names: Vec<&str> = commands.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() >= 12, "{help}");
    for name in names.into_iter().filter(|name| *name != "help") {
        let help = place.expect(0, &[name, "--help"]).stdout;
        assert!(help.contains(&format!("\n  polhode {name}")), "{name}: {help}");
    }
}

/// The report begins with its answers; in full the plan stands below all else and fits 100 columns. No colour, and
/// nothing on stderr of a run that is short.
#[test]
fn the_report_leads_with_the_result() {
    let place = Place::new();
    let run = place.expect(0, &["run", "example:box-drop", "--duration", "0.2", "--full"]);
    let at = |part: &str| run.stdout.find(part).unwrap_or_else(|| panic!("{part} is missing: {}", run.stdout));
    let order = [
        "  simulated ",
        "\n  is it right ",
        "\nwhat happened\n",
        "\nat the end\n",
        "\nenergy\n",
        "\ncompared with\n",
        "\ncertificate",
        "\nledger",
        "\nplan\n",
        "\neffects\n",
    ];
    assert!(order.is_sorted_by_key(|part| at(part)), "{}", run.stdout);
    let plan = &run.stdout[at("\nplan\n")..];
    assert!(plan.lines().all(|line| line.chars().count() <= 100), "{plan}");
    assert!(run.stderr.is_empty() && !run.stdout.contains('\u{1b}'), "{}", run.stderr);
    let verbose = place.expect(0, &["run", "example:box-drop", "--duration", "0.2", "-v"]);
    assert!(verbose.stderr.contains("\neffects\n"), "{}", verbose.stderr);
}

/// With --json a run that failed prints an object too, which says how it ended and why.
#[test]
fn failures_are_told_as_json() {
    let place = Place::with_scene(FLIGHT);
    for (code, args, word) in [
        (3, &["run", "missing.toml", "--json"][..], "cannot read missing.toml"),
        (2, &["run", "scene.toml", "--json", "--step", "-1"], "-1"),
        (2, &["run", "scene.toml", "--json", "-o", "scene.toml"], "never replaces"),
        (3, &["resume", "missing", "--json"], "cannot read missing"),
    ] {
        let run = place.expect(code, args);
        let value = run.json();
        assert_eq!((value["outcome"].as_str(), value["exit_code"].as_i64()), (Some("failed"), Some(i64::from(code))));
        assert!(value["error"].as_str().unwrap().contains(word), "{value}");
        assert!(run.stderr.contains(word), "{}", run.stderr);
    }
    // A body that falls into the point that attracts it.
    let text =
        FLIGHT.replace("velocity = [3, 0, 4]", "").replace("duration = 0.5", "duration = 100\ngravity = [0, 0, 0]");
    let force = "\n[[forces]]\ntype.point_gravity = { mu = 1, center = [1, 0, 0] }\n";
    place.write("scene.toml", &(text + force));
    let value = place.expect(1, &["run", "scene.toml", "--json"]).json();
    assert!(value["simulated_s"].as_f64().unwrap() > 0.5 && value["duration_s"] == 100.0, "{value}");
    assert!(value["error"].as_str().unwrap().contains("point gravity"), "{value}");
}

/// Characters of names that would steer a terminal are written out; JSON has its own way.
#[test]
fn control_characters_are_harmless() {
    let place = Place::with_scene(&FLIGHT.replace("stone", "st\\u001B[31mone").replace("name = \"flight\"", ""));
    let run = place.expect(0, &["run", "scene.toml"]);
    assert!(!run.stdout.contains('\u{1b}') && run.stdout.contains("st\\u{1b}[31mone"), "{}", run.stdout);
    let run = place.expect(2, &["run", "scene.toml", "--set", "bodies.0.mass=-1"]);
    assert!(!run.stderr.contains('\u{1b}'), "{}", run.stderr);
}

/// Bodies that overlap a little are moved apart when the scene says so, by no more, and the report says so; all pairs
/// that overlap are named otherwise, with what would mend it.
#[test]
fn overlaps_at_the_start() {
    let ball = |name: &str, z: f64| {
        format!("[[bodies]]\nname = \"{name}\"\nshape.sphere.radius = 0.5\nmass = 1\nposition = [0, 0, {z}]\n")
    };
    let floor =
        "format = 1\nduration = 0.1\n[[bodies]]\nname = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\n";
    let place = Place::with_scene(&format!("{floor}{}{}", ball("a", 0.4999999), ball("b", 1.4999997)));
    let run = place.expect(2, &["run", "scene.toml"]);
    for part in ["floor and a overlap by 1e-7 m", "a and b overlap by 2e-7 m", "--set start.separate=2.1e-7"] {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
    let mended = ["run", "scene.toml", "--json", "--set", "start.separate=2.1e-7"];
    let report = place.expect(0, &mended).json();
    assert!(report["warnings"][0].as_str().unwrap().contains("2 pairs of bodies overlapped by up to "), "{report}");
    let z = |body: usize| report["bodies"][body]["position"][2].as_f64().unwrap();
    assert!((z(1) - 0.5).abs() < 1e-12 && (z(2) - 1.5).abs() < 1e-12, "{report}");
    let run = place.expect(2, &["run", "scene.toml", "--set", "start.separate=1.5e-7"]);
    assert!(run.stderr.contains("a and b overlap"), "{}", run.stderr);
}

/// A disk that is full (here: a limit on the size of files) keeps what fits: readable, whole samples, and named.
#[cfg(unix)]
#[test]
fn a_full_disk_keeps_what_fits() {
    let place = Place::with_scene(&FLIGHT.replace("interval = 0.125", "interval = 1e-4"));
    for (name, readable) in [("a.csv", "a.csv.partial"), ("a.npy", "a.npy.partial"), ("a.json", "a.json.partial")] {
        let program = env!("CARGO_BIN_EXE_polhode");
        let script = format!("trap '' XFSZ; ulimit -f 64; exec '{program}' run scene.toml -o {name}");
        let mut command = place.command(&[]);
        command = {
            let folder = command.get_current_dir().unwrap().to_owned();
            let mut shell = std::process::Command::new("sh");
            shell.current_dir(folder).args(["-c", &script]);
            shell
        };
        let run: Run = command.output().unwrap().into();
        assert_eq!(run.code, Some(3), "{}", run.stderr);
        assert!(run.stderr.contains(&format!("what was written is kept in {readable}")), "{}", run.stderr);
        place.expect(0, &["view", "scene.toml", readable, "-o", "page.html"]);
    }
    assert_eq!(place.list(), ["a.csv.partial", "a.json.partial", "a.npy.partial", "page.html", "scene.toml"]);
}

/// A temporary file that a killed program has left is removed when its target is written again; an output that is a
/// link is followed.
#[cfg(unix)]
#[test]
fn no_file_is_left_behind() {
    let place = Place::with_scene(FLIGHT);
    place.write(".a.csv.k1ll3d.tmp", "t,body");
    std::os::unix::fs::symlink("real.csv", place.path("a.csv")).unwrap();
    place.write("real.csv", "before");
    place.write(".real.csv.k1ll3d.tmp", "t,body");
    place.expect(0, &["run", "scene.toml", "-o", "a.csv"]);
    assert_eq!(place.list(), [".a.csv.k1ll3d.tmp", "a.csv", "real.csv", "scene.toml"]);
    assert!(place.path("a.csv").is_symlink() && place.read("real.csv").starts_with("t,body,px"));
}
