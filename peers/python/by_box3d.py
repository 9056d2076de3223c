"""The scenes by Box3D, through the program of peers/examples/by_box3d.rs, which reads and writes what that of rapier does. No impulses are told."""

import by_rapier
from by_rapier import Setting
from states import Refused

# The third word is the speed below which nothing bounces, m/s; by default 1.
SETTINGS = [
    Setting("defaults", 1 / 60, 4, "1"),
    Setting("as advised", 1 / 60, 8, "1"),
    Setting("best found", 0.001, 8, "0"),
]


def run(program, scene, setting, samples):
    if any(body.shape == "cylinder" for body in scene.bodies):
        raise Refused("Box3D has no cylinder, but prisms of up to 32 sides")
    return by_rapier.run(program, scene, setting, samples)
