//! Planes with a grid, which fades into the background far away.

use super::scene_triangles::Plane;
use crate::colors::{self, Color};
use polhode::spatial::DVec3;

/// Width of a line of the grid, as a fraction of the distance between lines.
const LINE: f64 = 0.012;
/// How strong a line is.
const LINE_INK: f64 = 0.7;
/// Distance between lines, as a fraction of the size of what is shown, before it is rounded.
const SPACING: f64 = 0.25;
/// Where the ground begins to fade and where it has faded, in sizes of what is shown.
const FADING: [f64; 2] = [1.5, 6.0];
/// Smallest spacing of the grid, m.
const SMALLEST_SPACING_M: f64 = 1e-9;

/// The ground of a picture.
#[derive(Debug, Clone)]
pub struct Ground {
    planes: Vec<(Plane, [DVec3; 2])>,
    center: DVec3,
    size_m: f64,
    spacing_m: f64,
    /// Of the ground, and of a line on it.
    colors: [Color; 2],
}

/// What is seen of a plane.
#[derive(Debug, Clone, Copy)]
pub struct GroundPoint {
    /// `1/z`, 1/m.
    pub nearness: f64,
    /// Where, m.
    pub place: DVec3,
    /// Unit normal of the plane.
    pub normal: DVec3,
    /// Colour.
    pub color: Color,
    /// How much of it is left, 0 to 1.
    pub strength: f64,
}

/// What the rays of a block of samples see of the ground.
#[derive(Debug, Clone, Copy)]
pub enum Block {
    /// All pass it.
    Nothing,
    /// All meet the inside of one cell of the grid, where nothing has faded.
    Cell(Cell),
    /// They may see different things.
    Mixed,
}

/// The inside of a cell of the grid.
#[derive(Debug, Clone, Copy)]
pub struct Cell {
    /// Unit normal of its plane.
    pub normal: DVec3,
    /// Its colour.
    pub color: Color,
    offset_m: f64,
}

impl Cell {
    /// `1/z` of the place that a ray from the eye meets, 1/m.
    pub fn nearness(&self, eye: DVec3, ray: DVec3) -> f64 {
        -self.normal.dot(ray) / (self.normal.dot(eye) - self.offset_m)
    }
}

impl Ground {
    /// Planes under what lies in a box.
    pub fn new(planes: &[Plane], bounds: [DVec3; 2]) -> Self {
        let size_m = (bounds[1] - bounds[0]).length();
        let axes = |plane: &Plane| {
            let across = plane.normal.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
            // For level ground x and y of the world.
            let across = if across.x < 0.0 { -across } else { across };
            [across, plane.normal.cross(across)]
        };
        Self {
            planes: planes.iter().map(|plane| (*plane, axes(plane))).collect(),
            center: 0.5 * (bounds[0] + bounds[1]),
            size_m,
            spacing_m: spacing_m(bounds),
            colors: {
                let [ground, grid] = [colors::GROUND, colors::GRID].map(colors::linear);
                [ground, std::array::from_fn(|i| ground[i] + (grid[i] - ground[i]) * LINE_INK)]
            },
        }
    }

    /// What a block sees whose corners are seen in these directions. The cells of a grid and the part of a plane that
    /// has not faded are convex, and so is their picture: what holds at the corners holds between them.
    pub fn block(&self, eye: DVec3, corners: [DVec3; 4]) -> Block {
        let passes = |(plane, _): &(Plane, [DVec3; 2])| corners.iter().all(|ray| plane.normal.dot(*ray) >= 0.0);
        if self.planes.iter().all(passes) {
            return Block::Nothing;
        }
        let [(plane, axes)] = &self.planes[..] else { return Block::Mixed };
        let cell = |ray: DVec3| {
            let point = self.seen(eye, ray).filter(|point| point.strength >= 1.0 && point.color == self.colors[0])?;
            Some(axes.map(|axis| (axis.dot(point.place) / self.spacing_m).floor()))
        };
        let [first, others @ ..] = corners.map(cell);
        if first.is_some() && others.iter().all(|other| *other == first) {
            Block::Cell(Cell { normal: plane.normal, color: self.colors[0], offset_m: plane.offset_m })
        } else {
            Block::Mixed
        }
    }

    /// The nearest plane that a ray from the eye meets; the ray's component forwards is 1.
    pub fn seen(&self, eye: DVec3, ray: DVec3) -> Option<GroundPoint> {
        let mut nearest: Option<GroundPoint> = None;
        for (plane, axes) in &self.planes {
            let falls = -plane.normal.dot(ray);
            let above = plane.normal.dot(eye) - plane.offset_m;
            // From below, a half-space hides nothing.
            if falls <= 0.0 || above <= 0.0 {
                continue;
            }
            let nearness = falls / above;
            if nearest.is_some_and(|other| other.nearness >= nearness) {
                continue;
            }
            let place = eye + ray / nearness;
            let below = self.center - plane.normal * (plane.normal.dot(self.center) - plane.offset_m);
            let far = ((place - below).length() / self.size_m - FADING[0]) / (FADING[1] - FADING[0]);
            let strength = 1.0 - far.clamp(0.0, 1.0);
            let on_line = axes.iter().any(|axis| {
                let at = axis.dot(place) / self.spacing_m;
                (at - at.round()).abs() < 0.5 * LINE
            });
            let color = self.colors[usize::from(on_line)];
            nearest = Some(GroundPoint { nearness, place, normal: plane.normal, color, strength });
        }
        nearest.filter(|point| point.strength > 0.0)
    }
}

/// Distance between the lines of the grid under what lies in a box, m.
pub fn spacing_m(bounds: [DVec3; 2]) -> f64 {
    round_length(SPACING * (bounds[1] - bounds[0]).length())
}

/// 1, 2 or 5 times a power of ten, at most this.
pub(crate) fn round_length(wanted: f64) -> f64 {
    let mut spacing = SMALLEST_SPACING_M;
    while 10.0 * spacing <= wanted && spacing.is_finite() {
        spacing *= 10.0;
    }
    [5.0, 2.0].into_iter().map(|factor| factor * spacing).find(|&larger| larger <= wanted).unwrap_or(spacing)
}
