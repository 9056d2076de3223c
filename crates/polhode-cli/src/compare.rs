//! `polhode compare`: two trajectories, number by number.

use crate::args::CompareArgs;
use crate::failure::Failure;
use crate::{stdout, text};
use polhode_scene::Tolerance;

/// Compares and prints the largest difference of every column; exit code 1 when they differ beyond the tolerance.
pub(crate) fn compare(args: &CompareArgs) -> Result<(), Failure> {
    let tolerance = Tolerance { absolute: args.atol, relative: args.rtol };
    let comparison = polhode_scene::compare(&args.a, &args.b, tolerance)?;
    stdout::text(&text::comparison(&comparison))?;
    // What differs has been printed.
    if comparison.agrees() { Ok(()) } else { Err(Failure::Check(String::new())) }
}
