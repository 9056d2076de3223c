//! How far bodies at rest are from moving, against closed forms; and rest of hundreds of bodies, certified at t = 0.
//!
//! A box on a slope, one that tips, a tower, a plank that leans on a block: the friction that each needs, the push that
//! each bears, and what begins to move. A pyramid of 210 cubes rests with forces that carry its weight, and nothing is
//! computed after its start.

use polhode::contact::Shape;
use polhode::mesh::solid_box;
use polhode::scene::{Material, PairRule, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector};
use polhode::stability::{Beginning, Stability};
use polhode::{Body, Effects, Scene, SceneBuilder, Simulation};

const GRAVITY: f64 = 9.81;

/// Margins are told to six digits.
const MARGIN: f64 = 2e-6;

/// Of a box that stands alone.
const EXACT: f64 = 1e-8;

fn material(name: &str, friction: f64) -> Material {
    Material::new(name).with_friction(friction).unwrap()
}

fn block(name: &str, size: DVec3, mass: f64, center: DVec3) -> Body {
    Body::movable(name, solid_box(size, Mass::new(mass).unwrap()).unwrap())
        .geometry(Shape::cuboid(size).unwrap().into())
        .pose(Pose::from_translation(center))
}

fn ground(friction: f64) -> Body {
    Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into()).material(material("stone", friction))
}

/// In space, also where the motion is planar.
fn stability(scene: SceneBuilder) -> Stability {
    let scene = scene.build().unwrap();
    Simulation::with_effects(&scene, Effects::All).unwrap().stability().unwrap()
}

/// The push that is borne in this direction, as a part of the weight.
#[track_caller]
fn push(stability: &Stability, direction: DVec3) -> f64 {
    let found = stability.pushes.iter().find(|push| push.direction.dot(direction) > 1.0 - 1e-9);
    found.and_then(|push| push.of_weight).unwrap()
}

/// On a slope of angle a with friction mu a box needs `tan a / mu` of its friction, and slides when the slope is tilted
/// to `atan mu`: by `atan mu - a` downhill, by `atan mu + a` uphill.
#[test]
fn a_box_on_a_slope_needs_the_tangent_of_its_angle() {
    let (angle, friction) = (0.2_f64, 0.4_f64);
    let turn = Rotation::from_rotation_vector(DVec3::Y * angle);
    let normal = UnitVector::new(turn.rotate(DVec3::Z)).unwrap();
    let plane = Body::fixed("slope").geometry(Shape::half_space(normal).into()).material(material("stone", friction));
    let body = block("box", DVec3::new(1.0, 1.0, 0.2), 3.0, DVec3::ZERO).material(material("stone", friction));
    let body = body.pose(Pose::new(turn, turn.rotate(DVec3::Z * 0.1)));
    let found = stability(Scene::builder("slope").body(plane).body(body));
    assert!((found.friction.needed.unwrap() - angle.tan() / friction).abs() < MARGIN);
    assert_eq!(found.friction.begins[0].beginning, Beginning::Slides);
    // The slope falls towards +x.
    assert!((push(&found, DVec3::X) - (friction.atan() - angle).tan()).abs() < MARGIN);
    assert!((push(&found, DVec3::NEG_X) - (friction.atan() + angle).tan()).abs() < MARGIN);
    let along = found.friction.begins[0].direction.unwrap();
    // With the opening of limit analysis: by the angle of the friction that is needed away from the slope.
    assert!((along - DVec3::X).length() < 1e-5, "{along}");
    assert_eq!(found.worst_push().unwrap().direction, DVec3::X);
}

/// A column on level ground tips over an edge at width over height, over a corner at the root of two times that, and
/// slides where friction is less.
#[test]
fn a_column_tips_over_its_edges_and_corners() {
    let size = DVec3::new(0.5, 0.5, 2.0);
    let of = |friction| {
        let column = block("column", size, 3.0, DVec3::Z).material(material("stone", friction));
        stability(Scene::builder("column").body(ground(friction)).body(column))
    };
    let rough = of(0.6);
    for direction in [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y] {
        assert!((push(&rough, direction) - 0.25).abs() < EXACT);
    }
    assert!((push(&rough, DVec3::new(1.0, 1.0, 0.0).normalize()) - 0.25 * 2.0_f64.sqrt()).abs() < EXACT);
    assert_eq!(rough.friction.needed, Some(0.0));
    assert_eq!(rough.worst_push().unwrap().begins[0].beginning, Beginning::Tips);
    let smooth = of(0.2);
    assert!((push(&smooth, DVec3::X) - 0.2).abs() < EXACT);
    assert_eq!(smooth.worst_push().unwrap().begins[0].beginning, Beginning::Slides);
}

/// A tower of n cubes is tilted until it tips as one, at 1/n, or its uppermost parts do: as one.
#[test]
fn a_tower_of_cubes_tips_as_one() {
    for count in [2_u32, 5] {
        let mut scene = Scene::builder("tower").body(ground(2.0));
        for number in 0..count {
            let center = DVec3::Z * (f64::from(number) + 0.5);
            scene =
                scene.body(block(&format!("cube {number}"), DVec3::ONE, 1.0, center).material(material("stone", 2.0)));
        }
        let found = stability(scene);
        assert!((push(&found, DVec3::X) - 1.0 / f64::from(count)).abs() < MARGIN);
        assert_eq!(found.worst_push().unwrap().begins.len(), count as usize);
        assert_eq!(found.bodies, count as usize);
    }
}

/// A plank of length L and thickness t at an angle a to the ground leans on the smooth face of a block. It presses the
/// block with `F = W (L cos a - t sin a)/(2 L sin a)`; the ground bears F by friction under the plank, whose weight is
/// W, and under the block of weight V: of friction mu the part `max(F/W, F/V)/mu` is needed, and the one that needs it
/// slides.
#[test]
fn a_plank_that_leans_on_a_block() {
    let (length, thickness, angle, friction) = (2.0, 0.1, 1.1_f64, 0.7);
    let (s, c) = angle.sin_cos();
    let pressure = (length * c - thickness * s) / (2.0 * length * s);
    for (mass, first) in [(0.5, "block"), (5.0, "plank")] {
        // The lower edge of the plank stands at the origin, its upper lower edge leans on the face at x = L cos a.
        let (along, across) = (DVec3::new(c, 0.0, s), DVec3::new(-s, 0.0, c));
        let plank = block("plank", DVec3::new(length, 0.4, thickness), 1.0, DVec3::ZERO).pose(Pose::new(
            Rotation::from_rotation_vector(DVec3::NEG_Y * angle),
            along * (0.5 * length) + across * (0.5 * thickness),
        ));
        let size = DVec3::new(4.0, 1.0, 2.0);
        let center = DVec3::new(length * c + 0.5 * size.x, 0.0, 0.5 * size.z);
        let rock = Body::fixed("ground").geometry(Shape::half_space(UnitVector::Z).into());
        let scene = Scene::builder("plank")
            .body(rock.material(material("rock", friction)))
            .body(plank.material(material("wood", friction)))
            .body(block("block", size, mass, center).material(material("stone", friction)))
            .pair_rule(PairRule::new(["wood".to_owned(), "stone".to_owned()]).with_friction(0.0).unwrap())
            .build()
            .unwrap();
        let simulation = Simulation::with_effects(&scene, Effects::All).unwrap();
        let found = simulation.stability().unwrap();
        let needed = pressure.max(pressure / mass) / friction;
        assert!((found.friction.needed.unwrap() / needed - 1.0).abs() < MARGIN, "{:?}", found.friction);
        let begins = &found.friction.begins;
        let names: Vec<&str> = begins.iter().map(|one| scene.bodies()[one.body.index()].name()).collect();
        assert!(names.contains(&first) && names.contains(&"plank"), "{names:?}");
        let block = begins.iter().find(|one| scene.bodies()[one.body.index()].name() == "block");
        assert_eq!(block.is_some(), first == "block");
        assert!(block.is_none_or(|block| block.beginning == Beginning::Slides));
    }
}

/// What is in the air, or moves, has no margins; what cannot stand is told.
#[test]
fn what_does_not_stand_is_told() {
    let flying = stability(Scene::builder("air").body(block("box", DVec3::ONE, 1.0, DVec3::Z * 3.0)).body(ground(0.5)));
    assert_eq!((flying.bodies, flying.friction.needed), (0, Some(0.0)));
    let rule = |friction| material("stone", friction);
    let over = block("over", DVec3::new(2.0, 1.0, 1.0), 1.0, DVec3::new(1.2, 0.0, 1.5)).material(rule(0.5));
    let under = block("under", DVec3::ONE, 1.0, DVec3::Z * 0.5).material(rule(0.5));
    let falling = stability(Scene::builder("over").body(ground(0.5)).body(under).body(over));
    assert_eq!(falling.friction.needed, None);
    assert!(falling.pushes.iter().all(|push| push.of_weight.is_none()));
}

/// A pyramid with a base of `base` cubes, with gaps between the cubes of a course.
fn pyramid(base: u32, friction: f64) -> Scene {
    let mut scene = Scene::builder("pyramid").body(ground(friction)).duration_s(1.0);
    for course in 0..base {
        for place in 0..base - course {
            let x = (f64::from(place) + 0.5 * f64::from(course)) * 0.44;
            let center = DVec3::new(x, 0.0, 0.2 + 0.4 * f64::from(course));
            let cube = block(&format!("{course} {place}"), DVec3::splat(0.4), 1.0, center);
            scene = scene.body(cube.material(material("stone", friction)));
        }
    }
    scene.build().unwrap()
}

/// A pyramid of 210 cubes stands: forces within the cones carry it, at the start and to the end, and it takes no steps
/// on the way. No fallback is needed, and no body moves at all.
#[test]
fn a_pyramid_of_hundreds_rests_from_the_start() {
    let scene = pyramid(20, 0.5);
    let mut simulation = Simulation::new(&scene).unwrap();
    assert_eq!(simulation.plan().tier, Tier::Accurate);
    let contacts = simulation.contacts();
    let on_ground = contacts.iter().filter(|contact| [contact.body_a, contact.body_b].iter().any(|b| b.index() == 0));
    let carried: f64 = on_ground.map(|contact| contact.normal_force_n).sum();
    // In planar motion one contact of each mirror pair stands for both.
    let weight = 210.0 * GRAVITY;
    assert!((carried / weight - 1.0).abs() < 1e-12 || (2.0 * carried / weight - 1.0).abs() < 1e-12, "{carried}");
    for contact in &contacts {
        let (normal, tangential) = (contact.normal_force_n, contact.friction_n.length());
        assert!(normal >= 0.0 && tangential <= 0.5 * normal * (1.0 + 1e-12), "{tangential} of {normal}");
    }
    let start: Vec<Pose> = simulation.bodies().iter().map(|body| body.pose).collect();
    let report = simulation.run().unwrap();
    assert_eq!(report.certificate.fallbacks, 0);
    assert!(report.steps <= 2, "{} steps", report.steps);
    let moved = simulation.bodies().iter().zip(&start).any(|(body, start)| body.pose != *start);
    assert!(!moved);
}

/// It needs hardly any friction, and what it bears across is that of its tallest column: half a width over the height
/// of its centre of mass, 0.2 m over 0.2 + (n - 1) 0.4/3.
#[test]
fn margins_of_a_pyramid() {
    let scene = pyramid(6, 0.5);
    let found = Simulation::with_effects(&scene, Effects::All).unwrap().stability().unwrap();
    let height = 0.2 + 5.0 * 0.4 / 3.0;
    assert!((push(&found, DVec3::Y) - 0.2 / height).abs() < MARGIN, "{}", push(&found, DVec3::Y));
    assert!((push(&found, DVec3::X) - 0.5).abs() < MARGIN);
}

/// A box beyond the edge of another one turns over that edge, whatever the friction: in the motion that is told no
/// contact closes, and its weight goes down.
#[test]
fn what_nothing_holds_turns_over_an_edge() {
    let size = DVec3::new(1.0, 1.0, 0.5);
    let low = block("low", size, 5.0, DVec3::Z * 0.25).material(material("wood", 0.8));
    let high = block("high", size, 5.0, DVec3::new(0.6, 0.0, 0.75)).material(material("wood", 0.8));
    let found = stability(Scene::builder("edge").body(ground(0.8)).body(low).body(high));
    assert_eq!(found.friction.needed, None);
    let begins = found.friction.begins.first().unwrap();
    assert_eq!((begins.body.index(), begins.beginning), (2, Beginning::Tips));
    let at_edge = begins.velocity.at(DVec3::new(0.5, 0.0, 0.5) - DVec3::new(0.6, 0.0, 0.75));
    assert!(at_edge.dot(DVec3::Z) > -1e-5, "{at_edge}");
    assert!(begins.velocity.linear.z < 0.0 && begins.velocity.angular.y > 0.1, "{:?}", begins.velocity);
}
