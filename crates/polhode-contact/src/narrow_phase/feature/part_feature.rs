//! Numbers of a compound's features: global ones among all parts, and local ones within one part.

use crate::shape::Compound;
use crate::{ContactFeature, Shape, Side, SurfaceFeature};

/// A contact feature in the local numbers of one part of each body.
pub(crate) struct Local<'a> {
    pub(crate) feature: ContactFeature,
    pub(crate) shapes: [&'a Shape; 2],
    /// The numbers of the parts; zero where a body is no compound.
    pub(crate) parts: [usize; 2],
}

/// The parts of a pair that a contact feature names, and the feature in their local numbers; none when no parts have
/// these numbers. A shape that is not a compound is returned unchanged.
#[inline]
pub(crate) fn localized<'a>(feature: ContactFeature, a: &'a Shape, b: &'a Shape) -> Option<Local<'a>> {
    match (a, b) {
        (Shape::Compound(_), _) | (_, Shape::Compound(_)) => in_parts(feature, [a, b]),
        _ => Some(Local { feature, shapes: [a, b], parts: [0; 2] }),
    }
}

/// [`localized`] for a pair with at least one compound.
fn in_parts(feature: ContactFeature, shapes: [&Shape; 2]) -> Option<Local<'_>> {
    let mut local = Local { feature, shapes, parts: [0; 2] };
    let mut take = |side: Side, kind: Kind, number: u32| -> Option<u32> {
        let at = side.index();
        let Shape::Compound(compound) = shapes[at] else { return Some(number) };
        let (part, shape, number) = compound.owner(number, |first| kind.of(first))?;
        local.parts[at] = part;
        local.shapes[at] = shape;
        Some(number)
    };
    let mut feature = match feature {
        ContactFeature::Spheres { center_a, center_b } => {
            take(Side::A, Kind::Vertex, center_a)?;
            take(Side::B, Kind::Vertex, center_b)?;
            ContactFeature::SphereSphere
        }
        ContactFeature::SphereSphere => return None,
        other => other.renumbered(take)?,
    };
    if let ContactFeature::Smooth { center_of, against, .. } = &mut feature {
        // A part that is a sphere is numbered by its centre.
        if matches!(local.shapes[center_of.other().index()], Shape::Sphere(_)) {
            *against = SurfaceFeature::Sphere;
        }
    }
    local.feature = feature;
    Some(local)
}

/// The feature in the global numbers of the two bodies; the reverse of [`localized`].
pub(crate) fn globalized(feature: ContactFeature, bodies: [&Shape; 2], parts: [usize; 2]) -> ContactFeature {
    if !bodies.iter().any(|shape| matches!(shape, Shape::Compound(_))) {
        return feature;
    }
    let compound = |side: Side| -> Option<(&Compound, usize)> {
        let at = side.index();
        if let Shape::Compound(c) = bodies[at] { Some((c, parts[at])) } else { None }
    };
    let number = |side: Side, kind: Kind, number: u32| {
        compound(side).and_then(|(c, part)| c.first.get(part)).map_or(number, |first| kind.of(first) + number)
    };
    match feature {
        ContactFeature::SphereSphere | ContactFeature::Spheres { .. } => ContactFeature::Spheres {
            center_a: number(Side::A, Kind::Vertex, 0),
            center_b: number(Side::B, Kind::Vertex, 0),
        },
        ContactFeature::Smooth { center_of, center, against: SurfaceFeature::Sphere }
            if compound(center_of.other()).is_some() =>
        {
            let against = SurfaceFeature::Vertex(number(center_of.other(), Kind::Vertex, 0));
            ContactFeature::Smooth { center_of, center: number(center_of, Kind::Vertex, center), against }
        }
        other => other.renumbered(|side, kind, n| Some(number(side, kind, n))).unwrap_or(other),
    }
}

impl ContactFeature {
    /// The same contact with its features renumbered; none when `number` returns none for one of them.
    pub(crate) fn renumbered(self, mut number: impl FnMut(Side, Kind, u32) -> Option<u32>) -> Option<Self> {
        Some(match self {
            Self::VertexFace { vertex_of, vertex, face } => Self::VertexFace {
                vertex_of,
                vertex: number(vertex_of, Kind::Vertex, vertex)?,
                face: number(vertex_of.other(), Kind::Face, face)?,
            },
            Self::EdgeEdge { edge_a, edge_b } => Self::EdgeEdge {
                edge_a: number(Side::A, Kind::Edge, edge_a)?,
                edge_b: number(Side::B, Kind::Edge, edge_b)?,
            },
            Self::Smooth { center_of, center, against } => Self::Smooth {
                center_of,
                center: number(center_of, Kind::Vertex, center)?,
                against: surface(against, |kind, n| number(center_of.other(), kind, n))?,
            },
            Self::Elements { a, b } => Self::Elements {
                a: surface(a, |kind, n| number(Side::A, kind, n))?,
                b: surface(b, |kind, n| number(Side::B, kind, n))?,
            },
            Self::SphereSphere | Self::Spheres { .. } => self,
        })
    }
}

/// A surface feature with its number replaced; none when `number` returns none.
fn surface(feature: SurfaceFeature, mut number: impl FnMut(Kind, u32) -> Option<u32>) -> Option<SurfaceFeature> {
    Some(match feature {
        SurfaceFeature::Face(n) => SurfaceFeature::Face(number(Kind::Face, n)?),
        SurfaceFeature::Edge(n) => SurfaceFeature::Edge(number(Kind::Edge, n)?),
        SurfaceFeature::Vertex(n) => SurfaceFeature::Vertex(number(Kind::Vertex, n)?),
        SurfaceFeature::Cap(n) => SurfaceFeature::Cap(number(Kind::Vertex, n)?),
        SurfaceFeature::Side(n) => SurfaceFeature::Side(number(Kind::Edge, n)?),
        SurfaceFeature::Rim(n) => SurfaceFeature::Rim(number(Kind::Edge, n)?),
        SurfaceFeature::RimExit(n) => SurfaceFeature::RimExit(number(Kind::Edge, n)?),
        SurfaceFeature::RimEntry(n) => SurfaceFeature::RimEntry(number(Kind::Edge, n)?),
        SurfaceFeature::Sphere => SurfaceFeature::Sphere,
    })
}

/// Kinds of features, each with its own numbers. Centres, points and caps are numbered as vertices, sides and rims as
/// edges, which is unambiguous because no shape has both.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    Vertex,
    Edge,
    Face,
}

impl Kind {
    const fn of(self, first: &crate::shape::FirstElements) -> u32 {
        match self {
            Self::Vertex => first.vertex,
            Self::Edge => first.edge,
            Self::Face => first.face,
        }
    }
}
