"""Seen skins, ironing and cooling as somebody who slices sees them: in the summary, the program and its measures."""
import math
import os
import re
import tempfile
import unittest

from lamina_command import lamina, motions, reported

SKINS = ["--set", "skins.top_layers=2", "--set", "skins.bottom_layers=2", "--set", "skirt.count=0"]
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="22mm" viewBox="0 0 30 22">
<path fill-rule="evenodd" d="M0 0H30V22H0Z M5 5H11V12H5Z M16 13H26V18H16Z"/></svg>"""


class Skins(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("plate.svg")
        with open(self.part, "w", encoding="utf-8") as file:
            file.write(PLATE)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def program(self, *settings):
        reported("slice", self.part, "--set", "input.extrude_mm=0.8", *SKINS, *settings, "-o", self.path("part.gcode"))
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            return file.read()

    def test_what_is_seen_is_ironed_last(self):
        program = self.program("--set", "ironing.use=true")
        self.assertEqual(program.count(";TYPE:ironing"), 1)
        self.assertEqual(re.findall(r";TYPE:(\w+)", program)[-1], "ironing")
        self.assertNotIn(";TYPE:ironing", self.program())

    def test_its_volume_counts(self):
        def deposited(*settings):
            self.program(*settings)
            return reported("preview", self.path("part.gcode"), "-o", self.path("part.png"))["deposited_mm3"]

        # 414.8 mm2 within two walls and the inset, 0.03 mm high.
        self.assertAlmostEqual(deposited("--set", "ironing.use=true") - deposited(), 12.44, delta=0.4)

    def test_ironing_without_skins_is_refused(self):
        done = lamina("slice", "box", "--set", "ironing.use=true", "--set", "skins.top_layers=0")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("skins.top_layers", done.stderr)

    def test_the_order_changes_the_program_and_not_what_is_deposited(self):
        one_sense, shortest = self.program(), self.program("--set", "skins.monotonic=false")
        self.assertNotEqual(one_sense, shortest)

        def skin(program):
            return [m for m in motions(program) if m.role == "top_skin" and m.lays()]

        def lines(program):
            """Where lines of the skin lie across, and how much each lays; where they end they join otherwise, by turns up to 0.15 mm long."""
            found = []
            for at, filament in sorted((m.start[0] + m.start[1], m.filament) for m in skin(program)
                                       if abs(sum(m.end[:2]) - sum(m.start[:2])) < 0.02 and math.dist(m.start, m.end) > 0.2):
                if not found or at - found[-1][0] > 0.1:
                    found.append([at, 0.0])
                found[-1][1] += filament
            return found
        self.assertGreater(len(lines(one_sense)), 50)
        for line, same in zip(lines(one_sense), lines(shortest)):
            self.assertAlmostEqual(line[0], same[0], delta=0.05)
            self.assertAlmostEqual(line[1], same[1], delta=0.02)  # 0.5 mm of a bead
        self.assertEqual(len(lines(one_sense)), len(lines(shortest)))
        volumes = [sum(m.filament for m in skin(program)) for program in (one_sense, shortest)]
        self.assertAlmostEqual(volumes[0] / volumes[1], 1.0, delta=0.01)

    def test_the_fan_has_its_share_of_the_role(self):
        fan = ["--set", "fan.use=true", "--set", "fan.full_below_s=0", "--set", "fan.least_at_s=1", "--set", "fan.least=0.2"]
        program = self.program(*fan, "--set", "fan.by_role=top_skin=0.8")
        skin = program[program.index(";TYPE:top_skin"):]
        self.assertEqual(re.findall(r"M106 S(\d+)", skin)[0], "204")
        refused = lamina("slice", "box", "--set", "fan.by_role=roof=1")
        self.assertIn("fan.by_role", refused.stderr)

    def test_a_solid_part_has_the_roles_of_skins(self):
        solid = self.program("--set", "infill.density=1")
        self.assertLess(solid.index(";TYPE:bottom_skin"), solid.index(";TYPE:top_skin"))
        self.assertNotIn(";TYPE:infill", self.program("--set", "infill.density=1", "--set", "skins.top_layers=4"))

    def test_infill_is_deposited_every_other_layer(self):
        box = ["slice", "box", "--set", "skins.top_layers=0", "--set", "skins.bottom_layers=0"]
        both = ["--set", "infill.every_layers=2"]
        self.assertIn("0.8 of bead.width_mm", lamina(*box, *both).stderr)

        def infills(*settings):
            reported(*box, "--set", "machine.nozzle_mm=0.8", "--set", "slicing.layer_height_mm=0.2", "--set",
                 "slicing.first_layer_height_mm=0.2", *settings, "-o", self.path("box.gcode"))
            with open(self.path("box.gcode"), encoding="utf-8") as file:
                return file.read().count(";TYPE:infill")

        self.assertEqual(infills(*both), infills() // 2)

    def test_places_are_left_alone_only_by_waiting(self):
        alone = ["--set", "cooling.least_layer_time_s=60", "--set", "cooling.interval=place"]
        self.assertIn("cooling.by", lamina("slice", "box", *alone).stderr)
        notes = reported("slice", "box", *alone, "--set", "cooling.by=dwell")["notes"]
        self.assertTrue(any("end with a dwell" in note for note in notes), notes)


if __name__ == "__main__":
    unittest.main()
