"""Robots from their files, and what is wrong with them."""

import polhode as ph
import pytest
from conftest import ROOT

ARM = ROOT / "fixtures" / "robots" / "arm.urdf"


def test_a_robot_runs():
    run = ph.run(ARM, duration=0.1)
    assert run.outcome == "completed" and len(run.joints) > 0
    scene = ph.Scene(duration=0.1)
    scene.robot(ARM, base="fixed")
    assert len(ph.run(scene).joints) == len(run.joints)


def test_a_doctor_finds_what_is_impossible_and_says_what_mends_it(tmp_path):
    text = ARM.read_text()
    assert not [finding for finding in ph.doctor(ARM) if finding.severity == "error"]
    sick = tmp_path / "sick.urdf"
    at = text.index('mass value="')
    sick.write_text(text[:at] + 'mass value="-' + text[at + len('mass value="') :])
    finding = next(finding for finding in ph.doctor(sick) if finding.severity == "error")
    assert 0 <= text[:at].count("\n") + 1 - finding.line <= 2 and finding.file == str(sick)
    assert "post" in finding.subject and "-8 kg" in finding.what and finding.cure
    with pytest.raises(ph.SceneError) as caught:
        ph.run(sick)
    error = caught.value
    assert (error.place.origin, error.place.line) == (str(sick), finding.line)
    assert error.cure == finding.cure and error.place.key == finding.subject


def test_no_robot_is_an_error(tmp_path):
    with pytest.raises(OSError):
        ph.doctor(tmp_path / "none.urdf")
    words = tmp_path / "words.urdf"
    words.write_text("no robot at all")
    assert ph.doctor(words)[0].severity == "error"


def test_a_robot_tells_its_links_joints_and_limits():
    robot = ph.Robot(ARM)
    assert len(robot.links) == len(robot.joints) + 1 and robot.mass > 0
    assert set(robot.limits) <= {own.name for joint in robot.joints for own in joint.coordinates}
    assert any(lower < upper < float("inf") for lower, upper in robot.limits.values())
    assert all(joint.parent in robot.link_names and joint.child in robot.link_names for joint in robot.joints)
    assert [str(finding) for finding in robot.doctor()] == [str(finding) for finding in ph.doctor(ARM)]


def test_joints_of_a_robot_are_driven():
    servo_arm = ROOT / "fixtures" / "robots" / "servo-arm.xml"
    robot = ph.Robot(servo_arm)
    assert [(own.name, own.kind, own.joint) for own in robot.actuators] == [
        ("shoulder_servo", "position", "shoulder"),
        ("elbow_servo", "position", "elbow"),
        ("wrist_motor", "motor", "wrist"),
    ]
    assert robot.actuators[0].control_range == (-2.0, 2.0) and robot.keyframes == ["raised", "swinging"]
    scene = ph.Scene(duration=1.0)
    swing = {"motion": {"sine": {"amplitude": 0.3, "frequency": 1.0}}}
    scene.robot(servo_arm, keyframe="raised", controls={"wrist_motor": 0.0}, drives={"elbow": swing})
    elbow = ph.run(scene).joints["elbow"].angle
    assert abs(max(elbow) - min(elbow) - 0.6) < 1e-2
    read = [finding for finding in ph.doctor(servo_arm) if finding.severity == "read"]
    assert any(finding.subject == "actuator `shoulder_servo`" for finding in read)
    arm = {own.name: own.effort_limit for joint in ph.Robot(ARM).joints for own in joint.coordinates}
    assert arm["shoulder"] == 60.0


def test_a_robot_stands_where_a_scene_does():
    robot = ph.Robot(ARM)
    run = ph.run(robot, duration=0.1)
    assert list(run.joints) == list(ph.run(ARM, duration=0.1).joints)
    sim = ph.Simulation(robot, duration=0.1)
    assert set(sim.joint_names) == set(run.joints)
    scene = ph.Scene(duration=0.1)
    assert scene.add(robot, name="left", base="fixed", at=(0, 0, 1)) is robot
    scene.add(robot, name="right", base="fixed", at=(3, 0, 1))
    assert len(ph.run(scene).joints) == 2 * len(run.joints)
    assert "left/" in "".join(ph.run(scene))


def test_a_robot_that_is_refused_says_where(tmp_path):
    with pytest.raises(OSError):
        ph.Robot(tmp_path / "none.urdf")
    words = tmp_path / "words.urdf"
    words.write_text("<robot name='x'><link/></robot>")
    with pytest.raises(ph.SceneError) as caught:
        ph.Robot(words)
    assert caught.value.place.origin == str(words) and caught.value.place.line == 1 and caught.value.errors
