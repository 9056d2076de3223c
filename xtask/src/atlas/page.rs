//! The page: a table of all entries, and each with its picture, digits, source and command.

use crate::golden::short_number;
use polhode_cases::atlas::{Entry, Group, PeerRun, Published, Record};
use polhode_cases::row::Value;
use std::fmt::Write as _;

/// The page, from the root of the workspace.
pub(super) const DOCUMENT: &str = "docs/atlas.md";

/// What stands before the entries.
const INTRODUCTION: &str = "# Atlas of published results

Results of mechanics that others have published, each as a scene, a number with its digits, and what this engine gives.
A number is right when it rounds to the printed digits; where a source gives a bound or an error, when it is within it.
`cargo xtask verify --only atlas` measures all of them, and fails where one is not, or is another one than that
recorded here; `cargo xtask atlas` writes this page from what is recorded. The commands below show each number with the
program `polhode`, or the case of `cargo xtask verify` that measures it. The sources are told in
[References](REFERENCES.md).
";

/// The page.
pub(super) fn text(groups: &[Group], record: &Record, peers: &[PeerRun]) -> String {
    let entries: Vec<&Entry> = groups.iter().flat_map(|group| &group.entries).collect();
    let numbers: usize = entries.iter().map(|entry| entry.quantities.len()).sum();
    let mut text = INTRODUCTION.to_owned();
    let _ = write!(text, "\n{} results, {numbers} numbers.\n", entries.len());
    text.push_str(&others(&entries, peers));
    text.push_str("\n## All of them\n\n| result | published | polhode | error |\n|---|---|---|---|\n");
    for entry in &entries {
        let lines = lines(entry, record);
        let title = format!("[{}](#{})", entry.title, anchor(&entry.title));
        for (number, line) in lines.iter().enumerate() {
            let first = if number == 0 { title.as_str() } else { "" };
            let _ = writeln!(text, "| {first} | {} | {} | {} |", line.published, line.found, line.error);
        }
    }
    for group in groups {
        let _ = write!(text, "\n## {}\n\n{}\n", group.title, group.about);
        for entry in &group.entries {
            text.push_str(&section(entry, record, peers));
        }
    }
    text
}

/// Results in which other engines are nearer come first.
fn others(entries: &[&Entry], peers: &[PeerRun]) -> String {
    let with: Vec<&&Entry> = entries.iter().filter(|entry| !entry.peers.is_empty()).collect();
    let mut text = "\n## Where other engines are nearer\n\n".to_owned();
    let mut nearer = String::new();
    for (entry, scene) in with.iter().flat_map(|entry| entry.peers.iter().map(move |scene| (entry, scene))) {
        let runs = || peers.iter().filter(move |run| run.scene == *scene);
        let own = runs().find(|run| run.is_most_accurate_own()).and_then(PeerRun::number).unwrap_or(f64::INFINITY);
        for run in runs().filter(|run| !run.is_own() && run.number().is_some_and(|error| error < own)) {
            let _ = writeln!(
                nearer,
                "- [{}](#{}): {}, {} where polhode is {own:.1e} off",
                entry.title,
                anchor(&entry.title),
                run.engine,
                run.error
            );
        }
    }
    if nearer.is_empty() {
        let _ = writeln!(
            text,
            "In none of the {} results below that other engines were run on, with the tier `accurate`. Where the \
             other tiers of polhode are farther off than they, and where others take less time, [Beside other \
             engines](peers.md) says first. On the other results no engine but this one was run.",
            with.len()
        );
    }
    text + &nearer
}

/// What other engines give, and this one by its other tiers.
fn beside(entry: &Entry, peers: &[PeerRun]) -> String {
    let mut text = String::new();
    for scene in &entry.peers {
        let _ = write!(
            text,
            "\nOther engines on the scene *{scene}* of [Beside other engines](peers.md), which says what \
             the error is of, with their settings; states in `peers/recorded`:\n\n| engine | error |\n|---|---|\n"
        );
        for run in peers.iter().filter(|run| run.scene == *scene) {
            let _ = writeln!(text, "| {} | {} |", run.engine, run.error);
        }
    }
    text
}

/// A line of a table.
struct Line {
    quantity: String,
    published: String,
    found: String,
    error: String,
}

fn lines(entry: &Entry, record: &Record) -> Vec<Line> {
    let none = Vec::new();
    let found = record.found.get(&entry.name).unwrap_or(&none);
    let line = |(number, (quantity, published)): (usize, (&String, &Published))| {
        let own = found.get(number);
        Line {
            quantity: quantity.clone(),
            published: published.to_string(),
            found: own.map_or_else(|| "not measured".to_owned(), words),
            error: own.and_then(|own| published.error(own)).map_or_else(String::new, |error| match error {
                0.0 => "0".to_owned(),
                error => format!("{error:.1e}"),
            }),
        }
    };
    entry.quantities.iter().zip(&entry.published).enumerate().map(line).collect()
}

fn words(value: &Value) -> String {
    match value {
        Value::Number(number) => short_number(*number),
        Value::Count(count) => count.to_string(),
        Value::Text(text) => text.clone(),
        other => format!("{other:?}"),
    }
}

fn section(entry: &Entry, record: &Record, peers: &[PeerRun]) -> String {
    let mut text = format!("\n### {}\n\n", entry.title);
    if let Some(scene) = entry.scene() {
        let _ = write!(text, "![{}](gallery/{scene}.png)\n\n", entry.title);
    }
    let _ = write!(text, "{}\n\n| quantity | published | polhode | error |\n|---|---|---|---|\n", entry.plain);
    for line in lines(entry, record) {
        let _ = writeln!(text, "| {} | {} | {} | {} |", line.quantity, line.published, line.found, line.error);
    }
    let place = entry.place.as_ref().map_or_else(String::new, |place| format!(", {place}"));
    let _ = write!(text, "\nSource: {}{place}.\n", entry.source);
    let mut commands: Vec<String> = Vec::new();
    for reading in &entry.readings {
        let command = reading.command();
        if !command.is_empty() && !commands.contains(&command) {
            commands.push(command);
        }
    }
    if commands.is_empty() {
        commands.push(format!("cargo xtask verify --only \"atlas {}\"", entry.name));
    }
    text.push('\n');
    for command in &commands {
        let _ = writeln!(text, "- `{command}`");
    }
    text.push_str(&beside(entry, peers));
    text
}

/// The anchor of a heading.
fn anchor(title: &str) -> String {
    let kept = title.to_lowercase().replace(' ', "-");
    kept.chars().filter(|letter| letter.is_alphanumeric() || *letter == '-').collect()
}
