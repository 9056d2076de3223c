//! A Rust source file as the rules see it: its code without comments and strings, and which lines are tests.
//!
//! This is a lexer for rules of style, not a parser: comments (nested ones too), strings (raw ones too) and
//! characters are blanked out, so that a brace or a word inside them counts for nothing; lines keep their numbers.

/// A Rust source file.
#[derive(Debug)]
pub(super) struct RustSource {
    path: String,
    text: Vec<String>,
    code: Vec<String>,
    test: Vec<bool>,
}

/// A function with a body.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Function {
    pub(super) name: String,
    /// Line of the `fn`, from 0.
    pub(super) first_line: usize,
    /// Line of the closing brace, from 0.
    pub(super) last_line: usize,
}

impl RustSource {
    /// From the path relative to the workspace and the text.
    pub(super) fn new(path: &str, text: &str) -> Self {
        let blanked = without_comments_and_strings(text);
        let code: Vec<String> = blanked.lines().map(str::to_owned).collect();
        let test = test_lines(path, &code);
        Self { path: path.to_owned(), text: text.lines().map(str::to_owned).collect(), code, test }
    }

    /// Path relative to the workspace.
    pub(super) fn path(&self) -> &str {
        &self.path
    }

    /// The name of the crate the file belongs to: its folder under `crates`, or the top folder.
    pub(super) fn crate_name(&self) -> &str {
        let mut parts = self.path.split('/');
        match parts.next() {
            Some("crates") => parts.next().unwrap_or_default(),
            other => other.unwrap_or_default(),
        }
    }

    /// Lines as they are written.
    pub(super) fn text(&self) -> &[String] {
        &self.text
    }

    /// Lines without comments and strings.
    pub(super) fn code(&self) -> &[String] {
        &self.code
    }

    /// Lines of code outside tests, with their numbers (from 0).
    pub(super) fn product_code(&self) -> impl Iterator<Item = (usize, &str)> {
        self.code
            .iter()
            .enumerate()
            .filter(|(number, _)| !self.test[*number])
            .map(|(number, line)| (number, line.as_str()))
    }

    /// Last line of the item whose first brace opens in this line or after it; the line itself when there is none.
    pub(super) fn end_of_block(&self, line: usize) -> usize {
        end_of_item(&self.code, line, 0).unwrap_or(line)
    }

    /// Functions with a body, those inside others too.
    pub(super) fn functions(&self) -> Vec<Function> {
        let mut found = Vec::new();
        for (number, line) in self.code.iter().enumerate() {
            for (at, name) in function_names(line) {
                if let Some(last_line) = end_of_item(&self.code, number, at) {
                    found.push(Function { name, first_line: number, last_line });
                }
            }
        }
        found
    }
}

/// Where `fn name` stands in a line, as (column after the name, name).
fn function_names(line: &str) -> Vec<(usize, String)> {
    let mut names = Vec::new();
    for (at, _) in line.match_indices("fn ") {
        let starts_word = line[..at].chars().next_back().is_none_or(|before| !is_word(before));
        let rest = &line[at + 3..];
        let name: String = rest.chars().take_while(|c| is_word(*c)).collect();
        if starts_word && !name.is_empty() {
            names.push((at + 3 + name.len(), name));
        }
    }
    names
}

fn is_word(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

/// Line of the brace that closes the first one opened after the place given; `None` for an item that ends with a
/// semicolon before any brace.
fn end_of_item(code: &[String], line: usize, column: usize) -> Option<usize> {
    let (mut depth, mut nesting) = (0usize, 0usize);
    for (number, text) in code.iter().enumerate().skip(line) {
        let start = if number == line { column } else { 0 };
        for character in text.get(start..).unwrap_or_default().chars() {
            match character {
                '(' | '[' => nesting += 1,
                ')' | ']' => nesting = nesting.saturating_sub(1),
                '{' => depth += 1,
                '}' if depth <= 1 => return (depth == 1).then_some(number),
                '}' => depth -= 1,
                // A semicolon inside brackets belongs to an array type, not to the end of the item.
                ';' if depth == 0 && nesting == 0 => return None,
                _ => {}
            }
        }
    }
    None
}

/// Which lines belong to tests: all of a test file, and items under `#[cfg(test)]` or `#[test]`.
fn test_lines(path: &str, code: &[String]) -> Vec<bool> {
    let test_file = ["/tests/", "/benches/", "/examples/"].iter().any(|folder| path.contains(folder))
        || path.ends_with("/tests.rs");
    let mut test = vec![test_file; code.len()];
    for (number, line) in code.iter().enumerate() {
        if let Some(at) = line.find("#[cfg(test)]").or_else(|| line.find("#[test]")) {
            // The attribute's own brackets are behind the place where the search for the item's braces begins.
            let after = at + line[at..].find(']').map_or(0, |end| end + 1);
            // An item without braces ends with its semicolon.
            let semicolon = || code.iter().skip(number).position(|line| line.contains(';')).map(|lines| number + lines);
            let last = end_of_item(code, number, after).or_else(semicolon).unwrap_or(number);
            test[number..=last].fill(true);
        }
    }
    test
}

/// What the lexer is inside of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Inside {
    Code,
    LineComment,
    /// With the depth of nesting.
    BlockComment(usize),
    Text,
    /// With the number of `#`.
    RawText(usize),
}

/// The text with comments, strings and characters replaced by spaces; every line keeps its length and number.
fn without_comments_and_strings(text: &str) -> String {
    let characters: Vec<char> = text.chars().collect();
    let mut blanked = String::with_capacity(text.len());
    let mut inside = Inside::Code;
    let mut at = 0;
    while at < characters.len() {
        let (next, length, keep) = token(&characters, at, inside);
        for &character in &characters[at..at + length] {
            blanked.push(if keep || character == '\n' { character } else { ' ' });
        }
        inside = next;
        at += length;
    }
    blanked
}

/// The next token: what the lexer is inside of after it, its length, and whether it is code.
fn token(characters: &[char], at: usize, inside: Inside) -> (Inside, usize, bool) {
    let left = &characters[at..];
    let pair = (left[0], left.get(1).copied().unwrap_or('\0'));
    match inside {
        Inside::Code => code_token(characters, at, pair),
        Inside::LineComment if left[0] == '\n' => (Inside::Code, 1, false),
        Inside::LineComment => (inside, 1, false),
        Inside::BlockComment(depth) => match pair {
            ('*', '/') if depth == 1 => (Inside::Code, 2, false),
            ('*', '/') => (Inside::BlockComment(depth - 1), 2, false),
            ('/', '*') => (Inside::BlockComment(depth + 1), 2, false),
            _ => (inside, 1, false),
        },
        Inside::Text => match pair {
            ('\\', next) if next != '\0' => (inside, 2, false),
            ('"', _) => (Inside::Code, 1, false),
            _ => (inside, 1, false),
        },
        Inside::RawText(hashes) => {
            let closes = left[0] == '"' && left[1..].iter().take_while(|c| **c == '#').count() >= hashes;
            if closes { (Inside::Code, 1 + hashes, false) } else { (inside, 1, false) }
        }
    }
}

fn code_token(characters: &[char], at: usize, pair: (char, char)) -> (Inside, usize, bool) {
    let left = &characters[at..];
    let after_word = at > 0 && is_word(characters[at - 1]);
    match pair {
        ('/', '/') => (Inside::LineComment, 2, false),
        ('/', '*') => (Inside::BlockComment(1), 2, false),
        ('"', _) => (Inside::Text, 1, false),
        ('r', '"' | '#') if !after_word || characters[at - 1] == 'b' => {
            let hashes = left[1..].iter().take_while(|c| **c == '#').count();
            // `r#name` is a raw identifier, not a string.
            if left.get(1 + hashes) == Some(&'"') {
                (Inside::RawText(hashes), 2 + hashes, false)
            } else {
                (Inside::Code, 1, true)
            }
        }
        ('\'', _) => (Inside::Code, character_length(left), false),
        _ => (Inside::Code, 1, true),
    }
}

/// Length of the character literal that begins here; 1 for the quote of a lifetime.
fn character_length(left: &[char]) -> usize {
    match (left.get(1), left.get(2)) {
        // '\n', '\'', '\u{1F600}'
        (Some('\\'), Some(_)) => left.iter().skip(3).position(|c| *c == '\'').map_or(1, |end| end + 4),
        (Some(_), Some('\'')) => 3,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    //! Braces, words and numbers inside comments, strings and characters count for nothing; tests are told apart.
    use super::*;

    #[test]
    fn comments_strings_and_characters_are_blank() {
        let text = "a(\"}// \\\" x\"); // }\nb('{', '\\'', r#\"}\"}\"#); /* } /* } */ } */ c::<'d>(e);\n";
        let code = without_comments_and_strings(text);
        assert!(!code.contains(['{', '}', '"', '#']), "{code}");
        assert!(code.contains("a(") && code.contains("b(") && code.contains("c::<") && code.contains("(e);"));
        assert_eq!(code.chars().count(), text.chars().count());
        assert_eq!(code.lines().count(), text.lines().count());
    }

    #[test]
    fn a_function_ends_at_its_own_brace() {
        let source = RustSource::new(
            "crates/x/src/a.rs",
            "trait T { fn f(a: [u8; 2]); }\nfn g() {\n  if a { b }\n}\nfn h() {}\n",
        );
        let functions = source.functions();
        assert_eq!(
            functions.iter().map(|f| (f.name.as_str(), f.first_line, f.last_line)).collect::<Vec<_>>(),
            [("g", 1, 3), ("h", 4, 4)]
        );
    }

    #[test]
    fn tests_are_told_from_the_product() {
        let source =
            RustSource::new("crates/x/src/a.rs", "fn f() {}\n#[cfg(test)]\nmod tests {\n  fn g() {}\n}\nfn h() {}\n");
        assert_eq!(source.product_code().map(|(number, _)| number).collect::<Vec<_>>(), [0, 5]);
        let declared = RustSource::new("crates/x/src/a.rs", "#[cfg(test)]\nmod tests;\nmod b;\n");
        assert_eq!(declared.product_code().map(|(number, _)| number).collect::<Vec<_>>(), [2]);
        assert_eq!(RustSource::new("crates/x/tests/it/main.rs", "fn f() {}\n").product_code().count(), 0);
        assert_eq!(source.crate_name(), "x");
    }
}
