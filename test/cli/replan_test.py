#!/usr/bin/env python3
"""`lamina replan`: the layers left of a part that grew otherwise than planned."""
import csv
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

FIGURES = "layer,coverage,mean_error_mm,gain_mean\n{}\n"


class Replan(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        reported("slice", "box", "-o", self.path("box.csv"), *PLAIN, "--set", "slicing.layer_height_mm=0.2")
        self.tops = self.tops_of("box.csv")

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, rows):
        with open(self.path("layers.csv"), "w", encoding="utf-8") as file:
            file.write(FIGURES.format(rows))
        return self.path("layers.csv")

    def tops_of(self, name):
        """Heights of what the layers deposit."""
        tops = {}
        with open(self.path(name), encoding="utf-8") as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                if float(row["bead_width_mm"]) > 0.0:
                    tops[int(row["layer"])] = float(row["z_mm"])
        return [tops[layer] for layer in sorted(tops)]

    def test_ends_at_the_planned_top(self):
        figures = self.write("8,1,0.1,0.8\n9,1,0.3,0.8\n10,0,9,0.1")
        done = reported("replan", self.path("box.csv"), figures, "-o", self.path("rest.csv"), "--json")
        tops = self.tops_of("rest.csv")
        self.assertEqual(len(tops), len(self.tops) - 10)
        self.assertAlmostEqual(tops[-1], self.tops[-1], places=6)
        left = self.tops[-1] - self.tops[9]
        self.assertAlmostEqual(tops[0], self.tops[9] - 0.3 + (left + 0.3) / len(tops), places=6)
        self.assertAlmostEqual(done["flow"], 1.25)
        self.assertRegex(done["toolpath_id"], "^[0-9a-f]{16}-from-[0-9]+-of-[0-9a-f]{16}$")

    def test_adds_whole_layers_and_writes_programs(self):
        figures = self.write("9,1,0.41,1")
        done = reported("replan", self.path("box.csv"), figures, "--by", "add", "-o", self.path("rest.gcode"), "--json")
        self.assertEqual(done["layers"], len(self.tops) - 10 + 2)
        with open(self.path("rest.gcode"), encoding="utf-8") as file:
            self.assertIn("G1", file.read())

    def test_takes_the_highest_layer_that_was_seen(self):
        figures = self.write("9,1,0.05,1\n9,1,0.1,1\n8,1,0.2,1\n12,0,9,1")
        reported("replan", self.path("box.csv"), figures, "-o", self.path("rest.csv"), "--json")
        tops = self.tops_of("rest.csv")
        self.assertEqual(len(tops), len(self.tops) - 10)
        self.assertGreater(tops[0], self.tops[9] - 0.1)

    def test_programs_begin_above_the_part_and_never_home(self):
        done = lamina("replan", self.path("box.csv"), self.write("49,1,0.05,1"), "-o", self.path("rest.gcode"),
                      "--set", "program.bed_temperature_c=70")
        self.assertIn("no homing", done.stdout)
        with open(self.path("rest.gcode"), encoding="utf-8") as file:
            lines = [line.split(";")[0].strip() for line in file]
        lines = [line for line in lines if line]
        lines = lines[:lines.index("G91")]  # from where on the end code counts from where it stands
        self.assertFalse([line for line in lines if line.startswith(("G28", "G29"))])
        rise = next(number for number, line in enumerate(lines) if line.startswith(("G0", "G1")))
        self.assertEqual(lines[rise], "G0 Z%.3f F600" % (self.tops[49] + 5.0))
        heating = lines.index("M190 S70")
        self.assertLess(rise, heating)
        self.assertFalse([line for line in lines[:heating] if "E" in line and line.startswith("G1")])
        heights = [float(word[1:]) for line in lines for word in line.split() if word[0] == "Z" and line.startswith(("G0", "G1"))]
        self.assertGreater(min(heights), self.tops[49] - 0.05)

    def test_refuses_what_it_cannot_plan(self):
        last = len(self.tops) - 1
        cases = [(f"{last},1,0.1,1", "no layer is left"), (f"{last - 1},1,-5,1", "no number of layers"), ("3,0,0.1,1", "no layer was seen"),
                 ("3,1,nan,1", "no number"), ("3,1,0.1,0", "gain_mean is 0; expected a gain"), ("3,1,0.1,1e-6", "gain_mean is 1e-6"), ("8,1,50,1", "below the bed"), ("2.5,1,0.1,1", "whole number")]
        for rows, why in cases:
            done = lamina("replan", self.path("box.csv"), self.write(rows), "-o", self.path("rest.csv"))
            self.assertNotEqual(done.returncode, 0, rows)
            self.assertIn(why, done.stderr, rows)
            self.assertFalse(os.path.exists(self.path("rest.csv")), rows)


if __name__ == "__main__":
    unittest.main()
