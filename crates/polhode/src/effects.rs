//! Which effects a run simulates.

/// Which effects a run simulates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Effects {
    /// Those that the plan finds the scene to call for.
    #[default]
    Planned,
    /// All, whether called for or not: the reference for what the plan leaves out.
    All,
}
