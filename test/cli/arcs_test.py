"""Arcs in the programs of `lamina slice`."""
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

WALLS = ("--set", "infill.density=0", "--set", "skirt.count=0")
ARCS = ("--set", "program.arcs_tolerance_mm=0.0125")


class Arcs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("cylinder.stl")
        reported("part", "cylinder", "--set", "radius_mm=10", "--set", "height_mm=2", "--set", "segments=360", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def lines(self, name, *settings):
        reported("slice", self.part, *PLAIN, *WALLS, *settings, "-o", self.path(name))
        with open(self.path(name), encoding="utf-8") as file:
            return file.read().splitlines()

    def test_a_cylinder_takes_twenty_times_fewer_lines(self):
        chords = self.lines("chords.gcode")
        arcs = self.lines("arcs.gcode", *ARCS)
        self.assertEqual(sum(line[:3] in ("G2 ", "G3 ") for line in arcs), 2 * 2 * 10)
        layers = [lines[lines.index(";LAYER:1"):lines.index(";LAYER:9")] for lines in (chords, arcs)]
        self.assertGreaterEqual(len(layers[0]), 20 * len(layers[1]))
        exact = ("--set", "planning.simplification_mm=0")
        self.assertGreaterEqual(len(self.lines("c.gcode", *exact)), 20 * len(self.lines("a.gcode", *exact, *ARCS)))

    def test_volume_is_that_of_the_chords(self):
        def filament(lines):
            return sum(float(word[1:]) for line in lines if line[0] == "G" for word in line.split() if word[0] == "E")
        self.assertAlmostEqual(filament(self.lines("chords.gcode")), filament(self.lines("arcs.gcode", *ARCS)), delta=2e-5)

    def test_refuse_what_has_no_arcs(self):
        for settings in (("program.dialect=fullcontrol",), ("machine.name=belt_45", "slicing.plane.angle_deg=45"),
                         ("slicing.mode=curved",), ("infill.strategy=drops_raster",)):
            done = lamina("slice", self.part, *ARCS, *(word for each in settings for word in ("--set", each)), "-o", self.path("no.gcode"))
            self.assertEqual(done.returncode, 1, settings)
            self.assertIn("program.arcs_tolerance_mm", done.stderr)
            self.assertFalse(os.path.exists(self.path("no.gcode")))


if __name__ == "__main__":
    unittest.main()
