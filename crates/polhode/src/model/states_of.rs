//! The states of some bodies among those of all: taken out, and put back.

use polhode_dynamics::BodyState;

/// The states of `bodies`, in their order, from those of all bodies.
pub(crate) fn states_of(states: &[BodyState], bodies: &[usize]) -> Vec<BodyState> {
    bodies.iter().map(|&body| states[body]).collect()
}

/// Sets the states of `bodies` among those of all bodies to `to`, in their order.
pub(crate) fn set_states(states: &mut [BodyState], bodies: &[usize], to: &[BodyState]) {
    for (&body, state) in bodies.iter().zip(to) {
        states[body] = *state;
    }
}
