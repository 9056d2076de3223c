//! What is nearest at each sample of a band of rows.

use super::paint::Paint;
use super::projection::Projected;
use polhode::spatial::DVec3;

/// How much nearer a line counts than it is: it lies on the surface that it belongs to.
const LINE_NEARER: f64 = 1.002;

/// What is seen at a sample.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    /// `1/z`, 1/m; zero where nothing is.
    pub nearness: f64,
    /// Normal of the surface, of any length; zero of a line, which takes no light.
    pub normal: DVec3,
    /// Number of the paint.
    pub paint: u16,
}

const NOTHING: Seen = Seen { nearness: 0.0, normal: DVec3::ZERO, paint: u16::MAX };

/// A triangle in samples.
#[derive(Debug, Clone, Copy)]
pub struct FlatTriangle {
    /// Corners.
    pub corners: [Projected; 3],
    /// Normals at the corners.
    pub normals: [DVec3; 3],
    /// Number of the paint.
    pub paint: u16,
}

/// A line in samples.
#[derive(Debug, Clone, Copy)]
pub struct FlatSegment {
    /// Ends.
    pub ends: [Projected; 2],
    /// Number of the paint.
    pub paint: u16,
}

/// A disc that faces the camera and takes light as a ball does.
#[derive(Debug, Clone, Copy)]
pub struct FlatDisc {
    /// Middle.
    pub center: Projected,
    /// Radius, samples.
    pub radius: f64,
    /// Unit vectors to the right, up, and forwards.
    pub axes: [DVec3; 3],
    /// Number of the paint.
    pub paint: u16,
}

/// A band of rows.
#[derive(Debug)]
pub struct DepthBuffer {
    width: usize,
    /// First row, and one past the last.
    rows: [usize; 2],
    samples: Vec<Seen>,
}

impl DepthBuffer {
    /// An empty band of rows of this width, samples.
    pub fn new(width: usize, rows: [usize; 2]) -> Self {
        Self { width, rows, samples: vec![NOTHING; width * rows[1].saturating_sub(rows[0])] }
    }

    /// What is seen at a sample of the band.
    pub fn at(&self, x: usize, y: usize) -> &Seen {
        &self.samples[(y - self.rows[0]) * self.width + x]
    }

    /// The samples of a range of coordinates that lie within `limits`: first, and one past the last.
    fn covered(low: f64, high: f64, limits: [usize; 2]) -> std::ops::Range<usize> {
        // The middle of sample i is at i + 1/2; a conversion to whole numbers saturates.
        let first = ((low - 0.5).ceil().max(0.0) as usize).max(limits[0]);
        let end = ((high + 0.5).floor().max(0.0) as usize).min(limits[1]);
        first..end.max(first)
    }

    /// Draws a triangle.
    pub fn draw_triangle(&mut self, triangle: &FlatTriangle, paint: &Paint) {
        let [a, b, c] = triangle.corners;
        let twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if twice_area == 0.0 || !twice_area.is_finite() {
            return;
        }
        let (low, high) = (a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y));
        let inverse = 1.0 / twice_area;
        // Normals divided by z are linear over the picture; their length does not matter.
        let [na, nb, nc] = [0, 1, 2].map(|i| triangle.normals[i] * triangle.corners[i].nearness);
        for y in Self::covered(low, high, self.rows) {
            let py = y as f64 + 0.5;
            let Some([left, right]) = span([a, b, c], py) else { continue };
            for x in Self::covered(left, right, [0, self.width]) {
                let px = x as f64 + 0.5;
                let wb = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) * inverse;
                let wc = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) * inverse;
                let wa = 1.0 - wb - wc;
                let nearness = wa * a.nearness + wb * b.nearness + wc * c.nearness;
                let seen = &mut self.samples[(y - self.rows[0]) * self.width + x];
                if nearness > seen.nearness && paint.covers(x, y) {
                    *seen = Seen { nearness, normal: na * wa + nb * wb + nc * wc, paint: triangle.paint };
                }
            }
        }
    }

    /// Draws a disc.
    pub fn draw_disc(&mut self, disc: &FlatDisc) {
        let FlatDisc { center, radius, axes: [right, up, forwards], paint } = *disc;
        for y in Self::covered(center.y - radius, center.y + radius, self.rows) {
            let down = (y as f64 + 0.5 - center.y) / radius;
            for x in Self::covered(center.x - radius, center.x + radius, [0, self.width]) {
                let across = (x as f64 + 0.5 - center.x) / radius;
                let square = across * across + down * down;
                let seen = &mut self.samples[(y - self.rows[0]) * self.width + x];
                if square <= 1.0 && center.nearness > seen.nearness {
                    let normal = right * across - up * down - forwards * (1.0 - square).sqrt();
                    *seen = Seen { nearness: center.nearness, normal, paint };
                }
            }
        }
    }

    /// Draws a line of this width, samples.
    pub fn draw_segment(&mut self, segment: &FlatSegment, width: f64, paint: &Paint) {
        let [a, b] = segment.ends;
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        let square = dx * dx + dy * dy;
        if !square.is_finite() {
            return;
        }
        let half = 0.5 * width;
        for y in Self::covered(a.y.min(b.y) - half, a.y.max(b.y) + half, self.rows) {
            let py = y as f64 + 0.5;
            // The line's middle on this row, or all of it where it runs along the row.
            let (mut left, mut right) = (a.x.min(b.x), a.x.max(b.x));
            if dy.abs() > f64::EPSILON * dx.abs() {
                let slant = dx / dy;
                let reach = half * (1.0 + slant.abs());
                let middle = a.x + (py - a.y) * slant;
                (left, right) = (left.max(middle - reach), right.min(middle + reach));
            }
            for x in Self::covered(left - half, right + half, [0, self.width]) {
                let px = x as f64 + 0.5;
                let along = if square > 0.0 { ((px - a.x) * dx + (py - a.y) * dy) / square } else { 0.0 };
                let along = along.clamp(0.0, 1.0);
                let (ex, ey) = (px - a.x - along * dx, py - a.y - along * dy);
                if ex * ex + ey * ey > half * half {
                    continue;
                }
                let nearness = (a.nearness + (b.nearness - a.nearness) * along) * LINE_NEARER;
                let seen = &mut self.samples[(y - self.rows[0]) * self.width + x];
                if nearness > seen.nearness && paint.covers(x, y) {
                    *seen = Seen { nearness, normal: DVec3::ZERO, paint: segment.paint };
                }
            }
        }
    }
}

/// Where a row crosses a triangle: left and right end.
fn span(corners: [Projected; 3], y: f64) -> Option<[f64; 2]> {
    let (mut left, mut right) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 0..3 {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        if (a.y <= y) != (b.y <= y) {
            // In one order, so that both triangles at an edge find the same crossing.
            let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
            let x = a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
            left = left.min(x);
            right = right.max(x);
        }
    }
    (left <= right).then_some([left, right])
}
