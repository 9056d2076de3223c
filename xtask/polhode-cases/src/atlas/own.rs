//! Readings that no scene file can say.

use crate::cases::Context;
use crate::row::Value;
use std::error::Error;

/// The reading of this name.
///
/// # Errors
/// When there is none, or it cannot be read.
pub(super) fn values(name: &str, _context: &Context) -> Result<Vec<Value>, Box<dyn Error>> {
    Err(format!("there is no reading {name}").into())
}
