//! What every case may use: the folder, reference values, runs of shipped scenes, and how much is to be run.

use super::kept::Kept;
use super::program::Program;
use super::run::ShippedScenes;
use crate::reference::Reference;
use crate::row::Row;
use std::error::Error;
use std::path::{Path, PathBuf};

/// How many of the random cases run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Amount {
    /// One in a hundred.
    Part,
    /// All.
    Full,
}

impl Amount {
    /// The number of random cases to run out of `full`.
    pub(crate) fn of(self, full: usize) -> usize {
        match self {
            Self::Part => full.div_ceil(100),
            Self::Full => full,
        }
    }
}

/// What every case may use.
#[derive(Debug)]
pub struct Context {
    /// Folder of the workspace.
    pub root: PathBuf,
    /// Reference values.
    pub reference: Reference,
    /// How many of the random cases to run.
    pub amount: Amount,
    /// Runs of the scenes that the project ships, each made once.
    pub shipped: ShippedScenes,
    /// The program.
    pub program: Program,
    /// Rows of cases that have run.
    pub(super) rows: Kept<Vec<Row>>,
}

impl Context {
    /// For the workspace in this folder.
    ///
    /// # Errors
    /// When the reference values cannot be read.
    pub fn new(root: &Path, amount: Amount) -> Result<Self, Box<dyn Error>> {
        Ok(Self {
            root: root.to_owned(),
            reference: Reference::load(&root.join("fixtures/reference"))?,
            amount,
            shipped: ShippedScenes::new(&root.join("fixtures/scenes")),
            program: Program::default(),
            rows: Kept::default(),
        })
    }
}

#[cfg(test)]
mod tests {
    //! How many cases a part is.
    use super::*;

    #[test]
    fn part_of_the_random_cases_is_one_in_a_hundred_and_never_none() {
        assert_eq!(Amount::Part.of(100_000), 1000);
        assert_eq!(Amount::Part.of(5), 1);
        assert_eq!(Amount::Full.of(5), 5);
    }
}
