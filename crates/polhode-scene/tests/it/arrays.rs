//! Arrays of bodies: many equal ones in a layout.
//!
//! They are the bodies that a scene written out in full would have, to the bit; those of a drop are apart, inside their
//! region, the same for the same seed; and every mistake is refused at its key.

use crate::{check, scene};
use polhode::Scene;
use polhode::spatial::DVec3;

/// A scene of one array of cubes.
fn array(keys: &str) -> String {
    format!(
        "format = 1\n[materials.stone]\nfriction = 0.5\n[[arrays]]\nname = \"cube\"\nshape.box.size = [0.4, 0.4, 0.4]\n\
         mass = 2\nmaterial = \"stone\"\n{keys}\n"
    )
}

fn names(scene: &Scene) -> Vec<&str> {
    scene.bodies().iter().map(polhode::Body::name).collect()
}

fn positions(scene: &Scene) -> Vec<DVec3> {
    scene.bodies().iter().map(|body| body.initial_pose().translation).collect()
}

#[test]
fn a_grid_stands_in_rows_columns_and_layers() {
    let found = scene(&array("position = [1, 2, 3]\nlayout.grid = { counts = [2, 1, 2], spacing = [0.5, 0, 0.4] }"));
    assert_eq!(names(&found), ["cube-1-1-1", "cube-2-1-1", "cube-1-1-2", "cube-2-1-2"]);
    let expected = [[1.0, 2.0, 3.0], [1.5, 2.0, 3.0], [1.0, 2.0, 3.4], [1.5, 2.0, 3.4]];
    assert_eq!(positions(&found), expected.map(DVec3::from_array));
    for body in found.bodies() {
        assert_eq!(body.mass_properties().unwrap().mass(), 2.0);
        assert_eq!(body.initial_pose().rotation.to_wxyz(), [1.0, 0.0, 0.0, 0.0]);
    }
}

/// The courses of a pyramid have one body fewer each; every second one of a wall begins and ends with half a brick,
/// flush with the ends of the others: every body stands over the joint of two, and none juts out.
#[test]
fn courses_stand_over_the_joints_of_those_below() {
    let pyramid = scene(&array("position = [0, 0, 0.2]\nlayout.pyramid = { base = 3, spacing = [0.5, 0.4] }"));
    assert_eq!(names(&pyramid), ["cube-1-1", "cube-1-2", "cube-1-3", "cube-2-1", "cube-2-2", "cube-3-1"]);
    assert_eq!(positions(&pyramid).map_x(), [0.0, 0.5, 1.0, 0.25, 0.75, 0.5]);
    let wall = scene(&array("layout.wall = { length = 3, height = 3, spacing = [0.5, 0.4] }"));
    assert_eq!(positions(&wall).map_x(), [0.0, 0.5, 1.0, -0.1, 0.25, 0.75, 1.1, 0.0, 0.5, 1.0]);
    assert_eq!(names(&wall)[3..7], ["cube-2-1", "cube-2-2", "cube-2-3", "cube-2-4"]);
    let masses: Vec<f64> = wall.bodies().iter().map(|body| body.mass_properties().unwrap().mass()).collect();
    assert_eq!(masses, [2.0, 2.0, 2.0, 1.0, 2.0, 2.0, 1.0, 2.0, 2.0, 2.0]);
}

/// An arch of n stones over an opening: every stone is the one before it, turned by the opening over n about the centre
/// of the arch, and the joint at its ends lies on the ground of a semicircle. Fixed springers do not move.
#[test]
fn an_arch_is_turned_stones() {
    let arch = |keys: &str| {
        scene(&format!(
            "format = 1\n[[arrays]]\nname = \"stone\"\ndensity = 2000\nposition = [1, 2, 3]\n\
             layout.arch = {{ radius = 2, thickness = 0.5, width = 0.4, {keys} }}\n"
        ))
    };
    let found = arch("count = 5");
    assert_eq!(names(&found), ["stone-1", "stone-2", "stone-3", "stone-4", "stone-5"]);
    for (k, body) in found.bodies().iter().enumerate() {
        let pose = body.initial_pose();
        let angle = (k as f64 - 2.0) * std::f64::consts::PI / 5.0;
        let outwards = DVec3::new(angle.sin(), 0.0, angle.cos());
        assert!((pose.rotation.rotate(DVec3::X) - outwards).length() < 1e-15, "{k}");
        assert!((pose.rotation.rotate(DVec3::Z) + DVec3::Y).length() < 1e-15, "{k}");
        assert_eq!(pose.translation, DVec3::new(1.0, 2.0, 3.0));
        // 2000 kg/m^3 times half the sine of its angle, the difference of the squares of its radii, and its width.
        let mass = 2000.0 * 0.5 * (std::f64::consts::PI / 5.0).sin() * (2.25 * 2.25 - 1.75 * 1.75) * 0.4;
        assert!((body.mass_properties().unwrap().mass() / mass - 1.0).abs() < 1e-14);
    }
    let fixed = arch("count = 6, opening = 1.2, springers = \"fixed\", turn = 1.5707963267948966");
    let moves: Vec<bool> = fixed.bodies().iter().map(|body| !body.is_fixed()).collect();
    assert_eq!(moves, [false, true, true, true, true, false]);
    assert!(fixed.bodies()[0].initial_pose().rotation.rotate(DVec3::X).x.abs() < 1e-15);
}

/// Bodies of a ring stand around the vertical, each turned with its place; wedges that close a circle touch and do not
/// overlap.
#[test]
fn a_ring_is_turned_about_the_vertical() {
    let found = scene(&array("position = [1, 0, 0.2]\nlayout.ring = { count = 4, radius = 3 }"));
    let expected = [[4.0, 0.0, 0.2], [1.0, 3.0, 0.2], [-2.0, 0.0, 0.2], [1.0, -3.0, 0.2]];
    for (place, expected) in positions(&found).iter().zip(expected) {
        assert!((*place - DVec3::from_array(expected)).length() < 1e-14, "{place}");
    }
    assert!((found.bodies()[1].initial_pose().rotation.rotate(DVec3::X) - DVec3::Y).length() < 1e-15);
    let angle = std::f64::consts::TAU / 7.0;
    let well = array("layout.ring = { count = 7 }").replace(
        "shape.box.size = [0.4, 0.4, 0.4]",
        &format!("shape.wedge = {{ inner_radius = 1, outer_radius = 2, angle = {angle}, width = 1 }}"),
    );
    assert!(polhode::Simulation::new(&scene(&well)).is_ok());
}

/// Every mistake in a ring or an arch is refused at its key.
#[test]
fn mistakes_in_rings_and_arches_are_refused() {
    let arch = |keys: &str| {
        array(&format!("layout.arch = {{ width = 1, {keys} }}")).replace("shape.box.size = [0.4, 0.4, 0.4]\n", "")
    };
    for (keys, key, message) in [
        ("count = 0, radius = 1, thickness = 0.1", "count", "at least 1"),
        ("count = 1, radius = 1, thickness = 0.1", "count", "less than half a turn"),
        ("count = 9, radius = -1, thickness = 0.1", "radius", "positive"),
        ("count = 9, radius = 1, thickness = 2", "thickness", "below twice the radius"),
        ("count = 9, radius = 1, thickness = 0.1, opening = 7", "opening", "whole turn"),
        ("count = 9, radius = 1, thickness = 0.1, springers = \"stiff\"", "springers", "accepted: `loose` or `fixed`"),
    ] {
        check(&arch(keys), &format!("arrays.cube.layout.arch.{key}"), key, message);
    }
    let shaped = array("layout.arch = { count = 9, radius = 1, thickness = 0.1, width = 1 }");
    check(&shaped, "arrays.cube.shape", "shape", "an arch, whose stones are wedges of its own");
    check(&array("layout.ring = { count = 3, radius = -1 }"), "arrays.cube.layout.ring.radius", "radius", "at least 0");
}

trait Abscissas {
    fn map_x(&self) -> Vec<f64>;
}

impl Abscissas for Vec<DVec3> {
    fn map_x(&self) -> Vec<f64> {
        self.iter().map(|position| position.x).collect()
    }
}

/// `turn` turns places and bodies about the vertical through `position`: a wall along y is one along x, turned.
#[test]
fn a_layout_can_be_turned() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let wall = format!(
        "position = [1, 0, 0]\nlayout.wall = {{ length = 2, height = 1, spacing = [0.5, 0.4], turn = {quarter} }}"
    );
    let found = scene(&array(&wall));
    assert!((positions(&found)[1] - DVec3::new(1.0, 0.5, 0.0)).length() < 1e-15);
    let turned = found.bodies()[1].initial_pose().rotation.rotate(DVec3::X);
    assert!((turned - DVec3::Y).length() < 1e-15, "{turned}");
}

/// A body keeps its own orientation in a layout: logs that lie along y, in a pile.
#[test]
fn bodies_keep_their_orientation() {
    let text = array("rotation_vector = [1.5707963267948966, 0, 0]\nlayout.pyramid = { base = 2, spacing = [1, 0.9] }");
    for body in scene(&text).bodies() {
        assert!((body.initial_pose().rotation.rotate(DVec3::Z) + DVec3::Y).length() < 1e-15);
    }
}

/// Bodies of a drop lie in its region, and the balls that hold them are apart; the seed determines all of it.
#[test]
fn a_drop_is_apart_and_repeats() {
    let drop = |count: u32, seed: u32| {
        let keys = "position = [-1, -2, 0.5]";
        scene(&array(&format!("{keys}\nlayout.drop = {{ count = {count}, size = [2, 4, 6], seed = {seed} }}")))
    };
    let radius = DVec3::splat(0.2).length();
    for count in [1, 7, 60] {
        let found = drop(count, 3);
        let places = positions(&found);
        assert_eq!(places.len(), count as usize);
        assert_eq!(names(&found).last(), Some(&format!("cube-{count}").as_str()));
        for (i, place) in places.iter().enumerate() {
            let (low, high) = (DVec3::new(-1.0, -2.0, 0.5), DVec3::new(1.0, 2.0, 6.5));
            assert!(place.cmpge(low + radius).all() && place.cmple(high - radius).all(), "{place}");
            assert!(places[..i].iter().all(|other| other.distance(*place) > 2.0 * radius));
        }
        assert_eq!(positions(&drop(count, 3)), places);
        assert_ne!(positions(&drop(count, 4)), places);
    }
    // No direction is preferred: the mean of a body's axis over many is small.
    let many = drop(60, 1);
    let mean = many.bodies().iter().map(|body| body.initial_pose().rotation.rotate(DVec3::Z)).sum::<DVec3>() / 60.0;
    assert!(mean.length() < 4.0 / f64::sqrt(60.0), "{mean}");
}

/// Ten lines make a pile of ten thousand.
#[test]
fn ten_lines_make_ten_thousand() {
    let text = array("position = [-5, -5, 0.1]\nlayout.drop = { count = 10000, size = [10, 10, 60], seed = 1 }");
    assert!(text.lines().count() <= 10);
    assert_eq!(scene(&text).bodies().len(), 10_000);
}

/// What refers to bodies finds those of arrays by name, and a force on all bodies acts on them too.
#[test]
fn bodies_of_arrays_have_names() {
    let text = array("layout.grid = { counts = [3, 1, 1], spacing = [1, 0, 0] }");
    let more = "[[forces]]\ntype.drag = { law = \"linear\", translational = 1 }\n[[forces]]\n\
        type.force = { body = \"cube-2-1-1\", force = [1, 0, 0] }\n[[no_contact]]\n\
        bodies = [\"cube-1-1-1\", \"cube-3-1-1\"]\n";
    assert_eq!(scene(&(text.clone() + more)).forces().len(), 4);
    let wrong = text + "[[forces]]\ntype.force = { body = \"cube-4-1-1\", force = [1, 0, 0] }\n";
    check(&wrong, "forces.0.type.force.body", "cube-4-1-1", "no body is named `cube-4-1-1`");
}

/// Every mistake in an array is refused at its key.
#[test]
fn mistakes_are_refused() {
    let cases = [
        ("", "arrays.cube", "[[arrays]]", "missing key `layout`"),
        ("layout = {}", "arrays.cube.layout", "layout", "one of grid, pyramid, wall, ring, arch or drop"),
        (
            "layout.pyramid = { base = 2, spacing = [1, 1] }\n\
             layout.wall = { length = 2, height = 2, spacing = [1, 1] }",
            "arrays.cube.layout",
            "layout",
            "one of grid, pyramid, wall, ring, arch or drop",
        ),
        (
            "layout.heap = { count = 3 }",
            "arrays.cube.layout.heap",
            "heap",
            "accepted: `grid`, `pyramid`, `wall`, `ring`, `arch`, `drop`",
        ),
        ("layout.pyramid = { base = 0, spacing = [1, 1] }", "arrays.cube.layout.pyramid.base", "base", "at least 1"),
        ("layout.pyramid = { base = -1, spacing = [1, 1] }", "arrays.cube.layout.pyramid.base", "base", "whole number"),
        (
            "layout.pyramid = { base = 2.5, spacing = [1, 1] }",
            "arrays.cube.layout.pyramid.base",
            "base",
            "whole number",
        ),
        ("layout.pyramid = { base = 2 }", "arrays.cube.layout.pyramid", "pyramid", "missing key `spacing`"),
        (
            "layout.pyramid = { base = 2, spacing = [1, 0] }",
            "arrays.cube.layout.pyramid.spacing.1",
            "spacing",
            "positive",
        ),
        ("layout.pyramid = { base = 1000000000, spacing = [1, 1] }", "arrays.cube.layout", "layout", "2^31 pairs"),
        (
            "layout.wall = { length = 1, height = 2, spacing = [1, 1] }",
            "arrays.cube.layout.wall.length",
            "length",
            "at least 2",
        ),
        (
            "layout.wall = { length = 2, height = 0, spacing = [1, 1] }",
            "arrays.cube.layout.wall.height",
            "height",
            "at least 1",
        ),
    ];
    for (keys, key, shown, message) in cases {
        check(&array(keys), key, shown, message);
    }
}

/// The same of grids, drops and the keys of the body.
#[test]
fn mistakes_in_grids_drops_and_bodies_are_refused() {
    let cases = [
        (
            "layout.grid = { counts = [4000000000, 4000000000, 4000000000], spacing = [1, 1, 1] }",
            "arrays.cube.layout",
            "layout",
            "may have 65536",
        ),
        (
            "layout.grid = { counts = [2, 0, 2], spacing = [1, 1, 1] }",
            "arrays.cube.layout.grid.counts.1",
            "counts",
            "at least 1",
        ),
        (
            "layout.grid = { counts = [2, 2], spacing = [1, 1, 1] }",
            "arrays.cube.layout.grid.counts",
            "counts",
            "length 3",
        ),
        (
            "layout.grid = { counts = [2, 2, 2], spacing = [1, 0, 1] }",
            "arrays.cube.layout.grid.spacing.1",
            "spacing",
            "not zero",
        ),
        (
            "layout.grid = { counts = [2, 2, 2], spacing = [1, nan, 1] }",
            "arrays.cube.layout.grid.spacing.1",
            "spacing",
            "finite",
        ),
        ("layout.drop = { count = 0, size = [1, 1, 1] }", "arrays.cube.layout.drop.count", "count", "at least 1"),
        (
            "layout.drop = { count = 30, size = [2, 2, 2] }",
            "arrays.cube.layout.drop.count",
            "count",
            "room for 8 of 30",
        ),
        ("layout.drop = { count = 1, size = [2, -2, 2] }", "arrays.cube.layout.drop.size.1", "size", "positive"),
        (
            "layout.drop = { count = 1, size = [2, 2, 2], seed = -1 }",
            "arrays.cube.layout.drop.seed",
            "seed",
            "whole number",
        ),
        (
            "rotation_vector = [1, 0, 0]\nlayout.drop = { count = 1, size = [2, 2, 2] }",
            "arrays.cube.rotation_vector",
            "rotation_vector",
            "a drop, which turns its bodies at random",
        ),
        (
            "pivot = [0, 0, 0]\nlayout.pyramid = { base = 2, spacing = [1, 1] }",
            "arrays.cube.pivot",
            "pivot",
            "unknown key",
        ),
        (
            "velocity = [0, 0, inf]\nlayout.pyramid = { base = 2, spacing = [1, 1] }",
            "arrays.cube.velocity.2",
            "velocity",
            "finite",
        ),
    ];
    for (keys, key, shown, message) in cases {
        check(&array(keys), key, shown, message);
    }
}

/// A drop needs a shape, a wall boxes that lie along it, and both the keys of a body in order.
#[test]
fn mistakes_in_the_body_of_an_array_are_refused() {
    let nothing = array("layout.drop = { count = 1, size = [2, 2, 2] }")
        .replace("shape.box.size = [0.4, 0.4, 0.4]", "inertia = [1, 1, 1]");
    check(&nothing, "arrays.cube.layout.drop", "drop", "`shape`, of a finite size");
    let ball = array("layout.wall = { length = 2, height = 2, spacing = [1, 1] }")
        .replace("shape.box.size = [0.4, 0.4, 0.4]", "shape.sphere.radius = 0.2");
    check(&ball, "arrays.cube.layout.wall", "layout", "needs `shape.box`");
    let bricks = "layout.wall = { length = 2, height = 2, spacing = [1, 1] }";
    check(&array(&format!("inertia = [1, 1, 1]\n{bricks}")), "arrays.cube.inertia", "inertia", "half bricks");
    let turned = array(&format!("rotation_vector = [1, 0, 0]\n{bricks}"));
    check(&turned, "arrays.cube.rotation_vector", "rotation_vector", "`turn` turns it");
    let heavy = array("layout.pyramid = { base = 2, spacing = [1, 1] }").replace("mass = 2", "mass = -2");
    check(&heavy, "arrays.cube.mass", "mass = -2", "positive number of kilograms");
}

/// Names of arrays must not lead to the same names of bodies.
#[test]
fn names_differ() {
    let text = array("layout.grid = { counts = [1, 1, 1], spacing = [1, 1, 1] }");
    let twice = text.clone()
        + "[[arrays]]\nname = \"cube-1\"\nshape.sphere.radius = 1\nmass = 1\n\
            layout.pyramid = { base = 1, spacing = [1, 1] }\n";
    check(&twice, "arrays.cube.name", "name", "two bodies are named `cube-1-1-1`");
    let beside = text + "[[bodies]]\nname = \"cube-1-1-1\"\nfixed = true\n";
    check(&beside, "arrays.cube.name", "name", "two bodies are named `cube-1-1-1`");
}
