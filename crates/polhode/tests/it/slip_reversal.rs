//! A slip that reverses passes through zero without a loss, and one that ends does so at its instant.
//!
//! A sledge of mass M on ice is pulled by F, and a load of mass m slides forward on it at first. Friction slows the
//! load by `mu g` and pulls the sledge by `mu m g`, until the sledge has caught up:
//! `v_0 - mu g t = (F + mu m g) t / M`. From then on the load slides back and gains `mu g`, since the sledge
//! accelerates by more than friction can follow.

use crate::friction::{lying, on_slope, rough};
use crate::support::{accurate, brick, floor, run};
use polhode::scene::{Force, Frame, Signal};
use polhode::spatial::{DVec3, Rotation, SplitMix64, Velocity};
use polhode::{BodyId, Effects, EventKind, Scene};

const G: f64 = 9.81;

/// The speed of the load at the end equals the closed form, for any time of the reversal.
#[test]
fn slip_that_reverses_loses_nothing() {
    let (mu, pull, mass) = (0.4, 20.0, 1.0);
    let mut random = SplitMix64::new(7);
    for _ in 0..12 {
        let speed = 0.4 + 1.2 * random.uniform();
        let sledge = brick("sledge", DVec3::new(4.0, 1.0, 0.1), DVec3::Z * 0.05).material(rough(mu));
        let load = brick("load", DVec3::new(1.0, 0.9, 0.1), DVec3::Z * 0.15)
            .velocity(Velocity::new(DVec3::X * speed, DVec3::ZERO))
            .material(rough(mu));
        let force = Force::Applied {
            body: BodyId::new(1),
            force: DVec3::X * pull,
            torque: DVec3::ZERO,
            frame: Frame::World,
            point: None,
            signal: Signal::polynomial(vec![1.0]).unwrap(),
        };
        let scene = Scene::builder("sledge")
            .method(accurate())
            .duration_s(0.2)
            .output_interval_s(0.1)
            .body(floor())
            .body(sledge)
            .body(load)
            .force(force)
            .build()
            .unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let reversal = speed / (mu * G + (pull + mu * mass * G));
        let expected = speed + mu * G * (0.2 - 2.0 * reversal);
        let found = report.bodies[2].state.velocity.linear.x;
        assert!((found - expected).abs() < 1e-12 * (1.0 + speed), "{found} {expected} {speed}");
    }
}

/// A box that slides on a rough floor begins to stick after `v/(mu g)`, to 1e-12 of that time.
#[test]
fn slip_ends_at_its_instant() {
    let mut random = SplitMix64::new(3);
    for _ in 0..12 {
        let (speed, mu) = (0.1 + 3.0 * random.uniform(), 0.05 + random.uniform());
        let time = speed / (mu * G);
        let body = lying(DVec3::new(0.5, 0.4, 0.02), random.uniform(), DVec3::X * speed);
        let scene = on_slope(Rotation::IDENTITY, body, &rough(mu)).duration_s(1.5 * time).build().unwrap();
        let (_, recorder) = run(&scene, Effects::Planned);
        let sticks = recorder.events.iter().find(|event| event.kind == EventKind::Stick).unwrap().t_s;
        assert!((sticks / time - 1.0).abs() < 1e-12, "{sticks} {time}");
    }
}
