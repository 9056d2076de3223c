//! What the lamp sees: a parallel picture of depths, from which shadow follows.
//!
//! A place is in shadow where the lamp sees something nearer. Source: docs/REFERENCES.md, Williams 1978.

use super::paint::Paint;
use super::projection::Projected;
use super::scene_triangles::{SceneTriangles, Triangle};
use crate::light::Light;
use polhode::spatial::DVec3;

/// Texels each way.
const SIZE: usize = 2048;
/// How far a surface lies before its own shadow, texels: what the map rounds.
const BIAS_TEXELS: f64 = 2.5;
/// Texels each way around a place over which its shadow is averaged.
const SOFTNESS: i64 = 1;

/// Depths seen from the lamp.
#[derive(Debug)]
pub struct ShadowMap {
    axes: [DVec3; 3],
    /// Corner of the map, in its axes, m.
    low: DVec3,
    texel_m: f64,
    /// Height towards the lamp of the highest surface, m, above `low`.
    heights: Vec<f32>,
}

impl ShadowMap {
    /// Of what throws shadows; none where nothing does.
    pub fn new(scene: &SceneTriangles, light: &Light) -> Option<Self> {
        let towards = light.towards;
        let across = towards.any_orthonormal_vector();
        let axes = [across, towards.cross(across), towards];
        let seen = |p: DVec3| DVec3::from_array(axes.map(|axis| axis.dot(p)));
        let is_solid = |triangle: &&Triangle| scene.paints.get(triangle.paint).is_some_and(Paint::is_solid);
        let points = scene.triangles.iter().filter(is_solid).flat_map(|triangle| triangle.corners).map(seen);
        let bounds = points.fold(None, |bounds: Option<[DVec3; 2]>, p| {
            Some(bounds.map_or([p; 2], |[low, high]| [low.min(p), high.max(p)]))
        });
        let [low, high] = bounds?;
        let texel_m = (high - low).truncate().max_element() / (SIZE - 2) as f64;
        if texel_m <= 0.0 || !texel_m.is_finite() {
            return None;
        }
        let low = low - DVec3::new(texel_m, texel_m, 0.0);
        let mut map = Self { axes, low, texel_m, heights: vec![f32::NEG_INFINITY; SIZE * SIZE] };
        for triangle in scene.triangles.iter().filter(is_solid) {
            map.draw(triangle.corners.map(seen));
        }
        Some(map)
    }

    /// A place in the map: across and down, texels; height, m.
    fn placed(&self, seen: DVec3) -> Projected {
        let arm = seen - self.low;
        Projected { x: arm.x / self.texel_m, y: arm.y / self.texel_m, nearness: arm.z }
    }

    fn draw(&mut self, corners: [DVec3; 3]) {
        let [a, b, c] = corners.map(|corner| self.placed(corner));
        let twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if twice_area == 0.0 {
            return;
        }
        let range = |low: f64, high: f64| (low.floor().max(0.0) as usize)..(high.ceil().max(0.0) as usize).min(SIZE);
        for y in range(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y)) {
            for x in range(a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x)) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let wb = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / twice_area;
                let wc = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / twice_area;
                let wa = 1.0 - wb - wc;
                if wa.min(wb).min(wc) >= 0.0 {
                    let height = (wa * a.nearness + wb * b.nearness + wc * c.nearness) as f32;
                    let place = &mut self.heights[y * SIZE + x];
                    *place = place.max(height);
                }
            }
        }
    }

    /// The part of the lamp that a place with this unit normal sees, 0 to 1.
    pub fn lit(&self, place: DVec3, normal: DVec3) -> f64 {
        let [_, _, towards] = self.axes;
        let cosine = normal.dot(towards);
        if cosine <= 0.0 {
            return 0.0;
        }
        // Moved out along the normal, the more the lower the lamp stands over the surface.
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let moved = place + normal * (BIAS_TEXELS * self.texel_m * (0.3 + sine));
        let at = self.placed(DVec3::from_array(self.axes.map(|axis| axis.dot(moved))));
        let (x, y) = (at.x.floor() as i64, at.y.floor() as i64);
        let height = (at.nearness + 0.5 * BIAS_TEXELS * self.texel_m) as f32;
        let mut lit = 0;
        let mut count = 0;
        for v in y - SOFTNESS..=y + SOFTNESS {
            for u in x - SOFTNESS..=x + SOFTNESS {
                let size = SIZE as i64;
                let is_inside = (0..size).contains(&u) && (0..size).contains(&v);
                let hidden = is_inside && self.heights[v as usize * SIZE + u as usize] > height;
                lit += u32::from(!hidden);
                count += 1;
            }
        }
        f64::from(lit) / f64::from(count)
    }
}
