//! Contacts as programs see them.

use crate::collision::contact_kinematics;
use crate::collision::touch::Touch;
use crate::identity::body_id::BodyId;
use crate::identity::contact_id::Feature;
use crate::model::Model;
use crate::report::frame::ContactView;
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;

/// Adds the view of a contact with this force along its normal and this friction (N). In planar motion a contact
/// may represent its mirror image too; then two views are added, each with half of the force.
pub(crate) fn view_contact(
    model: &Model,
    states: &[BodyState],
    touch: &Touch,
    (force_n, friction_n): (f64, DVec3),
    views: &mut Vec<ContactView>,
) {
    let (id, geometry) = (touch.id, touch.kinematics.geometry);
    // The force of a stop is part of the load of its joint.
    let Feature::Shapes(feature) = id.feature else { return };
    let view = ContactView {
        body_a: BodyId::new(id.a),
        body_b: BodyId::new(id.b),
        feature,
        point_m: geometry.point,
        normal: geometry.normal,
        separation_m: geometry.separation,
        normal_force_n: force_n,
        friction_n,
    };
    let Some(aside) = contact_kinematics::mirrored(model, states, id) else { return views.push(view) };
    for point_m in [view.point_m - aside, view.point_m + aside] {
        let (normal_force_n, friction_n) = (0.5 * force_n, friction_n * 0.5);
        views.push(ContactView { point_m, normal_force_n, friction_n, ..view });
    }
}
