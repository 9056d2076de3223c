//! The loads of joints over the last step as plain data, for snapshots: of each joint its number, force (N), moment
//! (N m) and what of them acts along its coordinates.

use crate::report::frame::JointView;
use crate::report::joint_efforts::EffortsAlong;
use crate::snapshot::content::JointLoad;
use crate::solve::joint_loads::joint_view;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Loads as plain data: of each joint the force and the moment.
pub(super) fn saved_loads(loads: &BTreeMap<usize, JointView>) -> Vec<JointLoad> {
    let saved = |(&joint, view): (&usize, &JointView)| JointLoad {
        joint,
        force_n: view.force_n.to_array(),
        moment_n_m: view.moment_n_m.to_array(),
        efforts: view.along.to_numbers(),
    };
    loads.iter().map(saved).collect()
}

/// Loads from plain data; where they act is where their joints are.
pub(super) fn restored_loads(saved: &[JointLoad]) -> BTreeMap<usize, JointView> {
    let load = |&JointLoad { joint, force_n, moment_n_m, efforts }: &JointLoad| {
        let load = (DVec3::from_array(force_n), DVec3::from_array(moment_n_m));
        let along = EffortsAlong::from_numbers(efforts);
        (joint, JointView { along, ..joint_view(joint, DVec3::ZERO, load) })
    };
    saved.iter().map(load).collect()
}
