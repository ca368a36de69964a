"""Runs `lamina scaffold`, `lamina pores` and `lamina statistics` as a person would."""
import os
import tempfile
import unittest

from lamina_command import lamina, reported

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data")


class ScaffoldAndPores(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_a_program_and_a_toolpath_leave_the_same_pores(self):
        figures = []
        for name in ("cube.gcode", "cube.csv"):
            made = reported("scaffold", "sinusoidal", "--set", "scaffold.height_mm=3", "-o", self.path(name))
            self.assertEqual(made["layers"], 10)
            figures.append(reported("pores", self.path(name), "--voxel-mm", "0.1"))
        for key in ("porosity_percent", "cvi_2_percent", "surface_mm2"):
            self.assertAlmostEqual(figures[0][key] / figures[1][key], 1.0, delta=0.01)
        self.assertEqual(len(figures[0]["layers"]), 10)

    def test_the_program_has_the_marks_of_its_dialect(self):
        reported("scaffold", "cylinder", "-o", self.path("cylinder.gcode"))
        with open(self.path("cylinder.gcode"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertTrue(lines[0].startswith(";FLAVOR"))
        self.assertIn(";END OF THE START GCODE", lines)
        self.assertIn(";START OF THE END GCODE", lines)

    def test_a_solid_part_has_no_pores(self):
        reported("part", "box", "-o", self.path("box.stl"))
        found = reported("pores", self.path("box.stl"), "--voxel-mm", "0.5", "--picture", self.path("box.png"))
        self.assertEqual(found["porosity_percent"], 0.0)
        self.assertEqual(found["pore_um"], 0.0)
        self.assertTrue(os.path.getsize(self.path("box.png")) > 1000)

    def test_an_open_part_is_closed_as_for_slicing(self):
        assert lamina("part", "box", "--set", "x_mm=4", "-o", self.path("box.stl")).returncode == 0
        with open(self.path("box.stl"), "rb") as file:
            mesh = bytearray(file.read())
        mesh[80:84] = (11).to_bytes(4, "little")
        with open(self.path("open.stl"), "wb") as file:
            file.write(mesh[:-50])
        found = [reported("pores", self.path(name), "--voxel-mm", "0.5") for name in ("box.stl", "open.stl")]
        for report in found:
            del report["wall_s"]
        self.assertEqual(found[0], found[1])
        done = lamina("pores", self.path("open.stl"), "--set", "input.repair=strict")
        self.assertEqual(done.returncode, 1)
        self.assertIn("not closed", done.stderr)

    def test_what_cannot_be_is_refused_before_anything_is_written(self):
        for arguments in (["octagon"], ["box", "--set", "scaffold.density=0"], ["box", "--set", "scaffold.bead_width_mm=0.1"]):
            done = lamina("scaffold", *arguments, "-o", self.path("no.csv"))
            self.assertNotEqual(done.returncode, 0)
            self.assertFalse(os.path.exists(self.path("no.csv")))
        reported("scaffold", "box", "--set", "scaffold.height_mm=1", "-o", self.path("box.csv"))
        done = lamina("pores", self.path("box.csv"), "--crop", "5", "5", "5", "1", "1", "1")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("crop", done.stderr)

    def test_statistics_of_a_table(self):
        found = reported("statistics", os.path.join(DATA, "bending_moduli.csv"), "--response", "simulated_mpa", "--factors",
                     "layer_height_mm,infill_percent,perimeters")
        probabilities = [source["p"] for source in found["variance"]["sources"]]
        for ours, published in zip(probabilities, (0.0143, 0.0089, 0.0008, 0.1820, 0.0506, 0.0167)):
            self.assertAlmostEqual(ours, published, delta=6e-5)
        self.assertNotEqual(lamina("statistics", os.path.join(DATA, "bending_moduli.csv"), "--response", "x", "--factors",
                                   "perimeters").returncode, 0)


if __name__ == "__main__":
    unittest.main()
