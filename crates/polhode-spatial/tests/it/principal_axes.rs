//! The eigen-decomposition: it rebuilds its matrix, keeps small moments beside large ones, and answers for any input.

use crate::random::{assert_matrix, largest, rotations, vectors};
use polhode_spatial::{DMat3, DVec3, PrincipalAxes, Rotation};
use proptest::prelude::*;

fn symmetric(diagonal: DVec3, off: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(diagonal.x, off.z, off.y),
        DVec3::new(off.z, diagonal.y, off.x),
        DVec3::new(off.y, off.x, diagonal.z),
    )
}

fn rebuilt(axes: &PrincipalAxes) -> DMat3 {
    let r = axes.rotation().to_matrix();
    r * DMat3::from_diagonal(axes.moments()) * r.transpose()
}

/// A diagonal matrix keeps its values to the last bit; only the order changes, and the axes stay right-handed.
#[test]
fn diagonal_matrices_are_exact() {
    for moments in [[1.0, 2.0, 3.0], [3.0, 1.0, 2.0], [2.0, 2.0, 1.0], [0.1, 0.1, 0.1], [1e-30, 1.0, 1e30]] {
        let axes = PrincipalAxes::of(&DMat3::from_diagonal(DVec3::from_array(moments)));
        let mut sorted = moments;
        sorted.sort_by(f64::total_cmp);
        assert_eq!(axes.moments().to_array(), sorted);
        assert!((axes.rotation().to_matrix().determinant() - 1.0).abs() < 1e-15);
    }
    assert_eq!(PrincipalAxes::of(&DMat3::IDENTITY).rotation(), Rotation::IDENTITY);
}

/// Case MP-12's needle in axes a little tilted: the scaled matrix is well conditioned, and the small moment keeps the
/// digits that the elements have (relative error of the element xx, 1e-16 of 1.7e-13, and no more).
#[test]
fn graded_matrix_keeps_its_small_moment() {
    let (small, large, coupling) = (1.6666666666666667e-13, 0.08333333333341668, 1e-8);
    let axes = PrincipalAxes::of(&symmetric(DVec3::new(small, large, large), DVec3::new(0.0, 0.0, coupling)));
    // Smaller root of the quadratic, by its product with the larger, which has no cancellation:
    // (small large - coupling^2) / larger, with small large - coupling^2 = 1.38e-14 - 1e-16.
    let larger = large + coupling * coupling / (large - small);
    let expected = (small * large - coupling * coupling) / larger;
    assert!((axes.moments().x / expected - 1.0).abs() < 4e-16, "{:e} {expected:e}", axes.moments().x);
}

/// Zero, NaN, infinite and huge matrices: an answer without a panic, and not finite when the input is not.
#[test]
fn any_matrix_is_answered() {
    assert_eq!(PrincipalAxes::of(&DMat3::ZERO).moments(), DVec3::ZERO);
    assert!(!PrincipalAxes::of(&DMat3::from_cols_array(&[f64::NAN; 9])).moments().is_finite());
    let huge = symmetric(DVec3::splat(1e307), DVec3::splat(3e306));
    assert_matrix(rebuilt(&PrincipalAxes::of(&huge)), huge, 4e-15);
    let tiny = symmetric(DVec3::splat(1e-300), DVec3::splat(3e-301));
    assert_matrix(rebuilt(&PrincipalAxes::of(&tiny)), tiny, 4e-15);
}

proptest! {
    /// Moments ascend, axes are orthonormal and right-handed, and together they rebuild the matrix. Definite or not.
    #[test]
    fn rebuilds_its_matrix(diagonal in vectors(1.0), off in vectors(1.0)) {
        let matrix = symmetric(diagonal, off);
        prop_assume!(largest(matrix) > 1e-3);
        let axes = PrincipalAxes::of(&matrix);
        let m = axes.moments();
        prop_assert!(m.x <= m.y && m.y <= m.z);
        assert_matrix(rebuilt(&axes), matrix, 4e-15);
        let r = axes.rotation().to_matrix();
        assert_matrix(r.transpose() * r, DMat3::IDENTITY, 4e-15);
        prop_assert!((r.determinant() - 1.0).abs() < 4e-15);
        // The same input gives the same bits.
        prop_assert_eq!(axes, PrincipalAxes::of(&matrix));
    }

    /// Moments do not depend on the axes in which the matrix is given, and the signs follow the stated rule.
    #[test]
    fn moments_are_invariant(a in 0.1..1.0f64, b in 1.0..2.0f64, c in 2.0..3.0f64, rotation in rotations()) {
        let r = rotation.to_matrix();
        let matrix = r * DMat3::from_diagonal(DVec3::new(a, b, c)) * r.transpose();
        let axes = PrincipalAxes::of(&((matrix + matrix.transpose()) * 0.5));
        prop_assert!((axes.moments() - DVec3::new(a, b, c)).length() < 1e-14);
        let found = axes.rotation().to_matrix();
        for axis in [found.x_axis, found.y_axis] {
            let (high, low) = (axis.max_element(), axis.min_element());
            prop_assert!(high >= -low - 1e-15, "{axis}");
        }
    }
}
