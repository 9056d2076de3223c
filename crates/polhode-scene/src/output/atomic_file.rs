//! A file that appears under its name when it is complete, and not before.
//!
//! While it grows it is locked. A temporary file of the same target that nobody has locked was left behind by a program
//! that was killed. When the target is written again, such a file is kept under the name with `.partial` at its end if
//! a readable file can be made of it, and removed otherwise, so that such files never pile up;
//! [`AtomicFile::left_behind`] says what was found.

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
    left_behind: Vec<LeftBehind>,
}

/// A temporary file that a program which was killed has left behind, and what has become of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftBehind {
    /// Where it was found.
    pub temporary: PathBuf,
    /// Where it is now; none when it was of no use and is removed.
    pub kept: Option<PathBuf>,
}

/// What makes a complete file of one that ends anywhere.
type Mender = Box<dyn FnOnce(&mut File) -> io::Result<()> + Send>;

/// A file that grows, for a program that must end at once: another thread may still be within a step, and never ends
/// it.
pub struct Unfinished {
    temporary: PathBuf,
    partial: PathBuf,
    mend: Mender,
}

impl std::fmt::Debug for Unfinished {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Unfinished").field("temporary", &self.temporary).finish_non_exhaustive()
    }
}

impl Unfinished {
    /// Moves what has reached the disk to the name with `.partial` at its end, which is returned, and makes a readable
    /// file of it. The program must end now: nothing more may be written.
    ///
    /// # Errors
    /// Those of renaming: then nothing is kept.
    pub fn keep(self) -> io::Result<PathBuf> {
        fs::rename(&self.temporary, &self.partial)?;
        // Even a file that could not be mended holds what was computed.
        let _ = File::options().read(true).write(true).open(&self.partial).and_then(|mut file| (self.mend)(&mut file));
        Ok(self.partial)
    }
}

/// The temporary file. Dropped, it removes the file.
#[derive(Debug)]
struct Open {
    writer: BufWriter<File>,
    path: TempPath,
    /// Whether a part of what was written since the last flush has reached the disk.
    has_spilled: bool,
}

impl AtomicFile {
    /// Opens a temporary file beside `target`.
    ///
    /// # Errors
    /// When the target is a folder or names no file, or its folder cannot be written to.
    pub fn create(target: &Path) -> io::Result<Self> {
        // What is cut off anywhere is of no use.
        Self::create_mending(target, |_| Err(io::ErrorKind::InvalidData.into()))
    }

    /// As [`AtomicFile::create`]; `mend` makes a readable file of one of this kind that ends anywhere, or fails where
    /// there is nothing to keep.
    ///
    /// # Errors
    /// As [`AtomicFile::create`].
    pub fn create_mending(target: &Path, mend: impl FnMut(&mut File) -> io::Result<()>) -> io::Result<Self> {
        // A link stays a link: what it points to is replaced.
        let pointed = |_| fs::read_link(target).map(|to| target.parent().unwrap_or(Path::new("")).join(to));
        let target = fs::canonicalize(target).or_else(pointed).unwrap_or_else(|_| target.to_owned());
        if target.is_dir() {
            return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
        }
        let name = target.file_name().ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "it names no file"))?;
        let mut prefix = std::ffi::OsString::from(".");
        prefix.push(name);
        prefix.push(".");
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(SUFFIX);
        #[cfg(unix)]
        builder.permissions(as_other_files());
        let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        // Said here, where no temporary name stands in the message.
        if !fs::metadata(folder)?.is_dir() {
            return Err(io::Error::new(io::ErrorKind::NotADirectory, format!("{} is no folder", folder.display())));
        }
        let left_behind = found_left_behind(folder, &prefix.to_string_lossy(), &partial_of(&target), mend);
        let (file, path) = builder.tempfile_in(folder)?.into_parts();
        // Where a file system has no locks nothing is lost but the mark.
        let _ = file.try_lock();
        Ok(Self { target, open: Some(Open { writer: BufWriter::new(file), path, has_spilled: false }), left_behind })
    }

    /// What programs that were killed while they wrote the same file had left behind.
    pub fn left_behind(&self) -> &[LeftBehind] {
        &self.left_behind
    }

    /// The name under which the file will appear.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// The temporary name under which it grows; none when it is complete.
    pub fn temporary(&self) -> Option<&Path> {
        self.open.as_ref().map(|open| &*open.path)
    }

    /// Whether a part of what was written since the last flush has reached the disk: the buffer was full.
    pub fn has_spilled(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.has_spilled)
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
        let partial = self.partial();
        self.move_to(&partial)?;
        Ok(partial)
    }

    /// The file as it grows; `mend` makes a readable file of what has reached the disk.
    pub fn unfinished(&self, mend: impl FnOnce(&mut File) -> io::Result<()> + Send + 'static) -> Option<Unfinished> {
        let temporary = self.open.as_ref()?.path.to_path_buf();
        Some(Unfinished { temporary, partial: self.partial(), mend: Box::new(mend) })
    }

    /// After a fault of writing (a full disk): lets `mend` make a readable file of what has reached the disk, and keeps
    /// it under the name with `.partial` at its end, which is returned.
    ///
    /// # Errors
    /// Those of `mend` and of renaming.
    pub fn salvage(&mut self, mend: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<PathBuf> {
        let Some(Open { writer, path, .. }) = self.open.take() else {
            return Err(io::Error::other("the file is closed"));
        };
        // What is still in memory finds no room.
        let (mut file, _lost) = writer.into_parts();
        mend(&mut file)?;
        let partial = self.partial();
        path.persist(&partial).map_err(|refused| refused.error)?;
        Ok(partial)
    }

    /// The name with `.partial` at its end.
    fn partial(&self) -> PathBuf {
        partial_of(&self.target)
    }

    fn move_to(&mut self, name: &Path) -> io::Result<()> {
        let Some(open) = &mut self.open else { return Ok(()) };
        open.writer.flush()?;
        // The data must be on the disk before the name is, or a crash could leave an empty file under it.
        open.writer.get_ref().sync_all()?;
        if let Some(Open { writer, path, has_spilled }) = self.open.take()
            && let Err(refused) = path.persist(name)
        {
            self.open = Some(Open { writer, path: refused.path, has_spilled });
            return Err(refused.error);
        }
        Ok(())
    }

    fn open(&mut self) -> io::Result<&mut Open> {
        self.open.as_mut().ok_or_else(|| io::Error::other("the file is closed"))
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let open = self.open()?;
        let held = open.writer.buffer().len();
        let written = open.writer.write(bytes)?;
        open.has_spilled |= open.writer.buffer().len() != held + written;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let open = self.open()?;
        open.has_spilled = false;
        open.writer.flush()
    }
}

impl Seek for AtomicFile {
    fn seek(&mut self, position: SeekFrom) -> io::Result<u64> {
        self.open()?.writer.seek(position)
    }
}

/// A name with `.partial` at its end.
fn partial_of(target: &Path) -> PathBuf {
    let mut partial = target.as_os_str().to_owned();
    partial.push(".partial");
    PathBuf::from(partial)
}

/// Keeps or removes the temporary files of a target that nobody writes to any more.
fn found_left_behind(
    folder: &Path,
    prefix: &str,
    partial: &Path,
    mut mend: impl FnMut(&mut File) -> io::Result<()>,
) -> Vec<LeftBehind> {
    let mut found = Vec::new();
    let Ok(entries) = fs::read_dir(folder) else { return found };
    let mut paths: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    // The newest first.
    paths.sort_by_key(|path| std::cmp::Reverse(fs::metadata(path).and_then(|file| file.modified()).ok()));
    for path in paths {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if !(name.starts_with(prefix) && name.ends_with(SUFFIX)) {
            continue;
        }
        let Ok(mut file) = File::options().read(true).write(true).open(&path) else { continue };
        if file.try_lock().is_err() {
            continue;
        }
        // Of several the newest is kept, in the place of an older one, as what an interrupted run has computed is.
        let is_first = found.iter().all(|other: &LeftBehind| other.kept.is_none());
        let is_kept = is_first && mend(&mut file).is_ok() && fs::rename(&path, partial).is_ok();
        if !is_kept {
            let _ = fs::remove_file(&path);
        }
        found.push(LeftBehind { temporary: path, kept: is_kept.then(|| partial.to_owned()) });
    }
    found
}

/// Ending of the names of temporary files.
const SUFFIX: &str = ".tmp";

/// Readable and writable by all whom the process's mask lets: a temporary file is by default its owner's alone, and
/// keeps that under its final name.
#[cfg(unix)]
fn as_other_files() -> fs::Permissions {
    std::os::unix::fs::PermissionsExt::from_mode(0o666)
}
