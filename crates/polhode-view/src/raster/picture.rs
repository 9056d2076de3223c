//! Pictures, and how they are made.

use super::depth_buffer::{DepthBuffer, FlatDisc, FlatSegment, FlatTriangle, Seen};
use super::ground::{Block, Ground};
use super::marks::Marks;
use super::paint::{Paint, Paints, SAMPLES};
use super::processors::on_all_processors;
use super::projection::{Projected, Projection};
use super::scene_triangles::SceneTriangles;
use super::shadow_map::ShadowMap;
use crate::camera::Camera;
use crate::colors::{self, Color, Encoding};
use crate::error::ViewError;
use crate::light::Light;
use polhode::spatial::DVec3;

/// Rows of pixels of a band.
const BAND: u32 = 16;
/// Pixels each way of a block, of which it is asked at once what it sees of the ground.
const BLOCK: u32 = 8;
/// Pixels each way at the most.
const MOST_PIXELS: u32 = 8192;
/// Normals of one pixel whose product is at least this, as a fraction of a square, are one.
const SAME: f64 = 0.98;
/// Width of a line, pixels.
const LINE_WIDTH: f64 = 1.1;
/// Width and height of a picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PictureSize {
    width: u32,
    height: u32,
}

impl PictureSize {
    /// Of a still when nothing else is asked for.
    pub const STILL: Self = Self { width: 1280, height: 720 };
    /// Of a moving picture when nothing else is asked for.
    pub const MOVING: Self = Self { width: 640, height: 360 };

    /// Pixels across and down.
    ///
    /// # Errors
    /// When one is zero or above 8192.
    pub fn new(width: u32, height: u32) -> Result<Self, ViewError> {
        let possible = 1..=MOST_PIXELS;
        if possible.contains(&width) && possible.contains(&height) {
            Ok(Self { width, height })
        } else {
            Err(ViewError::PictureSize { width, height, most: MOST_PIXELS })
        }
    }

    /// Pixels across.
    pub fn width(self) -> u32 {
        self.width
    }

    /// Pixels down.
    pub fn height(self) -> u32 {
        self.height
    }

    /// Width over height.
    pub fn aspect(self) -> f64 {
        f64::from(self.width) / f64::from(self.height)
    }
}

/// A picture: red, green and blue (sRGB) of every pixel, row by row from the top left.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Width and height.
    pub size: PictureSize,
    /// Three bytes a pixel.
    pub rgb: Vec<u8>,
}

/// Draws what a camera sees; `bounds` are corners of the box that the camera is about, which gives the ground its
/// scale.
pub fn draw(
    scene: &SceneTriangles,
    marks: &Marks,
    camera: Camera,
    light: &Light,
    bounds: [DVec3; 2],
    size: PictureSize,
) -> Picture {
    let projection = Projection::new(camera, [size.width * SAMPLES, size.height * SAMPLES]);
    let mut flat = Flattened::new(scene, &projection);
    flat.add_marks(marks, &projection);
    let view = View {
        paints: &flat.paints,
        behind: colors::linear(colors::STAGE),
        encoding: Encoding::default(),
        light,
        shadow: ShadowMap::new(scene, light),
        ground: Ground::new(&scene.planes, bounds),
        projection,
    };
    let bands: Vec<[u32; 2]> =
        (0..size.height.div_ceil(BAND)).map(|band| [band * BAND, ((band + 1) * BAND).min(size.height)]).collect();
    let rgb = on_all_processors(&bands, |&rows| band(&flat, &view, size.width, rows)).concat();
    Picture { size, rgb }
}

/// The pixels of a band of rows, three bytes each.
fn band(flat: &Flattened, view: &View<'_>, width: u32, [top, bottom]: [u32; 2]) -> Vec<u8> {
    let rows = [top, bottom].map(|row| (row * SAMPLES) as usize);
    let mut buffer = DepthBuffer::new((width * SAMPLES) as usize, rows);
    flat.draw(&mut buffer, rows);
    let mut rgb = Vec::with_capacity((3 * width * (bottom - top)) as usize);
    let mut blocks = Vec::new();
    for y in top..bottom {
        if (y - top).is_multiple_of(BLOCK) {
            blocks = (0..width).step_by(BLOCK as usize).map(|left| view.block([left, y], BLOCK)).collect();
        }
        for x in 0..width {
            rgb.extend(view.encoding.srgb(view.pixel(&buffer, &blocks[(x / BLOCK) as usize], x, y)));
        }
    }
    rgb
}

/// Triangles, lines and discs in samples, with the rows that they are on.
struct Flattened {
    triangles: Vec<([f64; 2], FlatTriangle)>,
    segments: Vec<([f64; 2], FlatSegment)>,
    discs: Vec<([f64; 2], FlatDisc)>,
    paints: Paints,
}

impl Flattened {
    fn new(scene: &SceneTriangles, projection: &Projection) -> Self {
        let camera = &projection.camera;
        let (triangles, segments, discs) = (Vec::new(), Vec::new(), Vec::new());
        let mut flat = Self { triangles, segments, discs, paints: scene.paints.clone() };
        for triangle in &scene.triangles {
            for corners in projection.cut(triangle.corners.map(|corner| camera.seen(corner))) {
                let normal = |weights: DVec3| {
                    triangle.normals[0] * weights.x + triangle.normals[1] * weights.y + triangle.normals[2] * weights.z
                };
                let normals = corners.map(|(_, weights)| normal(weights));
                let corners = corners.map(|(seen, _)| projection.project(seen));
                let rows = corners.map(|corner| corner.y);
                let rows = [rows[0].min(rows[1]).min(rows[2]), rows[0].max(rows[1]).max(rows[2])];
                flat.triangles.push((rows, FlatTriangle { corners, normals, paint: triangle.paint }));
            }
        }
        for segment in &scene.segments {
            flat.add_segment(segment.ends, segment.paint, projection);
        }
        flat
    }

    fn add_segment(&mut self, ends: [DVec3; 2], paint: u16, projection: &Projection) {
        let Some(ends) = projection.cut_segment(ends.map(|end| projection.camera.seen(end))) else { return };
        let ends = ends.map(|end| projection.project(end));
        let rows = [ends[0].y.min(ends[1].y), ends[0].y.max(ends[1].y)];
        self.segments.push((rows, FlatSegment { ends, paint }));
    }

    fn add_marks(&mut self, marks: &Marks, projection: &Projection) {
        for path in &marks.paths {
            let paint = self.paints.number_of(path.color, 1.0);
            for ends in path.places.windows(2) {
                self.add_segment([ends[0], ends[1]], paint, projection);
            }
        }
        let camera = &projection.camera;
        let focal = camera.focal_length_px(f64::from(projection.samples[1]));
        for disc in &marks.discs {
            let radius = disc.radius_px * f64::from(SAMPLES);
            let seen = camera.seen(disc.place);
            // As near as the front of a ball of that radius, but never behind the camera.
            let nearness = (1.0 + radius / focal) / seen.z;
            let center = Projected { nearness, ..projection.project(seen) };
            let rows = [center.y - radius, center.y + radius];
            let paint = self.paints.number_of(disc.color, 1.0);
            self.discs.push((rows, FlatDisc { center, radius, axes: camera.axes, paint }));
        }
    }

    fn draw(&self, buffer: &mut DepthBuffer, rows: [usize; 2]) {
        let width = LINE_WIDTH * f64::from(SAMPLES);
        let meets = |[low, high]: [f64; 2]| high + width >= rows[0] as f64 && low - width <= rows[1] as f64;
        for (_, triangle) in self.triangles.iter().filter(|(rows, _)| meets(*rows)) {
            if let Some(paint) = self.paints.get(triangle.paint) {
                buffer.draw_triangle(triangle, paint);
            }
        }
        for (_, segment) in self.segments.iter().filter(|(rows, _)| meets(*rows)) {
            if let Some(paint) = self.paints.get(segment.paint) {
                buffer.draw_segment(segment, width, paint);
            }
        }
        self.discs.iter().filter(|(rows, _)| meets(*rows)).for_each(|(_, disc)| buffer.draw_disc(disc));
    }
}

/// What gives samples their colours.
struct View<'a> {
    paints: &'a Paints,
    behind: Color,
    encoding: Encoding,
    light: &'a Light,
    shadow: Option<ShadowMap>,
    ground: Ground,
    projection: Projection,
}

/// What the samples of a pixel have in common: how much of the lamp they see is asked once.
#[derive(Clone, Copy)]
enum Shade {
    /// Each sample asks.
    Asked,
    /// All see so much of the lamp.
    Known(f64),
}

impl View<'_> {
    /// What a block of so many pixels each way, from this corner, sees of the ground.
    fn block(&self, corner: [u32; 2], pixels: u32) -> Block {
        let last = pixels * SAMPLES - 1;
        let [left, top] = corner.map(|at| at * SAMPLES);
        let corners = [(left, top), (left + last, top), (left, top + last), (left + last, top + last)];
        self.ground.block(self.projection.camera.eye, corners.map(|(x, y)| self.projection.ray(x, y)))
    }

    /// The mean of the samples of a pixel.
    fn pixel(&self, buffer: &DepthBuffer, block: &Block, x: u32, y: u32) -> Color {
        let (left, top) = (x * SAMPLES, y * SAMPLES);
        let middle = buffer.at((left + 1) as usize, (top + 1) as usize);
        let all = || (top..top + SAMPLES).flat_map(|v| (left..left + SAMPLES).map(move |u| (u, v)));
        let is_same = |seen: &Seen| {
            seen.paint == middle.paint && seen.normal.dot(middle.normal) >= SAME * middle.normal.length_squared()
        };
        if all().all(|(u, v)| buffer.at(u as usize, v as usize).nearness <= 0.0) {
            // Where a block sees several things, one of its pixels may see one.
            let own = if matches!(block, Block::Mixed) { self.block([x, y], 1) } else { *block };
            if !matches!(own, Block::Mixed) {
                return self.behind_all(&own, self.projection.ray(left + 1, top + 1));
            }
        }
        let shade = if all().all(|(u, v)| is_same(buffer.at(u as usize, v as usize))) {
            let shade = self.shade(middle, left + 1, top + 1);
            // One surface, and nothing before it: one sample stands for all.
            if middle.nearness > 0.0
                && matches!(shade, Shade::Known(_))
                && self.hides_ground(middle, [left + 1, top + 1])
            {
                return self.sample(middle, [left + 1, top + 1], shade);
            }
            shade
        } else {
            Shade::Asked
        };
        let mut sum = [0.0; 3];
        for (u, v) in all() {
            let color = self.sample(buffer.at(u as usize, v as usize), [u, v], shade);
            sum = std::array::from_fn(|i| sum[i] + color[i]);
        }
        sum.map(|channel| channel / f64::from(SAMPLES * SAMPLES))
    }

    /// What is seen through a pixel that no body is in, where its block sees one thing.
    fn behind_all(&self, block: &Block, ray: DVec3) -> Color {
        let Block::Cell(cell) = block else { return self.behind };
        let eye = self.projection.camera.eye;
        let light = self.light.on(cell.normal, self.lit(eye + ray / cell.nearness(eye, ray), cell.normal));
        cell.color.map(|c| c * light)
    }

    /// Whether no ground lies before what is seen at a sample.
    fn hides_ground(&self, seen: &Seen, [x, y]: [u32; 2]) -> bool {
        let ground = self.ground.seen(self.projection.camera.eye, self.projection.ray(x, y));
        ground.is_none_or(|ground| ground.nearness <= seen.nearness)
    }

    /// How much of the lamp a sample sees.
    fn shade(&self, seen: &Seen, x: u32, y: u32) -> Shade {
        let (eye, ray) = (self.projection.camera.eye, self.projection.ray(x, y));
        match self.ground.seen(eye, ray).filter(|ground| ground.nearness > seen.nearness) {
            // Where the ground fades, two surfaces are seen.
            Some(ground) if ground.strength >= 1.0 => Shade::Known(self.lit(ground.place, ground.normal)),
            Some(_) => Shade::Asked,
            None => match seen.normal.try_normalize() {
                Some(normal) if seen.nearness > 0.0 => {
                    Shade::Known(self.lit(eye + ray / seen.nearness, facing(normal, ray)))
                }
                _ => Shade::Asked,
            },
        }
    }

    fn sample(&self, seen: &Seen, [x, y]: [u32; 2], shade: Shade) -> Color {
        let camera = &self.projection.camera;
        let ray = self.projection.ray(x, y);
        let ground = self.ground.seen(camera.eye, ray).filter(|ground| ground.nearness > seen.nearness);
        let lit = |place: DVec3, normal: DVec3| match shade {
            Shade::Known(lit) => lit,
            Shade::Asked => self.lit(place, normal),
        };
        let surface = || {
            let Some(Paint { color, .. }) = self.paints.get(seen.paint) else { return self.behind };
            let Some(normal) = seen.normal.try_normalize() else { return *color };
            // Of a surface with two sides the one that is seen.
            let normal = facing(normal, ray);
            let light = self.light.on(normal, lit(camera.eye + ray / seen.nearness, normal));
            color.map(|c| c * light)
        };
        let Some(ground) = ground else { return surface() };
        let light = self.light.on(ground.normal, lit(ground.place, ground.normal));
        mix(surface(), ground.color.map(|c| c * light), ground.strength)
    }

    fn lit(&self, place: DVec3, normal: DVec3) -> f64 {
        self.shadow.as_ref().map_or(1.0, |shadow| shadow.lit(place, normal))
    }
}

/// A normal on the side that is seen.
fn facing(normal: DVec3, ray: DVec3) -> DVec3 {
    if normal.dot(ray) > 0.0 { -normal } else { normal }
}

/// From `a` (at 0) to `b` (at 1).
fn mix(a: Color, b: Color, at: f64) -> Color {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * at)
}
