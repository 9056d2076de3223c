//! Newton's law of restitution at one contact: equation (14) of the thesis.

/// The impulse of a contact that is struck alone, N s:
/// `J = -(1 + e) u / K` for `u < 0`, with `K = G_ii` (1/kg) the denominator of equation (14).
///
/// 0 when the contact does not approach; `None` when it approaches and no body can move, or a number is not finite.
/// Energy lost: `(1 - e^2) u^2 / (2 K)` (thesis, Appendix B for e = 1).
///
/// ```
/// use polhode_response::single_contact_impulse;
/// // A ball of 2 kg at 3 m/s against a wall, e = 1/2: it leaves at 1.5 m/s.
/// assert_eq!(single_contact_impulse(0.5, -3.0, 0.5), Some(9.0));
/// ```
pub fn single_contact_impulse(inverse_mass: f64, velocity: f64, restitution: f64) -> Option<f64> {
    if velocity >= 0.0 {
        return Some(0.0);
    }
    let impulse = -(1.0 + restitution) * velocity / inverse_mass;
    (inverse_mass > 0.0 && impulse.is_finite()).then_some(impulse)
}
