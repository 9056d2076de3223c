//! Errors as JSON, with their places in the text of the scene.

use polhode_scene::{Refused, SceneFileError};
use polhode_study::play::PlayError;
use serde_json::{Value, json};
use wasm_bindgen::JsValue;

/// What a script catches.
pub(crate) fn thrown(error: &PlayError) -> JsValue {
    let places: Vec<Value> = match error {
        PlayError::Scene(error) => places(error),
        _ => Vec::new(),
    };
    JsValue::from_str(&json!({ "message": error.to_string(), "places": places }).to_string())
}

fn places(error: &SceneFileError) -> Vec<Value> {
    let one = |refused: &Refused| {
        json!({
            "line": refused.place.line,
            "column": refused.place.column,
            "key": refused.place.key,
            "words": refused.cause.to_string(),
        })
    };
    error.all_refused().iter().map(one).collect()
}
