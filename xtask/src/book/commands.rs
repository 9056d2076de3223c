//! Blocks of commands: each is run as it is printed, and prints what the page says.

use super::page::Block;
use std::error::Error;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// What stands before a command in a block of language `console`.
const PROMPT: &str = "$ ";
/// How the program is run in the folder of the workspace.
const RUN_IN_WORKSPACE: &str = "cargo run --release -- ";
/// How the tasks of the workspace are run.
const TASK: &str = "cargo xtask ";
/// What stands for anything in the printed output.
const ANYTHING: &str = "...";
/// Programs that are run.
const RUN: [&str; 5] = ["polhode", "cat", "head", "ls", "echo"];
/// Programs that fetch or build something and are not run: what they build is built and tested by verify itself.
const NOT_RUN: [&str; 5] = ["cargo", "git", "cd", "pip", "mdbook"];
/// Lines of a failed command's output that are shown.
const SHOWN_LINES: usize = 6;

/// Where commands are run.
#[derive(Debug)]
pub(super) struct Shell<'a> {
    /// The workspace.
    pub(super) root: &'a Path,
    /// The program.
    pub(super) program: PathBuf,
    /// The folder of the page.
    pub(super) folder: PathBuf,
}

/// A command of a page.
#[derive(Debug, PartialEq, Eq)]
struct Printed {
    line: usize,
    text: String,
    output: Vec<String>,
}

/// Runs the commands of a block; how many ran.
pub(super) fn run(block: &Block, shell: &Shell<'_>) -> Result<usize, Box<dyn Error>> {
    let mut ran = 0;
    for printed in commands_of(block) {
        let done =
            shell.run(&printed).map_err(|error| format!("line {}: `{}`: {error}", printed.line, printed.text))?;
        ran += usize::from(done == Done::Ran);
    }
    Ok(ran)
}

/// Whether a command was run.
#[derive(Debug, PartialEq, Eq)]
enum Done {
    Ran,
    Left,
}

impl Shell<'_> {
    fn run(&self, printed: &Printed) -> Result<Done, Box<dyn Error>> {
        let text = match printed.text.strip_prefix(RUN_IN_WORKSPACE) {
            Some(arguments) => format!("polhode {arguments}"),
            None => printed.text.clone(),
        };
        if let Some(task) = text.strip_prefix(TASK) {
            task_exists(task)?;
            return Ok(Done::Ran);
        }
        let mut words = text.split_whitespace();
        let first = words.next().unwrap_or_default();
        if RUN.contains(&first) {
            self.run_in_shell(&text, &printed.output)?;
            return Ok(Done::Ran);
        }
        if !NOT_RUN.contains(&first) {
            return Err(
                format!("nothing here can run {first}: let xtask/src/book run it, or make the block text").into()
            );
        }
        self.example_exists(&text)?;
        Ok(Done::Left)
    }

    /// Examples of the crates are compiled and run by the case `one dependency`; that there is one is checked here.
    fn example_exists(&self, text: &str) -> Result<(), Box<dyn Error>> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let behind = |option: &str| words.iter().position(|word| *word == option).and_then(|at| words.get(at + 1));
        if let (Some(package), Some(example)) = (behind("-p"), behind("--example")) {
            let file = self.root.join("crates").join(package).join("examples").join(format!("{example}.rs"));
            if !file.is_file() {
                return Err(format!("{package} has no example {example}").into());
            }
        }
        Ok(())
    }

    fn run_in_shell(&self, text: &str, expected: &[String]) -> Result<(), Box<dyn Error>> {
        let output = Command::new("sh")
            .args(["-c", &format!("{{ {text}\n}} 2>&1")])
            .current_dir(&self.folder)
            .env("PATH", self.path()?)
            .stdin(Stdio::null())
            .output()?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        if !output.status.success() {
            let lines: Vec<&str> = printed.lines().collect();
            return Err(
                format!("{}: {}", output.status, lines[lines.len().saturating_sub(SHOWN_LINES)..].join(" / ")).into()
            );
        }
        let mut lines = printed.lines();
        for wanted in expected.iter().filter(|wanted| !matches!(wanted.trim(), "" | ANYTHING)) {
            if !lines.any(|line| matches(wanted, line)) {
                return Err(format!("does not print \"{}\" (in this order)", wanted.trim()).into());
            }
        }
        Ok(())
    }

    /// Where programs are looked for: first in the folder of polhode.
    pub(super) fn path(&self) -> Result<OsString, Box<dyn Error>> {
        let own = self.program.parent().ok_or("the program lies in no folder")?.to_owned();
        let others = std::env::var_os("PATH").unwrap_or_default();
        Ok(std::env::join_paths(std::iter::once(own).chain(std::env::split_paths(&others)))?)
    }
}

/// Tasks run for long: that there is one of this name with these options is what is checked.
fn task_exists(task: &str) -> Result<(), Box<dyn Error>> {
    let output = Command::new(std::env::current_exe()?).args(task.split_whitespace()).arg("--help").output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned().into());
    }
    Ok(())
}

/// Whether a line is the printed one, where spaces in a row count as one and `...` stands for anything.
fn matches(wanted: &str, line: &str) -> bool {
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (wanted, line) = (words(wanted), words(line));
    let mut parts = wanted.split(ANYTHING).map(str::trim);
    let Some(mut rest) = parts.next().and_then(|first| line.strip_prefix(first)) else { return false };
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.trim().is_empty() || wanted.ends_with(ANYTHING)
}

/// The commands of a block: every line, or those behind a prompt; a backslash at the end joins the next line.
fn commands_of(block: &Block) -> Vec<Printed> {
    let has_output = block.language == "console";
    let mut commands: Vec<Printed> = Vec::new();
    let mut continued = false;
    for (number, line) in block.text.lines().enumerate() {
        let command = if has_output { line.strip_prefix(PROMPT) } else { Some(line) };
        match (command, commands.last_mut()) {
            (_, Some(last)) if continued => {
                last.text.truncate(last.text.trim_end_matches('\\').len());
                last.text.push_str(line.trim_start());
            }
            (Some(text), _) if text.trim().is_empty() || text.starts_with('#') => {}
            (Some(text), _) => {
                commands.push(Printed { line: block.line + number, text: text.to_owned(), output: Vec::new() });
            }
            (None, Some(last)) => last.output.push(line.to_owned()),
            (None, None) => {}
        }
        continued = line.ends_with('\\');
    }
    commands
}

#[cfg(test)]
mod tests {
    //! Commands and the output below them are told apart, and output is compared as a reader would.
    use super::*;

    fn block(language: &str, text: &str) -> Block {
        Block { language: language.into(), file: None, line: 10, text: text.into() }
    }

    #[test]
    fn commands_and_their_output() {
        let commands = commands_of(&block("console", "$ polhode plan a.toml\nscene a\n...\n$ polhode check a.toml\n"));
        assert_eq!(commands.len(), 2);
        assert_eq!((commands[0].text.as_str(), commands[0].output.len()), ("polhode plan a.toml", 2));
        assert_eq!(commands[1].line, 13);
        let joined = commands_of(&block("sh", "# a comment\npolhode run a.toml \\\n    -o a.csv\n"));
        assert_eq!(joined[0].text, "polhode run a.toml -o a.csv");
    }

    #[test]
    fn output_with_gaps() {
        assert!(matches("wall time  ... s", "  wall time   0.25 s"));
        assert!(matches("closure ...", "closure  0 (relative)"));
        assert!(!matches("events 41", "events 42"));
        assert!(!matches("events 4", "events 41"));
    }
}
