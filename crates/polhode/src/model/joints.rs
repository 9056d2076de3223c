//! What holds bodies together: the joints of a scene and those that a program adds, gears and prescribed motions.

use crate::constraint::joint::{AddedJoint, ModelJoint};
use crate::constraint::tie::Tie;
use crate::identity::contact_id::Feature;
use crate::scene::{Coordinate, Motor};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The joints of all bodies, by their numbers, and who is held by which.
#[derive(Debug, Clone)]
pub(crate) struct Joints {
    pub(crate) list: Vec<ModelJoint>,
    /// Which of them hold a movable body.
    pub(crate) of_body: BTreeMap<usize, Vec<usize>>,
    /// Bodies that constraint rows hold at their pivots or joints, ascending.
    pub(crate) held_by_rows: Vec<usize>,
    /// The kinematic bodies that joints and ties hold, ascending.
    pub(crate) drivers: Vec<usize>,
    /// The bodies that carry prescribed motions of joints.
    pub(crate) carriages: Range<usize>,
    /// Joints that hold nothing any more: they have broken, or their bodies have run off the ends of their tracks.
    pub(crate) released: BTreeMap<usize, ModelJoint>,
    /// The poses of bodies at which a program has added joints.
    pub(crate) added: Vec<AddedJoint>,
    /// The joints of the scene that may break.
    pub(crate) breakable: BTreeSet<usize>,
    /// Gears and prescribed motions of joints.
    pub(crate) ties: Vec<Tie>,
    /// Which of them hold a movable body.
    pub(crate) ties_of_body: BTreeMap<usize, Vec<usize>>,
    /// The contacts at joints, by their pairs of bodies, ascending.
    pub(crate) contacts: BTreeMap<(usize, usize), Vec<Feature>>,
    /// The bodies that a body has such contacts with, itself for those with the world.
    pub(crate) contact_partners: BTreeMap<usize, BTreeSet<usize>>,
    /// Whether any joint has friction.
    pub(crate) have_friction: bool,
    /// The motors that a program has given coordinates; none where it has taken one away.
    pub(crate) motors: BTreeMap<(usize, Coordinate), Option<Motor>>,
    /// How many joints are on tracks that let go at their ends.
    pub(crate) ending_tracks: usize,
}

impl Joints {
    /// None yet, of a scene some of whose joints may break, and some of whose bodies carry prescribed motions of
    /// joints.
    pub(super) fn none(breakable: BTreeSet<usize>, carriages: Range<usize>) -> Self {
        Self {
            list: Vec::new(),
            of_body: BTreeMap::new(),
            held_by_rows: Vec::new(),
            drivers: Vec::new(),
            carriages,
            released: BTreeMap::new(),
            added: Vec::new(),
            breakable,
            ties: Vec::new(),
            ties_of_body: BTreeMap::new(),
            contacts: BTreeMap::new(),
            contact_partners: BTreeMap::new(),
            have_friction: false,
            motors: BTreeMap::new(),
            ending_tracks: 0,
        }
    }
}
