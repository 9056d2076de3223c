//! The joints of a simulation at one time.

use crate::constraint::joint::ModelJoint;
use crate::identity::joint_id::JointId;
use crate::joints::{efforts, joint_power, motors};
use crate::report::joint_sample::JointSample;
use crate::scene::Coordinate;
use crate::tier::Tier;
use crate::tier::core::Core;
use crate::tier::facts::TierFeature;
use polhode_dynamics::BodyState;

/// The joints at `t` (s), when the bodies have these states, in the order of their handles. Those that broke or were
/// removed are left out.
pub(crate) fn joint_samples(tier: &dyn Tier, core: &Core, t: f64, states: &[BodyState]) -> Vec<JointSample> {
    let model = &core.model;
    if model.joints.list.is_empty() {
        return Vec::new();
    }
    let loads = tier.joint_loads(core, t, states);
    let are_computed = core.settings.takes(TierFeature::AllOfJoints);
    let sample = |joint: &ModelJoint| {
        let number = joint.number();
        let coordinates = Coordinate::ALL.into_iter();
        let coordinates = coordinates.filter_map(|own| Some((own, motors::coordinate_of(model, states, number, own)?)));
        let load = loads.iter().find(|load| load.joint.index() == number).copied();
        // What only limits hold, as a rope, bears nothing between them.
        let is_slack = are_computed && !joint.has_rows();
        let load = load.or_else(|| is_slack.then(|| efforts::no_load(model, states, joint)));
        let power_w =
            load.map(|load| joint_power::power_of_joint(model, states, joint, (load.force_n, load.moment_n_m)));
        JointSample {
            joint: JointId::new(number),
            coordinates: coordinates.collect(),
            efforts: efforts::of_joint(model, states, joint, load.as_ref()),
            reaction: load.map(|load| efforts::reaction(model, states, joint, &load)),
            load,
            power_w,
        }
    };
    model.joints.list.iter().map(sample).collect()
}
