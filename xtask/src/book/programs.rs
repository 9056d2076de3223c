//! Blocks of Rust, run by rustdoc, and the book, built by mdbook.

use polhode_cases::cargo::cargo;
use polhode_cases::row::Row;
use std::error::Error;
use std::path::Path;
use std::process::{Command, Stdio};

/// Runs the programs of all pages, of which there are `count`.
pub(super) fn rust(case: &str, root: &Path, count: usize) -> Result<Row, Box<dyn Error>> {
    let quantity = "programs in Rust that compile and run";
    let mut command = cargo(root);
    let output = command.args(["test", "--doc", "--package", "xtask"]).stdin(Stdio::null()).output()?;
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    if !output.status.success() {
        eprintln!("{printed}\n{}", String::from_utf8_lossy(&output.stderr));
    }
    Ok(Row::exact(case, quantity, count as u64, passed(&printed) as u64))
}

/// How many tests passed, by the lines that say so.
fn passed(printed: &str) -> usize {
    let numbers = printed.lines().filter_map(|line| {
        let (_, rest) = line.strip_prefix("test result: ")?.split_once(". ")?;
        rest.split(' ').next()?.parse::<usize>().ok()
    });
    numbers.sum()
}

/// Builds the book where mdbook is installed, with a playground beside its pages.
pub(super) fn mdbook(case: &str, root: &Path, program: &Path) -> Result<Row, Box<dyn Error>> {
    let quantity = "the book is built by mdbook";
    let mut version = Command::new("mdbook");
    if version.arg("--version").stdin(Stdio::null()).output().is_err() {
        return Ok(Row::skipped(case, quantity, "mdbook is not installed (cargo install mdbook)"));
    }
    let output = Command::new("mdbook").args(["build", "docs"]).current_dir(root).stdin(Stdio::null()).output()?;
    let printed = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    let complains = ["WARN", "ERROR"].iter().any(|word| printed.contains(word));
    if complains || !output.status.success() {
        eprintln!("{printed}");
    }
    if output.status.success() {
        write_playground(root, program)?;
    }
    let measured = if complains { "warnings".to_owned() } else { output.status.to_string() };
    Ok(Row::exact(case, quantity, "exit status: 0", measured))
}

/// Writes the playground beside the pages of the book.
fn write_playground(root: &Path, program: &Path) -> Result<(), Box<dyn Error>> {
    let page = root.join(BOOK).join("book/playground.html");
    let output = Command::new(program).args(["play", "-o"]).arg(&page).stdin(Stdio::null()).output()?;
    if output.status.success() {
        return Ok(());
    }
    Err(format!("polhode play: {}: {}", output.status, String::from_utf8_lossy(&output.stderr)).into())
}

/// Where mdbook builds the book (docs/book.toml).
const BOOK: &str = "target/book";

#[cfg(test)]
mod tests {
    //! Tests that passed are counted over all that ran.
    use super::*;

    #[test]
    fn counts_of_passed_tests() {
        let printed = "test result: ok. 4 passed; 0 failed; 0 ignored\n\ntest result: FAILED. 2 passed; 1 failed\n";
        assert_eq!(passed(printed), 6);
    }
}
