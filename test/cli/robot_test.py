# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots on the command line: a maker's description expanded, what the robot is, and the rest of its program.

    robot_test.py LAMINA
"""
import json
import os
import re
import shutil
import tempfile
import unittest

from lamina_command import lamina, reported

JOINT = """<xacro:joint_of number="{0}" parent="{1}" xyz="{2}" axis="{3}"/>"""
TUBE = ("machine.name=irb_4600", "slicing.layer_height_mm=0.8", "slicing.first_layer_height_mm=0.8", "bead.width_mm=1.6",
        "infill.density=0", "skirt.count=0", "skins.top_layers=0", "skins.bottom_layers=0", "feed.outer_wall_mm_s=25",
        "feed.inner_wall_mm_s=25")
CHAIN = ("0 0 0.1807", "0 0 1"), ("0 0.176 0", "0 1 0"), ("0.6127 -0.137 0", "0 1 0"), ("0.57155 0 0", "0 1 0"), ("0 0.135 0", "0 0 -1"), (
    "0 0 -0.12", "0 1 0")
MACRO = """<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:macro name="joint_of" params="number parent xyz axis
  mark:='$(find maker)/marks and more.yaml'">
<xacro:property name="of_no_use" value="${load_yaml('')}"/><link name="link_${number}"/><joint name="axis_${number}" type="revolute"><parent link="${parent}"/><child link="link_${number}"/>
<origin xyz="${xyz}"/><axis xyz="${axis}"/><limit lower="${-pi}" upper="${pi}" velocity="${radians(120)}"/></joint></xacro:macro></robot>"""


class Robot(unittest.TestCase):
    def test_xacro_becomes_a_robot_of_a_class(self):
        with tempfile.TemporaryDirectory() as folder:
            package = os.path.join(folder, "packages", "maker")
            os.makedirs(package)
            with open(os.path.join(package, "joints.xacro"), "w", encoding="utf-8") as file:
                file.write(MACRO)
            joints = "".join(JOINT.format(i + 1, f"link_{i}" if i else "base_link", *each) for i, each in enumerate(CHAIN))
            source, urdf = os.path.join(folder, "arm.xacro"), os.path.join(folder, "arm.urdf")
            with open(source, "w", encoding="utf-8") as file:
                file.write('<robot name="$(arg name)" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:include '
                           f'filename="$(find maker)/joints.xacro"/><link name="base_link"/>{joints}</robot>')
            lamina("expand", source, "name:=tried", "--packages", os.path.join(folder, "packages"), "-o", urdf)
            written = os.path.join(folder, "one.urdf")
            report = json.loads(lamina("robot", urdf, "--write", written, "--json").stdout)
            self.assertEqual(report["name"], "tried")
            self.assertEqual(report["class"], "three parallel axes")
            self.assertEqual([joint["name"] for joint in report["joints"]], [f"axis_{i}" for i in range(1, 7)])
            self.assertAlmostEqual(report["joints"][0]["speed"], 120.0)
            self.assertTrue(os.path.exists(written))
            self.assertEqual(report["built_in"], [])
            trial = json.loads(lamina("robot", urdf, "--poses", "50", "--json").stdout)["inverse"]
            self.assertEqual((trial["poses"], trial["reached"], trial["ends"]), (50, 50, True))
            self.assertEqual(trial["regular_recovered"], trial["regular"])
            self.assertLess(trial["tip_error_mm"], 1e-6)
            self.assertLess(trial["turn_error_rad"], 1e-9)
            self.assertIn("inverse    50 of 50 poses reached", lamina("robot", urdf, "--poses", "50").stdout)
            self.lists_what_is_built_in(urdf)

    def lists_what_is_built_in(self, urdf):
        """A flange within the fork of link 4, whatever the joints between them."""
        with open(urdf, encoding="utf-8") as file:
            text = file.read()
        for link, shape in (("link_4", '<box size="0.5 0.5 0.5"/>'), ("link_6", '<sphere radius="0.02"/>')):
            text = re.sub(f'<link name="{link}" ?/>', f'<link name="{link}"><collision><geometry>{shape}</geometry></collision></link>', text)
        with open(urdf, "w", encoding="utf-8") as file:
            file.write(text)
        self.assertEqual(json.loads(lamina("robot", urdf, "--json").stdout)["built_in"], [["link_4", "link_6"]])
        self.assertIn("unchecked  link_4 against link_6, built into each other\n", lamina("robot", urdf).stdout)

    def test_an_arm_of_seven_axes_runs_a_toolpath_and_no_program(self):
        arm = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "robots", "seven_axis_arm.urdf")
        report = json.loads(lamina("robot", arm, "--json").stdout)
        self.assertEqual(report["class"], "seven axes, spherical shoulder and wrist")
        self.assertIn("arm angle", report["redundancy"])
        self.assertEqual(len(report["joints"]), 7)
        self.assertIn("redundancy arm angle", lamina("robot", arm).stdout)
        with tempfile.TemporaryDirectory() as folder:
            part, points = os.path.join(folder, "tube.stl"), os.path.join(folder, "tube.csv")
            lamina("part", "tube", "--set", "radius_mm=50", "--set", "inner_radius_mm=46.8", "--set", "height_mm=1.6", "-o", part)
            settings = [word for setting in TUBE[1:] for word in ("--set", setting)]
            sliced = lamina("slice", part, "--machine", arm, *settings, "-o", points)
            self.assertEqual(sliced.returncode, 0, sliced.stderr)
            checked = lamina("check", points, "--machine", arm)
            self.assertEqual(checked.returncode, 0, checked.stderr)
            self.assertIn("the machine can run it", checked.stdout)
            refused = lamina("slice", part, "--machine", arm, *settings, "-o", os.path.join(folder, "tube.src"))
            self.assertNotEqual(refused.returncode, 0)
            self.assertIn("an arm of seven axes", refused.stderr)

    def test_check_tells_how_near_fences_are_and_what_hangs(self):
        examples = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "robots")
        with tempfile.TemporaryDirectory() as folder:
            part, points, cell = (os.path.join(folder, name) for name in ("tube.stl", "tube.csv", "cell"))
            shutil.copytree(os.path.join(examples, "tilting_cell"), cell)
            lamina("part", "tube", "--set", "radius_mm=50", "--set", "inner_radius_mm=46.8", "--set", "height_mm=1.6", "-o", part)
            lamina("slice", part, *(word for setting in TUBE[1:] for word in ("--set", setting)), "-o", points)
            self.write_wall(os.path.join(cell, "wall.stl"))
            with open(os.path.join(cell, "cell.yaml"), encoding="utf-8") as file:
                text = file.read()
            found = {}
            # Beyond the part, across: as much farther as it stands farther.
            for x_mm in (2000, 2300):
                with open(os.path.join(cell, "cell.yaml"), "w", encoding="utf-8") as file:
                    file.write(text.replace("  bed:", f"  bodies: [{{mesh: wall.stl, xyz_mm: [{x_mm}, 0, 0]}}]\n  bed:"))
                found[x_mm] = reported("check", points, "--machine", os.path.join(cell, "cell.yaml"))
            nearest = found[2000]["nearest_body"]
            self.assertEqual(nearest["body"], 1)
            self.assertAlmostEqual(found[2300]["nearest_body"]["distance_mm"] - nearest["distance_mm"], 300.0, delta=0.01)
            self.assertIn(f"comes to {found[2300]['nearest_body']['distance_mm']:.1f} mm of body 1 of the cell",
                          lamina("check", points, "--machine", os.path.join(cell, "cell.yaml")).stdout)
            self.assertEqual(found[2000]["overhang_mm"], 0.0)
            self.hangs_aside(points)

    def write_wall(self, path):
        """A triangle at x = 0, 4 m wide and 4 m high, of no thickness."""
        with open(path, "w", encoding="utf-8") as file:
            corners = "".join(f"vertex 0 {y} {z}\n" for y, z in ((-2000, -100), (2000, -100), (0, 8000)))
            file.write(f"solid wall\nfacet normal 1 0 0\nouter loop\n{corners}endloop\nendfacet\nendsolid wall\n")

    def hangs_aside(self, points):
        """A bead of 60 mm, and one of 80 mm on its end."""
        rows = [(0, 0, "outer_wall", 0.0, 0.8), (0, 0, "outer_wall", 60.0, 0.8), (0, 1, "travel", 60.0, 0.8), (0, 1, "travel", 60.0, 1.6),
                (1, 0, "outer_wall", 60.0, 1.6), (1, 0, "outer_wall", 140.0, 1.6)]
        with open(points, "w", encoding="utf-8") as file:
            file.write("layer,path,role,closed,x_mm,y_mm,z_mm,qw,qx,qy,qz,bead_width_mm,bead_height_mm,feed_mm_s\n")
            for layer, path, role, x_mm, z_mm in rows:
                bead = "0,0,100" if role == "travel" else "1.6,0.8,20"
                file.write(f"{layer},{path},{role},0,{x_mm},0,{z_mm},0,1,0,0,{bead}\n")
        hanging = reported("check", points, "--machine", "irb_4600")
        self.assertIsNone(hanging["nearest_body"])
        # The bead below ends half a width behind its end, and a quarter more is enough.
        self.assertAlmostEqual(hanging["overhang_mm"], 80.0 - 0.75 * 1.6, delta=0.3)
        self.assertEqual(hanging["longest_overhang_mm"], hanging["overhang_mm"])
        self.assertIn("overhang    1 stretch, ", lamina("check", points, "--machine", "irb_4600").stdout)

    def test_the_rest_of_a_program_is_a_program_of_its_own(self):
        with tempfile.TemporaryDirectory() as folder:
            part = os.path.join(folder, "tube.stl")
            lamina("part", "tube", "--set", "radius_mm=50", "--set", "inner_radius_mm=46.8", "--set", "height_mm=2.4", "-o", part)
            for suffix in ("src", "script", "ls", "jbi", "mod"):
                whole, rest = (os.path.join(folder, f"{name}.{suffix}") for name in ("whole", "rest"))
                sliced = lamina("slice", part, *(word for setting in TUBE for word in ("--set", setting)), "-o", whole)
                self.assertEqual(sliced.returncode, 0, sliced.stderr)
                resumed = reported("resume", whole, "--from-layer", "1", "--machine", "irb_4600", "-o", rest)
                self.assertEqual([resumed["from_layer"], resumed["from_path"], resumed["from_waypoint"]], [1, 0, 0])
                self.assertEqual(resumed["files"], [f"rest.{suffix}"])
                # Walls of 128 waypoints, travels of 2 between and of 3 between layers; the first travel is left out.
                self.assertEqual(reported("check", whole, "--machine", "irb_4600")["waypoints"], 258 + 261 + 261, suffix)
                checked = reported("check", rest, "--machine", "irb_4600")
                self.assertEqual(checked["waypoints"], 258 + 261, suffix)
                self.assertEqual(checked["faulty_waypoints"], 0, suffix)
            self.go_on_amid_a_wall(os.path.join(folder, "whole.src"), os.path.join(folder, "rest.src"))

    def go_on_amid_a_wall(self, whole, rest):
        with open(whole, encoding="utf-8") as file:
            lines = file.read().splitlines()
        second = next(i for i, line in enumerate(lines) if line.startswith(";# layer 1.6"))
        moves = [i + 1 for i, line in enumerate(lines) if i > second and line.startswith("LIN ")]
        # Two moves of a travel, then those of the wall: the twentieth sets out from waypoint 17.
        resumed = reported("resume", whole, "--from-line", str(moves[19]), "--machine", "irb_4600", "-o", rest)
        self.assertEqual([resumed["from_layer"], resumed["from_path"], resumed["from_waypoint"]], [1, 1, 17])
        self.assertEqual(reported("check", rest, "--machine", "irb_4600")["waypoints"], 112 + 2 + 128 + 261)
        with open(rest, encoding="utf-8") as file:
            moved = [line for line in file.read().splitlines() if line.startswith("LIN ")]
        # To the waypoint, by the approach; then as before.
        self.assertEqual(moved[1].split(",A")[0], lines[moves[19] - 1].split(",A")[0])
        self.assertEqual(reported("resume", whole, "--from-line", str(moves[19]), "--of-file", "WHOLE", "--machine", "irb_4600", "-o", rest)["from_waypoint"], 17)
        for wrong, says in ((("--from-line", "9", "--of-file", "whole_2"), "no file 'whole_2'"), (("--from-layer", "3"), "layers 0 to 2"), (("--from-layer", "1", "--nozzle-height", "5"), "--nozzle-height"),
                            (("--from-layer", "1", "--set", "robot_program.process_output=2"), "output 2")):
            refused = lamina("resume", whole, *wrong, "--machine", "irb_4600", "-o", rest)
            self.assertNotEqual(refused.returncode, 0)
            self.assertIn(says, refused.stderr)


if __name__ == "__main__":
    unittest.main()
