//! Forces so stiff that the rounding of a position changes them, and forces that grow without bound.

use crate::checks::{heavy_brick, particle};
use crate::support::{accurate, ball, floor, run};
use polhode::scene::{Attachment, DragLaw, Force, Frame, Method, Signal, Tier};
use polhode::spatial::{DVec3, Velocity};
use polhode::{BodyId, Effects, Scene, SceneBuilder, Simulation, SimulationError};

const CENTER: DVec3 = DVec3::new(0.0, 0.0, 2.0);

/// A box of 1 kg above the floor on a spring of 1e12 N/m. Its weight stretches the spring by 1e-11 m, a hundred
/// thousand rounding units of its height, each of which changes the force by 1e-4 N. This noise is not taken for an
/// error of the integration: a period of 6.3 us takes a few steps. (Before, it took a hundred.)
#[test]
fn rounding_of_positions_on_a_stiff_spring_adds_no_steps() {
    let (stiffness, duration) = (1e12_f64, 1e-3);
    let spring = Force::Spring {
        a: Attachment::World(DVec3::Z),
        b: Attachment::Body { body: BodyId::new(1), point: DVec3::ZERO },
        stiffness,
        rest_length: 0.0,
        damping: 0.0,
    };
    let scene = Scene::builder("stiff")
        .method(accurate())
        .duration_s(duration)
        .body(floor())
        .body(heavy_brick("box", 1.0, DVec3::ONE, DVec3::Z))
        .force(spring)
        .build()
        .unwrap();
    let (report, recorder) = run(&scene, Effects::Planned);
    assert!(report.steps < 2000, "{} steps", report.steps);
    let w = stiffness.sqrt();
    let place = |t: f64| 1.0 - 9.81 / stiffness * (1.0 - (w * t).cos());
    for (t, bodies) in recorder.times_s.iter().zip(&recorder.samples) {
        let error = (bodies[1].pose.translation.z - place(*t)).abs();
        assert!(error < 1e-12, "t = {t}: {error:e} m");
    }
}

/// A body at rest at `place`, beside an attracting centre or in it.
fn attracted(place: DVec3, tier: Tier) -> SceneBuilder {
    Scene::builder("attracted")
        .method(Method { tier: Some(tier), ..Method::default() })
        .gravity(DVec3::ZERO)
        .duration_s(3.0)
        .body(particle("comet", 1.0, place, DVec3::ZERO))
        .force(Force::PointGravity { center: CENTER, mu: 1.0 })
}

/// No tier starts where a force is not finite. The error names the force, the body and the time.
#[test]
fn start_at_an_attracting_point_names_the_force() {
    for tier in [Tier::Accurate, Tier::Stepped, Tier::Thesis] {
        for scene in [attracted(CENTER, tier), attracted(CENTER, tier).body(floor())] {
            let refused = Simulation::new(&scene.build().unwrap()).err();
            let Some(SimulationError::ForceNotFinite { t_s: t, body, force }) = refused else {
                panic!("{tier:?}: {refused:?}");
            };
            assert_eq!((t, body.as_str()), (0.0, "comet"));
            assert!(force.contains("number 0") && force.contains("point gravity"), "{force}");
        }
    }
}

/// A fall from rest ends at the centre: from the distance d after `pi/2 sqrt(d^3/(2 mu))`, with an error that says so.
#[test]
fn radial_fall_ends_where_the_force_is_singular() {
    for offset in [DVec3::Z, DVec3::new(0.1, 0.2, 1.1)] {
        let fall = attracted(CENTER + offset, Tier::Accurate);
        for scene in [fall.clone(), fall.body(floor())] {
            let scene = scene.build().unwrap();
            let failed = Simulation::new(&scene).and_then(|mut own| own.run()).err();
            let Some(SimulationError::SingularForce { t_s: t, body, force, force_n }) = failed else {
                panic!("{offset}: {failed:?}");
            };
            let end = std::f64::consts::FRAC_PI_2 * (offset.length().powi(3) / 2.0).sqrt();
            assert!((t - end).abs() < 1e-9, "{t} s, {end} s");
            assert!(
                body == "comet" && force.contains("point gravity") && force_n > 1e9,
                "{body}, {force}, {force_n:e}"
            );
        }
    }
}

/// A spin in a medium so viscous that it falls by half within microseconds. A longer step overflows: it is refused, and
/// a shorter one made. The spin is that of `I w' = -c w^2`.
#[test]
fn a_step_that_overflows_under_stiff_drag_is_refused() {
    let (drag, spin, duration) = (1.5, 25.0, 2e-3);
    let drag_on = |rotational: f64| Force::Drag {
        body: BodyId::new(1),
        law: DragLaw::Quadratic,
        translational: 0.0,
        rotational,
        wind: DVec3::ZERO,
    };
    let ball = ball("ball", 0.05, 0.22, DVec3::Z, DVec3::ZERO).velocity(Velocity::new(DVec3::ZERO, DVec3::X * spin));
    let moment = 0.4 * 0.05 * 0.22 * 0.22;
    let scene = Scene::builder("viscous").method(accurate()).duration_s(duration);
    let scene = scene.body(floor()).body(ball).force(drag_on(drag)).build().unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    let expected = spin / (1.0 + drag * spin * duration / moment);
    let off = report.bodies[1].state.velocity.angular.x / expected - 1.0;
    assert!(off.abs() < 1e-9, "{off:e}");
}

/// A force that grows from nothing presses a box on a floor, without gravity: there is no energy at all, and what
/// rounding leaves is compared with what the force would do.
#[test]
fn energies_are_those_of_forces_where_nothing_moves() {
    let signal = Signal::polynomial(vec![0.0, 1.0]).unwrap();
    let push = Force::Applied {
        body: BodyId::new(1),
        force: DVec3::Z * -1.0,
        torque: DVec3::ZERO,
        frame: Frame::World,
        point: None,
        signal,
    };
    let scene = Scene::builder("pressed").method(accurate()).gravity(DVec3::ZERO).duration_s(0.1);
    let scene = scene.body(floor()).body(heavy_brick("box", 1.0, DVec3::splat(0.2), DVec3::Z * 0.1)).force(push);
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    assert!((report.bodies[1].state.pose.translation.z - 0.1).abs() < 1e-11, "{:?}", report.bodies[1]);
}
