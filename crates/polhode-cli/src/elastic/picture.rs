//! The mesh where it is deformed most, with the vertical stress of its elements as colour, as SVG.
//!
//! Displacements are drawn as they are. Blue is pressure, red is tension; the darkest colour is the largest stress of
//! the picture, which is written below it.

use crate::abandoned;
use crate::failure::Failure;
use crate::plots::{cannot_write, is_plot};
use crate::text::number;
use polhode_elastic::{Cells, DVec2, ElasticError, RectangleDrop};
use polhode_scene::AtomicFile;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

/// Width of the picture, pixels.
const WIDTH: f64 = 720.0;

/// Around the rectangle, pixels.
const MARGIN: f64 = 24.0;

/// Below the floor, for the legend, pixels.
const LEGEND: f64 = 44.0;

/// Colours of the greatest pressure, of none, and of the greatest tension.
const COLOURS: [[f64; 3]; 3] = [[33.0, 94.0, 168.0], [247.0, 247.0, 247.0], [178.0, 34.0, 52.0]];

/// Writes the picture of a drop on this mesh.
pub(super) fn write(path: &Path, drop: &RectangleDrop, cells: Cells) -> Result<(), Failure> {
    if !is_plot(path) {
        return Err(Failure::Usage(format!("error: {}: unknown ending; accepted: .svg", path.display())));
    }
    let mut file = AtomicFile::create(path).map_err(|error| cannot_write(path, &error))?;
    abandoned::note(file.left_behind());
    let svg = Scenery::of(drop, cells)?.svg();
    let written = file.write_all(svg.as_bytes()).and_then(|()| file.commit());
    written.map_err(|error| cannot_write(path, &error))
}

/// What is drawn, in the axes of the world.
struct Scenery {
    t_s: f64,
    /// Corners of the elements, m above the floor and along it.
    quads: Vec<[DVec2; 4]>,
    /// Vertical stresses of the elements, Pa.
    stresses: Vec<f64>,
}

impl Scenery {
    fn of(drop: &RectangleDrop, cells: Cells) -> Result<Self, ElasticError> {
        let deepest = drop.run(cells)?.deepest_step;
        let mut run = drop.start(cells)?;
        for _ in 0..deepest {
            run.step()?;
        }
        let [along, up] = drop.world_axes();
        let offset = run.floor().map_or(0.0, |floor| floor.offset);
        let mesh = run.body().mesh();
        let place = |node: usize| {
            let place = mesh.nodes()[node] + run.displacements()[node];
            DVec2::new(along.dot(place), up.dot(place) - offset)
        };
        let quads = (0..mesh.elements()).filter_map(|element| mesh.corners(element)).map(|nodes| nodes.map(place));
        let stresses = run.body().stresses(run.displacements())?;
        Ok(Self {
            t_s: run.time_s(),
            quads: quads.collect(),
            stresses: stresses.iter().map(|stress| up.dot(*stress * up)).collect(),
        })
    }

    fn svg(&self) -> String {
        let corners = || self.quads.iter().flatten();
        let least = corners().fold(DVec2::splat(f64::INFINITY), |least, corner| least.min(*corner));
        let most = corners().fold(DVec2::splat(f64::NEG_INFINITY), |most, corner| most.max(*corner));
        let scale = (WIDTH - 2.0 * MARGIN) / (most.x - least.x);
        let floor_y = MARGIN + most.y * scale;
        let height = floor_y + LEGEND;
        let largest = self.stresses.iter().fold(0.0, |most: f64, stress| most.max(stress.abs()));
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH:.0} {height:.0}\" \
             font-family=\"sans-serif\" font-size=\"13\">\n\
             <style>.ink{{fill:#333}}.line{{stroke:#333}}\
             @media(prefers-color-scheme:dark){{.ink{{fill:#ddd}}.line{{stroke:#ddd}}}}</style>\n\
             <g stroke=\"#555\" stroke-width=\"0.5\" stroke-linejoin=\"round\">\n"
        );
        for (quad, stress) in self.quads.iter().zip(&self.stresses) {
            let point = |corner: &DVec2| {
                format!("{:.1},{:.1}", MARGIN + (corner.x - least.x) * scale, floor_y - corner.y * scale)
            };
            let points = quad.iter().map(point).collect::<Vec<_>>().join(" ");
            let colour = colour(if largest > 0.0 { stress / largest } else { 0.0 });
            let _ = writeln!(svg, "<polygon points=\"{points}\" fill=\"{colour}\"/>");
        }
        let words = format!(
            "vertical stress after {} s: blue is pressure, red is tension, darkest {} Pa",
            number(self.t_s),
            number(largest)
        );
        let _ = write!(
            svg,
            "</g>\n<path class=\"line\" d=\"M0 {floor_y:.1}H{WIDTH:.0}\" stroke-width=\"2\"/>\n\
             <text class=\"ink\" x=\"{MARGIN:.0}\" y=\"{:.1}\">{words}</text>\n</svg>\n",
            floor_y + 0.6 * LEGEND,
        );
        svg
    }
}

/// The colour of a stress in units of the largest.
fn colour(part: f64) -> String {
    let [pressure, none, tension] = COLOURS;
    let (end, amount) = if part < 0.0 { (pressure, -part) } else { (tension, part) };
    let mix = |k: usize| (none[k] + (end[k] - none[k]) * amount.min(1.0)).round();
    format!("#{:02x}{:02x}{:02x}", mix(0) as u8, mix(1) as u8, mix(2) as u8)
}
