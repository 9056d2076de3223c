//! Scenes of many boxes and spheres, as plain data that both engines are built from.
//!
//! Lengths in m, masses in kg. Floors and walls are half-spaces. Cubes of 1 m and 1 kg where nothing else is said.

use polhode::spatial::{DVec3, Pose, Rotation};

/// The shape of a movable body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Form {
    /// A box with these full edges, m.
    Box(DVec3),
    /// A sphere of this radius, m.
    Sphere(f64),
}

impl Form {
    /// Radius of a sphere around it, m.
    pub(crate) fn reach(self) -> f64 {
        match self {
            Self::Box(edges) => 0.5 * edges.length(),
            Self::Sphere(radius) => radius,
        }
    }

    /// Principal moments of inertia for a mass, kg m^2.
    pub(crate) fn moments(self, mass: f64) -> DVec3 {
        match self {
            Self::Box(edges) => {
                let squares = edges * edges;
                DVec3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y) * (mass / 12.0)
            }
            Self::Sphere(radius) => DVec3::splat(0.4 * mass * radius * radius),
        }
    }
}

/// A movable body.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Member {
    pub(crate) form: Form,
    pub(crate) mass: f64,
    pub(crate) pose: Pose,
    /// It does not turn.
    pub(crate) velocity: DVec3,
}

/// A half-space: what lies below a plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    pub(crate) point: DVec3,
    /// Unit vector out of it.
    pub(crate) normal: DVec3,
}

/// One scene.
#[derive(Debug, Clone)]
pub(crate) struct Scene {
    pub(crate) name: &'static str,
    pub(crate) members: Vec<Member>,
    pub(crate) planes: Vec<Plane>,
    pub(crate) friction: f64,
    /// s.
    pub(crate) step: f64,
    pub(crate) steps: usize,
    /// Whether it can stand, so that drift is an error.
    pub(crate) stands: bool,
}

const FLOOR: Plane = Plane { point: DVec3::ZERO, normal: DVec3::Z };
const STEP: f64 = 1.0 / 60.0;

fn member(form: Form, mass: f64, place: DVec3) -> Member {
    Member { form, mass, pose: Pose::from_translation(place), velocity: DVec3::ZERO }
}

fn standing(name: &'static str, members: Vec<Member>, friction: f64, steps: usize) -> Scene {
    Scene { name, members, planes: vec![FLOOR], friction, step: STEP, steps, stands: true }
}

/// A pyramid of cubes, 0.1 m apart beside each other.
fn pyramid(name: &'static str, base: usize, steps: usize) -> Scene {
    let place = |row: usize, k: usize| DVec3::new((k as f64 + 0.5 * row as f64) * 1.1, 0.0, row as f64 + 0.5);
    let cubes = (0..base).flat_map(|row| (0..base - row).map(move |k| place(row, k)));
    standing(name, cubes.map(|at| member(Form::Box(DVec3::ONE), 1.0, at)).collect(), 0.5, steps)
}

/// The same, a cube of the second row hit from the side.
fn hit_pyramid(name: &'static str, base: usize, steps: usize) -> Scene {
    let mut scene = pyramid(name, base, steps);
    if let Some(cube) = scene.members.get_mut(base + base / 2) {
        cube.velocity = DVec3::Y;
    }
    Scene { stands: false, ..scene }
}

/// A thousand bodies in ten layers above a bin of 11.9 m, each turned a little.
fn poured(name: &'static str, form: Form) -> Scene {
    let place = |k: usize| {
        let even = |n: usize, generator: f64| (generator.sqrt() * (k * 3 + n + 1) as f64).fract() - 0.5;
        let shift = DVec3::new(even(0, 2.0), even(1, 3.0), even(2, 5.0)) * 0.04;
        let grid = DVec3::new((k % 10) as f64 - 4.5, (k / 10 % 10) as f64 - 4.5, (k / 100) as f64) * 1.15;
        let turn = DVec3::new(even(0, 7.0), even(1, 11.0), even(2, 13.0)) * 0.1;
        Pose::new(Rotation::from_rotation_vector(turn), grid + shift + DVec3::Z * 0.7)
    };
    let sides = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y].map(|normal| Plane { point: normal * -5.95, normal });
    let members = (0..1000).map(|k| Member { form, mass: 1.0, pose: place(k), velocity: DVec3::ZERO }).collect();
    let planes = std::iter::once(FLOOR).chain(sides).collect();
    Scene { name, members, planes, friction: 0.5, step: STEP, steps: 300, stands: false }
}

/// Boxes that fall in a heap from places in a column, turned anyhow.
fn dropped(name: &'static str, count: usize) -> Scene {
    let place = |k: usize| {
        let even = |generator: f64| (generator.sqrt() * (k + 1) as f64).fract() - 0.5;
        let turn = DVec3::new(even(7.0), even(11.0), even(13.0)) * 6.0;
        let side = 0.6 * (count as f64 / 20.0).cbrt();
        let at = DVec3::new(even(2.0) * side, even(3.0) * side, 0.2 + 0.2 * k as f64);
        Pose::new(Rotation::from_rotation_vector(turn), at)
    };
    let edges = DVec3::new(0.12, 0.1, 0.08);
    let members = (0..count)
        .map(|k| Member { form: Form::Box(edges), mass: 1.0, pose: place(k), velocity: DVec3::ZERO })
        .collect();
    let steps = 120 + 2 * count;
    Scene { name, members, planes: vec![FLOOR], friction: 0.5, step: STEP, steps, stands: false }
}

/// Courses of bricks in running bond; every other course begins and ends with half a brick.
fn wall(name: &'static str, courses: usize, columns: usize) -> Scene {
    let brick = DVec3::new(0.25, 0.12, 0.0625);
    let joint = 0.005;
    let mut members = Vec::new();
    for course in 0..courses {
        let z = (course as f64 + 0.5) * brick.z;
        let pitch = brick.x + joint;
        if course % 2 == 0 {
            for k in 0..columns {
                members.push(member(Form::Box(brick), 3.75, DVec3::new(k as f64 * pitch, 0.0, z)));
            }
            continue;
        }
        let half = DVec3::new(0.5 * (brick.x - joint), brick.y, brick.z);
        let end = 0.5 * (brick.x - half.x);
        for x in [-end, (columns - 1) as f64 * pitch + end] {
            members.push(member(Form::Box(half), 3.75 * half.x / brick.x, DVec3::new(x, 0.0, z)));
        }
        for k in 0..columns - 1 {
            members.push(member(Form::Box(brick), 3.75, DVec3::new((k as f64 + 0.5) * pitch, 0.0, z)));
        }
    }
    standing(name, members, 0.6, 600)
}

/// The tower of SimBenchmark's `kapla`: six storeys of eight bases, its step of 0.01 s (docs/REFERENCES.md).
fn kapla() -> Scene {
    let (storeys, bases) = (6, 8);
    let (base, beam) = (DVec3::new(0.05, 0.25, 0.1), DVec3::new(0.2, 0.05, 0.1));
    let mut members = Vec::new();
    for storey in 0..storeys {
        let z = 0.2 * storey as f64;
        for k in 0..bases {
            members.push(member(Form::Box(base), 10.0, DVec3::new(0.2 * k as f64, 0.0, z + 0.05)));
        }
        let walls = bases / 2;
        let right = (0..walls).map(|k| (0.4 * k as f64 + 0.1, -0.1));
        let left = (0..walls - 1).map(|k| (0.4 * k as f64 + 0.3, 0.1));
        let ends = [0.1, 0.4 * (walls - 1) as f64 + 0.1].map(|x| (x, 0.1));
        for (x, y) in right.chain(left).chain(ends) {
            members.push(member(Form::Box(beam), 10.0, DVec3::new(x, y, z + 0.15)));
        }
    }
    Scene { step: 0.01, ..standing("kapla", members, 0.8, 1000) }
}

/// Bricks in rows of 1, 2, 3, 2, 1, each shifted by half a brick.
fn diamond() -> Scene {
    let brick = DVec3::new(1.0, 0.5, 0.25);
    let rows = [1, 2, 3, 2, 1];
    let place =
        |row: usize, k: usize| DVec3::new(k as f64 - 0.5 * (rows[row] - 1) as f64, 0.0, (row as f64 + 0.5) * brick.z);
    let places = (0..rows.len()).flat_map(|row| (0..rows[row]).map(move |k| place(row, k)));
    standing("diamond", places.map(|at| member(Form::Box(brick), 1.0, at)).collect(), 0.5, 600)
}

/// Ten cubes of 1 kg, and one of 1000 kg on top.
fn heavy_top() -> Scene {
    let cube = |k: usize| {
        let mass = if k == 10 { 1000.0 } else { 1.0 };
        member(Form::Box(DVec3::ONE), mass, DVec3::new(0.0, 0.0, k as f64 + 0.5))
    };
    standing("stack-1000kg", (0..11).map(cube).collect(), 0.5, 600)
}

/// Scenes of one kind from a hundred to twenty thousand bodies: how the cost of a step grows.
pub(crate) fn growing() -> Vec<(&'static str, Vec<Scene>)> {
    let walls = [(10, 10), (20, 20), (32, 32), (50, 50), (71, 71), (142, 142)];
    let pyramids = [14, 28, 45, 70, 100, 200];
    vec![
        ("walls", walls.iter().map(|&(courses, columns)| pushed(wall("wall", courses, columns))).collect()),
        ("pyramids", pyramids.iter().map(|&base| pushed(pyramid("pyramid", base, 8))).collect()),
    ]
}

/// The same with a slow push at its highest body, so that nothing rests.
fn pushed(mut scene: Scene) -> Scene {
    if let Some(last) = scene.members.last_mut() {
        last.velocity = DVec3::Y * 0.05;
    }
    Scene { steps: 8, stands: false, ..scene }
}

/// All scenes, in the order of the table.
pub(crate) fn scenes() -> Vec<Scene> {
    vec![
        pyramid("pyramid-210", 20, 600),
        pyramid("pyramid-5050", 100, 300),
        hit_pyramid("pyramid-210-hit", 20, 120),
        poured("spheres-1000", Form::Sphere(0.5)),
        poured("boxes-1000", Form::Box(DVec3::ONE)),
        wall("wall-400", 20, 20),
        kapla(),
        diamond(),
        heavy_top(),
        dropped("drop-20", 20),
        dropped("drop-50", 50),
        dropped("drop-100", 100),
    ]
}
