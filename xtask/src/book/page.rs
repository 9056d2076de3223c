//! Pages of Markdown and their fenced blocks.

use std::error::Error;
use std::path::{Path, PathBuf};

/// What opens and closes a block.
const FENCE: &str = "```";

/// A page.
#[derive(Debug)]
pub(super) struct Page {
    /// Its path from the workspace, with slashes.
    pub(super) path: String,
    /// What it says.
    pub(super) text: String,
}

/// A fenced block.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Block {
    /// Its language: the first word behind the fence.
    pub(super) language: String,
    /// The file that it is, when the page says so.
    pub(super) file: Option<String>,
    /// The line of the page that its first line is, from 1.
    pub(super) line: usize,
    /// What stands in it.
    pub(super) text: String,
}

impl Page {
    /// Reads the page at this path from the workspace.
    pub(super) fn read(root: &Path, path: &str) -> Result<Self, Box<dyn Error>> {
        let text = std::fs::read_to_string(root.join(path)).map_err(|error| format!("{path}: {error}"))?;
        Ok(Self { path: path.to_owned(), text })
    }

    /// Its blocks, in order.
    pub(super) fn blocks(&self) -> Vec<Block> {
        let mut blocks = Vec::new();
        let mut open: Option<Block> = None;
        let mut before = "";
        for (number, line) in self.text.lines().enumerate() {
            match (&mut open, line.trim_start().strip_prefix(FENCE)) {
                (None, Some(info)) => {
                    let language = info.split([' ', ',']).next().unwrap_or_default().to_owned();
                    open = Some(Block { language, file: file_name(before), line: number + 2, text: String::new() });
                }
                (Some(_), Some(_)) => {
                    blocks.extend(open.take());
                    before = "";
                }
                (Some(block), None) => {
                    block.text.push_str(line);
                    block.text.push('\n');
                }
                (None, None) if !line.trim().is_empty() => before = line,
                (None, None) => {}
            }
        }
        blocks
    }

    /// Its lines outside of blocks, with their numbers from 1.
    pub(super) fn prose(&self) -> Vec<(usize, &str)> {
        let mut inside = false;
        let mut lines = Vec::new();
        for (number, line) in self.text.lines().enumerate() {
            if line.trim_start().starts_with(FENCE) {
                inside = !inside;
            } else if !inside {
                lines.push((number + 1, line));
            }
        }
        lines
    }
}

/// The name of a file between backticks that a line ends with, before a colon.
fn file_name(line: &str) -> Option<String> {
    let name = line.trim_end().strip_suffix("`:")?.rsplit('`').next()?;
    let is_file = name.contains('.') && !name.contains(['/', '\\', ' ']);
    is_file.then(|| name.to_owned())
}

/// Every page of Markdown in a folder and those below it, as paths from the workspace, in order.
pub(super) fn pages_in(root: &Path, folder: &str) -> Result<Vec<String>, Box<dyn Error>> {
    let mut found = Vec::new();
    let mut entries: Vec<PathBuf> =
        std::fs::read_dir(root.join(folder))?.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>()?;
    entries.sort();
    for entry in entries {
        let name = format!("{folder}/{}", entry.file_name().unwrap_or_default().to_string_lossy());
        if entry.is_dir() {
            found.extend(pages_in(root, &name)?);
        } else if entry.extension().is_some_and(|extension| extension == "md") {
            found.push(name);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    //! Blocks have the language, the file and the line that a reader sees.
    use super::*;

    #[test]
    fn blocks_of_a_page() {
        let text = "A scene, `fall.toml`:\n\n```toml\nformat = 1\n```\n\nThen:\n```sh\npolhode run fall.toml\n```\n";
        let page = Page { path: "a.md".into(), text: text.into() };
        let [scene, command] = &page.blocks()[..] else { panic!("two blocks") };
        assert_eq!((scene.language.as_str(), scene.file.as_deref(), scene.line), ("toml", Some("fall.toml"), 4));
        assert_eq!((command.language.as_str(), command.file.as_deref(), command.line), ("sh", None, 9));
        assert_eq!(command.text, "polhode run fall.toml\n");
        assert_eq!(page.prose().iter().map(|line| line.0).collect::<Vec<_>>(), [1, 2, 6, 7]);
    }
}
