//! The step of a verification that runs the committed engine.

use super::{DIST, ENGINE, LARGEST_ENGINE, LARGEST_PAGE};
use crate::golden;
use crate::viewer::Node;
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Name of the step, as of a case.
pub(crate) const NAME: &str = "playground";

/// The scenes whose hashes are compared: flight and rotation, impacts by several laws, friction, stacks, joints,
/// springs, a track, and each tier that the page offers.
const SCENES: [&str; 10] = [
    "bouncing-ball",
    "box-drop",
    "dzhanibekov",
    "newtons-cradle",
    "double-pendulum",
    "fast-pyramid",
    "painleve-rod",
    "slider-crank",
    "roller-coaster",
    "dominoes",
];

/// What to do about other bits.
const BUILD: &str = "run `cargo xtask playground` and commit what it writes";

/// Exit codes of the checks in a browser: all passed, and some failed.
const CHECKED: [Option<i32>; 2] = [Some(0), Some(1)];

/// Runs the committed engine by node and in a browser.
pub(crate) fn check(context: &Context) -> Vec<Row> {
    guarded(NAME, || rows(context))
}

fn rows(context: &Context) -> CaseResult {
    let size = fs::metadata(context.root.join(DIST).join(ENGINE))?.len();
    let mut rows = vec![Row::at_most(NAME, "size of the packed engine, bytes", LARGEST_ENGINE as f64, size as f64)];
    let node = match Node::with_packages(&context.root) {
        Ok(node) => node,
        Err(reason) => {
            rows.push(Row::skipped(NAME, "hashes of shipped scenes by the committed engine", &reason));
            return Ok(rows);
        }
    };
    let mut scenes = Vec::new();
    for scene in SCENES {
        scenes.push((scene, format!("{:016x}", golden::stored_hash(&context.root, scene)?)));
    }
    let mut command = node.script("test/play_engine.mjs");
    command.args(SCENES.map(|scene| context.shipped.path(scene)));
    let printed = succeeded(command.output()?)?;
    for ((scene, hash), line) in scenes.iter().zip(printed.lines()) {
        rows.push(Row::exact(NAME, &format!("{scene}: hash by node, else {BUILD}"), hash.as_str(), line));
    }
    match node.browser() {
        Ok(browser) => rows.extend(in_browser(context, &node, &browser)?),
        Err(reason) => rows.push(Row::skipped(NAME, "the page in a browser", &reason)),
    }
    Ok(rows)
}

/// The page of the program in a browser, with the hashes of the scenes there.
fn in_browser(context: &Context, node: &Node, browser: &Path) -> CaseResult {
    let folder = tempfile::tempdir()?;
    let page = folder.path().join("play.html");
    let mut command = Command::new(context.program.path(&context.root)?);
    command.arg("play").arg(context.shipped.path("box-drop")).arg("-o").arg(&page);
    succeeded(command.output()?)?;
    let size = fs::metadata(&page)?.len();
    let mut rows = vec![Row::at_most(NAME, "size of a page, bytes", LARGEST_PAGE as f64, size as f64)];
    let mut command = node.script("test/play.mjs");
    command.env("CHROMIUM", browser).arg(&page);
    for scene in SCENES {
        let hash = golden::stored_hash(&context.root, scene)?;
        command.arg(format!("{hash:016x}={}", context.shipped.path(scene).display()));
    }
    let output = command.output()?;
    if !CHECKED.contains(&output.status.code()) {
        return Err(format!("the checks in the browser broke off: {}", String::from_utf8_lossy(&output.stderr)).into());
    }
    for line in String::from_utf8(output.stdout)?.lines() {
        let Some((verdict, what)) = line.split_once(' ') else { continue };
        rows.push(match verdict {
            "info" => Row::info(NAME, what, "", ""),
            verdict => Row::exact(NAME, what, "ok", verdict),
        });
    }
    Ok(rows)
}

/// What a command has printed that must succeed.
fn succeeded(output: Output) -> Result<String, String> {
    if output.status.success() {
        return String::from_utf8(output.stdout).map_err(|error| error.to_string());
    }
    Err(format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr)))
}
