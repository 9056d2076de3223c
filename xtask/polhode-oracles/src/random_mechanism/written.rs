//! A random mechanism as a scene file.

use super::model::{Coordinate, Joint, JointKind, Keys, Mechanism, Member, Role, Value};
use super::placement::Placement;
use glam::DVec3;

/// Three numbers with all their digits.
fn vector(v: DVec3) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

fn list<T>(items: impl IntoIterator<Item = T>, text: impl Fn(T) -> String) -> String {
    format!("[{}]", items.into_iter().map(text).collect::<Vec<_>>().join(", "))
}

impl Value {
    fn text(&self) -> String {
        match self {
            Self::Point(v) | Self::Direction(v) => vector(*v),
            Self::Points(points) => list(points, |&p| vector(p)),
            Self::Text(text) => text.clone(),
        }
    }
}

fn table(keys: &Keys, placement: &Placement) -> String {
    let keys: Vec<String> =
        keys.iter().map(|(key, value)| format!("{key} = {}", placement.value(value).text())).collect();
    format!("{{ {} }}", keys.join(", "))
}

impl Mechanism {
    /// The scene file, for a tier and a step (none: as the plan chooses it).
    pub fn written(&self, placement: &Placement, tier: &str, step: Option<f64>) -> String {
        let mut lines = vec![
            "format = 1".to_owned(),
            format!("title = \"Random mechanism {}: {}\"", self.seed, self.kind),
            format!("duration = {:?}", self.duration),
            format!("gravity = {}", vector(placement.direction(self.gravity))),
            String::new(),
            "[method]".to_owned(),
            format!("tier = \"{tier}\""),
        ];
        lines.extend(step.map(|step| format!("step = {step:?}")));
        for (number, material) in self.materials.iter().enumerate() {
            lines.extend([String::new(), format!("[materials.m{number}]"), material.clone()]);
        }
        for (number, track) in self.tracks.iter().enumerate() {
            let curve = table(&track.keys, placement);
            lines.extend([String::new(), "[[tracks]]".to_owned(), format!("name = \"t{number}\"")]);
            lines.push(format!("curve.{} = {curve}", track.kind));
        }
        let mut bodies: Vec<&Member> = self.bodies.iter().collect();
        let mut joints: Vec<&Joint> = self.joints.iter().collect();
        if placement.is_reversed {
            bodies.reverse();
            joints.reverse();
        }
        lines.extend(bodies.iter().flat_map(|body| body.lines(placement)));
        lines.extend(joints.iter().flat_map(|joint| joint.lines(&self.bodies, placement)));
        for gear in &self.gears {
            lines.extend([String::new(), "[[gears]]".to_owned(), gear.clone()]);
        }
        for force in &self.forces {
            let force = format!("type.{} = {}", force.kind, table(&force.keys, placement));
            lines.extend([String::new(), "[[forces]]".to_owned(), force]);
        }
        if self.apart.len() > 1 {
            let names = list(&self.apart, |name| format!("\"{name}\""));
            lines.extend([String::new(), "[[no_contact]]".to_owned(), format!("bodies = {names}")]);
        }
        lines.join("\n") + "\n"
    }
}

impl Member {
    fn lines(&self, placement: &Placement) -> Vec<String> {
        let orientation = (placement.rotation * self.orientation).normalize();
        let [x, y, z, w] = orientation.to_array();
        let mut lines = vec![
            String::new(),
            "[[bodies]]".to_owned(),
            format!("name = \"{}\"", self.name),
            format!("position = {}", vector(placement.point(self.position))),
            format!("orientation = [{w:?}, {x:?}, {y:?}, {z:?}]"),
        ];
        lines.extend(self.shape.as_ref().map(|shape| format!("shape.{shape}")));
        lines.extend(self.material.map(|number| format!("material = \"m{number}\"")));
        match &self.role {
            Role::Fixed => lines.push("fixed = true".to_owned()),
            Role::Moved(motion, keys) => lines.push(format!("motion.{motion} = {}", table(keys, placement))),
            Role::Free(mass, inertia) => {
                lines.push(format!("mass = {mass:?}"));
                lines.extend(inertia.map(|inertia| format!("inertia = {}", vector(inertia))));
                lines.push(format!("velocity = {}", vector(placement.direction(self.velocity))));
                lines.push(format!("angular_velocity = {}", vector(placement.direction(self.angular_velocity))));
            }
        }
        lines.extend(self.more.iter().cloned());
        lines
    }
}

impl Joint {
    fn lines(&self, bodies: &[Member], placement: &Placement) -> Vec<String> {
        let names = list(&self.bodies, |&body| format!("\"{}\"", bodies[body].name));
        let mut keys = vec![format!("bodies = {names}")];
        let anchors = list(&self.anchors, |&anchor| vector(placement.point(anchor)));
        let (anchor, axis) = (
            self.anchors.first().map(|&anchor| vector(placement.point(anchor))).unwrap_or_default(),
            self.axes.first().map(|&axis| vector(placement.direction(axis))).unwrap_or_default(),
        );
        match self.kind {
            JointKind::Rod => keys.push(format!("anchors = {anchors}")),
            JointKind::Rope => keys.extend([format!("anchors = {anchors}"), format!("length = {:?}", self.length)]),
            JointKind::Ball | JointKind::Fixed | JointKind::Track => keys.push(format!("anchor = {anchor}")),
            JointKind::Planar => keys.extend([format!("anchor = {anchor}"), format!("normal = {axis}")]),
            JointKind::Universal => {
                let axes = list(&self.axes, |&axis| vector(placement.direction(axis)));
                keys.extend([format!("anchor = {anchor}"), format!("axes = {axes}")]);
            }
            JointKind::Screw => {
                keys.extend([
                    format!("anchor = {anchor}"),
                    format!("axis = {axis}"),
                    format!("lead = {:?}", self.length),
                ]);
            }
            JointKind::Hinge | JointKind::Slider | JointKind::Cylindrical => {
                keys.extend([format!("anchor = {anchor}"), format!("axis = {axis}")]);
            }
        }
        keys.extend(self.keys.iter().map(|(key, value)| format!("{key} = {}", placement.value(value).text())));
        vec![
            String::new(),
            "[[joints]]".to_owned(),
            format!("name = \"{}\"", self.name),
            format!("type.{} = {{ {} }}", self.kind.key(), keys.join(", ")),
        ]
    }
}

impl JointKind {
    /// Its key in a scene file.
    fn key(self) -> &'static str {
        match self {
            Self::Ball => "ball",
            Self::Hinge => "hinge",
            Self::Universal => "universal",
            Self::Fixed => "fixed",
            Self::Slider => "slider",
            Self::Cylindrical => "cylindrical",
            Self::Screw => "screw",
            Self::Planar => "planar",
            Self::Rod => "rod",
            Self::Rope => "rope",
            Self::Track => "track",
        }
    }

    /// Its coordinates, on which springs, limits, motors and friction act.
    pub(super) fn coordinates(self) -> &'static [Coordinate] {
        match self {
            Self::Hinge | Self::Screw => &[Coordinate::Angle],
            Self::Slider | Self::Track => &[Coordinate::Displacement],
            Self::Cylindrical => &[Coordinate::Angle, Coordinate::Displacement],
            _ => &[],
        }
    }
}
