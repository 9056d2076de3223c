//! Ctrl-C and SIGTERM: what was computed is kept as a readable file, whether the run can end its step or not.
//!
//! Nothing here waits for a time to pass: a signal is sent when the file has grown, and stdout that nobody reads holds
//! a run up within a step for as long as it takes.

use crate::{FLIGHT, Place};
use std::io::{BufRead as _, BufReader};
use std::process::{Child, Command, Stdio};

/// A flight with so many samples that it does not end by itself; they wait for no errors.
fn long_flight() -> Place {
    let text = FLIGHT.replace("duration = 0.5", "duration = 1e5").replace("interval = 0.125", "interval = 1e-4");
    let text = text.replace("format = 1\n", "format = 1\nmethod.error = \"off\"\n");
    Place::with_scene(&text)
}

fn start(place: &Place, args: &[&str]) -> Child {
    place.command(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn signal(child: &Child, name: &str) {
    let sent = Command::new("sh").args(["-c", &format!("kill -{name} {}", child.id())]).status().unwrap();
    assert!(sent.success());
}

/// Waits until a temporary file of this output holds something.
fn wait_for(place: &Place, output: &str) {
    let begins = format!(".{output}.");
    let grows = |name: &String| {
        name.starts_with(&begins) && std::fs::metadata(place.path(name)).is_ok_and(|file| file.len() > 0)
    };
    while !place.list().iter().any(grows) {
        std::thread::yield_now();
    }
}

/// Waits until a run that also writes to stdout, which nobody reads, is held up within a step: the pipe and the buffers
/// before it hold 64 and 9 KiB of the same rows as the CSV file.
fn wait_until_held_up(place: &Place) {
    let held_up = |name: &String| {
        name.starts_with(".a.csv.") && std::fs::metadata(place.path(name)).is_ok_and(|file| file.len() > 70_000)
    };
    while !place.list().iter().any(held_up) {
        std::thread::yield_now();
    }
}

/// Asked to end, a run ends its step and keeps what it has computed; the exit code says who asked.
#[test]
fn a_run_that_is_asked_to_end_keeps_its_results() {
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let place = long_flight();
        let child = start(&place, &["run", "scene.toml", "-o", "a.csv", "-o", "a.npy", "--json"]);
        wait_for(&place, "a.csv");
        signal(&child, name);
        let run: crate::Run = child.wait_with_output().unwrap().into();
        assert_eq!(run.code, Some(code), "{}", run.stderr);
        assert!(run.stderr.contains("note: what was computed is in a.csv.partial"), "{}", run.stderr);
        let value = run.json();
        assert_eq!((value["outcome"].as_str(), value["exit_code"].as_i64()), (Some("interrupted"), Some(code.into())));
        assert_eq!(place.list(), ["a.csv.partial", "a.npy.partial", "scene.toml"]);
        place.expect(0, &["view", "scene.toml", "a.npy.partial", "-o", "page.html"]);
    }
}

/// Asked again while it cannot end its step, the program ends at once, and what has reached the disk is a readable file
/// all the same: whole samples, of every kind of trajectory.
#[test]
fn a_program_that_ends_at_once_keeps_its_results() {
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let place = long_flight();
        let kinds = ["a.csv", "a.npy", "a.json"];
        // Nobody reads stdout: the run waits for room in the pipe, within its step.
        let args = ["run", "scene.toml", "-o", kinds[0], "-o", kinds[1], "-o", kinds[2], "-o", "-"];
        let mut child = start(&place, &args);
        wait_until_held_up(&place);
        for kind in kinds {
            wait_for(&place, kind);
        }
        signal(&child, name);
        let mut said = BufReader::new(child.stderr.take().unwrap()).lines();
        assert!(said.next().unwrap().unwrap().starts_with("note: stopping at the end of this step"));
        signal(&child, name);
        assert_eq!(child.wait().unwrap().code(), Some(code));
        let said: String = said.map(|line| line.unwrap() + "\n").collect();
        for kind in kinds {
            let kept = format!("{kind}.partial");
            assert!(said.contains(&format!("note: what was computed is in {kept}")), "{said}");
            place.expect(0, &["view", "scene.toml", &kept, "-o", "page.html"]);
        }
        assert_eq!(place.list(), ["a.csv.partial", "a.json.partial", "a.npy.partial", "page.html", "scene.toml"]);
    }
}

/// Asked to end while it draws, the program stops after a frame and leaves no file behind: a picture that is cut off is
/// of no use.
#[test]
fn drawing_that_is_asked_to_end_leaves_nothing() {
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let place = Place::with_scene(FLIGHT);
        let child = start(&place, &["view", "scene.toml", "-o", "a.gif", "--fps", "1e9"]);
        wait_for(&place, "a.gif");
        signal(&child, name);
        let run: crate::Run = child.wait_with_output().unwrap().into();
        assert_eq!(run.code, Some(code), "{}", run.stderr);
        // A frame that takes long is not waited for.
        let words = ["a.gif: drawing was stopped after", "interrupted"];
        assert!(words.iter().any(|said| run.stderr.contains(said)), "{}", run.stderr);
        assert_eq!(place.list(), ["scene.toml"]);
    }
}

/// A program that is killed leaves a hidden file behind. The next run of the same output finds it, says so, and makes a
/// readable file of it; one of a picture is removed. Before that `view` shows it as it is.
#[test]
fn what_a_killed_program_left_behind_is_found() {
    let place = long_flight();
    let mut child = start(&place, &["run", "scene.toml", "-o", "a.csv", "-o", "a.npy", "-o", "a.glb"]);
    for name in ["a.csv", "a.npy"] {
        wait_for(&place, name);
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let hidden: Vec<String> = place.list().into_iter().filter(|name| name.starts_with('.')).collect();
    assert_eq!(hidden.len(), 3, "{hidden:?}");
    for name in hidden.iter().filter(|name| !name.starts_with(".a.glb")) {
        let run = place.expect(0, &["view", "scene.toml", name, "-o", "page.html"]);
        // A file of lines may end with a whole one by chance.
        assert!(name.starts_with(".a.csv") || run.stderr.contains("cut off"), "{}", run.stderr);
    }
    let args = ["run", "scene.toml", "--duration", "0.01", "-o", "a.csv", "-o", "a.npy", "-o", "a.glb"];
    let said = place.expect(0, &args).stderr;
    for name in &hidden {
        assert!(said.contains(name.as_str()), "{name}: {said}");
    }
    assert!(said.contains("is now a.csv.partial") && said.contains("of no use"), "{said}");
    let files = ["a.csv", "a.csv.partial", "a.glb", "a.npy", "a.npy.partial", "page.html", "scene.toml"];
    assert_eq!(place.list(), files);
    let run = place.expect(0, &["view", "scene.toml", "a.csv.partial", "-o", "page.html"]);
    assert!(!run.stderr.contains("cut off"), "{}", run.stderr);
    place.expect(0, &["view", "scene.toml", "a.npy.partial", "-o", "page.html"]);
}

/// A study that is asked to end does, and leaves no temporary file behind; so does a page in the middle of a run's
/// step.
#[test]
fn a_study_that_is_asked_to_end_leaves_nothing() {
    for (name, code) in [("INT", 130), ("TERM", 143)] {
        let place = long_flight();
        let args = ["cost", "scene.toml", "--csv", "a.csv", "--svg", "a.svg", "--html", "a.html"];
        let child = start(&place, &args);
        while place.list().len() < 4 {
            std::thread::yield_now();
        }
        signal(&child, name);
        let run: crate::Run = child.wait_with_output().unwrap().into();
        assert_eq!(run.code, Some(code), "{}", run.stderr);
        assert!(run.stderr.contains("interrupted"), "{}", run.stderr);
        assert_eq!(place.list(), ["scene.toml"]);
    }
}

/// A step that does not end holds nothing up: asked once, the program ends, and keeps what has reached the disk.
#[test]
fn a_step_that_does_not_end_is_not_waited_for() {
    let place = long_flight();
    // Nobody reads stdout: the run waits for room in the pipe, within its step.
    let mut child = start(&place, &["run", "scene.toml", "-o", "a.csv", "-o", "page.html", "-o", "-"]);
    wait_until_held_up(&place);
    signal(&child, "TERM");
    assert_eq!(child.wait().unwrap().code(), Some(143));
    assert_eq!(place.list(), ["a.csv.partial", "scene.toml"]);
}
