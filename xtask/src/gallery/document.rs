//! The document with the stills: the videos of the thesis first, then all other scenes in groups, each with a moving
//! picture.

use super::selection::Still;
use super::shown::{Shown, ShownScenes};
use std::fmt::Write as _;

/// What stands before the stills.
const INTRODUCTION: &str = "# Gallery

The scenes in `fixtures/scenes`, each by a still of `polhode view`, and a moving picture of each group of them, made by
`cargo xtask gallery`; `polhode scenes` prints the groups. That command also
builds a page of them all, with a viewer of each and the figures of its run: open `target/gallery/index.html` in a
browser. `polhode view fixtures/scenes/NAME.toml` makes the viewer of one scene.

## The videos of the thesis

Fifteen videos came with the thesis. Where one shows a fault, the scene that has it stands on the left and the scene
without it on the right; `polhode view fixtures/scenes/LEFT.toml fixtures/scenes/RIGHT.toml` plays the two beside each
other. The text of the thesis names the fault of each video, and bodies and numbers of some only: where it is silent the
scenes have their own.
";

/// Stills beside each other in a group.
const COLUMNS: usize = 2;

/// The document.
pub(super) fn text(shown: &ShownScenes) -> String {
    let mut text = INTRODUCTION.to_owned();
    for video in &shown.selection.videos {
        let _ = write!(text, "\n### Video {}: {}\n\n", video.number, video.subject);
        text.push_str(&table(&shown.selection.of_video(video), shown));
    }
    for group in &shown.groups.groups {
        let _ = write!(text, "\n## {}\n\n{}\n", group.title, group.about);
        if let Some(scene) = shown.scenes.get(&group.moving) {
            let title = scene.loaded.title();
            let _ = write!(text, "\n![{title}](gallery/{}) \\\n**{title}** (`{}`).\n", group.file(), group.moving);
        }
        for row in shown.groups.rows(group, &shown.selection, COLUMNS) {
            text.push('\n');
            text.push_str(&table(&row, shown));
        }
    }
    text
}

/// Stills beside each other, with what their scenes show below.
fn table(stills: &[&Still], shown: &ShownScenes) -> String {
    let cells = |cell: &dyn Fn(&Still, &Shown) -> String| {
        let cells = stills.iter().filter_map(|still| Some(cell(still, shown.of_still(still)?)));
        format!("| {} |\n", cells.collect::<Vec<_>>().join(" | "))
    };
    let mut text = cells(&|still, shown| {
        let title = shown.loaded.title();
        format!("![{title}](gallery/{})", still.file())
    });
    let _ = writeln!(text, "|{}", "---|".repeat(stills.len()));
    text + &cells(&|still, shown| {
        let (title, description) = (shown.loaded.title(), shown.loaded.description().unwrap_or_default());
        format!("**{title}** (`{}`, t = {} s). {description}", still.scene(), still.time_s).replace('|', "\\|")
    })
}
