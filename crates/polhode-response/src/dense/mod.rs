//! Small dense linear algebra: vector kernels, a Cholesky factor that grows and shrinks, a pivoted QR factor, and
//! numbers of twice the working precision.

pub(crate) mod cholesky;
pub(crate) mod householder;
pub(crate) mod kernels;
pub(crate) mod scalar;
pub(crate) mod semidefinite;
pub(crate) mod small;
