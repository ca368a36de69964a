"""Regions of a part with tools, flow, bridges and supports of their own."""
import os
import resource
import tempfile
import unittest
import zipfile

from lamina_command import PLAIN, lamina, motions, reported

LEVEL = (*PLAIN, "--set", "slicing.first_layer_height_mm=0.2", "--set", "skirt.count=0")
MIDDLE = (110.0, 110.0, 0.0)
TOOLS = ("--set", "tools.list=[{name: black}, {name: white}]")


def box(low, high):
    return "box_mm: [[%g, %g, %g], [%g, %g, %g]]" % (*low, *high)


RIGHT = box((0, -99, -1), (99, 99, 99))


class Regions(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.box = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=20", "--set", "y_mm=20", "--set", "z_mm=2", "-o", self.box)
        self.bridge = self.path("bridge.stl")  # 20 x 20 mm hang between two pillars
        reported("part", "bridge", "-o", self.bridge)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def sliced(self, part, modifiers, *arguments):
        """The summary and the motions of a part with modifiers."""
        with open(self.path("modifiers.yaml"), "w", encoding="utf-8") as file:
            file.write("modifiers:\n" + "".join("  - {%s}\n" % each for each in modifiers))
        regions = ("--set", "part.modifiers=" + self.path("modifiers.yaml")) if modifiers else ()
        summary = reported("slice", part, "-o", self.path("part.gcode"), *LEVEL, *regions, *arguments)
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            found = motions(file.read())
        for motion in found:  # from the middle of the bed, where the part stands
            motion.start = tuple(at - of for at, of in zip(motion.start, MIDDLE))
            motion.end = tuple(at - of for at, of in zip(motion.end, MIDDLE))
        return summary, found

    def refusal(self, modifiers, *arguments):
        with open(self.path("modifiers.yaml"), "w", encoding="utf-8") as file:
            file.write("modifiers:\n" + "".join("  - {%s}\n" % each for each in modifiers))
        done = lamina("slice", self.box, "--set", "part.modifiers=" + self.path("modifiers.yaml"), *arguments)
        self.assertNotEqual(done.returncode, 0)
        return done.stderr

    def test_a_region_has_a_tool_of_its_own(self):
        usual, _ = self.sliced(self.box, [RIGHT + ", settings: {flow: 1}"])
        summary, found = self.sliced(self.box, [RIGHT + ", settings: {tool: 1}"], *TOOLS)
        self.assertAlmostEqual(summary["deposited_mm3"], usual["deposited_mm3"], places=6)
        taken = {}
        for motion in found:
            if not motion.lays():
                continue
            middle = 0.5 * (motion.start[0] + motion.end[0])
            self.assertEqual(motion.tool, 1 if middle > 0 else 0, (motion.start, motion.end))
            taken.setdefault(motion.layer, []).append(motion.tool)
        for tools in taken.values():
            self.assertEqual(sum(a != b for a, b in zip(tools, tools[1:])), 1)

    def test_the_tool_of_a_region_purges(self):
        _, found = self.sliced(self.box, [RIGHT + ", settings: {tool.infill: 1}"], *TOOLS, "--set",
                               "tools.purge_mm3=50")
        filament = sum(motion.filament for motion in found if motion.lays() and motion.role == "prime")
        self.assertAlmostEqual(filament * 2.405282 / 10, 50.0, delta=0.5)  # of 1.75 mm, in 10 layers

    def test_a_change_between_layers_purges(self):
        _, found = self.sliced(self.box, ["from_mm: 1, settings: {tool: 1}"], *TOOLS, "--set", "tools.purge_mm3=50")
        changed = [m for m in found if m.lays() and m.role == "prime" and m.tool == 1]
        self.assertEqual({m.layer for m in changed}, {5})
        self.assertAlmostEqual(sum(m.filament for m in changed) * 2.405282, 50.0, delta=0.5)
        self.assertEqual({m.layer for m in found if m.lays() and m.role == "prime"}, set(range(6)))

    def test_infill_takes_what_is_purged(self):
        def deposited(found, role, layer):
            return 2.405282 * sum(m.filament for m in found if m.lays() and m.role == role and m.layer == layer)
        region, purge = [RIGHT + ", settings: {tool: 1}"], ("--set", "tools.purge_mm3=40")
        hidden = ("--set", "skins.top_layers=1", "--set", "skins.bottom_layers=1")
        _, plain = self.sliced(self.box, region, *TOOLS, *purge, *hidden)
        into = (*hidden, "--set", "tools.purge_into_infill=true")
        _, found = self.sliced(self.box, region, *TOOLS, *purge, *into)
        for layer in range(1, 9):
            infill = deposited(found, "infill", layer)
            self.assertAlmostEqual(infill, deposited(plain, "infill", layer), places=3)
            self.assertAlmostEqual(deposited(found, "prime", layer) + infill, 40.0, delta=0.4)
            order = [(m.tool, m.role) for m in found if m.lays() and m.layer == layer]
            taken = [role for tool, role in order if tool != order[0][0]]
            kinds = [role for i, role in enumerate(taken) if i == 0 or taken[i - 1] != role]
            self.assertEqual(kinds[:2], ["prime", "infill"])
            self.assertNotIn("infill", [role for tool, role in order if tool == order[0][0]])
        # As much as the infill holds needs no tower.
        _, found = self.sliced(self.box, region, *TOOLS, *into, "--set", "tools.purge_mm3=5")
        self.assertEqual({m.layer for m in found if m.lays() and m.role == "prime"}, set(range(10)))
        self.assertLess(deposited(found, "prime", 5), deposited(found, "prime", 9))

    def test_no_tool_takes_what_purges_another(self):
        regions = [box((-2, -99, -1), (99, 99, 99)) + ", settings: {tool: 1}",
                   box((4, -99, -1), (99, 99, 99)) + ", settings: {tool: 2}"]
        three = ("--set", "tools.list=[{name: a}, {name: b}, {name: c}]", "--set", "skins.top_layers=1", "--set",
                 "skins.bottom_layers=1", "--set", "infill.density=0.5", "--set", "tools.purge_mm3=30")
        _, found = self.sliced(self.box, regions, *three, "--set", "tools.purge_into_infill=true")
        for layer in range(1, 9):
            at_work, purged = None, {}
            for motion in (m for m in found if m.lays() and m.layer == layer):
                if at_work is not None and motion.tool != at_work:
                    purged[motion.tool] = 0.0
                at_work = motion.tool
                if at_work in purged and motion.role in ("prime", "infill"):
                    purged[at_work] += 2.405282 * motion.filament
                elif at_work in purged:
                    self.assertGreater(purged.pop(at_work), 29.0, (layer, at_work))
            self.assertFalse(purged)

    def test_a_region_has_a_flow_of_its_own(self):
        usual, _ = self.sliced(self.box, [], "--set", "infill.density=1")
        half, _ = self.sliced(self.box, [RIGHT + ", settings: {flow: 0.5}"], "--set", "infill.density=1")
        self.assertAlmostEqual(half["deposited_mm3"] / usual["deposited_mm3"], 0.75, delta=0.01)
        everywhere, _ = self.sliced(self.box, [], "--set", "infill.density=1", "--set", "bead.flow=0.5")
        self.assertAlmostEqual(everywhere["deposited_mm3"] / usual["deposited_mm3"], 0.5, places=4)

    def test_what_is_blocked_is_not_held_up(self):
        held = ("--set", "supports.use=true")
        whole, _ = self.sliced(self.bridge, [], *held)
        self.assertAlmostEqual(whole["overhang_mm2"], 400.0, places=3)
        blocked, found = self.sliced(self.bridge, [RIGHT + ", kind: support_blocker"], *held)
        self.assertAlmostEqual(blocked["overhang_mm2"], 200.0, places=3)
        self.assertAlmostEqual(blocked["support_blocked_mm2"], 200.0, places=3)
        self.assertAlmostEqual(blocked["support_mm3"] / whole["support_mm3"], 0.5, delta=0.05)
        self.assertLess(max(m.end[0] for m in found if m.lays() and m.role.startswith("support")), 0.0)
        off, _ = self.sliced(self.bridge, [RIGHT + ", settings: {supports.use: false}"], *held)
        self.assertAlmostEqual(off["overhang_mm2"], 200.0, places=3)

    def test_what_is_enforced_is_held_up_though_supports_are_off(self):
        enforced, found = self.sliced(self.bridge, [RIGHT + ", kind: support_enforcer"])
        self.assertAlmostEqual(enforced["overhang_mm2"], 200.0, places=3)
        self.assertGreater(min(m.end[0] for m in found if m.lays() and m.role.startswith("support")), 0.0)
        # The last of both wins.
        both = [RIGHT + ", kind: support_enforcer", RIGHT + ", kind: support_blocker"]
        self.assertEqual(self.sliced(self.bridge, both)[0]["support_mm3"], 0.0)

    def test_walls_that_lean_little_are_held_up_where_that_is_enforced(self):
        cone = self.path("cone.stl")
        reported("part", "cone", "--set", "radius_mm=6", "--set", "top_radius_mm=12", "--set", "height_mm=10", "-o", cone)
        held = ("--set", "supports.use=true", "--set", "supports.angle_deg=50")
        self.assertEqual(self.sliced(cone, [], *held)[0]["support_mm3"], 0.0)  # they lean 31 deg
        summary, found = self.sliced(cone, [RIGHT + ", kind: support_enforcer"], *held)
        self.assertGreater(summary["support_mm3"], 10.0)
        # Outlines of what stands below an overhang are simplified by 0.4 bead widths.
        self.assertGreater(min(m.end[0] for m in found if m.lays() and m.role.startswith("support")), -0.16)

    def test_a_region_has_bridges_of_its_own(self):
        plain, found = self.sliced(self.bridge, ["from_mm: 0, settings: {skins.top_layers: 3, skins.bottom_layers: 3}"])
        self.assertEqual(plain["bridges"], 0)
        bridged, found = self.sliced(self.bridge, [box((-99, -99, 8), (99, 99, 99)) + ", settings: {bridges.use: true}"])
        self.assertEqual(bridged["bridges"], 1)
        self.assertIn("bridge", {motion.role for motion in found})

    def test_travels_hop_over_skins_of_neighbours(self):
        band = box((-3, -99, -1), (3, 99, 99)) + ", settings: {skins.top_layers: 2}"
        _, found = self.sliced(self.box, [band], "--set", "travel.hop=over_skin", "--set", "travel.hop_mm=0.5")

        def is_across(motion):
            return motion.start[0] * motion.end[0] < 0.0 and min(abs(motion.start[0]), abs(motion.end[0])) > 3.0
        top = max(motion.layer for motion in found)
        crossings, is_skin_deposited = [], False
        for motion in found:
            if motion.layer != top:
                continue
            is_skin_deposited = is_skin_deposited or (motion.lays() and motion.role == "top_skin")
            if is_skin_deposited and not motion.lays() and is_across(motion):
                crossings.append(motion)
        self.assertEqual(len(crossings), 1, "from one side of the band to the other")
        for motion in crossings:
            self.assertAlmostEqual(motion.end[2], 2.5, places=3)

    def threemf(self, boxes, entry, config, model="3D/3dmodel.model", before=""):
        """A 3MF file of one object of boxes, and what a slicer writes beside it.

        @param model   where the archive has its model
        @param before  the object in it
        """
        corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
        faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
                 (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5))
        vertices, triangles = "", ""
        for i, (low, high) in enumerate(boxes):
            for corner in corners:
                vertices += '<vertex x="%g" y="%g" z="%g"/>' % tuple((low, high)[c][a] for a, c in enumerate(corner))
            for face in faces:
                triangles += '<triangle v1="%d" v2="%d" v3="%d"/>' % tuple(8 * i + corner for corner in face)
        mesh = f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"
        relation = "http://schemas.openxmlformats.org/package/2006/relationships"
        with zipfile.ZipFile(self.path("part.3mf"), "w", zipfile.ZIP_DEFLATED) as file:
            file.writestr("[Content_Types].xml", '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package'
                          '/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package'
                          '.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.'
                          '3dmanufacturing-3dmodel+xml"/></Types>')
            file.writestr("_rels/.rels", f'<?xml version="1.0"?><Relationships xmlns="{relation}"><Relationship Target='
                          f'"/{model}" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>'
                          '</Relationships>')
            file.writestr(model, '<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft'
                          f'.com/3dmanufacturing/core/2015/02"><resources>{before}<object id="4" type="model">{mesh}</object>'
                          '</resources><build><item objectid="4"/></build></model>')
            if config:
                file.writestr(entry, config)
        return self.path("part.3mf")

    def test_volumes_of_3mf_files_are_no_material(self):
        boxes = [((0, 0, 0), (20, 20, 4)), ((5, 5, -1), (15, 15, 9))]

        def sliced(kind, plate=()):
            config = ('<?xml version="1.0"?><config><object id="4"><volume firstid="0" lastid="11"><metadata type="volume" '
                      'key="volume_type" value="ModelPart"/></volume><volume firstid="12" lastid="23"><metadata type="volume" '
                      f'key="volume_type" value="{kind}"/></volume></object></config>')
            part = self.threemf(boxes, "Metadata/Slic3r_PE_model.config", config)
            return reported("slice", part, *plate, *LEVEL)
        self.assertAlmostEqual(sliced("NegativeVolume")["sliced_volume_mm3"], 4 * (400 - 100), places=3)
        self.assertAlmostEqual(sliced("NegativeVolume", [self.box])["sliced_volume_mm3"], 4 * 300 + 2 * 400, places=3)
        for kind in ("SupportBlocker", "SupportEnforcer"):
            self.assertAlmostEqual(sliced(kind)["sliced_volume_mm3"], 1600.0, places=3)
            self.assertEqual(sliced(kind)["notes"], [])
        bare = sliced("ParameterModifier")  # that has no settings changes nothing
        self.assertAlmostEqual(bare["sliced_volume_mm3"], 1600.0, places=3)
        self.assertEqual(bare["notes"], [])

    BOXES = [((0, 0, 0), (20, 20, 4)), ((10, -1, -1), (30, 21, 9))]

    def prusa(self, settings, of_object=(), of_material=(), boxes=BOXES):
        """A box of 20 x 20 x 4 mm whose right half has settings of its own, as PrusaSlicer 2.5 writes it."""
        def volume(first, kind, name, rest):
            words = [("name", name), *rest[:1], ("volume_type", kind), ("matrix", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
                     ("source_file", "part.stl"), ("source_object_id", "0"), ("source_volume_id", "0"),
                     ("source_offset_x", "10"), *rest[1:]]
            return ('  <volume firstid="%d" lastid="%d">\n' % (first, first + 11)
                    + "".join('   <metadata type="volume" key="%s" value="%s"/>\n' % word for word in words)
                    + '   <mesh edges_fixed="0" degenerate_facets="0" facets_removed="0" facets_reversed="0" '
                    'backwards_edges="0"/>\n  </volume>\n')
        config = ('<?xml version="1.0" encoding="UTF-8"?>\n<config>\n <object id="4" instances_count="1">\n'
                  '  <metadata type="object" key="name" value="part"/>\n'
                  + "".join('  <metadata type="object" key="%s" value="%s"/>\n' % word for word in of_object)
                  + volume(0, "ModelPart", "part", list(of_material)) + volume(12, "ParameterModifier", "Generic-Box",
                                                                [("modifier", "1"), *settings])
                  + " </object>\n</config>\n")
        return self.threemf(boxes, "Metadata/Slic3r_PE_model.config", config)

    def orca(self, settings):
        """The same as OrcaSlicer and Bambu Studio write it: volumes are objects, and components of one."""
        path = self.prusa([])
        with zipfile.ZipFile(path) as file:
            entries = {name: file.read(name).decode() for name in file.namelist()}
        mesh = entries["3D/3dmodel.model"].split("<mesh>")[1].split("</mesh>")[0]
        vertices = mesh.split("<vertices>")[1].split("</vertices>")[0].split("/>")[:-1]
        triangles = mesh.split("<triangles>")[1].split("</triangles>")[0].split("/>")[:12]
        objects = "".join('<object id="%d" type="model"><mesh><vertices>%s</vertices><triangles>%s</triangles></mesh></object>'
                          % (number, "".join(v + "/>" for v in vertices[8 * i:8 * i + 8]), "".join(t + "/>" for t in triangles))
                          for i, number in enumerate((1, 2)))
        head = entries["3D/3dmodel.model"].split("<object")[0]
        entries["3D/3dmodel.model"] = (head + objects + '<object id="3" type="model"><components><component objectid="1"/>'
                                       '<component objectid="2"/></components></object></resources><build><item objectid="3"/>'
                                       '</build></model>')
        del entries["Metadata/Slic3r_PE_model.config"]
        words = [("name", "Cube"), ("matrix", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"), ("source_object_id", "0"), ("extruder", "0"),
                 *settings]
        entries["Metadata/model_settings.config"] = (
            '<?xml version="1.0" encoding="UTF-8"?>\n<config>\n  <object id="3">\n    <metadata key="name" value="part"/>\n'
            '    <metadata key="extruder" value="1"/>\n    <part id="1" subtype="normal_part">\n      <metadata key="name" '
            'value="part"/>\n      <mesh_stat edges_fixed="0"/>\n    </part>\n    <part id="2" subtype="modifier_part">\n'
            + "".join('      <metadata key="%s" value="%s"/>\n' % word for word in words)
            + '      <mesh_stat edges_fixed="0"/>\n    </part>\n  </object>\n</config>\n')
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            for name, text in entries.items():
                file.writestr(name, text)
        return path

    def program(self, part, *arguments):
        """What `lamina slice` reports, and the program without its comments."""
        summary = reported("slice", part, "-o", self.path("part.gcode"), *LEVEL, *arguments)
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            return summary, [line for line in file.read().splitlines() if not line.startswith(";")]

    def test_settings_of_volumes_hold_as_those_of_modifiers(self):
        half = box((10, -1, -1), (30, 21, 9))
        ours = "settings: {infill.density: 0.6, infill.strategy: grid, walls.count: 4, feed.outer_wall_mm_s: 20}"
        with open(self.path("modifiers.yaml"), "w", encoding="utf-8") as file:
            file.write("modifiers:\n  - {%s, %s}\n" % (half, ours))
        plain_file = self.threemf(self.BOXES[:1], "", "")
        usual, plain = self.program(plain_file)
        _, expected = self.program(plain_file, "--set", "part.modifiers=" + self.path("modifiers.yaml"))
        self.assertNotEqual(plain, expected)
        prusa = self.prusa([("fill_density", "60%"), ("fill_pattern", "grid"), ("perimeters", "4"),
                            ("external_perimeter_speed", "20")])
        summary, found = self.program(prusa)
        self.assertEqual(summary["notes"], usual["notes"])
        self.assertEqual(found, expected)
        orca = self.orca([("sparse_infill_density", "60%"), ("sparse_infill_pattern", "grid"), ("wall_loops", "4"),
                          ("outer_wall_speed", "20")])
        summary, found = self.program(orca)
        self.assertEqual(summary["notes"], usual["notes"])
        self.assertEqual(found, expected)

    def test_settings_of_volumes_that_no_region_has_are_named(self):
        for written, words in ((self.prusa, [("support_material", "1"), ("fill_pattern", "stars"), ("perimeters", "3")]),
                               (self.orca, [("enable_support", "1"), ("ironing_type", "top"), ("wall_loops", "3")])):
            summary = reported("slice", written(words), *LEVEL)
            notes = [note for note in summary["notes"] if "of the part's file" in note]
            self.assertEqual(len(notes), 1)
            self.assertIn("volume 0 of the part's file", notes[0])
            for key, value in words[:2]:
                self.assertIn("'%s' '%s'" % (key, value), notes[0])
            self.assertNotIn("'%s'" % words[2][0], notes[0])
        summary = reported("slice", self.prusa([("perimeters", "3")]), *LEVEL, "--set", "infill.strategy=vase", "--set",
                       "walls.count=0", "--set", "skins.top_layers=0", "--set", "skins.bottom_layers=0", "--set", "bridges.use=false")
        self.assertIn("cannot lie beside others", " ".join(summary["notes"]))

    def alike(self, part, modifier, *arguments):
        """Asserts that a 3MF file gives the program of a modifier in YAML; returns the notes besides."""
        with open(self.path("modifiers.yaml"), "w", encoding="utf-8") as file:
            file.write("modifiers:\n  - {%s}\n" % modifier)
        summary, found = self.program(part, *arguments)
        plain_file = self.threemf(self.BOXES[:1], "", "")
        usual, plain = self.program(plain_file, *arguments)
        _, expected = self.program(plain_file, *arguments, "--set", "part.modifiers=" + self.path("modifiers.yaml"))
        self.assertNotEqual(plain, expected)
        self.assertEqual(found, expected)
        return [note for note in summary["notes"] if note not in usual["notes"]]

    def test_settings_of_an_object_hold_in_all_of_it(self):
        whole = box((-1, -1, -1), (21, 21, 5))
        words = [("fill_density", "60%"), ("perimeters", "3"), ("extruder", "1"), ("brim_width", "5")]
        notes = self.alike(self.prusa([], words), whole + ", settings: {infill.density: 0.6, walls.count: 3}")
        self.assertEqual(len(notes), 1)
        self.assertIn("object '' of the part's file", notes[0])
        self.assertIn("'brim_width' '5'", notes[0])
        # What says no more than the part changes nothing.
        _, found = self.program(self.prusa([], [("perimeters", "2"), ("extruder", "1")]))
        self.assertEqual(found, self.program(self.threemf(self.BOXES[:1], "", ""))[1])

    def test_settings_of_an_object_by_orca(self):
        path = self.orca([])
        with zipfile.ZipFile(path) as file:
            entries = {name: file.read(name).decode() for name in file.namelist()}
        entry = "Metadata/model_settings.config"
        entries[entry] = entries[entry].replace('<metadata key="extruder" value="1"/>',
                                                '<metadata key="wall_loops" value="3"/>', 1)
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            for name, text in entries.items():
                file.writestr(name, text)
        self.assertEqual(self.alike(path, box((-1, -1, -1), (21, 21, 5)) + ", settings: {walls.count: 3}"), [])

    def test_what_orca_says_of_plates_is_no_setting(self):
        def entries_with(change):
            path = self.orca([])
            with zipfile.ZipFile(path) as file:
                entries = {name: file.read(name).decode() for name in file.namelist()}
            entry = "Metadata/model_settings.config"
            entries[entry] = change(entries[entry])
            with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
                for name, text in entries.items():
                    file.writestr(name, text)
            return path
        plate = ('  <plate>\n    <metadata key="plater_id" value="1"/>\n    <metadata key="plater_name" value=""/>\n    '
                 '<metadata key="locked" value="false"/>\n    <metadata key="print_sequence" value="by object"/>\n    '
                 '<metadata key="wall_loops" value="4"/>\n    <model_instance>\n      <metadata key="object_id" value="3"/>\n'
                 '      <metadata key="instance_id" value="0"/>\n    </model_instance>\n  </plate>\n  <assemble>\n   '
                 '<assemble_item object_id="3" instance_id="0" transform="1 0 0 0 1 0 0 0 1 0 0 0" offset="0 0 0"/>\n'
                 '  </assemble>\n</config>')
        plain, program = self.program(entries_with(lambda text: text))
        counted = '<metadata key="extruder" value="1"/>\n    <metadata face_count="24"/>'
        part = entries_with(lambda text: text.replace("</config>", plate).replace(
            '<metadata key="extruder" value="1"/>', counted, 1))
        summary, found = self.program(part)
        self.assertEqual(summary["notes"], plain["notes"])
        self.assertEqual(found, program)

    def test_a_part_that_is_listed_twice_is_refused(self):
        part = self.threemf([((0, 0, 0), (20, 20, 4))], "Metadata/model_settings.config", '<config><object id="1">'
                            + '<part id="4" subtype="modifier_part"/>' * 2 + "</object></config>")
        done = lamina("slice", part)
        self.assertEqual(done.returncode, 1)
        self.assertIn("part 4 is listed twice", done.stderr)

    def test_a_piece_of_the_part_has_a_tool_of_its_own(self):
        halves = [((0, 0, 0), (10, 20, 2)), ((10, 0, 0), (20, 20, 2))]
        config = ('<?xml version="1.0"?><config><object id="4"><volume firstid="0" lastid="11"><metadata type="volume" '
                  'key="extruder" value="1"/></volume><volume firstid="12" lastid="23"><metadata type="volume" '
                  'key="volume_type" value="ModelPart"/><metadata type="volume" key="extruder" value="2"/></volume></object>'
                  '</config>')
        part = self.threemf(halves, "Metadata/Slic3r_PE_model.config", config)
        reported("slice", part, "-o", self.path("part.gcode"), *LEVEL, *TOOLS)
        with open(self.path("part.gcode"), encoding="utf-8") as file:
            deposited = [motion for motion in motions(file.read()) if motion.lays()]
        self.assertEqual({motion.tool for motion in deposited}, {0, 1})
        for motion in deposited:
            middle = 0.5 * (motion.start[0] + motion.end[0]) - MIDDLE[0]
            self.assertEqual(motion.tool, 1 if middle > 0 else 0, (motion.start, motion.end))

    def with_heights(self, ranges, entry="Metadata/Prusa_Slicer_layer_config_ranges.xml"):
        text = '<?xml version="1.0" encoding="utf-8"?>\n<objects>\n <object id="1">\n'
        for low, high, options in ranges:
            text += '  <range min_z="%s" max_z="%s">\n' % (low, high)
            text += "".join('   <option opt_key="%s">%s</option>\n' % option for option in options) + "  </range>\n"
        return self.threemf(self.BOXES[:1], entry, text + " </object>\n</objects>\n")

    def test_ranges_of_heights_have_settings_of_their_own(self):
        ours = "from_mm: 1, to_mm: 3, settings: {infill.density: 0.6, walls.count: 3}"
        words = [("extruder", "0"), ("layer_height", "0.2"), ("fill_density", "60%"), ("perimeters", "3")]
        self.assertEqual(self.alike(self.with_heights([("1", "3", words)]), ours), [])
        words = [("layer_height", "0.1"), ("sparse_infill_density", "60%"), ("wall_loops", "3")]
        part = self.with_heights([("1", "3", words)], "Metadata/layer_config_ranges.xml")
        notes = self.alike(part, ours)
        self.assertEqual(len(notes), 1)
        self.assertIn("heights 1 to 3 mm of object", notes[0])
        self.assertIn("'layer_height' '0.1'", notes[0])
        for low, high in (("3", "1"), ("1", "nan"), ("one", "2"), ("1", "1")):
            done = lamina("slice", self.with_heights([(low, high, [])]), *LEVEL)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("layer_config_ranges.xml:4", done.stderr)

    def cura(self, settings):
        """The box and one over its right half, an object each, with settings of the latter as Cura writes them."""
        path = self.orca([])
        with zipfile.ZipFile(path) as file:
            entries = {name: file.read(name).decode() for name in file.namelist()}
        del entries["Metadata/model_settings.config"]
        model = entries["3D/3dmodel.model"]
        words = "".join('<metadata name="cura:%s" preserve="1" type="xs:string">%s</metadata>' % word for word in settings)
        model = model.replace("<model ", '<model xmlns:cura="http://software.ultimaker.com/xml/cura/3mf/2015/10" ', 1)
        second = model.index('<object id="2"')
        mesh_end = model.index("<mesh>", second)
        model = model[:mesh_end] + "<metadatagroup>" + words + "</metadatagroup>" + model[mesh_end:]
        model = model[:model.index('<object id="3"')] + ('</resources><build><item objectid="1"/><item objectid="2"/></build>'
                                                         "</model>")
        entries["3D/3dmodel.model"] = model
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            for name, text in entries.items():
                file.writestr(name, text)
        return path

    def test_objects_of_cura_change_others(self):
        words = [("infill_mesh", "True"), ("drop_to_buildplate", "False"), ("infill_sparse_density", "60"),
                 ("infill_pattern", "grid"), ("wall_line_count", "4"), ("speed_wall_0", "20"), ("ironing_enabled", "True")]
        half = box((10, -1, -1), (30, 21, 9))
        notes = self.alike(self.cura(words), half + ", settings: {infill.density: 0.6, infill.strategy: grid, "
                           "walls.count: 4, feed.outer_wall_mm_s: 20}")
        self.assertEqual(len(notes), 1)
        self.assertIn("'cura:ironing_enabled' 'True'", notes[0])

    def negative(self, number=4):
        return ('<?xml version="1.0"?><config><object id="%d"><volume firstid="12" lastid="23"><metadata type="volume" '
                'key="volume_type" value="NegativeVolume"/></volume></object></config>' % number)

    def test_level_layers_that_were_chosen_mind_volumes(self):
        part = self.threemf([((0, 0, 0), (20, 20, 4)), ((5, 5, -1), (15, 15, 9))], "Metadata/Slic3r_PE_model.config",
                            self.negative())
        for mode in ("planar", "auto"):
            summary = reported("slice", part, *LEVEL, "--set", "slicing.mode=" + mode)
            self.assertEqual(summary["mode"], "planar")
            self.assertAlmostEqual(summary["sliced_volume_mm3"], 4 * (400 - 100), places=3)
            self.assertFalse([note for note in summary["notes"] if "volumes of the file" in note])
        inclined = reported("slice", part, *LEVEL, "--set", "slicing.plane.angle_deg=45", "--set", "machine.name=belt_45")
        self.assertIn("1 volumes of the file", " ".join(inclined["notes"]))

    def test_volumes_are_found_by_what_the_archive_says(self):
        boxes, entry = [((0, 0, 0), (20, 20, 4)), ((5, 5, -1), (15, 15, 9))], "Metadata/Slic3r_PE_model.config"
        comment = '<!-- <object id="9"> -->'
        for model in ("3D/3dmodel.model", "3D/part.model"):
            part = self.threemf(boxes, entry, self.negative(), model, comment)
            self.assertAlmostEqual(reported("slice", part, *LEVEL)["sliced_volume_mm3"], 4 * (400 - 100), places=3)
        done = lamina("slice", self.threemf(boxes, entry, self.negative(7)), *LEVEL)
        self.assertEqual(done.returncode, 1)
        self.assertIn("object 7", done.stderr)

    def test_sizes_that_headers_state_take_no_room(self):
        boxes, entry = [((0, 0, 0), (20, 20, 4)), ((5, 5, -1), (15, 15, 9))], "Metadata/Slic3r_PE_model.config"
        with open(self.threemf(boxes, entry, self.negative()), "rb") as file:
            archive = bytearray(file.read())
        # Sizes stand 24 bytes into the entry of the central directory, its name 46.
        at = archive.rindex(b"3D/3dmodel.model") - 46
        self.assertEqual(archive[at:at + 4], b"PK\x01\x02")
        archive[at + 24:at + 28] = (0xE0000000).to_bytes(4, "little")
        with open(self.path("part.3mf"), "wb") as file:
            file.write(archive)
        lamina("slice", self.path("part.3mf"), *LEVEL)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 1500000, "KiB")

    def test_volumes_are_numbered_as_in_the_file(self):
        boxes = [((0, 0, 0), (20, 20, 4)), ((5, 5, -1), (15, 15, 9)), ((30, 30, 0), (30, 31, 1))]
        config = '<?xml version="1.0"?><config><object id="4">'
        for first, kind in ((12, "ParameterModifier"), (24, "NegativeVolume")):
            config += ('<volume firstid="%d" lastid="%d"><metadata type="volume" key="volume_type" value="%s"/></volume>'
                       % (first, first + (11 if first == 12 else 5), kind))
        done = lamina("slice", self.threemf(boxes, "Metadata/Slic3r_PE_model.config", config + "</object></config>"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("volume 1 of the part's file", done.stderr)

    def test_lists_of_volumes_that_are_broken_are_refused(self):
        for config, word in (('<config><object id="x">', "id of object is 'x'"), ("<config", "part.3mf")):
            part = self.threemf([((0, 0, 0), (20, 20, 4))], "Metadata/Slic3r_PE_model.config", config)
            done = lamina("slice", part)
            self.assertEqual(done.returncode, 1)
            self.assertIn(word, done.stderr)

    def test_objects_of_3mf_files_may_be_volumes(self):
        part = self.threemf([((0, 0, 0), (20, 20, 4))], "Metadata/model_settings.config", '<config><object id="1">'
                            '<part id="4" subtype="normal_part"/></object></config>')
        self.assertAlmostEqual(reported("slice", part, *LEVEL)["sliced_volume_mm3"], 1600.0, places=3)
        part = self.threemf([((0, 0, 0), (20, 20, 4))], "Metadata/model_settings.config", '<config><object id="1">'
                            '<part id="4" subtype="modifier_part"/></object></config>')
        self.assertNotEqual(lamina("slice", part).returncode, 0, "nothing is left")

    def test_what_is_left_is_refused_by_name(self):
        for key in ("supports.top_gap_mm", "feed.support_mm_s", "feed.skirt_mm_s", "tool.support", "overhangs.use",
                    "bead.width_mm", "travel.hop_mm"):
            self.assertIn("'%s'" % key, self.refusal([RIGHT + ", settings: {%s: 1}" % key]))
        self.assertIn("tool.walls is 3", self.refusal([RIGHT + ", settings: {tool: 3}"], *TOOLS))
        self.assertIn("or seam_here", self.refusal([RIGHT + ", kind: seam"]))
        self.assertIn("expected no settings", self.refusal([RIGHT + ", kind: support_blocker, settings: {flow: 1}"]))

    def test_a_region_that_changes_nothing_leaves_the_program_as_it_was(self):
        def program(*arguments):
            self.sliced(self.box, *arguments)
            with open(self.path("part.gcode"), encoding="utf-8") as file:
                return file.read()
        plain = program([])
        self.assertEqual(plain, program([RIGHT + ", kind: support_blocker"]))
        self.assertEqual(plain, program([], "--set", "supports.density=0.3"))


if __name__ == "__main__":
    unittest.main()
