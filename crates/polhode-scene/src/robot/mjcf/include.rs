//! Files that an MJCF file includes: their elements stand in the place of `<include>`.

use super::super::element::{Element, Fault};
use super::super::finding::RobotDefect;
use super::super::text::text_of;
use crate::files::Files;
use std::path::{Path, PathBuf};

/// Deepest nesting of included files: more is a circle.
const DEEPEST: usize = 16;

/// Most files that are included: more is a circle that spreads.
const MOST_FILES: usize = 1000;

/// Expands the includes in an element; names of files are relative to `folder`. The files are added to the list.
///
/// # Errors
/// When a file cannot be read, or they include each other.
pub(super) fn expand(
    element: &mut Element,
    (from, folder): (Files, &Path),
    files: &mut Vec<PathBuf>,
) -> Result<(), Fault> {
    expand_at(element, (from, folder), files, 0)
}

fn expand_at(
    element: &mut Element,
    (from, folder): (Files, &Path),
    files: &mut Vec<PathBuf>,
    depth: usize,
) -> Result<(), Fault> {
    let mut children = Vec::with_capacity(element.children.len());
    for mut child in std::mem::take(&mut element.children) {
        if child.name != "include" {
            expand_at(&mut child, (from, folder), files, depth)?;
            children.push(child);
            continue;
        }
        let fault = |defect| Box::new((child.place.clone(), defect));
        if depth >= DEEPEST || files.len() >= MOST_FILES {
            return Err(fault(RobotDefect::Depth { what: "included files", limit: DEEPEST }));
        }
        let Some(name) = child.attribute("file") else { return Err(fault(RobotDefect::MissingAttribute("file"))) };
        let path = folder.join(name);
        let unread = |reason: String| fault(RobotDefect::Include { file: path.display().to_string(), reason });
        let text = text_of(from, &path).map_err(|error| unread(error.to_string()))?;
        files.push(path.clone());
        let mut included = Element::parse(&path, &text)?;
        expand_at(&mut included, (from, folder), files, depth + 1)?;
        children.append(&mut included.children);
    }
    element.children = children;
    Ok(())
}
