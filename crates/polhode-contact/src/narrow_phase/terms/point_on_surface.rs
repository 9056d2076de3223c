//! A contact of a point of one body (a vertex, a point of a cloud, a sphere's centre) with a feature of the other one's
//! surface; the formulas are in `evaluate.rs`.

use crate::narrow_phase::feature::face_border::face_margin;
use crate::narrow_phase::terms::surface_distance::{Distance, distance, from_plane};
use crate::narrow_phase::terms::tangential::ContactMotion;
use crate::shape::polyhedron::{ConvexPolyhedron, Face};
use crate::{ContactFeature, ContactGeometry, ContactKinematics, Shape, Side, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::{Pose, Velocity};

/// A point of V against a feature of E, in world axes.
pub(crate) struct PointOnSurface {
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
    pub(crate) fn new(
        feature: ContactFeature,
        shape_a: &Shape,
        pose_a: &Pose,
        shape_b: &Shape,
        pose_b: &Pose,
    ) -> Option<Self> {
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

    /// A vertex of a polyhedron V against a face of another one, E, whose normal in the world is given; none when it is
    /// higher than `reach` (m) above the face. The operations are those of [`Self::new`], bit for bit.
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

    pub(crate) fn geometry(&self) -> ContactGeometry {
        let gradient = self.distance.gradient;
        let separation = self.distance.value - self.radius_of_point - self.radius_of_surface;
        ContactGeometry {
            point: self.origin + (self.arm - gradient * (self.radius_of_point + 0.5 * separation)),
            normal: if self.center_of == Side::A { gradient } else { -gradient },
            separation,
            margin: self.distance.margin,
        }
    }

    /// The velocities of V and E, and `u`: the velocity of the point relative to E's material point that coincides with
    /// it.
    #[inline]
    fn velocities<'a>(&self, a: &'a Velocity, b: &'a Velocity) -> (&'a Velocity, &'a Velocity, DVec3) {
        let (v, e) = if self.center_of == Side::A { (a, b) } else { (b, a) };
        (v, e, (v.linear - e.linear) + (v.angular.cross(self.arm) - e.angular.cross(self.offset)))
    }

    #[inline]
    pub(crate) fn kinematics(&self, a: &Velocity, b: &Velocity) -> ContactKinematics {
        let (v, e, u) = self.velocities(a, b);
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

    /// The rates of the contact point and of the normal: `g' = w_E x g + H u`.
    pub(crate) fn motion(&self, kinematics: &ContactKinematics, a: &Velocity, b: &Velocity) -> ContactMotion {
        let (v, e, u) = self.velocities(a, b);
        let Distance { gradient: g, curvature, along, .. } = self.distance;
        let rate = kinematics.separation_rate;
        let turning = e.angular.cross(g) + (u - g * rate - along * along.dot(u)) * curvature;
        let depth = self.radius_of_point + 0.5 * kinematics.geometry.separation;
        let from_v = v.angular.cross(self.arm) - turning * depth - g * (0.5 * rate);
        let from_e = from_v + (v.linear - e.linear);
        let (arm_v, arm_e) = (self.arm - g * depth, self.offset - g * depth);
        match self.center_of {
            Side::A => {
                ContactMotion { normal: g, normal_rate: turning, arms: [arm_v, arm_e], point_rates: [from_v, from_e] }
            }
            Side::B => {
                ContactMotion { normal: -g, normal_rate: -turning, arms: [arm_e, arm_v], point_rates: [from_e, from_v] }
            }
        }
    }
}

/// The contact of a vertex of a polyhedron with a face of another whose normal in the world is given, bit for bit that
/// of [`crate::evaluate()`]; none when its separation exceeds `reach` (m).
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
