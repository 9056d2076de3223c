//! The nearest pair of features of two polytopes around given vertices. The edges and faces adjacent to these vertices
//! are compared: every edge with every edge, every vertex with every face.

use super::found::Found;
use super::lines::nearest_points;
use super::piece::{Core, Piece};
use crate::SurfaceFeature;
use crate::narrow_phase::feature::face_border::face_margin;
use crate::shape::nearer_point::is_nearer;
use glam::DVec3;

/// The features of one polytope around some of its vertices, in the common frame.
struct Around {
    edges: Vec<(SurfaceFeature, [DVec3; 2], [u32; 2])>,
    vertices: Vec<(u32, DVec3)>,
    faces: Vec<u32>,
}

/// The nearest of the pairs; in a tie by `is_nearer` a vertex over a face of B comes first, then one over a face of A,
/// then edges.
pub(crate) fn nearest_pair(a: &Piece<'_>, b: &Piece<'_>, vertices: &[Vec<u32>; 2]) -> Found {
    let (around_a, around_b) = (around(a, &vertices[0]), around(b, &vertices[1]));
    let mut best: Option<Found> = None;
    let lengths = a.ball.1 + b.ball.1 + (a.ball.0 - b.ball.0).length();
    let support = |direction: DVec3| direction.dot(b.support(direction) - a.support(-direction));
    let mut offer = |found: Found| {
        let measured = |found: &Found| (found.distance, found.normal);
        if best.is_none_or(|best| is_nearer(measured(&found), measured(&best), lengths, support)) {
            best = Some(found);
        }
    };
    over_faces((a, &around_a), b, &around_b, &mut offer);
    over_faces((b, &around_b), a, &around_a, &mut |found| offer(found.swapped()));
    for (feature_a, edge_a, ends_a) in &around_a.edges {
        for (feature_b, edge_b, ends_b) in &around_b.edges {
            let near = nearest_points(*edge_a, *edge_b);
            // The normal of intersecting edges has an arbitrary sign; the centres of the bodies decide it.
            let outward = (b.ball.0 - a.ball.0).dot(near.normal) > 0.0;
            let touching = near.on_a == near.on_b;
            offer(Found {
                distance: near.distance,
                normal: if touching && outward { -near.normal } else { near.normal },
                on_a: near.on_a,
                on_b: near.on_b,
                feature_a: of_end(a, (*feature_a, edge_a, *ends_a), near.on_a),
                feature_b: of_end(b, (*feature_b, edge_b, *ends_b), near.on_b),
            });
        }
    }
    best.unwrap_or(Found {
        distance: 0.0,
        normal: DVec3::Z,
        on_a: a.ball.0,
        on_b: b.ball.0,
        feature_a: a.core.corner(0),
        feature_b: b.core.corner(0),
    })
}

/// The feature of an edge at a point: a vertex at its ends, otherwise the edge.
fn of_end(
    piece: &Piece<'_>,
    (edge, places, ends): (SurfaceFeature, &[DVec3; 2], [u32; 2]),
    place: DVec3,
) -> SurfaceFeature {
    let end = (0..2).find(|&end| place == places[end]);
    end.map_or(edge, |end| piece.core.corner(ends[end]))
}

fn around(piece: &Piece<'_>, vertices: &[u32]) -> Around {
    let place = |v: u32| {
        let own = piece.core.vertices();
        own.get(v as usize).map_or(piece.ball.0, |&p| piece.pose.transform_point(p))
    };
    let mut edges: Vec<(SurfaceFeature, [u32; 2])> = Vec::new();
    let mut faces = Vec::new();
    match &piece.core {
        Core::Polyhedron(polyhedron) => {
            let mut numbers: Vec<u32> =
                vertices.iter().flat_map(|&v| polyhedron.edges_at.of(v as usize)).copied().collect();
            numbers.sort_unstable();
            numbers.dedup();
            edges.extend(numbers.iter().map(|&e| (SurfaceFeature::Edge(e), polyhedron.edges[e as usize].vertices)));
            faces = vertices.iter().flat_map(|&v| polyhedron.faces_at.of(v as usize)).copied().collect();
            faces.sort_unstable();
            faces.dedup();
        }
        Core::Triangle(_) => {
            edges.extend(
                [[0, 1], [1, 2], [2, 0]].into_iter().enumerate().map(|(i, e)| (SurfaceFeature::Edge(i as u32), e)),
            );
            faces.push(0);
        }
        _ => edges.push((SurfaceFeature::Side(0), [0, 1])),
    }
    let edges = edges.into_iter().map(|(feature, ends)| (feature, ends.map(place), ends)).collect();
    Around { edges, vertices: vertices.iter().map(|&v| (v, place(v))).collect(), faces }
}

/// Calls `offer` with every vertex of `one` that lies over a face of `other`, `one` as A and `other` as B.
fn over_faces(
    (one, corners): (&Piece<'_>, &Around),
    other: &Piece<'_>,
    features: &Around,
    offer: &mut dyn FnMut(Found),
) {
    for &(vertex, place) in &corners.vertices {
        let local = other.pose.inverse_transform_point(place);
        for &index in &features.faces {
            let (normal, height) = match &other.core {
                Core::Polyhedron(polyhedron) => {
                    let Some(face) = polyhedron.face(index as usize) else { continue };
                    let height = face.normal.dot(local) - face.offset;
                    if face_margin(polyhedron, &face, local) < 0.0 || height < 0.0 {
                        continue;
                    }
                    (other.pose.rotation.rotate(face.normal), height)
                }
                core => {
                    let near = super::signed_distance::signed_distance(core, local);
                    if near.feature != SurfaceFeature::Face(0) {
                        continue;
                    }
                    (other.pose.rotation.rotate(near.normal), near.distance)
                }
            };
            offer(Found {
                distance: height,
                normal,
                on_a: place,
                on_b: place - normal * height,
                feature_a: one.core.corner(vertex),
                feature_b: SurfaceFeature::Face(index),
            });
        }
    }
}
