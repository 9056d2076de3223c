//! The example lines below the help of every subcommand run as they are printed, in a shell, in a folder that holds the
//! files they name.

use crate::{FLIGHT, Place, Run};
use std::path::Path;
use std::process::Command;

/// A folder with the files that examples name, and a home for completions.
fn furnished() -> Place {
    // The time that `view --still t=1.5` shows is one of the motion.
    let scene = FLIGHT.replace("stone, \\\"flat\\\"", "brick").replace("duration = 0.5", "duration = 2");
    let place = Place::with_scene(&scene);
    for name in ["motion.csv", "a.csv", "b.csv"] {
        place.expect(0, &["run", "scene.toml", "-o", name]);
    }
    // A free flight is one step, unless all effects are on.
    place.expect(0, &["run", "scene.toml", "--effects", "all", "--checkpoint-every", "1"]);
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let triangles = [[1, 3, 2], [1, 2, 4], [1, 4, 3], [2, 3, 4]];
    let corner = |[x, y, z]: [i32; 3]| format!("v {x} {y} {z}\n");
    let triangle = |[a, b, c]: [usize; 3]| format!("f {a} {b} {c}\n");
    let text: String = corners.map(corner).into_iter().chain(triangles.map(triangle)).collect();
    place.write("part.obj", &text);
    place.expect(0, &["mesh", "part.obj", "-o", "part.stl"]);
    for folder in [".local/share/bash-completion/completions", ".zfunc"] {
        std::fs::create_dir_all(place.path(folder)).unwrap();
    }
    place
}

/// A line of a shell, where `polhode` is the program under test.
fn in_shell(place: &Place, line: &str) -> Run {
    let folder = Path::new(env!("CARGO_BIN_EXE_polhode")).parent().unwrap();
    let path = format!("{}:{}", folder.display(), std::env::var("PATH").unwrap());
    let mut shell = Command::new("sh");
    shell.args(["-c", line]).env("PATH", path).env("HOME", place.path("")).current_dir(place.path(""));
    shell.output().unwrap().into()
}

/// The lines that a help ends with.
fn examples(help: &str) -> Vec<&str> {
    let shown = help.split_once("\nExample").map_or("", |(_, shown)| shown);
    shown.lines().filter_map(|line| line.strip_prefix("  ")).filter(|line| line.starts_with("polhode ")).collect()
}

#[test]
fn examples_of_every_help_run_as_printed() {
    let place = Place::new();
    let help = place.expect(0, &["--help"]).stdout;
    let commands = help.split_once("Commands:\n").unwrap().1.split("\n\n").next().unwrap();
    for command in commands.lines().filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help") {
        let help = place.expect(0, &[command, "--help"]).stdout;
        let lines = examples(&help);
        assert!(!lines.is_empty(), "no example below the help of {command}\n{help}");
        for line in lines {
            let run = in_shell(&furnished(), line);
            assert_eq!(run.code, Some(0), "{line}\n{}{}", run.stdout, run.stderr);
        }
    }
}
