//! How a body is held at its pivot: by constraint rows, or by a reduction of its motion to rotation about the pivot
//! (`pivots.rs`).

use crate::scene::Body;
use polhode_spatial::{DVec3, Pose, Velocity};

/// Which pivoted bodies constraint rows hold; the motion of the others is reduced to rotation about the pivot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum PivotRows {
    /// None.
    #[default]
    None,
    /// Those that may collide.
    WhereColliding,
    /// All.
    All,
}

/// The form of the motion of a body in the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PivotForm {
    /// The motion of a pivoted body is reduced to rotation about the pivot; that of any other body is not reduced.
    Reduced,
    /// The motion is not reduced, and constraint rows hold the pivot.
    Rows,
}

impl PivotForm {
    /// That of a body that a joint holds too: what the joint gives to it must reach the pivot, by rows, in every tier
    /// that takes joints.
    pub(crate) fn jointed(body: &Body) -> Self {
        if body.pivot_point().is_some() { Self::Rows } else { Self::Reduced }
    }
}

impl PivotRows {
    /// The form of a body's motion; `may_collide` says whether the body may.
    pub(crate) fn form(self, body: &Body, may_collide: impl FnOnce() -> bool) -> PivotForm {
        let by_rows = body.pivot_point().is_some()
            && match self {
                Self::None => false,
                Self::WhereColliding => may_collide(),
                Self::All => true,
            };
        if by_rows { PivotForm::Rows } else { PivotForm::Reduced }
    }
}

/// The point of a body that constraint rows hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HeldPoint {
    /// The pivot: the point of the world at which it is held, m.
    pub(crate) place: DVec3,
    /// Arm from the centre of mass to the point, in body axes, m.
    pub(crate) arm: DVec3,
}

impl HeldPoint {
    /// The held point of a body of the scene; none for a body without a pivot or without mass.
    pub(crate) fn of(body: &Body) -> Option<Self> {
        let (place, properties) = (body.pivot_point()?, body.mass_properties()?);
        let arm = body.initial_pose().inverse_transform_point(place) - properties.center_of_mass();
        Some(Self { place, arm })
    }

    /// The velocity of a body that turns about the point with this angular velocity.
    pub(crate) fn velocity_of_rotation(&self, pose: &Pose, angular: DVec3) -> Velocity {
        Velocity::new(pose.rotation.rotate(self.arm).cross(angular), angular)
    }
}
