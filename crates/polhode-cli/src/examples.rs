//! `polhode scenes` and `polhode new`: the shipped scenes, which are inside the program.

use crate::args::NewArgs;
use crate::failure::Failure;
use crate::scene_groups::SceneGroups;
use crate::stdout;
use crate::text::Table;
use polhode_scene::{AtomicFile, load_with_files};
use std::ffi::OsStr;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

include!(concat!(env!("OUT_DIR"), "/examples.rs"));

/// What stands before the name of an example where a scene file can be named.
pub(crate) const PREFIX: &str = "example:";

/// The scene that `polhode new` writes when no example is named.
const FIRST_SCENE: &str = include_str!("new_scene.toml");

/// Least likeness of two names (Jaro and Winkler: 1 for equal ones) at which one is taken for the other.
const LIKE: f64 = 0.8;

/// The text of the example of this name.
///
/// # Errors
/// When there is none.
pub(crate) fn find(name: &str) -> Result<&'static str, Failure> {
    let found = SCENES.iter().find(|(known, _)| *known == name).map(|(_, text)| *text);
    found.ok_or_else(|| {
        let like = SCENES.iter().map(|(known, _)| (strsim::jaro_winkler(name, known), known));
        let nearest = like.max_by(|(a, _), (b, _)| a.total_cmp(b)).filter(|(like, _)| *like >= LIKE);
        let meant = nearest.map_or_else(String::new, |(_, known)| format!("did you mean {PREFIX}{known}? "));
        Failure::Usage(format!("error: no example is named `{name}`: {meant}`polhode scenes` lists them"))
    })
}

/// Prints the names of the examples in groups, each with its title; one that shows a fault stands below the one without
/// it.
pub(crate) fn scenes() -> Result<(), Failure> {
    let groups = SceneGroups::read(GROUPS)?;
    let title = |name: &str| Ok::<_, Failure>(load_with_files(name, find(name)?, MESHES, &[])?.title());
    let mut text = String::new();
    for group in &groups.groups {
        let mut table = Table::default();
        for name in &group.scenes {
            table.row([name, &title(name)?]);
            for wrong in groups.wrong_versions(name) {
                table.row([wrong, &format!("wrong version of {name}: {}", title(wrong)?)]);
            }
        }
        let _ = write!(text, "{}: {}\n{}\n", group.title, group.about, table.print());
    }
    text.push_str("Run one: polhode run example:diamond-4; begin with one: polhode new my-scene --from diamond-4\n");
    stdout::text(&text)
}

/// Writes a commented scene, and the meshes of an example beside it; what stands there stays.
pub(crate) fn new(args: &NewArgs) -> Result<(), Failure> {
    let name = args.name.strip_suffix(".toml").unwrap_or(&args.name);
    let path = PathBuf::from(format!("{name}.toml"));
    let Some(stem) =
        path.file_stem().and_then(OsStr::to_str).filter(|stem| stem.contains(|c| c != '.') && *stem != ".toml")
    else {
        return Err(Failure::Usage(format!("error: {}: this names no scene: give a name such as my-scene", args.name)));
    };
    let text = match &args.from {
        Some(example) => find(example.strip_prefix(PREFIX).unwrap_or(example))?,
        None => FIRST_SCENE,
    };
    let meshes: Vec<_> = MESHES.iter().filter(|(mesh, _)| text.contains(&format!("\"{mesh}\""))).collect();
    let mut text = named(text, stem);
    let mut files = Vec::new();
    for (mesh, bytes) in meshes {
        let own = Path::new(mesh).file_name().unwrap_or_default().to_string_lossy().into_owned();
        text = text.replace(mesh, &own);
        files.push((path.with_file_name(own), *bytes));
    }
    files.push((path.clone(), text.as_bytes()));
    if let Some((there, _)) = files.iter().find(|(file, _)| file.exists()) {
        let what = format!("error: {} is there already: give another name, or move it away", there.display());
        return Err(Failure::Usage(what));
    }
    for (file, bytes) in &files {
        let written = AtomicFile::create(file).and_then(|mut open| {
            open.write_all(bytes)?;
            open.commit()
        });
        written.map_err(|error| crate::plots::cannot_write(file, &error))?;
        stdout::text(&format!("{}\n", file.display()))?;
    }
    Ok(())
}

/// The scene under another name: that of the top, which stands before all tables.
fn named(text: &str, name: &str) -> String {
    let mut is_top = true;
    let mut renamed = String::new();
    for line in text.lines() {
        if is_top && line.starts_with("name = ") {
            let _ = writeln!(renamed, "name = {name:?}");
        } else {
            let _ = writeln!(renamed, "{line}");
        }
        is_top &= !line.starts_with('[');
    }
    renamed
}

#[cfg(test)]
mod tests {
    //! Every example loads from inside the program, and its name can be replaced.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]
    use super::*;

    #[test]
    fn examples_load() {
        assert!(SCENES.len() > 30 && MESHES.len() > 2);
        for (name, text) in SCENES {
            load_with_files(name, text, MESHES, &[]).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        load_with_files("new", FIRST_SCENE, &[], &[]).unwrap();
    }

    /// Each example stands in one group, or is the wrong version of one that does.
    #[test]
    fn groups_hold_every_example_once() {
        let groups = SceneGroups::read(GROUPS).unwrap();
        let right = groups.groups.iter().flat_map(|group| &group.scenes).map(String::as_str);
        let mut all: Vec<&str> = right.clone().chain(right.flat_map(|name| groups.wrong_versions(name))).collect();
        all.sort_unstable();
        let mut shipped: Vec<&str> = SCENES.iter().map(|(name, _)| *name).collect();
        shipped.sort_unstable();
        assert_eq!(all, shipped);
    }

    #[test]
    fn a_scene_gets_its_name() {
        for (name, text) in SCENES {
            let loaded = load_with_files("x", &named(text, "mine"), MESHES, &[]).unwrap();
            assert_eq!(loaded.scene.name(), "mine", "{name}");
        }
    }
}
