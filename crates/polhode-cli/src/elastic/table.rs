//! Many drops: rectangles of several widths that drop flat, and the one of the arguments at several tilts.

use super::one::{Dropped, figure};
use crate::args::ElasticArgs;
use crate::failure::Failure;
use crate::text::Table;
use polhode_elastic::{ElasticMaterial, Extrapolated, Quantity, RectangleDrop};
use serde_json::{Value, json};

/// Widths of the rectangles that drop flat, in units of their height.
const WIDTHS: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];

/// Tilts of the rectangle of the arguments, degrees.
const TILTS: [f64; 5] = [5.0, 15.0, 30.0, 45.0, 75.0];

/// A drop of the table.
pub(super) struct Row {
    /// Width over height.
    aspect: f64,
    tilt_deg: f64,
    dropped: Dropped,
}

/// Drops them all.
pub(super) fn rows(args: &ElasticArgs, material: &ElasticMaterial) -> Result<Vec<Row>, Failure> {
    let row = |aspect: f64, tilt_deg: f64| {
        let drop = RectangleDrop::new(aspect * args.height, args.height, *material, args.speed)?;
        let dropped = Dropped::of(&drop.tilted(tilt_deg.to_radians())?, args.elements)?;
        Ok(Row { aspect, tilt_deg, dropped })
    };
    let flat = WIDTHS.iter().map(|&aspect| row(aspect, 0.0));
    let tilted = TILTS.iter().map(|&tilt_deg| row(args.width / args.height, tilt_deg));
    flat.chain(tilted).collect()
}

/// As text.
pub(super) fn text(rows: &[Row]) -> Result<String, Failure> {
    let mut table = Table::default();
    table.row([
        "W/H",
        "tilt, deg",
        "touch / (2 H/c_p)",
        "velocity up",
        "angular velocity",
        "vibration",
        "rigid e = 1 off",
        "best e",
        "off",
    ]);
    for row in rows {
        let limit = |quantity: Quantity| row.dropped.limit(quantity);
        let touch = limit(Quantity::ContactTime)?;
        let touch = shown(touch.value / row.dropped.wave_s(), touch.error / row.dropped.wave_s());
        let quantity = |quantity: Quantity| limit(quantity).map(|found| shown_limit(&found));
        let [.., whole, best] = row.dropped.rigid() else { continue };
        table.cells(vec![
            row.aspect.to_string(),
            row.tilt_deg.to_string(),
            touch,
            quantity(Quantity::Velocity)?,
            quantity(Quantity::AngularVelocity)?,
            quantity(Quantity::Vibration)?,
            figure(whole.error),
            best.restitution.to_string(),
            figure(best.error),
        ]);
    }
    Ok(table.print())
}

fn shown_limit(limit: &Extrapolated) -> String {
    shown(limit.value, limit.error)
}

/// A value with its error, in four decimals: errors are of some thousandths.
fn shown(value: f64, error: f64) -> String {
    format!("{value:.4} +- {error:.4}")
}

/// As JSON.
pub(super) fn json(rows: &[Row]) -> Result<Value, Failure> {
    let row = |row: &Row| {
        let mut value = row.dropped.json()?;
        value["aspect"] = json!(row.aspect);
        value["tilt_deg"] = json!(row.tilt_deg);
        Ok(value)
    };
    rows.iter().map(row).collect::<Result<Vec<_>, Failure>>().map(Value::from)
}
