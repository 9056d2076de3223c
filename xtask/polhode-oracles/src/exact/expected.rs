//! Which contacts a pair of polyhedra in a general pose has, found from all axes and the outlines of two faces.
//!
//! The rules are those that polhode-contact states, evaluated by plain search over all vertices, edges and faces.
//! Whatever lies nearer to the limit of a rule than its stated clearance and the rounding of f64 may or may not be a
//! contact; pairs of which several faces of one body decide alike are set apart as ties.

use super::feature::Feature;
use super::pair::{Axis, AxisOf, Pair};
use glam::DVec3;

/// Lengths nearer to a limit than so many clearances are undecided: features in one place count as one, and the rule
/// for two vertices takes four.
const BAND: f64 = 8.0;

/// Cosine of the angle up to which normals belong to one contact region (0.01 rad).
const ALIKE: f64 = 0.999_95;

/// Cosines and unit normals nearer to each other than this are undecided.
const SAME_COSINE: f64 = 1e-8;

/// Edges whose directions differ by a smaller sine may count as parallel.
const NEARLY_PARALLEL: f64 = 1e-6;

/// Rounding of a separation along an axis in f64, relative to the scale, times the sine of the angle between its edges:
/// thirty times the machine's epsilon.
const ROUNDING: f64 = 7e-15;

/// What is expected of a pair.
#[derive(Debug)]
pub enum Expected {
    /// These contacts, and perhaps some of the others.
    Contacts {
        /// Those that must be found.
        sure: Vec<Feature>,
        /// Those that may be.
        perhaps: Vec<Feature>,
    },
    /// Several faces decide alike: any of them is right.
    Tie,
    /// Another axis decides.
    WrongAxis,
}

/// Contacts being collected.
#[derive(Default)]
struct Found {
    sure: Vec<Feature>,
    perhaps: Vec<Feature>,
}

impl Found {
    /// A contact when all `conditions` are at most zero, m; undecided near zero.
    fn offer(&mut self, feature: Feature, conditions: [f64; 2], band: f64) {
        let worst = conditions[0].max(conditions[1]);
        if worst < -band {
            self.sure.push(feature);
        } else if worst <= band {
            self.perhaps.push(feature);
        }
    }
}

impl From<Found> for Expected {
    fn from(found: Found) -> Self {
        Self::Contacts { sure: found.sure, perhaps: found.perhaps }
    }
}

/// Whether a number is above a limit; nothing when it is too near.
fn above(value: f64, limit: f64, band: f64) -> Option<bool> {
    ((value - limit).abs() > band).then_some(value > limit)
}

/// The contacts within `reach` (m) of a pair for which the crate took an axis to decide.
///
/// The crate's rule is that edges decide when they separate by more than the best face and the stated clearance, and
/// that faces within the clearance of the best face are equally good. What f64 cannot tell from the limit of the rule
/// may be decided either way; whether the axis that was taken may have been is part of the answer.
pub fn contacts(pair: &Pair<'_>, axes: &[Axis], taken: AxisOf, reach: f64) -> Expected {
    let rounding = |axis: &Axis| ROUNDING * pair.scale / axis.sine;
    let is_face = |axis: &&Axis| !matches!(axis.of, AxisOf::Edges(..));
    let best = axes.iter().filter(is_face).map(|axis| axis.separation).fold(f64::NEG_INFINITY, f64::max);
    let edges =
        axes.iter().filter(|axis| !is_face(axis) && axis.is_told()).map(|axis| axis.separation - rounding(axis));
    let best_of_edges = edges.fold(f64::NEG_INFINITY, f64::max);
    let of_taken = axes.iter().filter(|axis| axis.of == taken);
    let Some(axis) = of_taken.max_by(|x, y| x.separation.total_cmp(&y.separation)) else { return Expected::WrongAxis };
    let most = axis.separation + rounding(axis);
    if matches!(taken, AxisOf::Edges(..)) {
        let may_decide = most >= best_of_edges && most >= best + pair.clearance();
        let expected = || across_edges(pair, axis, reach).map_or(Expected::Tie, Found::into);
        return if may_decide { expected() } else { Expected::WrongAxis };
    }
    if most < best || best_of_edges > best + pair.clearance() + rounding(axis) {
        return Expected::WrongAxis;
    }
    let least = best - pair.clearance();
    if axes.iter().filter(is_face).any(|face| (face.separation - least).abs() <= rounding(face)) {
        return Expected::Tie;
    }
    let faces: Vec<&Axis> = axes.iter().filter(is_face).filter(|face| face.separation > least).collect();
    let expected = match faces[..] {
        [axis] => match axis.of {
            AxisOf::FaceA(face) => on_face(pair, axis, 0, face, reach),
            AxisOf::FaceB(face) => on_face(pair, axis, 1, face, reach),
            AxisOf::Edges(..) => None,
        },
        [x, y] if x.normal.distance(y.normal) <= SAME_COSINE => match (x.of, y.of) {
            (AxisOf::FaceA(a), AxisOf::FaceB(b)) | (AxisOf::FaceB(b), AxisOf::FaceA(a)) => {
                between_faces(pair, [a, b], None, reach)
            }
            _ => None,
        },
        _ => None,
    };
    expected.map_or(Expected::Tie, Found::into)
}

/// Two faces that lie against each other: of the overlap of their outlines, the corners whose normals are alike to
/// those of the faces that decide. These are the face that separates better, or both when they separate equally well;
/// where a crossing decides, only such as are alike to its normal. Nothing when that cannot be decided.
fn between_faces(pair: &Pair<'_>, [a, b]: [usize; 2], crossing: Option<DVec3>, reach: f64) -> Option<Found> {
    let (of_a, of_b) = (Outline::new(pair, 0, a)?, Outline::new(pair, 1, b)?);
    let normals = [-of_a.normal, of_b.normal];
    let alike = |k: usize| crossing.map_or(Some(true), |n| above(n.dot(normals[k]), ALIKE, SAME_COSINE));
    let alike = [alike(0)?, alike(1)?];
    let along = normals.map(|normal| pair.along(normal));
    let separates = |own: usize, other: usize| {
        let least = along[other] - pair.clearance();
        if alike[other] { above(along[own], least, ROUNDING * pair.scale) } else { Some(true) }
    };
    let deciding = [alike[0] && separates(0, 1)?, alike[1] && separates(1, 0)?];
    let deciding: Vec<DVec3> = (0..2).filter(|&k| deciding[k]).map(|k| normals[k]).collect();
    let mut found = Found::default();
    if belongs(normals[0], &deciding)? {
        stand_on(&mut found, pair, [&of_b, &of_a], (1, a), reach);
    }
    if belongs(normals[1], &deciding)? {
        stand_on(&mut found, pair, [&of_a, &of_b], (0, b), reach);
    }
    cross(&mut found, pair, [&of_a, &of_b], &deciding, reach);
    Some(found)
}

/// Whether a normal is alike to one of those that decide; nothing when it is too near to the limit.
fn belongs(normal: DVec3, deciding: &[DVec3]) -> Option<bool> {
    let cosine = deciding.iter().map(|d| d.dot(normal)).fold(f64::NEG_INFINITY, f64::max);
    above(cosine, ALIKE, SAME_COSINE)
}

/// A face in axes of the world: corners, unit normal, outward unit sides.
struct Outline {
    corners: Vec<DVec3>,
    vertices: Vec<usize>,
    edges: Vec<usize>,
    normal: DVec3,
    sides: Vec<DVec3>,
}

impl Outline {
    fn new(pair: &Pair<'_>, body: usize, face: usize) -> Option<Self> {
        let view = pair.bodies[body].faces.get(face)?;
        let corners: Vec<DVec3> = view.vertices.iter().map(|&v| pair.vertices[body][v]).collect();
        let normal = pair.face_normal(body, face);
        let forward = |k: usize| pair.edge(body, view.edges[k]).vertices[0] == view.vertices[k];
        let along = |k: usize| pair.direction(body, view.edges[k]) * if forward(k) { 1.0 } else { -1.0 };
        let sides = (0..corners.len()).map(|k| along(k).cross(normal).normalize()).collect();
        Some(Self { vertices: view.vertices.clone(), edges: view.edges.clone(), normal, sides, corners })
    }

    /// How far a point stands outside each side, m.
    fn outside(&self, point: DVec3) -> Vec<f64> {
        self.corners.iter().zip(&self.sides).map(|(corner, side)| side.dot(point - *corner)).collect()
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// The face of a body at its lowest vertices along `normal` that lies most nearly against it, and these vertices;
/// nothing when undecided.
fn opposing(pair: &Pair<'_>, body: usize, normal: DVec3) -> Option<(usize, Vec<usize>)> {
    let mut heights: Vec<(f64, usize)> =
        pair.vertices[body].iter().enumerate().map(|(v, p)| (p.dot(normal), v)).collect();
    heights.sort_by(|x, y| x.0.total_cmp(&y.0));
    let least = heights[0].0;
    let limit = least + pair.clearance();
    if heights.iter().any(|(height, _)| (height - limit).abs() <= ROUNDING * pair.scale) {
        return None;
    }
    let low: Vec<usize> = heights.iter().filter(|(height, _)| *height <= limit).map(|(_, v)| *v).collect();
    let at_low = |f: &usize| pair.bodies[body].faces[*f].vertices.iter().any(|v| low.contains(v));
    let mut faces: Vec<(f64, usize)> =
        (0..pair.bodies[body].faces.len()).filter(at_low).map(|f| (pair.face_normal(body, f).dot(normal), f)).collect();
    faces.sort_by(|x, y| x.0.total_cmp(&y.0));
    let decided = faces.len() > 1 && faces[1].0 - faces[0].0 > SAME_COSINE;
    decided.then(|| (faces[0].1, low))
}

/// A face of `body` decides.
fn on_face(pair: &Pair<'_>, axis: &Axis, body: usize, face: usize, reach: f64) -> Option<Found> {
    let (other, band) = (1 - body, BAND * pair.clearance());
    let outward = if body == 0 { -axis.normal } else { axis.normal };
    let (against, deepest) = opposing(pair, other, outward)?;
    let mut found = between_faces(pair, if body == 0 { [face, against] } else { [against, face] }, None, reach)?;
    if found.sure.is_empty() && axis.separation <= band {
        // Bodies that touch have a contact, also where the outlines leave none: the deepest vertex, or one of the
        // deepest.
        let is_sure = found.perhaps.is_empty() && axis.separation < -band && deepest.len() == 1;
        let deciding = deepest.into_iter().map(|v| Feature::VertexFace { vertex_of: other, vertex: v, face });
        if is_sure { found.sure.extend(deciding) } else { found.perhaps.extend(deciding) }
    }
    Some(found)
}

/// Vertices of one outline over a face.
fn stand_on(found: &mut Found, pair: &Pair<'_>, [upper, face]: [&Outline; 2], (of, index): (usize, usize), reach: f64) {
    for (&vertex, &corner) in upper.vertices.iter().zip(&upper.corners) {
        let height = face.normal.dot(corner - face.corners[0]);
        let feature = Feature::VertexFace { vertex_of: of, vertex, face: index };
        found.offer(feature, [largest(&face.outside(corner)), height - reach], BAND * pair.clearance());
    }
}

/// Crossings of the outlines of a face of A and one of B whose normals are alike to the deciding ones.
fn cross(found: &mut Found, pair: &Pair<'_>, [of_a, of_b]: [&Outline; 2], deciding: &[DVec3], reach: f64) {
    let band = BAND * pair.clearance();
    let outside_b: Vec<Vec<f64>> = of_a.corners.iter().map(|&c| of_b.outside(c)).collect();
    let outside_a: Vec<Vec<f64>> = of_b.corners.iter().map(|&c| of_a.outside(c)).collect();
    let next = |k: usize, outline: &Outline| (k + 1) % outline.corners.len();
    // Negative when the ends lie on opposite sides, m.
    let apart = |p: f64, q: f64| if p * q < 0.0 { -p.abs().min(q.abs()) } else { p.abs().min(q.abs()) };
    for i in 0..of_a.corners.len() {
        for j in 0..of_b.corners.len() {
            let (k, l) = (next(i, of_a), next(j, of_b));
            let crossing = apart(outside_b[i][j], outside_b[k][j]).max(apart(outside_a[j][i], outside_a[l][i]));
            if crossing > band {
                continue;
            }
            let (edge_a, edge_b) = (of_a.edges[i], of_b.edges[j]);
            let axis = pair.across(edge_a, edge_b);
            let belongs = if axis.sine < NEARLY_PARALLEL { None } else { belongs(axis.normal, deciding) };
            if belongs == Some(false) || axis.normal.is_nan() {
                continue;
            }
            let crossing = if belongs.is_none() { crossing.max(0.0) } else { crossing };
            let separation = (of_a.corners[i] - of_b.corners[j]).dot(axis.normal);
            found.offer(Feature::EdgeEdge { edge_a, edge_b }, [crossing, separation - reach], band);
        }
    }
}

/// Two edges decide.
fn across_edges(pair: &Pair<'_>, axis: &Axis, reach: f64) -> Option<Found> {
    let AxisOf::Edges(i, j) = axis.of else { return None };
    let (band, normal) = (BAND * pair.clearance(), axis.normal);
    let beside = |body: usize, edge: usize, sign: f64| {
        let along = |face: usize| sign * pair.face_normal(body, face).dot(normal);
        pair.edge(body, edge).faces.map(|face| (face, along(face)))
    };
    let nearer = |[first, second]: [(usize, f64); 2]| {
        above(second.1, first.1, SAME_COSINE).map(|is_second| if is_second { second.0 } else { first.0 })
    };
    let (a, b) = (beside(0, i, -1.0), beside(1, j, 1.0));
    let is_alike = |[first, second]: [(usize, f64); 2]| above(first.1.max(second.1), ALIKE, SAME_COSINE);
    let alike = [is_alike(a)?, is_alike(b)?];
    let deciding = Feature::EdgeEdge { edge_a: i, edge_b: j };
    let mut found = Found::default();
    if alike == [false; 2] {
        let beyond = if axis.separation < -band { -pair.scale } else { beyond_ends(pair, i, j) };
        found.offer(deciding, [beyond, axis.separation - reach], band);
    } else {
        found = between_faces(pair, [nearer(a)?, nearer(b)?], Some(normal), reach)?;
        if alike != [true; 2] {
            found = along_edge(pair, found, (i, j));
        }
    }
    // Bodies that touch have a contact, also where the outlines leave none.
    if found.sure.is_empty() && axis.separation <= band && !found.perhaps.contains(&deciding) {
        found.perhaps.push(deciding);
    }
    Some(found)
}

/// Contacts beside a deciding crossing where one of the faces stands at an angle: crossings beyond the ends of their
/// edges are none, and the deciding one is always there, unless another is in its place.
fn along_edge(pair: &Pair<'_>, found: Found, (i, j): (usize, usize)) -> Found {
    let band = BAND * pair.clearance();
    let mut kept = Found::default();
    for (features, is_sure) in [(found.sure, true), (found.perhaps, false)] {
        for feature in features {
            let beyond = match feature {
                Feature::EdgeEdge { edge_a, edge_b } => beyond_ends(pair, edge_a, edge_b),
                Feature::VertexFace { .. } => f64::NEG_INFINITY,
            };
            kept.offer(feature, [beyond, if is_sure { f64::NEG_INFINITY } else { 0.0 }], band);
        }
    }
    let deciding = Feature::EdgeEdge { edge_a: i, edge_b: j };
    if !kept.sure.contains(&deciding) && !kept.perhaps.contains(&deciding) {
        kept.offer(deciding, [beyond_ends(pair, i, j), f64::NEG_INFINITY], band);
    }
    kept
}

/// How far the nearest places of two lines lie beyond the ends of their edges, m.
fn beyond_ends(pair: &Pair<'_>, i: usize, j: usize) -> f64 {
    let ends = |body: usize, edge: usize| pair.edge(body, edge).vertices.map(|v| pair.vertices[body][v]);
    let ([p, q], [r, s]) = (ends(0, i), ends(1, j));
    let (u, v, w) = (q - p, s - r, r - p);
    let n = u.cross(v);
    let (on_a, on_b) = (w.cross(v).dot(n) / n.length_squared(), w.cross(u).dot(n) / n.length_squared());
    let beyond = |part: f64, length: f64| (-part).max(part - 1.0) * length;
    beyond(on_a, u.length()).max(beyond(on_b, v.length()))
}
