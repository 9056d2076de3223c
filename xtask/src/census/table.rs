//! The tables of a census, in Markdown: one for each thing asked, and one of the methods that could go.
//!
//! "Next" is what the chain finds without the method that answered: the method that does so most often, and in how many
//! of the solves that were asked again some other method is accepted, or accepted with a residual as good. "Needed" is
//! the rest of them: solves that no other method of the chain solves.

use super::asks::Ask;
use polhode_response::census::{Chain, Counted, Kind, Other, Table, Without, residual_of};
use polhode_response::friction::FrictionMethod;
use polhode_response::sparse::BodyMethod;
use polhode_response::{ChainMethod, Method};
use std::collections::{BTreeMap, BTreeSet};

/// The part of the solves above whose residual only one in a hundred is.
const ALMOST_ALL: f64 = 0.99;

/// What is known of one method.
#[derive(Debug, Default)]
struct Line {
    answered: u64,
    tried: u64,
    unsolved: u64,
    worst: f64,
    worst_in: String,
    residuals: BTreeMap<i32, u64>,
    cost: u64,
    most_rows: usize,
    asked: u64,
    asked_solved: u64,
    accepted: u64,
    as_good: u64,
    asked_cost: u64,
    next: BTreeMap<&'static str, Other>,
    scenes: BTreeSet<String>,
    callers: BTreeSet<String>,
}

impl Line {
    fn add(&mut self, kind: &Kind, counted: &Counted) {
        self.answered += counted.count;
        self.unsolved += counted.unsolved;
        if counted.worst >= self.worst || counted.worst.is_nan() {
            self.worst = counted.worst;
            self.worst_in.clone_from(&counted.worst_in);
        }
        for (&class, count) in &counted.residuals {
            *self.residuals.entry(class).or_default() += count;
        }
        self.cost += counted.cost;
        self.most_rows = self.most_rows.max(counted.most.rows);
        self.asked += counted.asked;
        self.asked_solved += counted.asked_solved;
        self.accepted += counted.others_accepted;
        self.as_good += counted.others_as_good;
        self.asked_cost += counted.asked_cost;
        for (&(level, method), other) in &counted.next {
            if level == 1 {
                let own = self.next.entry(method).or_default();
                own.count += other.count;
                own.accepted += other.accepted;
                own.as_good += other.as_good;
                own.moved += other.moved;
                own.cost += other.cost;
                own.worst = own.worst.max(other.worst);
            }
        }
        self.scenes.extend(counted.scenes.iter().cloned());
        let file = kind.file.rsplit('/').next().unwrap_or_default();
        self.callers.insert(format!("{}:{}", file.trim_end_matches(".rs"), kind.line));
    }

    /// The residual that all but one in a hundred are not above.
    fn almost_all(&self) -> f64 {
        let mut below = 0;
        for (&class, count) in &self.residuals {
            below += count;
            if below as f64 >= ALMOST_ALL * self.answered as f64 {
                return residual_of(class);
            }
        }
        0.0
    }

    fn mean_cost(&self) -> f64 {
        self.cost as f64 / self.answered.max(1) as f64
    }

    /// The method that is next most often, with what it costs relative to this one.
    fn next(&self) -> String {
        let Some((method, other)) = self.next.iter().max_by_key(|(_, other)| other.count) else {
            return "-".to_owned();
        };
        let own = self.asked_cost as f64 / self.asked.max(1) as f64;
        let cost = other.cost as f64 / other.count.max(1) as f64 / own.max(1.0);
        let moved: u64 = self.next.values().map(|other| other.moved).sum();
        let moves = if moved > 0 { format!("; another motion {moved}") } else { String::new() };
        format!("{method} {} ({cost:.1} of the cost{moves})", other.count)
    }
}

type Lines = BTreeMap<(Chain, &'static str), Line>;

/// The lines of these kinds; methods that were only tried have one, too.
fn lines<'a>(kinds: impl Iterator<Item = (&'a Kind, &'a Counted)>) -> Lines {
    let mut lines = Lines::new();
    for (kind, counted) in kinds {
        lines.entry((kind.chain, kind.method)).or_default().add(kind, counted);
        for &method in &kind.tried {
            lines.entry((kind.chain, method)).or_default().tried += counted.count;
        }
    }
    lines
}

/// Prints all tables.
pub(super) fn print(table: &Table) {
    let asks: BTreeSet<Ask> = table.kinds.keys().map(|kind| Ask::of(kind.file)).collect();
    for ask in asks {
        println!("### {ask}\n");
        println!(
            "| chain | method | answered | tried | unsolved | residual: worst, 99 % | cost | most rows | next | \
             others accepted, as good | asked by |"
        );
        println!("|---|---|---|---|---|---|---|---|---|---|---|");
        for ((chain, method), line) in lines(table.kinds.iter().filter(|(kind, _)| Ask::of(kind.file) == ask)) {
            let callers: Vec<&str> = line.callers.iter().map(String::as_str).collect();
            println!(
                "| {} | {method} | {} | {} | {} | {:.1e}, {:.1e} | {:.1} | {} | {} | {}, {} of {} | {} |",
                chain.name(),
                line.answered,
                line.tried,
                line.unsolved,
                line.worst,
                line.almost_all(),
                line.mean_cost(),
                line.most_rows,
                line.next(),
                line.accepted,
                line.as_good,
                line.asked_solved,
                callers.join(" ")
            );
        }
        println!();
    }
    candidates(&lines(table.kinds.iter()));
    sets(table);
}

/// All methods of the chains that have several.
fn all_methods() -> Vec<(Chain, &'static str)> {
    let of = |chain, names: Vec<&'static str>| names.into_iter().map(move |name| (chain, name));
    let active = of(Chain::ActiveSet, Method::ALL.iter().map(|method| method.name()).collect());
    let friction = of(Chain::Friction, FrictionMethod::ALL.iter().map(|method| method.name()).collect());
    let bodies = of(Chain::Bodies, BodyMethod::ALL.iter().map(|method| method.name()).collect());
    // What belongs to the thesis is another chain, and Newton's method ends stages of bodies.
    let others = [
        (Chain::ActiveSet, Method::LinearProgramme.name()),
        (Chain::ActiveSet, Method::Guesses.name()),
        (Chain::Bodies, BodyMethod::Newton.name()),
    ];
    active.chain(friction).chain(bodies).filter(|method| !others.contains(method)).collect()
}

/// What each method of a chain is needed for.
fn candidates(lines: &Lines) {
    println!("### What could go\n");
    println!("| chain | method | verdict | answered | tried | asked again | needed | needed to be as good | scenes |");
    println!("|---|---|---|---|---|---|---|---|---|");
    for (chain, method) in all_methods() {
        let none = Line::default();
        let line = lines.get(&(chain, method)).unwrap_or(&none);
        let needed = line.asked_solved - line.accepted;
        let to_be_as_good = line.asked_solved - line.as_good;
        let verdict = if line.tried == 0 {
            "never tried"
        } else if line.answered == 0 {
            "never answered"
        } else if line.answered == line.unsolved {
            "never solved"
        } else if needed == 0 && line.asked_solved > 0 {
            "others solve as much"
        } else {
            "needed"
        };
        let scenes: Vec<&str> = line.scenes.iter().map(String::as_str).take(2).collect();
        println!(
            "| {} | {method} | {verdict} | {} | {} | {} | {needed} | {to_be_as_good} | {} |",
            chain.name(),
            line.answered,
            line.tried,
            line.asked_solved,
            scenes.join("; ")
        );
    }
}

/// What chains find without sets of methods.
fn sets(table: &Table) {
    if table.sets.is_empty() {
        return;
    }
    println!("\n### Without these methods\n");
    println!(
        "| chain | without | asked for | solves that tried them | solved | still solved | as good | newly solved | \
         cost |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for (number, set) in table.sets.iter().enumerate() {
        let mut by_ask: BTreeMap<Ask, Without> = BTreeMap::new();
        for (kind, counted) in &table.kinds {
            let Some(without) = counted.without.get(&number) else { continue };
            let own = by_ask.entry(Ask::of(kind.file)).or_default();
            own.count += without.count;
            own.solved_before += without.solved_before;
            own.still_solved += without.still_solved;
            own.as_good += without.as_good;
            own.newly_solved += without.newly_solved;
            own.cost[0] += without.cost[0];
            own.cost[1] += without.cost[1];
        }
        for (ask, own) in by_ask {
            let Without { count, solved_before, still_solved, as_good, newly_solved, cost: [before, after] } = own;
            println!(
                "| {} | {} | {ask} | {count} | {solved_before} | {still_solved} | {as_good} | {newly_solved} | \
                 {:.2} of it |",
                set.chain.name(),
                set.methods.join(" "),
                after as f64 / before.max(1) as f64
            );
        }
    }
}
