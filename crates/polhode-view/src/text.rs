//! Data as text inside a page.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Bytes as base64.
pub(crate) fn base64(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

/// Bytes as letters of 7 bits each, the first bit first; zeros fill the last one. The letters that HTML replaces (NUL
/// and the carriage return) and the one that begins its tags have 128 added, which takes two bytes in UTF-8. The text
/// is an eighth shorter than base64 has it, and holds for elements whose content is raw text.
pub(crate) fn seven_bits(bytes: &[u8]) -> String {
    const BITS: u32 = 7;
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 4);
    let (mut held, mut count) = (0_u32, 0);
    let mut push = |letter: u32| {
        let is_special = [u32::from('\0'), u32::from('\r'), u32::from('<')].contains(&letter);
        text.extend(char::from_u32(if is_special { letter + 128 } else { letter }));
    };
    for &byte in bytes {
        (held, count) = (held << 8 | u32::from(byte), count + 8);
        while count >= BITS {
            count -= BITS;
            push(held >> count & 127);
            held &= (1 << count) - 1;
        }
    }
    if count > 0 {
        push(held << (BITS - count));
    }
    text
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
