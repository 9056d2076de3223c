//! How a scene is shown: its camera, and bodies with a look of their own.

use super::array;
use super::fault::{Fault, Faults, direction, vector};
use crate::document::KeyPath;
use crate::error::Refusal;
use crate::format::{CameraEntry, ColorEntry, SceneFile, ViewEntry};
use polhode::scene::{Appearance, BodyLook, Standpoint};
use polhode::{Body, BodyId};

/// How the scene of these bodies is shown.
pub(super) fn build(file: &SceneFile, bodies: &[Body], faults: &mut Faults) -> Appearance {
    let path = KeyPath::of(&["view"]);
    let mut appearance = faults.note(camera(&file.view, &path)).unwrap_or_default();
    for (number, entry) in file.bodies.iter().enumerate() {
        let path = KeyPath::element("bodies", number);
        let words = Look { color: entry.colour, label: entry.label.as_deref(), hidden: entry.hidden };
        if let Some(Some(look)) = faults.note(look(words, entry.opacity, &path)) {
            appearance.bodies.insert(BodyId::new(number), look);
        }
    }
    let of_arrays: Vec<Option<BodyLook>> = file
        .arrays
        .iter()
        .enumerate()
        .map(|(index, entry)| {
            let words = Look { color: entry.colour, label: None, hidden: entry.hidden };
            faults.note(look(words, entry.opacity, &KeyPath::element("arrays", index))).flatten()
        })
        .collect();
    if of_arrays.iter().any(Option::is_some) {
        for (number, body) in bodies.iter().enumerate().skip(file.bodies.len()) {
            let look = array::of_body(body.name(), file).and_then(|index| of_arrays.get(index)?.clone());
            appearance.bodies.extend(look.map(|look| (BodyId::new(number), look)));
        }
    }
    appearance
}

/// From where it is shown.
fn camera(entry: &ViewEntry, path: &KeyPath) -> Result<Appearance, Fault> {
    let standpoint = match (&entry.camera, &entry.from) {
        (Some(_), Some(_)) => return Err((path.key("from"), Refusal::Excludes { key: "from", other: "camera" })),
        (Some(CameraEntry::Named(view)), None) => Some(view.0),
        (Some(CameraEntry::Place(place)), None) => Some(Standpoint::Eye(vector(place, &path.key("camera"))?)),
        (None, Some(from)) => Some(Standpoint::Direction(direction(from, &path.key("from"))?.get())),
        (None, None) => None,
    };
    let look_at = entry.look_at.as_ref().map(|place| vector(place, &path.key("look_at"))).transpose()?;
    if let (Some(Standpoint::Eye(eye)), Some(look_at)) = (standpoint, look_at)
        && eye == look_at
    {
        let accepted = "a place other than that of the camera".to_owned();
        return Err((path.key("look_at"), Refusal::Type { found: "the place of the camera".to_owned(), accepted }));
    }
    let frame = match &entry.frame {
        None => None,
        Some(corners) => {
            let path = path.key("frame");
            let [a, b] = [vector(&corners.0[0], &path.index(0))?, vector(&corners.0[1], &path.index(1))?];
            if a == b {
                let accepted = "two corners that differ".to_owned();
                return Err((path, Refusal::Type { found: "a box without a size".to_owned(), accepted }));
            }
            Some([a.min(b), a.max(b)])
        }
    };
    Ok(Appearance { standpoint, look_at, frame, ..Appearance::default() })
}

/// What an entry says of a look, but for how much is seen.
#[derive(Clone, Copy)]
struct Look<'a> {
    color: Option<ColorEntry>,
    label: Option<&'a str>,
    hidden: bool,
}

/// The look of a body; none where nothing is said of it.
fn look(words: Look<'_>, opacity: Option<f64>, path: &KeyPath) -> Result<Option<BodyLook>, Fault> {
    if let Some(value) = opacity.filter(|value| !(0.0..=1.0).contains(value)) {
        return Err((path.key("opacity"), Refusal::Number { value, accepted: "a number from 0 to 1" }));
    }
    let opacity = if words.hidden { 0.0 } else { opacity.unwrap_or(1.0) };
    let look = BodyLook { color: words.color.map(|color| color.0), label: words.label.map(str::to_owned), opacity };
    Ok((look != BodyLook::default()).then_some(look))
}
