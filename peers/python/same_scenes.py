"""Scenes with exact answers, by polhode, rapier, MuJoCo, Drake and Box3D.

    cargo build --release --manifest-path peers/Cargo.toml --example same_scenes
    python peers/python/same_scenes.py --polhode target/release/polhode --rapier peers/target/release/examples/same_scenes
    python peers/python/same_scenes.py --recompute peers/recorded

Each scene is run by each peer with three settings (its defaults; what its manual advises; the best that was found) and by polhode in its
tiers with defaults. Every error is that of one quantity whose exact value is known, computed from recorded states alone. A cell has: the error;
the energy made (positive) or lost beyond what the exact motion loses, of the largest energy of the motion; the residual of Coulomb's law of the
engine's own impulses, in the middle of the samples and at its largest (of polhode what the run tells itself); with `--fine` the distance of
the end from that of the same setting at a quarter of its step, m; the time in units of the yardstick, a loop of a million square roots in Python.
A run that breaks (a position that is no number, or an error above `BROKEN`) is marked. `--keep` writes the recorded states as CSV,
`--recompute` computes the table from such files. `--floats` gives how high sliding boxes float, `--curves FILE` errors over steps.

An engine that is not there, or another version than that recorded, is not left out: its rows have the error of the recorded states, and say so.
With `--keep` any version is run.
"""

import argparse
import math
import pathlib
import sys
import time
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

import by_box3d
import by_drake
import by_mujoco
import by_polhode
import by_rapier
import states
from atlas_scenes import ATLAS
from scenes import SCENES as FIRST, sliding
from states import Refused, apart, file_name, gained, keep, read, residual

SCENES = FIRST + ATLAS
RECORDED = pathlib.Path(__file__).resolve().parent.parent / "recorded"
SAMPLES = 200
# An error (of what the scene says) above which nothing is left of the motion.
BROKEN = 10.0
# A run that takes longer has no fine run, s.
LONG = 2.0
TIERS = "accurate,stepped,fast,micro-collisions,penalty,thesis"
# Steps of curves, s.
STEPS = [1 / 60, 0.01, 0.005, 0.002, 0.001, 0.0005, 0.0002, 0.0001]


@dataclass
class Engine:
    """An engine with a setting: `run` of a scene and samples; `with_step` the same with another step (s)."""

    name: str
    run: object
    with_step: object
    step: float | None
    # Why it shows recorded states and runs nothing.
    recorded: str | None = None


@dataclass
class Peer:
    """An engine that is not polhode: its name, the version whose states are recorded, that which is there (none: it is not), what it needs."""

    name: str
    recorded: str
    there: str | None
    module: object
    needs: str
    program: tuple = ()

    def why_recorded(self, keeps):
        """Why recorded states are shown instead of a run; none where it is run. What is to be recorded is run by any version."""
        if self.there is None:
            return f"not installed ({self.needs}), as recorded"
        if self.there != self.recorded and not keeps:
            return f"{self.there} is installed, as recorded"
        return None


def installed(package):
    """The version of a package of Python, or none."""
    try:
        return version(package)
    except PackageNotFoundError:
        return None


def peers(arguments):
    """All of them, whether they are there or not. Versions of rapier and Box3D are those that peers/Cargo.toml asks for."""
    rapier, box3d = "0.36.1" if arguments.rapier else None, "0.3.1" if arguments.box3d else None
    return [
        Peer("rapier3d-f64", "0.36.1", rapier, by_rapier, "--rapier PROGRAM", (arguments.rapier,)),
        Peer("MuJoCo", "4.0.1", installed("mujoco-core") or installed("mujoco"), by_mujoco, "pip install mujoco-core==4.0.1"),
        Peer("Drake", "1.51.1", installed("drake"), by_drake, "pip install drake==1.51.1"),
        Peer("Box3D", "0.3.1", box3d, by_box3d, "--box3d PROGRAM", (arguments.box3d,)),
    ]


def engines(arguments):
    def polhode(tier, step=None):
        run = lambda scene, samples: by_polhode.run(arguments.polhode, scene, tier, samples, step)
        usual = {"fast": 1 / 60, "stepped": 0.001, "micro-collisions": 0.001, "thesis": 0.01}.get(tier)
        return Engine(f"polhode, {tier}", run, lambda step: polhode(tier, step), step or usual)

    def runs(peer, setting):
        run = lambda scene, samples: peer.module.run(*peer.program, scene, setting, samples)
        return Engine(f"{peer.name} {peer.there}, {setting.name}", run, lambda step: runs(peer, setting.with_step(step)), setting.step)

    def as_recorded(peer, setting, why):
        name = f"{peer.name} {peer.recorded}, {setting.name}"
        return Engine(name, lambda scene, samples: read(RECORDED, scene, name), None, None, why)

    found = [polhode(tier) for tier in arguments.tiers.split(",")] if arguments.polhode else []
    for peer in peers(arguments):
        why = peer.why_recorded(arguments.keep)
        settings = peer.module.SETTINGS + ([by_drake.CONVEX] if arguments.floats and peer.module is by_drake else [])
        found += [as_recorded(peer, s, why) if why else runs(peer, s) for s in settings]
    return [engine for engine in found if arguments.engine in engine.name]


def tell_missing(arguments):
    """Says which engines are not there."""
    for peer in peers(arguments):
        why = peer.why_recorded(arguments.keep)
        if why and arguments.engine in f"{peer.name} {peer.recorded}":
            print(f"{peer.name} {peer.recorded}: {why}", file=sys.stderr)


def error_of_table(scene, engine):
    """What the table beside the recorded states has for a run without states: broken, refused, or nothing."""
    for line in (RECORDED / "README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if cells[1:3] == [scene.name, engine]:
            return cells[3]
    return "not recorded"


def yardstick():
    """Seconds of a loop of a million square roots: the least of three."""
    times = []
    for _ in range(3):
        begin = time.perf_counter()
        sum(math.sqrt(k) for k in range(1_000_000))
        times.append(time.perf_counter() - begin)
    return min(times)


def error_of(scene, recorded):
    """None where the run has broken."""
    error = scene.error(recorded.times, recorded.tracks)
    return error if error < BROKEN else None


def told(value):
    return "-" if value is None else "0" if value == 0 else f"{value:.1e}"


def change(scene, recorded):
    energy = gained(scene, recorded)
    return "-" if energy is None else f"{energy:+.1e}"


def of_record(scene, engine):
    """The fields of a row of an engine that is not there."""
    try:
        recorded = engine.run(scene, SAMPLES)
    except FileNotFoundError:
        return [error_of_table(scene, engine.name), "", "", "", engine.recorded]
    return [told(error_of(scene, recorded)), change(scene, recorded), "-", "-", engine.recorded]


def measured(scene, engine, arguments, unit):
    """The fields of a row."""
    if engine.recorded:
        return of_record(scene, engine)
    try:
        recorded = engine.run(scene, SAMPLES)
    except Refused as error:
        print(f"{scene.name}, {engine.name}: {str(error)[:160]}", file=sys.stderr)
        return [str(error) if str(error).startswith("over ") else "refused", "", "", "", ""]
    error = error_of(scene, recorded)
    if arguments.keep and error is not None:
        keep(arguments.keep, scene, engine.name, recorded, arguments.every)
    if error is None:
        return ["broken", "", "", "", f"{recorded.wall / unit:.2g}"]
    judged = residual(scene, recorded)
    law = f"{told(judged[0])} / {told(judged[1])}" if judged else "-"
    if recorded.own_residual is not None:
        law = f"{told(recorded.own_residual)} (own)"
    fine = None
    if arguments.fine and engine.step and recorded.wall < LONG:
        try:
            fine = apart(recorded, engine.with_step(engine.step / 4).run(scene, SAMPLES))
        except Refused:
            pass
    return [told(error), change(scene, recorded), law, told(fine), f"{recorded.wall / unit:.2g}"]


def table(arguments):
    print("| scene | engine | error | energy gained | residual, middle / largest | from own fine run, m | time |\n" + "|---" * 7 + "|")
    for scene in SCENES:
        if arguments.scenes and scene.name not in arguments.scenes:
            continue
        unit = yardstick()
        for engine in engines(arguments):
            cells = measured(scene, engine, arguments, unit)
            print(f"| {scene.name} | {engine.name} | " + " | ".join(cells) + " |", flush=True)


def recompute(arguments):
    """Errors and energies from files."""
    print("| scene | file | error | energy gained |\n|---|---|---|---|")
    for scene in SCENES:
        begin = file_name(scene, "").removesuffix(".csv.gz")
        for file in sorted(arguments.recompute.glob(begin + "*.csv.gz")):
            engine = file.name.removeprefix(begin).removesuffix(".csv.gz")
            recorded = read(arguments.recompute, scene, engine)
            error = error_of(scene, recorded)
            cells = [told(error), change(scene, recorded)] if error is not None else ["broken", ""]
            print(f"| {scene.name} | {engine} | " + " | ".join(cells) + " |")


def floats(arguments):
    """How high a sliding box is above where it touches, m, while it slides."""
    cases = [(mu, v) for mu in (0.1, 0.5, 1.0) for v in (0.1, 1.0, 10.0)]
    print("| engine | " + " | ".join(f"mu {mu}, {v} m/s" for mu, v in cases) + " |\n" + "|---" * (len(cases) + 1) + "|")
    for engine in engines(arguments):
        if engine.recorded:
            print(f"| {engine.name}: {engine.recorded}, where docs/peers.md has these heights " + "| " * len(cases) + "|")
            continue
        cells = []
        for mu, v in cases:
            scene = sliding(mu, v)
            try:
                recorded = engine.run(scene, SAMPLES)
                cells.append(f"{scene.error(recorded.times, recorded.tracks):+.1e}")
            except Refused:
                cells.append("refused")
        print(f"| {engine.name} | " + " | ".join(cells) + " |", flush=True)


def curves(arguments):
    """Errors over steps, cut where they break, as a figure."""
    from figure import figure

    found = {}
    for scene in SCENES:
        if arguments.scenes and scene.name not in arguments.scenes:
            continue
        for engine in engines(arguments):
            if engine.step is None or "as advised" in engine.name:
                continue
            points = []
            for step in STEPS:
                try:
                    error = error_of(scene, engine.with_step(step).run(scene, 40))
                except Refused:
                    break
                points.append((step, error))
            if not points:
                continue
            found.setdefault(scene.name, {})[engine.name] = points
            print(scene.name, engine.name, *(f"{step:.1e}:{told(error)}" for step, error in points), flush=True)
    arguments.curves.write_text(figure(found))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--polhode", help="the program")
    parser.add_argument("--rapier", help="the program of peers/examples/same_scenes.rs")
    parser.add_argument("--box3d", help="the program of peers/examples/by_box3d.rs")
    parser.add_argument("--tiers", default=TIERS, help="tiers of polhode, with commas")
    parser.add_argument("--engine", default="", help="only engines whose names contain this")
    parser.add_argument("--longest", type=float, default=states.LONGEST, help="a run may take so long, s")
    parser.add_argument("--fine", action="store_true", help="also runs at a quarter of each step")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the recorded states")
    parser.add_argument("--every", type=int, default=1, help="keeps one sample of so many")
    parser.add_argument("--recompute", type=pathlib.Path, help="a folder with recorded states")
    parser.add_argument("--floats", action="store_true", help="how high sliding boxes float")
    parser.add_argument("--curves", type=pathlib.Path, help="an SVG file of errors over steps")
    parser.add_argument("scenes", nargs="*", help="names of scenes (default: all)")
    arguments = parser.parse_args()
    states.LONGEST = arguments.longest
    if not arguments.recompute:
        tell_missing(arguments)
    if arguments.recompute:
        recompute(arguments)
    elif arguments.floats:
        floats(arguments)
    elif arguments.curves:
        curves(arguments)
    else:
        table(arguments)


if __name__ == "__main__":
    main()
