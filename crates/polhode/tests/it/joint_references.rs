//! Machines of links with reference values that were derived or computed elsewhere: a chain of four rods (the thesis's
//! Figure 5, hung and let go level; equations of Lagrange integrated in 80-bit numbers) and Bricard's loop of six
//! hinges, which is overconstrained and moves nevertheless (a quadrature).

use crate::checks::assert_closes;
use crate::support::{accurate, run};
use polhode::mesh::solid_box;
use polhode::scene::Joint;
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, UnitVector};
use polhode::{Body, BodyId, Effects, RunReport, Scene};

/// Joints do no work.
#[track_caller]
fn assert_held(report: &RunReport) {
    assert!(report.ledger.numerical.value().abs() < 1e-12 * report.ledger.scale_j, "{:?}", report.ledger);
    assert!(report.ledger.projection.value().abs() < 1e-12 * report.ledger.scale_j, "{:?}", report.ledger);
    assert_closes(report);
}

/// The angles of the rods from the vertical, after half a second, one and two.
#[test]
fn chain_of_four_rods_falls_as_the_equations_of_lagrange_say() {
    let rod = |number: usize| {
        // A thin rod of 1 kg and 1 m; its moment about itself does not count.
        let inertia = Inertia::from_diagonal(DVec3::new(0.01, 1.0 / 12.0, 1.0 / 12.0)).unwrap();
        let properties = MassProperties::new(Mass::new(1.0).unwrap(), DVec3::ZERO, inertia);
        Body::movable(format!("rod {number}"), properties)
            .pose(Pose::from_translation(DVec3::X * (number as f64 + 0.5)))
    };
    let references: [(f64, [f64; 4]); 3] = [
        (0.5, [0.720_398_257_457_362_2, 1.030_148_949_566_932, 1.600_398_104_793_214_5, 1.589_827_010_108_461]),
        (
            1.0,
            [-0.050_179_021_832_213_97, 0.111_060_686_202_674_09, -0.322_276_370_276_213_3, -0.840_803_531_278_181_9],
        ),
        (2.0, [-0.977_438_760_246_136, -1.890_821_413_181_754_2, -2.071_930_024_842_632_4, -0.932_302_303_444_466_5]),
    ];
    for (duration, angles) in references {
        let mut builder = Scene::builder("chain").method(accurate()).duration_s(duration);
        for number in 0..4_usize {
            let joint = Joint::hinge(BodyId::new(number), DVec3::X * number as f64, UnitVector::Y);
            builder =
                builder.body(rod(number)).joint(if number > 0 { joint.with(BodyId::new(number - 1)) } else { joint });
        }
        let (report, _) = run(&builder.build().unwrap(), Effects::Planned);
        for (polhode::ReportedBody { state: body, .. }, angle) in report.bodies.iter().zip(angles) {
            let along = body.pose.rotation.rotate(DVec3::X);
            let off = (along - DVec3::new(angle.sin(), 0.0, -angle.cos())).length();
            assert!(off < 1e-11, "t = {duration} s: {off:e}");
        }
        assert_held(&report);
    }
}

/// Six hinges on the edges of a cube: 30 rows hold 30 velocities, and one motion is left. The corner opposite to the
/// ground link passes where the quadrature of its one equation says.
#[test]
fn bricard_loop_moves_as_its_one_equation_says() {
    let corners = [[0, 0, 0], [1, 0, 0], [1, -1, 0], [1, -1, 1], [0, -1, 1], [0, 0, 1]]
        .map(|[x, y, z]: [i32; 3]| DVec3::new(f64::from(x), f64::from(y), f64::from(z)));
    let references = [
        (0.713_636_674_724_765_3, [0.866_025_403_784_438_6, -std::f64::consts::SQRT_2, 0.5]),
        (1.005_963_332_146_470_3, [0.5, -1.652_891_650_281_069_5, 0.133_974_596_215_561_35]),
        (1.208_691_910_258_946_6, [0.087_155_742_747_658_18, -1.729_852_420_347_900_9, 0.003_805_301_908_254_468]),
    ];
    for (duration, corner) in references {
        let mut builder =
            Scene::builder("bricard").method(accurate()).duration_s(duration).gravity(DVec3::new(0.0, -9.81, 0.0));
        for link in 0..5 {
            let along = corners[link + 1] - corners[link];
            let size = along.abs() + (DVec3::ONE - along.abs()) * 0.1;
            let properties = solid_box(size, Mass::new(1.0).unwrap()).unwrap();
            let center = (corners[link] + corners[link + 1]) * 0.5;
            builder =
                builder.body(Body::movable(format!("link {link}"), properties).pose(Pose::from_translation(center)));
        }
        for at in 0..6 {
            let [before, after] = [corners[(at + 5) % 6], corners[(at + 1) % 6]];
            let axis = UnitVector::new((corners[at] - before).cross(after - corners[at])).unwrap();
            let joint = Joint::hinge(BodyId::new(at.min(4)), corners[at], axis);
            builder = builder.joint(if (1..5).contains(&at) { joint.with(BodyId::new(at - 1)) } else { joint });
        }
        let (report, _) = run(&builder.build().unwrap(), Effects::Planned);
        let third = report.bodies[2].state.pose.transform_point(DVec3::Z * 0.5);
        assert!((third - DVec3::from_array(corner)).length() < 1e-12, "t = {duration} s: {third:?}");
        assert_held(&report);
    }
}
