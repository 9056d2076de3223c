"""Builders: what they write is what the program reads."""

import subprocess
from pathlib import Path

import numpy as np
import polhode as ph
import pytest


def everything():
    name, method = 'a "quoted" name\n', {"tier": "stepped"}
    scene = ph.Scene(gravity=(0, 0, -9.81), duration=0.2, name=name, title="All", method=method)
    scene.fixed(ph.HalfSpace(), friction=0.4, name="floor")
    scene.add(ph.Box(1, 0.5, 0.25), mass=2.0, at=np.array([0, 0, 1.0]), friction=0.4, restitution=0.3)
    scene.add(ph.Cylinder(0.1, 0.2), density=1000.0, at=(2, 0, 1), rotation_vector=(0.1, 0, 0))
    scene.add(ph.Compound(ph.Box(0.1, 0.1, 0.4), (ph.Sphere(0.1), (0, 0, 0.3))), mass=np.float64(1), at=(4, 0, 1))
    for shape in (ph.Cone(0.1, 0.2), ph.Capsule(0.1, 0.2), ph.Torus(0.3, 0.1), ph.Sphere(0.1)):
        scene.add(shape, mass=1.0, at=(6 + len(scene.document["bodies"]), 0, 2))
    rod = scene.add(ph.Box(0.1, 0.1, 1), mass=1.0, at=(0, 5, 2))
    motor = {"velocity": 1.0, "gain": 2.0}
    scene.joint(ph.Hinge(at=(0, 5, 2.5), axis=(0, 1, 0), range=(-1, 1), motor=motor), rod, name="knee")
    wheels = [scene.add(ph.Cylinder(0.1, 0.1), mass=1.0, at=(0, 8 + n, 3)) for n in range(2)]
    axles = [scene.joint(ph.Hinge(at=(0, 8 + n, 3), axis=(0, 0, 1)), wheel) for n, wheel in enumerate(wheels)]
    scene.gear(*axles, ratio=-2.0)
    scene.force("spring", bodies=[rod, wheels[0]], stiffness=1.0)
    scene.no_contact(*wheels)
    pyramid = {"pyramid": {"base": 3, "spacing": [0.44, 0.4]}}
    scene.array(ph.Box(0.4, 0.4, 0.4), pyramid, at=(0, -5, 0.2), mass=1.0, friction=0.4)
    return scene


def test_the_program_runs_what_a_scene_writes(program, tmp_path):
    path = tmp_path / "all.toml"
    path.write_text(everything().to_toml())
    done = subprocess.run([program, "run", path, "-o", tmp_path / "all.npy"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    run = ph.run(everything())
    assert run.name == 'a "quoted" name\n' and len(run) == len(everything().document["bodies"]) + 6
    assert np.array_equal(ph.run(path)["box"].position, run["box"].position)


def test_names_are_free_ones():
    scene = ph.Scene()
    assert [scene.add(ph.Sphere(1), mass=1.0).name for _ in range(3)] == ["sphere", "sphere-2", "sphere-3"]


def test_equal_materials_are_one():
    scene = ph.Scene()
    for height in (1, 4):
        scene.add(ph.Sphere(1), mass=1.0, at=(0, 0, height), friction=0.5)
    assert list(scene.document["materials"]) == ["friction 0.5"]
    with pytest.raises(ValueError, match="a material, or friction of its own"):
        scene.add(ph.Sphere(1), mass=1.0, friction=0.5, material="ice")


def test_every_joint_can_be_built():
    for joint in [
        ph.Ball((0, 0, 0)),
        ph.FixedJoint((0, 0, 0)),
        ph.Hinge((0, 0, 0), (0, 0, 1)),
        ph.Slider((0, 0, 0), (0, 0, 1), stiffness=10.0),
        ph.Cylindrical((0, 0, 0), (0, 0, 1), angle={"damping": 1.0}),
        ph.Screw((0, 0, 0), (0, 0, 1), lead=0.1),
        ph.Universal((0, 0, 0), ((1, 0, 0), (0, 1, 0))),
        ph.Planar((0, 0, 0), (0, 0, 1)),
        ph.Rod(((0, 0, 0), (0, 0, 2))),
        ph.Rope(((0, 0, 0), (0, 0, 2))),
    ]:
        scene = ph.Scene(duration=0.1)
        body = scene.add(ph.Sphere(0.2), mass=1.0, at=(0, 0, 0))
        handle = scene.joint(joint, body)
        assert len(ph.run(scene).joints[handle].angle) == 11, joint


def test_a_mesh_file_is_found(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
    Path("tetrahedron.obj").write_text(tetrahedron)
    scene = ph.Scene(duration=0.1)
    scene.add(ph.Mesh(Path("tetrahedron.obj"), scale=0.1), density=1000.0)
    assert ph.run(scene).outcome == "completed"


def test_a_bead_on_a_cycloid_swings_like_a_clock():
    # Huygens: its arc from the lowest point is s cos(t sqrt(g / 4R)), however far it swings.
    radius, begun = 0.5, 1.2
    scene = ph.Scene(gravity=9.81, duration=2.0)
    up = {"lowest": [0, 0, 0], "heading": [1, 0, 0], "up": [0, 0, 1], "radius": radius, "angle": 2.5}
    wire = scene.track("wire", {"cycloid": up})
    at = (radius * (begun + np.sin(begun)), 0, radius * (1 - np.cos(begun)))
    bead = scene.add(ph.Sphere(0.01), mass=0.3, at=at)
    scene.joint(ph.OnTrack(wire, at=at), bead, name="bead")
    run = ph.run(scene)
    start = 4 * radius * np.sin(begun / 2)
    arc = start + run.joints["bead"].displacement
    assert np.allclose(arc, start * np.cos(run.t * np.sqrt(9.81 / (4 * radius))), atol=1e-8)
    off = ph.Scene()
    wire = off.track("wire", {"cycloid": up})
    off.joint(ph.OnTrack(wire, at=(0, 0, 1)), off.add(ph.Sphere(0.01), mass=1.0))
    with pytest.raises(ph.SceneError, match="off its track"):
        ph.run(off)


TETRAHEDRON = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def test_a_mesh_is_loaded_asked_and_added(tmp_path):
    path = tmp_path / "part.obj"
    path.write_text(TETRAHEDRON)
    part = ph.Mesh.load(path, scale=0.5)
    assert part.vertices.shape == (4, 3) and part.vertices.max() == 0.5 and part.triangles.dtype.kind == "i"
    properties = part.mass_properties(density=480.0)
    assert properties["mass_kg"] == pytest.approx(480.0 * 0.125 / 6)
    assert properties["center_of_mass_m"] == pytest.approx([0.125] * 3)
    with pytest.raises(ValueError):
        part.vertices[0, 0] = 1.0
    scene = ph.Scene(duration=0.1)
    body = scene.add(part, density=480.0, at=(0, 0, 1))
    assert ph.run(scene)[body].position[-1, 2] == pytest.approx(1 - 9.81 * 0.01 / 2)
    binary = tmp_path / "part.stl"
    corners = part.vertices[part.triangles].astype("<f4")
    record = np.zeros(len(corners), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("end", "<u2")])
    record["corners"] = corners
    binary.write_bytes(bytes(80) + np.uint32(len(record)).tobytes() + record.tobytes())
    stl = ph.Mesh.load(str(binary))
    assert stl.mass_properties(mass=1.0)["volume_m3"] == pytest.approx(0.125 / 6)


def test_what_is_no_mesh_is_refused(tmp_path):
    with pytest.raises(OSError, match="none.stl"):
        ph.Mesh.load(tmp_path / "none.stl")
    words = tmp_path / "words.obj"
    words.write_text("v one two three\n")
    with pytest.raises(ValueError, match="line 1"):
        ph.Mesh.load(words)
    unknown = tmp_path / "part.xyz"
    unknown.write_bytes(b"\x00\x01\x02")
    with pytest.raises(ValueError, match="OBJ"):
        ph.Mesh.load(unknown)


def test_each_key_of_a_material_makes_one():
    scene = ph.Scene()
    scene.add(ph.Sphere(1), mass=1.0, youngs_modulus_pa=1e6, poisson_ratio=0.3, rolling_friction=0.001, friction=0.5)
    material = next(iter(scene.document["materials"].values()))
    assert set(material) == {"youngs_modulus_pa", "poisson_ratio", "rolling_friction", "friction"}
