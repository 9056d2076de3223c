//! What can be wrong with the data of a contact problem.
//!
//! Errors are about data that the caller can correct: lengths, indices, numbers that are not finite, settings out of
//! range. How well a solve went is not an error but a [`SolverStatus`](crate::SolverStatus).

use thiserror::Error;

/// Why a contact problem cannot be built or solved as asked.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ResponseError {
    /// A body has no velocity components.
    #[error("a body needs at least 1 velocity component (6 in space, 3 in a plane), found width {0}")]
    Width(usize),
    /// A list has the wrong number of entries.
    #[error("{what}: expected {expected} numbers, found {found}")]
    Length {
        /// Which list.
        what: &'static str,
        /// How many it must have.
        expected: usize,
        /// How many it has.
        found: usize,
    },
    /// A number is NaN or infinite, or became so by overflow.
    #[error("{what}: number {index} is not finite; check the input for NaN, infinity and overflow")]
    NotFinite {
        /// Which list.
        what: &'static str,
        /// Where in the list.
        index: usize,
    },
    /// The inverse mass of a body is not symmetric and positive semidefinite.
    #[error("the inverse mass matrix of body {body} must be symmetric and positive semidefinite")]
    InverseMass {
        /// The body.
        body: usize,
    },
    /// The mass block of a body is not symmetric and positive definite.
    #[error(
        "the mass block of body {body} must be symmetric and positive definite; a body that nothing moves is fixed"
    )]
    BodyMass {
        /// The body.
        body: usize,
    },
    /// A row names a body that does not exist.
    #[error("a row names body {body}, but the problem has {bodies} bodies")]
    UnknownBody {
        /// The body named.
        body: usize,
        /// Number of bodies.
        bodies: usize,
    },
    /// A row names one body twice.
    #[error("a row names body {body} twice; add the two blocks first")]
    RepeatedBody {
        /// The body named twice.
        body: usize,
    },
    /// A row must touch one or two bodies, that of a gear up to four.
    #[error(
        "a row touches one or two movable bodies, of a gear up to four, found {0}; leave out contacts between \
         immovable bodies"
    )]
    RowBodies(usize),
    /// A row cannot have this compliance.
    #[error(
        "row {row} cannot have a compliance of {compliance}: a row that is held and a finite number of at least 0 are \
         needed"
    )]
    Compliance {
        /// The row.
        row: usize,
        /// The compliance, 1/kg.
        compliance: f64,
    },
    /// Too many contacts to guess which of them vanish.
    #[error(
        "{contacts} contacts of bodies that touch have 2^{contacts} sets of those that vanish: guesses are accepted \
         for at most {limit}; use contact = \"heuristic\", \"least-force\" or \"active-set\""
    )]
    TooManyGuesses {
        /// Number of contacts.
        contacts: usize,
        /// The most that are accepted.
        limit: usize,
    },
    /// Too many rows for their matrix.
    #[error(
        "{rows} rows of contacts and joints are coupled, and their matrix is formed of at most {limit}: let fewer \
         bodies touch or be joined, or take time steps (tier = \"stepped\") without soft joints and gears, which need \
         no matrix"
    )]
    TooManyRows {
        /// Number of rows.
        rows: usize,
        /// The most that have a matrix.
        limit: usize,
    },
    /// A row index is out of range.
    #[error("row {row} does not exist, the problem has {rows} rows")]
    UnknownRow {
        /// The row named.
        row: usize,
        /// Number of rows.
        rows: usize,
    },
    /// A coefficient of restitution is outside `[0, 1]`.
    #[error("the coefficient of restitution of row {row} must be between 0 and 1, found {value}")]
    Restitution {
        /// The row.
        row: usize,
        /// The value found.
        value: f64,
    },
    /// A coefficient of tangential restitution is outside `[-1, 1]`.
    #[error("the coefficient of tangential restitution of contact {contact} must be between -1 and 1, found {value}")]
    TangentialRestitution {
        /// The contact.
        contact: usize,
        /// The value found.
        value: f64,
    },
    /// The collision matrix of a contact is not one.
    #[error("the collision matrix must be symmetric and positive semidefinite, with an entry above 0 for the normal")]
    CollisionMatrix,
    /// A contact that slides has no slip.
    #[error("a contact that slides needs a slip other than 0; a contact without slip sticks or starts to slide")]
    NoSlip,
    /// A setting is out of its range.
    #[error("setting {field} must be {accepted}, found {value}")]
    Setting {
        /// Name of the field.
        field: &'static str,
        /// What is accepted.
        accepted: &'static str,
        /// The value found.
        value: f64,
    },
    /// A block has not the rows of its law.
    #[error("the rows of one block: its law is of {expected}, found {found}")]
    BlockRows {
        /// How many its law has.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A row is in no block, or in several.
    #[error("row {row} is in {blocks} blocks: each row is in one, since its law is said there")]
    BlocksOfRow {
        /// The row.
        row: usize,
        /// How many blocks it is in.
        blocks: usize,
    },
    /// A solver without friction is given a block with friction.
    #[error("the block of row {row} has friction: `solve` takes it, solvers without friction do not")]
    HasFriction {
        /// The first row of the block.
        row: usize,
    },
    /// A block has no rows, or more than a contact has.
    #[error(
        "block {block} has {rows} rows, a contact or a hold has 1 to 3; give a joint of more rows as several blocks"
    )]
    FrictionRows {
        /// The block.
        block: usize,
        /// Its rows.
        rows: usize,
    },
    /// The pulse law is given a contact that resists rotations.
    #[error(
        "block {block} resists rolling or spinning, or slides already: the pulse law takes contacts with friction \
         against slip alone; use the simultaneous law"
    )]
    PulseOfRotation {
        /// The block.
        block: usize,
    },
    /// A coefficient of friction is negative or not finite.
    #[error("the coefficient of friction of contact {contact} must be at least 0 and finite, found {friction}")]
    Friction {
        /// The contact.
        contact: usize,
        /// The coefficient found.
        friction: f64,
    },
    /// A block of a matrix is given twice.
    #[error("block ({row}, {column}) of the Delassus matrix is given twice; add the two first")]
    RepeatedBlock {
        /// Its block row.
        row: usize,
        /// Its block column.
        column: usize,
    },
    /// A Delassus matrix is not symmetric.
    #[error(
        "the Delassus matrix must be symmetric: entry ({row}, {column}) is {value:e}, its mirror {other:e}; give both \
         their mean, (W + W^T)/2, where that is rounding"
    )]
    Asymmetric {
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        column: usize,
        /// The entry.
        value: f64,
        /// The entry with row and column exchanged.
        other: f64,
    },
    /// A Delassus matrix is not positive semidefinite.
    #[error(
        "the Delassus matrix must be positive semidefinite: what other rows leave of row {row} is {part:e} of its \
         diagonal entry, and at least -{limit:e} counts as rounding; form it as W = J M^-1 J^T of inverse masses that \
         are positive semidefinite"
    )]
    Indefinite {
        /// The row.
        row: usize,
        /// What is left of it, as a part of its diagonal entry (no unit).
        part: f64,
        /// How far below zero counts as rounding (no unit).
        limit: f64,
    },
    /// A Delassus matrix has a negative entry on its diagonal.
    #[error("the Delassus matrix must be positive semidefinite: diagonal entry {row} is {value:e}")]
    NegativeDiagonal {
        /// The row.
        row: usize,
        /// The entry.
        value: f64,
    },
}

/// Checks that `values` has `expected` entries.
pub(crate) fn check_length(what: &'static str, expected: usize, found: usize) -> Result<(), ResponseError> {
    if expected == found { Ok(()) } else { Err(ResponseError::Length { what, expected, found }) }
}

/// Checks that every entry of `values` is finite.
pub(crate) fn check_finite(what: &'static str, values: &[f64]) -> Result<(), ResponseError> {
    values
        .iter()
        .position(|value| !value.is_finite())
        .map_or(Ok(()), |index| Err(ResponseError::NotFinite { what, index }))
}
