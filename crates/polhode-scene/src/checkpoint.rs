//! Checkpoints: a run that can be continued later.
//!
//! A checkpoint holds where the scene file is, what was set from outside, and a [`Snapshot`]. Nothing else is needed to
//! continue but the scene file with its meshes; that these are still the same is known from the snapshot's hash of the
//! scene.
//!
//! | bytes | holds |
//! |---|---|
//! | first line | `polhode checkpoint 1` |
//! | second line | scene file and settings, as JSON |
//! | rest | the snapshot, with its own version and checksum |

use crate::document::Override;
use crate::error::SceneFileError;
use crate::files::{Fault, Files};
use crate::load::{LoadedScene, load_with};
use crate::output::AtomicFile;
use polhode::{Simulation, SimulationError, Snapshot, SnapshotError};
use serde::{Deserialize, Serialize};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use thiserror::Error;

/// The first line: what the file is, and the version of the lines.
const MAGIC: &[u8] = b"polhode checkpoint 1\n";

/// Largest checkpoint read, bytes: a hundred thousand bodies in contact need some hundred megabytes.
pub const LARGEST_CHECKPOINT: u64 = 1 << 30;

/// A run that can be continued.
#[derive(Debug, Clone, PartialEq)]
pub struct Checkpoint {
    /// The scene file, from the root of the file system.
    pub scene: PathBuf,
    /// What was set from outside the file.
    pub overrides: Vec<Override>,
    /// The run.
    pub snapshot: Snapshot,
}

/// The second line.
#[derive(Serialize, Deserialize)]
struct Header {
    scene: String,
    set: Vec<Setting>,
}

#[derive(Serialize, Deserialize)]
struct Setting {
    origin: String,
    key: String,
    value: String,
}

/// Why a checkpoint cannot be written or continued from.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// The file could not be read.
    #[error("cannot read {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is larger than any checkpoint.
    #[error("{} is larger than {limit} bytes, which no checkpoint is", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The largest size accepted, bytes.
        limit: u64,
    },
    /// The file could not be written.
    #[error("cannot write {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Under the name stands something else, which must not be lost.
    #[error("{} stands there and is no checkpoint: give another file, or move it away", path.display())]
    InTheWay {
        /// The file.
        path: PathBuf,
    },
    /// A name cannot be kept as text.
    #[error("{}: a checkpoint keeps the name of its scene file as UTF-8 text, which this is not", path.display())]
    Name {
        /// The file.
        path: PathBuf,
    },
    /// The file is no checkpoint.
    #[error("{} is no checkpoint: it does not begin with `polhode checkpoint 1` and a line of \
        settings", path.display())]
    NotACheckpoint {
        /// The file.
        path: PathBuf,
    },
    /// The snapshot in it is refused.
    #[error("{}: {source}", path.display())]
    Snapshot {
        /// The file.
        path: PathBuf,
        /// Why.
        source: SnapshotError,
    },
    /// The scene file cannot be loaded.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// The simulation cannot be made or does not take the snapshot.
    #[error("{}: {source}", path.display())]
    Simulation {
        /// The checkpoint.
        path: PathBuf,
        /// Why.
        source: Box<SimulationError>,
    },
}

impl CheckpointError {
    /// Whether reading or writing failed, as opposed to what stands in a file.
    pub fn is_input_output(&self) -> bool {
        match self {
            Self::Read { .. } | Self::Write { .. } => true,
            Self::Scene(error) => error.is_input_output(),
            _ => false,
        }
    }
}

impl Checkpoint {
    /// Of a run of this scene file, with these settings.
    ///
    /// # Errors
    /// When the place of the scene file cannot be found.
    pub fn new(scene: &Path, overrides: &[Override], snapshot: Snapshot) -> Result<Self, CheckpointError> {
        let absolute = std::path::absolute(scene);
        let scene = absolute.map_err(|source| CheckpointError::Read { path: scene.to_owned(), source })?;
        Ok(Self { scene, overrides: overrides.to_vec(), snapshot })
    }

    /// Writes it to a file, which appears when it is complete; a checkpoint that stood there is replaced.
    ///
    /// # Errors
    /// When the file cannot be written, or something other than a checkpoint stands there.
    pub fn write(&self, path: &Path) -> Result<(), CheckpointError> {
        check_place(path)?;
        let fault = |source| CheckpointError::Write { path: path.to_owned(), source };
        let Some(scene) = self.scene.to_str() else { return Err(CheckpointError::Name { path: self.scene.clone() }) };
        let setting = |Override { origin, key, value }: &Override| Setting {
            origin: origin.clone(),
            key: key.clone(),
            value: value.clone(),
        };
        let header = Header { scene: scene.to_owned(), set: self.overrides.iter().map(setting).collect() };
        let header = serde_json::to_vec(&header).map_err(|error| fault(error.into()))?;
        let mut file = AtomicFile::create(path).map_err(fault)?;
        for part in [MAGIC, &header, b"\n", &self.snapshot.to_bytes()] {
            file.write_all(part).map_err(fault)?;
        }
        file.commit().map_err(fault)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, is no checkpoint, or has been cut short or altered.
    pub fn read(path: &Path) -> Result<Self, CheckpointError> {
        let bytes = Files::Disk.bounded(path, LARGEST_CHECKPOINT).map_err(|fault| match fault {
            Fault::Io(source) => CheckpointError::Read { path: path.to_owned(), source },
            Fault::TooLarge => CheckpointError::TooLarge { path: path.to_owned(), limit: LARGEST_CHECKPOINT },
        })?;
        let (header, snapshot) =
            split(&bytes).ok_or_else(|| CheckpointError::NotACheckpoint { path: path.to_owned() })?;
        let snapshot = Snapshot::from_bytes(snapshot)
            .map_err(|source| CheckpointError::Snapshot { path: path.to_owned(), source })?;
        let overrides = header.set.into_iter().map(|set| Override::new(set.origin, set.key, set.value)).collect();
        Ok(Self { scene: PathBuf::from(header.scene), overrides, snapshot })
    }

    /// Loads the scene and makes a simulation that goes on from here; `path` is that of the checkpoint, which errors
    /// name.
    ///
    /// # Errors
    /// When the scene cannot be loaded, or has changed since.
    pub fn load(&self, path: &Path) -> Result<(LoadedScene, Simulation), CheckpointError> {
        let loaded = load_with(&self.scene, &self.overrides)?;
        let fault = |source| CheckpointError::Simulation { path: path.to_owned(), source: Box::new(source) };
        let mut simulation = match Simulation::with_effects(&loaded.scene, self.snapshot.effects()) {
            Ok(simulation) => simulation,
            Err(SimulationError::Scene(error)) => return Err(loaded.explain(error).into()),
            Err(error) => return Err(fault(error)),
        };
        simulation.restore(&self.snapshot).map_err(fault)?;
        Ok((loaded, simulation))
    }
}

/// Checks that nothing but a checkpoint, or an empty file, stands where one is to be written.
///
/// # Errors
/// When something does, or what stands there cannot be read.
pub fn check_place(path: &Path) -> Result<(), CheckpointError> {
    let file = match std::fs::File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(source) => return Err(CheckpointError::Read { path: path.to_owned(), source }),
    };
    let mut first = Vec::new();
    let read = file.take(MAGIC.len() as u64).read_to_end(&mut first);
    read.map_err(|source| CheckpointError::Read { path: path.to_owned(), source })?;
    let in_the_way = || CheckpointError::InTheWay { path: path.to_owned() };
    if first.is_empty() || first == MAGIC { Ok(()) } else { Err(in_the_way()) }
}

/// The header and the bytes of the snapshot.
fn split(bytes: &[u8]) -> Option<(Header, &[u8])> {
    let rest = bytes.strip_prefix(MAGIC)?;
    let line = rest.iter().position(|&byte| byte == b'\n')?;
    Some((serde_json::from_slice(&rest[..line]).ok()?, &rest[line + 1..]))
}
