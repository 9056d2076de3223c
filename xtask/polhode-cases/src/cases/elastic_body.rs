//! The elastic rectangle (thesis, Figure 2): the closed form of the confined bar, its ledgers and symmetry, and whether
//! the restitution of the shipped scene of Figure 2 is that of finite elements.
//!
//! A bar of height L in uniaxial strain that meets a rigid floor sends a wave up at c_p, which comes back as one that
//! relieves: after `2 L / c_p` the bar leaves with the speed it came with, and the floor has given `2 m v`.

use super::{Amount, CaseResult, Context};
use crate::elastic_table::{self, Reached};
use crate::row::Row;
use polhode_elastic::{DropStudy, ElasticError, ElasticMaterial, Quantity, RectangleDrop};

const NAME: &str = "elastic body";

/// Tolerances of the confined bar, relative: as in the specification of the case.
const CONTACT_TIME: f64 = 1e-3;
const IMPULSE: f64 = 1e-9;

/// What ledgers may leave unexplained, relative: sums over thousands of nodes and steps.
const LEDGER: f64 = 1e-11;

/// What left and right may differ by, of the speed: rounding, grown by contacts that open and close.
const MIRROR: f64 = 1e-9;

/// What the trapezoidal rule for the work of elastic forces may be off, as a part of the energy.
const STEPS: f64 = 1e-3;

/// The coefficient of `fixtures/scenes/figure-02.toml`.
const SHIPPED_RESTITUTION: f64 = 0.8195;

/// Drops of the table that are made again: flat, and on a steep corner.
const KEPT: [[f64; 2]; 2] = [[2.0, 0.0], [2.0, 75.0]];

/// What they may differ by, relative: the arithmetic is the same, that of another compiler would be found.
const AGAIN: f64 = 1e-12;

/// Elements of Figure 2.
const ELEMENTS: usize = 200;

/// The rectangle of Figure 2: 2 m x 1 m of rubber.
fn figure_2() -> Result<RectangleDrop, ElasticError> {
    RectangleDrop::new(2.0, 1.0, ElasticMaterial::new(1e6, 0.3, 1000.0)?, 1.0)
}

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = confined()?;
    rows.extend(ledgers()?);
    rows.extend(mirrored()?);
    rows.extend(restitution()?);
    rows.extend(kept(context)?);
    Ok(rows)
}

/// The closed form, on coarse and fine meshes, for several materials.
fn confined() -> CaseResult {
    let mut rows = Vec::new();
    for (poisson, elements, speed) in
        [(0.3, 8, 1.0), (0.3, ELEMENTS, 1.0), (0.3, 3200, 1.0), (0.0, ELEMENTS, 5.0), (0.45, ELEMENTS, 0.1)]
    {
        let material = ElasticMaterial::new(1e6, poisson, 1000.0)?;
        let drop = RectangleDrop::new(2.0, 1.0, material, speed)?.confined()?;
        let report = drop.run(drop.cells(elements))?;
        let time = report.contact_time_s * material.dilatational_speed() / (2.0 * drop.height());
        let impulse = report.impulse_n_s / (2.0 * report.mass_kg * speed);
        let what = format!("confined, nu {poisson}, {elements} elements, {speed} m/s");
        rows.push(Row::at_most(NAME, &format!("{what}: contact time over 2 L/c_p, less 1"), CONTACT_TIME, time - 1.0));
        rows.push(Row::at_most(NAME, &format!("{what}: impulse over 2 m v, less 1"), IMPULSE, impulse - 1.0));
    }
    Ok(rows)
}

/// Energy and momentum of flat and tilted drops.
fn ledgers() -> CaseResult {
    let mut rows = Vec::new();
    for tilt_deg in [0.0, 15.0, 45.0] {
        let drop = figure_2()?.tilted(f64::to_radians(tilt_deg))?;
        let report = drop.run(drop.cells(ELEMENTS))?;
        let energy = &report.energy;
        let part = |value: f64| value / energy.before_j;
        let mut row = |what: &str, limit: f64, value: f64| {
            rows.push(Row::at_most(NAME, &format!("tilt {tilt_deg} degrees: {what}"), limit, value));
        };
        row("energy left unexplained, part", LEDGER, part(energy.residual_j));
        row("momentum left unexplained, part", LEDGER, report.momentum_residual);
        row("work of the floor, part", LEDGER, part(energy.contact_loss_j));
        row("energy from the time steps, part", STEPS, part(energy.numerical_j));
    }
    Ok(rows)
}

/// A drop on the left corner mirrors that on the right one.
fn mirrored() -> CaseResult {
    let drop = |tilt: f64| -> Result<_, ElasticError> {
        let drop = figure_2()?.tilted(tilt)?;
        drop.run(drop.cells(ELEMENTS))
    };
    let (left, right) = (drop(-0.35)?, drop(0.35)?);
    let differences = [
        left.velocity.y - right.velocity.y,
        left.velocity.x + right.velocity.x,
        left.angular_velocity + right.angular_velocity,
    ];
    let worst = differences.iter().fold(0.0, |worst: f64, difference| worst.max(difference.abs()));
    Ok(vec![Row::at_most(NAME, "mirrored drops: difference, m/s and rad/s", MIRROR, worst)])
}

/// The means of the document's table, made again: two drops on the two coarsest meshes, with all cases every drop on
/// three.
fn kept(context: &Context) -> CaseResult {
    let drops = elastic_table::kept(&context.root)?;
    let is_full = matches!(context.amount, Amount::Full);
    let meshes = if is_full { 3 } else { 2 };
    let mut rows = Vec::new();
    for drop in drops.iter().filter(|drop| is_full || KEPT.contains(&[drop.aspect, drop.tilt_deg])) {
        let again = elastic_table::measured(drop.aspect, drop.tilt_deg, meshes)?;
        let pairs = again.meshes.iter().zip(&drop.meshes);
        let differences = pairs.flat_map(|(again, kept)| {
            [
                again.contact_time.value / kept.contact_time.value,
                again.impulse.value / kept.impulse.value,
                again.restitution.value / kept.restitution.value,
            ]
        });
        let worst = differences.map(|ratio| (ratio - 1.0).abs()).fold(0.0, f64::max);
        let what =
            format!("W/H {}, tilt {} degrees: {meshes} meshes against those of the table", drop.aspect, drop.tilt_deg);
        rows.push(Row::at_most(NAME, &what, AGAIN, worst));
    }
    let Reached { entries, reached } = Reached::of(&drops)?;
    rows.push(Row::exact(NAME, "entries of the table that hold four digits", entries as u64, reached as u64));
    Ok(rows)
}

/// What Figure 2 bounces with.
fn restitution() -> CaseResult {
    let study = DropStudy::of(&figure_2()?, figure_2()?.cells(ELEMENTS))?;
    let limit = study.limit(Quantity::Restitution)?;
    Ok(vec![
        Row::at_most(
            NAME,
            "figure-02: restitution of the scene less that of elements",
            limit.error,
            SHIPPED_RESTITUTION - limit.value,
        ),
        Row::info(NAME, "figure-02: estimated error of the restitution", 0.0, limit.error),
    ])
}
