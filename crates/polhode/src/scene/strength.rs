//! The strength of a joint: the load at which it breaks.
//!
//! A joint breaks when the force that it bears reaches its greatest force, or the moment at its anchor its greatest
//! moment: what [`Simulation::joint_loads`](crate::Simulation::joint_loads) tells. From then on it is gone; its bodies
//! still do not collide with each other. Breaking takes no energy. Tier `accurate` locates the time; a time step breaks
//! it at its end.
//!
//! In an impact the load is infinite for no time, and what a real joint does then depends on how long the impact lasts.
//! Impulses therefore break a joint only if it has a greatest impulse: the impact is resolved with the joint whole, and
//! if the force impulse at the anchor has reached that bound, it is gone afterwards. Time steps do not ask for impulses
//! of impacts.

use super::freedom::FreedomError;

/// The load at which a joint breaks.
///
/// ```
/// use polhode::mesh::solid_box;
/// use polhode::prelude::*;
/// use polhode::scene::{JointKind, Strength};
/// // A beam of 2 kg and 1 m is glued to a wall, which bears a moment of 9 N m: its weight alone has 9.81 N m there.
/// let beam = solid_box(DVec3::new(1.0, 0.1, 0.1), Mass::new(2.0)?)?;
/// let mut scene = Scene::builder("beam");
/// let beam = scene.add_body(Body::movable("beam", beam));
/// let glue = Joint::new(JointKind::Fixed, beam, DVec3::X * -0.5).breaking_at(Strength::default().moment(9.0)?);
/// let mut simulation = Simulation::new(&scene.joint(glue).build()?)?;
/// simulation.advance_to(1.0)?;
/// assert!((simulation.body(beam).pose.translation.z + 0.5 * 9.81).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strength {
    force: f64,
    moment: f64,
    impulse: f64,
}

impl Default for Strength {
    /// Of a joint that nothing breaks.
    fn default() -> Self {
        Self { force: f64::INFINITY, moment: f64::INFINITY, impulse: f64::INFINITY }
    }
}

impl Strength {
    /// The same with this greatest force, N.
    ///
    /// # Errors
    /// When it is not above zero.
    pub fn force(self, force: f64) -> Result<Self, FreedomError> {
        Ok(Self { force: above_zero("greatest force", force)?, ..self })
    }

    /// The same with this greatest moment at the anchor, N m.
    ///
    /// # Errors
    /// When it is not above zero.
    pub fn moment(self, moment: f64) -> Result<Self, FreedomError> {
        Ok(Self { moment: above_zero("greatest moment", moment)?, ..self })
    }

    /// The same with this greatest impulse of an impact, N s.
    ///
    /// # Errors
    /// When it is not above zero.
    pub fn impulse(self, impulse: f64) -> Result<Self, FreedomError> {
        Ok(Self { impulse: above_zero("greatest impulse", impulse)?, ..self })
    }

    /// The greatest force, N; infinite without one.
    pub const fn greatest_force(&self) -> f64 {
        self.force
    }

    /// The greatest moment, N m; infinite without one.
    pub const fn greatest_moment(&self) -> f64 {
        self.moment
    }

    /// The greatest impulse, N s; infinite without one.
    pub const fn greatest_impulse(&self) -> f64 {
        self.impulse
    }

    /// What part of it a force (N) and a moment (N m) are: 1 breaks.
    pub(crate) fn used(&self, force: f64, moment: f64) -> f64 {
        (force / self.force).max(moment / self.moment)
    }
}

fn above_zero(quantity: &'static str, value: f64) -> Result<f64, FreedomError> {
    if value > 0.0 { Ok(value) } else { Err(FreedomError::new(quantity, value, "a number above 0")) }
}
