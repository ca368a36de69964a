# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `lamina check` and `lamina track` as a person or a script does.

    check_and_track_test.py LAMINA
"""
import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
HEAD = "layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s\n"


def run(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, timeout=60)


def through(points, role="infill", width=0.4):
    """A path through the points, the nozzle straight down."""
    return HEAD + "".join(f"0,0,{role},0,{x},{y},{z},0,1,0,0,{width},0.2,20\n" for x, y, z in points)


class CheckAndTrack(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, points, *path_of):
        path = self.path("path.csv")
        with open(path, "w") as file:
            file.write(through(points, *path_of))
        return path

    def reported(self, *arguments, code=0):
        done = run(*arguments, "--json")
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout)

    def listed(self, path):
        with open(path, newline="") as file:
            return list(csv.DictReader(file))

    def test_a_program_that_was_cut_off_is_reported(self):
        program = self.path("box.gcode")
        sliced = run("slice", "box", "--set", "input.scale=0.5", "-o", program, "--json")
        count = json.loads(sliced.stdout)["layers"]
        self.assertEqual(count, 50)
        self.assertEqual(self.reported("check", program)["findings"], [])
        with open(program) as file:
            lines = file.readlines()
        cut = lines.index(";LAYER:25\n")
        with open(program, "w") as file:
            file.writelines(lines[:cut])
        findings = self.reported("check", program)["findings"]
        self.assertEqual([(found["what"], found["layer"], found["line"]) for found in findings], [("ends early", 24, cut)])
        self.assertIn("states 50 layers and ends in layer 24", findings[0]["reason"])
        shown = run("check", program).stdout
        self.assertIn("ends early  line %d, layer 24, " % cut, shown)
        self.assertIn("the machine can run it as far as it goes", shown)

    def test_what_can_be_run_takes_its_time(self):
        points = self.write([(0, 0, 0.2), (40, 0, 0.2)])
        for machine in ("irb_4600", "five_axis_head_ac", "rus_platform", "cartesian_gantry"):
            reported = self.reported("check", points, "--machine", machine)
            self.assertEqual(reported["machine"], machine)
            self.assertEqual(reported["waypoints"], 2)
            self.assertEqual(reported["findings"], [])
            self.assertGreater(reported["time_s"], 40.0 / 20.0)
        self.assertIn("the machine can run it", run("check", points, "--machine", "irb_4400").stdout)

    def test_the_nozzle_is_written_over_time(self):
        points = self.write([(0, 0, 0.2), (40, 0, 0.2)])
        for machine in ("irb_4600", "cartesian_gantry"):
            table = self.path(machine + ".csv")
            reported = self.reported("check", points, "--machine", machine, "--set", "part.placement=as_is", "--trajectory", table,
                             "--rate-hz", "500")
            rows = [{name: float(value) for name, value in row.items()} for row in self.listed(table)]
            self.assertEqual(list(rows[0]), "t,x,y,z,qw,qx,qy,qz,v,flow_mm3_s,laser,wire,powder,gas".split(","))
            if machine == "irb_4600":  # a gantry's firmware plans without its joints
                self.assertAlmostEqual(rows[-1]["t"], reported["time_s"], places=5)
            self.assertAlmostEqual(rows[0]["x"], 0.0, places=3)
            self.assertAlmostEqual(rows[-1]["x"], 40.0, places=3)
            for row, after in zip(rows, rows[1:-1]):
                self.assertAlmostEqual(after["t"] - row["t"], 0.002, places=5)
                self.assertAlmostEqual(row["z"], 0.2, delta=0.02)
                self.assertAlmostEqual(after["x"] - row["x"], 0.001 * (row["v"] + after["v"]), delta=0.002)
            amid = rows[len(rows) // 2]
            self.assertAlmostEqual(amid["v"], 20.0, delta=0.1)
            self.assertAlmostEqual(amid["flow_mm3_s"], amid["v"] * 0.0714, delta=0.05)

    def test_slice_and_check_say_the_same_time(self):
        for machine in ("prusa_mk3s", "open5x_i3", "creality_ender_3"):
            program = self.path(machine + ".gcode")
            sliced = self.reported("slice", "box", "--machine", machine, "-o", program)["estimated_time_s"]
            for checked in ("box", program):
                time_s = self.reported("check", checked, "--machine", machine)["time_s"]
                self.assertAlmostEqual(time_s, sliced, delta=(0.001 if checked == "box" else 0.01) * sliced, msg=checked)
        self.assertEqual(self.time_line("slice", "box"), self.time_line("check", "box"))

    def time_line(self, *arguments):
        return next(line for line in run(*arguments).stdout.splitlines() if line.startswith("print time"))

    def test_no_trajectory_of_what_cannot_be_run(self):
        table = self.path("nozzle.csv")
        points = self.write([(0, 0, 50), (0, 0, -25), (10, 0, -25)], "travel", 0)
        self.reported("check", points, "--machine", "irb_4600", "--set", "part.placement=as_is", "--trajectory", table,
                  code=2)
        self.assertFalse(os.path.exists(table))
        done = run("check", points, "--machine", "irb_4600", "--set", "part.placement=as_is", "--trajectory", table)
        self.assertIn("nozzle.csv is not written", done.stderr)
        self.assertIn("requires --trajectory", run("check", points, "--machine", "irb_4600", "--rate-hz", "100").stderr)

    def test_waiting_counts(self):
        def taking(waiting, machine):
            program = self.path("waits.gcode")
            with open(program, "w") as file:
                file.write("G0 X110 Y110 Z0.2 F600\n;LAYER:0\nG1 X140 E1\n" + waiting + "G0 X140 Y160\nG1 X110 E1\n")
            return self.reported("check", program, "--machine", machine)["time_s"]
        for machine in ("five_axis_head_ac", "cartesian_gantry"):
            more = taking("G4 P3500\n", machine) - taking("", machine)
            self.assertGreaterEqual(more, 3.5)
            self.assertLess(more, 3.52)  # it also comes to rest in the corner where it waits

    def test_a_part_is_sliced_for_the_machine(self):
        reported = self.reported("check", "box", "--machine", "irb_4600", "--set", "slicing.layer_height_mm=1", "--set",
                         "slicing.first_layer_height_mm=1", "--set", "bead.width_mm=2")
        self.assertGreater(reported["waypoints"], 80)
        self.assertEqual(reported["faulty_waypoints"], 0)

    def test_all_waypoints_out_of_reach_are_reported(self):
        points = self.write([(i, 0, 0.2) for i in range(20)] + [(1e5 + i, 0, 0.2) for i in range(15)])
        report = self.path("report.csv")
        arguments = ("check", points, "--machine", "irb_4600", "--set", "part.placement=as_is", "--set",
                     "joints.max_step_mm=100000", "--report", report)
        reported = self.reported(*arguments, code=2)
        self.assertEqual(reported["faulty_waypoints"], 15)
        self.assertIsNone(reported["time_s"])
        unreached = [finding["waypoint"] for finding in reported["findings"] if finding["what"] == "out_of_reach"]
        self.assertEqual(unreached, list(range(20, 35)))
        self.assertEqual([int(row["waypoint"]) for row in self.listed(report)], unreached)
        done = run(*arguments)
        self.assertEqual(done.returncode, 2)
        self.assertIn("out_of_reach at 15 waypoints", done.stdout)
        self.assertIn("the machine cannot run it", done.stdout)

    def test_what_collides_is_reported(self):
        points = self.write([(0, 0, 50), (0, 0, -25), (10, 0, -25)], "travel", 0)
        report = self.path("report.csv")
        reported = self.reported("check", points, "--machine", "irb_4600", "--set", "part.placement=as_is", "--report",
                         report, code=2)
        self.assertEqual(reported["faulty_waypoints"], 0)
        self.assertEqual([finding["waypoint"] for finding in reported["findings"]], [1, 2])
        self.assertEqual([row["what"] for row in self.listed(report)], ["collision", "collision"])
        self.assertIn("the bed", self.listed(report)[0]["reason"])

    def test_what_cannot_be_checked_is_refused(self):
        points = self.write([(0, 0, 0.2), (40, 0, 0.2)])
        names = sorted(os.listdir(self.folder.name))
        for code, arguments in (("InvalidConfig", [points, "--machine", "nowhere"]),
                                ("FileError", [self.path("none.csv"), "--machine", "irb_4600"]),
                                ("InvalidInput", [points, "--machine", "irb_4600", "--report", points]),
                                ("InvalidInput", [points, "--machine", "irb_4600", "--trajectory", points]),
                                ("InvalidInput", [points, "--machine", "irb_4600", "--trajectory", self.path("t.txt")]),
                                ("InvalidConfig", [points, "--machine", "irb_4600", "--trajectory", self.path("t.csv"),
                                                   "--rate-hz", "20"]),
                                ("InvalidConfig", [points, "--machine", "irb_4600", "--set", "joints.yaw_samples=0"])):
            done = run("check", *arguments, "--json")
            self.assertNotIn(done.returncode, (0, 2), arguments)
            reported = json.loads(done.stdout)
            self.assertEqual(reported["error"]["code"], code, reported)
            self.assertEqual(sorted(os.listdir(self.folder.name)), names, arguments)
        self.assertIn("irb_4400", run("check", points, "--machine", "nowhere").stderr)

    def test_a_toolpath_is_tracked_by_the_platform(self):
        points = self.write([(50, 60, 0.2), (70, 60, 0.2)])
        reported = self.reported("track", points)
        # From rest to rest: 20 mm at 20 mm/s, up to it and down from it at 1000 mm/s2.
        self.assertAlmostEqual(reported["duration_s"], 1.0 + 20.0 / 1000.0, places=9)
        for figure in ("linear_ise_mm2_s", "control_energy_nm2_s", "greatest_torque_nm", "greatest_tip_error_mm"):
            self.assertGreater(reported[figure], 0.0)
        self.assertLess(reported["greatest_tip_error_mm"], 1.0)
        self.assertIn("1.020 s", run("track", points).stdout)
        moved = self.reported("track", self.write([(-10, 0, 0.2), (10, 0, 0.2)]), "--middle", "60,60")
        self.assertAlmostEqual(moved["control_energy_nm2_s"], reported["control_energy_nm2_s"], places=9)

    def test_what_the_platform_cannot_track_is_refused(self):
        points = self.write([(50, 60, 0.2), (70, 60, 0.2)])
        for code, arguments in (("Unreachable", [points, "--middle", "500,60"]),
                                ("InvalidConfig", [points, "--set", "controller.k1=0"]),
                                ("InvalidConfig", [points, "--set", "controller.k3=1e9"]),
                                ("InvalidConfig", [points, "--urdf", points]),
                                ("FileError", [self.path("none.csv")])):
            done = run("track", *arguments, "--json")
            self.assertEqual(done.returncode, 1, arguments)
            self.assertEqual(json.loads(done.stdout)["error"]["code"], code, arguments)


if __name__ == "__main__":
    unittest.main()
