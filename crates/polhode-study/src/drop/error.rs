//! Why nothing can be thrown.

use polhode::SceneError;
use polhode::contact::ShapeError;
use polhode::response::penalty::SpringError;
use polhode_scene::SceneFileError;
use thiserror::Error;

/// Why nothing can be thrown.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum DropError {
    /// The scene is refused.
    #[error(transparent)]
    File(#[from] SceneFileError),
    /// The scene is refused as it is built.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// No throws, or too many.
    #[error("{throws} throws: 1 to {most} are accepted")]
    Throws {
        /// How many were asked for.
        throws: u64,
        /// The most.
        most: u64,
    },
    /// The scene has no such body, or does not say which.
    #[error("{what}; bodies that forces move: {accepted}")]
    Body {
        /// What is wrong.
        what: String,
        /// The bodies that could be thrown.
        accepted: String,
    },
    /// The body has no faces: it rolls.
    #[error(
        "{body} is round ({shape}): it has no facet to come to rest on, it rolls, and all its attitudes are alike; a \
         body of plane faces is needed: a mesh, a box, a convex hull, points, or a compound of them"
    )]
    Round {
        /// The body.
        body: String,
        /// Its shape.
        shape: &'static str,
    },
    /// The body has nothing that could touch.
    #[error("{body} has no shape: nothing of it could touch what it falls on")]
    Shapeless {
        /// The body.
        body: String,
    },
    /// The shape has no hull, or no parts.
    #[error("{body}: {source}")]
    Shape {
        /// The body.
        body: String,
        /// Why.
        source: ShapeError,
    },
    /// The body is held, so that it cannot fall.
    #[error("{body} is held by {by}: a body that falls freely is needed")]
    Held {
        /// The body.
        body: String,
        /// What holds it.
        by: &'static str,
    },
    /// Nothing falls.
    #[error("gravity is zero: nothing falls; give the scene a gravity, as gravity = [0, 0, -9.81]")]
    Weightless,
    /// A number that is not accepted.
    #[error("{what} is {value}: {accepted} is accepted")]
    Number {
        /// What it is, with its unit.
        what: &'static str,
        /// The number.
        value: f64,
        /// What is accepted.
        accepted: &'static str,
    },
    /// The law of a contact over time cannot be made.
    #[error("{0}")]
    Contact(#[from] SpringError),
    /// Impacts have no duration, for want of something.
    #[error("a radius of corners without Young's modulus: give at least one of the two materials youngs_modulus_pa")]
    Rigid,
    /// The caller has ended it.
    #[error("the throws have been stopped after {done} of {all}")]
    Stopped {
        /// Throws that were finished.
        done: u64,
        /// Throws that were asked for.
        all: u64,
    },
}
