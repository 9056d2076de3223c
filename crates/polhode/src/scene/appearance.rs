//! How a scene is shown: from where, and in which colours. Nothing of it is simulated: a [`Scene`](super::Scene) does
//! not hold it, so that no motion and no hash depends on it.

use crate::identity::body_id::BodyId;
use polhode_spatial::DVec3;
use std::collections::BTreeMap;

/// Where a camera stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Standpoint {
    /// In this direction from what is looked at, so far away that all of it is seen.
    Direction(DVec3),
    /// Here, m.
    Eye(DVec3),
}

impl Standpoint {
    /// Views by name, with the direction from what is looked at to the camera. That from the top leans a little:
    /// straight from above, "up" has no meaning. That from the front leans too, so that the ground is seen.
    pub const NAMED: [(&str, DVec3); 4] = [
        ("front", DVec3::new(0.0, -1.0, 0.12)),
        ("side", DVec3::new(1.0, 0.0, 0.12)),
        ("top", DVec3::new(0.0, -0.001, 1.0)),
        ("iso", DVec3::new(0.85, -1.25, 0.75)),
    ];

    /// The view of this name, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMED.iter().find(|(known, _)| *known == name).map(|(_, from)| Self::Direction(*from))
    }
}

/// Colours by name, sRGB: seven that bodies that move have in turn, told apart by people who see few colours (after
/// Okabe and Ito), and five more; standing bodies are `grey`.
pub const COLORS: [(&str, [u8; 3]); 12] = [
    ("blue", [86, 146, 204]),
    ("orange", [230, 159, 60]),
    ("green", [60, 165, 125]),
    ("vermilion", [214, 105, 60]),
    ("pink", [204, 130, 172]),
    ("yellow", [226, 208, 80]),
    ("violet", [128, 128, 200]),
    ("grey", [176, 178, 182]),
    ("red", [200, 60, 60]),
    ("brown", [150, 110, 80]),
    ("white", [245, 245, 245]),
    ("black", [50, 54, 60]),
];

/// How a body is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyLook {
    /// Red, green and blue (sRGB); without it a colour of the palette.
    pub color: Option<[u8; 3]>,
    /// Words beside it.
    pub label: Option<String>,
    /// How much of it is seen: 1 all, 0 nothing.
    pub opacity: f64,
}

impl Default for BodyLook {
    /// In a colour of the palette, without words.
    fn default() -> Self {
        Self { color: None, label: None, opacity: 1.0 }
    }
}

/// How a scene is shown.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Appearance {
    /// Where the camera stands.
    pub standpoint: Option<Standpoint>,
    /// The place in the middle of the picture, m.
    pub look_at: Option<DVec3>,
    /// Corners of a box that the picture holds, m; without it what is there is held.
    pub frame: Option<[DVec3; 2]>,
    /// Bodies that are shown otherwise than the palette says.
    pub bodies: BTreeMap<BodyId, BodyLook>,
}
