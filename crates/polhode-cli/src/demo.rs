//! `polhode demo`: what the program is for, in one page that needs no words.
//!
//! Sixteen bricks without friction are in equilibrium, by so little that the errors of a method decide whether they
//! stand. They are simulated twice, by the tier `accurate` and by the algorithm of the thesis, and played side by side.

use crate::args::{ChangeArgs, DemoArgs, EffectsArg, ViewArgs};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::{stdout, view};
use std::path::PathBuf;

/// The scenes, each the other's rival.
const SCENES: [&str; 2] = ["example:diamond-4", "example:diamond-4-collapsing"];

/// Simulated time, s: until the bricks of the second have fallen.
const DURATION_S: &str = "5";

/// What the page is called when no name is asked for.
const PAGE: &str = "polhode-demo.html";

/// What the page shows, and what can be done next.
const NEXT: &str = "
Sixteen bricks without friction, twice: they are in equilibrium, by so little that the errors of a method decide whether
they stand. The first stand by tier `accurate`; the others fall by an algorithm with larger errors.

Next
  polhode new mine                        a commented scene to change: mine.toml
  polhode run mine.toml                   what happens in it, and how far to trust that
  polhode view mine.toml --open           a page that plays it
  polhode scenes                          the shipped scenes: polhode view example:NAME --open
  polhode cost example:dzhanibekov        what accuracy costs, method by method
";

/// Simulates both, writes the page, and says what can be done next.
pub(crate) fn demo(args: &DemoArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let view = ViewArgs {
        files: SCENES.map(PathBuf::from).to_vec(),
        output: vec![args.output.clone().unwrap_or_else(|| PathBuf::from(PAGE))],
        still: None,
        fps: None,
        beside: Vec::new(),
        size: None,
        camera: None,
        look_at: None,
        show: Vec::new(),
        open: args.open,
        changes: ChangeArgs {
            set: Vec::new(),
            tier: None,
            step: None,
            duration: Some(DURATION_S.to_owned()),
            effects: EffectsArg::Planned,
        },
    };
    view::view(&view, interrupt)?;
    stdout::text(NEXT)
}
