//! What happened in a run: steps, events, springs; where the bodies are at the end; energies.

use super::ended::Ended;
use super::words::{MOST_BODIES, about, joule, rest};
use crate::text::table::{Table, number, vector};
use polhode::{Acceleration, Energy, ReportedBody, RunReport, Scene, SpringReport};

/// Steps, events, what stands, springs. What there was none of is left out.
pub(super) fn happened(ended: &Ended<'_>) -> String {
    let report = ended.report;
    let mut table = Table::default();
    table.row(["steps", &report.steps.to_string()]);
    if report.events > 0 {
        table.row(["events", &report.events.to_string()]);
    }
    if !report.crowded.is_empty() {
        table.row(["crowded stretches", &crowded(report)]);
    }
    if let Some(stands) = ended.stands {
        table.row(["stands", stands]);
    }
    if let Some(springs) = &report.springs {
        of_springs(&mut table, springs);
    }
    format!("what happened\n{}", table.print())
}

/// The stretches of crowded events of a run.
fn crowded(report: &RunReport) -> String {
    let (length, residual) = (number(report.crowded_s()), report.crowded_residual());
    let residual = if residual > 0.0 { format!(", largest residual {}", about(residual)) } else { String::new() };
    format!("{}, {length} s in all{residual}", report.crowded.len())
}

/// Penetration and restitution that springs at contacts were asked for and reached, and how stiff they were for the
/// steps.
fn of_springs(table: &mut Table, springs: &SpringReport) {
    if springs.penetration_m > 0.0 {
        let asked = springs.penetration_asked_m.map(|asked| format!(", {} m asked", number(asked))).unwrap_or_default();
        table.row(["penetration", &format!("{} m reached{asked}", number(springs.penetration_m))]);
    }
    let worst = springs.worst_restitution.as_ref().map(|worst| {
        let (reached, asked, t_s) = (worst.restitution(), worst.restitution_asked, worst.begun_s);
        format!(
            "{} reached, {} asked, where it was farthest off (t = {} s), of {} contacts that ended",
            number(reached),
            number(asked),
            number(t_s),
            springs.impacts
        )
    });
    let beyond = springs.out_of_reach.map(|[asked, reached]| {
        format!("{} asked is beyond any damper, {} is reached", number(asked), number(reached))
    });
    let restitution: Vec<String> = worst.into_iter().chain(beyond).collect();
    if !restitution.is_empty() {
        table.row(["restitution", &restitution.join("; ")]);
    }
    if springs.fastest_rad_s > 0.0 {
        let (fastest, of_step) = (number(springs.fastest_rad_s), number(springs.frequency_step));
        table.row(["springs", &format!("up to {fastest} rad/s, times the step {of_step}")]);
    }
}

/// Where the bodies are at the end.
pub(super) fn bodies(report: &RunReport) -> String {
    let mut table = Table::default();
    table.row(["body", "position, m", "orientation wxyz", "velocity, m/s", "angular velocity, rad/s"]);
    for ReportedBody { name, state: sample, .. } in report.bodies.iter().take(MOST_BODIES) {
        let wxyz = sample.pose.rotation.to_wxyz().map(number).join(", ");
        table.cells(vec![
            name.clone(),
            vector(sample.pose.translation),
            format!("({wxyz})"),
            vector(sample.velocity.linear),
            vector(sample.velocity.angular),
        ]);
    }
    format!("at the end\n{}{}", table.print(), rest(report.bodies.len(), "--json or -o"))
}

/// Energies, but for those that are zero.
pub(super) fn energies(energy: &Energy) -> String {
    let mut table = Table::default();
    let all = [
        ("initial", energy.initial_j),
        ("final", energy.final_j),
        ("kinetic", energy.kinetic_j),
        ("potential", energy.potential_j),
    ];
    for (name, energy_j) in all.into_iter().filter(|&(_, energy_j)| energy_j != 0.0) {
        table.row([name, &joule(energy_j)]);
    }
    let rows = table.print();
    if rows.is_empty() { String::new() } else { format!("energy\n{rows}") }
}

/// Accelerations at t = 0.
pub(crate) fn accelerations(scene: &Scene, accelerations: &[Acceleration]) -> String {
    let mut table = Table::default();
    table.row(["body", "linear, m/s^2", "angular, rad/s^2"]);
    for (body, acceleration) in scene.bodies().iter().zip(accelerations).take(MOST_BODIES) {
        table.row([body.name(), &vector(acceleration.linear), &vector(acceleration.angular)]);
    }
    format!("accelerations at t = 0\n{}{}", table.print(), rest(accelerations.len(), "--json"))
}
