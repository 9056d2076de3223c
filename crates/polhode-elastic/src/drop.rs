//! A rectangle that drops onto the floor and leaves it again: what a rigid body would be told by a coefficient.
//!
//! The rectangle touches the floor at the start, with one side or, tilted, with one corner, and moves against it with
//! the speed v (m/s). There is no gravity: a contact is short, and what gravity adds in it is of the order of g t / v.
//! The motion ends when the rectangle has been off the floor for longer than its slowest vibration could bring it back:
//! `(2 (W + H) + L^2 / B) / c_s` with L the longer and B the shorter side (two passes of shear waves, and a period of
//! bending, which is 0.97 of `L^2 / (B c)` with c the speed of waves in bars).
//!
//! The velocity of the rebound is momentum over mass, and the angular velocity is angular momentum over the moment of
//! inertia at rest, so that both are constant while the rectangle vibrates. Quantities are for each metre of depth.
//! Fails: a tilt whose second corner follows within that time gives both impacts as one; a body that stays on the
//! floor is an error after [`LONGEST_STAY`] times that time.

use crate::body::{ElasticBody, moment};
use crate::error::{ElasticError, finite, positive};
use crate::floor::Floor;
use crate::guide::Guide;
use crate::material::ElasticMaterial;
use crate::mesh::{Cells, QuadMesh};
use crate::run::{ElasticRun, EnergyLedger, NodeStates};
use crate::stability::STABILITY_FACTOR;
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// How long a rectangle may stay on the floor, in units of the time after which it has left it for good.
pub const LONGEST_STAY: f64 = 50.0;

/// The longer side over the shorter one at the most: the time of bending goes with its square.
pub const MOST_SLENDER: f64 = 50.0;

/// A rectangle and how it meets the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RectangleDrop {
    width: f64,
    height: f64,
    material: ElasticMaterial,
    speed: f64,
    tilt_rad: f64,
    guide: Guide,
    step_s: Option<f64>,
}

/// Where the energy of a drop is when it is over, J for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReboundEnergy {
    /// Kinetic, before.
    pub before_j: f64,
    /// Of the motion of the centre of mass.
    pub translation_j: f64,
    /// Of rotation.
    pub rotation_j: f64,
    /// Of vibration, kinetic and elastic.
    pub vibration_j: f64,
    /// Lost in contacts.
    pub contact_loss_j: f64,
    /// What the time steps have added.
    pub numerical_j: f64,
    /// What the ledger leaves unexplained.
    pub residual_j: f64,
}

/// What came of a drop, in the axes of the world: x along the floor, z up; for each metre of depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DropReport {
    /// Elements.
    pub cells: Cells,
    /// Time step, s.
    pub step_s: f64,
    /// The longest stable step, s.
    pub longest_step_s: f64,
    /// Steps until the body had left the floor for good.
    pub steps: usize,
    /// The step with the most elastic energy.
    pub deepest_step: usize,
    /// Mass, kg.
    pub mass_kg: f64,
    /// From the first to the last impulse of the floor, s.
    pub contact_time_s: f64,
    /// Vertical impulse of the floor, N s.
    pub impulse_n_s: f64,
    /// Velocity of the centre of mass, m/s.
    pub velocity: DVec2,
    /// Angular velocity about the axis y (z towards x), rad/s.
    pub angular_velocity: f64,
    /// Velocity of the centre of mass up over that down before.
    pub restitution: f64,
    /// The same of the corner that met the floor, moved as part of a rigid body.
    pub corner_restitution: f64,
    /// Square root of the part of the energy that is motion as a rigid body.
    pub energy_restitution: f64,
    /// Where the energy is.
    pub energy: ReboundEnergy,
    /// What the ledger of momentum leaves unexplained: linear (kg m/s), as a part of the momentum before.
    pub momentum_residual: f64,
}

impl RectangleDrop {
    /// A rectangle of width times height (m) that drops flat at this speed (m/s).
    ///
    /// # Errors
    /// A size or speed that is not positive and finite, a rectangle that is too slender.
    pub fn new(width: f64, height: f64, material: ElasticMaterial, speed: f64) -> Result<Self, ElasticError> {
        positive("the width", "m", width)?;
        positive("the height", "m", height)?;
        positive("the speed", "m/s", speed)?;
        let ratio = (width / height).max(height / width);
        if ratio > MOST_SLENDER {
            return Err(ElasticError::Slender { ratio, most: MOST_SLENDER });
        }
        Ok(Self { width, height, material, speed, tilt_rad: 0.0, guide: Guide::Free, step_s: None })
    }

    /// Turned by this angle (rad) about the axis y, z towards x: the right corner is the lower one.
    ///
    /// # Errors
    /// A tilt beyond a right angle, and any of a confined rectangle.
    pub fn tilted(mut self, tilt_rad: f64) -> Result<Self, ElasticError> {
        finite("the tilt", "rad", tilt_rad)?;
        if tilt_rad.abs() > FRAC_PI_2 {
            return Err(ElasticError::Tilt { tilt_rad, least: -FRAC_PI_2, most: FRAC_PI_2 });
        }
        self.tilt_rad = tilt_rad;
        self.checked()
    }

    /// With its sides on rollers.
    ///
    /// # Errors
    /// A tilt.
    pub fn confined(mut self) -> Result<Self, ElasticError> {
        self.guide = Guide::Vertical;
        self.checked()
    }

    /// With this time step (s) instead of the one that stability gives.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn step_s(mut self, step_s: f64) -> Result<Self, ElasticError> {
        self.step_s = Some(positive("the time step", "s", step_s)?);
        Ok(self)
    }

    fn checked(self) -> Result<Self, ElasticError> {
        if self.guide == Guide::Vertical && self.tilt_rad != 0.0 {
            return Err(ElasticError::TiltedAndConfined { tilt_rad: self.tilt_rad });
        }
        Ok(self)
    }

    /// Width, m.
    pub const fn width(&self) -> f64 {
        self.width
    }

    /// Height, m.
    pub const fn height(&self) -> f64 {
        self.height
    }

    /// The material.
    pub const fn material(&self) -> &ElasticMaterial {
        &self.material
    }

    /// Speed against the floor, m/s.
    pub const fn speed(&self) -> f64 {
        self.speed
    }

    /// Tilt, rad.
    pub const fn tilt_rad(&self) -> f64 {
        self.tilt_rad
    }

    /// How its nodes may move.
    pub const fn guide(&self) -> Guide {
        self.guide
    }

    /// About so many elements that are nearly squares.
    pub fn cells(&self, elements: usize) -> Cells {
        Cells::near(self.width, self.height, elements)
    }

    /// Whether it has a time step of its own.
    pub(crate) const fn has_step(&self) -> bool {
        self.step_s.is_some()
    }

    /// The axes of the world in those of the mesh: x along the floor, then up.
    pub fn world_axes(&self) -> [DVec2; 2] {
        let (sin, cos) = (libm::sin(self.tilt_rad), libm::cos(self.tilt_rad));
        [DVec2::new(cos, sin), DVec2::new(-sin, cos)]
    }

    /// The rectangle where it touches the floor.
    ///
    /// # Errors
    /// No element or too many, a step beyond the limit.
    pub fn start(&self, cells: Cells) -> Result<ElasticRun, ElasticError> {
        let mesh = QuadMesh::rectangle(self.width, self.height, cells)?;
        let [_, up] = self.world_axes();
        let offset = mesh.nodes().iter().map(|place| up.dot(*place)).fold(f64::INFINITY, f64::min);
        let body = ElasticBody::new(mesh, self.material, self.guide);
        let part = match self.guide {
            Guide::Free => STABILITY_FACTOR,
            // Waves along one axis that step at the limit have no dispersion.
            Guide::Vertical => 1.0,
        };
        let step_s = self.step_s.unwrap_or(part * body.longest_step_s());
        let states = NodeStates::moving(&body, up * -self.speed);
        ElasticRun::new(body, Some(Floor { normal: up, offset }), states, step_s)
    }

    /// Time off the floor after which nothing brings it back, s.
    fn left_for_good_s(&self) -> f64 {
        let (long, short) = (self.width.max(self.height), self.width.min(self.height));
        (2.0 * (long + short) + long * long / short) / self.material.shear_speed()
    }

    /// Drops it.
    ///
    /// # Errors
    /// Those of [`RectangleDrop::start`], an element that folds, a body that stays on the floor.
    pub fn run(&self, cells: Cells) -> Result<DropReport, ElasticError> {
        let mut run = self.start(cells)?;
        let before = positive("the energy of the drop", "J", run.energy().kinetic_j)?;
        let (quiet_s, mut most_elastic, mut deepest_step) = (self.left_for_good_s(), 0.0, 0);
        loop {
            run.step()?;
            if run.elastic_j() > most_elastic {
                (most_elastic, deepest_step) = (run.elastic_j(), run.steps());
            }
            let last_s = run.contact_times().map_or(0.0, |times| times.last_s);
            if run.time_s() - last_s > quiet_s {
                return Ok(self.report(&run, cells, before, deepest_step));
            }
            if run.time_s() > LONGEST_STAY * quiet_s {
                return Err(ElasticError::StaysDown { t_s: run.time_s(), steps: run.steps() });
            }
        }
    }

    fn report(&self, run: &ElasticRun, cells: Cells, before_j: f64, deepest_step: usize) -> DropReport {
        let (body, ledger, momenta) = (run.body(), run.energy(), run.momentum());
        let [along, up] = self.world_axes();
        let (mass, inertia) = (body.mass(), body.inertia());
        let velocity = momenta.now.linear / mass;
        // Half a step ago, when the velocities were those of the momenta, the centre of mass was here up to a multiple
        // of its velocity, which has no moment.
        let spin = momenta.now.angular - moment(body.center_of_mass(run.displacements()), momenta.now.linear);
        let angular_velocity = spin / inertia;
        let corner = self.lowest_corner() - body.center_of_mass(&vec![DVec2::ZERO; body.masses().len()]);
        let corner_velocity = velocity + angular_velocity * DVec2::new(corner.y, -corner.x);
        let translation_j = 0.5 * mass * velocity.length_squared();
        let rotation_j = 0.5 * inertia * angular_velocity * angular_velocity;
        let EnergyLedger { kinetic_j, elastic_j, contact_loss_j, numerical_j, .. } = ledger;
        let contact_time_s = run.contact_times().map_or(0.0, |times| times.last_s - times.first_s);
        DropReport {
            cells,
            step_s: run.step_s(),
            longest_step_s: body.longest_step_s(),
            steps: run.steps(),
            deepest_step,
            mass_kg: mass,
            contact_time_s,
            impulse_n_s: momenta.floor.linear.dot(up),
            velocity: DVec2::new(along.dot(velocity), up.dot(velocity)),
            angular_velocity,
            restitution: up.dot(velocity) / self.speed,
            corner_restitution: up.dot(corner_velocity) / self.speed,
            energy_restitution: ((translation_j + rotation_j) / before_j).sqrt(),
            energy: ReboundEnergy {
                before_j,
                translation_j,
                rotation_j,
                vibration_j: kinetic_j + elastic_j - translation_j - rotation_j,
                contact_loss_j,
                numerical_j,
                residual_j: ledger.residual_j(),
            },
            momentum_residual: momenta.residual().linear.length() / (mass * self.speed),
        }
    }

    /// The corner that meets the floor, in the axes of the mesh; the middle of the side of a flat drop.
    pub fn lowest_corner(&self) -> DVec2 {
        let [_, up] = self.world_axes();
        let side = |slope: f64| if slope == 0.0 { 0.0 } else { -0.5 * slope.signum() };
        DVec2::new(side(up.x) * self.width, if up.y < 0.0 { self.height } else { 0.0 })
    }
}
