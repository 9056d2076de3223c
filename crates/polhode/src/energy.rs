//! The energies of a scene.

/// Energies of the whole scene, J. The potential is `-sum m g.x_cm`, zero at the world's origin.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energy {
    /// Total at t = 0.
    pub initial_j: f64,
    /// Total at the end.
    pub final_j: f64,
    /// Kinetic at the end.
    pub kinetic_j: f64,
    /// Potential at the end.
    pub potential_j: f64,
}
