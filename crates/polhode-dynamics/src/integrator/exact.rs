//! Exact flight with forces as kicks.
//!
//! A body that nothing loads flies by its record ([`Flight`]), set at [`Integrator::start`] and never chained: its
//! state at any time is exact to round-off, whatever the step. Fields, and the torque of gravity on a pivoted body, act
//! as kicks between exact drifts, so that the error is proportional to the forces and vanishes with them:
//!
//! | member | composition | order |
//! |---|---|---|
//! | [`Exact::blanes_moan`] | `blanes_moan.rs`, six kicks | 4 |
//! | [`Exact::strang`] | drift h/2, kick h, drift h/2 | 2 |
//!
//! Both are symmetric and, for conservative fields, symplectic: the energy of a bound motion oscillates and does not
//! drift. Fields may depend on time, not on velocities. How it fails: a step as long as the time scale of the *forces*
//! (the spin does not matter) is inaccurate and, beyond it, unstable: [`super::AdaptiveExact`] controls the error.
//! The motion must stay the same from step to step: call [`Integrator::start`] after a change of fields.
//! Source: docs/REFERENCES.md, Hairer, Lubich and Wanner, II.5 and VII.5.

use super::blanes_moan;
use super::drift_kick::{Stages, Stepper};
use super::saved::{NotItsVariables, Reader, write_flights};
use super::{IntegrationError, Integrator};
use crate::{BodyState, Flight, FreeMotion};

/// Strang's composition, with the kick in the middle: one evaluation of the forces, and half the error of the kicks
/// outside.
const STRANG: &Stages = &[(0.5, 1.0), (0.5, 0.0)];

/// Exact drifts with a composition of kicks.
#[derive(Debug, Clone)]
pub struct Exact {
    name: &'static str,
    order: u32,
    stages: &'static Stages,
    stepper: Stepper,
    /// Whether any body is loaded, so that drifts and kicks are needed.
    loaded: bool,
    /// Records of the bodies that nothing loads.
    flights: Vec<Option<Flight>>,
}

impl Exact {
    /// Order 4: the method named `exact`.
    pub fn blanes_moan() -> Self {
        Self::new("exact", 4, blanes_moan::STAGES)
    }

    /// Order 2: the method named `exact-strang`.
    pub fn strang() -> Self {
        Self::new("exact-strang", 2, STRANG)
    }

    fn new(name: &'static str, order: u32, stages: &'static Stages) -> Self {
        Self { name, order, stages, stepper: Stepper::default(), loaded: false, flights: Vec::new() }
    }

    /// The stages of a step: one drift when nothing is loaded.
    fn stages(&self) -> &'static Stages {
        if self.loaded { self.stages } else { &[] }
    }
}

/// Records of the bodies that nothing loads.
pub(super) fn records(motion: &FreeMotion<'_>, t: f64, states: &[BodyState]) -> Vec<Option<Flight>> {
    let record = |(index, (body, state))| {
        (!motion.is_loaded(index)).then(|| Flight::new(body, t, state, motion.free_acceleration(body)))
    };
    motion.bodies().iter().zip(states).enumerate().map(record).collect()
}

/// Overwrites the states of the bodies that fly by their records.
pub(super) fn follow(flights: &[Option<Flight>], t: f64, states: &mut [BodyState]) {
    for (state, flight) in states.iter_mut().zip(flights) {
        if let Some(flight) = flight {
            *state = flight.state(t);
        }
    }
}

impl Integrator for Exact {
    fn order(&self) -> u32 {
        self.order
    }

    fn start(&mut self, motion: &FreeMotion<'_>, t: f64, states: &[BodyState]) {
        self.stepper.start(t, states);
        self.loaded = motion.has_loads();
        self.flights = records(motion, t, states);
    }

    fn step(&mut self, motion: &FreeMotion<'_>, h: f64) -> Result<(), IntegrationError> {
        let stages = self.stages();
        let flights = &self.flights;
        self.stepper.step(motion, h, stages, self.name, |t, states| follow(flights, t, states))
    }

    fn time(&self) -> f64 {
        self.stepper.t
    }

    fn states(&self) -> &[BodyState] {
        &self.stepper.states
    }

    fn states_within(
        &mut self,
        motion: &FreeMotion<'_>,
        t: f64,
        states: &mut [BodyState],
    ) -> Result<(), IntegrationError> {
        self.stepper.states_within(motion, t, self.stages(), states)?;
        follow(&self.flights, t, states);
        Ok(())
    }

    fn save(&self) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.stepper.write(&mut numbers);
        numbers.push(f64::from(u8::from(self.loaded)));
        write_flights(&self.flights, &mut numbers);
        numbers
    }

    fn restore(&mut self, motion: &FreeMotion<'_>, saved: &[f64]) -> Result<(), NotItsVariables> {
        let mut numbers = Reader::new(motion, saved);
        let stepper = Stepper::read(&mut numbers)?;
        let loaded = numbers.flag()?;
        let flights = numbers.flights(motion, &stepper.states)?;
        numbers.end()?;
        (self.stepper, self.loaded, self.flights) = (stepper, loaded, flights);
        Ok(())
    }
}
