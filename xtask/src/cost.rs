//! `cargo xtask cost`: figures and tables of `docs/accuracy-and-cost.md`, from scenes that ship.
//!
//! The program `polhode cost` does the work, so that a reader gets what is printed here from the same command. Times
//! are ratios, but they are measured: a run on another machine, or at another hour, changes their last digits. Errors
//! are the same everywhere.

use crate::contact_chart::{self, ContactStudy};
use crate::{cost_summary, narrow_phase};
use clap::Args;
use polhode_cases::cargo::cargo;
use serde_json::Value;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

/// The document, from the root of the workspace.
const DOCUMENT: &str = "docs/accuracy-and-cost.md";

/// Folder of the figures, from the root of the workspace.
const FIGURES: &str = "docs/figures";

/// The figure of all scenes, from the root of the workspace.
const SUMMARY: &str = "docs/figures/cost-summary.svg";

/// Error that the last columns of the tables ask for.
const TARGET: f64 = 1e-6;

/// The chart of contact, from the root of the workspace.
const CONTACT: &str = "docs/figures/cost-contact.svg";

/// A scene of the document.
struct PageScene {
    name: &'static str,
    /// What it is.
    what: &'static str,
    /// How much of it is run, s; all of it where nothing is said.
    duration_s: Option<&'static str>,
    /// What happens in it, for its panel in the chart of contact.
    contact: Option<&'static str>,
}

impl PageScene {
    const fn free(name: &'static str, what: &'static str) -> Self {
        Self { name, what, duration_s: None, contact: None }
    }

    const fn contact(name: &'static str, title: &'static str, what: &'static str) -> Self {
        Self { name, what, duration_s: None, contact: Some(title) }
    }
}

/// The scenes; the first with contact has the large panel of the chart.
const SCENES: [PageScene; 10] = [
    PageScene::contact(
        "box-drop",
        "A box falls on a corner, bounces, tumbles and comes to rest",
        "A box that lands on a corner, bounces and comes to rest: what counts is where impacts are.",
    ),
    PageScene::contact(
        "box-down-ramp",
        "A box slides off a ramp",
        "A box that slides down a ramp and over its edge, without friction.",
    ),
    PageScene::contact(
        "billiard-follow",
        "Billiard balls: slip, then roll",
        "A ball with follow strikes another: both slip on the cloth until they roll.",
    ),
    PageScene {
        duration_s: Some("0.5"),
        ..PageScene::contact(
            "diamond-4",
            "Sixteen bricks in balance",
            "The first half second of sixteen bricks that stand by little: nothing moves.",
        )
    },
    PageScene::free(
        "figure-02",
        "A rectangle drops flat onto a rigid floor: rigid by all methods, elastic beside the impact laws.",
    ),
    PageScene::free(
        "dzhanibekov",
        "Free rotation near the separatrix, where a small error grows with every flip. No force acts.",
    ),
    PageScene::free("thrown-l-shape", "A thrown body that tumbles: a parabola and a free rotation."),
    PageScene::free("heavy-top", "A top under gravity, held at a point: a torque that depends on the attitude."),
    PageScene::free("kepler-orbit", "A body on an orbit that turns while gravity falls off with distance."),
    PageScene::free("spring-pair", "Two bodies tied by a spring: translation and rotation drive each other."),
];

/// What stands before the table of contact.
const INTRODUCTION: &str = "# What accuracy costs

![contact: error against time, all methods](figures/cost-contact.svg)

Four shipped scenes by every method. A method that is wrong by 1 has nothing to do with the right motion any more. \
Within
the band the choice of a [law of contact](contact-methods.md) matters more than the method. Where a line is missing, the
method does not take the scene; the table says why. The heuristic is what the tier `thesis` does by itself: one line.

The smallest error of each method in this study, the error that this run told of itself, \
the seconds of computing for each
simulated second that it takes (without what the estimate takes), \
and how far its law is from the scene's where that is another:

";

/// What stands between that table and the scenes.
const READING: &str = "
![what an error costs in every scene](figures/cost-summary.svg)

Each dot is a method at its cheapest setting that reaches the error at the head of its column; the cheapest of all is
ringed and named. An empty place is a method that no setting of the study brought there.

Every scene can be run by several methods. `polhode cost SCENE` runs it by all of them over steps and tolerances, and
shows error against time; this page is made from shipped scenes by `cargo xtask cost`, and `polhode cost
fixtures/scenes/NAME.toml` prints the whole table of each.

## How to read it

- **Error** is the largest distance from the reference over the run, of positions relative to the scene's length and of
  attitudes in rad, whichever is larger. At an error of 1 the result is unrelated to the solution.
- **Reference** is the exact solution if the motion is flight in closed form, else the finest one computed. Its own
  uncertainty is stated. An error is given as `<=` that uncertainty if it is smaller. *Confirmed* is the difference from
  a method that integrates in another way.
- **Law** is no error: where bodies meet, methods may have other laws (of impacts, or springs in the place of \
impacts). Each is judged by
  the limit of its own law, computed by the most accurate tier, or by its own finest run where no other method has that
  law. How far that limit is from the limit of the scene's law stands in a column of its own, and as a line across \
the figure. It counts
  where an accuracy is asked for (`--target`, `--accuracy`): the error is then that of the method and of its law \
together.
- **Time** is a ratio: of the time of RK4 at its middle step, or of the first method where RK4 does not run alone. All
  methods take turns on the same machine, round after round, and the median of the ratios is given, so that it says
  something on other machines too. Its third digit is not reliable: caches and compilers change it.
  Reading and preparing the scene are not counted. `polhode cost --instructions` counts instructions instead, which
  repeat exactly. The upper axis of a figure has microseconds for each simulated second, on one machine.
- **Units**: the axes on the right of a figure have the same error in millimetres and in degrees, which the position and
  the attitude do not exceed.
- **Ties** are methods that reach a target and whose time cannot be told from that of the cheapest: the ranges that hold
  the middle half of the rounds of both overlap. A bar shows such a range if it is wider than a marker. A ring marks the
  cheapest method for an error of 1e-6, a dashed ring a tie. Settings of one method that made the same run, step for \
step
  and bit for bit (tolerances that nothing needs), are ties whatever their times; the first of them is named.
- **Velocity** and **energy** in the tables that `polhode cost` prints: the largest error of a velocity at the end \
of the
  run, of the largest speed (0 where all have come to rest), and what integration lost or made of the energy.
- **Told** (*estimated* in the tables that `polhode cost` prints) is the error that a run tells of itself, by runs \
beside
  it, which are not timed; it is empty where they would take too long. In the chart of a method a thin line leads there.
  Springs tell how far they are from the motion of these springs, and not from that of stiffer ones.
- **Colours** are families of methods, markers their members.
- The **Pareto front** has the methods for which no other has both a smaller error and a shorter time. In a figure it is
  the broad line: the smallest error at each time.
- The length of the step does not determine the accuracy: errors at the same step differ by ten decades.
  `polhode cost SCENE --target 1e-8` names the cheapest method that reaches an error, and
  `polhode run SCENE --accuracy 1e-8` runs by it.
- `polhode cost SCENE --vary method.integrator=rk4,cf4 --vary method.step=0.1,0.01` compares these values; any key of a
  scene can be varied.
";

/// What to regenerate.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Seconds that the methods of a scene may take together, about.
    #[arg(long, default_value_t = 40.0)]
    budget: f64,
    /// Count instructions too, and take them for the cost (needs valgrind; takes many minutes).
    #[arg(long)]
    instructions: bool,
}

/// Runs the studies and writes document and figures. A scene that does not ship is left out and named on stderr.
///
/// # Errors
/// When the program cannot be built, a study fails or a file cannot be written.
pub(crate) fn run(options: &Options, root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    fs::create_dir_all(root.join(FIGURES))?;
    let mut sections = String::new();
    let mut studies = Vec::new();
    for scene in &SCENES {
        let file = format!("fixtures/scenes/{}.toml", scene.name);
        if !root.join(&file).exists() {
            eprintln!("left out: there is no {file}");
            continue;
        }
        eprintln!("cost: {}", scene.name);
        let study = study(options, root, scene, &file)?;
        sections.push_str(&section(scene.name, scene.what, &study));
        studies.push((scene, study));
    }
    let document =
        format!("{INTRODUCTION}{}{READING}{sections}{}", contact(root, &studies)?, narrow_phase::section(root)?);
    let studies: Vec<Value> = studies.into_iter().map(|(_, study)| study).collect();
    fs::write(root.join(SUMMARY), cost_summary::svg(&studies))?;
    fs::write(root.join(DOCUMENT), document)?;
    Ok(ExitCode::SUCCESS)
}

/// Writes the chart of contact, and one for the page of each method; gives the table.
fn contact(root: &Path, studies: &[(&PageScene, Value)]) -> Result<String, Box<dyn Error>> {
    let panels = studies.iter().filter_map(|(scene, study)| Some(ContactStudy { title: scene.contact?, study }));
    let panels: Vec<ContactStudy<'_>> = panels.collect();
    fs::write(root.join(CONTACT), contact_chart::svg(&panels, None))?;
    for (page, methods) in contact_chart::PAGES {
        let figure = format!("{FIGURES}/cost-contact-{page}.svg");
        fs::write(root.join(figure), contact_chart::svg(&panels, Some(methods)))?;
    }
    Ok(contact_chart::table(&panels))
}

/// Runs the program on a scene.
fn study(options: &Options, root: &Path, scene: &PageScene, file: &str) -> Result<Value, Box<dyn Error>> {
    let figure = format!("{FIGURES}/cost-{}.svg", scene.name);
    let mut command: Command = cargo(root);
    command.args(["run", "--release", "--quiet", "--package", "polhode-cli", "--", "cost", file, "--json"]);
    command.args(["--svg", &figure, "--target", &TARGET.to_string()]).arg("--budget").arg(options.budget.to_string());
    if let Some(duration_s) = scene.duration_s {
        command.args(["--duration", duration_s]);
    }
    if options.instructions {
        command.arg("--instructions");
    }
    let output = command.stdin(Stdio::null()).stderr(Stdio::inherit()).output()?;
    // Exit code 1 says that no method reaches the target: the study is whole.
    if !matches!(output.status.code(), Some(0 | 1)) {
        return Err(format!("polhode cost {file}: {}", output.status).into());
    }
    Ok(serde_json::from_slice(&output.stdout)?)
}

/// Heading, reference, figure and tables of a scene.
fn section(name: &str, what: &str, study: &Value) -> String {
    let mut text = format!("\n## {name}\n\n{what}\n\n");
    text.push_str(&references(study));
    let unit = if word(study, "cost") == "instructions" { "instructions" } else { "time" };
    let base = word(study, "base");
    let _ = write!(text, "Times are relative to {base}.\n\n![error against cost](figures/cost-{name}.svg)\n");
    let candidates: Vec<&Value> = study["candidates"].as_array().into_iter().flatten().collect();

    let mut front: Vec<&&Value> = candidates.iter().filter(|candidate| candidate["pareto"] == true).collect();
    front.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let _ =
        write!(text, "\nThe Pareto front:\n\n| method | setting | error | told | {unit} |\n|---|---|---|---|---|\n");
    for candidate in front {
        let _ = writeln!(text, "| {} |", cells(candidate, study).join(" | "));
    }

    let step = base_step(&candidates, base);
    let which = match step {
        Some(step) => format!("at step {step} s (or nearest to the time of {base})"),
        None => format!("nearest to the time of {base}"),
    };
    let _ = write!(
        text,
        "\nEvery method {which}, and its cheapest setting for an error of {TARGET:e}:\n\n\
         | method | setting | error | told | {unit} | reaches {TARGET:e} with | in |\n|---|---|---|---|---|---|---|\n"
    );
    for method in methods(&candidates) {
        let own: Vec<&Value> =
            candidates.iter().filter(|candidate| word(candidate, "method") == method).copied().collect();
        text.push_str(&row(method, &own, step, study));
    }
    text.push_str(&elastic(&study["elastic"]));
    text
}

/// An elastic body beside the impact laws on the same drop, where the study has one.
fn elastic(beside: &Value) -> String {
    if !beside.is_object() {
        return String::new();
    }
    let mut text = format!(
        "\nThe same drop of an [elastic body](elastic-body.md) at {} m/s leaves {:.0} % of its energy as vibration. It \
         has no gravity,\n\
         which would add {} of its speed while it is on the floor.\n\n\
         | body | contact time, s | impulse, N s | effective restitution | computing, s |\n|---|---|---|---|---|\n",
        digits(&beside["speed_m_s"]),
        100.0 * beside["vibration_part"].as_f64().unwrap_or(f64::NAN),
        amount(beside["gravity_part"].as_f64().unwrap_or(f64::NAN)),
    );
    let keys = ["contact_time_s", "impulse_n_s", "restitution"];
    for mesh in beside["meshes"].as_array().into_iter().flatten() {
        let cells = keys.map(|key| digits(&mesh[key])).join(" | ");
        let _ = writeln!(text, "| elastic, {} elements | {cells} | {} |", mesh["elements"], exponent(&mesh["wall_s"]));
    }
    let limit = |key: &str| format!("{} +- {}", digits(&beside["limit"][key]), exponent(&beside["limit_error"][key]));
    let _ = writeln!(text, "| elastic, limit | {} | |", keys.map(limit).join(" | "));
    for law in beside["laws"].as_array().into_iter().flatten() {
        let cells = keys.map(|key| digits(&law[key])).join(" | ");
        let _ = writeln!(text, "| rigid, {} | {cells} | {} |", word(law, "law"), exponent(&law["wall_s"]));
    }
    text
}

/// A number in five digits.
fn digits(number: &Value) -> String {
    let number = number.as_f64().unwrap_or(f64::NAN);
    format!("{number:.4e}").parse().map_or_else(|_| number.to_string(), |short: f64| short.to_string())
}

/// What errors are relative to: the reference of the scene, and the limits of other laws.
fn references(study: &Value) -> String {
    let all: Vec<&Value> = study["references"].as_array().into_iter().flatten().collect();
    let is_own = |reference: &&&Value| reference["model"].as_object().is_none_or(serde_json::Map::is_empty);
    let mut text = String::new();
    for reference in all.iter().filter(is_own) {
        let _ =
            write!(text, "Reference: {}, known to about {}", word(reference, "kind"), exponent(&reference["error"]));
        if reference["confirmed"].is_object() {
            let confirmed = &reference["confirmed"];
            let _ = write!(text, ", confirmed by {} to {}", word(confirmed, "by"), exponent(&confirmed["error"]));
        }
        text.push_str(".\n");
    }
    let others = all.iter().filter(|reference| !is_own(reference)).filter_map(|reference| {
        let model = reference["model"].as_object()?;
        let law = model.get(contact_chart::LAW_KEY).or_else(|| model.get("method.tier"))?;
        Some(format!("{} to {}", law.as_str()?, exponent(&reference["error"])))
    });
    let others: Vec<String> = others.collect();
    if !others.is_empty() {
        let _ = writeln!(text, "Limits of other laws: {}.", others.join(", "));
    }
    text
}

/// One method: at the step, and its cheapest setting that reaches the target.
fn row(method: &str, own: &[&Value], step: Option<&str>, study: &Value) -> String {
    let ran: Vec<&Value> = own.iter().filter(|candidate| candidate["error"].is_number()).copied().collect();
    let at_step = ran.iter().find(|candidate| step.is_some() && candidate["changes"]["method.step"].as_str() == step);
    let distance = |candidate: &Value| candidate["time_ratio"].as_f64().unwrap_or(f64::INFINITY).ln().abs();
    let nearest = ran.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let Some(shown) = at_step.or(nearest) else {
        let reason = own.first().map_or("", |candidate| word(candidate, "failure"));
        return format!("| {method} | | {} | | | | |\n", reason.replace('|', "/"));
    };
    let reaching =
        ran.iter().filter(|candidate| candidate["known_error"].as_f64().is_some_and(|error| error <= TARGET));
    let cheapest = reaching.min_by(|a, b| cost(a).total_cmp(&cost(b)));
    let [setting, time] = cheapest.map_or([String::new(), String::new()], |candidate| {
        [word(candidate, "setting").to_owned(), amount(cost(candidate))]
    });
    format!("| {} | {setting} | {time} |\n", cells(shown, study).join(" | "))
}

/// Method, setting, error, what the run told of it, and cost of a candidate that ran.
fn cells(candidate: &Value, study: &Value) -> [String; 5] {
    let reference = candidate["reference"].as_u64().unwrap_or(0) as usize;
    let floor = study["references"][reference]["error"].as_f64().unwrap_or(0.0);
    let sign = if candidate["error"].as_f64().is_some_and(|error| error <= floor) { "<= " } else { "" };
    [
        word(candidate, "method").to_owned(),
        word(candidate, "setting").to_owned(),
        format!("{sign}{}", exponent(&candidate["known_error"])),
        candidate["estimated_error"].as_f64().map_or_else(String::new, |told| format!("{told:.1e}")),
        amount(cost(candidate)),
    ]
}

/// The methods in the order in which they occur.
fn methods<'a>(candidates: &[&'a Value]) -> Vec<&'a str> {
    let mut methods: Vec<&str> = candidates.iter().map(|candidate| word(candidate, "method")).collect();
    methods.dedup();
    methods
}

/// The step of the candidate whose time is the unit.
fn base_step<'a>(candidates: &[&'a Value], base: &str) -> Option<&'a str> {
    let named = |candidate: &&&Value| {
        format!("{} {}", word(candidate, "method"), word(candidate, "setting")).trim_end() == base
    };
    candidates.iter().find(named)?["changes"]["method.step"].as_str()
}

fn cost(candidate: &Value) -> f64 {
    let instructions = candidate["instructions"].as_f64();
    instructions.or(candidate["time_ratio"].as_f64()).unwrap_or(f64::NAN)
}

fn word<'a>(value: &'a Value, key: &str) -> &'a str {
    value[key].as_str().unwrap_or_default()
}

fn exponent(number: &Value) -> String {
    number.as_f64().map_or_else(String::new, |number| format!("{number:.1e}"))
}

/// Ratios from here to there are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-2..1e5;

fn amount(number: f64) -> String {
    if !PLAIN.contains(&number) {
        format!("{number:.1e}")
    } else if number < 10.0 {
        format!("{number:.2}")
    } else {
        format!("{number:.0}")
    }
}

#[cfg(test)]
mod tests {
    //! The document says what the study says, and is what the command writes.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;
    use serde_json::json;

    /// The document is what the command writes: the texts of this file stand in it, and a section and a figure for
    /// every scene. What is measured is not compared.
    #[test]
    fn the_document_is_that_of_the_command() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let document = fs::read_to_string(root.join(DOCUMENT)).unwrap();
        assert!(document.starts_with(INTRODUCTION), "run cargo xtask cost");
        assert!(document.contains(READING), "run cargo xtask cost");
        for scene in &SCENES {
            assert!(document.contains(&format!("\n## {}\n\n{}\n", scene.name, scene.what)), "{}", scene.name);
        }
        let figures = document.split("](").skip(1).filter_map(|rest| rest.split(')').next());
        for figure in figures.filter(|link| link.starts_with("figures/")) {
            assert!(root.join("docs").join(figure).exists(), "{figure}");
        }
        for (page, _) in contact_chart::PAGES {
            assert!(root.join(format!("{FIGURES}/cost-contact-{page}.svg")).exists(), "{page}");
        }
    }

    fn candidate(method: &str, step: &str, error: f64, time: f64) -> Value {
        json!({
            "method": method, "setting": format!("step {step}"), "changes": { "method.step": step }, "reference": 0,
            "error": error, "known_error": error.max(1e-9), "time_ratio": time, "instructions": null,
            "pareto": method == "cf4", "estimated_error": if step == "0.1" { Some(2.0 * error) } else { None },
        })
    }

    #[test]
    fn a_section_has_the_front_and_every_method() {
        let study = json!({
            "cost": "time_ratio", "base": "rk4 step 0.1",
            "references": [{ "kind": "finest", "error": 1e-9, "confirmed": { "by": "cf4 step 0.01", "error": 2e-9 } }],
            "candidates": [
                candidate("rk4", "0.1", 1e-3, 1.0),
                candidate("rk4", "0.01", 1e-7, 10.0),
                candidate("cf4", "0.1", 1e-12, 0.5),
                { "method": "exact", "setting": "", "changes": {}, "reference": 0, "failure": "refused" },
            ],
        });
        let text = section("test", "What it is.", &study);
        for part in [
            "Reference: finest, known to about 1.0e-9, confirmed by cf4 step 0.01 to 2.0e-9.",
            "| cf4 | step 0.1 | <= 1.0e-9 | 2.0e-12 | 0.50 |\n",
            "| rk4 | step 0.1 | 1.0e-3 | 2.0e-3 | 1.00 | step 0.01 | 10 |\n",
            "| exact | | refused | | | | |\n",
            "![error against cost](figures/cost-test.svg)",
        ] {
            assert!(text.contains(part), "{part}\n{text}");
        }
    }
}
