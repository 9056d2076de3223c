//! Collision: which bodies are near each other, and where they touch.
//!
//! | module | holds |
//! |---|---|
//! | `boxes` | boxes around moving bodies, and the pairs whose boxes meet |
//! | `narrow_phase` | contacts and separation of a pair of shapes, with what is remembered of the pair: the only door to them |
//! | `contact_set` | the contacts of a pair: identity, geometry, derivatives |

pub(crate) mod boxes;
pub(crate) mod contact_set;
pub(crate) mod narrow_phase;
