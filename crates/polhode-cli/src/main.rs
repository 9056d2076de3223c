//! The `polhode` program.
//!
//! Results go to stdout, progress (a bar on a terminal, else a line every ten seconds) and messages to stderr. Exit
//! codes: 0 fine; 1 a check failed, the run diverged or has not kept the promise of its tier (`degraded`); 2 usage or a
//! bad scene; 3 input or output; 130 Ctrl-C, 143 SIGTERM. The clock is read here and nowhere else.
//!
//! | module | holds |
//! |---|---|
//! | `args`, `drop_args`, `mesh_args` | the command line |
//! | `abandoned` | what programs that were killed have left behind |
//! | `failure` | [`Failure`]: what went wrong, and the exit code it means |
//! | `run`, `plan`, `check`, `mesh`, `compare` | the commands; `run` has `resume` too |
//! | `run_files` | the files that a run writes |
//! | `second_opinion` | a run repeated by another method |
//! | `checkpoints` | when and where a run is stored so that it can be continued |
//! | `view`, `demo` | the commands that show a scene or a trajectory, and the first one to try |
//! | `browser` | opening a page |
//! | `viewpoint` | from where pictures are taken |
//! | `pictures` | the pages, pictures and models that a run is shown as |
//! | `heading` | title and description of what is shown |
//! | `plots`, `quantity_plots` | the plots of a run over time; of single quantities by name |
//! | `watch` | the observer of a run: tells outputs and pictures |
//! | `interrupt` | Ctrl-C and SIGTERM |
//! | `meant` | the command that was meant by a mistyped one |
//! | `scene_groups` | the shipped scenes in groups |
//! | `mechanism_figure` | the figure of the motion that begins |
//! | `progress`, `verbosity` | progress of long work; how much is said on stderr |
//! | `terminal` | stderr: messages, and the line that is drawn again |
//! | `examples` | the shipped scenes, inside the program; new scenes |
//! | `help` | examples below the help of each command |
//! | `inputs` | files that an output never replaces |
//! | `elastic` | the command that drops an elastic rectangle, with rigid laws beside it |
//! | `cost` | the command that sets error against computing time |
//! | `sweep` | the command that runs a scene many times with other values |
//! | `stands` | the command that says whether bodies stand |
//! | `drop` | the command that says on which faces a body comes to rest |
//! | `judge` | the command that judges a trajectory by the laws of a scene |
//! | `play` | the command that writes a page which runs a scene itself |
//! | `scene` | loading the scene that a command names |
//! | `text` | numbers, tables and reports for people |
//! | `stdout`, `harmless` | writing results; text that does not steer a terminal |
//! | `drawing` | pictures after a run: PNG and GIF, frame by frame |
//!
//! The stages of `polhode run`, in the order of the calls; paths are in `src`. Other commands that take a scene load it
//! in the same way.
//!
//! | stage | what it does | where |
//! |---|---|---|
//! | arguments | parses the command line and calls the command | `args.rs`, `main.rs` |
//! | settings | collects the values that the command line sets | `scene.rs` |
//! | accuracy | chooses the cheapest method that reaches a given error, if `--accuracy` asks for it | `cost/mod.rs` |
//! | scene | loads the file, stdin or an example with these values | `run.rs`, `scene.rs` |
//! | outputs | opens files and the checkpoint, none of which may replace an input | `run_files.rs`, `checkpoints.rs` |
//! | simulation | makes the simulation and its plan | `scene.rs` |
//! | run | runs it up to the end, a checkpoint or Ctrl-C | `run.rs` |
//! | | tells how far it is | `watch.rs`, `progress.rs` |
//! | second opinion | repeats it by another method, if `--second-opinion` asks for it | `second_opinion` |
//! | report | prints the report and the plan, for people or as JSON | `text/report.rs`, `stdout.rs` |
//! | exit code | says on stderr what went wrong, and returns the exit code | `failure.rs` |

mod abandoned;
mod args;
mod browser;
mod check;
mod checkpoints;
mod compare;
mod cost;
mod demo;
mod drawing;
mod drop;
mod drop_args;
mod elastic;
mod examples;
mod failure;
mod harmless;
mod heading;
mod help;
mod inputs;
mod interrupt;
mod judge;
mod meant;
mod mechanism_figure;
mod mesh;
mod mesh_args;
mod pictures;
mod plan;
mod play;
mod plots;
mod progress;
mod quantity_plots;
mod run;
mod run_files;
mod scene;
mod scene_groups;
mod second_opinion;
mod stands;
mod stdout;
mod sweep;
mod terminal;
mod text;
mod verbosity;
mod view;
mod viewpoint;
mod watch;

use args::{Cli, Command};
use clap::{CommandFactory, Parser};
use failure::Failure;
use interrupt::Interrupt;
use std::process::ExitCode;
use verbosity::Verbosity;

fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            let error = meant::with_suggestion(error, &Cli::command());
            // Help and version go to stdout with code 0, mistakes to stderr with code 2; a closed pipe is no mistake.
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(failure::USAGE));
        }
    };
    verbosity::set(match (cli.quiet, cli.verbose) {
        (true, _) => Verbosity::Quiet,
        (_, true) => Verbosity::Verbose,
        _ => Verbosity::Usual,
    });
    let outcome = Interrupt::listen().and_then(|interrupt| called(&cli.command, &interrupt));
    outcome.map_or_else(Failure::report, |()| ExitCode::SUCCESS)
}

/// Calls the command.
fn called(command: &Command, interrupt: &Interrupt) -> Result<(), Failure> {
    match command {
        Command::Demo(args) => demo::demo(args, interrupt),
        Command::Run(args) => run::run(args, interrupt),
        Command::Resume(args) => run::resume(args, interrupt),
        Command::Plan(args) => plan::plan(args),
        Command::Cost(args) => cost::cost(args, interrupt),
        Command::Sweep(args) => sweep::sweep(args, interrupt),
        Command::Drop(args) => drop::drop(args, interrupt),
        Command::Judge(args) => judge::judge(args),
        Command::Stands(args) => stands::stands(args, interrupt),
        Command::Check(args) => check::check(args),
        Command::Mesh(args) => mesh::mesh(args),
        Command::Elastic(args) => elastic::elastic(args),
        Command::Schema => schema(),
        Command::Compare(args) => compare::compare(args, interrupt),
        Command::View(args) => view::view(args, interrupt),
        Command::Play(args) => play::play(args, interrupt),
        Command::New(args) => examples::new(args),
        Command::Scenes => examples::scenes(),
        Command::Completions(args) => completions(args.shell),
        Command::Probe(args) => cost::probe(args),
    }
}

/// Prints the JSON Schema of the scene format.
fn schema() -> Result<(), Failure> {
    stdout::text(&format!("{:#}\n", polhode_scene::schema()))
}

/// Prints the script that completes commands and options in a shell.
fn completions(shell: clap_complete::Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "polhode", &mut script);
    stdout::text(&String::from_utf8_lossy(&script))
}
