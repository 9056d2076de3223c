//! Where the impulses of an impact are not unique, and the motion afterwards depends on them, the choice is one of the
//! bodies and not of the world: copies of a scene that are turned, or whose bodies have another order, move alike.
//!
//! A block rests on a rough floor with four corners, which a blow off its centre makes slide: three of their normal
//! impulses follow from the fourth, and each corner has the friction of its own. Turned by any angle the velocities
//! after the blow are the same.

use crate::support::{accurate, ball, brick, run};
use polhode::contact::Shape;
use polhode::scene::Material;
use polhode::spatial::{DVec3, Pose, Rotation, UnitVector, Velocity};
use polhode::{Body, Effects, Scene};

/// A blow: size of the block, place of its centre across the way of the ball, height of the ball, its speed, friction,
/// restitution.
type Blow = (DVec3, f64, f64, f64, f64, f64);

/// Velocities of the block after a blow in a world that is turned, turned back; the bodies in this order.
fn struck((size, across, height, speed, friction, restitution): Blow, turn: Rotation, reversed: bool) -> Velocity {
    let material = || Material::new("m").with_friction(friction).unwrap().with_restitution(restitution).unwrap();
    let up = turn.rotate(DVec3::Z);
    let ground = Body::fixed("floor").geometry(Shape::half_space(UnitVector::new(up).unwrap()).into());
    let place = DVec3::new(0.3, across, 0.5 * size.z);
    let block = brick("block", size, DVec3::ZERO).pose(Pose::new(turn, turn.rotate(place)));
    let start = DVec3::new(0.0, 0.0, height);
    let hitting = ball("ball", 2.3, 0.08, turn.rotate(start), turn.rotate(DVec3::X * speed));
    let mut bodies = vec![ground, block, hitting];
    if reversed {
        bodies.reverse();
    }
    let mut scene = Scene::builder("blow").method(accurate()).gravity(up * -9.81).duration_s(0.05);
    for body in bodies {
        scene = scene.body(body.material(material()));
    }
    let (report, _) = run(&scene.build().unwrap(), Effects::Planned);
    let velocity = report.bodies[1].state.velocity;
    Velocity::new(turn.inverse_rotate(velocity.linear), turn.inverse_rotate(velocity.angular))
}

#[test]
fn a_blow_off_the_centre_of_a_resting_block_turns_with_the_world() {
    let cube = DVec3::splat(0.2);
    let flat = DVec3::new(0.31, 0.23, 0.24);
    let blows =
        [(cube, 0.065, 0.15, 3.55, 0.88, 0.5), (flat, 0.05, 0.19, 4.4, 0.33, 0.3), (cube, -0.04, 0.1, 4.0, 0.5, 0.8)];
    for blow in blows {
        let home = struck(blow, Rotation::IDENTITY, false);
        assert!(home.linear.length() > 0.1, "{blow:?}: {home:?}");
        let turns = [DVec3::Z, DVec3::Z * 2.0, DVec3::Z * std::f64::consts::FRAC_PI_2, DVec3::new(0.45, 0.9, 1.35)];
        let copies = turns.into_iter().map(|turn| (Rotation::from_rotation_vector(turn), false));
        for (turn, reversed) in copies.chain([(Rotation::IDENTITY, true)]) {
            let copy = struck(blow, turn, reversed);
            let off = (copy.linear - home.linear).length() + (copy.angular - home.angular).length();
            assert!(off < 1e-9, "{blow:?} {turn:?} {reversed}: {off:e} off {home:?}");
        }
    }
}
