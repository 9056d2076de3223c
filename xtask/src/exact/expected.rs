//! Which contacts a pair of polyhedra in a general pose has, found from all axes and the outlines of two faces.
//!
//! The rules are those that polhode-contact states, evaluated by plain search over all vertices, edges and faces. Whatever
//! f64 cannot decide (within [`BAND`] of the scale) may or may not be a contact; pairs whose best axis is not the only one
//! are set apart as ties.

use super::pair::{Axis, AxisOf, Pair};
use glam::DVec3;
use polhode_contact::{ContactFeature, Side};

/// Lengths nearer to a limit than this times the scale are undecided: far above rounding, far below what is looked for.
const BAND: f64 = 1e-11;

/// Cosine of the angle up to which normals belong to one contact region (0.01 rad).
const ALIKE: f64 = 0.999_95;

/// Cosine of the angle (0.005 rad) up to which two faces belong to one contact region whichever of their normals and
/// those of their edges' crossings decides.
const CLEARLY_ALIKE: f64 = 0.999_987_5;

/// Cosine of 0.02 rad: normals that differ by more belong to different contact regions whichever of two almost parallel
/// faces decides.
const PERHAPS_ALIKE: f64 = 0.999_8;

/// Cosines and unit normals nearer to each other than this are undecided.
const SAME_COSINE: f64 = 1e-8;

/// Edges whose directions differ by a smaller sine may count as parallel.
const NEARLY_PARALLEL: f64 = 1e-6;

/// What is expected of a pair.
#[derive(Debug)]
pub(crate) enum Expected {
    /// These contacts, and perhaps some of the others.
    Contacts { sure: Vec<ContactFeature>, perhaps: Vec<ContactFeature> },
    /// Several axes or faces decide alike: any of them is right.
    Tie,
}

/// Contacts being collected.
#[derive(Default)]
struct Found {
    sure: Vec<ContactFeature>,
    perhaps: Vec<ContactFeature>,
}

impl Found {
    /// A contact when all `conditions` are at most zero, m; undecided near zero.
    fn offer(&mut self, feature: ContactFeature, conditions: [f64; 2], band: f64) {
        let worst = conditions[0].max(conditions[1]);
        if worst < -band {
            self.sure.push(feature);
        } else if worst <= band {
            self.perhaps.push(feature);
        }
    }
}

const SIDES: [Side; 2] = [Side::A, Side::B];

/// The contacts within `reach` (m) of a pair whose best axes are `near`, the best first.
pub(crate) fn contacts(pair: &Pair<'_>, near: &[Axis], reach: f64) -> Expected {
    let Some(best) = near.first() else { return Expected::Tie };
    if near.iter().any(|axis| axis.normal.distance(best.normal) > SAME_COSINE) {
        return Expected::Tie;
    }
    let faces: Vec<&Axis> = near.iter().filter(|axis| !matches!(axis.of, AxisOf::Edges(..))).collect();
    match faces[..] {
        [] => across_edges(pair, near, reach),
        [axis] => match axis.of {
            AxisOf::FaceA(face) => on_face(pair, axis, 0, face, reach),
            AxisOf::FaceB(face) => on_face(pair, axis, 1, face, reach),
            AxisOf::Edges(..) => Expected::Tie,
        },
        [x, y] => match (x.of, y.of) {
            (AxisOf::FaceA(a), AxisOf::FaceB(b)) | (AxisOf::FaceB(b), AxisOf::FaceA(a)) => {
                between_faces(pair, [a, b], best.normal, reach)
            }
            _ => Expected::Tie,
        },
        _ => Expected::Tie,
    }
}

/// Two faces of which at least one is almost perpendicular to the deciding normal: the overlap of their outlines.
fn between_faces(pair: &Pair<'_>, [a, b]: [usize; 2], normal: DVec3, reach: f64) -> Expected {
    let (Some(of_a), Some(of_b)) = (Outline::new(pair, 0, a), Outline::new(pair, 1, b)) else { return Expected::Tie };
    let cosines = [-of_a.normal.dot(normal), of_b.normal.dot(normal)];
    if cosines.iter().any(|cosine| (PERHAPS_ALIKE..CLEARLY_ALIKE).contains(cosine)) {
        return Expected::Tie;
    }
    let (mut found, band) = (Found::default(), BAND * pair.scale);
    if cosines[0] >= CLEARLY_ALIKE {
        stand_on(&mut found, &of_b, &of_a, Side::B, a, reach, band);
    }
    if cosines[1] >= CLEARLY_ALIKE {
        stand_on(&mut found, &of_a, &of_b, Side::A, b, reach, band);
    }
    cross(&mut found, &of_a, &of_b, (0, normal), reach, band);
    Expected::Contacts { sure: found.sure, perhaps: found.perhaps }
}

/// Contacts beside a deciding crossing, which is one of them when the bodies overlap. Where one of the faces stands at an
/// angle, other crossings are decided by the ends of their edges.
fn along_edge(expected: Expected, deciding: ContactFeature, separation: f64, band: f64) -> Expected {
    let Expected::Contacts { mut sure, mut perhaps } = expected else { return Expected::Tie };
    let crossings = sure.extract_if(.., |feature| matches!(feature, ContactFeature::EdgeEdge { .. }));
    perhaps.extend(crossings);
    if separation < -band {
        sure.push(deciding);
    } else {
        perhaps.push(deciding);
    }
    Expected::Contacts { sure, perhaps }
}

/// A face in axes of the world: corners, unit normal, outward unit sides.
struct Outline {
    corners: Vec<DVec3>,
    vertices: Vec<u32>,
    edges: Vec<u32>,
    normal: DVec3,
    sides: Vec<DVec3>,
}

impl Outline {
    fn new(pair: &Pair<'_>, body: usize, face: usize) -> Option<Self> {
        let view = pair.bodies[body].face(face)?;
        let corners: Vec<DVec3> = view.vertices.iter().map(|&v| pair.vertices[body][v as usize]).collect();
        let normal = pair.face_normal(body, face).normalize();
        let next = |k: usize| corners[(k + 1) % corners.len()];
        let sides = (0..corners.len()).map(|k| (next(k) - corners[k]).cross(normal).normalize()).collect();
        Some(Self { vertices: view.vertices.to_vec(), edges: view.edges.to_vec(), normal, sides, corners })
    }

    /// How far a point stands outside each side, m.
    fn outside(&self, point: DVec3) -> Vec<f64> {
        self.corners.iter().zip(&self.sides).map(|(corner, side)| side.dot(point - *corner)).collect()
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// The face of a body at its lowest vertex along `normal` that lies most nearly against it; nothing when undecided.
fn opposing(pair: &Pair<'_>, body: usize, normal: DVec3) -> Option<(usize, usize)> {
    let mut heights: Vec<(f64, usize)> =
        pair.vertices[body].iter().enumerate().map(|(v, p)| (p.dot(normal), v)).collect();
    heights.sort_by(|x, y| x.0.total_cmp(&y.0));
    let lowest = heights[0].1;
    if heights[1].0 - heights[0].0 < BAND * pair.scale {
        return None;
    }
    let at_lowest =
        |f: &usize| pair.bodies[body].face(*f).is_some_and(|face| face.vertices.iter().any(|&v| v as usize == lowest));
    let mut faces: Vec<(f64, usize)> = (0..pair.bodies[body].face_count())
        .filter(at_lowest)
        .map(|f| (pair.face_normal(body, f).normalize().dot(normal), f))
        .collect();
    faces.sort_by(|x, y| x.0.total_cmp(&y.0));
    let decided = faces.len() > 1 && faces[1].0 - faces[0].0 > SAME_COSINE;
    decided.then(|| (faces[0].1, lowest))
}

/// A face of `body` decides.
fn on_face(pair: &Pair<'_>, axis: &Axis, body: usize, face: usize, reach: f64) -> Expected {
    let (other, band) = (1 - body, BAND * pair.scale);
    let outward = if body == 0 { -axis.normal } else { axis.normal };
    let Some((against, deepest)) = opposing(pair, other, outward) else { return Expected::Tie };
    let (Some(below), Some(above)) = (Outline::new(pair, body, face), Outline::new(pair, other, against)) else {
        return Expected::Tie;
    };
    let alike = -below.normal.dot(above.normal) - ALIKE;
    if alike.abs() < SAME_COSINE {
        return Expected::Tie;
    }
    let mut found = Found::default();
    stand_on(&mut found, &above, &below, SIDES[other], face, reach, band);
    if alike > 0.0 {
        stand_on(&mut found, &below, &above, SIDES[body], against, reach, band);
    }
    cross(&mut found, &below, &above, (body, axis.normal), reach, band);
    let deciding = ContactFeature::VertexFace { vertex_of: SIDES[other], vertex: deepest as u32, face: face as u32 };
    if found.sure.is_empty() && axis.separation <= band {
        // Bodies that touch have a contact, also where the outlines leave none.
        let list =
            if found.perhaps.is_empty() && axis.separation < -band { &mut found.sure } else { &mut found.perhaps };
        list.push(deciding);
    }
    Expected::Contacts { sure: found.sure, perhaps: found.perhaps }
}

/// Vertices of one outline over a face.
fn stand_on(found: &mut Found, upper: &Outline, face: &Outline, of: Side, index: usize, reach: f64, band: f64) {
    for (&vertex, &corner) in upper.vertices.iter().zip(&upper.corners) {
        let height = face.normal.dot(corner - face.corners[0]);
        let feature = ContactFeature::VertexFace { vertex_of: of, vertex, face: index as u32 };
        found.offer(feature, [largest(&face.outside(corner)), height - reach], band);
    }
}

/// Crossings of two outlines whose normals are like the deciding one (from B to A); `body` owns the first outline.
fn cross(found: &mut Found, first: &Outline, second: &Outline, (body, normal): (usize, DVec3), reach: f64, band: f64) {
    let outside_second: Vec<Vec<f64>> = first.corners.iter().map(|&c| second.outside(c)).collect();
    let outside_first: Vec<Vec<f64>> = second.corners.iter().map(|&c| first.outside(c)).collect();
    let next = |k: usize, outline: &Outline| (k + 1) % outline.corners.len();
    // Negative when the ends lie on opposite sides, m.
    let apart = |p: f64, q: f64| if p * q < 0.0 { -p.abs().min(q.abs()) } else { p.abs().min(q.abs()) };
    for i in 0..first.corners.len() {
        for j in 0..second.corners.len() {
            let (k, l) = (next(i, first), next(j, second));
            let crossing =
                apart(outside_second[i][j], outside_second[k][j]).max(apart(outside_first[j][i], outside_first[l][i]));
            let along = (first.corners[k] - first.corners[i]).normalize();
            let product = along.cross((second.corners[l] - second.corners[j]).normalize());
            let cosine = product.dot(normal) / product.length();
            if crossing > band || cosine.is_nan() || cosine.abs() < PERHAPS_ALIKE {
                continue;
            }
            let between =
                if body == 0 { first.corners[i] - second.corners[j] } else { second.corners[j] - first.corners[i] };
            let separation = between.dot(product) / product.length() * cosine.signum();
            let (edge_a, edge_b) =
                if body == 0 { (first.edges[i], second.edges[j]) } else { (second.edges[j], first.edges[i]) };
            let feature = ContactFeature::EdgeEdge { edge_a, edge_b };
            let uncertain = product.length() < NEARLY_PARALLEL || cosine.abs() < CLEARLY_ALIKE;
            found.offer(feature, [if uncertain { crossing.max(0.0) } else { crossing }, separation - reach], band);
        }
    }
}

/// Two edges decide.
fn across_edges(pair: &Pair<'_>, near: &[Axis], reach: f64) -> Expected {
    let band = BAND * pair.scale;
    let normal = near[0].normal;
    let pairs = near.iter().filter_map(|x| if let AxisOf::Edges(i, j) = x.of { Some((i, j)) } else { None });
    let bearing: Vec<(usize, usize)> = pairs.collect();
    let [(i, j)] = bearing[..] else { return Expected::Tie };
    let beside = |body: usize, edge: usize, sign: f64| {
        let along = |face: u32| sign * pair.face_normal(body, face as usize).normalize().dot(normal);
        let [first, second] = pair.bodies[body].edges()[edge].faces;
        let best = if along(second) > along(first) { second } else { first };
        (best as usize, along(best))
    };
    let (a, b) = (beside(0, i, -1.0), beside(1, j, 1.0));
    if a.1.max(b.1) > ALIKE - SAME_COSINE {
        let deciding = ContactFeature::EdgeEdge { edge_a: i as u32, edge_b: j as u32 };
        let expected = between_faces(pair, [a.0, b.0], normal, reach);
        return match expected {
            Expected::Contacts { sure, perhaps } if a.1.min(b.1) > ALIKE && !sure.is_empty() => {
                Expected::Contacts { sure, perhaps }
            }
            expected => along_edge(expected, deciding, near[0].separation, band),
        };
    }
    let feature = ContactFeature::EdgeEdge { edge_a: i as u32, edge_b: j as u32 };
    let mut found = Found::default();
    let separation = near[0].separation;
    let beyond = if separation < -band { -pair.scale } else { beyond_ends(pair, i, j) };
    found.offer(feature, [beyond, separation - reach], band);
    if beyond > band && separation <= band {
        found.perhaps.push(feature);
    }
    Expected::Contacts { sure: found.sure, perhaps: found.perhaps }
}

/// How far the nearest places of two lines lie beyond the ends of their edges, m.
fn beyond_ends(pair: &Pair<'_>, i: usize, j: usize) -> f64 {
    let ends =
        |body: usize, edge: usize| pair.bodies[body].edges()[edge].vertices.map(|v| pair.vertices[body][v as usize]);
    let ([p, q], [r, s]) = (ends(0, i), ends(1, j));
    let (u, v, w) = (q - p, s - r, r - p);
    let n = u.cross(v);
    let (on_a, on_b) = (w.cross(v).dot(n) / n.length_squared(), w.cross(u).dot(n) / n.length_squared());
    let beyond = |part: f64, length: f64| (-part).max(part - 1.0) * length;
    beyond(on_a, u.length()).max(beyond(on_b, v.length()))
}
