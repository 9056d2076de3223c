//! The scenes of a census: shipped ones, heaps, random mechanisms and random scenes of contacts.

use super::options::Options;
use crate::verify::workspace_root;
use polhode_oracles::random_mechanism::generate as mechanisms;
use polhode_oracles::random_mechanism::placement::Placement;
use polhode_oracles::random_scene::generate as contacts;
use polhode_scene::Override;
use std::error::Error;
use std::path::PathBuf;

/// Steps of tiers of fixed steps in heaps, s, and how long heaps fall, s.
const HEAP_HEAD: &str = "format = 1\nduration = 1.0\n[method]\ntier = \"stepped\"\nstep = 0.01\n";

/// A scene.
#[derive(Debug)]
pub(super) struct Subject {
    pub(super) name: String,
    pub(super) from: Source,
    /// Whether the tiers asked for run it beside its own.
    is_for_all_tiers: bool,
}

/// Where a scene comes from.
#[derive(Debug)]
pub(super) enum Source {
    File(PathBuf),
    Text(String),
    Mechanism(u64),
    Contacts(u64),
}

/// A scene file with its meshes.
#[derive(Debug)]
pub(super) struct Text {
    pub(super) toml: String,
    pub(super) meshes: Vec<(String, String)>,
}

impl Subject {
    /// The tiers that run it: none stands for its own.
    pub(super) fn tiers<'a>(&self, asked: &'a [String]) -> Vec<Option<&'a str>> {
        let others = asked.iter().map(|tier| Some(tier.as_str()));
        match self.from {
            // A mechanism has none of its own.
            Source::Mechanism(_) => others.collect(),
            _ if self.is_for_all_tiers => std::iter::once(None).chain(others).collect(),
            _ => vec![None],
        }
    }

    /// The scene for a tier.
    pub(super) fn text(&self, tier: Option<&str>) -> Result<Text, Box<dyn Error>> {
        let plain = |toml| Text { toml, meshes: Vec::new() };
        Ok(match &self.from {
            Source::File(path) => plain(std::fs::read_to_string(path)?),
            Source::Text(text) => plain(text.clone()),
            Source::Mechanism(seed) => {
                let scene = mechanisms::scene(*seed);
                let tier = tier.unwrap_or("accurate");
                let step = (tier != "accurate").then_some(scene.step);
                plain(scene.written(&Placement::AS_IS, tier, step))
            }
            Source::Contacts(seed) => {
                let written = contacts::scene(*seed).written("random");
                Text { toml: written.text, meshes: written.meshes }
            }
        })
    }

    /// What is set for a tier.
    pub(super) fn overrides(&self, tier: Option<&str>) -> Vec<Override> {
        let is_written = matches!(self.from, Source::Mechanism(_));
        let tier = tier.filter(|_| !is_written);
        tier.map(|tier| Override::new("the census", "method.tier", format!("\"{tier}\""))).into_iter().collect()
    }
}

/// All that are asked for.
pub(super) fn all(options: &Options) -> Result<Vec<Subject>, Box<dyn Error>> {
    let mut subjects = shipped(options.scenes)?;
    if options.scenes.is_none() {
        subjects.extend(heaps());
    }
    for number in 0..options.random {
        let seed = options.first + number / 2;
        let (name, from) = if number % 2 == 0 {
            (format!("mechanism {seed}"), Source::Mechanism(seed))
        } else {
            (format!("contacts {seed}"), Source::Contacts(seed))
        };
        subjects.push(Subject { name, from, is_for_all_tiers: true });
    }
    if let Some(pattern) = &options.only {
        subjects.retain(|subject| subject.name.contains(pattern.as_str()));
    }
    Ok(subjects)
}

fn shipped(most: Option<usize>) -> Result<Vec<Subject>, Box<dyn Error>> {
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(workspace_root()?.join("fixtures/scenes"))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "toml") {
            paths.push(path);
        }
    }
    paths.sort();
    paths.truncate(most.unwrap_or(usize::MAX));
    let name = |path: &PathBuf| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    Ok(paths
        .into_iter()
        .map(|path| Subject { name: name(&path), from: Source::File(path), is_for_all_tiers: true })
        .collect())
}

/// Balls and boxes that fall into a bin, a heavy box on light ones, and a pyramid that is struck.
fn heaps() -> Vec<Subject> {
    let heap = |name: String, text: String| Subject { name, from: Source::Text(text), is_for_all_tiers: false };
    let mut heaps = Vec::new();
    for friction in [0.0, 0.3] {
        for (count, half) in [(30, 1.0), (60, 1.5), (125, 2.0), (343, 2.5)] {
            let side = 2.0 * half - 0.4;
            let falling = |shape: &str, height: f64| {
                format!(
                    "layout.drop = {{ count = {count}, size = [{side:?}, {side:?}, {height:?}], seed = 3 }}\n{shape}\n"
                )
            };
            let balls = bin(half, friction, &falling("shape.sphere.radius = 0.3", 12.0));
            heaps.push(heap(format!("{count} balls of friction {friction}"), balls));
            if count <= 125 {
                let boxes = bin(half, friction, &falling("shape.box.size = [0.6, 0.5, 0.4]", 16.0));
                heaps.push(heap(format!("{count} boxes of friction {friction}"), boxes));
            }
        }
    }
    let floor = |friction: f64| {
        format!(
            "{HEAP_HEAD}[materials.rough]\nfriction = {friction:?}\n[[bodies]]\nname = \"floor\"\nfixed = true\n\
             material = \"rough\"\nshape.half_space.normal = [0, 0, 1]\n"
        )
    };
    let boxes = "shape.box.size = [1, 1, 1]\nmass = 1.0\nmaterial = \"rough\"\n";
    for friction in [0.0, 0.5] {
        let head = floor(friction);
        let heavy = format!(
            "{head}[[arrays]]\nname = \"light\"\nlayout.grid = {{ counts = [3, 3, 1], spacing = [1.2, 1.2, 1.0] }}\n\
             position = [-1.2, -1.2, 0.5]\n{boxes}[[bodies]]\nname = \"heavy\"\nposition = [0.0, 0.0, 1.5]\n\
             velocity = [0.5, 0.1, 0.0]\nshape.box.size = [4, 4, 1]\nmass = 1e6\nmaterial = \"rough\"\n"
        );
        heaps.push(heap(format!("heavy box on light ones of friction {friction}"), heavy));
        let pyramid = format!(
            "{head}[[arrays]]\nname = \"stone\"\nlayout.pyramid = {{ base = 8, spacing = [1.1, 1.0] }}\n\
             position = [0.0, 0.0, 0.5]\n{boxes}[[bodies]]\nname = \"ball\"\nposition = [3.85, 0.0, 9.0]\n\
             velocity = [1.0, 0.2, -3.0]\nshape.sphere.radius = 0.5\nmass = 2.0\nmaterial = \"rough\"\n"
        );
        heaps.push(heap(format!("pyramid that is struck of friction {friction}"), pyramid));
    }
    heaps
}

fn bin(half: f64, friction: f64, falling: &str) -> String {
    let wall = |(name, normal): (&str, [f64; 3])| {
        let [x, y, z] = normal;
        format!(
            "[[bodies]]\nname = \"{name}\"\nfixed = true\nmaterial = \"rough\"\nposition = [{:?}, {:?}, 0.0]\n\
             shape.half_space.normal = [{x:?}, {y:?}, {z:?}]\n",
            -half * x,
            -half * y
        )
    };
    let walls = [
        ("floor", [0.0, 0.0, 1.0]),
        ("west", [1.0, 0.0, 0.0]),
        ("east", [-1.0, 0.0, 0.0]),
        ("south", [0.0, 1.0, 0.0]),
        ("north", [0.0, -1.0, 0.0]),
    ];
    let walls = walls.map(wall).concat();
    let corner = 0.2 - half;
    format!(
        "{HEAP_HEAD}[materials.rough]\nfriction = {friction:?}\n{walls}[[arrays]]\nname = \"fallen\"\n{falling}\
         position = [{corner:?}, {corner:?}, 0.3]\nmass = 1.0\nmaterial = \"rough\"\n"
    )
}
