//! JSON Schema of the scene format.

use crate::format::SceneFile;
use serde_json::Value;

/// The JSON Schema (draft 2020-12) of version 1 of the scene format: what is accepted, and nothing that is not yet
/// available.
pub fn schema() -> Value {
    schemars::schema_for!(SceneFile).to_value()
}

#[cfg(test)]
mod tests {
    //! Lists of keys are those of the schema.
    use super::*;
    use crate::format::MATERIAL_KEYS;
    use std::collections::BTreeSet;

    #[test]
    fn keys_of_a_material_are_listed() {
        let schema = schema();
        let properties = schema.pointer("/$defs/MaterialEntry/properties").and_then(Value::as_object);
        let own: BTreeSet<&str> = properties.into_iter().flat_map(|own| own.keys().map(String::as_str)).collect();
        assert_eq!(own, BTreeSet::from(MATERIAL_KEYS));
    }
}
