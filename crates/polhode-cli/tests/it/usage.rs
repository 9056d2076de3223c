//! Mistakes on the command line, help, and the schema.

use crate::{FLIGHT, Place};
use std::process::Stdio;

/// Unknown commands and arguments are mistakes; help and version are not.
#[test]
fn mistakes_and_help() {
    let place = Place::with_scene(FLIGHT);
    for args in [
        &["frobnicate"][..],
        &[],
        &["run"],
        &["run", "scene.toml", "--speed", "3"],
        &["run", "scene.toml", "--effects", "none"],
        &["run", "scene.toml", "--set", "duration"],
        &["mesh", "a.obj", "--solid", "--hollow"],
        &["mesh", "a.obj", "--mass", "1", "--density", "1"],
        &["compare", "a.csv"],
    ] {
        let run = place.expect(2, args);
        assert!(run.stdout.is_empty() && !run.stderr.is_empty(), "{args:?}");
    }
    for args in [&["--help"][..], &["run", "--help"], &["--version"]] {
        let run = place.expect(0, args);
        assert!(!run.stdout.is_empty() && run.stderr.is_empty(), "{args:?}");
    }
}

/// The schema is JSON.
#[test]
fn schema() {
    let schema = Place::new().expect(0, &["schema"]).json();
    assert_eq!(schema["title"], "Polhode scene, version 1");
}

/// Whoever reads stdout may stop reading: no message, no panic.
#[cfg(unix)]
#[test]
fn closed_stdout() {
    let place = Place::with_scene(FLIGHT);
    for args in [&["schema"][..], &["run", "scene.toml", "-o", "a.csv"], &["--help"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = place.command(args).stdout(writer).stderr(Stdio::piped()).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{args:?}");
        assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    // Files are written all the same.
    assert_eq!(place.read("a.csv").lines().count(), 6);
}

/// A JSON value that cannot be written, because stdout is closed from the start or at the end, is a fault of output:
/// half a value is none.
#[cfg(target_os = "linux")]
#[test]
fn json_to_a_closed_stdout() {
    let place = Place::with_scene(FLIGHT);
    for args in [&["run", "scene.toml", "--json"][..], &["plan", "scene.toml", "--json"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let output = place.command(args).stdout(writer).stderr(Stdio::piped()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(3), "{args:?}: {said}");
        assert!(said.contains("stdout is closed"), "{said}");
        let program = place.command(args);
        let words: Vec<_> = std::iter::once(program.get_program()).chain(program.get_args()).collect();
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", "exec \"$@\" >&-", "sh"]).args(words).current_dir(program.get_current_dir().unwrap());
        let output = shell.stderr(Stdio::piped()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(3), "{args:?}: {said}");
        assert!(said.contains("stdout is closed"), "{said}");
    }
}

/// A full disk under stdout is a fault of output.
#[cfg(target_os = "linux")]
#[test]
fn full_stdout() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Place::new().command(&["schema"]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(3));
}

/// A command with two letters exchanged is recognised, and what is like no command is not.
#[test]
fn mistyped_commands_are_recognised() {
    for (typed, meant) in [("rnu", "'run'"), ("veiw", "'view'"), ("resme", "'resume'"), ("compar", "'compare'")] {
        let said = Place::new().expect(2, &[typed, "scene.toml"]).stderr;
        assert!(said.contains("similar subcommand") && said.contains(meant), "{said}");
    }
    let said = Place::new().expect(2, &["frobnicate"]).stderr;
    assert!(!said.contains("similar"), "{said}");
}

/// Quiet is quiet: no report, no notes; what is asked for as JSON and errors are told all the same.
#[test]
fn quiet_runs_say_nothing() {
    let place = Place::with_scene(FLIGHT);
    let quiet = place.expect(0, &["run", "scene.toml", "-q", "-o", "a.csv", "--checkpoint", "kept"]);
    assert_eq!((quiet.stdout.as_str(), quiet.stderr.as_str()), ("", ""));
    let resumed = place.expect(0, &["resume", "kept", "-q"]);
    assert_eq!((resumed.stdout.as_str(), resumed.stderr.as_str()), ("", ""));
    assert_eq!(place.expect(0, &["run", "scene.toml", "-q", "--json"]).json()["outcome"], "completed");
    assert!(place.expect(3, &["run", "-q", "missing.toml"]).stderr.starts_with("error: "));
}
