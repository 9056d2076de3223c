//! From the world to the samples of a picture.
//!
//! A point ahead at distance z goes to `x = cx + f X / z`, `y = cy - f Y / z` (samples). `1/z` and whatever is linear
//! on a triangle divided by z are linear in x and y, which is what is interpolated.

use crate::camera::Camera;
use polhode::spatial::DVec3;

/// A corner in samples: x, y, and `1/z` (1/m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projected {
    /// Across, samples.
    pub x: f64,
    /// Down, samples.
    pub y: f64,
    /// `1/z`, 1/m: the larger, the nearer.
    pub nearness: f64,
}

/// A camera with samples.
#[derive(Debug, Clone, Copy)]
pub struct Projection {
    /// The camera.
    pub camera: Camera,
    /// Samples across and down.
    pub samples: [u32; 2],
    focal: f64,
}

impl Projection {
    /// Onto so many samples across and down.
    pub fn new(camera: Camera, samples: [u32; 2]) -> Self {
        Self { camera, samples, focal: camera.focal_length_px(f64::from(samples[1])) }
    }

    /// Of a point as the camera sees it, which must lie ahead.
    pub fn project(&self, seen: DVec3) -> Projected {
        let nearness = 1.0 / seen.z;
        Projected {
            x: 0.5 * f64::from(self.samples[0]) + self.focal * seen.x * nearness,
            y: 0.5 * f64::from(self.samples[1]) - self.focal * seen.y * nearness,
            nearness,
        }
    }

    /// Direction in the world in which the middle of a sample is seen; its component forwards is 1.
    pub fn ray(&self, x: u32, y: u32) -> DVec3 {
        let across = (f64::from(x) + 0.5 - 0.5 * f64::from(self.samples[0])) / self.focal;
        let up = (0.5 * f64::from(self.samples[1]) - f64::from(y) - 0.5) / self.focal;
        let [right, upwards, forwards] = self.camera.axes;
        forwards + right * across + upwards * up
    }

    /// The part of a triangle that is not too near, as up to two triangles: corners as the camera sees them, and the
    /// weights of the triangle's own corners there.
    pub fn cut(&self, corners: [DVec3; 3]) -> impl Iterator<Item = [(DVec3, DVec3); 3]> {
        let near = self.camera.near_m;
        let weights = [DVec3::X, DVec3::Y, DVec3::Z];
        let mut polygon: Vec<(DVec3, DVec3)> = Vec::with_capacity(4);
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (a, b) = (corners[i], corners[j]);
            if a.z >= near {
                polygon.push((a, weights[i]));
            }
            if (a.z >= near) != (b.z >= near) {
                let s = (near - a.z) / (b.z - a.z);
                polygon.push((a + (b - a) * s, weights[i] + (weights[j] - weights[i]) * s));
            }
        }
        (1..polygon.len().saturating_sub(1)).map(move |i| [polygon[0], polygon[i], polygon[i + 1]])
    }

    /// The part of a segment that is not too near, as the camera sees it.
    pub fn cut_segment(&self, ends: [DVec3; 2]) -> Option<[DVec3; 2]> {
        let near = self.camera.near_m;
        let [a, b] = ends;
        let at_near = |a: DVec3, b: DVec3| a + (b - a) * ((near - a.z) / (b.z - a.z));
        match (a.z >= near, b.z >= near) {
            (true, true) => Some(ends),
            (true, false) => Some([a, at_near(a, b)]),
            (false, true) => Some([at_near(a, b), b]),
            (false, false) => None,
        }
    }
}
