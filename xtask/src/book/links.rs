//! Links of pages: the file or the heading that each leads to exists.

use super::page::Page;
use std::path::{Component, Path, PathBuf};

/// The summary of the book, which names its pages.
const SUMMARY: &str = "docs/SUMMARY.md";
/// The folder of the book.
const FOLDER: &str = "docs/";

/// Every link of these pages that leads nowhere, and how many there are.
pub(super) fn broken(root: &Path, pages: &[Page]) -> (Vec<String>, usize) {
    let (mut broken, mut count) = (Vec::new(), 0);
    for page in pages {
        let links = page.prose().into_iter().flat_map(|(number, line)| links_in(line).map(move |link| (number, link)));
        for (number, link) in links {
            count += 1;
            if let Some(reason) = fault(root, pages, page, &link) {
                broken.push(format!("{}:{number}: {link}: {reason}", page.path));
            }
        }
    }
    broken.extend(not_in_the_summary(pages));
    (broken, count)
}

/// The targets of the links and pictures of a line; what stands between backticks is no link.
fn links_in(line: &str) -> impl Iterator<Item = String> {
    let text: String = line.split('`').step_by(2).collect::<Vec<_>>().join("`");
    let targets: Vec<String> =
        text.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next()).map(str::to_owned).collect();
    targets.into_iter()
}

/// Why a link leads nowhere.
fn fault(root: &Path, pages: &[Page], page: &Page, link: &str) -> Option<String> {
    if link.contains("://") || link.starts_with("mailto:") {
        return None;
    }
    let (file, heading) = link.split_once('#').map_or((link, None), |(file, heading)| (file, Some(heading)));
    let folder = Path::new(&page.path).parent().unwrap_or(Path::new(""));
    let target = if file.is_empty() { page.path.clone() } else { normal(&folder.join(file)) };
    if !root.join(&target).exists() {
        return Some("there is no such file".to_owned());
    }
    // The built book has the folder of documents alone.
    if page.path.starts_with(FOLDER) && !target.starts_with(FOLDER) {
        return Some("leads out of the book: name the file between backticks instead".to_owned());
    }
    let heading = heading?;
    let Some(shown) = pages.iter().find(|page| page.path == target) else {
        return Some("only pages have headings".to_owned());
    };
    let exists = shown.prose().iter().any(|(_, line)| anchor(line).is_some_and(|anchor| anchor == heading));
    (!exists).then(|| "there is no such heading".to_owned())
}

/// A path without `.` and `..`, with slashes.
fn normal(path: &Path) -> String {
    let mut parts = PathBuf::new();
    for component in path.components() {
        match component {
            Component::ParentDir => {
                parts.pop();
            }
            Component::CurDir => {}
            other => parts.push(other),
        }
    }
    parts.iter().map(|part| part.to_string_lossy()).collect::<Vec<_>>().join("/")
}

/// The anchor of a heading: its words in small letters, with hyphens between them.
fn anchor(line: &str) -> Option<String> {
    let title = line.strip_prefix('#')?.trim_start_matches('#').strip_prefix(' ')?;
    let kept = title.trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
    Some(kept.map(|c| if c == ' ' { '-' } else { c }).collect::<String>().to_lowercase())
}

/// Pages of the book that its summary does not name.
fn not_in_the_summary(pages: &[Page]) -> Vec<String> {
    let Some(summary) = pages.iter().find(|page| page.path == SUMMARY) else {
        return vec![format!("{SUMMARY} is missing")];
    };
    let named: Vec<String> = summary.prose().into_iter().flat_map(|(_, line)| links_in(line)).collect();
    let is_missing = |page: &&Page| {
        page.path
            .strip_prefix(FOLDER)
            .is_some_and(|path| page.path != SUMMARY && !named.iter().any(|name| name == path))
    };
    pages.iter().filter(is_missing).map(|page| format!("{}: is not in {SUMMARY}", page.path)).collect()
}

#[cfg(test)]
mod tests {
    //! Links are found where they stand, and lead to files and headings as in a browser.
    use super::*;

    #[test]
    fn links_of_a_line() {
        let found: Vec<String> = links_in("See [a](b.md#c), ![d](e.png) and `[f](g)`; [h](https://i.j).").collect();
        assert_eq!(found, ["b.md#c", "e.png", "https://i.j"]);
    }

    #[test]
    fn anchors_of_headings() {
        assert_eq!(anchor("## Bodies that do not collide").as_deref(), Some("bodies-that-do-not-collide"));
        assert_eq!(anchor("### `exact`, or not?").as_deref(), Some("exact-or-not"));
        assert_eq!(anchor("no heading"), None);
    }

    #[test]
    fn paths_are_made_normal() {
        assert_eq!(normal(Path::new("docs/book/../plots.md")), "docs/plots.md");
    }
}
