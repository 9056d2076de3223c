//! What is asked for, by the file that asks.

use std::fmt;

/// What a solve is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Ask {
    /// Forces and accelerations now.
    Instant,
    /// Forces in a stage of an integrator.
    Stage,
    /// Impulses of a time step.
    Step,
    /// Impulses of an impact.
    Impact,
    /// Bodies out of each other, joints together.
    Displacement,
    /// Whether and by what forces bodies stay at rest.
    Rest,
    /// The thesis's own.
    Thesis,
    /// Any other file.
    Other,
}

/// Ends of paths, the longer ones first.
const FILES: &[(&str, Ask)] = &[
    ("solve/accelerations.rs", Ask::Instant),
    ("solve/joint_reactions.rs", Ask::Instant),
    ("solve/open_loads.rs", Ask::Instant),
    ("solve/closed_loops.rs", Ask::Instant),
    ("solve/contradiction.rs", Ask::Instant),
    ("stepped/present_forces.rs", Ask::Instant),
    ("accurate/load_views.rs", Ask::Instant),
    ("accurate/held_forces.rs", Ask::Stage),
    ("solve/impact.rs", Ask::Impact),
    ("solve/frictional_impact.rs", Ask::Impact),
    ("solve/instant/mod.rs", Ask::Instant),
    ("solve/stage.rs", Ask::Stage),
    ("solve/removal.rs", Ask::Displacement),
    ("solve/overlap.rs", Ask::Displacement),
    ("solve/projection.rs", Ask::Displacement),
    ("solve/instant/rest.rs", Ask::Rest),
    ("solve/instant/sticking.rs", Ask::Rest),
    ("solve/instant/sliding.rs", Ask::Rest),
    ("src/stability.rs", Ask::Rest),
];

/// Folders.
const FOLDERS: &[(&str, Ask)] = &[
    ("polhode-response/src/impact/", Ask::Impact),
    ("polhode/src/time_stepping/", Ask::Step),
    ("polhode/src/thesis/", Ask::Thesis),
];

impl Ask {
    /// What this file asks for.
    pub(super) fn of(file: &str) -> Self {
        let by_file = FILES.iter().find(|(end, _)| file.ends_with(end));
        let found = by_file.or_else(|| FOLDERS.iter().find(|(folder, _)| file.contains(folder)));
        found.map_or(Self::Other, |found| found.1)
    }
}

impl fmt::Display for Ask {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

#[cfg(test)]
mod tests {
    //! Files are known by their ends and folders.
    use super::*;

    #[test]
    fn files_are_known_by_their_ends_and_folders() {
        assert_eq!(Ask::of("crates/polhode/src/accurate/held_forces.rs"), Ask::Stage);
        assert_eq!(Ask::of("crates/polhode/src/time_stepping/cone_problem.rs"), Ask::Step);
        assert_eq!(Ask::of("crates/polhode-response/src/impact/friction/part.rs"), Ask::Impact);
        assert_eq!(Ask::of("crates/polhode-response/src/heuristic.rs"), Ask::Other);
    }
}
