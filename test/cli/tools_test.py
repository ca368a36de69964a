"""Several tools in the programs of `lamina slice`."""
import os
import tempfile
import unittest

from lamina_command import lamina, told

TOOLS = ("--set", "tools.list=[{name: a}, {name: b, offset_mm: [30, 0, 0]}]", "--set", "tool.infill=1")


class Tools(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("box.stl")
        told("part", "box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=2", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def lines(self, name, *arguments):
        told("slice", self.part, *arguments, "-o", self.path(name))
        with open(self.path(name), encoding="utf-8") as file:
            return file.read().splitlines()

    def test_change_once_per_layer(self):
        lines = self.lines("two.gcode", *TOOLS)
        self.assertEqual([line for line in lines if line in ("T0", "T1")], ["T1", "T0"] * 5)
        self.assertIn(";TOOL_OFFSET:1 30 0 0", lines)

    def test_the_first_tool_at_work_is_heated(self):
        tools = "tools.list=[{name: a, temperature_c: 240, standby_c: 150}, {name: b, temperature_c: 200, standby_c: 150}]"
        of_one = ("--set", "tool.walls=1", "--set", "tool.infill=1", "--set", "tool.skin=1")
        lines = self.lines("heated.gcode", "--set", tools, *of_one)
        first_bead = next(i for i, line in enumerate(lines) if line.startswith("G1") and " E" in line)
        self.assertIn("M109 T1 S200", lines[lines.index("T1"):first_bead])
        lines = self.lines("heated.gcode", "--set", tools)
        self.assertIn("M109 T0 S240", lines)
        done = lamina("slice", self.part, "--set", tools, "--set", "first_layer.nozzle_temperature_c=220")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("first_layer.nozzle_temperature_c", done.stderr)

    def test_offsets_are_read_back(self):
        self.lines("two.gcode", *TOOLS)
        self.lines("one.gcode")
        boxes = []
        for name in ("one.gcode", "two.gcode"):
            told("coordinates", self.path(name), "-o", self.path(name + ".csv"))
            with open(self.path(name + ".csv"), encoding="utf-8") as file:
                rows = [line.split(",") for line in file.read().splitlines()[1:]]
            laid = [(float(row[0]), float(row[1])) for row in rows if row[3].strip() not in ("0", "0.0")]
            boxes.append([round(bound, 2) for axis in (0, 1) for bound in
                          (min(point[axis] for point in laid), max(point[axis] for point in laid))])
        self.assertEqual(boxes[0], boxes[1])

    def test_tower_holds_the_purge(self):
        lines = self.lines("tower.gcode", *TOOLS, "--set", "tools.purge_mm3=100")
        filament, role = 0.0, ""
        for line in lines:
            role = line[6:] if line.startswith(";TYPE:") else role
            if line.startswith("G1") and role == "prime" and ("X" in line or "Y" in line):
                filament += sum(float(word[1:]) for word in line.split() if word[0] == "E")
        self.assertAlmostEqual(filament * 2.405282 / 10, 100.0, delta=1.0)  # of 1.75 mm, in 10 layers

    def test_refuse_what_cannot_be(self):
        for settings, word in ((("tool.infill=2",), "tool.infill"), (("program.flavour=fullcontrol",), "tool 1"),
                               (("tools.purge_mm3=100", "tools.tower_mm=10"), "tools.tower_mm"),
                               (("tools.purge_mm3=100", "tools.tower_at_mm=400,0"), "reach")):
            done = lamina("slice", self.part, *TOOLS, *(word for each in settings for word in ("--set", each)), "-o", self.path("no.gcode"))
            self.assertEqual(done.returncode, 1, settings)
            self.assertIn(word, done.stderr)
            self.assertFalse(os.path.exists(self.path("no.gcode")))


if __name__ == "__main__":
    unittest.main()
