//! Contact problems in the velocities of bodies: pyramids, walls, towers, chains and heaps, each of one
//! velocity-level time step.

use polhode_response::Law;
use polhode_response::sparse::{BodyMass, BodyProblem, BodyRows};

/// Acceleration of gravity (m/s^2) times the step (s).
pub(crate) const GRAVITY_OF_A_STEP: f64 = 9.81 / 60.0;

/// Bodies with contacts between them, before the problem is built.
#[derive(Debug, Clone, Default)]
pub(crate) struct BodyScene {
    pub(crate) masses: Vec<f64>,
    /// Full edges of boxes (m).
    pub(crate) sizes: Vec<[f64; 3]>,
    pub(crate) centres: Vec<[f64; 3]>,
    pub(crate) velocities: Vec<[f64; 6]>,
    pub(crate) contacts: Vec<Contact>,
}

/// A contact point of body `a` on body `b`, or on the ground; its normal points from b to a.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Contact {
    pub(crate) a: usize,
    pub(crate) b: Option<usize>,
    pub(crate) point: [f64; 3],
    pub(crate) normal: [f64; 3],
    pub(crate) law: Law,
    pub(crate) bias: f64,
    pub(crate) compliance: f64,
}

/// A number between -1 and 1, and then the next one.
#[derive(Debug, Clone)]
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    pub(crate) fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 / (1_u64 << 52) as f64) - 1.0
    }

    /// About normal, of unit deviation.
    pub(crate) fn bell(&mut self) -> f64 {
        (0..12).map(|_| self.roll()).sum::<f64>() * 0.5
    }
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Two unit vectors across a third.
pub(crate) fn tangents(n: [f64; 3]) -> [[f64; 3]; 2] {
    let axis = if n[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let along = n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2];
    let first: [f64; 3] = std::array::from_fn(|k| axis[k] - along * n[k]);
    let size = first.iter().map(|x| x * x).sum::<f64>().sqrt();
    let first = first.map(|x| x / size);
    [first, cross(n, first)]
}

impl BodyScene {
    pub(crate) fn add_box(&mut self, centre: [f64; 3], size: [f64; 3], mass: f64) -> usize {
        self.masses.push(mass);
        self.sizes.push(size);
        self.centres.push(centre);
        self.velocities.push([0.0; 6]);
        self.masses.len() - 1
    }

    /// Four corners of a face that lies on `b`.
    fn add_face(&mut self, a: usize, b: Option<usize>, x: [f64; 2], y: [f64; 2], z: f64, friction: f64) {
        for x in x {
            for y in y {
                let (point, normal) = ([x, y, z], [0.0, 0.0, 1.0]);
                let law = Law::Cone { rows: 3, friction };
                self.contacts.push(Contact { a, b, point, normal, law, bias: 0.0, compliance: 0.0 });
            }
        }
    }

    /// Every body under gravity for a step, in a direction tilted by this angle (rad) about y.
    pub(crate) fn pull(&mut self, angle: f64) -> &mut Self {
        let (sine, cosine) = angle.sin_cos();
        for velocity in &mut self.velocities {
            velocity[0] += GRAVITY_OF_A_STEP * sine;
            velocity[2] -= GRAVITY_OF_A_STEP * cosine;
        }
        self
    }

    /// Random velocities of this deviation in all components.
    pub(crate) fn shake(&mut self, deviation: f64, seed: u64) -> &mut Self {
        let mut dice = Dice(seed);
        for velocity in self.velocities.as_flattened_mut() {
            *velocity += deviation * dice.bell();
        }
        self
    }

    /// Masses and moments of inertia, which are those about the axes of the world.
    pub(crate) fn diagonal_masses(&self) -> Vec<[f64; 6]> {
        let of = |(&mass, [a, b, c]): (&f64, &[f64; 3])| {
            let moment = |x: &f64, y: &f64| mass / 12.0 * (x * x + y * y);
            [mass, mass, mass, moment(b, c), moment(a, c), moment(a, b)]
        };
        self.masses.iter().zip(&self.sizes).map(of).collect()
    }

    /// The part of `H` of each body of a contact.
    pub(crate) fn jacobian(&self, contact: &Contact) -> Vec<(usize, Vec<f64>)> {
        let axes = contact_axes(contact);
        let lines = |body: usize, sign: f64| -> Vec<f64> {
            let arm: [f64; 3] = std::array::from_fn(|k| contact.point[k] - self.centres[body][k]);
            axes.iter().take(contact.law.rows()).flat_map(|axis| line(axis, arm, sign)).collect()
        };
        let mut parts = vec![(contact.a, lines(contact.a, 1.0))];
        parts.extend(contact.b.map(|b| (b, lines(b, -1.0))));
        parts
    }

    pub(crate) fn problem(&self) -> BodyProblem {
        let mass = |[m, _, _, a, b, c]: [f64; 6]| BodyMass::rigid(m, &[a, 0.0, 0.0, 0.0, b, 0.0, 0.0, 0.0, c]);
        let masses: Vec<BodyMass> = self.diagonal_masses().into_iter().map(mass).collect();
        let mut problem = BodyProblem::new(&masses, &self.velocities).unwrap();
        for contact in &self.contacts {
            let rows = contact.law.rows();
            let parts = self.jacobian(contact);
            let bodies: Vec<(usize, &[f64])> = parts.iter().map(|(body, lines)| (*body, &lines[..])).collect();
            let mut bias = vec![0.0; rows];
            bias[0] = contact.bias;
            let compliance = if contact.compliance > 0.0 { vec![contact.compliance; rows] } else { Vec::new() };
            let rows = BodyRows { law: contact.law, bodies: &bodies, bias: &bias, compliance: &compliance };
            problem.push(&rows).unwrap();
        }
        problem
    }
}

/// An axis of translation, or with `Axis::Turn` of rotation.
#[derive(Debug, Clone, Copy)]
enum Axis {
    Slip([f64; 3]),
    /// With a length that makes a speed of the angular velocity (m).
    Turn([f64; 3], f64),
}

/// Length of rows of rotations (m).
const TURNING_LENGTH: f64 = 0.1;

fn contact_axes(contact: &Contact) -> Vec<Axis> {
    let n = contact.normal;
    let [t, s] = tangents(n);
    let turn = |axis| Axis::Turn(axis, TURNING_LENGTH);
    vec![Axis::Slip(n), Axis::Slip(t), Axis::Slip(s), turn(t), turn(s), turn(n)]
}

fn line(axis: &Axis, arm: [f64; 3], sign: f64) -> [f64; 6] {
    let (linear, angular) = match *axis {
        Axis::Slip(axis) => (axis, cross(arm, axis)),
        Axis::Turn(axis, length) => ([0.0; 3], axis.map(|x| length * x)),
    };
    std::array::from_fn(|k| sign * if k < 3 { linear[k] } else { angular[k - 3] })
}

/// Cubes of 0.5 m and 1 kg, `rows` of them on the ground, one fewer in each row above.
pub(crate) fn pyramid(rows: usize, friction: f64) -> BodyScene {
    let a = 0.5;
    let mut scene = BodyScene::default();
    let mut below = Vec::new();
    for row in 0..rows {
        let mut own = Vec::new();
        for column in 0..rows - row {
            let x = (column as f64 + 0.5 * row as f64) * a;
            let z = a * row as f64;
            let body = scene.add_box([x, 0.0, z + a / 2.0], [a; 3], 1.0);
            let (left, right, y) = (x - a / 2.0, x + a / 2.0, [-a / 2.0, a / 2.0]);
            if row == 0 {
                scene.add_face(body, None, [left, right], y, z, friction);
            } else {
                scene.add_face(body, Some(below[column]), [left, x], y, z, friction);
                scene.add_face(body, Some(below[column + 1]), [x, right], y, z, friction);
            }
            own.push(body);
        }
        below = own;
    }
    scene
}

/// Cubes of 1 m and 1 kg on each other.
pub(crate) fn tower(boxes: usize, friction: f64) -> BodyScene {
    let mut scene = BodyScene::default();
    for k in 0..boxes {
        let body = scene.add_box([0.0, 0.0, k as f64 + 0.5], [1.0; 3], 1.0);
        scene.add_face(body, body.checked_sub(1), [-0.5, 0.5], [-0.5, 0.5], k as f64, friction);
    }
    scene
}

/// Cubes of 0.5 m and 1 kg in layers of bricks, `columns` wide and `rows` high.
pub(crate) fn wall(columns: usize, rows: usize, friction: f64) -> BodyScene {
    let a = 0.5;
    let mut scene = BodyScene::default();
    let mut below: Vec<(f64, usize)> = Vec::new();
    for row in 0..rows {
        let shift = if row % 2 == 0 { 0.0 } else { 0.5 * a };
        let (z, y) = (a * row as f64, [-a / 2.0, a / 2.0]);
        let mut own = Vec::new();
        for column in 0..columns {
            let x = column as f64 * a + shift;
            let body = scene.add_box([x, 0.0, z + a / 2.0], [a; 3], 1.0);
            if row == 0 {
                scene.add_face(body, None, [x - a / 2.0, x + a / 2.0], y, z, friction);
            }
            for &(other, under) in &below {
                let (left, right) = ((x - a / 2.0).max(other - a / 2.0), (x + a / 2.0).min(other + a / 2.0));
                if right - left > 0.1 * a {
                    scene.add_face(body, Some(under), [left, right], y, z, friction);
                }
            }
            own.push((x, body));
        }
        below = own;
    }
    scene
}

/// Boxes that hang on each other by ball joints, the first one on the ceiling.
pub(crate) fn chain(links: usize) -> BodyScene {
    let mut scene = BodyScene::default();
    for k in 0..links {
        let x = k as f64;
        let body = scene.add_box([x + 0.5, 0.0, 0.0], [1.0, 0.2, 0.2], 1.0);
        let (point, normal, law) = ([x, 0.0, 0.0], [0.0, 0.0, 1.0], Law::Hold { rows: 3 });
        scene.contacts.push(Contact {
            a: body,
            b: body.checked_sub(1),
            point,
            normal,
            law,
            bias: 0.0,
            compliance: 0.0,
        });
    }
    scene
}

/// Bodies that lie on up to three earlier ones, or on the ground, by one contact each, with normals that lean.
pub(crate) fn heap(bodies: usize, friction: f64, seed: u64) -> BodyScene {
    let mut dice = Dice(seed);
    let mut scene = BodyScene::default();
    for k in 0..bodies {
        let centre = [3.0 * dice.roll(), 3.0 * dice.roll(), 0.5 + k as f64 * 0.3];
        let size = std::array::from_fn(|_| 1.0 + 0.5 * dice.roll());
        let body = scene.add_box(centre, size, 1.5 + dice.roll());
        for rest in 1..=3_usize {
            let b = body.checked_sub(rest * (1 + (dice.roll().abs() * 3.0) as usize));
            let lean = [0.6 * dice.roll(), 0.6 * dice.roll(), 1.0];
            let size = lean.iter().map(|x| x * x).sum::<f64>().sqrt();
            let point = std::array::from_fn(|i| centre[i] + if i == 2 { -0.5 } else { 0.6 * dice.roll() });
            let law = Law::Cone { rows: 3, friction };
            let normal = lean.map(|x| x / size);
            scene.contacts.push(Contact { a: body, b, point, normal, law, bias: 0.0, compliance: 0.0 });
        }
    }
    scene
}
