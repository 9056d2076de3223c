//! A contact with friction among the rows of a group: its coefficients, the directions in which it may slip, and how it
//! slides.
//!
//! Instants, stages, impacts and time steps make it here; they differ in the mode that they hand in: the one in which
//! the contact is known to be, or none where that is to be found.

use crate::collision::friction_mode::{FrictionCoefficients, FrictionMode};
use crate::collision::slip_directions::{self, SlipDirections};
use crate::collision::touch::Touch;
use crate::collision::turn::Turn;
use crate::collision::{contact_kinematics, friction};
use crate::identity::contact_id::ContactId;
use crate::model::Model;
use crate::rows::assembly::TangentRow;
use crate::rows::friction_blocks::push_contact;
use crate::scene::FrictionEllipse;
use polhode_contact::{ContactGeometry, TangentialKinematics};
use polhode_dynamics::BodyState;
use polhode_response::{Blocks, Law};
use polhode_spatial::DVec3;
use std::ops::Range;

/// A contact with friction among the rows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrictionalContact {
    pub(crate) id: ContactId,
    pub(crate) geometry: ContactGeometry,
    pub(crate) terms: TangentialKinematics,
    pub(crate) coefficients: FrictionCoefficients,
    /// The directions in which it may slip.
    pub(crate) slip: SlipDirections,
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

impl FrictionalContact {
    /// That of a contact which slides or sticks as this mode says; it sticks without one. None without friction.
    pub(crate) fn of(
        model: &Model,
        states: &[BodyState],
        (id, geometry): (ContactId, ContactGeometry),
        mode: Option<FrictionMode>,
    ) -> Option<Self> {
        friction::friction_of(model, id)?;
        let terms = contact_kinematics::tangential_kinematics(model, states, id)?;
        let coefficients = friction::friction_at(model, states, id, terms.basis)?;
        let slip = slip_directions::slip_directions(model, (id.a, id.b));
        let own = Self { id, geometry, terms, coefficients, slip, sliding: None };
        Some(match mode {
            None | Some(FrictionMode::Sticking) => own,
            Some(FrictionMode::Sliding(slide)) => own.sliding_along(slide.direction_of(terms.slip_velocity)),
        })
    }

    /// That of a touching contact with its mode.
    pub(crate) fn of_touch(model: &Model, states: &[BodyState], touch: &Touch) -> Option<Self> {
        Self::of(model, states, (touch.id, touch.kinematics.geometry), touch.modes.friction)
    }

    /// The same, which slides in this direction (unit vector, world).
    pub(crate) fn sliding_along(self, direction: DVec3) -> Self {
        let (row, coefficient) = self.coefficients.sliding.opposed(self.terms.basis, direction);
        Self { sliding: Some(Sliding { direction, row, coefficient }), ..self }
    }

    /// The directions of its rows in the tangent plane.
    pub(crate) fn tangents(&self) -> Vec<DVec3> {
        self.sliding.map_or_else(|| self.slip.tangents(&self.terms.basis).to_vec(), |sliding| vec![sliding.row])
    }

    /// The row along a tangent (unit vector, world).
    pub(crate) fn row_along(&self, tangent: DVec3) -> TangentRow {
        TangentRow::new(self.id, &self.geometry, &self.terms, tangent)
    }

    /// Its rows in the tangent plane.
    pub(crate) fn rows(&self) -> impl Iterator<Item = TangentRow> + '_ {
        self.tangents().into_iter().map(|tangent| self.row_along(tangent))
    }

    /// The axes of a rotation of its bodies (unit vectors, world).
    pub(crate) fn axes_of(&self, turn: Turn) -> Vec<DVec3> {
        turn.axes(self.geometry.normal, (&self.terms.basis, self.slip))
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
}
