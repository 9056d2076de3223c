//! Rotations of two bodies on each other at a contact: rolling and spinning, and whether friction holds them.

use super::friction_mode::FrictionMode;
use super::slip_directions::SlipDirections;
use crate::collision::{friction, slip_directions};
use crate::model::{Model, tolerances};
use polhode_spatial::DVec3;

/// A kind of rotation of two bodies on each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Turn {
    /// About an axis in the tangent plane.
    Rolling,
    /// About the normal.
    Spinning,
}

impl Turn {
    /// Both kinds.
    pub(crate) const ALL: [Self; 2] = [Self::Rolling, Self::Spinning];

    /// Axes of its rows at a contact with this normal and tangents, on which bodies slip in these directions.
    pub(crate) fn axes(self, normal: DVec3, (basis, slip): (&[DVec3; 2], SlipDirections)) -> Vec<DVec3> {
        match self {
            Self::Rolling => slip.rolling_axes(basis).to_vec(),
            Self::Spinning => vec![normal],
        }
    }

    /// The length of its friction between two bodies, m; none without it, and of spinning in planar motion.
    pub(crate) fn friction(self, model: &Model, (a, b): (usize, usize)) -> Option<f64> {
        let friction = friction::rotational_friction_of(model, a, b)?;
        let length = match self {
            Self::Rolling => friction.rolling,
            Self::Spinning if slip_directions::slip_directions(model, (a, b)) == SlipDirections::First => return None,
            Self::Spinning => friction.spinning,
        };
        (length > 0.0).then_some(length)
    }

    /// Its friction between two bodies in the rows of their rotations: its length over that of the rows (no unit); none
    /// without it.
    pub(crate) fn coefficient(self, model: &Model, (a, b): (usize, usize)) -> Option<f64> {
        Some(self.friction(model, (a, b))? / tolerances::turning_length(model, a, b))
    }

    /// The part of a relative angular velocity (rad/s) that is of this kind.
    pub(crate) fn part(self, rotation: DVec3, normal: DVec3) -> DVec3 {
        let along = normal * normal.dot(rotation);
        match self {
            Self::Rolling => rotation - along,
            Self::Spinning => along,
        }
    }
}

/// Whether the rotations at a contact are held or turn, by kind; none without friction of the kind, and where that is
/// to be found from its moments. The slip of such a mode is an angular velocity, rad/s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct RotationModes([Option<FrictionMode>; 2]);

impl RotationModes {
    /// Those that `of` gives for each kind.
    pub(crate) fn of(of: impl FnMut(Turn) -> Option<FrictionMode>) -> Self {
        Self(Turn::ALL.map(of))
    }

    /// That of a kind.
    pub(crate) fn get(&self, turn: Turn) -> Option<FrictionMode> {
        self.0[turn as usize]
    }

    /// The kinds that friction holds at zero.
    pub(crate) fn held(self) -> impl Iterator<Item = Turn> {
        Turn::ALL.into_iter().filter(move |&turn| self.get(turn) == Some(FrictionMode::Sticking))
    }

    /// Whether there is none of either kind.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.iter().all(Option::is_none)
    }
}
