//! Collision detection: which bodies are near each other, and where they touch.
//!
//! | module | holds |
//! |---|---|
//! | `boxes` | swept boxes of moving bodies, and the pairs whose boxes overlap |
//! | `narrow_phase` | contacts and separation of a pair of shapes, computed with the memory of the pair |
//! | `contact_set` | the contacts of a pair with identity, geometry and time derivatives |

pub(crate) mod boxes;
pub(crate) mod contact_set;
pub(crate) mod narrow_phase;
