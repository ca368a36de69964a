# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the command `lamina` as a person or a cell controller does.

    command_line_test.py LAMINA
"""
import json
import os
import pty
import re
import select
import signal
import subprocess
import sys
import tempfile
import time
import unittest

LAMINA = os.path.abspath(sys.argv.pop())


def content(path):
    with open(path, "rb") as file:
        return file.read()


def run(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, timeout=60)


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def make_part(self, name, *settings):
        path = self.path(name + ".stl")
        self.assertEqual(run("part", name, *settings, "-o", path).returncode, 0)
        return path

    def assert_fails_with(self, code, *arguments):
        done = run(*arguments, "--json")
        self.assertNotEqual(done.returncode, 0)
        reported = json.loads(done.stdout)
        self.assertEqual(reported["error"]["code"], code)
        self.assertTrue(reported["error"]["message"])
        return reported

    def test_arguments_that_cannot_be_read_are_reported_as_json(self):
        for arguments in (["slice", "--bogus"], ["stream"], ["info"], ["slice", "box", "--threads", "0"],
                          ["emulate", "--tcp", "99999999"], ["preview", "box", "--layer", "-1"]):
            self.assert_fails_with("InvalidConfig", *arguments)

    def test_the_bound_of_a_layer_can_be_read(self):
        for subcommand in ("voids", "preview"):
            reported = self.assert_fails_with("InvalidConfig", subcommand, "box", "--layer", "-1")
            self.assertLess(len(reported["error"]["message"]), 100)

    def test_help_is_no_failure(self):
        for subcommand in ("part", "info", "slice", "preview", "emulate", "stream"):
            done = run(subcommand, "--help")
            self.assertEqual(done.returncode, 0)
            self.assertIn("--json", done.stdout)

    def test_help_by_the_word_is_that_by_the_option(self):
        for asked in (["slice"], ["calibrate", "time"], ["optimise"], []):
            by_word, by_option = run("help", *asked), run(*asked, "--help")
            self.assertEqual(by_word.returncode, 0, by_word.stderr)
            self.assertEqual(by_word.stdout, by_option.stdout)
        self.assertIn("lamina help SUBCOMMAND", run("help").stdout)
        self.assertIn("there is no subcommand 'slise'; did you mean 'slice'", run("help", "slise").stderr)

    def test_an_unknown_option_names_the_one_that_is_like_it(self):
        for arguments, meant in ((("slice", "box", "--otput", "x.csv"), "--output"), (("slice", "box", "--sett=a=b"), "--set"),
                                 (("calibrate", "time", "--outputt", "x.yaml"), "--output")):
            done = run(*arguments)
            self.assertEqual(done.returncode, 109)
            self.assertIn(f"; did you mean '{meant}'?\n", done.stderr)
        self.assertNotIn("did you mean", run("slice", "box", "--xyzzy").stderr)
        message = self.assert_fails_with("InvalidConfig", "slice", "box", "--otput", "x.csv")["error"]["message"]
        self.assertIn("; did you mean '--output'?", message)

    def test_the_version_is_that_of_the_package(self):
        package = os.path.join(os.path.dirname(__file__), "..", "..", "package.xml")
        with open(package, encoding="utf-8") as file:
            version = re.search(r"<version>(.*)</version>", file.read()).group(1)
        done = run("--version")
        self.assertEqual((done.returncode, done.stdout), (0, f"lamina {version}\n"))

    def test_a_program_that_is_none_is_named_and_not_quoted(self):
        path = self.path("noise.gcode")
        with open(path, "wb") as file:
            file.write(b"\n\n?secret\xff\x80\n")
        message = self.assert_fails_with("InvalidProgram", "check", path)["error"]["message"]
        self.assertIn(f"'{path}' line 3: a letter is expected, as in X10.5", message)
        self.assertIn("not quoted", message)
        self.assertNotIn("secret", message)

    def test_options_given_twice_are_refused_and_settings_taken_by_the_last(self):
        done = run("slice", "box", "-o", self.path("a.gcode"), "-o", self.path("b.gcode"))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("--output is given 2 times; expected once", done.stderr)
        self.assertEqual(os.listdir(self.path("")), [])
        printed = run("slice", "--set", "infill.density=0.1", "--set", "infill.density=0.3", "--print-config", "--json")
        self.assertEqual(json.loads(printed.stdout)["infill.density"], 0.3)
        self.assertIn("the last counts", run("slice", "--help").stdout)

    def test_configuration_is_printed_in_both_formats(self):
        self.assertIn("layer_height_mm: 0.2", run("slice", "--print-config").stdout)
        configuration = json.loads(run("slice", "--print-config", "--json").stdout)
        self.assertEqual(configuration["slicing.layer_height_mm"], 0.2)
        self.assertEqual(configuration["infill.strategy"], "zigzag")

    def test_slicing_reports_one_object(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=2")
        reported = json.loads(run("slice", box, "-o", self.path("box.gcode"), "--json").stdout)
        self.assertEqual(reported["layers"], 10)
        self.assertEqual(reported["open_contours"], 0)
        self.assertAlmostEqual(reported["sliced_volume_mm3"], 200.0, places=6)
        self.assertTrue(os.path.getsize(self.path("box.gcode")) > 0)

    def test_five_axis_programs_are_written_and_read_through_their_machine(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1")
        program, picture = self.path("box.gcode"), self.path("box.png")
        machine = ["--set", "machine.name=five_axis_head_table"]
        tilt = ["--set", "orientation.mode=fixed", "--set", "orientation.fixed_lean_deg=10"]
        self.assertEqual(run("slice", box, *machine, *tilt, "-o", program).returncode, 0)
        self.assertIn(b"\n;FIVE_AXIS:tool_tip X Y Z B C\n", content(program))
        reported = json.loads(run("preview", program, *machine, "-o", picture, "--json").stdout)
        self.assertEqual(reported["layers"], 5)
        reported = json.loads(run("check", program, "--machine", "five_axis_head_table", "--json").stdout)
        self.assertEqual(reported["faulty_waypoints"], 0)
        self.assertEqual(run("voids", program, *machine).returncode, 0)
        self.assert_fails_with("InvalidProgram", "preview", program, "-o", picture)
        self.assert_fails_with("Unreachable", "slice", box, *tilt, "-o", self.path("upright.gcode"))
        self.assertFalse(os.path.exists(self.path("upright.gcode")))

    def test_programs_of_arms_tell_their_joints(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1")
        module, arm = self.path("box.mod"), ["--set", "machine.name=irb_4600"]
        done = run("slice", box, *arm, "--set", "rapid.configuration=joints", "-o", module)
        self.assertEqual(done.returncode, 0, done.stderr)
        reported = json.loads(run("check", module, "--machine", "irb_4600", "--json").stdout)
        self.assertEqual(reported["faulty_waypoints"], 0)
        reported = json.loads(run("voids", module, "--json").stdout)
        self.assertEqual(reported["layers"], 5)
        self.assert_fails_with("InvalidInput", "slice", box, *arm, "-o", self.path("box.gcode"))
        self.assertFalse(os.path.exists(self.path("box.gcode")))

    def test_programs_in_languages_of_robots_are_written_read_and_checked(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1")
        arm = ["--set", "machine.name=irb_4600"]
        for suffix in (".src", ".script", ".ls", ".jbi"):
            program = self.path("box" + suffix)
            cut = ["--set", "robot_program.allow_cut=true"]
            done = run("slice", box, *arm, *cut, "-o", program)
            self.assertEqual(done.returncode, 0, done.stderr)
            reported = json.loads(run("check", program, "--machine", "irb_4600", "--json").stdout)
            self.assertEqual(reported["faulty_waypoints"], 0)
            reported = json.loads(run("voids", program, "--json").stdout)
            self.assertEqual(reported["layers"], 5)
            upright = self.path("upright" + suffix)
            self.assert_fails_with("InvalidInput", "slice", box, "-o", upright)
            self.assertFalse(os.path.exists(upright))

    def test_inclined_layers_are_sliced_and_drawn(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=2")
        plane = ["--set", "slicing.plane.angle_deg=45", "--set", "machine.name=gantry_45"]
        program = self.path("inclined.gcode")
        reported = json.loads(run("slice", box, *plane, "-o", program, "--json").stdout)
        # The box is (10 + 2) / sqrt 2 = 8.49 mm across these layers, which makes 42 of 0.2 mm.
        self.assertEqual(reported["layers"], 42)
        self.assertAlmostEqual(reported["sliced_volume_mm3"], 200.0, places=0)
        self.assertEqual(reported["starts_in_air"], 0)
        drawn = json.loads(run("preview", program, "-o", self.path("inclined.png"), "--json").stdout)
        self.assertEqual(drawn["layers"], 42)
        self.assertAlmostEqual(drawn["deposition_mm"], reported["deposition_mm"], delta=1.0)
        refused = run("slice", box, "--set", "slicing.plane.angle_deg=45", "-o", self.path("none.gcode"))
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("slicing.plane.tool_axis 'down'", refused.stderr)
        self.assertFalse(os.path.exists(self.path("none.gcode")))

    def test_all_voids_of_a_program_are_listed_with_class_area_and_outline(self):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1")
        program = self.path("box.gcode")
        self.assertEqual(run("slice", box, "-o", program).returncode, 0)
        listed = self.path("voids.json")
        reported = json.loads(run("voids", program, "--part", box, "-o", listed, "--json").stdout)
        layers = json.loads(content(listed))["layers"]
        self.assertEqual(len(layers), reported["layers"])
        voids = [void for layer in layers for void in layer["voids"]]
        self.assertEqual(len(voids), reported["voids"])
        self.assertGreater(len(voids), 0)  # the infill is sparse
        for void in voids:
            self.assertIn(void["class"], reported["voids_by_class"])
            self.assertGreater(void["area_mm2"], 0.0)
            self.assertGreaterEqual(len(void["outline_mm"]), 3)
        # The outer walls alone tell the same of a box.
        alone = json.loads(run("voids", program, "--json").stdout)
        self.assertAlmostEqual(alone["uncovered_percent_mean"], reported["uncovered_percent_mean"], delta=0.5)
        self.assert_fails_with("InvalidInput", "voids", program, "--part", box, "-o", self.path("voids.txt"))

    def slice_drops(self, name):
        box = self.make_part("box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1")
        path = self.path(name)
        self.assertEqual(run("slice", box, "-o", path, "--set", "infill.strategy=drops_dense", "--set",
                             "slicing.layer_height_mm=0.5", "--set", "slicing.first_layer_height_mm=0.5").returncode, 0)
        return path

    def test_voids_of_a_drop_program_are_filled(self):
        program = self.slice_drops("drops.gcode")
        before = content(program)
        filled = self.path("filled.gcode")
        reported = json.loads(run("fill-voids", program, "-o", filled, "--overlap", "0.1", "--json").stdout)
        self.assertEqual(reported["layers"], 2)
        self.assertGreater(reported["new_drops"], 0)
        self.assertLessEqual(reported["greatest_linear_overlap"], 0.1 + 1e-6)
        self.assertEqual(sum(reported["voids_by_class"].values()), reported["voids"])
        self.assertEqual(content(program), before)
        lines = content(filled).decode().splitlines()
        self.assertEqual(lines.count("M780"), reported["drops"] + reported["new_drops"])

    def test_a_sweep_of_degrees_needs_no_output(self):
        table = self.path("sweep.csv")
        reported = json.loads(run("fill-voids", self.slice_drops("drops.gcode"), "--sweep", table, "--json").stdout)
        self.assertEqual([round(100 * step["allowed_overlap"]) for step in reported["sweep"]], list(range(0, 41, 5)))
        self.assertEqual(len(content(table).decode().splitlines()), 10)
        self.assertNotIn("output", reported)

    def test_a_drop_program_is_measured_like_one_of_beads(self):
        program = self.slice_drops("drops.gcode")
        reported = json.loads(run("voids", program, "--part", self.path("box.stl"), "--json").stdout)
        for key in ("layers", "uncovered_percent_mean", "uncovered_percent_worst", "overfill_percent_mean",
                    "runs_per_layer_mean", "voids"):
            self.assertIn(key, reported)
        # Between the porosity of a hexagonal lattice, 9.3 %, and that of a layer with its voids open.
        self.assertGreater(reported["uncovered_percent_mean"], 9.3)
        self.assertLess(reported["uncovered_percent_mean"], 25.0)

    def test_options_that_do_not_apply_are_refused(self):
        drops = self.slice_drops("drops.gcode")
        box = self.path("box.stl")
        beads = self.path("beads.gcode")
        self.assertEqual(run("slice", box, "-o", beads).returncode, 0)
        filled = ["-o", self.path("filled.gcode")]
        for option in (["--part", box], ["--offset", "1,2"], ["--least-area", "0.25"], ["--least-width", "1"]):
            self.assertIn(option[0], self.assert_keeps_inputs("fill-voids", drops, *filled, *option))
        for option in (["--overlap", "0.1"], ["--definition", "area"], ["--detector", "voronoi"], ["--iterate"],
                       ["--sweep", self.path("s.csv")]):
            self.assertIn(option[0], self.assert_keeps_inputs("fill-voids", beads, "--part", box, *filled, *option))

    def test_a_part_too_narrow_for_a_drop_is_refused_in_terms_of_drops(self):
        box = self.make_part("box", "--set", "x_mm=2", "--set", "y_mm=2", "--set", "z_mm=1")
        reported = self.assert_fails_with("InvalidInput", "slice", box, "--set", "infill.strategy=drops_dense", "--set",
                                      "drops.diameter_mm=3", "--set", "drops.pitch_mm=3")
        self.assertIn("no drop", reported["error"]["message"])
        self.assertIn("drops.diameter_mm", reported["error"]["message"])

    def test_filling_without_a_file_to_write_is_refused(self):
        self.assert_fails_with("InvalidInput", "fill-voids", self.slice_drops("drops.gcode"))

    def test_a_mesh_is_never_overwritten_by_its_program(self):
        mesh = self.make_part("box")
        trap = self.path("box.gcode")
        os.rename(mesh, trap)
        before = content(trap)
        self.assert_fails_with("InvalidInput", "slice", trap, "-o", trap)
        self.assertEqual(content(trap), before)

    def test_a_configuration_is_never_overwritten_by_a_program(self):
        trap = self.path("config.gcode")
        with open(trap, "w") as file:
            file.write("walls: {count: 1}\n")
        self.assert_fails_with("InvalidInput", "slice", "box", "--config", trap, "-o", trap)
        self.assertEqual(content(trap), b"walls: {count: 1}\n")

    def assert_keeps_inputs(self, *arguments):
        names = sorted(os.listdir(self.folder.name))
        before = [content(self.path(name)) for name in names]
        reported = self.assert_fails_with("InvalidInput", *arguments)
        self.assertEqual(sorted(os.listdir(self.folder.name)), names, arguments)
        self.assertEqual([content(self.path(name)) for name in names], before, arguments)
        return reported["error"]["message"]

    def write_config(self, name):
        with open(self.path(name), "w") as file:
            file.write("walls: {count: 1}\n")
        return self.path(name)

    def test_no_output_overwrites_what_is_read(self):
        drops = self.slice_drops("drops.gcode")
        box = self.path("box.stl")
        beads = self.path("beads.gcode")
        self.assertEqual(run("slice", box, "-o", beads).returncode, 0)
        os.symlink(beads, self.path("link.gcode"))
        for suffix in ("gcode", "csv", "json", "png"):
            self.write_config("c." + suffix)
        for arguments in (["fill-voids", drops, "-o", self.path("c.gcode"), "--config", self.path("c.gcode")],
                          ["fill-voids", drops, "--sweep", self.path("c.csv"), "--config", self.path("c.csv")],
                          ["fill-voids", beads, "--part", box, "-o", self.path("link.gcode")],
                          ["voids", beads, "-o", self.path("c.json"), "--config", self.path("c.json")],
                          ["voids", beads, "--picture", self.path("c.png"), "--config", self.path("c.png")],
                          ["preview", beads, "-o", self.path("c.png"), "--config", self.path("c.png")],
                          ["slice", box, "-o", self.path("c.csv"), "--set", "slicing.heights=file",
                           "--set", "slicing.heights_file=" + self.path("c.csv")],
                          ["slice", box, "-o", self.path("c.csv"), "--set", "slicing.mode=volumetric", "--set", "volumetric.target=given",
                           "--set", "volumetric.target_file=" + self.path("c.csv")],
                          ["preview", beads, "-o", self.path("c.png"), "--layer", "0", "--part", self.path("c.png")]):
            self.assertIn("is the file that is read", self.assert_keeps_inputs(*arguments))

    def test_an_output_has_the_suffix_of_what_it_holds(self):
        drops = self.slice_drops("drops.gcode")
        yaml = self.write_config("c.yaml")
        for arguments in (["fill-voids", drops, "-o", self.path("out.csv")],
                          ["fill-voids", drops, "-o", yaml, "--config", yaml],
                          ["fill-voids", drops, "--sweep", yaml, "--config", yaml],
                          ["voids", drops, "-o", self.path("v.csv"), "--picture", self.path("v.csv")],
                          ["preview", drops, "-o", self.path("p.gcode")]):
            self.assertIn("suffix must be", self.assert_keeps_inputs(*arguments))

    def write_program(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)
        return self.path(name)

    def tilted(self):
        return self.write_program("tilted.gcode", "; generated by a test\nM83\n;LAYER:0\nG0 X5 Y20 Z0\nG1 X9 E1 F900\n"
                                                  "G1 Y21 E1\n; end of the part\nG1 X0 Y200\n")

    def inclined(self, path):
        """The program without the comments that tell its frame, which stand after the head."""
        lines = content(path).decode().splitlines(True)
        self.assertTrue(lines[1].startswith(";LAYER_FRAME: 0.92387953"), lines)
        self.assertTrue(lines[2].startswith(";NOZZLE_FRAME: "), lines)
        return "".join(lines[:1] + lines[3:])

    def test_a_program_is_inclined_beside_itself(self):
        done = run("incline", self.tilted(), "--layer-height", "0.5", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        reported = json.loads(done.stdout)
        self.assertEqual(reported["output"], self.path("tilted_rotate.gcode"))
        self.assertEqual(reported["depositions"], 2)
        self.assertEqual(self.inclined(reported["output"]),
                         "; generated by a test\nM83\n;LAYER:0\nG0 X5.000 Y14.142 Z0.500\n"
                         "G1 X9.000 Y14.142 Z0.500 E1 F900\nG1 X9.000 Y14.849 Z1.207 E1\n; end of the part\nG1 X0 Y200\n")

    def test_a_program_is_mapped_by_any_matrix(self):
        program = self.tilted()
        # Where (9, 21, 0), the end of the last deposition, goes; all is lifted to 0.5 mm.
        for arguments, last in ((["--map", "scale", "--factors", "2,1,1"], "X18.000 Y21.000 Z0.500 E"),
                                (["--map", "shear", "--shear", "x,y,0.5"], "X19.500 Y21.000 Z0.500 E"),
                                (["--map", "matrix", "--matrix", "1,0,0,3,0,1,0,4,0,0,1,0"], "X12.000 Y25.000 Z0.500 E"),
                                (["--axis", "0,0,1", "--angle-deg", "5"], "X7.135 Y21.704 Z0.500 E"),
                                (["--belt-deg", "45"], "X9.000 Y1.707 Z-13.642 E"),
                                (["--mode", "listing"], "X9.00 Y14.85 Z1.21 E"),
                                (["--machine", "gantry_45"], "X9.000 Y14.849 Z1.207 E"),
                                (["--homing", "keep", "--build-aids", "drop", "--lift", "none"], "X9.000 Y14.849 Z14.849 E")):
            done = run("incline", program, "--layer-height", "0.5", *arguments, "--json")
            self.assertEqual(done.returncode, 0, (arguments, done.stderr))
            self.assertIn("G1 " + last, content(json.loads(done.stdout)["output"]).decode(), arguments)

    def test_a_nozzle_that_leans_the_other_way_is_refused(self):
        arguments = ["incline", self.tilted(), "--layer-height", "0.5", "--machine", "large_gantry_45_reverse"]
        self.assert_fails_with("Unreachable", *arguments)
        self.assertEqual(run(*arguments, "--tool-axis", "machine", "--table-position", "600,600").returncode, 0)

    def test_code_and_final_position_are_put_in(self):
        begin = self.write_program("begin.txt", "M117 on")
        end = self.write_program("end.txt", "M117 off\n")
        output = self.path("o.gcode")
        done = run("incline", self.tilted(), "--layer-height", "0.5", "--begin-code", begin, "--end-code", end,
                   "--final-position", "1,2,3", "--table-position", "650,1250", "-o", output)
        self.assertEqual(done.returncode, 0, done.stderr)
        text = self.inclined(output)
        self.assertTrue(text.startswith("; generated by a test\nM117 on\nM83\n"), text)
        self.assertTrue(text.endswith("G1 X0 Y200\nG0 F3000 Z3.000\nG0 X1.000 Y2.000\nM117 off\n"), text)

    def test_inclining_is_configured_by_a_file_and_by_settings(self):
        config = self.write_program("incline.yaml", "incline: {angle_deg: 30, axis: y, begin_code: M117 a, layer_height_mm: 0.5}\n")
        done = run("incline", self.tilted(), "--config", config, "--axis", "x", "--set", "incline.angle_deg=45", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("\nM117 a\nM83\n", self.inclined(json.loads(done.stdout)["output"]))
        self.assertIn("angle_deg: 45", run("incline", "--print-config").stdout)
        self.assertEqual(json.loads(run("incline", "--print-config", "--json").stdout)["incline.angle_deg"], 45)

    def test_what_cannot_be_inclined_leaves_nothing(self):
        program = self.tilted()
        text = self.write_program("tilted.txt", "M83\n")
        begin = self.write_program("begin.gcode", "M117\n")
        names = sorted(os.listdir(self.folder.name))
        for code, arguments in (("FileError", [self.path("none.gcode")]), ("InvalidInput", [text]),
                                ("InvalidInput", [program, "-o", program]), ("InvalidInput", [program, "-o", self.path("o.txt")]),
                                ("InvalidProgram", [program]), ("InvalidConfig", [program, "--axis", "w"]),
                                ("InvalidConfig", [program, "--map", "scale"]),
                                ("InvalidConfig", [program, "--map", "scale", "--factors", "1,1,1", "--axis", "y"]), ("InvalidConfig", [program, "--shear", "y,z,1"]),
                                ("InvalidConfig", [program, "--machine", "nowhere", "--layer-height", "1"]),
                                ("InvalidInput", [program, "--begin-code", begin, "-o", begin, "--layer-height", "1"]),
                                ("Unreachable", [program, "--layer-height", "1", "--offset=-20,0,0"]),
                                ("InvalidConfig", [program, "--angle-deg", "361"])):
            self.assert_fails_with(code, "incline", *arguments)
            self.assertEqual(sorted(os.listdir(self.folder.name)), names, arguments)

    def test_a_mesh_is_turned_and_put_on_the_bed(self):
        for part in ("box", self.make_part("box")):
            done = run("rotate", part, "--angle-deg", "-45", "-o", self.path("turned.stl"), "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            size = json.loads(done.stdout)["size_mm"]  # a cube of 20 mm on an edge
            for side, expected in zip(size, (20.0, 20.0 * 2 ** 0.5, 20.0 * 2 ** 0.5)):
                self.assertAlmostEqual(side, expected, 4)
            reported = json.loads(run("info", self.path("turned.stl"), "--json").stdout)
            self.assertAlmostEqual(reported["volume_mm3"], 8000.0, 1)
        mesh = self.path("box.stl")
        before = content(mesh)
        self.assert_fails_with("InvalidInput", "rotate", mesh, "-o", mesh)
        self.assert_fails_with("InvalidConfig", "rotate", mesh, "--axis", "w", "-o", self.path("w.stl"))
        self.assertEqual(content(mesh), before)

    def test_a_part_is_written_as_stl_only(self):
        self.assert_fails_with("InvalidConfig", "part", "box", "-o", self.path("box.obj"))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_bad_settings_write_nothing(self):
        for setting in ("slicing.layer_height_mm=0", "walls.cuont=2", "infill.density=-1", "bead.width_mm=nan"):
            self.assert_fails_with("InvalidConfig", "slice", "box", "--set", setting, "-o", self.path("b.gcode"))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_a_closed_terminal_leaves_the_machine_cold(self):
        program = self.path("hot.gcode")
        with open(program, "w") as file:
            file.write("M104 S200\nG1 F60\n" + "".join(f"G1 X{i % 50}\n" for i in range(2000)))
        machine = self.path("machine")
        emulator = subprocess.Popen([LAMINA, "emulate", "--pty", machine, "--record", self.path("run")],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(emulator.wait)
        self.addCleanup(emulator.kill)
        self.wait_for(lambda: os.path.exists(machine))
        screen, terminal = pty.openpty()  # on which it shows how far it is
        self.addCleanup(os.close, screen)
        stream = subprocess.Popen([LAMINA, "stream", program, "--port", machine, "--json"],
                                  stdout=subprocess.PIPE, stderr=terminal, text=True,
                                  preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL))
        os.close(terminal)
        self.wait_for_text(screen, b"Execute")
        stream.send_signal(signal.SIGHUP)
        reported = json.loads(stream.communicate(timeout=60)[0])
        self.assertEqual(reported["error"]["code"], "Cancelled")
        self.assertEqual(reported["lines"], 2002)
        self.assertLess(reported["acknowledged"], 2002)
        emulator.send_signal(signal.SIGINT)
        emulator.wait(timeout=60)
        self.assertIn(b"M104 S0", content(self.path("run")))

    def test_under_nohup_a_closed_terminal_ends_nothing(self):
        machine = self.path("machine")
        emulator = subprocess.Popen([LAMINA, "emulate", "--pty", machine], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                    preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.addCleanup(emulator.wait)
        self.addCleanup(emulator.kill)
        self.wait_for(lambda: os.path.exists(machine))
        emulator.send_signal(signal.SIGHUP)
        with self.assertRaises(subprocess.TimeoutExpired):
            emulator.wait(timeout=1)
        emulator.send_signal(signal.SIGINT)
        self.assertEqual(emulator.wait(timeout=60), 0)

    def test_what_cannot_be_printed_is_said(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([LAMINA, "slice", "--print-config"], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("FileError: cannot write the standard output: ", done.stderr)

    def test_a_dry_run_moves_and_switches_nothing_on(self):
        program = self.path("wet.gcode")
        with open(program, "w") as file:
            file.write("M109 S200\nM83\nG1 X5 E1 F1200\nM106 S255\nPURGE_IT\nG1 E-1\nG1 Y5 E1 ; on\nM104 S0\n")
        machine = self.path("machine")
        emulator = subprocess.Popen([LAMINA, "emulate", "--pty", machine, "--speed-up", "0", "--record", self.path("run")],
                                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(emulator.wait)
        self.addCleanup(emulator.kill)
        self.wait_for(lambda: os.path.exists(machine))
        stream = [LAMINA, "stream", program, "--port", machine, "--set", "stream.journal=" + self.path("progress"), "--dry"]
        dry = subprocess.run([*stream, "--set", "dry.speed=0.5"], capture_output=True, text=True, timeout=60)
        self.assertEqual(dry.returncode, 0, dry.stderr)
        self.assertIn("dry run: 5 commands and words of the process taken out, 1 commands left out", dry.stderr)
        self.assertIn("line 5: 'PURGE_IT'", dry.stderr)
        self.assertFalse(os.path.exists(self.path("progress")))
        emulator.send_signal(signal.SIGINT)
        emulator.wait(timeout=60)
        ran = [line for line in content(self.path("run")).decode().splitlines() if line and not line.startswith(";")]
        self.assertEqual(ran, ["M83", "G1 X5 F600", "G1 Y5", "M104 S0"])
        refused = subprocess.run([*stream, "--set", "dry.unknown=refuse"], capture_output=True, text=True, timeout=60)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("line 5", refused.stderr)
        for other in (["--resume"], ["--set", "dry.speed=0"]):
            self.assertNotEqual(subprocess.run([*stream, *other], capture_output=True, timeout=60).returncode, 0)

    def wait_for_text(self, descriptor, text):
        seen = b""
        while text not in seen:
            self.assertTrue(select.select([descriptor], [], [], 60.0)[0], seen)
            seen += os.read(descriptor, 1000)

    def wait_for(self, is_true):
        give_up = time.monotonic() + 120.0
        while not is_true() and time.monotonic() < give_up:
            time.sleep(0.02)
        self.assertTrue(is_true())


if __name__ == "__main__":
    unittest.main()
