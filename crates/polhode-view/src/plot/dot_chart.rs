//! Many scenes at one glance: rows of dots on logarithmic axes, one dot for a method, columns side by side.

use super::axes;
use super::decades::Decades;
use super::ink::Ink;
use super::method_style::{FAMILIES, Style, styles};
use super::svg::{Anchor, Stroke, Svg, Type};
use super::text_width::{cut_to, text_width};

/// Width of a figure, pixels.
const WIDTH: f64 = 1000.0;
/// Room on the left for the names of rows, and on the right, pixels.
const LEFT: f64 = 150.0;
const RIGHT: f64 = 14.0;
/// Room above the rows, pixels.
const TOP: f64 = 82.0;
/// Between columns, pixels.
const GAP: f64 = 18.0;
/// Height of a row, pixels.
const ROW: f64 = 46.0;
/// Places of the dots and of the text above them, from the top of a row, pixels.
const DOTS: f64 = 31.0;
const ABOVE: f64 = 13.0;
/// Size of labels, pixels.
const LABEL: f64 = 11.5;
/// Height of a line of the legend, pixels.
const LEGEND_ROW: f64 = 18.0;
/// Half of the width of a marker, pixels.
const MARKER: f64 = 4.2;
/// Room on both sides of the values, decades.
const ROOM: f64 = 0.25;
/// Marks on an axis, about.
const MARKS: usize = 5;

/// A method in a cell.
#[derive(Debug, Clone, PartialEq)]
pub struct Dot {
    /// Its name.
    pub method: String,
    /// Its value.
    pub value: f64,
}

/// Where a row and a column meet.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Cell {
    /// The methods.
    pub dots: Vec<Dot>,
    /// Number of the dot that is marked.
    pub best: Option<usize>,
    /// What is said of it.
    pub text: String,
}

/// A row.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its name.
    pub name: String,
    /// What there is to know besides; may be empty.
    pub note: String,
    /// Its cells, one a column.
    pub cells: Vec<Cell>,
}

/// Rows of dots.
#[derive(Debug, Clone, PartialEq)]
pub struct DotChart {
    /// What it is of.
    pub title: String,
    /// What there is to know besides.
    pub subtitle: String,
    /// What the axes show.
    pub across: String,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The rows, from above.
    pub rows: Vec<Row>,
}

impl DotChart {
    /// The figure as SVG.
    pub fn svg(&self) -> String {
        let names = self.methods();
        let all = styles(&names);
        let style =
            |name: &str| names.iter().position(|other| *other == name).and_then(|number| all.get(number)).copied();
        let foot = TOP + ROW * self.rows.len() as f64;
        let legend = legend_rows(&names);
        let mut svg = Svg::new([WIDTH, foot + 56.0 + LEGEND_ROW * legend.len() as f64], &self.title);
        let room = WIDTH - 24.0;
        svg.text([12.0, 18.0], &cut_to(&self.title, 16.0, room), Type::new(16.0, Ink::Text).bold());
        svg.text([12.0, 39.0], &cut_to(&self.subtitle, 12.0, room), Type::new(12.0, Ink::Faint));
        self.draw_row_names(&mut svg);
        let values = self.rows.iter().flat_map(|row| row.cells.iter().flat_map(|cell| &cell.dots));
        let axis = Decades::around(values.map(|dot| libm::log10(dot.value)), ROOM);
        let count = self.columns.len().max(1) as f64;
        let width = (WIDTH - LEFT - RIGHT - GAP * (count - 1.0)) / count;
        for (number, column) in self.columns.iter().enumerate() {
            let left = LEFT + (width + GAP) * number as f64;
            let range = [left, left + width];
            svg.text([left, TOP - 14.0], column, Type::new(12.5, Ink::Text).bold());
            draw_axis(&mut svg, axis, range, foot);
            for (row, place) in self.rows.iter().zip(0..) {
                if let Some(cell) = row.cells.get(number) {
                    draw_cell(&mut svg, cell, axis, range, TOP + ROW * f64::from(place), &style);
                }
            }
        }
        let middle = 0.5 * (LEFT + WIDTH - RIGHT);
        svg.text([middle, foot + 34.0], &self.across, Type::new(12.5, Ink::Text).anchor(Anchor::Middle));
        for (line, y) in legend.iter().zip(0..) {
            for (x, name) in line {
                let y = foot + 58.0 + LEGEND_ROW * f64::from(y);
                if let Some(Style { ink, marker }) = style(name) {
                    marker.draw(&mut svg, [*x, y], MARKER, ink);
                    svg.text([x + 10.0, y], name, Type::new(LABEL, ink));
                }
            }
        }
        svg.finish()
    }

    /// The methods, those of a family beside each other, in the order in which they occur.
    fn methods(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for dot in self.rows.iter().flat_map(|row| row.cells.iter().flat_map(|cell| &cell.dots)) {
            if !names.contains(&dot.method.as_str()) {
                names.push(&dot.method);
            }
        }
        let family_of = |name: &&str| FAMILIES.iter().position(|family| family.members.contains(name));
        names.sort_by_key(|name| family_of(name).unwrap_or(FAMILIES.len()));
        names
    }

    fn draw_row_names(&self, svg: &mut Svg) {
        for (row, number) in self.rows.iter().zip(0..) {
            let top = TOP + ROW * f64::from(number);
            svg.line(&[[12.0, top], [WIDTH - RIGHT, top]], Stroke::new(Ink::Grid, 1.0));
            let y = top + if row.note.is_empty() { 0.5 * ROW } else { 16.0 };
            svg.text([12.0, y], &cut_to(&row.name, 12.5, LEFT - 20.0), Type::new(12.5, Ink::Text).bold());
            svg.text([12.0, y + 16.0], &cut_to(&row.note, 11.0, LEFT - 20.0), Type::new(11.0, Ink::Faint));
        }
    }
}

fn draw_axis(svg: &mut Svg, axis: Decades, [left, right]: [f64; 2], foot: f64) {
    for (part, mark) in axis.marks(MARKS) {
        let x = left + part * (right - left);
        svg.line(&[[x, TOP], [x, foot]], Stroke::new(Ink::Grid, 1.0));
        axes::mark(svg, [x, foot + 13.0], &mark, Type::new(LABEL, Ink::Faint).anchor(Anchor::Middle));
    }
    svg.line(&[[left, foot], [right, foot]], Stroke::new(Ink::Faint, 1.0));
}

fn draw_cell(
    svg: &mut Svg,
    cell: &Cell,
    axis: Decades,
    [left, right]: [f64; 2],
    top: f64,
    style: &impl Fn(&str) -> Option<Style>,
) {
    let place = |dot: &Dot| [left + axis.part(libm::log10(dot.value)) * (right - left), top + DOTS];
    let best = cell.best.and_then(|best| cell.dots.get(best));
    // The marked dot is drawn over the others.
    for dot in cell.dots.iter().rev().chain(best) {
        if let Some(Style { ink, marker }) = style(&dot.method) {
            marker.draw(svg, place(dot), MARKER, ink);
        }
    }
    let Some(best) = best else {
        let none = Type::new(LABEL, Ink::Faint).anchor(Anchor::Middle);
        return svg.text([0.5 * (left + right), top + DOTS - 6.0], "none", none);
    };
    let spot = place(best);
    svg.ring(spot, 8.0, Stroke::new(Ink::Text, 1.6));
    let ink = style(&best.method).map_or(Ink::Text, |style| style.ink);
    let text = cut_to(&cell.text, LABEL, right - left - 4.0);
    let half = 0.5 * text_width(&text, LABEL);
    let x = spot[0].clamp(left + half.min(0.5 * (right - left)), (right - half).max(0.5 * (left + right)));
    svg.text_on_ground([x, top + ABOVE], &text, Type::new(LABEL, ink).anchor(Anchor::Middle));
}

/// Names with their places, in lines.
fn legend_rows<'a>(names: &[&'a str]) -> Vec<Vec<(f64, &'a str)>> {
    let mut rows: Vec<Vec<(f64, &str)>> = vec![Vec::new()];
    let mut x = 18.0;
    for &name in names {
        let width = text_width(name, LABEL) + 30.0;
        if x + width > WIDTH - RIGHT {
            rows.push(Vec::new());
            x = 18.0;
        }
        if let Some(row) = rows.last_mut() {
            row.push((x, name));
        }
        x += width;
    }
    rows
}
