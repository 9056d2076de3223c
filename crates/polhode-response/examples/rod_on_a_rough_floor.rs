//! A slender rod falls on its lower end, at 45 degrees, on a floor with friction: what the contact does in the short
//! time of the impact, and how much each law of restitution gives back.

use polhode_response::{CollisionMatrix, RestitutionLaw, SingleFrictionalImpact};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // 1 kg and 1 m: along the normal 1/m + x^2/I, along the floor 1/m + y^2/I, and what couples the two.
    let collision = CollisionMatrix::planar(2.5, -1.5, 2.5)?;
    for law in [RestitutionLaw::Newton, RestitutionLaw::Poisson, RestitutionLaw::Stronge] {
        let velocity_before = [-1.0, 0.6, 0.0];
        let impact = SingleFrictionalImpact { collision, velocity_before, friction: 0.5, restitution: 0.5, law };
        let outcome = impact.resolve()?;
        let rebound = outcome.velocity_after[0];
        println!("{law:?}: leaves at {rebound:.4} m/s, energy changed by {:.4} J", outcome.energy_change);
        for phase in &outcome.phases {
            println!("  {:?} for {:.4} N s", phase.kind, phase.normal_impulse);
        }
        assert!(outcome.energy_change < 0.0);
    }
    Ok(())
}
