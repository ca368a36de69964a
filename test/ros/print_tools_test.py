#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tools/demo understands, what tools/print_inclined and tools/print_by_joints make of what a machine reports, tools/compare_deposit of a deposit,
tools/draw_closed_loop of two prints and
tools/draw_cell of a cell's timeline, without a master.

Usage: print_tools_test.py ROOT
"""
import ast
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import xml.etree.ElementTree
from unittest import mock

import lamina.srv
import rospy
from lamina.msg import ProcessState
from lamina.srv import MachineRestResponse
from sensor_msgs.msg import JointState

ROOT = pathlib.Path(sys.argv.pop(1))


def tool(name):
    sys.dont_write_bytecode = True
    path = str(ROOT / "tools" / name)
    spec = importlib.util.spec_from_loader(name, importlib.machinery.SourceFileLoader(name, path))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.PATIENCE = 0.2
    return module


def position(stamp_s, x, y, z):
    message = JointState(name=["x", "y", "z"], position=[x, y, z])
    message.header.stamp = rospy.Time(stamp_s)
    return message


def report(seq, stamp_s, flow):
    message = ProcessState(flow=flow)
    message.header.seq = seq
    message.header.stamp = rospy.Time(stamp_s)
    return message


def requests_of(source):
    """(line, type of the service, names of the fields, number of values without a name) of each request that a source makes: by a
    proxy itself, or by `call(name, type, ...)`."""
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        named = [word.arg for word in node.keywords if word.arg]
        of_proxy = isinstance(node.func, ast.Call) and getattr(node.func.func, "attr", "") == "ServiceProxy"
        if of_proxy and isinstance(node.func.args[1], ast.Name):
            yield node.lineno, node.func.args[1].id, named, sum(not isinstance(value, ast.Starred) for value in node.args)
        elif getattr(node.func, "id", getattr(node.func, "attr", "")) == "call" and len(node.args) >= 2:
            yield node.lineno, node.args[1].id, named, len(node.args) - 2


class Requests(unittest.TestCase):
    def test_name_their_fields_so_that_a_new_field_breaks_none(self):
        found = 0
        for path in sorted((ROOT / "tools").glob("print_*")):
            for line, kind, named, unnamed in requests_of(path.read_text()):
                found += 1
                self.assertEqual(unnamed, 0, f"{path.name}:{line}")
                if hasattr(lamina.srv, kind):
                    fields = getattr(lamina.srv, kind)._request_class.__slots__
                    self.assertLessEqual(set(named), set(fields), f"{path.name}:{line}")
        self.assertGreater(found, 8)


@mock.patch("rospy.is_shutdown", return_value=False)
@mock.patch("rospy.wait_for_service")
@mock.patch("rospy.Subscriber")
class Inclined(unittest.TestCase):
    def test_reach_is_complete_once_the_stamp_has_come(self, *_):
        reach = tool("print_inclined").Reach()
        reach.take(position(1, 0.1, 0.2, 0.3))
        reach.take(position(2, 0.4, 0.1, 0.3))
        reach.await_stamp(rospy.Time(2))
        self.assertEqual((reach.low, reach.high), ([0.1, 0.1, 0.3], [0.4, 0.2, 0.3]))

    def test_a_position_that_does_not_come_is_a_failure(self, *_):
        reach = tool("print_inclined").Reach()
        with self.assertRaisesRegex(SystemExit, "nothing of 0.000 s"):
            reach.await_stamp(rospy.Time(0))
        reach.take(position(1, 0.1, 0.2, 0.3))
        with self.assertRaisesRegex(SystemExit, "nothing of 2.000 s"):
            reach.await_stamp(rospy.Time(2))

    def test_the_last_position_is_that_of_the_machine_at_rest(self, *_):
        answers = [MachineRestResponse(False, rospy.Time(1), rospy.Time()), MachineRestResponse(True, rospy.Time(3), rospy.Time())]
        with mock.patch("rospy.ServiceProxy", return_value=mock.Mock(side_effect=answers)):
            self.assertEqual(tool("print_inclined").last_position(), rospy.Time(3))

    def test_a_machine_that_never_rests_is_a_failure(self, *_):
        answer = MachineRestResponse(False, rospy.Time(1), rospy.Time())
        with mock.patch("rospy.ServiceProxy", return_value=mock.Mock(return_value=answer)):
            with self.assertRaisesRegex(SystemExit, "does not rest"):
                tool("print_inclined").last_position()


@mock.patch("rospy.is_shutdown", return_value=False)
@mock.patch("rospy.Subscriber")
class ByJoints(unittest.TestCase):
    def test_what_is_deposited_is_compared_with_the_plan(self, *_):
        process = tool("print_by_joints").Process()
        for seq in range(7, 18):  # 10 s at 1 mm3/s
            process.take(report(seq, seq, 1e-9))
        self.assertAlmostEqual(process.deposited, 10e-9)
        self.assertEqual(process.fault(10e-9), "")
        self.assertRegex(process.fault(12e-9), "deposited 10 mm3; expected 12 mm3")

    def test_reports_that_are_lost_are_counted(self, *_):
        process = tool("print_by_joints").Process()
        for seq in (1, 2, 5, 6, 8):
            process.take(report(seq, seq, 1e-9))
        self.assertEqual(process.lost, 3)
        self.assertRegex(process.fault(7e-9), "3 reports were lost")

    def test_a_process_that_nobody_reports_is_a_failure(self, subscriber, _):
        subscriber.return_value.get_num_connections.return_value = 0
        with self.assertRaisesRegex(SystemExit, "nobody has published it"):
            tool("print_by_joints").Process().await_connection()
        subscriber.return_value.get_num_connections.return_value = 1
        tool("print_by_joints").Process().await_connection()


class CompareDeposit(unittest.TestCase):
    def box(self, path, low, high):
        """A box as a binary STL file."""
        corners = [[(low, high)[corner >> axis & 1][axis] for axis in range(3)] for corner in range(8)]
        faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5))
        content = bytes(80) + struct.pack("<I", len(faces))
        for face in faces:
            content += struct.pack("<12fH", 0, 0, 0, *(value for corner in face for value in corners[corner]), 0)
        path.write_bytes(content)
        return str(path)

    def test_what_deposit_and_part_share_is_counted(self):
        compare = tool("compare_deposit")
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            part = compare.Solid(self.box(root / "part.stl", (0, 0, 0), (8, 8, 10)))
            deposited, left_open, outside = compare.shares(part, compare.Solid(self.box(root / "deposit.stl", (4, 0, 0), (12, 8, 5))))
        self.assertAlmostEqual(deposited, 0.5)
        self.assertAlmostEqual(left_open, 0.75)
        self.assertAlmostEqual(outside, 0.25)

    def test_a_part_without_volume_is_a_failure(self):
        compare = tool("compare_deposit")
        with tempfile.TemporaryDirectory() as scratch:
            empty = pathlib.Path(scratch) / "empty.stl"
            empty.write_bytes(bytes(84))
            with self.assertRaisesRegex(SystemExit, "no volume"):
                compare.shares(compare.Solid(str(empty)), compare.Solid(str(empty)))


class ClosedLoop(unittest.TestCase):
    def folder(self, root, name, errors):
        """A print of a row of 10 cells, whose layers are off by so much [mm]."""
        folder = root / name
        folder.mkdir()
        (folder / "deviation.json").write_text(json.dumps([[0.5 * i, 2.0, errors[-1]] for i in range(10)]))
        rows = [f"{layer},{layer + 1},{error},{abs(error)},{error},1,10,5,seen" for layer, error in enumerate(errors)]
        head = "layer,expected_height_mm,mean_error_mm,rms_error_mm,worst_error_mm,coverage,cells,profiles,sight"
        (folder / "layer_heights.csv").write_text("\n".join(["# comment", head] + rows + ["9,10,,,,0,0,0,not seen"]) + "\n")
        return str(folder)

    def test_one_picture_and_one_sentence_tell_both_prints(self):
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            off = self.folder(root, "off", [-0.1, -0.5, -1.0, -1.0])
            on = self.folder(root, "on", [-0.1, -0.1, 0.1, 0.1])
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                tool("draw_closed_loop").main(off, on, str(root / "both.svg"))
            self.assertIn("off by 1.000 mm", said.getvalue())
            self.assertIn("by 0.100 mm with it: 90 % less", said.getvalue())
            picture = xml.etree.ElementTree.parse(root / "both.svg").getroot()
            names = [each.tag.split("}")[1] for each in picture.iter()]
            self.assertEqual((names.count("image"), names.count("polyline")), (2, 2))

    def test_the_scale_is_white_as_planned_and_blue_where_too_low(self):
        draw = tool("draw_closed_loop")
        self.assertEqual(draw.colour(0.0), (247, 247, 247))
        self.assertEqual(draw.colour(-1.0), (5, 48, 97))
        self.assertEqual(draw.colour(7.0), (103, 0, 31))

    def test_a_print_of_which_nothing_was_measured_is_a_failure(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = self.folder(pathlib.Path(scratch), "off", [0.1])
            (pathlib.Path(folder) / "deviation.json").write_text("[]")
            with self.assertRaisesRegex(SystemExit, "nothing was measured"):
                tool("draw_closed_loop").Print(folder)


class Cell(unittest.TestCase):
    def test_a_picture_shows_states_layers_kills_and_alarms(self):
        timeline = {"states": [[0.0, "Idle", ""], [1.0, "Starting", "ring"], [2.0, "Execute", "ring"], [5.0, "Holding", "ring"],
                               [6.0, "Held", "ring"], [7.0, "Execute", "ring"], [9.0, "Complete", "ring"]],
                    "layers": [[2.0, "ring", 0], [4.0, "ring", 1], [8.0, "ring", 2]],
                    "events": [[0.1, "queue", "ring is in the queue"], [5.0, "alarm", "alarm 3202: vacuum lost"], [7.0, "back", "acknowledged"],
                               [8.0, "kill", "kill -9 of the streamer at line 12"]]}
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            (root / "timeline.json").write_text(json.dumps(timeline))
            tool("draw_cell").main(str(root / "timeline.json"), str(root / "cell.svg"))
            picture = xml.etree.ElementTree.parse(root / "cell.svg").getroot()
        names = [each.tag.split("}")[1] for each in picture.iter()]
        self.assertEqual(names.count("polyline"), 1)
        self.assertEqual(names.count("rect"), 1 + 7, "a ground and a bar for each state")
        said = [each.text for each in picture.iter() if each.tag.endswith("text")]
        for words in ("kill -9 of the streamer", "alarm 3202", "goes on", "ring"):
            self.assertEqual(said.count(words), 1, words)

    def test_times_are_marked_at_round_seconds(self):
        chart = tool("draw_cell").Chart({"states": [[0.0, "Idle", ""]], "layers": [], "events": [[90.0, "part", "done"]]})
        self.assertIn(">80<", "".join(chart.seconds()))
        self.assertEqual(chart.y_of("Holding"), chart.y_of("Held"))

    def test_registers_are_written_and_read_as_modbus_has_them(self):
        kind = tool("print_cell").Plc
        plc = kind.__new__(kind)
        plc.link, peer = socket.socketpair()
        plc.lock, plc.transaction = threading.Lock(), 6
        with plc.link, peer:
            peer.sendall(bytes.fromhex("0007 0000 0006 01 10 0001 0002"))
            plc.write(1, 2, 43)
            self.assertEqual(peer.recv(64), bytes.fromhex("0007 0000 000b 01 10 0001 0002 04 0002 002b"))
            peer.sendall(bytes.fromhex("0008 0000 0007 01 04 04 002b 0001"))
            self.assertEqual(plc.read(13, 2), (43, 1))
            self.assertEqual(peer.recv(64), bytes.fromhex("0008 0000 0006 01 04 000d 0002"))
            peer.sendall(bytes.fromhex("0009 0000 0003 01 84 02"))
            with self.assertRaisesRegex(OSError, "exception 2"):
                plc.read(999, 1)

    def test_the_page_is_opened_where_there_is_a_screen(self):
        print_cell = tool("print_cell")
        for screen, opened in (({"DISPLAY": ":0"}, 1), ({"WAYLAND_DISPLAY": "wayland-0"}, 1), ({}, 0)):
            with mock.patch.dict("os.environ", screen, clear=True), mock.patch.object(print_cell.webbrowser, "open") as browser:
                print_cell.show("http://127.0.0.1:8080")
                self.assertEqual(browser.call_count, opened, screen)

    def test_a_state_is_reported_once(self):
        timeline = tool("print_cell").Timeline()
        with contextlib.redirect_stdout(io.StringIO()) as said:
            for _ in range(3):
                timeline.state("Execute", "ring")
            timeline.layer("ring", 4)
            timeline.layer("ring", 4)
        self.assertEqual(said.getvalue().count("Execute"), 1)
        self.assertEqual(len(timeline.layers), 1)


class Demo(unittest.TestCase):
    """A tree whose tools/install-dependencies fails: what the demo would do until then."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name).resolve() / "lamina"
        (self.root / "tools").mkdir(parents=True)
        shutil.copy(ROOT / "tools/demo", self.root / "tools/demo")
        installer = self.root / "tools/install-dependencies"
        installer.write_text("#!/bin/sh\nexit 77\n")
        installer.chmod(0o755)

    def demo(self, *arguments):
        command = ["bash", "-x", self.root / "tools/demo", *arguments]
        return subprocess.run(command, cwd=self.folder.name, capture_output=True, text=True, check=False)

    def test_help_is_all_of_its_head(self):
        done = self.demo("--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("--speed-up X", done.stdout)
        self.assertIn("journal and files of the cell.", done.stdout)
        self.assertNotIn("#", done.stdout)

    def test_an_unknown_option_is_named(self):
        done = self.demo("--volumetrc")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--volumetrc is no option", done.stderr)

    def test_a_mesh_that_is_not_there_is_named_before_anything_is_installed(self):
        done = self.demo("models/duck.stl")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no file models/duck.stl", done.stderr)

    def test_a_mesh_is_found_from_where_the_demo_is_called(self):
        (pathlib.Path(self.folder.name) / "duck.stl").touch()
        done = self.demo("duck.stl")
        self.assertEqual(done.returncode, 77)
        self.assertIn(f"part={self.root.parent}/duck.stl", done.stderr)

    def test_the_cell_of_the_robot_is_that_of_the_tree(self):
        done = self.demo("--robot")
        self.assertEqual(done.returncode, 77)
        self.assertIn(f"machine_of_joints={self.root}/examples/robots/tilting_cell/cell.yaml", done.stderr)


if __name__ == "__main__":
    unittest.main()
