//! How a body is held at its pivot: by rows, or in a frame in which turning alone is left (`pivots.rs`), and where.

use crate::effects::Effects;
use crate::scene::{Body, Integrator, Tier};
use crate::settings::Settings;
use polhode_spatial::{DVec3, Pose, Velocity};

/// Which pivoted bodies are held by rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum PivotRows {
    /// None: turning is all that is left of them.
    #[default]
    None,
    /// Those that something may touch.
    WhereTouched,
    /// All.
    All,
}

impl PivotRows {
    /// For a run of this kind: the tiers of fixed steps, and the methods that step bodies one by one, know no rows.
    pub(crate) fn of(settings: &Settings, effects: Effects) -> Self {
        let solves_rows = matches!(settings.asked_integrator, None | Some(Integrator::Dop853 | Integrator::Rk4));
        match effects {
            _ if settings.tier != Tier::Accurate || !solves_rows => Self::None,
            Effects::Planned => Self::WhereTouched,
            Effects::All => Self::All,
        }
    }
}

/// What is left of the motion of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PivotForm {
    /// Of a pivoted one turning alone; of any other everything.
    Turning,
    /// Everything: rows hold the pivot.
    Rows,
}

impl PivotRows {
    /// How a body is held that something may touch, or not.
    pub(crate) fn form(self, body: &Body, may_collide: impl FnOnce() -> bool) -> PivotForm {
        let by_rows = body.pivot_point().is_some()
            && match self {
                Self::None => false,
                Self::WhereTouched => may_collide(),
                Self::All => true,
            };
        if by_rows { PivotForm::Rows } else { PivotForm::Turning }
    }
}

/// The point of a body that rows hold.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HeldPoint {
    /// Where it is held, world, m.
    pub(crate) place: DVec3,
    /// From the centre of mass to it, in body axes, m.
    pub(crate) arm: DVec3,
}

impl HeldPoint {
    /// Of a body of the scene, if it has a pivot.
    pub(crate) fn of(body: &Body) -> Option<Self> {
        let (place, properties) = (body.pivot_point()?, body.mass_properties()?);
        let arm = body.initial_pose().inverse_transform_point(place) - properties.center_of_mass();
        Some(Self { place, arm })
    }

    /// The velocity of the centre of mass of a body that turns about the point with this angular velocity.
    pub(crate) fn turning(&self, pose: &Pose, angular: DVec3) -> Velocity {
        Velocity::new(pose.rotation.rotate(self.arm).cross(angular), angular)
    }
}
