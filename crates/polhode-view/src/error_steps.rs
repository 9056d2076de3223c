//! The estimated errors of bodies over the time of a page.
//!
//! They change where a run was compared with its references, some hundred times, and are kept from change to change.

use crate::text;
use polhode::BodyError;
use serde_json::{Value, json};

/// Numbers of a body: the error of its position (m) and of its attitude (rad).
const OF_BODY: usize = 2;

/// The errors of the bodies that move, from change to change.
#[derive(Debug, Default)]
pub(crate) struct ErrorSteps {
    /// When they change, s.
    times: Vec<f64>,
    /// Those of each time after those of another; not a number where they are not known.
    values: Vec<f64>,
}

impl ErrorSteps {
    /// Adds those of a sample at `t` (s), of these bodies.
    pub(crate) fn add(&mut self, t: f64, errors: Option<&[BodyError]>, moving: &[usize]) {
        let of_body = |&body: &usize| {
            let error = errors.and_then(|errors| errors.get(body));
            error.map_or([f64::NAN; OF_BODY], |error| [error.position_m, error.rotation_rad])
        };
        let now: Vec<f64> = moving.iter().flat_map(of_body).collect();
        let last = self.values.len().saturating_sub(now.len());
        let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        if self.times.is_empty() || bits(&self.values[last..]) != bits(&now) {
            self.times.push(t);
            self.values.extend(now);
        }
    }

    /// As the viewer reads them; null where none is known.
    pub(crate) fn json(&self) -> Value {
        if self.values.iter().all(|number| number.is_nan()) {
            return Value::Null;
        }
        json!({ "times": text::base64_f64(&self.times), "values": text::base64_f32(self.values.iter().copied()) })
    }
}

#[cfg(test)]
mod tests {
    //! Errors are kept where they change, and a run without any has none.
    use super::*;

    #[test]
    fn errors_are_kept_where_they_change() {
        let mut steps = ErrorSteps::default();
        assert_eq!(steps.json(), Value::Null);
        let [small, large] = [[BodyError::new(1.0, 2.0); 3], [BodyError::new(3.0, 4.0); 3]];
        for (t, errors) in [(0.0, Some(&small)), (1.0, Some(&small)), (2.0, Some(&large)), (3.0, None), (4.0, None)] {
            steps.add(t, errors.map(<[_; 3]>::as_slice), &[0, 2]);
        }
        assert_eq!(steps.times, [0.0, 2.0, 3.0]);
        assert_eq!(steps.values[..8], [1.0, 2.0, 1.0, 2.0, 3.0, 4.0, 3.0, 4.0]);
        assert!(steps.values[8..].iter().all(|number| number.is_nan()) && steps.values.len() == 12);
    }
}
