//! Columns of equal width, numbers in few digits.

use polhode::spatial::DVec3;
use std::fmt::Write as _;

/// Significant digits of a number in a report: enough to recognise, files hold all of them.
const DIGITS: i32 = 7;

/// Rows of cells that are printed in columns, each as wide as its widest cell.
#[derive(Debug, Default)]
pub(crate) struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn row<const N: usize>(&mut self, cells: [&str; N]) {
        self.rows.push(cells.map(str::to_owned).to_vec());
    }

    pub(crate) fn cells(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The rows, indented by two spaces.
    pub(crate) fn print(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let width = |column: usize| {
            self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<_> = (0..columns).map(width).collect();
        let mut text = String::new();
        for row in &self.rows {
            let mut line = String::new();
            for (cell, &width) in row.iter().zip(&widths) {
                let _ = write!(line, "{GAP}{cell:<width$}");
            }
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}

impl Table {
    /// The rows, with the last column broken between words so that no line is longer than `width` characters, but for
    /// longer words.
    pub(crate) fn print_within(&self, width: usize) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let cell_width = |column: usize| {
            self.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let before: usize = (0..columns.saturating_sub(1)).map(|column| cell_width(column) + GAP.len()).sum();
        let mut broken = Self::default();
        for row in &self.rows {
            let Some((last, first)) = row.split_last().filter(|_| row.len() == columns) else {
                broken.rows.push(row.clone());
                continue;
            };
            for (number, line) in lines(last, width.saturating_sub(before + GAP.len())).into_iter().enumerate() {
                let mut cells = if number == 0 { first.to_vec() } else { vec![String::new(); first.len()] };
                cells.push(line);
                broken.rows.push(cells);
            }
        }
        broken.print()
    }
}

/// What stands before every cell.
const GAP: &str = "  ";

/// A text in lines of at most `width` characters, but for longer words; at least one.
pub(crate) fn lines(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let used = lines.last().map_or(0, |line| line.chars().count());
        let fits = used == 0 || used + 1 + word.chars().count() <= width;
        match lines.last_mut().filter(|_| fits) {
            Some(line) => {
                if used > 0 {
                    line.push(' ');
                }
                line.push_str(word);
            }
            None => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A number in at most [`DIGITS`] significant digits.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 {
        // Minus zero too.
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string();
    }
    let exponent = value.abs().log10().floor() as i32;
    if (-4..DIGITS).contains(&exponent) {
        let decimals = (DIGITS - 1 - exponent).max(0) as usize;
        let text = format!("{value:.decimals$}");
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        let text = format!("{value:.*e}", (DIGITS - 1) as usize);
        match text.split_once('e') {
            Some((mantissa, exponent)) if mantissa.contains('.') => {
                format!("{}e{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
            }
            _ => text,
        }
    }
}

/// Three numbers.
pub(crate) fn vector(v: DVec3) -> String {
    format!("({}, {}, {})", number(v.x), number(v.y), number(v.z))
}
