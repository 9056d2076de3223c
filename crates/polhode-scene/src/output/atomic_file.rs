//! A file that appears under its name when it is complete, and not before.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Temporary names tried before giving up: names are taken by runs that were killed.
const ATTEMPTS: u32 = 100;

/// A file being written under a temporary name in the folder of its target. Dropped without
/// [`commit`](AtomicFile::commit) it leaves nothing behind.
#[derive(Debug)]
pub struct AtomicFile {
    target: PathBuf,
    temporary: PathBuf,
    writer: Option<BufWriter<File>>,
}

impl AtomicFile {
    /// Opens a temporary file beside `target`.
    ///
    /// # Errors
    /// When the target is a folder or names no file, or its folder cannot be written to.
    pub fn create(target: &Path) -> io::Result<Self> {
        // A link stays a link: what it points to is replaced.
        let target = fs::canonicalize(target).unwrap_or_else(|_| target.to_owned());
        if target.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
        }
        let name = target.file_name().ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "it names no file"))?;
        for attempt in 0..ATTEMPTS {
            let mut hidden = std::ffi::OsString::from(".");
            hidden.push(name);
            hidden.push(format!(".{}-{attempt}.tmp", std::process::id()));
            let temporary = target.with_file_name(hidden);
            match OpenOptions::new().write(true).create_new(true).open(&temporary) {
                Ok(file) => return Ok(Self { target, temporary, writer: Some(BufWriter::new(file)) }),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::new(io::ErrorKind::AlreadyExists, "too many temporary files are in the way"))
    }

    /// The name under which the file will appear.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Moves the complete file to its name, replacing what stood there.
    ///
    /// # Errors
    /// Those of writing and renaming; the name then holds what it held.
    pub fn commit(&mut self) -> io::Result<()> {
        let target = self.target.clone();
        self.move_to(&target)
    }

    /// Moves what has been written to the name with `.partial` at its end, which is returned.
    ///
    /// # Errors
    /// Those of writing and renaming.
    pub fn keep_partial(&mut self) -> io::Result<PathBuf> {
        let mut partial = self.target.clone().into_os_string();
        partial.push(".partial");
        let partial = PathBuf::from(partial);
        self.move_to(&partial)?;
        Ok(partial)
    }

    fn move_to(&mut self, name: &Path) -> io::Result<()> {
        let Some(mut writer) = self.writer.take() else { return Ok(()) };
        let moved = writer
            .flush()
            // The data must be on the disk before the name is, or a crash could leave an empty file under it.
            .and_then(|()| writer.get_ref().sync_all())
            .and_then(|()| fs::rename(&self.temporary, name));
        if moved.is_err() {
            self.writer = Some(writer);
        }
        moved
    }

    fn writer(&mut self) -> io::Result<&mut BufWriter<File>> {
        self.writer.as_mut().ok_or_else(|| io::Error::other("the file is closed"))
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer()?.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer()?.flush()
    }
}

impl Seek for AtomicFile {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.writer()?.seek(position)
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        if let Some(writer) = self.writer.take() {
            // What is left in the buffer goes nowhere; a file that cannot be removed is only litter.
            let _ = writer.into_parts();
            let _ = fs::remove_file(&self.temporary);
        }
    }
}
