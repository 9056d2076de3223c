//! Impacts of a step as events: one for each point that approached faster than gravity makes it in two steps, and got
//! an impulse.
//!
//! The impulse is that of the whole step; its event is at the end of the step, since the step tells no time within. The
//! change of energy is `p . (u- + u+) / 2` (J), with the impulse `p` (N s, friction included) and the relative
//! velocities `u` of the point (m/s) at the start and the end of the step: exact for a point that is struck alone, but
//! for what gravity does in the step; of several that are struck together it is their share to first order. Source:
//! algebra of kinetic energy, as in `polhode_response::sequential_impulses`.

use super::course::Course;
use super::rules::Rules;
use crate::identity::body_id::BodyId;
use crate::model::Model;
use crate::report::event::{Event, EventKind};
use polhode_dynamics::BodyState;

/// The impacts of the last step, which began with these states and ended at `t_s`, in the order of its contacts.
pub(super) fn impacts(course: &Course, model: &Model, before: &[BodyState], (t_s, rules): (f64, &Rules)) -> Vec<Event> {
    let mut events = Vec::new();
    // Where no impulse of a collision has done work, none has collided.
    for group in course.groups().iter().filter(|group| group.report.works.colliding_j != 0.0) {
        for (number, (place, manifold)) in group.patches.iter().zip(group.solver.manifolds()).enumerate() {
            let pair = &course.pairs[place.pair];
            let patch = &pair.patches[place.patch];
            for (point, impulse) in patch.points().iter().zip(group.solver.impulses(number)) {
                let [along, first, second] = impulse.total;
                if !(impulse.rate < -rules.soft.colliding && along > 0.0) {
                    continue;
                }
                let (normal, tangent) = (manifold.normal, manifold.tangent);
                let whole = normal * along + tangent * first + normal.cross(tangent) * second;
                let geometry = pair.geometry(before, patch, point);
                let towards_b = 0.5 - pair.acting_part(model, geometry.separation);
                let place = geometry.point + geometry.normal * (geometry.separation * towards_b);
                let velocity = |states: &[BodyState]| {
                    let [a, b] = [pair.a, pair.b].map(|body| {
                        let own = model.velocity(body, &states[body]);
                        own.linear + own.angular.cross(place - before[body].pose.translation)
                    });
                    a - b
                };
                let energy_change_j = 0.5 * whole.dot(velocity(before) + velocity(&course.states));
                let event = Event::new(t_s, EventKind::Impact, BodyId::new(pair.a));
                events.push(Event {
                    body_b: Some(BodyId::new(pair.b)),
                    point: place,
                    normal,
                    impulse: along,
                    energy_change_j,
                    ..event
                });
            }
        }
    }
    events
}
