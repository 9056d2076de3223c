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
