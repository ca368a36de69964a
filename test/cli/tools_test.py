"""Several tools in the programs of `lamina slice`."""
import os
import tempfile
import unittest

from lamina_command import PLAIN, lamina, motions, reported

TWO = "tools.list=[{name: a}, {name: b, offset_mm: [30, 0, 0]}]"
TOOLS = (*PLAIN, "--set", TWO, "--set", "tool.infill=1")


def facets(bottom, top):
    """A box of 10 mm between two heights, as text."""
    corners = [(x, y, z) for z in (bottom, top) for y in (0, 10) for x in (0, 10)]
    faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
             (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5))
    text = ""
    for face in faces:
        text += "facet normal 0 0 0\nouter loop\n"
        text += "".join("vertex %g %g %g\n" % corners[i] for i in face) + "endloop\nendfacet\n"
    return text


class Tools(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.part = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=2", "-o", self.part)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def lines(self, name, *arguments):
        reported("slice", self.part, *arguments, "-o", self.path(name))
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
            reported("coordinates", self.path(name), "-o", self.path(name + ".csv"))
            with open(self.path(name + ".csv"), encoding="utf-8") as file:
                rows = [line.split(",") for line in file.read().splitlines()[1:]]
            deposited = [(float(row[0]), float(row[1])) for row in rows if row[3].strip() not in ("0", "0.0")]
            boxes.append([round(bound, 2) for axis in (0, 1) for bound in
                          (min(point[axis] for point in deposited), max(point[axis] for point in deposited))])
        self.assertEqual(boxes[0], boxes[1])

    def test_tower_holds_the_purge(self):
        lines = self.lines("tower.gcode", *TOOLS, "--set", "tools.purge_mm3=100")
        filament, role = 0.0, ""
        for line in lines:
            role = line[6:] if line.startswith(";TYPE:") else role
            if line.startswith("G1") and role == "prime" and ("X" in line or "Y" in line):
                filament += sum(float(word[1:]) for word in line.split() if word[0] == "E")
        self.assertAlmostEqual(filament * 2.405282 / 10, 100.0, delta=1.0)  # of 1.75 mm, in 10 layers

    def motions(self, name, *arguments, part=None):
        reported("slice", part or self.part, *arguments, "-o", self.path(name))
        with open(self.path(name), encoding="utf-8") as file:
            return motions(file.read())

    def test_tool_of_supports_alone_changes_once_and_purges(self):
        tee = self.path("bridge.stl")
        reported("part", "bridge", "-o", tee)
        tools = (*PLAIN, "--set", TWO, "--set", "supports.use=true", "--set", "supports.tool=1", "--set", "tools.purge_mm3=30")
        found = self.motions("supports.gcode", *tools, part=tee)
        self.assertEqual({m.tool for m in found if m.lays() and m.role == "support"}, {1})
        self.assertTrue([m for m in found if m.lays() and m.role == "prime"])
        taken = {}
        for m in found:
            if m.lays():
                taken.setdefault(m.layer, []).append(m.tool)
        for tools_of_layer in taken.values():
            self.assertLessEqual(sum(a != b for a, b in zip(tools_of_layer, tools_of_layer[1:])), 1)

    def heights(self, found, role):
        return sorted({round(m.end[2], 3) for m in found if m.lays() and m.role == role})

    def test_tower_and_skirt_stand_on_what_is_below_them(self):
        # The part stands 0.15 mm above a raft of 0.3 + 0.2 mm, in layers of 0.2 mm; tower and skirt have no gap.
        raft = ("--set", "raft.layers=2", "--set", "raft.gap_mm=0.15", "--set", "slicing.first_layer_height_mm=0.2",
                "--set", "skirt.layers=5")
        found = self.motions("raft.gcode", *TOOLS, "--set", "tools.purge_mm3=100", *raft)
        expected = [round(0.3 + 0.2 * i, 3) for i in range(12)]
        self.assertEqual(self.heights(found, "prime"), expected)
        self.assertEqual(self.heights(found, "skirt"), expected[:5])
        self.assertEqual(self.heights(found, "outer_wall"), [round(0.85 + 0.2 * i, 3) for i in range(10)])

    def test_tower_does_not_float_over_layers_without_part(self):
        boxes = self.path("boxes.stl")
        with open(boxes, "w", encoding="utf-8") as file:
            file.write("solid boxes\n" + facets(0, 1) + facets(2, 3) + "endsolid boxes\n")
        found = self.motions("boxes.gcode", *TOOLS, "--set", "tools.purge_mm3=100", "--set",
                             "slicing.first_layer_height_mm=0.2", part=boxes)
        self.assertEqual(self.heights(found, "prime"), [round(0.2 * i, 3) for i in range(1, 16)])
        self.assertNotIn(1.4, self.heights(found, "outer_wall"))

    def test_plates_lay_their_skirt_with_the_tool_of_walls(self):
        of_one = ("--set", TWO, "--set", "tool.walls=1", "--set", "tool.infill=1", "--set", "tool.skin=1")
        reported("slice", self.part, self.part, *of_one, "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            found = motions(file.read())
        self.assertEqual({m.role for m in found if m.lays() and m.tool == 0}, set())
        self.assertIn("skirt", {m.role for m in found if m.lays() and m.tool == 1})

    def test_plates_prime_the_tool_that_goes_on(self):
        reported("slice", self.part, self.part, *TOOLS, "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual([line for line in lines if line in ("T0", "T1")], ["T1", "T0"] * 5, "once in each layer")
        # Whoever is left is pulled back, and who is taken is pushed forth.
        pulled, tool = 0.0, 0
        for line in lines[lines.index("; start of the part"):lines.index("; end of the part")]:
            if line in ("T0", "T1") and int(line[1:]) != tool:
                tool = int(line[1:])
                self.assertLess(pulled, 0.0, "pulled back before the tool changes")
            if line.startswith("G1 E"):
                pulled += float(line.split()[1][1:])

    def test_plates_have_one_tower(self):
        reported("slice", self.part, self.part, *TOOLS, "--set", "tools.purge_mm3=60", "--set", "plate.labels=m486",
             "--set", "travel.wipe_mm=2", "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            text = file.read()
        found = motions(text)
        for layer in range(10):
            prime = [m for m in found if m.lays() and m.role == "prime" and m.layer == layer]
            self.assertAlmostEqual(2.405282 * sum(m.filament for m in prime), 60.0, delta=0.6)
            self.assertEqual({m.part for m in prime}, {""})
            taken = [m.role for m in found if m.lays() and m.layer == layer and m.tool == prime[0].tool]
            self.assertEqual(taken[0], "prime", "before anything of the part")
        parts = {m.part for m in found if m.lays() and m.role != "prime" and m.role != "skirt"}
        self.assertEqual(parts, {"box 1", "box 2"})
        self.assertIn(";PART:\nM486 S-1\n", text)
        done = lamina("slice", self.part, self.part, *TOOLS, "--set", "tools.purge_mm3=60", "--set", "plate.order=by_part")
        self.assertEqual(done.returncode, 1)
        self.assertIn("plate.order", done.stderr)

    def test_towers_purge_for_parts_of_other_layers_and_heights(self):
        reported("part", "box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=4", "-o", self.path("high.stl"))
        with open(self.path("plate.yaml"), "w", encoding="utf-8") as file:
            file.write("plate:\n  parts:\n    - {file: box.stl}\n    - {file: high.stl, settings: "
                       "{slicing.layer_height_mm: 0.3, slicing.first_layer_height_mm: 0.3}}\n")
        reported("slice", "--plate", self.path("plate.yaml"), *TOOLS, "--set", "tools.purge_mm3=60", "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            found = [m for m in motions(file.read()) if m.lays() and m.role != "skirt"]
        self.assertEqual({m.part for m in found if m.role != "prime"}, {"box", "high"})
        purged, changes, at_work = None, 0, found[0].tool
        for before, motion in zip(found, found[1:]):
            self.assertGreaterEqual(motion.end[2], before.end[2] - 1e-6, "never below what is deposited")
            if motion.tool != at_work:
                at_work, purged, changes = motion.tool, 0.0, changes + 1
            if purged is not None and motion.role == "prime":
                purged += 2.405282 * motion.filament
            elif purged is not None:
                self.assertAlmostEqual(purged, 60.0, delta=0.6)
                purged = None
        self.assertGreater(changes, 10)

    def test_plates_leave_room_for_their_tower(self):
        settings = (*TOOLS, "--set", "tools.purge_mm3=100", "--set", "plate.spacing_mm=5")
        room = int((220 - 2 * 4.4 + 5) // 15)  # boxes of 10 mm in a row of the bed
        reported("slice", *[self.part] * room, *settings, "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            found = motions(file.read())
        tower = [m.end[0] for m in found if m.lays() and m.role == "prime"]
        self.assertLess(max(tower), 220.0)

    def test_parts_of_a_plate_have_tools_of_their_own(self):
        with open(self.path("plate.yaml"), "w", encoding="utf-8") as file:
            file.write("plate:\n  parts:\n    - {file: box.stl, name: black}\n    - {file: box.stl, name: white, settings: "
                       "{tool.walls: 1, tool.infill: 1, tool.skin: 1}}\n")
        reported("slice", "--plate", self.path("plate.yaml"), "--set", TWO, "-o", self.path("plate.gcode"))
        with open(self.path("plate.gcode"), encoding="utf-8") as file:
            found = motions(file.read())
        self.assertEqual({(m.part, m.tool) for m in found if m.lays() and m.part}, {("black", 0), ("white", 1)})

    def test_copies_on_a_belt_keep_their_tool(self):
        belt = ("--set", "machine.name=belt_45", "--set", "slicing.plane.angle_deg=45", "--set", "part.copies=2", "--set",
                TWO, "--set", "tool.walls=1", "--set", "tool.infill=1", "--set", "tool.skin=1")
        lines = self.lines("belt.gcode", *belt)
        self.assertEqual([line for line in lines if line in ("T0", "T1")], ["T1"])

    def test_refuse_what_cannot_be(self):
        for settings, word in ((("tool.infill=2",), "tool.infill"), (("program.dialect=fullcontrol",), "tool 1"),
                               (("tools.purge_mm3=100", "tools.tower_mm=10"), "tools.tower_mm"),
                               (("tools.purge_mm3=100", "tools.tower_at_mm=400,0"), "reach")):
            done = lamina("slice", self.part, *TOOLS, *(word for each in settings for word in ("--set", each)), "-o", self.path("no.gcode"))
            self.assertEqual(done.returncode, 1, settings)
            self.assertIn(word, done.stderr)
            self.assertFalse(os.path.exists(self.path("no.gcode")))


if __name__ == "__main__":
    unittest.main()
