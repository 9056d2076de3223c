//! Random structures: the friction that they need, by the margin that a simulation tells and by the programme of
//! `statics`, which shares no code with it.

use super::generate::structure;
use crate::cases::{Amount, CaseResult, Context};
use crate::row::Row;
use polhode::{Effects, Simulation};
use polhode_oracles::statics::{Verdict, judge};
use std::error::Error;

const CASE: &str = "structures: margins";

/// How many random structures there are, and how many of them the plain command looks at.
const STRUCTURES: usize = 300;
const STRUCTURES_OF_PART: usize = 60;

/// On either side of the margin the programme is asked with this part of friction more or less (no unit): well above
/// the shortfall that it counts as none.
const BESIDE: f64 = 1e-3;

/// What the structures showed.
#[derive(Debug, Default)]
struct Tally {
    /// With a margin above 0, and those that need no friction or that none holds.
    between: u64,
    other: u64,
    /// The programme finds no forces above the margin, or some below it; or says otherwise where there is none.
    disagree: u64,
}

impl Tally {
    fn count(&mut self, number: usize) -> Result<(), Box<dyn Error>> {
        let structure = structure(number);
        if structure.friction == 0.0 {
            return Ok(());
        }
        let blocks = structure.blocks();
        let scene = structure.scene()?;
        let stability = Simulation::with_effects(&scene, Effects::All)?.stability()?;
        // A block that touches nothing is none of those at rest, and falls.
        let movable = scene.bodies().iter().filter(|body| !body.is_fixed()).count();
        let needed = stability.friction.needed.filter(|_| stability.bodies == movable);
        let verdict = |part: f64| judge(&blocks, structure.friction(part));
        let agrees = match needed {
            Some(needed) if needed > 0.0 => {
                self.between += 1;
                verdict(needed * (1.0 + BESIDE))? != Verdict::Infeasible
                    && verdict(needed * (1.0 - BESIDE))? != Verdict::Feasible
            }
            Some(_) => {
                self.other += 1;
                verdict(BESIDE)? != Verdict::Infeasible
            }
            None => {
                self.other += 1;
                verdict(1.0)? != Verdict::Feasible
            }
        };
        self.disagree += u64::from(!agrees);
        Ok(())
    }
}

/// The margins of friction are those of the programme.
pub(in crate::cases) fn margins(context: &Context) -> CaseResult {
    let count = if context.amount == Amount::Full { STRUCTURES } else { STRUCTURES_OF_PART };
    let mut tally = Tally::default();
    for number in 0..count {
        tally.count(number).map_err(|error| format!("structure {number}: {error}"))?;
    }
    Ok(vec![
        Row::exact(CASE, &format!("{count} structures: margin and programme disagree"), 0_u64, tally.disagree),
        Row::info(
            CASE,
            &format!("{count} structures: with a margin of friction, without"),
            "",
            format!("{}, {}", tally.between, tally.other),
        ),
    ])
}
