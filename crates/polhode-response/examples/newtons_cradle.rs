//! Newton's cradle: five balls in a row that touch, of which the first is moving. Each impact law has its own answer.

use polhode_response::{ComplementaritySolver, ContactProblem, ImpactLaw, ImpactProblem, ImpactSettings};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    // On a line: one velocity for each ball of 1 kg, one row for each pair of neighbours.
    let mut cradle = ContactProblem::new(1, vec![1.0; 5])?;
    for left in 0..4 {
        cradle.push_row(&[(left, &[-1.0]), (left + 1, &[1.0])])?;
    }
    let (before, settings) = ([1.0, 0.0, 0.0, 0.0, 0.0], ImpactSettings::default());
    let (approach, mut solver) = (cradle.row_velocities(&before)?, ComplementaritySolver::new(settings.solver));
    let (delassus, restitution) = (cradle.delassus(), [1.0; 4]);
    let problem = ImpactProblem {
        contacts: &cradle,
        delassus: &delassus,
        u_before: &approach,
        restitution: &restitution,
        settings: &settings,
    };
    for law in [ImpactLaw::Propagation, ImpactLaw::Simultaneous, ImpactLaw::Reflection] {
        let impact = law.resolve(&problem, &mut solver)?;
        let change = cradle.response(&impact.impulses)?;
        let after: Vec<f64> = before.iter().zip(change).map(|(before, change)| before + change).collect();
        println!("{law:?}: {after:.3?} m/s, energy changed by {:.0e} J", impact.energy_change);
        assert!((after.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        assert!(law != ImpactLaw::Propagation || after == [0.0, 0.0, 0.0, 0.0, 1.0]);
    }
    Ok(())
}
