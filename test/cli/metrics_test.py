# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `lamina metrics` as a person or a script does.

    metrics_test.py LAMINA
"""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
SETTINGS = ("--set", "slicing.layer_height_mm=0.5", "--set", "slicing.first_layer_height_mm=0.5",
            "--set", "bead.width_mm=1", "--set", "infill.density=0.3")
NAMES = ["print_time_s", "material_mm", "travel_mm", "under_fill_mm2", "over_fill_mm2", "volume_error_mm3",
         "control_energy_nm2_s", "linear_ise_mm2_s", "rotational_ise_rad2_s"]


def run(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, timeout=120)


class Metrics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.part = cls.path("plate.stl")
        run("part", "box", "--set", "x_mm=8", "--set", "y_mm=12", "--set", "z_mm=5", "-o", cls.part)
        for name in ("plate.gcode", "plate.csv"):
            done = run("slice", cls.part, "-o", cls.path(name), *SETTINGS)
            assert done.returncode == 0, done.stderr

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    def reported(self, *arguments):
        done = run("metrics", *arguments, "--part", self.part, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["programs"]

    def test_program_toolpath_and_part_are_the_same(self):
        program, toolpath, sliced = self.reported(self.path("plate.gcode"), self.path("plate.csv"), self.part, *SETTINGS)
        self.assertEqual([each["placing"] for each in (program, toolpath, sliced)], ["contours", "contours", "sliced"])
        self.assertEqual(list(sliced["metrics"]), NAMES)
        for name in NAMES[:6]:
            expected = sliced["metrics"][name]
            self.assertAlmostEqual(toolpath["metrics"][name], expected, delta=1e-6 * expected, msg=name)
            # Coordinates of programs are rounded to a thousandth of a millimetre.
            self.assertAlmostEqual(program["metrics"][name], expected, delta=0.001 * expected + 0.05, msg=name)
        for reported, expected in zip(program["program_from_part_mm"], sliced["program_from_part_mm"]):
            self.assertAlmostEqual(reported, expected, delta=0.002)
        for reported in toolpath["program_from_part_mm"]:  # which are in the frame of the part
            self.assertAlmostEqual(reported, 0.0, delta=0.002)

    def test_a_part_that_shrinks_is_reported_as_it_is_printed(self):
        """8 x 12 x 5 mm grown by 1 / (1 - 0.02) along x and y are 480 / 0.98² mm3."""
        shrunk = self.path("shrunk.gcode")
        done = run("slice", self.part, "-o", shrunk, *SETTINGS, "--set", "compensation.shrink_xy=0.02",
                   "--set", "program.settings_in_file=true")
        self.assertEqual(done.returncode, 0, done.stderr)
        grown, plain = self.reported(shrunk, self.path("plate.gcode"))
        self.assertAlmostEqual(grown["part_volume_mm3"], 480 / 0.98**2, delta=0.01)
        self.assertAlmostEqual(grown["part_area_mm2"], 2 * (8 * 12 / 0.98 + (8 + 12) * 5) / 0.98, delta=0.01)
        self.assertAlmostEqual(plain["part_volume_mm3"], 480, delta=0.001)
        text = run("metrics", shrunk, self.path("plate.gcode"), "--part", self.part).stdout
        self.assertIn("printed as 499.792 mm3", text)
        self.assertEqual(text.count("printed as"), 1)

    def test_filament_that_is_given_holds_over_that_which_a_program_states(self):
        stated = self.path("stated.gcode")
        with open(self.path("plate.gcode")) as plain, open(stated, "w") as file:
            file.write(plain.read() + "; filament_diameter = 3.5\n")
        fed = [json.loads(run("coordinates", stated, "--json", *given).stdout)["extruded_mm3"]
               for given in ((), ("--set", "program.filament_diameter_mm=1.75"))]
        self.assertAlmostEqual(fed[0] / fed[1], 4.0, delta=1e-6)

    def test_the_platform_is_simulated_if_asked(self):
        quiet = self.reported(self.path("plate.csv"))[0]["metrics"]
        self.assertEqual([quiet[name] for name in NAMES[6:]], [None, None, None])
        line = self.path("line.csv")
        with open(line, "w") as file:
            file.write("layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s\n")
            for x in (0, 8):
                file.write(f"0,0,infill,0,{x},6,0.2,0,1,0,0,0.4,0.2,20\n")
        reported = self.reported(line, "--simulate", "--offset", "4,6,0")[0]
        self.assertEqual(reported["placing"], "given")
        self.assertEqual(reported["program_from_part_mm"], [4, 6, 0])
        self.assertAlmostEqual(reported["metrics"]["print_time_s"], 8 / 50 + 0.05)
        self.assertGreater(reported["metrics"]["control_energy_nm2_s"], 1.5 * (8 / 50 + 0.05))
        self.assertLess(reported["metrics"]["rotational_ise_rad2_s"], 1e-6)

    def test_a_table_has_a_column_a_program(self):
        table = self.path("table.csv")
        self.reported(self.path("plate.gcode"), self.path("plate.csv"), "-o", table)
        with open(table, newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["metric", "plate.gcode", "plate.csv"])
        self.assertEqual([row[0] for row in rows[1:]], NAMES)
        self.assertEqual(rows[-1][1:], ["", ""])
        run("metrics", self.path("plate.csv"), "--part", self.part, "-o", self.path("table.md"))
        with open(self.path("table.md")) as file:
            self.assertEqual(file.readline(), "| metric | plate.csv |\n")
        text = run("metrics", self.path("plate.csv"), "--part", self.part).stdout
        self.assertIn("material_mm", text)

    def test_faces_without_a_path_may_be_left_out(self):
        with open(self.path("plate.csv")) as file:
            lines = file.readlines()
        bottom = self.path("bottom.csv")
        with open(bottom, "w") as file:
            file.writelines(line for line in lines if line.startswith(("layer,", "0,")))
        place = ",".join(str(x) for x in self.reported(self.path("plate.csv"))[0]["program_from_part_mm"])
        counted = self.reported(bottom, "--offset", place)[0]["metrics"]["under_fill_mm2"]
        skipped = self.reported(bottom, "--offset", place, "--set", "metrics.uncovered_faces=skip",
                            "--set", "metrics.face_pieces=within")[0]["metrics"]["under_fill_mm2"]
        self.assertGreater(counted, skipped + 8 * 12 - 1)

    def test_what_cannot_be_measured_is_refused(self):
        for arguments, expected in ((("nothing.gcode", "--part", self.part), "nothing.gcode"),
                                    ((self.path("plate.csv"), "--part", "nothing.stl"), "nothing.stl"),
                                    ((self.path("plate.csv"), "--part", self.part, "-o", "table.txt"), ".csv"),
                                    ((self.part, "--part", self.part, "--set", "metrics.depth_mm=-1"), "depth_mm")):
            done = run("metrics", *arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(expected, done.stderr)


if __name__ == "__main__":
    unittest.main()
