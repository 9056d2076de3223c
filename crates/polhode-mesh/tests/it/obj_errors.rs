//! The OBJ reader refuses what it cannot read, with the line and the word.

use polhode_mesh::{Place, ReadError, ReadErrorKind, obj};
use proptest::prelude::*;

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn error(text: impl AsRef<[u8]>) -> ReadError {
    obj::read(text.as_ref()).unwrap_err()
}

/// The error of a line that follows the four vertices of a square, as a person sees it.
fn message(line: &str) -> String {
    let error = error(format!("{SQUARE}{line}\nf 1 2 3\nf 1 2 bad later\n"));
    error.to_string()
}

#[test]
fn messages_name_the_line_and_the_word() {
    assert_eq!(message("v 0 0 zero"), "line 5: 'zero' is not a number");
    assert_eq!(message("v 0 1,5 0"), "line 5: '1,5' is not a number");
    assert_eq!(message("v 0 nan 0"), "line 5: 'nan' is not a finite number");
    assert_eq!(message("v -inf 0 0"), "line 5: '-inf' is not a finite number");
    assert_eq!(message("v 0 0 1e999"), "line 5: '1e999' is not a finite number");
    assert_eq!(message("v 0 0 \\\n \\\n x"), "line 7: 'x' is not a number");
    assert_eq!(message("f 1 2"), "line 5: a face needs at least 3 vertices, found 2");
    // Known only at the end of the file, because the vertex might come later.
    let dangling = error(format!("{SQUARE}f 1 2 9/1\nf 1 2 3\n"));
    assert_eq!(dangling.to_string(), "line 5: '9/1' names a vertex that does not exist: the file has 4 vertices");
    assert_eq!(message("f 1 2 -5"), "line 5: '-5' counts back beyond the first vertex: 4 vertices come before it");
    assert!(message("v 1 2").ends_with("found 2 numbers"));
    assert!(message("v 1 2 3 4 5 6 7 8").ends_with("found 8 numbers"));
    assert!(message("curv2 1 2").starts_with("line 5: 'curv2' is no statement"));
}

#[test]
fn corners_of_no_form() {
    for corner in [
        "0",
        "1.5",
        "a",
        "1/",
        "1/2/",
        "//",
        "1//",
        "/1",
        "1/2/3/4",
        "1/x",
        "1/0",
        "99999999999999999999",
        "1e0",
        "\u{e9}",
    ] {
        let found = error(format!("{SQUARE}f 1 2 {corner}\n"));
        assert_eq!(found, ReadError { place: Place::Line(5), kind: ReadErrorKind::BadCorner(corner.into()) });
    }
    for corner in ["5000000000", "9223372036854775807", "-9223372036854775808"] {
        let found = error(format!("{SQUARE}f 1 2 {corner}\n"));
        assert!(
            matches!(found.kind, ReadErrorKind::NoSuchVertex { .. } | ReadErrorKind::NoEarlierVertex { .. }),
            "{found}"
        );
    }
}

/// Of several corners that name vertices never defined, the first in the file is reported.
#[test]
fn the_first_dangling_corner_is_reported() {
    let found = error("f 2 3 4\nf 1 2 5\nf 1 2 9\nf 1 7 3\nv 0 0 0\nv 0 0 1\nv 0 1 0\nv 1 0 0\n");
    assert_eq!(
        found,
        ReadError { place: Place::Line(2), kind: ReadErrorKind::NoSuchVertex { token: "5".into(), vertices: 4 } }
    );
}

#[test]
fn a_file_without_faces_is_empty() {
    assert_eq!(error(""), ReadError { place: Place::Line(1), kind: ReadErrorKind::Empty { vertices: 0 } });
    assert_eq!(error("# nothing\n\n"), ReadError { place: Place::Line(3), kind: ReadErrorKind::Empty { vertices: 0 } });
    assert_eq!(error(SQUARE).to_string(), "line 5: the file has no faces (4 vertices)");
}

/// Long and binary words are shortened and made visible.
#[test]
fn words_are_shortened() {
    let long = error(format!("v 0 0 {}\n", "9x".repeat(1_000_000)));
    assert_eq!(long.to_string(), format!("line 1: '{}...' is not a number", "9x".repeat(20)));
    let binary = error(b"v 0 0 \x00\xFF\x1B[31m\n");
    assert_eq!(binary.to_string(), "line 1: '\u{FFFD}\u{FFFD}\u{FFFD}[31m' is not a number");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    /// Any bytes at all: a mesh or an error, whose line exists.
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        if let Err(error) = obj::read(&bytes) {
            prop_assert!(matches!(error.place, Place::Line(line) if line >= 1 && line <= bytes.len() + 1));
            prop_assert!(error.to_string().len() < 400);
        }
    }

    /// Words of the format in any order: a mesh or an error, and the same when the lines end otherwise.
    #[test]
    fn any_words(words in prop::collection::vec(
        prop::sample::select(vec![
            "v", "f", "1", "2", "-1", "1/1", "\n", "\n", "\\\n", "0.5", "1e400", "#", "vt", "g", "x",
        ]),
        0..60,
    )) {
        let text = words.join(" ");
        prop_assert_eq!(obj::read(text.as_bytes()), obj::read(text.replace('\n', "\r\n").as_bytes()));
    }

    /// The error of a bad line does not depend on what follows it.
    #[test]
    fn the_first_bad_line_decides(tail in "[ -~\n]{0,200}") {
        let text = format!("{SQUARE}v 0 0 bad\n{tail}");
        prop_assert_eq!(error(text), ReadError { place: Place::Line(5), kind: ReadErrorKind::BadNumber("bad".into()) });
    }
}
