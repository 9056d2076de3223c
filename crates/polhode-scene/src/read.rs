//! Reading files of bounded size.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Why a file could not be read.
pub(crate) enum Fault {
    Io(io::Error),
    TooLarge,
}

/// The bytes of a file of at most `limit` bytes.
pub(crate) fn bounded(path: &Path, limit: u64) -> Result<Vec<u8>, Fault> {
    let file = File::open(path).map_err(Fault::Io)?;
    // What a regular file says of its length saves reading it; a device may say 0 and go on for ever.
    let length = file.metadata().map_err(Fault::Io)?.len();
    if length > limit {
        return Err(Fault::TooLarge);
    }
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes).map_err(Fault::Io)?;
    if bytes.len() as u64 > limit { Err(Fault::TooLarge) } else { Ok(bytes) }
}
