//! Twenty scenes whose motion is chaotic: a difference of rounding at the start grows to a hundredth of a body.

use polhode::scene::Tier;
use polhode_oracles::random::Random;
use std::fmt::Write as _;
use std::path::Path;

/// A chaotic scene.
pub(super) struct Chaotic {
    pub(super) name: String,
    /// The scene file.
    pub(super) text: String,
    pub(super) tier: Tier,
    pub(super) duration_s: f64,
}

/// Step of scenes in the tier `stepped`, s.
const STEP_S: f64 = 0.002;
/// Heaps of boxes, and of balls: how many.
const BOXES: [u32; 2] = [12, 16];
const BALLS: u32 = 20;
/// Dominoes in a row.
const DOMINOES: u32 = 8;

/// The scenes, of the workspace in this folder.
pub(super) fn all(root: &Path) -> Vec<Chaotic> {
    let mut all = Vec::new();
    for degrees in [[90.0f64, 90.0], [120.0, -10.0], [170.0, 170.0]] {
        all.push(chain(&format!("double pendulum at {degrees:?}"), &degrees.map(f64::to_radians), Support::Still));
    }
    all.push(chain("driven pendulum of two rods", &[0.2, 0.1], Support::Driven(2.0)));
    all.push(chain("driven chain of three rods", &[0.3, -0.2, 0.1], Support::Driven(1.5)));
    all.push(attracting("three bodies that attract each other", 3, 60.0));
    all.push(attracting("four bodies that attract each other", 4, 25.0));
    all.extend((1..=4).map(billiard));
    all.extend((2..=5).map(dice));
    all.extend(BOXES.map(|count| heap(&format!("heap of {count} boxes"), count, Thrown::Box)));
    all.push(heap("heap of balls", BALLS, Thrown::Ball));
    all.extend(ragdoll(root));
    all.push(dominoes());
    all
}

/// The head of a scene file.
fn head(name: &str, tier: Tier, duration_s: f64, gravity: f64) -> String {
    let step = if tier == Tier::Stepped { format!("step = {STEP_S:?}\n") } else { String::new() };
    format!(
        "format = 1\nname = \"{name}\"\nduration = {duration_s:?}\ngravity = [0.0, 0.0, {:?}]\n[method]\n\
         tier = \"{}\"\n{step}",
        -gravity,
        tier.name()
    )
}

/// What a chain hangs from.
#[derive(Clone, Copy)]
enum Support {
    /// A fixed point.
    Still,
    /// A point that swings along x so often each second.
    Driven(f64),
}

/// A chain of rods of 1 m at these angles from hanging, at rest.
fn chain(name: &str, angles: &[f64], support: Support) -> Chaotic {
    let (tier, duration_s) = (Tier::Accurate, if let Support::Driven(_) = support { 14.0 } else { 45.0 });
    let mut text = head(name, tier, duration_s, 9.81);
    if let Support::Driven(frequency) = support {
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"support\"\nshape.sphere.radius = 0.01\n\
             motion.sine = {{ amplitude = [0.3, 0, 0], frequency = {frequency:?}, \
             phase = 1.5707963267948966 }}"
        );
    }
    let mut joints = String::new();
    let mut end = [0.0, 0.0];
    for (number, angle) in angles.iter().enumerate() {
        let (sine, cosine) = (libm::sin(*angle), libm::cos(*angle));
        let middle = [end[0] + 0.5 * sine, end[1] - 0.5 * cosine];
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"rod {number}\"\nmass = 1.0\ninertia = [0.0836, 0.0837, 0.0005]\n\
             rotation_vector = [0, {:?}, 0]\nposition = [{:?}, 0, {:?}]",
            -angle, middle[0], middle[1]
        );
        let other = match (number, support) {
            (0, Support::Still) => String::new(),
            (0, Support::Driven(_)) => ", \"support\"".to_owned(),
            _ => format!(", \"rod {}\"", number - 1),
        };
        let _ = writeln!(
            joints,
            "[[joints]]\ntype.hinge = {{ bodies = [\"rod {number}\"{other}], anchor = [{:?}, 0, {:?}], \
             axis = [0, 1, 0] }}",
            end[0], end[1]
        );
        end = [end[0] + sine, end[1] - cosine];
    }
    Chaotic { name: name.to_owned(), text: text + &joints, tier, duration_s }
}

/// Balls without a surface that attract each other, bound to each other.
fn attracting(name: &str, count: u32, duration_s: f64) -> Chaotic {
    let tier = Tier::Accurate;
    let mut text = head(name, tier, duration_s, 0.0);
    for number in 0..count {
        let angle = std::f64::consts::TAU * f64::from(number) / f64::from(count) + 0.3 * f64::from(number);
        let (x, y) = (libm::cos(angle), libm::sin(angle));
        let (far, fast) = (1.0 + 0.2 * f64::from(number), 0.6 - 0.1 * f64::from(number));
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"body {number}\"\nmass = {:?}\ninertia = [0.001, 0.001, 0.001]\n\
             position = [{:?}, {:?}, {:?}]\nvelocity = [{:?}, {:?}, 0.0]",
            1.0 + 0.3 * f64::from(number),
            far * x,
            far * y,
            0.05 * f64::from(number),
            -fast * y,
            fast * x
        );
    }
    text.push_str("[[forces]]\ntype.mutual_gravity = { constant = 1.0 }\n");
    Chaotic { name: name.to_owned(), text, tier, duration_s }
}

/// Smooth balls that bounce for ever between walls and fixed balls.
fn billiard(seed: u64) -> Chaotic {
    let (name, tier, duration_s) = (format!("billiard {seed}"), Tier::Accurate, 30.0);
    let mut random = Random(seed);
    let mut text = head(&name, tier, duration_s, 0.0);
    text.push_str("[materials.ivory]\nrestitution = 1.0\n");
    walls(&mut text, "ivory", &[[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]], 1.0);
    for (number, place) in [[-0.4, -0.3], [0.45, 0.2], [-0.1, 0.55]].iter().enumerate() {
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"post {number}\"\nfixed = true\nmaterial = \"ivory\"\nshape.sphere.radius = 0.2\n\
             position = [{:?}, {:?}, 0.0]",
            place[0], place[1]
        );
    }
    for number in 0..=seed % 2 {
        let (x, y) = if number == 0 { (0.3, -0.5) } else { (0.6, 0.7) };
        let angle = random.between(0.0, std::f64::consts::TAU);
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"ball {number}\"\nmass = 1.0\nmaterial = \"ivory\"\nshape.sphere.radius = 0.05\n\
             position = [{x:?}, {y:?}, 0.0]\nvelocity = [{:?}, {:?}, 0.0]",
            2.0 * libm::cos(angle),
            2.0 * libm::sin(angle)
        );
    }
    Chaotic { name, text, tier, duration_s }
}

/// Half-spaces with these normals, each so far from the origin, m.
fn walls(text: &mut String, material: &str, normals: &[[f64; 3]], far: f64) {
    for (number, normal) in normals.iter().enumerate() {
        let place = normal.map(|part| -part * far);
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"wall {number}\"\nfixed = true\nmaterial = \"{material}\"\n\
             shape.half_space.normal = {normal:?}\nposition = {place:?}"
        );
    }
}

/// What is thrown.
#[derive(Clone, Copy)]
enum Thrown {
    Box,
    Ball,
}

impl Thrown {
    /// The lines of a body that turns and moves anyhow.
    fn body(self, name: &str, place: [f64; 3], speed: f64, random: &mut Random) -> String {
        let mut vector = |size: f64| [0; 3].map(|_| random.between(-size, size));
        let (turn, velocity, spin) = (vector(3.0), vector(speed), vector(4.0 * speed));
        let shape = match self {
            Self::Box => "shape.box.size = [0.2, 0.2, 0.2]",
            Self::Ball => "shape.sphere.radius = 0.1",
        };
        format!(
            "[[bodies]]\nname = \"{name}\"\nmass = 1.0\nmaterial = \"m\"\n{shape}\nposition = {place:?}\n\
             rotation_vector = {turn:?}\nvelocity = {velocity:?}\nangular_velocity = {spin:?}\n"
        )
    }
}

/// Dice that are thrown on a floor, and tumble over each other.
fn dice(seed: u64) -> Chaotic {
    let (name, tier, duration_s) = (format!("dice {seed}"), Tier::Stepped, 5.0);
    let mut random = Random(100 + seed);
    let mut text = head(&name, tier, duration_s, 9.81);
    text.push_str("[materials.m]\nfriction = 0.3\nrestitution = 0.95\n");
    walls(&mut text, "m", &[[0.0, 0.0, 1.0]], 0.0);
    walls_around(&mut text, 0.5);
    for number in 0..=seed {
        let place = [random.between(-0.2, 0.2), random.between(-0.2, 0.2), 0.6 + 0.4 * number as f64];
        text.push_str(&Thrown::Box.body(&format!("die {number}"), place, 5.0, &mut random));
    }
    Chaotic { name, text, tier, duration_s }
}

/// Four walls around a floor, so far from its middle, m.
fn walls_around(text: &mut String, far: f64) {
    for (number, normal) in [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]].iter().enumerate() {
        let place = normal.map(|part: f64| -part * far);
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"side {number}\"\nfixed = true\nmaterial = \"m\"\n\
             shape.half_space.normal = {normal:?}\nposition = {place:?}"
        );
    }
}

/// Bodies that fall on each other in a box.
fn heap(name: &str, count: u32, thrown: Thrown) -> Chaotic {
    let (tier, duration_s) = (Tier::Stepped, 3.0);
    let mut random = Random(200 + u64::from(count));
    let mut text = head(name, tier, duration_s, 9.81);
    text.push_str("[materials.m]\nfriction = 0.1\nrestitution = 0.95\n");
    walls(&mut text, "m", &[[0.0, 0.0, 1.0]], 0.0);
    walls_around(&mut text, 0.5);
    for number in 0..count {
        let [x, y] = [number % 2, number / 2 % 2].map(|half| 0.44 * f64::from(half) - 0.22);
        let height = 0.3 + 0.4 * f64::from(number / 4);
        let place = [x + random.between(-0.02, 0.02), y + random.between(-0.02, 0.02), height];
        text.push_str(&thrown.body(&format!("body {number}"), place, 1.5, &mut random));
    }
    Chaotic { name: name.to_owned(), text, tier, duration_s }
}

/// Dominoes that bounce against each other as they fall.
fn dominoes() -> Chaotic {
    let (name, tier, duration_s) = ("dominoes".to_owned(), Tier::Stepped, 1.0);
    let mut text = head(&name, tier, duration_s, 9.81);
    text.push_str("[materials.m]\nfriction = 0.4\nrestitution = 0.75\n");
    walls(&mut text, "m", &[[0.0, 0.0, 1.0]], 0.0);
    for number in 0..DOMINOES {
        let moving = if number == 0 { "velocity = [0.072, 0, 0.01125]\nangular_velocity = [0, 3, 0]\n" } else { "" };
        let _ = writeln!(
            text,
            "[[bodies]]\nname = \"domino {number}\"\nmass = 0.01\nmaterial = \"m\"\n\
             shape.box.size = [0.0075, 0.024, 0.048]\nposition = [{:?}, {:?}, 0.024]\n{moving}",
            0.0275 * f64::from(number),
            0.002 * f64::from(number % 3)
        );
    }
    Chaotic { name, text, tier, duration_s }
}

/// The ragdoll that ships, of rubber; none where it cannot be read.
fn ragdoll(root: &Path) -> Option<Chaotic> {
    let name = "ragdoll-on-stairs";
    let text = std::fs::read_to_string(root.join(format!("fixtures/scenes/{name}.toml"))).ok()?;
    let text = text.replace("friction = 0.4", "friction = 0.4\nrestitution = 0.95");
    let text = text.replace("velocity = [1.2, 0, 0]", "velocity = [1.5, 0.4, 1.0]");
    Some(Chaotic { name: format!("{name}, of rubber"), text, tier: Tier::Stepped, duration_s: 4.2 })
}
