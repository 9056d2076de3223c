//! Small dense linear algebra: vector kernels, a Cholesky factor that grows and shrinks, a pivoted QR factor, and
//! numbers of twice the working precision.
//!
//! | module | holds |
//! |---|---|
//! | `cholesky` | a Cholesky factor that grows by one row and shrinks by any row |
//! | `householder` | QR factorisation with column pivoting, which reveals the rank |
//! | `kernels` | sums and updates of vectors, in a fixed order of operations |
//! | `scalar` | the numbers that the active set calculates with |
//! | `semidefinite` | whether a matrix is symmetric and positive semidefinite, of any rank |
//! | `small` | elimination for a handful of unknowns, in place |

pub(crate) mod cholesky;
pub(crate) mod householder;
pub(crate) mod kernels;
pub(crate) mod scalar;
pub(crate) mod semidefinite;
pub(crate) mod small;
