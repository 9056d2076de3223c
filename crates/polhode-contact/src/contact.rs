//! Contacts of a pair of bodies: geometry, derivatives and the set of all of them.

use crate::ContactFeature;
use glam::DVec3;

/// Where and how a contact stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactGeometry {
    /// Point of the contact in the world, m: the middle of the gap (or of the overlap) along the normal. The velocities
    /// along the normal are the same at every point of that line.
    pub point: DVec3,
    /// Unit normal in the world, from B to A.
    pub normal: DVec3,
    /// Signed distance of the two features along the normal, m; negative when they overlap.
    pub separation: f64,
    /// Distance of the contact from the border of its features, m: of a vertex from the border of its face, of a
    /// crossing from the ends of its edges, of a sphere's centre from the border of the feature's Voronoi region.
    /// Negative when the contact has left its features; infinite where there is no border.
    pub margin: f64,
}

/// A contact: its identity and where it stands.
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
    /// Where the contact stands.
    pub geometry: ContactGeometry,
    /// `chi'`, m/s; negative when the bodies approach.
    pub separation_rate: f64,
    /// All terms of `chi''` that are not linear in the accelerations, m/s^2.
    pub acceleration_bias: f64,
}

/// The tangential terms of a contact, as friction needs them: which way it slips, and how that changes.
///
/// Let `p` be the contact point ([`ContactGeometry::point`], which wanders over both bodies), `r_A` and `r_B` the arms
/// from the centres of mass to it, `V = v_A + w_A x r_A - v_B - w_B x r_B` the velocity of A's material there against
/// B's, and `P = 1 - n n^T` the projection on the tangent plane. Then
///
/// `u_T = P V`,  `u_T' = P (v_A' + w_A' x r_A - v_B' - w_B' x r_B) + acceleration_bias`.
///
/// `u_T'` is the derivative of the slip at the contact as it wanders and its normal turns, not that of two points fixed
/// to the bodies. It is what a contact that sticks or rolls keeps at zero. All vectors are in world axes. Swapping A and B
/// turns the slip, the bias and the rate of the normal round, and of the basis the second vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TangentialKinematics {
    /// [`tangent_basis`](crate::tangent_basis) of the normal: `t_1 x t_2 = n`. It is a choice of axes, made from the normal
    /// alone; no other field depends on it.
    pub basis: [DVec3; 2],
    /// `u_T`, m/s: how A slips over B.
    pub slip_velocity: DVec3,
    /// All terms of `u_T'` that are not linear in the accelerations, m/s^2. It has a part along n, `-(n'.u_T) n`, with
    /// which the slip stays in the tangent plane as that turns; of a contact that does not slip this part is zero.
    pub acceleration_bias: DVec3,
    /// `p'`, m/s. Where a whole circle is as near as its nearest place, that place is held still on its body.
    pub point_velocity: DVec3,
    /// `n'`, 1/s.
    pub normal_rate: DVec3,
}

/// What decided the separation of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SeparatingAxis {
    /// The normal of a face of A (a half-space is face 0).
    FaceA(u32),
    /// The normal of a face of B (a half-space is face 0).
    FaceB(u32),
    /// The common perpendicular of an edge of A and an edge of B.
    Edges(u32, u32),
    /// The line between nearest points of a smooth shape or a cloud and the other body.
    Nearest,
    /// The pair never touches (two half-spaces, two clouds), or the poses are not finite.
    None,
}

/// All contacts of a pair within a reach.
#[derive(Debug, Clone, PartialEq)]
pub struct Manifold {
    /// The contacts, sorted by feature, one for each place.
    pub contacts: Vec<Contact>,
    /// Signed separation, m: the depth of penetration (negative) when the bodies overlap; apart, a lower bound of their
    /// distance that is zero exactly when they touch (and the distance itself when a face or a smooth shape decides).
    /// Beyond the reach the search stops at the first axis that shows it, and this is the separation along that axis.
    pub separation: f64,
    /// What decided the contacts: of two polyhedra the axis with this separation, and a face where edges separate by no more
    /// than the clearance of places above the best one.
    pub axis: SeparatingAxis,
}

impl Default for Manifold {
    /// No contact, and nothing known.
    fn default() -> Self {
        Self { contacts: Vec::new(), separation: f64::NAN, axis: SeparatingAxis::None }
    }
}

impl Manifold {
    /// Forgets the contacts, and takes a separation.
    pub(crate) fn set_empty(&mut self, separation: f64, axis: SeparatingAxis) {
        self.contacts.clear();
        (self.separation, self.axis) = (separation, axis);
    }
}
