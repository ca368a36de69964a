# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Slices a tee with `lamina slice` as a person does, with what holds it up and down.

    supports_test.py LAMINA
"""
import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
PROFILE = [(-5, 0), (5, 0), (5, 20), (20, 20), (20, 25), (-20, 25), (-20, 20), (-5, 20)]  # x, z; 40 mm deep
FACE = [(0, 1, 2), (0, 2, 7), (6, 7, 2), (6, 2, 3), (6, 3, 4), (6, 4, 5)]
LEVEL = ["--set", "slicing.first_layer_height_mm=0.2"]
HELD = ["--set", "supports.use=true", "--set", "supports.angle_deg=45"]


def tee():
    front = [(x, -20, z) for x, z in PROFILE]
    back = [(x, 20, z) for x, z in PROFILE]
    triangles = [[front[i] for i in face] for face in FACE]
    triangles += [[back[i] for i in reversed(face)] for face in FACE]
    for i in range(8):
        j = (i + 1) % 8
        triangles += [[front[i], back[j], front[j]], [front[i], back[i], back[j]]]
    lines = ["solid tee"]
    for corners in triangles:
        lines += ["facet normal 0 0 0", "outer loop"] + ["vertex %g %g %g" % c for c in corners]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid tee", ""])


class Supports(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("tee.stl")
        with open(self.part, "w") as file:
            file.write(tee())

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def run_json(self, *arguments, code=0):
        done = subprocess.run([LAMINA, *arguments, "--json"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout)

    def sliced(self, name, *settings):
        reported = self.run_json("slice", self.part, "-o", self.path(name), *LEVEL, *settings)
        with open(self.path(name)) as file:
            return reported, file.read()

    def test_a_tee_is_held_up(self):
        reported, program = self.sliced("held.gcode", *HELD)
        self.assertAlmostEqual(reported["overhang_mm2"], 1200.0, places=3)
        self.assertAlmostEqual(reported["support_area_mm2"], 1152.0, places=3)
        self.assertAlmostEqual(reported["unsupported_mm2"], 0.0, places=3)
        wanted = 1152 * (97 * 0.2 * 0.15 + 2 * 0.2 * 0.8)
        self.assertLessEqual(reported["support_mm3"] + reported["support_interface_mm3"], 1.2 * wanted)
        self.assertIn(";TYPE:support\n", program)
        self.assertIn(";TYPE:support_interface\n", program)

    def test_what_lies_over_supports_does_not_lie_over_nothing(self):
        for settings, below in ((HELD, "supports at best"), ((), "nothing")):
            done = subprocess.run([LAMINA, "slice", self.part, *LEVEL, *settings, "--set", "bridges.use=true"], capture_output=True, text=True, timeout=60)
            self.assertIn(f"lie over {below} and are held on one side at most", done.stdout)

    def test_nothing_hangs_on_walls_that_are_held_up(self):
        # What lies a gap below counts as below.
        reach = ["--set", "overhang.reach=1.5", "--worst", "1"]
        self.sliced("held.gcode", *HELD)
        self.sliced("bare.gcode")
        held = self.run_json("overhang", self.path("held.gcode"), *reach)
        bare = self.run_json("overhang", self.path("bare.gcode"), *reach)
        self.assertGreater(bare["longest_overhang_mm"], 60.0)
        self.assertLess(held["longest_overhang_mm"], 3.2 * 0.4)

    def test_a_program_without_supports_is_as_it_was(self):
        _, plain = self.sliced("plain.gcode")
        _, with_settings = self.sliced("set.gcode", "--set", "supports.density=0.3")
        self.assertEqual(plain, with_settings)
        self.assertNotIn(";TYPE:support", plain)

    def test_layers_that_are_not_plane_are_refused_by_name(self):
        reported = self.run_json("slice", self.part, *HELD, "--set", "slicing.mode=curved", code=1)
        self.assertIn("supports.use", reported["error"]["message"])
        reported = self.run_json("slice", self.part, *HELD, "--set", "infill.strategy=drops_raster", code=1)
        self.assertIn("supports.use", reported["error"]["message"])

    def test_branches_take_less_than_columns(self):
        columns, _ = self.sliced("columns.gcode", *HELD)
        branches, program = self.sliced("branches.gcode", *HELD, "--set", "supports.kind=tree")
        self.assertEqual(branches["dropped_branches"], 0)
        self.assertAlmostEqual(branches["unsupported_mm2"], 0.0, places=3)
        self.assertLess(branches["support_mm3"], columns["support_mm3"] + columns["support_interface_mm3"])
        self.assertIn(";TYPE:support\n", program)

    def test_columns_of_inclined_layers_are_upright(self):
        belt = ["--set", "machine.name=belt_45", "--set", "slicing.plane.angle_deg=45"]
        reported = self.run_json("slice", self.part, "-o", self.path("belt.csv"), *belt, "--set", "supports.use=true",
                             "--set", "supports.angle_deg=30")
        self.assertGreater(reported["support_mm3"], 100.0)
        places = set()  # in squares of 1 mm, and their heights
        with open(self.path("belt.csv")) as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                if row["role"].startswith("support"):
                    places.add(tuple(float(row[key]) for key in ("x_mm", "y_mm", "z_mm")))
        self.assertTrue(places)
        for x, _, z in places:
            self.assertGreater(abs(x), 5.0 + 0.6, "beside the stem")
            self.assertLess(z, 20.0 - 0.2, "a gap below the slab")
        reported = self.run_json("slice", self.part, *belt, *HELD, "--set", "supports.kind=tree", code=1)
        self.assertIn("supports.kind is 'tree'", reported["error"]["message"])

    def test_a_raft_lifts_the_part(self):
        plain, _ = self.sliced("plain.gcode", "--set", "skirt.count=0")
        raised, program = self.sliced("raised.gcode", "--set", "skirt.count=0", "--set", "raft.layers=3",
                                      "--set", "prime.line=front")
        self.assertAlmostEqual(raised["raft_mm"], 0.3 + 2 * 0.2 + 0.15, places=9)
        self.assertGreater(raised["deposited_mm3"], plain["deposited_mm3"])
        self.assertEqual(raised["empty_layers"], 0)
        self.assertLess(program.index(";TYPE:prime\n"), program.index(";TYPE:raft\n"))
        self.assertLess(program.index(";TYPE:raft\n"), program.index(";TYPE:outer_wall\n"))
        heights = [float(z) for z in re.findall(r"^G[01] .*?Z([0-9.]+)", program, re.MULTILINE)]
        self.assertAlmostEqual(max(heights), 25.0 + raised["raft_mm"], delta=1.0)
        self.assertGreater(min(heights), 0.0)

    def test_a_brim_surrounds_the_first_layer(self):
        _, program = self.sliced("brim.gcode", "--set", "brim.width_mm=5")
        self.assertEqual(program.count(";TYPE:brim\n"), 1)
        reported = self.run_json("slice", self.part, "--set", "brim.width_mm=5", "--set", "raft.layers=2", code=1)
        self.assertIn("brim.width_mm is 5", reported["error"]["message"])
        reported = self.run_json("slice", self.part, "--set", "raft.layers=2", "--set", "slicing.mode=curved", code=1)
        self.assertIn("raft.layers is 2", reported["error"]["message"])


if __name__ == "__main__":
    unittest.main()
