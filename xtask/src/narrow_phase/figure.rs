//! Panels with logarithmic axes side by side, as SVG.

use std::fmt::Write as _;

/// One curve.
#[derive(Debug)]
pub(super) struct Series {
    pub(super) name: &'static str,
    pub(super) places: Vec<(f64, f64)>,
}

/// One pair of axes.
#[derive(Debug)]
pub(super) struct Panel {
    pub(super) title: &'static str,
    /// What the axis across shows.
    pub(super) across: &'static str,
    pub(super) series: Vec<Series>,
}

/// Size of a panel, and the room around its axes, pixels.
const WIDTH: f64 = 330.0;
const HEIGHT: f64 = 330.0;
const LEFT: f64 = 58.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 48.0;

/// Colours that most people tell apart (Okabe and Ito's).
const COLOURS: [&str; 2] = ["#0072b2", "#d55e00"];

/// Decades that are labelled at the most.
const MOST_LABELS: i32 = 8;

/// A logarithmic axis between whole powers of ten, and where it lies in pixels.
struct Axis {
    low: i32,
    high: i32,
    from: f64,
    to: f64,
}

impl Axis {
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        let low = low.log10().floor() as i32;
        Self { low, high: (high.log10().ceil() as i32).max(low + 1), from, to }
    }

    fn place(&self, value: f64) -> f64 {
        self.at(value.log10())
    }

    fn at(&self, decade: f64) -> f64 {
        self.from + (self.to - self.from) * (decade - f64::from(self.low)) / f64::from(self.high - self.low)
    }

    fn labels(&self) -> impl Iterator<Item = i32> + use<> {
        let step = (self.high - self.low + MOST_LABELS - 1) / MOST_LABELS;
        (self.low..=self.high).step_by(usize::try_from(step).unwrap_or(1).max(1))
    }
}

/// The panels from left to right.
pub(super) fn svg(panels: &[Panel]) -> String {
    let width = WIDTH * panels.len() as f64;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{HEIGHT}\" viewBox=\"0 0 {width} {HEIGHT}\" \
         font-family=\"sans-serif\" font-size=\"11\">\n<rect width=\"{width}\" height=\"{HEIGHT}\" fill=\"white\"/>\n"
    );
    for (k, panel) in panels.iter().enumerate() {
        draw(&mut text, panel, WIDTH * k as f64);
    }
    text.push_str("</svg>\n");
    text
}

fn draw(text: &mut String, panel: &Panel, left: f64) {
    let places = || panel.series.iter().flat_map(|series| series.places.iter());
    let (from, to, foot) = (left + LEFT, left + WIDTH - RIGHT, HEIGHT - BOTTOM);
    let x = Axis::new(places().map(|place| place.0), from, to);
    let y = Axis::new(places().map(|place| place.1), foot, TOP);
    let middle = 0.5 * (from + to);
    let _ = writeln!(
        text,
        "<text x=\"{middle:.1}\" y=\"20\" text-anchor=\"middle\" font-size=\"13\">{}</text>\n\
         <text x=\"{middle:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
        panel.title,
        HEIGHT - 10.0,
        panel.across
    );
    for decade in x.labels() {
        let at = x.at(f64::from(decade));
        let _ = writeln!(
            text,
            "<path d=\"M{at:.1} {TOP}V{foot}\" stroke=\"#ddd\"/>\
             <text x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">1e{decade}</text>",
            foot + 16.0
        );
    }
    for decade in y.labels() {
        let at = y.at(f64::from(decade));
        let _ = writeln!(
            text,
            "<path d=\"M{from} {at:.1}H{to}\" stroke=\"#ddd\"/>\
             <text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade}</text>",
            from - 5.0,
            at + 4.0
        );
    }
    for (k, series) in panel.series.iter().enumerate() {
        let colour = COLOURS[k % COLOURS.len()];
        let mut path = String::new();
        for (i, place) in series.places.iter().enumerate() {
            let (px, py) = (x.place(place.0), y.place(place.1));
            let _ = write!(path, "{}{px:.1} {py:.1}", if i == 0 { 'M' } else { 'L' });
            let _ = writeln!(text, "<circle cx=\"{px:.1}\" cy=\"{py:.1}\" r=\"3.5\" fill=\"{colour}\"/>");
        }
        let key = TOP + 14.0 + 16.0 * k as f64;
        let _ = writeln!(
            text,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>\n\
             <text x=\"{:.1}\" y=\"{key:.1}\" fill=\"{colour}\">{}</text>",
            from + 8.0,
            series.name
        );
    }
}

#[cfg(test)]
mod tests {
    //! What is drawn stands where the numbers say.
    use super::*;

    #[test]
    fn decades_are_equally_far_apart() {
        let axis = Axis::new([1e-3, 1e-1].into_iter(), 0.0, 100.0);
        assert!((axis.place(1e-2) - 50.0).abs() < 1e-9);
        assert_eq!(axis.labels().collect::<Vec<_>>(), [-3, -2, -1]);
    }

    #[test]
    fn every_series_is_named() {
        let series = vec![Series { name: "one", places: vec![(1.0, 2.0), (10.0, 3.0)] }];
        let text = svg(&[Panel { title: "title", across: "across", series }]);
        assert!(["<svg", "title", "across", "one", "</svg>"].iter().all(|part| text.contains(part)), "{text}");
    }
}
