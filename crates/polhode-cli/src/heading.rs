//! What stands above what is shown: title and description of the scenes.

use polhode_scene::LoadedScene;

/// Width at which a description is broken into lines, characters.
const LINE: usize = 100;

/// Title and description of what is shown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Heading {
    /// In a few words.
    pub(crate) title: String,
    /// What to look at; empty when the scenes do not say.
    pub(crate) description: String,
}

impl Heading {
    /// Of one scene, or of two that are shown beside each other: what both say stands once.
    pub(crate) fn of<'a>(scenes: impl Iterator<Item = &'a LoadedScene>) -> Self {
        let (mut titles, mut descriptions) = (Vec::new(), Vec::new());
        for scene in scenes {
            titles.push(scene.title());
            descriptions.extend(scene.description());
        }
        titles.dedup();
        descriptions.dedup();
        Self { title: titles.join(" | "), description: descriptions.join(" | ") }
    }

    /// As lines of text, each with its end: nothing where there is nothing to say beyond the name.
    pub(crate) fn lines(&self, name: &str) -> String {
        let title = if self.title == name { String::new() } else { format!("{}\n", self.title) };
        title + &self.description_lines()
    }

    /// The description alone, likewise.
    pub(crate) fn description_lines(&self) -> String {
        wrapped(&self.description)
    }
}

/// A text in lines of at most [`LINE`] characters, but for longer words.
fn wrapped(text: &str) -> String {
    let mut lines = String::new();
    let mut used = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if used > 0 {
            let fits = used + 1 + length <= LINE;
            lines.push(if fits { ' ' } else { '\n' });
            used = if fits { used + 1 } else { 0 };
        }
        lines.push_str(word);
        used += length;
    }
    if used > 0 {
        lines.push('\n');
    }
    lines
}

#[cfg(test)]
mod tests {
    //! A description is broken into lines between words.
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let text = "word ".repeat(50);
        let lines = wrapped(&text);
        assert!(lines.lines().all(|line| line.len() <= LINE && !line.ends_with(' ')));
        assert_eq!(lines.split_whitespace().count(), 50);
        assert_eq!(wrapped(""), "");
    }

    #[test]
    fn what_the_name_says_already_is_not_repeated() {
        let heading = Heading { title: "box".to_owned(), description: String::new() };
        assert_eq!(heading.lines("box"), "");
        assert_eq!(heading.lines("scene"), "box\n");
    }
}
