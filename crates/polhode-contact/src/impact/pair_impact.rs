//! The impact of two shapes without parts: conservative advancement from a clear pair, and the search after a start in
//! contact. `time_of_impact.rs` describes both.

use crate::clearance::{place_tolerance, resolution, touch_tolerance};
use crate::impact::arc_cuts::Cuts;
use crate::impact::fine_time::refined;
use crate::impact::impact_bounds::{Points, Window};
use crate::impact::impact_error::ImpactError;
use crate::impact::impact_report::ImpactReport;
use crate::impact::impact_search::ImpactSearch;
use crate::impact::quadratic_bound::Quadratic;
use crate::impact::ring_arcs::RingArcs;
use crate::impact::ring_pair::RingPair;
use crate::impact::root_bracket::{Sample, last_not_negative};
use crate::narrow_phase::axis::axes::Axes;
use crate::narrow_phase::axis::gap::{self, Gap};
use crate::narrow_phase::axis::ring;
use crate::narrow_phase::axis::separating_axis::search_axes;
use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::feature::closest_feature::nearest_feature;
use crate::narrow_phase::feature::element::{Element, Locus};
use crate::narrow_phase::feature::placed::Placed;
use crate::narrow_phase::terms::crossed_edges::CrossedEdges;
use crate::narrow_phase::terms::open_face::{Moving, OpenFace, open_faces};
use crate::shape::round::{Hull, circles, is_round};
use crate::{Shape, Side, SurfaceFeature};
use glam::DVec3;
use polhode_spatial::{Motion, Pose};

/// The impact of one part of each of two bodies; the whole bodies give the tolerances.
pub(crate) fn find_in_parts(
    shapes: [&Shape; 2],
    wholes: [&Shape; 2],
    motions: [&dyn Motion; 2],
    (t0, t1): (f64, f64),
    settings: &ImpactSearch,
) -> Result<ImpactReport, ImpactError> {
    let mut search = Search {
        shapes,
        wholes,
        motions,
        settings,
        workspace: Workspace::default(),
        bounds: [Vec::new(), Vec::new()],
        axes: None,
        gap: None,
        evaluations: 0,
        cuts: Cuts::new(),
        began_in_touch: false,
        departing_step: None,
    };
    let start = search.moment_at(t0)?;
    let (time, separation) = search.from(start, t1)?;
    Ok(ImpactReport { time, separation, evaluations: search.evaluations, cuts: search.cuts.made() })
}

/// The pair at a time.
#[derive(Clone, Copy)]
struct Moment {
    t: f64,
    poses: [Pose; 2],
    separation: f64,
}

/// How one stage of a search ends.
enum Ended {
    /// The time of impact, if any, and the separation there or at the end of the interval.
    At(Option<f64>, f64),
    /// The pair is clear from here on, or touches here while it passes along an open face: the search continues.
    GoesOn(Moment),
}

struct Search<'a> {
    shapes: [&'a Shape; 2],
    /// The bodies that the shapes are parts of.
    wholes: [&'a Shape; 2],
    motions: [&'a dyn Motion; 2],
    settings: &'a ImpactSearch,
    workspace: Workspace,
    /// Buffers of the bounds.
    bounds: [Vec<Quadratic>; 2],
    /// Best axes at the last evaluation, for two polyhedra.
    axes: Option<Axes>,
    /// Best axis at the last evaluation, for a round shape and another convex one.
    gap: Option<Gap>,
    evaluations: u32,
    cuts: Cuts,
    /// Whether the pair touched at the start, or has since.
    began_in_touch: bool,
    /// The first safe step of a pair that has just departed, s.
    departing_step: Option<f64>,
}

/// The window is narrowed to this many times the first safe step when that was much shorter than the window: bounds
/// that need not hold for long are tighter.
const NARROWER: f64 = 4.0;

/// Changes of separation up to this many resolutions are rounding error.
const MEASURABLE: f64 = 4.0;

/// A pair in contact has an impact when its separation has decreased by this part of the touch tolerance: more than the
/// drift of a persistent contact, less than what counts as penetration.
const NOTICED: f64 = 1.0 / 16.0;

/// At the end of an interval, and before the pair separates again, a smaller decrease counts as an impact: this part of
/// the touch tolerance, a quarter of [`NOTICED`].
const CLOSED: f64 = 1.0 / 64.0;

/// A pair that begins in touch has departed when the rigorous search can advance by at least this part of the time
/// since the start. A smaller step would mean a great many evaluations: the separation grows as slowly as the bounds
/// allow, as where a contact force has decreased to zero smoothly (the separation then grows as the cube of time).
const LEAST_PROGRESS: f64 = 1.0 / 64.0;

/// A pair has departed anyway at this many touch tolerances: a touch cannot go on at such a separation.
const APART: f64 = 4096.0;

/// So many evaluations within the touch tolerance that neither bring the separation to rounding nor increase it beyond
/// the tolerance show a touch that goes on. A pair that approaches needs about ten.
const MOST_IN_TOUCH: u32 = 64;

/// A bound for a ball and a torus holds as long as the ball's distance from the torus's axis is at least this fraction
/// of the present one.
const LEAST_AXIS_DISTANCE: f64 = 0.5;

/// `2^-j`, exactly; zero beyond the smallest double.
fn halved(j: u32) -> f64 {
    libm::ldexp(1.0, -(j as i32))
}

/// How long points of body `of` stay above one plane that is fixed in the other body, s: its outward unit normal and
/// its offset in that body's frame (m).
fn points_clear_of_plane(
    now: &Moment,
    window: &mut Window<'_>,
    of: Side,
    (points, radius): Points<'_>,
    (normal, offset): (DVec3, f64),
) -> f64 {
    let (this, other) = (of.index(), of.other().index());
    let x = now.poses[other].relative(&now.poses[this]);
    let gap = |k: usize| normal.dot(x.transform_point(points[k])) - offset - radius;
    window.above_planes(of, (points, radius), |k| (normal, gap(k)))
}

/// The same for the points and circles of a hull.
fn hull_clear_of_plane(now: &Moment, window: &mut Window<'_>, of: Side, hull: &Hull<'_>, plane: (DVec3, f64)) -> f64 {
    let circles = window.circles_above_plane(of, hull, plane.0, plane.1);
    circles.min(points_clear_of_plane(now, window, of, (&hull.points, hull.ball), plane))
}

/// The hull of one point of a cloud, named by a feature; for other shapes the whole hull.
fn only_point<'a>(shape: &Shape, hull: Hull<'a>, feature: SurfaceFeature) -> Hull<'a> {
    match (shape, feature) {
        (Shape::Points(_), SurfaceFeature::Vertex(index)) => hull.of_point(index),
        _ => hull,
    }
}

impl Search<'_> {
    /// Poses and separation at a time.
    fn moment_at(&mut self, t: f64) -> Result<Moment, ImpactError> {
        let poses = [self.motions[0].pose(t), self.motions[1].pose(t)];
        if !(poses[0].is_finite() && poses[1].is_finite()) {
            return Err(ImpactError::NotFinite { t });
        }
        self.evaluations += 1;
        let [pose_a, pose_b] = &poses;
        let separation = if let [Shape::Convex(a), Shape::Convex(b)] = self.shapes {
            let axes = search_axes(&mut self.workspace.pair().search, [a, b], [pose_a, pose_b], f64::INFINITY);
            self.axes = Some(axes);
            axes.separation([a, b], [pose_a, pose_b])
        } else if self.shapes.into_iter().any(Shape::is_ring) && !self.shapes.into_iter().any(Shape::is_half_space) {
            self.gap = ring::least(Placed::new(self.shapes[0], pose_a), Placed::new(self.shapes[1], pose_b));
            self.gap.map_or(f64::INFINITY, |gap| gap.separation)
        } else if self.shapes.into_iter().any(is_round) && !self.shapes.into_iter().any(Shape::is_half_space) {
            let (a, b) = (Placed::new(self.shapes[0], pose_a), Placed::new(self.shapes[1], pose_b));
            self.gap = gap::between(a, b, f64::INFINITY);
            self.gap.map_or(f64::INFINITY, |gap| gap.separation)
        } else {
            separation_with(&mut self.workspace, self.shapes[0], pose_a, self.shapes[1], pose_b)
        };
        if self.evaluations > self.settings.max_evaluations {
            return Err(ImpactError::EvaluationLimit { t, separation, limit: self.settings.max_evaluations });
        }
        if separation.is_nan() { Err(ImpactError::NotFinite { t }) } else { Ok(Moment { t, poses, separation }) }
    }

    fn resolution(&self, at: &Moment) -> f64 {
        resolution(self.wholes[0], &at.poses[0], self.wholes[1], &at.poses[1])
    }

    fn touch(&self, at: &Moment) -> f64 {
        touch_tolerance(self.wholes[0], &at.poses[0], self.wholes[1], &at.poses[1], self.settings.touch_relative)
    }

    /// The time of impact from a time on, if any, and the separation there or at the end.
    fn from(&mut self, start: Moment, t1: f64) -> Result<(Option<f64>, f64), ImpactError> {
        let mut now = start;
        loop {
            let is_clear = now.separation > self.touch(&now);
            match if is_clear { self.advance(now, t1)? } else { self.depart(now, t1)? } {
                Ended::At(time, separation) => return Ok((time, separation)),
                Ended::GoesOn(next) => now = next,
            }
        }
    }

    /// From a time at which the pair is clear to its next touch. A pair that stays within the touch tolerance without
    /// coming closer touches: what the contact does then is not a question of geometry.
    fn advance(&mut self, start: Moment, t1: f64) -> Result<Ended, ImpactError> {
        let mut now = start;
        let mut in_touch = 0;
        loop {
            if now.separation == f64::INFINITY {
                return Ok(Ended::At(None, now.separation));
            }
            if now.separation <= self.resolution(&now) {
                return self.refine(now, (start.t, t1)).map(|touch| self.passed(touch, start.t));
            }
            if now.t >= t1 {
                return Ok(Ended::At(None, now.separation));
            }
            in_touch = if now.separation <= self.touch(&now) { in_touch + 1 } else { 0 };
            if in_touch > MOST_IN_TOUCH {
                return Ok(self.passed(now, start.t));
            }
            let step = match self.departing_step.take() {
                Some(step) => step,
                None => self.safe_step(&now, t1 - now.t)?,
            };
            let next = (now.t + step).min(t1);
            // The gap closes before the next larger floating point number.
            if next <= now.t {
                return Ok(self.passed(now, start.t));
            }
            now = self.moment_at(next)?;
        }
    }

    /// Whether a touch is an impact. It is none while the bodies pass each other along an open face. Where one is
    /// noticeably below that face, the search ends too: it is to be lifted.
    fn passed(&self, touch: Moment, start: f64) -> Ended {
        let velocities = self.motions.map(|motion| motion.velocity(touch.t));
        let moving = |k: usize| Moving { shape: self.shapes[k], pose: &touch.poses[k], velocity: &velocities[k] };
        let goes_on = touch.t > start && touch.separation <= self.touch(&touch);
        let is_flush = |face: &OpenFace| face.separation >= -NOTICED * self.touch(&touch);
        if goes_on && open_faces(moving(0), moving(1), self.touch(&touch)).iter().any(is_flush) {
            return Ended::GoesOn(touch);
        }
        Ended::At(Some(touch.t), touch.separation)
    }

    /// Refines the impact found at `now` beyond the rounding of poses where the motions allow it (`fine_time.rs`).
    fn refine(&mut self, now: Moment, (t0, t1): (f64, f64)) -> Result<Moment, ImpactError> {
        let t = refined(self.shapes, self.motions, (t0, now.t, t1), self.touch(&now));
        if t == now.t { Ok(now) } else { self.moment_at(t) }
    }

    /// For how long the pair certainly stays clear, at most `remaining` (s).
    fn safe_step(&mut self, now: &Moment, remaining: f64) -> Result<f64, ImpactError> {
        let mut step = self.clear_for(now, remaining)?;
        // A window that was clear to its end makes the step that many times as long: it reaches the end soon.
        loop {
            let window = step * NARROWER;
            if !(step > 0.0 && window < remaining) {
                break;
            }
            let longer = self.clear_for(now, window)?;
            step = step.max(longer);
            // The pair is clear for the whole narrow window, so that a wider window may give a longer step.
            // Written so that NaN ends it.
            let is_clear_to_its_end = longer >= window;
            if !is_clear_to_its_end {
                break;
            }
        }
        Ok(step)
    }

    /// As [`Self::safe_step`], with bounds that hold over a window of this length.
    fn clear_for(&mut self, now: &Moment, length: f64) -> Result<f64, ImpactError> {
        let end = now.t + length;
        let mut buffers = std::mem::take(&mut self.bounds);
        let window = Window::new(self.motions, now.poses, now.t, end, &mut buffers);
        let step = window.map(|mut window| self.clear_in(now, &mut window));
        self.bounds = buffers;
        step.ok_or(ImpactError::NotFinite { t: now.t })
    }

    fn clear_in(&mut self, now: &Moment, window: &mut Window<'_>) -> f64 {
        let [a, b] = self.shapes;
        match (a, b) {
            (Shape::Convex(_), Shape::Convex(_)) => self.polyhedra_clear(now, window),
            _ if a.is_half_space() && !circles(b).is_empty() || b.is_half_space() && !circles(a).is_empty() => {
                self.circles_clear_of_half_space(now, window)
            }
            _ if a.is_ring() || b.is_ring() => self.ring_clear(now, window),
            _ if (is_round(a) || is_round(b)) && !(a.is_half_space() || b.is_half_space()) => {
                self.round_clear(now, window)
            }
            (Shape::HalfSpace(_), _) => self.clear_of_surface(now, window, Side::B),
            (_, Shape::HalfSpace(_)) => self.clear_of_surface(now, window, Side::A),
            (Shape::Convex(_), _) => self.clear_of_surface(now, window, Side::B),
            (_, Shape::Convex(_)) => self.clear_of_surface(now, window, Side::A),
            (Shape::Sphere(s), _) => window.around_center(Side::B, b.centers(), s.center(), s.radius()),
            (_, Shape::Sphere(s)) => window.around_center(Side::A, a.centers(), s.center(), s.radius()),
            _ => f64::INFINITY,
        }
    }

    /// How long two polyhedra stay clear: the longest time over the plane of the best face of each body, the common
    /// normal of the best pair of edges, and the best of these directions fixed in the world (which is better for
    /// distant bodies that spin).
    fn polyhedra_clear(&self, now: &Moment, window: &mut Window<'_>) -> f64 {
        let ([Shape::Convex(a), Shape::Convex(b)], Some(axes)) = (self.shapes, self.axes) else { return 0.0 };
        let [pose_a, pose_b] = &now.poses;
        let (points_a, points_b) = (self.shapes[0].centers(), self.shapes[1].centers());
        let (hull_a, hull_b) = (Hull::of(self.shapes[0]), Hull::of(self.shapes[1]));
        let mut step: f64 = 0.0;
        let mut direction = (f64::NEG_INFINITY, DVec3::ZERO);
        if axes.face_a.separation > 0.0 {
            let face = &a.faces[axes.face_a.face as usize];
            step = step.max(points_clear_of_plane(now, window, Side::B, points_b, (face.normal, face.offset)));
            direction = (axes.face_a.separation, -pose_a.rotation.rotate(face.normal));
        }
        if axes.face_b.separation > 0.0 {
            let face = &b.faces[axes.face_b.face as usize];
            step = step.max(points_clear_of_plane(now, window, Side::A, points_a, (face.normal, face.offset)));
            if axes.face_b.separation > direction.0 {
                direction = (axes.face_b.separation, pose_b.rotation.rotate(face.normal));
            }
        }
        let edges = axes.edges.filter(|e| e.separation > 0.0);
        let crossed = edges.and_then(|e| CrossedEdges::new([a, b], [pose_a, pose_b], [e.edge_a, e.edge_b]));
        if let Some(crossed) = crossed {
            step = step.max(window.across_edges(&crossed, a, b));
            if crossed.separation > direction.0 {
                direction = (crossed.separation, crossed.normal);
            }
        }
        let (nearly_parallel, out_of_a) = axes.along_nearly_parallel;
        if nearly_parallel > 0.0 {
            step = step.max(window.along_direction(-pose_a.rotation.rotate(out_of_a), &hull_a, &hull_b));
        }
        if direction.0 > 0.0 { step.max(window.along_direction(direction.1, &hull_a, &hull_b)) } else { step }
    }

    /// How long points or a sphere of body `of` stay clear of a half-space or a polyhedron: each point has its own
    /// plane, through the nearest feature.
    fn clear_of_surface(&self, now: &Moment, window: &mut Window<'_>, of: Side) -> f64 {
        let (this, other) = (of.index(), of.other().index());
        let points = self.shapes[this].centers();
        let polyhedron = match self.shapes[other] {
            Shape::HalfSpace(h) => return points_clear_of_plane(now, window, of, points, (h.normal(), h.offset())),
            Shape::Convex(polyhedron) => polyhedron,
            _ => return 0.0,
        };
        let x = now.poses[other].relative(&now.poses[this]);
        let tolerance = place_tolerance(polyhedron.size(), polyhedron.size(), x.translation);
        let nearest = |k: usize| nearest_feature(polyhedron, x.transform_point(points.0[k]), tolerance);
        let step = window.above_planes(of, points, |k| {
            let nearest = nearest(k);
            (nearest.normal, nearest.distance - points.1)
        });
        // For a single centre far from a spinning polyhedron, a direction fixed in the world is better.
        if points.0.len() > 1 {
            return step;
        }
        let away = now.poses[other].rotation.rotate(nearest(0).normal);
        let direction = if of == Side::A { away } else { -away };
        step.max(window.along_direction(direction, &Hull::of(self.shapes[0]), &Hull::of(self.shapes[1])))
    }

    /// How long a round shape or a ring stays above a half-space: its points and its circles.
    fn circles_clear_of_half_space(&self, now: &Moment, window: &mut Window<'_>) -> f64 {
        let (of, this, other) = if self.shapes[1].is_half_space() { (Side::A, 0, 1) } else { (Side::B, 1, 0) };
        let Shape::HalfSpace(half_space) = self.shapes[other] else { return 0.0 };
        let hull = Hull::of(self.shapes[this]);
        hull_clear_of_plane(now, window, of, &hull, (half_space.normal(), half_space.offset()))
    }

    /// How long a round shape and another convex one stay clear: along the best axis, fixed in the world or
    /// perpendicular to straight elements, or above the plane of the best face or disc. A cloud stays clear as long as
    /// each of its points does.
    fn round_clear(&self, now: &Moment, window: &mut Window<'_>) -> f64 {
        let ([a, b], [pose_a, pose_b]) = (self.shapes, now.poses);
        let (hull_a, hull_b) = (Hull::of(a), Hull::of(b));
        if matches!(a, Shape::Points(_)) || matches!(b, Shape::Points(_)) {
            let mut step = f64::INFINITY;
            gap::each(Placed::new(a, &pose_a), Placed::new(b, &pose_b), f64::INFINITY, |gap| {
                let (hull_a, hull_b) = (only_point(a, hull_a, gap.a), only_point(b, hull_b, gap.b));
                step = step.min(window.along_direction(gap.normal, &hull_a, &hull_b));
            });
            return step;
        }
        let Some(gap) = self.gap else { return 0.0 };
        let step = window.along_direction(gap.normal, &hull_a, &hull_b);
        let step = step.max(self.clear_beside_lines(now, window, &gap));
        let of_plane = |shape: &Shape, feature: SurfaceFeature| {
            let SurfaceFeature::Face(_) = feature else { return None };
            match Element::of(shape, feature, &Pose::IDENTITY)?.locus {
                Locus::Plane(through, normal) => Some((normal, normal.dot(through))),
                _ => None,
            }
        };
        let (of, hull, plane) = match (of_plane(a, gap.a), of_plane(b, gap.b)) {
            (Some(plane), _) => (Side::B, hull_b, plane),
            (_, Some(plane)) => (Side::A, hull_a, plane),
            _ => return step,
        };
        step.max(hull_clear_of_plane(now, window, of, &hull, plane))
    }

    /// How long a ball, or each point of a cloud, and a torus stay clear; 0 for other pairs. At a distance `rho` from
    /// the torus's axis the distance from its centre circle has a second derivative of at least `-1/rho` along any unit
    /// vector; at a speed of `speed` (m/s) this is an acceleration of `speed^2/rho`.
    fn centers_clear_of_ring(&self, now: &Moment, window: &mut Window<'_>, speed: f64) -> f64 {
        let (of, this, other, torus) = match self.shapes {
            [Shape::Torus(torus), Shape::Sphere(_) | Shape::Points(_)] => (Side::B, 1, 0, torus),
            [Shape::Sphere(_) | Shape::Points(_), Shape::Torus(torus)] => (Side::A, 0, 1, torus),
            _ => return 0.0,
        };
        let Some(ring) = circles(self.shapes[other]).first().copied() else { return 0.0 };
        let x = now.poses[other].relative(&now.poses[this]);
        let (centers, radius) = self.shapes[this].centers();
        let mut step = f64::INFINITY;
        for center in centers {
            let y = x.transform_point(*center);
            let away = y - ring.nearest(y);
            let (distance, rho) = (away.length(), ring.axis.cross(y - ring.center).length());
            let gap = distance - torus.minor - radius;
            let least = rho - speed * window.length();
            // Near the axis the distance over the speed is all that is known.
            let clear = if least < LEAST_AXIS_DISTANCE * rho || rho == 0.0 || distance == 0.0 {
                (gap / speed).min(window.length())
            } else {
                let only = (std::slice::from_ref(center), radius);
                window.above_surfaces(of, only, speed * speed / least, |_| (away / distance, gap))
            };
            step = step.min(clear);
        }
        step
    }

    /// How long the bodies stay clear along the normal of the gap when it rotates so as to stay perpendicular to the
    /// straight ones of the two closest elements; 0 without such elements.
    fn clear_beside_lines(&self, now: &Moment, window: &mut Window<'_>, gap: &Gap) -> f64 {
        let [a, b] = self.shapes;
        let features = [(a, gap.a, &now.poses[0]), (b, gap.b, &now.poses[1])];
        let elements = features.map(|(shape, feature, pose)| Element::of(shape, feature, pose));
        let along = |element: &Option<Element<'_>>| {
            let element = element.as_ref()?;
            let line = element.straight_direction(gap.normal).or_else(|| self.tangent(element, gap.normal))?;
            line.cross(gap.normal).try_normalize()
        };
        let mut lines = [along(&elements[0]), along(&elements[1])];
        // Beside a line the normal of a disc turns about it as the disc does.
        for (of, beside) in [(0, 1), (1, 0)] {
            let is_plane = elements[of].as_ref().is_some_and(|element| matches!(element.locus, Locus::Plane(..)));
            if let (None, Some(across), true) = (lines[of], lines[beside], is_plane && self.began_in_touch) {
                lines[of] = across.cross(gap.normal).try_normalize();
            }
        }
        match window.turn_with(lines) {
            Some(turn) => window.along_turning(gap.normal, turn, &Hull::of(a), &Hull::of(b)),
            None => 0.0,
        }
    }

    /// The tangent of a rim where it is closest, for a search that began in touch: a rim that stays near an edge turns
    /// about it, and along a normal that does not turn with the tangent its gap would seem to close at the speed of the
    /// rim. Pairs that begin apart approach so fast that this does not matter.
    fn tangent(&self, element: &Element<'_>, normal: DVec3) -> Option<DVec3> {
        match element.locus {
            Locus::Circle(circle) if self.began_in_touch => circle.axis.cross(normal).try_normalize(),
            _ => None,
        }
    }

    /// How long a torus and another shape stay clear: their hulls along the normal of the gap, where that separates
    /// them. Otherwise (a body in the hole) arc by arc, or at least the distance over the largest relative speed of two
    /// points.
    fn ring_clear(&mut self, now: &Moment, window: &mut Window<'_>) -> f64 {
        let Some(gap) = self.gap else { return 0.0 };
        let [a, b] = self.shapes;
        let apart = (now.poses[0].translation - now.poses[1].translation).length();
        let speed = window.largest_speed(a.radius().min(b.radius() + apart), b.radius());
        // The speed is a bound within the window only.
        let step = (now.separation / speed).min(window.length()).max(self.centers_clear_of_ring(now, window, speed));
        let step = step.max(window.along_direction(gap.normal, &Hull::of(a), &Hull::of(b)));
        let step = step.max(self.clear_beside_lines(now, window, &gap));
        if step >= window.length() {
            return step;
        }
        if let Some(rings) = RingPair::new(self.shapes, now.poses) {
            return step.max(rings.clear(window, &mut self.cuts));
        }
        RingArcs::new(self.shapes, now.poses).map_or(step, |arcs| step.max(arcs.clear(window, &mut self.cuts)))
    }

    /// The search from a time at which the pair is in contact: see the description in `time_of_impact.rs`.
    fn depart(&mut self, start: Moment, t1: f64) -> Result<Ended, ImpactError> {
        self.began_in_touch = true;
        let rounding = self.resolution(&start);
        // Below this the separation has measurably decreased. Bodies in contact at rest stay above it.
        let noticed = (NOTICED * self.touch(&start)).max(MEASURABLE * rounding);
        let level = if start.separation > rounding {
            0.0
        } else if start.separation >= -CLOSED * self.touch(&start) {
            start.separation - noticed
        } else {
            // The penetration at the start is already noticeable: any measurable increase is an impact.
            (start.separation - MEASURABLE * rounding).min(-noticed)
        };
        let closed = start.separation.min(0.0) - (CLOSED * self.touch(&start)).max(MEASURABLE * rounding);
        let (mut above, mut below, mut last): (_, Option<Moment>, _) = (start, None, start);
        // More halvings than this give an interval below the smallest double.
        let most = f64::MANTISSA_DIGITS + f64::MIN_EXP.unsigned_abs();
        let mut halvings = self.settings.departure_halvings.min(most);
        while halvings > 0 && !self.can_have_moved(&start, t1, halvings)? {
            halvings -= 1;
        }
        for j in (0..=halvings).rev() {
            let t = if j == 0 { t1 } else { start.t + (t1 - start.t) * halved(j) };
            if t <= last.t {
                continue;
            }
            last = self.moment_at(t)?;
            let touch = self.touch(&last);
            let overlap = below.filter(|below| last.separation >= level && below.separation < closed);
            if let Some(overlap) = overlap {
                // It penetrated, by less than the touch tolerance, and separates again.
                let above = if above.separation >= closed { above } else { start };
                return self.locate_closing(above, overlap, closed, rounding);
            }
            if last.separation > touch && last.t < t1 {
                let step = self.safe_step(&last, t1 - last.t)?;
                if step >= LEAST_PROGRESS * (last.t - start.t) || last.separation > APART * touch {
                    self.departing_step = Some(step);
                    return Ok(Ended::GoesOn(last));
                }
            }
            if last.separation >= level {
                (above, below) = (last, None);
            } else {
                below = below.or(Some(last));
            }
            // If the pair overlaps at the start, only additional penetration counts.
            if last.separation < (-touch).min(start.separation - touch) {
                return self.locate_closing(above, below.unwrap_or(last), level, rounding);
            }
        }
        // Penetration at the end, below the touch tolerance. It counts, because the next search would take it as its
        // start.
        if last.separation < closed {
            let above = if above.separation >= closed { above } else { start };
            return self.locate_closing(above, last, closed, rounding);
        }
        Ok(Ended::At(None, last.separation))
    }

    /// Whether a point can have moved by the distance that counts as an impact (`CLOSED`) by the `j`-th departure time.
    fn can_have_moved(&mut self, start: &Moment, t1: f64, j: u32) -> Result<bool, ImpactError> {
        let length = (t1 - start.t) * halved(j);
        let mut buffers = std::mem::take(&mut self.bounds);
        let apart = (start.poses[0].translation - start.poses[1].translation).length();
        // A half-space has no radius; the radius of the other body is used.
        let radius = |own: &Shape, other: &Shape| own.radius().min(other.radius() + apart);
        let [a, b] = self.shapes;
        let speed = Window::new(self.motions, start.poses, start.t, start.t + length, &mut buffers)
            .map(|window| window.largest_speed(radius(a, b), radius(b, a)));
        self.bounds = buffers;
        let speed = speed.ok_or(ImpactError::NotFinite { t: start.t })?;
        let path = speed * length;
        Ok(path.is_nan() || path >= CLOSED * self.touch(start))
    }

    /// The time, between two evaluations, at which the separation falls below a level.
    fn locate_closing(
        &mut self,
        above: Moment,
        below: Moment,
        level: f64,
        tolerance: f64,
    ) -> Result<Ended, ImpactError> {
        let left = Sample { at: above.t, value: above.separation - level };
        let right = Sample { at: below.t, value: below.separation - level };
        let found =
            last_not_negative(left, right, tolerance, |t| self.moment_at(t).map(|moment| moment.separation - level))?;
        Ok(Ended::At(Some(found.at), found.value + level))
    }
}
