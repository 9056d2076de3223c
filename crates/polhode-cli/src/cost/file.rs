//! A file that appears under its name when it is complete, and not before.

use crate::failure::Failure;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file under a temporary name in the folder of its target; dropped without [`NewFile::write`] it leaves nothing.
#[derive(Debug)]
pub(super) struct NewFile {
    target: PathBuf,
    temporary: PathBuf,
    file: File,
}

impl NewFile {
    /// Opens a temporary file beside `target`.
    pub(super) fn create(target: &Path) -> Result<Self, Failure> {
        let fault = |error: io::Error| fault(target, &error);
        if target.is_dir() {
            return Err(fault(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder")));
        }
        let name = target.file_name();
        let name = name.ok_or_else(|| fault(io::Error::new(io::ErrorKind::InvalidInput, "it names no file")))?;
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}.tmp", std::process::id()));
        let temporary = target.with_file_name(hidden);
        let file = OpenOptions::new().write(true).create_new(true).open(&temporary).map_err(fault)?;
        Ok(Self { target: target.to_owned(), temporary, file })
    }

    /// Writes the whole content and moves the file to its name, replacing what stood there.
    pub(super) fn write(mut self, content: &str) -> Result<(), Failure> {
        let written = self.file.write_all(content.as_bytes()).and_then(|()| self.file.sync_all());
        let moved = written.and_then(|()| fs::rename(&self.temporary, &self.target));
        moved.map_err(|error| fault(&self.target, &error))
    }
}

impl Drop for NewFile {
    fn drop(&mut self) {
        // After it was moved there is nothing under the temporary name.
        let _ = fs::remove_file(&self.temporary);
    }
}

fn fault(path: &Path, error: &io::Error) -> Failure {
    Failure::InputOutput(format!("error: cannot write {}: {error}", path.display()))
}
