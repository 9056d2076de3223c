//! Structures that stand or fall by friction, judged by an independent programme of static equilibrium.
//!
//! A structure stands in a run if and only if forces exist that balance all of it (`statics`). Without friction the two
//! agree. With friction forces that balance may exist although the bodies move (they are not unique), so that two
//! things are asked: what the programme finds impossible falls, and what it finds possible with 5 % less friction
//! stands.
//!
//! | module | holds |
//! |---|---|
//! | `generate` | random walls, bridges, corbels and leaning piles |
//! | `built` | structures of prisms, as a scene and as blocks of the programme |
//! | `margins` | the friction that random structures need |
//! | `masonry` | arches and card houses |
//! | `fate` | runs: whether a structure stands |

mod built;
mod fate;
mod generate;
mod margins;
mod masonry;

use super::{Amount, CaseResult, Context};
use crate::row::Row;
use built::Built;
use fate::{Fate, Until, fate};
use generate::{Structure, structure};
pub(super) use margins::margins;
use polhode::{ErrorEstimation, Simulation};
use polhode_oracles::statics::{Verdict, judge};
use std::error::Error;

const CASE: &str = "structures";

/// How many random structures there are, and how many of them the plain command runs.
const RANDOM: usize = 1000;
const RANDOM_OF_PART: usize = 20;

/// The falls of the first so many are run until they show; the others accelerate at the start.
const FALLS: usize = RANDOM_OF_PART;

/// Walls with friction that could fall by forces that satisfy Coulomb's law as well as those that balance them: a brick
/// that overhangs is jammed by friction against its neighbour, or tips along it.
const JAMMED: [usize; 6] = [372, 428, 452, 676, 804, 940];

/// A structure that stands with this part of its friction stands with all of it.
const LESS_FRICTION: f64 = 0.95;

/// What the runs of random structures showed.
#[derive(Debug, Default)]
struct Tally {
    /// Structures that can stand, that cannot, and that the programme leaves open.
    feasible: u64,
    infeasible: u64,
    open: u64,
    /// Without friction: the run and the programme disagree.
    disagree: u64,
    /// With friction: stood although no forces balance; fell although less friction would do.
    stood: u64,
    fell: u64,
    /// Runs that were given up, and those that ended with an error.
    given_up: u64,
    failed: u64,
}

impl Tally {
    fn count(&mut self, structure: &Structure, until: Until) -> Result<(), Box<dyn Error>> {
        let blocks = structure.blocks();
        let verdict = judge(&blocks, structure.friction(1.0))?;
        let with_less = judge(&blocks, structure.friction(LESS_FRICTION))?;
        let fate = fate(&structure.scene()?, until);
        self.failed += u64::from(matches!(fate, Fate::Fails(_)));
        self.given_up += u64::from(matches!(fate, Fate::Open(_)));
        let stands = fate.stands();
        match verdict {
            Verdict::Infeasible => self.infeasible += 1,
            Verdict::Feasible if with_less == Verdict::Feasible => self.feasible += 1,
            Verdict::Feasible | Verdict::Marginal => self.open += 1,
        }
        let stood = verdict == Verdict::Infeasible && stands;
        let fell = with_less == Verdict::Feasible && !stands;
        if structure.friction > 0.0 {
            self.stood += u64::from(stood);
            self.fell += u64::from(fell);
        } else {
            self.disagree += u64::from(stood || fell);
        }
        Ok(())
    }

    fn add(&mut self, other: &Self) {
        self.feasible += other.feasible;
        self.infeasible += other.infeasible;
        self.open += other.open;
        self.disagree += other.disagree;
        self.stood += other.stood;
        self.fell += other.fell;
        self.given_up += other.given_up;
        self.failed += other.failed;
    }
}

/// The structures of these numbers, by two threads.
fn random_structures(numbers: &[usize]) -> Result<Tally, Box<dyn Error>> {
    const THREADS: usize = 2;
    let mut sum = Tally::default();
    std::thread::scope(|scope| {
        let part = |first: usize| {
            scope.spawn(move || -> Result<Tally, String> {
                let mut tally = Tally::default();
                for &number in numbers.iter().skip(first).step_by(THREADS) {
                    // Falls of many bricks that rub against each other take minutes each.
                    let until = if number < FALLS { Until::Displacement } else { Until::Acceleration };
                    tally.count(&structure(number), until).map_err(|error| format!("structure {number}: {error}"))?;
                }
                Ok(tally)
            })
        };
        let threads: Vec<_> = (0..THREADS).map(part).collect();
        for thread in threads {
            sum.add(&thread.join().map_err(|_| "a panic: a bug, whatever the input was".to_owned())??);
        }
        Ok::<(), String>(())
    })?;
    Ok(sum)
}

/// Random structures stand or fall as the programme says.
pub(super) fn random(context: &Context) -> CaseResult {
    let count = if context.amount == Amount::Full { RANDOM } else { RANDOM_OF_PART };
    let tally = random_structures(&(0..count).collect::<Vec<_>>())?;
    let jammed = random_structures(&JAMMED)?;
    let named = |what: &str| format!("{count} structures: {what}");
    Ok(vec![
        Row::exact(CASE, &named("without friction, the run and the programme disagree"), 0_u64, tally.disagree),
        Row::exact(CASE, &named("with friction, stood although no forces balance"), 0_u64, tally.stood),
        Row::exact(CASE, &named("with friction, fell although 95 % of it would do"), 0_u64, tally.fell),
        Row::exact(CASE, "walls jammed by friction: fell although 95 % of it would do", 0_u64, jammed.fell),
        Row::exact(CASE, &named("runs that failed"), 0_u64, tally.failed),
        Row::exact(CASE, &named("runs given up: their events crowd"), 0_u64, tally.given_up),
        Row::info(
            CASE,
            &named("can stand, cannot, left open"),
            "",
            [tally.feasible as f64, tally.infeasible as f64, tally.open as f64],
        ),
    ])
}

/// Least thickness of an arch by the programme, m: between one that falls and one that stands.
fn least_thickness(stones: u32) -> Result<f64, Box<dyn Error>> {
    let (mut falls, mut stands) = (0.05, 0.2);
    while stands - falls > THICKNESS * stands {
        let middle = 0.5 * (falls + stands);
        let built = masonry::arch(stones, middle, ARCH_FRICTION)?;
        match judge(built.blocks(), built.friction(1.0))? {
            Verdict::Feasible => stands = middle,
            Verdict::Infeasible | Verdict::Marginal => falls = middle,
        }
    }
    Ok(0.5 * (falls + stands))
}

/// The least thickness is found to this part of it.
const THICKNESS: f64 = 1e-3;

/// Friction of the joints of arches: stone on stone.
const ARCH_FRICTION: f64 = 0.7;

/// Arches are tried this far below and above their least thickness, relative to it.
const BESIDE: f64 = 0.01;

/// Whether a built structure stands.
fn stands(built: &Built) -> Result<bool, Box<dyn Error>> {
    match fate(&built.scene()?, Until::Displacement) {
        Fate::Fails(message) => Err(message.into()),
        fate => Ok(fate.stands()),
    }
}

/// The residual of the forces of a standing structure.
fn residual(built: &Built) -> Result<f64, Box<dyn Error>> {
    let mut simulation = Simulation::new(&built.scene()?)?.estimating(ErrorEstimation::Off);
    simulation.advance_to(0.1)?;
    Ok(simulation.frame().certificate.max_residual)
}

/// Largest residual of a structure of bodies of nearly equal mass.
const RESIDUAL: f64 = 1e-12;

/// Arches stand above their least thickness and fall below it. That of 101 stones takes long and is left to the full
/// run.
pub(super) fn arches(context: &Context) -> CaseResult {
    let stones: &[u32] = if context.amount == Amount::Full { &[25, 101] } else { &[25] };
    let mut rows = Vec::new();
    for &stones in stones {
        let least = least_thickness(stones)?;
        let at = |part: f64| masonry::arch(stones, part * least, ARCH_FRICTION);
        let (below, above) = (at(1.0 - BESIDE)?, at(1.0 + BESIDE)?);
        let named = |what: &str| format!("arch of {stones} stones: {what}");
        let found = vec![stands(&below)?, stands(&above)?];
        rows.push(Row::exact(CASE, &named("stands 1 % below and above the least thickness"), vec![false, true], found));
        rows.push(Row::at_most(CASE, &named("residual of its forces"), RESIDUAL, residual(&above)?));
        rows.push(Row::info(CASE, &named("least thickness by the radius (of one piece 0.1075)"), 0.1075, least));
    }
    Ok(rows)
}

/// Card houses of four storeys stand on enough friction, and fall on less than the programme asks for.
pub(super) fn card_houses(_context: &Context) -> CaseResult {
    let mut rows = Vec::new();
    for degrees in [15.0, 20.0, 25.0f64] {
        let house = |friction: f64| masonry::card_house(4, degrees.to_radians(), friction);
        let mut found = Vec::new();
        for friction in [HOUSE_FRICTION, SLIPPERY] {
            let built = house(friction)?;
            found.push(judge(built.blocks(), built.friction(1.0))? == Verdict::Feasible);
            found.push(stands(&built)?);
        }
        let quantity =
            format!("card house of 4 storeys at {degrees} degrees, friction 0.6 and 0.05: can stand, stands");
        rows.push(Row::exact(CASE, &quantity, vec![true, true, false, false], found));
        let quantity = format!("card house of 4 storeys at {degrees} degrees: residual of its forces");
        rows.push(Row::at_most(CASE, &quantity, RESIDUAL, residual(&house(HOUSE_FRICTION)?)?));
    }
    Ok(rows)
}

/// Structures that stand: houses of cards, an arch, and random ones with more friction than the programme asks for.
pub(crate) fn standing(random: std::ops::Range<usize>) -> Result<Vec<(String, polhode::Scene)>, Box<dyn Error>> {
    let mut all = Vec::new();
    for storeys in 1..=4 {
        let house = masonry::card_house(storeys, 20.0f64.to_radians(), HOUSE_FRICTION)?;
        all.push((format!("card house of {storeys} storeys"), house.scene()?));
    }
    all.push(("arch of 9 stones".to_owned(), masonry::arch(9, 0.2, ARCH_FRICTION)?.scene()?));
    for number in random {
        let one = structure(number);
        if judge(&one.blocks(), one.friction(LESS_FRICTION))? == Verdict::Feasible {
            all.push((format!("structure {number}"), one.scene()?));
        }
    }
    Ok(all)
}

/// Friction of cards that hold, and of cards that slip.
const HOUSE_FRICTION: f64 = 0.6;
const SLIPPERY: f64 = 0.05;
