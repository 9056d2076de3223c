"""What shows a run: the page and plots of the program, pictures, notebooks, progress, and what cannot be shown."""

import html
import json
import struct
import subprocess
import sys
import types
import warnings
import webbrowser

import polhode as ph
import pytest
from conftest import ROOT, SCENES

SMALL = (64, 36)


def drop(**keys):
    scene = ph.Scene(gravity=9.81, name="a drop", **({"duration": 1.0} | keys))
    scene.fixed(ph.HalfSpace(), friction=0.4, name="floor")
    scene.add(ph.Box(1, 0.5, 0.25), mass=2.0, at=(0, 0, 1), restitution=0.3, friction=0.4, name="brick")
    return scene


def diverging(**keys):
    """A run that fails on its way."""
    probe = {"name": "probe", "mass": 1.0, "inertia": [1, 1, 1], "position": [1, 0, 0]}
    scene = {"format": 1, "duration": 5.0, "gravity": [0, 0, 0], "bodies": [probe]}
    scene["forces"] = [{"type": {"point_gravity": {"mu": 1.0}}}]
    with pytest.raises(ph.SimulationError) as caught:
        ph.run(scene, **keys)
    return caught.value.run


@pytest.mark.parametrize(
    ("name", "plots"),
    [
        ("bouncing-ball", "energy,ledger,penetration,contacts,steps"),
        ("double-pendulum", "steps,joint-coordinates,joint-rates,joint-forces,joint-moments,joint-powers"),
        ("box-down-ramp", "contacts"),
    ],
)
def test_page_and_plots_are_those_of_the_program(name, plots, program, tmp_path):
    files = ["run.html", "run.svg"]
    asked = [program, "run", SCENES / f"{name}.toml", "--duration", "0.5", "--plot", plots]
    subprocess.run([*asked, *(part for file in files for part in ("-o", tmp_path / file))], check=True)
    run = ph.run(SCENES / f"{name}.toml", duration=0.5)
    before = run.plot(*plots.split(","))
    assert run.page().save(tmp_path / "own.html").read_bytes() == (tmp_path / "run.html").read_bytes()
    plot = run.plot(*reversed(plots.split(",")), path=tmp_path / "own.svg")
    assert plot.data == before.data == (tmp_path / "run.svg").read_bytes() == (tmp_path / "own.svg").read_bytes()


def test_a_notebook_shows_the_page_of_a_run():
    run = ph.run(drop())
    shown = run._repr_html_()
    source = shown.split('srcdoc="')[1].split('"')[0]
    assert html.unescape(source) == run.page().html
    assert "http://" not in run.page().html.replace("http://www.w3.org", "").split("<script>")[0]
    assert run._repr_html_() == shown


def test_a_page_in_a_notebook_stays_of_moderate_size():
    scene = ph.Scene(duration=100.0, gravity=9.81)
    for number in range(100):
        scene.add(ph.Sphere(0.1), name=f"ball-{number}", mass=1.0, at=(number, 0, 0), angular_velocity=(1, 2, number))
    run = ph.run(scene)
    assert len(run._repr_html_()) < 0.3 * len(run.page().data)


def test_stills_are_of_the_time_that_is_asked_for(tmp_path):
    run = ph.run(drop())
    first, last = run.still(0, size=SMALL), run.still(size=SMALL, path=tmp_path / "last.png")
    assert last.data[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">II", last.data[16:24]) == SMALL
    assert (tmp_path / "last.png").read_bytes() == last._repr_png_() == run.still(1.0, size=SMALL).data != first.data
    assert run.still(0.004, size=SMALL).data == first.data != run.still(0.5, size=SMALL).data
    # The same from arrays that numpy holds meanwhile.
    assert run["brick"].position.shape == (101, 3)
    assert run.still(size=SMALL).data == last.data != run.still(size=SMALL, camera="top", look_at=(0, 0, 0)).data
    assert run.still(size=SMALL, camera=(9, 9, 9)).data != last.data


def test_a_moving_picture_has_the_frames_that_are_asked_for(tmp_path):
    run = ph.run(drop(duration=0.2))
    gif = run.gif(tmp_path / "run.gif", size=SMALL, fps=10)
    assert gif.data[:6] == b"GIF89a" and (tmp_path / "run.gif").read_bytes() == gif.data
    frames = [run.gif(size=SMALL, fps=fps).data.count(b"\x21\xf9\x04") for fps in (None, 10, 1000)]
    assert frames == [6, 3, 21]
    assert 'src="data:image/gif;base64,R0lGOD' in gif._repr_html_()


def test_view_opens_a_browser_or_writes_a_file(tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(webbrowser, "open", lambda url: opened.append(url) or True)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    run = ph.run(drop())
    page = run.view(tmp_path / "run.html")
    assert not opened and (tmp_path / "run.html").read_text(encoding="utf-8") == page.html
    assert run.view().html == page.html
    assert len(opened) == 1 and opened[0].startswith("file:///") and opened[0].endswith(".html")
    monkeypatch.setattr(webbrowser, "open", lambda url: False)
    with pytest.raises(ph.ViewError, match="no browser"):
        run.view()


@pytest.mark.parametrize(
    ("show", "error", "said"),
    [
        (lambda run: run.plot("energi"), ph.UnknownName, "did you mean 'energy'.*energy, ledger, .*joint-powers"),
        (lambda run: run.plot("energy", "joint-forces"), ph.ViewError, "no joints: nothing to plot as `joint-forces`"),
        (lambda run: run.still(1.5), ph.ViewError, "t = 1.5 s: the motion is from 0 s to 1 s"),
        (lambda run: run.still(float("nan")), ph.ViewError, "t = NaN"),
        (lambda run: run.still(camera="up"), ph.UnknownName, "front, side, top, iso"),
        (lambda run: run.still(camera=(1, 2)), TypeError, "camera: 3 numbers"),
        (lambda run: run.still(camera=(0, 0, 1), look_at=(0, 0, 1)), ph.ViewError, "two different places"),
        (lambda run: run.still(size=(0, 9)), ph.ViewError, "0 x 9 pixels: 1 to 8192"),
        (lambda run: run.still(size="big"), TypeError, "size: width and height are needed.*'big'"),
        (lambda run: run.still(path="run.jpg"), ph.ViewError, "run.jpg: the file of a Still ends in .png"),
        (lambda run: run.gif(fps=0), ph.ViewError, "fps=0"),
        (lambda run: run.page(frames=1), ph.ViewError, "frames=1 is below its limit, 2"),
    ],
)
def test_what_cannot_be_shown_says_why(show, error, said):
    with pytest.raises(error, match=said):
        show(ph.run(drop()))


def test_a_run_that_failed_is_shown_up_to_there():
    run = diverging()
    report = run.page().html
    assert '"outcome":"failed: ' in report and run._repr_html_() is not None
    assert "grows without bound" in run.plot("energy").svg
    assert run.still(size=SMALL).data[:4] == b"\x89PNG"


def test_a_run_without_samples_or_bodies_shows_nothing():
    empty = ph.run({"format": 1, "bodies": []})
    with pytest.raises(ph.ViewError, match="no bodies"):
        empty.page()
    with pytest.raises(ph.ViewError, match="no bodies"):
        empty.still()
    assert empty._repr_html_() is None


INTERRUPTED = """
import os, signal, sys, threading
import polhode as ph
scene = ph.Scene(duration=1e4, interval=0.1)
scene.add(ph.Box(1, 2, 3), mass=1.0, angular_velocity=(0.1, 5, 0.1))
threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    ph.run(scene, set={"method.integrator": "rk4"}, step=0.001, frames=sys.argv[1] == "True")
except ph.Interrupted as ended:
    run = ended.run
page = run.page(frames=100).html
assert '"outcome":"failed: interrupted at t = ' in page
assert "interrupted" in run.plot("energy").svg
"""


@pytest.mark.parametrize("frames", ["False", "True"])
def test_a_run_that_was_interrupted_is_shown_up_to_there(frames):
    done = subprocess.run([sys.executable, "-c", INTERRUPTED, frames], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr


SLOW = {"scene": ph.Scene(duration=150.0), "set": {"method.integrator": "rk4"}, "step": 0.001}
SLOW["scene"].add(ph.Box(1, 2, 3), mass=1.0, angular_velocity=(0.1, 5, 0.1))


class FakeBar:
    """A bar that keeps what it was told."""

    made = []

    def __init__(self, **keys):
        self.keys, self.n, self.is_closed = keys, 0.0, False
        FakeBar.made.append(self)

    def update(self, further):
        self.n += further

    def close(self):
        self.is_closed = True


@pytest.fixture
def bars(monkeypatch):
    """A tqdm that keeps its bars."""
    FakeBar.made = []
    fake = types.ModuleType("tqdm.auto")
    fake.tqdm = FakeBar
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", fake)
    return FakeBar.made


def test_a_bar_tells_how_far_a_run_is(bars, monkeypatch):
    monkeypatch.setattr("polhode._progress._AFTER", 0.0)
    ph.run(**SLOW, progress=True)
    (bar,) = bars
    assert bar.keys["total"] == 150 and 0 < bar.n <= 150 and bar.is_closed
    ph.run(**SLOW, progress=False)
    ph.run(**SLOW)
    assert len(bars) == 1


def test_a_bar_tells_how_far_a_sweep_is(bars, monkeypatch):
    from concurrent.futures import ThreadPoolExecutor

    monkeypatch.setattr("polhode._progress._AFTER", 0.0)
    with ThreadPoolExecutor(2) as threads:
        ph.sweep(drop(), vary={"bodies.brick.mass": [1.0, 2.0, 3.0]}, executor=threads, progress=True)
    (bar,) = bars
    assert (bar.n, bar.keys["total"], bar.keys["unit"], bar.is_closed) == (3, 3, "runs", True)


def test_a_terminal_has_a_bar_and_a_script_has_none(bars, monkeypatch):
    monkeypatch.setattr("polhode._progress._AFTER", 0.0)
    monkeypatch.setattr(sys, "stderr", types.SimpleNamespace(isatty=lambda: True))
    ph.run(**SLOW)
    assert len(bars) == 1


def test_without_tqdm_nothing_breaks(monkeypatch):
    monkeypatch.setattr("polhode._progress._AFTER", 0.0)
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.warns(UserWarning, match="pip install tqdm"):
        assert ph.run(**SLOW, progress=True).outcome == "completed"
    monkeypatch.setattr(sys, "stderr", types.SimpleNamespace(isatty=lambda: True))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert ph.run(**SLOW).outcome == "completed"


def test_tqdm_is_not_loaded_before_it_is_needed():
    code = "import sys, polhode as ph; ph.run({'format': 1, 'bodies': []}, progress=True)"
    code += "; assert 'tqdm' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_notebooks_stand_without_outputs():
    notebooks = sorted((ROOT / "crates" / "polhode-py" / "notebooks").glob("*.ipynb"))
    assert len(notebooks) >= 3
    for path in notebooks:
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
            assert not cell.get("outputs") and cell.get("execution_count") is None, path


def test_a_run_that_keeps_its_frames_has_page_and_plots_without_another_simulation():
    kept, other = ph.run(drop(), frames=True), ph.run(drop())
    assert kept.report.keys() == other.report.keys() and (kept["brick"].position == other["brick"].position).all()
    assert kept.plot("energy", "steps").data == other.plot("energy", "steps").data
    assert kept.page().data == other.page().data == kept.page(frames=1000).data
    assert kept.page(frames=5).data == other.page(frames=5).data != kept.page().data
    # A page is kept once it is made.
    assert kept.page() is kept.page()


@pytest.mark.parametrize("frames", [False, True])
def test_a_run_that_failed_shows_why_whether_it_kept_its_frames_or_not(frames):
    run = diverging(frames=frames)
    assert "grows without bound" in run.plot("energy").svg and '"outcome":"failed: ' in run.page().html
