//! No input makes the loader panic.

use crate::BASE;
use polhode_scene::{Override, load_text};

const SPLINTERS: [&str; 14] = ["", "[", "]", "{", "\"", "'", "=", ".", "\n", "\u{1F600}", "-", "1e400", "nan", "\r\n"];

/// A scene with a character replaced by each of many splinters, at every place: accepted or refused with a message.
#[test]
fn damaged_scenes() {
    for (at, old) in BASE.char_indices() {
        for splinter in SPLINTERS {
            let text = format!("{}{splinter}{}", &BASE[..at], &BASE[at + old.len_utf8()..]);
            if let Err(error) = load_text("test.toml", &text, &[]) {
                assert!(error.to_string().starts_with("error: "), "{text}\n{error}");
            }
        }
    }
}

/// A scene that ends anywhere.
#[test]
fn cut_scenes() {
    for at in 0..BASE.len() {
        if let Err(error) = load_text("test.toml", &BASE[..at], &[]) {
            assert!(error.to_string().contains("test.toml:"), "{error}");
        }
    }
}

/// A change from outside, damaged in the same way.
#[test]
fn damaged_changes() {
    let change = "bodies.\"brick\".position=[1.0, 2, 3e0]";
    for at in 0..change.len() {
        for splinter in SPLINTERS {
            let text = format!("{}{splinter}{}", &change[..at], &change[at + 1..]);
            if let Some(change) = Override::parse("--set", &text)
                && let Err(error) = load_text("test.toml", BASE, &[change])
            {
                assert!(error.to_string().starts_with("error: "), "{text}\n{error}");
            }
        }
    }
}
