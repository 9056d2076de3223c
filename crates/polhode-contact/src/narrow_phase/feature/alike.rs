//! The angle within which two normals belong to one region of contact: 0.01 rad.

/// Normals within this angle belong to one contact region (cosine; 0.01 rad): bodies that lie on each other and rock, as
/// opposed to bodies that touch at an angle. Contacts are measured against the normal of the face that decides, and this
/// face, where a crossing decides, against the crossing's.
pub(crate) const ALIKE: f64 = 0.999_95;

/// Sine of the angle by which a normal may leave the normals of a rim, cap, apex or corner before the contact has left it
/// (0.01 rad): both ends of a body that lies on its side and rocks stay contacts.
pub(crate) const ALIKE_SINE: f64 = 0.01;
