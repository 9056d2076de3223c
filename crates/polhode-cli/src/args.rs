//! The command line.

use crate::drop_args::ThrowArgs;
use crate::help;
use crate::mesh_args::MeshArgs;
use clap::{Args, Parser, Subcommand, ValueEnum};
use polhode::ErrorEstimation;
use polhode_study::Threads;
use polhode_study::judge::TOLERANCE;
use polhode_study::stands::MOST_DIGITS;
use polhode_study::sweep::Sensitivities;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Simulates rigid bodies with contacts, friction and joints, and says how far each result is right.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, about, after_help = EXIT_CODES)]
pub(crate) struct Cli {
    /// Says nothing but errors: no progress, no notes, and no report of a run (--json prints it all the same)
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub(crate) quiet: bool,
    /// Says on stderr what is being done
    #[arg(short, long, global = true)]
    pub(crate) verbose: bool,
    #[command(subcommand)]
    pub(crate) command: Command,
}

/// Most samples that errors are taken from: they stay in memory, those of several runs at a time.
const MOST_SAMPLES: i64 = 1_000_000;

const EXIT_CODES: &str = "Exit codes: 0 fine; 1 a check failed, or the run diverged or is degraded (has not kept what \
     its method promises); 2 usage or a bad scene; 3 input or output; 130 Ctrl-C; 143 SIGTERM.";

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Plays a pile that stands beside one that falls, and says what to do next
    #[command(after_help = help::DEMO)]
    Demo(DemoArgs),
    /// Simulates a scene, and says whether the run is right and what happened
    #[command(after_help = help::RUN)]
    Run(RunArgs),
    /// Continues a run from a checkpoint, to the same bits as if it had never stopped
    #[command(after_help = help::RESUME)]
    Resume(ResumeArgs),
    /// Says which effects of a scene are on or off, why, and what that saves
    #[command(after_help = help::PLAN)]
    Plan(PlanArgs),
    /// Shows what accuracy costs: error against time over methods and steps
    #[command(after_help = help::COST)]
    Cost(CostArgs),
    /// Runs a scene many times with other values, and measures each run
    #[command(after_help = help::SWEEP)]
    Sweep(SweepArgs),
    /// Says whether bodies stand, how firmly, what moves first, and what each contact carries
    #[command(after_help = help::STANDS)]
    Stands(StandsArgs),
    /// Throws a body from random attitudes: on which faces it comes to rest, how often, how hard it is struck
    #[command(after_help = help::DROP)]
    Drop(DropArgs),
    /// Judges a trajectory of any engine by the laws of a scene; exit code 1 where it breaks one
    #[command(after_help = help::JUDGE)]
    Judge(JudgeArgs),
    /// Validates a scene
    #[command(after_help = help::CHECK)]
    Check(CheckArgs),
    /// Diagnoses a mesh and computes its mass properties
    #[command(after_help = help::MESH)]
    Mesh(MeshArgs),
    /// Drops an elastic rectangle by finite elements, and rigid laws beside it (thesis, Figure 2)
    #[command(after_help = help::ELASTIC)]
    Elastic(ElasticArgs),
    /// Prints the JSON Schema of the scene format
    #[command(after_help = help::SCHEMA)]
    Schema,
    /// Compares two CSV trajectories number by number; exit code 1 when they differ beyond the tolerance
    #[command(after_help = help::COMPARE)]
    Compare(CompareArgs),
    /// Shows a scene or a trajectory: an HTML page that plays it, a picture, a moving picture or a model
    #[command(after_help = help::VIEW)]
    View(ViewArgs),
    /// Writes a page that runs a scene itself: edit it, pull at its bodies, see what a fast method loses
    #[command(after_help = help::PLAY)]
    Play(PlayArgs),
    /// Writes a commented scene to begin with
    #[command(after_help = help::NEW)]
    New(NewArgs),
    /// Lists the shipped examples: `example:NAME` stands for a scene file
    #[command(after_help = help::SCENES)]
    Scenes,
    /// Prints a script that completes commands and options in a shell
    #[command(after_help = help::COMPLETIONS)]
    Completions(CompletionsArgs),
    /// Prepares a scene and runs it, printing nothing: what `cost --instructions` counts
    #[command(hide = true)]
    Probe(ProbeArgs),
}

/// A scene and changes to it.
#[derive(Debug, Args)]
pub(crate) struct SceneArgs {
    /// Scene file (TOML), robot file (.urdf, .xml, .mjcf) or table of boxes (.csv); `-` reads a scene from stdin,
    /// `example:NAME` is a shipped one (`polhode scenes` lists them)
    pub(crate) scene: PathBuf,
    #[command(flatten)]
    pub(crate) changes: ChangeArgs,
}

/// Changes to a scene, and which of its effects are simulated.
#[derive(Debug, Args)]
pub(crate) struct ChangeArgs {
    /// Sets any key of the scene by its dotted path; bodies go by name or number (bodies.brick.mass=2)
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    /// Tier of methods: accurate, stepped, fast, penalty, micro-collisions or thesis (method.tier)
    #[arg(long, value_name = "TIER", allow_hyphen_values = true)]
    pub(crate) tier: Option<String>,
    /// Step, s (method.step)
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) step: Option<String>,
    /// Simulated time, s (duration)
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) duration: Option<String>,
    /// Effects that are simulated
    #[arg(long, value_enum, default_value_t = EffectsArg::Planned)]
    pub(crate) effects: EffectsArg,
}

/// Effects that are simulated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum EffectsArg {
    /// Those that the plan finds the scene to call for
    Planned,
    /// All of them: the reference for what the plan leaves out
    All,
}

/// Arguments of `run`.
#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    #[command(flatten)]
    pub(crate) output: RunOutputArgs,
    /// Runs by the cheapest method whose error stays below this, as `polhode cost` finds it; exit
    /// code 1 where it does not
    #[arg(long, value_name = "ERROR", allow_negative_numbers = true)]
    pub(crate) accuracy: Option<f64>,
    /// Repeats the run by another method, and says how far the bodies of both are apart; exit
    /// code 1 where that is more than the method of the run promises
    ///
    /// A run of tier accurate is repeated in the scene turned, mirrored and with its bodies in the opposite order, by
    /// another integrator; one of tier penalty likewise, with the same springs; any other by tier accurate. Whole runs
    /// are repeated, however long that takes.
    #[arg(long)]
    pub(crate) second_opinion: bool,
    #[command(flatten)]
    pub(crate) checkpoints: CheckpointArgs,
}

/// What a run writes.
#[derive(Debug, Args)]
pub(crate) struct RunOutputArgs {
    /// Writes the trajectory (.csv, .npy, .json), a page that plays it (.html), a model (.glb), a moving picture (.gif,
    /// .apng, .webp), a picture of the end (.png) or plots over time (.svg); `-` writes CSV to stdout, and the report
    /// goes to stderr; `resume`: from the checkpoint on (may be given several times)
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,
    /// What is plotted over time, into the .svg files of -o: energy, ledger, penetration, contacts, steps,
    /// joint-coordinates, joint-rates, joint-forces, joint-moments, joint-powers, or any quantity of a body, a joint or
    /// contacts by name (torque:crank, bodies.box.position[2], normal_force:box/floor) [default with -o FILE.svg: all
    /// but those of joints]
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) plot: Vec<String>,
    /// Plots the quantities of --plot against this one instead of time, as angle:crank
    #[arg(long, value_name = "QUANTITY", requires = "plot")]
    pub(crate) against: Option<String>,
    /// Writes the events as CSV (`resume`: from the checkpoint on)
    #[arg(long, value_name = "FILE")]
    pub(crate) events: Option<PathBuf>,
    /// Writes coordinates, loads and powers of the joints at every sample as CSV, and what acts along each coordinate
    /// by its cause: drive, gear, spring, damper, dry friction, limit, and the reaction (`resume`: from the checkpoint
    /// on)
    #[arg(long, value_name = "FILE")]
    pub(crate) joints: Option<PathBuf>,
    /// Writes points, normals and forces of the contacts at every sample as CSV, and which forces are not unique
    /// (`resume`: from the checkpoint on)
    #[arg(long, value_name = "FILE")]
    pub(crate) contacts: Option<PathBuf>,
    /// Prints the report of the whole run as JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// Prints the whole report: what it was compared with, certificate, ledgers, plan and effects too (--json has all
    /// of it anyway)
    #[arg(long)]
    pub(crate) full: bool,
    /// How the error of the run is estimated: by runs beside it, which are to take three tenths of its time at most
    /// (quick) or three times as much (full); off leaves the columns of errors out of trajectories [default: what the
    /// scene says, or quick; `resume`: as before]
    #[arg(long, value_name = "EFFORT", value_enum)]
    pub(crate) error: Option<ErrorArg>,
    /// Threads that compute the islands of a step (tiers stepped and fast); the bits are the same for any number
    #[arg(long, value_name = "N", default_value_t = NonZeroUsize::MIN)]
    pub(crate) threads: NonZeroUsize,
}

/// Arguments of `play`.
#[derive(Debug, Args)]
pub(crate) struct PlayArgs {
    /// Scene file (TOML) to begin with; `-` reads it from stdin, `example:NAME` is a shipped one. Without it the page
    /// begins with what was typed in it before, or a small scene
    #[arg(required_unless_present = "output")]
    pub(crate) scene: Option<PathBuf>,
    /// Writes the page to this file (.html): one file with the engine in it, which needs no server
    #[arg(short, long, value_name = "FILE", required_unless_present = "hash")]
    pub(crate) output: Option<PathBuf>,
    /// Opens the page in the browser
    #[arg(long, requires = "output")]
    pub(crate) open: bool,
    /// Prints the strict hash of the scene's run, to compare with that of the page
    #[arg(long, requires = "scene")]
    pub(crate) hash: bool,
}

/// Arguments of `stands`.
#[derive(Debug, Args)]
pub(crate) struct StandsArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Says what each contact carries
    #[arg(long)]
    pub(crate) contacts: bool,
    /// Draws the motion that begins, now or at the least push, with its hinges, as SVG
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,
    /// Finds up to which value of a key the scene stands, between a value with which it does and one with which it does
    /// not
    #[arg(long, value_name = "KEY=LOW..HIGH", allow_hyphen_values = true, conflicts_with_all = ["contacts", "picture"])]
    pub(crate) bisect: Option<String>,
    /// Digits of that value
    #[arg(long, value_name = "N", default_value_t = 6, requires = "bisect")]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_DIGITS)))]
    pub(crate) digits: u32,
    /// Prints everything as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `drop`.
#[derive(Debug, Args)]
pub(crate) struct DropArgs {
    #[command(flatten)]
    pub(crate) throw: ThrowArgs,
    #[command(flatten)]
    pub(crate) changes: ChangeArgs,
}

/// Arguments of `judge`.
#[derive(Debug, Args)]
pub(crate) struct JudgeArgs {
    /// A trajectory of all bodies of the scene (.csv, .npy, .json, as `polhode run -o` writes them); columns of
    /// velocities may be left out
    pub(crate) trajectory: PathBuf,
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// What counts as nothing, of sizes, speeds and energies
    #[arg(long, value_name = "PART", default_value_t = TOLERANCE, allow_negative_numbers = true)]
    pub(crate) tolerance: f64,
    /// Leaves out the distance from a run of tier accurate, which takes its time
    #[arg(long)]
    pub(crate) no_truth: bool,
    /// Draws what is found over time (.svg)
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Prints everything as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `sweep`.
#[derive(Debug, Args)]
pub(crate) struct SweepArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Varies a key of the scene: values (0.1,0.2), a range with their number (0.1..0.8:8), or what is drawn from
    /// (0.1..0.8, normal(0.4, 0.1), lognormal(0.4, 0.1), uniform(0.1, 0.8), choice(newton, poisson)); several keys give
    /// all combinations. Without it the [[uncertain]] values of the scene are drawn
    #[arg(long, value_name = "KEY=VALUES", allow_hyphen_values = true)]
    pub(crate) vary: Vec<String>,
    /// How it is found what measures hang on, of uncertain values [default: by nodes where they are few, else by mixed
    /// draws]
    #[arg(long, value_enum, conflicts_with = "vary")]
    pub(crate) sensitivities: Option<SensitivitiesArg>,
    /// Draws of each combination, where a key is drawn
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(crate) random: Option<u64>,
    /// Seed of the draws: those of a run depend on it, the number of the run and the key alone
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub(crate) seed: u64,
    /// Measures each run: bodies.NAME.position[2]@end (start, least, most, mean), max(joints.NAME.torque),
    /// energy.kinetic, count(events.impact), sum(impulse); NAME=... names the column
    #[arg(long, value_name = "EXPR")]
    pub(crate) measure: Vec<String>,
    /// Writes the table: .csv, row by row, gone on with where it was cut off; .parquet, whose rows are kept in a CSV
    /// beside it until all are there [default: CSV to stdout]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Computes one of N equal shards, into a file beside the table (table.2-of-8.csv); without --shard the same
    /// command puts them together
    #[arg(long, value_name = "I/N", value_parser = shard, requires = "output")]
    pub(crate) shard: Option<[u64; 2]>,
    /// Runs at a time; the table is the same for any number [default: as many as the machine has processors]
    #[arg(long, value_name = "N", default_value_t = Threads::of_machine().0, hide_default_value = true)]
    pub(crate) workers: NonZeroUsize,
    /// Writes a page that says all of the sweep: inputs, method, versions, seed, hash of the table, distributions, what
    /// measures hang on; the same command gives the same bytes
    #[arg(long, value_name = "FILE", conflicts_with = "shard")]
    pub(crate) report: Option<PathBuf>,
    /// Prints what was found as JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}

/// How it is found what measures hang on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum SensitivitiesArg {
    /// By a grid of Gauss's nodes: few values, smooth answers
    Gauss,
    /// By mixed draws, with standard errors: many values, any answers
    Saltelli,
    /// Derivatives alone
    Local,
    /// Not at all
    Off,
}

impl From<SensitivitiesArg> for Sensitivities {
    fn from(own: SensitivitiesArg) -> Self {
        match own {
            SensitivitiesArg::Gauss => Self::Gauss,
            SensitivitiesArg::Saltelli => Self::Saltelli,
            SensitivitiesArg::Local => Self::Local,
            SensitivitiesArg::Off => Self::Off,
        }
    }
}

/// A shard, as 2/8.
fn shard(text: &str) -> Result<[u64; 2], String> {
    let parsed = text.split_once('/').and_then(|(number, of)| Some([number.parse().ok()?, of.parse().ok()?]));
    parsed
        .filter(|[number, of]| (1..=*of).contains(number))
        .ok_or_else(|| "I/N is needed, 1 to N of N, as 2/8".to_owned())
}

/// How the error of a run is estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ErrorArg {
    /// Not at all
    Off,
    /// By runs beside the run: whole ones where they are cheap, pieces elsewhere
    Quick,
    /// By whole runs beside the run
    Full,
}

impl From<ErrorArg> for ErrorEstimation {
    fn from(own: ErrorArg) -> Self {
        match own {
            ErrorArg::Off => Self::Off,
            ErrorArg::Quick => Self::Quick,
            ErrorArg::Full => Self::Full,
        }
    }
}

/// Where and when checkpoints are written.
#[derive(Debug, Args)]
pub(crate) struct CheckpointArgs {
    /// Writes a checkpoint at the first step end after every S seconds of simulated time, at Ctrl-C or SIGTERM, and at
    /// the end where none was due before; `resume --duration` goes on from there
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub(crate) checkpoint_every: Option<f64>,
    /// Where checkpoints are written, one over the other; alone: at the end and at Ctrl-C [default: the scene file's
    /// name with the ending .checkpoint, in this folder; for `resume` the checkpoint itself]
    #[arg(long, value_name = "FILE")]
    pub(crate) checkpoint: Option<PathBuf>,
}

/// Arguments of `resume`.
#[derive(Debug, Args)]
pub(crate) struct ResumeArgs {
    /// Checkpoint of a run; its scene file must stand where it stood
    pub(crate) from: PathBuf,
    /// Simulated time of the whole run, s, counted from its start: a longer one than before extends a run that has
    /// ended
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    pub(crate) duration: Option<String>,
    #[command(flatten)]
    pub(crate) output: RunOutputArgs,
    #[command(flatten)]
    pub(crate) checkpoints: CheckpointArgs,
}

/// Arguments of `plan`.
#[derive(Debug, Args)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Says how far the bodies at rest are from moving: how far friction may fall, how far the scene may be tilted or
    /// its bodies pushed, and what begins to move then
    #[arg(long)]
    pub(crate) stability: bool,
    /// Prints the plan as JSON, with the accelerations at t = 0
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `cost`.
#[expect(clippy::struct_excessive_bools, reason = "flags of a command line, each with a name")]
#[derive(Debug, Args)]
pub(crate) struct CostArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Varies a key of the scene over values; several keys give all combinations [default: integrators and steps]
    #[arg(long, value_name = "KEY=VALUE,...")]
    pub(crate) vary: Vec<String>,
    /// Says why an elastic body cannot be shown beside the impact laws [default: it is shown where the scene is the
    /// drop of a box with moduli]
    ///
    /// Such a scene has one box that falls straight onto a fixed floor, flat or on an edge, without friction, and whose
    /// material has youngs_modulus_pa and poisson_ratio. Contact time, impulse and effective restitution are computed
    /// by finite elements.
    #[arg(long, conflicts_with_all = ["scale", "broad_phase"])]
    pub(crate) elastic: bool,
    /// Compares the broad phases, which find pairs that may touch, on the boxes of one run
    #[arg(long, conflicts_with_all = ["vary", "target", "instructions", "svg"])]
    pub(crate) broad_phase: bool,
    /// Times the methods with so many bodies in the arrays of the scene, and tells how the time grows: 100,200,400
    #[arg(long, value_name = "N,...", value_delimiter = ',', value_parser = clap::value_parser!(u32).range(1..))]
    #[arg(conflicts_with_all = ["target", "instructions", "svg", "html", "broad_phase"])]
    pub(crate) scale: Vec<u32>,
    /// Names the cheapest method whose error stays below this, and its ties; exit code 1 when there is none
    ///
    /// Ties are the methods that reach it too, and whose time cannot be told from that of the cheapest within the noise
    /// of timing: the ranges that hold the middle half of the rounds' ratios of both overlap. With fewer than three
    /// rounds the range is 10 % each way. Settings of one method that made the same run, step for step and bit for bit,
    /// are ties too: the first of them, the coarsest, is named.
    #[arg(long, value_name = "ERROR", allow_negative_numbers = true)]
    pub(crate) target: Option<f64>,
    /// Counts instructions too, which repeat exactly, and takes them for the cost (needs valgrind)
    #[arg(long)]
    pub(crate) instructions: bool,
    /// Writes the table as CSV
    #[arg(long, value_name = "FILE")]
    pub(crate) csv: Option<PathBuf>,
    /// Draws error against cost as SVG
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// Writes figure and table as one HTML page
    #[arg(long, value_name = "FILE")]
    pub(crate) html: Option<PathBuf>,
    /// Prints everything as JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// Samples that errors are taken from
    #[arg(long, value_name = "N", default_value_t = 200)]
    #[arg(value_parser = clap::value_parser!(u32).range(1..=MOST_SAMPLES))]
    pub(crate) samples: u32,
    /// Rounds of timing at the most
    #[arg(long, value_name = "N", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) rounds: u32,
    /// Time that the candidates may take together when no --vary is given, about, s
    #[arg(long, value_name = "S", default_value_t = 40.0, allow_negative_numbers = true)]
    pub(crate) budget: f64,
}

/// Arguments of `view`.
#[derive(Debug, Args)]
pub(crate) struct ViewArgs {
    /// One or two scenes (.toml), or a scene and one or two trajectories of it (.csv, .json, .npy)
    #[arg(required = true, num_args = 1..)]
    pub(crate) files: Vec<PathBuf>,
    /// Where to: .html, .png, .gif, .apng, .webp or .glb (may be given several times) [default: the first file's name
    /// with the ending .html, or .png with --still, beside it]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Vec<PathBuf>,
    /// Draws a picture of this time, s: --still t=1.5
    #[arg(long, value_name = "t=S", allow_hyphen_values = true)]
    pub(crate) still: Option<String>,
    /// Frames for each simulated second [default: 60; 25 for moving pictures; never more than 10,000 in all]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub(crate) fps: Option<f64>,
    /// Shows a second run of the scene beside the first, with this change (may be given several times)
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) beside: Vec<String>,
    /// Width and height of pictures, pixels [default: 1280x720; 640x360 for moving pictures]
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<String>,
    /// From where pictures are taken: front, side, top, iso, or the place of the camera, m: --camera 3,-4,2 [default:
    /// as the scene's [view] says; what moves in a plane is seen square on, all else from the front, a little from the
    /// right and above]
    #[arg(long, value_name = "VIEW|X,Y,Z", allow_hyphen_values = true)]
    pub(crate) camera: Option<String>,
    /// What the camera looks at, m: --look-at 0,0,0.5 [default: what is there]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true)]
    pub(crate) look_at: Option<String>,
    /// Draws these over the bodies of pictures: velocities, spins, forces, traces, names (several with commas)
    #[arg(long, value_name = "OVERLAYS", value_delimiter = ',')]
    pub(crate) show: Vec<String>,
    /// Opens what was written: a page, which then plays at once, by the browser
    #[arg(long)]
    pub(crate) open: bool,
    #[command(flatten)]
    pub(crate) changes: ChangeArgs,
}

/// Arguments of `demo`.
#[derive(Debug, Args)]
pub(crate) struct DemoArgs {
    /// The page [default: polhode-demo.html, in this folder]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// Opens the page, which then plays at once, by the browser
    #[arg(long)]
    pub(crate) open: bool,
}

/// Arguments of `new`.
#[derive(Debug, Args)]
pub(crate) struct NewArgs {
    /// Name of the scene; the file is NAME.toml
    pub(crate) name: String,
    /// A shipped example to begin with, with its meshes
    #[arg(long, value_name = "EXAMPLE")]
    pub(crate) from: Option<String>,
}

/// Arguments of `completions`.
#[derive(Debug, Args)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

/// Arguments of `probe`.
#[derive(Debug, Args)]
pub(crate) struct ProbeArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
    /// Runs the scene once it is prepared
    #[arg(long)]
    pub(crate) run: bool,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    #[command(flatten)]
    pub(crate) scene: SceneArgs,
}

/// Arguments of `elastic`.
#[derive(Debug, Args)]
pub(crate) struct ElasticArgs {
    /// Width, m
    #[arg(long, value_name = "M", default_value_t = 2.0, allow_negative_numbers = true)]
    pub(crate) width: f64,
    /// Height, m
    #[arg(long, value_name = "M", default_value_t = 1.0, allow_negative_numbers = true)]
    pub(crate) height: f64,
    /// Angle by which it is turned, degrees: the right corner is the lower one
    #[arg(long, value_name = "DEG", default_value_t = 0.0, allow_negative_numbers = true)]
    pub(crate) tilt: f64,
    /// Speed against the floor, m/s
    #[arg(long, value_name = "M/S", default_value_t = 1.0, allow_negative_numbers = true)]
    pub(crate) speed: f64,
    /// Young's modulus, Pa
    #[arg(long, value_name = "PA", default_value_t = 1e6, allow_negative_numbers = true)]
    pub(crate) young: f64,
    /// Poisson ratio
    #[arg(long, value_name = "NU", default_value_t = 0.3, allow_negative_numbers = true)]
    pub(crate) poisson: f64,
    /// Density, kg/m^3
    #[arg(long, value_name = "D", default_value_t = 1000.0, allow_negative_numbers = true)]
    pub(crate) density: f64,
    /// Elements of the coarsest of three meshes, about; the next ones have four and sixteen times as many
    #[arg(long, value_name = "N", default_value_t = 200)]
    pub(crate) elements: usize,
    /// Time step, s [default: eight just below the limit of stability, whose mean is taken]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    pub(crate) step: Option<f64>,
    /// Puts the sides on rollers: uniaxial strain, for which there is a closed form
    #[arg(long)]
    pub(crate) confined: bool,
    /// Drops rectangles of several widths, and of several tilts, one a row
    #[arg(long, conflicts_with_all = ["confined", "picture", "step"])]
    pub(crate) table: bool,
    /// Draws the mesh where it is deformed most, with its stresses, as SVG
    #[arg(long, value_name = "FILE")]
    pub(crate) picture: Option<PathBuf>,
    /// Prints everything as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `compare`.
#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// A trajectory (.csv)
    pub(crate) a: PathBuf,
    /// Another trajectory of the same bodies at the same times (.csv)
    pub(crate) b: PathBuf,
    /// Absolute difference that is accepted, in the unit of each column
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    pub(crate) atol: f64,
    /// Difference that is accepted, relative to the larger of the two numbers
    #[arg(long, default_value_t = 0.0, allow_negative_numbers = true)]
    pub(crate) rtol: f64,
    /// Draws the differences over time, into the .svg file of -o [default: all that the files, and --scene, tell]
    #[arg(long, value_name = "LIST", value_enum, value_delimiter = ',', num_args = 0..=1, requires = "output")]
    pub(crate) plot: Option<Vec<ComparePlotArg>>,
    /// Where the plots go (.svg)
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
    /// The scene of the trajectories, whose masses energies are computed from
    #[arg(long, value_name = "SCENE", requires = "output")]
    pub(crate) scene: Option<PathBuf>,
}

/// What is plotted of two trajectories: differences over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ComparePlotArg {
    /// Distance of the bodies' origins
    Positions,
    /// Angle between their attitudes
    Attitudes,
    /// Of velocities of their centres of mass
    Velocities,
    /// Of kinetic energy and that of gravity (needs --scene)
    Energy,
}
