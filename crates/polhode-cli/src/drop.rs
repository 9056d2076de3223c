//! `polhode drop`: on which of its faces a body comes to rest, how often, and how hard it is struck.

use crate::args::{ChangeArgs, DropArgs};
use crate::drop_args::{PartArgs, ThrowArgs};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::progress::Progress;
use crate::scene::{self, SceneText};
use crate::text::drop::page;
use crate::verbosity::{self, Verbosity};
use crate::{inputs, stdout};
use polhode::mesh::{MeshFormat, SolidMesh};
use polhode::spatial::DVec3;
use polhode::{Body, BodySample};
use polhode_scene::{AtomicFile, LoadedScene, load_text, read_mesh};
use polhode_study::drop::{
    DropError, NAMED_SHAPES, Part, PartShape, RestPoses, Setting, Start, THROW_COLUMNS, Throw, Throws, json, throw_line,
};
use polhode_view::Recording;
use polhode_view::raster::PictureSize;
use polhode_view::still::{still, write_png};
use std::io::Write as _;
use std::path::Path;

/// Density of a part when none is given, kg/m^3: that of water.
const DENSITY: f64 = 1000.0;
/// Friction and restitution of a part when none is given: steel on steel, about.
const FRICTION: f64 = 0.5;
const RESTITUTION: f64 = 0.3;
/// Poisson's ratio when only Young's modulus is given: that of most metals.
const POISSON: f64 = 0.3;

/// Throws the body, and tells what became of it; exit code 1 where every throw failed.
pub(crate) fn drop(args: &DropArgs, interrupt: &Interrupt) -> Result<(), Failure> {
    let DropArgs { throw: args, changes } = args;
    if let Some(path) = &args.output {
        inputs::check_output(path, [args.body.as_path()].into_iter().chain(args.on.as_deref()))?;
    }
    let mut progress = Progress::new("reading what is thrown");
    let setting = setting(args, changes)?;
    let throws =
        Throws { count: args.throws, seed: args.seed, workers: args.workers, corner_radius_m: args.part.corner_radius };
    interrupt.wait_for_steps();
    progress.phase("throws", usize::try_from(args.throws).unwrap_or(usize::MAX));
    let mut lines = String::new();
    let is_stopped = || interrupt.has_come();
    let thrown = RestPoses::of(&setting, &throws, &is_stopped, |throw: &Throw| {
        progress.part_done();
        if args.output.is_some() {
            lines.push_str(&throw_line(throw));
            lines.push('\n');
        }
        Ok(())
    });
    let poses = match thrown {
        Err(error @ DropError::Stopped { .. }) => {
            return Err(Failure::Interrupted(error.to_string(), interrupt.code()));
        }
        thrown => thrown?,
    };
    progress.clear();
    if let Some(path) = &args.output {
        written(path, format!("{THROW_COLUMNS}\n{lines}").as_bytes())?;
    }
    if let Some(folder) = &args.pictures {
        pictures(&setting, &poses, folder)?;
    }
    if args.json {
        stdout::json(&json(&setting, &throws, &poses))?;
    } else if verbosity::asked() != Verbosity::Quiet {
        stdout::text(&page(&setting, &throws, &poses))?;
    }
    if poses.failed == poses.throws {
        return Err(Failure::Check("error: every throw failed: the first reason is told".to_owned()));
    }
    Ok(())
}

/// What is thrown, on what.
fn setting(args: &ThrowArgs, changes: &ChangeArgs) -> Result<Setting, Failure> {
    let text = args.body.to_string_lossy();
    let place = args.at.as_deref().map(place).transpose()?;
    let effects = scene::effects(changes);
    let changes = scene::overrides(changes)?;
    let start = |loaded: &LoadedScene| Start {
        height_m: args.height,
        place,
        longest_s: loaded.set_by("duration").map(|_| loaded.scene.duration_s()),
    };
    let named = PartShape::parse(&text);
    if named.is_none() && MeshFormat::of_path(&args.body).is_none() {
        if let Some(option) = args.part.first_given() {
            let what = "is for a mesh or a named shape: a scene has its own, which --set changes";
            return Err(Failure::Usage(format!("error: {option} {what}")));
        }
        if args.on.is_some() {
            let what = "is for a mesh or a named shape: the body of a scene falls on what its scene holds";
            return Err(Failure::Usage(format!("error: --on {what}; named shapes: {NAMED_SHAPES}")));
        }
        let loaded = SceneText::of(&args.body)?.load(&changes)?;
        return Ok(Setting::of_scene(&loaded.scene, args.name.as_deref(), effects, start(&loaded))?);
    }
    if args.name.is_some() {
        return Err(Failure::Usage("error: --body names the body of a scene: a mesh is one body".to_owned()));
    }
    let part = part(args, named)?;
    let origin = text.into_owned();
    let Some(on) = &args.on else {
        let loaded = load_text(&origin, &part.scene(), &changes)?;
        return Ok(Setting::of_scene(&loaded.scene, Some(&part.name), effects, start(&loaded))?);
    };
    let own = load_text(&origin, &part.scene(), &[])?;
    let loaded = SceneText::of(on)?.load(&changes)?;
    let body = own.scene.bodies().iter().find(|body| !body.is_fixed()).cloned();
    let body = body.ok_or_else(|| Failure::Usage(format!("error: {origin}: nothing of it moves")))?;
    let is_taken = loaded.scene.body_id(body.name()).is_some();
    let body: Body = if is_taken { body.renamed(format!("thrown {}", part.name)) } else { body };
    Ok(Setting::onto(&loaded.scene, body, effects, start(&loaded))?)
}

/// The part that is thrown.
fn part(args: &ThrowArgs, named: Option<PartShape>) -> Result<Part, Failure> {
    let PartArgs { scale, density, friction, restitution, young, poisson, corner_radius: _ } = args.part;
    let name = match &named {
        Some(_) => args.body.to_string_lossy().split(':').next().unwrap_or_default().to_owned(),
        None => args.body.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
    };
    if let (Some(_), Some(_)) = (&named, scale) {
        return Err(Failure::Usage("error: --scale is for a mesh file: a named shape is in metres".to_owned()));
    }
    let shape = if let Some(shape) = named {
        shape
    } else {
        let path = &args.body;
        let solid = SolidMesh::new(read_mesh(path)?);
        solid.map_err(|error| Failure::Usage(format!("error: {0}: {error}\n{1}", path.display(), cure(path))))?;
        let unread = |error| Failure::InputOutput(format!("error: cannot read {}: {error}", path.display()));
        PartShape::Mesh { file: std::fs::canonicalize(path).map_err(unread)?, scale: scale.unwrap_or(1.0) }
    };
    // A body may not bear the name of the floor.
    let name = if name == "floor" { "part".to_owned() } else { name };
    Ok(Part {
        name,
        shape,
        density: density.unwrap_or(DENSITY),
        friction: friction.unwrap_or(FRICTION),
        restitution: restitution.unwrap_or(RESTITUTION),
        elastic: young.map(|young| [young, poisson.unwrap_or(POISSON)]),
    })
}

/// What mends a mesh that bounds no solid.
fn cure(path: &Path) -> String {
    format!("help: `polhode mesh {0} --repair -o MENDED.obj` mends what can be mended safely", path.display())
}

/// A place, m.
fn place(text: &str) -> Result<DVec3, Failure> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|own| own.trim().parse().ok()).collect();
    let place = numbers.and_then(|list| <[f64; 3]>::try_from(list).ok()).map(DVec3::from_array);
    place.filter(|place| place.is_finite()).ok_or_else(|| {
        Failure::Usage(format!("error: --at {text}: not of the form X,Y,Z with finite numbers, such as --at 0,0,1"))
    })
}

/// A picture of the body on each face on which it came to rest.
fn pictures(setting: &Setting, poses: &RestPoses, folder: &Path) -> Result<(), Failure> {
    let failed = |error| Failure::InputOutput(format!("error: cannot write {}: {error}", folder.display()));
    std::fs::create_dir_all(folder).map_err(failed)?;
    for number in (0..poses.on.len()).filter(|&number| poses.on[number] > 0) {
        let scene = setting.at_rest(number)?;
        let bodies: Vec<BodySample> = scene
            .bodies()
            .iter()
            .map(|body| BodySample { pose: *body.initial_pose(), velocity: *body.initial_velocity() })
            .collect();
        let path = folder.join(format!("face-{}.png", number + 1));
        let drawn = || {
            let recording = Recording::of_instant(&scene, 0.0, &bodies)?;
            let mut png = Vec::new();
            write_png(&still(&recording, 0, PictureSize::MOVING)?, &mut png)?;
            Ok::<_, polhode_view::ViewError>(png)
        };
        let png = drawn().map_err(|error| Failure::Usage(format!("error: {}: {error}", path.display())))?;
        written(&path, &png)?;
    }
    Ok(())
}

/// Writes a file that appears when it is complete.
fn written(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let write = || {
        let mut file = AtomicFile::create(path)?;
        file.write_all(bytes)?;
        file.commit()
    };
    write().map_err(|error| Failure::InputOutput(format!("error: cannot write {}: {error}", path.display())))
}

impl From<DropError> for Failure {
    fn from(error: DropError) -> Self {
        match error {
            DropError::File(error) => error.into(),
            error => Self::Usage(format!("error: {error}")),
        }
    }
}
