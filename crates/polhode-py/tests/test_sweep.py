"""Sweeps: the same bits for all executors, lost workers, killed sweeps, bad input."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import polhode as ph
import pytest
import sweeps
from sweeps import MEASURE, VARY

HEIGHT = "bodies.box.position[2]"


def text(table, path):
    table.to_csv(path)
    return path.read_text()


@pytest.fixture
def threads():
    with ThreadPoolExecutor(2) as pool:
        yield pool


def swept(executor, **keys):
    keys = {"vary": VARY, "runs": 6, "seed": 7, "measure": MEASURE, "executor": executor, **keys}
    return ph.sweep(sweeps.scene(), **keys)


def test_the_bits_are_the_same_for_any_executor_and_number_of_workers(threads, tmp_path):
    one = text(swept(1), tmp_path / "one.csv")
    assert text(swept(2), tmp_path / "two.csv") == one
    assert text(swept(threads), tmp_path / "threads.csv") == one
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        assert text(swept(pool), tmp_path / "pool.csv") == one
        pool.submit(int).result()
    assert one.splitlines()[0] == ",".join(["run", *VARY, "outcome", "error", *MEASURE, "reason"])


def test_a_run_of_a_sweep_is_the_run_of_its_values(threads):
    table = swept(threads)
    assert len(table) == 12 and list(table["outcome"]) == ["completed"] * 12
    values = {name: float(table[name][5]) for name in VARY}
    run = ph.run(sweeps.scene(), set=values)
    assert table["box.position[2]@end"][5] == run["box"].position[-1, 2]
    assert table["energy.total@end"][5] == run.energy.total[-1]


def test_draws_depend_on_seed_run_and_key_alone(threads):
    table, more = swept(threads), swept(threads, runs=9, measure="events")
    assert np.array_equal(more[HEIGHT][:12], table[HEIGHT])
    assert len(set(more[HEIGHT])) == 18
    assert not set(swept(threads, seed=8)[HEIGHT]) & set(table[HEIGHT])
    alone = swept(threads, vary={HEIGHT: VARY[HEIGHT]}, runs=12)
    assert np.array_equal(alone[HEIGHT], table[HEIGHT])


def test_lists_are_a_grid(threads):
    vary = {
        "gravity": [[0, 0, -9.81], [0, 0, -1.62]],
        "bodies.box.mass": np.array([1.0, 2.0]),
        "method.tier": ["accurate"],
    }
    table = ph.sweep(sweeps.scene(), vary=vary, executor=threads)
    assert table["gravity"].tolist() == [[0, 0, -9.81]] * 2 + [[0, 0, -1.62]] * 2
    assert table["bodies.box.mass"].tolist() == [1, 2, 1, 2]
    assert table["method.tier"].tolist() == ["accurate"] * 4


@pytest.mark.parametrize(
    ("drawn", "mean", "deviation"),
    [
        (ph.Normal(3, 0.5), 3, 0.5),
        (ph.Uniform(1, 3), 2, 1 / 3**0.5),
        (ph.LogNormal(1, 0.1), np.exp(0.005), 0.1007),
        (ph.Choice((0.0, 1.0)), 0.5, 0.5),
    ],
)
def test_distributions_have_their_moments(drawn, mean, deviation):
    draws = [drawn.draw(1, run, "key") for run in range(4000)]
    assert np.mean(draws) == pytest.approx(mean, abs=4 * deviation / 4000**0.5)
    assert np.std(draws) == pytest.approx(deviation, rel=0.05)


def test_runs_that_fail_are_rows_with_their_reason(threads):
    vary = {"bodies.box.mass": ph.Normal(1, 1)}
    table = ph.sweep(sweeps.scene(), vary=vary, runs=20, measure={"top": sweeps.top}, executor=threads)
    failed = table["bodies.box.mass"] <= 0
    assert 0 < failed.sum() < 20
    assert np.array_equal(table["outcome"] == "failed", failed) and np.array_equal(np.isnan(table["top"]), failed)
    assert all("mass" in reason for reason in table["reason"][failed]) and not any(table["reason"][~failed])
    with pytest.raises(ValueError, match=f"{failed.sum()} of 20 runs have no value"):
        table.mean("top")
    assert table.where(~failed).mean("top").runs == 20 - failed.sum()


def test_a_measure_that_fails_and_a_broken_promise_are_seen(threads, tmp_path):
    table = swept(threads, measure={"picky": sweeps.picky}, save=tmp_path / "save.csv")
    failed = table[HEIGHT] > 1
    assert failed.any() and np.array_equal(table["outcome"] == "failed", failed)
    assert set(table["reason"][failed]) == {"measure 'picky': ArithmeticError: ArithmeticError: too high for me"}
    nut = {"name": "nut", "mass": 1.0, "inertia": [1, 2, 3], "angular_velocity": [0.1, 9, 0]}
    scene = {"format": 1, "bodies": [nut], "duration": 1.0, "method": {"integrator": "explicit-euler"}}
    table = ph.sweep(scene, vary={"method.step": [0.01]}, executor=threads)
    assert table["outcome"][0] == "degraded" and table["reason"][0]


def test_means_and_quantiles(threads):
    table = ph.Table({"run": [0, 1, 2, 3], "x": [1.0, 2.0, 3.0, 4.0]})
    assert table.mean("x") == (2.5, pytest.approx((5 / 3 / 4) ** 0.5), 4)
    assert table.quantile("x", [0, 0.5, 1]).tolist() == [1, 2.5, 4]
    with pytest.raises(ph.UnknownName, match="column"):
        table["y"]


def test_a_killed_worker_loses_no_finished_run(tmp_path):
    height = float(np.sort(swept(1)[HEIGHT])[-2])
    whole = swept(1, measure={"top": sweeps.top})
    table = swept(2, measure={"top": sweeps.Deadly(tmp_path, height, 1)}, save=tmp_path / "save.csv")
    assert (tmp_path / "0").exists()
    assert text(table, tmp_path / "a.csv") == text(whole, tmp_path / "b.csv")


def test_a_pool_that_was_given_is_renewed(tmp_path):
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        table = swept(pool, measure={"top": sweeps.Deadly(tmp_path, 1.0, 1)})
    assert list(table["outcome"]) == ["completed"] * 12


def test_a_run_that_kills_each_worker_is_a_row_and_the_others_are_finished(tmp_path):
    heights = swept(1)[HEIGHT]
    table = swept(2, measure={"top": sweeps.Deadly(tmp_path, float(np.sort(heights)[-2]), 99)})
    killer = heights == heights.max()
    assert np.array_equal(table["outcome"] == "failed", killer)
    assert list(table["reason"][killer]) == ["its worker was lost 3 times"]


def test_a_sweep_whose_workers_all_die_ends(tmp_path):
    with pytest.raises(ph.SweepStopped, match="__main__") as caught:
        swept(2, measure={"top": sweeps.Deadly(tmp_path, 0.0, 99)})
    assert len(caught.value.table) == 0


SCRIPT = """
import sys
sys.path.insert(0, sys.argv[1])
import polhode as ph, sweeps
if __name__ == "__main__":
    keys = {"vary": sweeps.VARY, "runs": 20, "seed": 7, "measure": {"top": sweeps.slow}}
    ph.sweep(sweeps.scene(), executor=2, save=sys.argv[2], **keys)
"""


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize("signal_number", [signal.SIGKILL, signal.SIGINT])
def test_a_killed_sweep_goes_on_where_it_was(threads, tmp_path, signal_number):
    script, save = tmp_path / "script.py", tmp_path / "save.csv"
    script.write_text(SCRIPT)
    started = subprocess.Popen([sys.executable, script, Path(sweeps.__file__).parent, save], start_new_session=True)
    end = time.monotonic() + 60
    while (not save.exists() or save.read_text().count("\n") < 8) and time.monotonic() < end:
        time.sleep(0.02)
    os.killpg(started.pid, signal_number)
    started.wait(10)
    before = save.read_text()
    kept = before[: before.rfind("\n") + 1].splitlines()[2:]
    assert 6 <= len(kept) < 40
    save.write_text(before + "39,0.5")
    begun = []

    class Counting(ThreadPoolExecutor):
        def submit(self, *call):
            begun.extend(run for run, _ in call[2])
            return super().submit(*call)

    with Counting(2) as pool:
        table = swept(pool, runs=20, measure={"top": sweeps.slow}, save=save)
    assert not {int(line.split(",")[0]) for line in kept} & set(begun) and len(begun) == 40 - len(kept)
    whole = swept(threads, runs=20, measure={"top": sweeps.slow})
    assert text(table, tmp_path / "a.csv") == text(whole, tmp_path / "b.csv")
    assert save.read_text().split("\n", 1)[1] == (tmp_path / "b.csv").read_text()


def test_a_file_goes_on_to_more_runs_and_one_of_another_sweep_is_refused(threads, tmp_path):
    save = tmp_path / "save.csv"
    swept(threads, runs=2, save=save)
    table = swept(threads, save=save)
    assert text(table, tmp_path / "a.csv") == text(swept(threads), tmp_path / "b.csv")
    before = save.read_bytes()
    for other in (
        {"seed": 8},
        {"vary": {HEIGHT: ph.Normal(1, 0.02)}},
        {"measure": "events"},
        {"duration": 0.2},
        {"runs": 2},
    ):
        with pytest.raises(ph.SweepError, match="path"):
            swept(threads, save=save, **other)
        assert save.read_bytes() == before
    save.write_text("my thesis\n")
    with pytest.raises(ph.SweepError, match="no file of a sweep"):
        swept(threads, save=save)
    assert save.read_text() == "my thesis\n"
    save.write_text("my thesis")
    with pytest.raises(ph.SweepError, match="no file of a sweep"):
        swept(threads, save=save)
    assert save.read_text() == "my thesis"


def test_a_callable_with_a_state_is_told_by_it(threads, tmp_path):
    save = tmp_path / "save.csv"
    made = [sweeps.Deadly(tmp_path, 9.0, 1), sweeps.Deadly(tmp_path, 9.0, 1), sweeps.Deadly(tmp_path, 8.0, 1)]
    assert len(swept(threads, measure={"top": made[0]}, save=save)) == 12
    assert len(swept(threads, measure={"top": made[1]}, save=save)) == 12
    with pytest.raises(ph.SweepError, match="another sweep"):
        swept(threads, measure={"top": made[2]}, save=save)


def test_parquet(threads, tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    save = tmp_path / "save.parquet"
    swept(threads, runs=2, save=save)
    assert os.listdir(tmp_path) == ["save.parquet"]
    table = swept(threads, save=save)
    written = parquet.read_table(save).to_pydict()
    np.testing.assert_equal(written, {name: table[name].tolist() for name in table.columns})
    with pytest.raises(ph.SweepError, match="another sweep"):
        swept(threads, save=save, seed=8)


def test_parquet_without_pyarrow_is_refused(threads, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    with pytest.raises(ph.SweepError, match="pip install pyarrow"):
        swept(threads, save=tmp_path / "save.parquet")


def test_pandas(threads):
    pandas = pytest.importorskip("pandas")
    frame = swept(threads).to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.index.name == "run" and len(frame) == 12


class Nothing(ThreadPoolExecutor):
    def submit(self, *_):
        raise AssertionError("something is computed")


@pytest.mark.parametrize(
    ("keys", "error", "said"),
    [
        ({"runs": 10**9}, ph.SweepError, "runs=1000000000 of 2 points each: the limit is 10000000"),
        ({"runs": 1e9}, ph.SweepError, "limit is 10000000"),
        ({"runs": float("nan")}, ph.SweepError, "limit is 10000000"),
        ({"runs": 0}, ph.SweepError, "limit, 1"),
        ({"runs": 2.5}, ph.SweepError, "no whole number"),
        ({"runs": None}, ph.SweepError, "runs is not given"),
        ({"vary": {"bodies.box.mass": [1.0]}}, ph.SweepError, "nothing is drawn"),
        ({"vary": {}}, ph.SweepError, "dictionary"),
        ({"vary": {"bodies.bax.mass": ph.Normal(1, 0.1)}}, ph.SceneError, "bax"),
        ({"vary": {"bodies.box.position[3]": ph.Normal(1, 0.1)}}, ph.SceneError, "from 0 to 2"),
        ({"vary": {"bodies.box.mass": [1.0, -1.0]}, "runs": None}, ph.SceneError, "mass"),
        ({"vary": {"bodies.box.mass": 1.0}, "runs": None}, ph.SweepError, "list or a distribution"),
        ({"vary": {"bodies.box.mass": []}, "runs": None}, ph.SweepError, "0 values"),
        ({"vary": {"outcome": [1.0]}, "runs": None}, ph.SweepError, "column"),
        ({"measure": "bax.position[2]@end"}, ph.UnknownName, "box"),
        ({"measure": "box.position[3]"}, ph.SweepError, "to \\[2\\]"),
        ({"measure": "box.position"}, ph.SweepError, "to \\[2\\]"),
        ({"measure": "box.position[2]@last"}, ph.UnknownName, "end"),
        ({"measure": "events.impacts"}, ph.UnknownName, "impact"),
        ({"measure": {HEIGHT: sweeps.top}}, ph.SweepError, "what is varied"),
        ({"measure": "???"}, ph.SweepError, "no such form"),
        ({"measure": {"x": 3}}, ph.SweepError, "int"),
        ({"measure": {"run": sweeps.top}}, ph.SweepError, "rename"),
        ({"seed": 0.5}, ph.SweepError, "seed=0.5"),
        ({"executor": "many"}, ph.SweepError, "no submit"),
        ({"executor": 0}, ph.SweepError, "at least 1"),
        ({"effects": "some"}, ValueError, "planned"),
    ],
)
def test_bad_input_is_refused_before_anything_is_computed(keys, error, said):
    with Nothing(1) as nothing, pytest.raises(error, match=said):
        swept(keys.pop("executor", nothing), **keys)


@pytest.mark.parametrize(
    "make",
    [lambda: ph.Normal(1, -1), lambda: ph.Uniform(2, 1), lambda: ph.Normal(float("nan"), 1), lambda: ph.Choice(())],
)
def test_bad_distributions_are_refused(make):
    with pytest.raises(ValueError):
        make()


def test_an_executor_that_is_shut_down_is_told(threads):
    threads.shutdown()
    with pytest.raises(ph.SweepStopped, match="shutdown"):
        swept(threads)


def test_a_script_without_a_guard_is_told(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT.replace('if __name__ == "__main__":', "if True:"))
    done = subprocess.run(
        [sys.executable, script, Path(sweeps.__file__).parent, tmp_path / "save.csv"],
        capture_output=True,
        text=True,
        timeout=100,
    )
    assert done.returncode != 0 and "needs `if __name__" in done.stderr.splitlines()[-1]


@pytest.mark.parametrize("is_killed", [False, True])
def test_the_bits_are_the_same_on_dask_also_when_a_worker_is_killed(tmp_path, is_killed):
    distributed = pytest.importorskip("distributed")
    whole = swept(1, measure={"top": sweeps.top})
    measure = {"top": sweeps.Deadly(tmp_path, 1.0, 1 if is_killed else 0)}
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            table = swept(client, measure=measure, save=tmp_path / "save.csv")
    assert (tmp_path / "0").exists() == is_killed
    assert text(table, tmp_path / "a.csv") == text(whole, tmp_path / "b.csv")
