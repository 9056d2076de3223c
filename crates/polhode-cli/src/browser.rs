//! Shows a file by the program that the system has for it: a page by the browser.

use crate::failure;
use std::path::Path;

/// Opens a file. Where there is nothing to open it with, stderr says so: the file is there all the same.
pub(crate) fn open(path: &Path) {
    // A program that is given a relative path may have another folder.
    let whole = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    if let Err(error) = open::that_detached(&whole) {
        failure::remark(&format!("note: nothing here opens {}: open it yourself ({error})", path.display()));
    }
}
