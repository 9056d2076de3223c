//! Bad files of every format: a typed error that names the place, never a panic, never memory by a false count.

use crate::shapes::{PYRAMID, mesh};
use polhode_mesh::{Encoding, MeshFormat, Place, ReadError, ReadErrorKind, format, off, ply, stl};
use proptest::prelude::*;
use std::fmt::Write;

/// A small file of each kind.
fn samples() -> Vec<(MeshFormat, Vec<u8>)> {
    let pyramid = mesh(PYRAMID);
    let mut samples: Vec<_> = [
        (MeshFormat::Obj, Encoding::Text),
        (MeshFormat::Off, Encoding::Text),
        (MeshFormat::Ply, Encoding::Text),
        (MeshFormat::Ply, Encoding::Binary),
        (MeshFormat::Stl, Encoding::Text),
        (MeshFormat::Stl, Encoding::Binary),
    ]
    .map(|(format, encoding)| (format, format::write(&pyramid, format, encoding).unwrap()))
    .into();
    let big =
        b"ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
    let mut big = big.to_vec();
    for number in [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        big.extend(number.to_be_bytes());
    }
    big.extend([3, 0, 1, 2]);
    samples.push((MeshFormat::Ply, big));
    samples
}

#[track_caller]
fn message(result: Result<polhode_mesh::TriangleMesh, ReadError>) -> String {
    result.unwrap_err().to_string()
}

/// Cut anywhere, a file is refused; only within its last line may text still make sense.
#[test]
fn truncated_at_every_byte() {
    for (format, bytes) in samples() {
        let text_end = bytes.trim_ascii_end().iter().rposition(|&byte| byte == b'\n').unwrap_or(0);
        let is_binary = bytes.contains(&0);
        for length in 0..bytes.len() {
            match format::read(&bytes[..length], format) {
                Err(error) => assert!(error.to_string().len() < 400),
                Ok(_) => {
                    assert!(!is_binary && (length > text_end || format == MeshFormat::Obj), "{format} at {length}");
                }
            }
        }
    }
}

#[test]
fn false_counts() {
    let off = "OFF\n3 1000000000 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    assert_eq!(
        message(off::read(off.as_bytes())),
        "line 7: the file ends after 1 of 1000000000 faces: it is cut off, or its header is wrong"
    );
    assert!(message(off::read(b"OFF\n1000000000 1 0\n0 0 0\n")).contains("after 1 of 1000000000 vertices"));
    assert!(
        message(off::read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"))
            .contains("after 3 of 4000000000 corners")
    );
    assert!(
        message(off::read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"))
            .starts_with("line 7: the file goes on after the 1 faces")
    );
    assert!(message(off::read(b"OFF\n3 -1 0\n")).starts_with("line 2: '-1' is not a count"));

    let mut binary = stl::write_binary(&mesh(PYRAMID)).unwrap();
    let length = binary.len();
    binary[80..84].copy_from_slice(&1_000_000_000u32.to_le_bytes());
    let expected =
        format!("byte {length}: the file ends after 6 of 1000000000 triangles: it is cut off, or its header is wrong");
    assert_eq!(message(stl::read(&binary)), expected);
    binary[80..84].copy_from_slice(&5u32.to_le_bytes());
    assert!(message(stl::read(&binary)).starts_with("byte 334: the file goes on after the 5 triangles"));

    let header = |vertices: u64, faces: u64| {
        format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
             property float z\n\
             element face {faces}\nproperty list uint int vertex_indices\nend_header\n"
        )
        .into_bytes()
    };
    let claim = [header(3, 1_000_000_000), vec![0; 36]].concat();
    assert!(message(ply::read(&claim)).contains("after 0 of 1000000000 rows of element face"));
    assert!(
        message(ply::read(&header(u64::MAX >> 1, 1))).contains("after 0 of 9223372036854775807 rows of element vertex")
    );
    let long_list = [header(3, 1), vec![0; 36], vec![0xFF; 4]].concat();
    assert!(message(ply::read(&long_list)).contains("after 0 of 1 rows of element face"));
    let trailing = [header(3, 1), vec![0; 36], vec![3, 0, 0, 0], vec![0; 12], vec![1]].concat();
    assert!(message(ply::read(&trailing)).contains("goes on after the 1 rows of element face"));
}

#[test]
fn numbers_that_are_none() {
    assert_eq!(message(off::read(b"OFF\n3 1 0\n0 0 nan\n")), "line 3: 'nan' is not a finite number");
    assert_eq!(message(off::read(b"OFF\n3 1 0\n0 0 O\n")), "line 3: 'O' is not a number");
    assert_eq!(
        message(off::read(b"OFF\n3 1 0\n0 0\n")),
        "line 3: the line of a vertex begins with its 3 coordinates, found 2 numbers"
    );
    assert_eq!(
        message(off::read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
        "line 6: a face names vertex 3, but the file has 3 vertices, counted from 0"
    );
    assert_eq!(
        message(off::read(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n")),
        "line 6: a face needs at least 3 vertices, found 2"
    );
    let mut binary = stl::write_binary(&mesh(PYRAMID)).unwrap();
    binary[84 + 50 + 12 + 4..][..4].copy_from_slice(&f32::INFINITY.to_le_bytes());
    assert_eq!(message(stl::read(&binary)), "byte 150: 'inf' is not a finite number");
    let text = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1e999 0\n";
    assert_eq!(message(stl::read(text.as_bytes())), "line 5: '1e999' is not a finite number");
    let four = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 1 0\nvertex 1 0 0\n";
    assert_eq!(
        message(stl::read(four.as_bytes())),
        "line 7: expected 'endloop' (a facet has three vertices), found 'vertex'"
    );
}

#[test]
fn headers_that_are_wrong() {
    let ply = |lines: &str| message(ply::read(format!("ply\n{lines}").as_bytes()));
    assert_eq!(message(ply::read(b"PLY\n")), "line 1: expected 'ply' in a line of its own, found 'PLY'");
    assert!(ply("format ascii 2.0\n").starts_with("line 2: expected format ascii, binary"));
    assert!(ply("property float x\n").contains("an element before its properties"));
    assert!(ply("element vertex many\n").starts_with("line 2: 'many' is not a count"));
    assert!(ply("element vertex 1\nelement vertex 1\n").contains("element vertex twice"));
    assert!(ply("element face 1\nproperty list float int vertex_indices\n").contains("integer types"));
    assert!(
        ply("element face 1\nproperty list int int vertex_indices\nproperty list int int vertex_index\n")
            .contains("twice")
    );
    assert!(ply("element vertex 1\nproperty real x\n").contains("found 'property real x'"));
    assert!(ply("element vertex 1").contains("the file ends where 'end_header' must follow"));
    assert!(ply("end_header\n").contains("no line that begins with 'format'"));
    assert!(ply("format ascii 1.0\nend_header\n").contains("no element vertex"));
    assert!(
        ply("format ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\nend_header\n")
            .contains("line 3: the header has no property z")
    );
    let row = "format ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nproperty int z\nelement face 0\n\
        property list int int vertex_index\nend_header\n";
    assert!(ply(&format!("{row}0 0\n")).starts_with("line 10: the file ends after 0 of 1 rows"));
    assert!(ply(&format!("{row}0 0 0 0\n")).starts_with("line 10: expected the end of the line"));
    assert!(ply(&format!("{row}0 0 0\n")).contains("no faces (1 vertices)"));
    assert!(message(off::read(b"4OFF\n")).contains("not read: write it as OFF"));
    assert!(message(off::read(b"OFF BINARY\n")).contains("not read: write it as text"));
    assert!(message(off::read(b"")).contains("the file ends where 'OFF' must follow"));
    assert!(message(stl::read(b"")).contains("84 bytes"));
    assert!(message(stl::read(b"solid a\nendsolid a\nfacet")).starts_with("line 3: expected 'solid'"));
}

/// Ears are clipped in time that grows as the square, so there is a largest number of them.
#[test]
fn a_face_too_large_to_clip_is_refused() {
    let n = 20_000;
    let mut text = format!("OFF\n{n} 1 0\n");
    for i in 0..n {
        // A comb: not convex anywhere.
        writeln!(text, "{i} {} 0", if i == 0 || i == n - 1 { "-5" } else { ["0", "1"][i % 2] }).unwrap();
    }
    write!(text, "{n}").unwrap();
    for i in 0..n {
        write!(text, " {i}").unwrap();
    }
    let error = off::read(text.as_bytes()).unwrap_err();
    assert!(matches!(error.kind, ReadErrorKind::LargeFace { corners: 20_000, .. }));
    assert_eq!(error.place, Place::Line(n + 3));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(512) })]

    /// Any bytes at all, in every format.
    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        for format in MeshFormat::ALL {
            if let Err(error) = format::read(&bytes, format) {
                prop_assert!(error.to_string().len() < 600);
            }
        }
        let _ = format::read_any(&bytes);
    }

    /// Sound files with a few bytes changed, put in or left out: a mesh or an error.
    #[test]
    fn mutated_files(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0..4u8), 1..6),
        which in 0usize..7,
    ) {
        let (format, mut bytes) = samples().swap_remove(which);
        for (place, value, kind) in changes {
            let at = place.index(bytes.len());
            match kind {
                0 => bytes[at] = value,
                1 => bytes.insert(at, value),
                2 => drop(bytes.remove(at)),
                _ => bytes[at] ^= 1 << (value % 8),
            }
        }
        let _ = format::read(&bytes, format);
    }
}

/// A header of very many elements, or of one with very many properties, is read in the time of its bytes; names that
/// come twice and a second format are refused.
#[test]
fn long_ply_headers() {
    let elements: String = (0..50_000).map(|k| format!("element e{k} 0\n")).collect::<Vec<_>>().concat();
    let properties: String = (0..50_000).map(|k| format!("property float p{k}\n")).collect::<Vec<_>>().concat();
    for (header, expected) in [
        (format!("{elements}element e7 0\n"), "element e7"),
        (format!("element vertex 0\n{properties}property float p7\n"), "property p7"),
        ("format binary_little_endian 1.0\n".to_owned(), "format"),
    ] {
        let file = format!("ply\nformat ascii 1.0\n{header}end_header\n");
        let error = format::read(file.as_bytes(), MeshFormat::Ply).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}
