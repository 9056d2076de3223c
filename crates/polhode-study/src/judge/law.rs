//! The laws, and what is found of each.

/// A law that a trajectory may break.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// The total energy.
    Energy,
    /// The momentum of bodies.
    Momentum,
    /// Bodies do not overlap.
    Penetration,
    /// Bodies do not float.
    Floating,
    /// Coulomb's law.
    Friction,
    /// Signorini's law.
    Contact,
    /// Joints and pivots.
    Joints,
    /// Prescribed motions.
    Motion,
    /// Velocities are the rates of poses.
    Velocities,
    /// The distance from the truth.
    Truth,
}

impl Law {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Energy,
        Self::Momentum,
        Self::Penetration,
        Self::Floating,
        Self::Friction,
        Self::Contact,
        Self::Joints,
        Self::Motion,
        Self::Velocities,
        Self::Truth,
    ];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Momentum => "momentum",
            Self::Penetration => "penetration",
            Self::Floating => "floating",
            Self::Friction => "friction",
            Self::Contact => "contact",
            Self::Joints => "joints",
            Self::Motion => "motion",
            Self::Velocities => "velocities",
            Self::Truth => "truth",
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Energy => "J",
            Self::Momentum | Self::Friction | Self::Contact => "N",
            Self::Penetration | Self::Floating | Self::Joints | Self::Motion | Self::Truth => "m",
            Self::Velocities => "m/s",
        }
    }

    /// What its value is.
    pub const fn value(self) -> &'static str {
        match self {
            Self::Energy => "energy gained (below zero: lost) that nothing in the scene explains",
            Self::Momentum => "force that nothing in the scene gives",
            Self::Penetration => "depth",
            Self::Floating => "height above what should hold it",
            Self::Friction => "force beyond what friction gives",
            Self::Contact => "force of contacts that pull, or of bodies that are apart",
            Self::Joints => "distance from what they keep; of an angle times the size of the body",
            Self::Motion => "distance from where the scene moves it",
            Self::Velocities => "difference from the rates of the poses",
            Self::Truth => "distance from the run of tier accurate; of an angle times the size of the body",
        }
    }
}

/// What is found of a law.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The law.
    pub law: Law,
    /// At how many samples, or in how many intervals between them, it is broken.
    pub broken: usize,
    /// When it is broken first, s.
    pub first_s: Option<f64>,
    /// The worst value, in the unit of the law: the one farthest beyond its limit, or nearest to it.
    pub worst: f64,
    /// What would be allowed there.
    pub limit: f64,
    /// When, s.
    pub at_s: f64,
    /// Which bodies.
    pub bodies: Vec<String>,
    /// What happens there, in words; empty where the law says it.
    pub what: &'static str,
    /// The value over time.
    pub over_time: Vec<[f64; 2]>,
}

/// A value at a time.
#[derive(Debug, Clone)]
pub(super) struct AtTime {
    pub(super) t_s: f64,
    pub(super) value: f64,
    pub(super) limit: f64,
    pub(super) bodies: Vec<String>,
    pub(super) what: &'static str,
}

impl Finding {
    /// Nothing yet.
    pub(super) fn of(law: Law) -> Self {
        let (worst, limit, at_s) = (0.0, f64::INFINITY, 0.0);
        Self { law, broken: 0, first_s: None, worst, limit, at_s, bodies: Vec::new(), what: "", over_time: Vec::new() }
    }

    /// Adds a value.
    pub(super) fn add(&mut self, own: AtTime) {
        match self.over_time.last_mut().filter(|last| last[0].to_bits() == own.t_s.to_bits()) {
            Some(last) if own.value.abs() > last[1].abs() => last[1] = own.value,
            Some(_) => {}
            None => self.over_time.push([own.t_s, own.value]),
        }
        let is_broken = own.value.abs() > own.limit;
        if is_broken {
            self.broken += 1;
            self.first_s.get_or_insert(own.t_s);
        }
        let beyond = |value: f64, limit: f64| value.abs() - limit;
        if self.limit.is_infinite() || beyond(own.value, own.limit) > beyond(self.worst, self.limit) {
            (self.worst, self.limit, self.at_s) = (own.value, own.limit, own.t_s);
            (self.bodies, self.what) = (own.bodies, own.what);
        }
    }

    /// Whether the law is kept.
    pub fn is_kept(&self) -> bool {
        self.broken == 0
    }
}
