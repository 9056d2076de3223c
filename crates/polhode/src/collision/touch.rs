//! Contacts as the engine holds them: found, touching, and whether they hold.

use super::contact_modes::ContactModes;
use super::turn::Turn;
use crate::identity::contact_id::ContactId;
use polhode_contact::ContactKinematics;

/// Whether a touching contact is active until the next event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hold {
    /// It is active: a force keeps its relative acceleration along the normal at zero.
    Held,
    /// It opens or separates: no force acts.
    Open,
}

/// A contact as collision detection finds it. It is smaller than a [`Touch`]: most are looked at once, and dropped.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FoundContact {
    pub(crate) id: ContactId,
    pub(crate) kinematics: ContactKinematics,
}

/// A pair of bodies that are near each other.
#[derive(Debug)]
pub(crate) struct Pair {
    /// m; infinite when it exceeds the reach. It may be more negative than that of any contact.
    pub(crate) separation: f64,
    /// Sorted by feature.
    pub(crate) contacts: Vec<FoundContact>,
    /// Whether contacts with the plane of a face took the place of some at which the bodies would collide.
    pub(crate) is_passing: bool,
}

impl Pair {
    /// Bodies beyond the reach.
    pub(super) const fn far() -> Self {
        Self { separation: f64::INFINITY, contacts: Vec::new(), is_passing: false }
    }
}

/// A touching contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch {
    pub(crate) id: ContactId,
    pub(crate) kinematics: ContactKinematics,
    pub(crate) hold: Hold,
    /// Whether `hold` has been decided; it has not for a contact that has just been found.
    pub(crate) known: bool,
    /// Whether its features define a contact in the present states; where they do not, `kinematics` are of states
    /// before.
    pub(crate) is_defined: bool,
    pub(crate) modes: ContactModes,
}

impl Touch {
    /// An active contact.
    pub(crate) fn held(id: ContactId, kinematics: ContactKinematics, modes: ContactModes) -> Self {
        Self { id, kinematics, hold: Hold::Held, known: true, is_defined: true, modes }
    }
}

/// A contact that has just been found is open until its status is decided.
impl From<FoundContact> for Touch {
    fn from(FoundContact { id, kinematics }: FoundContact) -> Self {
        Self { id, kinematics, hold: Hold::Open, known: false, is_defined: true, modes: ContactModes::default() }
    }
}

impl Touch {
    /// Its rotations that friction holds at zero.
    pub(crate) fn held_turns(&self) -> impl Iterator<Item = (ContactId, Turn)> {
        let id = self.id;
        self.modes.rotation.held().map(move |turn| (id, turn))
    }
}
