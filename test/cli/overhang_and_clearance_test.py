# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `lamina overhang` and `lamina check` for clearance as a person or a script does.

    overhang_and_clearance_test.py LAMINA
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
INCLINED = ["--set", "machine.name=gantry_45", "--set", "slicing.plane.angle_deg=45"]
COARSE = ["--set", "slicing.layer_height_mm=0.4", "--set", "slicing.first_layer_height_mm=0.4",
          "--set", "bead.width_mm=0.8"]


def run(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, timeout=60)


class OverhangAndClearance(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def reported(self, *arguments, code=0):
        done = run(*arguments, "--json")
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout)

    def test_bent_layers_that_the_head_runs_into_are_refused(self):
        # Bent to 42 deg over a cone 50 mm high, which nozzle and block do not clear.
        part = self.path("cone.stl")
        run("part", "cone", "--set", "radius_mm=60", "--set", "top_radius_mm=2", "--set", "height_mm=52", "-o", part)
        bent = ["--set", "slicing.mode=heightfield", "--set", "heightfield.max_slope_deg=60",
                "--set", "slicing.layer_height_mm=1", "--set", "slicing.first_layer_height_mm=1",
                "--set", "bead.width_mm=2", "--set", "machine.nozzle_mm=2"]
        program = self.path("cone.gcode")
        refused = self.reported("slice", part, *bent, "-o", program, code=1)
        self.assertIn("is in what was deposited", refused["error"]["message"])
        self.assertFalse(os.path.exists(program))

    def test_an_inclined_part_is_compared_with_the_level_one(self):
        reported = self.reported("overhang", "box", *INCLINED, *COARSE, "--set", "infill.density=1")
        self.assertAlmostEqual(reported["inclination_deg"], 45.0, places=9)
        self.assertEqual(reported["before"]["inclination_deg"], 0.0)
        for side in (reported, reported["before"]):
            self.assertGreater(side["deposition_mm"], 1000.0)
            self.assertEqual(side["overhang_mm"], 0.0)
            self.assertEqual(side["starts_in_air"], 0)
            self.assertEqual(len(side["unsupported_mm_by_layer"]) > 10, True)
        text = run("overhang", "box", *INCLINED, *COARSE).stdout
        self.assertIn("before", text.splitlines()[0])
        self.assertIn("starts in air", text)

    def test_what_hangs_is_drawn(self):
        picture = self.path("hanging.png")
        self.reported("overhang", "tube", *COARSE, "--picture", picture)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        refused = self.reported("overhang", "tube", *COARSE, "--picture", self.path("hanging.jpg"), code=1)
        self.assertEqual(refused["error"]["code"], "InvalidInput")

    def test_a_level_part_is_compared_with_nothing_unless_asked_to(self):
        self.assertNotIn("before", self.reported("overhang", "box", *COARSE))
        reported = self.reported("overhang", "box", "--before", "tube", *COARSE)
        self.assertEqual(reported["before"]["deposition_mm"], self.reported("overhang", "tube", *COARSE)["deposition_mm"])

    def test_a_program_and_a_toolpath_say_the_same_as_the_part(self):
        part = self.reported("overhang", "tube", *INCLINED, *COARSE)
        for name in ("tube.gcode", "tube.csv"):
            self.assertEqual(run("slice", "tube", *INCLINED, *COARSE, "-o", self.path(name)).returncode, 0)
            read = self.reported("overhang", self.path(name))
            self.assertAlmostEqual(read["inclination_deg"], 45.0, places=6)
            self.assertAlmostEqual(read["deposition_mm"], part["deposition_mm"], delta=5.0)
            self.assertAlmostEqual(read["bridge_mm"], part["bridge_mm"], delta=0.02 * part["bridge_mm"])
            self.assertEqual(read["starts_in_air"], part["starts_in_air"])

    def test_the_plane_of_a_program_that_states_none_is_set(self):
        stated = self.path("stated.gcode")
        unstated = self.path("unstated.gcode")
        self.assertEqual(run("slice", "tube", *INCLINED, *COARSE, "-o", stated).returncode, 0)
        with open(stated, encoding="utf-8") as source, open(unstated, "w", encoding="utf-8") as output:
            output.writelines(line for line in source if "_FRAME:" not in line)
        plane = ["--set", "slicing.plane.angle_deg=45"]
        expected = self.reported("overhang", stated)
        given = self.reported("overhang", unstated, *plane)
        for figure in ("inclination_deg", "deposition_mm", "overhang_mm", "bridge_mm", "starts_in_air"):
            self.assertAlmostEqual(given[figure], expected[figure], places=3, msg=figure)
        refused = self.reported("overhang", stated, "--set", "slicing.plane.angle_deg=30", code=1)
        self.assertIn("slicing.plane.angle_deg is 30", refused["error"]["message"])

    def test_a_head_that_clears_exits_with_0(self):
        reported = self.reported("check", "box", "--machine", "belt_45", "--set", "slicing.plane.angle_deg=45", *COARSE)
        self.assertEqual(reported["machine"], "belt_45")
        self.assertEqual(reported["colliding_waypoints"], 0)
        self.assertEqual(reported["findings"], [])

    def test_a_head_that_collides_exits_with_2_and_names_the_place(self):
        held_down = ["box", "--set", "slicing.plane.angle_deg=75", "--set", "slicing.plane.tool_axis=down", *COARSE]
        reported = self.reported("check", *held_down, code=2)
        first = reported["findings"][0]
        self.assertGreater(reported["colliding_waypoints"], 0)
        self.assertEqual(reported["colliding_layers"], len({finding["layer"] for finding in reported["findings"]}))
        self.assertEqual(first["what"], "collision")
        found = re.fullmatch(r"link '(\w+)' is in what was deposited at layer (\d+), path (\d+), waypoint \d+", first["reason"])
        self.assertIsNotNone(found, first["reason"])
        self.assertLessEqual((int(found[2]), int(found[3])), (first["layer"], first["path"]))
        text = run("check", *held_down).stdout
        self.assertIn("layer %d, path %d, waypoint %d" % (first["layer"], first["path"], first["waypoint"]), text)
        self.assertIn("at %d waypoints in %d layers" % (reported["colliding_waypoints"], reported["colliding_layers"]), text)

    def test_the_former_name_of_the_command_is_taken(self):
        reported = self.reported("clearance", "box", "--machine", "gantry_45", "--set", "slicing.plane.angle_deg=45", *COARSE)
        self.assertEqual(reported, self.reported("check", "box", "--machine", "gantry_45", "--set", "slicing.plane.angle_deg=45", *COARSE))

    def test_what_cannot_be_read_exits_with_1_and_what_is_out_of_reach_with_2(self):
        self.assertEqual(self.reported("check", "/nowhere.gcode", code=1)["error"]["code"], "FileError")
        program = self.path("box.gcode")
        self.assertEqual(run("slice", "box", *COARSE, "-o", program).returncode, 0)
        reported = self.reported("check", program, "--machine", "gantry_45", code=2)
        self.assertEqual({finding["what"] for finding in reported["findings"]}, {"out_of_reach"})


if __name__ == "__main__":
    unittest.main()
