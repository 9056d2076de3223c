//! Free bodies in space, and vectors, for the tests of impacts with friction.

use crate::scenes::Noise;
use polhode_response::ContactProblem;

pub(crate) type Vector = [f64; 3];

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn unit(v: Vector) -> Vector {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// Components between -1 and 1.
pub(crate) fn random_vector(noise: &mut Noise) -> Vector {
    [0, 1, 2].map(|_| noise.signed())
}

/// Two tangents, perpendicular to a normal and to each other.
pub(crate) fn tangents(normal: Vector) -> [Vector; 2] {
    let beside = if normal[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let first = unit(cross(normal, beside));
    [first, cross(normal, first)]
}

/// Bodies with these masses and principal moments along the axes of the world, without rows.
pub(crate) fn free_bodies(bodies: &[(f64, Vector)]) -> ContactProblem {
    let mut inverse = Vec::new();
    for (mass, moments) in bodies {
        for row in 0..6 {
            let value = if row < 3 { *mass } else { moments[row - 3] };
            inverse.extend((0..6).map(|column| if row == column { 1.0 / value } else { 0.0 }));
        }
    }
    ContactProblem::new(6, inverse).unwrap()
}
