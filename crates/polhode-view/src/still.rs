//! Stills: one frame as a PNG picture.

use crate::annotations::{Annotations, Largest};
use crate::camera::{Camera, Viewpoint};
use crate::error::ViewError;
use crate::light::Light;
use crate::overlay::Overlay;
use crate::raster::{Marks, Picture, PictureSize, SceneTriangles, draw};
use crate::recording::Recording;
use crate::scale::Corner;
use polhode::spatial::DVec3;
use std::io::Write;

/// Draws a frame of a recording as its scene wants it, or whence it is best seen.
///
/// # Errors
/// When the scene wants a camera that looks nowhere.
pub fn still(recording: &Recording, frame: usize, size: PictureSize) -> Result<Picture, ViewError> {
    still_from(recording, frame, &Viewpoint::default(), size)
}

/// Draws a frame of a recording from a viewpoint.
///
/// # Errors
/// When the viewpoint looks nowhere.
pub fn still_from(
    recording: &Recording,
    frame: usize,
    viewpoint: &Viewpoint,
    size: PictureSize,
) -> Result<Picture, ViewError> {
    still_with(recording, frame, viewpoint, size, &[])
}

/// Draws a frame of a recording from a viewpoint, with overlays.
///
/// # Errors
/// When the viewpoint looks nowhere.
pub fn still_with(
    recording: &Recording,
    frame: usize,
    viewpoint: &Viewpoint,
    size: PictureSize,
    overlays: &[Overlay],
) -> Result<Picture, ViewError> {
    let framing = recording.framing_at(frame);
    let (camera, bounds) = (framing.camera(viewpoint, size.aspect())?, framing.bounds());
    let mut picture = frame_from(recording, frame, camera, bounds, size);
    let largest = Largest::of(recording, frame..frame + 1);
    let corner = Corner::freest(recording, frame..frame + 1, &camera, size.aspect());
    Annotations { recording, frame, camera, bounds, overlays, largest, corner }.draw(&mut picture);
    Ok(picture)
}

/// Draws a frame as a camera sees it, without anything written on it.
pub fn frame_from(
    recording: &Recording,
    frame: usize,
    camera: Camera,
    bounds: [DVec3; 2],
    size: PictureSize,
) -> Picture {
    let marks = Marks::of_frame(recording, frame, &camera, size.height());
    draw(&SceneTriangles::of_frame(recording, frame), &marks, camera, &Light::default(), bounds, size)
}

/// Writes a picture as PNG.
///
/// # Errors
/// Those of writing.
pub fn write_png(picture: &Picture, out: impl Write) -> Result<(), ViewError> {
    let mut encoder = png::Encoder::new(out, picture.size.width(), picture.size.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    let mut writer = encoder.write_header().map_err(png_error)?;
    writer.write_image_data(&picture.rgb).map_err(png_error)?;
    writer.finish().map_err(png_error)
}

/// An error of the encoder: of writing, or its own.
pub(crate) fn png_error(error: png::EncodingError) -> ViewError {
    match error {
        png::EncodingError::IoError(error) => ViewError::Write(error),
        error => ViewError::Encoding(error.to_string()),
    }
}
