//! The page writer: one HTML file, written while the run goes on.
//!
//! The page is self-contained: style, viewer and motion are inside. It holds one or two runs. A run is an
//! [`Observer`]: its frames are packed into chunks ([`chunk`](crate::chunk)), of which one is in memory; quantities
//! over time and events are kept until the end. Layout: the head, the elements of the viewer, the chunks of each run in
//! order, what is shown as JSON, the report as JSON, the viewer.

use crate::camera::{FIELD_OF_VIEW_RAD, MARGIN, PRESETS};
use crate::chunk::{Chunk, ChunkContact, ChunkDetails, NO_ISLAND};
use crate::colors;
use crate::error::ViewError;
use crate::error_steps::ErrorSteps;
use crate::event_list::EventList;
use crate::extent::Extent;
use crate::fixtures::{Fixture, Link};
use crate::framing::{Framing, add_moving, frames_looked_at};
use crate::light::Light;
use crate::mesh_library::MeshLibrary;
use crate::quanta::Quanta;
use crate::scale::AXIS_COLORS;
use crate::series::Series;
use crate::shown_body::JointEnd;
use crate::shown_scene::ShownScene;
use crate::surface_mesh::SurfaceMesh;
use crate::tessellation::Part;
use crate::text;
use crate::thinning::Thinning;
use polhode::scene::{Appearance, Standpoint};
use polhode::spatial::{DVec3, Pose};
use polhode::{BodyError, BodySample, Event, Flow, Frame, MotionKind, Observer, Scene};
use serde_json::{Value, json};
use std::cmp::Ordering;
use std::io::Write;

const STYLE: &str = include_str!("../viewer/viewer.css");
const ELEMENTS: &str = include_str!("../viewer/page.html");
const VIEWER: &str = include_str!("../viewer/dist/viewer.js");

/// The version of what the viewer reads.
pub(crate) const VERSION: u32 = 1;
/// Frames of a run at the most: more frequent samples are thinned out, but for the last one.
pub const MOST_FRAMES: f64 = 10_000.0;

/// Where the frames of a run come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameSource {
    /// A simulation: with contacts, islands and energies.
    Simulation,
    /// A trajectory: poses and velocities alone.
    Trajectory,
}

/// What a page does when it has been opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum AtFirst {
    /// It waits at the start of the run.
    #[default]
    Waits,
    /// It plays the run, again and again, unless its reader prefers that nothing moves by itself.
    Plays,
}

/// A page that is being written.
#[derive(Debug)]
pub struct Page<W> {
    out: W,
    title: String,
    description: String,
    gravity: Value,
    meshes: MeshLibrary,
    runs: Vec<Value>,
    at_first: AtFirst,
    /// What would move first, as HTML.
    mechanism: Option<String>,
}

impl<W: Write> Page<W> {
    /// Writes what stands before the motion; `description` says what to look at, and may be empty.
    ///
    /// # Errors
    /// Those of writing.
    pub fn begin(mut out: W, title: &str, description: &str) -> Result<Self, ViewError> {
        write!(
            out,
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
             <style>\n{STYLE}</style>\n</head>\n<body>\n{ELEMENTS}",
            text::html(title)
        )?;
        let (title, description) = (title.to_owned(), description.to_owned());
        Ok(Self {
            out,
            title,
            description,
            gravity: Value::Null,
            meshes: MeshLibrary::default(),
            runs: Vec::new(),
            at_first: AtFirst::default(),
            mechanism: None,
        })
    }

    /// With what it does when it has been opened.
    pub fn at_first(mut self, at_first: AtFirst) -> Self {
        self.at_first = at_first;
        self
    }

    /// Begins a run of a scene under a name.
    ///
    /// # Errors
    /// When the scene has no bodies.
    pub fn begin_run(mut self, scene: &Scene, name: &str, source: FrameSource) -> Result<PageRun<W>, ViewError> {
        if scene.bodies().is_empty() {
            return Err(ViewError::NoBodies(scene.name().to_owned()));
        }
        let shown = ShownScene::new(scene, &mut self.meshes);
        if self.runs.is_empty() {
            self.gravity = json!(scene.gravity().to_array());
        }
        let quanta = Quanta::for_scene(scene, &shown);
        Ok(PageRun {
            chunk: Chunk::new(shown.moving.len(), quanta),
            page: self,
            name: name.to_owned(),
            source,
            quanta,
            thinning: Thinning::new(scene.duration_s() / MOST_FRAMES),
            looks: Thinning::new(scene.duration_s() / frames_looked_at(shown.moving.len()) as f64),
            reach: Extent::new(),
            shown,
            put_off: None,
            initial: Vec::new(),
            times: Vec::new(),
            chunks: Vec::new(),
            series: Series::default(),
            errors: ErrorSteps::default(),
            events: EventList::default(),
            fault: None,
        })
    }

    /// Writes what stands after the motion, with the report of the run (or `null`); gives back what was written to.
    ///
    /// # Errors
    /// When there is no run, and those of writing.
    pub fn finish(mut self, report: &Value) -> Result<W, ViewError> {
        if self.runs.is_empty() {
            return Err(ViewError::NoFrames);
        }
        let show = json!({
            "version": VERSION,
            "title": self.title,
            "description": self.description,
            "gravity": self.gravity,
            "look": look_json(),
            "plays_at_once": self.at_first == AtFirst::Plays,
            "meshes": self.meshes.meshes().iter().map(mesh_json).collect::<Vec<_>>(),
            "runs": self.runs,
        });
        if let Some(figure) = &self.mechanism {
            writeln!(self.out, "<template id=\"polhode-mechanism\">{figure}</template>")?;
        }
        for (id, value) in [("polhode-show", &show), ("polhode-report", report)] {
            let json = text::json_in_html(&value.to_string());
            writeln!(self.out, "<script id=\"{id}\" type=\"application/json\">{json}</script>")?;
        }
        write!(self.out, "<script>\n{VIEWER}</script>\n</body>\n</html>\n")?;
        self.out.flush()?;
        Ok(self.out)
    }
}

/// A run that is being written into a page.
///
/// The first fault stops the run at the end of its step; [`PageRun::end`] returns it.
#[derive(Debug)]
pub struct PageRun<W> {
    page: Page<W>,
    name: String,
    source: FrameSource,
    shown: ShownScene,
    quanta: Quanta,
    chunk: Chunk,
    thinning: Thinning,
    /// Which frames are looked at to find how far the motion reaches, and how far it does.
    looks: Thinning,
    reach: Extent,
    /// The last sample, when it has not been shown.
    put_off: Option<(f64, Vec<BodySample>, Option<Frame>)>,
    /// Poses of all bodies in the first frame.
    initial: Vec<Pose>,
    times: Vec<f64>,
    chunks: Vec<Value>,
    series: Series,
    errors: ErrorSteps,
    events: EventList,
    fault: Option<ViewError>,
}

impl<W> PageRun<W> {
    /// Whether it is the first run of its page.
    pub fn is_first(&self) -> bool {
        self.page.runs.is_empty()
    }

    /// Shows what of its bodies at rest would move first: a figure as SVG, below a line that says it.
    pub fn show_mechanism(&mut self, caption: &str, figure: &str) {
        self.page.mechanism = Some(format!("<p>{}</p>{figure}", text::html(caption)));
    }
}

impl<W: Write> PageRun<W> {
    /// Shown as the file of the scene wants it.
    #[must_use]
    pub fn shown_as(mut self, appearance: &Appearance) -> Self {
        self.shown.show_as(appearance);
        self
    }

    /// With frames at least this far apart, s.
    pub fn with_least_interval(mut self, interval_s: f64) -> Self {
        self.thinning = Thinning::new(interval_s.max(self.shown.duration_s / MOST_FRAMES));
        self
    }

    /// Ends the run: `completed`, `degraded`, or `failed: ` with the reason.
    ///
    /// # Errors
    /// The first fault: of writing, or a frame that is not one of the scene. A run without a frame is one too.
    pub fn end(mut self, outcome: &str) -> Result<Page<W>, ViewError> {
        if let Some((t, bodies, frame)) = self.put_off.take()
            && self.fault.is_none()
        {
            self.fault = self.add(t, &bodies, frame.as_ref()).err();
        }
        if let Some(fault) = self.fault.take() {
            return Err(fault);
        }
        if self.times.is_empty() {
            return Err(ViewError::NoFrames);
        }
        self.write_chunk()?;
        let duration_s = match self.source {
            FrameSource::Simulation => self.shown.duration_s,
            FrameSource::Trajectory => self.times.last().copied().unwrap_or_default(),
        };
        let mut run = described(&self.shown, self.reach, &self.initial);
        run["name"] = json!(self.name);
        run["outcome"] = json!(outcome);
        run["duration_s"] = json!(duration_s);
        run["frames"] = json!({
            "count": self.times.len(),
            "times": text::base64_f64(&self.times),
            "position_quantum_m": self.quanta.position_m,
            "velocity_quantum_m_s": self.quanta.velocity_m_s,
            "spin_quantum_rad_s": self.quanta.spin_rad_s,
            "moving": self.shown.moving,
            "contacts": self.source == FrameSource::Simulation,
            "chunks": self.chunks,
        });
        run["series"] = self.series.json();
        run["errors"] = self.errors.json();
        run["events"] = json!(self.events.into_events());
        self.page.runs.push(run);
        Ok(self.page)
    }

    /// Shows a sample, or puts it off to be the last.
    fn see(&mut self, t: f64, bodies: &[BodySample], frame: Option<&Frame>) {
        if self.fault.is_some() {
            return;
        }
        if self.thinning.shows(t) {
            self.put_off = None;
            self.fault = self.add(t, bodies, frame).err();
        } else {
            self.put_off = Some((t, bodies.to_vec(), frame.cloned()));
        }
    }

    fn add(&mut self, t: f64, bodies: &[BodySample], frame: Option<&Frame>) -> Result<(), ViewError> {
        let needed = self.shown.bodies.len();
        if bodies.len() < needed {
            return Err(ViewError::BodyCount { found: bodies.len(), needed });
        }
        // Bodies that a program adds while the run goes on stand at the end, and are not shown.
        let bodies = &bodies[..needed];
        let not_finite = |sample: &BodySample| {
            let velocity = sample.velocity;
            !(t.is_finite() && sample.pose.is_finite() && velocity.linear.is_finite() && velocity.angular.is_finite())
        };
        if let Some(body) = bodies.iter().position(not_finite) {
            return Err(ViewError::NotFinite { t_s: t, body: self.shown.bodies[body].name.clone() });
        }
        if self.times.is_empty() {
            self.initial = bodies.iter().map(|sample| sample.pose).collect();
        }
        if self.looks.shows(t) {
            add_moving(&mut self.reach, &self.shown, self.shown.moving.iter().map(|&body| &bodies[body].pose));
        }
        self.times.push(t);
        let details = frame.map(|frame| details(frame, &self.shown.moving, self.quanta));
        if let Some(frame) = frame {
            self.series.add(frame);
        }
        let moving: Vec<&BodySample> = self.shown.moving.iter().map(|&body| &bodies[body]).collect();
        self.chunk.add(moving.into_iter(), details);
        if self.chunk.is_full() { self.write_chunk() } else { Ok(()) }
    }

    fn write_chunk(&mut self) -> Result<(), ViewError> {
        let count = self.chunk.frames();
        if count == 0 {
            return Ok(());
        }
        let packed = text::base64(&self.chunk.take()?);
        let (run, number) = (self.page.runs.len(), self.chunks.len());
        let id = format!("polhode-frames-{run}-{number}");
        writeln!(self.page.out, "<script id=\"{id}\" type=\"application/octet-stream\">{packed}</script>")?;
        self.chunks.push(json!({ "first": self.times.len() - count, "count": count }));
        Ok(())
    }
}

impl<W: Write> Observer for PageRun<W> {
    fn sample(&mut self, t: f64, bodies: &[BodySample]) {
        // What a simulation shows comes with its frame.
        if self.source == FrameSource::Trajectory {
            self.see(t, bodies, None);
        }
    }

    fn event(&mut self, event: &Event) {
        let bodies = &self.shown.bodies;
        self.events
            .add(event, |body| bodies.get(body.index()).map_or_else(|| format!("body {body}"), |b| b.name.clone()));
    }

    fn wants_errors(&self) -> bool {
        true
    }

    fn errors(&mut self, t: f64, errors: Option<&[BodyError]>) {
        self.errors.add(t, errors, &self.shown.moving);
    }

    fn wants_frames(&self) -> bool {
        self.source == FrameSource::Simulation
    }

    fn frame(&mut self, frame: &Frame) {
        self.see(frame.t_s, &frame.bodies, Some(frame));
    }

    fn progress(&mut self, _t: f64) -> Flow {
        if self.fault.is_some() { Flow::Stop } else { Flow::Continue }
    }
}

/// What a chunk holds of a frame besides poses and velocities.
fn details(frame: &Frame, moving: &[usize], quanta: Quanta) -> ChunkDetails {
    let motion = |&body: &usize| match frame.motions.get(body) {
        Some(MotionKind::Flight) => 1,
        Some(MotionKind::Integrated) => 2,
        Some(MotionKind::Rest) => 3,
        _ => 0,
    };
    let mut island_of = vec![NO_ISLAND; frame.bodies.len()];
    for (number, island) in frame.islands.iter().enumerate() {
        let number = u16::try_from(number).unwrap_or(NO_ISLAND);
        for body in &island.bodies {
            if let Some(place) = island_of.get_mut(body.index()) {
                *place = number;
            }
        }
    }
    let contacts = frame.contacts.iter().map(|contact| {
        let bodies = [contact.body_a.index(), contact.body_b.index()];
        let (separation, force) = (contact.separation_m, contact.normal_force_n);
        ChunkContact::new(bodies, contact.point_m, contact.normal, separation, force, quanta)
    });
    let loads = frame.joint_loads.iter();
    let loads = loads.map(|load| ChunkContact::of_joint(load.joint.index(), load.point_m, load.force_n, quanta));
    ChunkDetails {
        motions: moving.iter().map(motion).collect(),
        islands: moving.iter().map(|&body| island_of[body]).collect(),
        contacts: contacts.chain(loads).collect(),
    }
}

/// What is shown of a scene, without its motion: bodies, joints, where they stand at first, and what a camera holds of
/// a motion that reaches so far.
pub(crate) fn described(shown: &ShownScene, reach: Extent, initial: &[Pose]) -> Value {
    json!({
        "bodies": (0..shown.bodies.len()).map(|body| body_json(shown, body)).collect::<Vec<_>>(),
        "joints": shown.joints,
        "fixtures": shown.fixtures.parts.iter().map(fixture_json).collect::<Vec<_>>(),
        "links": shown.fixtures.links.iter().map(link_json).collect::<Vec<_>>(),
        "initial": initial.iter().map(pose_json).collect::<Vec<_>>(),
        "frame": frame_json(&Framing::new(shown, reach, initial).with_start(shown, initial)),
    })
}

/// What page and picture have in common: camera, light and colours.
pub(crate) fn look_json() -> Value {
    let light = Light::default();
    let presets = PRESETS.map(|(name, from)| json!({ "name": name, "from": from.to_array() }));
    json!({
        "field_of_view_rad": FIELD_OF_VIEW_RAD,
        "margin": MARGIN,
        "cameras": presets,
        "light": {
            "towards": light.towards.to_array(),
            "lamp": light.lamp,
            "ambient": light.ambient,
            "sky": light.sky,
        },
        "fixture": colors::hexadecimal(colors::FIXTURE),
        "axes": AXIS_COLORS.map(colors::hexadecimal),
    })
}

/// What the page's camera holds, and from where it looks.
fn frame_json(framing: &Framing) -> Value {
    let points = |extent: &Extent| {
        let mut points: Vec<[f64; 3]> = extent.points().map(|point| point.to_array()).collect();
        points.sort_by(|a, b| {
            a.iter().zip(b).map(|(a, b)| a.total_cmp(b)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
        });
        points.dedup();
        points
    };
    let (from, eye) = match framing.viewpoint.standpoint {
        Some(Standpoint::Eye(eye)) => (Value::Null, json!(eye.to_array())),
        Some(Standpoint::Direction(from)) => (json!(from.to_array()), Value::Null),
        None => (Value::Null, Value::Null),
    };
    json!({
        "from": from,
        "eye": eye,
        "look_at": framing.viewpoint.target.map(|target| target.to_array()),
        "moving": points(&framing.moving),
        "standing": points(&framing.standing),
    })
}

fn pose_json(pose: &Pose) -> Value {
    let (p, [w, x, y, z]) = (pose.translation, pose.rotation.to_wxyz());
    json!([p.x, p.y, p.z, w, x, y, z])
}

pub(crate) fn mesh_json(mesh: &SurfaceMesh) -> Value {
    let numbers = |vectors: &[DVec3]| {
        let flat: Vec<f64> = vectors.iter().flat_map(DVec3::to_array).collect();
        text::base64_f32(flat.into_iter())
    };
    json!({
        "positions": numbers(&mesh.positions),
        "normals": numbers(&mesh.normals),
        "indices": text::base64_u32(mesh.triangles.iter().flatten().copied()),
        "edges": text::base64_u32(mesh.lines.iter().flatten().copied()),
    })
}

fn part_json(part: &Part) -> Value {
    json!({
        "mesh": part.mesh,
        "position": part.position.to_array(),
        "orientation": part.orientation.to_wxyz(),
        "scale": part.scale.to_array(),
    })
}

fn fixture_json(fixture: &Fixture) -> Value {
    json!({ "body": fixture.body, "part": part_json(&fixture.part) })
}

fn link_json(link: &Link) -> Value {
    let ends = link.ends.map(|JointEnd { body, point }| json!({ "body": body, "point": point.to_array() }));
    json!({ "kind": link.kind.name(), "ends": ends, "radius_m": link.radius_m, "length_m": link.length_m })
}

fn body_json(shown: &ShownScene, number: usize) -> Value {
    let body = &shown.bodies[number];
    let parts = body.shape.parts.iter().map(part_json);
    let half_spaces = body.shape.half_spaces.iter();
    json!({
        "name": body.name,
        "colour": colors::hexadecimal(shown.color(number)),
        "label": body.look.label,
        "opacity": body.look.opacity,
        "moves": body.moves,
        "mass_kg": body.mass_kg,
        "center_of_mass": body.center_of_mass.to_array(),
        "principal_inertia_kg_m2": body.principal_moments.map(|moments| moments.to_array()),
        "principal_axes": body.principal_axes,
        "parts": parts.collect::<Vec<_>>(),
        "half_spaces": half_spaces
            .map(|plane| json!({ "normal": plane.normal().to_array(), "offset_m": plane.offset() }))
            .collect::<Vec<_>>(),
        "box": body.bounds.map(|bounds| bounds.map(|corner| corner.to_array())),
    })
}
