//! Restitution that depends on the speed of approach.
//!
//! | law | `e(v)` | for |
//! |---|---|---|
//! | [`RestitutionSpeed::Constant`] | `e` | small ranges of speed |
//! | [`RestitutionSpeed::Yield`] | `e` up to `v_y`, `e (v/v_y)^(-1/4)` above | metals: Johnson's plastic impact |
//! | [`RestitutionSpeed::Slope`] | `e - a v`, not below 0 | a line through measured points |
//!
//! with the speed of approach `v` (m/s), the yield speed `v_y` (m/s) and the slope `a` (s/m). None rises with speed,
//! and all stay in [0, 1], so that no impact gains energy. Of two materials the larger value at the speed counts, as
//! without speed.
//!
//! Assumption: the speed is that of each contact along its normal at the beginning of the impact. Fails where bodies
//! that hit at several contacts share their speed unevenly: each contact has the restitution of its own.
//!
//! Source: Johnson 1985, section 11.5 (the exponent -1/4).

use super::SceneError;

/// Exponent of restitution above the yield speed (Johnson).
const PLASTIC_EXPONENT: f64 = -0.25;

/// How restitution depends on speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub enum RestitutionSpeed {
    /// Not at all.
    #[default]
    Constant,
    /// It falls with the power -1/4 of the speed above this one, m/s.
    Yield(f64),
    /// It falls by this for each metre a second, s/m.
    Slope(f64),
}

/// A coefficient and its dependence on speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct OneRestitution {
    slow: f64,
    speed: RestitutionSpeed,
}

impl OneRestitution {
    fn at(self, speed: f64) -> f64 {
        let speed = speed.max(0.0);
        match self.speed {
            RestitutionSpeed::Constant => self.slow,
            RestitutionSpeed::Yield(limit) if speed <= limit => self.slow,
            RestitutionSpeed::Yield(limit) => self.slow * libm::pow(speed / limit, PLASTIC_EXPONENT),
            RestitutionSpeed::Slope(slope) => (self.slow - slope * speed).max(0.0),
        }
    }
}

/// The restitution of a material, or of two that meet: the larger one at the speed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Restitution([OneRestitution; 2]);

impl Restitution {
    /// This coefficient at every speed.
    pub(super) fn constant(slow: f64) -> Self {
        Self([OneRestitution { slow, speed: RestitutionSpeed::Constant }, OneRestitution::default()])
    }

    /// The same with a dependence on speed.
    ///
    /// # Errors
    /// When the yield speed is not positive, or the slope would let restitution rise.
    pub(super) fn with_speed(self, material: &str, speed: RestitutionSpeed) -> Result<Self, SceneError> {
        let refused = |quantity, value, accepted| {
            Err(SceneError::RestitutionSpeed { material: material.to_owned(), quantity, value, accepted })
        };
        match speed {
            RestitutionSpeed::Yield(limit) if !(limit > 0.0 && limit.is_finite()) => {
                refused("restitution_yield_speed", limit, "a finite number above 0, m/s")
            }
            RestitutionSpeed::Slope(slope) if !(slope >= 0.0 && slope.is_finite()) => refused(
                "restitution_slope",
                slope,
                "a finite number of at least 0, s/m: restitution must not rise with speed",
            ),
            _ => Ok(Self([OneRestitution { speed, ..self.0[0] }, self.0[1]])),
        }
    }

    /// Of two materials that meet.
    pub(super) fn combined(self, other: Self) -> Self {
        let [a, b] = [self.0[0], other.0[0]];
        if a.speed == RestitutionSpeed::Constant && b.speed == RestitutionSpeed::Constant {
            return Self::constant(a.slow.max(b.slow));
        }
        Self([a, b])
    }

    /// At a speed of approach, m/s.
    pub(crate) fn at(self, speed: f64) -> f64 {
        self.0[0].at(speed).max(self.0[1].at(speed))
    }

    /// Of slow impacts: the largest.
    pub(crate) fn slow(self) -> f64 {
        self.0[0].slow.max(self.0[1].slow)
    }

    /// All numbers, so that two can be told apart.
    pub(super) fn numbers(self) -> [f64; 6] {
        let [a, b] = self.0.map(|one| match one.speed {
            RestitutionSpeed::Constant => [one.slow, 0.0, 0.0],
            RestitutionSpeed::Yield(limit) => [one.slow, limit, 0.0],
            RestitutionSpeed::Slope(slope) => [one.slow, 0.0, slope],
        });
        [a[0], a[1], a[2], b[0], b[1], b[2]]
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
mod tests {
    //! The laws have their values, never rise, and refuse numbers with which they would.
    use super::*;

    #[test]
    fn restitution_falls_with_speed() {
        let metal = Restitution::constant(0.8).with_speed("metal", RestitutionSpeed::Yield(0.5)).unwrap();
        assert_eq!([metal.at(0.0), metal.at(0.5)], [0.8, 0.8]);
        assert!((metal.at(8.0) - 0.4).abs() < 1e-15);
        let line = Restitution::constant(0.9).with_speed("line", RestitutionSpeed::Slope(0.25)).unwrap();
        assert!((line.at(2.0) - 0.4).abs() < 1e-15);
        assert_eq!(line.at(1e9), 0.0);
        // The larger of two at each speed: the line first, the metal later.
        let both = line.combined(metal);
        assert_eq!([both.at(0.0), both.at(8.0)], [0.9, metal.at(8.0)]);
        assert_eq!(both.slow(), 0.9);
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(Restitution::constant(0.5).with_speed("bad", RestitutionSpeed::Slope(bad)).is_err());
            assert!(Restitution::constant(0.5).with_speed("bad", RestitutionSpeed::Yield(bad)).is_err());
        }
    }
}
