//! `<general>`: what the ways to write an actuator mean, in its attributes.
//!
//! `<motor>`, `<position>`, `<velocity>` and `<damper>` are ways to write `<general>`, and share its defaults: the
//! class of a `<position>` gives attributes to a `<general>` too, and later words replace earlier ones. The numbers
//! that a `<position>` made in a class hold for no `<velocity>`. Source: docs/REFERENCES.md, MJCF.

use super::super::element::Element;

/// What all of them are, in classes.
pub(super) const GENERAL: &str = "general";

/// Elements that are read.
pub(super) const READ: [&str; 5] = [GENERAL, "motor", "position", "velocity", "damper"];

/// Elements that are known, and not simulated.
pub(super) const NOT_READ: [&str; 6] = ["intvelocity", "cylinder", "muscle", "adhesion", "plugin", "dcmotor"];

/// Attributes that one of the ways to write an actuator has, and `<general>` has not.
const OWN: [&str; 5] = ["class", "kp", "kv", "dampratio", "timeconst"];

/// Under which key a class keeps the way in which its numbers were written; no attribute has a space.
const WAY: &str = "written as";

/// Attributes that the ways to write an actuator make.
const MADE: [&str; 7] = ["gaintype", "biastype", "gainprm", "biasprm", "dyntype", "dynprm", "dampratio"];

/// Whether a class holds attributes of actuators in an element of this name.
pub(super) fn is_actuator(name: &str) -> bool {
    READ.contains(&name) || NOT_READ.contains(&name)
}

/// The attributes of `<general>` that an element means, with those that it has from above.
pub(super) fn general(element: &Element, above: Vec<(String, String)>) -> Vec<(String, String)> {
    let mut all = above;
    // What another way to write an actuator made of the numbers in a class is not taken over.
    let way = element.name.as_str();
    if all.iter().any(|(key, own)| key == WAY && own != way && way != GENERAL) {
        all.retain(|(key, _)| !MADE.contains(&key.as_str()));
    }
    all.retain(|(key, _)| key != WAY);
    if way != GENERAL {
        set(&mut all, WAY, way.to_owned());
    }
    for (key, value) in element.attributes().filter(|(key, _)| !OWN.contains(key)) {
        set(&mut all, key, value.to_owned());
    }
    let first = |all: &[(String, String)]| word(all, "gainprm", 0).unwrap_or_else(|| "1".to_owned());
    let constant = |key: &str| element.attribute(key).map(|text| text.trim().to_owned());
    match way {
        "motor" => words(&mut all, ["fixed", "none", "1", "0 0 0"]),
        "position" => {
            let kp = constant("kp").unwrap_or_else(|| first(&all));
            let of_rate = word(&all, "biasprm", 2).unwrap_or_else(|| "0".to_owned());
            let of_rate = constant("kv").map_or(of_rate, |kv| opposite(&kv));
            let offset = word(&all, "biasprm", 0).unwrap_or_else(|| "0".to_owned());
            words(&mut all, ["fixed", "affine", &kp, &format!("{offset} {} {of_rate}", opposite(&kp))]);
            if let Some(ratio) = constant("dampratio") {
                set(&mut all, "dampratio", ratio);
            } else if element.attribute("kv").is_some() {
                all.retain(|(key, _)| key != "dampratio");
            }
            if let Some(time) = constant("timeconst") {
                set(&mut all, "dyntype", "filterexact".to_owned());
                set(&mut all, "dynprm", time);
            }
        }
        "velocity" => {
            let kv = constant("kv").unwrap_or_else(|| first(&all));
            words(&mut all, ["fixed", "affine", &kv, &format!("0 0 {}", opposite(&kv))]);
        }
        "damper" => {
            let kv = constant("kv").unwrap_or_else(|| "0".to_owned());
            words(&mut all, ["affine", "none", &format!("0 0 {}", opposite(&kv)), "0 0 0"]);
        }
        _ => {}
    }
    all
}

/// Sets kinds and numbers of gain and bias, of what has no dynamics.
fn words(all: &mut Vec<(String, String)>, [gain_kind, bias_kind, gain, bias]: [&str; 4]) {
    let of_each =
        [("gaintype", gain_kind), ("biastype", bias_kind), ("gainprm", gain), ("biasprm", bias), ("dyntype", "none")];
    for (key, value) in of_each {
        set(all, key, value.to_owned());
    }
}

fn set(all: &mut Vec<(String, String)>, key: &str, value: String) {
    all.retain(|(own, _)| own != key);
    all.push((key.to_owned(), value));
}

/// A word of an attribute.
fn word(all: &[(String, String)], key: &str, number: usize) -> Option<String> {
    let (_, value) = all.iter().find(|(own, _)| own == key)?;
    value.split_whitespace().nth(number).map(str::to_owned)
}

/// A number with the opposite sign, as a word; what is no number stays, to be refused where it is read.
fn opposite(word: &str) -> String {
    let number = word.parse::<f64>().ok();
    number.map_or_else(|| word.to_owned(), |number| format!("{:?}", 0.0 - number))
}
