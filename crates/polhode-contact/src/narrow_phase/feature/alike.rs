//! The angle within which two normals belong to one region of contact: 0.01 rad.

/// Normals within this angle belong to one contact region (cosine; 0.01 rad): bodies that lie on each other and rock,
/// as opposed to bodies that touch at an angle. The normal of a contact is compared with that of the best separating
/// face. Where two edges are the best axis, the normal of the face beside them is compared with that of the edges.
pub(crate) const ALIKE: f64 = 0.999_95;

/// Sine of the angle by which a normal may lie outside the normals of a rim, cap, apex or corner while the contact
/// still counts as one of that feature (0.01 rad): both ends of a body that lies on its side and rocks stay contacts.
pub(crate) const ALIKE_SINE: f64 = 0.01;
