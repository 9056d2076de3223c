//! Static equilibrium of structures of convex blocks, judged from their geometry alone.
//!
//! An oracle: it shares no code with the contact and response crates, which are judged by it (a rule of the house).
//!
//! | module | holds |
//! |---|---|
//! | `block` | a convex block in the world: corners, faces, weight |
//! | `contact_points` | where the faces and edges of blocks bear on each other |
//! | `equilibrium` | the cone programme: forces at those points that balance every block |

mod block;
mod contact_points;
mod equilibrium;

pub use block::Block;
pub use equilibrium::{Friction, Verdict, judge};
