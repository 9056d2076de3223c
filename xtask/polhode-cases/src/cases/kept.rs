//! What is made once and used by several cases: the runs of shipped scenes, the rows of cases.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;
use std::sync::{Arc, Mutex, PoisonError};

/// Where one stands once it is made.
type Place<T> = Arc<Mutex<Option<Arc<T>>>>;

/// What is made when it is first asked for, by name.
pub(super) struct Kept<T> {
    /// One place for each, held while it is made: whoever else asks for it waits.
    places: Mutex<BTreeMap<String, Place<T>>>,
}

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self { places: Mutex::default() }
    }
}

impl<T> fmt::Debug for Kept<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Kept").finish_non_exhaustive()
    }
}

impl<T> Kept<T> {
    /// The one of this name, made by `make` where it is not there.
    ///
    /// # Errors
    /// Those of `make`; it is then tried again when it is next asked for.
    pub(super) fn get(
        &self,
        name: &str,
        make: impl FnOnce() -> Result<T, Box<dyn Error>>,
    ) -> Result<Arc<T>, Box<dyn Error>> {
        let place = {
            let mut places = self.places.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(places.entry(name.to_owned()).or_default())
        };
        let mut made = place.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(own) = made.as_ref() {
            return Ok(Arc::clone(own));
        }
        let own = Arc::new(make()?);
        *made = Some(Arc::clone(&own));
        Ok(own)
    }
}
