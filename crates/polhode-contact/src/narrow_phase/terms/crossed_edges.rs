//! An edge of A across an edge of B: geometry and derivatives of their separation.
//!
//! With unit vectors `e_A`, `e_B` along the edges, `N = e_A x e_B` turned to point from B to A and `n = N/|N|`, the
//! separation is `chi = (x_A - x_B) . n` for any points of the two lines. For the material points at the nearest points
//! of the lines, where `x_A - x_B = chi n`,
//!
//! `chi'  = n . (v_A - v_B)`,  `chi'' = n . (a_A - a_B) + 2 (v_A - v_B) . n' - chi |n'|^2`,
//! `n' = (1 - n n') N'/|N|`,  `N' = (w_A x e_A) x e_B + e_A x (w_B x e_B)`
//!
//! (thesis 3.4, edge-edge form of equation (18) with erratum E18, divided by `|N|` and kept exact at any separation).
//! The nearest point on A's edge moves along it at the rate `s' = (e_B x n).(chi n' - v_A + v_B)/|N|` (the condition
//! `x_A - x_B = chi n`, differentiated), and the contact point `x_A - chi n/2` with it. The outward normals of the
//! edges' faces decide the sign of `N`; the sign of the separation does not, because it may be rounding error. Fails
//! where the edges are parallel: `N` vanishes, and there is no such contact.

use crate::clearance::PARALLEL_SINE;
use crate::narrow_phase::feature::edge_line::EdgeLine;
use crate::narrow_phase::terms::tangential::ContactMotion;
use crate::{ContactGeometry, ContactKinematics, ConvexPolyhedron};
use glam::DVec3;
use polhode_spatial::{Pose, Velocity};

/// Two lines and their nearest points, in world axes.
#[derive(Clone, Copy)]
pub(crate) struct CrossedEdges {
    /// Unit normal from B to A.
    pub(crate) normal: DVec3,
    /// `|N|`: sine of the angle between the edges.
    pub(crate) sine: f64,
    /// `e_A` and `e_B`, the first turned so that `e_A x e_B` points from B to A.
    pub(crate) along_a: DVec3,
    pub(crate) along_b: DVec3,
    /// From each centre of mass to the nearest point of its edge.
    pub(crate) arm_a: DVec3,
    pub(crate) arm_b: DVec3,
    /// `chi`, m.
    pub(crate) separation: f64,
    margin: f64,
    origin_a: DVec3,
}

/// An edge in world axes, relative to its body's centre of mass.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PlacedEdge {
    middle: DVec3,
    along: DVec3,
    half_length: f64,
    /// A direction out of the body.
    outward: DVec3,
}

impl PlacedEdge {
    #[inline]
    pub(crate) fn new(edge: &EdgeLine, pose: &Pose) -> Self {
        Self {
            middle: pose.rotation.rotate(edge.middle),
            along: pose.rotation.rotate(edge.direction),
            half_length: 0.5 * edge.length,
            outward: pose.rotation.rotate(edge.outward),
        }
    }
}

/// The common perpendicular of two edges.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Perpendicular {
    cross: DVec3,
    sine: f64,
    /// Unit normal from B to A.
    pub(crate) normal: DVec3,
    along_a: DVec3,
}

impl Perpendicular {
    /// None when the edges are parallel.
    #[inline]
    pub(crate) fn new(a: &PlacedEdge, b: &PlacedEdge) -> Option<Self> {
        let cross = a.along.cross(b.along);
        let sine = cross.length();
        if sine.is_nan() || sine <= PARALLEL_SINE {
            return None;
        }
        let (normal, along_a) =
            if cross.dot(b.outward - a.outward) >= 0.0 { (cross / sine, a.along) } else { (-cross / sine, -a.along) };
        Some(Self { cross, sine, normal, along_a })
    }
}

impl CrossedEdges {
    /// None when the edges do not exist or are parallel.
    pub(crate) fn new(
        [a, b]: [&ConvexPolyhedron; 2],
        [pose_a, pose_b]: [&Pose; 2],
        [edge_a, edge_b]: [u32; 2],
    ) -> Option<Self> {
        Self::between(&EdgeLine::of_polyhedron(a, edge_a)?, pose_a, &EdgeLine::of_polyhedron(b, edge_b)?, pose_b)
    }

    /// None when the edges are parallel.
    pub(crate) fn between(a: &EdgeLine, pose_a: &Pose, b: &EdgeLine, pose_b: &Pose) -> Option<Self> {
        let (a, b) = (PlacedEdge::new(a, pose_a), PlacedEdge::new(b, pose_b));
        let perpendicular = Perpendicular::new(&a, &b)?;
        Some(Self::along(&perpendicular, &a, pose_a.translation, &b, pose_b.translation))
    }

    /// For bodies with these centres of mass in the world.
    #[inline]
    pub(crate) fn along(
        perpendicular: &Perpendicular,
        a: &PlacedEdge,
        origin_a: DVec3,
        b: &PlacedEdge,
        origin_b: DVec3,
    ) -> Self {
        let Perpendicular { cross, sine, normal, along_a } = *perpendicular;
        // Coordinates of the nearest points along the edges, measured from the midpoints, where rounding is least.
        let between = (origin_b - origin_a) + (b.middle - a.middle);
        let on_a = between.cross(b.along).dot(cross) / (sine * sine);
        let on_b = between.cross(a.along).dot(cross) / (sine * sine);
        let (to_a, to_b) = (a.along * on_a, b.along * on_b);
        Self {
            normal,
            sine,
            along_a,
            along_b: b.along,
            arm_a: a.middle + to_a,
            arm_b: b.middle + to_b,
            separation: normal.dot((to_a - to_b) - between),
            margin: (a.half_length - on_a.abs()).min(b.half_length - on_b.abs()),
            origin_a,
        }
    }

    pub(crate) fn geometry(&self) -> ContactGeometry {
        ContactGeometry {
            point: self.origin_a + (self.arm_a - self.normal * (0.5 * self.separation)),
            normal: self.normal,
            separation: self.separation,
            margin: self.margin,
        }
    }

    /// `N'`.
    pub(crate) fn normal_rate(&self, a: &Velocity, b: &Velocity) -> DVec3 {
        a.angular.cross(self.along_a).cross(self.along_b) + self.along_a.cross(b.angular.cross(self.along_b))
    }

    /// Velocity of A's material point relative to B's at the two nearest points, and `n'`.
    #[inline]
    fn rates(&self, a: &Velocity, b: &Velocity) -> (DVec3, DVec3) {
        let (n, rate) = (self.normal, self.normal_rate(a, b));
        let velocity = (a.linear - b.linear) + (a.angular.cross(self.arm_a) - b.angular.cross(self.arm_b));
        (velocity, (rate - n * n.dot(rate)) / self.sine)
    }

    #[inline]
    pub(crate) fn kinematics(&self, a: &Velocity, b: &Velocity) -> ContactKinematics {
        let n = self.normal;
        let (velocity, turning) = self.rates(a, b);
        let centripetal = a.angular.cross(a.angular.cross(self.arm_a)) - b.angular.cross(b.angular.cross(self.arm_b));
        ContactKinematics {
            geometry: self.geometry(),
            separation_rate: n.dot(velocity),
            acceleration_bias: n.dot(centripetal) + 2.0 * velocity.dot(turning)
                - self.separation * turning.length_squared(),
        }
    }

    /// The rates of the contact point and of the normal.
    pub(crate) fn motion(&self, kinematics: &ContactKinematics, a: &Velocity, b: &Velocity) -> ContactMotion {
        let n = self.normal;
        let (velocity, turning) = self.rates(a, b);
        let along = (turning * self.separation - velocity).dot(self.along_b.cross(n)) / self.sine;
        let half_gap = n * (0.5 * self.separation);
        let from_a = a.angular.cross(self.arm_a) + self.along_a * along
            - turning * (0.5 * self.separation)
            - n * (0.5 * kinematics.separation_rate);
        ContactMotion {
            normal: n,
            normal_rate: turning,
            arms: [self.arm_a - half_gap, self.arm_b + half_gap],
            point_rates: [from_a, from_a + (a.linear - b.linear)],
        }
    }
}
