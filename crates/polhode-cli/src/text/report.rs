//! Plan, accelerations and report of a run.

use super::table::{Table, number, vector};
use crate::heading::Heading;
use polhode::scene::{OverlapLimit, Promise};
use polhode::{
    Acceleration, Body, BodyId, Certificate, ErrorEstimation, Ledger, MomentumLedger, PairAt, Plan, ReferenceReport,
    RunReport, Scene, SpringReport,
};
use polhode_scene::{LoadedScene, names};

/// Most bodies listed: more are for a file to hold.
const MOST_BODIES: usize = 50;

/// Width of a plan, characters.
const WIDTH: usize = 100;

/// What a run has come to: its report, with how far what stands is from moving, and below it the plan.
pub(crate) fn run(loaded: &LoadedScene, report: &RunReport, stands: Option<&str>, wall_s: f64) -> String {
    format!("{}{}\n{}", heading(loaded), self::report(report, stands, wall_s), methods_and_effects(&report.plan))
}

/// The scene with what it shows, and the plan: methods, then one line per effect.
pub(crate) fn plan(loaded: &LoadedScene, plan: &Plan) -> String {
    format!("{}{}\n", heading(loaded), methods_and_effects(plan))
}

/// Name, title and description of the scene.
fn heading(loaded: &LoadedScene) -> String {
    let name = loaded.scene.name();
    let lines = Heading::of(std::iter::once(loaded)).lines(name);
    format!("scene {name}\n{lines}{}\n", approximations(&loaded.scene))
}

/// How well convex parts fill the meshes that they stand for; one line for each such body.
pub(crate) fn approximations(scene: &Scene) -> String {
    let of_body = |body: &Body| {
        let found = body.approximation()?;
        let (name, parts, error) = (body.name(), found.parts, number(found.volume_error));
        Some(format!(
            "body {name}: {parts} convex parts stand for its mesh; error of their volume, relative: {error}\n"
        ))
    };
    scene.bodies().iter().filter_map(of_body).collect()
}

fn methods_and_effects(plan: &Plan) -> String {
    let mut methods = Table::default();
    methods.row(["tier", &format!("{} ({})", names::tier(plan.tier), plan.tier_reason)]);
    methods.row(["integrator", &format!("{} ({})", names::integrator(plan.integrator), plan.integrator_reason)]);
    methods.row(["impact", names::impact(plan.impact)]);
    methods.row(["contact", names::contact(plan.contact)]);
    methods.row(["response", plan.response.name()]);
    methods.row(["broad phase", plan.broad_phase.name()]);
    methods.row(["step", &format!("{} s", number(plan.step_s))]);
    methods.row(["tolerance", &number(plan.tolerance)]);
    methods.row(["promise", &promise(&plan.promise)]);
    let mut effects = Table::default();
    for effect in &plan.effects {
        let saves = if effect.saves.is_empty() { String::new() } else { format!("; {}", effect.saves) };
        let fact = format!("{}{saves}", effect.fact);
        effects.row([effect.effect.name(), names::decision(effect.decision), &fact]);
    }
    format!("plan\n{}\neffects\n{}", methods.print_within(WIDTH), effects.print_within(WIDTH))
}

/// The limits beyond which a run is degraded.
fn promise(promise: &Promise) -> String {
    let overlap = match promise.overlap {
        OverlapLimit::OfSize(part) => format!("{} of the smaller body", number(part)),
        OverlapLimit::OfStatedPenetration(times) => format!("{} times the stated penetration", number(times)),
        OverlapLimit::OfEnvelope(times) => format!("{} times the envelope", number(times)),
        _ => "not limited".to_owned(),
    };
    let others = [
        ("gaps of joints", promise.joint_gap),
        ("energy from projections and from the method", Some(promise.energy)),
        ("residuals", promise.residual),
        ("Coulomb's law", promise.friction),
        ("loads by Newton's law", promise.loads),
        ("estimated error", Some(promise.error)),
    ];
    let others = others.into_iter().filter_map(|(what, limit)| Some(format!(", {what} {}", number(limit?))));
    format!("overlaps at most {overlap}{}", others.collect::<String>())
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

/// The report of a run that took `wall_s` seconds.
fn report(report: &RunReport, stands: Option<&str>, wall_s: f64) -> String {
    let mut run = Table::default();
    let ended = names::outcome(report.outcome);
    run.row(["simulated", &format!("{} of {} s, {ended}", number(report.simulated_s), number(report.duration_s))]);
    run.row(["steps", &report.steps.to_string()]);
    run.row(["events", &report.events.to_string()]);
    run.row(["wall time", &format!("{} s", number(wall_s))]);
    if let Some(stands) = stands {
        run.row(["stands", stands]);
    }
    if !report.crowded.is_empty() {
        run.row(["crowded stretches", &crowded(report)]);
    }
    run.row(["estimated error", &estimated(report)]);
    for reference in &report.error.references {
        run.row(["compared with", &compared(reference)]);
    }

    if let Some(springs) = &report.springs {
        let [penetration, restitution, stiffness] = of_springs(springs);
        run.row(["penetration", &penetration]);
        run.row(["restitution", &restitution]);
        run.row(["springs", &stiffness]);
    }

    let energy = &report.energy;
    let mut energies = Table::default();
    energies.row(["initial", &joule(energy.initial_j)]);
    energies.row(["final", &joule(energy.final_j)]);
    energies.row(["kinetic", &joule(energy.kinetic_j)]);
    energies.row(["potential", &joule(energy.potential_j)]);

    format!(
        "run\n{}{}\ncertificate (largest of the run)\n{}\nenergy\n{}\nledger (lost, but for work done by forces)\n{}\n\
         ledger of momentum (lost, but for what gravity and fixed bodies gave)\n{}\n{}",
        run.print(),
        warnings(report),
        certificate(report),
        energies.print(),
        ledger(&report.ledger),
        momentum_ledger(&report.ledger.momentum),
        bodies(report)
    )
}

/// The stretches of crowded events of a run.
fn crowded(report: &RunReport) -> String {
    let (length, residual) = (number(report.crowded_s()), number(report.crowded_residual()));
    format!("{}, {length} s in all, largest residual {residual}", report.crowded.len())
}

/// The estimated error of a run: the largest, where it was, and until when it is known.
fn estimated(report: &RunReport) -> String {
    let error = &report.error;
    let Some(largest) = error.largest else {
        return match error.estimation {
            ErrorEstimation::Off => "not estimated (--error off)".to_owned(),
            _ => "not known: the run was too short to compare, or nothing that it could be compared with".to_owned(),
        };
    };
    let name = report.bodies.get(largest.body.index()).map_or("", |body| body.name.as_str());
    let told = format!(
        "{} of a body's size ({name}: {} m, {} rad, at t = {} s)",
        number(largest.relative),
        number(largest.error.position_m),
        number(largest.error.rotation_rad),
        largest.t_s
    );
    match error.horizon_s {
        Some(horizon) => format!("{told}; what lies after t = {} s is one of many outcomes", number(horizon)),
        None => told,
    }
}

/// With what a run was compared, for how long, and how far it was from it.
fn compared(reference: &ReferenceReport) -> String {
    let ended = reference.ended.as_ref().map_or_else(String::new, |why| format!("; {why}"));
    format!(
        "{} ({}) for {} s, at {} of the work: at most {} of a body's size apart{ended}",
        reference.kind.name(),
        reference.method,
        number(reference.covered_s),
        number(reference.work),
        number(reference.largest_distance)
    )
}

/// Penetration and restitution that springs at contacts were asked for and reached, and how stiff they were for the
/// steps.
fn of_springs(springs: &SpringReport) -> [String; 3] {
    let asked = springs.penetration_asked_m.map(|asked| format!(", {} m asked", number(asked))).unwrap_or_default();
    let restitution = springs.worst_restitution.as_ref().map_or_else(
        || format!("of {} contacts that ended none acted alone", springs.impacts),
        |worst| {
            let (reached, asked, t_s) = (worst.restitution(), worst.restitution_asked, worst.begun_s);
            format!(
                "{} reached, {} asked, where it was farthest off (t = {} s), of {} contacts that ended",
                number(reached),
                number(asked),
                number(t_s),
                springs.impacts
            )
        },
    );
    let restitution = springs.out_of_reach.map_or(restitution.clone(), |[asked, reached]| {
        format!("{restitution}; {} asked is beyond any damper, {} is reached", number(asked), number(reached))
    });
    let stiffness =
        format!("up to {} rad/s, times the step {}", number(springs.fastest_rad_s), number(springs.frequency_step));
    [format!("{} m reached{asked}", number(springs.penetration_m)), restitution, stiffness]
}

/// What is to be known of the run before its numbers.
fn warnings(report: &RunReport) -> String {
    let warnings = report.warnings.iter().map(|warning| format!("warning: {warning}\n"));
    let tolerated = report.tolerated.iter().map(|tolerated| format!("tolerated: {tolerated}\n"));
    let choices = report.choices.iter().map(|choice| format!("chosen: {choice}\n"));
    let all: String = warnings.chain(tolerated).chain(choices).collect();
    if all.is_empty() { all } else { format!("\n{all}") }
}

/// What the run says of its own accuracy: what was lost first, the certificate next; closure stands with the ledgers,
/// for it only checks the book-keeping.
fn certificate(report: &RunReport) -> String {
    let (ledger, certificate) = (&report.ledger, &report.certificate);
    let Certificate { max_projection_m, max_projection_j, max_penetration_m, .. } = *certificate;
    let relative = |energy_j: f64| if energy_j == 0.0 { 0.0 } else { energy_j / ledger.scale_j };
    let energy = |energy_j: f64| format!("{} ({} of the largest energy)", joule(energy_j), number(relative(energy_j)));
    let mut table = Table::default();
    table.row(["numerical loss", &energy(ledger.numerical.value())]);
    table.row(["taken by projection", &energy(ledger.projection.value())]);
    let at = at(report, certificate.max_projection_j_at);
    table.row(["largest projection, energy", &format!("{}{at}", energy(max_projection_j))]);
    let at = self::at(report, certificate.max_ended_bounces_at);
    table.row(["taken by ended bounces, beyond their energy", &energy(certificate.ended_bounces_j)]);
    table.row(["largest of these", &format!("{}{at}", energy(certificate.max_ended_bounces_j))]);
    table.row([
        "largest projection, distance",
        &with_limit(report, max_projection_m, certificate.max_projection_of_limit, certificate.max_projection_at),
    ]);
    table.row([
        "largest penetration",
        &with_limit(report, max_penetration_m, certificate.max_penetration_of_limit, certificate.max_penetration_at),
    ]);
    if certificate.max_sample_penetration_m > 0.0 {
        table.row([
            "  of the samples alone",
            &with_limit(
                report,
                certificate.max_sample_penetration_m,
                certificate.max_sample_penetration_of_limit,
                certificate.max_sample_penetration_at,
            ),
        ]);
    }
    let violation = number(certificate.max_friction_violation);
    let of_limit = of_its_limit(certificate.max_friction_violation_of_limit);
    let at = self::at(report, certificate.max_friction_violation_at);
    table.row(["largest violation of friction's law", &format!("{violation} of the largest force{of_limit}{at}")]);
    let of_limit = of_its_limit(certificate.max_residual_of_limit);
    table.row(["largest residual of a contact problem", &format!("{}{of_limit}", number(certificate.max_residual))]);
    if certificate.max_load_defect > 0.0 {
        let of_limit = of_its_limit(certificate.max_load_defect_of_limit);
        table.row([
            "loads off Newton's law, of their sum",
            &format!("{}{of_limit}", number(certificate.max_load_defect)),
        ]);
    }
    table.row(["bound on the error of an acceleration", &measured(certificate.max_acceleration_error_bound)]);
    table.row(["largest error of a step, of its tolerance", &measured(certificate.max_step_error)]);
    if let (Some(apart), Some(turned)) = (certificate.max_joint_error_m, certificate.max_joint_error_rad) {
        let of_limit = of_its_limit(certificate.max_joint_error_of_limit);
        let at = self::at(report, certificate.max_joint_error_at);
        table.row(["largest error of a joint", &format!("{} m, {} rad{of_limit}{at}", number(apart), number(turned))]);
    }
    table.row(["fallbacks", &certificate.fallbacks.to_string()]);
    table.print()
}

/// A length, how much of what is promised it is, and where that was.
fn with_limit(report: &RunReport, length_m: f64, of_limit: f64, pair: Option<PairAt>) -> String {
    format!("{} m{}{}", number(length_m), of_its_limit(of_limit), at(report, pair))
}

/// How much of a limit something is.
fn of_its_limit(of_limit: f64) -> String {
    if of_limit > 0.0 { format!(", {} of its limit", number(of_limit)) } else { String::new() }
}

/// A value, or that there is none.
fn measured(value: Option<f64>) -> String {
    value.map_or_else(|| "not measured".to_owned(), number)
}

/// Which bodies, and when.
fn at(report: &RunReport, pair: Option<PairAt>) -> String {
    let name = |body: BodyId| report.bodies.get(body.index()).map_or("", |body| body.name.as_str());
    pair.map_or_else(String::new, |pair| {
        // A joint with the world has one body.
        if pair.body_a == pair.body_b {
            return format!(": {} at t = {} s", name(pair.body_a), number(pair.t_s));
        }
        format!(": {} and {} at t = {} s", name(pair.body_a), name(pair.body_b), number(pair.t_s))
    })
}

fn ledger(ledger: &Ledger) -> String {
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
    for (name, sum) in entries {
        table.row([name, &joule(sum.value())]);
    }
    let closure = number(ledger.closure_relative());
    table.row(["closure", &format!("{closure} (relative; checks the book-keeping only)")]);
    table.print()
}

fn momentum_ledger(ledger: &MomentumLedger) -> String {
    let mut table = Table::default();
    table.row(["", "linear, N s", "angular, N m s"]);
    let entries = [
        ("given by gravity", ledger.gravity),
        ("given by fixed bodies", ledger.support),
        ("rest", ledger.rest),
        ("projection", ledger.projection),
        ("numerical", ledger.numerical),
    ];
    for (name, sum) in entries {
        table.row([name, &vector(sum.value().linear), &vector(sum.value().angular)]);
    }
    table.row(["closure", &format!("{} (relative)", number(ledger.closure_relative())), ""]);
    table.print()
}

/// Where the bodies are at the end.
fn bodies(report: &RunReport) -> String {
    let mut table = Table::default();
    table.row(["body", "position, m", "orientation wxyz", "velocity, m/s", "angular velocity, rad/s"]);
    for polhode::ReportedBody { name, state: sample, .. } in report.bodies.iter().take(MOST_BODIES) {
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

/// What is not listed.
fn rest(count: usize, elsewhere: &str) -> String {
    if count > MOST_BODIES { format!("  and {} more: see {elsewhere}\n", count - MOST_BODIES) } else { String::new() }
}

fn joule(value: f64) -> String {
    format!("{} J", number(value))
}
