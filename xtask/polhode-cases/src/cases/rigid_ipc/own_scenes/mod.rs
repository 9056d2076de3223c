//! Scenes written after the descriptions of the suite's scenes, in its own format, with meshes made here: they need no
//! data of others and go the same way as the suite's files do. SI units, degrees, y up.
//!
//! | module | holds |
//! |---|---|
//! | `units` | unit tests: features, what Erleben finds hard, tunnels, planes, stacks, rotations |
//! | `chains` | chains, a wrecking ball, a net |
//! | `machines` | a lever, a compactor, gears |
//! | `clouds` | bodies that fall on points |
//! | `screw` | a screw in a nut |
//! | `planar` | the suite's scenes in the plane, as prisms |
//! | `unheld` | scenes that friction holds there, and that nothing holds here; piles |
//! | `own_scene` | a scene in the suite's format |
//! | `meshes` | the meshes of all |
//! | `outlines` | those of `planar` |
//! | `round` | those of `unheld` |

mod chains;
mod clouds;
mod machines;
mod meshes;
mod outlines;
mod own_scene;
mod planar;
mod round;
mod screw;
mod unheld;
mod units;

pub(super) use own_scene::OwnScene;

use polhode::mesh::TriangleMesh;
use std::error::Error;

/// The mesh files that the scenes name.
pub(super) fn mesh_files() -> Result<Vec<(&'static str, TriangleMesh)>, Box<dyn Error>> {
    let mut files = vec![
        ("cube.obj", meshes::cube()?),
        ("plane.obj", meshes::plane(1)?),
        ("plane-8.obj", meshes::plane(2)?),
        ("plane-512.obj", meshes::plane(16)?),
        ("plane-8192.obj", meshes::plane(64)?),
        ("corner.obj", meshes::corner()?),
        ("crossed.obj", meshes::crossed()?),
        ("pyramid.obj", meshes::pyramid()?),
        ("spike.obj", meshes::spike()?),
        ("wedge.obj", meshes::wedge()?),
        ("crack.obj", meshes::crack()?),
        ("cliff.obj", meshes::cliff()?),
        ("internal-edges.obj", meshes::internal_edges()?),
        ("ellipsoid.obj", meshes::ellipsoid()?),
        ("link.obj", meshes::link()?),
        ("beam.obj", meshes::beam()?),
        ("knife.obj", meshes::knife()?),
        ("gear.obj", meshes::gear()?),
        ("pin.obj", meshes::pin()?),
        ("rack.obj", meshes::rack()?),
    ];
    files.extend(planar::mesh_files()?);
    files.extend(unheld::mesh_files()?);
    files.extend(screw::mesh_files()?);
    Ok(files)
}

/// The files of corners without faces that the scenes name.
pub(super) fn point_files() -> Vec<(&'static str, String)> {
    clouds::files()
}

/// All of them.
pub(super) fn all() -> Vec<OwnScene> {
    [units::all(), chains::all(), machines::all(), clouds::all(), screw::all(), planar::all(), unheld::all()]
        .into_iter()
        .flatten()
        .collect()
}
