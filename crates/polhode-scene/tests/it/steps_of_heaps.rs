//! Time steps of many bodies: what may meet within a step is a row of its problem, so that bodies overlap by less than
//! a thousandth of their size at the end of any step, and moving them apart gives less than a thousandth of the energy.

use crate::scene;
use polhode::Simulation;

/// What the tier `stepped` promises, in parts of the smaller body's size and of the largest energy.
const OVERLAP: f64 = 1e-3;
const GIVEN: f64 = 1e-3;

/// A bin of five planes with walls at this distance from the middle, m.
fn bin(half_width: f64, friction: f64, step: f64, bodies: &str) -> String {
    let planes = [
        ("floor", [0.0, 0.0, 1.0], [0.0, 0.0]),
        ("left", [1.0, 0.0, 0.0], [-half_width, 0.0]),
        ("right", [-1.0, 0.0, 0.0], [half_width, 0.0]),
        ("front", [0.0, 1.0, 0.0], [0.0, -half_width]),
        ("back", [0.0, -1.0, 0.0], [0.0, half_width]),
    ];
    let plane = |(name, normal, [x, y]): (&str, [f64; 3], [f64; 2])| {
        format!(
            "[[bodies]]\nname = \"{name}\"\nfixed = true\nshape.half_space.normal = {normal:?}\n\
             position = [{x}, {y}, 0.0]\nmaterial = \"m\"\n"
        )
    };
    let planes: String = planes.map(plane).concat();
    format!(
        "format = 1\nname = \"bin\"\n[method]\ntier = \"stepped\"\nstep = {step}\n[materials.m]\n\
         friction = {friction}\n{planes}{bodies}"
    )
}

/// Runs a scene for so long (s), and checks overlap and energy; `size` is that of the smallest body, m.
#[track_caller]
fn check(text: &str, duration: f64, size: f64) {
    let mut simulation = Simulation::new(&scene(text)).unwrap();
    simulation.advance_to(duration).unwrap();
    let frame = simulation.frame();
    let overlap = frame.certificate.max_penetration_m / size;
    assert!(overlap < OVERLAP, "overlap of {overlap:.1e} of a body");
    let given = -frame.ledger.projection.value() / frame.energy.initial_j;
    assert!(given < GIVEN, "moving bodies apart has given {given:.1e} of the energy");
}

/// Balls in layers, not quite above each other, come down with 2 m/s.
fn balls(edge: u32) -> String {
    let mut text = String::new();
    for (layer, row, column) in (0..edge).flat_map(|l| (0..edge).flat_map(move |r| (0..edge).map(move |c| (l, r, c)))) {
        let [x, y, z] = [column, row, layer].map(f64::from);
        let shift = |k: f64| 0.01 * (1.7 * x + 2.9 * y + 4.3 * z + k).sin();
        let middle = 0.5 * f64::from(edge - 1);
        text.extend([format!(
            "[[bodies]]\nname = \"{layer} {row} {column}\"\nshape.sphere.radius = 0.195\nmass = 1.0\n\
             position = [{}, {}, {}]\nvelocity = [0, 0, -2.0]\nmaterial = \"m\"\n",
            (x - middle) * 0.42 + shift(0.0),
            (y - middle) * 0.42 + shift(1.0),
            0.2 + 0.42 * z
        )]);
    }
    text
}

#[test]
fn balls_that_fall_into_a_bin_overlap_in_no_step() {
    for friction in [0.0, 0.3] {
        check(&bin(0.89, friction, 0.01, &balls(4)), 0.25, 0.39);
    }
}

#[test]
fn boxes_that_tumble_into_a_bin_overlap_in_no_step() {
    let boxes = "[[arrays]]\nname = \"box\"\nshape.box.size = [0.3, 0.25, 0.2]\ndensity = 1000\nmaterial = \"m\"\n\
                 position = [-0.6, -0.6, 0.05]\nlayout.drop = { count = 24, size = [1.2, 1.2, 4.0], seed = 3 }\n";
    check(&bin(0.62, 0.5, 0.01, boxes), 0.5, 0.2);
}

/// A heavy ball pushes a light one, which rests, into a third that is far from both: the light one goes ten times as
/// far as its own motion says.
#[test]
fn what_a_faster_body_pushes_meets_what_is_in_its_way() {
    let ball = |name: &str, mass: f64, x: f64, v: f64| {
        format!(
            "[[bodies]]\nname = \"{name}\"\nshape.sphere.radius = 0.1\nmass = {mass}\n\
             position = [{x}, 0.0, 0.5]\nvelocity = [{v}, 0.0, 0.0]\nmaterial = \"m\"\n"
        )
    };
    let row = [ball("heavy", 100.0, -0.21, 8.0), ball("light", 0.1, 0.0, 0.0), ball("third", 1.0, 0.24, 0.0)];
    check(&bin(2.0, 0.0, 0.01, &row.concat()), 0.1, 0.2);
}

/// A puck with this shape and half height (m) on so many tiles of 0.3 m, which are turned about the vertical as a
/// whole. Returns how much of its velocity is left after it has passed them, and how much it turns.
fn over_tiles(shape: &str, half_height: f64, (speed, turn): (f64, f64)) -> [f64; 2] {
    let tiles = 6;
    let along = |s: f64| [s * turn.cos(), s * turn.sin()];
    let mut text = String::from("format = 1\nname = \"seam\"\n[method]\ntier = \"stepped\"\n");
    for tile in 0..tiles {
        let [x, y] = along(0.3 * f64::from(tile));
        text.extend([format!(
            "[[bodies]]\nname = \"t{tile}\"\nfixed = true\nshape.box.size = [0.3, 1.0, 0.1]\n\
             rotation_vector = [0, 0, {turn}]\nposition = [{x}, {y}, -0.05]\n"
        )]);
    }
    let ([x, y], [vx, vy]) = (along(-0.075), along(speed));
    text.extend([format!(
        "[[bodies]]\nname = \"puck\"\n{shape}\nmass = 0.7\nrotation_vector = [0, 0, {turn}]\n\
         position = [{x}, {y}, {half_height}]\nvelocity = [{vx}, {vy}, 0]\n"
    )]);
    let mut simulation = Simulation::new(&scene(&text)).unwrap();
    simulation.advance_to((0.3 * f64::from(tiles) - 0.25) / speed).unwrap();
    let frame = simulation.frame();
    let puck = frame.bodies.last().unwrap().velocity;
    let [vx, vy] = along(1.0);
    [(puck.linear.x * vx + puck.linear.y * vy) / speed, puck.angular.length()]
}

#[test]
fn a_puck_passes_the_seams_of_flush_tiles() {
    let prism = "shape.cylinder = { radius = 0.05, height = 0.065 }";
    let shapes =
        [(prism, 0.0325), ("shape.box.size = [0.1, 0.08, 0.06]", 0.03), ("shape.box.size = [0.09, 0.09, 0.02]", 0.01)];
    for (shape, half_height) in shapes {
        for motion in [(1.1, 0.0), (2.3, 0.0), (1.1, 0.7)] {
            let [speed, spin] = over_tiles(shape, half_height, motion);
            assert!((speed - 1.0).abs() < 1e-9 && spin < 1e-9, "{shape} at {motion:?}: {speed}, {spin} rad/s");
        }
    }
}
