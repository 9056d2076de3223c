//! Vectors, states and contacts as plain numbers that keep their bits.

use super::SnapshotError;
use crate::identity::contact_id;
use crate::identity::coordinate_id::CoordinateId;
use crate::identity::stop_id::StopId;
use crate::report::momentum_ledger::Momentum;
use polhode_contact::{ContactFeature, ContactGeometry, ContactKinematics, Side, SurfaceFeature};
use polhode_dynamics::BodyState;
use polhode_dynamics::state::WIDTH;
use polhode_spatial::DVec3;
use serde::{Deserialize, Serialize};

/// x, y, z.
pub(crate) type Vector = [f64; 3];

/// A state in the flat layout of [`polhode_dynamics::state`].
pub(crate) type State = [f64; WIDTH];

/// States as numbers.
pub(crate) fn write_states(states: &[BodyState]) -> Vec<State> {
    states.iter().map(BodyState::to_array).collect()
}

/// A state from numbers.
pub(crate) fn read_state(numbers: &State) -> Result<BodyState, SnapshotError> {
    BodyState::from_stored(numbers).map_err(|_| SnapshotError::Invalid("the attitude of a body is not a rotation"))
}

/// The states of all bodies from numbers; refused unless there is one state for each body.
pub(crate) fn read_states(numbers: &[State], bodies: usize) -> Result<Vec<BodyState>, SnapshotError> {
    if numbers.len() != bodies {
        return Err(SnapshotError::Invalid("it does not have one state for each body"));
    }
    numbers.iter().map(read_state).collect()
}

/// Momentum as numbers.
pub(crate) fn write_momentum(momentum: Momentum) -> [Vector; 2] {
    [momentum.linear.to_array(), momentum.angular.to_array()]
}

/// Momentum from numbers.
pub(crate) fn read_momentum([linear, angular]: [Vector; 2]) -> Momentum {
    Momentum { linear: DVec3::from_array(linear), angular: DVec3::from_array(angular) }
}

/// Identity of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Contact {
    pub(crate) a: usize,
    pub(crate) b: usize,
    pub(crate) feature: Feature,
}

/// [`contact_id::Feature`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Feature {
    VertexFace { vertex_of: Body, vertex: u32, face: u32 },
    EdgeEdge { edge_a: u32, edge_b: u32 },
    Smooth { center_of: Body, center: u32, against: Part },
    SphereSphere,
    Spheres { center_a: u32, center_b: u32 },
    Elements { a: Part, b: Part },
    Stop { joint: u64, stop: u64 },
    JointFriction { joint: u64, coordinate: u64 },
}

/// [`Side`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Body {
    A,
    B,
}

/// [`SurfaceFeature`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) enum Part {
    Face(u32),
    Edge(u32),
    Vertex(u32),
    Sphere,
    Cap(u32),
    Side(u32),
    Rim(u32),
    RimExit(u32),
    RimEntry(u32),
}

impl From<Side> for Body {
    fn from(side: Side) -> Self {
        match side {
            Side::A => Self::A,
            Side::B => Self::B,
        }
    }
}

impl From<Body> for Side {
    fn from(body: Body) -> Self {
        match body {
            Body::A => Self::A,
            Body::B => Self::B,
        }
    }
}

impl From<SurfaceFeature> for Part {
    fn from(feature: SurfaceFeature) -> Self {
        match feature {
            SurfaceFeature::Face(n) => Self::Face(n),
            SurfaceFeature::Edge(n) => Self::Edge(n),
            SurfaceFeature::Vertex(n) => Self::Vertex(n),
            SurfaceFeature::Sphere => Self::Sphere,
            SurfaceFeature::Cap(n) => Self::Cap(n),
            SurfaceFeature::Side(n) => Self::Side(n),
            SurfaceFeature::Rim(n) => Self::Rim(n),
            SurfaceFeature::RimExit(n) => Self::RimExit(n),
            SurfaceFeature::RimEntry(n) => Self::RimEntry(n),
        }
    }
}

impl From<Part> for SurfaceFeature {
    fn from(part: Part) -> Self {
        match part {
            Part::Face(n) => Self::Face(n),
            Part::Edge(n) => Self::Edge(n),
            Part::Vertex(n) => Self::Vertex(n),
            Part::Sphere => Self::Sphere,
            Part::Cap(n) => Self::Cap(n),
            Part::Side(n) => Self::Side(n),
            Part::Rim(n) => Self::Rim(n),
            Part::RimExit(n) => Self::RimExit(n),
            Part::RimEntry(n) => Self::RimEntry(n),
        }
    }
}

impl From<ContactFeature> for Feature {
    fn from(feature: ContactFeature) -> Self {
        match feature {
            ContactFeature::VertexFace { vertex_of, vertex, face } => {
                Self::VertexFace { vertex_of: vertex_of.into(), vertex, face }
            }
            ContactFeature::EdgeEdge { edge_a, edge_b } => Self::EdgeEdge { edge_a, edge_b },
            ContactFeature::Smooth { center_of, center, against } => {
                Self::Smooth { center_of: center_of.into(), center, against: against.into() }
            }
            ContactFeature::SphereSphere => Self::SphereSphere,
            ContactFeature::Spheres { center_a, center_b } => Self::Spheres { center_a, center_b },
            ContactFeature::Elements { a, b } => Self::Elements { a: a.into(), b: b.into() },
        }
    }
}

impl From<contact_id::Feature> for Feature {
    fn from(feature: contact_id::Feature) -> Self {
        match feature {
            contact_id::Feature::Shapes(feature) => feature.into(),
            contact_id::Feature::Stop(StopId { joint, stop }) => Self::Stop { joint: joint as u64, stop: stop as u64 },
            contact_id::Feature::JointFriction(CoordinateId { joint, place }) => {
                Self::JointFriction { joint: joint as u64, coordinate: place as u64 }
            }
        }
    }
}

impl From<Feature> for contact_id::Feature {
    fn from(feature: Feature) -> Self {
        use ContactFeature as Of;
        Self::Shapes(match feature {
            Feature::Stop { joint, stop } => {
                return Self::Stop(StopId { joint: joint as usize, stop: stop as usize });
            }
            Feature::JointFriction { joint, coordinate } => {
                return Self::JointFriction(CoordinateId { joint: joint as usize, place: coordinate as usize });
            }
            Feature::VertexFace { vertex_of, vertex, face } => {
                Of::VertexFace { vertex_of: vertex_of.into(), vertex, face }
            }
            Feature::EdgeEdge { edge_a, edge_b } => Of::EdgeEdge { edge_a, edge_b },
            Feature::Smooth { center_of, center, against } => {
                Of::Smooth { center_of: center_of.into(), center, against: against.into() }
            }
            Feature::SphereSphere => Of::SphereSphere,
            Feature::Spheres { center_a, center_b } => Of::Spheres { center_a, center_b },
            Feature::Elements { a, b } => Of::Elements { a: a.into(), b: b.into() },
        })
    }
}

/// Point, normal, separation, margin, rate of separation, bias of its acceleration.
pub(crate) type Kinematics = [f64; 10];

/// The kinematics of a contact as numbers.
pub(crate) fn write_kinematics(kinematics: &ContactKinematics) -> Kinematics {
    let ContactKinematics { geometry, separation_rate, acceleration_bias } = *kinematics;
    let ContactGeometry { point, normal, separation, margin } = geometry;
    let ([px, py, pz], [nx, ny, nz]) = (point.to_array(), normal.to_array());
    [px, py, pz, nx, ny, nz, separation, margin, separation_rate, acceleration_bias]
}

/// The kinematics of a contact from numbers.
pub(crate) fn read_kinematics(numbers: Kinematics) -> ContactKinematics {
    let [px, py, pz, nx, ny, nz, separation, margin, separation_rate, acceleration_bias] = numbers;
    let geometry =
        ContactGeometry { point: DVec3::new(px, py, pz), normal: DVec3::new(nx, ny, nz), separation, margin };
    ContactKinematics { geometry, separation_rate, acceleration_bias }
}
