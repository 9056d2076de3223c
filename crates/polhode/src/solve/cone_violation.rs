//! How far forces or impulses of contacts are from Coulomb's law.
//!
//! The violation of a contact with the normal force `f_n` and the tangential force `f_t` is the larger of
//! `|f_t| - mu max(f_n, 0)` and `-f_n`, relative to the largest force of its problem (no unit). It is zero to rounding
//! for a contact that obeys the law, also where `f_n = 0`: such a contact bears no tangential force. With a grain
//! `|f_t|` is the length in units of the largest coefficient (`collision/friction_ellipse.rs`).

/// Most that forces and impulses may violate Coulomb's law by, relative to the largest of their problem (no unit, 1e-6
/// to 1e-4). Time steps solve for impulses to a tenth of it. Where a face bears just what friction allows, the least
/// change that takes out what a solver left may carry one of its contacts beyond its cone by
/// some 1e-6, although all of them together bear the load.
pub(crate) const CONE_LIMIT: f64 = 1e-5;

/// The violation of a pair of bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ConeViolation {
    /// Relative to the largest force (no unit).
    pub(crate) value: f64,
    pub(crate) pair: (usize, usize),
}

impl ConeViolation {
    /// The larger one.
    pub(crate) fn larger(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        match (one, other) {
            (Some(one), Some(other)) => Some(if other.value > one.value { other } else { one }),
            (one, other) => one.or(other),
        }
    }
}

/// The force or impulse at a contact with friction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RubbingForce {
    pub(crate) pair: (usize, usize),
    /// N, N s.
    pub(crate) normal: f64,
    /// Its length in units of the largest coefficient, N, N s.
    pub(crate) tangential: f64,
    /// The largest coefficient.
    pub(crate) friction: f64,
}

impl RubbingForce {
    /// How far it is outside the cone, N, N s.
    fn excess(&self) -> f64 {
        (self.tangential - self.friction * self.normal.max(0.0)).max(-self.normal)
    }
}

/// The largest violation of some contacts; `scale` is a force (N, N s) that the largest of theirs counts as at least.
/// None if all obey the law exactly.
pub(crate) fn largest_violation(
    forces: impl Iterator<Item = RubbingForce> + Clone,
    scale: f64,
) -> Option<ConeViolation> {
    let scale = forces.clone().fold(scale, |most, force| most.max(force.normal.abs()).max(force.tangential));
    let violation = |force: RubbingForce| ConeViolation { value: force.excess() / scale, pair: force.pair };
    let beyond = forces.filter(|force| force.excess() > 0.0).map(violation);
    beyond.fold(None, |worst, one| ConeViolation::larger(worst, Some(one)))
}

#[cfg(test)]
mod tests {
    use super::{RubbingForce, largest_violation};

    /// What touches without pressing bears no tangential force: any is a violation, of the size of the force itself.
    /// Within the cone, and at its edge, there is none.
    #[test]
    fn a_force_along_the_surface_without_one_against_it_is_a_violation() {
        let force = |normal: f64, tangential: f64| RubbingForce { pair: (0, 1), normal, tangential, friction: 0.5 };
        let violation = |forces: &[RubbingForce]| largest_violation(forces.iter().copied(), 0.0).map(|one| one.value);
        assert_eq!(violation(&[force(0.0, 9.81)]), Some(1.0));
        assert_eq!(violation(&[force(-2.0, 0.0), force(4.0, 2.0)]), Some(0.5));
        assert_eq!(violation(&[force(2.0, 1.0), force(0.0, 0.0), force(2.0, 0.3)]), None);
    }
}
