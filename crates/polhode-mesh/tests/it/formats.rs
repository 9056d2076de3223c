//! Every format reads what it should, and what is written reads back as it was, bit by bit.

use crate::shapes::{L_SHAPE, icosphere, mesh};
use polhode_mesh::{Encoding, MeshFormat, TriangleMesh, WriteError, diagnose, format, off, ply, stl};
use polhode_spatial::DVec3;
use proptest::prelude::*;
use std::path::Path;

/// All ways to write a mesh that keep every bit.
const EXACT: [(MeshFormat, Encoding); 5] = [
    (MeshFormat::Obj, Encoding::Text),
    (MeshFormat::Off, Encoding::Text),
    (MeshFormat::Ply, Encoding::Text),
    (MeshFormat::Ply, Encoding::Binary),
    (MeshFormat::Stl, Encoding::Text),
];

/// The corners of all triangles, as bits.
fn corner_bits(mesh: &TriangleMesh) -> Vec<[[u64; 3]; 3]> {
    mesh.corner_positions().map(|corners| corners.map(|v| v.to_array().map(f64::to_bits))).collect()
}

fn written(mesh: &TriangleMesh, format: MeshFormat, encoding: Encoding) -> Vec<u8> {
    format::write(mesh, format, encoding).unwrap()
}

#[test]
fn what_is_written_reads_back() {
    for original in [mesh(L_SHAPE), icosphere(2)] {
        for (format, encoding) in EXACT {
            let bytes = written(&original, format, encoding);
            assert_eq!(MeshFormat::of_content(&bytes), Some(format));
            let read = format::read_any(&bytes).unwrap();
            assert_eq!(corner_bits(&read), corner_bits(&original), "{format}");
            // An STL has corners only: that the surface is closed again shows that they were merged.
            assert_eq!(diagnose(&read).defects, []);
            assert_eq!(read.vertices().len(), original.vertices().len());
        }
        let rounded = stl::read(&stl::write_binary(&original).unwrap()).unwrap();
        for (found, expected) in rounded.corner_positions().flatten().zip(original.corner_positions().flatten()) {
            assert_eq!(found, expected.as_vec3().as_dvec3());
        }
        assert_eq!(diagnose(&rounded).defects, []);
    }
}

#[test]
fn what_cannot_be_written() {
    let huge = TriangleMesh::new(vec![DVec3::ZERO, DVec3::X * 1e39, DVec3::Y], vec![[0, 1, 2]]).unwrap();
    let error = stl::write_binary(&huge).unwrap_err();
    assert!(matches!(error, WriteError::BeyondF32 { vertex: 1, .. }));
    assert!(error.to_string().contains("vertex 1 is (1000000000"), "{error}");
    assert_eq!(format::write(&huge, MeshFormat::Off, Encoding::Binary), Err(WriteError::NoBinary(MeshFormat::Off)));
}

#[test]
fn formats_by_name_and_content() {
    for (name, format) in [
        ("a.obj", Some(MeshFormat::Obj)),
        ("b.STL", Some(MeshFormat::Stl)),
        ("c.d.off", Some(MeshFormat::Off)),
        ("e/f.Ply", Some(MeshFormat::Ply)),
        ("g.step", None),
        ("obj", None),
    ] {
        assert_eq!(MeshFormat::of_path(Path::new(name)), format, "{name}");
    }
    for (content, format) in [
        (&b"# x\n\nmtllib a\n"[..], Some(MeshFormat::Obj)),
        (b"v 0 0 0", Some(MeshFormat::Obj)),
        (b" SOLID\n", Some(MeshFormat::Stl)),
        (b"STCNOFF 1 2 3", Some(MeshFormat::Off)),
        (b"ply\r\n", Some(MeshFormat::Ply)),
        (b"plywood", None),
        (b"\x00\x01", None),
        (b"", None),
    ] {
        assert_eq!(MeshFormat::of_content(content), format);
    }
    assert!(format::read_any(b"letter").unwrap_err().to_string().contains("none of OBJ, STL, OFF, PLY"));
}

/// Many programs begin binary files with the word that text files begin with.
#[test]
fn a_binary_stl_that_begins_with_solid_is_binary() {
    let original = mesh(L_SHAPE);
    let mut bytes = stl::write_binary(&original).unwrap();
    let plain = stl::read(&bytes).unwrap();
    for name in [&b"solid"[..], b"solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", &[b'x'; 80]] {
        bytes[..name.len()].copy_from_slice(name);
        assert_eq!(stl::read(&bytes).unwrap(), plain);
    }
}

/// Keywords in any case, DOS lines, names with odd characters, several solids, normals that are not numbers.
#[test]
fn stl_text_as_real_programs_write_it() {
    let facet = |z: u8| {
        format!(
            "  FACET NORMAL nan 0 1\n OUTER LOOP\nVertex 0 0 {z}\nvertex 1 -0.0 {z}\nvertex 0 1e0 {z}\nEndLoop\n\
             endfacet\n"
        )
    };
    let text = format!(
        "\u{feff}solid C:\\parts\\\n{}{}endsolid C:\\parts\\\n\nSolid #2\n{}EndSolid",
        facet(0),
        facet(1),
        facet(0)
    );
    let read = stl::read(text.as_bytes()).unwrap();
    assert_eq!((read.vertices().len(), read.triangles().len()), (6, 3));
    assert_eq!(read.triangles()[0], read.triangles()[2]);
    assert_eq!(read, stl::read(text.replace('\n', "\r\n").as_bytes()).unwrap());
}

#[test]
fn off_in_its_variants() {
    let plain = off::read(b"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n").unwrap();
    assert_eq!(plain.triangles(), [[0, 1, 2], [0, 2, 3]]);
    for variant in [
        "OFF 4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3",
        "# a square\nOFF # header\n\n4 1\n# first\n0 0 0 # origin\n1 0 0\n1 1 0\n\n0 1 0\n4 0 1 2 3 255 0 0\n# end\n",
        "COFF\n4 1 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n4 0 1 2 3 0.5 0.5 0.5 1\n",
        "NOFF\n4 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3\n",
        "STCNOFF\r\n4 1 0\r\n0 0 0 0 0\r\n1 0 0 0 0\r\n1 1 0 0 0\r\n0 1 0 0 0\r\n4 0 1 2 3\r\n",
    ] {
        assert_eq!(off::read(variant.as_bytes()).unwrap(), plain, "{variant}");
    }
}

/// A square as a PLY file with every kind of thing around it that is to be passed over.
fn ply_header(encoding: &str, end: &str) -> String {
    [
        "ply",
        &format!("format {encoding} 1.0"),
        "comment made by hand",
        "obj_info nothing",
        "element camera 2",
        "property list ushort double view",
        "property char kind",
        "element face 1",
        "property uchar red",
        "property list uchar short vertex_index",
        "property list int float texcoord",
        "element vertex 4",
        "property double confidence",
        "property float y",
        "property uint x",
        "property int8 z",
        "property list uint8 int32 neighbours",
        "element empty 4000000000000000000",
        "end_header",
        "",
    ]
    .join(end)
}

#[test]
fn ply_text_with_extras() {
    for end in ["\n", "\r\n", "\r"] {
        let rows =
            ["1 0.5 7", "0 1", "9 4 0 1 2 3 2 0.5 1e3", "0 0 0 0 0", "1 0 1 0 1 5", "0 1 1 0 0", "nan 1 0 0 0", ""];
        let text = ply_header("ascii", end) + &rows.join(end);
        let read = ply::read(text.as_bytes()).unwrap();
        assert_eq!(read.vertices(), [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y]);
        assert_eq!(read.triangles(), [[0, 1, 2], [0, 2, 3]]);
    }
}

/// Numbers of the binary body of [`ply_header`] in one byte order.
fn ply_body(to_bytes: &dyn Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut body = Vec::new();
    let mut put = |little_endian: &[u8]| body.extend(to_bytes(little_endian));
    put(&1u16.to_le_bytes());
    put(&0.5f64.to_le_bytes());
    put(&[7]);
    put(&0u16.to_le_bytes());
    put(&[0]);
    // The face.
    put(&[9]);
    put(&[4]);
    for index in 0..4i16 {
        put(&index.to_le_bytes());
    }
    put(&1i32.to_le_bytes());
    put(&2.5f32.to_le_bytes());
    for (x, y) in [(0u32, 0.0f32), (1, 0.0), (1, 1.0), (0, 1.0)] {
        put(&f64::NAN.to_le_bytes());
        put(&y.to_le_bytes());
        put(&x.to_le_bytes());
        put(&[-3i8 as u8]);
        put(&[1]);
        put(&77i32.to_le_bytes());
    }
    body
}

#[test]
fn ply_binary_of_both_byte_orders() {
    let read = |name: &str, end: &str, to_bytes: &dyn Fn(&[u8]) -> Vec<u8>| {
        let bytes = [ply_header(name, end).into_bytes(), ply_body(to_bytes)].concat();
        ply::read(&bytes).unwrap()
    };
    let little = read("binary_little_endian", "\n", &<[u8]>::to_vec);
    let big = read("binary_big_endian", "\r\n", &|bytes| bytes.iter().rev().copied().collect());
    assert_eq!(little, big);
    assert_eq!(little.vertices()[2], DVec3::new(1.0, 1.0, -3.0));
    assert_eq!(little.triangles(), [[0, 1, 2], [0, 2, 3]]);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(64) })]

    /// Any coordinates and any triangles, in every exact encoding: the corners have the same bits.
    #[test]
    fn round_trip(
        points in prop::collection::vec(
            prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL),
            3..40,
        ),
        picks in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 1..40),
    ) {
        let vertices: Vec<DVec3> = points.iter().map(|&p| DVec3::from_array(p)).collect();
        let triangles = picks.iter().map(|t| t.map(|i| i.index(vertices.len()) as u32)).collect();
        let original = TriangleMesh::new(vertices, triangles).unwrap();
        for (format, encoding) in EXACT {
            let read = format::read(&written(&original, format, encoding), format).unwrap();
            prop_assert_eq!(corner_bits(&read), corner_bits(&original));
            if format != MeshFormat::Stl {
                prop_assert_eq!(&read, &original);
            }
        }
    }
}
