//! Stills: one frame as a PNG picture.

use crate::camera::{Camera, Viewpoint};
use crate::error::ViewError;
use crate::light::Light;
use crate::raster::{Marks, Picture, PictureSize, SceneTriangles, draw};
use crate::recording::Recording;
use polhode::spatial::DVec3;
use std::io::Write;

/// Draws a frame of a recording: the bodies that move, in the middle, from the front, a little from the right and
/// above.
pub fn still(recording: &Recording, frame: usize, size: PictureSize) -> Picture {
    let bounds = recording.bounds_at(frame);
    let camera = Camera::for_box(bounds, size.aspect());
    frame_from(recording, frame, camera, bounds, size)
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
    let bounds = recording.bounds_at(frame);
    let camera = viewpoint.camera(bounds, size.aspect())?;
    Ok(frame_from(recording, frame, camera, bounds, size))
}

/// Draws a frame as a camera sees it.
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
