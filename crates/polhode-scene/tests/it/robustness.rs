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

/// Forces, a pivot and a method, damaged in the same way.
const LOADED: &str = r#"format = 1
method = { integrator = "rk4", orientation = "matrix" }
[[bodies]]
name = "a"
mass = 1
inertia = [1, 1, 1]
pivot = [0, 0, 1]
velocity = [0, 0, 0]
[[forces]]
type.spring = { body = "a", point = [1, 0, 0], anchor = [0, 0, 2], stiffness = 3, damping = 0.1 }
[[forces]]
type.torque = { body = "a", torque = [0, 0, 1], signal = { table = [[0, 1], [1, 2]] } }
[[forces]]
type.drag = { law = "quadratic", rotational = 1, wind = [1, 0, 0] }
"#;

#[test]
fn damaged_forces() {
    assert!(load_text("test.toml", LOADED, &[]).is_ok());
    for (at, old) in LOADED.char_indices() {
        for splinter in SPLINTERS {
            let text = format!("{}{splinter}{}", &LOADED[..at], &LOADED[at + old.len_utf8()..]);
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
