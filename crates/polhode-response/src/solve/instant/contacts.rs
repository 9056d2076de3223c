//! Blocks as contacts that have no friction, stick or slide.

use crate::friction::{Blocks, ContactStatus};
use crate::law::Law;
use crate::least_in_cones::EXCEEDED;
use crate::problem::ContactProblem;

/// Whether a tangential force is more than friction bears (both N): bodies of one material that slide together hold
/// each other with forces exactly at the limit, and errors of steps must not decide whether they slide on each other.
fn exceeds_friction(tangential: f64, limit: f64) -> bool {
    tangential > limit * (1.0 + EXCEEDED)
}

/// What friction does at a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Mode {
    /// Nothing.
    Frictionless,
    /// It holds it up to this coefficient.
    Sticks(f64),
    /// It slides with this coefficient.
    Slides(f64),
}

/// A contact among the rows of a problem.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    /// Its row along the normal.
    pub(super) normal: usize,
    /// Its rows along tangents.
    pub(super) tangents: Vec<usize>,
    /// What the reactions along these are multiplied by in its block.
    scales: Vec<f64>,
    pub(super) mode: Mode,
}

impl Contact {
    /// Whether these forces of all rows are beyond Coulomb's law: the contact pulls, or bears more than friction may.
    fn is_beyond(&self, forces: &[f64]) -> bool {
        let normal = forces[self.normal];
        let slips = |friction: f64| exceeds_friction(self.tangential(forces), friction * normal);
        normal < 0.0 || matches!(self.mode, Mode::Sticks(friction) if slips(friction))
    }

    /// The length of its tangential force in units of its coefficient, of these forces of all rows, N.
    fn tangential(&self, forces: &[f64]) -> f64 {
        self.tangents
            .iter()
            .zip(&self.scales)
            .fold(0.0, |sum: f64, (&row, scale)| libm::hypot(sum, forces[row] / scale))
    }

    /// Its rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        std::iter::once(self.normal).chain(self.tangents.iter().copied())
    }
}

/// The contacts of some blocks, and the other rows of the problem.
#[derive(Debug, Clone)]
pub(super) struct Contacts {
    pub(super) all: Vec<Contact>,
    /// Rows that hold, those of joints.
    pub(super) joints: Vec<usize>,
}

impl Contacts {
    /// Those of blocks none of which resists rotations.
    pub(super) fn of(problem: &ContactProblem, blocks: &Blocks) -> Self {
        let scales: Vec<f64> = blocks.scales().collect();
        let mut is_joint = vec![true; problem.len()];
        let (mut all, mut first) = (Vec::with_capacity(blocks.len()), 0);
        for law in blocks.laws() {
            let own = first..first + law.rows();
            first = own.end;
            let rows = &blocks.rows()[own.clone()];
            let Some((&normal, tangents)) = rows.split_first().filter(|_| law.pushes()) else { continue };
            for &row in rows {
                is_joint[row] = false;
            }
            let mode = match law {
                Law::Slide { friction } => Mode::Slides(*friction),
                Law::Cone { friction, .. } if !tangents.is_empty() => Mode::Sticks(*friction),
                _ => Mode::Frictionless,
            };
            all.push(Contact { normal, tangents: tangents.to_vec(), scales: scales[own][1..].to_vec(), mode });
        }
        let joints = (0..problem.len()).filter(|&row| is_joint[row]).collect();
        Self { all, joints }
    }

    /// Whether no contact pulls, and none that sticks bears more than friction may.
    pub(super) fn obey(&self, forces: &[f64]) -> bool {
        !self.all.iter().any(|contact| contact.is_beyond(forces))
    }

    /// What each contact does where all hold.
    pub(super) fn statuses(&self) -> Vec<ContactStatus> {
        let of = |contact: &Contact| match contact.mode {
            Mode::Slides(_) => ContactStatus::Slide,
            Mode::Frictionless | Mode::Sticks(_) => ContactStatus::Stick,
        };
        self.all.iter().map(of).collect()
    }

    /// The cones of those that stick, over the rows at these places, and the push of all others.
    pub(super) fn cones(&self, place_of: impl Fn(usize) -> usize) -> Blocks {
        let mut blocks = Blocks::default();
        for contact in &self.all {
            let rows = contact.rows().map(&place_of);
            match contact.mode {
                Mode::Sticks(friction) => {
                    let law = Law::Cone { rows: 1 + contact.tangents.len(), friction };
                    blocks.push_scaled(law, rows, std::iter::once(1.0).chain(contact.scales.iter().copied()));
                }
                Mode::Frictionless | Mode::Slides(_) => blocks.push(Law::Push, rows.take(1)),
            }
        }
        blocks
    }
}
