//! In which coordinates joints are integrated, and for which scenes reduced ones are available.
//!
//! Reduced coordinates are those of the joints of trees (`crate::reduced`). They need joints with coordinates of their
//! own, no loop, and nothing that pushes: no contacts, no limits, no dry friction. Gears, prescribed motions and joints
//! that break have constraint rows.

use super::facts::TierFeature;
use crate::constraint::tree_joint::is_of_trees;
use crate::scene::{Coordinate, Coordinates, Integrator, Joint, Scene, SceneError, Tier};
use polhode_spatial::DisjointSets;

impl Scene {
    /// Checks that reduced coordinates apply where the method asks for them.
    ///
    /// # Errors
    /// With the reason why they do not.
    pub(super) fn check_coordinates(&self) -> Result<(), SceneError> {
        if self.method.coordinates.unwrap_or_default() == Coordinates::Maximal {
            return Ok(());
        }
        let refused = |reason: String| Err(SceneError::ReducedCoordinates { reason });
        let tier = self.method.named_tier().unwrap_or_default();
        if !tier.facts().takes(TierFeature::ReducedCoordinates) {
            let instead = Tier::names_with(TierFeature::ReducedCoordinates);
            return refused(format!("the tier is `{}`: tier {instead} has them", tier.name()));
        }
        if self.method.integrator.is_some_and(|integrator| integrator != Integrator::Dop853) {
            return refused("method.integrator is not `dop853`".to_owned());
        }
        if let Some(body) = self.bodies.iter().find(|body| body.pivot_point().is_some()) {
            return refused(format!("body {} has a pivot: a ball joint with the world does the same", body.name()));
        }
        for (number, joint) in self.joints.iter().enumerate() {
            if let Some(reason) = self.reason_against(joint) {
                return refused(format!("joint {number} {reason}"));
            }
        }
        if !self.gears.is_empty() || !self.coordinate_motions.is_empty() {
            return refused("gears, and prescribed motions of joints, need maximal ones".to_owned());
        }
        if let Some(number) = self.first_joint_of_a_loop() {
            return refused(format!("joint {number} closes a loop"));
        }
        if let Some((a, b)) = self.first_pair_that_may_collide() {
            let [a, b] = [a, b].map(|body| self.bodies[body].name());
            return refused(format!(
                "bodies {a} and {b} may touch: bodies without shapes, or [[no_contact]], are needed"
            ));
        }
        Ok(())
    }

    /// Why a joint is not one of a tree.
    fn reason_against(&self, joint: &Joint) -> Option<String> {
        let kind = joint.kind();
        if !is_of_trees(kind) {
            return Some(format!("is of the kind {}: ball, hinge and slider are available", kind.name()));
        }
        if joint.strength().is_some() {
            return Some("may break".to_owned());
        }
        if joint.bodies().any(|body| self.bodies[body].motion().is_some()) {
            return Some("holds a body that follows a motion".to_owned());
        }
        let freedom = |&coordinate: &Coordinate| joint.freedom(coordinate);
        let freedoms = || kind.coordinates().iter().filter_map(freedom);
        if freedoms().any(|own| own.limits().is_some()) {
            return Some("has limits".to_owned());
        }
        freedoms().any(|own| own.friction().is_some()).then(|| "has dry friction".to_owned())
    }

    fn first_joint_of_a_loop(&self) -> Option<usize> {
        let world = self.bodies.len();
        let mut sets = DisjointSets::new(world + 1);
        self.joints.iter().position(|joint| {
            let place = |body: usize| if self.bodies[body].is_fixed() { world } else { body };
            let mut ends = joint.bodies().map(place).chain([world]);
            let (a, b) = (ends.next().unwrap_or(world), ends.next().unwrap_or(world));
            let closes = sets.smallest(a) == sets.smallest(b);
            sets.join(a, b);
            closes
        })
    }

    fn first_pair_that_may_collide(&self) -> Option<(usize, usize)> {
        let shaped: Vec<usize> = (0..self.bodies.len()).filter(|&body| self.bodies[body].geometry.is_some()).collect();
        let of = |&a: &usize| shaped.iter().copied().find(|&b| b > a && self.may_collide(a, b)).map(|b| (a, b));
        shaped.iter().find_map(of)
    }
}
