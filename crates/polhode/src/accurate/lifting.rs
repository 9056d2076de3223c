//! Bodies that pass onto a higher face are lifted onto it.
//!
//! A body that slides from one face to the next passes over a step of at most the touch distance
//! (`crate::collision::passing`). It is lifted by the height of the step, along the normal of the higher face and
//! without a rotation, so that a flat body remains parallel to both faces: tilted by the step over its length, it would
//! sink into the border of the higher face as it moves on. Two movable bodies share the height in the inverse ratio of
//! their masses. The energy is booked as that of a projection.
//!
//! Bodies on a pivot are not lifted: the projection of held contacts moves them.

use super::resolve::Resolution;
use crate::collision::touch::Touch;
use crate::constraint::ConstraintId;
use crate::joints::held;
use crate::model::tolerances;
use crate::solve::projection::Projection;
use polhode_dynamics::RigidBody;

impl Resolution<'_> {
    /// Lifts the bodies of pairs that pass each other (ascending) onto the faces along which they pass.
    pub(super) fn lift_onto_faces(&mut self, passing: &[(usize, usize)]) {
        for &(a, b) in passing {
            let of_pair = |touch: &&Touch| (touch.id.a, touch.id.b) == (a, b);
            let separation = |touch: &Touch| touch.kinematics.geometry.separation;
            let touches = self.instant.touches.iter().filter(of_pair);
            let Some(&deepest) = touches.min_by(|x, y| separation(x).total_cmp(&separation(y))) else { continue };
            let depth = -separation(&deepest);
            let inverse_mass = |body: usize| match &self.core.model.bodies[body].rigid {
                Some(rigid) if self.core.model.bodies[body].moves() => RigidBody::mass(rigid).recip(),
                _ => 0.0,
            };
            let (of_a, of_b) = (inverse_mass(a), inverse_mass(b));
            let bodies: Vec<usize> = [(a, of_a), (b, of_b)].iter().filter(|(_, m)| *m > 0.0).map(|(i, _)| *i).collect();
            let has_pivot = held::bilaterals(&self.core.model, &self.motions.states, &bodies).next().is_some();
            if depth <= tolerances::rounding(&self.core.model, &self.motions.states, a, b)
                || bodies.is_empty()
                || has_pivot
            {
                continue;
            }
            self.motions.end_flights(self.core, self.instant.t, &bodies);
            let before = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &bodies);
            let rise = deepest.kinematics.geometry.normal * (depth / (of_a + of_b));
            self.motions.states[a].pose.translation += rise * of_a;
            self.motions.states[b].pose.translation -= rise * of_b;
            let after = self.core.accounts.books.balance(&self.core.model, &self.motions.states, &bodies);
            let farthest = Some(ConstraintId::Contact(deepest.id));
            let done = Projection { moved_m: depth, farthest, ..Projection::default() };
            self.core.book_lift(self.instant.t, &self.motions.states, &done, (before, after));
            self.refresh_kinematics();
        }
    }
}
