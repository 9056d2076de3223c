//! Contacts of a pair of bodies: geometry, derivatives and the set of all of them.

use crate::ContactFeature;
use glam::DVec3;

/// Point, normal and separation of a contact at one pose of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactGeometry {
    /// Contact point in the world, m: the midpoint of the gap (or of the overlap) along the normal. The choice of the
    /// point on that line does not matter to the velocity along the normal.
    pub point: DVec3,
    /// Unit normal in the world, from B to A.
    pub normal: DVec3,
    /// Signed distance of the two features along the normal, m; negative when they overlap.
    pub separation: f64,
    /// Distance of the contact from the border of its features, m: of a vertex from the border of the face, of the
    /// crossing of two edges from their ends, of a sphere's centre from the border of the feature's Voronoi region.
    /// Negative when the contact is beyond that border, so that other features touch; infinite where there is no
    /// border.
    pub margin: f64,
}

/// A contact: its identity and its geometry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Which features touch.
    pub feature: ContactFeature,
    /// Where they touch.
    pub geometry: ContactGeometry,
}

/// A contact and the time derivatives of its separation chi (thesis 3.4).
///
/// `chi'' = n.(v_A' + w_A' x r_A - v_B' - w_B' x r_B) + acceleration_bias` with `r = point - centre of mass` and `n`
/// of unit length (equation (18) with erratum E18; the edge-edge form divided by `|e_A x e_B|`). It is exact also while
/// the bodies do not touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactKinematics {
    /// Point, normal and separation.
    pub geometry: ContactGeometry,
    /// `chi'`, m/s; negative when the bodies approach.
    pub separation_rate: f64,
    /// All terms of `chi''` that are not linear in the accelerations, m/s^2.
    pub acceleration_bias: f64,
}

/// The tangential terms of a contact, as friction needs them: the slip velocity and the terms of its derivative.
///
/// Let `p` be the contact point ([`ContactGeometry::point`], which moves over the surfaces of both bodies), `r_A` and
/// `r_B` the arms from the centres of mass to it, `V = v_A + w_A x r_A - v_B - w_B x r_B` the velocity of A's material
/// point there relative to B's, and `P = 1 - n n^T` the projection on the tangent plane. Then
///
/// `u_T = P V`,  `u_T' = P (v_A' + w_A' x r_A - v_B' - w_B' x r_B) + acceleration_bias`.
///
/// `u_T'` is the derivative of the slip at the contact point as that point moves and its normal turns, not that of two
/// points fixed to the bodies. A contact that sticks or rolls keeps it at zero. All vectors are in world axes. Swapping
/// A and B reverses the slip, the bias, the rate of the normal and the second vector of the basis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialKinematics {
    /// [`tangent_basis`](crate::tangent_basis) of the normal: `t_1 x t_2 = n`. It depends on the normal alone, and no
    /// other field depends on it.
    pub basis: [DVec3; 2],
    /// `u_T`, m/s: the velocity at which A slips over B.
    pub slip_velocity: DVec3,
    /// All terms of `u_T'` that are not linear in the accelerations, m/s^2. Its component along n, `-(n'.u_T) n`, keeps
    /// the slip in the tangent plane as the plane turns; it is zero without slip.
    pub acceleration_bias: DVec3,
    /// `p'`, m/s. Where all points of a circle are equally near, the contact point is taken as fixed to the circle's
    /// body.
    pub point_velocity: DVec3,
    /// `n'`, 1/s.
    pub normal_rate: DVec3,
}

/// The axis along which the separation of a pair was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SeparatingAxis {
    /// The normal of a face of A (a half-space is face 0).
    FaceA(u32),
    /// The normal of a face of B (a half-space is face 0).
    FaceB(u32),
    /// The common perpendicular of an edge of A and an edge of B.
    Edges(u32, u32),
    /// The line between the nearest points of the two bodies, one of which is a smooth shape, a point cloud, a mesh or
    /// a compound.
    Nearest,
    /// None: the pair never touches (two half-spaces, two clouds), a pose is not finite, or
    /// [`near_manifold`](crate::near_manifold) found only that the pair is beyond the reach.
    None,
}

/// All contacts of a pair whose separation is at most a limit (`reach`).
#[derive(Debug, Clone, PartialEq)]
pub struct Manifold {
    /// The contacts, sorted by feature, one at each point of contact.
    pub contacts: Vec<Contact>,
    /// Signed separation, m: minus the depth of penetration when the bodies overlap; apart, a lower bound of their
    /// distance that is zero exactly when they touch (and the distance itself when the axis is a face normal or belongs
    /// to a smooth shape). A search that finds an axis with a separation beyond the reach stops there, and this is the
    /// separation along that axis.
    pub separation: f64,
    /// The axis from which the contacts follow. Of two polyhedra it is the axis with this separation; a face is
    /// preferred when the best pair of edges separates by less than the place tolerance more than the best face.
    pub axis: SeparatingAxis,
}

impl Default for Manifold {
    /// No contact, and an unknown separation.
    fn default() -> Self {
        Self { contacts: Vec::new(), separation: f64::NAN, axis: SeparatingAxis::None }
    }
}

impl Manifold {
    /// Whether the separation exceeds the reach (m), so that there are no contacts; also when either is NaN.
    pub(crate) fn is_beyond(&self, reach: f64) -> bool {
        self.separation.is_nan() || reach.is_nan() || self.separation > reach
    }

    /// Removes the contacts, and sets the separation and its axis.
    pub(crate) fn set_empty(&mut self, separation: f64, axis: SeparatingAxis) {
        self.contacts.clear();
        (self.separation, self.axis) = (separation, axis);
    }
}
