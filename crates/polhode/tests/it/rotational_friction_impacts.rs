//! Impacts against friction of rolling and spinning: whatever strikes, with whatever restitution, loses energy and
//! gains none, in the row of impacts as in that of friction, and the run ends as completed. Impacts of bodies on
//! pivots, too, where the pivot leaves the contact no freedom.

use crate::checks::assert_closes;
use crate::support::{accurate, ball, brick, floor, run, run_even_degraded};
use polhode::contact::Shape;
use polhode::scene::{ImpactLaw, Material, Method, SceneError};
use polhode::spatial::{DVec3, Inertia, Mass, MassProperties, Pose, Rotation, SplitMix64, Velocity};
use polhode::{Body, Effects, RunReport, Scene};

/// Rounding of a row of the ledger as a part of the energy at the start (no unit).
const LEDGER_ROUNDING: f64 = 1e-9;

/// Numbers from a seed.
#[derive(Debug)]
struct Numbers(SplitMix64);

impl Numbers {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.uniform()
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|_| self.between(-size, size)))
    }
}

/// A body of 1 kg and some 0.2 m of one of five shapes.
fn body_of(kind: usize, name: &str) -> Body {
    let shape = match kind {
        0 => Shape::sphere(0.1),
        1 => return brick(name, DVec3::new(0.2, 0.15, 0.1), DVec3::ZERO),
        2 => Shape::cylinder(0.1, 0.15),
        3 => Shape::capsule(0.06, 0.1),
        _ => Shape::cone(0.1, 0.2),
    };
    let inertia = Inertia::from_diagonal(DVec3::new(3e-3, 3e-3, 4e-3)).expect("moments");
    let properties = MassProperties::new(Mass::new(1.0).expect("a mass"), DVec3::ZERO, inertia);
    Body::movable(name, properties).geometry(shape.expect("a shape").into())
}

#[track_caller]
fn assert_takes_energy(report: &RunReport, initial_j: f64, what: &str) {
    let rows = [("impact", report.ledger.impact.value()), ("friction", report.ledger.friction.value())];
    for (row, lost) in rows {
        assert!(lost >= -LEDGER_ROUNDING * initial_j, "{what}: the row of {row} is {lost:e} J of {initial_j} J");
    }
    assert_closes(report);
}

/// Bodies of all shapes are thrown at the floor, with any restitution, also onto edges and corners: each impact takes
/// energy.
#[test]
fn friction_of_rolling_gives_no_energy_at_impacts() {
    for seed in 0..60 {
        let mut numbers = Numbers(SplitMix64::new(seed));
        let kind = (seed % 5) as usize;
        let restitution = [0.0, 0.5, 1.0][(seed / 5 % 3) as usize];
        let felt = Material::new("felt")
            .with_friction(numbers.between(0.1, 1.5))
            .expect("a material")
            .with_restitution(restitution)
            .expect("a material");
        let felt = felt.with_rotational_friction(numbers.between(0.0, 0.01), numbers.between(0.0, 0.02));
        let felt = felt.expect("lengths of friction");
        let turn = Rotation::from_rotation_vector(numbers.vector(3.0));
        let velocity = Velocity::new(numbers.vector(1.0) - DVec3::Z, numbers.vector(6.0));
        let thrown = body_of(kind, "thrown").pose(Pose::new(turn, DVec3::Z * 0.25)).velocity(velocity);
        let scene = Scene::builder("thrown")
            .method(accurate())
            .gravity(DVec3::ZERO)
            .body(thrown.material(felt.clone()))
            .body(floor().material(felt));
        let (report, _) = run(&scene.duration_s(0.4).build().expect("a scene"), Effects::Planned);
        assert_takes_energy(&report, 0.5 * 2.0 * 3.0 + 0.1, &format!("seed {seed}"));
    }
}

/// Two bodies are thrown together onto the floor: several contacts, struck together or in order. Each impact is
/// resolved, and takes energy; where contacts crowd afterwards, projections may take more than is promised, which is
/// not asked here.
#[test]
fn several_contacts_with_friction_of_rolling_give_no_energy() {
    for seed in 0..12 {
        let mut numbers = Numbers(SplitMix64::new(1000 + seed));
        let law = if seed % 2 == 0 { ImpactLaw::Simultaneous } else { ImpactLaw::Propagation };
        let restitution = [0.0, 0.4, 1.0][(seed % 3) as usize];
        let felt = Material::new("felt")
            .with_friction(numbers.between(0.1, 1.5))
            .expect("a material")
            .with_restitution(restitution)
            .expect("a material");
        let felt = felt.with_rotational_friction(numbers.between(0.0, 0.005), numbers.between(0.0, 0.01));
        let felt = felt.expect("lengths of friction");
        let lower = body_of((seed % 5) as usize, "lower").pose(Pose::from_translation(DVec3::Z * 0.12));
        let upper = body_of((seed / 5 % 5) as usize, "upper");
        let turn = Rotation::from_rotation_vector(numbers.vector(3.0));
        let velocity = Velocity::new(numbers.vector(0.3) - DVec3::Z, numbers.vector(3.0));
        let upper = upper.pose(Pose::new(turn, DVec3::Z * 0.45)).velocity(velocity);
        let scene = Scene::builder("thrown")
            .method(Method { impact: Some(law), ..accurate() })
            .body(lower.material(felt.clone()))
            .body(upper.material(felt.clone()))
            .body(floor().material(felt));
        let (report, _) = run_even_degraded(&scene.duration_s(0.3).build().expect("a scene"), Effects::Planned);
        let unresolved = report.warnings.iter().find(|warning| warning.contains("not resolved"));
        assert_eq!(unresolved, None, "seed {seed}");
        assert_takes_energy(&report, 10.0, &format!("seed {seed}"));
    }
}

/// A ball on a pivot through its centre touches the floor, which can do nothing to it but turn it, and another ball is
/// thrown at it. Its contact with the floor is part of the impact, and the pivot leaves it no freedom along the normal.
#[test]
fn contact_that_a_pivot_leaves_no_freedom_is_no_error() {
    for law in [ImpactLaw::Simultaneous, ImpactLaw::Propagation] {
        for (friction, rolling) in [(0.4, 0.0), (0.4, 0.002), (0.0, 0.0)] {
            for restitution in [0.0, 0.5, 1.0] {
                let felt = Material::new("felt")
                    .with_friction(friction)
                    .expect("a material")
                    .with_restitution(restitution)
                    .expect("a material");
                let felt = felt.with_rotational_friction(rolling, 2.0 * rolling).expect("lengths of friction");
                let held =
                    ball("held", 1.0, 0.1, DVec3::new(0.3, 0.2, 0.1), DVec3::ZERO).pivot(DVec3::new(0.3, 0.2, 0.1));
                let velocity = Velocity::new(DVec3::new(1.1, 0.8, -0.6), DVec3::new(3.0, -2.0, 1.0));
                let thrown = ball("thrown", 0.7, 0.1, DVec3::new(0.0, 0.0, 0.3), DVec3::ZERO).velocity(velocity);
                let scene = Scene::builder("pivot")
                    .method(Method { impact: Some(law), ..accurate() })
                    .body(held.material(felt.clone()))
                    .body(thrown.material(felt.clone()))
                    .body(floor().material(felt));
                let (report, _) = run(&scene.duration_s(0.5).build().expect("a scene"), Effects::Planned);
                let what = format!("{law:?}, friction {friction}, rolling {rolling}, restitution {restitution}");
                assert_takes_energy(&report, 5.0, &what);
            }
        }
    }
}

/// The law `pulse` strikes contacts with friction, and refuses those that resist rolling or spinning as well, when the
/// scene is built.
#[test]
fn pulse_refuses_contacts_that_resist_rotations() {
    let scene = |rolling: f64, spinning: f64| {
        let felt = Material::new("felt").with_friction(0.4).expect("a coefficient");
        let felt = felt.with_rotational_friction(rolling, spinning).expect("lengths of friction");
        Scene::builder("pulse")
            .method(Method { impact: Some(ImpactLaw::Pulse), ..accurate() })
            .duration_s(0.3)
            .body(floor().material(felt.clone()))
            .body(body_of(1, "box").pose(Pose::from_translation(DVec3::Z * 0.2)).material(felt))
            .build()
    };
    run(&scene(0.0, 0.0).expect("a scene"), Effects::Planned);
    for (rolling, spinning) in [(0.002, 0.0), (0.0, 0.002)] {
        let refused = scene(rolling, spinning).expect_err("friction of rotations");
        assert!(matches!(refused, SceneError::NotYetAvailable { .. }), "{refused}");
    }
}
