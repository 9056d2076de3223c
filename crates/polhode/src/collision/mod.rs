//! Collision: which bodies are near each other, and where they touch.
//!
//! | module | holds |
//! |---|---|
//! | `boxes` | boxes around moving bodies, and the pairs whose boxes meet |
//! | `contact_set` | the contacts of a pair: identity, geometry, derivatives |

pub(crate) mod boxes;
pub(crate) mod contact_set;
