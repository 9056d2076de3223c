//! Whether what a robot file says fits together: masses and inertias against shapes, meshes, links that overlap.
//!
//! What a file is refused for is found while it is read and assembled; here is what would simulate and is likely not
//! what was meant.
//!
//! | module | holds |
//! |---|---|
//! | `matter` | masses, centres of mass and inertias against shapes |
//! | `mesh` | meshes that are open, inverted, mirrored or missing |
//! | `overlap` | links that overlap at the start |

mod matter;
mod mesh;
mod overlap;

use super::assemble::Placement;
use super::finding::{Finding, Findings};
use super::model::Robot;
use super::shapes::Meshes;

/// Examines a robot as it stands in a scene. It reads the meshes, which may take seconds.
pub fn examine(robot: &Robot, placement: &Placement) -> Vec<Finding> {
    let (mut meshes, mut findings) = (Meshes::new(robot.source), Findings::default());
    mesh::examine(robot, &mut meshes, &mut findings);
    for link in &robot.links {
        matter::examine(link, &mut meshes, &mut findings);
    }
    overlap::examine(robot, placement, &mut findings);
    findings.into_sorted()
}
