//! Puts the shipped scenes and their meshes inside the program: a list of names and texts, made from the folders.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    let scenes = list(&fixtures.join("scenes"), "SCENES", "&str", "include_str!", "")?;
    let meshes = list(&fixtures.join("meshes"), "MESHES", "&[u8]", "include_bytes!", "../meshes/")?;
    let out = env::var_os("OUT_DIR").ok_or_else(|| io::Error::other("OUT_DIR is not set"))?;
    fs::write(PathBuf::from(out).join("examples.rs"), scenes + &meshes)
}

/// A constant of the files of a folder, sorted: scenes by their names without the ending, meshes as scenes name them.
fn list(folder: &Path, constant: &str, content: &str, include: &str, prefix: &str) -> io::Result<String> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut files: Vec<PathBuf> = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
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
