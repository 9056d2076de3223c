//! Elements: features as geometric sets in a common frame, for the solution of common normals.
//!
//! Every feature of a convex shape or torus is the Minkowski sum of a locus and a ball. There are five loci: a point
//! (vertex, apex, centre), a line (edge, axis of a capsule or cylinder), a circle (rim, centre circle of a torus), the
//! lateral side of a cone, a plane (face, disc). Their outward normals `o` satisfy `o.e = 0` on a line along `e`,
//! `o.a = sin(alpha)` on a cone with axis `a` towards its apex and half angle `alpha`, and are fixed on a plane.

use crate::narrow_phase::feature::alike::ALIKE_SINE;
use crate::narrow_phase::feature::branch::Branch;
use crate::narrow_phase::feature::face_border::face_margin;
use crate::narrow_phase::feature::mesh_feature::patch_margin;
use crate::shape::TriangleMesh;
use crate::shape::circle::Circle;
use crate::shape::round::{circles, fixed_point};
use crate::{ConvexPolyhedron, Shape, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::Pose;

/// The set of points whose sum with a ball is the element.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Locus {
    Point(DVec3),
    /// Through a point, along a unit vector.
    Line(DVec3, DVec3),
    Circle(Circle),
    Cone(ConeSide),
    /// Through a point, with its outward normal.
    Plane(DVec3, DVec3),
}

/// The lateral side of a cone: apex, axis towards the apex, sine and cosine of the half angle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ConeSide {
    pub(crate) apex: DVec3,
    pub(crate) axis: DVec3,
    pub(crate) sine: f64,
    pub(crate) cosine: f64,
}

/// The border of an element.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Border<'a> {
    /// No border: the element is unbounded or complete.
    Open,
    /// The two ends of a line, at this distance from its point, m.
    Ends(f64),
    /// A cone's generator of this length, m.
    Generator(f64),
    /// A disc of this radius, m.
    Disc(f64),
    /// A rim, whose normals lie between the disc's and the side's: the unit vector along the side towards the rim is
    /// `radial` times the radial direction plus `axial` times the disc's outward normal.
    Rim { radial: f64, axial: f64 },
    /// A cap: normals in the half-space of this unit vector.
    Cap(DVec3),
    /// The apex of a cone: normals steeper than the side's.
    Apex(ConeSide),
    /// A face of a polyhedron at a pose.
    Polygon(&'a ConvexPolyhedron, u32, Pose),
    /// A face of a triangle mesh at a pose.
    Patch(&'a TriangleMesh, u32, Pose),
    /// A vertex of a polyhedron at a pose.
    Corner(&'a ConvexPolyhedron, u32, Pose),
}

/// A feature in the common frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Element<'a> {
    pub(crate) locus: Locus,
    /// Radius of the ball, m.
    pub(crate) ball: f64,
    pub(crate) branch: Branch,
    /// A direction out of the body at an edge; zero where there is none.
    pub(crate) outward: DVec3,
    pub(crate) border: Border<'a>,
}

impl<'a> Element<'a> {
    pub(crate) const fn new(locus: Locus, ball: f64, border: Border<'a>) -> Self {
        Self { locus, ball, branch: Branch::Nearest, outward: DVec3::ZERO, border }
    }

    /// Whether it is the centre circle of a torus.
    pub(crate) const fn is_ring(&self) -> bool {
        self.ball > 0.0 && matches!(self.locus, Locus::Circle(_))
    }

    /// The element of a shape at a pose; none when the shape has no such feature.
    pub(crate) fn of(shape: &'a Shape, feature: SurfaceFeature, pose: &Pose) -> Option<Self> {
        match feature {
            SurfaceFeature::Face(index) => face(shape, index, pose),
            SurfaceFeature::Edge(index) => edge(shape, index, pose),
            SurfaceFeature::Vertex(index) => vertex(shape, index, pose),
            SurfaceFeature::Sphere => {
                let Shape::Sphere(s) = shape else { return None };
                Some(Self::new(Locus::Point(pose.transform_point(s.center)), s.radius, Border::Open))
            }
            SurfaceFeature::Cap(index) => {
                let Shape::Capsule(c) = shape else { return None };
                let (end, other) = (*c.ends.get(index as usize)?, c.ends[1 - index as usize]);
                let outward = pose.rotation.rotate((end - other) / end.distance(other));
                Some(Self::new(Locus::Point(pose.transform_point(end)), c.radius, Border::Cap(outward)))
            }
            SurfaceFeature::Side(0) => side(shape, pose),
            SurfaceFeature::Side(_) => None,
            SurfaceFeature::Rim(index) => rim(shape, index, pose, Branch::Nearest),
            SurfaceFeature::RimExit(index) => rim(shape, index, pose, Branch::Exit),
            SurfaceFeature::RimEntry(index) => rim(shape, index, pose, Branch::Entry),
        }
    }

    /// The direction in which the surface is straight at a point with this unit normal: along a line or along the
    /// generator of a cone; none for other loci.
    pub(crate) fn straight_direction(&self, normal: DVec3) -> Option<DVec3> {
        match self.locus {
            Locus::Line(_, along) => Some(along),
            Locus::Cone(side) => Some(side.axis - normal * normal.dot(side.axis)),
            _ => None,
        }
    }

    /// Distance of the surface from a point of the locus along the outward normal, m: the ball's radius, plus for a
    /// point on a cone's axis the length of the normal from there to the side.
    pub(crate) fn radius_at(&self, place: DVec3) -> f64 {
        match self.locus {
            Locus::Cone(side) => self.ball + side.sine * side.axis.dot(side.apex - place),
            _ => self.ball,
        }
    }

    /// Signed distance from the border, m; negative beyond it. `place` lies on the locus, `outward` is the unit normal
    /// there. `apart` is the distance of the two loci, m: a margin of normals is an angle, and is multiplied by it
    /// to give a length.
    pub(crate) fn margin(&self, place: DVec3, outward: DVec3, apart: f64) -> f64 {
        match (self.border, self.locus) {
            (Border::Ends(half), Locus::Line(middle, along)) => half - along.dot(place - middle).abs(),
            (Border::Generator(length), Locus::Cone(side)) => {
                let down = side.cosine * side.axis.dot(side.apex - place);
                down.min(length - down)
            }
            (Border::Disc(radius), Locus::Plane(center, normal)) => {
                let from = place - center;
                radius - (from - normal * normal.dot(from)).length()
            }
            (Border::Rim { radial, axial }, Locus::Circle(circle)) => {
                let out = (place - circle.center) / circle.radius;
                let from_side = outward.dot(out) * radial + outward.dot(circle.axis) * axial;
                circle.radius * (outward.dot(out).min(from_side) + ALIKE_SINE)
            }
            (Border::Cap(away), _) => apart * (away.dot(outward) + ALIKE_SINE),
            (Border::Apex(side), _) => {
                let along = outward.dot(side.axis);
                let across = (outward - side.axis * along).length();
                apart * (along * side.cosine - across * side.sine + ALIKE_SINE)
            }
            (Border::Polygon(polyhedron, index, pose), _) => {
                let place = pose.inverse_transform_point(place);
                polyhedron.face(index as usize).map_or(f64::INFINITY, |face| face_margin(polyhedron, &face, place))
            }
            (Border::Patch(mesh, face, pose), _) => patch_margin(mesh, face, pose.inverse_transform_point(place)),
            (Border::Corner(polyhedron, index, pose), _) => {
                let outward = pose.rotation.inverse_rotate(outward);
                let beyond = |&e: &u32| {
                    let edge = &polyhedron.edges[e as usize];
                    if edge.vertices[0] == index { -edge.direction.dot(outward) } else { edge.direction.dot(outward) }
                };
                let least = polyhedron.edges_at.of(index as usize).iter().map(beyond).fold(f64::INFINITY, f64::min);
                apart * (least + ALIKE_SINE)
            }
            _ => f64::INFINITY,
        }
    }
}

fn face<'a>(shape: &'a Shape, index: u32, pose: &Pose) -> Option<Element<'a>> {
    let plane =
        |through: DVec3, normal: DVec3| Locus::Plane(pose.transform_point(through), pose.rotation.rotate(normal));
    match shape {
        Shape::HalfSpace(h) => {
            (index == 0).then(|| Element::new(plane(h.normal * h.offset, h.normal), 0.0, Border::Open))
        }
        Shape::Convex(p) => {
            let face = p.face(index as usize)?;
            let through = *p.vertices.get(*face.vertices.first()? as usize)?;
            // The vertex is projected onto the face's plane, from which it may be off by a tolerance.
            let through = through + face.normal * (face.offset - face.normal.dot(through));
            Some(Element::new(plane(through, face.normal), 0.0, Border::Polygon(p, index, *pose)))
        }
        Shape::TriangleMesh(m) => {
            let patch = m.face_plane(index)?;
            let locus = plane(patch.normal * patch.offset, patch.normal);
            Some(Element::new(locus, 0.0, Border::Patch(m, index, *pose)))
        }
        Shape::Cylinder(_) | Shape::Cone(_) => {
            let rims = circles(shape);
            let rim = rims.get(index as usize)?;
            Some(Element::new(plane(rim.center, rim.axis), 0.0, Border::Disc(rim.radius)))
        }
        _ => None,
    }
}

fn edge<'a>(shape: &'a Shape, index: u32, pose: &Pose) -> Option<Element<'a>> {
    let edge = shape.edge_line(index)?;
    let line = Locus::Line(pose.transform_point(edge.middle), pose.rotation.rotate(edge.direction));
    let mut element = Element::new(line, 0.0, Border::Ends(0.5 * edge.length));
    element.outward = pose.rotation.rotate(edge.outward);
    Some(element)
}

fn vertex<'a>(shape: &'a Shape, index: u32, pose: &Pose) -> Option<Element<'a>> {
    let (point, ball) = fixed_point(shape, index)?;
    let border = match shape {
        Shape::Convex(p) => Border::Corner(p, index, *pose),
        Shape::Cone(_) if index == 0 => match side(shape, pose)?.locus {
            Locus::Cone(side) => Border::Apex(side),
            _ => Border::Open,
        },
        _ => Border::Open,
    };
    Some(Element::new(Locus::Point(pose.transform_point(point)), ball, border))
}

fn side<'a>(shape: &'a Shape, pose: &Pose) -> Option<Element<'a>> {
    match shape {
        Shape::Capsule(c) => {
            // The length is computed in the capsule's own frame: at a far pose the rounded ends could coincide.
            let [from, to] = c.ends;
            let length = from.distance(to);
            let axis = pose.rotation.rotate((to - from) / length);
            let locus = Locus::Line(pose.transform_point(0.5 * (from + to)), axis);
            Some(Element::new(locus, c.radius, Border::Ends(0.5 * length)))
        }
        Shape::Cylinder(c) => {
            let locus = Locus::Line(pose.transform_point(c.center), pose.rotation.rotate(c.axis));
            Some(Element::new(locus, c.radius, Border::Ends(c.half_height)))
        }
        Shape::Cone(c) => {
            let length = libm::hypot(c.radius, c.height);
            let side = ConeSide {
                apex: pose.transform_point(c.apex()),
                axis: pose.rotation.rotate(c.axis),
                sine: c.radius / length,
                cosine: c.height / length,
            };
            Some(Element::new(Locus::Cone(side), 0.0, Border::Generator(length)))
        }
        _ => None,
    }
}

fn rim<'a>(shape: &'a Shape, index: u32, pose: &Pose, branch: Branch) -> Option<Element<'a>> {
    let circle = circles(shape).get(index as usize)?.placed(pose);
    let (ball, border) = match shape {
        Shape::Torus(t) => (t.minor, Border::Open),
        Shape::Cone(c) => {
            let length = libm::hypot(c.radius, c.height);
            (0.0, Border::Rim { radial: c.radius / length, axial: c.height / length })
        }
        _ => (0.0, Border::Rim { radial: 0.0, axial: 1.0 }),
    };
    // The crossings of a rim have no border of normals: on a disc that lies flat the normal is the disc's own.
    let border = if branch == Branch::Nearest { border } else { Border::Open };
    Some(Element { branch, ..Element::new(Locus::Circle(circle), ball, border) })
}
