//! A contact of given features at any poses: its geometry, the first two time derivatives of its separation, and how the
//! contact itself moves.
//!
//! All kinds but edge against edge and pairs of curved elements are a point of a body V (a vertex, a point of a cloud, a sphere's centre) against a feature of the
//! other body E. Let `y` be the point's place in E's frame, `phi(y)` its distance from the feature and `rho` the sum
//! of the radii; then `chi = phi(y) - rho`, and with the gradient `g` and Hessian `H` of `phi`
//!
//! `chi'  = g . u`,  `chi'' = g . (a_V - a_E) + 2 u . (w_E x g) + u . H u`,
//!
//! where `u = v_V - v_E` and `a_V - a_E` are velocity and acceleration of the point relative to the place of E under
//! it: thesis 3.4, `chi''` before equation (18), extended to curved distances and to separations that are not zero.
//! `H` is 0 for a face, `(1 - g g' - e e')/phi` for an edge along `e` and `(1 - g g')/phi` for a vertex or a sphere.
//! The gradient turns with `g' = w_E x g + H u`, and with it the contact point `x_V - (rho_V + chi/2) g`: the tangential
//! terms follow from these two rates (`tangential.rs`).
//! Edge against edge has a formula of its own (`crossed_edges.rs`), and so have capsules, cylinders, cones and tori
//! (`stationary.rs`).

use crate::clearance::{COINCIDENCE, joint_size, place_tolerance};
use crate::narrow_phase::feature::element::Element;
use crate::narrow_phase::feature::mesh_feature;
use crate::narrow_phase::feature::part_feature::{Local, localized};
use crate::narrow_phase::region::round_region;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::narrow_phase::terms::stationary::Stationary;
use crate::narrow_phase::terms::tangential::ContactMotion;
use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::shape::round::is_round;
use crate::{ContactFeature, ContactGeometry, ContactKinematics, Shape, Side, SurfaceFeature, TangentialKinematics};
use glam::DVec3;
use polhode_spatial::{Pose, Velocity};

/// The contact of the same features at other poses; the manifold's own geometry comes from here.
///
/// Nothing when the features are none of these shapes', when two edges are parallel
/// ([`crate::clearance::PARALLEL_SINE`]), or when a distance that gives the normal is zero.
pub fn evaluate(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> Option<ContactGeometry> {
    by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| Some(crossed.geometry()),
        |stationary| Some(stationary.geometry(pose_a.translation)),
        |point| Some(point.geometry()),
    )
}

/// The contact with the rate of its separation and the part of the second derivative that the accelerations do not
/// decide ([`ContactKinematics`]). Velocities are of the centres of mass.
///
/// Nothing in the same cases as [`evaluate`].
pub fn kinematics(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<ContactKinematics> {
    by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| Some(crossed.kinematics(velocity_a, velocity_b)),
        |stationary| stationary.kinematics(pose_a.translation, velocity_a, velocity_b),
        |point| Some(point.kinematics(velocity_a, velocity_b)),
    )
}

/// The contact with its tangential terms too: what [`kinematics`] gives, to the bit, and what friction needs beside it
/// ([`TangentialKinematics`]), from one evaluation.
///
/// Nothing in the same cases as [`evaluate`].
pub fn kinematics_with_tangential(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<(ContactKinematics, TangentialKinematics)> {
    let (kinematics, moving) = by_kind(
        feature,
        (shape_a, pose_a),
        (shape_b, pose_b),
        |crossed| Some(crossed.with_motion(velocity_a, velocity_b)),
        |stationary| stationary.with_motion(pose_a.translation, velocity_a, velocity_b),
        |point| Some(point.with_motion(velocity_a, velocity_b)),
    )?;
    Some((kinematics, moving.tangential(velocity_a, velocity_b)))
}

/// The tangential terms of a contact alone: those of [`kinematics_with_tangential`].
///
/// Nothing in the same cases as [`evaluate`].
///
/// A ball that slides without spin slips with its own velocity; one that rolls does not slip:
/// ```
/// use polhode_contact::{ContactFeature, Shape, Side, SurfaceFeature, tangential};
/// use polhode_contact::{DVec3, Pose, UnitVector, Velocity};
/// let (ball, floor) = (Shape::sphere(0.5)?, Shape::half_space(UnitVector::Z));
/// let feature = ContactFeature::Smooth { center_of: Side::A, center: 0, against: SurfaceFeature::Face(0) };
/// let pose = Pose::from_translation(DVec3::Z * 0.5);
/// let slip = |spin: DVec3| {
///     let velocity = Velocity::new(DVec3::X, spin);
///     tangential(feature, &ball, &pose, &velocity, &floor, &Pose::IDENTITY, &Velocity::ZERO)
///         .map(|terms| terms.slip_velocity)
/// };
/// assert_eq!(slip(DVec3::ZERO), Some(DVec3::X));
/// assert_eq!(slip(DVec3::Y * 2.0), Some(DVec3::ZERO));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn tangential(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    velocity_a: &Velocity,
    shape_b: &Shape,
    pose_b: &Pose,
    velocity_b: &Velocity,
) -> Option<TangentialKinematics> {
    let both = kinematics_with_tangential(feature, shape_a, pose_a, velocity_a, shape_b, pose_b, velocity_b)?;
    Some(both.1)
}

/// What a contact answers, by the kind of its features; of compounds those of the parts.
#[inline]
fn by_kind<T>(
    feature: ContactFeature,
    (shape_a, pose_a): (&Shape, &Pose),
    (shape_b, pose_b): (&Shape, &Pose),
    of_edges: impl FnOnce(CrossedEdges) -> Option<T>,
    of_round: impl FnOnce(Stationary) -> Option<T>,
    of_point: impl FnOnce(PointOnSurface) -> Option<T>,
) -> Option<T> {
    let Local { feature, shapes: [shape_a, shape_b], .. } = localized(feature, shape_a, shape_b)?;
    if let ContactFeature::EdgeEdge { edge_a, edge_b } = feature {
        let (a, b) = (shape_a.edge_line(edge_a)?, shape_b.edge_line(edge_b)?);
        return of_edges(CrossedEdges::between(&a, pose_a, &b, pose_b)?);
    }
    if has_elements(shape_a) || has_elements(shape_b) {
        return of_round(of_elements(feature, shape_a, pose_a, shape_b, pose_b)?);
    }
    of_point(PointOnSurface::new(feature, shape_a, pose_a, shape_b, pose_b)?)
}

/// Whether the contacts of a shape are found element by element (`round`).
fn has_elements(shape: &Shape) -> bool {
    is_round(shape) || matches!(shape, Shape::Torus(_))
}

/// The elements of a contact of a round shape, in world axes relative to A's centre of mass.
fn of_elements(
    feature: ContactFeature,
    shape_a: &Shape,
    pose_a: &Pose,
    shape_b: &Shape,
    pose_b: &Pose,
) -> Option<Stationary> {
    let (part_a, part_b) = round_region::parts(feature, shape_a, shape_b)?;
    let origin_b = pose_b.translation - pose_a.translation;
    let a = Element::of(shape_a, part_a, &Pose::new(pose_a.rotation, DVec3::ZERO))?;
    let b = Element::of(shape_b, part_b, &Pose::new(pose_b.rotation, origin_b))?;
    let sizes = shape_a.size().max(shape_b.size());
    Stationary::new(&a, &b, origin_b, place_tolerance(joint_size(shape_a, shape_b), sizes, origin_b))
}

/// Distance of a point from a feature, in the frame of the feature's body.
pub(crate) struct Distance {
    value: f64,
    /// Unit vector from the feature to the point.
    gradient: DVec3,
    /// `H` is `(1 - g g' - e e')` times this, 1/m.
    curvature: f64,
    /// `e`, zero for a vertex or a sphere.
    pub(crate) along: DVec3,
    pub(crate) margin: f64,
}

/// A point of V against a feature of E, in world axes.
struct PointOnSurface {
    center_of: Side,
    /// From V's centre of mass to the point.
    arm: DVec3,
    /// From E's centre of mass to the point.
    offset: DVec3,
    /// Centre of mass of V in the world.
    origin: DVec3,
    distance: Distance,
    radius_of_point: f64,
    radius_of_surface: f64,
}

impl PointOnSurface {
    fn new(feature: ContactFeature, shape_a: &Shape, pose_a: &Pose, shape_b: &Shape, pose_b: &Pose) -> Option<Self> {
        let (center_of, center, against) = match feature {
            ContactFeature::VertexFace { vertex_of, vertex, face } => (vertex_of, vertex, SurfaceFeature::Face(face)),
            ContactFeature::Smooth { center_of, center, against } => (center_of, center, against),
            ContactFeature::SphereSphere => (Side::A, 0, SurfaceFeature::Sphere),
            ContactFeature::EdgeEdge { .. } | ContactFeature::Spheres { .. } | ContactFeature::Elements { .. } => {
                return None;
            }
        };
        let ((shape_v, pose_v), (shape_e, pose_e)) = match center_of {
            Side::A => ((shape_a, pose_a), (shape_b, pose_b)),
            Side::B => ((shape_b, pose_b), (shape_a, pose_a)),
        };
        let (centers, radius_of_point) = shape_v.centers();
        let arm = pose_v.rotation.rotate(*centers.get(center as usize)?);
        // The difference of the centres first: two bodies far from the origin lose no digits.
        let offset = (pose_v.translation - pose_e.translation) + arm;
        let mut distance = distance(shape_e, against, pose_e.rotation.inverse_rotate(offset))?;
        distance.gradient = pose_e.rotation.rotate(distance.gradient);
        if distance.along != DVec3::ZERO {
            distance.along = pose_e.rotation.rotate(distance.along);
        }
        let radius_of_surface =
            if let (Shape::Sphere(s), SurfaceFeature::Sphere) = (shape_e, against) { s.radius() } else { 0.0 };
        let origin = pose_v.translation;
        Some(Self { center_of, arm, offset, origin, distance, radius_of_point, radius_of_surface })
    }

    /// A vertex of a polyhedron V over a face of another, E, whose normal in the world is given; nothing when it is
    /// higher than `reach` (m). The operations are those of [`Self::new`].
    #[inline]
    fn above_face(
        center_of: Side,
        (vertex, pose_v): (DVec3, &Pose),
        (polyhedron, face, pose_e): (&ConvexPolyhedron, &Face<'_>, &Pose),
        normal: DVec3,
        reach: f64,
    ) -> Option<Self> {
        let arm = pose_v.rotation.rotate(vertex);
        let offset = (pose_v.translation - pose_e.translation) + arm;
        let y = pose_e.rotation.inverse_rotate(offset);
        let height = face.normal.dot(y) - face.offset;
        if height.is_nan() || height > reach {
            return None;
        }
        let distance = from_plane(normal, height, face_margin(polyhedron, face, y));
        let origin = pose_v.translation;
        Some(Self { center_of, arm, offset, origin, distance, radius_of_point: 0.0, radius_of_surface: 0.0 })
    }

    fn geometry(&self) -> ContactGeometry {
        let gradient = self.distance.gradient;
        let separation = self.distance.value - self.radius_of_point - self.radius_of_surface;
        ContactGeometry {
            point: self.origin + (self.arm - gradient * (self.radius_of_point + 0.5 * separation)),
            normal: if self.center_of == Side::A { gradient } else { -gradient },
            separation,
            margin: self.distance.margin,
        }
    }

    /// The velocity `u` of the point relative to the place of E under it. `v` moves the body V of the point, `e` the body
    /// E of the surface.
    #[inline]
    fn relative_velocity(&self, v: &Velocity, e: &Velocity) -> DVec3 {
        (v.linear - e.linear) + (v.angular.cross(self.arm) - e.angular.cross(self.offset))
    }

    /// The velocities of V and E, from those of A and B.
    #[inline]
    fn of_point_and_surface<'a>(&self, a: &'a Velocity, b: &'a Velocity) -> (&'a Velocity, &'a Velocity) {
        match self.center_of {
            Side::A => (a, b),
            Side::B => (b, a),
        }
    }

    fn kinematics(&self, a: &Velocity, b: &Velocity) -> ContactKinematics {
        let (v, e) = self.of_point_and_surface(a, b);
        self.kinematics_at(self.relative_velocity(v, e), v, e)
    }

    /// `u` is [`Self::relative_velocity`].
    #[inline]
    fn kinematics_at(&self, u: DVec3, v: &Velocity, e: &Velocity) -> ContactKinematics {
        let Distance { gradient: g, curvature, along, .. } = self.distance;
        let centripetal = v.angular.cross(v.angular.cross(self.arm)) - e.angular.cross(e.angular.cross(self.offset));
        let (rate, slip) = (g.dot(u), along.dot(u));
        let bending = curvature * (u.length_squared() - rate * rate - slip * slip);
        ContactKinematics {
            geometry: self.geometry(),
            separation_rate: rate,
            acceleration_bias: g.dot(centripetal) + 2.0 * u.dot(e.angular.cross(g)) + bending,
        }
    }

    /// The same with how the contact moves: `g' = w_E x g + H u`.
    fn with_motion(&self, a: &Velocity, b: &Velocity) -> (ContactKinematics, ContactMotion) {
        let (v, e) = self.of_point_and_surface(a, b);
        let Distance { gradient: g, curvature, along, .. } = self.distance;
        let u = self.relative_velocity(v, e);
        let kinematics = self.kinematics_at(u, v, e);
        let rate = kinematics.separation_rate;
        let turning = e.angular.cross(g) + (u - g * rate - along * along.dot(u)) * curvature;
        let depth = self.radius_of_point + 0.5 * kinematics.geometry.separation;
        let from_v = v.angular.cross(self.arm) - turning * depth - g * (0.5 * rate);
        let from_e = from_v + (v.linear - e.linear);
        let (arm_v, arm_e) = (self.arm - g * depth, self.offset - g * depth);
        let motion = match self.center_of {
            Side::A => {
                ContactMotion { normal: g, normal_rate: turning, arms: [arm_v, arm_e], point_rates: [from_v, from_e] }
            }
            Side::B => {
                ContactMotion { normal: -g, normal_rate: -turning, arms: [arm_e, arm_v], point_rates: [from_e, from_v] }
            }
        };
        (kinematics, motion)
    }
}

/// The contact of a vertex of a polyhedron with a face of another whose normal in the world is given, as [`evaluate`]
/// would give it; nothing when its separation exceeds `reach` (m).
#[inline]
pub(crate) fn vertex_above_face(
    vertex_of: Side,
    vertex: (DVec3, &Pose),
    face: (&ConvexPolyhedron, &Face<'_>, &Pose),
    normal: DVec3,
    reach: f64,
) -> Option<ContactGeometry> {
    PointOnSurface::above_face(vertex_of, vertex, face, normal, reach).map(|contact| contact.geometry())
}

/// Distance of the place `y` (frame of the shape) from one of the shape's features.
fn distance(shape: &Shape, feature: SurfaceFeature, y: DVec3) -> Option<Distance> {
    match (shape, feature) {
        (Shape::HalfSpace(h), SurfaceFeature::Face(0)) => {
            Some(from_plane(h.normal(), h.normal().dot(y) - h.offset(), f64::INFINITY))
        }
        (Shape::Convex(p), SurfaceFeature::Face(face)) => {
            let face = p.face(face as usize)?;
            Some(from_plane(face.normal, face.normal.dot(y) - face.offset, face_margin(p, &face, y)))
        }
        (Shape::Convex(p), SurfaceFeature::Edge(edge)) => from_edge(p, edge as usize, y),
        (Shape::Convex(p), SurfaceFeature::Vertex(vertex)) => from_vertex(p, vertex as usize, y),
        (Shape::TriangleMesh(mesh), feature) => mesh_feature::distance_of(mesh, feature, y),
        (Shape::Sphere(s), SurfaceFeature::Sphere) => {
            from_point(y - s.center(), COINCIDENCE * s.radius(), f64::INFINITY)
        }
        _ => None,
    }
}

pub(crate) fn from_plane(normal: DVec3, value: f64, margin: f64) -> Distance {
    Distance { value, gradient: normal, curvature: 0.0, along: DVec3::ZERO, margin }
}

/// Signed distance of a place over a face from the face's border, m; positive inside.
#[inline]
pub(crate) fn face_margin(polyhedron: &ConvexPolyhedron, face: &Face<'_>, y: DVec3) -> f64 {
    let mut least = f64::INFINITY;
    for (vertex, side) in face.vertices.iter().zip(face.sides) {
        let inward = side.dot(polyhedron.vertices[*vertex as usize] - y);
        // The minimum, which has to be asked only of what compares as neither less nor greater.
        if inward < least {
            least = inward;
        } else if inward == least || inward.is_nan() {
            least = least.min(inward);
        }
    }
    least
}

/// The Voronoi region of an edge ends at its two vertices and where either of its faces begins.
fn from_edge(polyhedron: &ConvexPolyhedron, index: usize, y: DVec3) -> Option<Distance> {
    let edge = polyhedron.edges.get(index)?;
    let w = y - polyhedron.vertices[edge.vertices[0] as usize];
    let along = edge.direction.dot(w);
    let mut distance = from_point(w - edge.direction * along, COINCIDENCE * polyhedron.size, f64::INFINITY)?;
    distance.along = edge.direction;
    let [left, right] = edge.faces.map(|f| polyhedron.faces[f as usize].normal);
    let (side_left, side_right) = (edge.direction.cross(left), -edge.direction.cross(right));
    distance.margin = along.min(edge.length - along).min(side_left.dot(w)).min(side_right.dot(w));
    Some(distance)
}

/// The Voronoi region of a vertex ends where one of its edges begins.
fn from_vertex(polyhedron: &ConvexPolyhedron, index: usize, y: DVec3) -> Option<Distance> {
    let w = y - *polyhedron.vertices.get(index)?;
    let beyond = |&e: &u32| {
        let edge = &polyhedron.edges[e as usize];
        if edge.vertices[0] as usize == index { -edge.direction.dot(w) } else { edge.direction.dot(w) }
    };
    let margin = polyhedron.edges_at.of(index).iter().map(beyond).fold(f64::INFINITY, f64::min);
    from_point(w, COINCIDENCE * polyhedron.size, margin)
}

/// Distance along `w` from a point or an edge; nothing when it is too short (`least`, m) to have a direction, or so long
/// that its square overflows.
pub(crate) fn from_point(w: DVec3, least: f64, margin: f64) -> Option<Distance> {
    let value = w.length();
    (value > least && value.is_finite()).then(|| Distance {
        value,
        gradient: w / value,
        curvature: 1.0 / value,
        along: DVec3::ZERO,
        margin,
    })
}
