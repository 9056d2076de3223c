//! Curves of pieces.
//!
//! A curve is a row of pieces, each with one formula (`piece.rs`), whose tangent has no jump. Of each of its places
//! there are the point, the unit tangent `t` and the derivative of the tangent by the arc length, `k = dt/ds`, whose
//! length is the curvature (1/m). A point `p` near the curve has a foot, the place `s` of the curve with `(p -
//! c(s)).t(s) = 0`, for which
//!
//! `s' = t.p' / (1 - k.(p - c))`
//!
//! Source: do Carmo 1976, chapter 1. Assumptions: no cusp, and no two parts at one place ([`CurveError`]); both are
//! checked when a curve is made. The curvature may jump from piece to piece, as from a straight line to a circle.

use super::error::{CurveError, finite, positive};
use super::piece::{Piece, Stretch};
use super::place::CurvePoint;
use super::span::{Block, Span, blocks, spans};
use super::spline::{self, SplineEnds};
use crate::rounding;
use crate::unit_vector::UnitVector;
use glam::DVec3;
use std::f64::consts::TAU;

/// How far from a plane the points of a curve in it may be, as a part of its size (no unit, 1e-14 to 1e-10): rounding.
const IN_PLANE_RELATIVE: f64 = 1e-12;

/// The plane that a curve lies in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CurvePlane {
    /// Every plane along it: it is straight.
    Straight,
    /// The plane with this normal; of a path and a wave the normal is heading x up, so that up is on its left, and a
    /// circle goes anticlockwise about it.
    Plane(UnitVector),
    /// None.
    None,
}

/// A part of a path in a plane, along which the curvature changes evenly: straight, an arc of a circle, or a clothoid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// m.
    pub length: f64,
    /// Curvature at its start and its end, 1/m: positive where it bends up.
    pub curvature: [f64; 2],
}

/// A curve in space.
///
/// ```
/// use polhode_spatial::DVec3;
/// use polhode_spatial::curve::{Curve, CurvePlane};
/// use polhode_spatial::UnitVector;
/// let circle = Curve::circle(DVec3::ZERO, UnitVector::Z, DVec3::X * 2.0)?;
/// let foot = circle.nearest(DVec3::Y * 3.0);
/// assert!((foot.point - DVec3::Y * 2.0).length() < 1e-15);
/// assert!((foot.curvature + DVec3::Y * 0.5).length() < 1e-15);
/// assert!((circle.length() - 4.0 * std::f64::consts::PI).abs() < 1e-14);
/// assert_eq!(circle.plane(), CurvePlane::Plane(UnitVector::Z));
/// # Ok::<(), polhode_spatial::curve::CurveError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) stretches: Vec<Stretch>,
    pub(super) spans: Vec<Span>,
    pub(super) blocks: Vec<Block>,
    pub(super) length: f64,
    pub(super) is_closed: bool,
    plane: CurvePlane,
}

impl Curve {
    /// The straight line between two points, m.
    ///
    /// # Errors
    /// When they are one point, or not finite.
    pub fn line(from: DVec3, to: DVec3) -> Result<Self, CurveError> {
        finite("a point", from.is_finite() && to.is_finite())?;
        let length = (to - from).length();
        let Ok(heading) = UnitVector::new(to - from) else {
            return Err(CurveError::Coincident { first: 0, second: 1 });
        };
        let (heading, left) = (heading.get(), heading.get().any_orthonormal_vector());
        let piece = Piece::Bend { heading, left, curvature: 0.0, curvature_rate: 0.0 };
        Self::new(vec![Stretch { piece, from: 0.0, to: length }], from, false, Some(CurvePlane::Straight))
    }

    /// The circle about a center (m), anticlockwise about an axis, that begins in the direction of a vector whose
    /// length is the radius (m): its part along the axis is left out.
    ///
    /// # Errors
    /// When the radius is zero, or a number is not finite.
    pub fn circle(center: DVec3, axis: UnitVector, out: DVec3) -> Result<Self, CurveError> {
        Self::helix(center, axis, out, Coil { advance: 0.0, turns: 1.0 })
    }

    /// The helix about an axis through a point (m), anticlockwise about it, that begins in the direction of a vector
    /// whose length is the radius (m): its part along the axis is left out.
    ///
    /// # Errors
    /// When the radius is zero, or the turns are not positive, or a number is not finite.
    pub fn helix(center: DVec3, axis: UnitVector, out: DVec3, coil: Coil) -> Result<Self, CurveError> {
        let Coil { advance, turns } = coil;
        finite("a center", center.is_finite())?;
        finite("an advance", advance.is_finite())?;
        positive("the turns", turns)?;
        let axis = axis.get();
        let out = out - axis * axis.dot(out);
        let radius = positive("the radius", out.length())?;
        let x = out / radius;
        let piece = Piece::Helix { center, x, y: axis.cross(x), axis, radius, advance: advance / TAU };
        let is_closed = advance == 0.0 && turns == 1.0;
        let plane = if advance == 0.0 {
            UnitVector::new(axis).map_or(CurvePlane::None, CurvePlane::Plane)
        } else {
            CurvePlane::None
        };
        Self::new(vec![Stretch { piece, from: 0.0, to: TAU * turns }], center, is_closed, Some(plane))
    }

    /// The path of bends in the plane of two directions that begins at a point (m) along the first one: the second one
    /// says which side is up. It is closed where it ends as it began.
    ///
    /// # Errors
    /// When there is no bend, a length is not positive, the directions are parallel, or a number is not finite.
    pub fn path(start: DVec3, heading: UnitVector, up: DVec3, bends: &[Bend]) -> Result<Self, CurveError> {
        finite("a point", start.is_finite())?;
        let frame = PathFrame::new(heading, up)?;
        if bends.is_empty() {
            return Err(CurveError::TooFew { what: "bends", found: 0, least: 1 });
        }
        let mut stretches = Vec::with_capacity(bends.len());
        let mut angle = 0.0_f64;
        for bend in bends {
            let length = positive("the length of a bend", bend.length)?;
            let [first, last] = bend.curvature;
            finite("the curvature of a bend", first.is_finite() && last.is_finite())?;
            let (sin, cos) = libm::sincos(angle);
            let heading = frame.heading * cos + frame.left * sin;
            let left = frame.left * cos - frame.heading * sin;
            let piece = Piece::Bend { heading, left, curvature: first, curvature_rate: (last - first) / length };
            stretches.push(Stretch { piece, from: 0.0, to: length });
            angle += 0.5 * (first + last) * length;
        }
        let is_straight = bends.iter().all(|bend| bend.curvature == [0.0; 2]);
        let plane = if is_straight { CurvePlane::Straight } else { CurvePlane::Plane(frame.normal) };
        let open = Self::new(stretches, start, false, Some(plane))?;
        let [first, last] = [open.at(0.0), open.at(open.length)];
        let closes = (last.point - first.point).length() <= rounding::DIGITS_OF_A_FILE * open.length
            && (last.tangent - first.tangent).length() <= rounding::DIGITS_OF_A_FILE;
        let closed = Self { is_closed: closes, ..open };
        closed.check_distance_from_itself()?;
        Ok(closed)
    }

    /// The cubic spline through points (m), whose curvature has no jump.
    ///
    /// # Errors
    /// When there are too few points, two that follow each other are one, or one is not finite.
    pub fn spline(points: &[DVec3], ends: SplineEnds) -> Result<Self, CurveError> {
        let stretches = spline::pieces(points, ends)?;
        Self::new(stretches, points[0], ends == SplineEnds::Closed, None)
    }

    /// The curve `sum a_k u^k` of these coefficients (m over the unit of `u` to the power k), from the lowest, over a
    /// range of `u`.
    ///
    /// # Errors
    /// When there are fewer than two coefficients, the range is empty, the curve has a cusp, or a number is not finite.
    pub fn polynomial(coefficients: &[DVec3], [from, to]: [f64; 2]) -> Result<Self, CurveError> {
        let found = coefficients.len();
        if found < 2 {
            return Err(CurveError::TooFew { what: "coefficients", found, least: 2 });
        }
        finite("a coefficient", coefficients.iter().all(|own| own.is_finite()))?;
        positive("the range of the parameter", to - from)?;
        let piece = Piece::Polynomial(coefficients.to_vec());
        Self::new(vec![Stretch { piece, from, to }], DVec3::ZERO, false, None)
    }

    /// The wave `start + e x + A f cos(2 pi x / wavelength)`, `0 <= x <= length`, where `e` is the heading and `f` the
    /// part of up at right angles to it: it begins on a crest.
    ///
    /// # Errors
    /// When the wavelength or the length is not positive, the directions are parallel, or a number is not finite.
    pub fn wave(start: DVec3, heading: UnitVector, up: DVec3, wave: Wave) -> Result<Self, CurveError> {
        let Wave { amplitude, wavelength, length } = wave;
        finite("a point", start.is_finite())?;
        finite("the amplitude", amplitude.is_finite())?;
        let frame = PathFrame::new(heading, up)?;
        let wavenumber = TAU / positive("the wavelength", wavelength)?;
        let to = positive("the length", length)?;
        let piece = Piece::Wave { start, along: frame.heading, up: frame.left, amplitude, wavenumber };
        Self::new(vec![Stretch { piece, from: 0.0, to }], start, false, Some(CurvePlane::Plane(frame.normal)))
    }

    /// The cycloid `lowest + R e (a + sin a) + R f (1 - cos a)`, `-reach <= a <= reach` (rad, below pi), where `e` is
    /// the heading and `f` the part of up at right angles to it: the curve on which all falls to the lowest point last
    /// as long (Huygens 1673).
    ///
    /// # Errors
    /// When the radius is not positive, the reach is not between 0 and pi, the directions are parallel, or a number is
    /// not finite.
    pub fn cycloid(lowest: DVec3, heading: UnitVector, up: DVec3, rolling: Rolling) -> Result<Self, CurveError> {
        let Rolling { radius, reach } = rolling;
        finite("a point", lowest.is_finite())?;
        let frame = PathFrame::new(heading, up)?;
        let radius = positive("the radius", radius)?;
        positive("the reach of a cycloid", reach)?;
        positive("the distance of the reach of a cycloid from its cusps, pi - reach,", std::f64::consts::PI - reach)?;
        let piece = Piece::Cycloid { lowest, along: frame.heading, up: frame.left, radius };
        let plane = Some(CurvePlane::Plane(frame.normal));
        Self::new(vec![Stretch { piece, from: -reach, to: reach }], lowest, false, plane)
    }

    pub(super) fn new(
        stretches: Vec<Stretch>,
        start: DVec3,
        is_closed: bool,
        plane: Option<CurvePlane>,
    ) -> Result<Self, CurveError> {
        let spans = spans(&stretches, start)?;
        let length = spans.last().map_or(0.0, |span| span.arc + span.length);
        positive("the length", length)?;
        let blocks = blocks(&spans);
        let mut curve = Self { stretches, spans, blocks, length, is_closed, plane: CurvePlane::None };
        curve.plane = plane.unwrap_or_else(|| curve.find_plane());
        // A path is checked when it is known whether it is closed.
        if !matches!(curve.stretches[0].piece, Piece::Bend { .. }) {
            curve.check_distance_from_itself()?;
        }
        Ok(curve)
    }

    /// The plane of its points, if there is one.
    fn find_plane(&self) -> CurvePlane {
        let middle = |span: &Span| self.at(span.arc + 0.5 * span.length).point;
        let points: Vec<DVec3> = self.spans.iter().flat_map(|span| [span.start, middle(span), span.end]).collect();
        let origin = points[0];
        let farthest = |of: &dyn Fn(DVec3) -> DVec3| {
            points
                .iter()
                .map(|point| of(*point - origin))
                .fold(DVec3::ZERO, |most, way| if way.length() > most.length() { way } else { most })
        };
        let along = farthest(&|way| way);
        let size = along.length();
        let across = farthest(&|way| along.cross(way) / size);
        if across.length() <= IN_PLANE_RELATIVE * size {
            return CurvePlane::Straight;
        }
        let Ok(normal) = UnitVector::new(across) else { return CurvePlane::None };
        let is_in_plane = |point: &DVec3| normal.get().dot(*point - origin).abs() <= IN_PLANE_RELATIVE * size;
        if points.iter().all(is_in_plane) { CurvePlane::Plane(normal) } else { CurvePlane::None }
    }

    /// The place at an arc length from its start, m: between 0 and the length, the nearest of which stands for any
    /// other.
    pub fn at(&self, arc: f64) -> CurvePoint {
        let number = self.spans.partition_point(|span| span.arc <= arc).saturating_sub(1);
        let span = &self.spans[number];
        let piece = &self.stretches[span.piece].piece;
        let left = (arc - span.arc).clamp(0.0, span.length);
        let mut u = span.from + (span.to - span.from) * (left / span.length);
        if piece.even_speed().is_none() {
            /// Newton's iteration from within a quarter of a radian doubles its digits at each step.
            const STEPS: usize = 6;
            for _ in 0..STEPS {
                let excess = piece.arc_length((span.from, u)) - left;
                let speed = piece.at(u, span.known()).speed();
                u = (u - excess / speed).clamp(span.from, span.to);
            }
        }
        self.at_parameter(number, u)
    }

    /// The place at a parameter in a span.
    pub(super) fn at_parameter(&self, number: usize, u: f64) -> CurvePoint {
        let span = &self.spans[number];
        let piece = &self.stretches[span.piece].piece;
        let jet = piece.at(u, span.known());
        let arc = span.arc + piece.arc_length((span.from, u));
        let (tangent, curvature) = (jet.tangent(), jet.curvature());
        CurvePoint { point: jet.point, tangent, curvature, curvature_rate: jet.curvature_rate(), arc }
    }

    /// The first place, as arc length (m), at which the curvature jumps: between two pieces, as from a straight line to
    /// a circle. That of a straight continuation beyond an end does not count.
    pub fn curvature_jump(&self) -> Option<f64> {
        let ends = |spans: [&Span; 2]| {
            let [before, after] = spans;
            let end = self.stretches[before.piece].piece.at(before.to, before.known()).curvature();
            let start = self.stretches[after.piece].piece.at(after.from, after.known()).curvature();
            let size = end.length().max(start.length());
            ((end - start).length() > rounding::DIGITS_OF_A_FILE * size).then_some(after.arc)
        };
        let first_and_last = self.spans.first().zip(self.spans.last()).filter(|_| self.is_closed);
        let mut inside = self.spans.windows(2).filter(|pair| pair[0].piece != pair[1].piece);
        let inside = inside.find_map(|pair| ends([&pair[0], &pair[1]]));
        inside.or_else(|| first_and_last.and_then(|(first, last)| ends([last, first])))
    }

    /// Arc length, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Whether its end is its start.
    pub fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// The plane that it lies in.
    pub fn plane(&self) -> CurvePlane {
        self.plane
    }

    /// Points along it with which it can be drawn, m: both ends, and where it bends at least sixteen for each radian.
    pub fn polyline(&self) -> Vec<DVec3> {
        let of_span = |span: &Span| {
            let parts: u32 = if span.sagitta > 0.0 { 4 } else { 1 };
            let (from, length) = (span.arc, span.length);
            (1..=parts).map(move |k| from + length * f64::from(k) / f64::from(parts))
        };
        let arcs = self.spans.iter().flat_map(of_span);
        std::iter::once(0.0).chain(arcs).map(|arc| self.at(arc).point).collect()
    }
}

/// How a helix winds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coil {
    /// Displacement along the axis for each turn, m.
    pub advance: f64,
    /// How many turns.
    pub turns: f64,
}

/// The form of a wave, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wave {
    /// Height of its crests above its middle; negative where it begins in a trough.
    pub amplitude: f64,
    /// From crest to crest.
    pub wavelength: f64,
    /// Along the heading.
    pub length: f64,
}

/// The form of a cycloid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rolling {
    /// Of the wheel, m.
    pub radius: f64,
    /// By how much the wheel turns to either side of the lowest point, rad: below pi, where the cycloid has cusps.
    pub reach: f64,
}

/// Unit vectors along a path, to its left, and normal to its plane.
#[derive(Debug, Clone, Copy)]
struct PathFrame {
    heading: DVec3,
    left: DVec3,
    normal: UnitVector,
}

impl PathFrame {
    fn new(heading: UnitVector, up: DVec3) -> Result<Self, CurveError> {
        let heading = heading.get();
        let normal = UnitVector::new(up).and_then(|up| UnitVector::new(heading.cross(up.get())));
        let normal = normal.map_err(|_| CurveError::Parallel)?;
        Ok(Self { heading, left: normal.get().cross(heading), normal })
    }
}
