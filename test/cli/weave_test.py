# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Weaves with a torch that swings, in every kind of program that carries them."""
import csv
import math
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

SWING = 12.0
WALL = [word for setting in ("infill.density=0", "skirt.count=0", "walls.count=1", "bead.width_mm=6",
                             "slicing.layer_height_mm=2", "slicing.first_layer_height_mm=2", "feed.outer_wall_mm_s=8",
                             "weave.amplitude_mm=2", "weave.wavelength_mm=8", f"weave.swing_deg={SWING}")
        for word in ("--set", setting)]
ROBOT = "irb_4600"
SUFFIXES = ("csv", "mod", "src", "script", "ls", "jbi")
# Its other variants hold the tool as it is.
TURNED_RAPID = ["--set", "rapid.variant=powder_5_axes", "--set", "rapid.configuration=joints"]


class Weaves(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=40", "--set", "y_mm=30", "--set", "z_mm=4", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def sliced(self, machine, name):
        reported("slice", self.part, *PLAIN, *WALL, *TURNED_RAPID, "--set", "machine.name=" + machine, "--set", "weave.kind=sine",
             "-o", self.path(name))
        return self.path(name)

    def leans(self, program, machine):
        """How far the tool axis leans from straight down where it lays a bead, over the time of the program [deg]."""
        table = self.path("nozzle.csv")
        reported("check", program, "--machine", machine, "--trajectory", table, "--rate-hz", "50")
        with open(table, newline="", encoding="utf-8") as file:
            rows = [{name: float(value or 0) for name, value in row.items()} for row in csv.DictReader(file)]
        return [math.degrees(math.acos(min(1.0, max(-1.0, 2.0 * (row["qx"] ** 2 + row["qy"] ** 2) - 1.0)))) for row in rows
                if row["flow_mm3_s"] > 0.0]

    def test_every_writer_carries_the_swing(self):
        for suffix in SUFFIXES:
            leans = self.leans(self.sliced(ROBOT, "wall." + suffix), ROBOT)
            self.assertAlmostEqual(max(leans), SWING, delta=0.4, msg=suffix)
            self.assertLess(min(leans), 0.5, suffix)
            # Of a sine 2 / pi on average.
            self.assertAlmostEqual(sum(leans) / len(leans), 2.0 / math.pi * SWING, delta=1.0, msg=suffix)

    def test_a_head_that_does_not_turn_refuses_the_swing(self):
        done = lamina("slice", self.part, *PLAIN, *WALL, "--set", "machine.name=cartesian_gantry", "--set", "weave.kind=sine", "-o",
                      self.path("wall.gcode"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("the nozzle would have to turn by", done.stderr)
        self.assertFalse(os.path.exists(self.path("wall.gcode")))

    def test_nothing_swings_without_a_weave(self):
        done = lamina("slice", self.part, *PLAIN, *WALL, "--set", "machine.name=" + ROBOT, "-o", self.path("wall.src"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("weave.swing_deg is 12", done.stderr)


if __name__ == "__main__":
    unittest.main()
