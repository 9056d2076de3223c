//! Drops: the confined rectangle has a closed form (a wave goes up and comes back, and the bar leaves as it came:
//! contact time `2 L / c_p`, impulse `2 m v`); mirrored, scaled and flat drops have the symmetry that they should; and
//! a short run has the same bits everywhere.

use crate::rubber;
use polhode_elastic::{Cells, DVec2, DropReport, DropStudy, ElasticMaterial, Quantity, RectangleDrop};

fn drop(tilt_rad: f64) -> RectangleDrop {
    RectangleDrop::new(2.0, 1.0, rubber(), 1.0).unwrap().tilted(tilt_rad).unwrap()
}

#[test]
fn a_confined_rectangle_bounces_off_whole() {
    for (poisson, speed) in [(0.3, 1.0), (0.0, 0.01), (0.45, 0.2), (-0.5, 1.0)] {
        let material = ElasticMaterial::new(1e6, poisson, 1000.0).unwrap();
        let drop = RectangleDrop::new(2.0, 1.0, material, speed).unwrap().confined().unwrap();
        for elements in [8, 200, 800] {
            let report = drop.run(drop.cells(elements)).unwrap();
            let time = report.contact_time_s * material.dilatational_speed() / (2.0 * drop.height());
            let impulse = report.impulse_n_s / (2.0 * report.mass_kg * speed);
            assert!((time - 1.0).abs() < 1e-9, "{poisson} {elements}: {time}");
            assert!((impulse - 1.0).abs() < 1e-9, "{poisson} {elements}: {impulse}");
            assert!(report.energy.vibration_j.abs() < 1e-9 * report.energy.before_j, "{report:?}");
        }
    }
}

#[test]
fn the_floor_does_no_work() {
    for tilt in [0.0, 0.2, 0.8] {
        let energy = drop(tilt).run(drop(tilt).cells(200)).unwrap().energy;
        assert!(energy.contact_loss_j.abs() < 1e-12 * energy.before_j, "{energy:?}");
        assert!(energy.numerical_j.abs() < 1e-3 * energy.before_j, "{energy:?}");
        assert!(energy.residual_j.abs() < 1e-12 * energy.before_j, "{energy:?}");
    }
}

#[test]
fn a_flat_drop_bounces_straight_and_vibrates() {
    let report = drop(0.0).run(drop(0.0).cells(200)).unwrap();
    assert!(report.velocity.x.abs() < 1e-13 && report.angular_velocity.abs() < 1e-13, "{report:?}");
    assert!(report.restitution > 0.5 && report.restitution < 1.0, "{report:?}");
    assert!(report.energy.vibration_j > 0.05 * report.energy.before_j, "{report:?}");
}

#[test]
fn a_solid_that_does_not_bulge_bounces_off_whole_without_rollers() {
    // At nu = 0 a flat drop is uniaxial by itself; what its steps below the limit disperse stays behind.
    let cork = ElasticMaterial::new(1e6, 0.0, 1000.0).unwrap();
    let drop = RectangleDrop::new(2.0, 1.0, cork, 1.0).unwrap();
    let report = drop.run(drop.cells(800)).unwrap();
    assert!((report.restitution - 1.0).abs() < 5e-3, "{report:?}");
}

#[test]
fn a_mirrored_drop_mirrors_the_rebound() {
    let cells = drop(0.0).cells(200);
    let (left, right) = (drop(-0.35).run(cells).unwrap(), drop(0.35).run(cells).unwrap());
    assert!((left.velocity.y - right.velocity.y).abs() < 1e-10);
    assert!((left.velocity.x + right.velocity.x).abs() < 1e-10);
    assert!((left.angular_velocity + right.angular_velocity).abs() < 1e-10);
    assert!(right.angular_velocity.abs() > 0.1);
}

#[test]
fn a_drop_twice_as_large_is_the_same_but_for_its_times() {
    let large = RectangleDrop::new(4.0, 2.0, rubber(), 1.0).unwrap();
    let cells = Cells { columns: 12, rows: 6 };
    let (small, large) = (drop(0.0).run(cells).unwrap(), large.run(cells).unwrap());
    assert_eq!(small.restitution.to_bits(), large.restitution.to_bits());
    assert_eq!((2.0 * small.contact_time_s).to_bits(), large.contact_time_s.to_bits());
}

#[test]
fn a_tilted_drop_turns_the_way_its_corner_is_pushed() {
    // Pushed up right of the centre of mass, x turns to z, which is negative about y; left of it, the other way.
    let (right, left) = (drop(0.8).run(drop(0.8).cells(50)).unwrap(), drop(1.3).run(drop(1.3).cells(50)).unwrap());
    assert!(right.angular_velocity < -0.1, "{right:?}");
    assert!(left.angular_velocity > 0.1, "{left:?}");
}

#[test]
fn a_study_takes_away_the_noise_of_steps_and_tells_what_is_left() {
    let study = DropStudy::of(&drop(0.0), drop(0.0).cells(32)).unwrap();
    let counts: Vec<usize> = study.meshes.iter().map(|drops| drops.cells.count()).collect();
    assert_eq!(counts, [32, 128, 512]);
    let limit = study.limit(Quantity::Restitution).unwrap();
    // The value on 3200 elements by eight step lengths, which the estimate must hold.
    assert!((limit.value - 0.8189).abs() < limit.error + 1e-3 && limit.error < 0.03, "{limit:?}");
    let confined = drop(0.0).confined().unwrap();
    let limit = DropStudy::of(&confined, confined.cells(8)).unwrap().limit(Quantity::Impulse).unwrap();
    assert!((limit.value - 4000.0).abs() < 1e-6 && limit.error < 1e-6, "{limit:?}");
}

/// FNV-1a over the bits of some numbers.
fn hash(numbers: impl Iterator<Item = f64>) -> u64 {
    let bytes = numbers.flat_map(|number| number.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[test]
fn a_short_run_has_the_same_bits_everywhere() {
    let mut run = drop(0.4).start(drop(0.4).cells(50)).unwrap();
    for _ in 0..60 {
        run.step().unwrap();
    }
    let numbers = run.displacements().iter().chain(run.velocities()).flat_map(DVec2::to_array);
    assert_eq!(hash(numbers), 18_123_122_734_719_766_033);
    let report: DropReport = drop(0.4).run(drop(0.4).cells(50)).unwrap();
    assert_eq!(report, drop(0.4).run(drop(0.4).cells(50)).unwrap());
}
