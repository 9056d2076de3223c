//! Conversion of a run to plain data and back.
//!
//! The data hold the states at the starts of the steps, how each body moves, the islands with the lengths of their
//! steps, the contacts, and the pairs that may meet. Steps with contact forces are repeated from their starts and have
//! the same bits; the agenda is computed from the islands and pairs.

use super::agenda::{Agenda, Due};
use super::contact_change::ContactChange;
use super::contacts::Contacts;
use super::crowd_step::Crowd;
use super::engine::Engine;
use super::free_stepping::FreeStep;
use super::island::{Island, Step};
use super::motions::{Mode, Motions, Track};
use super::near_pairs::NearPairs;
use super::schedule::Schedule;
use crate::collision::active_contacts::ActiveContacts;
use crate::collision::contact_modes::ContactModes;
use crate::collision::friction_mode::{FrictionMode, Slide};
use crate::collision::touch::{Hold, Touch};
use crate::collision::turn::{RotationModes, Turn};
use crate::error::SimulationError;
use crate::identity::contact_id::ContactId;
use crate::model::{Model, prescribed};
use crate::snapshot::numbers::{self, Contact, read_kinematics, read_states, write_kinematics};
use crate::snapshot::parts::{restored_flight, restored_id, save_contact, save_flight};
use crate::snapshot::{SnapshotError, content};
use crate::tier::core::Core;
use polhode_dynamics::Flight;
use polhode_spatial::DVec3;
use std::collections::{BTreeMap, BTreeSet};

impl Engine {
    /// The run as plain data.
    pub(super) fn saved(&self) -> content::Accurate {
        let touch = |touch: &Touch| content::Touch {
            id: save_contact(touch.id),
            kinematics: write_kinematics(&touch.kinematics),
            held: touch.hold == Hold::Held,
            known: touch.known,
            friction: touch.modes.friction.map(save_friction),
            rotation: save_rotation(&touch.modes.rotation),
        };
        content::Accurate {
            states: numbers::write_states(&self.motions.states),
            tracks: self.motions.tracks.iter().map(save_track).collect(),
            islands: self.motions.islands.values().map(save_island).collect(),
            contacts: self.schedule.contacts.all().map(touch).collect(),
            near: self.schedule.near.save(),
            spins: self.motions.spins.iter().map(|(&body, spin)| (body, save_flight(spin))).collect(),
            begun: self.begun,
            goes_on: self.goes_on,
            observed_s: self.motions.observed_s,
        }
    }

    /// The run from such data. `core` already has the time and the accounts of the snapshot.
    ///
    /// # Errors
    /// When the data are not of this scene or contradict themselves.
    pub(crate) fn restored(core: &mut Core, saved: &content::Accurate) -> Result<Self, SimulationError> {
        let model = &core.model;
        let states = read_states(&saved.states, model.bodies.len())?;
        let mut engine = Self {
            motions: Motions {
                tracks: restored_tracks(model, &saved.tracks)?,
                spins: restored_spins(model, &saved.spins)?,
                observed_s: saved.observed_s,
                ..Motions::new(core, states)
            },
            schedule: Schedule {
                contacts: restored_contacts(model, &saved.contacts)?,
                near: NearPairs::restored(core, &saved.near)?,
                agenda: Agenda::default(),
            },
            begun: saved.begun,
            goes_on: saved.goes_on,
            interrupted: None,
        };
        for island in &saved.islands {
            let island = engine.motions.restored_island(core, island)?;
            engine.motions.insert_island(island);
        }
        engine.rebuild_agenda(core);
        // A run that had ended goes on to a longer duration: the islands that begin no step at its end begin one. Those
        // that wait for time steps on the way are unsolved.
        let waits_for_end = |island: &Island| matches!(island.step, Step::Waiting(_)) && !island.is_unsolved;
        if core.t < core.model.scene.duration_s()
            && !engine.goes_on
            && engine.motions.islands.values().any(waits_for_end)
        {
            engine.continue_after_end_of_run(core)?;
            engine.goes_on = false;
        }
        Ok(engine)
    }

    /// Fills the agenda from the islands, the pairs and the prescribed motions. Before the first instant has been
    /// resolved it is empty.
    fn rebuild_agenda(&mut self, core: &Core) {
        if self.begun {
            for &body in &core.model.prescribed {
                // A corner at the time of the snapshot may be due still. One that has been passed changes nothing.
                self.schedule.expect_corner(core, body, core.t.next_down());
            }
        }
        for (&first, island) in &self.motions.islands {
            self.schedule.agenda.add(island.due, Due::Island(first));
        }
        for (t, (a, b)) in self.schedule.near.impacts() {
            self.schedule.agenda.add(t, Due::Impact(a, b));
        }
        self.schedule.agenda.add(self.schedule.near.flight_end, Due::FlightBoxes);
    }
}

impl Motions {
    fn restored_island(&mut self, core: &mut Core, saved: &content::Island) -> Result<Island, SimulationError> {
        self.check_island(&core.model, &saved.bodies)?;
        let (bodies, t) = (saved.bodies.clone(), saved.t);
        let active = restored_active(&core.model, saved)?;
        let change = restored_change(&core.model, saved)?;
        let step = match &saved.step {
            content::Step::Waiting(t) => Step::Waiting(*t),
            content::Step::Crowd(end, pairs) => {
                // A joint with the world has its contacts between its body and itself.
                let is_at_joint = |pair: (usize, usize)| !core.model.joints.joint_contacts_of_pair(pair).is_empty();
                let can_touch = |&(a, b): &(usize, usize)| (a < b || is_at_joint((a, b))) && b < self.states.len();
                if !(pairs.iter().all(can_touch) && t < *end && end.is_finite()) {
                    return Err(SnapshotError::Invalid(
                        "a time step of crowded events has pairs or times that no run has",
                    )
                    .into());
                }
                Step::Crowd(Box::new(self.repeated_crowd_step(core, &bodies, pairs.clone(), (t, *end))?))
            }
            content::Step::Free(step) => Step::Free(Box::new(FreeStep::restored(core, &bodies, t, step)?)),
            content::Step::Constrained(h) => {
                let step = self.repeated_step(core, &bodies, &active, (t, *h));
                let step = step.ok_or(SnapshotError::Invalid("a step cannot be repeated from its start"))?;
                Step::Constrained(Box::new(step))
            }
        };
        Ok(Island {
            bodies,
            active,
            t,
            step,
            due: saved.due,
            changes: saved.changes,
            is_unsolved: saved.is_unsolved,
            change,
        })
    }

    /// Checks that bodies can form an island: forces move them, and none is in an island already restored.
    fn check_island(&self, model: &Model, bodies: &[usize]) -> Result<(), SnapshotError> {
        let moves = |body: usize| {
            let track = self.tracks.get(body);
            let moves =
                track.is_some_and(|track| matches!(track.mode, Mode::Constrained | Mode::Stepped | Mode::Crowded(_)));
            moves && model.bodies[body].moves() && self.islands.values().all(|island| !island.bodies.contains(&body))
        };
        let is_island =
            !bodies.is_empty() && bodies.is_sorted_by(|x, y| x < y) && bodies.iter().all(|&body| moves(body));
        if is_island {
            Ok(())
        } else {
            Err(SnapshotError::Invalid("an island has no bodies, or not only bodies that forces move"))
        }
    }
}

fn restored_ids(model: &Model, saved: &[Contact]) -> Result<Vec<ContactId>, SnapshotError> {
    let ids = saved.iter().map(|id| restored_id(model, id)).collect::<Result<Vec<_>, _>>()?;
    if ids.is_sorted_by(|x, y| x < y) { Ok(ids) } else { Err(SnapshotError::Invalid("contacts are not in order")) }
}

fn restored_contacts(model: &Model, saved: &[content::Touch]) -> Result<Contacts, SnapshotError> {
    let touch = |touch: &content::Touch| {
        let hold = if touch.held { Hold::Held } else { Hold::Open };
        let (id, kinematics) = (restored_id(model, &touch.id)?, read_kinematics(touch.kinematics));
        let friction = touch.friction.map(restored_friction);
        let modes = ContactModes { friction, rotation: restored_rotation(touch.rotation) };
        Ok(Touch { id, kinematics, hold, known: touch.known, is_defined: true, modes })
    };
    let touches = saved.iter().map(touch).collect::<Result<Vec<_>, SnapshotError>>()?;
    if !touches.is_sorted_by(|x, y| x.id < y.id) {
        return Err(SnapshotError::Invalid("contacts are not in order"));
    }
    let mut contacts = Contacts::new(model.bodies.len());
    for of_pair in touches.chunk_by(|x, y| (x.id.a, x.id.b) == (y.id.a, y.id.b)) {
        contacts.set((of_pair[0].id.a, of_pair[0].id.b), of_pair.to_vec());
    }
    Ok(contacts)
}

/// The active contacts of an island.
fn restored_active(model: &Model, saved: &content::Island) -> Result<ActiveContacts, SnapshotError> {
    let held = restored_ids(model, &saved.held)?;
    let friction = saved.friction.iter().map(|(id, mode)| Ok((restored_id(model, id)?, restored_friction(*mode))));
    let friction = friction.collect::<Result<BTreeMap<_, _>, SnapshotError>>()?;
    let rotation = saved.rotation.iter().map(|(id, modes)| Ok((restored_id(model, id)?, restored_rotation(*modes))));
    let rotation = rotation.collect::<Result<BTreeMap<_, _>, SnapshotError>>()?;
    let modes = |id: &ContactId| ContactModes {
        friction: friction.get(id).copied(),
        rotation: rotation.get(id).copied().unwrap_or_default(),
    };
    Ok(ActiveContacts::new(held.into_iter().map(|id| (id, modes(&id)))))
}

/// What changes at the end of an island's step.
fn restored_change(model: &Model, saved: &content::Island) -> Result<ContactChange, SnapshotError> {
    let slipping = saved.slipping.iter().map(|(id, to)| Ok((restored_id(model, id)?, DVec3::from_array(*to))));
    let settling = saved.settling.iter().map(|(id, spins)| Ok((restored_id(model, id)?, restored_turn(*spins))));
    let turning = saved
        .turning
        .iter()
        .map(|(id, spins, to)| Ok(((restored_id(model, id)?, restored_turn(*spins)), DVec3::from_array(*to))));
    Ok(ContactChange {
        t: saved.due,
        breaking: saved.breaking.iter().copied().collect(),
        departing: restored_ids(model, &saved.departing)?.into_iter().collect(),
        stopping: restored_ids(model, &saved.stopping)?.into_iter().collect(),
        fading: restored_ids(model, &saved.fading)?.into_iter().collect(),
        slipping: slipping.collect::<Result<_, SnapshotError>>()?,
        settling: settling.collect::<Result<_, SnapshotError>>()?,
        turning: turning.collect::<Result<_, SnapshotError>>()?,
        running_off: saved.running_off.iter().copied().collect(),
    })
}

fn save_friction(mode: FrictionMode) -> content::Friction {
    match mode {
        FrictionMode::Sticking => content::Friction::Sticking,
        FrictionMode::Sliding(Slide { direction, speed, noise }) => {
            content::Friction::Sliding { direction: direction.to_array(), speed, noise }
        }
    }
}

fn restored_friction(saved: content::Friction) -> FrictionMode {
    match saved {
        content::Friction::Sticking => FrictionMode::Sticking,
        content::Friction::Sliding { direction, speed, noise } => {
            FrictionMode::Sliding(Slide { direction: DVec3::from_array(direction), speed, noise })
        }
    }
}

fn save_rotation(modes: &RotationModes) -> [Option<content::Friction>; 2] {
    Turn::ALL.map(|turn| modes.get(turn).map(save_friction))
}

fn restored_rotation([rolling, spinning]: [Option<content::Friction>; 2]) -> RotationModes {
    RotationModes::of(|turn| match turn {
        Turn::Rolling => rolling.map(restored_friction),
        Turn::Spinning => spinning.map(restored_friction),
    })
}

/// A kind of rotation, of which a snapshot holds whether it is spinning.
const fn restored_turn(spins: bool) -> Turn {
    if spins { Turn::Spinning } else { Turn::Rolling }
}

fn save_island(island: &Island) -> content::Island {
    let ids = |ids: &BTreeSet<ContactId>| ids.iter().copied().map(save_contact).collect();
    let modes = || island.active.with_modes();
    content::Island {
        bodies: island.bodies.clone(),
        held: island.active.held().iter().copied().map(save_contact).collect(),
        t: island.t,
        step: match &island.step {
            Step::Constrained(step) => content::Step::Constrained(step.h),
            Step::Free(step) => content::Step::Free(step.save()),
            Step::Crowd(step) => content::Step::Crowd(step.end, step.pairs.clone()),
            Step::Waiting(t) => content::Step::Waiting(*t),
        },
        due: island.due,
        changes: island.changes,
        is_unsolved: island.is_unsolved,
        departing: ids(&island.change.departing),
        friction: modes().filter_map(|(id, own)| Some((save_contact(id), save_friction(own.friction?)))).collect(),
        stopping: ids(&island.change.stopping),
        fading: ids(&island.change.fading),
        slipping: island.change.slipping.iter().map(|(&id, to)| (save_contact(id), to.to_array())).collect(),
        rotation: modes()
            .filter(|(_, own)| !own.rotation.is_empty())
            .map(|(id, own)| (save_contact(id), save_rotation(&own.rotation)))
            .collect(),
        breaking: island.change.breaking.iter().copied().collect(),
        settling: island.change.settling.iter().map(|&(id, turn)| (save_contact(id), turn == Turn::Spinning)).collect(),
        running_off: island.change.running_off.iter().copied().collect(),
        turning: island
            .change
            .turning
            .iter()
            .map(|(&(id, turn), to)| (save_contact(id), turn == Turn::Spinning, to.to_array()))
            .collect(),
    }
}

fn restored_spins(model: &Model, saved: &[(usize, content::Flight)]) -> Result<BTreeMap<usize, Flight>, SnapshotError> {
    let spin = |(body, spin): &(usize, content::Flight)| {
        let rigid = model.bodies.get(*body).and_then(|body| body.rigid.as_ref());
        let rigid = rigid.ok_or(SnapshotError::Invalid("a free rotation is of a body that no force can move"))?;
        Ok((*body, restored_flight(rigid, spin)?))
    };
    saved.iter().map(spin).collect()
}

fn save_track(track: &Track) -> content::Track {
    let Track {
        // The island of a body is known from the list of islands.
        island: _,
        mode,
        pace,
        proposed_step_s,
        speed_scale,
        rest_booked_s,
        last_stretch_s,
        gave_up_splitting,
    } = track;
    content::Track {
        mode: match mode {
            Mode::Fixed => content::Mode::Fixed,
            Mode::Prescribed => content::Mode::Prescribed,
            Mode::Flight(flight) => content::Mode::Flight(save_flight(flight)),
            Mode::Constrained => content::Mode::Constrained,
            Mode::Stepped => content::Mode::Stepped,
            Mode::Crowded(crowd) => {
                let Crowd { until, step_s, number, spare_error } = *crowd;
                content::Mode::Crowded { until, step_s, number, spare_error }
            }
            Mode::Rest => content::Mode::Rest,
        },
        pace: *pace,
        proposed_step_s: *proposed_step_s,
        speed_scale: *speed_scale,
        rest_booked_s: *rest_booked_s,
        last_stretch_s: *last_stretch_s,
        gave_up_splitting: *gave_up_splitting,
    }
}

fn restored_tracks(model: &Model, saved: &[content::Track]) -> Result<Vec<Track>, SnapshotError> {
    if saved.len() != model.bodies.len() {
        return Err(SnapshotError::Invalid("it does not say how each body moves"));
    }
    let track = |(body, track): (usize, &content::Track)| {
        let mode = match (&track.mode, &model.bodies[body].rigid) {
            (content::Mode::Fixed, _)
                if !model.bodies[body].moves() && prescribed::trajectory(model, body).is_none() =>
            {
                Mode::Fixed
            }
            (content::Mode::Prescribed, None) if prescribed::trajectory(model, body).is_some() => Mode::Prescribed,
            (content::Mode::Flight(flight), Some(rigid)) => Mode::Flight(Box::new(restored_flight(rigid, flight)?)),
            (content::Mode::Constrained, Some(_)) => Mode::Constrained,
            (content::Mode::Stepped, Some(_)) => Mode::Stepped,
            (&content::Mode::Crowded { until, step_s, number, spare_error }, Some(_)) => {
                Mode::Crowded(Crowd { until, step_s, number, spare_error })
            }
            (content::Mode::Rest, Some(_)) => Mode::Rest,
            _ => return Err(SnapshotError::Invalid("the way a body moves is not one that its scene allows")),
        };
        Ok(Track {
            mode,
            island: None,
            pace: track.pace,
            proposed_step_s: track.proposed_step_s,
            speed_scale: track.speed_scale,
            rest_booked_s: track.rest_booked_s,
            last_stretch_s: track.last_stretch_s,
            gave_up_splitting: track.gave_up_splitting,
        })
    };
    saved.iter().enumerate().map(track).collect()
}
