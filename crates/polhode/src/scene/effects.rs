//! Which effects a run simulates.

/// Which effects a run simulates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Effects {
    /// Those that the plan finds to matter in the scene.
    #[default]
    Planned,
    /// All, without the reductions of the plan: the reference that shows what the reductions change.
    All,
}
