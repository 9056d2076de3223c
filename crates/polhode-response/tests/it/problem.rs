//! Contact problems and their Delassus matrix: the definition, its invariances, and what is refused.

use crate::scenes::{Noise, pile};
use polhode_response::{ContactProblem, ResponseError};

/// `G = J M^-1 J^T` entry by entry: column k is what a unit force at row k does to the accelerations of all rows; it
/// is exactly symmetric.
#[test]
fn delassus_is_the_response_to_unit_forces() {
    let mut noise = Noise::new(11);
    for _ in 0..20 {
        let scene = pile(1 + noise.below(5), 1 + noise.below(4), 100.0, &mut noise);
        let (problem, delassus) = (&scene.problem, scene.problem.delassus());
        for column in 0..problem.len() {
            let mut forces = vec![0.0; problem.len()];
            forces[column] = 1.0;
            let expected = problem.row_velocities(&problem.response(&forces).unwrap()).unwrap();
            for (row, value) in expected.iter().enumerate() {
                let size = (delassus.get(row, row) * delassus.get(column, column)).sqrt();
                assert!((delassus.get(row, column) - value).abs() <= 1e-14 * size);
                assert_eq!(delassus.get(row, column), delassus.get(column, row));
            }
        }
    }
}

/// Mirror image and order of the rows do not change a bit of the matrix.
#[test]
fn delassus_is_neutral_to_mirror_and_order() {
    let (mut noise, width) = (Noise::new(4), 3);
    let inverse = [0.3, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.7];
    let rows: Vec<[Vec<f64>; 2]> =
        (0..6).map(|_| [0, 1].map(|_| (0..width).map(|_| noise.signed()).collect())).collect();
    let build = |order: &[usize], mirror: f64, bodies: [usize; 2]| {
        let mut problem = ContactProblem::new(width, [inverse, inverse].concat()).unwrap();
        for &row in order {
            // The mirror image x -> -x turns the sense of rotation as well.
            let blocks = rows[row].clone().map(|block| vec![mirror * block[0], block[1], mirror * block[2]]);
            problem.push_row(&[(bodies[0], &blocks[0]), (bodies[1], &blocks[1])]).unwrap();
        }
        problem.delassus()
    };
    let (order, straight) = ([3, 1, 5, 0, 4, 2], build(&[0, 1, 2, 3, 4, 5], 1.0, [0, 1]));
    let image = build(&order, -1.0, [1, 0]);
    for (row, &original_row) in order.iter().enumerate() {
        for (column, &original_column) in order.iter().enumerate() {
            assert_eq!(image.get(row, column), straight.get(original_row, original_column));
        }
    }
}

/// Bad data is refused with an error that names it.
#[test]
fn bad_problems_are_refused() {
    assert_eq!(ContactProblem::new(0, vec![]).unwrap_err(), ResponseError::Width(0));
    assert!(matches!(ContactProblem::new(2, vec![1.0; 5]).unwrap_err(), ResponseError::Length { .. }));
    let not_symmetric = ContactProblem::new(2, vec![1.0, 0.5, 0.0, 1.0]).unwrap_err();
    assert_eq!(not_symmetric, ResponseError::InverseMass { body: 0 });
    let negative = ContactProblem::new(1, vec![1.0, -1.0]).unwrap_err();
    assert_eq!(negative, ResponseError::InverseMass { body: 1 });
    let indefinite = ContactProblem::new(2, vec![1.0, 2.0, 2.0, 1.0]).unwrap_err();
    assert_eq!(indefinite, ResponseError::InverseMass { body: 0 });
    assert!(ContactProblem::new(2, vec![0.0, 0.5, 0.5, 1.0]).is_err());
    // Semidefinite is fine: a body that only turns about an axis.
    let mut problem = ContactProblem::new(2, vec![0.0, 0.0, 0.0, 2.0, 1.0, 1.0, 1.0, 1.0]).unwrap();
    assert_eq!(problem.push_row(&[]).unwrap_err(), ResponseError::RowBodies(0));
    assert!(matches!(problem.push_row(&[(2, &[1.0, 0.0])]).unwrap_err(), ResponseError::UnknownBody { .. }));
    let twice = problem.push_row(&[(0, &[1.0, 0.0]), (0, &[1.0, 0.0])]).unwrap_err();
    assert_eq!(twice, ResponseError::RepeatedBody { body: 0 });
    assert!(matches!(problem.push_row(&[(0, &[1.0])]).unwrap_err(), ResponseError::Length { .. }));
    assert!(problem.is_empty());
    assert_eq!(problem.push_row(&[(0, &[1.0, 1.0])]).unwrap(), 0);
}
