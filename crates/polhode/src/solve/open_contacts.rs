//! Contacts whose forces statics leaves open: four legs on a floor.
//!
//! Forces of contacts and joints do nothing together if they are in the null space of `J^T`, where `J` has the rows of
//! all contacts that bear something and of the joints between their bodies ([`Supports`]). A force is open if one of
//! those has a part there: a little of it may then be added, as the forces that bear are positive. A contact that
//! sticks has rows along its tangents; one that slides has none, since its friction follows from its normal force.
//!
//! Assumptions: forces within their cones; friction of rolling and spinning is left out. A force that was not found
//! counts as open.

use crate::collision::{contact_kinematics, friction};
use crate::constraint::row::{BilateralRow, Member, Part, RowKind, push_in_space};
use crate::identity::contact_id::{ContactId, Feature};
use crate::joints::held;
use crate::model::{Model, tolerances};
use crate::report::contact_sample::ContactSample;
use crate::report::frame::ContactView;
use crate::rows::groups::groups;
use polhode_dynamics::BodyState;
use polhode_response::solve::held::Supports;
use polhode_response::{ContactProblem, ResponseError};
use polhode_spatial::DVec3;
use std::ops::Range;

/// Numbers of a velocity.
const WIDTH: usize = 6;

/// What is open of a contact: along its normal, and of its friction.
#[derive(Debug, Clone, Copy, Default)]
struct Open {
    normal: bool,
    friction: bool,
}

impl Open {
    const UNKNOWN: Self = Self { normal: true, friction: true };
}

/// Contacts with what of their forces is not unique.
pub(crate) fn contact_samples(model: &Model, states: &[BodyState], contacts: &[ContactView]) -> Vec<ContactSample> {
    let mut open = vec![Open::default(); contacts.len()];
    let bears = |view: &ContactView| view.normal_force_n > 0.0;
    let pair = |view: &ContactView| (view.body_a.index(), view.body_b.index());
    let bearing = contacts.iter().enumerate().filter(|(_, view)| bears(view));
    for group in groups(model, bearing.map(|(index, view)| (index, pair(view).0, pair(view).1))) {
        let views: Vec<&ContactView> = group.contacts.iter().map(|&index| &contacts[index]).collect();
        let found = of_group(model, states, &group.bodies, &views);
        let found = found.unwrap_or_else(|_| vec![Open::UNKNOWN; views.len()]);
        group.contacts.iter().zip(found).for_each(|(&index, own)| open[index] = own);
    }
    let sample = |(view, own): (&ContactView, Open)| {
        let own = if view.normal_force_n.is_nan() { Open::UNKNOWN } else { own };
        ContactSample { view: *view, is_normal_open: own.normal, is_friction_open: own.friction }
    };
    contacts.iter().zip(open).map(sample).collect()
}

/// What friction may do at a contact.
enum Rubbing {
    /// It has none.
    None,
    /// It follows from the normal force.
    Slides,
    /// It bears along two tangents.
    Sticks,
}

fn rubbing(model: &Model, states: &[BodyState], view: &ContactView) -> Rubbing {
    let (a, b) = (view.body_a.index(), view.body_b.index());
    let id = ContactId { a, b, feature: Feature::Shapes(view.feature) };
    if friction::friction_of(model, id).is_none() {
        return Rubbing::None;
    }
    let slip = contact_kinematics::tangential_kinematics(model, states, id);
    let speed = slip.map_or(0.0, |terms| terms.slip_velocity.length());
    if speed > tolerances::velocity_rounding(model, states, &[a, b]) { Rubbing::Slides } else { Rubbing::Sticks }
}

/// What is open of the contacts of bodies that hold each other.
fn of_group(
    model: &Model,
    states: &[BodyState],
    bodies: &[usize],
    views: &[&ContactView],
) -> Result<Vec<Open>, ResponseError> {
    let place = |body: usize| bodies.binary_search(&body).ok();
    let inverse_mass = |&body: &usize| {
        let rigid = model.bodies[body].rigid.as_ref();
        rigid.map_or([0.0; WIDTH * WIDTH], |rigid| rigid.inverse_mass_block(states[body].pose.rotation))
    };
    let mut problem = ContactProblem::new(WIDTH, bodies.iter().flat_map(inverse_mass).collect())?;
    let along = |view: &ContactView, direction: DVec3| {
        let member = |body: usize, sign: f64| {
            let arm = view.point_m - states[body].pose.translation;
            Member { body, arm, sign, part: Part::First }
        };
        let members = [member(view.body_a.index(), 1.0), member(view.body_b.index(), -1.0)];
        (members, [BilateralRow { kind: RowKind::Along(direction), gap: 0.0, rate: 0.0, bias: 0.0 }])
    };
    let mut rows: Vec<(usize, Range<usize>)> = Vec::with_capacity(views.len());
    let friction: Vec<Rubbing> = views.iter().map(|view| rubbing(model, states, view)).collect();
    for (view, friction) in views.iter().zip(&friction) {
        let first = problem.len();
        let (members, row) = along(view, view.normal);
        push_in_space(&mut problem, place, (&members, &row))?;
        if matches!(friction, Rubbing::Sticks) {
            let (one, other) = view.normal.any_orthonormal_pair();
            for tangent in [one, other] {
                let (members, row) = along(view, tangent);
                push_in_space(&mut problem, place, (&members, &row))?;
            }
        }
        rows.push((first, first + 1..problem.len()));
    }
    for bilateral in held::bilaterals(model, states, bodies) {
        push_in_space(&mut problem, place, (&bilateral.members, &bilateral.rows))?;
    }
    let count = problem.len();
    let supports = Supports::of(&problem, 0..count);
    let is_open = |row: usize| {
        let mut unit = vec![0.0; count];
        unit[row] = 1.0;
        supports.leave_open(unit)
    };
    let open = |((normal, tangents), friction): ((usize, Range<usize>), Rubbing)| {
        let normal = is_open(normal)?;
        let mut open = Open { normal, friction: normal && matches!(friction, Rubbing::Slides) };
        for tangent in tangents {
            open.friction |= is_open(tangent)?;
        }
        Ok(open)
    };
    rows.into_iter().zip(friction).map(open).collect()
}
