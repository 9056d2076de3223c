//! Centre of mass and inertia of evenly filled shapes, by formulas of the judge's own.
//!
//! A polyhedron is the sum of the tetrahedra of its triangles and a point; a compound the sum of its parts, by volume.

use crate::random_scene::model::{Form, Triangles};
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// What a shape weighs: for mass 1 or for density 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Weight {
    pub(super) mass: f64,
    /// Centre of mass in the frame of the body, m.
    pub(super) center: DVec3,
    /// About the centre of mass, along the axes of the body.
    pub(super) inertia: DMat3,
}

impl Weight {
    /// The same of another mass.
    pub(super) fn of_mass(self, mass: f64) -> Self {
        Self { mass, inertia: self.inertia * (mass / self.mass), ..self }
    }

    /// Of density 1 throughout.
    pub(super) fn of(form: &Form) -> Self {
        let diagonal = |mass: f64, squares: [f64; 3]| Self {
            mass,
            center: DVec3::ZERO,
            inertia: DMat3::from_diagonal(DVec3::from_array(squares) * mass),
        };
        match form {
            Form::HalfSpace(_) => diagonal(0.0, [0.0; 3]),
            Form::Cuboid(size) => {
                let squares = *size * *size / 12.0;
                let sum = squares.element_sum();
                diagonal(size.element_product(), (DVec3::splat(sum) - squares).to_array())
            }
            Form::Sphere(r) => diagonal(4.0 / 3.0 * PI * r * r * r, [0.4 * r * r; 3]),
            Form::Cylinder(r, h) => {
                let across = r * r / 4.0 + h * h / 12.0;
                diagonal(PI * r * r * h, [across, across, r * r / 2.0])
            }
            Form::Cone(r, h) => {
                let across = 3.0 / 20.0 * r * r + 3.0 / 80.0 * h * h;
                diagonal(PI * r * r * h / 3.0, [across, across, 0.3 * r * r])
            }
            Form::Capsule(r, h) => {
                let (middle, caps) = (PI * r * r * h, 4.0 / 3.0 * PI * r * r * r);
                // Each half ball is 3/8 r beyond its end of the cylinder.
                let across =
                    middle * (r * r / 4.0 + h * h / 12.0) + caps * (0.4 * r * r + h * h / 4.0 + 3.0 / 8.0 * h * r);
                let along = middle * r * r / 2.0 + caps * 0.4 * r * r;
                let mass = middle + caps;
                diagonal(mass, [across / mass, across / mass, along / mass])
            }
            Form::Torus(major, minor) => {
                let (c, a) = (major * major, minor * minor);
                let across = c / 2.0 + 5.0 / 8.0 * a;
                diagonal(2.0 * PI * PI * major * a, [across, across, c + 0.75 * a])
            }
            Form::Convex(solid) | Form::Mesh(solid, _) => Self::polyhedron(solid),
            Form::Compound(parts) => {
                let weights: Vec<Self> = parts
                    .iter()
                    .map(|part| {
                        let (own, turn) = (Self::of(&part.form), DMat3::from_quat(part.orientation));
                        Self {
                            mass: own.mass,
                            center: part.position + turn * own.center,
                            inertia: turn * own.inertia * turn.transpose(),
                        }
                    })
                    .collect();
                let mass: f64 = weights.iter().map(|weight| weight.mass).sum();
                let center = weights.iter().map(|weight| weight.center * weight.mass).sum::<DVec3>() / mass;
                let moved = |weight: &Self| weight.inertia + of_point(weight.center - center) * weight.mass;
                Self { mass, center, inertia: weights.iter().map(moved).fold(DMat3::ZERO, |a, b| a + b) }
            }
        }
    }

    fn polyhedron(solid: &Triangles) -> Self {
        let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for triangle in &solid.triangles {
            let [a, b, c] = triangle.map(|index| solid.vertices[index]);
            let part = a.dot(b.cross(c)) / 6.0;
            let sum = a + b + c;
            volume += part;
            first += sum * (part / 4.0);
            // The integral of x x^T over the tetrahedron of three points and the origin.
            let squares = [a, b, c, sum].into_iter().map(outer).fold(DMat3::ZERO, |a, b| a + b);
            second += squares * (part / 20.0);
        }
        let center = first / volume;
        let about = second - outer(center) * volume;
        let trace = about.x_axis.x + about.y_axis.y + about.z_axis.z;
        Self { mass: volume, center, inertia: DMat3::IDENTITY * trace - about }
    }
}

fn outer(v: DVec3) -> DMat3 {
    DMat3::from_cols(v * v.x, v * v.y, v * v.z)
}

/// Inertia of a unit mass at a point.
fn of_point(v: DVec3) -> DMat3 {
    DMat3::IDENTITY * v.length_squared() - outer(v)
}
