//! What a joint carries: the torque of a driven crank with rough bearings against inverse dynamics computed by itself,
//! causes told where nothing moves, contacts with what of them is not unique, and plots of quantities by name.

use super::Place;

const G: f64 = 9.81;

/// A slider-crank in a plane: lengths, masses and friction, and how fast the crank turns. The crank turns about +y from
/// +x, so that its pin is at `(r cos, -r sin)` in x and z; gravity is along -z.
#[derive(Clone, Copy)]
struct SliderCrank {
    crank: f64,
    rod: f64,
    masses: [f64; 3],
    /// Moments of inertia of crank and rod about their centres.
    inertias: [f64; 2],
    /// From the axis to the centre of mass of the crank.
    center: f64,
    rate: f64,
    /// Coefficient times radius of the three hinges, and the coefficient of the guide.
    bearings: [f64; 4],
}

type V = [f64; 2];

fn plus(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1]]
}

fn times(a: V, factor: f64) -> V {
    [a[0] * factor, a[1] * factor]
}

/// The moment about +y of a force (x, z) at an arm.
fn moment(arm: V, force: V) -> f64 {
    arm[1] * force[0] - arm[0] * force[1]
}

fn size(a: V) -> f64 {
    a[0].hypot(a[1])
}

impl SliderCrank {
    /// The torque of the drive and the friction of the crank's bearing at an angle: Newton and Euler for each body, in
    /// the motion that the drive forces, with Coulomb's friction of the bearings by their loads, which are found again
    /// until they stay.
    fn torques(&self, angle: f64) -> [f64; 2] {
        let Self { crank: r, rod: l, rate: w, .. } = *self;
        let (s, c) = angle.sin_cos();
        // sin(phi) = -(r/l) sin(angle), and its derivatives.
        let sin_phi = -r / l * s;
        let cos_phi = (1.0 - sin_phi * sin_phi).sqrt();
        let phi_rate = -r / l * c * w / cos_phi;
        let phi_acceleration = (r / l * s * w * w + sin_phi * phi_rate * phi_rate) / cos_phi;
        let (pin, along) = ([r * c, -r * s], [l * cos_phi, -l * sin_phi]);
        // Second derivatives: of (cos, -sin) of an angle.
        let second = |length: f64, [sin, cos]: V, rate: f64, acceleration: f64| {
            [length * (-cos * rate * rate - sin * acceleration), length * (sin * rate * rate - cos * acceleration)]
        };
        let of_pin = second(r, [s, c], w, 0.0);
        let of_crank = times(of_pin, self.center / r);
        let of_end = plus(of_pin, second(l, [sin_phi, cos_phi], phi_rate, phi_acceleration));
        let of_rod = times(plus(of_pin, of_end), 0.5);
        let end_rate = -r * s * w - l * sin_phi * phi_rate;
        let [m_crank, m_rod, m_piston] = self.masses;
        let down = [0.0, -G];
        let needed = |mass: f64, acceleration: V| times(minus(acceleration, down), mass);
        let sign = |rate: f64| if rate == 0.0 { 0.0 } else { rate.signum() };
        let (mut loads, mut found) = ([0.0; 4], [0.0; 2]);
        for _ in 0..400 {
            // Friction on the crank by its bearing, on the rod by both of its pins, on the piston by its guide.
            let rubbing = |place: usize, rate: f64| -sign(rate) * self.bearings[place] * loads[place];
            let by_bearing = rubbing(0, w);
            let by_crank = rubbing(1, phi_rate - w);
            let by_piston = rubbing(2, phi_rate);
            let by_guide = rubbing(3, end_rate);
            // Forces on the rod at its end (from the piston) and at the pin (from the crank).
            let at_end_x = by_guide - m_piston * of_end[0];
            let half = times(along, 0.5);
            let turning = self.inertias[1] * phi_acceleration + moment(half, needed(m_rod, of_rod));
            // turning = friction + moment(along, (x, z)), with moment = along_z x - along_x z.
            let at_end_z = (by_crank + by_piston + along[1] * at_end_x - turning) / along[0];
            let at_end = [at_end_x, at_end_z];
            let at_pin = minus(needed(m_rod, of_rod), at_end);
            let guide = at_end_z + m_piston * G;
            let arm = times(pin, self.center / r);
            let bearing = plus(needed(m_crank, of_crank), at_pin);
            let drive = moment(arm, needed(m_crank, of_crank)) + moment(pin, at_pin) + by_crank - by_bearing;
            loads = [size(bearing), size(at_pin), size(at_end), guide.abs()];
            found = [drive, by_bearing];
        }
        found
    }
}

/// A column of a table, of the rows of one joint.
fn column(table: &str, joint: &str, name: &str) -> Vec<f64> {
    let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let place = lines.next().unwrap().iter().position(|own| *own == name).unwrap();
    lines.filter(|row| row[1] == joint).map(|row| row[place].parse().unwrap()).collect()
}

/// `I = m (a^2 + b^2) / 12` of a box.
fn of_box(mass: f64, [a, b]: V) -> f64 {
    mass * (a * a + b * b) / 12.0
}

fn agrees(args: &[&str], own: SliderCrank) {
    let place = Place::with_scene("");
    let mut all = vec!["run", "example:slider-crank-driven", "--error", "off", "--joints", "joints.csv"];
    all.extend(args);
    place.expect(0, &all);
    let table = place.read("joints.csv");
    let times = column(&table, "crank", "t");
    let found = ["drive_torque", "friction_torque"].map(|name| column(&table, "crank", name));
    let largest = found[0].iter().fold(0.0_f64, |most, own| most.max(own.abs()));
    let mut compared = 0;
    for (row, t) in times.iter().enumerate() {
        let expected = own.torques(own.rate * t);
        // At a dead centre the piston turns back, and friction with it: a sample there may be on either side.
        if (own.rate * t).sin().abs() < 1e-6 {
            continue;
        }
        for (found, expected) in found.iter().zip(expected) {
            assert!((found[row] - expected).abs() < 1e-9 * largest, "t = {t}: {} for {expected}", found[row]);
        }
        compared += 1;
    }
    assert!(compared > 15 && largest > 0.1, "{compared} {largest}");
}

#[test]
fn the_torque_of_a_crank_with_rough_bearings_is_that_of_inverse_dynamics() {
    let own = SliderCrank {
        crank: 0.1,
        rod: 0.3,
        masses: [0.6, 0.5, 1.0],
        inertias: [of_box(0.6, [0.14, 0.03]), of_box(0.5, [0.3, 0.03])],
        center: 0.05,
        rate: 10.0,
        bearings: [0.001, 0.001, 0.001, 0.1],
    };
    agrees(&["--duration", "0.3"], own);
    let bearing = "joints[0].type.hinge.angle.friction.radius=0.03";
    let guide = "joints[3].type.slider.displacement.friction.coefficient=0.25";
    let rate = "joints[0].type.hinge.angle.motion.rate=-17";
    let args =
        ["--duration", "0.2", "--set", bearing, "--set", guide, "--set", rate, "--set", "bodies.piston.mass=2.5"];
    agrees(&args, SliderCrank { rate: -17.0, bearings: [0.003, 0.001, 0.001, 0.25], masses: [0.6, 0.5, 2.5], ..own });
}

/// An arm of 1 m and 2 kg that a servo holds level where its torque is that of the weight; beside it a bolt on
/// a spring and a limit, and a box on a floor.
const STILL: &str = r#"
format = 1
name = "still"
duration = 0.2
output.interval = 0.1
[[bodies]]
name = "arm"
shape.box.size = [1.0, 0.1, 0.1]
mass = 2.0
position = [0.5, 0, 0]
[[bodies]]
name = "bolt"
shape.box.size = [0.1, 0.1, 0.1]
mass = 3.0
position = [0, 2, 0]
[[bodies]]
name = "floor"
fixed = true
shape.half_space.normal = [0, 0, 1]
position = [0, 0, -5]
[[bodies]]
name = "table"
shape.box.size = [1, 1, 0.5]
mass = 4.0
position = [5, 5, -4.75]
[[joints]]
name = "shoulder"
[joints.type.hinge]
bodies = ["arm"]
anchor = [0, 0, 0]
axis = [0, 1, 0]
angle.motor = { position = -0.1, stiffness = 98.1 }
[[joints]]
name = "shaft"
[joints.type.slider]
bodies = ["bolt"]
anchor = [0, 2, 0]
axis = [0, 0, 2]
displacement = { range = [0, 1], stiffness = 50.0, rest = 0.1 }
"#;

/// Step of the runs of it, s.
const STEP_S: f64 = 1e-3;

#[test]
fn causes_are_told_where_nothing_moves() {
    for tier in ["accurate", "stepped"] {
        let place = Place::with_scene(STILL);
        let step = format!("method.step={STEP_S:?}");
        let files = ["--joints", "joints.csv", "--contacts", "contacts.csv"];
        place.expect(0, &[&["run", "scene.toml", "--tier", tier, "--set", &step][..], &files].concat());
        let table = place.read("joints.csv");
        let near = |joint: &str, name: &str, expected: f64| {
            for found in column(&table, joint, name) {
                assert!((found - expected).abs() < 1e-7, "{tier}: {joint}.{name}: {found} for {expected}\n{table}");
            }
        };
        near("shoulder", "drive_torque", -9.81);
        near("shoulder", "friction_torque", 0.0);
        // The axes of the hinge: its own, and two across; the weight hangs across.
        near("shoulder", "reaction_fx", 0.0);
        near("shoulder", "reaction_my", 0.0);
        near("shoulder", "fz", 2.0 * G);
        near("shaft", "spring_force", 5.0);
        // A time step takes the force of a spring where a free body would be half way through it, `g h^2 / 8` farther.
        let limit_forces = column(&table, "shaft", "limit_force");
        for (sample, found) in limit_forces.iter().enumerate() {
            let farther = if tier == "stepped" && sample > 0 { G * STEP_S * STEP_S / 8.0 } else { 0.0 };
            let expected = 3.0 * G - 50.0 * (0.1 - farther);
            assert!((found - expected).abs() < 1e-7, "{tier}: {found} for {expected}");
        }
        near("shaft", "reaction_fx", 0.0);
        let contacts = place.read("contacts.csv");
        let rows: Vec<Vec<&str>> = contacts.lines().skip(1).map(|line| line.split(',').collect()).collect();
        assert_eq!(rows.len(), 12, "{contacts}");
        // In time steps contacts bear nothing before the first one.
        let first = usize::from(tier == "stepped");
        for t in &["0.0", "0.1", "0.2"][first..] {
            let at: Vec<_> = rows.iter().filter(|row| row[0] == *t).collect();
            let sum: f64 = at.iter().map(|row| row[10].parse::<f64>().unwrap()).sum();
            assert!((sum - 4.0 * G).abs() < 1e-6, "{tier}: {contacts}");
            // Four corners of a box: statics does not say what each bears.
            assert!(at.iter().all(|row| row[14] == "normal"), "{contacts}");
        }
    }
}

/// Quantities by name, over time and against each other; the same words in a sweep.
#[test]
fn quantities_are_plotted_by_name() {
    let place = Place::with_scene(STILL);
    let words =
        "joint-torque:shoulder,bodies.table.position[2],velocity:bolt,contacts.table/floor.normal_force,effort:shaft";
    place.expect(0, &["run", "scene.toml", "--plot", words, "-o", "a.svg"]);
    let figure = place.read("a.svg");
    let titles = [
        "torque of shoulder, N m",
        "position of table z, m",
        "velocity of bolt, m/s",
        "normal_force of table/floor, N",
        "effort of shaft, N",
        "time, s",
    ];
    for title in titles {
        assert!(figure.contains(title), "{title}");
    }
    assert!(figure.contains("drive") && figure.contains("limit") && !figure.contains("energy, J"));
    let args = ["run", "scene.toml", "--plot", "drive:shoulder", "--against", "angle:shoulder", "-o", "b.svg"];
    place.expect(0, &args);
    let figure = place.read("b.svg");
    assert!(figure.contains("drive of shoulder, N m") && figure.contains("angle of shoulder, rad"));
    let measure = ["--measure", "t=max(joints.shoulder.torque)", "--measure", "n=contacts.table.normal_force@end"];
    let swept = place.expect(0, &[&["sweep", "scene.toml", "--vary", "bodies.table.mass=4,5"][..], &measure].concat());
    let last = swept.stdout.lines().last().unwrap().to_owned();
    assert!(last.contains(",-9.81") && last.contains(",49.0"), "{last}");
}

/// What is none is answered with what there is, and nothing is written.
#[test]
fn mistakes() {
    let place = Place::with_scene(STILL);
    let asked = |plot: &str, more: &[&str]| {
        let run = place.expect(2, &[&["run", "scene.toml", "--plot", plot, "-o", "a.svg"][..], more].concat());
        run.stderr
    };
    for (plot, parts) in [
        ("torqe:shoulder", ["did you mean `torque`?", "reaction_moment", "joint-powers"]),
        ("torque:sholder", ["did you mean `shoulder`?", "bolt", "shaft"]),
        ("enrgy", ["did you mean `energy`?", "ledger", "QUANTITY:NAME"]),
        ("position[3]:arm", ["[0] to [2]", "x, y, z", "accepted"]),
        ("angle[0]:shoulder", ["one number", "angle", "accepted"]),
        ("torque:shaft", ["displacement", "torque", "accepted"]),
        ("contacts.table/ceiling.force", ["ceiling", "floor", "two as A/B"]),
        ("energy.heat", ["kinetic", "potential", "total"]),
    ] {
        let told = asked(plot, &[]);
        for part in parts {
            assert!(told.contains(part), "{plot}: `{part}` in {told}");
        }
    }
    assert!(asked("energy", &["--against", "angle:shoulder"]).contains("over time"));
    assert!(asked("torque:shoulder", &["--against", "position:arm"]).contains("position:arm[0]"));
    let run = place.expect(2, &["run", "scene.toml", "--contacts", "-"]);
    assert!(run.stderr.contains("--contacts -"), "{}", run.stderr);
    assert_eq!(place.list(), ["scene.toml"]);
}
