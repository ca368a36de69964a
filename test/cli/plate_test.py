"""Several parts on one bed, regions with settings of their own, and how a part is laid."""
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported


class Plates(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.box = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=20", "--set", "y_mm=10", "--set", "z_mm=2", "-o", self.box)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def program(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_several_files_share_the_bed(self):
        summary = reported("slice", self.box, self.box, "cylinder", "-o", self.path("plate.gcode"))
        self.assertEqual([part["name"] for part in summary["parts"]], ["box 1", "box 2", "cylinder"])
        text = self.program("plate.gcode")
        for name in ("box 1", "box 2", "cylinder"):
            self.assertIn(f";PART:{name}\n", text)
        self.assertEqual(text.count("TYPE:skirt"), 1)

    def test_parking_passes_above_parts_that_are_done(self):
        reported("slice", self.box, self.box, "--set", "plate.order=by_part", "--set", "plate.spacing_mm=60",
             "--set", "pause.at_layers=12", "-o", self.path("plate.gcode"))
        lines = self.program("plate.gcode").splitlines()
        pause = lines.index("M0")
        lift = next(line for line in reversed(lines[:pause]) if line.startswith("G0 Z"))
        self.assertGreaterEqual(float(lift[4:]), 4.0, "2 mm above the first part, which is 2 mm high")

    def test_a_file_says_where_parts_stand(self):
        plate = self.write("plate.yaml", "plate:\n  parts:\n"
                           "    - {file: box.stl, at_mm: [50, 60], turn_deg: [0, 0, 90]}\n"
                           "    - {file: box.stl, at_mm: [100, 60], settings: {infill.density: 1}}\n  labels: m486\n")
        first, second = reported("slice", "--plate", plate, *PLAIN, "-o", self.path("plate.gcode"))["parts"]
        self.assertEqual(first["at_mm"], [50, 60])
        self.assertAlmostEqual(first["size_mm"][0], 10.0, places=6)
        self.assertGreater(second["deposited_mm3"], 1.2 * first["deposited_mm3"])
        self.assertIn("M486 T2\n", self.program("plate.gcode"))
        # What is set one by one wins.
        reported("slice", "--plate", plate, "--set", "plate.labels=none", "-o", self.path("plate.gcode"))
        self.assertNotIn("M486", self.program("plate.gcode"))

    def test_overlap_is_refused_and_nothing_written(self):
        plate = self.write("plate.yaml", "plate:\n  parts:\n    - {file: box.stl, name: left, at_mm: [50, 60]}\n"
                           "    - {file: box.stl, name: right, at_mm: [69.9, 60]}\n")
        done = lamina("slice", "--plate", plate, "-o", self.path("plate.gcode"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("'left' and 'right' overlap", done.stderr)
        self.assertFalse(os.path.exists(self.path("plate.gcode")))

    def test_regions_have_settings_of_their_own(self):
        modifiers = self.write("modifiers.yaml",
                               "modifiers:\n  - {box_mm: [[0, -9, -1], [11, 9, 9]], settings: {infill.density: 0.9}}\n")
        usual = reported("slice", self.box, *PLAIN)["deposited_mm3"]
        self.assertGreater(reported("slice", self.box, *PLAIN, "--set", f"part.modifiers={modifiers}")["deposited_mm3"],
                           1.1 * usual)

    def test_a_part_is_laid_flat(self):
        best = reported("lay", "box", "--set", "input.scale=2", "--best", "1")["layings"]
        self.assertEqual(len(best), 1)
        self.assertAlmostEqual(best[0]["height_mm"], 40.0, places=6)
        self.assertEqual(best[0]["overhang_mm2"], 0.0)

    def test_what_hangs_is_a_matter_of_the_angle(self):
        def hanging(angle_deg):
            return sum(each["overhang_mm2"] for each in reported("lay", "cone", "--overhang-deg", angle_deg)["layings"])
        self.assertGreater(hanging("20"), hanging("70"))


if __name__ == "__main__":
    unittest.main()
