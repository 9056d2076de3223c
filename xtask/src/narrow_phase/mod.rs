//! `cargo xtask narrow-phase`: the separating-axis test against GJK, error over the gap and time over the number of
//! edges, as a figure and a section of `docs/accuracy-and-cost.md`.
//!
//! | module | holds |
//! |---|---|
//! | [`measure`] | the pairs, their exact separations, errors and times |
//! | [`figure`] | panels with logarithmic axes as SVG |

mod figure;
mod measure;

use figure::{Panel, Series};
use measure::{GAPS, SIDES, Study};
use polhode_contact::ConvexMethod;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

/// The document and the figure, from the root of the workspace.
const DOCUMENT: &str = "docs/accuracy-and-cost.md";
const FIGURE: &str = "docs/figures/narrow-phase.svg";

/// Heading of the section, which is the last of the document.
const HEADING: &str = "\n## Narrow phase: separating axes against GJK\n";

/// Where zero is drawn, below everything that rounding leaves.
const FLOOR: f64 = 1e-18;

/// Where a gap of zero is drawn.
const ZERO_GAP: f64 = 1e-16;

/// Measures, draws, and puts the section in place of the one that stands.
///
/// # Errors
/// When a shape cannot be made or a file cannot be written.
pub(crate) fn run(root: &Path) -> Result<ExitCode, Box<dyn Error>> {
    let path = root.join(DOCUMENT);
    let document = fs::read_to_string(&path)?;
    let before = document.find(HEADING).map_or(document.as_str(), |at| &document[..at]);
    let section = section(root)?;
    fs::write(path, format!("{before}{section}"))?;
    print!("{section}");
    Ok(ExitCode::SUCCESS)
}

/// Measures, draws, and writes the section.
///
/// # Errors
/// When a shape cannot be made or the figure cannot be written.
pub(crate) fn section(root: &Path) -> Result<String, Box<dyn Error>> {
    let study = Study::run()?;
    fs::write(root.join(FIGURE), figure::svg(&panels(&study)))?;
    let mut text = format!(
        "{HEADING}\n\
         The separation of two convex polyhedra by either method (`separation_by(method, ..)`). One is above the \
         other, with a\ngap between two faces or a face and a vertex, and both are turned together at random. The \
         error is the largest over all\n\
         pairs and shapes, relative to the size; the exact gap and normal are known by construction, to the rounding \
         of the\nposes. A gap of 0 is drawn as 1e-16, an error of 0 at the bottom. Times are medians on one machine, \
         with a gap of 1e-3.\n\n\
         ![error and time of the narrow phase](figures/narrow-phase.svg)\n\n\
         | gap | separation, separating axes | separation, GJK | normal, separating axes | normal, GJK |\n\
         |---|---|---|---|---|\n"
    );
    for (k, gap) in GAPS.iter().enumerate() {
        let [axes, gjk] = study.errors.at(k);
        let _ = writeln!(
            text,
            "| {gap:.0e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} |",
            axes.separation, gjk.separation, axes.normal, gjk.normal
        );
    }
    text.push_str("\n| shape | edges | separating axes, us | GJK, us |\n|---|---|---|---|\n");
    for (k, sides) in SIDES.iter().enumerate() {
        let name = if *sides == 4 { "box".to_owned() } else { format!("{sides}-gon prism") };
        let [axes, gjk] = [study.times[0][k], study.times[1][k]];
        let _ = writeln!(text, "| {name} | {} | {axes:.2} | {gjk:.2} |", 3 * sides);
    }
    text.push_str("\n`cargo xtask narrow-phase` makes this section again.\n");
    Ok(text)
}

/// An error over the gap, of every method.
fn errors(study: &Study, of: fn(&measure::Errors) -> f64) -> Vec<Series> {
    let drawn = |gap: f64| if gap == 0.0 { ZERO_GAP } else { gap };
    let series = |(m, method): (usize, &ConvexMethod)| {
        let place = |(k, &gap): (usize, &f64)| (drawn(gap), of(&study.errors.0[m][k]).max(FLOOR));
        Series { name: method.name(), places: GAPS.iter().enumerate().map(place).collect() }
    };
    ConvexMethod::ALL.iter().enumerate().map(series).collect()
}

fn panels(study: &Study) -> [Panel; 3] {
    let times = ConvexMethod::ALL.iter().enumerate().map(|(m, method)| Series {
        name: method.name(),
        places: SIDES.iter().zip(&study.times[m]).map(|(&sides, &time)| (f64::from(3 * sides), time)).collect(),
    });
    [
        Panel { title: "error of the separation", across: "gap / size", series: errors(study, |e| e.separation) },
        Panel { title: "error of the normal, rad", across: "gap / size", series: errors(study, |e| e.normal) },
        Panel { title: "time per call, us", across: "edges of each body", series: times.collect() },
    ]
}
