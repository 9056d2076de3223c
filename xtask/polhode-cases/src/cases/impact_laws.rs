//! Every impact law on the tables of multiple impacts: cradles, a ball between two, a flat stick, mass ratios; and a
//! bounce whose restitution depends on speed.
//!
//! The tables are rational, or closed forms: each law must give its own to rounding, and none may give the energy of
//! another.

use super::bodies::{GRAVITY, ball_on_x, bouncy, half_space};
use super::run::Run;
use super::{CaseResult, Context};
use crate::row::Row;
use glam::DVec3;
use polhode::contact::Shape;
use polhode::response::impact::PulseExponent;
use polhode::response::{
    ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings, ImpactStatus,
};
use polhode::scene::{Material, Method, RestitutionSpeed};
use polhode::spatial::{Inertia, Mass, MassProperties, Pose, UnitVector, Velocity};
use polhode::{Body, Effects, EventKind, Scene};
use std::error::Error;

const CASE: &str = "impact laws";

/// The laws, by name.
const LAWS: [(&str, ImpactLaw); 7] = [
    ("propagation", ImpactLaw::Propagation),
    ("simultaneous", ImpactLaw::Simultaneous),
    ("reflection", ImpactLaw::Reflection),
    ("poisson", ImpactLaw::Poisson),
    ("energetic", ImpactLaw::Energetic),
    ("pulse, linear", ImpactLaw::Pulse(PulseExponent::Linear)),
    ("pulse, hertz", ImpactLaw::Pulse(PulseExponent::Hertz)),
];

/// Velocities are exact to this, m/s at 1 m/s.
const EXACT: f64 = 1e-14;
/// A bounce is exact to this, of its restitution: the time of impact is found to some rounding units.
const BOUNCE: f64 = 1e-12;
/// Those of springs to the error of their steps.
const OF_STEPS: f64 = 1e-10;
/// With friction some more pieces add up, in space those of slips that turn.
const WITH_FRICTION: f64 = 1e-9;
/// The energy may rise by this part: four rounding units.
const RISE: f64 = 4.0 * f64::EPSILON;

/// An impact: masses of the coordinates, rows over them, velocities before.
struct Impact {
    name: &'static str,
    masses: Vec<f64>,
    rows: Vec<Vec<f64>>,
    before: Vec<f64>,
}

/// What a law made of it.
struct Struck {
    after: Vec<f64>,
    /// Change of energy over the energy before.
    change: f64,
    separated: bool,
}

impl Impact {
    /// Balls on a line, of which the first `moving` come at 1 m/s.
    fn cradle(name: &'static str, masses: &[f64], moving: usize) -> Self {
        let count = masses.len();
        let row =
            |k: usize| (0..count).map(|i| f64::from(u8::from(i == k)) - f64::from(u8::from(i + 1 == k))).collect();
        let before = (0..count).map(|ball| if ball < moving { 1.0 } else { 0.0 }).collect();
        Self { name, masses: masses.to_vec(), rows: (1..count).map(row).collect(), before }
    }

    /// A ball at 1 m/s between two that touch it, at 30 degrees (case IM-11).
    fn between() -> Self {
        let (c, s) = (0.75_f64.sqrt(), 0.5);
        let rows = vec![vec![-c, -s, c, s, 0.0, 0.0], vec![-c, s, 0.0, 0.0, c, -s]];
        Self { name: "ball between two", masses: vec![1.0; 6], rows, before: vec![1.0, 0.0, 0.0, 0.0, 0.0, 0.0] }
    }

    /// The stick of Appendix C of inertia 0.05, flat at 1 m/s.
    fn stick() -> Self {
        let rows = vec![vec![1.0, 1.0], vec![1.0, -1.0]];
        Self { name: "flat stick", masses: vec![1.0, 0.05], rows, before: vec![-1.0, 0.0] }
    }

    fn by(&self, law: ImpactLaw, restitution: f64) -> Result<Struck, Box<dyn Error>> {
        let size = self.masses.len();
        let mut inverse = vec![0.0; size * size];
        self.masses.iter().enumerate().for_each(|(i, mass)| inverse[i * (size + 1)] = 1.0 / mass);
        let mut contacts = ContactProblem::new(size, inverse)?;
        for row in &self.rows {
            contacts.push_row(&[(0, row)])?;
        }
        let (delassus, settings) = (contacts.delassus(), ImpactSettings::default());
        let u_before = contacts.row_velocities(&self.before)?;
        let restitution = vec![restitution; self.rows.len()];
        let problem = ImpactProblem {
            contacts: &contacts,
            delassus: &delassus,
            u_before: &u_before,
            restitution: &restitution,
            settings: &settings,
        };
        let outcome = law.resolve(&problem, &mut ComplementaritySolver::default())?;
        let change = contacts.response(&outcome.impulses)?;
        let energy: f64 = self.masses.iter().zip(&self.before).map(|(mass, v)| 0.5 * mass * v * v).sum();
        Ok(Struck {
            after: self.before.iter().zip(change).map(|(v, change)| v + change).collect(),
            change: outcome.energy_change / energy,
            separated: outcome.status == ImpactStatus::Separated,
        })
    }
}

fn difference(found: &[f64], expected: &[f64]) -> f64 {
    found.iter().zip(expected).map(|(found, expected)| (found - expected).abs()).fold(0.0, f64::max)
}

/// The tables.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = tables()?;
    rows.extend(plank(context)?);
    rows.extend(energies()?);
    rows.extend(bounces_at_speed()?);
    Ok(rows)
}

/// What each law gives.
fn tables() -> CaseResult {
    let (c, third) = (0.75_f64.sqrt(), 1.0 / 3.0);
    let three = Impact::cradle("3 balls, 1 moving", &[1.0; 3], 1);
    let five = Impact::cradle("5 balls, 2 moving", &[1.0; 5], 2);
    let heavier = Impact::cradle("masses 1 2 4", &[1.0, 2.0, 4.0], 1);
    let (between, stick) = (Impact::between(), Impact::stick());
    let light = Impact::cradle("masses 1 1e6", &[1.0, 1e6], 1);
    let heavy = Impact::cradle("masses 1e6 1", &[1e6, 1.0], 1);
    let mut rows = Vec::new();
    let mut table = |impact: &Impact, restitution: f64, laws: &[&str], after: &[f64]| -> Result<(), Box<dyn Error>> {
        for (name, law) in LAWS.into_iter().filter(|(name, _)| laws.contains(name)) {
            let struck = impact.by(law, restitution)?;
            let limit = if matches!(law, ImpactLaw::Pulse(_)) && impact.rows.len() > 1 { OF_STEPS } else { EXACT };
            let quantity = format!("{}, e={restitution}: {name}: largest error of velocities, m/s", impact.name);
            let size = after.iter().fold(1.0, |most: f64, v| most.max(v.abs()));
            rows.push(Row::at_most(CASE, &quantity, limit * size, difference(&struck.after, after)));
        }
        Ok(())
    };
    let all: Vec<&str> = LAWS.iter().map(|(name, _)| *name).collect();
    let at_once = ["simultaneous", "poisson", "energetic"];
    let symmetric: Vec<&str> = all.iter().copied().filter(|name| *name != "propagation").collect();
    table(&three, 1.0, &["propagation", "reflection"], &[0.0, 0.0, 1.0])?;
    table(&three, 1.0, &at_once, &[-third, 2.0 * third, 2.0 * third])?;
    table(&three, 0.5, &["propagation"], &[13.0 / 64.0, 15.0 / 64.0, 36.0 / 64.0])?;
    table(&three, 0.5, &at_once, &[0.0, 0.5, 0.5])?;
    table(&five, 1.0, &["propagation", "reflection"], &[0.0, 0.0, 0.0, 1.0, 1.0])?;
    table(&five, 1.0, &at_once, &[-0.2, -0.2, 0.8, 0.8, 0.8])?;
    table(&heavier, 1.0, &["propagation"], &[-third, -2.0 / 9.0, 4.0 / 9.0])?;
    table(&heavier, 1.0, &at_once, &[-5.0 / 7.0, 2.0 / 7.0, 2.0 / 7.0])?;
    table(&between, 1.0, &["propagation"], &[-0.125, -0.25 * c, 0.75, 0.5 * c, 0.375, -0.25 * c])?;
    table(&between, 1.0, &symmetric, &[-0.2, 0.0, 0.6, 0.4 * c, 0.6, -0.4 * c])?;
    table(&stick, 1.0, &symmetric, &[1.0, 0.0])?;
    table(&stick, 0.5, &symmetric, &[0.5, 0.0])?;
    table(&light, 1.0, &all, &[-999_999.0 / 1_000_001.0, 2.0 / 1_000_001.0])?;
    table(&heavy, 1.0, &all, &[999_999.0 / 1_000_001.0, 2e6 / 1_000_001.0])?;
    for (name, law) in LAWS.into_iter().filter(|(_, law)| matches!(law, ImpactLaw::Pulse(_))) {
        let struck = three.by(law, 1.0)?;
        let row = Row::exact(CASE, &format!("{name}: momentum disperses in a cradle"), true, {
            let [first, second, third] = [struck.after[0], struck.after[1], struck.after[2]];
            first < -0.01 && second > 0.01 && third > 0.9 && third < 0.999
        });
        rows.push(Row { note: Some(format!("{:?}", struck.after)), ..row });
    }
    Ok(rows)
}

/// No law raises the energy; with e = 1 all of it is kept.
fn energies() -> CaseResult {
    let impacts = [
        Impact::cradle("3 balls", &[1.0; 3], 1),
        Impact::cradle("5 balls", &[1.0; 5], 2),
        Impact::cradle("1 2 4", &[1.0, 2.0, 4.0], 1),
        Impact::cradle("100 1 100", &[100.0, 1.0, 100.0], 1),
        Impact::between(),
        Impact::stick(),
    ];
    let mut rows = Vec::new();
    for (name, law) in LAWS {
        let (mut rise, mut loss, mut separated): (f64, f64, bool) = (0.0, 0.0, true);
        for impact in &impacts {
            for restitution in [0.0, 0.3, 0.5, 0.9, 1.0] {
                let struck = impact.by(law, restitution)?;
                rise = rise.max(struck.change);
                if restitution == 1.0 {
                    loss = loss.max(-struck.change);
                    separated &= struck.separated;
                }
            }
        }
        let limit = if matches!(law, ImpactLaw::Pulse(_)) { OF_STEPS } else { EXACT };
        rows.push(Row::at_most(CASE, &format!("{name}: largest rise of energy, of the energy"), RISE, rise));
        rows.push(Row::at_most(CASE, &format!("{name}: largest loss of energy with e=1, of the energy"), limit, loss));
        rows.push(Row::exact(CASE, &format!("{name}: separates with e=1"), true, separated));
    }
    Ok(rows)
}

/// A plank that lands on its lower edge, at two points, is the rod of IM-07: slip that goes on, reverses, or sticks.
/// The law pulse integrates the two contacts, where the rod has Stronge's closed form.
fn plank(context: &Context) -> CaseResult {
    /// Half the width of the plank, m.
    const HALF_WIDTH: f64 = 0.2;
    /// Gap below the edge, m.
    const GAP_M: f64 = 0.05;
    let half = 0.5 * std::f64::consts::FRAC_1_SQRT_2;
    let inertia = Inertia::from_diagonal(DVec3::new(1.0 / 12.0, 1.0 / 12.0, 1.0 / 12.0))?;
    let along = DVec3::new(half, 0.0, half);
    let across = DVec3::Y * HALF_WIDTH;
    let points = vec![along - across, along + across, -along - across, -along + across];
    let mut rows = Vec::new();
    for friction in [0.1, 0.5, 1.0] {
        let of_rod =
            context.reference.numbers("IM-07", &format!("mu={friction}, stronge: p_t, p_n, vx', vy', w', T'/T"))?;
        // Turning about z in the plane of the case is turning about -y here.
        let expected = [of_rod[2], of_rod[3], -of_rod[4]];
        let material = Material::new("rough").with_restitution(0.5)?.with_friction(friction)?;
        for exponent in [PulseExponent::Linear, PulseExponent::Hertz] {
            for effects in [Effects::Planned, Effects::All] {
                let body = Body::movable("plank", MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, inertia))
                    .geometry(Shape::points(points.clone())?.into())
                    .pose(Pose::from_translation(DVec3::Z * (half + GAP_M)))
                    .velocity(Velocity::new(DVec3::new(0.6, 0.0, -1.0), DVec3::ZERO))
                    .material(material.clone());
                let method = Method {
                    impact: Some(polhode::scene::ImpactLaw::Pulse),
                    pulse_exponent: Some(exponent),
                    ..Method::default()
                };
                let scene = Scene::builder("plank")
                    .gravity(DVec3::ZERO)
                    .method(method)
                    .body(half_space("floor", UnitVector::Z).material(material.clone()))
                    .body(body)
                    .duration_s(1.01 * GAP_M)
                    .build()?;
                let end = Run::of(&scene, effects)?.last("plank")?.velocity;
                let found = [end.linear.x, end.linear.z, end.angular.y];
                let quantity = format!(
                    "plank on its edge, mu={friction}, pulse, {}, {effects:?} effects: largest error of velocities, \
                     m/s",
                    exponent.name()
                );
                rows.push(Row::at_most(CASE, &quantity, WITH_FRICTION, difference(&found, &expected)));
            }
        }
    }
    Ok(rows)
}

/// A ball that falls from 1 m, with restitution by its speed v at the floor: it leaves at e(v) v.
fn bounces_at_speed() -> CaseResult {
    const HEIGHT_M: f64 = 1.0;
    const RADIUS_M: f64 = 0.5;
    let mut rows = Vec::new();
    let speed = (2.0 * GRAVITY * HEIGHT_M).sqrt();
    for (name, law, expected) in [
        ("yield at 0.5 m/s", RestitutionSpeed::Yield(0.5), 0.9 * (speed / 0.5).powf(-0.25)),
        ("slope 0.1 s/m", RestitutionSpeed::Slope(0.1), 0.9 - 0.1 * speed),
    ] {
        let material = Material::new("ball").with_restitution(0.9)?.with_restitution_speed(law)?;
        let ball = ball_on_x("ball", RADIUS_M, 1.0, 0.0, 0.0)?;
        let scene = Scene::builder("bounce")
            .body(half_space("floor", UnitVector::Z).material(bouncy(0.0)?))
            .body(ball.pose(Pose::from_translation(DVec3::Z * (RADIUS_M + HEIGHT_M))).material(material))
            .duration_s(1.0)
            .build()?;
        let run = Run::of(&scene, Effects::Planned)?;
        let impulse = run.events(EventKind::Impact).first().map_or(f64::NAN, |event| event.impulse);
        let measured = impulse / speed - 1.0;
        let quantity = format!("bounce at {speed:.3} m/s, {name}: error of restitution");
        rows.push(Row::at_most(CASE, &quantity, BOUNCE, (measured - expected).abs()));
    }
    Ok(rows)
}
