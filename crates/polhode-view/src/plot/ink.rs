//! Colours of figures, for light and dark pages.
//!
//! A figure names an ink, not a colour. Each ink has one colour on white, which every program that reads SVG shows, and
//! one for dark pages, which browsers take when the reader asks for dark pages. The inks of curves have a contrast of
//! at least 4.5 to 1 against white, so that labels in them can be read, and differ for readers who see fewer colours
//! (blue, vermilion, green and purple after Okabe and Ito, darkened).

use std::fmt::Write as _;

/// What something is drawn in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Ink {
    /// Text, and what must be seen.
    Text,
    /// Text of less weight, axes.
    Faint,
    /// Lines of a grid.
    Grid,
    /// What everything is drawn on.
    Ground,
    /// A band behind curves.
    Band,
    /// The first ink of curves.
    Blue,
    /// The second.
    Vermilion,
    /// The third.
    Green,
    /// The fourth.
    Purple,
    /// The fifth.
    Gold,
    /// The sixth.
    Teal,
    /// The seventh.
    Grey,
}

impl Ink {
    /// All inks.
    pub const ALL: [Self; 12] = [
        Self::Text,
        Self::Faint,
        Self::Grid,
        Self::Ground,
        Self::Band,
        Self::Blue,
        Self::Vermilion,
        Self::Green,
        Self::Purple,
        Self::Gold,
        Self::Teal,
        Self::Grey,
    ];

    /// Inks of curves, in the order in which they are taken.
    pub const CURVES: [Self; 7] =
        [Self::Blue, Self::Vermilion, Self::Green, Self::Purple, Self::Gold, Self::Teal, Self::Grey];

    /// The ink of the curve of this number, from 0.
    pub fn of_curve(number: usize) -> Self {
        Self::CURVES[number % Self::CURVES.len()]
    }

    /// The colour on white.
    pub(crate) const fn light(self) -> &'static str {
        match self {
            Self::Text => "#1f2328",
            Self::Faint => "#59636e",
            Self::Grid => "#e3e6ea",
            Self::Ground => "#ffffff",
            Self::Band => "#ffe59a",
            Self::Blue => "#0068a8",
            Self::Vermilion => "#c24a00",
            Self::Green => "#00785a",
            Self::Purple => "#a2407f",
            Self::Gold => "#8a6400",
            Self::Teal => "#0e7c8c",
            Self::Grey => "#6a6f76",
        }
    }

    /// The colour on dark pages.
    const fn dark(self) -> &'static str {
        match self {
            Self::Text => "#e6edf3",
            Self::Faint => "#9da7b1",
            Self::Grid => "#2a3038",
            Self::Ground => "#0d1117",
            Self::Band => "#57470f",
            Self::Blue => "#58b0ee",
            Self::Vermilion => "#ff9050",
            Self::Green => "#45cfa4",
            Self::Purple => "#ea93cb",
            Self::Gold => "#e0b33c",
            Self::Teal => "#54c8d8",
            Self::Grey => "#a3abb4",
        }
    }

    /// Its number: the name of its classes.
    pub(crate) const fn number(self) -> usize {
        self as usize
    }
}

/// The rules that change the colours on dark pages: class `pf` and the number of an ink fills, `ps` strokes.
pub(crate) fn dark_rules() -> String {
    let mut rules = "@media(prefers-color-scheme:dark){".to_owned();
    for ink in Ink::ALL {
        let (number, colour) = (ink.number(), ink.dark());
        let _ = write!(rules, ".pf{number}{{fill:{colour}}}.ps{number}{{stroke:{colour}}}");
    }
    rules.push('}');
    rules
}

#[cfg(test)]
mod tests {
    //! Labels can be read on white and on dark pages.
    use super::*;

    /// Relative luminance (WCAG 2.2, definition of relative luminance).
    fn luminance(colour: &str) -> f64 {
        let part = |at: usize| {
            let value = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap_or(0)) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
        };
        0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
    }

    fn contrast(a: &str, b: &str) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn text_and_curves_stand_out_from_the_ground() {
        for ink in Ink::CURVES.into_iter().chain([Ink::Text, Ink::Faint]) {
            let light = contrast(ink.light(), Ink::Ground.light());
            let dark = contrast(ink.dark(), Ink::Ground.dark());
            assert!(light >= 4.5 && dark >= 4.5, "{ink:?}: {light:.2}, {dark:.2}");
        }
    }

    #[test]
    fn an_ink_is_its_place_in_the_list() {
        assert!(Ink::ALL.iter().enumerate().all(|(number, ink)| ink.number() == number));
    }
}
