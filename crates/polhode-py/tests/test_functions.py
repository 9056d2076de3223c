"""Parts of the library as functions of arrays."""

import numpy as np
import polhode as ph
import pytest


def test_a_free_rotation_is_that_of_a_run():
    moments, velocity = [1.0, 2.0, 3.0], (0.1, 5.0, 0.2)
    scene = ph.Scene(gravity=0.0, duration=5.0)
    scene.add(name="nut", mass=1.0, inertia=moments, angular_velocity=velocity)
    run = ph.run(scene)
    attitudes = ph.rotate_free(moments, velocity, run.t)
    assert np.abs(np.abs((attitudes * run["nut"].orientation).sum(axis=1)) - 1).max() < 1e-13
    assert ph.rotate_free(moments, velocity, []).shape == (0, 4)
    # Any stride and type of numbers.
    assert np.array_equal(ph.rotate_free(moments, velocity, run.t[::2]), attitudes[::2])
    assert ph.rotate_free(moments, velocity, np.arange(3)).shape == (3, 4)


@pytest.mark.parametrize(
    "arguments",
    [
        ([1, 2], [0, 0, 1], [0.0]),
        ([1, 2, 9], [0, 0, 1], [0.0]),
        ([-1, 2, 2], [0, 0, 1], [0.0]),
        ([1, 2, 3], [0, 0, float("inf")], [0.0]),
        ([1, 2, 3], [0, 0, 1], [float("nan")]),
        ([1, 2, 3], [0, 0, 1], [[0.0]]),
        ([1, 2, 3], [0, 0, 1], "soon"),
        ([1, 2, 3], [0, 0, 1], [0.0], [0, 0, 0, 0]),
    ],
)
def test_bad_rotations_are_refused(arguments):
    with pytest.raises((TypeError, ValueError)):
        ph.rotate_free(*arguments)


CUBE = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
]


def test_mass_properties_of_a_cube():
    properties = ph.mass_properties(CUBE, np.array(FACES, dtype=np.int32), density=6.0)
    assert properties["mass_kg"] == pytest.approx(6.0)
    assert np.allclose(properties["inertia_kg_m2"], np.eye(3))
    assert ph.mass_properties(CUBE, FACES, mass=6.0, hollow=True)["principal_moments_kg_m2"][0] > 1.0


@pytest.mark.parametrize(
    "change",
    [
        {"vertices": np.zeros((8, 2))},
        {"vertices": [[float("nan")] * 3] * 8},
        {"triangles": FACES[:-1]},
        {"triangles": [[0, 1, 99]]},
        {"triangles": [[0, 1, -1]]},
        {"triangles": [[0.0, 1.0, 2.0]]},
        {"density": None},
        {"density": -1.0},
        {"mass": 1.0},
    ],
)
def test_bad_meshes_are_refused(change):
    with pytest.raises((TypeError, ValueError)):
        ph.mass_properties(**({"vertices": CUBE, "triangles": FACES, "density": 1.0} | change))
