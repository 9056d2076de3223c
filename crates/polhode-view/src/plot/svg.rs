//! A writer of SVG for figures: lines, shapes and text, nothing else.
//!
//! The crate plotters was used before. It rounds every place to whole pixels, which shows in smooth curves, and has
//! neither classes for dark pages nor exponents, so that figures for a paper need a writer of their own; what is needed
//! of SVG is little. The same calls give the same bytes on every machine: places are written in hundredths of a pixel.
//! What has a place that is not finite is not drawn.

use super::ink::{Ink, dark_rules};
use std::fmt::Write as _;

/// A place in a figure, pixels from the left and from the top.
pub type Spot = [f64; 2];

/// Farthest that anything is from the corner, pixels: a place beyond it is a mistake and is not drawn.
const FARTHEST: f64 = 1e5;

/// Fonts, the first of those that are there; all of about the same width.
const FONTS: &str = "Helvetica, Arial, 'Liberation Sans', sans-serif";

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stroke {
    /// Its ink.
    pub ink: Ink,
    /// Its width, pixels.
    pub width: f64,
    /// How much of it is seen, 0 to 1.
    pub opacity: f64,
    /// Lengths of its dashes and gaps, pixels; a whole line where there are none.
    pub dashes: Option<[f64; 2]>,
}

impl Stroke {
    /// A whole line.
    pub const fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, opacity: 1.0, dashes: None }
    }

    /// In dashes of these lengths, pixels.
    pub const fn dashed(self, dash: f64, gap: f64) -> Self {
        Self { dashes: Some([dash, gap]), ..self }
    }

    /// Seen less.
    pub const fn opacity(self, opacity: f64) -> Self {
        Self { opacity, ..self }
    }

    fn attributes(&self) -> String {
        let (colour, number) = (self.ink.light(), self.ink.number());
        let mut text = format!(" class=\"ps{number}\" stroke=\"{colour}\" stroke-width=\"{}\"", digits(self.width));
        if self.opacity < 1.0 {
            let _ = write!(text, " stroke-opacity=\"{}\"", digits(self.opacity));
        }
        if let Some([dash, gap]) = self.dashes {
            let _ = write!(text, " stroke-dasharray=\"{} {}\"", digits(dash), digits(gap));
        }
        text
    }
}

/// Which part of a text is at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
    /// Its right end.
    End,
}

/// How a text is written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Type {
    /// Size of the font, pixels.
    pub size: f64,
    /// Its ink.
    pub ink: Ink,
    /// Which part of it is at its place.
    pub anchor: Anchor,
    /// How heavy it is.
    pub weight: Weight,
}

/// How heavy a text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// As most text is.
    Regular,
    /// Bold.
    Bold,
}

impl Type {
    /// Regular text that begins at its place.
    pub const fn new(size: f64, ink: Ink) -> Self {
        Self { size, ink, anchor: Anchor::Start, weight: Weight::Regular }
    }

    /// With another part at its place.
    pub const fn anchor(self, anchor: Anchor) -> Self {
        Self { anchor, ..self }
    }

    /// In bold.
    pub const fn bold(self) -> Self {
        Self { weight: Weight::Bold, ..self }
    }
}

/// A drawing that grows.
#[derive(Debug, Clone)]
pub struct Svg {
    text: String,
}

impl Svg {
    /// An empty drawing of this size (pixels), with a title for those who do not see it.
    pub fn new([width, height]: [f64; 2], title: &str) -> Self {
        let (width, height) = (digits(width), digits(height));
        let mut svg = Self {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
                 viewBox=\"0 0 {width} {height}\" role=\"img\" font-family=\"{FONTS}\">\n<title>{}</title>\n\
                 <style>{}</style>\n",
                escaped(title),
                dark_rules()
            ),
        };
        let ground = Ink::Ground;
        let (colour, number) = (ground.light(), ground.number());
        let fill = format!("class=\"pf{number}\" fill=\"{colour}\"");
        let _ = writeln!(svg.text, "<rect width=\"{width}\" height=\"{height}\" {fill}/>");
        svg
    }

    /// A rectangle between two corners, filled.
    pub fn rectangle(&mut self, from: Spot, to: Spot, ink: Ink, opacity: f64) {
        if !is_drawn(&[from, to]) {
            return;
        }
        let [x, y] = [from[0].min(to[0]), from[1].min(to[1])].map(digits);
        let [width, height] = [(to[0] - from[0]).abs(), (to[1] - from[1]).abs()].map(digits);
        let fill = filled(ink, opacity);
        let _ = writeln!(self.text, "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"{fill}/>");
    }

    /// A line from place to place. Where one is not finite the line is broken; a single place between breaks is a dot.
    pub fn line(&mut self, spots: &[Spot], stroke: Stroke) {
        let mut path = String::new();
        let mut dots = Vec::new();
        for part in spots.split(|spot| !is_drawn(&[*spot])) {
            match part {
                [] => {}
                [single] => dots.push(*single),
                _ => add_part(&mut path, part),
            }
        }
        if !path.is_empty() {
            let _ = writeln!(self.text, "<path d=\"{path}\" fill=\"none\"{}/>", stroke.attributes());
        }
        for dot in dots {
            self.disc(dot, stroke.width.max(1.0) * 1.2, stroke.ink);
        }
    }

    /// A line around places, filled.
    pub fn polygon(&mut self, spots: &[Spot], ink: Ink) {
        self.area(spots, ink, 1.0);
    }

    /// The same, through which what is under it is seen.
    pub fn area(&mut self, spots: &[Spot], ink: Ink, opacity: f64) {
        if spots.len() < 3 || !is_drawn(spots) {
            return;
        }
        let mut path = String::new();
        add_part(&mut path, spots);
        let _ = writeln!(self.text, "<path d=\"{path}Z\"{}/>", filled(ink, opacity));
    }

    /// A filled circle.
    pub fn disc(&mut self, [x, y]: Spot, radius: f64, ink: Ink) {
        if is_drawn(&[[x, y]]) {
            let [x, y, radius] = [x, y, radius].map(digits);
            let _ = writeln!(self.text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"{}/>", filled(ink, 1.0));
        }
    }

    /// A circle.
    pub fn ring(&mut self, [x, y]: Spot, radius: f64, stroke: Stroke) {
        if is_drawn(&[[x, y]]) {
            let [x, y, radius] = [x, y, radius].map(digits);
            let stroke = stroke.attributes();
            let _ = writeln!(self.text, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"none\"{stroke}/>");
        }
    }

    /// A text on a line whose middle, between the feet and the heads of capitals, is at the place.
    pub fn text(&mut self, at: Spot, text: &str, kind: Type) {
        self.write(at, &escaped(text), kind, ["", ""]);
    }

    /// A text on the colour of the ground, so that it can be read across lines.
    pub fn text_on_ground(&mut self, at: Spot, text: &str, kind: Type) {
        let ground = Ink::Ground;
        let (colour, number) = (ground.light(), ground.number());
        let halo = format!(" stroke=\"{colour}\" stroke-width=\"3\" stroke-linejoin=\"round\" paint-order=\"stroke\"");
        self.write(at, &escaped(text), kind, [&format!(" ps{number}"), &halo]);
    }

    /// A text that reads upwards.
    pub fn upward_text(&mut self, [x, y]: Spot, text: &str, kind: Type) {
        // The middle of the letters is moved before the turn, which is about the place.
        let turn = format!(" transform=\"rotate(-90 {} {})\"", digits(x), digits(y));
        self.write([x, y], &escaped(text), kind, ["", &turn]);
    }

    /// A power of ten after a sign or word, which may be empty.
    pub fn power_of_ten(&mut self, at: Spot, before: &str, exponent: i32, kind: Type) {
        let before = escaped(before);
        let raised = format!("{before}10<tspan dy=\"-0.5em\" font-size=\"0.76em\">{}</tspan>", signed(exponent));
        self.write(at, &raised, kind, ["", ""]);
    }

    /// Writes a text with further classes and attributes.
    fn write(&mut self, [x, y]: Spot, markup: &str, kind: Type, [classes, attributes]: [&str; 2]) {
        if !is_drawn(&[[x, y]]) {
            return;
        }
        let anchor = match kind.anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        let weight = match kind.weight {
            Weight::Regular => "",
            Weight::Bold => " font-weight=\"bold\"",
        };
        // Capitals are about 0.7 of the size of a font high.
        let foot = y + 0.35 * kind.size;
        let (x, foot, size) = (digits(x), digits(foot), digits(kind.size));
        let (colour, number) = (kind.ink.light(), kind.ink.number());
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{foot}\" font-size=\"{size}\"{anchor}{weight} class=\"pf{number}{classes}\" \
             fill=\"{colour}\"{attributes}>{markup}</text>"
        );
    }

    /// The whole file.
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

fn filled(ink: Ink, opacity: f64) -> String {
    let (colour, number) = (ink.light(), ink.number());
    let seen = if opacity < 1.0 { format!(" fill-opacity=\"{}\"", digits(opacity)) } else { String::new() };
    format!(" class=\"pf{number}\" fill=\"{colour}\"{seen}")
}

fn add_part(path: &mut String, spots: &[Spot]) {
    let mut last = None;
    for &[x, y] in spots {
        let place = format!("{} {}", digits(x), digits(y));
        if last.as_ref() != Some(&place) {
            let _ = write!(path, "{}{place}", if last.is_none() { 'M' } else { 'L' });
            last = Some(place);
        }
    }
}

fn is_drawn(spots: &[Spot]) -> bool {
    spots.iter().flatten().all(|number| number.abs() <= FARTHEST)
}

/// A number in hundredths, without trailing zeros.
fn digits(number: f64) -> String {
    let text = format!("{number:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

/// A number with a true minus sign.
fn signed(number: i32) -> String {
    if number < 0 { format!("\u{2212}{}", number.unsigned_abs()) } else { number.to_string() }
}

/// Text in which markup is not markup; letters that XML forbids are left out.
pub(crate) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(' '),
            // XML 1.0, section 2.2: these are no characters of a document.
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => {}
            _ => out.push(letter),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    //! Numbers are short and finite, and text is text.
    use super::*;

    #[test]
    fn numbers_are_hundredths() {
        assert_eq!([1.0, 0.125, -0.001, 2.50].map(digits), ["1", "0.12", "0", "2.5"]);
    }

    #[test]
    fn what_is_not_finite_breaks_a_line() {
        let mut svg = Svg::new([10.0, 10.0], "a");
        let nan = [f64::NAN, 1.0];
        svg.line(&[[0.0, 0.0], [1.0, 1.0], nan, [2.0, 2.0], nan, [3.0, f64::INFINITY]], Stroke::new(Ink::Blue, 1.0));
        svg.disc(nan, 1.0, Ink::Blue);
        let text = svg.finish();
        assert!(text.contains("M0 0L1 1\"") && text.contains("cx=\"2\""), "{text}");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }

    #[test]
    fn markup_in_a_name_is_text() {
        assert_eq!(escaped("a<b> & \"c\"\u{1}\n"), "a&lt;b&gt; &amp; &quot;c&quot; ");
    }
}
