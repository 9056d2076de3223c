//! Rows of `cargo xtask verify`: the page is what the command writes, sources are told, scenes ship.

use super::page::{self, DOCUMENT};
use polhode_cases::atlas::{Entry, Group, Record, groups, peer_runs};
use polhode_cases::row::Row;
use polhode_cases::{CaseResult, Context, guarded};

/// Name of the rows, as of a case.
pub(crate) const PAGE_CASE: &str = "atlas page";

/// Where sources are told.
const SOURCES: &str = "docs/REFERENCES.md";

/// Whether the page is fresh, and what its entries name is there.
pub(crate) fn check_page(context: &Context) -> Vec<Row> {
    guarded(PAGE_CASE, || rows(context))
}

fn rows(context: &Context) -> CaseResult {
    let groups = groups(&context.root)?;
    let record = Record::read(&context.root)?;
    let entries: Vec<&Entry> = groups.iter().flat_map(|group: &Group| &group.entries).collect();
    let written = std::fs::read_to_string(context.root.join(DOCUMENT)).unwrap_or_default();
    let sources = std::fs::read_to_string(context.root.join(SOURCES))?;
    let scenes = context.shipped.names()?;
    let peers = peer_runs(&context.root)?;
    let without = |is_wrong: &dyn Fn(&Entry) -> bool| -> String {
        let names: Vec<&str> =
            entries.iter().filter(|entry| is_wrong(entry)).map(|entry| entry.name.as_str()).collect();
        names.join(", ")
    };
    let has_no_source = |entry: &Entry| !sources.contains(&format!("**{}**", entry.source));
    let has_no_scene = |entry: &Entry| entry.scene().is_some_and(|scene| !scenes.iter().any(|own| own == scene));
    let is_fresh = written == page::text(&groups, &record, &peers);
    let mut fresh = Row::exact(PAGE_CASE, "the page is what the command writes", true, is_fresh);
    fresh.note = (!is_fresh).then(|| "run cargo xtask atlas and look at what it changes".to_owned());
    let has_no_peers = |entry: &Entry| entry.peers.iter().any(|scene| !peers.iter().any(|run| run.scene == *scene));
    Ok(vec![
        fresh,
        Row::exact(PAGE_CASE, "entries with a scene that no other engine was run on", "", without(&has_no_peers)),
        Row::exact(PAGE_CASE, "entries whose source docs/REFERENCES.md does not have", "", without(&has_no_source)),
        Row::exact(PAGE_CASE, "entries whose scene does not ship", "", without(&has_no_scene)),
    ])
}
