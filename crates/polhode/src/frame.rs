//! Everything that a viewer draws of one instant.

use crate::BodyId;
use crate::body_sample::BodySample;
use crate::collision::contact_set::Touch;
use crate::energy::Energy;
use crate::ledger::Ledger;
use crate::report::Certificate;
use crate::world::World;
use polhode_contact::ContactFeature;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// How a body moves at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MotionKind {
    /// Never, or as its scene prescribes; or it has been removed.
    Given,
    /// In free flight, in closed form.
    Flight,
    /// Integrated, by forces and held contacts.
    Integrated,
    /// At rest: its contacts keep it in certified equilibrium.
    Rest,
}

/// A contact that touches.
///
/// Only sums of contact forces and the motion are unique: where statics leaves the forces open (four legs on a floor) the
/// least ones are given, and another method may give others for the same motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactView {
    /// Body A.
    pub body_a: BodyId,
    /// Body B.
    pub body_b: BodyId,
    /// Which features touch.
    pub feature: ContactFeature,
    /// Where, world, m.
    pub point_m: DVec3,
    /// Unit normal from B to A, world.
    pub normal: DVec3,
    /// Signed distance along the normal, m; negative when the bodies overlap.
    pub separation_m: f64,
    /// Force on A along the normal, N; zero for a contact that opens, NaN if it could not be found. In the tiers of fixed
    /// steps it is that of the last step; in `thesis` zero before the first one.
    pub normal_force_n: f64,
}

/// What holds a body at its pivot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PivotView {
    /// The body.
    pub body: BodyId,
    /// Where it is held, world, m.
    pub point_m: DVec3,
    /// Force of the pivot on the body, world, N; NaN if it could not be found. Unique but for what contacts leave open.
    pub force_n: DVec3,
}

/// Bodies that move together or rest together: connected by contacts that hold, or by forces that couple them; in the tier
/// `stepped` by what they may meet within a step, in `thesis` all. Bodies in free flight and immovable ones are in none.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IslandView {
    /// The bodies, ascending.
    pub bodies: Vec<BodyId>,
}

/// All bodies at one instant, with what connects them. The place of a body in the lists is its [`BodyId::index`].
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// s.
    pub t_s: f64,
    /// Poses and velocities.
    pub bodies: Vec<BodySample>,
    /// How each body moves.
    pub motions: Vec<MotionKind>,
    /// Contacts that touch, with their forces.
    pub contacts: Vec<ContactView>,
    /// Bodies that move together.
    pub islands: Vec<IslandView>,
    /// Energies; `initial_j` is that at the start of the run.
    pub energy: Energy,
    /// Where the energy went so far: what a step takes is booked at its end.
    pub ledger: Ledger,
    /// What is certain of the accuracy of the run so far.
    pub certificate: Certificate,
    /// Steps made so far.
    pub steps: u64,
}

impl World {
    /// Adds what is seen of a contact that bears this force (N); one that stands for its mirror image in a planar motion too
    /// is two.
    pub(crate) fn view_contact(&self, states: &[BodyState], touch: &Touch, force_n: f64, views: &mut Vec<ContactView>) {
        let (id, geometry) = (touch.id, touch.kinematics.geometry);
        let view = ContactView {
            body_a: BodyId::new(id.a),
            body_b: BodyId::new(id.b),
            feature: id.feature,
            point_m: geometry.point,
            normal: geometry.normal,
            separation_m: geometry.separation,
            normal_force_n: force_n,
        };
        let Some(aside) = self.mirrored(states, id) else { return views.push(view) };
        for point_m in [view.point_m - aside, view.point_m + aside] {
            views.push(ContactView { point_m, normal_force_n: 0.5 * force_n, ..view });
        }
    }
}
