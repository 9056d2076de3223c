//! From where pictures are taken, as the command line says.

use crate::args::ViewArgs;
use crate::failure::Failure;
use crate::pictures::Kind;
use polhode::spatial::DVec3;
use polhode_view::camera::{PRESETS, Standpoint, Viewpoint};
use std::path::PathBuf;

/// The viewpoint of the pictures; pages and models have cameras of their own.
pub(crate) fn viewpoint(args: &ViewArgs, paths: &[PathBuf]) -> Result<Viewpoint, Failure> {
    let asked = args.camera.as_ref().map(|_| "--camera").or(args.look_at.as_ref().map(|_| "--look-at"));
    let has_picture = paths.iter().any(|path| Kind::of(path).is_some_and(Kind::is_picture));
    if let Some(option) = asked.filter(|_| !has_picture) {
        let what = format!(
            "error: {option} is for pictures (.png, .gif, .apng, .webp): a page or a model has a camera of its own"
        );
        return Err(Failure::Usage(what));
    }
    let standpoint = args.camera.as_deref().map_or(Ok(Viewpoint::default().standpoint), standpoint)?;
    let target = args.look_at.as_deref().map(|text| place("--look-at", text, "")).transpose()?;
    Ok(Viewpoint { standpoint, target })
}

/// Where the camera stands: a view by name, or a place.
fn standpoint(text: &str) -> Result<Standpoint, Failure> {
    if let Some((_, from)) = PRESETS.iter().find(|(name, _)| *name == text) {
        return Ok(Standpoint::Direction(*from));
    }
    let names = PRESETS.map(|(name, _)| name).join(", ");
    place("--camera", text, &format!(", nor one of {names}")).map(Standpoint::Eye)
}

/// A place, m.
fn place(option: &str, text: &str, or_else: &str) -> Result<DVec3, Failure> {
    let coordinates: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    let coordinates = coordinates.and_then(|list| <[f64; 3]>::try_from(list).ok()).map(DVec3::from_array);
    coordinates.filter(|place| place.is_finite()).ok_or_else(|| {
        let what = format!(
            "error: {option} {text}: not of the form X,Y,Z with finite numbers, such as {option} 3,-4,2{or_else}"
        );
        Failure::Usage(what)
    })
}
