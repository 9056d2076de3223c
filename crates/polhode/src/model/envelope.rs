//! The collision envelope of micro-collisions, and their restitution (Mirtich).
//!
//! A contact collides where its gap `d` (m) is at most the envelope `eps` and it approaches. Up to the speed of a fall
//! through the envelope, `v = sqrt(2 g eps)`, the collision is a micro-collision: no impact of the world but one of the
//! many that stand for a contact force. Its restitution is
//!
//! `e(d) = e_0 + (1 - e_0) (1 - d/eps)`, from that of the materials, `e_0`, at the border to 1 where the bodies touch:
//!
//! a body that is supported sinks through the envelope ever more slowly, by `g h (1 - e)/4` (m/s) for collisions every
//! `h` (s), and at `d = 0` neither sinks nor rises. 1 at the most, no collision gives energy.
//!
//! Fails where bodies overlap: `e = 1` then, and nothing drives them apart.
//!
//! Contacts that stick reverse their slip as well (`polhode_response::solve::impact::Blow`).
//!
//! Source: the envelope and its speed, Mirtich 1996, section 3.5, and Mirtich and Canny 1995; the restitution that
//! grows towards touch is derived here (Mirtich's own micro-collision reverses the velocity, `e = 1`, where friction
//! allows it).

/// The envelope of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CollisionEnvelope {
    /// `eps`, m.
    pub(crate) depth_m: f64,
    /// The speed of a fall through it, m/s.
    pub(crate) slow: f64,
}

impl CollisionEnvelope {
    /// An envelope of this depth (m) under gravity (m/s^2).
    pub(crate) fn new(depth_m: f64, gravity: f64) -> Self {
        Self { depth_m, slow: (2.0 * gravity * depth_m).sqrt() }
    }

    /// Restitution of a collision, from that of the materials, at a gap (m) and a speed of approach (m/s).
    pub(crate) fn restitution(&self, of_materials: f64, gap_m: f64, speed: f64) -> f64 {
        if speed > self.slow {
            return of_materials;
        }
        let nearness = 1.0 - (gap_m / self.depth_m).clamp(0.0, 1.0);
        of_materials + (1.0 - of_materials) * nearness
    }
}

#[cfg(test)]
mod tests {
    //! Restitution is that of the materials for real impacts and at the border, and 1 at touch.
    use super::CollisionEnvelope;

    #[test]
    fn restitution_grows_towards_touch() {
        let envelope = CollisionEnvelope::new(1e-3, 9.81);
        assert!((envelope.slow - (2.0_f64 * 9.81e-3).sqrt()).abs() < 1e-15);
        assert_eq!(envelope.restitution(0.3, 0.0, 1.0), 0.3);
        let slow = |gap: f64| envelope.restitution(0.3, gap, 0.01);
        assert_eq!([slow(1e-3), slow(2e-3), slow(0.0), slow(-1e-3)], [0.3, 0.3, 1.0, 1.0]);
        assert!((slow(5e-4) - 0.65).abs() < 1e-15);
    }
}
