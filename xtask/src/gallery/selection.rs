//! Which stills there are and which show the videos of the thesis: `fixtures/gallery.toml`.

use serde::Deserialize;
use std::error::Error;
use std::path::Path;

/// The file, from the root of the workspace.
pub(super) const FILE: &str = "fixtures/gallery.toml";

/// Videos and stills.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Selection {
    /// The videos of the thesis, in order.
    pub(super) videos: Vec<Video>,
    /// The stills, in the order in which scenes are shown that are no videos.
    pub(super) stills: Vec<Still>,
}

/// A video of the thesis.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Video {
    /// Its number.
    pub(super) number: usize,
    /// What it is about.
    pub(super) subject: String,
    /// The still of the scene that has the fault which the video shows, when it shows one.
    pub(super) wrong: Option<String>,
    /// The still of the scene without it.
    pub(super) right: String,
}

/// A still.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Still {
    /// Name of its file, without ending.
    pub(super) name: String,
    /// The scene, when its name is another.
    scene: Option<String>,
    /// When, s; the nearest sample is drawn.
    #[serde(rename = "time")]
    pub(super) time_s: f64,
}

impl Still {
    /// The scene that it is of.
    pub(super) fn scene(&self) -> &str {
        self.scene.as_deref().unwrap_or(&self.name)
    }

    /// Name of its file.
    pub(super) fn file(&self) -> String {
        format!("{}.png", self.name)
    }
}

impl Video {
    /// The name of the page that plays its two versions beside each other.
    pub(super) fn page(&self) -> String {
        format!("video-{:02}", self.number)
    }
}

impl Selection {
    /// Reads it.
    ///
    /// # Errors
    /// When the file cannot be read, or a video names a still that is none.
    pub(super) fn read(root: &Path) -> Result<Self, Box<dyn Error>> {
        let text = std::fs::read_to_string(root.join(FILE)).map_err(|error| format!("{FILE}: {error}"))?;
        let selection: Self = toml::from_str(&text).map_err(|error| format!("{FILE}: {error}"))?;
        for video in &selection.videos {
            for name in video.wrong.iter().chain([&video.right]) {
                selection.still(name).ok_or_else(|| format!("{FILE}: video {}: no still {name}", video.number))?;
            }
        }
        Ok(selection)
    }

    /// The still of this name: of a scene's name, the one that shows it where it stands alone.
    pub(super) fn still(&self, name: &str) -> Option<&Still> {
        self.stills.iter().find(|still| still.name == name)
    }

    /// The stills of a video, the wrong one first.
    pub(super) fn of_video(&self, video: &Video) -> Vec<&Still> {
        video.wrong.iter().chain([&video.right]).filter_map(|name| self.still(name)).collect()
    }

    /// The stills of scenes that show no video.
    pub(super) fn others(&self) -> Vec<&Still> {
        let shown: Vec<&str> = self.videos.iter().flat_map(|video| self.of_video(video)).map(Still::scene).collect();
        self.stills.iter().filter(|still| !shown.contains(&still.scene())).collect()
    }
}

#[cfg(test)]
mod tests {
    //! The videos are fifteen, and files of stills differ.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn fifteen_videos_and_stills_that_differ() {
        let selection = Selection::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).unwrap();
        let numbers: Vec<usize> = selection.videos.iter().map(|video| video.number).collect();
        assert_eq!(numbers, (1..=15).collect::<Vec<_>>());
        let mut names: Vec<&str> = selection.stills.iter().map(|still| still.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), selection.stills.len());
    }
}
