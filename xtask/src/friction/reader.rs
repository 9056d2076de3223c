//! Frictional contact problems as text: the `.dat` form of the test data of Siconos (docs/REFERENCES.md, Acary, Bremond
//! and Huber 2018).
//!
//! Dimension `d` (2 or 3), number of contacts `n`, the matrix, `d n` constants, `n` coefficients of friction, and at
//! the end a flag or nothing. The matrix starts with its storage, rows and columns. Storage 0, dense: rows and columns
//! once more, then the values, column after column. Storage 1, blocks: the numbers of blocks, block rows and block
//! columns, the cumulated sizes of block rows and of block columns, the lengths of two lists of indices, the first
//! block of each block row (with one more at the end), the block column of each block, and then for each block its
//! number and its values, column after column. In each contact the normal component comes first.

use super::error::{Fault, ProblemFileError};
use polhode::response::Law;
use polhode::response::ResponseError;
use polhode::response::friction::{BlockMatrix, FrictionProblem};
use std::fs;
use std::path::Path;

/// A problem with its dimension.
#[derive(Debug)]
pub(crate) struct ProblemFile {
    /// 2 or 3.
    pub(crate) dimension: usize,
    /// The problem.
    pub(crate) problem: FrictionProblem,
}

/// What is wrong, and in which line.
type Refusal = (usize, Fault);

/// Reads a problem.
///
/// # Errors
/// When the file cannot be read, or is not such a problem: then with its line.
pub(crate) fn read(path: &Path) -> Result<ProblemFile, ProblemFileError> {
    let bytes = fs::read(path).map_err(|source| ProblemFileError::Read { path: path.to_owned(), source })?;
    // A byte that is no text is found as a word that is no number, with its line.
    let text = String::from_utf8_lossy(&bytes);
    parse(&text).map_err(|(line, fault)| ProblemFileError::At { path: path.to_owned(), line, fault })
}

/// A problem from text.
pub(crate) fn parse(text: &str) -> Result<ProblemFile, Refusal> {
    let mut words = Words::of(text);
    let dimension = words.one_of("the dimension", &[2, 3])?;
    let contacts = words.count("number of contacts")?;
    let entries = match words.one_of("the storage of the matrix (0 dense, 1 blocks)", &[0, 1])? {
        0 => dense(&mut words, dimension, contacts)?,
        _ => blocks(&mut words, dimension, contacts)?,
    };
    let constant = words.numbers("the constant vector", dimension.saturating_mul(contacts))?;
    let mut friction = Vec::new();
    for contact in 0..contacts {
        let value = words.number("coefficient of friction", contacts - contact)?;
        if value < 0.0 {
            return Err((words.line(), Fault::Friction { contact, value }));
        }
        friction.push(value);
    }
    if words.left() > 1 {
        let count = words.left();
        words.next += 1;
        return Err((words.line(), Fault::LeftOver { count }));
    }
    if words.left() == 1 {
        words.number("flag", 1)?;
    }
    let line_of = |row: usize, column: usize| entries.line_of(dimension, row, column);
    let refused = |error: ResponseError| match error {
        ResponseError::Asymmetric { row, column, .. } => (line_of(row, column), error.into()),
        ResponseError::NegativeDiagonal { row, .. } => (line_of(row, row), error.into()),
        _ => (1, error.into()),
    };
    let matrix = BlockMatrix::from_blocks(&vec![dimension; contacts], entries.blocks.clone()).map_err(refused)?;
    let contacts = friction.into_iter().map(|friction| Law::Cone { rows: dimension, friction }).collect();
    let problem = FrictionProblem::new(contacts, matrix, constant).map_err(refused)?;
    Ok(ProblemFile { dimension, problem })
}

/// Blocks of the matrix, row-major, and the line of each of their entries.
#[derive(Debug, Default)]
struct Entries {
    blocks: Vec<(usize, usize, Vec<f64>)>,
    lines: Vec<Vec<usize>>,
}

impl Entries {
    /// The line of an entry of the matrix, or of its mirror.
    fn line_of(&self, dimension: usize, row: usize, column: usize) -> usize {
        let find = |row: usize, column: usize| {
            let (i, j) = (row / dimension, column / dimension);
            let block = self.blocks.iter().position(|&(a, b, _)| (a, b) == (i, j))?;
            self.lines[block].get((row % dimension) * dimension + column % dimension).copied()
        };
        find(row, column).or_else(|| find(column, row)).unwrap_or(1)
    }
}

/// The square block that is written column after column in `values`.
fn transposed<T: Copy>(values: &[T], size: usize) -> Vec<T> {
    (0..size).flat_map(|row| (0..size).map(move |column| values[column * size + row])).collect()
}

fn dense(words: &mut Words<'_>, dimension: usize, contacts: usize) -> Result<Entries, Refusal> {
    let rows = dimension.saturating_mul(contacts);
    words.size("rows and columns of the matrix", rows)?;
    words.size("rows and columns of the dense matrix", rows)?;
    let (values, lines) = words.numbers_with_lines("the matrix", rows.saturating_mul(rows))?;
    let mut entries = Entries::default();
    for i in 0..contacts {
        for j in 0..contacts {
            let at = |k: usize| (j * dimension + k / dimension) * rows + i * dimension + k % dimension;
            let places: Vec<usize> = (0..dimension * dimension).map(at).collect();
            let block: Vec<f64> = places.iter().map(|&place| values[place]).collect();
            if i == j || block.iter().any(|value| *value != 0.0) {
                let block_lines: Vec<usize> = places.iter().map(|&place| lines[place]).collect();
                entries.blocks.push((i, j, transposed(&block, dimension)));
                entries.lines.push(transposed(&block_lines, dimension));
            }
        }
    }
    Ok(entries)
}

fn blocks(words: &mut Words<'_>, dimension: usize, contacts: usize) -> Result<Entries, Refusal> {
    words.size("rows and columns of the matrix", dimension.saturating_mul(contacts))?;
    let count = words.count("number of blocks")?;
    words.size("block rows and block columns", contacts)?;
    for _ in 0..2 {
        for block in 1..=contacts {
            words.exactly("cumulated size of the blocks", block * dimension)?;
        }
    }
    words.exactly("length of the list of first blocks", contacts + 1)?;
    words.exactly("length of the list of block columns", count)?;
    let mut first = Vec::new();
    for row in 0..=contacts {
        let start = words.count("first block of a block row")?;
        let least = first.last().copied().unwrap_or(0);
        let is_right = match row {
            0 => start == 0,
            _ if row == contacts => start == count,
            _ => (least..=count).contains(&start),
        };
        if !is_right {
            let expected = format!("from {least} to {count}, the first 0 and the last {count}");
            return Err(words.wrong("first block of a block row", expected, &start));
        }
        first.push(start);
    }
    let mut columns = Vec::new();
    for _ in 0..count {
        let column = words.count("block column of a block")?;
        if column >= contacts {
            return Err(words.wrong("block column of a block", format!("below {contacts}"), &column));
        }
        columns.push(column);
    }
    let mut entries = Entries::default();
    for row in 0..contacts {
        for block in first[row]..first[row + 1] {
            words.exactly("number of a block", block)?;
            let (values, lines) = words.numbers_with_lines("a block of the matrix", dimension * dimension)?;
            if let Some(&(_, _, _)) = entries.blocks.iter().rev().find(|(i, j, _)| (*i, *j) == (row, columns[block])) {
                return Err((words.line(), ResponseError::RepeatedBlock { row, column: columns[block] }.into()));
            }
            entries.blocks.push((row, columns[block], transposed(&values, dimension)));
            entries.lines.push(transposed(&lines, dimension));
        }
    }
    Ok(entries)
}

/// The words of a text with their lines.
#[derive(Debug)]
struct Words<'a> {
    list: Vec<(usize, &'a str)>,
    next: usize,
    last_line: usize,
}

impl<'a> Words<'a> {
    fn of(text: &'a str) -> Self {
        let lines = text.lines().enumerate();
        let list = lines.flat_map(|(line, text)| text.split_whitespace().map(move |word| (line + 1, word))).collect();
        Self { list, next: 0, last_line: text.lines().count().max(1) }
    }

    fn left(&self) -> usize {
        self.list.len() - self.next
    }

    /// The line of the word that was read last.
    fn line(&self) -> usize {
        self.next.checked_sub(1).and_then(|k| self.list.get(k)).map_or(1, |(line, _)| *line)
    }

    fn word(&mut self, what: &'static str, expected: usize) -> Result<&'a str, Refusal> {
        let Some(&(_, word)) = self.list.get(self.next) else {
            return Err((self.last_line, Fault::CutOff { what, expected }));
        };
        self.next += 1;
        Ok(word)
    }

    /// A finite number; `expected` are the numbers of its list from here on.
    fn number(&mut self, what: &'static str, expected: usize) -> Result<f64, Refusal> {
        let word = self.word(what, expected)?;
        match word.parse::<f64>() {
            Ok(value) if value.is_finite() => Ok(value),
            Ok(_) => Err((self.line(), Fault::NotFinite { what, found: word.to_owned() })),
            Err(_) => Err((self.line(), Fault::NoNumber { what, found: word.to_owned() })),
        }
    }

    fn numbers(&mut self, what: &'static str, count: usize) -> Result<Vec<f64>, Refusal> {
        self.numbers_with_lines(what, count).map(|(values, _)| values)
    }

    fn numbers_with_lines(&mut self, what: &'static str, count: usize) -> Result<(Vec<f64>, Vec<usize>), Refusal> {
        let (mut values, mut lines) = (Vec::new(), Vec::new());
        for k in 0..count {
            values.push(self.number(what, count - k)?);
            lines.push(self.line());
        }
        Ok((values, lines))
    }

    fn count(&mut self, what: &'static str) -> Result<usize, Refusal> {
        let word = self.word(what, 1)?;
        word.parse().map_err(|_| self.wrong(what, "a whole number, at least 0".to_owned(), &word))
    }

    fn exactly(&mut self, what: &'static str, expected: usize) -> Result<(), Refusal> {
        let found = self.count(what)?;
        if found == expected { Ok(()) } else { Err(self.wrong(what, expected.to_string(), &found)) }
    }

    /// Two counts that must both be `expected`.
    fn size(&mut self, what: &'static str, expected: usize) -> Result<(), Refusal> {
        self.exactly(what, expected)?;
        self.exactly(what, expected)
    }

    fn one_of(&mut self, what: &'static str, accepted: &[usize]) -> Result<usize, Refusal> {
        let found = self.count(what)?;
        if accepted.contains(&found) {
            return Ok(found);
        }
        let names: Vec<String> = accepted.iter().map(ToString::to_string).collect();
        Err(self.wrong(what, names.join(" or "), &found))
    }

    fn wrong(&self, what: &'static str, expected: String, found: &impl ToString) -> Refusal {
        (self.line(), Fault::Count { what, expected, found: found.to_string() })
    }
}

#[cfg(test)]
mod tests {
    //! A file is read as it is meant, and what is wrong in one is named with its line. A wrong file must never pass for
    //! a problem.
    #![allow(clippy::unwrap_used, reason = "a test that cannot go on has failed")]
    use super::*;

    /// Two contacts in a plane that share a body, in blocks, one item a line.
    const BLOCKS: &str = "2\n2\n1\n4 4\n4 2 2\n2 4\n2 4\n3 4\n0 2 4\n0 1 0 1\n0\n1 0.25 0.25 1\n1\n0.5 0.125 0 0.5\n2\n\
                          0.5 0 0.125 0.5\n3\n1 0 0 1\n-1 0.5 -2 0\n0.5 0.75\n";

    fn refusal(text: &str) -> (usize, String) {
        let (line, fault) = parse(text).unwrap_err();
        (line, fault.to_string())
    }

    #[test]
    fn blocks_are_written_column_after_column() {
        let file = parse(BLOCKS).unwrap();
        assert_eq!((file.dimension, file.problem.len()), (2, 2));
        // G (1, 0, 0, 0) + q is the first column and q.
        assert_eq!(file.problem.velocities(&[1.0, 0.0, 0.0, 0.0]).unwrap(), [0.0, 0.75, -1.5, 0.0]);
        assert_eq!(file.problem.velocities(&[0.0, 0.0, 0.0, 1.0]).unwrap(), [-1.0, 1.0, -2.0, 1.0]);
        assert_eq!(file.problem.blocks()[1], Law::Cone { rows: 2, friction: 0.75 });
    }

    #[test]
    fn a_dense_matrix_is_written_column_after_column_and_a_flag_may_follow() {
        let file = parse("3 1 0 3 3 3 3 15 -1 -2 -1 14 1 -2 1 16 -1 2 3 0.1 1").unwrap();
        assert_eq!(file.problem.velocities(&[1.0, 0.0, 0.0]).unwrap(), [14.0, 1.0, 1.0]);
    }

    #[test]
    fn a_file_that_is_cut_off_is_named_where_it_ends() {
        let lines: Vec<&str> = BLOCKS.lines().collect();
        for kept in 0..lines.len() {
            let (line, fault) = refusal(&lines[..kept].join("\n"));
            assert_eq!(line, kept.max(1));
            assert!(fault.contains("ends here"), "{fault}");
        }
    }

    #[test]
    fn wrong_counts_are_named_with_their_line() {
        let with = |line: usize, text: &str| {
            let mut lines: Vec<&str> = BLOCKS.lines().collect();
            lines[line - 1] = text;
            refusal(&lines.join("\n"))
        };
        for (line, text) in [(1, "4"), (1, "x"), (3, "2"), (4, "4 5"), (5, "4 3 2"), (6, "2 5"), (8, "4 4"), (8, "3 5")]
        {
            let (found, fault) = with(line, text);
            assert!(found == line && fault.contains("must be"), "{text}: line {found}: {fault}");
        }
        for (line, text) in [(9, "0 2 3"), (9, "1 2 4"), (9, "0 5 4"), (10, "0 1 0 2"), (10, "0 1 0 -1"), (13, "7")] {
            assert_eq!(with(line, text).0, line, "{text}");
        }
        // Fewer contacts than the matrix has, and numbers left over.
        assert_eq!(with(2, "1").0, 4);
        assert_eq!(with(2, "18446744073709551615").0, 4);
        assert_eq!(
            with(20, "0.5 0.75 1 2"),
            (
                20,
                "2 more numbers than the counts of the file ask for begin here; a \
            single flag may follow the coefficients"
                    .to_owned()
            )
        );
        // A block given twice: the columns of the second row are 0 and 0.
        let (line, fault) = with(10, "0 1 0 0");
        assert!(line == 18 && fault.contains("twice"), "line {line}: {fault}");
    }

    #[test]
    fn numbers_that_are_none_are_named_with_their_line() {
        for (line, from, to) in [(12, "0.25 0.25", "NaN 0.25"), (19, "-2 0", "-2 inf"), (20, "0.75", "nan")] {
            let (found, fault) = refusal(&BLOCKS.replace(from, to));
            assert!(found == line && fault.contains("not a finite number"), "line {found}: {fault}");
        }
        assert_eq!(refusal(&BLOCKS.replace("-2 0", "-2 0,5")).0, 19);
        let (line, fault) = refusal(&BLOCKS.replace("0.75", "-0.75"));
        assert!(line == 20 && fault.contains("contact 1 must be at least 0, found -0.75"), "line {line}: {fault}");
    }

    #[test]
    fn a_matrix_that_is_not_symmetric_is_named_with_the_line_of_its_entry() {
        let (line, fault) = refusal(&BLOCKS.replace("1 0.25 0.25 1", "1 0.25 0.5 1"));
        assert!(line == 12 && fault.contains("symmetric"), "line {line}: {fault}");
        let (line, fault) = refusal(&BLOCKS.replace("0.5 0 0.125 0.5", "0.5 0 -0.125 0.5"));
        assert!((line == 14 || line == 16) && fault.contains("symmetric"), "line {line}: {fault}");
        let (line, fault) = refusal(&BLOCKS.replace("1 0 0 1\n-1", "1 0 0 -1\n-1"));
        assert!(line == 18 && fault.contains("semidefinite"), "line {line}: {fault}");
    }
}
