//! The eight tests of Chung and Ooi (2011) of one impact, by springs after Hertz and Mindlin, at other parameters too.
//!
//! 1 two equal balls head on; 2 a ball on a rigid plane; 3 restitution by a damper; 4 oblique impacts on a plane at one
//! speed; 5 at one normal speed; 6 with spin instead; 7 two equal balls that spin against each other; 8 two unequal
//! balls of which one spins. 1 to 3 and 7 are closed forms, 4 to 6 where the contact slides throughout: friction is
//! then mu times the normal impulse, `V' = V - mu (1 + e) v_n` and `w' = w +- (5/2) mu (1 + e) v_n/r`. Where it also
//! sticks (5, 6 and 8) the reference is an integration of its own in the plane (`two_balls.rs`).
//! Source: docs/REFERENCES.md, Chung and Ooi 2011.

use super::two_balls::{Ball, Collision, Contact};
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use glam::DVec3;
use polhode::contact::Shape;
use polhode::mesh::solid_sphere;
use polhode::scene::{Material, Method, PenaltyMethod, Response, SpringDamping, SpringLaw};
use polhode::spatial::{Mass, Pose, UnitVector, Velocity};
use polhode::{Body, RunReport, Scene, Simulation, SpringImpact};
use std::error::Error;
use std::f64::consts::PI;

/// What closed forms are met to, relative.
const CLOSED: f64 = 1e-9;
/// What the integration of its own is met to, relative to the speeds of the impact.
const INTEGRATED: f64 = 1e-8;
/// Duration of an elastic impact after Hertz per greatest overlap and speed: 2 sqrt(pi) Gamma(7/5)/Gamma(9/10).
const DURATION: f64 = 2.943_275_184_324_706;
/// What the ledger closes to, relative.
const LEDGER: f64 = 1e-12;
/// Time in which every impact of these tests has ended after the bodies have met, s.
const AFTER_S: f64 = 4e-3;
/// Gap before an impact, relative to the radius.
const GAP: f64 = 1e-4;

/// A material of balls: Young's modulus (Pa), Poisson's ratio, density (kg/m^3).
#[derive(Debug, Clone, Copy)]
struct Matter {
    name: &'static str,
    young: f64,
    poisson: f64,
    density: f64,
}

const GLASS: Matter = Matter { name: "glass", young: 48e9, poisson: 0.20, density: 2800.0 };
const LIMESTONE: Matter = Matter { name: "limestone", young: 20e9, poisson: 0.25, density: 2500.0 };
const ALUMINIUM: Matter = Matter { name: "aluminium alloy", young: 70e9, poisson: 0.30, density: 2699.0 };
const MAGNESIUM: Matter = Matter { name: "magnesium alloy", young: 40e9, poisson: 0.35, density: 1800.0 };
const OXIDE: Matter = Matter { name: "aluminium oxide", young: 380e9, poisson: 0.23, density: 4000.0 };
const IRON: Matter = Matter { name: "cast iron", young: 100e9, poisson: 0.25, density: 7000.0 };
const STEEL: Matter = Matter { name: "steel", young: 208e9, poisson: 0.30, density: 7850.0 };
const NYLON: Matter = Matter { name: "nylon", young: 2.5e9, poisson: 0.40, density: 1000.0 };
const COPPER: Matter = Matter { name: "copper", young: 120e9, poisson: 0.35, density: 8900.0 };

impl Matter {
    fn material(&self, restitution: f64, friction: f64) -> Result<Material, Box<dyn Error>> {
        let rubs = Material::new(self.name).with_restitution(restitution)?.with_friction(friction)?;
        Ok(rubs.with_elasticity(self.young, self.poisson)?)
    }

    fn mass(&self, radius: f64) -> f64 {
        4.0 / 3.0 * PI * radius * radius * radius * self.density
    }

    /// A ball of a radius (m).
    fn ball(&self, of: &Material, radius: f64, place: DVec3, moving: Velocity) -> Result<Body, Box<dyn Error>> {
        let properties = solid_sphere(radius, Mass::new(self.mass(radius))?)?;
        let body = Body::movable(format!("ball at {place}"), properties).geometry(Shape::sphere(radius)?.into());
        Ok(body.pose(Pose::from_translation(place)).velocity(moving).material(of.clone()))
    }
}

/// An impact that was run: its report, and its one contact.
#[derive(Debug)]
struct Impact {
    report: RunReport,
    contact: SpringImpact,
}

impl Impact {
    fn of(bodies: Vec<Body>, penalty: PenaltyMethod, duration_s: f64) -> Result<Self, Box<dyn Error>> {
        let method = Method { response: Some(Response::Penalty), penalty: Some(penalty), ..Method::default() };
        let scene = Scene::builder("impact").method(method).gravity(DVec3::ZERO).duration_s(duration_s);
        let scene = bodies.into_iter().fold(scene, polhode::SceneBuilder::body).build()?;
        let report = Simulation::new(&scene)?.run()?;
        let springs = report.springs.as_ref().ok_or("no report of springs")?;
        let contact = *springs.first_impacts.first().ok_or("no impact has ended")?;
        Ok(Self { report, contact })
    }

    fn velocity(&self, body: usize) -> Velocity {
        self.report.bodies[body].state.velocity
    }
}

fn hertz() -> PenaltyMethod {
    PenaltyMethod { law: Some(SpringLaw::Hertz), ..PenaltyMethod::default() }
}

/// A plane through the origin, with its normal up.
fn plane(material: &Material) -> Body {
    Body::fixed("plane").geometry(Shape::half_space(UnitVector::Z).into()).material(material.clone())
}

/// A relative comparison.
fn closed(case: &str, quantity: &str, reference: f64, measured: f64) -> Row {
    Row::compared(case, quantity, reference, measured, Tolerance::Relative(CLOSED))
}

/// Greatest overlap, force and duration of an elastic impact after Hertz: stiffness (N/m^(3/2)), mass (kg), speed
/// (m/s).
fn hertz_rows(case: &str, name: &str, impact: &Impact, (stiffness, mass, speed): (f64, f64, f64)) -> [Row; 4] {
    let depth = (1.25 * mass * speed * speed / stiffness).powf(0.4);
    let contact = &impact.contact;
    [
        closed(case, &format!("{name}: greatest overlap, m"), depth, contact.penetration_m),
        closed(case, &format!("{name}: greatest force, N"), stiffness * depth.powf(1.5), contact.force_n),
        closed(case, &format!("{name}: duration, s"), DURATION * depth / speed, contact.duration_s),
        Row::at_most(case, &format!("{name}: ledger"), LEDGER, impact.report.ledger.closure_relative()),
    ]
}

/// Test 1.
pub(super) fn balls_head_on(_context: &Context) -> CaseResult {
    let case = "CO-1";
    let (radius, speed) = (0.01, 10.0);
    let mut rows = Vec::new();
    for matter in [GLASS, LIMESTONE] {
        let material = matter.material(1.0, 0.0)?;
        let one = |side: f64| {
            let moving = Velocity::new(DVec3::Z * (-speed * side), DVec3::ZERO);
            matter.ball(&material, radius, DVec3::Z * ((1.0 + GAP) * radius * side), moving)
        };
        let impact = Impact::of(vec![one(1.0)?, one(-1.0)?], hertz(), 4.0 * GAP * radius / speed + AFTER_S)?;
        let modulus = matter.young / (2.0 * (1.0 - matter.poisson * matter.poisson));
        let stiffness = 4.0 / 3.0 * modulus * (0.5 * radius).sqrt();
        let of = (stiffness, 0.5 * matter.mass(radius), 2.0 * speed);
        rows.extend(hertz_rows(case, matter.name, &impact, of));
    }
    Ok(rows)
}

/// Test 2.
pub(super) fn ball_on_a_rigid_plane(_context: &Context) -> CaseResult {
    let case = "CO-2";
    let (radius, speed) = (0.1, 0.2);
    let rigid = Material::new("rigid").with_restitution(1.0)?;
    let mut rows = Vec::new();
    for matter in [ALUMINIUM, MAGNESIUM] {
        let moving = Velocity::new(DVec3::Z * -speed, DVec3::ZERO);
        let ball = matter.ball(&matter.material(1.0, 0.0)?, radius, DVec3::Z * ((1.0 + GAP) * radius), moving)?;
        let impact = Impact::of(vec![plane(&rigid), ball], hertz(), 4.0 * GAP * radius / speed + AFTER_S)?;
        let stiffness = 4.0 / 3.0 * matter.young / (1.0 - matter.poisson * matter.poisson) * radius.sqrt();
        rows.extend(hertz_rows(case, matter.name, &impact, (stiffness, matter.mass(radius), speed)));
    }
    Ok(rows)
}

/// Test 3.
pub(super) fn restitution(_context: &Context) -> CaseResult {
    let case = "CO-3";
    let (radius, speed) = (0.0025, 3.9);
    let mut rows = Vec::new();
    for (name, damping) in [("Hunt-Crossley", SpringDamping::HuntCrossley), ("plain", SpringDamping::Plain)] {
        for matter in [OXIDE, IRON] {
            let (mut off, mut closure) = (0.0f64, 0.0f64);
            for e in [0.05, 0.2, 0.4, 0.6, 0.8, 1.0] {
                let penalty = PenaltyMethod { damping: Some(damping), ..hertz() };
                let moving = Velocity::new(DVec3::Z * -speed, DVec3::ZERO);
                let material = matter.material(e, 0.0)?;
                let ball = matter.ball(&material, radius, DVec3::Z * ((1.0 + GAP) * radius), moving)?;
                let impact = Impact::of(vec![plane(&material), ball], penalty, AFTER_S)?;
                off = off.max((impact.velocity(1).linear.z / (e * speed) - 1.0).abs());
                closure = closure.max(impact.report.ledger.closure_relative());
            }
            let quantity = format!("{}, {name}: rebound against e v, e = 0.05 to 1, relative", matter.name);
            rows.push(Row::at_most(case, &quantity, CLOSED, off));
            rows.push(Row::at_most(case, &format!("{}, {name}: ledger", matter.name), LEDGER, closure));
        }
    }
    Ok(rows)
}

/// A ball that meets a plane: radius (m), coefficients, velocity towards and along the plane (m/s), spin (rad/s).
#[derive(Debug, Clone, Copy)]
struct Oblique {
    matter: Matter,
    radius: f64,
    friction: f64,
    restitution: f64,
    normal: f64,
    along: f64,
    spin: f64,
}

impl Oblique {
    fn run(&self) -> Result<Impact, Box<dyn Error>> {
        let material = self.matter.material(self.restitution, self.friction)?;
        let moving = Velocity::new(DVec3::new(self.along, 0.0, -self.normal), DVec3::Y * self.spin);
        let ball = self.matter.ball(&material, self.radius, DVec3::Z * ((1.0 + GAP) * self.radius), moving)?;
        Impact::of(vec![plane(&material), ball], hertz(), 0.02 * self.radius / self.normal + AFTER_S)
    }

    /// Slip of the ball over the plane, m/s.
    fn slip(&self) -> f64 {
        self.along - self.spin * self.radius
    }

    /// Rows against gross slip.
    fn slip_rows(&self, case: &str, name: &str) -> CaseResult {
        let impact = self.run()?;
        let after = impact.velocity(1);
        let change = -self.friction * (1.0 + self.restitution) * self.normal * self.slip().signum();
        let (along, spin) = (self.along + change, self.spin - 2.5 * change / self.radius);
        let speed = self.along.abs().max(self.normal);
        let off = (after.linear.x - along).abs() / speed;
        let turned = (after.angular.y - spin).abs() * self.radius / speed;
        let name = format!("{}, {name}", self.matter.name);
        Ok(vec![
            Row::at_most(case, &format!("{name}: velocity against gross slip, relative"), CLOSED, off),
            Row::at_most(case, &format!("{name}: spin against gross slip, relative"), CLOSED, turned),
        ])
    }

    /// Rows against the integration in the plane.
    fn integrated_rows(&self, case: &str, name: &str) -> CaseResult {
        let impact = self.run()?;
        let after = impact.velocity(1);
        let own = Ball {
            radius: self.radius,
            mass: self.matter.mass(self.radius),
            position: [0.0, (1.0 + GAP) * self.radius],
            velocity: [self.along, -self.normal],
            // In the plane of x and z a positive rotation about -y is anticlockwise.
            spin: -self.spin,
        };
        let contact = Contact::of([self.matter.elastic(); 2], self.restitution, self.friction);
        let end = Collision::with_plane(own, contact).after();
        let speed = self.along.abs().max(self.normal);
        let velocity = (after.linear.x - end.0.velocity[0]).hypot(after.linear.z - end.0.velocity[1]) / speed;
        let spin = (-after.angular.y - end.0.spin).abs() * self.radius / speed;
        let name = format!("{}, {name}", self.matter.name);
        Ok(vec![
            Row::at_most(case, &format!("{name}: velocity against the integration, relative"), INTEGRATED, velocity),
            Row::at_most(case, &format!("{name}: spin against the integration, relative"), INTEGRATED, spin),
        ])
    }
}

impl Matter {
    fn elastic(&self) -> [f64; 2] {
        [self.young, self.poisson]
    }
}

/// Test 4.
pub(super) fn oblique_at_one_speed(_context: &Context) -> CaseResult {
    let case = "CO-4";
    let mut rows = Vec::new();
    for matter in [OXIDE, ALUMINIUM] {
        for degrees in [40.0f64, 60.0, 85.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let own = Oblique {
                matter,
                radius: 0.0025,
                friction: 0.092,
                restitution: 0.98,
                normal: 3.9 * cosine,
                along: 3.9 * sine,
                spin: 0.0,
            };
            rows.extend(own.slip_rows(case, &format!("{degrees} degrees"))?);
        }
    }
    let steep = Oblique {
        matter: OXIDE,
        radius: 0.0025,
        friction: 0.092,
        restitution: 0.98,
        normal: 3.9 * 10f64.to_radians().cos(),
        along: 3.9 * 10f64.to_radians().sin(),
        spin: 0.0,
    };
    rows.extend(steep.integrated_rows(case, "10 degrees, which also sticks")?);
    Ok(rows)
}

/// Test 5.
pub(super) fn oblique_at_one_normal_speed(_context: &Context) -> CaseResult {
    let case = "CO-5";
    let of =
        |matter, along| Oblique { matter, radius: 0.1, friction: 0.3, restitution: 1.0, normal: 5.0, along, spin: 0.0 };
    let mut rows = Vec::new();
    for matter in [STEEL, NYLON] {
        for along in [15.0, 25.0] {
            rows.extend(of(matter, along).slip_rows(case, &format!("{along} m/s along"))?);
        }
        for along in [0.5, 2.0, 6.0] {
            rows.extend(of(matter, along).integrated_rows(case, &format!("{along} m/s along, which also sticks"))?);
        }
    }
    Ok(rows)
}

/// Test 6.
pub(super) fn spin_on_a_plane(_context: &Context) -> CaseResult {
    let case = "CO-6";
    let of =
        |matter, spin| Oblique { matter, radius: 0.1, friction: 0.4, restitution: 0.5, normal: 0.2, along: 0.0, spin };
    let mut rows = Vec::new();
    for matter in [ALUMINIUM, NYLON] {
        for spin in [10.0, 24.0] {
            rows.extend(of(matter, spin).slip_rows(case, &format!("{spin} rad/s"))?);
        }
        for spin in [0.5, 2.0] {
            rows.extend(of(matter, spin).integrated_rows(case, &format!("{spin} rad/s, which also sticks"))?);
        }
    }
    Ok(rows)
}

/// Test 7.
pub(super) fn balls_that_spin_against_each_other(_context: &Context) -> CaseResult {
    let case = "CO-7";
    let (radius, speed, e) = (0.1, 0.2, 0.5);
    let mut rows = Vec::new();
    for matter in [ALUMINIUM, COPPER] {
        for spin in [25.0, 175.0] {
            let material = matter.material(e, 0.4)?;
            let one = |side: f64| {
                let moving = Velocity::new(DVec3::X * (-speed * side), DVec3::Y * (spin * side));
                matter.ball(&material, radius, DVec3::X * ((1.0 + GAP) * radius * side), moving)
            };
            let impact = Impact::of(vec![one(1.0)?, one(-1.0)?], hertz(), 4.0 * GAP * radius / speed + AFTER_S)?;
            let (mut along, mut turned, mut up) = (0.0f64, 0.0f64, 0.0f64);
            for (body, side) in [(0, 1.0), (1, -1.0)] {
                let velocity = impact.velocity(body);
                along = along.max((velocity.linear.x * side / (e * speed) - 1.0).abs());
                turned = turned.max((velocity.angular.y * side / spin - 1.0).abs());
                up = up.max(velocity.linear.z.abs() / speed);
            }
            let name = format!("{}, {spin} rad/s", matter.name);
            rows.push(Row::at_most(case, &format!("{name}: rebound against e v, relative"), CLOSED, along));
            rows.push(Row::at_most(case, &format!("{name}: spin kept, relative"), CLOSED, turned));
            rows.push(Row::at_most(case, &format!("{name}: tangential velocity, relative"), CLOSED, up));
        }
    }
    Ok(rows)
}

/// Test 8.
pub(super) fn unequal_balls(_context: &Context) -> CaseResult {
    let case = "CO-8";
    let (radii, speed, e, friction) = ([0.1, 0.05], 0.2, 0.5, 0.4);
    let mut rows = Vec::new();
    for matter in [ALUMINIUM, NYLON] {
        let material = matter.material(e, friction)?;
        for spin in [0.5, 3.0, 15.0, 100.0] {
            let places = [[0.0, (1.0 + GAP) * radii[0]], [0.0, -(1.0 + GAP) * radii[1]]];
            let moving = [-speed, speed];
            let spins = [0.0, spin];
            let bodies: Result<Vec<Body>, Box<dyn Error>> = (0..2)
                .map(|k| {
                    let place = DVec3::new(places[k][0], 0.0, places[k][1]);
                    // Anticlockwise in the plane of x and z is about -y.
                    let velocity = Velocity::new(DVec3::Z * moving[k], DVec3::Y * -spins[k]);
                    matter.ball(&material, radii[k], place, velocity)
                })
                .collect();
            let impact = Impact::of(bodies?, hertz(), 0.02 * radii[0] / speed + AFTER_S)?;
            let of = |k: usize| Ball {
                radius: radii[k],
                mass: matter.mass(radii[k]),
                position: places[k],
                velocity: [0.0, moving[k]],
                spin: spins[k],
            };
            let contact = Contact::of([matter.elastic(); 2], e, friction);
            let end = Collision::of_balls([of(0), of(1)], contact).after();
            let mut off = 0.0f64;
            for (k, own) in [end.0, end.1].iter().enumerate() {
                let found = impact.velocity(k);
                let velocity = (found.linear.x - own.velocity[0]).hypot(found.linear.z - own.velocity[1]);
                let turned = (-found.angular.y - own.spin).abs() * radii[k];
                off = off.max(velocity.max(turned) / speed);
            }
            let quantity =
                format!("{}, {spin} rad/s: velocities and spins against the integration, relative", matter.name);
            rows.push(Row::at_most(case, &quantity, INTEGRATED, off));
        }
    }
    Ok(rows)
}
