//! A file that appears under its name when it is complete, and not before.

use std::fs::{self, File};
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, TempPath};

/// A file being written under a temporary name in the folder of its target. Dropped without
/// [`commit`](AtomicFile::commit) it leaves nothing behind.
#[derive(Debug)]
pub struct AtomicFile {
    target: PathBuf,
    open: Option<Open>,
}

/// The temporary file. Dropped, it removes the file.
#[derive(Debug)]
struct Open {
    writer: BufWriter<File>,
    path: TempPath,
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
        let mut prefix = std::ffi::OsString::from(".");
        prefix.push(name);
        prefix.push(".");
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(".tmp");
        #[cfg(unix)]
        builder.permissions(as_other_files());
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let (file, path) = builder.tempfile_in(folder)?.into_parts();
        Ok(Self { target, open: Some(Open { writer: BufWriter::new(file), path }) })
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
        let Some(open) = &mut self.open else { return Ok(()) };
        open.writer.flush()?;
        // The data must be on the disk before the name is, or a crash could leave an empty file under it.
        open.writer.get_ref().sync_all()?;
        if let Some(Open { writer, path }) = self.open.take()
            && let Err(refused) = path.persist(name)
        {
            self.open = Some(Open { writer, path: refused.path });
            return Err(refused.error);
        }
        Ok(())
    }

    fn writer(&mut self) -> io::Result<&mut BufWriter<File>> {
        let open = self.open.as_mut().ok_or_else(|| io::Error::other("the file is closed"))?;
        Ok(&mut open.writer)
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

/// Readable and writable by all whom the process's mask lets: a temporary file is by default its owner's alone, and keeps
/// that under its final name.
#[cfg(unix)]
fn as_other_files() -> fs::Permissions {
    std::os::unix::fs::PermissionsExt::from_mode(0o666)
}
