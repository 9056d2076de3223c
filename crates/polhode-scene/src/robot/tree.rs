//! Whether the joints of a robot make a tree, and its links in the order from the root.

use super::finding::{Findings, RobotDefect};
use super::model::{Robot, RobotJoint};

/// Most links of a circle that a message names.
const MOST_NAMED: usize = 8;

/// The same robot with its root first and each link behind its parent; `None` when the joints make no tree, which is
/// noted.
pub(super) fn in_order(robot: Robot, findings: &mut Findings) -> Option<Robot> {
    let parents = parents(&robot, findings)?;
    let roots: Vec<usize> = (0..robot.links.len()).filter(|&link| parents[link].is_none()).collect();
    let mut children = vec![Vec::new(); robot.links.len()];
    for (number, joint) in robot.joints.iter().enumerate() {
        children[joint.parent].push(number);
    }
    let mut order = Vec::with_capacity(robot.links.len());
    let mut open: Vec<usize> = roots.first().copied().into_iter().collect();
    while let Some(link) = open.pop() {
        order.push(link);
        open.extend(children[link].iter().rev().map(|&joint| robot.joints[joint].child));
    }
    let mut place_of = vec![None; robot.links.len()];
    for (place, &link) in order.iter().enumerate() {
        place_of[link] = Some(place);
    }
    let mut is_tree = true;
    for &root in roots.iter().skip(1) {
        let (first, own) = (&robot.links[roots[0]], &robot.links[root]);
        findings.add(&own.place, format!("link `{}`", own.name), RobotDefect::SecondRoot(first.name.clone()));
        is_tree = false;
    }
    // What hangs at no root hangs at itself.
    if let Some(link) = (0..robot.links.len()).find(|&link| place_of[link].is_none() && roots.len() <= 1) {
        add_cycle(&robot, &parents, link, findings);
        is_tree = false;
    }
    is_tree.then(|| sorted(robot, &order, &place_of))
}

/// The joint at which each link hangs.
fn parents(robot: &Robot, findings: &mut Findings) -> Option<Vec<Option<usize>>> {
    let mut parents: Vec<Option<usize>> = vec![None; robot.links.len()];
    let mut is_tree = true;
    for (number, joint) in robot.joints.iter().enumerate() {
        let parent = parents.get_mut(joint.child)?;
        if let Some(first) = parent {
            let first = robot.joints[*first].name.clone();
            let subject = format!("joint `{}`, link `{}`", joint.name, robot.links[joint.child].name);
            findings.add(&joint.place, subject, RobotDefect::TwoParents { first });
            is_tree = false;
        } else {
            *parent = Some(number);
        }
    }
    is_tree.then_some(parents)
}

/// Notes the circle that is above a link.
fn add_cycle(robot: &Robot, parents: &[Option<usize>], link: usize, findings: &mut Findings) {
    let up = |link: usize| parents[link].map(|joint| robot.joints[joint].parent);
    // After as many steps as there are links one is in the circle.
    let inside = robot.links.iter().try_fold(link, |link, _| up(link)).unwrap_or(link);
    let mut names = vec![robot.links[inside].name.clone()];
    let mut at = up(inside);
    while let Some(link) = at.filter(|&link| link != inside) {
        names.push(robot.links[link].name.clone());
        at = up(link);
    }
    let shown: Vec<String> = names.iter().skip(1).take(MOST_NAMED).map(|name| format!("`{name}`")).collect();
    let over = if shown.is_empty() { "its own joint".to_owned() } else { shown.join(", ") };
    let own = &robot.links[inside];
    findings.add(&own.place, format!("link `{}`", own.name), RobotDefect::Cycle(over));
}

/// The robot with its links in this order.
fn sorted(robot: Robot, order: &[usize], place_of: &[Option<usize>]) -> Robot {
    let renumbered = |link: usize| place_of.get(link).copied().flatten().unwrap_or(0);
    let mut joints: Vec<RobotJoint> = robot.joints;
    for joint in &mut joints {
        (joint.parent, joint.child) = (renumbered(joint.parent), renumbered(joint.child));
    }
    joints.sort_by_key(|joint| joint.child);
    let loops = robot.loops.into_iter().map(|mut own| {
        own.links = own.links.map(renumbered);
        own
    });
    Robot {
        links: order.iter().map(|&link| robot.links[link].clone()).collect(),
        loops: loops.collect(),
        apart: robot.apart.iter().map(|pair| pair.map(renumbered)).collect(),
        joints,
        ..robot
    }
}
