//! The report of a run, and the plan of one.
//!
//! The first lines answer: did it end, is it right, with what was it compared, what limits it, what to do. Warnings
//! stand right below; then what happened, and the energies. The rest is for those who ask for all of it. What is absent
//! is left out.
//!
//! | module | holds |
//! |---|---|
//! | `answer` | the first lines, and the warnings |
//! | `limits` | what limits the accuracy of a run, and what to do |
//! | `comparisons` | the runs with which it was compared |
//! | `happened` | steps, events, springs; where the bodies are at the end; energies |
//! | `certificate` | what is certain about the accuracy |
//! | `ledgers` | where energy and momentum went |
//! | `plan` | methods and effects |
//! | `ended` | what is known of a run when it has ended |
//! | `words` | how numbers, bodies and places are told |

mod answer;
mod certificate;
mod comparisons;
mod ended;
mod happened;
mod ledgers;
mod limits;
mod plan;
mod words;

pub(crate) use ended::Ended;
pub(crate) use happened::accelerations;

use super::table::number;
use crate::heading::Heading;
use polhode::{Plan, Scene};
use polhode_scene::LoadedScene;

/// How much of a report is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Extent {
    /// Answer, warnings, what happened, energies.
    Short,
    /// All.
    Full,
}

/// What a run has come to.
pub(crate) fn run(loaded: &LoadedScene, ended: Ended<'_>, extent: Extent) -> String {
    let report = ended.report;
    let scene = &loaded.scene;
    let mut sections = vec![
        format!("{}{}", title(loaded), answer::answer(&ended)),
        answer::warnings(report) + &approximations(scene) + &uncertain(loaded),
    ];
    sections.push(happened::happened(&ended));
    sections.push(happened::bodies(report));
    sections.push(happened::energies(&report.energy));
    match extent {
        Extent::Short => sections.push("plan, effects, certificate and ledgers: --full\n".to_owned()),
        Extent::Full => {
            sections.insert(1, Heading::of(std::iter::once(loaded)).description_lines());
            sections.push(comparisons::all(&report.error, report.duration_s));
            sections.push(certificate::certificate(report));
            sections.push(ledgers::energy(&report.ledger));
            sections.push(ledgers::momentum(&report.ledger.momentum));
            sections.push(plan::methods_and_effects(&report.plan));
        }
    }
    sections.retain(|section| !section.is_empty());
    sections.join("\n")
}

/// The scene with what it shows, and the plan: methods, then one line per effect.
pub(crate) fn plan(loaded: &LoadedScene, plan: &Plan) -> String {
    let name = loaded.scene.name();
    let lines = Heading::of(std::iter::once(loaded)).lines(name);
    format!("scene {name}\n{lines}{}\n{}\n", approximations(&loaded.scene), plan::methods_and_effects(plan))
}

/// Name and title of the scene, in a line.
fn title(loaded: &LoadedScene) -> String {
    let (name, title) = (loaded.scene.name(), loaded.title());
    if title == name { format!("scene {name}\n") } else { format!("scene {name}: {title}\n") }
}

/// That the scene has values that are uncertain, of which a run says nothing.
fn uncertain(loaded: &LoadedScene) -> String {
    match loaded.uncertain().len() {
        0 => String::new(),
        1 => "uncertain: 1 entry of the scene, not drawn in a run: polhode sweep draws it\n".to_owned(),
        count => format!("uncertain: {count} entries of the scene, not drawn in a run: polhode sweep draws them\n"),
    }
}

/// How well convex parts fill the meshes that they stand for; one line for each such body.
pub(crate) fn approximations(scene: &Scene) -> String {
    let of_body = |body: &polhode::Body| {
        let found = body.approximation()?;
        let (name, parts, error) = (body.name(), found.parts, number(found.volume_error));
        Some(format!(
            "body {name}: {parts} convex parts stand for its mesh; error of their volume, relative: {error}\n"
        ))
    };
    scene.bodies().iter().filter_map(of_body).collect()
}
