//! JSON Schema of the scene format.

use crate::format::SceneFile;
use serde_json::Value;

/// The JSON Schema (draft 2020-12) of version 1 of the scene format: what is accepted, and nothing that is not yet
/// available.
pub fn schema() -> Value {
    schemars::schema_for!(SceneFile).to_value()
}
