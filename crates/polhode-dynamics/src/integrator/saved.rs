//! The variables that a method goes on from, as numbers.
//!
//! A method writes them one after the other and reads them back in the same order. Counts, flags and small integers are
//! numbers too: f64 holds them exactly. What depends on these variables alone (polynomials, buffers) is not among them.

use crate::state::WIDTH;
use crate::{BodyState, Flight, FreeMotion, RigidBody};
use glam::DVec3;
use thiserror::Error;

/// Numbers that are not the variables of a method for these bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "the {numbers} numbers given are not the variables of this integrator for {bodies} bodies: restore what its save \
     has returned, by the same method and for the same bodies"
)]
pub struct NotItsVariables {
    /// How many numbers were given.
    pub numbers: usize,
    /// Bodies of the motion.
    pub bodies: usize,
}

/// Reads numbers in the order in which they were written.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    left: &'a [f64],
    error: NotItsVariables,
}

impl<'a> Reader<'a> {
    /// Of the variables of the bodies of a motion.
    pub(crate) fn new(motion: &FreeMotion<'_>, numbers: &'a [f64]) -> Self {
        let error = NotItsVariables { numbers: numbers.len(), bodies: motion.bodies().len() };
        Self { left: numbers, error }
    }

    /// That the numbers are not the variables.
    pub(crate) fn refused<T>(&self) -> Result<T, NotItsVariables> {
        Err(self.error)
    }

    /// The next numbers.
    pub(crate) fn array<const N: usize>(&mut self) -> Result<[f64; N], NotItsVariables> {
        let Some((first, left)) = self.left.split_first_chunk::<N>() else { return self.refused() };
        self.left = left;
        Ok(*first)
    }

    /// The next number.
    pub(crate) fn number(&mut self) -> Result<f64, NotItsVariables> {
        self.array::<1>().map(|[number]| number)
    }

    /// So many next numbers.
    pub(crate) fn numbers(&mut self, count: usize) -> Result<Vec<f64>, NotItsVariables> {
        let Some((first, left)) = self.left.split_at_checked(count) else { return self.refused() };
        self.left = left;
        Ok(first.to_vec())
    }

    /// The next number, a whole one.
    pub(crate) fn integer(&mut self) -> Result<u32, NotItsVariables> {
        let number = self.number()?;
        let whole = number as u32;
        if f64::from(whole) == number { Ok(whole) } else { self.refused() }
    }

    /// The next number, which says yes or no.
    pub(crate) fn flag(&mut self) -> Result<bool, NotItsVariables> {
        match self.integer()? {
            0 => Ok(false),
            1 => Ok(true),
            _ => self.refused(),
        }
    }

    /// How many bodies the method has been started with: those of the motion, or none before that.
    pub(crate) fn count(&mut self) -> Result<usize, NotItsVariables> {
        let count = self.integer()? as usize;
        if count == 0 || count == self.error.bodies { Ok(count) } else { self.refused() }
    }

    /// The next vector.
    pub(crate) fn vector(&mut self) -> Result<DVec3, NotItsVariables> {
        self.array().map(DVec3::from_array)
    }

    /// The next states.
    pub(crate) fn states(&mut self, count: usize) -> Result<Vec<BodyState>, NotItsVariables> {
        (0..count).map(|_| self.state()).collect()
    }

    /// The next state.
    pub(crate) fn state(&mut self) -> Result<BodyState, NotItsVariables> {
        let numbers = self.array::<WIDTH>()?;
        BodyState::from_stored(&numbers).or_else(|_| self.refused())
    }

    /// The next records of flight: one or none for each body that the method has been started with.
    pub(crate) fn flights(
        &mut self,
        motion: &FreeMotion<'_>,
        started: &[BodyState],
    ) -> Result<Vec<Option<Flight>>, NotItsVariables> {
        let bodies = motion.bodies().iter().zip(started);
        bodies.map(|(body, _)| if self.flag()? { self.flight(body).map(Some) } else { Ok(None) }).collect()
    }

    fn flight(&mut self, body: &RigidBody) -> Result<Flight, NotItsVariables> {
        let (t0, start, gravity) = (self.number()?, self.state()?, self.vector()?);
        Ok(Flight::new(body, t0, &start, gravity))
    }

    /// That no number is left.
    pub(crate) fn end(self) -> Result<(), NotItsVariables> {
        if self.left.is_empty() { Ok(()) } else { self.refused() }
    }
}

/// Writes a count of bodies.
pub(crate) fn write_count(count: usize, numbers: &mut Vec<f64>) {
    numbers.push(count as f64);
}

/// Writes states.
pub(crate) fn write_states(states: &[BodyState], numbers: &mut Vec<f64>) {
    numbers.extend(states.iter().flat_map(BodyState::to_array));
}

/// Writes records of flight.
pub(crate) fn write_flights(flights: &[Option<Flight>], numbers: &mut Vec<f64>) {
    for flight in flights {
        numbers.push(f64::from(u8::from(flight.is_some())));
        if let Some(flight) = flight {
            numbers.push(flight.t0());
            write_states(&[*flight.start()], numbers);
            numbers.extend(flight.gravity().to_array());
        }
    }
}
