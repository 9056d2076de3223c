//! The change of velocities by force fields over a step that may be longer than the time in which they act.
//!
//! In the middle of the step, after half of the flight, let `F` be the force of a field there, `K` and `D` its
//! responses to displacement and velocity (`polhode_dynamics::field::response`), and `dv` the change of the velocities
//! by the kick. With the gravity `g` of the flight the whole change over the step is `dv + g h`, so that the force acts
//! at positions `a h (dv + g h/2)` further on and at velocities that lie at the part `s` of that change:
//!
//! `(M + h a h K + h s D) dv = h (F - a h K (g h/2) - (s - 1/2) D g h)`
//!
//! | | part | reason |
//! |---|---|---|
//! | a | `1/4 - 1/(4 x)`, zero for `x <= 1`; x bounds `h^2 K/M` | with `a = 1/4` the implicit midpoint rule |
//! | s | `1/(1 - e^-z) - 1/z`, z = `h D/M` | the decay under linear drag is exact: `e^-z`, to the speed of a fall |
//! | s, quadratic drag | 1/2 | the decay without other forces is exact, `1/(1 + h c v/m)` |
//!
//! The implicit midpoint rule is stable at any length and conserves the energy of a linear spring. A spring that the
//! step resolves is left to the explicit kick, which gives bodies at rest the whole of its force.
//! Constraints change the velocities by `c` in the same step; where `c` is known from a first solution (`step.rs`), the
//! whole change is `dv + c + g h`, and the right-hand side has `-(h a h K + h s D) c` besides.
//!
//! Both parts leave the step of second order. The matrix is symmetric and positive definite; conjugate gradients with M
//! as preconditioner solve for `dv` in as many rounds as there are independent stiff directions, or nearly.
//!
//! A spring that pulls outwards at an arm turns the body back; that stiffness is implicit in the same way, as a bound.
//!
//! Assumes that the direction of a spring does not turn by much in a step; where it does, energy may change, and the
//! ledger shows it. The impulses of contacts come after the kick, and `c` is that of one solution before: a body that a
//! stiff spring presses against another one bears the spring's force less the part `(x/(1 + x))^2`, `x = a h^2 K/M`.

use crate::model::rates;
use crate::model::states_of::set_states;
use crate::model::{Model, largest_eigenvalue as largest};
use polhode_dynamics::BodyState;
use polhode_dynamics::field::{Account, Decay, ForceResponse, ResponseEnd};
use polhode_spatial::{DMat3, DVec3};

/// Rounds of conjugate gradients for each body of the kick, beside as many for the first: more than there are stiff
/// directions of a body with a few springs.
const ROUNDS_PER_BODY: usize = 12;

/// The residual at which the solution ends, relative to the right-hand side: some rounding units.
const RESIDUAL_RELATIVE: f64 = 1e-15;

/// Below this value of z the exact part s is replaced by its series `1/2 + z/12`, whose error is `z^3/720`.
const SMALL_DECAY: f64 = 1e-3;

/// Linear and angular part of a generalised velocity, force or impulse of one body.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Twist {
    pub(super) linear: DVec3,
    pub(super) angular: DVec3,
}

impl Twist {
    fn dot(&self, other: &Self) -> f64 {
        self.linear.dot(other.linear) + self.angular.dot(other.angular)
    }

    fn plus(&self, other: &Self, factor: f64) -> Self {
        Self { linear: self.linear + other.linear * factor, angular: self.angular + other.angular * factor }
    }
}

/// The response of a field in a step, with its implicit parts.
#[derive(Debug, Clone, Copy)]
struct Element {
    account: Account,
    response: ForceResponse,
    /// Its bodies, as places in the list of the kick.
    places: [Option<usize>; 2],
    /// `h a h K + h s D`, kg.
    matrix: DMat3,
    /// `h s D` of rotation of the first body, kg m^2.
    rotational: DMat3,
    /// `h a h K` of rotation of both bodies, kg m^2.
    turning: [f64; 2],
    /// The part of the impulse that the gravity of the flight changes, N s, on the first end.
    given: DVec3,
}

/// The impulses by which the kick differs from that of constant forces: on the body, about the origin of its frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Difference {
    pub(super) account: Account,
    pub(super) body: usize,
    pub(super) impulse: Twist,
}

/// The implicit kick of some bodies.
#[derive(Debug)]
pub(super) struct ImplicitKick<'a> {
    model: &'a Model,
    states: &'a [BodyState],
    bodies: &'a [usize],
    elements: Vec<Element>,
}

impl<'a> ImplicitKick<'a> {
    /// That of a step of `h` (s) from the responses of fields; nothing when the explicit kick is as good, because no
    /// field is stiff in the step or damps.
    pub(super) fn new(
        model: &'a Model,
        states: &'a [BodyState],
        bodies: &'a [usize],
        responses: Vec<(Account, ForceResponse)>,
        h: f64,
    ) -> Option<Self> {
        let mut kick = Self { model, states, bodies, elements: Vec::with_capacity(responses.len()) };
        let stiffness = kick.stiffness_of_bodies(&responses, h);
        for (account, response) in responses {
            let element = kick.element(account, &response, &stiffness, h);
            if element.matrix != DMat3::ZERO || element.rotational != DMat3::ZERO || element.turning != [0.0; 2] {
                kick.elements.push(element);
            }
        }
        (!kick.elements.is_empty()).then_some(kick)
    }

    /// Place of a body in the list.
    fn place(&self, end: &ResponseEnd) -> Option<usize> {
        self.bodies.binary_search(&end.body).ok()
    }

    /// For each body the sum of `h^2 K/M` over its springs.
    fn stiffness_of_bodies(&self, responses: &[(Account, ForceResponse)], h: f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.bodies.len()];
        for (_, response) in responses {
            for (end, turning) in response.ends.iter().zip(response.rotational_stiffness) {
                let Some(end) = end else { continue };
                let rigid = self.model.bodies[end.body].rigid.as_ref();
                if let (Some(place), Some(rigid)) = (self.place(end), rigid) {
                    let stiffness = largest(&response.stiffness) * rates::lightness(self.model, end);
                    sums[place] += h * h * (stiffness + turning / rigid.moments().min_element());
                }
            }
        }
        sums
    }

    fn element(&self, account: Account, response: &ForceResponse, stiffness: &[f64], h: f64) -> Element {
        let places = response.ends.map(|end| end.and_then(|end| self.place(&end)));
        let x: f64 = places.iter().flatten().map(|&place| stiffness[place]).sum();
        let along = if x > 1.0 { 0.25 - 0.25 / x } else { 0.0 };
        let lightness: f64 =
            response.ends.iter().flatten().map(|end| self.lightness_along(end, &response.damping)).sum();
        let part = part_of_change(response.decay, h * largest(&response.damping) * lightness);
        let gravity = |end: &ResponseEnd| self.model.free_acceleration(end.body);
        let [a, b] = response.ends.map(|end| end.as_ref().map_or(DVec3::ZERO, gravity));
        let pull = (a - b) * h;
        Element {
            account,
            response: *response,
            places,
            matrix: response.stiffness * (h * along * h) + response.damping * (h * part),
            rotational: self.rotational(response, h),
            turning: response.rotational_stiffness.map(|stiffness| stiffness * (h * along * h)),
            given: response.stiffness * pull * (-0.5 * h * along * h) - response.damping * pull * (h * (part - 0.5)),
        }
    }

    /// The inverse mass that damping of a point meets, 1/kg: of a single direction exactly.
    fn lightness_along(&self, end: &ResponseEnd, damping: &DMat3) -> f64 {
        let Some(rigid) = &self.model.bodies[end.body].rigid else { return 0.0 };
        if end.arm == DVec3::ZERO {
            return rigid.inverse_mass();
        }
        let direction = longest_column(damping).normalize_or_zero();
        let lever = end.arm.cross(direction);
        let turned = rigid.inverse_inertia_world(self.states[end.body].pose.rotation) * lever;
        rigid.inverse_mass() + lever.dot(turned)
    }

    /// `h s D` of rotation: under linear drag with the exact part about each principal axis.
    fn rotational(&self, response: &ForceResponse, h: f64) -> DMat3 {
        let damping = response.rotational_damping;
        let body = response.ends[0].and_then(|end| Some((end.body, self.model.bodies[end.body].rigid.as_ref()?)));
        let Some((body, rigid)) = body.filter(|_| damping != DMat3::ZERO) else { return DMat3::ZERO };
        if response.decay == Decay::Hyperbolic {
            return damping * (0.5 * h);
        }
        let largest = largest(&damping);
        let parts = rigid
            .moments()
            .to_array()
            .map(|moment| h * largest * part_of_change(Decay::Exponential, h * largest / moment));
        let axes = (self.states[body].pose.rotation * rigid.axes()).to_matrix();
        axes * DMat3::from_diagonal(DVec3::from_array(parts)) * axes.transpose()
    }

    /// Adds `factor` times the implicit impulses against these changes of velocity.
    fn add_resisting(&self, changes: &[Twist], out: &mut [Twist], factor: f64) {
        for element in &self.elements {
            let impulse = element.matrix * Self::relative(element, changes) * factor;
            Self::push(element, impulse, out);
            if let Some(place) = element.places[0] {
                out[place].angular += element.rotational * changes[place].angular * factor;
            }
            for (place, turning) in element.places.iter().zip(element.turning) {
                if let Some(place) = *place {
                    out[place].angular += changes[place].angular * (turning * factor);
                }
            }
        }
    }

    /// The relative velocity of both ends of an element.
    fn relative(element: &Element, velocities: &[Twist]) -> DVec3 {
        let at = |index: usize| {
            let (Some(place), Some(end)) = (element.places[index], element.response.ends[index]) else {
                return DVec3::ZERO;
            };
            velocities[place].linear + velocities[place].angular.cross(end.arm)
        };
        at(0) - at(1)
    }

    /// Adds an impulse at the first end of an element, and its opposite at the second.
    fn push(element: &Element, impulse: DVec3, out: &mut [Twist]) {
        for (index, impulse) in [(0, impulse), (1, -impulse)] {
            if let (Some(place), Some(end)) = (element.places[index], element.response.ends[index]) {
                out[place].linear += impulse;
                out[place].angular += end.arm.cross(impulse);
            }
        }
    }

    /// `M` times these changes of velocity.
    fn momenta(&self, changes: &[Twist]) -> Vec<Twist> {
        self.each(changes, |rigid, state, change| Twist {
            linear: change.linear * if rigid.is_pivoted() { 0.0 } else { rigid.mass() },
            angular: rigid.angular_momentum_at(state.pose.rotation, change.angular),
        })
    }

    /// `M^-1` times these impulses.
    fn velocities(&self, impulses: &[Twist]) -> Vec<Twist> {
        self.each(impulses, |rigid, state, impulse| Twist {
            linear: impulse.linear * rigid.inverse_mass(),
            angular: rigid.angular_velocity_at(state.pose.rotation, impulse.angular),
        })
    }

    fn each(
        &self,
        values: &[Twist],
        of: impl Fn(&polhode_dynamics::RigidBody, &BodyState, &Twist) -> Twist,
    ) -> Vec<Twist> {
        let of = |(&body, value): (&usize, &Twist)| {
            let rigid = self.model.bodies[body].rigid.as_ref();
            rigid.map_or_else(Twist::default, |rigid| of(rigid, &self.states[body], value))
        };
        self.bodies.iter().zip(values).map(of).collect()
    }

    /// The changes of velocity by the impulses `h F` of the fields (about the origins of the frames), beside those that
    /// constraints are known to make.
    pub(super) fn solve(&self, forces: &[Twist], by_constraints: &[Twist]) -> Vec<Twist> {
        let mut residual = forces.to_vec();
        for element in &self.elements {
            Self::push(element, element.given, &mut residual);
        }
        if !by_constraints.is_empty() {
            self.add_resisting(by_constraints, &mut residual, -1.0);
        }
        let mut changes = vec![Twist::default(); self.bodies.len()];
        let mut preconditioned = self.velocities(&residual);
        let mut direction = preconditioned.clone();
        let mut size = product(&residual, &preconditioned);
        let smallest = RESIDUAL_RELATIVE * RESIDUAL_RELATIVE * size;
        for _ in 0..ROUNDS_PER_BODY * (self.bodies.len() + 1) {
            // NaN ends the rounds; the check of states finds it.
            if size.is_nan() || size <= smallest {
                break;
            }
            let mut image = self.momenta(&direction);
            self.add_resisting(&direction, &mut image, 1.0);
            let step = size / product(&direction, &image);
            add(&mut changes, &direction, step);
            add(&mut residual, &image, -step);
            preconditioned = self.velocities(&residual);
            let next = product(&residual, &preconditioned);
            let mut turned = preconditioned.clone();
            add(&mut turned, &direction, next / size);
            (direction, size) = (turned, next);
        }
        changes
    }

    /// The impulses of the fields besides `h F`, with these changes of velocity, by the kick and by constraints.
    pub(super) fn differences(&self, kicked: &[Twist], by_constraints: &[Twist]) -> Vec<Difference> {
        let mut changes = kicked.to_vec();
        add(&mut changes, by_constraints, 1.0);
        let changes = &changes[..];
        let mut found = Vec::with_capacity(2 * self.elements.len());
        for element in &self.elements {
            let impulse = element.given - element.matrix * Self::relative(element, changes);
            for (index, impulse) in [(0, impulse), (1, -impulse)] {
                let (Some(place), Some(end)) = (element.places[index], element.response.ends[index]) else { continue };
                let mut angular = end.arm.cross(impulse) - changes[place].angular * element.turning[index];
                if index == 0 {
                    angular -= element.rotational * changes[place].angular;
                }
                let impulse = Twist { linear: impulse, angular };
                found.push(Difference { account: element.account, body: self.bodies[place], impulse });
            }
        }
        found
    }
}

/// Adds these changes of velocity to the states of the bodies.
pub(super) fn change_velocities(model: &Model, states: &mut [BodyState], bodies: &[usize], changes: &[Twist]) {
    let changed: Vec<BodyState> = bodies
        .iter()
        .zip(changes)
        .map(|(&body, change)| {
            let mut state = states[body];
            if let Some(rigid) = &model.bodies[body].rigid {
                state.linear_velocity += change.linear;
                state.angular_momentum += rigid.angular_momentum_at(state.pose.rotation, change.angular);
            }
            state
        })
        .collect();
    set_states(states, bodies, &changed);
}

/// `s`: where in the change of a step the velocity lies that gives the mean force, for `z = h D/M`.
fn part_of_change(decay: Decay, z: f64) -> f64 {
    match decay {
        Decay::Hyperbolic => 0.5,
        Decay::Exponential if z < SMALL_DECAY => 0.5 + z / 12.0 - z * z * z / 720.0,
        Decay::Exponential => -1.0 / libm::expm1(-z) - 1.0 / z,
    }
}

/// The longest column: along the one direction of a matrix of rank one.
fn longest_column(matrix: &DMat3) -> DVec3 {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis];
    columns.into_iter().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared())).unwrap_or(DVec3::ZERO)
}

fn product(a: &[Twist], b: &[Twist]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

fn add(sum: &mut [Twist], more: &[Twist], factor: f64) {
    for (sum, more) in sum.iter_mut().zip(more) {
        *sum = sum.plus(more, factor);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The part of the change at which the mean force acts, from slow decay (a half) to fast decay (the end), without
    /// a jump where the series takes over.
    #[test]
    fn the_part_goes_from_the_middle_to_the_end() {
        let part = |z| part_of_change(Decay::Exponential, z);
        assert_eq!(part(0.0), 0.5);
        assert!((part(SMALL_DECAY) - part(SMALL_DECAY * (1.0 - 1e-9))).abs() < 1e-12);
        assert!((part(1e6) - 1.0).abs() < 2e-6);
        // Exactly: the velocity after the step is e^-z of that before.
        for z in [0.01, 1.0, 30.0] {
            let change = -z / (1.0 + z * part(z));
            assert!((1.0 + change - libm::exp(-z)).abs() < 1e-13, "{z}");
        }
    }
}
