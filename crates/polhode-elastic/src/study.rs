//! A drop on meshes that get finer, and what it would be on one that is infinitely fine.
//!
//! Nodes open at steps, and where in a step a wave arrives changes with the length of the steps: of a front that meets
//! the floor this leaves a noise of some parts of a thousand in the rebound. A study drops the rectangle by several
//! step lengths, spread evenly over [`SHORTEST_PART`] to [`LONGEST_PART`] of the limit, and takes means; their standard
//! error goes with the estimate. The means of three meshes, each twice as fine as the one before, are extrapolated
//! ([`crate::extrapolation`]). A confined drop has no such noise, and steps by the limit alone.
//!
//! Fails: quantities that change by jumps with the mesh (the last touch of a body that patters) have errors of the size
//! of the jumps, which the estimate says.

use crate::drop::{DropReport, RectangleDrop};
use crate::error::ElasticError;
use crate::extrapolation::{Extrapolated, Mean};
use crate::guide::Guide;
use crate::mesh::Cells;

/// The shortest step of a study, in units of the limit: 6 % are several steps' phase at the end of the shortest
/// contact.
pub const SHORTEST_PART: f64 = 0.93;

/// The longest step of a study, in units of the limit: that by which a drop steps by itself.
pub const LONGEST_PART: f64 = 0.99;

/// Step lengths of a study.
const STEP_LENGTHS: usize = 8;

/// Meshes of a study.
const MESHES: usize = 3;

/// What a study measures of a drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// From the first to the last impulse of the floor, s.
    ContactTime,
    /// Vertical impulse of the floor, N s.
    Impulse,
    /// Velocity of the centre of mass up, m/s.
    Velocity,
    /// Angular velocity about y (z towards x), rad/s.
    AngularVelocity,
    /// Velocity up over velocity down before.
    Restitution,
    /// The same of the corner that met the floor.
    CornerRestitution,
    /// Square root of the part of the energy that is motion as a rigid body.
    EnergyRestitution,
    /// The part of the energy that is vibration.
    Vibration,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::ContactTime,
        Self::Impulse,
        Self::Velocity,
        Self::AngularVelocity,
        Self::Restitution,
        Self::CornerRestitution,
        Self::EnergyRestitution,
        Self::Vibration,
    ];

    /// Its value in a drop.
    pub fn of(self, report: &DropReport) -> f64 {
        match self {
            Self::ContactTime => report.contact_time_s,
            Self::Impulse => report.impulse_n_s,
            Self::Velocity => report.velocity.y,
            Self::AngularVelocity => report.angular_velocity,
            Self::Restitution => report.restitution,
            Self::CornerRestitution => report.corner_restitution,
            Self::EnergyRestitution => report.energy_restitution,
            Self::Vibration => report.energy.vibration_j / report.energy.before_j,
        }
    }
}

/// Drops on one mesh, by several step lengths.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshedDrops {
    /// The elements.
    pub cells: Cells,
    /// One for each step length.
    pub reports: Vec<DropReport>,
}

impl MeshedDrops {
    /// Drops on this mesh.
    ///
    /// # Errors
    /// Those of [`RectangleDrop::run`].
    pub fn of(drop: &RectangleDrop, cells: Cells) -> Result<Self, ElasticError> {
        if drop.guide() == Guide::Vertical || drop.has_step() {
            return Ok(Self { cells, reports: vec![drop.run(cells)?] });
        }
        let limit_s = drop.start(cells)?.body().longest_step_s();
        let part = |k: usize| SHORTEST_PART + (LONGEST_PART - SHORTEST_PART) * k as f64 / (STEP_LENGTHS - 1) as f64;
        let reports = (0..STEP_LENGTHS).map(|k| drop.step_s(part(k) * limit_s)?.run(cells));
        Ok(Self { cells, reports: reports.collect::<Result<_, _>>()? })
    }

    /// The mean of a quantity.
    pub fn mean(&self, quantity: Quantity) -> Mean {
        let values: Vec<f64> = self.reports.iter().map(|report| quantity.of(report)).collect();
        let count = values.len().max(1) as f64;
        let value = values.iter().sum::<f64>() / count;
        let squares: f64 = values.iter().map(|x| (x - value) * (x - value)).sum();
        Mean { value, error: (squares / (count * (count - 1.0).max(1.0))).sqrt() }
    }
}

/// Drops on meshes each twice as fine as the one before.
#[derive(Debug, Clone, PartialEq)]
pub struct DropStudy {
    /// The meshes, the coarsest first.
    pub meshes: Vec<MeshedDrops>,
}

impl DropStudy {
    /// On three meshes, of which this is the coarsest.
    ///
    /// # Errors
    /// Those of [`RectangleDrop::run`].
    pub fn of(drop: &RectangleDrop, coarsest: Cells) -> Result<Self, ElasticError> {
        let meshes = Self::cells(coarsest)?.into_iter().map(|cells| MeshedDrops::of(drop, cells));
        Ok(Self { meshes: meshes.collect::<Result<_, _>>()? })
    }

    /// The meshes of a study of which this is the coarsest.
    ///
    /// # Errors
    /// No element, or too many on the finest: told before anything is computed.
    pub fn cells(coarsest: Cells) -> Result<Vec<Cells>, ElasticError> {
        let cells = std::iter::successors(Some(coarsest), |cells| Some(cells.halved()));
        cells.take(MESHES).map(Cells::checked).collect()
    }

    /// A quantity on a mesh that is infinitely fine.
    ///
    /// # Errors
    /// Fewer than three meshes.
    pub fn limit(&self, quantity: Quantity) -> Result<Extrapolated, ElasticError> {
        let means: Vec<Mean> = self.meshes.iter().map(|drops| drops.mean(quantity)).collect();
        Extrapolated::of_means(&means)
    }
}
