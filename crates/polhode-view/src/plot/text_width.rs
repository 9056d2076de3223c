//! How wide a text is, estimated: figures are laid out without a font.
//!
//! The advance widths are those of DejaVu Sans, which is wider than Helvetica, Arial and their like, in four classes of
//! letters. So a text in another font for the screen takes less room than is kept for it.

/// Widths of classes of letters, of the size of the font.
const NARROW: f64 = 0.36;
const COMMON: f64 = 0.64;
const WIDE: f64 = 0.80;
const WIDEST: f64 = 1.0;

/// Room that a text of this size (pixels) takes at the most, pixels.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().map(width).sum::<f64>() * size
}

const fn width(letter: char) -> f64 {
    match letter {
        ' ' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | '(' | ')' | '[' | ']' | '/' | 'f' | 'i' | 'j' | 'l' | 't'
        | 'I' | '-' => NARROW + 0.04,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '\u{2264}' | '\u{2026}' | '+' | '=' | '<' | '>' | '\u{d7}' | '~' => WIDEST,
        'A'..='Z' | '\u{b5}' => WIDE,
        '\0'..='\u{24f}' => COMMON,
        _ => WIDEST,
    }
}

/// The text, or its beginning and an ellipsis where it is wider than `room` (pixels).
pub(crate) fn cut_to(text: &str, size: f64, room: f64) -> String {
    if text_width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept = String::new();
    let mut used = text_width("\u{2026}", size);
    for letter in text.chars() {
        used += width(letter) * size;
        if used > room {
            break;
        }
        kept.push(letter);
    }
    format!("{}\u{2026}", kept.trim_end())
}

/// The text in lines of at most `room` (pixels), broken between words; the last of `most` lines is cut.
pub(crate) fn lines_of(text: &str, size: f64, room: f64, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if is_too_long(line, word, size, room) => lines.push(word.to_owned()),
            Some(line) => *line = format!("{line} {word}"),
            None => lines.push(word.to_owned()),
        }
    }
    if lines.len() > most {
        let rest = lines.split_off(most.saturating_sub(1)).join(" ");
        lines.push(rest);
    }
    lines.iter().map(|line| cut_to(line, size, room)).collect()
}

fn is_too_long(line: &str, word: &str, size: f64, room: f64) -> bool {
    text_width(line, size) + text_width(word, size) + text_width(" ", size) > room
}

#[cfg(test)]
mod tests {
    //! What is cut fits.
    use super::*;

    #[test]
    fn a_text_that_fits_is_whole_and_a_longer_one_is_cut() {
        assert_eq!(cut_to("brick", 12.0, 100.0), "brick");
        let cut = cut_to("a body of a very long name", 12.0, 60.0);
        assert!(cut.ends_with('\u{2026}') && text_width(&cut, 12.0) <= 60.0, "{cut}");
        assert_eq!(cut_to("x", 12.0, 0.0), "\u{2026}");
    }

    #[test]
    fn a_long_text_is_broken_between_words() {
        let lines = lines_of("one two three four five six seven eight nine", 10.0, 80.0, 3);
        assert!(lines.len() == 3 && lines.iter().all(|line| text_width(line, 10.0) <= 80.0), "{lines:?}");
        assert!(lines[0].starts_with("one two") && lines[2].ends_with('\u{2026}'), "{lines:?}");
        assert_eq!(lines_of("", 10.0, 80.0, 3), [""; 0]);
    }
}
