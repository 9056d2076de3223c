//! Overlays of pictures: velocities, angular velocities, forces and paths, which pages draw too.

use crate::shown_scene::ShownScene;
use polhode::Frame;
use polhode::spatial::DVec3;

/// What is drawn over the bodies of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Overlay {
    /// The velocity of each centre of mass.
    Velocities,
    /// The angular velocity of each body.
    Spins,
    /// The force at each contact on a body that moves, and that of each joint on its first body.
    Forces,
    /// Where bodies have been.
    Traces,
    /// The name of each body that moves.
    Names,
}

impl Overlay {
    /// All of them, with their names.
    pub const ALL: [(&str, Self); 5] = [
        ("velocities", Self::Velocities),
        ("spins", Self::Spins),
        ("forces", Self::Forces),
        ("traces", Self::Traces),
        ("names", Self::Names),
    ];

    /// The overlay of this name, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, overlay)| *overlay)
    }
}

/// Where a force comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TouchKind {
    Contact,
    Joint,
}

/// A force of a contact or a joint.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Touch {
    pub(crate) kind: TouchKind,
    /// Where, m.
    pub(crate) place: DVec3,
    /// On a body that moves, N.
    pub(crate) force: DVec3,
}

impl Touch {
    /// Those of a frame.
    pub(crate) fn of_frame(frame: &Frame, shown: &ShownScene) -> Vec<Self> {
        let contacts = frame.contacts.iter().map(|contact| {
            // The normal points from B to A: a force along it is what A feels; where A stands, what B feels.
            let moves = shown.bodies.get(contact.body_a.index()).is_some_and(|body| body.moves);
            let sign = if moves { 1.0 } else { -1.0 };
            let force = contact.normal * (sign * contact.normal_force_n);
            Self { kind: TouchKind::Contact, place: contact.point_m, force }
        });
        let loads = frame.joint_loads.iter();
        let loads = loads.map(|load| Self { kind: TouchKind::Joint, place: load.point_m, force: load.force_n });
        contacts.chain(loads).filter(|touch| touch.force.is_finite()).collect()
    }
}
