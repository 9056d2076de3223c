//! Bounces that come to rest while the body slides: friction takes `mu` times what the floor presses, no more.
//!
//! A ball is thrown along a rough floor, bounces ever lower and at last rolls and slides on it. As long as it slides,
//! friction changes its velocity along the floor by `mu` times the change across it, which is `g t` once the bounces
//! have ended: `v = v_0 - mu g t`, and `w = 5/2 mu g t / r`. The last of the infinitely many bounces are replaced by
//! their end, which therefore must give back the friction that the held contact takes in their place.

use crate::support::{accurate, ball, floor, run};
use polhode::scene::Material;
use polhode::spatial::{DVec3, SplitMix64};
use polhode::{Effects, Scene};

const G: f64 = 9.81;

/// Error of the end velocity that is accepted, m/s: that of the steps.
const ACCEPTED_M_S: f64 = 1e-9;

#[test]
fn a_ball_that_stops_bouncing_while_it_slides_loses_what_friction_allows() {
    let mut random = SplitMix64::new(11);
    for _ in 0..8 {
        let (mu, restitution) = (0.05 + 0.1 * random.uniform(), 0.2 + 0.4 * random.uniform());
        let (radius, height, duration) = (0.02 + 0.2 * random.uniform(), 0.03 + 0.03 * random.uniform(), 0.8);
        let material = Material::new("rough").with_friction(mu).unwrap().with_restitution(restitution).unwrap();
        let thrown = ball("ball", 1.0, radius, DVec3::Z * (radius + height), DVec3::X * 6.0).material(material.clone());
        let scene = Scene::builder("bounces")
            .method(accurate())
            .duration_s(duration)
            .body(floor().material(material))
            .body(thrown)
            .build()
            .unwrap();
        let (report, _) = run(&scene, Effects::Planned);
        let end = report.bodies[1].state.velocity;
        let (speed, spin) = (6.0 - mu * G * duration, 2.5 * mu * G * duration / radius);
        let off = (end.linear - DVec3::X * speed).length().max((end.angular - DVec3::Y * spin).length() * radius);
        assert!(off < ACCEPTED_M_S, "mu {mu}, e {restitution}, r {radius}: {off:e} m/s");
    }
}
