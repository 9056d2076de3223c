//! Every repair mends what it is for and leaves the rest alone.

use crate::shapes::{L_SHAPE, assert_relative, icosphere, joined, mesh, torus};
use polhode_mesh::{
    DefectKind, Diagnosis, MeshError, Repair, RepairOptions, RepairReport, SolidMesh, TriangleMesh, box_mesh, diagnose,
    repair, weld,
};
use polhode_spatial::DVec3;
use proptest::prelude::*;

fn cube() -> TriangleMesh {
    box_mesh(DVec3::splat(2.0)).unwrap().into_mesh()
}

/// Repair that may fill any hole.
fn mended(mesh: &TriangleMesh) -> (TriangleMesh, RepairReport) {
    repair(mesh, &RepairOptions { largest_hole: 1.0, ..RepairOptions::default() }).unwrap()
}

fn steps(report: &RepairReport) -> Vec<(Repair, usize)> {
    report.steps.iter().map(|step| (step.repair, step.count)).collect()
}

/// The mesh with its triangles replaced.
fn with_triangles(mesh: &TriangleMesh, f: impl FnOnce(&mut Vec<[u32; 3]>)) -> TriangleMesh {
    let mut triangles = mesh.triangles().to_vec();
    f(&mut triangles);
    TriangleMesh::new(mesh.vertices().to_vec(), triangles).unwrap()
}

/// Every triangle with corners of its own, as in an STL file without merging.
fn soup(mesh: &TriangleMesh) -> TriangleMesh {
    let vertices: Vec<DVec3> = mesh.corner_positions().flatten().collect();
    let triangles = (0..mesh.triangles().len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    TriangleMesh::new(vertices, triangles).unwrap()
}

#[test]
fn a_sound_mesh_stays_as_it_is() {
    let hollow = joined(&[&icosphere(1), &icosphere(1).scaled(0.5).unwrap().flipped()]);
    for sound in [cube(), mesh(L_SHAPE), torus(16, 8), hollow] {
        let (same, report) = mended(&sound);
        assert_eq!(same, sound);
        assert_eq!((report.steps.len(), report.volume_after), (0, report.volume_before));
        assert!(report.volume_before.is_some());
    }
}

/// Two cubes that touch along an edge are a solid as long as that edge is there twice; welding would make it one of
/// four triangles, and so is not done.
#[test]
fn welding_that_does_harm_is_left() {
    let touching = joined(&[&cube(), &cube().translated(DVec3::new(2.0, 2.0, 0.0)).unwrap()]);
    assert!(diagnose(&touching).get(DefectKind::DuplicateVertex).is_some());
    let (same, report) = mended(&touching);
    assert_eq!((same, report.steps.len()), (touching, 0));
}

#[test]
fn welding_closes_a_soup_of_triangles() {
    let ball = icosphere(2);
    let (whole, report) = mended(&soup(&ball));
    assert_eq!(steps(&report), [(Repair::Weld, 3 * 320 - 162)]);
    assert_eq!(report.volume_before, None);
    assert!(report.after.defects.is_empty());
    let volume = SolidMesh::new(ball).unwrap().volume_integrals().volume;
    assert_relative(report.volume_after.unwrap(), volume, 1e-15);
    assert_eq!(whole.vertices().len(), 162);
    assert_eq!(report.steps[0].to_string(), "weld: 798 vertices merged with earlier ones");
}

/// Corners that differ by less than the tolerance are merged, and those farther apart are not.
#[test]
fn the_tolerance_of_welding_is_kept() {
    let ball = icosphere(2);
    let shaken: Vec<DVec3> = soup(&ball)
        .vertices()
        .iter()
        .enumerate()
        .map(|(i, v)| *v + 3e-7 * DVec3::new((i % 7) as f64 - 3.0, (i % 5) as f64 - 2.0, (i % 3) as f64 - 1.0) / 6.5)
        .collect();
    let shaken = TriangleMesh::new(shaken, soup(&ball).triangles().to_vec()).unwrap();
    let merged = |tolerance: f64| weld(&shaken, tolerance).unwrap().merged;
    // The farthest two are |(6, 4, 2)| 3e-7 / 6.5 = 3.5e-7 apart.
    assert_eq!(merged(4e-7), 798);
    assert!(merged(1e-8) < 798);
    for tolerance in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(weld(&ball, tolerance), Err(MeshError::Tolerance(_))));
    }
    assert!(matches!(
        repair(&ball, &RepairOptions { largest_hole: 2.0, ..RepairOptions::default() }),
        Err(MeshError::HoleSize(2.0))
    ));
}

/// Triangles turned at random run the same way round again, and outward.
#[test]
fn flipping() {
    let ball = icosphere(2);
    let mixed = with_triangles(&ball, |triangles| triangles.iter_mut().step_by(3).for_each(|t| t.swap(0, 1)));
    let (whole, report) = mended(&mixed);
    assert_eq!(steps(&report), [(Repair::Flip, 107)]);
    assert!(report.after.is_solid());
    assert_eq!(whole.triangles().len(), 320);
    // Mostly turned: the majority is followed first and then found to face inward.
    let (whole, report) = mended(&mixed.flipped());
    assert_eq!(steps(&report), [(Repair::Flip, 107 + 320)]);
    assert!(SolidMesh::new(whole).is_ok());
}

/// Shells in shells alternate between material and void, however they run before.
#[test]
fn nested_shells_are_turned_alternately() {
    let shell = |radius: f64| icosphere(1).scaled(radius).unwrap();
    let nested = joined(&[&shell(1.0).flipped(), &shell(4.0).flipped(), &shell(3.0), &shell(2.0)]);
    let (whole, report) = mended(&nested);
    assert!(report.after.is_solid(), "{report:?}");
    let one = SolidMesh::new(shell(1.0)).unwrap().volume_integrals().volume;
    assert_relative(SolidMesh::new(whole).unwrap().volume_integrals().volume, one * (64.0 - 27.0 + 8.0 - 1.0), 1e-14);
}

/// A strip with one side only cannot be turned; it is left and said to be left.
#[test]
fn a_moebius_strip_is_left() {
    let (n, mut triangles) = (16u32, Vec::new());
    let mut vertices = Vec::new();
    for i in 0..n {
        let (angle, half) = (
            2.0 * std::f64::consts::PI * f64::from(i) / f64::from(n),
            std::f64::consts::PI * f64::from(i) / f64::from(n),
        );
        let out = DVec3::new(angle.cos(), angle.sin(), 0.0);
        let across = 0.3 * (out * half.cos() + DVec3::Z * half.sin());
        vertices.extend([out - across, out + across]);
        let (a, b) = (2 * i, 2 * i + 1);
        // The last quad joins the ends with a half turn.
        let (c, d) = if i + 1 == n { (1, 0) } else { (a + 2, b + 2) };
        triangles.extend([[a, b, d], [a, d, c]]);
    }
    let strip = TriangleMesh::new(vertices, triangles).unwrap();
    let (_, report) = repair(&strip, &RepairOptions { largest_hole: 0.0, ..RepairOptions::default() }).unwrap();
    assert!(report.steps.is_empty());
    assert!(report.after.get(DefectKind::InconsistentWinding).is_some());
}

/// A cube without a face, a ball without two pieces and one that lacks two triangles at a common vertex.
#[test]
fn filling_holes() {
    let open = with_triangles(&cube(), |triangles| drop(triangles.drain(0..2)));
    let (whole, report) = mended(&open);
    assert_eq!(steps(&report), [(Repair::FillHoles, 1)]);
    assert_relative(report.volume_after.unwrap(), 8.0, 1e-15);
    assert_eq!(whole.triangles().len(), 12);
    assert_eq!(report.steps[0].to_string(), "fill_holes: 1 holes filled (2 triangles added)");

    let ball = icosphere(3);
    let pole = |triangle: &[u32; 3]| ball.corners(*triangle).iter().map(|v| v.z).sum::<f64>() / 3.0;
    let open = with_triangles(&ball, |triangles| triangles.retain(|t| pole(t).abs() < 0.9));
    let (whole, report) = mended(&open);
    assert_eq!(
        steps(&report),
        [(Repair::FillHoles, 2), (Repair::DropUnused, diagnose(&open).get(DefectKind::UnusedVertex).unwrap().count)]
    );
    assert!(report.after.defects.is_empty());
    let (volume, full) = (SolidMesh::new(whole).unwrap().volume_integrals().volume, 4.0 / 3.0 * std::f64::consts::PI);
    // Two caps of height 0.1 are gone.
    let caps = 2.0 * std::f64::consts::PI * 0.01 * (1.0 - 0.1 / 3.0);
    assert!(volume < full && volume > full - 3.0 * caps, "{volume}");

    let (a, b) = touching_pair(&ball);
    let open = with_triangles(&ball, |triangles| {
        triangles.remove(a.max(b));
        triangles.remove(a.min(b));
    });
    let (whole, report) = mended(&open);
    assert_eq!(steps(&report), [(Repair::FillHoles, 2)]);
    assert_relative(report.volume_after.unwrap(), SolidMesh::new(ball).unwrap().volume_integrals().volume, 1e-15);
    assert!(diagnose(&whole).is_solid());
}

/// Two triangles that share one vertex and no more.
fn touching_pair(mesh: &TriangleMesh) -> (usize, usize) {
    let first = mesh.triangles()[0];
    let shared = |t: &[u32; 3]| t.iter().filter(|corner| first.contains(corner)).count();
    (0, mesh.triangles().iter().position(|t| shared(t) == 1).unwrap())
}

/// A hole larger than asked for stays open, and is counted as left.
#[test]
fn large_holes_stay() {
    let open = with_triangles(&cube(), |triangles| drop(triangles.drain(0..2)));
    let (same, report) = repair(&open, &RepairOptions { largest_hole: 0.5, ..RepairOptions::default() }).unwrap();
    assert_eq!((same, report.steps.len()), (open, 0));
    assert_eq!(report.after.get(DefectKind::OpenEdge).unwrap().count, 4);
}

/// A sheet is not a hole in anything: filling it would put a second sheet upon it.
#[test]
fn sheets_are_not_closed() {
    let square = mesh(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    // A soup whose corners are too far apart for the tolerance is many sheets.
    let apart = TriangleMesh::new(
        soup(&cube()).vertices().iter().enumerate().map(|(i, v)| *v * (1.0 + 1e-3 * (i / 3) as f64)).collect(),
        soup(&cube()).triangles().to_vec(),
    );
    for sheet in [square, apart.unwrap()] {
        let (same, report) = mended(&sheet);
        assert_eq!((same, report.steps.len()), (sheet, 0));
    }
}

/// Repeated triangles go, triangles that name a vertex twice go, and one on a line is swapped with its neighbour, which
/// changes neither volume nor area.
#[test]
fn duplicates_and_degenerate_triangles() {
    let untidy = with_triangles(&cube(), |triangles| {
        let [a, b, c] = triangles[3];
        triangles.extend([[b, c, a], [0, 0, 5], [c, a, b]]);
    });
    let diagnosis = diagnose(&untidy);
    let duplicate = diagnosis.get(DefectKind::DuplicateTriangle).unwrap();
    assert_eq!(duplicate.to_string(), "2 duplicate triangles, first: triangle 12, which repeats triangle 3");
    assert_eq!(duplicate.repair(), Some(Repair::DropDuplicates));
    let (whole, report) = mended(&untidy);
    assert_eq!(steps(&report), [(Repair::DropDuplicates, 2), (Repair::DropDegenerate, 1)]);
    assert_eq!(whole, cube());

    // The middle m of the edge 0-6 of triangles (0, 4, 6) and (0, 6, 2): the second keeps its edge and a triangle
    // without area fills the gap.
    let mut vertices = cube().vertices().to_vec();
    vertices.push(0.5 * (vertices[0] + vertices[6]));
    let mut triangles = cube().triangles().to_vec();
    triangles.splice(0..1, [[0, 4, 8], [8, 4, 6], [0, 8, 6]]);
    let thin = TriangleMesh::new(vertices, triangles).unwrap();
    assert_eq!(diagnose(&thin).get(DefectKind::DegenerateTriangle).unwrap().count, 1);
    let (whole, report) = mended(&thin);
    assert_eq!(steps(&report), [(Repair::DropDegenerate, 1)]);
    assert!(report.after.defects.is_empty(), "{:?}", report.after);
    assert_eq!(report.volume_after, Some(8.0));
    assert_eq!(whole.triangles().len(), 14);
}

#[test]
fn nothing_left_is_an_error() {
    let points = TriangleMesh::new(vec![DVec3::ZERO, DVec3::X], vec![[0, 0, 1]]).unwrap();
    assert_eq!(repair(&points, &RepairOptions::default()).unwrap_err(), MeshError::Empty);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(128) })]

    /// A closed mesh that is torn apart, shuffled, turned and has lost triangles is whole again; its volume is right to
    /// what the lost triangles could hold.
    #[test]
    fn torn_meshes_are_mended(
        lost in prop::collection::btree_set(0usize..320, 0..6),
        turned in prop::collection::vec(0usize..320, 0..40),
        tear in any::<bool>(),
    ) {
        let ball = icosphere(2);
        let broken = with_triangles(&ball, |triangles| {
            for &i in &turned {
                triangles[i].swap(1, 2);
            }
            for &i in lost.iter().rev() {
                triangles.remove(i);
            }
        });
        let broken = if tear { soup(&broken) } else { broken };
        let (whole, report) = mended(&broken);
        prop_assert!(report.after.is_solid(), "{:?}", report);
        let volume = SolidMesh::new(ball).unwrap().volume_integrals().volume;
        prop_assert!((SolidMesh::new(whole).unwrap().volume_integrals().volume / volume - 1.0).abs() < 0.05);
    }

    /// Whatever triangles are drawn among a few vertices, repair answers, and never leaves more faulty edges than it
    /// found.
    #[test]
    fn any_mesh_is_answered(
        points in prop::collection::vec((-2i8..3, -2i8..3, -2i8..3), 4..9),
        triangles in prop::collection::vec((0u32..4, 0u32..4, 0u32..4), 1..14),
    ) {
        let points = points.into_iter().map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into())).collect();
        let mesh = TriangleMesh::new(points, triangles.into_iter().map(|(a, b, c)| [a, b, c]).collect()).unwrap();
        if let Ok((_, report)) = repair(&mesh, &RepairOptions { largest_hole: 1.0, weld_tolerance: 0.5 }) {
            let kinds = [DefectKind::OpenEdge, DefectKind::NonManifoldEdge, DefectKind::InconsistentWinding];
            let faults = |diagnosis: &Diagnosis| -> usize {
                kinds.iter().filter_map(|&kind| diagnosis.get(kind)).map(|defect| defect.count).sum()
            };
            prop_assert!(faults(&report.after) <= faults(&report.before), "{:?}", report);
        }
    }

    /// Welding is a projection: what is welded has nothing left to weld at the same tolerance, and nothing moves.
    #[test]
    fn welding_twice_changes_nothing(
        points in prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), 3..60),
        tolerance in 0.0..0.5f64,
    ) {
        let points: Vec<DVec3> = points.into_iter().map(DVec3::from_array).collect();
        let mesh = TriangleMesh::new(points.clone(), vec![[0, 1, 2]]).unwrap();
        let once = weld(&mesh, tolerance).unwrap();
        prop_assert_eq!(weld(&once.mesh, tolerance).unwrap().merged, 0);
        prop_assert!(once.mesh.vertices().iter().all(|v| points.contains(v)));
        for v in &points {
            prop_assert!(once.mesh.vertices().iter().any(|kept| kept.distance(*v) <= tolerance));
        }
    }
}
