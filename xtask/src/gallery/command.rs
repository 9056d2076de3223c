//! `cargo xtask gallery`: stills and document (committed), the page and its viewers (built).

use super::selection::FILE;
use super::shown::ShownScenes;
use super::{document, moving, page, picture, viewer_page};
use clap::Args;
use polhode_cases::{Amount, Context};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Folder of the committed stills, from the root of the workspace.
pub(super) const STILLS_FOLDER: &str = "docs/gallery";
/// The committed document, from the root of the workspace.
pub(super) const DOCUMENT: &str = "docs/gallery.md";

/// What to make.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Folder of the page and its viewers.
    #[arg(short, long, value_name = "DIR", default_value = "target/gallery")]
    output: PathBuf,
    /// Only the stills and the document, which are committed.
    #[arg(long)]
    stills: bool,
}

/// Runs the shipped scenes and writes what shows them.
///
/// # Errors
/// When a scene has no still or does not run to its end, or a file cannot be written.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let context = Context::new(root, Amount::Part)?;
    let shown = ShownScenes::new(&context, |name| eprintln!("gallery: {name}"))?;
    if let Some(name) = shown.unseen().first() {
        return Err(format!("{name} has no still: {FILE} says at what time and from where each is taken").into());
    }
    let folder = root.join(STILLS_FOLDER);
    write_stills(&folder, &shown)?;
    fs::write(root.join(DOCUMENT), document::text(&shown))?;
    if !options.stills {
        let output = root.join(&options.output);
        write_pages(&output, &folder, &shown)?;
        println!("{}", output.join("index.html").display());
    }
    Ok(ExitCode::SUCCESS)
}

/// Writes the stills whose pixels have changed, and removes those that are no longer made.
fn write_stills(folder: &Path, shown: &ShownScenes) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for still in &shown.selection.stills {
        let Some(scene) = shown.of_still(still) else { continue };
        let drawn = picture::draw(still, &scene.loaded, &scene.run)?;
        let path = folder.join(still.file());
        if !picture::read_rgb(&path).is_ok_and(|rgb| rgb == drawn.rgb) {
            eprintln!("gallery: new still {}", still.name);
            fs::write(&path, picture::png(&drawn)?)?;
        }
    }
    for group in &shown.groups.groups {
        let Some(scene) = shown.scenes.get(&group.moving) else { continue };
        let (path, gif) = (folder.join(group.file()), moving::gif(scene)?);
        if !fs::read(&path).is_ok_and(|bytes| bytes == gif) {
            eprintln!("gallery: new moving picture {}", group.moving);
            fs::write(&path, gif)?;
        }
    }
    for name in strangers(folder, shown)? {
        fs::remove_file(folder.join(name))?;
    }
    Ok(())
}

/// Files in the folder of the stills that are none of them, and no moving picture.
///
/// # Errors
/// When the folder cannot be read.
pub(super) fn strangers(folder: &Path, shown: &ShownScenes) -> Result<Vec<String>, Box<dyn Error>> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        let is_still = shown.selection.stills.iter().any(|still| still.file() == name);
        if !is_still && !shown.groups.groups.iter().any(|group| group.file() == name) {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}

/// Writes the page of the gallery, its stills, a viewer of each scene and one of the two versions of each video.
fn write_pages(output: &Path, stills: &Path, shown: &ShownScenes) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(output.join("stills")).map_err(|error| format!("{}: {error}", output.display()))?;
    for still in &shown.selection.stills {
        fs::copy(stills.join(still.file()), output.join("stills").join(still.file()))?;
    }
    for group in &shown.groups.groups {
        fs::copy(stills.join(group.file()), output.join("stills").join(group.file()))?;
    }
    for (name, scene) in &shown.scenes {
        eprintln!("gallery: page of {name}");
        let description = scene.loaded.description().unwrap_or_default();
        let path = output.join(format!("{name}.html"));
        viewer_page::write(&path, &scene.loaded.title(), &description, &[&scene.loaded])?;
    }
    for video in shown.selection.videos.iter().filter(|video| video.wrong.is_some()) {
        let stills = shown.selection.of_video(video);
        let loaded: Vec<_> =
            stills.iter().filter_map(|still| shown.of_still(still)).map(|shown| &shown.loaded).collect();
        let description = loaded.first().and_then(|loaded| loaded.description()).unwrap_or_default();
        eprintln!("gallery: page of video {}", video.number);
        let title = format!("Video {}: {}", video.number, video.subject);
        viewer_page::write(&output.join(format!("{}.html", video.page())), &title, &description, &loaded)?;
    }
    fs::write(output.join("index.html"), page::text(shown))?;
    Ok(())
}
