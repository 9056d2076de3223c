//! What the lamp sees: a parallel picture of depths, from which shadow follows.
//!
//! A place is in shadow where the lamp sees something nearer. Source: docs/REFERENCES.md, Williams 1978.

use super::paint::Paint;
use super::processors::on_all_processors;
use super::projection::Projected;
use super::scene_triangles::{SceneTriangles, Triangle};
use crate::light::Light;
use polhode::spatial::DVec3;

/// Texels each way.
const SIZE: usize = 2048;
/// Rows of texels of a band.
const BAND: usize = 16;
/// How far a surface lies before its own shadow, texels: what the map rounds.
const BIAS_TEXELS: f64 = 2.5;
/// Texels each way around a place over which its shadow is averaged.
const SOFTNESS: i64 = 1;

/// Where the lamp looks.
#[derive(Debug, Clone, Copy)]
struct Frame {
    axes: [DVec3; 3],
    /// Corner of the map, in its axes, m.
    low: DVec3,
    texel_m: f64,
}

impl Frame {
    /// A place in the map: across and down, texels; height, m.
    fn placed(&self, point: DVec3) -> Projected {
        let arm = along(self.axes, point) - self.low;
        Projected { x: arm.x / self.texel_m, y: arm.y / self.texel_m, nearness: arm.z }
    }
}

/// A point in other axes.
fn along(axes: [DVec3; 3], point: DVec3) -> DVec3 {
    DVec3::from_array(axes.map(|axis| axis.dot(point)))
}

/// Depths seen from the lamp.
#[derive(Debug)]
pub struct ShadowMap {
    frame: Frame,
    /// Height towards the lamp of the highest surface, m, above the corner of the map.
    heights: Vec<f32>,
}

impl ShadowMap {
    /// Of what throws shadows; none where nothing does.
    pub fn new(scene: &SceneTriangles, light: &Light) -> Option<Self> {
        let towards = light.towards;
        let across = towards.any_orthonormal_vector();
        let axes = [across, towards.cross(across), towards];
        let is_solid = |triangle: &&Triangle| scene.paints.get(triangle.paint).is_some_and(Paint::is_solid);
        let solid = || scene.triangles.iter().filter(is_solid);
        let points = solid().flat_map(|triangle| triangle.corners).map(|corner| along(axes, corner));
        let bounds = points.fold(None, |bounds: Option<[DVec3; 2]>, p| {
            Some(bounds.map_or([p; 2], |[low, high]| [low.min(p), high.max(p)]))
        });
        let [low, high] = bounds?;
        let texel_m = (high - low).truncate().max_element() / (SIZE - 2) as f64;
        if texel_m <= 0.0 || !texel_m.is_finite() {
            return None;
        }
        let frame = Frame { axes, low: low - DVec3::new(texel_m, texel_m, 0.0), texel_m };
        let triangles: Vec<[Projected; 3]> =
            solid().map(|triangle| triangle.corners.map(|corner| frame.placed(corner))).collect();
        let bands: Vec<usize> = (0..SIZE).step_by(BAND).collect();
        let heights = on_all_processors(&bands, |&first| band(&triangles, first)).concat();
        Some(Self { frame, heights })
    }

    /// The part of the lamp that a place with this unit normal sees, 0 to 1.
    pub fn lit(&self, place: DVec3, normal: DVec3) -> f64 {
        let Frame { axes: [_, _, towards], texel_m, .. } = self.frame;
        let cosine = normal.dot(towards);
        if cosine <= 0.0 {
            return 0.0;
        }
        // Moved out along the normal, the more the lower the lamp stands over the surface.
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let moved = place + normal * (BIAS_TEXELS * texel_m * (0.3 + sine));
        let at = self.frame.placed(moved);
        let (x, y) = (at.x.floor() as i64, at.y.floor() as i64);
        let height = (at.nearness + 0.5 * BIAS_TEXELS * texel_m) as f32;
        // A row of texels of which none is in the map throws no shadow.
        let row = |v: i64| {
            let columns = (x - SOFTNESS).max(0) as usize..((x + SOFTNESS + 1).max(0) as usize).min(SIZE);
            let row = usize::try_from(v).ok().filter(|&v| v < SIZE).map(|v| v * SIZE);
            row.and_then(|first| self.heights.get(first + columns.start..first + columns.end.max(columns.start)))
        };
        let rows = (y - SOFTNESS..=y + SOFTNESS).filter_map(row);
        let hidden: usize = rows.map(|row| row.iter().filter(|&&other| other > height).count()).sum();
        let count = (2 * SOFTNESS + 1) * (2 * SOFTNESS + 1);
        (count - hidden as i64) as f64 / count as f64
    }
}

/// The heights of the rows of a band, whose first is this.
fn band(triangles: &[[Projected; 3]], first: usize) -> Vec<f32> {
    let mut heights = vec![f32::NEG_INFINITY; SIZE * BAND];
    let [top, bottom] = [first as f64, (first + BAND) as f64];
    let meets = |[a, b, c]: &&[Projected; 3]| a.y.max(b.y).max(c.y) >= top && a.y.min(b.y).min(c.y) <= bottom;
    for triangle in triangles.iter().filter(meets) {
        for (row, row_heights) in heights.chunks_exact_mut(SIZE).enumerate() {
            draw_row(*triangle, first + row, row_heights);
        }
    }
    heights
}

/// Raises a row of heights to those of a triangle.
fn draw_row([a, b, c]: [Projected; 3], y: usize, heights: &mut [f32]) {
    let py = y as f64 + 0.5;
    let Some([left, right]) = between([a, b, c], py) else { return };
    let twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if twice_area == 0.0 {
        return;
    }
    // A texel more on both sides: whether a middle lies in the triangle is asked below.
    let last = ((right.ceil() + 1.0).max(0.0) as usize).min(heights.len());
    let begin = ((left.floor() - 1.0).max(0.0) as usize).min(last);
    for (x, place) in heights.iter_mut().enumerate().take(last).skip(begin) {
        let px = x as f64 + 0.5;
        let wb = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / twice_area;
        let wc = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / twice_area;
        let wa = 1.0 - wb - wc;
        if wa.min(wb).min(wc) >= 0.0 {
            *place = place.max((wa * a.nearness + wb * b.nearness + wc * c.nearness) as f32);
        }
    }
}

/// Where the sides of a triangle meet a row: the least and the greatest; none where they do not.
fn between(corners: [Projected; 3], y: f64) -> Option<[f64; 2]> {
    let [a, b, c] = corners;
    let mut range: Option<[f64; 2]> = None;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        if (p.y - y) * (q.y - y) > 0.0 || p.y == q.y {
            continue;
        }
        let x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
        range = Some(range.map_or([x; 2], |[low, high]| [low.min(x), high.max(x)]));
    }
    range
}
