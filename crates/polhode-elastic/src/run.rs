//! Motion of an elastic body by central differences.
//!
//! With displacements u_n (m) at the instants `n dt` and velocities between them: `v_(n+1/2) = v_(n-1/2) + (dt f_n +
//! p_n) / m`, `u_(n+1) = u_n + dt v_(n+1/2)`, for every node; f (N) are the elastic forces, p (N s) the impulses of the
//! floor and of the guides. Order two, explicit, reversible; linear and angular momentum are changed by the impulses
//! alone, exactly.
//!
//! **Ledger.** The kinetic energy of an instant is `1/2 sum m v_(n-1/2) . v_(n+1/2)` without the impulses of that
//! instant: with it, kinetic and elastic energy together are exactly constant while the forces are linear, whatever the
//! step. What remains of a step is `U_(n+1) - U_n + 1/2 (f_n + f_(n+1)) . (u_(n+1) - u_n)`, the error of the
//! trapezoidal rule for the work of the elastic forces (numerical, of third order in the step), and the work of the
//! floor (lost in contacts). Energy at the start, less what contacts took, plus what is numerical, is the energy at any
//! time, to rounding. Source: docs/REFERENCES.md, Belytschko, Liu and Moran 2000; Hairer, Lubich and Wanner 2006.
//!
//! Fails: a step beyond the limit of stability is refused; an element that folds, and an energy that the steps change
//! by more than [`LARGEST_NUMERICAL_PART`], end the motion with an error.

use crate::body::{ElasticBody, Momentum};
use crate::error::{ElasticError, finite, positive};
use crate::floor::{Approach, Floor, NodeContact};
use crate::guide::Guide;
use glam::DVec2;
use polhode_spatial::CompensatedSum;

/// The largest part of the energy that the steps may have changed: beyond it the run does not tell what the body does.
pub const LARGEST_NUMERICAL_PART: f64 = 0.05;

/// By how much a step may be beyond the limit, relative: the limit is computed to 1e-12.
const LIMIT_ROUNDING: f64 = 1e-11;

/// How deep a node may be at the start, in units of the size of the mesh: rounding of its gap.
const GAP_ROUNDING: f64 = 1e-13;

/// Where the energy is, and where it went; J for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EnergyLedger {
    /// At the start.
    pub initial_j: f64,
    /// Kinetic, now.
    pub kinetic_j: f64,
    /// Elastic, now.
    pub elastic_j: f64,
    /// Lost in contacts.
    pub contact_loss_j: f64,
    /// What the time steps have added.
    pub numerical_j: f64,
}

impl EnergyLedger {
    /// What is left unexplained: rounding.
    pub fn residual_j(&self) -> f64 {
        self.kinetic_j + self.elastic_j - (self.initial_j - self.contact_loss_j + self.numerical_j)
    }
}

/// Momenta at the start and now, and what the floor and the guides have given; for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MomentumLedger {
    /// At the start.
    pub initial: Momentum,
    /// Now.
    pub now: Momentum,
    /// Given by the floor.
    pub floor: Momentum,
    /// Given by the guides.
    pub guides: Momentum,
}

impl MomentumLedger {
    /// What is left unexplained: rounding.
    pub fn residual(&self) -> Momentum {
        let given = |of: fn(&Momentum) -> f64| of(&self.initial) + of(&self.floor) + of(&self.guides);
        Momentum {
            linear: DVec2::new(self.now.linear.x - given(|m| m.linear.x), self.now.linear.y - given(|m| m.linear.y)),
            angular: self.now.angular - given(|m| m.angular),
        }
    }
}

/// Sums of impulses.
#[derive(Debug, Clone, Copy, Default)]
struct Given {
    sums: [CompensatedSum; 3],
}

impl Given {
    fn add(&mut self, momentum: Momentum) {
        let terms = [momentum.linear.x, momentum.linear.y, momentum.angular];
        for (sum, term) in self.sums.iter_mut().zip(terms) {
            sum.add(term);
        }
    }

    fn value(&self) -> Momentum {
        let [x, z, angular] = self.sums.map(|sum| sum.value());
        Momentum { linear: DVec2::new(x, z), angular }
    }
}

/// When the floor was first and last met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactTimes {
    /// The first impulse, s.
    pub first_s: f64,
    /// The last impulse, s.
    pub last_s: f64,
}

/// A body on its way.
#[derive(Debug, Clone)]
pub struct ElasticRun {
    body: ElasticBody,
    floor: Option<Floor>,
    step_s: f64,
    steps: usize,
    displacements: Vec<DVec2>,
    velocities: Vec<DVec2>,
    forces: Vec<DVec2>,
    elastic_j: f64,
    contacts: Vec<NodeContact>,
    contact_times: Option<ContactTimes>,
    initial_j: f64,
    initial: Momentum,
    contact_loss: CompensatedSum,
    numerical: CompensatedSum,
    from_floor: Given,
    from_guides: Given,
}

/// Displacements (m) and velocities (m/s) of the nodes at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeStates {
    /// From the places at rest, m.
    pub displacements: Vec<DVec2>,
    /// m/s.
    pub velocities: Vec<DVec2>,
}

impl NodeStates {
    /// A body at rest in shape that moves as a whole.
    pub fn moving(body: &ElasticBody, velocity: DVec2) -> Self {
        let nodes = body.masses().len();
        Self { displacements: vec![DVec2::ZERO; nodes], velocities: vec![velocity; nodes] }
    }
}

impl ElasticRun {
    /// Begins from states of the nodes, by steps of this length (s).
    ///
    /// # Errors
    /// A step that is not positive or beyond the limit, states that are not those of the nodes or not finite, nodes
    /// below the floor, a folded element.
    pub fn new(body: ElasticBody, floor: Option<Floor>, states: NodeStates, step_s: f64) -> Result<Self, ElasticError> {
        let limit_s = body.longest_step_s();
        positive("the time step", "s", step_s)?;
        if step_s > limit_s * (1.0 + LIMIT_ROUNDING) {
            return Err(ElasticError::StepBeyondLimit { step_s, limit_s });
        }
        let NodeStates { displacements, mut velocities } = states;
        body.check_length("displacements", displacements.len())?;
        body.check_length("velocities", velocities.len())?;
        for value in displacements.iter().flat_map(DVec2::to_array) {
            finite("a displacement", "m", value)?;
        }
        for value in velocities.iter().flat_map(DVec2::to_array) {
            finite("a velocity", "m/s", value)?;
        }
        if let Some(floor) = &floor {
            check_above(&body, floor, &displacements)?;
        }
        let found = body.forces(&displacements, 0.0)?;
        for ((velocity, force), mass) in velocities.iter_mut().zip(&found.forces).zip(body.masses()) {
            *velocity -= *force * (0.5 * step_s / mass);
            if body.guide() == Guide::Vertical {
                velocity.x = 0.0;
            }
        }
        let contacts = vec![NodeContact::default(); body.mesh().boundary().len()];
        let initial = body.momentum(&displacements, &velocities);
        let mut run = Self {
            body,
            floor,
            step_s,
            steps: 0,
            displacements,
            velocities,
            forces: found.forces,
            elastic_j: found.energy,
            contacts,
            contact_times: None,
            initial_j: 0.0,
            initial,
            contact_loss: CompensatedSum::ZERO,
            numerical: CompensatedSum::ZERO,
            from_floor: Given::default(),
            from_guides: Given::default(),
        };
        run.initial_j = run.kinetic_j() + run.elastic_j;
        Ok(run)
    }

    /// Advances by one step.
    ///
    /// # Errors
    /// An element that folds, errors of the steps that are no longer small.
    pub fn step(&mut self) -> Result<(), ElasticError> {
        let before = self.velocities.clone();
        for ((velocity, force), mass) in self.velocities.iter_mut().zip(&self.forces).zip(self.body.masses()) {
            *velocity += *force * (self.step_s / mass);
        }
        self.hold_guides();
        self.meet_floor(&before);
        for (u, velocity) in self.displacements.iter_mut().zip(&self.velocities) {
            *u += *velocity * self.step_s;
        }
        self.steps += 1;
        let found = self.body.forces(&self.displacements, self.time_s())?;
        let works = self.velocities.iter().zip(&self.forces).zip(&found.forces);
        let work: CompensatedSum = works.map(|((v, f), next)| 0.5 * self.step_s * v.dot(*f + *next)).collect();
        self.numerical.add(found.energy);
        self.numerical.add(-self.elastic_j);
        self.numerical.add(work.value());
        self.forces = found.forces;
        self.elastic_j = found.energy;
        let (numerical_j, limit_j) = (self.numerical.value(), LARGEST_NUMERICAL_PART * self.initial_j);
        if numerical_j.abs() <= limit_j {
            Ok(())
        } else {
            Err(ElasticError::Diverged { t_s: self.time_s(), numerical_j, limit_j })
        }
    }

    /// Guides take the velocity across them.
    fn hold_guides(&mut self) {
        if self.body.guide() == Guide::Free {
            return;
        }
        let nodes = self.body.mesh().nodes().iter().zip(&self.displacements).zip(self.body.masses());
        for (((place, u), mass), velocity) in nodes.zip(&mut self.velocities) {
            self.from_guides.add(Momentum::of(DVec2::new(-mass * velocity.x, 0.0), *place + *u));
            velocity.x = 0.0;
        }
    }

    /// Impulses of the floor on the nodes of the outline.
    fn meet_floor(&mut self, before: &[DVec2]) {
        let Some(floor) = self.floor else { return };
        let t_s = self.time_s();
        for (contact, &node) in self.contacts.iter_mut().zip(self.body.mesh().boundary()) {
            let place = self.body.mesh().nodes()[node] + self.displacements[node];
            let mass = self.body.masses()[node];
            // In this order the gap of a node that begins on the floor is exactly zero.
            let gap = floor.gap(self.body.mesh().nodes()[node]) + floor.normal.dot(self.displacements[node]);
            let rate = |velocity: DVec2| floor.normal.dot(velocity);
            let approach = Approach { mass, gap, before: rate(before[node]), free: rate(self.velocities[node]) };
            let impulse = contact.impulse(approach, self.step_s);
            if impulse > 0.0 {
                self.velocities[node] += floor.normal * (impulse / mass);
                let after = rate(self.velocities[node]);
                self.contact_loss.add(-0.5 * impulse * (approach.before + after));
                self.from_floor.add(Momentum::of(floor.normal * impulse, place));
                let first_s = self.contact_times.map_or(t_s, |times| times.first_s);
                self.contact_times = Some(ContactTimes { first_s, last_s: t_s });
            }
        }
    }

    fn kinetic_j(&self) -> f64 {
        let nodes = self.velocities.iter().zip(&self.forces).zip(self.body.masses());
        let guided = |force: DVec2| if self.body.guide() == Guide::Free { force } else { DVec2::new(0.0, force.y) };
        let twice: CompensatedSum = nodes.map(|((v, f), mass)| v.dot(*v * *mass + guided(*f) * self.step_s)).collect();
        0.5 * twice.value()
    }

    /// The body.
    pub const fn body(&self) -> &ElasticBody {
        &self.body
    }

    /// The floor.
    pub const fn floor(&self) -> Option<&Floor> {
        self.floor.as_ref()
    }

    /// Length of a step, s.
    pub const fn step_s(&self) -> f64 {
        self.step_s
    }

    /// Steps so far.
    pub const fn steps(&self) -> usize {
        self.steps
    }

    /// Time since the start, s.
    pub fn time_s(&self) -> f64 {
        self.steps as f64 * self.step_s
    }

    /// Displacements of the nodes from their places at rest, now, m.
    pub fn displacements(&self) -> &[DVec2] {
        &self.displacements
    }

    /// Velocities of the nodes half a step ago, m/s.
    pub fn velocities(&self) -> &[DVec2] {
        &self.velocities
    }

    /// Elastic forces on the nodes, now, N for each metre of depth.
    pub fn forces(&self) -> &[DVec2] {
        &self.forces
    }

    /// When the floor was first and last met; nothing while it has not been.
    pub const fn contact_times(&self) -> Option<ContactTimes> {
        self.contact_times
    }

    /// Elastic energy, now, J for each metre of depth.
    pub const fn elastic_j(&self) -> f64 {
        self.elastic_j
    }

    /// Where the energy is, and where it went.
    pub fn energy(&self) -> EnergyLedger {
        EnergyLedger {
            initial_j: self.initial_j,
            kinetic_j: self.kinetic_j(),
            elastic_j: self.elastic_j,
            contact_loss_j: self.contact_loss.value(),
            numerical_j: self.numerical.value(),
        }
    }

    /// Momenta, and what gave them.
    pub fn momentum(&self) -> MomentumLedger {
        MomentumLedger {
            initial: self.initial,
            now: self.body.momentum(&self.displacements, &self.velocities),
            floor: self.from_floor.value(),
            guides: self.from_guides.value(),
        }
    }
}

/// Whether no node begins below the floor.
fn check_above(body: &ElasticBody, floor: &Floor, displacements: &[DVec2]) -> Result<(), ElasticError> {
    let nodes = body.mesh().nodes();
    let size = nodes.iter().fold(0.0, |size: f64, place| size.max(place.length()));
    for &node in body.mesh().boundary() {
        let gap = floor.gap(nodes[node] + displacements[node]);
        if gap.is_nan() || gap < -GAP_ROUNDING * size {
            return Err(ElasticError::BelowFloor { node, depth_m: -gap });
        }
    }
    Ok(())
}
