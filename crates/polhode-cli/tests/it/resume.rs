//! `polhode run --checkpoint-every`, `polhode resume` and Ctrl-C.

use crate::Place;
use polhode_scene::Checkpoint;

/// A scene of a body that falls on a floor with this restitution; `head` is its keys of the run.
fn on_a_floor(head: &str, restitution: f64, body: &str) -> String {
    format!(
        "format = 1\n{head}\n[materials.m]\nrestitution = {restitution}\n\
         [[bodies]]\nname = \"floor\"\nfixed = true\nshape.half_space.normal = [0, 0, 1]\nmaterial = \"m\"\n\
         [[bodies]]\nmaterial = \"m\"\n{body}\n"
    )
}

/// A brick that falls on a corner, bounces and comes to rest.
fn fall() -> String {
    let brick = "name = \"brick\"\nshape.box.size = [0.6, 0.4, 0.2]\nmass = 2.0\nposition = [0, 0, 0.8]\n\
                 rotation_vector = [0.4, 0.7, 0.1]\nangular_velocity = [1, 3, -2]";
    on_a_floor("name = \"fall\"\nduration = 1.5\noutput.interval = 0.0625", 0.4, brick)
}

/// A ball that bounces for longer than anybody waits.
#[cfg(unix)]
fn endless() -> String {
    let ball = "name = \"ball\"\nshape.sphere.radius = 0.1\nmass = 1.0\nposition = [0, 0, 0.5]";
    on_a_floor("name = \"endless\"\nduration = 1e9\noutput.interval = 1e4", 1.0, ball)
}

/// A report without what the clock says.
fn timeless(mut report: serde_json::Value) -> serde_json::Value {
    report.as_object_mut().unwrap().remove("wall_s");
    report
}

/// The report of a run that was continued is that of a run that was never stopped, and so is the rest of its files.
#[test]
fn a_run_that_is_resumed_ends_like_one_that_was_never_stopped() {
    let place = Place::with_scene(&fall());
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
    assert!(place.expect(0, &["resume", "scene.checkpoint", "--full"]).stdout.contains("\ncertificate"));
}

/// A checkpoint may be written on the way of a resumed run, over the one that it began with.
#[test]
fn resumed_runs_keep_checkpoints_too() {
    let place = Place::with_scene(&fall());
    let all = timeless(place.expect(0, &["run", "scene.toml", "--effects", "all", "--json"]).json());
    place.expect(0, &["run", "scene.toml", "--effects", "all", "--checkpoint-every", "1", "--checkpoint", "kept"]);
    assert_eq!(timeless(place.expect(0, &["resume", "kept", "--json", "--checkpoint-every", "0.2"]).json()), all);
    assert!(Checkpoint::read(&place.path("kept")).unwrap().snapshot.time() >= 1.4);
    assert_eq!(timeless(place.expect(0, &["resume", "kept", "--json"]).json()), all);
}

#[test]
fn checkpoints_that_cannot_be_continued_are_refused_with_a_message() {
    let place = Place::with_scene(&fall());
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
    place.write("scene.toml", &fall().replace("mass = 2.0", "mass = 2.5"));
    assert!(place.expect(2, &["resume", "scene.checkpoint"]).stderr.contains("is of scene \"fall\""));
    std::fs::remove_file(place.path("scene.toml")).unwrap();
    assert!(place.expect(3, &["resume", "scene.checkpoint"]).stderr.contains("cannot read"));
}

/// A scene names its meshes relative to its own file: a run resumed in another folder finds them, and one whose mesh
/// has changed since is refused.
#[test]
fn a_run_with_mesh_files_is_resumed_in_another_folder() {
    let solid = "name = \"part\"\nshape.mesh.file = \"meshes/part.obj\"\ndensity = 500\nposition = [0, 0, 3.2]\n\
                 rotation_vector = [0.4, 0.7, 0.1]";
    let head = "name = \"part\"\nduration = 0.8\noutput.interval = 0.0625";
    let place = Place::with_scene(&on_a_floor(head, 0.3, solid));
    std::fs::create_dir(place.path("meshes")).unwrap();
    let mesh = std::fs::read_to_string(crate::fixture("meshes/l-shape.obj")).unwrap();
    place.write("meshes/part.obj", &mesh);
    let expected = timeless(place.expect(0, &["run", "scene.toml", "--json", "-o", "a.csv"]).json());
    place.expect(0, &["run", "scene.toml", "--checkpoint-every", "0.3"]);
    let checkpoint = place.path("scene.checkpoint");
    let checkpoint = checkpoint.to_str().unwrap();
    let elsewhere = Place::new();
    let resumed = elsewhere.expect(0, &["resume", checkpoint, "--json", "-o", "b.csv"]);
    assert_eq!(timeless(resumed.json()), expected);
    let rest = elsewhere.read("b.csv");
    assert!(place.read("a.csv").ends_with(rest.split_once('\n').unwrap().1));
    std::fs::copy(checkpoint, elsewhere.path("moved")).unwrap();
    assert_eq!(timeless(elsewhere.expect(0, &["resume", "moved", "--json"]).json()), expected);
    place.write("meshes/part.obj", &mesh.replace("v 2 ", "v 2.001 "));
    let refused = elsewhere.expect(2, &["resume", "moved"]);
    assert!(refused.stderr.contains("is of scene \"part\""), "{}", refused.stderr);
    std::fs::remove_file(place.path("meshes/part.obj")).unwrap();
    assert!(elsewhere.expect(3, &["resume", "moved"]).stderr.contains("part.obj"));
}

#[test]
fn an_output_never_replaces_what_the_run_is_made_from() {
    let place = Place::with_scene(&fall());
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
    assert_eq!((place.read("scene.toml"), place.read("notes").as_str()), (fall(), "mine"));
    assert_eq!(std::fs::read(place.path("scene.checkpoint")).unwrap(), before);
    assert_eq!(place.list(), ["notes", "scene.checkpoint", "scene.toml"]);
}

/// What was computed is kept, and where the run stopped it can go on.
#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_was_computed_and_a_checkpoint() {
    let place = Place::with_scene(&endless());
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
    let report = run.json();
    assert_eq!((report["outcome"].as_str(), report["exit_code"].as_i64()), (Some("interrupted"), Some(130)));
    assert!(report["simulated_s"].as_f64().unwrap() >= 50.0 && report["scene"] == "endless", "{report}");
    assert_eq!(place.list(), ["a.csv.partial", "scene.checkpoint", "scene.toml"]);
    assert!(place.read("a.csv.partial").starts_with("t,body,"));
    let path = place.path("scene.checkpoint");
    let checkpoint = Checkpoint::read(&path).unwrap();
    let (_, simulation) = checkpoint.load(&path).unwrap();
    assert!(simulation.time() >= 50.0);
}

/// A run at rest makes one step: it ends before a checkpoint is due, has one at its end, and says so.
#[test]
fn a_run_at_rest_has_a_checkpoint_and_is_extended() {
    let block = "name = \"block\"\nshape.box.size = [1, 1, 1]\nmass = 1.0\nposition = [0, 0, 0.5]";
    let place = Place::with_scene(&on_a_floor("name = \"rest\"\nduration = 5", 0.0, block));
    let run = place.expect(0, &["run", "scene.toml", "--checkpoint-every", "1"]);
    assert!(run.stderr.contains("note: checkpoint of t = 5 s in scene.checkpoint"), "{}", run.stderr);
    let longer = place.expect(0, &["resume", "scene.checkpoint", "--duration", "7", "--json"]).json();
    assert_eq!((longer["simulated_s"].as_f64(), longer["duration_s"].as_f64()), (Some(7.0), Some(7.0)));
    let ended = place.expect(0, &["resume", "scene.checkpoint"]).stderr;
    assert!(ended.contains("has ended at t = 5 s") && ended.contains("--duration"), "{ended}");
    let refused = place.expect(2, &["resume", "scene.checkpoint", "--duration", "4"]).stderr;
    assert!(refused.contains("is of t = 5 s already"), "{refused}");
}

/// A run that is extended has the motion of one that was as long from the start: to the bit where it was saved before
/// its end, at which its last step ends, and else to the error of a step. How its error is estimated depends on its
/// duration.
#[test]
fn an_extended_run_is_one_that_was_longer() {
    let place = Place::with_scene(&fall());
    place.expect(0, &["run", "scene.toml", "--duration", "2", "-o", "whole.csv", "--error", "off"]);
    place.expect(0, &["run", "scene.toml", "--checkpoint", "ended"]);
    place.expect(0, &["run", "scene.toml", "--checkpoint-every", "0.6", "--checkpoint", "before"]);
    let whole = place.read("whole.csv");
    place.expect(0, &["resume", "before", "--duration", "2", "-o", "rest.csv", "--error", "off"]);
    let rest = place.read("rest.csv");
    let rest = rest.split_once('\n').unwrap().1;
    assert!(!rest.is_empty() && whole.ends_with(rest), "{rest}");
    place.expect(0, &["resume", "ended", "--duration", "2", "-o", "rest.csv", "--error", "off"]);
    let rest = place.read("rest.csv");
    let (header, whole) = whole.split_once('\n').unwrap();
    let is_after = |row: &&str| row.split(',').next().unwrap().parse::<f64>().unwrap() > 1.5;
    let after = whole.lines().filter(is_after).collect::<Vec<_>>().join("\n") + "\n";
    place.write("after.csv", &format!("{header}\n{after}"));
    assert_eq!(rest.lines().count(), after.lines().count() + 1);
    place.expect(0, &["compare", "rest.csv", "after.csv", "--atol", "1e-9"]);
}
