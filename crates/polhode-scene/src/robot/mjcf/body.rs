//! The tree of bodies: `<worldbody>`, `<body>` and `<frame>`.

use super::super::element::Element;
use super::super::finding::{RobotDefect, RobotPlace};
use super::super::model::{Geom, Link, RobotCoordinate, RobotJoint, RobotJointKind};
use super::super::reading::Reading;
use super::super::shapes::Meshes;
use super::asset::MeshAsset;
use super::compiler::Compiler;
use super::defaults::Defaults;
use super::geom::{self, BodyGeom, Mask};
use super::joint::{self, BodyJoint};
use super::{frame, inertial};
use crate::files::Files;
use glam::DVec3;
use polhode::spatial::Pose;
use std::collections::BTreeMap;

/// The name of the world.
const WORLD: &str = "world";

/// Elements of a body that are read, and those that are seen or measured.
const KNOWN: [&str; 10] =
    ["inertial", "joint", "freejoint", "geom", "body", "frame", "site", "camera", "light", "user"];

/// Why others have no effect.
const UNKNOWN: &str = "it is not read: write out the bodies that it makes";

/// What is read of a file's bodies.
pub(super) struct Bodies<'a> {
    compiler: &'a Compiler,
    defaults: &'a Defaults,
    assets: &'a BTreeMap<String, MeshAsset>,
    meshes: Meshes,
    links: Vec<Link>,
    joints: Vec<RobotJoint>,
    numbers: BTreeMap<String, usize>,
    /// With what the geometries of each link collide.
    masks: Vec<Vec<(Geom, Mask)>>,
    /// Links and poses of sites by name.
    sites: BTreeMap<String, (usize, Pose)>,
}

/// Where in the tree an element stands.
#[derive(Clone, Copy)]
struct Around<'e> {
    /// The link that it belongs to.
    link: usize,
    /// The frame that it stands in, in that of the link.
    frame: Pose,
    /// The class of what names none.
    class: Option<&'e str>,
    /// Whether the link moves.
    mobility: Mobility,
}

/// Whether a link moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mobility {
    /// It is part of the world.
    Still,
    /// It hangs at a joint, or at a link that does.
    Moves,
}

/// Whether bodies of the file collide with each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Contacts {
    /// They do, by their masks.
    On,
    /// They do not.
    Off,
}

/// Whether a body has a joint.
fn has_joint(element: &Element) -> bool {
    element.children.iter().any(|child| match child.name.as_str() {
        "joint" | "freejoint" => true,
        "frame" => has_joint(child),
        _ => false,
    })
}

/// What the bodies of a file are.
pub(super) struct Parts {
    /// Links; the first is the world.
    pub(super) links: Vec<Link>,
    /// What connects them.
    pub(super) joints: Vec<RobotJoint>,
    /// Pairs of links whose geometries do not collide.
    pub(super) apart: Vec<[usize; 2]>,
}

/// What a body consists of.
#[derive(Default)]
struct Contents {
    geoms: Vec<BodyGeom>,
    joints: Vec<BodyJoint>,
}

impl<'a> Bodies<'a> {
    /// The coordinate of this name.
    pub(super) fn coordinate(&self, name: &str) -> Option<&RobotCoordinate> {
        self.joints.iter().flat_map(|joint| &joint.coordinates).find(|own| own.name == name)
    }

    pub(super) fn new(
        (compiler, defaults): (&'a Compiler, &'a Defaults),
        assets: &'a BTreeMap<String, MeshAsset>,
        files: Files,
        place: &RobotPlace,
    ) -> Self {
        let world = Link {
            name: WORLD.to_owned(),
            place: place.clone(),
            inertial: None,
            collisions: Vec::new(),
            visuals: Vec::new(),
        };
        let numbers = BTreeMap::from([(WORLD.to_owned(), 0)]);
        let (meshes, links, joints, sites) = (Meshes::new(files), vec![world], Vec::new(), BTreeMap::new());
        Self { compiler, defaults, assets, meshes, links, joints, numbers, masks: vec![Vec::new()], sites }
    }

    /// What the joint of this name leaves free.
    pub(super) fn kind_of(&self, name: &str) -> Option<RobotJointKind> {
        self.joints.iter().find(|joint| joint.name == name).map(|joint| joint.kind)
    }

    /// The names of all coordinates.
    pub(super) fn coordinate_names(&self) -> Vec<&str> {
        self.joints.iter().flat_map(|joint| &joint.coordinates).map(|own| own.name.as_str()).collect()
    }

    /// Links and joints, and the pairs of links whose geometries do not collide; with `contacts` off no pair does.
    pub(super) fn into_parts(mut self, contacts: Contacts) -> Parts {
        let meets = |a: Mask, b: Mask| contacts == Contacts::On && a.meets(b);
        let mut apart = Vec::new();
        let mut is_used: Vec<Vec<bool>> = self.masks.iter().map(|own| vec![false; own.len()]).collect();
        for b in 0..self.masks.len() {
            for a in 0..b {
                let mut is_met = false;
                for (i, (_, mask_a)) in self.masks[a].iter().enumerate() {
                    for (j, (_, mask_b)) in self.masks[b].iter().enumerate() {
                        if meets(*mask_a, *mask_b) {
                            (is_met, is_used[a][i], is_used[b][j]) = (true, true, true);
                        }
                    }
                }
                if !is_met && !self.masks[a].is_empty() && !self.masks[b].is_empty() {
                    apart.push([a, b]);
                }
            }
        }
        for ((link, masks), is_used) in self.links.iter_mut().zip(self.masks).zip(is_used) {
            for ((geom, mask), is_used) in masks.into_iter().zip(is_used) {
                // What meets nothing in the file may meet what else is in the scene.
                let collides = is_used || mask.meets(Mask::USUAL);
                if collides { link.collisions.push(geom) } else { link.visuals.push(geom) }
            }
        }
        Parts { links: self.links, joints: self.joints, apart }
    }

    /// The number of the link of a body.
    pub(super) fn link(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).copied()
    }

    /// The link and the pose of a site.
    pub(super) fn site(&self, name: &str) -> Option<(usize, Pose)> {
        self.sites.get(name).copied()
    }

    /// What defaults and the meaning of numbers are.
    pub(super) fn compiler(&self) -> &'a Compiler {
        self.compiler
    }

    /// The world and all bodies in it.
    pub(super) fn world(&mut self, element: &Element, reading: &mut Reading) {
        let class = element.attribute("childclass");
        let mut contents = Contents::default();
        self.contents(
            element,
            Around { link: 0, frame: Pose::IDENTITY, class, mobility: Mobility::Still },
            &mut contents,
            reading,
        );
        for own in contents.geoms {
            self.add_geom(0, own);
        }
        if let Some(joint) = contents.joints.first() {
            let subject = format!("joint `{}`", joint.name);
            reading.refuse(element, subject, RobotDefect::Joints { count: 1, why: "the world does not move" });
        }
    }

    /// What stands in an element: its own geometries and joints, and the bodies in it.
    fn contents(&mut self, element: &Element, around: Around<'_>, own: &mut Contents, reading: &mut Reading) {
        reading.ignore_others(element, &KNOWN, UNKNOWN);
        for child in &element.children {
            match child.name.as_str() {
                "geom" => {
                    let full = self.defaults.applied(child, around.class);
                    let subject = format!("body `{}`", self.links[around.link].name);
                    if let Some(mut geom) = geom::read(&full, (self.compiler, self.assets), &subject, reading) {
                        geom.geom.pose = around.frame * geom.geom.pose;
                        own.geoms.push(geom);
                    }
                }
                "joint" | "freejoint" => {
                    let is_free = child.name == "freejoint";
                    let full = if is_free { child.clone() } else { self.defaults.applied(child, around.class) };
                    let name = format!("{}_joint_{}", self.links[around.link].name, own.joints.len() + 1);
                    let joint = joint::read(&full, self.compiler, name, reading);
                    reading.has_guess |= joint.is_none();
                    own.joints.extend(joint);
                }
                "site" => {
                    let full = self.defaults.applied(child, around.class);
                    let pose = around.frame * frame::pose(&full, self.compiler, "site", reading);
                    if let Some(name) = child.attribute("name") {
                        self.sites.insert(name.to_owned(), (around.link, pose));
                    }
                }
                "frame" => {
                    let pose = around.frame * frame::pose(child, self.compiler, "frame", reading);
                    let class = child.attribute("childclass").or(around.class);
                    self.contents(child, Around { frame: pose, class, ..around }, own, reading);
                }
                "body" => self.body(child, around, reading),
                _ => {}
            }
        }
    }

    /// A body: the links of its joints, and what it consists of.
    fn body(&mut self, element: &Element, around: Around<'_>, reading: &mut Reading) {
        let name = element.attribute("name").map_or_else(|| format!("body_{}", self.links.len()), str::to_owned);
        let subject = format!("body `{name}`");
        let pose = around.frame * frame::pose(element, self.compiler, &subject, reading);
        if element.attribute("gravcomp").is_some_and(|text| text.trim().parse() != Ok(0.0)) {
            reading.ignore(
                element,
                "`gravcomp` of <body>",
                "gravity is not compensated: a force of the scene can do it",
            );
        }
        let class = element.attribute("childclass").or(around.class);
        let link = self.add_link(&name, element, reading);
        let mut own = Contents::default();
        let mobility = if has_joint(element) { Mobility::Moves } else { around.mobility };
        self.contents(element, Around { link, frame: Pose::IDENTITY, class, mobility }, &mut own, reading);
        // The mass of a part of the world has no effect.
        if mobility == Mobility::Moves {
            let parts = (self.compiler, &mut self.meshes);
            self.links[link].inertial = inertial::read(element, &own.geoms, parts, &subject, reading);
        }
        for geom in own.geoms {
            self.add_geom(link, geom);
        }
        self.hang(element, (around.link, link), pose, own.joints);
    }

    fn add_link(&mut self, name: &str, element: &Element, reading: &mut Reading) -> usize {
        if self.numbers.insert(name.to_owned(), self.links.len()).is_some() {
            reading.refuse(element, format!("body `{name}`"), RobotDefect::DuplicateName("body"));
        }
        self.push_link(name.to_owned(), element)
    }

    fn push_link(&mut self, name: String, element: &Element) -> usize {
        let place = element.place.clone();
        self.links.push(Link { name, place, inertial: None, collisions: Vec::new(), visuals: Vec::new() });
        self.masks.push(Vec::new());
        self.links.len() - 1
    }

    fn add_geom(&mut self, link: usize, own: BodyGeom) {
        self.masks[link].push((own.geom, own.mask));
    }

    /// Joints from the parent to the body, with a link without mass between two of them.
    fn hang(&mut self, element: &Element, (parent, child): (usize, usize), pose: Pose, joints: Vec<BodyJoint>) {
        let fixed = || BodyJoint {
            name: format!("{}_fixed", element.attribute("name").unwrap_or(WORLD)),
            kind: RobotJointKind::Fixed,
            anchor: DVec3::ZERO,
            coordinates: Vec::new(),
        };
        let joints = if joints.is_empty() { vec![fixed()] } else { joints };
        let (mut above, mut origin) = (parent, pose);
        let count = joints.len();
        for (number, joint) in joints.into_iter().enumerate() {
            let BodyJoint { name, kind, anchor, coordinates } = joint;
            let is_last = number + 1 == count;
            let below = if is_last { child } else { self.push_link(format!("{name}_link"), element) };
            let place = coordinates.first().map_or(&element.place, |own| &own.place).clone();
            self.joints.push(RobotJoint {
                name,
                place,
                parent: above,
                child: below,
                origin,
                anchor,
                kind,
                coordinates,
            });
            (above, origin) = (below, Pose::IDENTITY);
        }
    }
}
