//! Time of impact of compounds and triangle meshes: the earliest impact of any pair of parts. A triangle is a part of a
//! mesh.
//!
//! Each pair of parts whose swept boxes overlap is searched separately, up to the earliest time found so far. If the
//! boxes of many pairs overlap, the interval is divided into windows. A pair whose boxes first overlap in a later
//! window is clear before it. The search of a pair runs from its first window to the end of the whole interval; it is
//! not begun anew at the border of a window.
//!
//! Bodies in contact at the start may touch with further parts without an impact, when a body slides over the joint of
//! two parts or from triangle to triangle. For such bodies, a new touch counts as an impact only if a contact of the
//! whole pair approaches. Otherwise the search of this pair of parts continues from there, as for a pair in contact at
//! its start.
//!
//! A point of a cloud that lies in a triangle at the start is on neither side of the surface. It may leave to either
//! side.

use crate::bounding::aabb::Aabb;
use crate::bounding::around_shape::Sweep;
use crate::bounding::floor::Floor;
use crate::clearance::touch_tolerance;
use crate::impact::impact_error::ImpactError;
use crate::impact::impact_report::ImpactReport;
use crate::impact::impact_search::ImpactSearch;
use crate::impact::pair_impact::find_in_parts;
use crate::narrow_phase::dispatch::manifold::near_manifold_into;
use crate::narrow_phase::dispatch::separation::separation_with;
use crate::narrow_phase::dispatch::workspace::Workspace;
use crate::narrow_phase::parts::mesh_pair::{mesh_and_other, never_meets};
use crate::narrow_phase::terms::evaluate::kinematics;
use crate::shape::TriangleMesh;
use crate::shape::extent::turned;
use crate::{Manifold, Shape};
use polhode_spatial::{Motion, Pose, Velocity};
use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::BTreeSet;

/// While more pairs of parts than this could touch in a window, the number of windows is doubled.
const MANY_PAIRS: usize = 64;

/// Largest number of windows.
const MOST_WINDOWS: u32 = 64;

/// A contact approaches when its separation rate is below minus this times the speeds of the two contact points. The
/// limit is above the rounding of the rate of a sliding contact.
const APPROACHING: f64 = 1e-10;

/// After this many touches of one pair of parts without approach, the next touch counts as an impact.
const MOST_SLIDES: u32 = 4096;

/// Which pairs of parts are searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parts {
    /// All.
    All,
    /// Only those that are clear of each other at the start, for bodies that stay in contact with other parts.
    Clear,
}

/// The pair of whole bodies.
struct Pair<'a> {
    parts: Parts,
    /// Poses at the start.
    poses: [Pose; 2],
    shapes: [&'a Shape; 2],
    motions: [&'a dyn Motion; 2],
    settings: &'a ImpactSearch,
    /// Distance up to which the bodies touch at the start, m.
    touch: f64,
    /// Whether the bodies touch at the start; computed when first needed.
    starts_in_touch: OnceCell<bool>,
}

/// The earliest impact of two bodies, at least one of them a compound or a mesh. When there is none, the reported
/// separation is infinite: the separation of all parts at the end of the interval costs more than most searches, and
/// few callers need it.
pub(crate) fn find_composite(
    shapes: [&Shape; 2],
    motions: [&dyn Motion; 2],
    (t0, t1): (f64, f64),
    settings: &ImpactSearch,
    parts: Parts,
) -> Result<ImpactReport, ImpactError> {
    let mut workspace = Workspace::default();
    let poses = [motions[0].pose(t0), motions[1].pose(t0)];
    if !(poses[0].is_finite() && poses[1].is_finite()) {
        return Err(ImpactError::NotFinite { t: t0 });
    }
    let touch = touch_tolerance(shapes[0], &poses[0], shapes[1], &poses[1], settings.touch_relative);
    let pair = Pair { parts, poses, shapes, motions, settings, touch, starts_in_touch: OnceCell::new() };
    let mut best = ImpactReport { time: None, separation: f64::INFINITY, evaluations: 0, cuts: 0 };
    let mut candidates = Vec::new();
    let mut windows = 1;
    pair.candidates(t0, t1, &mut candidates)?;
    while candidates.len() > MANY_PAIRS && windows < MOST_WINDOWS {
        windows *= 2;
        pair.candidates(t0, t0 + (t1 - t0) / f64::from(windows), &mut candidates)?;
    }
    let mut seen = BTreeSet::new();
    for window in 0..windows {
        let at = |k: u32| if k == windows { t1 } else { t0 + (t1 - t0) * (f64::from(k) / f64::from(windows)) };
        let (start, end) = (at(window), at(window + 1));
        let limit = best.time.unwrap_or(t1);
        if start >= limit && window > 0 {
            break;
        }
        pair.candidates(start, end.min(limit), &mut candidates)?;
        for &parts in &candidates {
            if seen.insert(parts) {
                pair.search(&mut workspace, parts, start, t1, &mut best)?;
            }
        }
    }
    Ok(best)
}

impl Pair<'_> {
    /// The pairs of parts whose swept boxes overlap in a window of time (s), sorted.
    fn candidates(&self, start: f64, end: f64, found: &mut Vec<[u32; 2]>) -> Result<(), ImpactError> {
        found.clear();
        let fail = |_| ImpactError::NotFinite { t: start };
        let [sweep_a, sweep_b] = self.motions.map(|motion| Sweep::new(motion, start, end).map_err(fail));
        let sweeps = [sweep_a?, sweep_b?];
        let swept = |at: usize, part: &Shape| -> Result<Aabb, ImpactError> {
            sweeps[at].of(part).and_then(|b| b.inflated(2.0 * self.touch)).map_err(fail)
        };
        if let Some((at, mesh, other)) = mesh_and_other(self.shapes) {
            if never_meets(other) {
                return Ok(());
            }
            for (i, part) in (0..).zip(other.parts()) {
                let bounds = self.in_frame_of_mesh(at, mesh, &swept(1 - at, part)?, start, end);
                mesh.tree.overlaps(&bounds, &mut |triangle| {
                    found.push(if at == 0 { [triangle, i] } else { [i, triangle] });
                });
            }
        } else {
            let boxes = |at: usize| -> Result<Vec<(u32, Aabb)>, ImpactError> {
                let reach = Reach { touch: 2.0 * self.touch, floor: self.still_floor(1 - at, start, end) };
                let other = || match self.shapes[1 - at] {
                    Shape::Compound(compound) => Ok(sweeps[1 - at].of_box(compound.tree.bounds()).widened(reach.touch)),
                    shape => swept(1 - at, shape),
                };
                let near = reach.parts_near(self.shapes[at], &sweeps[at], other)?;
                let boxed = near.into_iter().map(|i| {
                    let part = self.shapes[at].parts().get(i as usize).unwrap_or(self.shapes[at]);
                    swept(at, part).map(|bounds| (i, bounds))
                });
                let above = |bounds: &Aabb| reach.floor.is_none_or(|floor| floor.height(bounds) <= 0.0);
                boxed.filter(|part| part.as_ref().map_or(true, |(_, bounds)| above(bounds))).collect()
            };
            let (boxes_a, boxes_b) = (boxes(0)?, boxes(1)?);
            for (i, box_a) in &boxes_a {
                let meeting = boxes_b.iter().filter(|(_, box_b)| box_a.overlaps(box_b));
                found.extend(meeting.map(|(j, _)| [*i, *j]));
            }
        }
        found.sort_unstable();
        Ok(())
    }

    /// The half-space that body `at` is, in the world, if it does not move in a window of time (s).
    fn still_floor(&self, at: usize, start: f64, end: f64) -> Option<Floor> {
        let motion = self.motions[at];
        let floor = Floor::of(self.shapes[at], &motion.pose(start))?;
        let bounds = motion.bounds(start, end);
        (bounds.speed == 0.0 && bounds.angular_speed == 0.0).then_some(floor)
    }

    /// A box that contains a given world box in the frame of the mesh (body `at`) at all times of a window.
    fn in_frame_of_mesh(&self, at: usize, mesh: &TriangleMesh, swept: &Aabb, start: f64, end: f64) -> Aabb {
        let motion = self.motions[at];
        let (pose, bounds) = (motion.pose(start), motion.bounds(start, end));
        let length = end - start;
        let turning = if bounds.angular_speed > 0.0 { bounds.angular_speed * length * mesh.radius() } else { 0.0 };
        let stray = bounds.speed * length + turning;
        if !(stray.is_finite() && swept.is_finite()) {
            return Aabb::UNBOUNDED;
        }
        let near = Aabb { min: swept.min() - pose.translation, max: swept.max() - pose.translation };
        let frame = Pose { rotation: pose.rotation.inverse(), translation: glam::DVec3::ZERO };
        turned(near, &frame).widened(stray)
    }

    /// Searches one pair of parts from a time at which it is clear, or from the start.
    fn search(
        &self,
        workspace: &mut Workspace,
        parts: [u32; 2],
        start: f64,
        t1: f64,
        best: &mut ImpactReport,
    ) -> Result<(), ImpactError> {
        let (Some(a), Some(b)) = (part(self.shapes[0], parts[0]), part(self.shapes[1], parts[1])) else {
            return Ok(());
        };
        if self.parts == Parts::Clear {
            let [pose_a, pose_b] = &self.poses;
            if separation_with(workspace, a.as_ref(), pose_a, b.as_ref(), pose_b) <= self.touch {
                return Ok(());
            }
        }
        let mut from = start;
        for slides in 0..=MOST_SLIDES {
            let limit = best.time.unwrap_or(t1);
            if from >= limit && from > start {
                break;
            }
            let found =
                find_in_parts([a.as_ref(), b.as_ref()], self.shapes, self.motions, (from, limit), self.settings)?;
            best.evaluations = best.evaluations.saturating_add(found.evaluations);
            best.cuts = best.cuts.saturating_add(found.cuts);
            let Some(t) = found.time else { break };
            if !self.starts_in_touch(workspace, best)
                || slides == MOST_SLIDES
                || t <= from
                || self.approaches(workspace, t)
            {
                best.time = Some(t);
                best.separation = found.separation;
                break;
            }
            if self.parts == Parts::Clear {
                break;
            }
            from = t;
        }
        Ok(())
    }

    /// Whether the bodies touch at the start. This needs the separation of all parts: it is computed only after a pair
    /// of parts has been found to touch.
    fn starts_in_touch(&self, workspace: &mut Workspace, best: &mut ImpactReport) -> bool {
        *self.starts_in_touch.get_or_init(|| {
            best.evaluations = best.evaluations.saturating_add(1);
            let ([shape_a, shape_b], [pose_a, pose_b]) = (self.shapes, &self.poses);
            separation_with(workspace, shape_a, pose_a, shape_b, pose_b) <= self.touch
        })
    }

    /// Whether a contact of the whole pair approaches at a time.
    fn approaches(&self, workspace: &mut Workspace, t: f64) -> bool {
        let [shape_a, shape_b] = self.shapes;
        let poses = self.motions.map(|motion| motion.pose(t));
        let velocities = self.motions.map(|motion| motion.velocity(t));
        let mut touching = Manifold::default();
        near_manifold_into(workspace, shape_a, &poses[0], shape_b, &poses[1], self.touch, &mut touching);
        // Other parts touched earlier, and their search gives the time. Contacts of bodies that overlap this much are
        // not used.
        if touching.separation < -self.touch {
            return true;
        }
        touching.contacts.iter().any(|contact| {
            let [va, vb] = &velocities;
            let found = kinematics(contact.feature, shape_a, &poses[0], va, shape_b, &poses[1], vb);
            let speed = |pose: &Pose, v: &Velocity| {
                v.linear.length() + v.angular.cross(contact.geometry.point - pose.translation).length()
            };
            let scale = speed(&poses[0], va) + speed(&poses[1], vb);
            found.is_none_or(|k| k.separation_rate < -APPROACHING * scale)
        })
    }
}

/// What a part must come near.
struct Reach {
    /// Distance by which the boxes of parts are widened, m.
    touch: f64,
    /// The other body when it is a half-space that does not move, in the world.
    floor: Option<Floor>,
}

impl Reach {
    /// The parts of a body whose swept boxes may meet the other body, ascending: those far from it are excluded by the
    /// tree of the parts' boxes. `other` gives the swept box of the other body.
    fn parts_near(
        &self,
        shape: &Shape,
        sweep: &Sweep<'_>,
        other: impl FnOnce() -> Result<Aabb, ImpactError>,
    ) -> Result<Vec<u32>, ImpactError> {
        let Shape::Compound(compound) = shape else { return Ok(vec![0]) };
        let whole = other()?;
        let may_meet = |fixed: &Aabb| {
            let swept = sweep.of_box(*fixed).widened(self.touch);
            self.floor.map_or_else(|| swept.overlaps(&whole), |floor| floor.height(&swept) <= 0.0)
        };
        let mut parts = Vec::new();
        compound.tree.passing(&may_meet, &mut |part| parts.push(part));
        parts.sort_unstable();
        Ok(parts)
    }
}

/// A part of a body; of a mesh, a triangle as a flat polyhedron.
fn part(shape: &Shape, index: u32) -> Option<Cow<'_, Shape>> {
    match shape {
        Shape::TriangleMesh(mesh) => Some(Cow::Owned(Shape::Convex(mesh.flat_polyhedron(index)))),
        other => other.parts().get(index as usize).map(Cow::Borrowed),
    }
}
