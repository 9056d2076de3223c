//! Reference points and Monte Carlo estimates of a mesh.

use super::table::{Table, number, vector};
use polhode::mesh::{Estimate, MonteCarloEstimate, ReferencePointCost};
use polhode::spatial::MassProperties;

/// What each reference point costs, as a table.
pub(crate) fn reference_points(costs: &[ReferencePointCost], measure: &str) -> String {
    let mut table = Table::default();
    table.row([
        "plain sums about the",
        measure,
        "error, relative",
        "centre of mass, m",
        "error, m",
        "inertia: error, relative",
    ]);
    for cost in costs {
        table.cells(vec![
            cost.reference.name().to_owned(),
            number(cost.measure),
            number(cost.measure_error),
            vector(cost.centroid),
            number(cost.centroid_error_m),
            number(cost.second_moment_error),
        ]);
    }
    format!("reference points (errors against the compensated sums about a local point)\n{}", table.print())
}

/// Estimate, standard error and deviation from the exact value of each quantity.
pub(crate) fn monte_carlo(
    estimate: &MonteCarloEstimate,
    volume_m3: f64,
    exact: &MassProperties,
    [estimate_s, exact_s]: [f64; 2],
) -> String {
    let mut table = Table::default();
    table.row(["", "exact", "estimate", "error", "standard error", "error / standard error"]);
    let mut row = |name: &str, exact: f64, found: Estimate| {
        let error = found.value - exact;
        let deviations = if found.standard_error > 0.0 { number(error / found.standard_error) } else { String::new() };
        table.cells(vec![
            name.to_owned(),
            number(exact),
            number(found.value),
            number(error),
            number(found.standard_error),
            deviations,
        ]);
    };
    row("volume, m^3", volume_m3, estimate.volume);
    row("mass, kg", exact.mass(), estimate.mass);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let name = format!("centre of mass {name}, m");
        row(&name, exact.center_of_mass()[axis], estimate.center_of_mass[axis]);
    }
    let m = exact.inertia().matrix();
    let elements = [m.x_axis.x, m.y_axis.y, m.z_axis.z, m.y_axis.z, m.x_axis.z, m.x_axis.y];
    for (index, name) in ["xx", "yy", "zz", "yz", "xz", "xy"].into_iter().enumerate() {
        row(&format!("inertia {name}, kg m^2"), elements[index], estimate.inertia[index]);
    }
    format!(
        "Monte Carlo: {} of {} points inside, {} s; exact: {} s\n{}",
        estimate.inside,
        estimate.samples,
        number(estimate_s),
        number(exact_s),
        table.print()
    )
}
