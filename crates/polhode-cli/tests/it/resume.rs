//! `polhode run --checkpoint-every`, `polhode resume` and Ctrl-C.

use crate::Place;
use polhode_scene::Checkpoint;

/// A brick that falls on a corner, bounces and comes to rest.
const FALL: &str = r#"
format = 1
name = "fall"
duration = 1.5
[output]
interval = 0.0625
[materials.wood]
restitution = 0.4
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "wood"
[[bodies]]
name = "brick"
shape.box.size = [0.6, 0.4, 0.2]
mass = 2.0
position = [0, 0, 0.8]
rotation_vector = [0.4, 0.7, 0.1]
angular_velocity = [1, 3, -2]
material = "wood"
"#;

/// A ball that bounces for longer than anybody waits.
#[cfg(unix)]
const ENDLESS: &str = r#"
format = 1
name = "endless"
duration = 1e9
[output]
interval = 1e4
[materials.rubber]
restitution = 1.0
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
material = "rubber"
[[bodies]]
name = "ball"
shape.sphere.radius = 0.1
mass = 1.0
position = [0, 0, 0.5]
material = "rubber"
"#;

/// A report without what the clock says.
fn timeless(mut report: serde_json::Value) -> serde_json::Value {
    report.as_object_mut().unwrap().remove("wall_s");
    report
}

/// The report of a run that was continued is that of a run that was never stopped, and so is the rest of its files.
#[test]
fn a_run_that_is_resumed_ends_like_one_that_was_never_stopped() {
    let place = Place::with_scene(FALL);
    let settings = ["--set", "bodies.brick.mass=3", "--tier", "accurate"];
    let whole = [&["run", "scene.toml", "--json", "-o", "a.csv", "--events", "a-events.csv"], &settings[..]].concat();
    let expected = timeless(place.expect(0, &whole).json());
    let run = place.expect(0, &[&["run", "scene.toml", "--checkpoint-every", "0.6"], &settings[..]].concat());
    assert!(run.stderr.contains("scene.checkpoint"), "{}", run.stderr);
    assert_eq!(run.stderr.lines().count(), 2, "{}", run.stderr);
    assert_eq!(place.list(), ["a-events.csv", "a.csv", "scene.checkpoint", "scene.toml"]);
    let resume = ["resume", "scene.checkpoint", "--json", "-o", "b.csv", "--events", "b-events.csv"];
    assert_eq!(timeless(place.expect(0, &resume).json()), expected);
    for (whole, rest) in [("a.csv", "b.csv"), ("a-events.csv", "b-events.csv")] {
        let (whole, rest) = (place.read(whole), place.read(rest));
        let rest = rest.split_once('\n').unwrap().1;
        assert!(whole.ends_with(rest) && rest.lines().count() < whole.lines().count(), "{rest}");
    }
    assert!(place.expect(0, &["resume", "scene.checkpoint"]).stdout.contains("certificate"));
}

/// A checkpoint may be written on the way of a resumed run, over the one that it began with.
#[test]
fn resumed_runs_keep_checkpoints_too() {
    let place = Place::with_scene(FALL);
    let all = timeless(place.expect(0, &["run", "scene.toml", "--effects", "all", "--json"]).json());
    place.expect(0, &["run", "scene.toml", "--effects", "all", "--checkpoint-every", "1", "--checkpoint", "kept"]);
    assert_eq!(timeless(place.expect(0, &["resume", "kept", "--json", "--checkpoint-every", "0.2"]).json()), all);
    assert!(Checkpoint::read(&place.path("kept")).unwrap().snapshot.time() >= 1.4);
    assert_eq!(timeless(place.expect(0, &["resume", "kept", "--json"]).json()), all);
}

#[test]
fn checkpoints_that_cannot_be_continued_are_refused_with_a_message() {
    let place = Place::with_scene(FALL);
    place.expect(0, &["run", "scene.toml", "--checkpoint-every", "0.7"]);
    let bytes = std::fs::read(place.path("scene.checkpoint")).unwrap();
    let altered = |bytes: &[u8]| std::fs::write(place.path("altered"), bytes).unwrap();
    for at in [3, 25, 40, bytes.len() / 2, bytes.len() - 1] {
        let mut bytes = bytes.clone();
        bytes[at] ^= 1;
        altered(&bytes);
        let run = place.run(&["resume", "altered"]);
        assert!(matches!(run.code, Some(2 | 3)) && run.stderr.starts_with("error: "), "{at}: {}", run.stderr);
    }
    for length in [0, 10, 30, bytes.len() - 1] {
        altered(&bytes[..length]);
        let run = place.expect(2, &["resume", "altered"]);
        assert!(run.stderr.starts_with("error: altered"), "{}", run.stderr);
    }
    place.expect(3, &["resume", "missing"]);
    assert!(place.expect(2, &["resume", "scene.toml"]).stderr.contains("is no checkpoint"));
    place.write("scene.toml", &FALL.replace("mass = 2.0", "mass = 2.5"));
    assert!(place.expect(2, &["resume", "scene.checkpoint"]).stderr.contains("is of scene \"fall\""));
    std::fs::remove_file(place.path("scene.toml")).unwrap();
    assert!(place.expect(3, &["resume", "scene.checkpoint"]).stderr.contains("cannot read"));
}

#[test]
fn an_output_never_replaces_what_the_run_is_made_from() {
    let place = Place::with_scene(FALL);
    place.expect(0, &["run", "scene.toml", "--checkpoint-every", "0.7"]);
    place.write("notes", "mine");
    let before = std::fs::read(place.path("scene.checkpoint")).unwrap();
    for args in [
        &["run", "scene.toml", "--events", "scene.toml"][..],
        &["run", "scene.toml", "--events", "./scene.toml"],
        &["run", "scene.toml", "--checkpoint", "scene.toml"],
        &["run", "scene.toml", "--checkpoint-every", "1", "--checkpoint", "notes"],
        &["run", "scene.toml", "--checkpoint-every", "0"],
        &["run", "scene.toml", "--checkpoint-every", "nan"],
        &["run", "scene.toml", "--checkpoint", "a.csv", "-o", "a.csv"],
        &["resume", "scene.checkpoint", "--events", "scene.checkpoint"],
        &["resume", "scene.checkpoint", "--events", "scene.toml"],
    ] {
        place.expect(2, args);
    }
    assert_eq!((place.read("scene.toml").as_str(), place.read("notes").as_str()), (FALL, "mine"));
    assert_eq!(std::fs::read(place.path("scene.checkpoint")).unwrap(), before);
    assert_eq!(place.list(), ["notes", "scene.checkpoint", "scene.toml"]);
}

/// What was computed is kept, and where the run stopped it can go on.
#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_was_computed_and_a_checkpoint() {
    let place = Place::with_scene(ENDLESS);
    let args = ["run", "scene.toml", "-o", "a.csv", "--checkpoint-every", "50", "--json"];
    let mut command = place.command(&args);
    let child = command.stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped()).spawn().unwrap();
    // The first checkpoint shows that the run has begun.
    while !place.path("scene.checkpoint").exists() {
        std::thread::yield_now();
    }
    let status = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(status.success());
    let run = crate::Run::from(child.wait_with_output().unwrap());
    assert_eq!(run.code, Some(130), "{}", run.stderr);
    for part in ["a.csv.partial", "scene.checkpoint", "interrupted at t = "] {
        assert!(run.stderr.contains(part), "{}", run.stderr);
    }
    assert!(run.stdout.is_empty());
    assert_eq!(place.list(), ["a.csv.partial", "scene.checkpoint", "scene.toml"]);
    assert!(place.read("a.csv.partial").starts_with("t,body,"));
    let path = place.path("scene.checkpoint");
    let checkpoint = Checkpoint::read(&path).unwrap();
    let (_, simulation) = checkpoint.load(&path).unwrap();
    assert!(simulation.time() >= 50.0);
}
