//! Rows of `cargo xtask verify`: every shipped scene says what it shows and has a still, and what is committed of the
//! gallery is what the command makes.

use super::command::{DOCUMENT, STILLS_FOLDER, strangers};
use super::groups::Group;
use super::selection::{FILE, Still};
use super::shown::{Shown, ShownScenes};
use super::{document, picture};
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};

/// Name of the rows, as of a case.
pub(crate) const CASE: &str = "gallery";

/// What to do when something committed is not fresh.
const FRESHEN: &str = "run cargo xtask gallery and look at what it changes";

/// Whether the gallery is complete and fresh.
pub(crate) fn check(context: &Context) -> Vec<Row> {
    guarded(CASE, || rows(context))
}

fn rows(context: &Context) -> CaseResult {
    let shown = ShownScenes::new(context, |_| {})?;
    let is_silent =
        |(name, scene): &(&String, &Shown)| scene.loaded.description().is_none() || scene.loaded.title() == **name;
    let silent: Vec<String> = shown.scenes.iter().filter(is_silent).map(|(name, _)| name.clone()).collect();
    let folder = context.root.join(STILLS_FOLDER);
    let is_stale = |still: &&Still| {
        let drawn = shown.of_still(still).and_then(|scene| picture::draw(still, &scene.loaded, &scene.run).ok());
        let committed = picture::read_rgb(&folder.join(still.file())).ok();
        drawn.is_none_or(|drawn| committed.is_none_or(|committed| committed != drawn.rgb))
    };
    let stale: Vec<String> = shown.selection.stills.iter().filter(is_stale).map(|still| still.name.clone()).collect();
    let is_missing = |group: &&Group| !folder.join(group.file()).exists();
    let without: Vec<String> = shown.groups.groups.iter().filter(is_missing).map(Group::file).collect();
    let document = std::fs::read_to_string(context.root.join(DOCUMENT)).unwrap_or_default();
    let stale_document = if document == document::text(&shown) { Vec::new() } else { vec![DOCUMENT.to_owned()] };
    Ok(vec![
        row("shipped scenes without title or description", &silent, "say in each scene what it shows"),
        row("shipped scenes without a still", &shown.unseen(), FILE),
        row("stills that are not, pixel by pixel, what their scenes give", &stale, FRESHEN),
        row("groups without their moving picture", &without, FRESHEN),
        row("files beside the stills that are none", &strangers(&folder, &shown)?, FRESHEN),
        row("documents that are not what the command writes", &stale_document, FRESHEN),
    ])
}

/// That there are none of these.
fn row(quantity: &str, found: &[String], remedy: &str) -> Row {
    let measured = if found.is_empty() { "none".to_owned() } else { found.join(", ") };
    let mut row = Row::exact(CASE, quantity, "none", measured);
    row.note = (!found.is_empty()).then(|| remedy.to_owned());
    row
}
