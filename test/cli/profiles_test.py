"""`lamina profiles`, and `lamina slice` with machines, materials and processes by their names."""
import os
import re
import tempfile
import unittest

from lamina_command import lamina, reported


class Profiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.box = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=12", "--set", "y_mm=10", "--set", "z_mm=4", "-o", self.box)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def sliced(self, name, *arguments):
        reported("slice", self.box, *arguments, "-o", self.path(name))
        with open(self.path(name), encoding="ascii") as file:
            return file.read()

    def test_are_listed(self):
        listed = reported("profiles")
        machines = [entry["name"] for entry in listed["machine"]]
        for name in ("creality_cr_30", "ideaformer_ir3", "prusa_mk3s", "prusa_mk4", "creality_ender_3", "voron_2_4_250",
                     "voron_2_4_300", "voron_2_4_350", "open5x_i3", "open5x_jubilee", "duet_large", "bigrep_class", "drop_printer"):
            self.assertIn(name, machines)
        self.assertEqual([entry["name"] for entry in listed["material"]], ["abs", "asa", "pa_cf", "petg", "pla", "pp", "tpu"])
        self.assertIn("prusa_mk4", lamina("profiles").stdout)

    def test_a_belt_printer_and_a_material_are_all_that_a_slice_needs(self):
        program = self.sliced("belt.gcode", "--machine", "creality_cr_30", "--material", "pla")
        self.assertIn(";BED_FROM_AXES:", program)
        self.assertIn("M109 S210\n", program)
        self.assertRegex(program, r"; filament used \[g\] = 0\.\d\d\n")
        self.assertIn("creality_cr_30", lamina("check", self.path("belt.gcode"), "--machine", "creality_cr_30").stdout)

    def test_a_printer_of_drops_lays_drops(self):
        program = self.sliced("drops.gcode", "--machine", "drop_printer", "--material", "pla")
        self.assertIn(";strategy=drops_dense\n", program)
        self.assertEqual(program.count(";LAYER:"), 20)
        self.assertNotIn(" E", program)

    def test_a_folder_of_profiles_that_is_not_there_is_named(self):
        missing = self.path("missing")
        os.environ["LAMINA_PROFILES"] = missing
        self.addCleanup(os.environ.pop, "LAMINA_PROFILES")
        done = lamina("profiles")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(f"LAMINA_PROFILES names '{missing}'", done.stderr)
        os.mkdir(missing)
        self.assertEqual(lamina("profiles").returncode, 0)

    def test_thumbnails_are_those_of_the_machine(self):
        program = self.sliced("mk4.gcode", "--machine", "prusa_mk4", "--material", "petg", "--process", "draft")
        found = re.findall(r"; (thumbnail\w*) begin (\d+x\d+) ", program)
        self.assertEqual(found, [("thumbnail_QOI", "16x16"), ("thumbnail_QOI", "313x173"), ("thumbnail_QOI", "440x240"),
                                 ("thumbnail_QOI", "480x240"), ("thumbnail", "640x480")])
        self.assertIn("; layer_height = 0.28\n", program)
        again = self.sliced("again.gcode", "--like", self.path("mk4.gcode"))
        self.assertEqual(again, program)

    def test_a_setting_is_explained(self):
        layers = ["--machine", "prusa_mk4", "--material", "tpu", "--process", "fine", "--set", "walls.count=5"]
        reported_of = reported("slice", "--explain", "walls.count", *layers)
        self.assertEqual((reported_of["value"], reported_of["set_by"]), ("5", "--set"))
        self.assertEqual([layer["layer"] for layer in reported_of["layers"]], ["built-in", "--process", "--set"])
        self.assertRegex(reported_of["layers"][1]["place"], r"processes/fine\.yaml:\d+$")
        self.assertIn("walls.count = 5, set by --set", lamina("slice", "--explain", "walls.count", *layers).stdout)

    def test_what_nobody_typed_follows_from_the_machine(self):
        with open(self.path("own.yaml"), "w", encoding="ascii") as file:
            file.write("profile:\n  kind: machine\n  name: own\n  inherits: filament_printer\n"
                       "machine:\n  has_fan: false\n  nozzle_mm: 0.6\n")
        own = ("--machine", self.path("own.yaml"))
        self.assertNotIn("M106", self.sliced("own.gcode", *own))
        explained = lamina("slice", "--explain", "fan.use", *own).stdout
        self.assertIn("fan.use = false, set by machine.has_fan\n", explained)
        self.assertRegex(explained, r"machine\.has_fan +false +.*own\.yaml:6\n")
        self.assertEqual(reported("slice", "--explain", "bead.width_mm", *own)["value"], "0.6")
        refused = lamina("slice", self.box, *own, "--set", "fan.use=true", "-o", self.path("no.gcode"))
        self.assertEqual(refused.returncode, 1)
        self.assertIn("fan.use is true with machine.has_fan false", refused.stderr)
        self.assertFalse(os.path.exists(self.path("no.gcode")))

    def test_what_a_machine_cannot_do_is_refused_by_file_and_line(self):
        refused = lamina("slice", self.box, "--machine", "creality_ender_3", "--material", "pa_cf", "-o", self.path("no.gcode"))
        self.assertEqual(refused.returncode, 1)
        self.assertRegex(refused.stderr, r"cannot melt PA-CF \(.*creality_ender_3\.yaml:\d+.*pa_cf\.yaml:\d+")
        self.assertFalse(os.path.exists(self.path("no.gcode")))
        self.assertIn("expected a profile", lamina("slice", self.box, "--machine", "ender").stderr)

    def test_an_outline_is_extruded(self):
        outline = self.path("ring.svg")
        with open(outline, "w", encoding="ascii") as file:
            file.write("<svg width='30mm' height='30mm' viewBox='0 0 30 30'>"
                       "<path fill-rule='evenodd' d='M5 5h20v20H5z M20 15a5 5 0 1 0-10 0a5 5 0 1 0 10 0'/></svg>")
        self.assertAlmostEqual(reported("slice", outline, "--set", "input.extrude_mm=2")["mesh_volume_mm3"], 2 * (400 - 78.54), delta=0.3)


if __name__ == "__main__":
    unittest.main()
