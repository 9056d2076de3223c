//! `cargo xtask solve-friction`: frictional contact problems of other programs, solved exactly.
//!
//! | module | holds |
//! |---|---|
//! | [`reader`] | the `.dat` form |
//! | [`error`] | why a file is refused, with its line |

mod error;
mod reader;

use clap::Args;
use error::ProblemFileError;
use polhode::response::SolverStatus;
use polhode::response::friction::{FrictionSettings, FrictionSolution, gauss_seidel, solve_friction};
use reader::ProblemFile;
use serde::Serialize;
use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

/// Runs of which the shortest counts: the first one fills the caches.
const RUNS: usize = 5;

/// Sweeps that the solver is held against.
const SWEEPS: usize = 100;

/// Exit codes of the program's conventions: a problem is not solved, a file is wrong, a file cannot be read.
const NOT_SOLVED: u8 = 1;
const BAD_FILE: u8 = 2;
const NOT_READ: u8 = 3;

/// Arguments of the command.
///
/// The residual is the natural map with De Saxce's correction, relative to the largest velocity without reactions: the
/// largest over all contacts of |r - P_K(r - u'/g)| g / max|q|, with u = M r + q, u' = u + mu |u_t| n, g the normal
/// diagonal entry of the contact in M and P_K the projection on its cone |r_t| <= mu r_n. It has no unit and is zero
/// exactly at a solution.
///
/// With --json: [{file, contacts, dimension, status, residual, method, iterations, seconds, reactions, squeeze}], a
/// reaction being [n, t1, t2], or [n, t] in a file of dimension 2. Status is solved, inaccurate or infeasible; of an
/// infeasible problem `squeeze` holds normal reactions that move nothing (M z = 0) with q.z < 0, which proves that no
/// reactions keep all normal velocities from being negative. Times are the shortest of five runs, reading not included.
/// Exit code: 0, 1 when a problem is inaccurate, 2 when a file is wrong, 3 when it cannot be read.
#[derive(Debug, Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Options {
    /// Files in the `.dat` form of the test data of Siconos.
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// One array of JSON instead of a table.
    #[arg(long)]
    json: bool,
    /// Measure 100 sweeps of block Gauss-Seidel beside it: time and residual.
    #[arg(long)]
    gauss_seidel: bool,
}

/// What is printed of one file.
#[derive(Debug, Serialize)]
struct Line {
    file: String,
    contacts: usize,
    dimension: usize,
    status: &'static str,
    residual: f64,
    method: &'static str,
    iterations: usize,
    seconds: f64,
    reactions: Vec<Vec<f64>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    squeeze: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    gauss_seidel: Option<Sweeps>,
}

/// 100 sweeps of block Gauss-Seidel.
#[derive(Debug, Serialize)]
struct Sweeps {
    seconds: f64,
    residual: f64,
}

/// Solves the files and prints what came of them; files that are refused are named on stderr, the others are solved.
///
/// # Errors
/// When the output cannot be written as JSON.
pub(crate) fn run(options: &Options) -> Result<ExitCode, Box<dyn Error>> {
    let (mut lines, mut code) = (Vec::new(), 0);
    for path in &options.files {
        match reader::read(path)
            .map_err(Refused::File)
            .and_then(|file| line(path.display().to_string(), &file, options))
        {
            Ok(line) => {
                if line.status == "inaccurate" {
                    code = code.max(NOT_SOLVED);
                }
                lines.push(line);
            }
            Err(error) => {
                eprintln!("error: {error}");
                code = code.max(error.exit_code());
            }
        }
    }
    if options.json {
        println!("{}", serde_json::to_string_pretty(&lines)?);
    } else {
        print_table(&lines);
    }
    Ok(ExitCode::from(code))
}

/// Why a file has no line.
#[derive(Debug, thiserror::Error)]
enum Refused {
    #[error(transparent)]
    File(ProblemFileError),
    #[error(transparent)]
    Solver(#[from] polhode::response::ResponseError),
}

impl Refused {
    fn exit_code(&self) -> u8 {
        match self {
            Self::File(error) if error.is_reading() => NOT_READ,
            Self::File(_) | Self::Solver(_) => BAD_FILE,
        }
    }
}

fn line(file: String, problem_file: &ProblemFile, options: &Options) -> Result<Line, Refused> {
    let ProblemFile { dimension, problem } = problem_file;
    let settings = FrictionSettings::default();
    let mut solution = FrictionSolution::default();
    let mut seconds = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        solution = solve_friction(problem, None, &settings)?;
        seconds = seconds.min(start.elapsed().as_secs_f64());
    }
    let sweeps = || -> Result<Sweeps, Refused> {
        let (mut reactions, mut seconds) = (Vec::new(), f64::INFINITY);
        for _ in 0..RUNS {
            let start = Instant::now();
            reactions = gauss_seidel(problem, SWEEPS);
            seconds = seconds.min(start.elapsed().as_secs_f64());
        }
        Ok(Sweeps { seconds, residual: problem.residual(&reactions)? })
    };
    Ok(Line {
        file,
        contacts: problem.len(),
        dimension: *dimension,
        status: match solution.report.status {
            SolverStatus::Solved => "solved",
            SolverStatus::Inaccurate => "inaccurate",
            SolverStatus::Infeasible => "infeasible",
        },
        residual: solution.report.residual,
        method: solution.report.method.name(),
        iterations: solution.report.iterations(),
        seconds,
        reactions: solution.reactions.chunks(*dimension).map(<[f64]>::to_vec).collect(),
        squeeze: solution.squeeze,
        gauss_seidel: options.gauss_seidel.then(sweeps).transpose()?,
    })
}

fn print_table(lines: &[Line]) {
    let width = lines.iter().map(|line| line.file.len()).max().unwrap_or(0).max("file".len());
    print!("{:width$}  contacts  dim  status      residual  method                 iterations    time/us", "file");
    println!("{}", if lines.iter().any(|line| line.gauss_seidel.is_some()) { "  100 sweeps/us  residual" } else { "" });
    for line in lines {
        print!(
            "{:width$}  {:8}  {:3}  {:10}  {:8.1e}  {:21}  {:10}  {:9.1}",
            line.file,
            line.contacts,
            line.dimension,
            line.status,
            line.residual,
            line.method,
            line.iterations,
            line.seconds * 1e6
        );
        if let Some(sweeps) = &line.gauss_seidel {
            print!("  {:13.1}  {:8.1e}", sweeps.seconds * 1e6, sweeps.residual);
        }
        println!();
    }
}
