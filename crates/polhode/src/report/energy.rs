//! Total, kinetic and potential energy of a scene.

/// Energies of the whole scene, J. The potential energy is `-sum m g.p_WBcm`, zero at the world's origin, and that of
/// the conservative force fields.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Energy {
    /// Total energy at t = 0.
    pub initial_j: f64,
    /// Total energy at the time of the report, or at the present.
    pub final_j: f64,
    /// Kinetic energy then.
    pub kinetic_j: f64,
    /// Potential energy then.
    pub potential_j: f64,
}
