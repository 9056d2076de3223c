//! Effects of friction besides sticking and sliding, in the scenes that show them, each against its closed form.
//!
//! | scene | what is known |
//! |---|---|
//! | Painleve's rod | the impulse of the jam: the path of an impact without a collision, in closed form |
//! | rolling balls | stop after `v^2/2a` with `a = c g/(R (1 + k))`; one that spins after `k R^2 w/(c g)` |
//! | super ball | with a backspin of `2.5 v/R` its first bounce reverses speed and spin (Garwin 1969) |

use super::bodies::GRAVITY;
use super::{CaseResult, Context};
use crate::row::{Row, Tolerance};
use polhode::EventKind;

const CASE: &str = "effects of friction";

/// Tolerance of impulses, places, times and velocities, relative: that of steps of the tier.
const RELATIVE: f64 = 1e-9;

/// Moment of inertia of a ball over `m R^2`.
const BALL: f64 = 0.4;

/// All rows.
pub(super) fn rows(context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for part in [painleve_rod, rolling_balls, super_ball] {
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
    let jammed: Vec<String> = jams.iter().map(|event| run.report.bodies[event.body_a.max(1)].0.clone()).collect();
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
    let rest = rests.iter().find(|event| run.report.bodies[event.body_a].0 == "spinning");
    let measured = rest.map_or(f64::NAN, |event| event.t);
    let quantity = "rolling-balls, spinning: when it stops, s";
    rows.push(Row::compared(CASE, quantity, expected, measured, Tolerance::Relative(RELATIVE)));
    Ok(rows)
}

/// The super ball after its first bounce.
fn super_ball(context: &Context) -> CaseResult {
    let run = context.shipped.run("super-ball")?;
    let bounces = run.events(EventKind::Impact);
    let [first, second, ..] = bounces.as_slice() else { return Err("super-ball: it does not bounce twice".into()) };
    let between = |t: f64| t > first.t && t < second.t;
    let sample = run.record.times.iter().position(|&t| between(t)).ok_or("super-ball: no sample between bounces")?;
    let ball = run.scene.bodies().iter().position(|body| body.name() == "ball").ok_or("super-ball: no ball")?;
    let velocity = run.record.samples[sample][ball].velocity;
    let tolerance = Tolerance::Relative(RELATIVE);
    Ok(vec![
        Row::compared(CASE, "super-ball: speed after a bounce, m/s", -0.5, velocity.linear.x, tolerance),
        Row::compared(CASE, "super-ball: spin after a bounce, rad/s", 25.0, velocity.angular.y, tolerance),
    ])
}
