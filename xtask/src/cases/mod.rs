//! Validation cases: what the project promises, measured on what its users run.
//!
//! A case builds scenes, runs them through the facade with default settings (unless it is about a setting) and turns
//! what it measures into rows. Where a quantity is internal (forces, mass properties) it calls the crate that computes
//! it. Names of cases with a number (`RC-10`) are those of the reference values.

mod bodies;
mod convergence;
mod convex_pairs;
mod curved_bodies;
mod decomposition;
mod diamonds;
mod effects;
mod exact_drift;
mod falling_shapes;
mod free_rotation;
mod heavy_tops;
mod impact_chains;
mod impacts;
mod invariances;
mod ledger;
mod long_runs;
mod mass_properties;
mod mesh_program;
mod motion;
mod numerical_loss;
mod one_dependency;
mod peers;
mod pi_machine;
mod polhode_times;
mod published_rotations;
mod random;
mod random_pairs;
mod random_solids;
mod reductions;
mod resting_contact;
mod rigid_ipc;
mod run;
mod setting;
mod snapshots;
mod speed;
mod stackings;
mod stacks;
mod strict_hash;
mod table_edge;
mod thesis_tier;
mod tunnelling;
mod valleys;

use crate::reference::Reference;
use crate::row::Row;
use run::ShippedScenes;
use std::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

pub(crate) use run::Run;
pub(crate) use strict_hash::strict_hash;

/// What a case returns: rows, or why it could not measure anything.
pub(crate) type CaseResult = Result<Vec<Row>, Box<dyn Error>>;

/// How many of the random cases run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Amount {
    /// One in a hundred.
    Part,
    /// All.
    Full,
}

impl Amount {
    /// The number of random cases to run out of `full`.
    fn of(self, full: usize) -> usize {
        match self {
            Self::Part => full.div_ceil(100),
            Self::Full => full,
        }
    }
}

/// What every case may use.
#[derive(Debug)]
pub(crate) struct Context {
    /// Folder of the workspace.
    pub(crate) root: PathBuf,
    /// Reference values.
    pub(crate) reference: Reference,
    /// How many of the random cases to run.
    pub(crate) amount: Amount,
    /// Runs of the scenes that the project ships, each made once.
    pub(crate) shipped: ShippedScenes,
}

impl Context {
    /// For the workspace in this folder.
    ///
    /// # Errors
    /// When the reference values cannot be read.
    pub(crate) fn new(root: &Path, amount: Amount) -> Result<Self, Box<dyn Error>> {
        Ok(Self {
            root: root.to_owned(),
            reference: Reference::load(&root.join("fixtures/reference"))?,
            amount,
            shipped: ShippedScenes::new(&root.join("fixtures/scenes")),
        })
    }
}

/// A validation case.
#[derive(Debug)]
pub(crate) struct Case {
    /// Name, which `--only` selects by.
    pub(crate) name: &'static str,
    rows: fn(&Context) -> CaseResult,
}

impl Case {
    /// Runs it. An error or a panic is a row that fails.
    pub(crate) fn run(&self, context: &Context) -> Vec<Row> {
        guarded(self.name, || (self.rows)(context))
    }
}

/// The rows of a case, or one that fails with the error or panic that kept it from giving any.
pub(crate) fn guarded(case: &str, rows: impl FnOnce() -> CaseResult) -> Vec<Row> {
    match catch_unwind(AssertUnwindSafe(rows)) {
        Ok(Ok(rows)) => rows,
        Ok(Err(error)) => vec![Row::broken(case, "runs", error.to_string())],
        Err(_) => vec![Row::broken(case, "runs", "panic: a bug, whatever the input was")],
    }
}

/// All cases, the quick ones first.
pub(crate) const ALL: &[Case] = &[
    Case { name: "MP-01", rows: mass_properties::mp_01 },
    Case { name: "MP-02", rows: mass_properties::mp_02 },
    Case { name: "MP-03", rows: mass_properties::mp_03 },
    Case { name: "MP-04", rows: mass_properties::mp_04 },
    Case { name: "MP-05", rows: mass_properties::mp_05 },
    Case { name: "MP-06", rows: mass_properties::mp_06 },
    Case { name: "MP-07", rows: curved_bodies::mp_07 },
    Case { name: "MP-08", rows: curved_bodies::mp_08 },
    Case { name: "MP-09", rows: curved_bodies::mp_09 },
    Case { name: "MP-10", rows: curved_bodies::mp_10 },
    Case { name: "MP-11", rows: curved_bodies::mp_11 },
    Case { name: "MP-12", rows: mass_properties::mp_12 },
    Case { name: "meshes of primitives", rows: curved_bodies::orders },
    Case { name: "mesh decomposition", rows: decomposition::convex_parts },
    Case { name: "moved meshes", rows: random_solids::moved },
    Case { name: "random solids", rows: random_solids::laws },
    Case { name: "convex pairs", rows: convex_pairs::random },
    Case { name: "stackings", rows: stackings::symmetric },
    Case { name: "tunnelling", rows: tunnelling::shots },
    Case { name: "FR-01", rows: free_rotation::fr_01 },
    Case { name: "FR-02", rows: free_rotation::fr_02 },
    Case { name: "FR-03", rows: polhode_times::fr_03 },
    Case { name: "FR-04", rows: free_rotation::fr_04 },
    Case { name: "FR-05", rows: polhode_times::fr_05 },
    Case { name: "FR-06", rows: free_rotation::fr_06 },
    Case { name: "FR-07", rows: free_rotation::fr_07 },
    Case { name: "exact drift: hard cases", rows: exact_drift::hard_cases },
    Case { name: "exact drift: samples", rows: exact_drift::samples },
    Case { name: "NESC-2", rows: published_rotations::tumbling_brick },
    Case { name: "OSRF-boxes", rows: published_rotations::osrf_boxes },
    Case { name: "Orekit", rows: published_rotations::orekit },
    Case { name: "Basilisk", rows: published_rotations::basilisk },
    Case { name: "Bruels-top", rows: published_rotations::bruels_top },
    Case { name: "HT-01", rows: heavy_tops::ht_01 },
    Case { name: "HT-02", rows: heavy_tops::ht_02 },
    Case { name: "HT-03", rows: heavy_tops::ht_03 },
    Case { name: "HT-04", rows: heavy_tops::ht_04 },
    Case { name: "HT-05", rows: heavy_tops::ht_05 },
    Case { name: "convergence", rows: convergence::orders },
    Case { name: "work-precision", rows: convergence::work_precision },
    Case { name: "peers", rows: peers::free_rotation },
    Case { name: "IM-01", rows: impacts::im_01 },
    Case { name: "IM-02", rows: impact_chains::im_02 },
    Case { name: "IM-03", rows: impact_chains::im_03 },
    Case { name: "IM-04", rows: impact_chains::im_04 },
    Case { name: "IM-05", rows: impacts::im_05 },
    Case { name: "IM-06", rows: pi_machine::im_06 },
    Case { name: "IM-12", rows: impacts::im_12 },
    Case { name: "IM-13", rows: impacts::im_13 },
    Case { name: "IM-14", rows: impacts::im_14 },
    Case { name: "RC-02", rows: diamonds::rc_02 },
    Case { name: "RC-03", rows: diamonds::rc_03 },
    Case { name: "RC-05", rows: stacks::rc_05 },
    Case { name: "RC-06", rows: stacks::rc_06 },
    Case { name: "RC-07", rows: resting_contact::rc_07 },
    Case { name: "RC-08", rows: resting_contact::rc_08 },
    Case { name: "RC-09", rows: resting_contact::rc_09 },
    Case { name: "RC-10", rows: table_edge::rc_10 },
    Case { name: "falling shapes", rows: falling_shapes::times },
    Case { name: "resting shapes", rows: falling_shapes::rest },
    Case { name: "round bodies in valleys", rows: valleys::rows },
    Case { name: "least-force bound", rows: resting_contact::least_force_bound },
    Case { name: "diamonds stand", rows: diamonds::stand },
    Case { name: "diamond-4 for an hour", rows: diamonds::stands_for_an_hour },
    Case { name: "diamond-5 falls", rows: diamonds::falls_symmetrically },
    Case { name: "tier thesis", rows: thesis_tier::diamonds },
    Case { name: "ledger", rows: ledger::shipped_scenes },
    Case { name: "energy at e = 1", rows: ledger::elastic_scenes },
    Case { name: "one dependency", rows: one_dependency::examples },
    Case { name: "numerical loss", rows: numerical_loss::conservative_scenes },
    Case { name: "reductions", rows: reductions::found_where_they_are },
    Case { name: "CD-02", rows: invariances::cd_02 },
    Case { name: "CD-03", rows: invariances::cd_03 },
    Case { name: "CD-04", rows: invariances::cd_04 },
    Case { name: "CD-05", rows: long_runs::cd_05 },
    Case { name: "CD-06", rows: invariances::cd_06 },
    Case { name: "Rigid IPC scenes", rows: rigid_ipc::own },
    Case { name: "Rigid IPC suite", rows: rigid_ipc::suite },
    Case { name: "effects", rows: effects::planned_equals_all },
    Case { name: "snapshots", rows: snapshots::continued_runs },
    Case { name: "speed", rows: speed::diamond_4 },
    Case { name: "memory", rows: speed::peak_memory },
];

#[cfg(test)]
mod tests {
    //! `--only` selects by name, so names differ; every reference value is used by some case or it is dead weight.
    use super::*;

    #[test]
    fn names_differ() {
        let mut names: Vec<&str> = ALL.iter().map(|case| case.name).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), ALL.len());
    }

    #[test]
    fn part_of_the_random_cases_is_one_in_a_hundred_and_never_none() {
        assert_eq!(Amount::Part.of(100_000), 1000);
        assert_eq!(Amount::Part.of(5), 1);
        assert_eq!(Amount::Full.of(5), 5);
    }
}
