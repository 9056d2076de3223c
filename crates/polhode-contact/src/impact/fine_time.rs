//! Times of impact that are more accurate than the rounded poses.
//!
//! A separation is computed from poses with rounded positions: the rounding is 5.5e-17 m at 0.5 m from the origin. This
//! is not always negligible: a body that bounces to a height of 4 um gains or loses 1.5e-11 of this height at every
//! bounce.
//!
//! A motion in closed form can give the rounding error of its pose ([`Motion::residue`]). With it the gap along a
//! contact normal is `separation + n . (residue of A - residue of B)`, and Newton's method finds its root. Two errors
//! remain: the rounding of the separation's own arithmetic (none for a ball on a floor through the origin), and that of
//! the time.

use crate::Shape;
use crate::narrow_phase::dispatch::manifold::manifold;
use crate::narrow_phase::terms::evaluate::kinematics;
use polhode_spatial::Motion;

/// Largest number of Newton steps. Each squares the relative error, which is about 1e-13 at the start.
const MOST_STEPS: usize = 4;

/// The contact whose separation reaches zero first.
struct Closing {
    /// s.
    t: f64,
    /// m.
    gap: f64,
    /// m/s, negative.
    rate: f64,
}

impl Closing {
    /// The time at which its separation reaches zero at this rate, s.
    fn time(&self) -> f64 {
        self.t - self.gap / self.rate
    }
}

/// The time near `t` in `(start, end]` (s) at which the separation of a contact of a pair within `reach` (m) reaches
/// zero; `t` itself where motions give no residues, no contact approaches, or no time near it is better.
pub(crate) fn refined(
    shapes: [&Shape; 2],
    motions: [&dyn Motion; 2],
    (start, t, end): (f64, f64, f64),
    reach: f64,
) -> f64 {
    let Some(mut best) = first_closing(shapes, motions, t, reach) else { return t };
    for _ in 0..MOST_STEPS {
        let next = best.time();
        if !(next > start && next <= end) || next == best.t {
            break;
        }
        match first_closing(shapes, motions, next, reach) {
            Some(closing) if closing.gap.abs() < best.gap.abs() => best = closing,
            _ => break,
        }
    }
    best.t
}

fn first_closing(shapes: [&Shape; 2], motions: [&dyn Motion; 2], t: f64, reach: f64) -> Option<Closing> {
    let residue = motions[0].residue(t)? - motions[1].residue(t)?;
    let (poses, velocities) = (motions.map(|motion| motion.pose(t)), motions.map(|motion| motion.velocity(t)));
    let [a, b] = shapes;
    let closing = |contact: &crate::Contact| {
        let measured = kinematics(contact.feature, a, &poses[0], &velocities[0], b, &poses[1], &velocities[1])?;
        let gap = measured.geometry.separation + measured.geometry.normal.dot(residue);
        let rate = measured.separation_rate;
        (rate < 0.0).then_some(Closing { t, gap, rate })
    };
    let found = manifold(a, &poses[0], b, &poses[1], reach);
    found.contacts.iter().filter_map(closing).min_by(|x, y| x.time().total_cmp(&y.time()))
}
