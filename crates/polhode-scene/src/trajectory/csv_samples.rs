//! The samples of a CSV file.

use super::error::TrajectoryError;
use super::expected::{CUT_OFF, Expected, Sample};
use crate::trajectory_rows::{Row, Rows, Velocities};
use std::path::Path;

/// The samples of a CSV file, whose rows of one sample bear the same text in `t`.
#[derive(Debug)]
pub(super) struct CsvSamples {
    rows: Rows,
    /// The row that begins the next sample.
    next: Option<Row>,
    /// Why no row follows the last whole sample.
    fault: Option<TrajectoryError>,
}

impl CsvSamples {
    pub(super) fn open(path: &Path, velocities: Velocities) -> Result<Self, TrajectoryError> {
        let mut rows = Rows::open(path, velocities)?;
        match rows.next()? {
            Some(next) => Ok(Self { rows, next: Some(next), fault: None }),
            None => Err(rows.content("it has no samples, only a first line".to_owned()).into()),
        }
    }

    pub(super) fn has_velocities(&self) -> bool {
        self.rows.has_velocities()
    }

    pub(super) fn next(&mut self, expected: &mut Expected) -> Result<Option<Sample>, TrajectoryError> {
        let Some(first) = self.next.take() else { return self.fault.take().map_or(Ok(None), Err) };
        let time = first.key[0].clone();
        let t: f64 = time.parse().map_err(|_| self.wrong(format!("`{time}` in column t is not a number")))?;
        let t = expected.time(t).map_err(|reason| self.wrong(reason))?;
        let (mut bodies, mut errors) = (vec![None; expected.count()], vec![None; expected.count()]);
        let mut found = 0;
        let mut row = Some(first);
        while let Some(present) = row {
            if present.key[0] != time {
                self.next = Some(present);
                break;
            }
            let number = expected.body(&present.key[1]).map_err(|reason| self.wrong(reason))?;
            if bodies[number].is_some() {
                return Err(self.wrong(format!("body `{}` stands twice at t = {time} s", present.key[1])));
            }
            errors[number] = present.error;
            bodies[number] = Some(expected.state(number, present.numbers).map_err(|reason| self.wrong(reason))?);
            found += 1;
            row = match self.rows.next() {
                // The sample is whole: what is wrong comes after it.
                Err(fault) if found == expected.count() => {
                    self.fault = Some(fault.into());
                    None
                }
                row => row?,
            };
        }
        let at_end = self.next.is_none() && self.fault.is_none();
        if let Some(missing) = bodies.iter().position(Option::is_none) {
            let (name, needed) = (expected.name(missing), expected.count());
            let reason = format!("t = {time} s has {found} of {needed} bodies; `{name}` is missing");
            return Err(self.wrong(if at_end { format!("{reason}: {CUT_OFF}") } else { reason }));
        }
        // A number that is cut off in its digits is a number.
        if at_end && !self.rows.ends_with_line_end() {
            return Err(
                self.wrong(format!("the last line has no end, so that its last number may lack digits: {CUT_OFF}"))
            );
        }
        let (bodies, errors) = (bodies.into_iter().flatten().collect(), errors.into_iter().collect());
        Ok(Some(Sample { t_s: t, bodies, errors }))
    }

    fn wrong(&self, reason: String) -> TrajectoryError {
        self.rows.content(reason).into()
    }
}
