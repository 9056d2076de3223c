//! A contact with friction among the rows of a group: its coefficients, its directions, and how it slides.

use crate::collision::friction_mode::{FrictionCoefficients, FrictionMode};
use crate::collision::slip_directions::{self, SlipDirections};
use crate::collision::touch::Touch;
use crate::collision::{contact_kinematics, friction};
use crate::model::Model;
use crate::rows::friction_blocks::push_contact;
use crate::scene::FrictionEllipse;
use polhode_contact::TangentialKinematics;
use polhode_dynamics::BodyState;
use polhode_response::{Blocks, Law};
use polhode_spatial::DVec3;
use std::ops::Range;

/// A contact with friction among the rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Frictional {
    pub(crate) coefficients: FrictionCoefficients,
    pub(crate) terms: TangentialKinematics,
    /// The directions in which it may slip.
    pub(crate) slip: SlipDirections,
    /// The angular velocity of A relative to B, rad/s.
    pub(crate) rotation: DVec3,
    /// How it slides; none when it sticks.
    pub(crate) sliding: Option<Sliding>,
}

/// A contact that slides.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sliding {
    /// The direction of its slip (unit vector, world).
    pub(crate) direction: DVec3,
    /// That of its row: what friction opposes. The direction of the slip, but with a grain.
    pub(crate) row: DVec3,
    /// The coefficient there.
    pub(crate) coefficient: f64,
}

impl Sliding {
    pub(crate) fn along(direction: DVec3, coefficients: &FrictionCoefficients, terms: &TangentialKinematics) -> Self {
        let (row, coefficient) = coefficients.sliding.opposed(terms.basis, direction);
        Self { direction, row, coefficient }
    }
}

impl Frictional {
    pub(crate) fn of(model: &Model, states: &[BodyState], touch: &Touch) -> Option<Self> {
        friction::friction_of(model, touch.id)?;
        let terms = contact_kinematics::tangential_kinematics(model, states, touch.id)?;
        let coefficients = friction::friction_at(model, states, touch.id, terms.basis)?;
        let sliding = match touch.modes.friction {
            None | Some(FrictionMode::Sticking) => None,
            Some(FrictionMode::Sliding(slide)) => Some(slide.direction_of(terms.slip_velocity)),
        };
        let sliding = sliding.map(|direction| Sliding::along(direction, &coefficients, &terms));
        let rotation = contact_kinematics::relative_rotation(model, states, touch.id);
        Some(Self { coefficients, terms, slip: slip_directions::slip_directions(model), rotation, sliding })
    }

    /// Adds the block of a contact with these rows: what they ask for together.
    pub(crate) fn push_block(friction: Option<&Self>, blocks: &mut Blocks, normal: usize, tangents: Range<usize>) {
        match friction {
            None => push_contact(blocks, FrictionEllipse::default(), normal, tangents),
            Some(Self { sliding: Some(sliding), .. }) => {
                let block = Law::Slide { friction: sliding.coefficient };
                blocks.push(block, std::iter::once(normal).chain(tangents));
            }
            Some(Self { coefficients, .. }) => push_contact(blocks, coefficients.at_rest, normal, tangents),
        }
    }

    /// The directions of its rows in the tangent plane.
    pub(crate) fn tangents(&self) -> Vec<DVec3> {
        self.sliding.map_or_else(|| self.slip.tangents(&self.terms.basis).to_vec(), |sliding| vec![sliding.row])
    }
}
