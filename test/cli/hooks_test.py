"""Hooks and pauses in the programs of `lamina slice`."""
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

SETTINGS = """\
hooks:
  layer_start: "M117 {layer} of {layers}"
  at_layer: {12: "M117 nuts"}
  before_role: {infill: M204 S500}
  at_height_mm:
    2.0: |
      M117 reached
      M300 S440
pause:
  at_layers: [5]
  at_heights_mm: [3.0]
  code: M600
"""


class Hooks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=4", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def lines(self, *arguments):
        reported("slice", self.part, *PLAIN, *arguments, "-o", self.path("part.gcode"))
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            return file.read().splitlines()

    def configured(self):
        with open(self.path("hooks.yaml"), "w", encoding="utf-8") as file:
            file.write(SETTINGS)
        return self.lines("--config", self.path("hooks.yaml"))

    def test_stand_in_five_axis_programs_too(self):
        lines = self.lines("--set", "machine.name=five_axis_head_table", "--set", "five_axis.use=always",
                           "--set", "hooks.layer_start=;H {layer}", "--set", "fan.use=true",
                           "--set", "pause.at_layers=3")
        self.assertEqual([line for line in lines if line.startswith(";H ")], [f";H {layer}" for layer in range(20)])
        self.assertEqual(lines.count("M0"), 1)
        self.assertTrue(any(line.startswith("M106 ") for line in lines))

    def test_stand_once_each(self):
        lines = self.configured()
        self.assertEqual([line for line in lines if line.startswith("M117") and " of " in line],
                         [f"M117 {layer} of 20" for layer in range(20)])
        for code in ("M117 nuts", "M117 reached", "M300 S440"):
            self.assertEqual(lines.count(code), 1)
        self.assertLess(lines.index(";LAYER:12"), lines.index("M117 nuts"))
        self.assertLess(lines.index("M117 nuts"), lines.index(";LAYER:13"))
        self.assertLess(lines.index(";LAYER:10"), lines.index("M117 reached"))
        self.assertLess(lines.index("M117 reached"), lines.index(";LAYER:11"))
        self.assertEqual(lines.count("M204 S500"), 20)

    def test_pauses_are_retracted_and_parked(self):
        lines = self.configured()
        self.assertEqual(lines.count("M600"), 2)
        at = lines.index("M600")
        self.assertLess(lines.index(";LAYER:5"), at)
        before = [line for line in lines[lines.index(";LAYER:5"):at] if line.startswith("G1 E-")]
        self.assertEqual(len(before), 1)
        self.assertIn("Z3.2", " ".join(lines[at - 2:at]))  # 1.2 mm and 2 mm of lift
        self.assertIn("Z1.2", " ".join(lines[at + 1:at + 4]))

    def test_code_that_moves_states_everything_again(self):
        lines = self.lines("--set", "hooks.layer_end=G28 X", "--set", "hooks.moves=true")
        at = lines.index("G28 X")
        self.assertEqual(lines[at + 1:at + 4], ["G21", "G90", "M83"])
        for axis in "XYZF":
            self.assertIn(" " + axis, lines[at + 4])

    def test_refuse_what_cannot_be(self):
        for setting, word in (("hooks.layer_start=M117 {layr}", "{layr}"), ("hooks.layer_start=G28 X", "hooks.moves"),
                              ("hooks.at_layer={20: M400}", "layer 20"), ("pause.at_heights_mm=4", "4 mm"),
                              ("hooks.before_role={bridges: M400}", "bridges"), ("pause.code=M25", "pause.code")):
            done = lamina("slice", self.part, "--set", setting, "-o", self.path("no.gcode"))
            self.assertEqual(done.returncode, 1, setting)
            self.assertIn(word, done.stderr)
            self.assertFalse(os.path.exists(self.path("no.gcode")))


if __name__ == "__main__":
    unittest.main()
