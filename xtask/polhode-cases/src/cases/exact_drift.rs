//! The exact free rotation by itself: hard cases computed to 40 digits, and many samples of one flight.
//!
//! The fixture's header says what its columns are and what is expected: within a turn of 10 rad absolute errors, beyond
//! it errors relative to what one rounding of the inputs changes.

use super::motion::{angle_between, angular_momentum};
use super::{CaseResult, Context};
use crate::row::Row;
use glam::{DQuat, DVec3};
use polhode::BodySample;
use polhode::dynamics::exact_rotation::drift;
use polhode::dynamics::{Flight, RigidBody};
use polhode::spatial::{Inertia, Mass, MassProperties, Motion, Pose, Rotation, Velocity};
use std::collections::BTreeMap;
use std::error::Error;

/// Name of both cases.
const CASE: &str = "exact drift";
/// Largest error of attitude, rad, in a turn of 10 rad: of a generic body, of any.
const ATTITUDE: [f64; 2] = [5e-14, 1e-13];
/// Largest error of momentum in body axes, relative to its length, in a turn of 10 rad.
const MOMENTUM: f64 = 5e-14;
/// Largest error in longer times, in roundings (2^-53) times the condition number.
const PER_CONDITION: f64 = 4.0;
/// Least condition number of the momentum, which is seen through the rounded attitude.
const SEEN_THROUGH_ATTITUDE: f64 = 4.0;
/// Largest relative change of energy and momentum over a million samples.
const CONSERVATION: f64 = 1e-12;

/// One line of the fixture.
#[derive(Debug)]
pub(crate) struct Hard {
    /// The kind of body.
    pub(crate) kind: String,
    is_long: bool,
    /// Principal moments, kg m^2.
    pub(crate) moments: DVec3,
    /// Angular momentum in body axes at the start, kg m^2/s.
    pub(crate) momentum: DVec3,
    /// May be negative, s.
    pub(crate) time: f64,
    /// After that time, from the identity.
    pub(crate) attitude: Rotation,
    momentum_then: DVec3,
    /// Condition numbers of attitude and momentum.
    condition: [f64; 2],
}

impl Hard {
    pub(crate) fn parse(line: &str) -> Result<Self, Box<dyn Error>> {
        let mut fields = line.split(',');
        let mut word = || fields.next().ok_or_else(|| format!("too few columns: {line}"));
        let (kind, span) = (word()?.to_owned(), word()?.to_owned());
        let numbers = fields.map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let [a, b, c, l, m, n, time, qw, qx, qy, qz, x, y, z, of_attitude, of_momentum] = numbers[..] else {
            return Err(format!("{} numbers instead of 16: {line}", numbers.len()).into());
        };
        Ok(Self {
            kind,
            is_long: span == "long",
            moments: DVec3::new(a, b, c),
            momentum: DVec3::new(l, m, n),
            time,
            attitude: Rotation::renormalized(DQuat::from_xyzw(qx, qy, qz, qw)),
            momentum_then: DVec3::new(x, y, z),
            condition: [of_attitude, of_momentum],
        })
    }

    /// Errors of attitude (rad) and momentum (relative); for a long time both in roundings times the condition number.
    fn errors(&self) -> [f64; 2] {
        let found = drift(self.moments, Rotation::IDENTITY, self.momentum, self.time);
        let momentum = found.inverse_rotate(self.momentum);
        let errors = [found.angle_to(self.attitude), (momentum - self.momentum_then).length() / self.momentum.length()];
        if self.is_long {
            let condition = [self.condition[0], self.condition[1].max(SEEN_THROUGH_ATTITUDE)];
            [0, 1].map(|k| errors[k] / (0.5 * f64::EPSILON * condition[k]))
        } else {
            errors
        }
    }
}

/// The worst errors of each kind of hard case.
pub(super) fn hard_cases(context: &Context) -> CaseResult {
    let path = context.root.join("fixtures/reference/free_rotation/hard_cases.csv");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut worst: BTreeMap<(bool, String), (usize, [f64; 2])> = BTreeMap::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let hard = Hard::parse(line)?;
        let errors = hard.errors();
        let (count, most) = worst.entry((hard.is_long, hard.kind)).or_insert((0, [0.0; 2]));
        *count += 1;
        // A NaN is the worst of all.
        *most = [0, 1].map(|k| if errors[k] <= most[k] { most[k] } else { errors[k] });
    }
    let mut rows = Vec::new();
    for ((is_long, kind), (count, [attitude, momentum])) in worst {
        if is_long {
            let name = |what: &str| format!("{kind}, long, {count} cases: {what}, 2^-53 x condition");
            rows.push(Row::at_most(CASE, &name("attitude"), PER_CONDITION, attitude));
            rows.push(Row::at_most(CASE, &name("momentum"), PER_CONDITION, momentum));
        } else {
            let limit = ATTITUDE[usize::from(kind != "Generic")];
            let name = |what: &str| format!("{kind}, short, {count} cases: {what}");
            rows.push(Row::at_most(CASE, &name("attitude, rad"), limit, attitude));
            rows.push(Row::at_most(CASE, &name("momentum, relative"), MOMENTUM, momentum));
        }
    }
    Ok(rows)
}

/// Energy and angular momentum in a million samples of one flight.
pub(super) fn samples(context: &Context) -> CaseResult {
    /// Samples at full count.
    const SAMPLES: usize = 1_000_000;
    let moments = DVec3::new(1.0, 2.0, 3.0);
    let count = context.amount.of(SAMPLES);
    let properties = MassProperties::new(Mass::new(1.0)?, DVec3::ZERO, Inertia::from_diagonal(moments)?);
    let body = RigidBody::new(&properties);
    let mut rows = Vec::new();
    for (name, spin, duration) in [("FR-02", DVec3::new(0.01, 2.0, 0.01), 100.0), ("FR-04", DVec3::ONE, 1000.0)] {
        let start = body.at_velocity(Pose::IDENTITY, Velocity::new(DVec3::ZERO, spin));
        let flight = Flight::new(&body, 0.0, &start, DVec3::ZERO);
        let (energy, momentum) = (body.rotational_energy(&start), moments * spin);
        let mut most = [0.0f64; 3];
        for sample in 0..=count {
            let t = duration * sample as f64 / count as f64;
            let state = flight.state(t);
            let seen = BodySample { pose: state.pose, velocity: flight.velocity(t) };
            let found = angular_momentum(moments, &seen);
            let errors = [
                (body.rotational_energy(&state) / energy - 1.0).abs(),
                (found.length() / momentum.length() - 1.0).abs(),
                angle_between(found, momentum),
            ];
            most = [0, 1, 2].map(|k| if errors[k] <= most[k] { most[k] } else { errors[k] });
        }
        for (what, most) in ["energy, relative", "|L|, relative", "direction of L, rad"].iter().zip(most) {
            rows.push(Row::at_most(CASE, &format!("{name}, {count} samples: {what}"), CONSERVATION, most));
        }
    }
    Ok(rows)
}
