//! All quantities, with their units and the words for them.

use polhode::Efforts;
use polhode::scene::Coordinate;

/// A quantity of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfBody {
    /// Of its origin, m.
    Position,
    /// A quaternion w, x, y, z.
    Orientation,
    /// Of its centre of mass, m/s.
    Velocity,
    /// rad/s.
    AngularVelocity,
}

/// A cause of what acts along a coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// A motor, or a prescribed motion.
    Drive,
    /// Gears.
    Gear,
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// Dry friction.
    Friction,
    /// Limits.
    Limit,
}

/// Along which coordinate of a joint something acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    /// About the axis: a torque, N m.
    Angle,
    /// Along the line of a displacement or a distance: a force, N.
    Line,
}

/// A quantity of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfJoint {
    /// The value of a coordinate, rad or m.
    Value(Coordinate),
    /// Its rate, rad/s or m/s.
    Rate(Coordinate),
    /// What it gives to its bodies, W.
    Power,
    /// What acts along a coordinate by a cause.
    Effort(Along, Cause),
    /// What its drive gives along a coordinate, as what is asked of the joint.
    ByDrive(Along),
    /// All that acts along a coordinate.
    All(Along),
    /// Its force on its first body, world, N: without springs, dampers and motors.
    Force,
    /// The moment of that about its anchor, world, N m.
    Moment,
    /// What it keeps by, in its own axes: force, N.
    ReactionForce,
    /// The same: moment, N m.
    ReactionMoment,
}

/// A quantity of the contacts of two bodies, or of one with all others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfContacts {
    /// Sum of the forces along normals, N.
    NormalForce,
    /// Sum of all forces on the body that is named first, world, N.
    Force,
    /// Sum of the forces of friction on it, world, N.
    Friction,
    /// The least separation of those that touch, m.
    Separation,
    /// How many points touch.
    Points,
}

/// An energy of the whole scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OfEnergy {
    /// Kinetic.
    Kinetic,
    /// Potential.
    Potential,
    /// Both.
    Total,
}

pub(super) const OF_BODY: [(&str, OfBody); 4] = [
    ("position", OfBody::Position),
    ("orientation", OfBody::Orientation),
    ("velocity", OfBody::Velocity),
    ("angular_velocity", OfBody::AngularVelocity),
];

/// The causes of what acts along a coordinate, with their words.
pub(crate) const CAUSES: [(&str, Cause); 6] = [
    ("drive", Cause::Drive),
    ("gear", Cause::Gear),
    ("spring", Cause::Spring),
    ("damper", Cause::Damper),
    ("friction", Cause::Friction),
    ("limit", Cause::Limit),
];

/// What acts along coordinates, under the names of the columns of a table of joints.
pub(crate) const EFFORTS: [(&str, OfJoint); 12] = [
    ("drive_torque", OfJoint::Effort(Along::Angle, Cause::Drive)),
    ("gear_torque", OfJoint::Effort(Along::Angle, Cause::Gear)),
    ("spring_torque", OfJoint::Effort(Along::Angle, Cause::Spring)),
    ("damper_torque", OfJoint::Effort(Along::Angle, Cause::Damper)),
    ("friction_torque", OfJoint::Effort(Along::Angle, Cause::Friction)),
    ("limit_torque", OfJoint::Effort(Along::Angle, Cause::Limit)),
    ("drive_force", OfJoint::Effort(Along::Line, Cause::Drive)),
    ("gear_force", OfJoint::Effort(Along::Line, Cause::Gear)),
    ("spring_force", OfJoint::Effort(Along::Line, Cause::Spring)),
    ("damper_force", OfJoint::Effort(Along::Line, Cause::Damper)),
    ("friction_force", OfJoint::Effort(Along::Line, Cause::Friction)),
    ("limit_force", OfJoint::Effort(Along::Line, Cause::Limit)),
];

/// All quantities of joints but those along coordinates.
pub(super) const OF_JOINT: [(&str, OfJoint); 13] = [
    ("angle", OfJoint::Value(Coordinate::Angle)),
    ("angle_rate", OfJoint::Rate(Coordinate::Angle)),
    ("displacement", OfJoint::Value(Coordinate::Displacement)),
    ("displacement_rate", OfJoint::Rate(Coordinate::Displacement)),
    ("distance", OfJoint::Value(Coordinate::Distance)),
    ("distance_rate", OfJoint::Rate(Coordinate::Distance)),
    ("torque", OfJoint::All(Along::Angle)),
    ("effort", OfJoint::All(Along::Line)),
    ("power", OfJoint::Power),
    ("force", OfJoint::Force),
    ("moment", OfJoint::Moment),
    ("reaction_force", OfJoint::ReactionForce),
    ("reaction_moment", OfJoint::ReactionMoment),
];

pub(super) const OF_CONTACTS: [(&str, OfContacts); 5] = [
    ("normal_force", OfContacts::NormalForce),
    ("force", OfContacts::Force),
    ("friction", OfContacts::Friction),
    ("separation", OfContacts::Separation),
    ("points", OfContacts::Points),
];

pub(super) const OF_ENERGY: [(&str, OfEnergy); 3] =
    [("kinetic", OfEnergy::Kinetic), ("potential", OfEnergy::Potential), ("total", OfEnergy::Total)];

/// Columns of the joints file: time (s), the joint, its coordinates with their rates (rad, rad/s, m, m/s; empty where
/// the joint has no such coordinate), the force (N) and the moment (N m) on its first body at its anchor in the world,
/// the power that it gives to its bodies (W); then what acts along its coordinates by its cause, about the axis of an
/// angle (N m) and along the line of a displacement or a distance (N); and what it keeps by, in its own axes.
pub const JOINT_COLUMNS: [&str; 33] = [
    "t",
    "joint",
    "angle",
    "angle_rate",
    "displacement",
    "displacement_rate",
    "distance",
    "distance_rate",
    "fx",
    "fy",
    "fz",
    "mx",
    "my",
    "mz",
    "power",
    EFFORTS[0].0,
    EFFORTS[1].0,
    EFFORTS[2].0,
    EFFORTS[3].0,
    EFFORTS[4].0,
    EFFORTS[5].0,
    EFFORTS[6].0,
    EFFORTS[7].0,
    EFFORTS[8].0,
    EFFORTS[9].0,
    EFFORTS[10].0,
    EFFORTS[11].0,
    "reaction_fx",
    "reaction_fy",
    "reaction_fz",
    "reaction_mx",
    "reaction_my",
    "reaction_mz",
];

impl OfBody {
    /// How many components it has.
    pub const fn size(self) -> usize {
        match self {
            Self::Orientation => 4,
            Self::Position | Self::Velocity | Self::AngularVelocity => 3,
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Position => "m",
            Self::Orientation => "",
            Self::Velocity => "m/s",
            Self::AngularVelocity => "rad/s",
        }
    }
}

impl Cause {
    /// Its part of what acts along a coordinate.
    pub(crate) const fn of(self, efforts: &Efforts) -> f64 {
        match self {
            Self::Drive => efforts.drive,
            Self::Gear => efforts.gear,
            Self::Spring => efforts.spring,
            Self::Damper => efforts.damper,
            Self::Friction => efforts.friction,
            Self::Limit => efforts.limit,
        }
    }
}

impl Along {
    /// Whether a coordinate is the one that is meant.
    pub(crate) const fn is(self, coordinate: Coordinate) -> bool {
        matches!(coordinate, Coordinate::Angle) == matches!(self, Self::Angle)
    }

    const fn unit(self) -> &'static str {
        match self {
            Self::Angle => "N m",
            Self::Line => "N",
        }
    }
}

impl OfJoint {
    /// How many components it has; 0 of one number.
    pub const fn size(self) -> usize {
        match self {
            Self::Force | Self::Moment | Self::ReactionForce | Self::ReactionMoment => 3,
            _ => 0,
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Value(Coordinate::Angle) => "rad",
            Self::Value(_) => "m",
            Self::Rate(Coordinate::Angle) => "rad/s",
            Self::Rate(_) => "m/s",
            Self::Power => "W",
            Self::Effort(along, _) | Self::ByDrive(along) | Self::All(along) => along.unit(),
            Self::Force | Self::ReactionForce => "N",
            Self::Moment | Self::ReactionMoment => "N m",
        }
    }

    /// The word for what acts along a coordinate, and its parts with theirs; none of other quantities.
    pub(super) fn causes(self) -> Option<(&'static str, Vec<(Self, &'static str)>)> {
        let (along, word, shown) = match self {
            Self::All(along) => (along, "all", None),
            Self::ByDrive(along) => (along, "drive", Some(Cause::Drive)),
            _ => return None,
        };
        let others = CAUSES.into_iter().filter(|(_, cause)| Some(*cause) != shown);
        Some((word, others.map(|(word, cause)| (Self::Effort(along, cause), word)).collect()))
    }
}

impl OfContacts {
    /// How many components it has; 0 of one number.
    pub const fn size(self) -> usize {
        match self {
            Self::Force | Self::Friction => 3,
            Self::NormalForce | Self::Separation | Self::Points => 0,
        }
    }

    /// Its unit.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::NormalForce | Self::Force | Self::Friction => "N",
            Self::Separation => "m",
            Self::Points => "",
        }
    }
}

/// All quantities, in a line.
pub fn accepted() -> String {
    let words = |all: &[&str]| all.join(", ");
    let of_joints: Vec<&str> = OF_JOINT.iter().map(|own| own.0).chain(CAUSES.map(|own| own.0)).collect();
    format!(
        "of a body {}; of a joint {}; of contacts {}; energy.{}",
        words(&OF_BODY.map(|own| own.0)),
        words(&of_joints),
        words(&OF_CONTACTS.map(|own| own.0)),
        OF_ENERGY.map(|own| own.0).join(", energy."),
    )
}
