//! The axes of the world, a bar with its length, and how large a cell of the grid is, on a plate in a corner of a
//! picture.
//!
//! The bar is as long as it says in the middle of what is looked at; what is nearer is larger. The plate stands in the
//! corner where it hides least of the bodies, in all frames of a moving picture the same one.

use crate::camera::Camera;
use crate::colors;
use crate::extent::box_corners;
use crate::framing::frames_looked_at;
use crate::lengths;
use crate::raster::canvas::{Canvas, Ink, Spot};
use crate::raster::ground;
use crate::recording::Recording;
use polhode::spatial::DVec3;
use std::ops::Range;

/// Length of the axes, and of the bar at the most, as fractions of the picture's height and width.
const AXES: f64 = 0.055;
const LONGEST_BAR: f64 = 0.2;
/// Colours of the axes x, y and z, sRGB.
pub(crate) const AXIS_COLORS: [[u8; 3]; 3] = [[0xc8, 0x3c, 0x3c], [0x2f, 0x94, 0x5a], [0x2f, 0x6f, 0xc4]];
/// Room at the rim, in rows of letters.
pub(crate) const RIM: f64 = 7.0;
/// How much of the picture a plate may take, across and down.
const SHARE: Spot = [0.32, 0.24];
/// Points of an edge of a body's box that are looked at, as parts of its length.
const ALONG: [f64; 3] = [0.0, 1.0 / 3.0, 2.0 / 3.0];

/// A corner of a picture. The legend of overlays has the upper left one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Corner {
    LowerLeft,
    LowerRight,
    UpperRight,
}

impl Corner {
    /// The one where a plate hides least of the bodies that move in some frames.
    pub(crate) fn freest(recording: &Recording, frames: Range<usize>, camera: &Camera, width_over_height: f64) -> Self {
        let shown = recording.shown();
        let stride = (frames.len() / frames_looked_at(shown.moving.len())).max(1);
        let corners = [Self::LowerLeft, Self::LowerRight, Self::UpperRight];
        let mut hidden = [0_usize; 3];
        for frame in frames.step_by(stride) {
            for (&body, pose) in shown.moving.iter().zip(recording.moving_poses(frame)) {
                let body = &shown.bodies[body];
                let Some(bounds) = body.bounds.filter(|_| body.look.opacity > 0.0) else { continue };
                for point in points_of_edges(bounds) {
                    let Some([x, y]) = camera.spot(pose.transform_point(point), [width_over_height, 1.0]) else {
                        continue;
                    };
                    let [x, y] = [x / width_over_height, y];
                    let is_low = y > 1.0 - SHARE[1];
                    hidden[0] += usize::from(is_low && x < SHARE[0]);
                    hidden[1] += usize::from(is_low && x > 1.0 - SHARE[0]);
                    hidden[2] += usize::from(y < SHARE[1] && x > 1.0 - SHARE[0]);
                }
            }
        }
        let least = (0..corners.len()).min_by_key(|&corner| hidden[corner]);
        least.map_or(Self::LowerLeft, |corner| corners[corner])
    }

    /// Where the upper left corner of a plate of this size is.
    fn origin(self, plate: Spot, picture: Spot, rim: f64) -> Spot {
        let [right, low] = [picture[0] - plate[0] - rim, picture[1] - plate[1] - rim];
        match self {
            Self::LowerLeft => [rim, low],
            Self::LowerRight => [right, low],
            Self::UpperRight => [right, rim],
        }
    }
}

/// Points along the edges of a box.
fn points_of_edges(bounds: [DVec3; 2]) -> impl Iterator<Item = DVec3> {
    let size = bounds[1] - bounds[0];
    box_corners(bounds).flat_map(move |corner| {
        [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(move |axis| {
            // From each corner half of each edge: both halves have thirds that the other has not.
            let inwards = if corner.dot(axis) > bounds[0].dot(axis) { -axis } else { axis };
            ALONG.map(|part| corner + inwards * (0.5 * part * size.dot(axis)))
        })
    })
}

/// What is drawn on the plate.
#[derive(Debug)]
pub(crate) struct Scale<'a> {
    pub(crate) camera: &'a Camera,
    /// Size of a cell of the grid, m, where there is one.
    pub(crate) cell_m: Option<f64>,
    pub(crate) corner: Corner,
}

impl Scale<'_> {
    /// Draws it.
    pub(crate) fn draw(&self, canvas: &mut Canvas<'_>) {
        let (size, row) = (canvas.size(), canvas.row_px);
        let rim = 0.5 * RIM * row;
        let arm = (AXES * size[1]).max(11.0 * row);
        let pixels_of_metre = self.camera.pixels_of_metre(size[1]);
        let bar_m = ground::round_length(LONGEST_BAR * size[0] / pixels_of_metre);
        let bar_px = bar_m * pixels_of_metre;
        let words = lengths::words(bar_m);
        let cell = self.cell_m.map(|cell_m| format!("grid {}", lengths::words(cell_m)));
        let side = 2.0 * arm + 20.0 * row;
        let width_of_cell = cell.as_deref().map_or(0.0, |cell| canvas.width_of(cell));
        let beside = bar_px.max(canvas.width_of(&words)).max(width_of_cell);
        let plate = [side + beside + 6.0 * row, side];
        let [left, top] = self.corner.origin(plate, size, rim);
        let low = top + plate[1];
        canvas.plate([[left, top], [left + plate[0], low]], 4.0 * row);
        self.axes(canvas, [left + 0.5 * side - 4.0 * row, low - 0.5 * side], arm);
        let (left, ink) = (left + side, Ink::solid(colors::INK));
        let y = low - if cell.is_some() { 17.0 } else { 8.0 } * row;
        canvas.line([[left, y], [left + bar_px, y]], 1.5 * row, ink);
        for end in [left, left + bar_px] {
            canvas.line([[end, y - 3.0 * row], [end, y + 3.0 * row]], 1.5 * row, ink);
        }
        canvas.words([left, y - 6.0 * row], &words, ink);
        if let Some(cell) = cell {
            canvas.words([left, low - 4.5 * row], &cell, ink);
        }
    }

    fn axes(&self, canvas: &mut Canvas<'_>, center: Spot, arm: f64) {
        let [right, up, forwards] = self.camera.axes;
        let mut axes: Vec<_> =
            [DVec3::X, DVec3::Y, DVec3::Z].into_iter().zip(AXIS_COLORS).zip(["x", "y", "z"]).collect();
        // The farthest first.
        axes.sort_by(|((a, _), _), ((b, _), _)| b.dot(forwards).total_cmp(&a.dot(forwards)));
        let row = canvas.row_px;
        for ((axis, color), name) in axes {
            let (x, y) = (axis.dot(right), -axis.dot(up));
            let tip = [center[0] + arm * x, center[1] + arm * y];
            canvas.arrow([center, tip], 1.5 * row, Ink::solid(color));
            let length = libm::hypot(x, y);
            // An axis that points to the camera has its name beside it.
            let (u, v) = if length > 0.2 { (x / length, y / length) } else { (0.7, 0.7) };
            let at = [tip[0] + u * 5.0 * row - 2.0 * row, tip[1] + v * 5.0 * row + 3.0 * row];
            canvas.words(at, name, Ink::solid(color));
        }
    }
}
