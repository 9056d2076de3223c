//! How the triangles of a mesh hang together: which share an edge, in which direction, and in which component.
//!
//! Purely combinatorial: only indices are compared, never positions. Triangles that name a vertex twice have no inside
//! and no direction; they are left out, and so must not be needed to close the surface.

use crate::TriangleMesh;
use polhode_spatial::DisjointSets;

/// One triangle's use of an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EdgeUse {
    /// Smaller vertex.
    pub(crate) low: u32,
    /// Larger vertex.
    pub(crate) high: u32,
    /// The triangle.
    pub(crate) triangle: u32,
    /// Whether the triangle runs from the smaller to the larger vertex.
    pub(crate) ascending: bool,
}

/// What the uses of an edge say about the surface there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum EdgeKind {
    /// Two triangles, in opposite directions.
    Sound,
    /// One triangle: the surface ends.
    Open,
    /// Two triangles in the same direction: one of them is the wrong way round.
    Inconsistent,
    /// Three or more triangles.
    NonManifold,
}

/// A set of triangles connected through shared edges.
#[derive(Debug, Clone, Default)]
pub(crate) struct Component {
    /// Its triangles, ascending.
    pub(crate) triangles: Vec<u32>,
    /// Whether all its edges are [`EdgeKind::Sound`].
    pub(crate) is_closed: bool,
}

/// Edges and components of a mesh.
#[derive(Debug)]
pub(crate) struct Topology {
    /// All uses of edges, ordered by edge and triangle.
    uses: Vec<EdgeUse>,
    /// Components, ordered by their first triangle.
    pub(crate) components: Vec<Component>,
}

impl Topology {
    pub(crate) fn of(mesh: &TriangleMesh) -> Self {
        let mut uses = Vec::with_capacity(3 * mesh.triangles().len());
        for (triangle, &corners) in (0u32..).zip(mesh.triangles()) {
            if names_vertex_twice(corners) {
                continue;
            }
            let [a, b, c] = corners;
            for (from, to) in [(a, b), (b, c), (c, a)] {
                uses.push(EdgeUse { low: from.min(to), high: from.max(to), triangle, ascending: from < to });
            }
        }
        uses.sort_unstable();
        let components = components(mesh, &uses);
        Self { uses, components }
    }

    /// The uses of each edge, one slice an edge, ordered by triangle within it.
    pub(crate) fn edges(&self) -> impl Iterator<Item = &[EdgeUse]> {
        edges(&self.uses)
    }
}

impl EdgeKind {
    /// Of an edge with these uses (at least one).
    pub(crate) fn of(uses: &[EdgeUse]) -> Self {
        match uses {
            [_] => Self::Open,
            [first, second] if first.ascending == second.ascending => Self::Inconsistent,
            [_, _] => Self::Sound,
            _ => Self::NonManifold,
        }
    }
}

/// Whether a triangle is a line or a point by its indices alone.
pub(crate) fn names_vertex_twice([a, b, c]: [u32; 3]) -> bool {
    a == b || b == c || c == a
}

/// The same triangle, in the same direction, beginning with its smallest index.
pub(crate) fn smallest_first([a, b, c]: [u32; 3]) -> [u32; 3] {
    if a <= b && a <= c {
        [a, b, c]
    } else if b <= c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

fn edges(uses: &[EdgeUse]) -> impl Iterator<Item = &[EdgeUse]> {
    uses.chunk_by(|first, second| (first.low, first.high) == (second.low, second.high))
}

/// Connected components by union of the triangles at each edge.
fn components(mesh: &TriangleMesh, uses: &[EdgeUse]) -> Vec<Component> {
    let mut sets = DisjointSets::new(mesh.triangles().len());
    for edge in edges(uses) {
        for pair in edge.windows(2) {
            sets.join(pair[0].triangle as usize, pair[1].triangle as usize);
        }
    }
    // Sets are known by their smallest triangle, so components come ordered by their first triangle.
    let mut component_of_first = vec![None; mesh.triangles().len()];
    let mut components: Vec<Component> = Vec::new();
    for (triangle, &corners) in (0u32..).zip(mesh.triangles()) {
        if names_vertex_twice(corners) {
            continue;
        }
        let slot = &mut component_of_first[sets.smallest(triangle as usize)];
        let index = *slot.get_or_insert_with(|| {
            components.push(Component { triangles: Vec::new(), is_closed: true });
            components.len() - 1
        });
        components[index].triangles.push(triangle);
    }
    for edge in edges(uses).filter(|edge| EdgeKind::of(edge) != EdgeKind::Sound) {
        if let Some(index) = component_of_first[sets.smallest(edge[0].triangle as usize)] {
            components[index].is_closed = false;
        }
    }
    components
}
