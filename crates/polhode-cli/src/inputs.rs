//! Files that a command reads: an output never replaces one of them.

use crate::failure::Failure;
use std::path::Path;

/// Whether two names are of one file.
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| std::fs::canonicalize(path).or_else(|_| std::path::absolute(path));
    a == b || place(a).is_ok_and(|a| place(b).is_ok_and(|b| a == b))
}

/// That an output is none of the inputs.
///
/// # Errors
/// When it is one.
pub(crate) fn check_output<'a>(output: &Path, inputs: impl IntoIterator<Item = &'a Path>) -> Result<(), Failure> {
    if inputs.into_iter().any(|input| is_same(output, input)) {
        let what = format!("error: {} is what the run is made from: an output never replaces it", output.display());
        return Err(Failure::Usage(what));
    }
    Ok(())
}
