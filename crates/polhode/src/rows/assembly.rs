//! From contacts and bodies to the rows that the response crate solves.
//!
//! Generalised velocity of a body: (v of the centre of mass, w), world axes; inverse mass `diag(1/m 1, I^-1)`. The row
//! of a contact is `(n, r_A x n)` for A and `-(n, r_B x n)` for B, with r from the centre of mass to the point
//! (thesis 3.4, equations 15-18). Immovable bodies have no entry (erratum E17). In planar motion a velocity has three
//! coordinates instead of six, and everything else is the same.

use crate::constraint::ConstraintId;
use crate::constraint::row::{BilateralRow, Member, RowKind};
use crate::constraint::softness::Softness;
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::bilateral::{self, Bilateral, Reaction};
use crate::joints::held;
use crate::joints::joint_friction::{self, LastRound, Pressed};
use crate::model::plane_of_motion::PlaneOfMotion;
use crate::model::work::{self, Work};
use crate::model::{Loads, Model, prescribed};
use crate::rows::rotation_row::RotationRow;
use polhode_contact::{ContactGeometry, ContactKinematics, TangentialKinematics};
use polhode_dynamics::BodyState;
use polhode_response::solve::held::{Independence, Supports};
use polhode_response::{ContactProblem, ResponseError};
use polhode_spatial::DVec3;
use std::borrow::Cow;
use std::ops::Range;

/// Coordinates of a body's generalised velocity in space.
const SPACE_WIDTH: usize = 6;

/// Coordinates of a body's generalised velocity: six in space, three in a plane.
#[derive(Debug, Clone, Copy)]
enum Coordinates {
    Space,
    Plane(PlaneOfMotion),
}

impl Coordinates {
    fn of(model: &Model, bodies: &[usize]) -> Self {
        model.planar.of_group(bodies).map_or(Self::Space, Self::Plane)
    }

    fn width(self) -> usize {
        match self {
            Self::Space => SPACE_WIDTH,
            Self::Plane(_) => 3,
        }
    }

    /// The coordinates of a linear and an angular part; the first [`Self::width`] numbers.
    fn of_parts(self, linear: DVec3, angular: DVec3) -> [f64; SPACE_WIDTH] {
        match self {
            Self::Space => [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z],
            Self::Plane(plane) => {
                let [x, y, turn] = plane.coordinates(linear, angular);
                [x, y, turn, 0.0, 0.0, 0.0]
            }
        }
    }

    /// Appends the coordinates of a linear and an angular part.
    fn push(self, out: &mut Vec<f64>, linear: DVec3, angular: DVec3) {
        out.extend_from_slice(&self.of_parts(linear, angular)[..self.width()]);
    }

    /// Linear and angular part of coordinates.
    fn parts(self, c: &[f64]) -> (DVec3, DVec3) {
        match (self, c) {
            (Self::Space, &[a, b, c, d, e, f]) => (DVec3::new(a, b, c), DVec3::new(d, e, f)),
            (Self::Plane(plane), &[a, b, c]) => plane.velocity([a, b, c]),
            // Never reached: all chunks of coordinates have the right width.
            _ => (DVec3::ZERO, DVec3::ZERO),
        }
    }
}

/// A row along a tangent of a contact with friction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TangentRow {
    pub(crate) id: ContactId,
    /// The contact, with the tangent (unit vector, world) in the place of its normal.
    pub(crate) along: ContactGeometry,
    /// Component along the tangent of the terms of `u_T'` that are not linear in the accelerations, m/s^2.
    pub(crate) acceleration_bias: f64,
}

impl TangentRow {
    /// That of a contact along `tangent`.
    pub(crate) fn new(id: ContactId, geometry: &ContactGeometry, terms: &TangentialKinematics, tangent: DVec3) -> Self {
        let along = ContactGeometry { normal: tangent, ..*geometry };
        Self { id, along, acceleration_bias: tangent.dot(terms.acceleration_bias) }
    }
}

/// The constraints of a group of bodies, assembled: a row for each contact, in the order given, then those of bilateral
/// constraints, in their order, then rows along tangents of contacts with friction, then rows of their rotations.
#[derive(Debug)]
pub(crate) struct Assembly {
    pub(crate) problem: ContactProblem,
    /// The constraint of each row of a contact or a bilateral constraint.
    constraints: Vec<ConstraintId>,
    /// How many of them are contacts.
    contacts: usize,
    bilaterals: Vec<Bilateral>,
    tangents: Vec<TangentRow>,
    /// The row of each.
    tangent_rows: Vec<usize>,
    rotations: Vec<RotationRow>,
    rotation_rows: Vec<usize>,
    /// The rows of contacts that a given force presses.
    pub(super) pressed: Vec<(usize, Pressed)>,
    pub(super) last_round: LastRound,
    /// The rows of stops: the joint, and the normal.
    stops: Vec<(usize, usize, DVec3)>,
    /// Which reactions of joints do the same, where that was asked for, or where they press bearings and close loops.
    supports: Option<Supports>,
    /// Movable bodies, in the order of the problem's blocks.
    bodies: Vec<usize>,
    coordinates: Coordinates,
    /// The count of work of the model.
    pub(super) work: Work,
}

impl Assembly {
    /// Rows of `contacts` and of the bilateral constraints of `bodies` (movable, ascending).
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn new(
        model: &Model,
        states: &[BodyState],
        bodies: &[usize],
        contacts: impl Iterator<Item = (ContactId, ContactGeometry)>,
    ) -> Result<Self, ResponseError> {
        let bilaterals = held::bilaterals(model, states, bodies).collect();
        Self::with_bilaterals(model, (states, bodies), contacts, bilaterals)
    }

    /// The same, where the bilateral constraints of the bodies in these states are known.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn with_bilaterals(
        model: &Model,
        (states, bodies): (&[BodyState], &[usize]),
        contacts: impl Iterator<Item = (ContactId, ContactGeometry)>,
        bilaterals: Vec<Bilateral>,
    ) -> Result<Self, ResponseError> {
        let coordinates = Coordinates::of(model, bodies);
        let width = coordinates.width();
        let mut inverse_masses = Vec::with_capacity(bodies.len() * width * width);
        for &body in bodies {
            push_inverse_mass(&mut inverse_masses, coordinates, model, (states, body));
        }
        let mut problem = ContactProblem::new(width, inverse_masses)?;
        let mut constraints = Vec::new();
        let (mut pressed, mut stops) = (Vec::new(), Vec::new());
        let rows = ContactRows { states, bodies, coordinates };
        for (id, geometry) in contacts {
            constraints.push(ConstraintId::Contact(id));
            if let Feature::Stop(stop) = id.feature {
                stops.push((problem.len(), stop.joint, geometry.normal));
            }
            if let Some(own) = joint_friction::pressed(model, states, id) {
                let row = problem.len();
                rows.row(id, &geometry, |entries| problem.push_held_row(entries))?;
                problem.soften(row, own.compliance)?;
                pressed.push((row, own));
            } else {
                rows.row(id, &geometry, |entries| problem.push_row(entries))?;
            }
        }
        let contacts = problem.len();
        problem.reserve(bilaterals.iter().map(|own| own.rows.len()).sum());
        for bilateral in &bilaterals {
            constraints.extend(std::iter::repeat_n(bilateral.id, bilateral.rows.len()));
            rows.bilateral(bilateral, &mut problem)?;
        }
        let depend = pressed.iter().any(|(_, own)| own.is_by_load()) && held::has_loops_among(model, bodies);
        let supports = depend.then(|| Supports::of(&problem, contacts..problem.len()));
        model.work.add(bodies.len() * work::OF_BODY);
        let bodies = bodies.to_vec();
        Ok(Self {
            problem,
            constraints,
            contacts,
            bilaterals,
            tangents: Vec::new(),
            tangent_rows: Vec::new(),
            rotations: Vec::new(),
            rotation_rows: Vec::new(),
            pressed,
            last_round: LastRound::default(),
            stops,
            supports,
            bodies,
            coordinates,
            work: model.work.shared(),
        })
    }

    /// Adds soft rows between these bodies, after those of contacts and bilateral constraints.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn push_soft(&mut self, states: &[BodyState], soft: Vec<Bilateral>) -> Result<(), ResponseError> {
        let rows = ContactRows { states, bodies: &self.bodies, coordinates: self.coordinates };
        for bilateral in &soft {
            let row = self.problem.len();
            rows.bilateral(bilateral, &mut self.problem)?;
            if let Some(softness) = &bilateral.softness {
                self.problem.soften(row, softness.compliance())?;
            }
            self.constraints.push(bilateral.id);
        }
        self.bilaterals.extend(soft);
        Ok(())
    }

    /// Constant terms of the rows of contacts and bilateral constraints in a time step, from those of the contacts,
    /// m/s, where the kick of fields has changed the rate of a row by `kicked` (m/s). A bilateral constraint that is
    /// rigid ends with the opposite of its rate before the kick, so that it does no work, and the second half of the
    /// step takes back the gap of the first.
    pub(crate) fn step_constants(
        &self,
        of_contacts: impl Iterator<Item = f64>,
        kicked: impl Fn(&Bilateral, &BilateralRow) -> f64,
    ) -> Vec<f64> {
        let of_rows = |bilateral: &Bilateral| {
            let soft = bilateral.softness.as_ref().map(Softness::constant);
            let rigid = |row: &BilateralRow| 2.0 * row.rate - kicked(bilateral, row);
            bilateral.rows.iter().map(move |row| soft.unwrap_or_else(|| rigid(row))).collect::<Vec<_>>()
        };
        of_contacts.chain(self.bilaterals.iter().flat_map(of_rows)).collect()
    }

    /// Adds rows along tangents of contacts between these bodies, after those of contacts and pivots.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn push_tangents(
        &mut self,
        states: &[BodyState],
        tangents: impl Iterator<Item = TangentRow>,
    ) -> Result<(), ResponseError> {
        let (bodies, coordinates) = (&self.bodies, self.coordinates);
        let (problem, rows) = (&mut self.problem, ContactRows { states, bodies, coordinates });
        for tangent in tangents {
            let row = problem.len();
            self.tangent_rows.push(row);
            rows.row(tangent.id, &tangent.along, |entries| problem.push_held_row(entries))?;
            // A joint with friction slips along one line: its second tangent acts on nothing.
            if tangent.along.normal == DVec3::ZERO
                && let Some(compliance) = self.pressed.iter().map(|(_, own)| own.compliance).next()
            {
                problem.soften(row, compliance)?;
            }
            self.tangents.push(tangent);
        }
        Ok(())
    }

    /// Adds rows of rotations at contacts between these bodies, after those so far.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn push_rotations(&mut self, rotations: impl Iterator<Item = RotationRow>) -> Result<(), ResponseError> {
        for rotation in rotations {
            let rows: Vec<(usize, Vec<f64>)> = [(rotation.id.a, 1.0), (rotation.id.b, -1.0)]
                .into_iter()
                .filter_map(|(body, sign)| {
                    let index = self.bodies.binary_search(&body).ok()?;
                    let mut row = Vec::with_capacity(self.coordinates.width());
                    self.coordinates.push(&mut row, DVec3::ZERO, rotation.axis * sign);
                    Some((index, row))
                })
                .collect();
            let entries: Vec<(usize, &[f64])> = rows.iter().map(|(index, row)| (*index, row.as_slice())).collect();
            self.rotation_rows.push(self.problem.len());
            self.problem.push_held_row(&entries)?;
            self.rotations.push(rotation);
        }
        Ok(())
    }

    /// The rows along tangents with their numbers (forces, velocities), from those of all rows.
    pub(crate) fn of_tangents<'a>(&'a self, values: &'a [f64]) -> impl Iterator<Item = (&'a TangentRow, f64)> {
        self.tangents.iter().zip(&self.tangent_rows).filter_map(|(row, &index)| Some((row, *values.get(index)?)))
    }

    /// The rows of rotations with their numbers, likewise.
    pub(crate) fn of_rotations<'a>(&'a self, values: &'a [f64]) -> impl Iterator<Item = (&'a RotationRow, f64)> {
        self.rotations.iter().zip(&self.rotation_rows).filter_map(|(row, &index)| Some((row, *values.get(index)?)))
    }

    /// The rows of rotations.
    pub(crate) fn rotations(&self) -> &[RotationRow] {
        &self.rotations
    }

    /// The rows along tangents.
    pub(crate) fn tangents(&self) -> &[TangentRow] {
        &self.tangents
    }

    /// Index of the first row along a tangent.
    pub(crate) fn first_tangent(&self) -> usize {
        self.problem.len() - self.rotations.len() - self.tangents.len()
    }

    /// The rows of bilateral constraints.
    pub(crate) fn joint_rows(&self) -> Range<usize> {
        self.contacts..self.first_tangent()
    }

    /// The constraint of a row.
    pub(crate) fn constraint(&self, row: usize) -> Option<ConstraintId> {
        if row >= self.first_tangent() {
            let tangent = self.tangent_rows.binary_search(&row).ok().map(|place| self.tangents[place].id);
            let rotation = || self.rotation_rows.binary_search(&row).ok().map(|place| self.rotations[place].id);
            return tangent.or_else(rotation).map(ConstraintId::Contact);
        }
        self.constraints.get(row).copied()
    }

    /// The bilateral constraints at the states of the assembly.
    pub(crate) fn bilaterals(&self) -> &[Bilateral] {
        &self.bilaterals
    }

    /// The gaps of the rows of contacts and bilateral constraints, from the separations of the contacts, m.
    pub(crate) fn gaps(&self, of_contacts: impl Iterator<Item = f64>) -> Vec<f64> {
        of_contacts.chain(self.bilateral_rows().map(|row| row.gap)).collect()
    }

    /// The rates of those rows, from the rates of separation of the contacts, m/s.
    pub(crate) fn rates(&self, of_contacts: impl Iterator<Item = f64>) -> Vec<f64> {
        of_contacts.chain(self.bilateral_rows().map(|row| row.rate)).collect()
    }

    fn bilateral_rows(&self) -> impl Iterator<Item = &BilateralRow> {
        self.bilaterals.iter().flat_map(|bilateral| &bilateral.rows)
    }

    /// The bilateral constraints with the reaction of each, from the forces (N; impulses, N s) of all rows.
    pub(crate) fn reactions(&self, forces: &[f64]) -> impl Iterator<Item = (&Bilateral, Reaction)> + Clone {
        let mut left = forces.get(self.contacts..).unwrap_or_default();
        self.bilaterals.iter().map_while(move |bilateral| {
            let (own, others) = left.split_at_checked(bilateral.rows.len())?;
            left = others;
            Some((bilateral, bilateral.reaction(own)))
        })
    }

    /// Movable bodies, in the order of the problem's blocks.
    pub(crate) fn bodies(&self) -> &[usize] {
        &self.bodies
    }

    /// Generalised accelerations without contact forces: `g + F/m` and `I^-1 (torque - w x L)`.
    pub(crate) fn free_accelerations(&self, model: &Model, states: &[BodyState], loads: &Loads) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.bodies.len() * self.coordinates.width());
        for &body in &self.bodies {
            let (linear, angular) = free_acceleration(model, states, loads, body);
            self.coordinates.push(&mut out, linear, angular);
        }
        out
    }

    /// Generalised accelerations of bodies that all have this acceleration (m/s^2) and do not turn.
    pub(crate) fn uniform_accelerations(&self, linear: DVec3) -> Vec<f64> {
        let mut out = Vec::with_capacity(self.bodies.len() * self.coordinates.width());
        self.bodies.iter().for_each(|_| self.coordinates.push(&mut out, linear, DVec3::ZERO));
        out
    }

    /// Constant terms of the relative accelerations of the contacts at `t` (s):
    /// `b = J a_free + bias + sum +-n.(a + alpha x r)`, the sum over those members of a contact whose motion is
    /// prescribed.
    ///
    /// # Errors
    /// When `free` has the wrong length.
    pub(crate) fn acceleration_constants<'a>(
        &self,
        model: &Model,
        t: f64,
        states: &[BodyState],
        free: &[f64],
        contacts: impl Iterator<Item = (ContactId, &'a ContactKinematics)>,
    ) -> Result<Vec<f64>, ResponseError> {
        let mut b = self.problem.row_velocities(free)?;
        for (constant, (id, k)) in b.iter_mut().zip(contacts) {
            *constant +=
                k.acceleration_bias + prescribed::prescribed_acceleration_of(model, t, states, id, &k.geometry);
        }
        self.press(&mut b, 1.0);
        let rows = self.bilaterals.iter().flat_map(|own| own.rows.iter().map(move |row| (own, row)));
        for (constant, (bilateral, row)) in b.iter_mut().skip(self.contacts).zip(rows) {
            *constant += row.bias + bilateral::driven_acceleration(model, t, bilateral, row);
        }
        for (&index, row) in self.tangent_rows.iter().zip(&self.tangents) {
            let Some(constant) = b.get_mut(index) else { continue };
            *constant +=
                row.acceleration_bias + prescribed::prescribed_acceleration_of(model, t, states, row.id, &row.along);
        }
        for (&index, row) in self.rotation_rows.iter().zip(&self.rotations) {
            let Some(constant) = b.get_mut(index) else { continue };
            *constant += row.prescribed_acceleration(model, t);
        }
        Ok(b)
    }

    /// Finds which reactions of joints do the same, where these close loops.
    pub(crate) fn find_supports(&mut self) {
        self.supports = Some(Supports::of(&self.problem, self.rigid_rows()));
    }

    /// How far the rows of joints are from depending on each other, where that was asked for.
    pub(crate) fn independence(&self) -> Option<Independence> {
        self.supports.as_ref().map(Supports::independence)
    }

    /// The same where the joints of these bodies close loops.
    pub(crate) fn with_supports(mut self, model: &Model) -> Self {
        if self.supports.is_none() && !self.bilaterals.is_empty() && held::has_loops_among(model, &self.bodies) {
            self.find_supports();
        }
        self
    }

    /// The rows of joints without those that are soft, which follow them.
    fn rigid_rows(&self) -> Range<usize> {
        let rigid = self.bilaterals.iter().take_while(|own| own.softness.is_none());
        self.contacts..self.contacts + rigid.map(|own| own.rows.len()).sum::<usize>()
    }

    /// The forces of all rows (N; impulses, N s), where those of joints are, of all that do the same, the ones with
    /// which joints bear least: what their stops and their friction do at levers is a part of that.
    ///
    /// # Errors
    /// When there is not one force for each row.
    pub(crate) fn least<'a>(&self, forces: &'a [f64]) -> Result<Cow<'a, [f64]>, ResponseError> {
        let Some(supports) = &self.supports else { return Ok(Cow::Borrowed(forces)) };
        let rigid = self.rigid_rows();
        let multipliers = |own: &Bilateral| {
            let at_levers = Reaction { force: self.force_at_levers(own, forces), moment: DVec3::ZERO };
            own.rows.iter().map(|row| row.multiplier(at_levers)).collect::<Vec<_>>()
        };
        let at_levers: Vec<f64> = self.bilaterals.iter().flat_map(multipliers).take(rigid.len()).collect();
        let mut least = forces.to_vec();
        let own = least.get_mut(rigid).unwrap_or_default();
        own.iter_mut().zip(&at_levers).for_each(|(own, at_lever)| *own += at_lever);
        supports.leave_least(own)?;
        own.iter_mut().zip(&at_levers).for_each(|(own, at_lever)| *own -= at_lever);
        Ok(Cow::Owned(least))
    }

    /// The force of stops and friction of a joint on its first body, from those of all rows.
    pub(super) fn force_at_levers(&self, of: &Bilateral, forces: &[f64]) -> DVec3 {
        let ConstraintId::Joint { joint, .. } = of.id else { return DVec3::ZERO };
        let is_first = |id: ContactId| {
            of.members.iter().chain(&of.drivers).any(|member| (member.body == id.a) == (member.sign > 0.0))
        };
        let on_first = |id: ContactId, force: DVec3| if is_first(id) { force } else { -force };
        let is_at = |id: ContactId| matches!(id.feature, Feature::JointFriction(of) if of.joint == joint);
        let tangents = self.of_tangents(forces).filter(|(row, _)| is_at(row.id));
        let stops = self.stops.iter().filter(|(_, stop, _)| *stop == joint);
        let stops = stops.filter_map(|(row, _, normal)| {
            let id = self.constraints.get(*row)?.contact()?;
            Some(on_first(id, *normal * *forces.get(*row)?))
        });
        tangents.map(|(row, force)| on_first(row.id, row.along.normal * force)).chain(stops).sum()
    }

    /// Splits generalised velocities, accelerations or forces into (body, linear part, angular part).
    pub(crate) fn split<'a>(&'a self, columns: &'a [f64]) -> impl Iterator<Item = (usize, DVec3, DVec3)> + 'a {
        self.bodies
            .iter()
            .zip(columns.chunks_exact(self.coordinates.width()))
            .map(|(&body, c)| (body, self.coordinates.parts(c)))
            .map(|(body, (linear, angular))| (body, linear, angular))
    }
}

/// Makes the rows of contacts along their normals or tangents, and those of bilateral constraints.
struct ContactRows<'a> {
    states: &'a [BodyState],
    /// Movable bodies, in the order of the problem's blocks.
    bodies: &'a [usize],
    coordinates: Coordinates,
}

impl ContactRows<'_> {
    /// Passes the row of a contact along the normal of `geometry` to `push`: the block of each movable body.
    fn row<T>(&self, id: ContactId, geometry: &ContactGeometry, push: impl FnOnce(&[(usize, &[f64])]) -> T) -> T {
        let block = |body: usize, sign: f64| {
            let index = self.bodies.binary_search(&body).ok()?;
            let normal = geometry.normal * sign;
            let moment = (geometry.point - self.states[body].pose.translation).cross(normal);
            Some((index, self.coordinates.of_parts(normal, moment)))
        };
        let width = self.coordinates.width();
        match (block(id.a, 1.0), id.second().and_then(|second| block(second, -1.0))) {
            (Some((a, row_a)), Some((b, row_b))) => push(&[(a, &row_a[..width]), (b, &row_b[..width])]),
            (Some((index, row)), None) | (None, Some((index, row))) => push(&[(index, &row[..width])]),
            (None, None) => push(&[]),
        }
    }

    /// Adds the rows of a bilateral constraint to a problem.
    fn bilateral(&self, bilateral: &Bilateral, problem: &mut ContactProblem) -> Result<(), ResponseError> {
        let width = self.coordinates.width();
        let place = |member: &Member| Some((self.bodies.binary_search(&member.body).ok()?, *member));
        let mut members = bilateral.members.iter().filter_map(place);
        let (first, second) = (members.next(), members.next());
        for row in &bilateral.rows {
            let of = |(index, member): (usize, Member)| {
                let (linear, angular) = row.entries(&member);
                (index, self.coordinates.of_parts(linear, angular))
            };
            if matches!(row.kind, RowKind::Tied { .. }) {
                let mut entries: Vec<_> = bilateral.members.iter().filter_map(place).map(of).collect();
                merge(&mut entries);
                let entries: Vec<(usize, &[f64])> =
                    entries.iter().map(|(index, own)| (*index, &own[..width])).collect();
                problem.push_held_row(&entries)?;
                continue;
            }
            match (first.map(of), second.map(of)) {
                (Some((a, row_a)), Some((b, row_b))) => {
                    problem.push_held_row(&[(a, &row_a[..width]), (b, &row_b[..width])])?;
                }
                (Some((index, row)), None) | (None, Some((index, row))) => {
                    problem.push_held_row(&[(index, &row[..width])])?;
                }
                (None, None) => return Err(ResponseError::RowBodies(0)),
            }
        }
        Ok(())
    }
}

/// Adds up the entries of a body that is at both coordinates of a tie.
fn merge(entries: &mut Vec<(usize, [f64; SPACE_WIDTH])>) {
    entries.sort_by_key(|(body, _)| *body);
    entries.dedup_by(|(body, entry), (kept, sum)| {
        let is_same = body == kept;
        if is_same {
            sum.iter_mut().zip(entry).for_each(|(sum, own)| *sum += *own);
        }
        is_same
    });
}

/// Relative acceleration of the bodies of a contact along the normal of `geometry` (m/s^2) at `t` (s): its terms
/// that depend on velocities, `bias`, prescribed accelerations, and those of bodies (body, linear, angular).
pub(crate) fn relative_acceleration(
    model: &Model,
    (t, states): (f64, &[BodyState]),
    id: ContactId,
    (geometry, bias): (&ContactGeometry, f64),
    accelerations: impl Iterator<Item = (usize, DVec3, DVec3)>,
) -> f64 {
    let mut relative = bias + prescribed::prescribed_acceleration_of(model, t, states, id, geometry);
    for (body, linear, angular) in accelerations {
        let sign = if body == id.a {
            1.0
        } else if body == id.b {
            -1.0
        } else {
            continue;
        };
        let arm = geometry.point - states[body].pose.translation;
        relative += sign * geometry.normal.dot(linear + angular.cross(arm));
    }
    relative
}

/// Linear and angular acceleration of a body without contact forces.
pub(crate) fn free_acceleration(model: &Model, states: &[BodyState], loads: &Loads, body: usize) -> (DVec3, DVec3) {
    let (state, load) = (&states[body], loads.of(body));
    model.bodies[body].rigid.as_ref().map_or((DVec3::ZERO, DVec3::ZERO), |rigid| {
        let w = rigid.angular_velocity(state);
        let inverse = rigid.inverse_inertia_world(state.pose.rotation);
        let linear = model.free_acceleration(body) + load.force * rigid.inverse_mass();
        (linear, inverse * (load.torque - w.cross(state.angular_momentum)))
    })
}

/// Applies impulses (N s) along the normals of contacts to the momenta of their bodies (thesis, equations 10-13).
pub(crate) fn apply_impulses<'a>(
    model: &Model,
    states: &mut [BodyState],
    impulses: impl Iterator<Item = (ContactId, &'a ContactGeometry, f64)>,
) {
    for (id, geometry, impulse) in impulses {
        for (body, sign) in id.members() {
            let signed = impulse * sign;
            if let Some(rigid) = &model.bodies[body].rigid {
                let state = &mut states[body];
                let vector = geometry.normal * signed;
                state.linear_velocity += vector * rigid.inverse_mass();
                state.angular_momentum += (geometry.point - state.pose.translation).cross(vector);
            }
        }
    }
}

/// Appends the inverse mass of a movable body: `diag(1/m 1, I^-1)` in space, `diag(1/m, 1/m, n.I^-1 n)` in a plane.
fn push_inverse_mass(
    out: &mut Vec<f64>,
    coordinates: Coordinates,
    model: &Model,
    (states, body): (&[BodyState], usize),
) {
    let width = coordinates.width();
    let start = out.len();
    out.resize(start + width * width, 0.0);
    let Some(rigid) = &model.bodies[body].rigid else { return };
    let block = &mut out[start..];
    let inverse_inertia = rigid.inverse_inertia_world(states[body].pose.rotation);
    match coordinates {
        Coordinates::Space => {
            for i in 0..3 {
                block[i * width + i] = rigid.inverse_mass();
                for j in 0..3 {
                    block[(3 + i) * width + 3 + j] = inverse_inertia.col(j)[i];
                }
            }
        }
        Coordinates::Plane(plane) => {
            block[0] = rigid.inverse_mass();
            block[width + 1] = rigid.inverse_mass();
            block[2 * width + 2] = plane.normal().dot(inverse_inertia * plane.normal());
        }
    }
}

/// Largest change of any point of some bodies, bounded by their sizes, from their linear and angular ones (m, rad; /s).
pub(crate) fn largest_change(model: &Model, changes: impl Iterator<Item = (usize, DVec3, DVec3)>) -> f64 {
    let change =
        |(body, linear, angular): (usize, DVec3, DVec3)| linear.length() + angular.length() * model.bodies[body].size;
    changes.map(change).fold(0.0, f64::max)
}
