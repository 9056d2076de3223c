//! `cargo xtask playground`: builds the engine for pages, its side of the page, and the scripts of the page.

use super::{BINDINGS, DIST, ENGINE};
use lzma_rust2::{LzmaOptions, LzmaWriter};
use polhode_cases::cargo::cargo;
use std::error::Error;
use std::fs;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, ExitCode};

/// The target of pages.
const TARGET: &str = "wasm32-unknown-unknown";

/// What builds need besides a compiler.
const INSTALL: &str = "rustup target add wasm32-unknown-unknown, rustup component add rust-src";

/// The standard library is built for its size too, and a panic ends the engine without words: a quarter of the engine.
const LIBRARY: [&str; 2] = ["-Zbuild-std=std,panic_abort", "-Zbuild-std-features=optimize_for_size"];

/// Registers of two numbers, and no text of a panic.
const FLAGS: &str =
    "-Ctarget-feature=+simd128 -Zunstable-options -Cpanic=immediate-abort -Zlocation-detail=none -Zfmt-debug=shallow";

/// Builds all of it.
///
/// # Errors
/// When a command fails. How large the engine may be is a row of the verification.
pub(crate) fn run(root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let library = ["build", "--package", "polhode-web", "--lib", "--target", TARGET, "--profile", "web"];
    let mut engine = cargo(root);
    // The compiler of a release takes these flags only where it is told that it may.
    let flags = format!("{FLAGS} {}", without_places(root));
    engine.args(library).args(LIBRARY).env("RUSTC_BOOTSTRAP", "1").env("RUSTFLAGS", flags);
    succeeded(&mut engine, &format!("the engine does not build: is the target there? {INSTALL}"))?;
    let made = tempfile::tempdir()?;
    let built = root.join("target").join(TARGET).join("web/polhode_web.wasm");
    let mut tool = cargo(&root.join("xtask/bindgen"));
    tool.args(["run", "--quiet", "--target-dir"])
        .arg(root.join("target/bindgen"))
        .arg("--")
        .arg(&built)
        .arg(made.path());
    succeeded(&mut tool, "the page's side of the engine cannot be made")?;
    let engine = fs::read(made.path().join("polhode_web_bg.wasm"))?;
    let dist = root.join(DIST);
    let packed = packed(&engine)?;
    fs::write(dist.join(ENGINE), &packed)?;
    fs::copy(made.path().join("polhode_web.js"), dist.join(BINDINGS))?;
    let viewer = root.join("crates/polhode-view/viewer");
    succeeded(
        Command::new("node").arg("build.mjs").current_dir(viewer),
        "the scripts cannot be bundled: run `npm ci` there",
    )?;
    println!("{DIST}/{ENGINE}: {} bytes, {} unpacked", packed.len(), engine.len());
    Ok(ExitCode::SUCCESS)
}

/// The engine by LZMA. Codes of instructions are bytes of any address and follow from those before them.
fn packed(engine: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    let options = LzmaOptions { lc: 4, pb: 0, ..LzmaOptions::with_preset(9) };
    let mut packed = LzmaWriter::new_use_header(Vec::new(), &options, Some(engine.len() as u64))?;
    packed.write_all(engine)?;
    Ok(packed.finish()?)
}

/// Flags with which no folder of this machine stands in what is built: panics name their file.
fn without_places(root: &Path) -> String {
    let home = std::env::var("CARGO_HOME").or_else(|_| std::env::var("HOME").map(|home| format!("{home}/.cargo")));
    let home = home.map(|home| format!(" --remap-path-prefix={home}=cargo")).unwrap_or_default();
    format!("--remap-path-prefix={}=polhode{home}", root.display())
}

/// Runs a command that must succeed.
fn succeeded(command: &mut Command, otherwise: &str) -> Result<(), Box<dyn Error>> {
    let status = command.status().map_err(|error| format!("{otherwise} ({error})"))?;
    if status.success() { Ok(()) } else { Err(format!("{otherwise} ({status})").into()) }
}
