//! From where pictures are taken, as the command line says.

use crate::args::ViewArgs;
use crate::failure::Failure;
use crate::pictures::Kind;
use polhode::spatial::DVec3;
use polhode_view::camera::{PRESETS, Standpoint, Viewpoint};
use polhode_view::overlay::Overlay;
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
    let standpoint = args.camera.as_deref().map(standpoint).transpose()?;
    let target = args.look_at.as_deref().map(|text| place("--look-at", text, "")).transpose()?;
    Ok(Viewpoint { standpoint, target })
}

/// Where the camera stands: a view by name, or a place.
fn standpoint(text: &str) -> Result<Standpoint, Failure> {
    if let Some(view) = Standpoint::named(text) {
        return Ok(view);
    }
    let names = PRESETS.map(|(name, _)| name).join(", ");
    place("--camera", text, &format!(", nor one of {names}")).map(Standpoint::Eye)
}

/// The overlays of the pictures.
pub(crate) fn overlays(args: &ViewArgs, paths: &[PathBuf]) -> Result<Vec<Overlay>, Failure> {
    let has_picture = paths.iter().any(|path| Kind::of(path).is_some_and(Kind::is_picture));
    if !args.show.is_empty() && !has_picture {
        let what = "error: --show is for pictures (.png, .gif, .apng, .webp): a page has buttons for its overlays";
        return Err(Failure::Usage(what.to_owned()));
    }
    let overlay = |name: &String| {
        Overlay::named(name.trim()).ok_or_else(|| {
            let names = Overlay::ALL.map(|(name, _)| name).join(", ");
            Failure::Usage(format!("error: --show {name}: no overlay is named so; accepted: {names}"))
        })
    };
    args.show.iter().map(overlay).collect()
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
