//! What a step has applied, as it is told: the loads of joints.
//!
//! Loads are impulses of the step; divided by its length they are its mean forces. A joint is told what its rows, its
//! stops and its friction have given, the rest that was projected out of its velocities with them. Impulses of the
//! impact law are kept apart: they grow beyond all bounds as forces of shorter and shorter steps.

use crate::constraint::ConstraintId;
use crate::identity::contact_id::Feature;
use crate::joints::bilateral::{Bilateral, Reaction};
use crate::model::Model;
use crate::report::frame::JointView;
use crate::solve::joint_loads::{ContactForce, add_joint_loads};
use polhode_dynamics::BodyState;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// What joints and others have been given in a step.
#[derive(Debug, Clone, Default)]
pub(crate) struct ToldLoads {
    /// Impulses of joints over the step by their numbers, N s and N m s, without those of impacts.
    pub(crate) joints: BTreeMap<usize, JointView>,
    /// The same of impacts.
    pub(crate) struck: BTreeMap<usize, JointView>,
    /// Impulses of what is no joint and no contact, N s: body and impulse.
    pub(crate) others: Vec<(usize, DVec3)>,
}

impl ToldLoads {
    /// Takes the impulses of constraints in these states.
    pub(crate) fn take<'a>(
        &mut self,
        model: &Model,
        states: &[BodyState],
        reactions: impl Iterator<Item = (&'a Bilateral, Reaction)> + Clone,
    ) {
        add_joint_loads(&mut self.joints, model, states, (reactions.clone(), std::iter::empty()));
        for (of, reaction) in reactions {
            if of.softness.is_some() || matches!(of.id, ConstraintId::Pivot { .. }) {
                self.others.extend(of.loads(reaction).map(|(body, impulse, _)| (body, impulse)));
            }
        }
    }

    /// Takes those of an impact.
    pub(crate) fn take_struck<'a>(
        &mut self,
        model: &Model,
        states: &[BodyState],
        reactions: impl Iterator<Item = (&'a Bilateral, Reaction)> + Clone,
    ) {
        add_joint_loads(&mut self.struck, model, states, (reactions.clone(), std::iter::empty()));
        let of_pivots = reactions.filter(|(of, _)| matches!(of.id, ConstraintId::Pivot { .. }));
        self.others.extend(of_pivots.flat_map(|(of, p)| of.loads(p)).map(|(body, impulse, _)| (body, impulse)));
    }

    /// Takes the impulse of a contact on A, N s, if it is one of a joint.
    pub(crate) fn take_contact(
        &mut self,
        model: &Model,
        states: &[BodyState],
        (force, is_struck): (ContactForce, bool),
    ) {
        if !matches!(force.id.feature, Feature::Shapes(_)) {
            let views = if is_struck { &mut self.struck } else { &mut self.joints };
            add_joint_loads(views, model, states, (std::iter::empty(), std::iter::once(force)));
        }
    }

    /// Adds those of a later step.
    pub(crate) fn append(&mut self, later: Self) {
        for (views, later) in [(&mut self.joints, later.joints), (&mut self.struck, later.struck)] {
            for (joint, view) in later {
                let own = views.entry(joint).or_insert_with(|| view.times(0.0));
                own.add(&view);
                own.point_m = view.point_m;
            }
        }
    }

    /// The mean loads of a step of `h` (s), N and N m: without what impacts gave, and with it.
    pub(crate) fn means(&self, h: f64) -> [BTreeMap<usize, JointView>; 2] {
        let mean = |view: &JointView| JointView {
            force_n: view.force_n / h,
            moment_n_m: view.moment_n_m / h,
            ..view.times(h.recip())
        };
        let sustained: BTreeMap<usize, JointView> =
            self.joints.iter().map(|(&joint, view)| (joint, mean(view))).collect();
        let mut all = sustained.clone();
        for (&joint, view) in &self.struck {
            let view = mean(view);
            all.entry(joint).or_insert_with(|| view.times(0.0)).add(&view);
        }
        [sustained, all]
    }
}
