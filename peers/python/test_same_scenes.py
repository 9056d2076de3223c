"""A peer that is not there, or of another version than its states, is told, and its recorded states are shown. `python -m unittest -v`"""

import argparse
import unittest
from unittest import mock

import same_scenes
from same_scenes import Peer, engines, error_of, measured, of_record
from scenes import SCENES


def arguments(**more):
    return argparse.Namespace(**{"polhode": None, "rapier": None, "box3d": None, "tiers": "", "engine": "", "keep": None, "floats": False, "fine": False, **more})


class MissingPeers(unittest.TestCase):
    def setUp(self):
        self.scene = next(scene for scene in SCENES if scene.name == "four-bar")

    def rows(self, there):
        with mock.patch.object(same_scenes, "installed", lambda package: there):
            return [(engine, measured(self.scene, engine, arguments(), 1.0)) for engine in engines(arguments(engine="MuJoCo"))]

    def test_a_peer_that_is_not_there_shows_its_recorded_states(self):
        rows = self.rows(None)
        self.assertEqual(len(rows), 3)
        for engine, cells in rows:
            exact = error_of(self.scene, same_scenes.read(same_scenes.RECORDED, self.scene, engine.name))
            self.assertEqual(cells[0], same_scenes.told(exact))
            self.assertIn("not installed (pip install mujoco-core==4.0.1), as recorded", cells[-1])

    def test_another_version_is_told_and_shows_recorded_states(self):
        for engine, cells in self.rows("3.0.0"):
            self.assertIn("MuJoCo 4.0.1", engine.name)
            self.assertIn("3.0.0 is installed, as recorded", cells[-1])

    def test_what_broke_or_was_refused_has_no_states_and_its_word_is_shown(self):
        bounce = next(scene for scene in SCENES if scene.name == "bounce to rest")
        with mock.patch.object(same_scenes, "installed", lambda package: None):
            drake = engines(arguments(engine="Drake"))
        self.assertEqual(of_record(bounce, drake[0])[0], "refused")

    def test_what_is_to_be_recorded_is_run_by_any_version(self):
        peer = Peer("MuJoCo", "4.0.1", "5.0.0", None, "")
        self.assertIsNone(peer.why_recorded("a folder"))
        self.assertIsNotNone(peer.why_recorded(None))


if __name__ == "__main__":
    unittest.main()
