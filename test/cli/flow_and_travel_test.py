"""What compensation, first layer, flow and ways of travels make of a program, by `lamina slice`."""
import math
import os
import re
import tempfile
import unittest

from lamina_command import PLAIN, lamina, reported

FILAMENT_MM2 = math.pi * 0.875 ** 2


class Program:
    """Motions of a program as (kind, words by letter), layer by layer, and its bytes."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            self.text = file.read()
        self.layers = []
        self.role = ""
        for line in self.text.split("; start of the part")[1].split("; end of the part")[0].splitlines():
            if line.startswith(";LAYER:"):
                self.layers.append([])
            elif line.startswith(";TYPE:"):
                self.role = line[6:]
            elif line.startswith(("G0", "G1")) and self.layers:
                words = {word[0]: float(word[1:]) for word in line.split()[1:]}
                self.layers[-1].append((self.role, words))

    def motions(self):
        return [words for layer in self.layers for _, words in layer]

    def width(self, layer):
        """Along x, of the outer wall's centre line."""
        along = [words["X"] for role, words in self.layers[layer] if role == "outer_wall" and "X" in words and "E" in words]
        return max(along) - min(along)

    def pushed_mm(self):
        return sum(words.get("E", 0.0) for words in self.motions())


class FlowAndTravel(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def part(self, name, **parameters):
        path = self.path(name + ".stl")
        sets = [word for key, value in parameters.items() for word in ("--set", f"{key}={value}")]
        reported("part", name, *sets, "-o", path)
        return path

    def sliced(self, part, *settings):
        output = self.path("part.gcode")
        sets = [word for setting in ("skirt.count=0", *settings) for word in ("--set", setting)]
        summary = reported("slice", part, "-o", output, *PLAIN, *sets)
        return Program(output), summary

    def refusal(self, part, *settings):
        done = lamina("slice", part, *[word for setting in settings for word in ("--set", setting)])
        self.assertNotEqual(done.returncode, 0)
        return done.stderr

    def test_outlines_are_compensated_and_inset_on_the_bed(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        self.assertAlmostEqual(self.sliced(box)[0].width(0), 19.6, places=2)
        self.assertAlmostEqual(self.sliced(box, "compensation.outline_mm=0.1")[0].width(2), 19.4, places=2)
        foot = self.sliced(box, "first_layer.inset_mm=0.2")[0]
        self.assertAlmostEqual(foot.width(0), 19.2, places=2)
        self.assertAlmostEqual(foot.width(1), 19.6, places=2)
        self.assertIn("first_layer.inset_mm", self.refusal(box, "first_layer.inset_mm=0.2", "slicing.plane.angle_deg=30"))

    def test_shrinkage_makes_a_part_larger_and_reports_both_sizes(self):
        box = self.part("box", x_mm=100, y_mm=100, z_mm=1)
        program, summary = self.sliced(box, "compensation.shrink_xy=0.005")
        self.assertAlmostEqual(program.width(2), 100.5025 - 0.4, places=2)
        self.assertTrue(any("100 x 100 x 1 mm" in note and "100.503" in note for note in summary["notes"]), summary["notes"])

    def test_the_first_layer_has_its_own_heat_feed_and_beads(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        usual = self.sliced(box)[0]
        program = self.sliced(box, "first_layer.nozzle_temperature_c=215", "first_layer.bed_temperature_c=65",
                              "first_layer.feed_factor=0.5", "first_layer.width_factor=1.2")[0]
        start, part = program.text.split("; start of the part")
        self.assertIn("M109 S215", start)
        self.assertIn("M190 S65", start)
        self.assertIn("M104 S210\nM140 S60\n", part.split(";LAYER:1")[1].split(";LAYER:2")[0])
        feeds = [words["F"] for role, words in program.layers[0] if "F" in words and "E" in words and ("X" in words or "Y" in words)]
        self.assertEqual(max(feeds), 600.0)
        thick = self.sliced(box, "first_layer.height_mm=0.3")[0]
        self.assertIn(";LAYER:0\n;Z:0.3\n", thick.text)
        self.assertAlmostEqual(program.width(0), 20 - 0.48, places=2)
        self.assertAlmostEqual(program.width(1), usual.width(1), places=3)
        done = lamina("slice", box, "-o", self.path("x.gcode"), "--set", "first_layer.nozzle_temperature_c=215", "--set",
                      "program.start_code=G28")
        self.assertIn("program.start_code", done.stderr)

    def test_the_flow_is_limited(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        fast = [f"feed.{role}_mm_s=300" for role in ("outer_wall", "inner_wall", "infill", "first_layer")]
        program = self.sliced(box, *fast, "flow.greatest_mm3_s=11")[0]
        feeds = {words["F"] / 60 for words in program.motions() if "F" in words and words.get("E", 0) > 0 and len(words) > 2}
        self.assertAlmostEqual(max(feeds), 154.0, delta=0.1)

    def test_runs_coast(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        _, usual = self.sliced(box)
        program, summary = self.sliced(box, "flow.coast_mm3=0.2", "flow.coast_longest_mm=3")
        runs = summary["deposition_runs"]
        self.assertAlmostEqual(usual["deposited_mm3"] - summary["deposited_mm3"], 0.2 * runs, places=6)
        self.assertAlmostEqual(program.pushed_mm() * FILAMENT_MM2, summary["deposited_mm3"], delta=0.01)
        self.assertTrue(any(note.startswith(f"{runs} runs end without pushing") for note in summary["notes"]))

    def test_the_firmware_is_given_its_advance(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        words = {"marlin": "M900 K0.05", "klipper": "SET_PRESSURE_ADVANCE ADVANCE=0.05", "reprapfirmware": "M572 D0 S0.05"}
        for firmware, word in words.items():
            program = self.sliced(box, "flow.advance_s=0.05", "flow.advance_word=" + firmware)[0]
            self.assertEqual(program.text.count(word + "\n"), 1)
            self.assertLess(program.text.index(word), program.text.index("\nG1 "))

    def test_a_lag_is_made_up_for_by_firmware_or_program(self):
        box = self.part("box", x_mm=20, y_mm=20, z_mm=1)
        _, summary = self.sliced(box, "flow.lag_s=0.05")
        self.assertTrue(any("pushed ahead of the flow" in note for note in summary["notes"]), summary["notes"])
        self.assertIn("flow.advance_s", self.refusal(box, "flow.lag_s=0.05", "flow.advance_s=0.05"))

    def test_travels_keep_inside_and_wipe(self):
        plate = self.part("through_hole_plate")
        usual, _ = self.sliced(plate)
        combed, _ = self.sliced(plate, "travel.comb=inside", "travel.comb_longest_mm=100")
        retractions = lambda program: len(re.findall(r"^G1 E-", program.text, re.MULTILINE))
        self.assertLess(retractions(combed), 0.6 * retractions(usual))
        self.assertAlmostEqual(combed.pushed_mm(), usual.pushed_mm(), delta=0.01)
        wiped, _ = self.sliced(plate, "travel.wipe_mm=2")
        self.assertIn("G1 E-0.24 ", wiped.text)
        self.assertAlmostEqual(wiped.pushed_mm(), usual.pushed_mm(), delta=0.01)
        on_the_way = [words["E"] for words in wiped.motions() if words.get("E", 0) < 0 and ("X" in words or "Y" in words)]
        self.assertAlmostEqual(sum(on_the_way) / len(re.findall(r"^G1 E-0.24 ", wiped.text, re.MULTILINE)), -0.56, places=3)
        self.assertIn("travel.comb", self.refusal(plate, "travel.comb=inside", "slicing.mode=curved"))


if __name__ == "__main__":
    unittest.main()
