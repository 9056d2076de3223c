//! Two trajectories.

use super::table::{Table, number};
use polhode_scene::Comparison;
use polhode_scene::compare::Mismatch;

/// The largest difference of every column.
pub(crate) fn comparison(comparison: &Comparison) -> String {
    if let (0, Some(mismatch)) = (comparison.rows, &comparison.mismatch) {
        // Nothing has been compared: a table would hold nothing but zeros.
        return format!("{}no row was compared\n", self::mismatch(mismatch));
    }
    let mut table = Table::default();
    table.row(["column", "largest difference", "rows beyond tolerance", "at t", "body", "first", "second"]);
    for column in &comparison.columns {
        let mut cells = vec![column.column.to_owned(), number(column.largest), column.beyond.to_string()];
        if let Some(at) = &column.at {
            cells.extend([at.t.clone(), at.body.clone(), format!("{:?}", at.a), format!("{:?}", at.b)]);
        }
        table.cells(cells);
    }
    let verdict = match (&comparison.mismatch, comparison.agrees()) {
        (Some(mismatch), _) => self::mismatch(mismatch),
        (None, true) => "the trajectories agree within the tolerance\n".to_owned(),
        (None, false) => "the trajectories differ beyond the tolerance\n".to_owned(),
    };
    format!("{} rows\n{}{verdict}", comparison.rows, table.print())
}

fn mismatch(mismatch: &Mismatch) -> String {
    let row = |key: &Option<[String; 2]>| match key {
        Some([t, body]) => format!("body {body} at t = {t}"),
        None => "its end".to_owned(),
    };
    let (line, a, b) = (mismatch.line, row(&mismatch.a), row(&mismatch.b));
    format!("the trajectories are not about the same samples: at line {line} the first has {a}, the second {b}\n")
}
