//! Which frames a moving picture has, and how long each is shown.

use crate::annotations::{Annotations, Largest};
use crate::camera::{Camera, Viewpoint};
use crate::error::ViewError;
use crate::framing::Framing;
use crate::overlay::Overlay;
use crate::raster::{Picture, PictureSize};
use crate::recording::Recording;
use crate::scale::Corner;
use crate::still::frame_from;
use polhode::Flow;
use std::fmt;

/// Frames a second of a moving picture when no others are asked for.
pub const FPS: f64 = 25.0;
/// Milliseconds that the last frame is shown before the picture begins anew.
const LAST_MS: u32 = 1000;
/// Milliseconds that a frame is shown at the least: browsers show shorter ones slowly.
const LEAST_MS: u32 = 20;

/// Who is told of every frame that has been drawn, by the number drawn so far, and says whether to go on: thousands of
/// frames take minutes.
#[derive(Clone, Copy)]
pub struct Watcher<'a>(pub &'a dyn Fn(usize) -> Flow);

impl fmt::Debug for Watcher<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Watcher")
    }
}

/// The frames of a moving picture in real time, seen by a camera that stands.
#[derive(Debug)]
pub struct Pace<'a> {
    recording: &'a Recording,
    framing: Framing,
    camera: Camera,
    size: PictureSize,
    overlays: &'a [Overlay],
    watcher: Option<Watcher<'a>>,
}

impl<'a> Pace<'a> {
    /// All frames of a recording, in pictures of this size.
    ///
    /// # Errors
    /// When it has none, or its scene wants a camera that looks nowhere.
    pub fn new(recording: &'a Recording, size: PictureSize) -> Result<Self, ViewError> {
        if recording.times().is_empty() {
            return Err(ViewError::NoFrames);
        }
        let framing = recording.framing();
        let camera = framing.camera(&Viewpoint::default(), size.aspect())?;
        Ok(Self { recording, framing, camera, size, overlays: &[], watcher: None })
    }

    /// Seen from a viewpoint.
    ///
    /// # Errors
    /// When the viewpoint looks nowhere.
    pub fn seen_from(mut self, viewpoint: &Viewpoint) -> Result<Self, ViewError> {
        self.camera = self.framing.camera(viewpoint, self.size.aspect())?;
        Ok(self)
    }

    /// With overlays.
    #[must_use]
    pub fn with_overlays(self, overlays: &'a [Overlay]) -> Self {
        Self { overlays, ..self }
    }

    /// Watched while it is drawn.
    #[must_use]
    pub const fn watched_by(mut self, watcher: Watcher<'a>) -> Self {
        self.watcher = Some(watcher);
        self
    }

    /// Width and height.
    pub fn size(&self) -> PictureSize {
        self.size
    }

    /// Number of frames.
    pub fn count(&self) -> usize {
        self.recording.times().len()
    }

    /// The pictures in order, with how long each is shown, ms. The times add up to those of the recording.
    ///
    /// # Errors
    /// [`ViewError::Stopped`] where the watcher stops it.
    pub fn pictures(&self) -> impl Iterator<Item = Result<(Picture, u32), ViewError>> + '_ {
        let times = self.recording.times();
        let ms = |t: f64| (1000.0 * t).round() as u32;
        let (recording, camera, bounds) = (self.recording, self.camera, self.framing.bounds());
        let (overlays, largest) = (self.overlays, Largest::of(recording, 0..times.len()));
        let corner = Corner::freest(recording, 0..times.len(), &camera, self.size.aspect());
        (0..times.len()).map(move |frame| {
            if self.watcher.is_some_and(|Watcher(told)| told(frame) == Flow::Stop) {
                return Err(ViewError::Stopped { drawn: frame, frames: times.len() });
            }
            let shown = times.get(frame + 1).map_or(LAST_MS, |&next| ms(next).saturating_sub(ms(times[frame])));
            let mut picture = frame_from(recording, frame, camera, bounds, self.size);
            Annotations { recording, frame, camera, bounds, overlays, largest, corner }.draw(&mut picture);
            Ok((picture, shown.max(LEAST_MS)))
        })
    }
}
