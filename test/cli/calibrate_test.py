"""`lamina calibrate` as a person runs it: programs to record, and recordings as tables."""
import json
import math
import os
import re
import tempfile
import unittest

from lamina_command import lamina, motions, reported

LATE = 0.12  # s


def height(time):
    """Of a nozzle that bobs ever faster about 5 mm."""
    phase = 0.5 * time + 0.075 * time * time
    return 5.0 + 2.0 * math.asin(math.sin(2.0 * math.pi * phase)) * 2.0 / math.pi


def write_bobbing(folder):
    with open(os.path.join(folder, "poses.csv"), "w", encoding="ascii") as poses:
        poses.write("time_s,x_mm,y_mm,z_mm\n")
        for i in range(1001):
            poses.write(f"{100.0 + 0.01 * i!r},75,100,{height(0.01 * i)!r}\n")
    with open(os.path.join(folder, "profiles.csv"), "w", encoding="ascii") as profiles:
        profiles.write("# depth of a bed 60 mm under the nozzle's tip\ntime_s,x_mm,z_mm\n")
        for i in range(2001):
            for x in (-10, 0, 10):
                profiles.write(f"{100.0 + LATE + 0.005 * i!r},{x},{60.0 + height(0.005 * i)!r}\n")


def pyramid(x, y):
    """40 mm wide at its base, 20 mm at its top, 10 mm high, about 100, 100."""
    return min(10.0, max(0.0, 20.0 - max(abs(x - 100.0), abs(y - 100.0))))


def write_scan(folder, surface):
    """Swaths along y at two heights over a surface by a sensor that sits 1 mm farther along x than it should."""
    os.makedirs(folder, exist_ok=True)
    time = 0.0
    with open(os.path.join(folder, "poses.csv"), "w", encoding="ascii") as poses, \
            open(os.path.join(folder, "profiles.csv"), "w", encoding="ascii") as profiles:
        poses.write("time_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n")
        profiles.write("z_mm,x_mm,y_mm,time_s\n")
        for z in (12.0, 20.0):
            for x in (60.0, 75.0, 90.0):
                time += 5.0
                for y in range(70, 131):
                    time += 0.05
                    poses.write(f"{time!r},{x},{y},{z},0,1,0,0\n")
                    for across in range(-14, 15):
                        depth = z + 60.0 - surface(x + 26.0 + across, y)
                        profiles.write(f"{depth!r},{across},0,{time!r}\n")


class Calibrate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_finds_how_late_the_stamps_of_tables_are(self):
        write_bobbing(self.folder)
        found = reported("calibrate", "time", self.folder, "-o", self.path("cell.yaml"), "--sensor", "profiler 7")
        self.assertAlmostEqual(found["time_offset_s"], LATE, delta=0.0002)
        self.assertLess(found["spread_s"], 0.0005)
        with open(self.path("cell.yaml"), encoding="ascii") as file:
            cell = file.read()
        self.assertIn("machine: cartesian_gantry", cell)
        self.assertIn("sensor: profiler 7", cell)
        self.assertIn("time_offset_method: bobbing", cell)
        again = lamina("calibrate", "time", self.folder, "-o", self.path("cell.yaml"))
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("time offset 120.0", again.stdout)
        with open(self.path("cell.yaml"), encoding="ascii") as file:
            self.assertIn("sensor: profiler 7", file.read())

    def test_finds_where_the_sensor_sits_by_a_touched_pyramid(self):
        write_scan(self.path("scan"), pyramid)
        write_scan(self.path("bare"), lambda x, y: 0.0)
        found = reported("calibrate", "sensor", self.path("scan"), "--method", "pyramid", "--pyramid", "40,20,10", "--at", "100,100",
                     "--top", "10", "--with-plane", self.path("bare"), "-o", self.path("cell.yaml"))
        for value, truth in zip(found["xyz_mm"], (26.0, 0.0, -60.0)):
            self.assertAlmostEqual(value, truth, delta=0.05)
        self.assertAlmostEqual(abs(found["quaternion_wxyz"][0]), 1.0, delta=1e-6)
        self.assertEqual(found["kept"], "")
        self.assertEqual(len(found["directions"]), 6)
        bed = lamina("calibrate", "sensor", self.path("bare"), "--method", "bed")
        self.assertEqual(bed.returncode, 0, bed.stderr)
        self.assertIn("kept        x of the nozzle is not observable", bed.stdout)
        wrong = lamina("calibrate", "sensor", self.path("scan"), "--method", "pyramid", "--pyramid", "20,40,10")
        self.assertIn("base wider than the top", wrong.stderr)

    def write_touches(self, errors):
        """Of a tip 12, -7, 250 mm from the flange that touches 900, 150, 400 mm, tilted by 40 deg all round."""
        with open(self.path("tip.csv"), "w", encoding="ascii") as table:
            table.write("x_mm,y_mm,z_mm,qw,qx,qy,qz\n")
            for i in range(8):
                about = math.radians(45.0 * i)
                half = math.radians(20.0)
                w, x, y = math.cos(half), math.sin(half) * math.cos(about), math.sin(half) * math.sin(about)
                turned = ((1 - 2 * y * y) * 12 + 2 * x * y * -7 + 2 * w * y * 250,
                          2 * x * y * 12 + (1 - 2 * x * x) * -7 - 2 * w * x * 250,
                          -2 * w * y * 12 + 2 * w * x * -7 + (1 - 2 * x * x - 2 * y * y) * 250)
                at = [900 - turned[0] + errors.get(i, 0.0), 150 - turned[1], 400 - turned[2]]
                table.write(",".join(repr(value) for value in (*at, w, x, y, 0.0)) + "\n")

    def test_finds_the_tip_of_a_tool_that_touches_a_point(self):
        self.write_touches({})
        found = reported("calibrate", "tcp", self.path("tip.csv"))
        for value, truth in zip(found["xyz_mm"] + found["point_mm"], (12.0, -7.0, 250.0, 900.0, 150.0, 400.0)):
            self.assertAlmostEqual(value, truth, delta=1e-9)
        self.assertEqual(found["outlying_lines"], [])
        self.write_touches({3: 4.0})
        refused = lamina("calibrate", "tcp", self.path("tip.csv"))
        self.assertEqual(refused.returncode, 1)
        self.assertIn("line 5", refused.stderr)
        self.assertIn("expected at most 1 mm", refused.stderr)
        wide = reported("calibrate", "tcp", self.path("tip.csv"), "--greatest-mm", "5")
        self.assertEqual((wide["touches"], wide["greatest_line"], wide["outlying_lines"]), (8, 5, [5]))
        dropped = reported("calibrate", "tcp", self.path("tip.csv"), "--drop")
        self.assertEqual(dropped["outlying_lines"], [5])
        self.assertEqual(dropped["touches"], 7)
        self.assertAlmostEqual(dropped["xyz_mm"][2], 250.0, delta=1e-9)
        said = lamina("calibrate", "tcp", self.path("tip.csv"), "--drop")
        self.assertIn("tool: {xyz_mm: [12.000, -7.000, 250.000]}", said.stdout)

    def test_finds_a_work_object_by_axes_and_by_known_points(self):
        with open(self.path("axes.csv"), "w", encoding="ascii") as table:
            table.write("x_mm,y_mm,z_mm\n100,50,10\n100,250,10\n20,80,10\n")
        foot = reported("calibrate", "object", self.path("axes.csv"))
        self.assertEqual([round(value, 9) for value in foot["xyz_mm"]], [100, 80, 10])
        self.assertEqual([round(value, 9) for value in foot["rpy_deg"]], [0, 0, 90])
        first = reported("calibrate", "object", self.path("axes.csv"), "--origin", "first")
        self.assertEqual([round(value, 9) for value in first["xyz_mm"]], [100, 50, 10])
        with open(self.path("known.csv"), "w", encoding="ascii") as table:
            table.write("x_mm,y_mm,z_mm,object_x_mm,object_y_mm,object_z_mm\n")
            for x, y, z in ((0, 0, 0), (200, 0, 0), (200, 100, 0), (0, 100, 50)):
                table.write(f"{500 - y},{x},{20 + z},{x},{y},{z}\n")
        known = lamina("calibrate", "object", self.path("known.csv"))
        self.assertEqual(known.returncode, 0, known.stderr)
        self.assertIn("bed: {xyz_mm: [500.000, 0.000, 20.000], rpy_deg: [0.0000, 0.0000, 90.0000]}", known.stdout.replace("-0.0", "0.0"))
        with open(self.path("two.csv"), "w", encoding="ascii") as table:
            table.write("x_mm,y_mm,z_mm\n1,2,3\n4,5,6\n")
        self.assertIn("has 2 points; expected 3", lamina("calibrate", "object", self.path("two.csv")).stderr)

    def test_finds_the_axes_of_positioner_and_rail(self):
        with open(self.path("table.csv"), "w", encoding="ascii") as table:
            table.write("angle_deg,x_mm,y_mm,z_mm\n")
            for angle in (-90, -30, 0, 60, 120):
                turned = math.radians(angle)
                table.write(f"{angle},{1600 + 150 * math.cos(turned)!r},{-20 - 150 * math.sin(turned)!r},700\n")
        found = reported("calibrate", "positioner", self.path("table.csv"))
        for value, truth in zip(found["axis"] + found["centre_mm"], (0, 0, -1, 1600, -20, 700)):
            self.assertAlmostEqual(value, truth, delta=1e-6)
        self.assertAlmostEqual(found["radius_mm"], 150.0, delta=1e-6)
        self.assertEqual((found["touches"], found["outlying_lines"]), (5, []))
        said = lamina("calibrate", "positioner", self.path("table.csv"))
        self.assertIn("positioner: {xyz_mm: [1600.000, -20.000, 700.000], rpy_deg: [", said.stdout)
        self.assertIn("not found   its height along the axis", said.stdout)
        with open(self.path("rail.csv"), "w", encoding="ascii") as table:
            table.write("rail_mm,x_mm,y_mm,z_mm\n")
            for value in (0, 500, 1000, 1500, 2000):
                table.write(f"{value},{900 - value},{100 + (4 if value == 1500 else 0)},300\n")
        refused = lamina("calibrate", "rail", self.path("rail.csv"))
        self.assertEqual(refused.returncode, 1)
        self.assertIn("line 5", refused.stderr)
        dropped = lamina("calibrate", "rail", self.path("rail.csv"), "--drop")
        self.assertIn("rail: {axis: [1.000000, 0.000000, 0.000000]}", dropped.stdout.replace("-0.0", "0.0"))
        self.assertIn("outlying    line 5", dropped.stdout)

    def test_refuses_the_calibration_of_another_machine(self):
        write_bobbing(self.folder)
        reported("calibrate", "time", self.folder, "-o", self.path("cell.yaml"))
        other = lamina("calibrate", "time", self.folder, "-o", self.path("cell.yaml"), "--set",
                       "machine.name=large_gantry_45")
        self.assertEqual(other.returncode, 1)
        self.assertIn("cartesian_gantry", other.stderr)

    def test_reports_what_is_missing(self):
        for arguments, words in ((("calibrate", "time", self.folder), "poses.csv"),
                                 (("calibrate", "plan", "bobbing"), "no output"),
                                 (("calibrate", "plan", "cross", "-o", self.path("a.gcode"), "--set", "calibrate.x_mm=5000"),
                                  "reaches"),
                                 (("calibrate", "plan", "edge", "-o", self.path("a.gcode"), "--set",
                                   "machine.name=large_gantry_45"), "straight down"),
                                 (("calibrate", "plan", "edge", "-o", self.path("a.gcode"), "--machine", "large_gantry_45"),
                                  "straight down"),
                                 (("calibrate", "plan", "edge", "-o", self.path("a.gcode"), "--machine", "drop_printer", "--set",
                                   "machine.name=cartesian_gantry"), "--machine is 'drop_printer'"),
                                 (("calibrate", "time", self.path("nowhere")), "nowhere' is no folder; expected one with poses.csv"),
                                 (("calibrate", "time", self.path("none.bag")), "none.bag")):
            done = lamina(*arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(words, done.stderr)
            self.assertEqual(len(re.findall(r"(?:^|: )[A-Z]\w+: ", done.stderr)), 1, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)

    def test_plans_what_is_to_be_recorded(self):
        for kind in ("bobbing", "edge", "cross", "feeder"):
            plan = reported("calibrate", "plan", kind, "-o", self.path(kind + ".gcode"))
            with open(self.path(kind + ".gcode"), encoding="ascii") as file:
                run = motions(file.read())
            deposited = sum(math.dist(motion.start, motion.end) for motion in run if motion.lays())
            self.assertAlmostEqual(deposited, plan["deposition_mm"], delta=0.1)
            self.assertEqual(deposited > 0.0, kind != "bobbing")
            if kind == "bobbing":
                heights = [motion.end[2] for motion in run]
        self.assertGreater(sum(a != b for a, b in zip(heights, heights[1:])), 20)

    def test_settings_are_listed(self):
        listed = json.loads(lamina("calibrate", "plan", "bobbing", "--print-config", "--json").stdout)
        self.assertEqual(listed["calibrate.bob_s"], 10.0)

    def test_programs_are_those_of_the_machine_named(self):
        listed = json.loads(lamina("calibrate", "plan", "bobbing", "--print-config", "--json", "--machine", "creality_ender_3").stdout)
        of_machine = json.loads(lamina("slice", "--print-config", "--json", "--machine", "creality_ender_3").stdout)
        for key in ("machine.name", "program.dialect", "program.bed_temperature_c"):
            self.assertEqual(listed[key], of_machine[key], key)

    def test_the_flow_is_found_by_the_thickness_of_walls(self):
        program = os.path.join(self.folder, "flow.gcode")
        plan = reported("calibrate", "plan", "flow", "-o", program)
        self.assertEqual(plan["multipliers"], [0.85, 0.9, 0.95, 1.0, 1.05, 1.1, 1.15])
        # Seven squares of 60 mm in 30 layers, of 0.45 x 0.2 mm with round sides at a multiplier of 1.
        self.assertAlmostEqual(plan["deposition_mm"], 7 * 30 * 60, delta=1e-6 * 12600)
        core = 0.45 - (1 - math.pi / 4) * 0.2
        self.assertAlmostEqual(plan["deposited_mm3"], 12600 * 0.2 * core, delta=0.1)
        walls = os.path.join(self.folder, "walls.csv")
        with open(walls, "w", encoding="ascii") as table:
            table.write("multiplier,thickness_mm\n")
            for multiplier in plan["multipliers"]:
                table.write(f"{multiplier},{0.9 * multiplier * core + (1 - math.pi / 4) * 0.2!r}\n")
        found = reported("calibrate", "flow", walls)
        self.assertAlmostEqual(found["share"], 0.9, delta=1e-6)
        self.assertAlmostEqual(found["flow"], 1 / 0.9, delta=1e-6)
        self.assertEqual((found["readings"], found["caution"]), (7, ""))
        with open(walls, "a", encoding="ascii") as table:
            table.write("1.0,-0.4\n")
        refused = lamina("calibrate", "flow", walls)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("walls.csv' line 9: thickness_mm is -0.4", refused.stderr)


if __name__ == "__main__":
    unittest.main()
