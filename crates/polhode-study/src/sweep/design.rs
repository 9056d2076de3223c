//! Which runs a sweep of an uncertain scene has: the middle of all keys, steps from it for derivatives, nodes of a
//! quadrature or draws that are mixed for sensitivities, and draws for the band.
//!
//! | rows | what they are for |
//! |---|---|
//! | `middle`, `step` | derivatives at the middle: central differences of three steps, extrapolated (Richardson) |
//! | `node` | sensitivities of few keys: a grid of Gauss's nodes, exact for smooth answers |
//! | `draw` | the band; they also judge how well the polynomial through the nodes fits |
//! | `other`, `mixed` | sensitivities of many keys: a second draw, and the draw with one value of it (Saltelli) |
//!
//! Draws come last, so that a table of fewer draws is the beginning of that of more.

use super::distribution::Drawing as _;
use super::varied::{Values, Varied};
use polhode_scene::Distribution;

/// Runs that the nodes of a grid may be, together.
const MOST_NODES: usize = 1024;

/// Nodes of a key at the most: more do not help an answer that is known to the last bits.
const MOST_OF_KEY: usize = 12;

/// Nodes of a key at the least: a parabola.
const FEWEST_OF_KEY: usize = 3;

/// Nodes of a key at the least in what is planned: keys that leave fewer are too many for a grid.
const FEWEST_PLANNED: usize = 4;

/// Steps of a difference: each is half of the one before.
pub(super) const STEPS: usize = 3;

/// The first step, of the standard deviation.
const FIRST_STEP: f64 = 0.25;

/// What makes a draw another one of the same run.
const OTHER: &str = "other";

/// How sensitivities are to be found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Sensitivities {
    /// Nodes where the keys are few, mixed draws where they are many.
    #[default]
    Planned,
    /// A grid of Gauss's nodes.
    Gauss,
    /// Mixed draws.
    Saltelli,
    /// Derivatives alone.
    Local,
    /// None.
    Off,
}

/// What the runs are.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Design {
    /// The keys of which there are derivatives: those with numbers that differ.
    stepped: Vec<usize>,
    /// How many nodes each key has; empty where there is no grid.
    nodes: Vec<usize>,
    /// Whether draws are mixed.
    mixing: Mixing,
}

/// Whether draws are mixed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mixing {
    None,
    /// Each draw has a second one, and as many mixed ones as there are keys.
    Saltelli,
}

/// What a run is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All keys at their middle.
    Middle,
    /// A key a step from its middle: which key, which of the steps, and which way.
    Step { key: usize, step: usize, is_up: bool },
    /// A node of the grid, the last key fastest.
    Node(usize),
    /// A draw.
    Draw(u64),
    /// The second draw of the same number.
    Other(u64),
    /// A draw with the value of one key from the second one.
    Mixed { draw: u64, key: usize },
}

impl Part {
    /// The word in the table.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Middle => "middle",
            Self::Step { .. } => "step",
            Self::Node(_) => "node",
            Self::Draw(_) => "draw",
            Self::Other(_) => "other",
            Self::Mixed { .. } => "mixed",
        }
    }
}

impl Design {
    /// The design for these keys, all of which are drawn; `is_accepted` says whether the scene takes a value of a key.
    pub(super) fn new(varied: &[Varied], asked: Sensitivities, is_accepted: impl Fn(usize, &str) -> bool) -> Self {
        let has_steps = asked != Sensitivities::Off;
        let stepped = (0..varied.len()).filter(|key| has_steps && step_of(&varied[*key]).is_some()).collect();
        let wants_nodes = matches!(asked, Sensitivities::Planned | Sensitivities::Gauss);
        let nodes = if wants_nodes { planned(varied, asked, is_accepted) } else { Vec::new() };
        let is_mixed = match asked {
            Sensitivities::Planned => nodes.is_empty(),
            other => other == Sensitivities::Saltelli,
        };
        Self { stepped, nodes, mixing: if is_mixed { Mixing::Saltelli } else { Mixing::None } }
    }

    /// How many nodes each key has; empty where there is no grid.
    pub(super) fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Whether draws are mixed.
    pub(super) fn mixing(&self) -> Mixing {
        self.mixing
    }

    /// The keys of which there are derivatives.
    pub(super) fn stepped(&self) -> &[usize] {
        &self.stepped
    }

    fn count_of_nodes(&self) -> usize {
        if self.nodes.is_empty() { 0 } else { self.nodes.iter().product() }
    }

    /// Rows before those of the draws.
    pub(super) fn before_draws(&self) -> u64 {
        (1 + 2 * STEPS * self.stepped.len() + self.count_of_nodes()) as u64
    }

    /// Rows of each draw.
    pub(super) fn of_draw(&self, keys: usize) -> u64 {
        match self.mixing {
            Mixing::None => 1,
            Mixing::Saltelli => keys as u64 + 2,
        }
    }

    /// What a run is for.
    pub(super) fn part(&self, run: u64, keys: usize) -> Part {
        let before = self.before_draws();
        if run >= before {
            let (draw, rest) = ((run - before) / self.of_draw(keys), (run - before) % self.of_draw(keys));
            return match rest {
                0 => Part::Draw(draw),
                1 => Part::Other(draw),
                mixed => Part::Mixed { draw, key: mixed as usize - 2 },
            };
        }
        let Some(number) = (run as usize).checked_sub(1) else { return Part::Middle };
        match self.stepped.get(number / (2 * STEPS)) {
            Some(key) => {
                let rest = number % (2 * STEPS);
                Part::Step { key: *key, step: rest / 2, is_up: rest % 2 == 1 }
            }
            None => Part::Node(number - 2 * STEPS * self.stepped.len()),
        }
    }

    /// Which node each key has in a node of the grid.
    pub(super) fn places(&self, mut node: usize) -> Vec<usize> {
        let mut places = vec![0; self.nodes.len()];
        for (place, count) in places.iter_mut().zip(&self.nodes).rev() {
            *place = node % count;
            node /= count;
        }
        places
    }

    /// The values of a run.
    pub(super) fn values(&self, varied: &[Varied], seed: u64, run: u64) -> Vec<String> {
        let part = self.part(run, varied.len());
        let places = match part {
            Part::Node(node) => self.places(node),
            _ => Vec::new(),
        };
        let value = |(key, own): (usize, &Varied)| {
            let Values::Drawn(drawn) = &own.values else { return own.values.middle() };
            let other = |draw: u64| drawn.draw(seed, draw, &format!("{}\n{OTHER}", own.key));
            match part {
                Part::Step { key: stepped, step, is_up } if stepped == key => {
                    let size = step_of(own).unwrap_or(0.0) / f64::from(1 << step);
                    let middle: f64 = drawn.at(0.5).parse().unwrap_or(f64::NAN);
                    format!("{:?}", if is_up { middle + size } else { middle - size })
                }
                Part::Middle | Part::Step { .. } => own.values.middle(),
                Part::Node(_) => drawn.nodes(self.nodes[key])[places[key]].value.clone(),
                Part::Other(draw) => other(draw),
                Part::Mixed { draw, key: mixed } if mixed == key => other(draw),
                Part::Draw(draw) | Part::Mixed { draw, .. } => drawn.draw(seed, draw, &own.key),
            }
        };
        varied.iter().enumerate().map(value).collect()
    }
}

/// The first step of a key; none where its values are no numbers, or do not differ.
fn step_of(own: &Varied) -> Option<f64> {
    let Values::Drawn(drawn) = &own.values else { return None };
    drawn.deviation().map(|deviation| FIRST_STEP * deviation).filter(|step| *step > 0.0)
}

/// How many nodes each key has: as many as the grid has room for, fewer where the scene takes no values so far out;
/// none where the keys are too many, or the scene takes too few values.
fn planned(varied: &[Varied], asked: Sensitivities, is_accepted: impl Fn(usize, &str) -> bool) -> Vec<usize> {
    let fixed: usize = varied.iter().filter_map(choices).product();
    let free = varied.iter().filter(|own| choices(own).is_none()).count() as u32;
    let fits = |count: &usize| {
        let all = count.checked_pow(free).and_then(|all| all.checked_mul(fixed));
        all.is_some_and(|all| all <= MOST_NODES)
    };
    let fewest = if asked == Sensitivities::Gauss { FEWEST_OF_KEY } else { FEWEST_PLANNED };
    let Some(most) = (fewest..=MOST_OF_KEY).rev().find(fits) else { return Vec::new() };
    let of_key = |(key, own): (usize, &Varied)| {
        if let Some(count) = choices(own) {
            return Some(count);
        }
        let Values::Drawn(drawn) = &own.values else { return None };
        (FEWEST_OF_KEY..=most).rev().find(|count| {
            let nodes = drawn.nodes(*count);
            let ends = [nodes.first(), nodes.last()];
            ends.into_iter().flatten().all(|node| is_accepted(key, &node.value))
        })
    };
    varied.iter().enumerate().map(of_key).collect::<Option<Vec<usize>>>().unwrap_or_default()
}

/// How many nodes a key has whatever is asked for: as many as a choice has values, and one where nothing differs.
fn choices(own: &Varied) -> Option<usize> {
    let Values::Drawn(drawn) = &own.values else { return None };
    match drawn {
        Distribution::Choice(values) => Some(values.len()),
        _ => (drawn.deviation() == Some(0.0)).then_some(1),
    }
}
