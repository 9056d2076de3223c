//! Tracks: curves that points of bodies follow, and how a joint holds a point to one.

use polhode_spatial::UnitVector;

/// Least sine of the angle between the reference direction and the track (no unit, 1e-3 to 0.1): where they are
/// parallel no direction is at right angles to both.
pub(crate) const LEAST_SINE: f64 = 1e-2;

/// The handle of a track of a scene: its number in the order in which tracks were added, from 0.
///
/// [`SceneBuilder::add_track`](crate::scene::SceneBuilder::add_track) returns it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct TrackId(usize);

impl TrackId {
    /// The track of this number. Whether there is one is checked where the handle is used.
    pub const fn new(number: usize) -> Self {
        Self(number)
    }

    /// Its number, which is its place in [`Scene::tracks`](crate::scene::Scene::tracks).
    pub const fn index(self) -> usize {
        self.0
    }
}

/// How a track holds a point of a body.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrackHold {
    /// From both sides, as a wire holds a bead.
    Both(Follows),
    /// In its plane, and there from one side: it pushes, but does not pull. The body may leave it and land on it again.
    OneSide(OneSide),
    /// By springs and dampers across it in the place of a constraint (thesis, section on penalty methods).
    Springs(TrackSprings),
}

/// What of a body follows a track that holds it from both sides.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum Follows {
    /// A point: the body turns about it freely.
    #[default]
    Point,
    /// The tangent too: the direction of the body along the track at the start stays along it, and the body rolls about
    /// it freely.
    Tangent,
    /// The tangent, and a direction at right angles to it: the body does not turn against the track. The body does not
    /// lean sideways against `up` (world at the start), which is nowhere along the track; without it, against the
    /// normal of the plane of the track.
    Frame {
        /// The direction; none for the normal of the plane.
        up: Option<UnitVector>,
    },
}

/// A track that only pushes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneSide {
    /// Points to the side to which it pushes, at the place of the track nearest to the body at the start, world.
    pub towards: UnitVector,
    /// Coefficient of restitution where the body lands on it.
    pub restitution: f64,
}

/// Springs and dampers across a track.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackSprings {
    /// Force for each metre from the track, N/m.
    pub stiffness: f64,
    /// Force against each m/s across the track, N s/m.
    pub damping: f64,
    /// Distance from the track beyond which there is no force, m: infinite where they never let go.
    pub reach: f64,
}

/// What happens at the ends of an open track.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum TrackEnds {
    /// The body leaves the track and is free from then on.
    #[default]
    Free,
    /// The body is stopped there, with this coefficient of restitution.
    Stops(f64),
    /// The track goes on straight.
    Straight,
}
