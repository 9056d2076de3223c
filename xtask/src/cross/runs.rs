//! Runs of the program over many scene files: one process for as many as it gets through.
//!
//! Starting the program can take seconds, where a runtime compiles it first. Each scene is told as soon as its line is
//! printed. A process that ends before its last line has failed in the file that was next; another one goes on with
//! those after it.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use strict_hash::Line;

/// The run of one scene file: its strict hash, or why it has none.
pub(super) type Outcome = Result<u64, String>;

/// Runs all files and tells the outcome of each, in their order.
pub(super) fn all(files: &[String], command: impl Fn() -> Command, tell: &mut dyn FnMut(&str, Outcome)) {
    let process = |files: &[String], line: &mut dyn FnMut(&str)| one_process(command(), files, line);
    all_by(files, process, tell);
}

/// The same with any way to run a process: it passes on the lines of some files and returns how it ended.
fn all_by(
    files: &[String],
    mut process: impl FnMut(&[String], &mut dyn FnMut(&str)) -> String,
    tell: &mut dyn FnMut(&str, Outcome),
) {
    let mut open: VecDeque<String> = files.iter().cloned().collect();
    while !open.is_empty() {
        let asked: Vec<String> = open.iter().cloned().collect();
        let end = process(&asked, &mut |line| {
            // A line about another file than the next one is none of the program's.
            let Some(line) = Line::read(line).filter(|line| open.front().is_some_and(|next| next == line.file()))
            else {
                return;
            };
            open.pop_front();
            match line {
                Line::Hash { file, hash } => tell(&file, Ok(hash)),
                Line::Failed { file, reason } => tell(&file, Err(reason)),
            }
        });
        if let Some(file) = open.pop_front() {
            tell(&file, Err(format!("the program ended without a line for it ({end})")));
        }
    }
}

/// Runs the program once and returns how it ended, in words.
fn one_process(mut command: Command, files: &[String], line: &mut dyn FnMut(&str)) -> String {
    let child = command.args(files).stdin(Stdio::null()).stdout(Stdio::piped()).spawn();
    let mut child = match child {
        Ok(child) => child,
        Err(error) => return format!("{}: {error}", command.get_program().display()),
    };
    if let Some(output) = child.stdout.take() {
        // What cannot be read is the end of it.
        BufReader::new(output).lines().map_while(Result::ok).for_each(|text| line(&text));
    }
    child.wait().map_or_else(|error| error.to_string(), |status| status.to_string())
}

#[cfg(test)]
mod tests {
    //! Every file has one outcome, in order, whatever the program prints and wherever it ends.
    use super::*;

    fn files(names: &[&str]) -> Vec<String> {
        names.iter().map(|&name| name.to_owned()).collect()
    }

    /// The outcomes when the program prints a hash for all files but ends before this one.
    fn outcomes(names: &[&str], ends_before: &str) -> Vec<(String, bool)> {
        let mut told = Vec::new();
        let process = |files: &[String], line: &mut dyn FnMut(&str)| {
            line("a warning of the runtime");
            line("0000000000000007 of another file");
            for file in files.iter().take_while(|&file| file != ends_before) {
                line(&format!("0000000000000001 {file}"));
            }
            "signal 6".to_owned()
        };
        all_by(&files(names), process, &mut |file, outcome| told.push((file.to_owned(), outcome == Ok(1))));
        told
    }

    #[test]
    fn every_file_is_told_once_in_order() {
        let all = |good: [bool; 3]| ["a", "b", "c"].map(str::to_owned).into_iter().zip(good).collect::<Vec<_>>();
        assert_eq!(outcomes(&["a", "b", "c"], ""), all([true, true, true]));
        assert_eq!(outcomes(&["a", "b", "c"], "a"), all([false, true, true]));
        assert_eq!(outcomes(&["a", "b", "c"], "b"), all([true, false, true]));
        assert_eq!(outcomes(&["a", "b", "c"], "c"), all([true, true, false]));
    }

    #[test]
    fn a_program_that_cannot_be_started_says_so_for_every_file() {
        let mut reasons = Vec::new();
        let command = || Command::new("no-such-program-anywhere");
        all(&files(&["a", "b"]), command, &mut |_, outcome| reasons.extend(outcome.err()));
        assert_eq!(reasons.len(), 2);
        assert!(reasons.iter().all(|reason| reason.contains("no-such-program-anywhere")), "{reasons:?}");
    }
}
