//! The surfaces of the bodies: whether any two collide, and what friction does between them.

use crate::scene::Scene;

/// The friction that any two bodies which may collide have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum FrictionKinds {
    /// None.
    None,
    /// Friction of slip.
    OfSlip,
    /// Friction of rolling or spinning too.
    OfRotation,
}

impl FrictionKinds {
    fn of(scene: &Scene) -> Self {
        let colliding = scene.colliding();
        match colliding.have_friction() {
            false => Self::None,
            true if colliding.largest_rotational_friction > 0.0 => Self::OfRotation,
            true => Self::OfSlip,
        }
    }
}

/// What the surfaces of all bodies do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Surfaces {
    /// Any two bodies may collide.
    collide: bool,
    /// The friction of bodies that may collide.
    friction: FrictionKinds,
    /// Friction of two bodies that may collide depends on the direction.
    have_grain: bool,
    /// The surface of a body moves.
    are_driven: bool,
}

impl Surfaces {
    /// Those of the bodies of a scene.
    pub(super) fn of(scene: &Scene) -> Self {
        Self {
            collide: scene.any_may_collide(),
            friction: FrictionKinds::of(scene),
            have_grain: scene.has_grain(),
            are_driven: scene.has_moving_surfaces(),
        }
    }

    /// Whether any two bodies may collide.
    pub(crate) const fn may_collide(self) -> bool {
        self.collide
    }

    /// Whether any two bodies that may collide have friction.
    pub(crate) fn have_friction(self) -> bool {
        self.friction != FrictionKinds::None
    }

    /// Whether any two have friction of rolling or spinning.
    pub(crate) fn have_rotational_friction(self) -> bool {
        self.friction == FrictionKinds::OfRotation
    }

    /// Whether friction of any two depends on the direction.
    pub(crate) const fn have_grain(self) -> bool {
        self.have_grain
    }

    /// Whether the surface of any body moves.
    pub(crate) const fn are_driven(self) -> bool {
        self.are_driven
    }
}
