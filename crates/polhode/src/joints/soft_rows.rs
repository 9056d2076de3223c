//! Forces at joints in a time step: which are given as a kick, and the soft rows (`softness.rs`) of all others.

use crate::constraint::ConstraintId;
use crate::constraint::coordinate::CoordinateAt;
use crate::constraint::joint_forces::{Gains, JointForce, Source};
use crate::constraint::row::{BilateralRow, Member, Part, RowKind, RowsAt};
use crate::constraint::softness::{LinearForce, Softness};
use crate::joints::bilateral::Bilateral;
use crate::model::{Forces, Model};
use crate::scene::Drive;
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Dependence, Field};
use polhode_spatial::{Pose, Velocity};

impl Forces {
    /// Whether any of these forces at joints, given as a kick, is that of a motor at its bound.
    pub(crate) fn are_motors_at_bounds(&self, kicks: &[usize]) -> bool {
        let force = |number: &usize| self.of_joints.get(number.checked_sub(self.first_of_joints)?);
        kicks.iter().filter_map(force).any(|force| force.dependence() == Dependence::Velocities)
    }

    /// The forces at joints of these bodies, with their numbers among the fields.
    fn joint_forces_among<'a>(&'a self, bodies: &'a [usize]) -> impl Iterator<Item = (usize, &'a JointForce)> {
        let is_among = |end: &Option<(usize, usize)>| end.is_some_and(|(body, _)| bodies.binary_search(&body).is_ok());
        let own = self.of_joints.iter().enumerate().filter(move |(_, force)| force.ends.iter().any(is_among));
        own.map(|(place, force)| (self.first_of_joints + place, force))
    }
}

/// The numbers, among the fields, of those forces at joints that a step gives as a kick: constant efforts, and
/// those of motors that ask for more than their bound in these states. All others are soft rows.
pub(crate) fn kicks_of_joints(model: &Model, states: &[BodyState], bodies: &[usize]) -> Vec<usize> {
    let own = model.forces.joint_forces_among(bodies);
    own.filter(|(_, force)| force.is_constant(model, states)).map(|(number, _)| number).collect()
}

/// The other forces at joints of these bodies as soft rows of a step of `h` (s) in the states of its middle;
/// `kicks` are the numbers of those that have been given, and `kicked` is by how much the kick has changed the rate
/// of a row (m/s).
pub(crate) fn soft_rows(
    model: &Model,
    (states, bodies): (&[BodyState], &[usize]),
    h: f64,
    kicks: &[usize],
    kicked: impl Fn(&Bilateral, &BilateralRow) -> f64,
) -> Vec<Bilateral> {
    let own: Vec<_> = model.forces.joint_forces_among(bodies).filter(|(number, _)| !kicks.contains(number)).collect();
    let coordinate = |force: &JointForce| (force.joint.number(), force.place);
    let of_coordinate = |forces: &[(usize, &JointForce)]| JointForce::soft_row(forces, model, states, h);
    let mut rows: Vec<Bilateral> =
        own.chunk_by(|(_, x), (_, y)| coordinate(x) == coordinate(y)).filter_map(of_coordinate).collect();
    for bilateral in &mut rows {
        let change: f64 = bilateral.rows.iter().map(|row| kicked(bilateral, row)).sum();
        if let Some(softness) = &mut bilateral.softness {
            softness.rate_before = softness.rate - change;
        }
    }
    rows
}

impl JointForce {
    fn in_world(&self, model: &Model, states: &[BodyState]) -> Option<CoordinateAt> {
        let motion = |body: usize| -> (Pose, Velocity) { (states[body].pose, model.velocity(body, &states[body])) };
        self.coordinate_at(motion)
    }

    /// Whether its effort does not change with small motions.
    fn is_constant(&self, model: &Model, states: &[BodyState]) -> bool {
        let Some(at) = self.in_world(model, states) else { return true };
        let Gains { stiffness, damping } = self.source.gains(at.value / self.unit, at.own_rate() / self.unit);
        stiffness == 0.0 && damping == 0.0
    }

    /// Its law in the unit of its row.
    fn linear(&self) -> LinearForce {
        let (stiffness, damping, at_zero) = match self.source {
            Source::Spring { stiffness, rest } => (stiffness, 0.0, stiffness * rest),
            Source::Damper { damping } => (0.0, damping, 0.0),
            Source::Motor(motor) => match motor.drive() {
                Drive::Effort(effort) => (0.0, 0.0, effort),
                Drive::Velocity { velocity, gain } => (0.0, gain, gain * velocity),
                Drive::Position { position, stiffness, damping } => (stiffness, damping, stiffness * position),
            },
        };
        let (unit, square) = (self.unit, self.unit * self.unit);
        LinearForce { stiffness: stiffness / square, damping: damping / square, at_zero: at_zero / unit }
    }

    /// The soft row of the forces along one coordinate; none where it has no direction.
    fn soft_row(forces: &[(usize, &Self)], model: &Model, states: &[BodyState], h: f64) -> Option<Bilateral> {
        let &(_, first) = forces.first()?;
        let at = first.in_world(model, states)?;
        let signs = first.ends.iter().zip([1.0, -1.0]);
        let member = |(end, sign): (&Option<(usize, usize)>, f64)| {
            let (body, _) = (*end)?;
            Some(Member { body, arm: at.point - states[body].pose.translation, sign, part: Part::First })
        };
        let members: Vec<Member> = signs.filter_map(member).collect();
        let kind = at.moment.map_or(RowKind::Along(at.direction), |moment| RowKind::About(moment.axis));
        let mut row = BilateralRow { kind, gap: 0.0, rate: 0.0, bias: 0.0 };
        let rate = |member: &Member| {
            let (along, about) = row.entries(member);
            let velocity = model.velocity(member.body, &states[member.body]);
            along.dot(velocity.linear) + about.dot(velocity.angular)
        };
        row.rate = members.iter().map(rate).sum();
        let none = LinearForce::default();
        let (spring, damper, motor) = (none, none, none);
        let mut softness =
            Softness { spring, damper, motor, value: at.value, rate_before: row.rate, rate: row.rate, h };
        for (_, force) in forces {
            match force.source {
                Source::Spring { .. } => softness.spring = force.linear(),
                Source::Damper { .. } => softness.damper = force.linear(),
                Source::Motor(_) => softness.motor = force.linear(),
            }
        }
        let (first_body, second_body) = first.joint.pair();
        let id = ConstraintId::Joint { joint: first.joint.number(), bodies: (first_body, second_body) };
        let rows = RowsAt { point: at.point, members, drivers: Vec::new(), rows: vec![row] };
        softness.responds().then(|| Bilateral::soft(id, rows, softness))
    }
}
