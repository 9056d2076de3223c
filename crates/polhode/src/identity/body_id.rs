//! The handle of a body.

/// The handle of a body of a scene or simulation: its number in the order in which bodies were added, from 0. It is the
/// same in scenes, simulations, samples, events, reports, frames and queries. The number of a removed body is not given
/// to another one.
///
/// [`SceneBuilder::add_body`](crate::scene::SceneBuilder::add_body) and
/// [`Simulation::add_body`](crate::Simulation::add_body) return it, [`Scene::body_id`](crate::scene::Scene::body_id)
/// and [`Simulation::body_id`](crate::Simulation::body_id) find it by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

impl BodyId {
    /// The body of this number. Whether there is one is checked where the handle is used.
    pub const fn new(number: usize) -> Self {
        Self(number)
    }

    /// Number of the body, which is its place in lists of all bodies.
    pub const fn index(self) -> usize {
        self.0
    }
}

impl std::fmt::Display for BodyId {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.fmt(f)
    }
}
