//! The value of a quantity in a sample. What a sample does not have is NaN.

use super::list::{Along, OfBody, OfContacts, OfEnergy, OfJoint};
use super::{Of, Quantity};
use polhode::scene::Coordinate;
use polhode::spatial::DVec3;
use polhode::{BodyId, BodySample, ContactView, Energy, JointSample};

impl Quantity {
    /// Of the bodies of a sample; none of another kind of quantity.
    pub fn of_bodies(&self, bodies: &[BodySample]) -> Option<f64> {
        let Of::Body(body, own) = self.of else { return None };
        let sample = bodies.get(body.index())?;
        Some(match own {
            OfBody::Position => self.of_vector(sample.pose.translation),
            OfBody::Velocity => self.of_vector(sample.velocity.linear),
            OfBody::AngularVelocity => self.of_vector(sample.velocity.angular),
            OfBody::Orientation => {
                let numbers = sample.pose.rotation.to_wxyz();
                self.component.and_then(|place| numbers.get(place).copied()).unwrap_or(1.0)
            }
        })
    }

    /// Of the joints of a sample; none of another kind of quantity, or of a joint that is not there.
    pub fn of_joints(&self, joints: &[JointSample]) -> Option<f64> {
        let Of::Joint(joint, own) = self.of else { return None };
        let sample = joints.iter().find(|sample| sample.joint == joint)?;
        Some(match own {
            OfJoint::Force => self.of_vector(sample.load.map_or(DVec3::NAN, |load| load.force_n)),
            OfJoint::Moment => self.of_vector(sample.load.map_or(DVec3::NAN, |load| load.moment_n_m)),
            OfJoint::ReactionForce => self.of_vector(sample.reaction.map_or(DVec3::NAN, |own| own.force_n)),
            OfJoint::ReactionMoment => self.of_vector(sample.reaction.map_or(DVec3::NAN, |own| own.moment_n_m)),
            own => of_joint(sample, own).unwrap_or(f64::NAN),
        })
    }

    /// Of the contacts of a sample; none of another kind of quantity.
    pub fn of_contacts(&self, contacts: &[ContactView]) -> Option<f64> {
        let Of::Contacts(body, other, own) = self.of else { return None };
        let sign = |view: &ContactView| sign_of(view, body, other);
        let of_pair = || contacts.iter().filter_map(|view| Some((view, sign(view)?)));
        Some(match own {
            OfContacts::NormalForce => of_pair().map(|(view, _)| view.normal_force_n).fold(0.0, |sum, own| sum + own),
            OfContacts::Force => {
                let force =
                    |(view, sign): (&ContactView, f64)| (view.normal * view.normal_force_n + view.friction_n) * sign;
                self.of_vector(of_pair().map(force).fold(DVec3::ZERO, |sum, own| sum + own))
            }
            OfContacts::Friction => self.of_vector(
                of_pair().map(|(view, sign)| view.friction_n * sign).fold(DVec3::ZERO, |sum, own| sum + own),
            ),
            OfContacts::Separation => of_pair().map(|(view, _)| view.separation_m).reduce(f64::min).unwrap_or(f64::NAN),
            OfContacts::Points => of_pair().count() as f64,
        })
    }

    /// Of the energies of a sample; none of another kind of quantity.
    pub const fn of_energy(&self, energy: &Energy) -> Option<f64> {
        let Of::Energy(own) = self.of else { return None };
        Some(match own {
            OfEnergy::Kinetic => energy.kinetic_j,
            OfEnergy::Potential => energy.potential_j,
            OfEnergy::Total => energy.final_j,
        })
    }

    /// A component of a vector, or its length.
    fn of_vector(&self, vector: DVec3) -> f64 {
        match self.component {
            Some(component) => vector[component.min(2)],
            None => vector.length(),
        }
    }
}

/// A quantity of a joint that is one number; none where the joint or the tier has none.
pub(crate) fn of_joint(sample: &JointSample, own: OfJoint) -> Option<f64> {
    let coordinate = |wanted: Coordinate| sample.coordinates.iter().find(|own| own.0 == wanted).map(|own| own.1);
    let efforts = |along: Along| sample.efforts.iter().find(|own| along.is(own.0)).map(|own| own.1);
    match own {
        OfJoint::Value(wanted) => coordinate(wanted).map(|own| own.value),
        OfJoint::Rate(wanted) => coordinate(wanted).map(|own| own.rate),
        OfJoint::Power => sample.power_w,
        OfJoint::Effort(along, cause) => efforts(along).map(|own| cause.of(&own)),
        OfJoint::ByDrive(along) => efforts(along).map(|own| own.drive),
        OfJoint::All(along) => efforts(along).map(|own| own.sum()),
        OfJoint::Force | OfJoint::Moment | OfJoint::ReactionForce | OfJoint::ReactionMoment => None,
    }
}

/// The sign of the forces of a contact on a body, if it is one of it, with the other one where that is given.
fn sign_of(view: &ContactView, body: BodyId, other: Option<BodyId>) -> Option<f64> {
    let is_other = |id: BodyId| other.is_none_or(|other| other == id);
    match (view.body_a == body, view.body_b == body) {
        (true, _) if is_other(view.body_b) => Some(1.0),
        (_, true) if is_other(view.body_a) => Some(-1.0),
        _ => None,
    }
}
