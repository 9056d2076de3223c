//! The quantities of bodies, joints and contacts by name: one list for tables, plots and what a sweep measures.
//!
//! | form | is |
//! |---|---|
//! | `bodies.box.position[2]`, `position[z]:box` | a component of a quantity of a body |
//! | `joints.crank.torque`, `joint-torque:crank`, `torque:crank` | a quantity of a joint |
//! | `contacts.box/floor.normal_force`, `normal_force:box/floor` | of all contacts of two bodies together |
//! | `contacts.box.force` | of all contacts of a body, on it |
//! | `energy.kinetic` | an energy of the whole scene |
//!
//! A vector without a component is all of it: three curves of a plot, a length where one number is needed. Components
//! are numbers from 0 on or letters, `x y z` and of an orientation `w x y z`. `-` may stand for `_`. Signs are those of
//! what acts on the first body of a joint, and on the first body named of contacts.
//!
//! | module | holds |
//! |---|---|
//! | `list` | all quantities, with their units and the words for them |
//! | `parse` | from a text to a quantity of a scene |
//! | `value` | the value of a quantity in a sample |

mod list;
mod parse;
mod value;

pub(crate) use list::EFFORTS;
pub use list::{Along, Cause, JOINT_COLUMNS};
pub use list::{OfBody, OfContacts, OfEnergy, OfJoint, accepted};
pub use parse::QuantityError;
pub(crate) use value::of_joint;

use polhode::{BodyId, JointId};

/// A quantity of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// What it is of.
    pub of: Of,
    /// The component of a vector; none of a scalar, and where all of it is meant.
    pub component: Option<usize>,
    /// What it is called, without its component: `torque of crank`.
    pub label: String,
}

/// What a quantity is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// A body.
    Body(BodyId, OfBody),
    /// A joint.
    Joint(JointId, OfJoint),
    /// The contacts of a body with another one, or with all.
    Contacts(BodyId, Option<BodyId>, OfContacts),
    /// The whole scene.
    Energy(OfEnergy),
}

/// The letters of the components of vectors, and of orientations.
const LETTERS: [&str; 2] = ["xyz", "wxyz"];

impl Quantity {
    /// How many components it has; 0 of one number.
    pub fn size(&self) -> usize {
        match self.of {
            Of::Body(_, own) => own.size(),
            Of::Joint(_, own) => own.size(),
            Of::Contacts(.., own) => own.size(),
            Of::Energy(_) => 0,
        }
    }

    /// Its unit.
    pub fn unit(&self) -> &'static str {
        match self.of {
            Of::Body(_, own) => own.unit(),
            Of::Joint(_, own) => own.unit(),
            Of::Contacts(.., own) => own.unit(),
            Of::Energy(_) => "J",
        }
    }

    /// What it is called, with its component.
    pub fn name(&self) -> String {
        let letters = LETTERS[usize::from(self.size() == 4)];
        match self.component.and_then(|component| letters.chars().nth(component)) {
            Some(letter) => format!("{} {letter}", self.label),
            None => self.label.clone(),
        }
    }

    /// What a plot of it shows, with the names of the curves: its components; of what acts along a coordinate of a
    /// joint also each cause of it.
    pub fn curves(&self) -> Vec<(String, Self)> {
        if self.component.is_none() && self.size() > 0 {
            let letters = LETTERS[usize::from(self.size() == 4)].chars().enumerate();
            let of = |(component, letter): (usize, char)| {
                (letter.to_string(), Self { component: Some(component), ..self.clone() })
            };
            return letters.map(of).collect();
        }
        let Of::Joint(joint, own) = self.of else { return vec![(String::new(), self.clone())] };
        let Some((first, others)) = own.causes() else { return vec![(String::new(), self.clone())] };
        let of = |(own, word): (OfJoint, &str)| {
            (word.to_owned(), Self { of: Of::Joint(joint, own), component: None, label: word.to_owned() })
        };
        std::iter::once((first.to_owned(), self.clone())).chain(others.into_iter().map(of)).collect()
    }
}
