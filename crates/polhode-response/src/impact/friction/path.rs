//! The path of an impact: velocity and impulse as the normal impulse grows (Routh 1905; Keller 1986).
//!
//! A contact slips until its slip vanishes, then sticks, or slips in the one direction that leads away from there,
//! until compression and restitution are over. Where the direction of slip stays, the path is a closed form
//! ([`Straight`]); where it turns, Taylor series ([`Turning`]).
//!
//! Assumptions: the time of the impact is so short that nothing moves but the velocities; one coefficient of friction,
//! for sticking and slipping. The path always ends: a jam ends in zero slip, from where the normal velocity rises.

use super::coulomb::{Coulomb, ZeroSlip};
use super::phase::{ImpactPhase, PhaseKind};
use super::plane::{self, Tangent};
use super::restitution::{Added, Happening, Restitution, Stage};
use super::straight::Straight;
use super::turning::{Turning, value};

/// Pieces after which a path is given up; paths have some dozen.
const PIECES: usize = 10_000;

/// A speed of slip below this fraction of the velocity before has vanished for every digit of the outcome (no unit):
/// what is left of the path to zero slip is a straight piece.
const VANISHING: f64 = 1e-20;

/// A speed of slip below this fraction of the velocity before is zero (no unit): its square would underflow.
const ZERO: f64 = 1e-140;

/// What rounding leaves of the normal velocity of a contact that nothing moves, relative to the velocity before (no
/// unit).
const WEDGED: f64 = 1e-9;

/// How a path ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PathEnd {
    /// Compression and restitution are over.
    Complete,
    /// It sticks, and no impulse within the cone moves it.
    Wedged,
    /// It sticks, still approaches, and no impulse within the cone moves it: the velocity before is none that the
    /// bodies can have.
    Inconsistent,
    /// Too many pieces: the outcome is not to be trusted.
    Unfinished,
}

/// How the contact moves.
#[derive(Debug, Clone, Copy)]
enum Contact {
    Slips,
    /// Slips away from zero slip, in a direction that stays.
    SlipsAgain {
        direction: Tangent,
        kind: PhaseKind,
    },
    Sticks,
}

/// Velocity, impulse and works along a path. Velocities before are of size 1.
#[derive(Debug, Clone)]
pub(super) struct Path {
    pub(super) normal_velocity: f64,
    pub(super) slip: Tangent,
    pub(super) normal_impulse: f64,
    pub(super) tangential_impulse: Tangent,
    pub(super) normal_work: f64,
    pub(super) friction_work: f64,
    /// Normal impulse at the end of the compression.
    pub(super) compression: f64,
    pub(super) phases: Vec<ImpactPhase>,
    pub(super) end: PathEnd,
    contact: Contact,
    stage: Stage,
}

impl Path {
    /// Follows the path from the velocity before to its end.
    pub(super) fn follow(coulomb: &Coulomb, before: [f64; 3], restitution: &Restitution) -> Self {
        let slip = [before[1], before[2]];
        let mut path = Self {
            normal_velocity: before[0],
            slip,
            normal_impulse: 0.0,
            tangential_impulse: [0.0, 0.0],
            normal_work: 0.0,
            friction_work: 0.0,
            compression: 0.0,
            phases: Vec::new(),
            end: PathEnd::Unfinished,
            contact: Contact::Slips,
            stage: Stage::Compression,
        };
        if plane::length(slip) <= ZERO {
            path.stop_slip(coulomb);
        }
        for _ in 0..PIECES {
            let happening = path.piece(coulomb);
            match happening {
                Happening::PieceEnds => {}
                Happening::SlipStops => path.stop_slip(coulomb),
                Happening::CompressionBegins => {
                    path.normal_velocity = 0.0;
                    path.stage = Stage::Compression;
                }
                Happening::CompressionEnds => {
                    path.normal_velocity = 0.0;
                    path.compression = path.normal_impulse;
                    match restitution.after_compression(path.normal_impulse, path.normal_work) {
                        Some(stage) => path.stage = stage,
                        None => path.end = PathEnd::Complete,
                    }
                }
                Happening::ImpactEnds => path.end = PathEnd::Complete,
                Happening::Wedged => path.wedge(),
            }
            if path.end != PathEnd::Unfinished {
                break;
            }
        }
        path
    }

    /// The slip is zero: decides how it goes on.
    fn stop_slip(&mut self, coulomb: &Coulomb) {
        self.slip = [0.0, 0.0];
        self.contact = match coulomb.leaving_zero_slip() {
            ZeroSlip::Sticks { .. } => Contact::Sticks,
            ZeroSlip::Slips(direction) => {
                // From a start without slip there is nothing to reverse.
                let kind = if self.normal_impulse > 0.0 { PhaseKind::Reversal } else { PhaseKind::Slip };
                Contact::SlipsAgain { direction, kind }
            }
        };
    }

    /// Nothing moves the contact any more: its velocity is zero, unless the matrix does not fit the velocity before.
    fn wedge(&mut self) {
        if self.normal_velocity.abs() <= WEDGED {
            self.normal_velocity = 0.0;
            self.end = PathEnd::Wedged;
        } else {
            self.end = PathEnd::Inconsistent;
        }
    }

    /// One piece of the path; returns what happens at its end.
    fn piece(&mut self, coulomb: &Coulomb) -> Happening {
        let speed = plane::length(self.slip);
        let slipping = |d: Tangent| Straight {
            ratio: plane::scaled(d, -coulomb.friction),
            working_friction: coulomb.friction,
            normal_velocity: self.normal_velocity,
            normal_rate: coulomb.normal_rate(d),
            speed,
            speed_rate: coulomb.speed_rate(d),
        };
        match self.contact {
            Contact::Sticks => {
                let ZeroSlip::Sticks { ratio, normal_rate } = coulomb.leaving_zero_slip() else {
                    return Happening::Wedged;
                };
                if normal_rate == 0.0 {
                    return Happening::Wedged;
                }
                let stick = Straight {
                    ratio,
                    working_friction: 0.0,
                    normal_velocity: self.normal_velocity,
                    normal_rate,
                    speed: 0.0,
                    speed_rate: 0.0,
                };
                self.take_straight(&stick, [0.0, 0.0], PhaseKind::Stick)
            }
            Contact::SlipsAgain { direction, kind } => self.take_straight(&slipping(direction), direction, kind),
            Contact::Slips => {
                let direction = plane::direction(self.slip).unwrap_or([1.0, 0.0]);
                let piece = slipping(direction);
                let kind = if piece.normal_rate < 0.0 { PhaseKind::Jam } else { PhaseKind::Slip };
                if coulomb.turning(direction) == 0.0 || (speed <= VANISHING && piece.speed_rate < 0.0) {
                    self.take_straight(&piece, direction, kind)
                } else {
                    self.take_turning(&Turning::new(coulomb, direction, speed, self.normal_velocity), kind)
                }
            }
        }
    }

    /// Goes to the end of a straight piece, unless it has none.
    fn take_straight(&mut self, piece: &Straight, direction: Tangent, kind: PhaseKind) -> Happening {
        let (x, happening) = piece.first(self.stage);
        if happening == Happening::Wedged {
            return happening;
        }
        self.normal_velocity += piece.normal_rate * x;
        let speed = if happening == Happening::SlipStops { 0.0 } else { piece.speed + piece.speed_rate * x };
        self.slip = plane::scaled(direction, speed);
        self.tangential_impulse = plane::sum(self.tangential_impulse, plane::scaled(piece.ratio, x));
        self.friction_work += piece.friction_work(x);
        self.add(Added { impulse: x, work: piece.normal_work(x) }, kind);
        happening
    }

    /// Goes to the end of a piece with a direction that turns.
    fn take_turning(&mut self, piece: &Turning, kind: PhaseKind) -> Happening {
        let (at, happening) = piece.first(self.stage);
        self.normal_velocity = value(&piece.normal_velocity, at);
        let (direction, speed) = piece.slip(at);
        self.slip = plane::scaled(direction, speed);
        let tangential = [&piece.tangential_impulse[0], &piece.tangential_impulse[1]].map(|series| value(series, at));
        self.tangential_impulse = plane::sum(self.tangential_impulse, tangential);
        self.friction_work += value(&piece.friction_work, at);
        self.add(Added { impulse: value(&piece.normal_impulse, at), work: value(&piece.normal_work, at) }, kind);
        happening
    }

    fn add(&mut self, added: Added, kind: PhaseKind) {
        self.normal_impulse += added.impulse;
        self.normal_work += added.work;
        self.stage = self.stage.after(added);
        match self.phases.last_mut().filter(|last| last.kind == kind) {
            Some(last) => {
                last.normal_impulse += added.impulse;
                last.slip_after = self.slip;
            }
            None => {
                self.phases.push(ImpactPhase { kind, normal_impulse: added.impulse, slip_after: self.slip });
            }
        }
    }
}
