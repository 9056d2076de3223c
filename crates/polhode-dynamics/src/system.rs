//! Systems of ordinary differential equations: what the integrators integrate.
//!
//! `y' = f(t, y)` over flat slices, so that one integrator serves a body, a scene with contact forces at every stage,
//! and a system of any other meaning. A system may keep buffers and statistics (`derivative` takes `&mut self`), but
//! its rates must be a function of `t` and the state alone, or the orders of the methods are lost.

/// A system `y' = f(t, y)` of first order.
pub trait System {
    /// Why rates could not be computed (a solver of contact forces that failed, say).
    type Error;

    /// Length of the state.
    fn dimension(&self) -> usize;

    /// Writes the rates `f(t, state)`. Both slices are [`System::dimension`] long.
    ///
    /// # Errors
    /// Whatever keeps the system from computing them; the integrator hands it on and leaves the step unfinished.
    fn derivative(&mut self, t: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Self::Error>;

    /// Brings a state that a step has left back to the manifold it belongs to (unit quaternions). A method of fixed
    /// step calls it after each step; for [`crate::Dop853`] the caller does, because it decides about the step.
    fn normalize(&self, _state: &mut [f64]) {}
}
