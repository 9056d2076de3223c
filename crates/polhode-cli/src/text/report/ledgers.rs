//! Where the energy and the momentum of a run went, by cause. Entries that are exactly zero are left out.

use super::words::joule;
use crate::text::table::{Table, number, vector};
use polhode::{Ledger, MomentumLedger};

/// The ledger of energy.
pub(super) fn energy(ledger: &Ledger) -> String {
    let mut table = Table::default();
    let entries = [
        ("numerical", ledger.numerical),
        ("projection", ledger.projection),
        ("impact", ledger.impact),
        ("friction", ledger.friction),
        ("rest", ledger.rest),
        ("damping", ledger.damping),
        ("work done by forces", ledger.external),
    ];
    for (name, sum) in entries.into_iter().filter(|(_, sum)| sum.value() != 0.0) {
        table.row([name, &joule(sum.value())]);
    }
    let closure = ledger.closure_relative();
    if closure > 0.0 {
        table.row(["closure", &format!("{} (relative; checks the book-keeping only)", number(closure))]);
    }
    section("ledger (lost, but for work done by forces)", &table, "nothing was lost, and nothing was given")
}

/// The ledger of momentum.
pub(super) fn momentum(ledger: &MomentumLedger) -> String {
    let mut table = Table::default();
    let entries = [
        ("given by gravity", ledger.gravity),
        ("given by fixed bodies", ledger.support),
        ("given by force fields", ledger.fields),
        ("given by the program", ledger.program),
        ("rest", ledger.rest),
        ("projection", ledger.projection),
        ("numerical", ledger.numerical),
    ];
    let entries = entries.map(|(name, sum)| (name, sum.value()));
    let is_there = |momentum: &polhode::Momentum| *momentum != polhode::Momentum::default();
    let told: Vec<_> = entries.into_iter().filter(|(_, momentum)| is_there(momentum)).collect();
    if !told.is_empty() {
        table.row(["", "linear, N s", "angular, N m s"]);
    }
    for (name, momentum) in told {
        table.row([name, &vector(momentum.linear), &vector(momentum.angular)]);
    }
    let closure = ledger.closure_relative();
    if closure > 0.0 {
        table.row(["closure", &format!("{} (relative)", number(closure)), ""]);
    }
    section("ledger of momentum (lost, but for what was given)", &table, "nothing was lost, and nothing was given")
}

/// A table below its heading, or one line where there is no row.
fn section(heading: &str, table: &Table, nothing: &str) -> String {
    let rows = table.print();
    if rows.is_empty() { format!("{heading}\n  {nothing}\n") } else { format!("{heading}\n{rows}") }
}
