//! Meshes of quadrilaterals, with what integrals over an element need.
//!
//! An element is bilinear (Q4): positions are interpolated from its four corners over the square [-1, 1]^2. Integrals
//! are taken by 2 x 2 Gauss points at +-1/sqrt(3), which is full integration: no mode of an element but the rigid ones
//! is free of energy, so there is no hourglassing. The Jacobian (m^2) is linear over an element, so that it is positive
//! everywhere when it is so at the corners. Source: docs/REFERENCES.md, Belytschko, Liu and Moran 2000, and
//! Hughes 1987. Fails: corners named clockwise, reflex corners, and nodes that are not finite are refused.

use crate::error::{ElasticError, finite, positive};
use glam::{DMat2, DVec2};

/// The most elements of a mesh: 100 MB of integrals.
pub const MOST_ELEMENTS: usize = 300_000;

/// Corners of the square that elements are interpolated over, in the order in which an element names its nodes.
const CORNERS: [DVec2; 4] =
    [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0)];

/// Elements along the side of a patch of a rectangle, at the least: larger ones would move the limit of the step by a
/// per cent.
const PATCH: usize = 4;

/// Where a Gauss point is, in units of its corner: 1/sqrt(3).
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// What an integral needs at a Gauss point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct GaussPoint {
    /// Gradients of the four interpolation functions, 1/m.
    pub(crate) gradients: [DVec2; 4],
    /// Values of the interpolation functions.
    pub(crate) values: [f64; 4],
    /// Its part of the area, m^2.
    pub(crate) weight: f64,
}

/// An element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Quad {
    /// Its corners, anticlockwise.
    pub(crate) nodes: [usize; 4],
    /// Its Gauss points.
    pub(crate) points: [GaussPoint; 4],
}

impl Quad {
    /// Its area, m^2.
    pub(crate) fn area(&self) -> f64 {
        self.points.iter().map(|point| point.weight).sum()
    }
}

/// Rows and columns of elements of a rectangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cells {
    /// Along the width.
    pub columns: usize,
    /// Along the height.
    pub rows: usize,
}

impl Cells {
    /// About so many elements that are nearly squares; none where none is asked for.
    pub fn near(width: f64, height: f64, elements: usize) -> Self {
        if elements == 0 {
            return Self { columns: 0, rows: 0 };
        }
        let most = elements as f64;
        let rows = libm::round((most * height / width).sqrt()).clamp(1.0, most);
        let columns = libm::round(most / rows).max(1.0);
        Self { columns: columns as usize, rows: rows as usize }
    }

    /// How many there are.
    pub const fn count(self) -> usize {
        self.columns.saturating_mul(self.rows)
    }

    /// These, where a mesh may have so many.
    ///
    /// # Errors
    /// No element or too many.
    pub const fn checked(self) -> Result<Self, ElasticError> {
        match self.count() {
            1..=MOST_ELEMENTS => Ok(self),
            value => Err(ElasticError::Elements { value, most: MOST_ELEMENTS }),
        }
    }

    /// Twice as many in each direction.
    pub const fn halved(self) -> Self {
        Self { columns: self.columns.saturating_mul(2), rows: self.rows.saturating_mul(2) }
    }
}

/// A mesh of quadrilaterals in the plane (x, z), none of which is folded.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadMesh {
    nodes: Vec<DVec2>,
    quads: Vec<Quad>,
    boundary: Vec<usize>,
    /// Elements in groups that together are the mesh, one of each kind: what bounds on frequencies are taken from.
    patches: Vec<Vec<usize>>,
}

impl QuadMesh {
    /// From positions (m) and the corners of the elements, anticlockwise.
    ///
    /// # Errors
    /// No element or too many, a node that does not exist or is not finite, a folded element.
    pub fn new(nodes: Vec<DVec2>, corners: &[[usize; 4]]) -> Result<Self, ElasticError> {
        if corners.is_empty() || corners.len() > MOST_ELEMENTS {
            return Err(ElasticError::Elements { value: corners.len(), most: MOST_ELEMENTS });
        }
        for value in nodes.iter().flat_map(DVec2::to_array) {
            finite("a coordinate of a node", "m", value)?;
        }
        let quad = |(element, &nodes_of): (usize, &[usize; 4])| {
            if let Some(&node) = nodes_of.iter().find(|&&node| node >= nodes.len()) {
                return Err(ElasticError::NoSuchNode { element, node, nodes: nodes.len() });
            }
            let jacobian = smallest_jacobian(nodes_of.map(|node| nodes[node]));
            if jacobian > 0.0 && jacobian.is_finite() {
                Ok(Quad { nodes: nodes_of, points: gauss_points(nodes_of.map(|node| nodes[node])) })
            } else {
                Err(ElasticError::Folded { element, jacobian })
            }
        };
        let quads = corners.iter().enumerate().map(quad).collect::<Result<Vec<_>, _>>()?;
        let boundary = boundary(corners);
        let patches = (0..quads.len()).map(|element| vec![element]).collect();
        Ok(Self { nodes, quads, boundary, patches })
    }

    /// A rectangle of width times height (m), standing on the axis x about the origin.
    ///
    /// # Errors
    /// A size that is not positive and finite, no element or too many.
    pub fn rectangle(width: f64, height: f64, cells: Cells) -> Result<Self, ElasticError> {
        positive("the width", "m", width)?;
        positive("the height", "m", height)?;
        let Cells { columns, rows } = cells.checked()?;
        // Written so that left and right mirror each other to the last bit.
        let x = |i: usize| 0.5 * width * ((2 * i) as f64 - columns as f64) / columns as f64;
        let z = |j: usize| height * j as f64 / rows as f64;
        let nodes = (0..=rows).flat_map(|j| (0..=columns).map(move |i| DVec2::new(x(i), z(j)))).collect();
        let at = |i: usize, j: usize| j * (columns + 1) + i;
        let corners: Vec<[usize; 4]> = (0..rows)
            .flat_map(|j| (0..columns).map(move |i| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
            .collect();
        let mut mesh = Self::new(nodes, &corners)?;
        let sizes = |along: usize| {
            let parts = (along / PATCH).max(1);
            if along.is_multiple_of(parts) { vec![along / parts] } else { vec![along / parts, along / parts + 1] }
        };
        let block =
            |wide: usize, high: usize| (0..high).flat_map(|j| (0..wide).map(move |i| j * columns + i)).collect();
        let across = sizes(columns);
        mesh.patches =
            sizes(rows).into_iter().flat_map(|high| across.iter().map(move |&wide| block(wide, high))).collect();
        Ok(mesh)
    }

    /// Positions of the nodes at rest, m.
    pub fn nodes(&self) -> &[DVec2] {
        &self.nodes
    }

    /// How many elements there are.
    pub const fn elements(&self) -> usize {
        self.quads.len()
    }

    /// The nodes of an element, anticlockwise; nothing where there is none.
    pub fn corners(&self, element: usize) -> Option<[usize; 4]> {
        self.quads.get(element).map(|quad| quad.nodes)
    }

    /// Nodes of the outline, ascending.
    pub fn boundary(&self) -> &[usize] {
        &self.boundary
    }

    pub(crate) fn patches(&self) -> &[Vec<usize>] {
        &self.patches
    }

    pub(crate) fn quads(&self) -> &[Quad] {
        &self.quads
    }
}

/// Columns: the derivatives of the position along the two axes of the square.
fn jacobian_matrix(corners: &[DVec2; 4], at: DVec2) -> DMat2 {
    let derivatives = derivatives(at);
    let mut matrix = DMat2::ZERO;
    for (corner, derivative) in corners.iter().zip(derivatives) {
        matrix.x_axis += *corner * derivative.x;
        matrix.y_axis += *corner * derivative.y;
    }
    matrix
}

/// Derivatives of the interpolation functions along the axes of the square.
fn derivatives(at: DVec2) -> [DVec2; 4] {
    CORNERS.map(|c| DVec2::new(c.x * (1.0 + c.y * at.y), c.y * (1.0 + c.x * at.x)) * 0.25)
}

fn smallest_jacobian(corners: [DVec2; 4]) -> f64 {
    let of = |at: DVec2| jacobian_matrix(&corners, at).determinant();
    CORNERS.map(of).into_iter().fold(f64::INFINITY, smaller)
}

/// The smaller of two numbers; what is not a number is the smallest.
pub(crate) fn smaller(a: f64, b: f64) -> f64 {
    if a.is_nan() || a <= b { a } else { b }
}

fn gauss_points(corners: [DVec2; 4]) -> [GaussPoint; 4] {
    CORNERS.map(|corner| {
        let at = corner * GAUSS;
        let matrix = jacobian_matrix(&corners, at);
        let to_gradient = matrix.inverse().transpose();
        GaussPoint {
            gradients: derivatives(at).map(|derivative| to_gradient * derivative),
            values: CORNERS.map(|c| 0.25 * (1.0 + c.x * at.x) * (1.0 + c.y * at.y)),
            weight: matrix.determinant(),
        }
    })
}

/// Nodes of sides that one element alone has.
fn boundary(corners: &[[usize; 4]]) -> Vec<usize> {
    let side = |quad: &[usize; 4], k: usize| {
        let (a, b) = (quad[k], quad[(k + 1) % 4]);
        [a.min(b), a.max(b)]
    };
    let mut sides: Vec<[usize; 2]> = corners.iter().flat_map(|quad| (0..4).map(|k| side(quad, k))).collect();
    sides.sort_unstable();
    let mut nodes: Vec<usize> =
        sides.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).flat_map(|same| same[0]).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}
