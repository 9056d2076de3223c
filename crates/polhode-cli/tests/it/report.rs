//! The report of a run as text: its first eight lines answer, what is absent is left out, and the rest comes by
//! `--full`.
//!
//! Shown by a run that is right, one that is wrong and one of which that is not known, so that a reader who stops after
//! eight lines knows which of them it is; and by whole reports, in which no row may end in a zero that says "there is
//! none".

use crate::{FLIGHT, Place};
use std::fmt::Write as _;

/// The first lines of a report, with one space between words.
fn first_lines(text: &str) -> Vec<String> {
    text.lines().take(8).map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

/// The line that begins so.
fn line<'a>(lines: &'a [String], label: &str) -> &'a str {
    let found = lines.iter().find_map(|line| line.strip_prefix(label));
    found.unwrap_or_else(|| panic!("no line begins with {label}: {lines:#?}"))
}

/// A run that is right: to how much, which body, when, and by what it was compared. There is nothing to do.
#[test]
fn the_first_lines_of_a_run_that_is_right() {
    let args = ["run", "example:double-pendulum", "--duration", "0.5", "--set", "promise.error=1e-6"];
    let lines = first_lines(&Place::new().expect(0, &args).stdout);
    assert_eq!(lines[0], "scene double-pendulum: A double pendulum");
    assert!(line(&lines, "simulated ").starts_with("0.5 of 0.5 s, completed; it took "), "{lines:#?}");
    let right = line(&lines, "is it right ");
    for part in
        ["yes: estimated error ", " of a body's size, where 1e-6 is promised; farthest off is ", " m", "at t = "]
    {
        assert!(right.contains(part), "{part}: {right}");
    }
    assert!(line(&lines, "compared with ").contains("other steps (steps of "), "{lines:#?}");
    assert!(
        line(&lines, "what limits it ").starts_with("nothing is beyond its limit; closest to it is "),
        "{lines:#?}"
    );
    assert!(lines.iter().all(|line| !line.starts_with("what to do")), "{lines:#?}");
}

/// A run whose estimated error is beyond what is promised: it says no, what limits it, and what to do, and each of them
/// once.
#[test]
fn the_first_lines_of_a_run_that_is_wrong() {
    let args = ["run", "example:double-pendulum", "--tier", "stepped", "--duration", "0.5", "--set"];
    let text = Place::new().expect(1, &[&args[..], &["promise.error=1e-9"]].concat()).stdout;
    let lines = first_lines(&text);
    assert!(line(&lines, "simulated ").starts_with("0.5 of 0.5 s, degraded; it took "), "{lines:#?}");
    let right = line(&lines, "is it right ");
    assert!(right.starts_with("no: estimated error ") && right.contains("where 1e-9 is promised"), "{right}");
    let limit = line(&lines, "what limits it ");
    assert!(limit.starts_with("the estimated error, ") && limit.ends_with(" times what is promised"), "{limit}");
    assert!(line(&lines, "what to do ").contains("method.tier = \"accurate\""), "{lines:#?}");
    assert!(!text.contains("the promised limit is"), "{text}");
}

/// Another limit that is exceeded stands there in words, with its cure; the other warnings stand right below.
#[test]
fn the_first_lines_of_a_run_beyond_other_limits() {
    let args = ["run", "example:box-drop-vibrating", "--duration", "1", "--set", "promise.error=10"];
    let text = Place::new().expect(1, &args).stdout;
    let lines = first_lines(&text);
    let limit = line(&lines, "what limits it ");
    assert!(limit.contains("the promised limit is") && limit.contains("exceeded"), "{limit}");
    assert!(line(&lines, "what to do ").contains("a shorter method.step would help"), "{lines:#?}");
    let [warning, happened] = ["\nwarning: ", "\nwhat happened\n"].map(|part| text.find(part));
    assert!(warning.is_some() && warning < happened, "{text}");
}

/// A run of which it is not known: why, and how to know it.
#[test]
fn the_first_lines_of_a_run_whose_error_is_not_known() {
    let place = Place::with_scene(FLIGHT);
    let lines = first_lines(&place.expect(0, &["run", "scene.toml", "--error", "off"]).stdout);
    assert_eq!(line(&lines, "is it right "), "not known: the error was not estimated (--error off)");
    assert_eq!(line(&lines, "what to do "), "--error quick estimates the error");
    assert!(lines.iter().all(|line| !line.starts_with("compared with")), "{lines:#?}");
}

/// Where rounding has grown to a hundredth of a body within the run, a line says so.
#[test]
fn the_horizon_stands_in_the_first_lines() {
    let mut scene = "format = 1\nduration = 60\ngravity = [0, 0, 0]\n[materials.ivory]\nrestitution = 1\n".to_owned();
    for (name, normal) in
        [("east", "[-1, 0, 0]"), ("west", "[1, 0, 0]"), ("north", "[0, -1, 0]"), ("south", "[0, 1, 0]")]
    {
        let far = normal.replace("-1", "2").replace('1', "-1").replace('2', "1");
        let _ = write!(
            scene,
            "[[bodies]]\nname = \"{name}\"\nfixed = true\nmaterial = \"ivory\"\n\
             shape.half_space.normal = {normal}\nposition = {far}\n"
        );
    }
    for (name, rest) in [
        ("post", "fixed = true\nshape.sphere.radius = 0.3\nposition = [-0.3, -0.2, 0]\n"),
        ("ball", "mass = 1\nshape.sphere.radius = 0.05\nposition = [0.3, -0.5, 0]\nvelocity = [1.3, 1.7, 0]\n"),
    ] {
        let _ = write!(scene, "[[bodies]]\nname = \"{name}\"\nmaterial = \"ivory\"\n{rest}");
    }
    let place = Place::new();
    place.write("scene.toml", &scene);
    let run = place.run(&["run", "scene.toml", "--error", "full"]);
    let lines = first_lines(&run.stdout);
    let until = line(&lines, "until when ");
    assert!(until.starts_with("what lies after t = ") && until.contains("s is one of many outcomes"), "{until}");
}

/// The whole report has what the short one leaves out.
#[test]
fn the_rest_comes_by_full() {
    let place = Place::new();
    let args = ["run", "example:box-drop", "--duration", "1"];
    let [short, full] = [&[][..], &["--full"]].map(|more| place.expect(0, &[&args[..], more].concat()).stdout);
    let parts = ["\ncertificate (largest of the run)\n", "\nledger (lost", "\nledger of momentum (lost", "\nplan\n"];
    for part in parts.into_iter().chain(["\neffects\n", "\ncompared with\n", "  numerical loss ", "  impact  "]) {
        assert!(full.contains(part) && !short.contains(part), "{part}\n{full}");
    }
    for part in ["\nwhat happened\n", "\nat the end\n", "\nenergy\n"] {
        assert!(full.contains(part) && short.contains(part), "{part}\n{short}");
    }
    assert!(short.ends_with("plan, effects, certificate and ledgers: --full\n"), "{short}");
    assert!(short.lines().count() <= 30, "{short}");
}

/// A report on stderr, where stdout holds the trajectory, is the same one, and a run that goes on has it too.
#[test]
fn the_same_report_beside_a_trajectory_and_of_a_run_that_goes_on() {
    let place = Place::with_scene(FLIGHT);
    let run = place.expect(0, &["run", "scene.toml", "-o", "-", "--checkpoint", "a.checkpoint"]);
    assert!(run.stderr.contains("\n  is it right ") && !run.stderr.contains("\ncertificate"), "{}", run.stderr);
    let resumed = place.expect(0, &["resume", "a.checkpoint", "--duration", "0.75"]).stdout;
    assert!(resumed.contains("0.75 of 0.75 s, completed") && !resumed.contains("\ncertificate"), "{resumed}");
    let resumed = place.expect(0, &["resume", "a.checkpoint", "--duration", "1", "--full"]).stdout;
    assert!(resumed.contains("\ncertificate"), "{resumed}");
}

/// No row says "there is none" by a zero, nor that something was not measured; where nothing is left, words say so.
#[test]
fn what_is_absent_is_left_out() {
    let place = Place::new();
    let mut told = String::new();
    for scene in ["newtons-cradle", "box-drop", "diamond-4", "double-pendulum", "penalty-bounce", "fast-pyramid"] {
        for full in [&[][..], &["--full"]] {
            let scene = format!("example:{scene}");
            let text = place.run(&[&["run", &scene, "--duration", "0.3"][..], full].concat()).stdout;
            // The plan has its own words.
            let report = text.split("\nplan\n").next().unwrap();
            for line in report.lines() {
                let words: Vec<&str> = line.split_whitespace().filter(|word| !is_unit(word)).collect();
                assert!(words.last() != Some(&"0") && !line.contains("not measured"), "{scene}: {line}");
                assert!(!line.contains(" 0 m,") && !line.contains(" 0 J ("), "{scene}: {line}");
            }
            told.push_str(report);
        }
    }
    for words in ["nothing was lost, and no limit was touched", "nothing was lost, and nothing was given"] {
        assert!(told.contains(words), "{words}");
    }
}

/// Units that may stand behind a number.
fn is_unit(word: &str) -> bool {
    ["J", "m", "rad", "s"].contains(&word)
}
