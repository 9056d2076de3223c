//! A rigid floor without friction, and the law of a node that meets it.
//!
//! Central differences move a node by `gap + step u`, with u (m/s) its rate of separation in the step. Where that is
//! below zero, the node is **held**: an impulse p >= 0 along the normal (N s for each metre of depth) takes it exactly
//! to the floor, `u+ = -gap / step`. This is the forward-increment multiplier of Carpenter, Taylor and Katona (1991):
//! no penalty stiffness, and no penetration. Within the step the impact of the node is inelastic: it stops. What its
//! stops have taken of the energy is remembered, and when no impulse is needed any more it **opens** by the impulse
//! that gives it back.
//!
//! Why: what stops is the lumped mass of a node, half an element of matter, which in truth is stopped by a wave and
//! keeps its energy. Left lost, it is a part of 1 / (2 rows) of the energy of a flat drop, and the rebound of a
//! confined bar lacks as much of its impulse; it vanishes with the size of elements to the first order only. Given back
//! at the end, it is exact for the confined bar: the boundary of d'Alembert's solution stops at once and leaves at once
//! with the speed it came with (the impact and release conditions of Hughes and others, 1976). A floor that does not
//! move has done no work when a contact has ended, whatever the mesh, and never has a node more from it than it has
//! given.
//!
//! Work of an impulse over central differences is `p (u_before + u_after) / 2`, with the rates in the steps before and
//! after it: it is exactly what the energy of the ledger changes by. While a node is held it is none.
//! Source: docs/REFERENCES.md, Carpenter, Taylor and Katona 1991; Hughes, Taylor, Sackman, Curnier and
//! Kanoknukulchai 1976.

use glam::DVec2;

/// The part of the impulse of its last step below which that of a held node is rounding, and the node opens: impulses
/// of held nodes have relative errors of some 1e-13, and one that falls to 1e-9 from one step to the next falls to
/// zero.
const OPEN_BELOW: f64 = 1e-9;

/// A half space in the axes of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Floor {
    /// Its outward normal, of unit length.
    pub normal: DVec2,
    /// Distance of its surface from the origin along the normal, m.
    pub offset: f64,
}

impl Floor {
    /// Distance of a place from the surface, m; negative below it.
    pub fn gap(&self, place: DVec2) -> f64 {
        self.normal.dot(place) - self.offset
    }
}

/// What a node has in memory of its contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct NodeContact {
    /// Impulse of the last step, N s.
    held: f64,
    /// Energy that its stops have taken since it was last open, J.
    taken: f64,
}

/// A node that may meet the floor in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Approach {
    /// Its mass, kg.
    pub(crate) mass: f64,
    /// Its gap, m.
    pub(crate) gap: f64,
    /// Its rate of separation in the step before, m/s.
    pub(crate) before: f64,
    /// Its rate of separation without an impulse, m/s.
    pub(crate) free: f64,
}

impl NodeContact {
    /// The impulse of a step, N s; zero where the node stays free.
    pub(crate) fn impulse(&mut self, approach: Approach, step_s: f64) -> f64 {
        let Approach { mass, gap, before, free } = approach;
        let after = -gap / step_s;
        let impulse = mass * (after - free);
        if impulse > OPEN_BELOW * self.held {
            self.held = impulse;
            self.taken = (self.taken - 0.5 * impulse * (before + after)).max(0.0);
            return impulse;
        }
        let taken = std::mem::take(self).taken;
        // What gives it back: p (before + free + p / m) / 2 = taken.
        let mean = 0.5 * (before + free);
        let root = (mean * mean + 2.0 * taken / mass).sqrt();
        // Without a difference of near numbers; the same for both signs of the mean.
        let impulse = if mean > 0.0 { 2.0 * taken / (root + mean) } else { mass * (root - mean) };
        if taken > 0.0 { impulse } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    //! A node that stops and leaves has the energy that it came with; one that does not meet the floor is left alone.
    use super::*;

    #[test]
    fn a_node_leaves_with_the_speed_it_came_with() {
        let mut contact = NodeContact::default();
        let stop = contact.impulse(Approach { mass: 2.0, gap: 0.0, before: -3.0, free: -3.0 }, 0.1);
        assert_eq!(stop, 6.0);
        let leave = contact.impulse(Approach { mass: 2.0, gap: 0.0, before: 0.0, free: 0.0 }, 0.1);
        assert_eq!(leave, 6.0);
        assert_eq!(contact, NodeContact::default());
    }

    #[test]
    fn a_node_above_the_floor_is_left_alone() {
        let approach = Approach { mass: 2.0, gap: 1.0, before: -3.0, free: -3.0 };
        assert_eq!(NodeContact::default().impulse(approach, 0.1), 0.0);
    }
}
