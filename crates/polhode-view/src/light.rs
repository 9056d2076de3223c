//! Light: one far lamp with shadow, and light from everywhere.

use polhode::spatial::DVec3;

/// The light of a picture. A surface of albedo `a` sends `a (ambient (1 + sky n.z) + lamp max(0, n.l))`,
/// without the lamp in shadow (Lambert's law).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Unit vector towards the lamp.
    pub towards: DVec3,
    /// Light of the lamp.
    pub lamp: f64,
    /// Light from everywhere.
    pub ambient: f64,
    /// Part of the light from everywhere that comes more from above than from the side.
    pub sky: f64,
}

/// Direction towards the lamp: high, from the left and the front.
const TOWARDS: DVec3 = DVec3::new(-0.35, -0.5, 0.9);

impl Default for Light {
    fn default() -> Self {
        Self { towards: TOWARDS.normalize_or_zero(), lamp: 0.72, ambient: 0.32, sky: 0.3 }
    }
}

impl Light {
    /// Light that a surface of this unit normal gets; `lit` is the part of the lamp that it sees, 0 to 1.
    pub fn on(&self, normal: DVec3, lit: f64) -> f64 {
        self.ambient * (1.0 + self.sky * normal.z) + self.lamp * lit * normal.dot(self.towards).max(0.0)
    }
}
