//! Blocks of Python: run where python3 has the modules that they import.

use super::commands::Shell;
use super::page::Block;
use std::collections::BTreeSet;
use std::error::Error;
use std::process::{Command, Stdio};

/// The interpreter.
const INTERPRETER: &str = "python3";

/// The modules that a block imports: the first names behind `import` and `from`.
pub(super) fn imports(block: &Block) -> BTreeSet<String> {
    let behind = |line: &str| {
        let rest = line.strip_prefix("import ").or_else(|| line.strip_prefix("from "))?;
        rest.split([' ', '.', ',']).next().map(str::to_owned)
    };
    block.text.lines().filter_map(behind).collect()
}

/// Whether the interpreter is here and has a module.
pub(super) fn has(module: &str) -> bool {
    let mut command = Command::new(INTERPRETER);
    command.args(["-c", &format!("import {module}")]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// Runs a block in the folder of its page.
pub(super) fn run(block: &Block, shell: &Shell<'_>) -> Result<(), Box<dyn Error>> {
    let output = Command::new(INTERPRETER)
        .args(["-c", &block.text])
        .current_dir(&shell.folder)
        .env("PATH", shell.path()?)
        .stdin(Stdio::null())
        .output()?;
    if output.status.success() {
        return Ok(());
    }
    let printed = String::from_utf8_lossy(&output.stderr).into_owned();
    Err(format!("line {}: {}", block.line, printed.lines().last().unwrap_or("it fails")).into())
}

#[cfg(test)]
mod tests {
    //! The modules of a block are those that it imports.
    use super::*;

    #[test]
    fn modules() {
        let text = "import numpy as np\nfrom matplotlib.pyplot import plot\nx = 'import none'\n".to_owned();
        let block = Block { language: "python".into(), file: None, line: 1, text };
        assert_eq!(imports(&block).into_iter().collect::<Vec<_>>(), ["matplotlib", "numpy"]);
    }
}
