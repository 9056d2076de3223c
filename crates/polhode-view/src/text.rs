//! Data as text inside a page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Bytes as base64.
pub(crate) fn base64(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

/// Numbers of 8 bytes as base64, little-endian.
pub(crate) fn base64_f64(numbers: &[f64]) -> String {
    base64(&numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<u8>>())
}

/// Numbers of 4 bytes as base64, little-endian.
pub(crate) fn base64_f32(numbers: impl Iterator<Item = f64>) -> String {
    base64(&numbers.flat_map(|number| (number as f32).to_le_bytes()).collect::<Vec<u8>>())
}

/// Whole numbers as base64, little-endian.
pub(crate) fn base64_u32(numbers: impl Iterator<Item = u32>) -> String {
    base64(&numbers.flat_map(u32::to_le_bytes).collect::<Vec<u8>>())
}

/// Text that stands for itself in HTML.
pub(crate) fn html(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// JSON that cannot end the element that it stands in.
pub(crate) fn json_in_html(json: &str) -> String {
    json.replace('<', "\\u003c")
}
