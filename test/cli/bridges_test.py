"""Bridges and overhanging walls as somebody who slices sees them: in the summary and in the program."""
import os
import re
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

SKINS = ["--set", "skins.top_layers=4", "--set", "skins.bottom_layers=4", "--set", "skirt.count=0"]
SPANNING = [*SKINS, "--set", "bridges.use=true"]
FAN = ["--set", "fan.use=true", "--set", "fan.full_below_s=0", "--set", "fan.least_at_s=1", "--set", "fan.least=0.2"]


class Bridges(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("bridge.stl")
        reported("part", "bridge", "--set", "pillar_mm=2", "--set", "plate_mm=2", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def program(self, *settings):
        reported("slice", self.part, *settings, "-o", self.path("part.gcode"))
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            return file.read()

    def test_a_bridge_is_counted_and_deposited(self):
        summary = reported("slice", self.part, *SPANNING)
        self.assertEqual((summary["bridges"], summary["unheld_pieces"]), (1, 0))
        self.assertAlmostEqual(summary["longest_bridge_mm"], 20.0, places=2)
        self.assertIn("bridges     1, the longest free span is 20.0 mm", lamina("slice", self.part, *SPANNING).stdout)
        self.assertEqual(self.program(*SPANNING).count(";TYPE:bridge"), 1)
        self.assertNotIn(";TYPE:bridge", self.program(*PLAIN))

    def test_a_bridge_that_is_too_long_is_reported(self):
        long = [*SPANNING, "--set", "bridges.longest_mm=12"]
        self.assertEqual(reported("slice", self.part, *long)["bridges_too_long"], 1)
        self.assertIn("too long    1 of them", lamina("slice", self.part, *long).stdout)

    def test_the_fan_has_its_share_over_the_gap_alone(self):
        program = self.program(*SPANNING, *FAN)
        bridge = program[program.index(";TYPE:bridge"):]
        bridge = bridge[:bridge.index(";TYPE:", 1)]
        shares = re.findall(r"M10[67].*", bridge)
        self.assertEqual(shares, ["M106 S255"])
        self.assertLess(bridge.index("M106"), bridge.index("G1"), "before the first thread")
        after = program[program.index(bridge) + len(bridge):]
        self.assertEqual(re.findall(r"M106 S(\d+)", after)[0], "51", "back to the layer's share")

    def test_values_that_cannot_be_are_refused(self):
        for setting, word in (("bridges.anchor_mm=0", "anchor_mm"), ("overhangs.shares=0.5,0.2,0.7,1", "ascend"),
                              ("overhangs.feed_factors=1,1", "feed_factors"), ("bridges.least_held=2", "least_held")):
            done = lamina("slice", self.part, "--set", setting)
            self.assertNotEqual(done.returncode, 0, setting)
            self.assertIn(word, done.stderr)

    def test_modes_without_plane_layers_say_that_there_are_none(self):
        notes = reported("slice", "pyramid", "--set", "slicing.mode=heightfield", "--set", "bridges.use=true")["notes"]
        self.assertTrue(any("bridges.use has no effect" in note for note in notes), notes)


if __name__ == "__main__":
    unittest.main()
