//! Impacts with friction at one contact: the rod, the double pendulum, Painleve's rod, the super ball; and the energy
//! of a million random impacts.

use super::random_impacts::{RandomImpact, Rise};
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use polhode::response::RestitutionLaw::{self, ChatterjeeRuina, Newton, Poisson, Stronge, Whittaker};
use polhode::response::{
    CollisionMatrix, ContactProblem, FrictionalImpact, ImpactStatus, SingleFrictionalImpact, SlidingContact,
    SlidingForce,
};
use polhode_oracles::random::Random;
use std::error::Error;

/// Words of the reference values for the laws.
const LAWS: [(&str, RestitutionLaw); 4] =
    [("whittaker", Whittaker), ("newton", Newton), ("poisson", Poisson), ("stronge", Stronge)];

/// A body in a plane that hits a floor with one point.
struct PlanarBody<'a> {
    /// Inverse of the mass matrix of its generalised velocities.
    inverse_mass: Vec<f64>,
    /// Velocity of the point by generalised velocities: up, along.
    rows: [&'a [f64]; 2],
    /// Generalised velocities before.
    before: &'a [f64],
}

impl PlanarBody<'_> {
    /// The impact with `[mu, e]`, and the generalised velocities afterwards.
    fn strike(
        &self,
        [friction, restitution]: [f64; 2],
        law: RestitutionLaw,
    ) -> Result<(FrictionalImpact, Vec<f64>), Box<dyn Error>> {
        let mut problem = ContactProblem::new(self.before.len(), self.inverse_mass.clone())?;
        for row in self.rows {
            problem.push_row(&[(0, row)])?;
        }
        let delassus = problem.delassus();
        let u = problem.row_velocities(self.before)?;
        let collision = CollisionMatrix::planar(delassus.get(0, 0), delassus.get(0, 1), delassus.get(1, 1))?;
        let velocity_before = [u[0], u[1], 0.0];
        let impact = SingleFrictionalImpact { collision, velocity_before, friction, restitution, law };
        let outcome = impact.resolve()?;
        let change = problem.response(&outcome.impulse[..2])?;
        let after = self.before.iter().zip(change).map(|(before, change)| before + change).collect();
        Ok((outcome, after))
    }
}

/// A slender rod of 1 kg and 1 m at 45 degrees falls on its lower end.
pub(super) fn im_07(context: &Context) -> CaseResult {
    /// Moment of inertia, kg m^2.
    const INERTIA: f64 = 1.0 / 12.0;
    let arm = 0.5 * 0.5_f64.sqrt();
    let rod = PlanarBody {
        inverse_mass: vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 / INERTIA],
        rows: [&[0.0, 1.0, -arm], &[1.0, 0.0, arm]],
        before: &[0.6, -1.0, 0.0],
    };
    let kinetic = |v: &[f64]| 0.5 * (v[0] * v[0] + v[1] * v[1] + INERTIA * v[2] * v[2]);
    let mut rows = Vec::new();
    for friction in [0.0, 0.1, 0.5, 1.0] {
        for (name, law) in LAWS {
            let (outcome, after) = rod.strike([friction, 0.5], law)?;
            let ratio = kinetic(&after) / kinetic(rod.before);
            let found = [outcome.impulse[1], outcome.impulse[0], after[0], after[1], after[2], ratio];
            let quantity = format!("mu={friction}, {name}: p_t, p_n, vx', vy', w', T'/T");
            rows.push(context.reference.row("IM-07", &quantity, found)?);
        }
    }
    Ok(rows)
}

/// Kane and Levinson's double pendulum on a rough floor: Newton's law raises the energy, and says so.
pub(super) fn im_08(context: &Context) -> CaseResult {
    let (q1, q2) = (20.0_f64.to_radians(), 30.0_f64.to_radians());
    let coupling = 0.5 * libm::cos(q1 - q2);
    let mass = [4.0 / 3.0, coupling, coupling, 1.0 / 3.0];
    let determinant = mass[0] * mass[3] - mass[1] * mass[2];
    let pendulum = PlanarBody {
        inverse_mass: [mass[3], -mass[1], -mass[2], mass[0]].map(|entry| entry / determinant).to_vec(),
        rows: [&[libm::sin(q1), libm::sin(q2)], &[libm::cos(q1), libm::cos(q2)]],
        before: &[-0.1, -0.2],
    };
    let kinetic = |v: &[f64]| 0.5 * (mass[0] * v[0] * v[0] + mass[3] * v[1] * v[1]) + coupling * v[0] * v[1];
    let mut rows = Vec::new();
    let mut reported_right = true;
    for (restitution, friction) in [(0.5, 0.5), (0.7, 0.5), (0.5, 0.7), (1.0, 0.5)] {
        for (name, law) in LAWS {
            let (outcome, after) = pendulum.strike([friction, restitution], law)?;
            let ratio = kinetic(&after) / kinetic(pendulum.before);
            let found = [outcome.impulse[1], outcome.impulse[0], after[0], after[1], ratio];
            let quantity = format!("e={restitution}, mu={friction}, {name}: p_t,p_n,u1',u2',T'/T");
            rows.push(context.reference.row("IM-08", &quantity, found)?);
            reported_right &= outcome.energy_rises == (ratio > 1.0);
        }
    }
    rows.push(Row::exact("IM-08", "a gain of energy is reported, and nothing else", true, reported_right));
    Ok(rows)
}

/// Painleve's rod of 1 kg and 2 m, which slides on its lower end, pushed along by its upper one.
struct PainleveRod {
    sin: f64,
    cos: f64,
}

impl PainleveRod {
    fn at(theta: f64) -> Self {
        Self { sin: libm::sin(theta), cos: libm::cos(theta) }
    }

    fn collision(&self) -> Result<CollisionMatrix, Box<dyn Error>> {
        let Self { sin, cos } = *self;
        Ok(CollisionMatrix::planar(1.0 + 3.0 * cos * cos, -3.0 * sin * cos, 1.0 + 3.0 * sin * sin)?)
    }

    fn critical_friction(&self) -> Result<f64, Box<dyn Error>> {
        Ok(self.collision()?.critical_friction([-1.0, 0.0]).ok_or("no friction makes the rod jam")?)
    }

    /// The contact while the rod turns at this rate, rad/s.
    fn contact(&self, friction: f64, rate: f64) -> Result<SlidingContact, Box<dyn Error>> {
        let free_acceleration = rate * rate * self.sin - 9.81;
        Ok(SlidingContact { collision: self.collision()?, slip: [-1.0, 0.0], friction, free_acceleration })
    }
}

/// The argument in `[low, high]` at which a function changes its sign, by bisection.
fn sign_change(
    function: impl Fn(f64) -> Result<f64, Box<dyn Error>>,
    low: f64,
    high: f64,
) -> Result<f64, Box<dyn Error>> {
    let (mut low, mut high) = (low, high);
    let rises = function(high)? > 0.0;
    while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
        let middle = 0.5 * (low + high);
        if (function(middle)? > 0.0) == rises { high = middle } else { low = middle }
    }
    Ok(high)
}

/// Rounding of the impulse of a jam, relative: as the catalogue has it for the other quantities of the rod.
const JAM_ROUNDING: f64 = 1e-12;

/// Painleve's rod: when no finite force exists, and how an impulse without a collision resolves it.
pub(super) fn im_09(context: &Context) -> CaseResult {
    let reference = |quantity: &str, found: &[f64]| context.reference.row("IM-09", quantity, found.to_vec());
    let critical = |degrees: f64| PainleveRod::at(degrees.to_radians()).critical_friction();
    // Where the angles at the same factor above and below, in tan theta, have the same critical coefficient it is
    // least.
    let around = |tangent: f64| -> Result<f64, Box<dyn Error>> {
        let [above, below] = [1.5, 1.0 / 1.5].map(|factor| PainleveRod::at(libm::atan(factor * tangent)));
        Ok(above.critical_friction()? - below.critical_friction()?)
    };
    let least = libm::atan(sign_change(around, 1.0, 4.0)?);
    let mut rows = vec![
        reference(
            "least critical mu, its theta in deg",
            &[PainleveRod::at(least).critical_friction()?, least.to_degrees()],
        )?,
        reference("critical mu at 45, 60, 70 deg", &[critical(45.0)?, critical(60.0)?, critical(70.0)?])?,
    ];
    let rod = PainleveRod::at(60.0_f64.to_radians());
    let cases = [
        ("theta=60deg, mu=0.5, theta'=1: N/m, p", rod.contact(0.5, 1.0)?),
        ("theta=60deg, mu=1.5, theta'=1 (inconsistent): p, b", rod.contact(1.5, 1.0)?),
        ("theta=60deg, mu=1.5, theta'=4 (indeterminate): p, b, N/m", rod.contact(1.5, 4.0)?),
    ];
    for (quantity, contact) in cases {
        let (p, b) = (contact.normal_rate()?, contact.free_acceleration);
        let found = match contact.forces()? {
            SlidingForce::Regular(force) => vec![force, p],
            SlidingForce::Inconsistent => vec![p, b],
            SlidingForce::Indeterminate(force) => vec![p, b, force],
            SlidingForce::Separates => Vec::new(),
        };
        rows.push(reference(quantity, &found)?);
    }
    let excess = |degrees: f64| critical(degrees).map(|critical| 1.5 - critical);
    let interval = [sign_change(excess, 20.0, 60.0)?, sign_change(excess, 60.0, 85.0)?];
    rows.push(reference("theta interval with p<0 for mu=1.5 (deg)", &interval)?);
    let outcome = rod.contact(1.5, 1.0)?.impact_without_collision(0.0, Stronge)?;
    // The slip of 1 m/s stops after p_1 = 1 / |g|, having driven the rod down at |p| p_1; then it sticks.
    let [[nn, nt, _], [_, tt, _], _] = rod.collision()?.entries();
    let (first, stick) = (1.0 / (1.5 * tt + nt), nn - nt * nt / tt);
    let impulse = first - (nn + 1.5 * nt) * first / stick;
    let (quantity, tolerance) = ("impulse of the jam at theta=60deg, N s", Tolerance::Relative(JAM_ROUNDING));
    rows.push(Row::compared("IM-09", quantity, impulse, outcome.impulse[0], tolerance));
    rows.push(Row::at_most("IM-09", "slip and rebound after the jam, m/s", 0.0, outcome.velocity_after[1]));
    Ok(rows)
}

/// A solid sphere on a floor at e = 1: it sticks, it slips, and as a super ball it reverses its slip.
pub(super) fn im_10(context: &Context) -> CaseResult {
    /// More than enough to stick.
    const LARGE: f64 = 1e3;
    let sphere = PlanarBody {
        inverse_mass: vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.5],
        rows: [&[0.0, 1.0, 0.0], &[1.0, 0.0, 1.0]],
        before: &[1.0, -1.0, 0.0],
    };
    let cases = [
        ("mu=inf, e_t=0: vx', w'", LARGE, ChatterjeeRuina { tangential_restitution: 0.0 }),
        ("mu=0.1: vx', w'", 0.1, Stronge),
        ("Garwin e_t=1: vx', w'", LARGE, ChatterjeeRuina { tangential_restitution: 1.0 }),
    ];
    let mut rows = Vec::new();
    for (quantity, friction, law) in cases {
        let (_, after) = sphere.strike([friction, 1.0], law)?;
        rows.push(context.reference.row("IM-10", quantity, [after[0], after[2]])?);
    }
    Ok(rows)
}

/// Random impacts with friction of 1 to 8 contacts.
const RANDOM_IMPACTS: usize = 1_000_000;
/// Seeds whose sequences leave nothing but rounding, which contradicted itself at redundant contacts: they had no
/// answer.
const ENDS_IN_ROUNDING: [u64; 5] = [28_032, 141_340, 321_944, 333_660, 355_636];
/// A rise of energy that is rounding, relative to the energy before: cone problems are solved to some 1e-13.
const RISE: f64 = 1e-11;

/// No impact raises the energy beyond rounding; Newton's law does, and says so.
pub(super) fn energy(context: &Context) -> CaseResult {
    const CASE: &str = "frictional impacts";
    let count = context.amount.of(RANDOM_IMPACTS);
    let mut worst = [Rise::default(); 3];
    let (mut newton_rises, mut newton_silent, mut in_order, mut not_solved) = (0_u64, 0_u64, 0_u64, 0_u64);
    for seed in (0..count as u64).chain(ENDS_IN_ROUNDING) {
        let impact = RandomImpact::new(&mut Random(seed));
        let single = impact.contacts() == 1;
        let (rise, outcome) = impact.strike(seed)?;
        let group = if single { 0 } else { usize::from(outcome.applications > 0) + 1 };
        worst[group].include(rise, seed);
        in_order += u64::from(outcome.status == ImpactStatus::StruckInOrder);
        not_solved += u64::from(outcome.status == ImpactStatus::NotSolved);
        if single {
            let (rise, outcome) = impact.strike_by_newton()?;
            newton_rises += u64::from(rise > RISE);
            newton_silent += u64::from(rise > RISE && !outcome.energy_rises);
        }
    }
    let kinds = ["one contact", "several contacts, together", "several contacts, in order"];
    let mut rows: Vec<Row> = kinds
        .iter()
        .zip(worst)
        .map(|(kind, worst)| {
            let quantity = format!("largest rise of energy, of the energy before: {kind} ({count} impacts)");
            let mut row = Row::at_most(CASE, &quantity, RISE, worst.amount);
            row.note = Some(format!("seed {}", worst.seed));
            row
        })
        .collect();
    rows.push(Row::exact(CASE, "rises by Newton's law that were not reported", 0_u64, newton_silent));
    rows.push(Row::info(CASE, "rises by Newton's law, all reported", 0_u64, newton_rises));
    rows.push(Row::exact(CASE, "impacts without an answer", 0_u64, not_solved));
    rows.push(Row::info(CASE, "impacts whose cone problem was not solved, struck in order", 0_u64, in_order));
    Ok(rows)
}
