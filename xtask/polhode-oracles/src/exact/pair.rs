//! Two convex polyhedra in one exact frame: separations along axes, and the best of all axes.
//!
//! The frame has its origin at A's and axes of the world, and lengths are multiplied by `D = |q_A|^2 |q_B|^2`. Normals
//! of faces and directions of edges come from the exact vertices. Every separation is between supports of all vertices:
//! along a unit vector `n` from B to A, `min n.x_A - max n.x_B`; the greatest over the normals of faces and the cross
//! products of edges is the separation of the pair (minus the depth of penetration when negative).

use super::dyadic::{Dyadic, ExactVector};
use super::polyhedron::{Edge, Polyhedron};
use glam::{DMat3, DVec3};
use polhode_spatial::Pose;
use std::cmp::Ordering;

/// What an axis is the normal of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisOf {
    /// The normal of a face of A.
    FaceA(usize),
    /// The normal of a face of B.
    FaceB(usize),
    /// The normal of an edge of A and one of B.
    Edges(usize, usize),
}

/// An axis in f64: unit normal from B to A (axes of the world), separation along it, m.
#[derive(Debug, Clone, Copy)]
pub struct Axis {
    /// What the axis is normal to.
    pub of: AxisOf,
    /// The direction of the axis, from B to A.
    pub normal: DVec3,
    /// How far the bodies are apart along it, m; negative where they overlap.
    pub separation: f64,
    /// Length of the cross product of two unit vectors along the edges; one for a face.
    pub sine: f64,
}

impl Axis {
    /// Whether f64 says what the separation along the axis is.
    pub fn is_told(&self) -> bool {
        self.sine >= UNCERTAIN_SINE
    }
}

/// Two polyhedra at poses, in f64 with B relative to A's origin: plain sums over all axes.
#[derive(Debug)]
pub struct Pair<'a> {
    /// A and B.
    pub bodies: [&'a Polyhedron; 2],
    poses: [&'a Pose; 2],
    /// Vertices in axes of the world, from A's origin, m.
    pub vertices: [Vec<DVec3>; 2],
    /// Outward unit normals of the faces and unit vectors along the edges, in axes of the world.
    normals: [Vec<DVec3>; 2],
    directions: [Vec<DVec3>; 2],
    /// The largest length of the pair, m.
    pub scale: f64,
}

/// Below this sine of the angle between two edges f64 does not say what the separation along their normal is.
const UNCERTAIN_SINE: f64 = 1e-4;

/// Features nearer to each other than this, relative to the smaller of the two sizes, are in one place: what the crate
/// promises (`polhode_contact::clearance::COINCIDENCE`), stated here again so that a change of it shows.
const ONE_PLACE: f64 = 1e-12;

/// Part of the clearance that is rounding, in units of the machine's epsilon times the scale.
const CLEARANCE_ULPS: f64 = 16.0;

/// Edges bear the supports when they stand no further behind them than this, relative to the scale.
const BEARING: f64 = 1e-11;

/// Separations in f64 this near to the best, relative to the scale, are compared exactly: a hundred times the rounding
/// at [`UNCERTAIN_SINE`].
const NEAR_BEST: f64 = 1e-10;

/// `q v q*/|q|^2` as a matrix.
fn turning(pose: &Pose) -> DMat3 {
    let [w, x, y, z] = pose.rotation.to_wxyz();
    let square = w * w + x * x + y * y + z * z;
    let columns = [
        DVec3::new(w * w + x * x - y * y - z * z, 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)),
        DVec3::new(2.0 * (x * y - w * z), w * w - x * x + y * y - z * z, 2.0 * (y * z + w * x)),
        DVec3::new(2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z),
    ];
    DMat3::from_cols(columns[0] / square, columns[1] / square, columns[2] / square)
}

fn supports(points: &[DVec3], n: DVec3) -> (f64, f64) {
    points.iter().map(|p| p.dot(n)).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), d| (l.min(d), h.max(d)))
}

impl<'a> Pair<'a> {
    /// Of two bodies at poses.
    pub fn new(a: &'a Polyhedron, pose_a: &'a Pose, b: &'a Polyhedron, pose_b: &'a Pose) -> Self {
        let (turn_a, turn_b, between) = (turning(pose_a), turning(pose_b), pose_b.translation - pose_a.translation);
        let vertices = [
            a.vertices.iter().map(|&v| turn_a * v).collect(),
            b.vertices.iter().map(|&v| turn_b * v + between).collect::<Vec<_>>(),
        ];
        // In the body's frame the differences of vertices have no rounding of a turn, which short edges would show.
        let normals =
            [(a, turn_a), (b, turn_b)].map(|(body, turn)| body.faces.iter().map(|face| turn * face.normal).collect());
        let directions = [(a, turn_a), (b, turn_b)]
            .map(|(body, turn)| body.edges.iter().map(|edge| turn * edge.direction).collect());
        let scale = a.size + b.size + between.length();
        Self { bodies: [a, b], poses: [pose_a, pose_b], vertices, normals, directions, scale }
    }

    /// Axes whose separations differ by no more than this are equally good, m: the clearance that the crate states for
    /// features in one place.
    pub fn clearance(&self) -> f64 {
        let [a, b] = self.bodies.map(|body| body.size);
        ONE_PLACE * a.min(b) + CLEARANCE_ULPS * f64::EPSILON * self.scale
    }

    /// Outward unit normal of a face.
    pub fn face_normal(&self, body: usize, face: usize) -> DVec3 {
        self.normals[body].get(face).copied().unwrap_or(DVec3::NAN)
    }

    /// An edge and its neighbours.
    pub fn edge(&self, body: usize, edge: usize) -> &Edge {
        &self.bodies[body].edges[edge]
    }

    /// Unit vector along an edge.
    pub fn direction(&self, body: usize, edge: usize) -> DVec3 {
        self.directions[body].get(edge).copied().unwrap_or(DVec3::NAN)
    }

    /// The common perpendicular of an edge of A and one of B, on the side from B to A by the directions out of the
    /// bodies.
    pub fn across(&self, i: usize, j: usize) -> Axis {
        let cross = self.direction(0, i).cross(self.direction(1, j));
        let sign = if cross.dot(self.outward(1, j) - self.outward(0, i)) < 0.0 { -1.0 } else { 1.0 };
        let sine = cross.length();
        let normal = cross * (sign / sine);
        Axis { of: AxisOf::Edges(i, j), normal, separation: self.along(normal), sine }
    }

    /// A direction out of a body at an edge: the sum of the normals of its two faces and, in either face, of the
    /// direction out of it across the edge.
    fn outward(&self, body: usize, edge: usize) -> DVec3 {
        let along = self.direction(body, edge);
        let [left, right] = self.edge(body, edge).faces.map(|face| self.face_normal(body, face));
        left + right + along.cross(left) - along.cross(right)
    }

    /// Separation along a unit vector from B to A, m.
    pub fn along(&self, normal: DVec3) -> f64 {
        supports(&self.vertices[0], normal).0 - supports(&self.vertices[1], normal).1
    }

    /// Every axis that has a direction, of two edges only when they bear the supports along it (or f64 cannot tell). Of
    /// bodies that overlap no other axis can be best; of bodies apart another one may separate by more, as many
    /// directions do, and says less of how they will meet.
    pub fn axes(&self) -> Vec<Axis> {
        let mut axes = Vec::new();
        let mut offer = |of, normal: DVec3, sine| {
            let separation = self.along(normal);
            if sine < UNCERTAIN_SINE || self.between_features(of, normal) <= separation + BEARING * self.scale {
                axes.push(Axis { of, normal, separation, sine });
            }
        };
        for face in 0..self.bodies[0].faces.len() {
            offer(AxisOf::FaceA(face), -self.face_normal(0, face), 1.0);
        }
        for face in 0..self.bodies[1].faces.len() {
            offer(AxisOf::FaceB(face), self.face_normal(1, face), 1.0);
        }
        for (i, a) in self.directions[0].iter().enumerate() {
            for (j, b) in self.directions[1].iter().enumerate() {
                let cross = a.cross(*b);
                let sine = cross.length();
                if sine > 0.0 {
                    let normal = cross / sine;
                    offer(AxisOf::Edges(i, j), normal, sine);
                    offer(AxisOf::Edges(i, j), -normal, sine);
                }
            }
        }
        axes
    }

    /// Separation of the axis' own features along it; a face is its own support.
    fn between_features(&self, of: AxisOf, normal: DVec3) -> f64 {
        let AxisOf::Edges(i, j) = of else { return f64::NEG_INFINITY };
        let ends =
            |body: usize, edge: usize| self.edge(body, edge).vertices.map(|v| self.vertices[body][v].dot(normal));
        let ([a, b], [c, d]) = (ends(0, i), ends(1, j));
        a.max(b) - c.min(d)
    }

    /// The axes whose separation in f64 is near the best, the best first, and all that f64 cannot tell: exact numbers
    /// will.
    pub fn near_best(&self, axes: &[Axis]) -> Vec<Axis> {
        let least = best_told(axes) - NEAR_BEST * self.scale;
        in_order(axes.iter().filter(|axis| !axis.is_told() || axis.separation >= least))
    }

    /// The axes that f64 can tell and whose separation is the best to twice the clearance, the best first: faces may
    /// decide when edges separate by no more than the clearance above the best of them, and any face that is as good as
    /// that one.
    pub fn equally_good(&self, axes: &[Axis]) -> Vec<Axis> {
        let least = best_told(axes) - 2.0 * self.clearance();
        in_order(axes.iter().filter(|axis| axis.is_told() && axis.separation >= least))
    }
}

/// The largest separation that f64 can tell.
fn best_told(axes: &[Axis]) -> f64 {
    axes.iter().filter(|axis| axis.is_told()).map(|axis| axis.separation).fold(f64::NEG_INFINITY, f64::max)
}

fn in_order<'a>(axes: impl Iterator<Item = &'a Axis>) -> Vec<Axis> {
    let mut axes: Vec<Axis> = axes.copied().collect();
    axes.sort_by(|x, y| y.separation.total_cmp(&x.separation));
    axes
}

/// The same pair in exact numbers.
#[derive(Debug)]
pub struct ExactPair<'a> {
    pair: &'a Pair<'a>,
    /// The vertices of A and of B.
    pub vertices: [Vec<ExactVector>; 2],
    /// `D`: lengths are multiplied by it.
    multiple: Dyadic,
}

/// An exact separation: `top/sqrt(square)`, m.
#[derive(Debug, Clone)]
pub struct ExactSeparation {
    top: Dyadic,
    square: Dyadic,
}

impl ExactSeparation {
    /// The sum of some lengths, m.
    pub fn sum(lengths: &[f64]) -> Self {
        let add = |sum: Dyadic, length: &f64| &sum + &Dyadic::from(*length);
        Self { top: lengths.iter().fold(Dyadic::from(0.0), add), square: Dyadic::from(1.0) }
    }

    fn compare(&self, other: &Self) -> Ordering {
        let signed = |s: &Self, other: &Self| {
            let square = &s.top.square() * &other.square;
            if s.top.signum() < 0 { -&square } else { square }
        };
        signed(self, other).compare(&signed(other, self))
    }

    /// The separation less a measured one, m.
    pub fn less(&self, measured: f64) -> f64 {
        self.top.over_root_less(&self.square, measured)
    }
}

/// `q v q*` and `|q|^2`.
fn turned(pose: &Pose, vertices: &[DVec3]) -> (Vec<ExactVector>, Dyadic) {
    let [w, x, y, z] = pose.rotation.to_wxyz();
    let (w, u) = (Dyadic::from(w), ExactVector::from(DVec3::new(x, y, z)));
    let (two, w2, u2) = (Dyadic::from(2.0), w.square(), u.dot(&u));
    let turn = |v: &DVec3| {
        // q v q* = (w^2 - u.u) v + 2 (u.v) u + 2 w (u x v).
        let v = ExactVector::from(*v);
        let sum = &v.scaled(&(&w2 - &u2)) + &u.scaled(&(&two * &u.dot(&v)));
        &sum + &u.cross(&v).scaled(&(&two * &w))
    };
    (vertices.iter().map(turn).collect(), &w2 + &u2)
}

impl<'a> ExactPair<'a> {
    /// Of this pair.
    pub fn new(pair: &'a Pair<'a>) -> Self {
        let [(a, square_a), (b, square_b)] = [0, 1].map(|i| turned(pair.poses[i], &pair.bodies[i].vertices));
        let between = &ExactVector::from(pair.poses[1].translation) - &ExactVector::from(pair.poses[0].translation);
        let multiple = &square_a * &square_b;
        let between = between.scaled(&multiple);
        let vertices = [
            a.iter().map(|v| v.scaled(&square_b)).collect(),
            b.iter().map(|v| &v.scaled(&square_a) + &between).collect(),
        ];
        Self { pair, vertices, multiple }
    }

    /// Outward normal of a face, of no particular length.
    pub fn face_normal(&self, body: usize, face: usize) -> ExactVector {
        let corners = self.pair.bodies[body].faces.get(face).map_or(&[][..], |f| &f.vertices);
        let at = |v: usize| &self.vertices[body][v];
        let mut sum = ExactVector::from(DVec3::ZERO);
        for pair in corners.get(1..).unwrap_or_default().windows(2) {
            sum = &sum + &(at(pair[0]) - at(corners[0])).cross(&(at(pair[1]) - at(corners[0])));
        }
        sum
    }

    /// Cross product of two edges, turned as the axis says; nothing when they are exactly parallel.
    fn normal(&self, axis: &Axis) -> Option<ExactVector> {
        let along = |body: usize, edge: usize| {
            let [from, to] = self.pair.edge(body, edge).vertices;
            &self.vertices[body][to] - &self.vertices[body][from]
        };
        let normal = match axis.of {
            AxisOf::FaceA(face) => -&self.face_normal(0, face),
            AxisOf::FaceB(face) => self.face_normal(1, face),
            AxisOf::Edges(i, j) => {
                let cross = along(0, i).cross(&along(1, j));
                if cross.dot(&ExactVector::from(axis.normal)).signum() < 0 { -&cross } else { cross }
            }
        };
        (!normal.is_zero()).then_some(normal)
    }

    /// An axis that f64 cannot tell with its exact normal and separation, rounded once; nothing when it has no
    /// direction.
    pub fn told(&self, axis: &Axis) -> Option<Axis> {
        let normal = self.normal(axis)?;
        let (square, separation) = (normal.dot(&normal), self.along(&normal).less(0.0));
        let unit = normal.0.map(|component| component.over_root_less(&square, 0.0));
        Some(Axis { of: axis.of, normal: DVec3::from_array(unit), separation, sine: 1.0 })
    }

    /// Separation along a vector of any length, from B to A.
    pub fn along(&self, normal: &ExactVector) -> ExactSeparation {
        let extreme = |body: usize, wanted: Ordering| {
            let mut best: Option<Dyadic> = None;
            for vertex in &self.vertices[body] {
                let height = vertex.dot(normal);
                if best.as_ref().is_none_or(|b| height.compare(b) == wanted) {
                    best = Some(height);
                }
            }
            best.unwrap_or_else(|| Dyadic::from(0.0))
        };
        let top = &extreme(0, Ordering::Less) - &extreme(1, Ordering::Greater);
        ExactSeparation { top, square: &normal.dot(normal) * &self.multiple.square() }
    }

    /// The best of some axes with its exact separation; nothing when none has a direction.
    pub fn best(&self, axes: &[Axis]) -> Option<(Axis, ExactSeparation)> {
        let mut best: Option<(Axis, ExactSeparation)> = None;
        for axis in axes {
            let Some(normal) = self.normal(axis) else { continue };
            let separation = self.along(&normal);
            if best.as_ref().is_none_or(|(_, b)| separation.compare(b) == Ordering::Greater) {
                best = Some((*axis, separation));
            }
        }
        best
    }
}
