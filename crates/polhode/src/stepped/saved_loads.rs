//! The loads of joints over the last step as plain data, for snapshots: of each joint its number, force (N) and moment
//! (N m).

use crate::report::frame::JointView;
use crate::solve::joint_loads::joint_view;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Loads as plain data: of each joint the force and the moment.
pub(super) fn saved_loads(loads: &BTreeMap<usize, JointView>) -> Vec<(usize, [f64; 3], [f64; 3])> {
    loads.iter().map(|(&joint, view)| (joint, view.force_n.to_array(), view.moment_n_m.to_array())).collect()
}

/// Loads from plain data; where they act is where their joints are.
pub(super) fn restored_loads(saved: &[(usize, [f64; 3], [f64; 3])]) -> BTreeMap<usize, JointView> {
    let load = |&(joint, force, moment): &(usize, [f64; 3], [f64; 3])| {
        let load = (DVec3::from_array(force), DVec3::from_array(moment));
        (joint, joint_view(joint, DVec3::ZERO, load))
    };
    saved.iter().map(load).collect()
}
