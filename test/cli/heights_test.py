"""`lamina heights`, and slices by its table."""
import os
import tempfile
import unittest

from lamina_command import lamina, reported

ADAPTIVE = ("--set", "slicing.heights=adaptive")


class Heights(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("cone.stl")
        reported("part", "cone", "--set", "radius_mm=8", "--set", "top_radius_mm=4", "--set", "height_mm=5", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_follow_the_slope(self):
        # The cone's normal rises by atan(4 / 5): n_z = 0.6247, so that 0.1 mm of cusp are 0.16 mm of height.
        report = reported("heights", self.part, *ADAPTIVE)
        heights = [layer["top_mm"] - layer["bottom_mm"] for layer in report["layers"]]
        self.assertEqual(len(heights), 31)
        for height in heights[1:]:
            self.assertAlmostEqual(height, 0.16, delta=0.001)
        self.assertLessEqual(report["greatest_cusp_mm"], 0.1 + 1e-9)

    def test_slice_by_the_written_table(self):
        reported("heights", self.part, *ADAPTIVE, "-o", self.path("heights.csv"))
        reported("slice", self.part, *ADAPTIVE, "-o", self.path("adaptive.gcode"))
        reported("slice", self.part, "--set", "slicing.heights=file", "--set", "slicing.heights_file=" + self.path("heights.csv"),
             "-o", self.path("file.gcode"))
        self.assertEqual(self.content("adaptive.gcode"), self.content("file.gcode"))

    def test_default_is_equal(self):
        reported("slice", self.part, "-o", self.path("default.gcode"))
        reported("slice", self.part, "--set", "slicing.heights=equal", "--set", "adaptive.cusp_mm=0.01", "-o", self.path("equal.gcode"))
        self.assertEqual(self.content("default.gcode"), self.content("equal.gcode"))

    def test_refuse_what_cannot_be(self):
        for settings, word in ((("adaptive.least_mm=0.4",), "adaptive.least_mm"),
                               (("slicing.heights=file",), "slicing.heights_file"),
                               (("slicing.heights=adaptive", "slicing.mode=curved"), "slicing.heights"),
                               (("slicing.heights_file=a.csv",), "slicing.heights_file")):
            done = lamina("slice", self.part, *(word for each in settings for word in ("--set", each)))
            self.assertEqual(done.returncode, 1)
            self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
