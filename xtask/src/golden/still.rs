//! Golden stills: a small picture of a shipped scene at a stated time, compared pixel by pixel.
//!
//! The rasteriser draws the same pixels on every platform, so that nothing may differ. A picture that is meant to be
//! another one is renewed by `cargo xtask verify --bless --only still`, to be looked at before it is committed.

use polhode::Simulation;
use polhode_cases::row::Row;
use polhode_cases::snapshot_environment::is_blessed;
use polhode_cases::{CaseResult, Context, guarded};
use polhode_view::Recording;
use polhode_view::raster::{Picture, PictureSize};
use polhode_view::still::{still, write_png};
use std::error::Error;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Where the pictures are.
const FOLDER: &str = "fixtures/pictures/stills";
/// Width and height, pixels.
const SIZE: [u32; 2] = [320, 200];

/// A scene and a time.
#[derive(Debug)]
pub(crate) struct GoldenStill {
    scene: &'static str,
    t_s: f64,
}

/// Shapes of every kind, shadows, a pile that falls, free bodies, point sets, a body without a shape, and an orbit in
/// which the body is a millionth of the picture.
pub(crate) const STILLS: &[GoldenStill] = &[
    GoldenStill { scene: "toppling-shapes", t_s: 0.75 },
    GoldenStill { scene: "diamond-5", t_s: 0.9 },
    GoldenStill { scene: "dzhanibekov", t_s: 3.0 },
    GoldenStill { scene: "thrown-l-shape", t_s: 0.4 },
    GoldenStill { scene: "newtons-cradle", t_s: 0.3 },
    GoldenStill { scene: "stick", t_s: 0.2 },
    GoldenStill { scene: "gyroscope-wheel", t_s: 0.5 },
    GoldenStill { scene: "heavy-top", t_s: 0.5 },
    GoldenStill { scene: "overhang-stack", t_s: 0.0 },
    GoldenStill { scene: "spring-pair", t_s: 0.5 },
    GoldenStill { scene: "kepler-orbit", t_s: 6000.0 },
];

impl GoldenStill {
    /// Name of the case.
    pub(crate) fn case_name(&self) -> String {
        format!("golden still {}", self.scene)
    }

    /// Draws it and compares it with the committed one; under `--bless` that is written anew where it is another.
    pub(crate) fn check(&self, context: &Context) -> Vec<Row> {
        let case = self.case_name();
        guarded(&case, || self.compare(context, &case))
    }

    fn compare(&self, context: &Context, case: &str) -> CaseResult {
        let drawn = self.draw(context)?;
        let path = context.root.join(FOLDER).join(self.scene).with_extension("png");
        let committed = if path.exists() { Some(read(&path)?) } else { None };
        let differing = committed.as_ref().map(|pixels| differing_pixels(pixels, &drawn.rgb));
        let quantity = format!("t = {} s, {} x {}: pixels that differ", self.t_s, SIZE[0], SIZE[1]);
        Ok(vec![match differing {
            Some(count) if count == 0 || !is_blessed() => Row::exact(case, &quantity, 0_u64, count),
            None if !is_blessed() => {
                Row::broken(case, &quantity, "no picture: run cargo xtask verify --bless and look")
            }
            differing => {
                write_png(&drawn, File::create(&path)?)?;
                let words =
                    differing.map_or("written for the first time".to_owned(), |count| format!("{count}, renewed"));
                Row::info(case, &quantity, 0_u64, words)
            }
        }])
    }

    fn draw(&self, context: &Context) -> Result<Picture, Box<dyn Error>> {
        let loaded = polhode_scene::load_with(&context.shipped.path(self.scene), &[])?;
        let scene = &loaded.scene;
        let mut recording = Recording::for_still(scene)?.shown_as(loaded.appearance());
        let mut simulation = Simulation::new(scene)?;
        simulation.advance_to_observed(self.t_s, &mut recording)?;
        recording.end_at(self.t_s, &simulation.bodies())?;
        let last = recording.times().len().saturating_sub(1);
        Ok(still(&recording, last, PictureSize::new(SIZE[0], SIZE[1])?)?)
    }
}

/// The pixels of a PNG file.
fn read(path: &Path) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let size = reader.output_buffer_size().ok_or("a picture that is too large")?;
    let mut pixels = vec![0; size];
    reader.next_frame(&mut pixels)?;
    Ok(pixels)
}

/// How many pixels of two pictures differ; all, where their sizes do.
fn differing_pixels(a: &[u8], b: &[u8]) -> u64 {
    if a.len() != b.len() {
        return (a.len().max(b.len()) / 3) as u64;
    }
    a.chunks_exact(3).zip(b.chunks_exact(3)).filter(|(a, b)| a != b).count() as u64
}
