//! Labels beside points of a figure, none over another.
//!
//! Each label in turn takes the best of some places around its point: a place over another label or beyond the frame is
//! no place; markers and curves are covered only where nothing else is left. A label for which there is no place is
//! told so.

use super::svg::Spot;

/// A rectangle with sides along the axes, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    /// Its corner on the left and above.
    pub(crate) from: Spot,
    /// Its corner on the right and below.
    pub(crate) to: Spot,
}

impl Area {
    /// Around a place.
    pub(crate) fn around([x, y]: Spot, half: [f64; 2]) -> Self {
        Self { from: [x - half[0], y - half[1]], to: [x + half[0], y + half[1]] }
    }

    /// Larger by this on all sides.
    pub(crate) fn grown(&self, by: f64) -> Self {
        let [from, to] = [self.from, self.to];
        Self { from: [from[0] - by, from[1] - by], to: [to[0] + by, to[1] + by] }
    }

    /// Whether two have an area in common.
    pub(crate) fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.from[axis] < other.to[axis] && other.from[axis] < self.to[axis])
    }

    fn holds(&self, other: &Self) -> bool {
        (0..2).all(|axis| self.from[axis] <= other.from[axis] && other.to[axis] <= self.to[axis])
    }

    fn contains(&self, spot: &Spot) -> bool {
        (0..2).all(|axis| (self.from[axis]..=self.to[axis]).contains(&spot[axis]))
    }
}

/// Directions from a point to the middle of a label, the best first.
const DIRECTIONS: [Spot; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [1.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [-1.0, 1.0], [0.0, -1.0], [0.0, 1.0]];

/// Distances from a point to its label, pixels.
const DISTANCES: [f64; 7] = [9.0, 16.0, 26.0, 40.0, 58.0, 80.0, 110.0];

/// What it costs to cover a marker, and a piece of a curve, in pixels of distance.
const MARKER: f64 = 60.0;
const PIECE: f64 = 4.0;

/// What it costs to take a later direction, pixels of distance.
const DIRECTION: f64 = 0.5;

/// What a figure contains already.
#[derive(Debug, Clone)]
pub(crate) struct LabelSpots {
    frame: Area,
    markers: Vec<Spot>,
    pieces: Vec<Spot>,
    placed: Vec<Area>,
}

impl LabelSpots {
    /// Within a frame, with markers, and curves in pieces of some pixels.
    pub(crate) fn new(frame: Area, markers: Vec<Spot>, pieces: Vec<Spot>) -> Self {
        Self { frame, markers, pieces, placed: Vec::new() }
    }

    /// Keeps a place free of labels.
    pub(crate) fn keep_free(&mut self, place: Area) {
        self.placed.push(place);
    }

    /// Adds pieces of a line.
    pub(crate) fn keep_off(&mut self, pieces: Vec<Spot>) {
        self.pieces.extend(pieces);
    }

    /// Whether a marker is in an area.
    pub(crate) fn has_markers(&self, place: &Area) -> bool {
        self.markers.iter().any(|spot| place.contains(spot))
    }

    /// The place of a label of this width and height for a point; none where there is no room.
    pub(crate) fn place(&mut self, point: Spot, [width, height]: [f64; 2]) -> Option<Area> {
        let half = [0.5 * width, 0.5 * height];
        let mut best: Option<(f64, Area)> = None;
        for distance in DISTANCES {
            for (number, direction) in DIRECTIONS.iter().enumerate() {
                let shift = |axis: usize| direction[axis] * (distance * slant(*direction) + half[axis]);
                let label = Area::around([point[0] + shift(0), point[1] + shift(1)], half);
                if !self.frame.holds(&label) || self.placed.iter().any(|other| other.overlaps(&label)) {
                    continue;
                }
                let cost = distance + DIRECTION * number as f64 + self.covered(&label);
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, label));
                }
            }
        }
        let (_, label) = best?;
        self.placed.push(label);
        Some(label)
    }

    fn covered(&self, label: &Area) -> f64 {
        let count = |spots: &[Spot]| spots.iter().filter(|spot| label.contains(spot)).count() as f64;
        MARKER * count(&self.markers) + PIECE * count(&self.pieces)
    }
}

/// A label aslant of a point needs less distance.
fn slant(direction: Spot) -> f64 {
    if direction.iter().all(|part| *part != 0.0) { 0.6 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    //! Labels are beside their points and never over another.
    use super::*;
    use proptest::prelude::*;

    const FRAME: Area = Area { from: [0.0, 0.0], to: [600.0, 400.0] };

    #[test]
    fn a_label_alone_is_right_of_its_point() {
        let mut spots = LabelSpots::new(FRAME, vec![[100.0, 100.0]], Vec::new());
        let label = spots.place([100.0, 100.0], [80.0, 14.0]);
        assert_eq!(label, Some(Area { from: [109.0, 93.0], to: [189.0, 107.0] }));
        let at_the_edge = spots.place([590.0, 200.0], [80.0, 14.0]).map(|label| label.to[0]);
        assert_eq!(at_the_edge, Some(581.0));
        assert_eq!(spots.place([f64::NAN, 200.0], [80.0, 14.0]), None);
    }

    proptest! {
        #[test]
        fn none_overlap(
            points in prop::collection::vec((0.0..600.0_f64, 0.0..400.0_f64), 0..40),
            widths in prop::collection::vec(20.0..150.0_f64, 40),
        ) {
            let markers: Vec<Spot> = points.iter().map(|&(x, y)| [x, y]).collect();
            let mut spots = LabelSpots::new(FRAME, markers.clone(), markers.clone());
            let placed: Vec<Area> =
                markers.iter().zip(widths).filter_map(|(point, width)| spots.place(*point, [width, 14.0])).collect();
            for (number, label) in placed.iter().enumerate() {
                prop_assert!(FRAME.holds(label));
                prop_assert!(placed[..number].iter().all(|other| !other.overlaps(label)), "{:?}", placed);
            }
        }
    }
}
