//! Snapshots: a simulation at one time, to be stored. A run that continues from a snapshot has the same bits as one
//! that was never stopped.
//!
//! | module | holds |
//! |---|---|
//! | `content` | the plain data from which a run continues |
//! | `springs` | that of the tier `penalty` |
//! | `numbers`, `parts` | vectors, states, contacts and flight records as plain data |
//! | `envelope` | the header of the bytes: version, length, checksum |
//! | `hash` | the hash of a scene |
//! | `error` | why a snapshot is refused |
//!
//! The bytes are in the format postcard, in which numbers keep their bits. They do not depend on the platform. Another
//! version of the program that reads them need not compute the same bits from them.

pub(crate) mod content;
mod envelope;
mod error;
mod hash;
pub(crate) mod numbers;
pub(crate) mod parts;
pub(crate) mod springs;

pub use error::SnapshotError;

use crate::constraint::joint::AddedJoint;
use crate::scene::Scene;
use crate::scene::effects::Effects;
use content::Content;
use serde::{Deserialize, Serialize};

/// A simulation at one time: [`crate::Simulation::snapshot`] takes it, [`crate::Simulation::restore`] restores it.
///
/// It converts to and from bytes; serde writes it as these bytes.
///
/// ```
/// use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Velocity};
/// use polhode::{Body, Scene, Simulation, Snapshot};
/// let inertia = Inertia::from_diagonal(DVec3::new(1.0, 2.0, 3.0))?;
/// let body = Body::movable("nut", MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))
///     .velocity(Velocity::new(DVec3::ZERO, DVec3::new(0.01, 2.0, 0.01)));
/// let scene = Scene::builder("nut").duration_s(10.0).body(body).build()?;
/// let mut simulation = Simulation::new(&scene)?;
/// simulation.advance_to(4.0)?;
/// let bytes = simulation.snapshot().to_bytes();
/// let whole = simulation.run()?;
/// let mut other = Simulation::new(&scene)?;
/// other.restore(&Snapshot::from_bytes(&bytes)?)?;
/// assert_eq!(other.time(), 4.0);
/// assert_eq!(other.run()?.bodies, whole.bodies);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(into = "Vec<u8>", try_from = "Vec<u8>")]
pub struct Snapshot {
    content: Content,
}

impl Snapshot {
    /// The snapshot with this content.
    pub(crate) const fn new(content: Content) -> Self {
        Self { content }
    }

    /// The content, if it is of this scene and these effects.
    ///
    /// # Errors
    /// When it is not.
    pub(crate) fn content_for(
        &self,
        scene: (&Scene, &[AddedJoint]),
        effects: Effects,
    ) -> Result<&Content, SnapshotError> {
        let (found, own) = (self.content.scene_hash, scene_hash(scene));
        if found != own {
            return Err(SnapshotError::OtherScene { scene: self.content.scene.clone(), found, own });
        }
        let found = self.effects();
        if found != effects {
            return Err(SnapshotError::OtherEffects { found, own: effects });
        }
        Ok(&self.content)
    }

    /// Name of the scene.
    pub fn scene(&self) -> &str {
        &self.content.scene
    }

    /// Hash of the whole scene, including method, duration and output interval.
    pub fn scene_hash(&self) -> u64 {
        self.content.scene_hash
    }

    /// The effects with which the simulation was made.
    pub fn effects(&self) -> Effects {
        if self.content.all_effects { Effects::All } else { Effects::Planned }
    }

    /// Simulated time of the snapshot, s.
    pub fn time(&self) -> f64 {
        self.content.t
    }

    /// The snapshot as bytes, with a version and a checksum.
    pub fn to_bytes(&self) -> Vec<u8> {
        // Writing plain data to memory cannot fail. If it did, the empty content would be refused when it is read.
        envelope::wrap(&postcard::to_stdvec(&self.content).unwrap_or_default())
    }

    /// The snapshot in these bytes.
    ///
    /// # Errors
    /// When the bytes are not a snapshot, have another version, or are incomplete or altered.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, SnapshotError> {
        let content = envelope::unwrap(bytes)?;
        match postcard::take_from_bytes(content) {
            Ok((content, [])) => Ok(Self { content }),
            Ok(_) => Err(SnapshotError::Unreadable("bytes follow its end".to_owned())),
            Err(error) => Err(SnapshotError::Unreadable(error.to_string())),
        }
    }
}

impl From<Snapshot> for Vec<u8> {
    fn from(snapshot: Snapshot) -> Self {
        snapshot.to_bytes()
    }
}

impl TryFrom<Vec<u8>> for Snapshot {
    type Error = SnapshotError;

    fn try_from(bytes: Vec<u8>) -> Result<Self, SnapshotError> {
        Self::from_bytes(&bytes)
    }
}

/// Hash of a whole scene, as [`Snapshot::scene_hash`], with the bodies and joints that a program has added.
pub(crate) fn scene_hash((scene, added): (&Scene, &[AddedJoint])) -> u64 {
    hash::of_scene(scene, added)
}
