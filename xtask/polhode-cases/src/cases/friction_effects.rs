//! Effects of friction besides sticking and sliding, in the scenes that show them, each against its closed form.
//!
//! | scene | what is known |
//! |---|---|
//! | Painleve's rod | the impulse of the jam: the path of an impact without a collision, in closed form |
//! | rolling balls | stop after `v^2/2a` with `a = c g/(R (1 + k))`; one that spins after `k R^2 w/(c g)` |
//! | rods that fall | Newton's law raises the energy by what Whittaker's algebra says, Stronge's never |
//! | sledges | one slides with `g (sin a - mu_1 cos a)`, one stays, one turns as the equations of the ellipse say |
//! | super ball | with a backspin of `2.5 v/R` its first bounce reverses speed and spin (Garwin 1969) |

use super::bodies::GRAVITY;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use polhode::EventKind;

const CASE: &str = "effects of friction";

/// Tolerance of impulses, places, times and velocities, relative: that of steps of the tier.
const RELATIVE: f64 = 1e-9;

/// Tolerance of ways of sledges, m: that of steps of the tier.
const PLACE_M: f64 = 1e-9;

/// Steps of the Runge-Kutta method that ways are compared with: its error is some 1e-13 m.
const ORACLE_STEPS: u32 = 200_000;

/// Moment of inertia of a ball over `m R^2`.
const BALL: f64 = 0.4;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for part in [painleve_rod, rolling_balls, super_ball, falling_rods, sledges] {
        rows.extend(part(context)?);
    }
    Ok(rows)
}

/// Painleve's rod: the rough one jams once, at once.
fn painleve_rod(context: &Context) -> CaseResult {
    let run = context.shipped.run("painleve-rod")?;
    let (friction, moment) = (1.5, 1.0 / 3.0);
    // The arm from the contact to the centre of mass.
    let (x, z) = (0.98 * 0.5, 0.98 * 0.75f64.sqrt() + 0.02);
    let (normal, coupling, along) = (1.0 + x * x / moment, x * z / moment, 1.0 + z * z / moment);
    let stop = 1.0 / (friction * along - coupling);
    let sinking = (friction * coupling - normal) * stop;
    let impulse = stop + sinking / (normal - coupling * coupling / along);
    let jams = run.events(EventKind::Jam);
    let jammed: Vec<String> =
        jams.iter().map(|event| run.report.bodies[event.body_a.index().max(1)].name.clone()).collect();
    let measured = jams.first().map_or(f64::NAN, |event| event.impulse);
    Ok(vec![
        Row::exact(CASE, "painleve-rod: which rods jam", "rough", jammed.join(", ")),
        Row::compared(CASE, "painleve-rod: impulse of the jam, N s", impulse, measured, Tolerance::Relative(RELATIVE)),
    ])
}

/// Balls that roll to a halt, and one that stops spinning.
fn rolling_balls(context: &Context) -> CaseResult {
    let run = context.shipped.run("rolling-balls")?;
    let (radius, speed, spin) = (0.1, 1.0, 20.0);
    let deceleration = |friction: f64| friction * GRAVITY / (radius * (1.0 + BALL));
    let mut rows = Vec::new();
    for (name, friction) in [("on felt", 0.005), ("on grass", 0.01)] {
        let expected = speed * speed / (2.0 * deceleration(friction));
        let quantity = format!("rolling-balls, {name}: where it stops, m");
        let measured = run.last(name)?.pose.translation.x;
        rows.push(Row::compared(CASE, &quantity, expected, measured, Tolerance::Relative(RELATIVE)));
    }
    let expected = BALL * radius * radius * spin / (0.005 * GRAVITY);
    let rests = run.events(EventKind::Rest);
    let rest = rests.iter().find(|event| run.report.bodies[event.body_a.index()].name == "spinning");
    let measured = rest.map_or(f64::NAN, |event| event.t_s);
    let quantity = "rolling-balls, spinning: when it stops, s";
    rows.push(Row::compared(CASE, quantity, expected, measured, Tolerance::Relative(RELATIVE)));
    Ok(rows)
}

/// The super ball after its first bounce.
fn super_ball(context: &Context) -> CaseResult {
    let run = context.shipped.run("super-ball")?;
    let bounces = run.events(EventKind::Impact);
    let [first, second, ..] = bounces.as_slice() else { return Err("super-ball: it does not bounce twice".into()) };
    let between = |t: f64| t > first.t_s && t < second.t_s;
    let sample = run.record.times_s.iter().position(|&t| between(t)).ok_or("super-ball: no sample between bounces")?;
    let ball = run.scene.bodies().iter().position(|body| body.name() == "ball").ok_or("super-ball: no ball")?;
    let velocity = run.record.samples[sample][ball].velocity;
    let tolerance = Tolerance::Relative(RELATIVE);
    Ok(vec![
        Row::compared(CASE, "super-ball: speed after a bounce, m/s", -0.5, velocity.linear.x, tolerance),
        Row::compared(CASE, "super-ball: spin after a bounce, rad/s", 25.0, velocity.angular.y, tolerance),
    ])
}

/// Rods that fall and slip: the change of energy of the impact by either law, and the warning.
fn falling_rods(context: &Context) -> CaseResult {
    let (moment, slip) = (1.0 / 3.0, 0.6);
    let (x, z) = (0.98 * 0.5f64.sqrt(), 0.98 * 0.5f64.sqrt() + 0.02);
    let (normal, coupling, along) = (1.0 + x * x / moment, x * z / moment, 1.0 + z * z / moment);
    // The impulses that stop the slip and reverse the normal velocity, -1 m/s, by their algebra.
    let tangential = (2.0 * coupling - normal * slip) / (normal * along - coupling * coupling);
    let mut rows = Vec::new();
    for (scene, gain) in [("rod-newton", Some(0.5 * tangential * slip)), ("rod-stronge", None)] {
        let run = context.shipped.run(scene)?;
        let lost = run.report.ledger.impact.value() + run.report.ledger.friction.value();
        let warns = run.report.warnings.iter().any(|warning| warning.contains("has raised the energy"));
        rows.push(Row::exact(CASE, &format!("{scene}: the report warns"), gain.is_some(), warns));
        rows.push(match gain {
            Some(gain) => {
                let quantity = format!("{scene}: energy gained at the impact, J");
                Row::compared(CASE, &quantity, gain, -lost, Tolerance::Relative(RELATIVE))
            }
            None => Row::exact(CASE, &format!("{scene}: no energy is gained"), true, lost >= 0.0),
        });
    }
    Ok(rows)
}

/// Sledges: places at the end.
fn sledges(context: &Context) -> CaseResult {
    let run = context.shipped.run("sledges")?;
    let (angle, t) = (20f64.to_radians(), run.report.duration_s);
    let (sin, cos) = (angle.sin(), angle.cos());
    let moved = |name: &str| -> Result<[f64; 2], Box<dyn std::error::Error>> {
        let start = run.scene.bodies().iter().find(|body| body.name() == name).ok_or("sledges: no such sledge")?;
        let moved = run.last(name)?.pose.translation - start.initial_pose().translation;
        Ok([moved.x * cos - moved.z * sin, moved.y])
    };
    let straight = 0.5 * GRAVITY * (sin - 0.1 * cos) * t * t;
    let [pushed_down, pushed_across] = deflected([0.0, 2.5], t, |[u, v]| {
        let (x, y) = (0.1 * u, 0.6 * v);
        let share = GRAVITY * cos / (x * x + y * y).sqrt();
        [GRAVITY * sin - share * 0.1 * x, -share * 0.6 * y]
    });
    let place = Tolerance::Absolute(PLACE_M);
    Ok(vec![
        Row::compared(CASE, "sledges, downhill: way, m", [straight, 0.0], moved("downhill")?, place),
        Row::compared(CASE, "sledges, across: way, m", [0.0, 0.0], moved("across")?, Tolerance::Exact),
        Row::compared(CASE, "sledges, pushed: way, m", [pushed_down, pushed_across], moved("pushed")?, place),
    ])
}

/// The way of a point with this velocity and rate of velocity after `t` (s), by many steps of the classical Runge-Kutta
/// method.
fn deflected(mut v: [f64; 2], t: f64, rate: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let h = t / f64::from(ORACLE_STEPS);
    let add = |x: [f64; 2], y: [f64; 2], h: f64| [x[0] + y[0] * h, x[1] + y[1] * h];
    let mut x = [0.0; 2];
    for _ in 0..ORACLE_STEPS {
        let a = rate(v);
        let b = rate(add(v, a, 0.5 * h));
        let c = rate(add(v, b, 0.5 * h));
        let d = rate(add(v, c, h));
        for k in 0..2 {
            x[k] += h * (v[k] + h / 6.0 * (a[k] + b[k] + c[k]));
            v[k] += h / 6.0 * (a[k] + 2.0 * (b[k] + c[k]) + d[k]);
        }
    }
    x
}
