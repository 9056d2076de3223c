//! What is certain about the accuracy of a run: the largest value of each measure. What was lost stands first.

use super::words::{joule, place};
use crate::text::table::{Table, number};
use polhode::{PairAt, RunReport};

/// The certificate: what is zero, or was not measured, is left out.
pub(super) fn certificate(report: &RunReport) -> String {
    let mut table = Table::default();
    energies(&mut table, report);
    lengths(&mut table, report);
    solves(&mut table, report);
    let fallbacks = report.certificate.fallbacks;
    if fallbacks > 0 {
        table.row(["fallbacks", &fallbacks.to_string()]);
    }
    let rows = table.print();
    let rows = if rows.is_empty() { "  nothing was lost, and no limit was touched\n" } else { &rows };
    format!("certificate (largest of the run)\n{rows}")
}

/// Energies that the numerics have taken.
fn energies(table: &mut Table, report: &RunReport) {
    let (ledger, certificate) = (&report.ledger, &report.certificate);
    let rows = [
        ("numerical loss", ledger.numerical.value(), None),
        ("taken by projection", ledger.projection.value(), None),
        ("largest projection, energy", certificate.max_projection_j, certificate.max_projection_j_at),
        ("taken by ended bounces, beyond their energy", certificate.ended_bounces_j, None),
        ("largest of these", certificate.max_ended_bounces_j, certificate.max_ended_bounces_at),
    ];
    for (name, energy_j, at) in rows.into_iter().filter(|&(_, energy_j, _)| energy_j != 0.0) {
        let relative = number(energy_j / ledger.scale_j);
        table.row([name, &format!("{} ({relative} of the largest energy){}", joule(energy_j), self::at(report, at))]);
    }
}

/// Overlaps, displacements by projections and errors of joints.
fn lengths(table: &mut Table, report: &RunReport) {
    let certificate = &report.certificate;
    let rows = [
        Length {
            name: "largest projection, distance",
            value_m: certificate.max_projection_m,
            of_limit: certificate.max_projection_of_limit,
            at: certificate.max_projection_at,
        },
        Length {
            name: "largest penetration",
            value_m: certificate.max_penetration_m,
            of_limit: certificate.max_penetration_of_limit,
            at: certificate.max_penetration_at,
        },
        Length {
            name: "  of the samples alone",
            value_m: certificate.max_sample_penetration_m,
            of_limit: certificate.max_sample_penetration_of_limit,
            at: certificate.max_sample_penetration_at,
        },
    ];
    for Length { name, value_m, of_limit, at } in rows.into_iter().filter(|row| row.value_m > 0.0) {
        table.row([name, &format!("{} m{}{}", number(value_m), of_its_limit(of_limit), self::at(report, at))]);
    }
    let (apart, turned) = (certificate.max_joint_error_m, certificate.max_joint_error_rad);
    let parts = [(apart, "m"), (turned, "rad")].into_iter().filter_map(|(error, unit)| {
        let error = error.filter(|&error| error > 0.0)?;
        Some(format!("{} {unit}", number(error)))
    });
    let parts: Vec<String> = parts.collect();
    if !parts.is_empty() {
        let of_limit = of_its_limit(certificate.max_joint_error_of_limit);
        let at = at(report, certificate.max_joint_error_at);
        table.row(["largest error of a joint", &format!("{}{of_limit}{at}", parts.join(", "))]);
    }
}

/// A length that is held against a limit.
struct Length {
    name: &'static str,
    value_m: f64,
    of_limit: f64,
    at: Option<PairAt>,
}

/// How well the problems of contacts and the steps were solved.
fn solves(table: &mut Table, report: &RunReport) {
    let certificate = &report.certificate;
    let violation = certificate.max_friction_violation;
    if violation > 0.0 {
        let of_limit = of_its_limit(certificate.max_friction_violation_of_limit);
        let at = at(report, certificate.max_friction_violation_at);
        let told = format!("{} of the largest force{of_limit}{at}", number(violation));
        table.row(["largest violation of friction's law", &told]);
    }
    let rows = [
        ("largest residual of a contact problem", certificate.max_residual, certificate.max_residual_of_limit),
        ("loads off Newton's law, of their sum", certificate.max_load_defect, certificate.max_load_defect_of_limit),
        ("bound on the error of an acceleration", certificate.max_acceleration_error_bound.unwrap_or_default(), 0.0),
        ("largest error of a step, of its tolerance", certificate.max_step_error.unwrap_or_default(), 0.0),
    ];
    for (name, value, of_limit) in rows.into_iter().filter(|&(_, value, _)| value > 0.0) {
        table.row([name, &format!("{}{}", number(value), of_its_limit(of_limit))]);
    }
}

/// How much of a limit something is.
fn of_its_limit(of_limit: f64) -> String {
    if of_limit > 0.0 { format!(", {} of its limit", number(of_limit)) } else { String::new() }
}

/// Which bodies, and when, behind a value.
fn at(report: &RunReport, at: Option<PairAt>) -> String {
    at.map_or_else(String::new, |at| format!(": {}", place(report, at)))
}
