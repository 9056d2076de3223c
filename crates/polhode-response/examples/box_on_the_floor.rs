//! The forces on the four corners of a loaded box that stands on the floor: of all that hold it the least.
//!
//! With half edges a and the centre of mass at the distance c from the middle they are `m g (1/4 + c x / (4 a^2))`.

use polhode_response::spatial::DVec3;
use polhode_response::{ContactProblem, SolverSettings, minimum_norm, solve_complementarity};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let (mass, half, center) = (8.0, 0.5, DVec3::X * 0.25);
    // Mass and inertia (1 kg m^2 about each axis) are diagonal, and so is their inverse.
    let diagonal = [1.0 / mass, 1.0 / mass, 1.0 / mass, 1.0, 1.0, 1.0];
    let inverse = (0..36).map(|k| if k % 7 == 0 { diagonal[k / 7] } else { 0.0 }).collect();
    let mut problem = ContactProblem::new(6, inverse)?;
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    for (x, y) in corners {
        // A row is the normal and its moment about the centre of mass.
        let (normal, arm) = (DVec3::Z, DVec3::new(x, y, -half) - center);
        problem.push_row(&[(0, &[normal.to_array(), arm.cross(normal).to_array()].concat())])?;
    }
    let (delassus, settings) = (problem.delassus(), SolverSettings::default());
    let solution = solve_complementarity(&problem, &delassus, &[-9.81; 4], None, &settings)?;
    let forces = minimum_norm(&problem, &solution, &settings)?.forces;
    for (force, (x, y)) in forces.into_iter().zip(corners) {
        println!("corner at {x:4}, {y:4} m: {force:.4} N");
        assert!((force - mass * 9.81 * (0.25 + center.x * x / (4.0 * half * half))).abs() < 1e-13);
    }
    Ok(())
}
