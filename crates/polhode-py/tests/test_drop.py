"""How a part lands: a die's shares within their errors, what rolls, and the same throws for any number of workers."""

import math

import polhode as ph
import pytest

TETRAHEDRON = "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def test_a_die_is_fair():
    poses = ph.rest_poses(ph.Box(0.016, 0.016, 0.016), 240, seed=2)
    assert len(poses) == 6 and poses.failed == poses.leaning == poses.moving == 0
    assert sum(face.throws for face in poses) == poses.throws == 240
    chi = sum((face.throws - 40) ** 2 / 40 for face in poses)
    assert chi < 20.5        # chi-squared of five degrees of freedom: exceeded once in a thousand times
    assert poses[0].tilt == pytest.approx(math.pi / 4, abs=1e-12)


def test_the_number_of_workers_changes_nothing():
    one, two = (ph.rest_poses(ph.Box(0.03, 0.02, 0.01), 12, seed=3, workers=workers) for workers in (1, 2))
    assert one.report == two.report


def test_a_mesh_of_a_file(tmp_path):
    file = tmp_path / "part.obj"
    file.write_text(TETRAHEDRON)
    poses = ph.rest_poses(file, 20, scale=0.001, density=7850, young=2e11, corner_radius=1e-3)
    assert poses.report["size_m"] == pytest.approx(0.03 * math.sqrt(2))
    assert poses.deceleration["largest"] > 9.81 and poses.impulse["largest"] > 0.0


def test_what_cannot_be_thrown():
    with pytest.raises(ValueError, match="it rolls"):
        ph.rest_poses(ph.Sphere(0.1), 10)
    for n in (0, 10**9):
        with pytest.raises(ValueError, match="1 to 10000000 are accepted"):
            ph.rest_poses(ph.Box(1, 1, 1), n)
    with pytest.raises(ValueError, match="no body"):
        nut = {"name": "a", "mass": 1.0, "inertia": [1, 1, 1]}
        ph.rest_poses({"format": 1, "duration": 1.0, "bodies": [nut]}, body="b")
