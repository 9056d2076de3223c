//! Which tier a response asks for where the scene names none, and which responses go with a tier.
//!
//! A response that a tier of its own has selects that tier. The tier `thesis` has responses of the same names with the
//! thesis's meaning, so that a scene that names it keeps that.

use super::list::Tier;
use crate::scene::Response;

/// The tier that a method names, or that its response selects; none where both leave it open.
pub(crate) fn named(tier: Option<Tier>, response: Option<Response>) -> Option<Tier> {
    tier.or(match response {
        Some(Response::Impulse) => Some(Tier::MicroCollisions),
        _ => None,
    })
}

/// The response of a tier that has one of its own.
pub(crate) const fn own_response(tier: Tier) -> Option<Response> {
    match tier {
        Tier::MicroCollisions => Some(Response::Impulse),
        _ => None,
    }
}
