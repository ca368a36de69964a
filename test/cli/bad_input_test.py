# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""What robots' cells and programs refuse, row by row: by name, with the value and what was expected, and with nothing written.

    bad_input_test.py LAMINA

Of a jog while a job runs `test/ros/drive/changed_drive_test.cpp` has the row: that takes nodes.
"""
import glob
import os
import re
import shutil
import tempfile
import unittest

from lamina_command import lamina

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "robots")
ARM, TABLE = "seam_arm_support/urdf/seam_arm.urdf", "tilting_table_support/urdf/tilting_table.urdf"

# A tube of two layers, as arms lay it.
PART = ("tube", "radius_mm=50", "inner_radius_mm=46.8", "height_mm=1.6")
LAID = ("slicing.layer_height_mm=0.8", "slicing.first_layer_height_mm=0.8", "bead.width_mm=1.6", "infill.density=0", "skirt.count=0",
        "skins.top_layers=0", "skins.bottom_layers=0", "feed.outer_wall_mm_s=25", "feed.inner_wall_mm_s=25", "levels.wire_diameter_mm=1.2")


def edited(name, old, new):
    """Puts text into a file of the cell in place of another."""
    def edit(folder):
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        assert old in text, (name, old)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new, 1))
    return edit


def without_axis(folder):
    """Five driven joints: the last is fixed."""
    path = os.path.join(folder, ARM)
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = re.sub(r'(<joint name="joint_6_t" type=)"revolute">(.*?)<axis[^>]*/>\s*<limit[^>]*/>', r'\1"fixed">\2', text, flags=re.S)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def five_axes(folder):
    without_axis(folder)
    edited("cell.yaml", "    flange: tool0\n  pos", "    flange: tool0\n    flange_turn_deg: [0, 0, 0]\n  pos")(folder)


def held_cell(_):
    """As the example stands."""


def long_rail(folder):
    """The bed stands 150 m along a rail."""
    edited("cell.yaml", "  positioner:\n    urdf: tilting_table_support/urdf/tilting_table.urdf\n    flange: tool0\n    xyz_mm: [1150, 0, 0]\n",
           "  rail: {axis: [1, 0, 0], lower_mm: 0, upper_mm: 200000, mm_s: 2000}\n")(folder)
    edited("cell.yaml", "xyz_mm: [0, 0, 20]", "xyz_mm: [150000, 0, 750]")(folder)


def third_axis(folder):
    edited(TABLE, '<joint name="joint_2-tool0" type="fixed">', '<joint name="joint_3" type="continuous"><axis xyz="1 0 0"/><limit velocity="1"/>')(folder)


LOOP = '<link name="ring_1"/><link name="ring_2"/>' + "".join(
    f'<joint name="ring_{a}" type="fixed"><parent link="ring_{a}"/><child link="ring_{b}"/></joint>' for a, b in ((1, 2), (2, 1)))
FLOATING = '<link name="room"/><joint name="float" type="floating"><parent link="room"/><child link="base_link"/></joint>'

# What is wrong, what makes it so, and what the refusal says.
DESCRIPTIONS = (
    ("package not found", edited(ARM, "package://seam_arm_support/meshes/collision/link_3.stl", "package://lost_support/link_3.stl"),
     ("link 'link_3'", "'package://lost_support/link_3.stl', whose package is in none of the folders ")),
    ("mesh not found", edited(ARM, "collision/link_3.stl", "collision/link_33.stl"), ("link 'link_3'", "but there is no file ", "link_33.stl")),
    ("xacro given as URDF", edited(ARM, '<robot name="seam_arm">', '<robot name="seam_arm" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:property name="a" value="1"/>'),
     ("is xacro; expected URDF, as `lamina expand ",)),
    ("mesh of a link in another format", edited(ARM, "collision/link_3.stl", "collision/link_3.step"), ("link 'link_3'", "link_3.step'; expected STL, OBJ or PLY")),
    ("mesh of a link in COLLADA", edited(ARM, "collision/link_3.stl", "collision/link_3.dae"), ("link 'link_3'", "which is COLLADA; expected STL or OBJ")),
    ("mesh of the tool in another format", edited("cell.yaml", "head.stl", "head.step"), ("cell.yaml:14: ", "is 'head.step'; expected STL, OBJ or PLY")),
    ("mesh of a fence in another format", edited("cell.yaml", "  bed:", "  bodies: [{mesh: fence.3ds}]\n  bed:"), ("cell.yaml:15: ", "is 'fence.3ds'; expected STL, OBJ or PLY")),
    ("mesh of a fence that is not there", edited("cell.yaml", "  bed:", "  bodies: [{mesh: fence.stl}]\n  bed:"), ("is 'fence.stl', but there is no file ",)),
    ("chain without the flange", edited("cell.yaml", "flange: tool0", "flange: hand"), ("'seam_arm' has no link 'hand' (flange); expected one of 'base', 'tool0'",)),
    ("two chains", edited(ARM, "</robot>", '<link name="other"/></robot>'), ("links 'base_link', 'other' hang on none; expected one such link, the root",)),
    ("loop", edited(ARM, "</robot>", LOOP + "</robot>"), ("links 'ring_1', 'ring_2' hang on each other in a loop; expected a tree",)),
    ("link of two joints", edited(ARM, "</robot>", '<joint name="rod" type="fixed"><parent link="link_1"/><child link="link_3"/></joint></robot>'),
     ("joint 'rod'", "has the child 'link_3', which hangs on another joint, too")),
    ("root that moves", edited(ARM, "</robot>", FLOATING + "</robot>"), ("joint 'float'", "is of type 'floating'; expected one of revolute, continuous, prismatic, fixed")),
    ("joint without velocity", edited(ARM, ' velocity="3.141593"', ""), ("joint 'joint_2_l'", "has no velocity; expected one in its limit, or in cell.arm.limits")),
    ("limit made wider", edited("cell.yaml", "    flange: tool0\n  pos", "    flange: tool0\n    limits: {joint_3_u: {upper_deg: 200}}\n  pos"),
     ("upper_deg of joint 'joint_3_u' is 200, wider than the 170 of its description; expected a limit within that, or wider: true",)),
    ("skew flange", edited(ARM, 'xyz="0.01 0 0" rpy="0 1.5707963267948966 0"', 'xyz="0.01 0 0"'), ("z of link 'tool0' lies across the last axis; expected cell.arm.flange_turn_deg",)),
    ("positioner of three axes", third_axis, ("tilting_table.urdf has 3 driven joints; expected one or two",)),
    ("unknown controller", edited("cell.yaml", "  bed:", "  controller: {kind: siemens}\n  bed:"), ("is 'siemens'; expected abb, kuka, fanuc, yaskawa or ur",)),
)

WELDED = ("robot_program.process=schedules",)
SWUNG = ("weave.kind=sine", "weave.amplitude_mm=0.7")
LASER = ("levels.values=laser_power_w=1200",)

# What is wrong; the machine, or what makes a cell of it; the file, the settings, and what the refusal says.
PROGRAMS = (
    ("arm of five axes with its yaw held", five_axes, "check", ("joints.yaw=held",), ("'seam_arm' has five axes, none of which is its tool axis; expected free",)),
    ("arm of seven axes without samples", "seven_axis_arm.urdf", "csv", ("joints.redundancy_samples=0",), ("joints.redundancy_samples is '0'; must be an integer in [1, 36]",)),
    ("pulses of two joints", "irb_4600", "jbi", ("inform.pulses_per_deg=1000,1000",), ("inform.pulses_per_deg is '1000,1000'; must be 6 numbers",)),
    ("pulses of 0", "irb_4600", "jbi", ("inform.pulses_per_deg=1000,1000,1000,0,1000,1000",), ("inform.pulses_per_deg holds 0; must be",)),
    ("name that begins with a digit", "irb_4600", "src", ("robot_program.name=9tube",), ("the program's name is '9tube'", "must be a letter, then letters, digits and underscores, at most 24 in KRL")),
    ("name that is a word", "irb_4600", "src", ("robot_program.name=loop",), ("the program's name is 'loop'", "a word of KRL itself")),
    ("speed beyond 2 % of the format", "irb_4600", "ls", ("feed.outer_wall_mm_s=0.05",), ("layer 0, path ", "a feed is 0.05 mm/s; the nearest that can be written is 1 cm/min, 233.3 % off, expected 2 % at most")),
    ("point out of the number format", long_rail, "src", ("joints.rail=follow",), (" mm; must be within -99999.999 to 99999.999 mm in KRL",)),
    ("table that turns uncoordinated", held_cell, "ls", ("fanuc.coordinated=false", "joints.external_deg=10"), ("fanuc.coordinated is false, and axis external_1 turns the bed to 10 deg; expected true, or 0 deg",)),
    ("external axes in URScript", held_cell, "script", (), ("the arm has 2 external axes; expected none: URScript moves none",)),
    ("external axes in INFORM", held_cell, "jbi", (), ("the arm has 2 external axes, and inform.external_pulses 0 numbers; expected the pulses of each",)),
    ("channel out of its bounds", "irb_4600", "src", LASER + ("levels.channels={laser_power_w: {upper: 1000}}",),
     ("layer 0 at 0.8 mm, path 0, waypoint 0: laser_power_w is 1200 W by levels.values; expected 0 W to 1000 W",)),
    ("unknown value", "irb_4600", "src", ("levels.values=laser_kw=1",), ("levels.values holds 'laser_kw", "known are laser_power_w, wire_speed_mm_s")),
    ("channel of no value", "irb_4600", "src", LASER + ("levels.channels={wire_speed_mm_s: {upper: 20}}",), ("levels.channels holds 'wire_speed_mm_s'; expected a name that levels.values states",)),
    ("channel without an output", "irb_4600", "src", LASER, ("states the process value 'laser_power_w'; expected an output for it in robot_program.levels",)),
    ("channel without an output of RAPID", "irb_4600", "mod", LASER + ("rapid.configuration=joints",), ("'laser_power_w'", "rapid.levels")),
    ("output beyond its range", "irb_4600", "src", LASER + ("robot_program.levels=laser_power_w=1*0.0025",), ("analogue output 1 is to be set to 3; KRL takes -1 to 1 (robot_program.levels)",)),
    # 1.6 x 0.8 mm, 1.1427 mm2, at 20 mm/s in the first layer, of a wire of 1.2 mm.
    ("wire faster than its feeder", "irb_4600", "csv", ("levels.values=wire_speed_mm_s=from_bead", "levels.channels={wire_speed_mm_s: {upper: 20}}"),
     ("waypoint 0: wire_speed_mm_s is 20.2066 mm/s by levels.values; expected 0 mm/s to 20 mm/s, as levels.channels.wire_speed_mm_s states",)),
    ("weave without a wavelength", "irb_4600", "src", SWUNG + ("weave.wavelength_mm=0",), ("weave.wavelength_mm is '0'; must be a number in (0, 1000]",)),
    ("weave faster than the joints", "irb_4600", "src", SWUNG + ("weave.wavelength_mm=1",), ("weaving by 0.7 mm every 1.00032 mm at 20 mm/s takes 11046.8 mm/s2; expected motion.acceleration_mm_s2, 1500 mm/s2, at most",)),
    ("overlap longer than its closed run", "irb_4600", "src", ("lead.overlap_mm=400",), ("layer 0 at 0.8 mm, path 0: lead.overlap_mm is 400 mm; must be less than the closed run, 30",)),
    ("lead longer than its closed run", "irb_4600", "src", ("lead.in=line", "lead.length_mm=320"), ("layer 0 at 0.8 mm, path 0: a lead is 320 mm long (lead.length_mm); must be less than the longest closed run, 30",)),
    ("arc without a schedule, Fanuc", "irb_4600", "ls", WELDED, ("robot_program.start_schedule is 0 with robot_program.process 'schedules'; expected the number of a schedule",)),
    ("arc without a schedule to end by", "irb_4600", "jbi", WELDED + ("robot_program.start_schedule=1",), ("robot_program.end_schedule is 0 with",)),
    ("arc without a statement", "irb_4600", "src", WELDED, ("krl.arc_on is ''", "must be a statement of the controller's arc package")),
    ("arc without a welder", "irb_4600", "script", WELDED, ("robot_program.process is 'schedules'; expected 'outputs'",)),
    ("arc without data", "irb_4600", "mod", ("rapid.process=arc", "rapid.seam_data=", "rapid.configuration=joints"), ("rapid.seam_data is ''; must be a letter",)),
)

TOUCH = "x_mm,y_mm,z_mm,qw,qx,qy,qz\n"
TOUCHES = (
    ("three touches of the tip", "tcp", TOUCH + "0,0,0,1,0,0,0\n" * 3, ("the tip touches its point in 3 poses; expected at least 4",)),
    ("touches without a tilt", "tcp", TOUCH + "0,0,0,1,0,0,0\n" * 6, ("the tip's place along (0, 0, 1) of the flange is determined by ", "expected at least 0.1: the flange must be tilted by 10 deg or more")),
    ("two points of a work object", "object", "x_mm,y_mm,z_mm\n0,0,0\n1,0,0\n", ("has 2 points; expected 3",)),
    ("points of a work object on one line", "object", "x_mm,y_mm,z_mm\n0,0,0\n100,0,0\n200,0,0\n", ("the point on the side of y is 0 mm off the line through the points on x; expected at least 1 mm",)),
    ("two touches of a positioner", "positioner", "angle_deg,x_mm,y_mm,z_mm\n0,0,0,0\n90,100,0,0\n", ("the mark is touched at 2 values of the positioner; expected at least 3",)),
)


class BadInput(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())
        self.part = os.path.join(self.folder, "tube.stl")
        lamina("part", PART[0], *(word for setting in PART[1:] for word in ("--set", setting)), "-o", self.part)

    def cell(self, edit):
        folder = os.path.join(self.folder, "cell")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(os.path.join(EXAMPLES, "tilting_cell"), folder)
        edit(folder)
        return os.path.join(folder, "cell.yaml")

    def refuses(self, says, *command):
        self.assertIsInstance(says, tuple)
        done = lamina(*command)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for each in says:
            self.assertIn(each, done.stderr)
        self.assertEqual(glob.glob(os.path.join(self.folder, "out*")), [])

    def test_descriptions(self):
        for what, edit, says in DESCRIPTIONS:
            with self.subTest(what):
                self.refuses(says, "robot", self.cell(edit), "--write", os.path.join(self.folder, "out.urdf"))

    def test_programs(self):
        for what, machine, suffix, settings, says in PROGRAMS:
            if callable(machine):
                machine = self.cell(machine)
            elif machine.endswith(".urdf"):
                machine = os.path.join(EXAMPLES, machine)
            chosen = [word for setting in LAID + settings for word in ("--set", setting)]
            command = ("slice", self.part, "--machine", machine, *chosen, "-o", os.path.join(self.folder, "out." + suffix))
            if suffix == "check":
                points = os.path.join(self.folder, "points.csv")
                lamina("slice", self.part, *(word for setting in LAID for word in ("--set", setting)), "-o", points)
                command = ("check", points, "--machine", machine, *chosen)
            with self.subTest(what):
                self.refuses(says, *command)

    def test_calibrations(self):
        for what, kind, rows, says in TOUCHES:
            table = os.path.join(self.folder, "touches.csv")
            with open(table, "w", encoding="utf-8") as file:
                file.write(rows)
            with self.subTest(what):
                self.refuses(says, "calibrate", kind, table)


if __name__ == "__main__":
    unittest.main()
