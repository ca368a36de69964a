# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""A maker's description on the command line: xacro expanded, and what the robot is.

    robot_test.py LAMINA
"""
import json
import os
import tempfile
import unittest

from lamina_command import lamina

JOINT = """<xacro:joint_of number="{0}" parent="{1}" xyz="{2}" axis="{3}"/>"""
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


if __name__ == "__main__":
    unittest.main()
