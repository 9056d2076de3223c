//! Exact convex decomposition: a solid as convex parts that fill it and, where its surface does not cross itself, do
//! not overlap. Crossing is not looked for: of two boxes that overlap both are parts, and the volume is the sum.
//!
//! Binary space partitioning (thesis 2): while a piece has reflex edges (where its material turns through more than
//! half a turn), a plane through one of them parts it; the piece on each side is treated in the same way
//! (docs/REFERENCES.md, Chazelle 1984). A plane through a reflex edge resolves it whatever its slope; among the planes
//! of the faces beside reflex edges and the planes halfway between, the one that resolves most and cuts fewest others
//! is taken. Pieces that fall apart are parts of their own. Holes like that of a torus and voids need nothing special.
//!
//! Robust by algebra, not by luck: a face is a plane and a closed chain of edges in it, not a polygon. Cutting adds the
//! segments along the cutting line that close the chains of the two sides again, and the cap is minus their sum, the
//! same for both sides with opposite sign. So pieces are watertight and their volumes add up whatever rounding does to
//! a single sign. A vertex closer to a plane than 16 roundings counts as on it; farther ones have a certain sign.
//! A part is the exact hull of its vertices ([`ConvexHull`]): certainly convex, certainly closed; its volume is
//! compared with that of the piece, so that nothing that is not convex passes for it. Both sides of a cut begin with
//! the same vertices on it, bit by bit.
//!
//! The number of parts is not the least possible (that is NP-hard, thesis 2): n reflex edges make n / 2 + 1 parts at
//! least and about n^2 / 2 at worst. Fails by [`DecompositionError`] when there would be more parts than allowed, and
//! states the volume error of every answer.
//!
//! | module | holds |
//! |---|---|
//! | `adjacency` | which faces of a piece meet at which edges, and which of the edges are reflex |
//! | `chain` | faces as closed chains of directed edges in a plane |
//! | `choice` | which plane to cut a piece along |
//! | `cut` | cutting a piece by a plane into the piece in front and the piece behind |
//! | `faces` | the faces of a solid |
//! | `grouping` | pieces that have fallen apart |
//! | `plane` | planes that faces lie in and pieces are cut along |

mod adjacency;
mod chain;
mod choice;
mod cut;
mod faces;
mod grouping;
mod plane;

use crate::surface_integrals::triangle_area;
use crate::{ConvexHull, ConvexSolid, SolidMesh};
use adjacency::Adjacency;
use cut::{Sides, Space};
use glam::DVec3;
use grouping::Group;
use polhode_spatial::CompensatedSum;
use thiserror::Error;

/// How close to a plane a vertex counts as lying on it, in roundings of the coordinates: a vertex on an edge that has
/// been cut a few times is that far off its planes. Between 4 and 1000 the parts hardly change; volumes move by as much
/// times the area, 1e-14 of the size.
const PLANE_ROUNDINGS: f64 = 16.0;

/// How far the volume of a part may be from that of the piece it stands for, in units of the tolerance for planes times
/// the area of the part: one for the vertices that lie off their planes, the rest for rounding of both sums.
const VOLUME_TOLERANCES: f64 = 4.0;

/// What a decomposition may cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DecompositionSettings {
    /// Most parts before it is given up, at least 1. The default of 100,000 is reached by smooth surfaces of some ten
    /// thousand triangles.
    pub max_parts: usize,
    /// Most comparisons of a vertex or an edge with a plane that may be cut along before it is given up; with all that
    /// goes with them some 70 million take a second. There is no limit by default.
    pub max_comparisons: u64,
}

impl Default for DecompositionSettings {
    fn default() -> Self {
        Self { max_parts: 100_000, max_comparisons: u64::MAX }
    }
}

/// Why a solid was not decomposed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DecompositionError {
    /// There would be more parts than allowed.
    #[error(
        "the solid has {reflex_edges} reflex edges and needs more than {limit} convex parts: raise the limit, coarsen \
         the mesh, or decompose it approximately"
    )]
    TooManyParts {
        /// The limit.
        limit: usize,
        /// Reflex edges of the solid as given.
        reflex_edges: usize,
    },
    /// The search for planes to cut along would take more comparisons than allowed.
    #[error(
        "the solid has {triangles} triangles and {reflex_edges} reflex edges, and exact convex parts of it would take \
         too long to find (more than {limit} comparisons): coarsen the mesh, or decompose it approximately"
    )]
    TooMuchWork {
        /// The limit.
        limit: u64,
        /// Triangles of the solid.
        triangles: usize,
        /// Its reflex edges.
        reflex_edges: usize,
    },
}

/// A solid as convex parts.
#[derive(Debug, Clone, PartialEq)]
pub struct Decomposition {
    /// The parts, in the order in which the space was parted.
    pub parts: Vec<ConvexSolid>,
    /// Volume of the parts together, m^3.
    pub volume: f64,
    /// Difference from the volume of the solid, relative to it: what rounding of the new vertices has cost.
    pub volume_error: f64,
    /// Reflex edges of the solid as given; none means that it was convex, or several convex parts.
    pub reflex_edges: usize,
    /// Cuts that were made.
    pub cuts: usize,
    /// Parts left out because they are flat to rounding.
    pub flat_parts: usize,
    /// Pieces that are not convex and that no plane could part, with their hulls among the parts: a surface that
    /// crosses itself may have some, and the volume error tells what they cost.
    pub unresolved: usize,
}

/// Parts a solid into convex solids.
///
/// ```
/// use polhode_mesh::{DecompositionSettings, SolidMesh, convex_decomposition, obj};
/// // A step: two boxes side by side, one twice as high.
/// let file = b"v 0 0 0\nv 2 0 0\nv 2 0 1\nv 1 0 1\nv 1 0 2\nv 0 0 2\n\
///     v 0 1 0\nv 2 1 0\nv 2 1 1\nv 1 1 1\nv 1 1 2\nv 0 1 2\n\
///     f 1 2 3 4\nf 1 4 5 6\nf 10 9 8 7\nf 12 11 10 7\n\
///     f 2 1 7 8\nf 3 2 8 9\nf 4 3 9 10\nf 5 4 10 11\nf 6 5 11 12\nf 1 6 12 7\n";
/// let solid = SolidMesh::new(obj::read(file)?)?;
/// let decomposition = convex_decomposition(&solid, DecompositionSettings::default())?;
/// assert_eq!((decomposition.parts.len(), decomposition.volume), (2, 3.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DecompositionError`], when the limits of `settings` are reached.
pub fn convex_decomposition(
    solid: &SolidMesh,
    settings: DecompositionSettings,
) -> Result<Decomposition, DecompositionError> {
    let (mut space, faces) = Space::of(solid.mesh());
    let mut result = Decomposition {
        parts: Vec::new(),
        volume: 0.0,
        volume_error: 0.0,
        reflex_edges: Adjacency::of(&space, &faces).reflex.len(),
        cuts: 0,
        flat_parts: 0,
        unresolved: 0,
    };
    let limit = settings.max_parts.max(1);
    let mut stack = vec![faces];
    let mut comparisons: u64 = 0;
    while let Some(faces) = stack.pop() {
        let adjacency = Adjacency::of(&space, &faces);
        let mut groups = grouping::groups(&space, &faces, &adjacency);
        // The stack gives back the last first.
        groups.reverse();
        for group in groups {
            let plane = choice::plane_through_reflex_edge(&mut space, &group, &mut comparisons);
            let plane = plane.or_else(|| emit(&mut space, &group, &mut result));
            if let Some((plane, sides)) = plane {
                let (front, back) = cut::cut(&mut space, &group.faces, plane, &sides);
                result.cuts += 1;
                stack.extend([front, back]);
            }
        }
        if comparisons > settings.max_comparisons {
            return Err(DecompositionError::TooMuchWork {
                limit: settings.max_comparisons,
                triangles: solid.mesh().triangles().len(),
                reflex_edges: result.reflex_edges,
            });
        }
        // Every piece that waits is one part at least.
        if result.parts.len() + result.flat_parts + stack.len() > limit {
            return Err(DecompositionError::TooManyParts { limit, reflex_edges: result.reflex_edges });
        }
    }
    let whole = solid.volume_integrals().volume;
    result.volume = result.parts.iter().map(|part| part.volume_integrals().volume).collect::<CompensatedSum>().value();
    result.volume_error = (result.volume - whole) / whole;
    Ok(result)
}

/// Adds the hull of a piece's vertices to the parts; or returns the plane of a face to cut along, when the hull holds
/// more than the piece although no edge is reflex: then the piece touches itself at a vertex to rounding.
fn emit(space: &mut Space, group: &Group, result: &mut Decomposition) -> Option<(u32, Sides)> {
    let points: Vec<DVec3> = chain::vertices(&group.faces).into_iter().map(|v| space.positions[v as usize]).collect();
    let Ok(hull) = ConvexHull::of(&points) else {
        result.flat_parts += 1;
        return None;
    };
    let area: f64 = hull.solid().mesh().corner_positions().map(triangle_area).sum();
    let excess = hull.solid().volume_integrals().volume - grouping::volume(space, &group.faces);
    if excess.abs() > VOLUME_TOLERANCES * space.tolerance * area {
        let plane = choice::plane_of_dented_face(space, group);
        if plane.is_some() {
            return plane;
        }
        result.unresolved += 1;
    }
    result.parts.push(hull.into_solid());
    None
}
