//! Comparing trajectories.

use polhode_scene::output::COLUMNS;
use polhode_scene::{CompareError, Comparison, Tolerance, compare};
use tempfile::TempDir;

const ROW_A: &str = "0.0,a,1.0,2.0,3.0,0.6,0.8,0.0,0.0,1.0,0.0,0.0,0.0,0.0,0.0";
const ROW_B: &str = "0.5,\"b, c\",1.0,2.0,3.0,1.0,0.0,0.0,0.0,1e6,0.0,0.0,0.0,0.0,0.0";

fn file(folder: &TempDir, name: &str, rows: &[&str]) -> std::path::PathBuf {
    let path = folder.path().join(name);
    let mut text = format!("{}\n", COLUMNS.join(","));
    for row in rows {
        text.push_str(row);
        text.push('\n');
    }
    std::fs::write(&path, text).unwrap();
    path
}

fn compare_rows(a: &[&str], b: &[&str], absolute: f64, relative: f64) -> Result<Comparison, CompareError> {
    let folder = tempfile::tempdir().unwrap();
    let (a, b) = (file(&folder, "a.csv", a), file(&folder, "b.csv", b));
    compare(&a, &b, Tolerance { absolute, relative })
}

/// A trajectory agrees with itself, and with the same rotations written by opposite quaternions.
#[test]
fn equal() {
    let same = compare_rows(&[ROW_A, ROW_B], &[ROW_A, ROW_B], 0.0, 0.0).unwrap();
    assert!(same.agrees());
    assert_eq!(same.rows, 2);
    let opposite = ROW_A.replace("0.6,0.8", "-0.6,-0.8");
    assert!(compare_rows(&[ROW_A], &[&opposite], 0.0, 0.0).unwrap().agrees());
}

/// The largest difference of each column is found, with its place; the tolerance is absolute plus relative.
#[test]
fn differences() {
    let moved = ROW_B.replace("1e6", "1000001.0").replace("3.0", "3.25");
    let comparison = compare_rows(&[ROW_A, ROW_B], &[ROW_A, &moved], 0.0, 0.0).unwrap();
    assert!(!comparison.agrees());
    let column = |name: &str| comparison.columns.iter().find(|column| column.column == name).unwrap();
    assert_eq!((column("pz").largest, column("pz").beyond), (0.25, 1));
    assert_eq!(column("vx").largest, 1.0);
    let at = column("vx").at.clone().unwrap();
    assert_eq!((at.t.as_str(), at.body.as_str(), at.a, at.b), ("0.5", "b, c", 1e6, 1_000_001.0));
    assert_eq!((column("px").largest, column("px").at.clone()), (0.0, None));
    assert!(compare_rows(&[ROW_B], &[&moved], 1.0, 0.0).unwrap().agrees());
    assert!(compare_rows(&[ROW_B], &[&moved], 0.25, 1e-6).unwrap().agrees());
    assert!(!compare_rows(&[ROW_B], &[&moved], 0.25, 1e-7).unwrap().agrees());
}

/// What is not a number differs from everything, whatever the tolerance.
#[test]
fn not_a_number() {
    let nan = ROW_A.replace("3.0", "NaN");
    assert!(!compare_rows(&[ROW_A], &[&nan], 1e9, 1.0).unwrap().agrees());
    assert!(!compare_rows(&[&nan], &[&nan], f64::INFINITY, 0.0).unwrap().agrees());
}

/// Other bodies, other times (by text) and other lengths are a mismatch.
#[test]
fn mismatches() {
    for other in
        [&[ROW_A.replace("0.0,a", "0.00,a")][..], &[ROW_A.replace(",a,", ",b,")], &[], &[ROW_A.into(), ROW_B.into()]]
    {
        let other: Vec<_> = other.iter().map(String::as_str).collect();
        let comparison = compare_rows(&[ROW_A], &other, 1e9, 0.0).unwrap();
        assert!(comparison.mismatch.is_some() && !comparison.agrees(), "{other:?}");
    }
}

/// Files that are no trajectories are refused with their line; a line without end is no way to fill the memory.
#[test]
fn content() {
    let line = |row: &str| match compare_rows(&[ROW_A, row], &[ROW_A, ROW_B], 0.0, 0.0) {
        Err(CompareError::Content { line, .. }) => line,
        other => panic!("{row}: {other:?}"),
    };
    assert_eq!(line("1,2,3"), 3);
    assert_eq!(line(&ROW_B.replace("1e6", "fast")), 3);
    line(&ROW_B.replace("\"b, c\"", "\"b, c"));
    line(&"9".repeat(1 << 20));
    let folder = tempfile::tempdir().unwrap();
    let good = file(&folder, "good.csv", &[]);
    let bad = folder.path().join("bad.csv");
    for content in [&b""[..], b"hello\n", b"\xff\xfe\n"] {
        std::fs::write(&bad, content).unwrap();
        assert!(matches!(compare(&good, &bad, Tolerance::default()), Err(CompareError::Content { line: 1, .. })));
    }
    let missing = folder.path().join("missing.csv");
    assert!(matches!(compare(&good, &missing, Tolerance::default()), Err(CompareError::Read { .. })));
    let tolerance = Tolerance { absolute: f64::NAN, relative: 0.0 };
    assert!(matches!(compare(&good, &good, tolerance), Err(CompareError::Tolerance(_))));
}
