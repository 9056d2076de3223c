//! The arguments of `polhode drop`, but for the changes to a scene.

use clap::Args;
use polhode_study::Threads;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// What is thrown, on what, how often, and what is told of it.
#[derive(Debug, Args)]
pub(crate) struct ThrowArgs {
    /// What is thrown: a mesh file (.obj, .stl, .off, .ply), a shape (box:0.1,0.2,0.3), or a scene, of which a body is
    /// thrown
    pub(crate) body: PathBuf,
    /// The body of the scene that is thrown, where several move
    #[arg(long = "body", value_name = "NAME")]
    pub(crate) name: Option<String>,
    /// Throws the mesh or shape into a scene, on what it holds [default: on a plane]
    #[arg(long, value_name = "SCENE")]
    pub(crate) on: Option<PathBuf>,
    /// Throws
    #[arg(short = 'n', long = "throws", value_name = "N", default_value_t = 1000)]
    pub(crate) throws: u64,
    /// Seed of the attitudes: that of a throw depends on it and on the number of the throw alone
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Throws at a time; the result is the same for any number [default: as many as the machine has processors]
    #[arg(long, value_name = "N", default_value_t = Threads::of_machine().0, hide_default_value = true)]
    pub(crate) workers: NonZeroUsize,
    /// Clearance of the lowest point above what it falls on, m [default: the size of the body]
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub(crate) height: Option<f64>,
    /// Where the centre of mass begins in a scene, m [default: above its middle; a body of the scene where it is]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(crate) at: Option<String>,
    #[command(flatten)]
    pub(crate) part: PartArgs,
    /// Writes a row for each throw as CSV
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Draws the body on each face on which it came to rest, as PNG
    #[arg(long, value_name = "FOLDER")]
    pub(crate) pictures: Option<PathBuf>,
    /// Prints everything as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// What a mesh or a named shape is made of.
#[derive(Debug, Args)]
pub(crate) struct PartArgs {
    /// Metres in a unit of the mesh file: 0.001 for millimetres [default: 1]
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    pub(crate) scale: Option<f64>,
    /// Density, kg/m^3 [default: 1000]
    #[arg(long, value_name = "D", allow_negative_numbers = true)]
    pub(crate) density: Option<f64>,
    /// Coefficient of friction with what it falls on [default: 0.5]
    #[arg(long, value_name = "MU", allow_negative_numbers = true)]
    pub(crate) friction: Option<f64>,
    /// Coefficient of restitution [default: 0.3]
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub(crate) restitution: Option<f64>,
    /// Young's modulus, Pa, for the time that an impact takes; a plane without one is rigid
    #[arg(long, value_name = "PA", allow_negative_numbers = true)]
    pub(crate) young: Option<f64>,
    /// Poisson's ratio [default: 0.3]
    #[arg(long, value_name = "NU", allow_negative_numbers = true, requires = "young")]
    pub(crate) poisson: Option<f64>,
    /// Radius to which corners and edges are rounded, m: with Young's modulus impacts have a duration, and the greatest
    /// deceleration is told (Hertz)
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub(crate) corner_radius: Option<f64>,
}

impl PartArgs {
    /// The first option that says what a part is made of; the radius of corners is no matter of the part alone.
    pub(crate) fn first_given(&self) -> Option<&'static str> {
        let given = [
            ("--scale", self.scale),
            ("--density", self.density),
            ("--friction", self.friction),
            ("--restitution", self.restitution),
            ("--young", self.young),
            ("--poisson", self.poisson),
        ];
        given.into_iter().find(|(_, value)| value.is_some()).map(|(option, _)| option)
    }
}
