//! Puts the shipped scenes, their groups and their meshes inside the program: a list of names and texts, made from the
//! folders.

use std::ffi::OsStr;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Endings of mesh files.
const MESHES: [&str; 4] = ["obj", "off", "ply", "stl"];

fn main() -> io::Result<()> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    // A published package holds the files themselves, in the workspace links to folders stand in their place. Where a
    // system has no such links, the workspace has the folders.
    let inside = package.join("fixtures");
    let fixtures = if inside.join("scenes").is_dir() { inside } else { package.join("../../fixtures") };
    let scenes = list(&fixtures.join("scenes"), &["toml"], "SCENES", "&str", "include_str!", "")?;
    let meshes = list(&fixtures.join("meshes"), &MESHES, "MESHES", "&[u8]", "include_bytes!", "../meshes/")?;
    let groups = fixtures.join("groups.toml");
    println!("cargo::rerun-if-changed={}", groups.display());
    let groups = format!("pub(crate) const GROUPS: &str = include_str!({:?});\n", groups.display().to_string());
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("OUT_DIR is not set"))?;
    fs::write(PathBuf::from(out).join("examples.rs"), scenes + &meshes + &groups)
}

/// A constant of the files of a folder with one of these endings, sorted: pages and results that a user has written
/// beside them are none of the program's. Scenes by their names without the ending, meshes as scenes name them.
fn list(
    folder: &Path,
    endings: &[&str],
    constant: &str,
    content: &str,
    include: &str,
    prefix: &str,
) -> io::Result<String> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut files: Vec<PathBuf> = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    files.retain(|file| file.extension().and_then(OsStr::to_str).is_some_and(|ending| endings.contains(&ending)));
    files.sort();
    let mut text = format!("pub(crate) const {constant}: &[(&str, {content})] = &[\n");
    for file in files {
        let name = if prefix.is_empty() { file.file_stem() } else { file.file_name() };
        let name = name.unwrap_or_default().to_string_lossy();
        let _ = writeln!(text, "    ({:?}, {include}({:?})),", format!("{prefix}{name}"), file.display().to_string());
    }
    text.push_str("];\n");
    Ok(text)
}
