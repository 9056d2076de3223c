//! The files that a scene names: on disk, or given with its text. Their size is bounded.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Files by name, there for as long as the program runs.
pub type GivenFiles = &'static [(&'static str, &'static [u8])];

/// Why a file could not be read.
pub(crate) enum Fault {
    Io(io::Error),
    TooLarge,
}

/// Where files are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Files {
    /// On disk.
    Disk,
    /// Given by name. Whole folders are not given: a path stands for the one file whose name is its end, or whose end
    /// it is; where several are, for none.
    Given(GivenFiles),
}

impl Files {
    /// The bytes of a file of at most `limit` bytes.
    pub(crate) fn bounded(self, path: &Path, limit: u64) -> Result<Vec<u8>, Fault> {
        let Self::Given(_) = self else { return bounded(path, limit) };
        let missing = || io::Error::new(io::ErrorKind::NotFound, "it is not among the files given with the scene");
        let bytes = self.given(path).ok_or_else(|| Fault::Io(missing()))?;
        if bytes.len() as u64 > limit { Err(Fault::TooLarge) } else { Ok(bytes.to_vec()) }
    }

    /// Whether there is a file.
    pub(crate) fn holds(self, path: &Path) -> bool {
        match self {
            Self::Disk => path.is_file(),
            Self::Given(_) => self.given(path).is_some(),
        }
    }

    /// The given file of a path.
    fn given(self, path: &Path) -> Option<&'static [u8]> {
        let Self::Given(files) = self else { return None };
        let exact = files.iter().find(|(name, _)| Path::new(name) == path);
        let similar = |name: &Path| path.ends_with(name) || name.ends_with(path);
        let mut others = files.iter().filter(|(name, _)| similar(Path::new(name)));
        let found = exact.or_else(|| others.next().filter(|_| others.next().is_none()));
        found.map(|(_, bytes)| *bytes)
    }
}

/// The folder that the names of a scene's files are relative to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SceneFolder {
    /// Where its files are.
    pub(crate) files: Files,
    /// The folder; of given files the empty one.
    folder: PathBuf,
}

impl SceneFolder {
    /// The folder of a scene file on disk.
    pub(crate) fn beside(scene: &Path) -> Self {
        Self { files: Files::Disk, folder: scene.parent().map(Path::to_owned).unwrap_or_default() }
    }

    /// Files that are given with the scene.
    pub(crate) fn given(files: GivenFiles) -> Self {
        Self { files: Files::Given(files), folder: PathBuf::new() }
    }

    /// The path of a file of this name.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }
}

/// The bytes of a file on disk of at most `limit` bytes.
fn bounded(path: &Path, limit: u64) -> Result<Vec<u8>, Fault> {
    let file = File::open(path).map_err(Fault::Io)?;
    // What a regular file says of its length saves reading it; a device may say 0 and go on for ever.
    let length = file.metadata().map_err(Fault::Io)?.len();
    if length > limit {
        return Err(Fault::TooLarge);
    }
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes).map_err(Fault::Io)?;
    if bytes.len() as u64 > limit { Err(Fault::TooLarge) } else { Ok(bytes) }
}
