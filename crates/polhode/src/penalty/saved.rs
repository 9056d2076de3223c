//! Springs and what is measured of them as plain data, for snapshots.

use super::contact::{ContactSpring, Grip, Passage, Push};
use super::laws::{Coulomb, Holding, Laws, Resistance};
use crate::identity::body_id::BodyId;
use crate::model::Model;
use crate::report::springs::{SpringImpact, SpringReport};
use crate::scene::PenaltyMethod;
use crate::snapshot::parts::{restored_id, save_contact};
use crate::snapshot::{SnapshotError, springs};
use polhode_response::penalty::{Damping, NormalSpring, TangentialSpring};
use polhode_spatial::DVec3;

pub(super) fn save_laws(laws: &Laws) -> springs::SpringLaws {
    springs::SpringLaws { depth_m: laws.depth_m, speed: laws.speed, blows: laws.blows.clone() }
}

pub(super) fn restored_laws(method: PenaltyMethod, saved: &springs::SpringLaws) -> Laws {
    Laws { method, depth_m: saved.depth_m, speed: saved.speed, blows: saved.blows.clone() }
}

pub(super) fn save_spring(spring: &ContactSpring) -> springs::ContactSpring {
    let (is_plain, damping) = match spring.normal.damping() {
        Damping::Plain(value) => (true, value),
        Damping::HuntCrossley(value) => (false, value),
    };
    springs::ContactSpring {
        id: save_contact(spring.id),
        is_hertz: spring.normal.growth() == polhode_response::penalty::Growth::Hertz,
        stiffness: spring.normal.stiffness(),
        is_plain,
        damping,
        tangential: spring.tangential.coefficient(),
        holding: [spring.holding.damper, spring.holding.weakening, spring.holding.stopped],
        slipped: spring.slipped,
        friction: spring.friction.map(|of| [of.at_rest, of.sliding]),
        resistance: spring.resistance.map(|of| [of.rolling, of.spinning, of.rate]),
        slip_speed: spring.friction.and_then(|of| of.slip_speed),
        restitution: spring.restitution,
        mass: spring.mass,
        push: match spring.push {
            Push::On => springs::Push::On,
            Push::Off => springs::Push::Off,
            Push::Cut => springs::Push::Cut,
        },
        loading: spring.loading,
        grip: match spring.grip {
            Grip::Free => springs::Grip::Free,
            Grip::Stick => springs::Grip::Stick,
            Grip::Yield => springs::Grip::Yield,
            Grip::Slide => springs::Grip::Slide,
            Grip::Cut => springs::Grip::Cut,
            Grip::CutSliding => springs::Grip::CutSliding,
        },
        vector: spring.vector.to_array(),
        passage: [spring.passage.begun_s, spring.passage.approach, spring.passage.deepest, spring.passage.hardest],
        alone: spring.passage.alone,
    }
}

/// A spring from plain data.
///
/// # Errors
/// When it is not of two bodies that can touch, or its stiffness is not positive.
pub(super) fn restored_spring(model: &Model, saved: &springs::ContactSpring) -> Result<ContactSpring, SnapshotError> {
    use polhode_response::penalty::Growth;
    let growth = if saved.is_hertz { Growth::Hertz } else { Growth::Linear };
    let spring = NormalSpring::elastic(growth, saved.stiffness);
    let spring = spring.map_err(|_| SnapshotError::Invalid("the stiffness of a contact is not positive"))?;
    let damping = if saved.is_plain { Damping::Plain(saved.damping) } else { Damping::HuntCrossley(saved.damping) };
    let [begun_s, approach, deepest, hardest] = saved.passage;
    Ok(ContactSpring {
        id: restored_id(model, &saved.id)?,
        normal: spring.with_damping(damping),
        tangential: TangentialSpring::of_coefficient(growth, saved.tangential),
        holding: Holding { damper: saved.holding[0], weakening: saved.holding[1], stopped: saved.holding[2] },
        friction: saved.friction.map(|[at_rest, sliding]| Coulomb { at_rest, sliding, slip_speed: saved.slip_speed }),
        resistance: saved.resistance.map(|[rolling, spinning, rate]| Resistance { rolling, spinning, rate }),
        restitution: saved.restitution,
        mass: saved.mass,
        push: match saved.push {
            springs::Push::On => Push::On,
            springs::Push::Off => Push::Off,
            springs::Push::Cut => Push::Cut,
        },
        loading: saved.loading,
        grip: match saved.grip {
            springs::Grip::Free => Grip::Free,
            springs::Grip::Stick => Grip::Stick,
            springs::Grip::Yield => Grip::Yield,
            springs::Grip::Slide => Grip::Slide,
            springs::Grip::Cut => Grip::Cut,
            springs::Grip::CutSliding => Grip::CutSliding,
        },
        vector: DVec3::from_array(saved.vector),
        slipped: saved.slipped,
        passage: Passage { begun_s, approach, deepest, hardest, alone: saved.alone },
    })
}

pub(super) fn save_report(report: &SpringReport) -> springs::SpringReport {
    springs::SpringReport {
        asked_m: report.penetration_asked_m,
        reached_m: report.penetration_m,
        impacts: report.impacts,
        first: report.first_impacts.iter().map(save_impact).collect(),
        worst: report.worst_restitution.as_ref().map(save_impact),
        fastest: [report.fastest_rad_s, report.frequency_step],
        out_of_reach: report.out_of_reach,
    }
}

pub(super) fn restored_report(saved: &springs::SpringReport) -> SpringReport {
    SpringReport {
        penetration_asked_m: saved.asked_m,
        penetration_m: saved.reached_m,
        impacts: saved.impacts,
        first_impacts: saved.first.iter().map(restored_impact).collect(),
        worst_restitution: saved.worst.as_ref().map(restored_impact),
        fastest_rad_s: saved.fastest[0],
        frequency_step: saved.fastest[1],
        out_of_reach: saved.out_of_reach,
    }
}

fn save_impact(impact: &SpringImpact) -> springs::SpringImpact {
    springs::SpringImpact {
        bodies: impact.bodies.map(BodyId::index),
        is_alone: impact.is_alone,
        numbers: [
            impact.begun_s,
            impact.duration_s,
            impact.approach_m_s,
            impact.separation_m_s,
            impact.penetration_m,
            impact.force_n,
            impact.restitution_asked,
        ],
    }
}

fn restored_impact(saved: &springs::SpringImpact) -> SpringImpact {
    let [begun_s, duration_s, approach_m_s, separation_m_s, penetration_m, force_n, restitution_asked] = saved.numbers;
    SpringImpact {
        begun_s,
        duration_s,
        bodies: saved.bodies.map(BodyId::new),
        approach_m_s,
        separation_m_s,
        penetration_m,
        force_n,
        restitution_asked,
        is_alone: saved.is_alone,
    }
}
