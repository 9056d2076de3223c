//! The atlas: results that others have published, each beside what the engine gives for it.
//!
//! What stands in it are files, `fixtures/atlas/NAME.toml`, one for each group of entries. An entry has the digits as
//! they are printed in their source, and says how each number is read out of runs. Nothing that is compared stands in
//! code: a number is measured anew each time, and what was found last stands in `fixtures/atlas/recorded.json`.
//!
//! | module | holds |
//! |---|---|
//! | `entry` | [`Entry`], [`Group`]: what the files say |
//! | `published` | [`Published`]: printed digits, and how far from them a number may be |
//! | `reading` | [`Reading`]: how a number is read out of runs |
//! | `runs` | runs of a shipped scene with some of its values changed |
//! | `modes` | exponents of small disturbances |
//! | `throws` | shares of random throws |
//! | `own` | readings that are no quantity of the scene format |
//! | `peers` | [`PeerRun`]: what other engines give |
//! | `record` | [`Record`]: what was found last |
//! | `check` | the rows of an entry |

mod check;
mod entry;
mod modes;
mod own;
mod peers;
mod published;
mod reading;
mod record;
mod runs;
mod throws;

pub use check::{CASE, check, measure_all};
pub use entry::{Entry, Group, groups};
pub use peers::{PeerRun, peer_runs};
pub use published::Published;
pub use reading::{Read, Reading};
pub use record::Record;
