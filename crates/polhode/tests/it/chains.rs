//! Long chains: trees of joints that are eliminated link by link hold what hangs on them, whatever its mass, and lose
//! no energy.
//!
//! Oracles are statics (nothing accelerates; the forces themselves are tested in `polhode-response`) and conservation
//! of energy. Chains are so long that the joints are not solved for through the matrix of their rows.

use crate::joints::{assert_held, down, rod};
use crate::support::run;
use polhode::contact::Shape;
use polhode::mesh::{solid_box, solid_sphere};
use polhode::scene::{Joint, Material, Method, Tier};
use polhode::spatial::{DVec3, Mass, Pose, Rotation, UnitVector};
use polhode::{Body, BodyId, Effects, Geometry, Scene, SceneBuilder, Simulation};

const G: f64 = 9.81;

/// Length of a link, m.
const LINK: f64 = 0.1;

/// A chain of rods of these masses and angles that hangs at the origin, by hinges along y and ball joints in turn, in
/// steps of `step` (s) for `duration` (s).
pub(crate) fn chain(tier: Tier, links: &[(f64, f64)], (step, duration): (f64, f64)) -> SceneBuilder {
    let method = Method { tier: Some(tier), step_s: Some(step), ..Method::default() };
    let mut builder = Scene::builder("chain").method(method).duration_s(duration).gravity(DVec3::Z * -G);
    let mut top = DVec3::ZERO;
    for (number, &(mass, angle)) in links.iter().enumerate() {
        let body = rod(&format!("link {number}"), (mass, LINK), top + down(angle) * (0.5 * LINK), angle);
        let own = BodyId::new(number);
        let joint = if number % 2 == 0 { Joint::hinge(own, top, UnitVector::Y) } else { Joint::ball(own, top) };
        builder = builder.body(body).joint(if number > 0 { joint.with(BodyId::new(number - 1)) } else { joint });
        top += down(angle) * LINK;
    }
    builder
}

/// A hundred links of 1 kg, the last of them of a thousand tonnes.
#[test]
fn a_chain_bears_a_million_times_the_mass_of_a_link() {
    let mut links = vec![(1.0, 0.0); 100];
    links[99].0 = 1e6;
    for tier in [Tier::Stepped, Tier::Accurate] {
        let scene = chain(tier, &links, (0.05, 60.0)).build().unwrap();
        let mut simulation = Simulation::new(&scene).unwrap();
        let largest = |simulation: &mut Simulation| {
            let sizes = simulation.accelerations().unwrap();
            sizes.iter().map(|a| a.linear.length() + LINK * a.angular.length()).fold(0.0, f64::max)
        };
        // The links bear 1e7 N from both sides, whose rounding is 1e-9 N.
        assert!(largest(&mut simulation) < 1e-8, "{tier:?}: {}", largest(&mut simulation));
        simulation.advance_to(60.0).unwrap();
        for (number, start) in scene.bodies().iter().enumerate() {
            let body = simulation.body(BodyId::new(number));
            let moved = (body.pose.translation - start.initial_pose().translation).length();
            assert!(moved < 1e-12, "{tier:?}: {number} has moved by {moved} m");
            assert!(body.velocity.linear.length() < 1e-12, "{tier:?}: {number} {:?}", body.velocity);
        }
    }
}

/// Forty links that swing keep their energy, and stay together.
#[test]
fn a_chain_that_swings_keeps_its_energy() {
    let links: Vec<(f64, f64)> = (0..40).map(|k| (1.0 + 0.5 * f64::from(k % 3), 0.4 + 0.02 * f64::from(k))).collect();
    let scene = chain(Tier::Accurate, &links, (0.01, 0.3)).build().unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    assert_held(&report);
}

/// A chain of forty links that hangs by both ends, a loop with the world, keeps its energy and stays together: by all
/// but the last joint as a tree.
#[test]
fn a_chain_that_hangs_by_both_ends_keeps_its_energy() {
    let links: Vec<(f64, f64)> = (0..40).map(|k| (1.0, -1.2 + 0.06 * (f64::from(k) + 0.5))).collect();
    let end: DVec3 = links.iter().map(|&(_, angle)| down(angle) * LINK).sum();
    let last = Joint::ball(BodyId::new(39), end);
    let scene = chain(Tier::Accurate, &links, (0.01, 0.2)).joint(last).build().unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    assert_held(&report);
}

/// A bridge of thirty planks on hinges that hangs by both ends has rows that depend on each other: beside the trees
/// some are zero but for rounding, of either sign. A ball falls on it: contacts, friction and joints are solved
/// together, and what is told of the answer is its error, not rounding across the plane in which all moves.
#[test]
fn a_bridge_whose_rows_depend_on_each_other_bears_a_ball() {
    let method = Method { tier: Some(Tier::Stepped), step_s: Some(0.005), ..Method::default() };
    let wood = Material::new("wood").with_friction(0.4).unwrap();
    let mut scene = Scene::builder("bridge").method(method).duration_s(0.4).gravity(DVec3::Z * -G);
    let size = DVec3::new(LINK, 0.6, 0.02);
    let mut end = DVec3::ZERO;
    for number in 0..30 {
        let angle = -1.2 + 0.08 * (f64::from(number) + 0.5);
        let along = DVec3::new(angle.cos(), 0.0, angle.sin()) * LINK;
        let turn = Rotation::from_rotation_vector(DVec3::Y * -angle);
        let plank = Body::movable(format!("plank {number}"), solid_box(size, Mass::new(1.0).unwrap()).unwrap());
        let shape = Geometry::Shape(Shape::cuboid(size * DVec3::new(0.9, 1.0, 1.0)).unwrap());
        let plank = plank.geometry(shape).material(wood.clone()).pose(Pose::new(turn, end + along * 0.5));
        let own = scene.add_body(plank);
        let joint = Joint::hinge(own, end, UnitVector::Y);
        scene = scene.joint(if number > 0 { joint.with(BodyId::new(own.index() - 1)) } else { joint });
        end += along;
    }
    scene = scene.joint(Joint::hinge(BodyId::new(29), end, UnitVector::Y));
    let properties = solid_sphere(0.15, Mass::new(3.0).unwrap()).unwrap();
    let lowest = DVec3::new(0.5 * end.x, 0.05, -0.5);
    let ball = Body::movable("ball", properties).geometry(Geometry::Shape(Shape::sphere(0.15).unwrap()));
    let scene = scene.body(ball.material(wood).pose(Pose::from_translation(lowest))).build().unwrap();
    let (report, _) = run(&scene, Effects::Planned);
    assert!(report.events > 0, "the ball meets the bridge");
    assert!(report.certificate.max_residual < 1e-10, "{:?}", report.certificate);
}
