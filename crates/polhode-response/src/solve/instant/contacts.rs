//! Blocks as contacts, each with what it resists: slip, rolling and spinning that stick or slide; and whether forces
//! obey Coulomb's law.

use crate::friction::{Blocks, ContactStatus};
use crate::law::{Law, PARTS, Resistance};
use crate::least_in_cones::EXCEEDED;
use crate::problem::ContactProblem;

/// Whether a tangential force is more than friction bears (both N): bodies of one material that slide together hold
/// each other with forces exactly at the limit, and errors of steps must not decide whether they slide on each other.
fn exceeds_friction(tangential: f64, limit: f64) -> bool {
    tangential > limit * (1.0 + EXCEEDED)
}

/// What friction does along some rows of a contact: its slip, its rolling or its spinning.
#[derive(Debug, Clone, Default)]
pub(super) struct Part {
    pub(super) rows: Vec<usize>,
    /// What the reactions along these are multiplied by in their block.
    scales: Vec<f64>,
    /// The largest reaction over the normal one (no unit).
    pub(super) friction: f64,
    /// Whether it slides, along its one row.
    pub(super) slides: bool,
}

impl Part {
    /// The length of these forces of all rows along its own, in units of its coefficient, N.
    fn length(&self, forces: &[f64]) -> f64 {
        self.rows.iter().zip(&self.scales).fold(0.0, |sum: f64, (&row, scale)| libm::hypot(sum, forces[row] / scale))
    }

    /// Whether it holds its rows.
    pub(super) fn sticks(&self) -> bool {
        !self.slides && !self.rows.is_empty()
    }

    fn status(&self) -> ContactStatus {
        match (self.slides, self.rows.is_empty()) {
            (true, _) => ContactStatus::Slide,
            (false, true) => ContactStatus::Open,
            (false, false) => ContactStatus::Stick,
        }
    }
}

/// A contact among the rows of a problem.
#[derive(Debug, Clone)]
pub(super) struct Contact {
    /// Its row along the normal.
    pub(super) normal: usize,
    /// What it resists; no rows of what it does not.
    pub(super) parts: [Part; PARTS],
}

impl Contact {
    /// Whether these forces of all rows are beyond Coulomb's law: the contact pulls, or bears more than friction may.
    fn is_beyond(&self, forces: &[f64]) -> bool {
        let normal = forces[self.normal];
        let exceeds = |part: &Part| part.sticks() && exceeds_friction(part.length(forces), part.friction * normal);
        normal < 0.0 || self.parts.iter().any(exceeds)
    }

    /// Its rows beside that along the normal.
    pub(super) fn bounded_rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.parts.iter().flat_map(|part| part.rows.iter().copied())
    }

    /// Its rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        std::iter::once(self.normal).chain(self.bounded_rows())
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
    /// Those of blocks.
    pub(super) fn of(problem: &ContactProblem, blocks: &Blocks) -> Self {
        let scales: Vec<f64> = blocks.scales().collect();
        let mut is_joint = vec![true; problem.len()];
        let (mut all, mut first) = (Vec::with_capacity(blocks.len()), 0);
        for law in blocks.laws() {
            let own = first..first + law.rows();
            first = own.end;
            let (rows, scales) = (&blocks.rows()[own.clone()], &scales[own]);
            let Some(&normal) = rows.first().filter(|_| law.pushes()) else { continue };
            for &row in rows {
                is_joint[row] = false;
            }
            let parts = law.parts().map(|(range, Resistance { friction, slides, .. })| Part {
                rows: rows[range.clone()].to_vec(),
                scales: scales[range].to_vec(),
                friction,
                slides,
            });
            all.push(Contact { normal, parts });
        }
        let joints = (0..problem.len()).filter(|&row| is_joint[row]).collect();
        Self { all, joints }
    }

    /// Whether no contact pulls, and none bears more than the friction of what sticks may.
    pub(super) fn obey(&self, forces: &[f64]) -> bool {
        !self.all.iter().any(|contact| contact.is_beyond(forces))
    }

    /// What each contact does where all hold: whether it slips.
    pub(super) fn statuses(&self) -> Vec<ContactStatus> {
        let slides = |contact: &Contact| contact.parts[0].slides;
        let of = |contact| if slides(contact) { ContactStatus::Slide } else { ContactStatus::Stick };
        self.all.iter().map(of).collect()
    }

    /// What each contact does in its slip, its rolling and its spinning where all hold.
    pub(super) fn statuses_of_parts(&self) -> Vec<[ContactStatus; PARTS]> {
        self.all.iter().map(|contact| contact.parts.each_ref().map(Part::status)).collect()
    }

    /// The cones of what sticks, over the rows at these places, and the push of all others.
    pub(super) fn cones(&self, place_of: impl Fn(usize) -> usize) -> Blocks {
        let mut blocks = Blocks::default();
        for contact in &self.all {
            let sticks = contact.parts.each_ref().map(|part| Some(part).filter(|part| part.sticks()));
            let resistance = |part: Option<&Part>| {
                part.map(|part| Resistance { rows: part.rows.len(), friction: part.friction, slides: false })
            };
            let law = match sticks.map(resistance) {
                [None, None, None] => Law::Push,
                [Some(slip), None, None] => Law::Cone { rows: 1 + slip.rows, friction: slip.friction },
                parts => Law::Resist { parts: parts.map(Option::unwrap_or_default) },
            };
            let rows = sticks.iter().flatten().flat_map(|part| part.rows.iter().copied());
            let scales = sticks.iter().flatten().flat_map(|part| part.scales.iter().copied());
            let rows = std::iter::once(contact.normal).chain(rows).map(&place_of);
            blocks.push_scaled(law, rows, std::iter::once(1.0).chain(scales));
        }
        blocks
    }
}
