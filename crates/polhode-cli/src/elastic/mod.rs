//! `polhode elastic`: an elastic rectangle that drops onto a floor, by finite elements, and the rigid laws beside it.
//!
//! | module | holds |
//! |---|---|
//! | `rigid` | the same drop of a rigid box, by the laws of the library |
//! | `one` | one drop: meshes, limit, energies and rigid laws, as text and JSON |
//! | `table` | many drops, one a row |
//! | `picture` | the deformed mesh with its stresses as SVG |

pub(crate) mod rigid;

mod one;
mod picture;
mod table;

use crate::args::ElasticArgs;
use crate::failure::Failure;
use crate::stdout;
use polhode_elastic::{ElasticMaterial, RectangleDrop};

/// Drops the rectangle that the arguments say, or those of the table.
pub(crate) fn elastic(args: &ElasticArgs) -> Result<(), Failure> {
    let material = ElasticMaterial::new(args.young, args.poisson, args.density)?;
    if args.table {
        let rows = table::rows(args, &material)?;
        return if args.json { stdout::json(&table::json(&rows)?) } else { stdout::text(&table::text(&rows)?) };
    }
    let mut drop = RectangleDrop::new(args.width, args.height, material, args.speed)?.tilted(args.tilt.to_radians())?;
    if args.confined {
        drop = drop.confined()?;
    }
    if let Some(step_s) = args.step {
        drop = drop.step_s(step_s)?;
    }
    let one = one::Dropped::of(&drop, args.elements)?;
    if let Some(path) = &args.picture {
        picture::write(path, &drop, one.coarsest())?;
    }
    if args.json { stdout::json(&one.json()?) } else { stdout::text(&one.text()?) }
}
