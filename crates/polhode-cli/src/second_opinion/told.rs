//! What is told of a second opinion.

use super::Opinion;
use super::apart::BodyApart;
use crate::text::{Table, number};
use serde_json::{Value, json};

/// Most bodies listed.
const MOST_LISTED: usize = 50;

impl Opinion {
    /// For people: a section below the report.
    pub(crate) fn text(&self) -> String {
        let notes = self.notes.iter().fold(String::new(), |told, note| format!("{told}  note: {note}\n"));
        let Some(method) = &self.method else {
            return format!("\nsecond opinion\n  none could be had\n{notes}");
        };
        let ended = self.ended.as_ref().map_or_else(String::new, |why| {
            format!("  it ended at t = {} s: {why}\n", number(self.compared_s.unwrap_or_default()))
        });
        let rest = self.bodies.len().saturating_sub(MOST_LISTED);
        let rest = if rest > 0 { format!("  and {rest} more: see --json\n") } else { String::new() };
        format!("\nsecond opinion\n  {}\n  by {method}\n{ended}{notes}{}{rest}", self.sentence(), self.table())
    }

    /// The largest difference, and whether the run is as good as its method promises.
    fn sentence(&self) -> String {
        let Some(farthest) = self.bodies.first() else {
            return "nothing that forces move could be compared".to_owned();
        };
        let verdict = if self.agrees() { "agrees with" } else { "contradicts" };
        format!("it {verdict} the run: the largest difference is {}", self.said(farthest))
    }

    /// How far a body is from its place, in words.
    fn said(&self, body: &BodyApart) -> String {
        let BodyApart { name, distance_m, rotation_rad, of_size, t_s } = body;
        let [distance, rotation, of_size, t] = [*distance_m, *rotation_rad, *of_size, *t_s].map(number);
        let limit = number(self.limit);
        format!(
            "{of_size} of the size of {name} ({distance} m, {rotation} rad) at t = {t} s, where {limit} is promised"
        )
    }

    fn table(&self) -> String {
        let mut table = Table::default();
        table.row(["body", "distance, m", "rotation, rad", "of its size", "at t, s"]);
        for BodyApart { name, distance_m, rotation_rad, of_size, t_s } in self.bodies.iter().take(MOST_LISTED) {
            let [distance, rotation, of_size, t] = [*distance_m, *rotation_rad, *of_size, *t_s].map(number);
            table.cells(vec![name.clone(), distance, rotation, of_size, t]);
        }
        if self.bodies.is_empty() { String::new() } else { table.print() }
    }

    /// For programs.
    pub(crate) fn json(&self) -> Value {
        let body = |body: &BodyApart| {
            json!({
                "name": body.name,
                "distance_m": body.distance_m,
                "rotation_rad": body.rotation_rad,
                "of_size": body.of_size,
                "t_s": body.t_s,
            })
        };
        json!({
            "method": self.method,
            "agrees": self.method.as_ref().map(|_| self.agrees()),
            "limit": self.limit,
            "largest": self.bodies.first().map(body),
            "compared_until_s": self.compared_s,
            "ended": self.ended,
            "notes": self.notes,
            "bodies": self.bodies.iter().map(body).collect::<Vec<_>>(),
        })
    }

    /// What is wrong, where the run is farther from the second one than its method promises.
    pub(crate) fn contradiction(&self, scene: &str) -> Option<String> {
        let farthest = self.bodies.first().filter(|_| !self.agrees())?;
        Some(format!("degraded: {scene}: a second opinion contradicts the run: {}", self.said(farthest)))
    }
}
