//! Problems of rows as plain text, one problem in a file, so that a set of them can be kept and solved again.
//!
//! ```text
//! polhode-problem 1
//! # facts: a word and what it is, such as who asked and which method answered
//! answered newton
//! width 6
//! body <the inverse mass of a body: width x width numbers, row-major>
//! block cone 3 0.5
//! row <constant term> <compliance> <start> <body> <width numbers> <body> <width numbers>
//! ```
//!
//! A block is one of `push`, `hold ROWS`, `cone ROWS MU`, `slide MU` and `resist` with rows, coefficient and `0` or `1`
//! (slides) of slip, rolling and spinning; its rows follow it. A row that names no body is the unit vector of its own
//! number on the only body: so stands a problem of which only the matrix is known, which is then the inverse mass.
//! Numbers have all their digits.

use crate::law::{Law, Resistance};
use std::fmt;

/// The first line.
const HEAD: &str = "polhode-problem 1";

/// A row.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TextRow {
    /// The constant term: velocity or acceleration without reactions.
    pub constant: f64,
    /// Compliance, 1/kg.
    pub compliance: f64,
    /// The reaction that the solver was given to start with; 0 without one.
    pub start: f64,
    /// The bodies that it touches, with its Jacobian there; empty for a unit vector.
    pub entries: Vec<(usize, Vec<f64>)>,
}

/// Rows with one law.
#[derive(Debug, Clone, PartialEq)]
pub struct TextBlock {
    /// What they ask for.
    pub law: Law,
    /// The rows.
    pub rows: Vec<TextRow>,
}

/// A problem.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ProblemText {
    /// Coordinates of a body.
    pub width: usize,
    /// Inverse masses of the bodies, row-major.
    pub inverse_masses: Vec<Vec<f64>>,
    /// The blocks.
    pub blocks: Vec<TextBlock>,
}

/// Why a text is no problem.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {what}")]
pub struct ProblemTextError {
    /// The line, from 1 on.
    pub line: usize,
    /// What is wrong.
    pub what: String,
}

impl ProblemText {
    /// The text, with some facts about it: a word each, and what it is.
    pub fn written(&self, facts: &[(&str, String)]) -> String {
        let facts = facts.iter().map(|(word, fact)| format!("{word} {fact}\n"));
        format!("{HEAD}\n{}{self}", facts.collect::<String>())
    }

    /// Reads a text; the facts besides.
    ///
    /// # Errors
    /// When it is no such text: a head, a number or a law that is not as it should be.
    pub fn read(text: &str) -> Result<(Self, Vec<(String, String)>), ProblemTextError> {
        let (mut problem, mut facts) = (Self::default(), Vec::new());
        let error = |line: usize, what: &str| ProblemTextError { line: line + 1, what: what.to_owned() };
        for (number, line) in text.lines().enumerate() {
            let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
            let told = |what: &str| error(number, what);
            match word {
                _ if number == 0 => (line == HEAD).then_some(()).ok_or_else(|| told("not the head of a problem"))?,
                "" | "#" => {}
                "width" => problem.width = rest.parse().map_err(|_| told("width is no number"))?,
                "body" => problem.inverse_masses.push(numbers(rest).ok_or_else(|| told("not all are numbers"))?),
                "block" => {
                    let law = law_of(rest).ok_or_else(|| told("no law of rows"))?;
                    problem.blocks.push(TextBlock { law, rows: Vec::new() });
                }
                "row" => {
                    let width = problem.width;
                    let block = problem.blocks.last_mut().ok_or_else(|| told("a row before the first block"))?;
                    block.rows.push(row_of(rest, width).ok_or_else(|| told("not the numbers of a row"))?);
                }
                fact => facts.push((fact.to_owned(), rest.to_owned())),
            }
        }
        let lines = text.lines().count();
        if problem.inverse_masses.iter().any(|mass| mass.len() != problem.width * problem.width) {
            return Err(error(lines, "an inverse mass has another number of entries than the width asks for"));
        }
        if problem.blocks.iter().any(|block| block.rows.len() != block.law.rows()) {
            return Err(error(lines, "a block has another number of rows than its law"));
        }
        Ok((problem, facts))
    }
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split_whitespace().map(|word| word.parse().ok()).collect()
}

fn row_of(text: &str, width: usize) -> Option<TextRow> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let (first, rest) = words.split_at_checked(3)?;
    let number = |word: &&str| word.parse::<f64>().ok();
    let mut row = TextRow {
        constant: number(first.first()?)?,
        compliance: number(first.get(1)?)?,
        start: number(first.get(2)?)?,
        entries: Vec::new(),
    };
    for entry in rest.chunks(width + 1) {
        let (body, jacobian) = entry.split_first()?;
        let jacobian: Vec<f64> = jacobian.iter().map(number).collect::<Option<_>>()?;
        row.entries.push((body.parse().ok()?, (jacobian.len() == width).then_some(jacobian)?));
    }
    Some(row)
}

fn law_of(text: &str) -> Option<Law> {
    let mut words = text.split_whitespace();
    let name = words.next()?;
    let mut number = || words.next()?.parse::<f64>().ok();
    let law = match name {
        "push" => Law::Push,
        "hold" => Law::Hold { rows: number()? as usize },
        "cone" => Law::Cone { rows: number()? as usize, friction: number()? },
        "slide" => Law::Slide { friction: number()? },
        "resist" => {
            let mut parts = [Resistance::default(); 3];
            for part in &mut parts {
                *part = Resistance { rows: number()? as usize, friction: number()?, slides: number()? != 0.0 };
            }
            Law::Resist { parts }
        }
        _ => return None,
    };
    Some(law)
}

impl fmt::Display for ProblemText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "width {}", self.width)?;
        for mass in &self.inverse_masses {
            write_numbers(f, "body", mass)?;
            writeln!(f)?;
        }
        for block in &self.blocks {
            match block.law {
                Law::Push => writeln!(f, "block push")?,
                Law::Hold { rows } => writeln!(f, "block hold {rows}")?,
                Law::Cone { rows, friction } => writeln!(f, "block cone {rows} {friction:?}")?,
                Law::Slide { friction } => writeln!(f, "block slide {friction:?}")?,
                Law::Resist { parts } => {
                    write!(f, "block resist")?;
                    for part in parts {
                        write!(f, " {} {:?} {}", part.rows, part.friction, u8::from(part.slides))?;
                    }
                    writeln!(f)?;
                }
            }
            for row in &block.rows {
                write!(f, "row {:?} {:?} {:?}", row.constant, row.compliance, row.start)?;
                for (body, jacobian) in &row.entries {
                    write_numbers(f, &format!(" {body}"), jacobian)?;
                }
                writeln!(f)?;
            }
        }
        Ok(())
    }
}

fn write_numbers(f: &mut fmt::Formatter<'_>, before: &str, numbers: &[f64]) -> fmt::Result {
    f.write_str(before)?;
    numbers.iter().try_for_each(|number| write!(f, " {number:?}"))
}

#[cfg(test)]
mod tests {
    //! What is no problem is told.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    #[test]
    fn what_is_no_problem_is_refused_with_its_line() {
        assert_eq!(ProblemText::read("anything").unwrap_err().line, 1);
        for (text, line) in [("row 1 2 3", 2), ("block cone", 2), ("width 1\nbody 1 x", 3), ("block push\nrow 1 2", 3)]
        {
            assert_eq!(ProblemText::read(&format!("{HEAD}\n{text}")).unwrap_err().line, line, "{text}");
        }
    }
}
