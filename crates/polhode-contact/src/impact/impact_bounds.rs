//! For how long two moving shapes certainly stay separated: second-order bounds along separating axes.
//!
//! The gap along an axis is the minimum of many smooth functions of time, one for each vertex. Each is bounded from
//! below by a parabola ([`Quadratic`]) from its current value and rate and a bound of its second derivative over a
//! window `[t, t + T]`. Let `r` be the arm of a vertex in its body V, `y` the vertex's position in the frame of the
//! body E of a face with normal `n`, and `v`, `w`, `alpha` bounds of speed, angular speed and angular acceleration.
//! Then
//!
//! `gap'' = n.(v_V' - v_E') + n.(alpha_V x r + w_V x (w_V x r)) - n.(alpha_E x y) - (w_E x n).(w_E x y)
//!          + 2 (w_E x n).(v_V - v_E + w_V x r)`
//!
//! `|gap''| <= |v_V' - v_E'| + (alpha_V + w_V^2)|r| + (alpha_E + w_E^2) Y + 2 w_E (S + w_V |r|)`,
//! `Y = |y| + (S + w_V |r|) T`, `S` the largest relative speed of the centres.
//!
//! For two edges the axis is `N = e_A x e_B`, which turns with both: `f = N.u` for a vector `u` fixed in A has
//! `|f''| <= K |u x e_A|`, `K = alpha_A + alpha_B + w_A w_B + (w_A + w_B)^2`, and between the edges themselves
//! `|f''| <= K C + 2 (w_A + w_B) U + |relative acceleration|`, with `C` and `U` the largest distance and relative speed
//! of the two nearest points (all in A's frame, where `e_A` is at rest).
//!
//! A circle (centre `c`, axis `a`, radius `R`) extends `R |a x n|` farther along `n` than its centre; `circle_below`
//! bounds that.
//!
//! The centres' accelerations: the bound `|v'| <= a` alone would allow two bodies that fall side by side to approach
//! each other with 2g. But the change of velocity `dv` over the window is known. If it is nearly `a T` in a direction
//! `u`, then `v'` is nearly `a u` throughout: `integral |v' - a u| <= sqrt(2 a T (a T - |dv|))` by the Cauchy-Schwarz
//! inequality. Gravity, which is the same for both, then cancels up to the small residual velocity on the right-hand
//! side.

use crate::clearance::PARALLEL_SINE;
use crate::impact::quadratic_bound::{Quadratic, positive_until};
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::shape::round::Hull;
use crate::{ConvexPolyhedron, Side};
use glam::DVec3;
use polhode_spatial::{Motion, MotionBounds, Pose, Velocity};

/// Rounding of a velocity, in epsilons of its magnitude.
const VELOCITY_ULPS: f64 = 8.0;

/// Lower bound of `-|a x n|` over a window, for a unit vector `a` (`axis`) with rate `a'` and a bound of `|a''|`
/// (`second`). For `a + a' s` this length is convex in `s`, so that it lies below its chord over the window; the rest
/// of `a` changes it by at most `|a''| s^2/2`.
fn circle_below(n: DVec3, axis: DVec3, rate: DVec3, second: f64, window: f64) -> Quadratic {
    let (now, change) = (axis.cross(n), rate.cross(n));
    let start = now.length();
    let slope = if window > 0.0 { ((now + change * window).length() - start) / window } else { change.length() };
    Quadratic { value: -start, rate: -slope, curvature: second }
}

/// Points of a body, inflated by a radius: their support function is that of the shape.
pub(crate) type Points<'a> = (&'a [DVec3], f64);

/// A body over a window of time that begins at the current time.
pub(crate) struct MovingBody {
    pub(crate) pose: Pose,
    pub(crate) velocity: Velocity,
    bounds: MotionBounds,
    /// `a u`: the acceleration of the centre as far as its change of velocity shows it, m/s^2.
    mean: DVec3,
    /// Bound of the velocity that the remaining acceleration can give over the window, m/s.
    stray: f64,
}

impl MovingBody {
    fn new(motion: &dyn Motion, pose: Pose, t: f64, end: f64) -> Self {
        let bounds = motion.bounds(t, end);
        let (velocity, later) = (motion.velocity(t), motion.velocity(end));
        let change = later.linear - velocity.linear;
        let most = bounds.acceleration * (end - t);
        let rounding = VELOCITY_ULPS * f64::EPSILON * (velocity.linear.length() + later.linear.length());
        let lacking = (most - change.length()).max(0.0) + rounding;
        let mean = change.try_normalize().unwrap_or(DVec3::ZERO) * bounds.acceleration;
        let stray = if mean == DVec3::ZERO { most } else { (2.0 * most * lacking).sqrt() };
        Self { pose, velocity, bounds, mean, stray }
    }

    /// Bound of the acceleration of a point on an arm from the rotation, m/s^2.
    fn turning(&self, arm: f64) -> f64 {
        (self.bounds.angular_acceleration + self.bounds.angular_speed * self.bounds.angular_speed) * arm
    }

    /// The same relative to a frame that rotates at the constant rate `rate` (rad/s).
    fn turning_from(&self, rate: f64, arm: f64) -> f64 {
        let spin = self.bounds.angular_speed;
        (self.bounds.angular_acceleration + (spin + rate) * (spin + rate) + spin * rate) * arm
    }

    fn spin(&self) -> f64 {
        self.bounds.angular_speed
    }
}

/// Two moving bodies over a window of time, and buffers for the parabolas.
pub(crate) struct Window<'a> {
    a: MovingBody,
    b: MovingBody,
    length: f64,
    /// Largest relative speed of the centres, m/s.
    speed: f64,
    buffers: &'a mut [Vec<Quadratic>; 2],
}

impl<'a> Window<'a> {
    /// The window `[t, end]` (s); none when a velocity or bound is not finite.
    pub(crate) fn new(
        motions: [&dyn Motion; 2],
        poses: [Pose; 2],
        t: f64,
        end: f64,
        buffers: &'a mut [Vec<Quadratic>; 2],
    ) -> Option<Self> {
        let a = MovingBody::new(motions[0], poses[0], t, end);
        let b = MovingBody::new(motions[1], poses[1], t, end);
        let length = end - t;
        let start = a.velocity.linear - b.velocity.linear;
        // When the velocity changes linearly, the speed is largest at an end.
        let straight = start.length().max((start + (a.mean - b.mean) * length).length()) + a.stray + b.stray;
        let speed = straight
            .min(start.length() + (a.bounds.acceleration + b.bounds.acceleration) * length)
            .min(a.bounds.speed + b.bounds.speed);
        let finite = |m: &MovingBody| {
            m.velocity.is_finite() && (m.turning(1.0) + m.bounds.acceleration + m.bounds.speed).is_finite()
        };
        (finite(&a) && finite(&b)).then_some(Self { a, b, length, speed, buffers })
    }

    /// The bodies as (first, other).
    fn sides(&self, first: Side) -> (&MovingBody, &MovingBody) {
        match first {
            Side::A => (&self.a, &self.b),
            Side::B => (&self.b, &self.a),
        }
    }

    /// Bound of the contribution of the centres' motion to a gap, along an axis from the second body to the first that
    /// turns at most at `spin` (rad/s).
    fn central(&self, first: Side, axis: DVec3, spin: f64) -> Quadratic {
        // The axis deviates from its direction by at most spin * s, which adds spin |relative| s^3/6 over the window.
        self.central_about(first, axis, spin * self.length / 3.0)
    }

    /// The same for axes that do not turn and differ from the given one by at most `aside` (length of the difference).
    fn central_about(&self, first: Side, axis: DVec3, aside: f64) -> Quadratic {
        let (body, other) = self.sides(first);
        let relative = body.mean - other.mean;
        let steady = (aside * relative.length() - axis.dot(relative)).max(0.0);
        let crude = body.bounds.acceleration + other.bounds.acceleration;
        let stray = body.stray + other.stray;
        if stray + 0.5 * steady * self.length < 0.5 * crude * self.length {
            Quadratic { value: 0.0, rate: -stray, curvature: steady }
        } else {
            Quadratic { value: 0.0, rate: 0.0, curvature: crude }
        }
    }

    /// How long points of body `of` stay outside planes that are fixed in the other body, s. `plane` gives, for the
    /// index of a point, the plane's unit normal in the other body's frame and the point's current gap above it (m).
    pub(crate) fn above_planes(&mut self, of: Side, points: Points<'_>, plane: impl Fn(usize) -> (DVec3, f64)) -> f64 {
        self.above_surfaces(of, points, 0.0, plane)
    }

    /// As [`Self::above_planes`], for surfaces that curve towards the points. `bend` bounds the reduction of the second
    /// derivative of a gap by the curvature, m/s^2.
    pub(crate) fn above_surfaces(
        &mut self,
        of: Side,
        points: Points<'_>,
        bend: f64,
        plane: impl Fn(usize) -> (DVec3, f64),
    ) -> f64 {
        if points.0.is_empty() {
            return self.length;
        }
        let mut bounds = std::mem::take(&mut self.buffers[0]);
        bounds.clear();
        let (v, e) = self.sides(of);
        let between = v.pose.translation - e.pose.translation;
        let relative = v.velocity.linear - e.velocity.linear;
        let mut same: Option<(DVec3, DVec3, Quadratic)> = None;
        for (index, &point) in points.0.iter().enumerate() {
            let (normal, gap) = plane(index);
            // A face's plane is the same for all points: its part is computed once.
            let (normal, central) = match same {
                Some((local, world, central)) if local == normal => (world, central),
                _ => {
                    let world = e.pose.rotation.rotate(normal);
                    let central = self.central(of, world, e.spin());
                    same = Some((normal, world, central));
                    (world, central)
                }
            };
            let arm = v.pose.rotation.rotate(point);
            let place = between + arm;
            let velocity = relative + v.velocity.angular.cross(arm) - e.velocity.angular.cross(place);
            let length = arm.length();
            let speed = self.speed + v.spin() * length;
            let turning = v.turning(length) + e.turning(place.length() + speed * self.length) + 2.0 * e.spin() * speed;
            bounds.push(Quadratic {
                value: gap,
                rate: normal.dot(velocity) + central.rate,
                curvature: central.curvature + turning + bend,
            });
        }
        let clear = positive_until(Quadratic::ZERO, &bounds, &[], self.length);
        self.buffers[0] = bounds;
        clear
    }

    /// How long the circles of a hull of body `of` stay outside a plane that is fixed in the other body, s: its outward
    /// unit normal and its offset in that body's frame (m).
    pub(crate) fn circles_above_plane(&mut self, of: Side, hull: &Hull<'_>, normal: DVec3, offset: f64) -> f64 {
        let (v, e) = self.sides(of);
        let up = e.pose.rotation.rotate(normal);
        let between = v.pose.translation - e.pose.translation;
        let relative = v.velocity.linear - e.velocity.linear;
        let central = self.central(of, up, e.spin());
        let spin = v.velocity.angular - e.velocity.angular;
        // The axis in the frame of the plane's body.
        let both = v.spin() + e.spin();
        let swing = v.bounds.angular_acceleration + e.bounds.angular_acceleration + v.spin() * e.spin() + both * both;
        let mut clear = self.length;
        for circle in hull.circles.iter() {
            let arm = v.pose.rotation.rotate(circle.center);
            let axis = v.pose.rotation.rotate(circle.axis);
            let place = between + arm;
            let velocity = relative + v.velocity.angular.cross(arm) - e.velocity.angular.cross(place);
            let length = arm.length();
            let speed = self.speed + v.spin() * length;
            let turning = v.turning(length) + e.turning(place.length() + speed * self.length) + 2.0 * e.spin() * speed;
            let center = Quadratic {
                value: up.dot(place) - offset - hull.ball,
                rate: up.dot(velocity) + central.rate,
                curvature: central.curvature + turning,
            };
            let tilt = circle_below(up, axis, spin.cross(axis), swing, self.length);
            clear = clear.min(positive_until(center.plus(tilt.times(circle.radius)), &[], &[], self.length));
        }
        clear
    }

    /// How long two hulls stay apart along a direction that is fixed in the world, from B to A.
    pub(crate) fn along_direction(&mut self, direction: DVec3, hull_a: &Hull<'_>, hull_b: &Hull<'_>) -> f64 {
        self.along_turning(direction, DVec3::ZERO, hull_a, hull_b)
    }

    /// As [`Self::along_direction`], with a direction that rotates at a constant rate (`turn`, rad/s); in its frame a
    /// body rotates at the difference. The gap at the ends of lines to which the direction stays perpendicular has no
    /// loss of first order.
    pub(crate) fn along_turning(&mut self, direction: DVec3, turn: DVec3, hull_a: &Hull<'_>, hull_b: &Hull<'_>) -> f64 {
        let turning = turn.length();
        let [mut first, mut second] = std::mem::take(self.buffers);
        let length = self.length;
        let collect = |bounds: &mut Vec<Quadratic>, body: &MovingBody, direction: DVec3, hull: &Hull<'_>| {
            let point = |point: DVec3| {
                let arm = body.pose.rotation.rotate(point);
                Quadratic {
                    value: direction.dot(arm),
                    rate: direction.dot((body.velocity.angular - turn).cross(arm)),
                    curvature: body.turning_from(turning, arm.length()),
                }
            };
            bounds.clear();
            bounds.extend(hull.points.iter().map(|&p| point(p)));
            bounds.extend(hull.circles.iter().map(|circle| {
                let axis = body.pose.rotation.rotate(circle.axis);
                let drift = (body.velocity.angular - turn).cross(axis);
                let tilt = circle_below(direction, axis, drift, body.turning_from(turning, 1.0), length);
                point(circle.center).plus(tilt.times(circle.radius))
            }));
        };
        collect(&mut first, &self.a, direction, hull_a);
        collect(&mut second, &self.b, -direction, hull_b);
        let mut base = self.central(Side::A, direction, turning);
        let between = self.a.pose.translation - self.b.pose.translation;
        base.value = direction.dot(between) - hull_a.ball - hull_b.ball;
        base.rate +=
            direction.dot(self.a.velocity.linear - self.b.velocity.linear) + turn.cross(direction).dot(between);
        base.curvature += turning * (turning * (between.length() + self.speed * self.length) + 2.0 * self.speed);
        let clear = positive_until(base, &first, &second, self.length);
        *self.buffers = [first, second];
        clear
    }

    /// The angular velocity, perpendicular to an axis, at which the axis stays perpendicular to a line fixed in A and
    /// to one fixed in B. `across` holds for each line the unit vector perpendicular to the line and to the axis. None
    /// without lines; of parallel lines the first is used.
    pub(crate) fn turn_with(&self, across: [Option<DVec3>; 2]) -> Option<DVec3> {
        let (spin_a, spin_b) = (self.a.velocity.angular, self.b.velocity.angular);
        match across {
            [Some(u), Some(v)] => {
                let (along_u, along_v, cosine) = (spin_a.dot(u), spin_b.dot(v), u.dot(v));
                let determinant = 1.0 - cosine * cosine;
                if determinant < PARALLEL_SINE {
                    return Some(u * along_u);
                }
                Some((u * (along_u - cosine * along_v) + v * (along_v - cosine * along_u)) / determinant)
            }
            [Some(u), None] => Some(u * spin_a.dot(u)),
            [None, Some(v)] => Some(v * spin_b.dot(v)),
            [None, None] => None,
        }
    }

    /// The angular velocity perpendicular to an axis with which it turns as a body does.
    pub(crate) fn turn_of(&self, body: Side, axis: DVec3) -> DVec3 {
        let spin = self.sides(body).0.velocity.angular;
        spin - axis * axis.dot(spin)
    }

    /// How long two polyhedra stay apart along the common perpendicular of two edges, which turns with them.
    pub(crate) fn across_edges(
        &mut self,
        crossed: &CrossedEdges,
        polyhedron_a: &ConvexPolyhedron,
        polyhedron_b: &ConvexPolyhedron,
    ) -> f64 {
        let [mut first, mut second] = std::mem::take(self.buffers);
        let (a, b) = (&self.a, &self.b);
        let axis = crossed.normal * crossed.sine;
        let axis_rate = crossed.normal_rate(&a.velocity, &b.velocity);
        let (w_a, w_b) = (a.spin(), b.spin());
        let swing =
            a.bounds.angular_acceleration + b.bounds.angular_acceleration + w_a * w_b + (w_a + w_b) * (w_a + w_b);
        // The distances `N.u` of the vertices of each body behind its edge: zero at the edge itself, positive for the
        // others.
        let behind = |bounds: &mut Vec<Quadratic>,
                      body: &MovingBody,
                      arm: DVec3,
                      along: DVec3,
                      turned: f64,
                      vertices: &[DVec3]| {
            bounds.clear();
            bounds.push(Quadratic::ZERO);
            bounds.extend(vertices.iter().map(|&vertex| {
                let u = body.pose.rotation.rotate(vertex) - arm;
                Quadratic {
                    value: turned * axis.dot(u),
                    rate: turned * (axis_rate.dot(u) + axis.dot(body.velocity.angular.cross(u))),
                    curvature: swing * u.cross(along).length(),
                }
            }));
        };
        behind(&mut first, a, crossed.arm_a, crossed.along_a, 1.0, &polyhedron_a.vertices);
        behind(&mut second, b, crossed.arm_b, crossed.along_b, -1.0, &polyhedron_b.vertices);
        let velocity = (a.velocity.linear - b.velocity.linear)
            + (a.velocity.angular.cross(crossed.arm_a) - b.velocity.angular.cross(crossed.arm_b));
        let gap = (a.pose.translation - b.pose.translation) + (crossed.arm_a - crossed.arm_b);
        // Position of B's point relative to A's centre, and its largest speed there.
        let arm_b = crossed.arm_b.length();
        let speed = self.speed + w_b * arm_b;
        let place = (crossed.arm_a - gap).length() + speed * self.length;
        let relative_speed = speed + w_a * place;
        let central = self.central(Side::A, axis, w_a + w_b);
        let base = Quadratic {
            value: crossed.separation * crossed.sine,
            rate: axis.dot(velocity) + axis_rate.dot(gap) + central.rate,
            curvature: central.curvature
                + swing * (gap.length() + relative_speed * self.length)
                + 2.0 * (w_a + w_b) * relative_speed
                + b.turning(arm_b)
                + a.turning(place)
                + 2.0 * w_a * speed,
        };
        let clear = positive_until(base, &first, &second, self.length);
        *self.buffers = [first, second];
        clear
    }

    /// How long points of body `of` stay outside a sphere of the other body, s: its centre in that body's frame and its
    /// radius, m.
    pub(crate) fn around_center(&mut self, of: Side, points: Points<'_>, center: DVec3, radius: f64) -> f64 {
        let mut bounds = std::mem::take(&mut self.buffers[0]);
        bounds.clear();
        let (v, e) = self.sides(of);
        let between = v.pose.translation - e.pose.translation;
        let other = e.pose.rotation.rotate(center);
        for &point in points.0 {
            let arm = v.pose.rotation.rotate(point);
            let d = between + (arm - other);
            let distance = d.length();
            let normal = d / distance;
            let velocity = (v.velocity.linear - e.velocity.linear)
                + (v.velocity.angular.cross(arm) - e.velocity.angular.cross(other));
            // The distance is at least its component along the current direction.
            let central = self.central(of, normal, 0.0);
            bounds.push(Quadratic {
                value: distance - points.1 - radius,
                rate: normal.dot(velocity) + central.rate,
                curvature: central.curvature + v.turning(arm.length()) + e.turning(other.length()),
            });
        }
        let clear = positive_until(Quadratic::ZERO, &bounds, &[], self.length);
        self.buffers[0] = bounds;
        clear
    }

    /// How long points on arms of A and of B (m, at most `arms` long) stay apart along axes that are fixed in the world
    /// and differ from the given one by at most `aside`, when the gap of all of them is now at least `gap`.
    pub(crate) fn between_points(&self, gap: Quadratic, axis: DVec3, aside: f64, arms: [f64; 2]) -> f64 {
        let turning = self.a.turning(arms[0]) + self.b.turning(arms[1]);
        let bound = gap.plus(self.central_about(Side::A, axis, aside));
        positive_until(bound.plus(Quadratic { curvature: turning, ..Quadratic::ZERO }), &[], &[], self.length)
    }

    /// Velocities of A and of B at the beginning.
    pub(crate) const fn velocities(&self) -> [Velocity; 2] {
        [self.a.velocity, self.b.velocity]
    }

    /// Length of the window, s.
    pub(crate) const fn length(&self) -> f64 {
        self.length
    }

    /// Largest relative speed of a point of A and a point of B that are at most these distances (m) from the centres of
    /// their bodies.
    pub(crate) fn largest_speed(&self, radius_a: f64, radius_b: f64) -> f64 {
        let turning = |spin: f64, radius: f64| if spin == 0.0 { 0.0 } else { spin * radius };
        self.speed + turning(self.a.spin(), radius_a) + turning(self.b.spin(), radius_b)
    }
}
