#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tools/print_inclined and tools/print_by_joints make of what a machine reports, without a master.

Usage: print_tools_test.py ROOT
"""
import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest
from unittest import mock

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
    def test_what_is_laid_is_compared_with_the_plan(self, *_):
        process = tool("print_by_joints").Process()
        for seq in range(7, 18):  # 10 s at 1 mm3/s
            process.take(report(seq, seq, 1e-9))
        self.assertAlmostEqual(process.laid, 10e-9)
        self.assertEqual(process.fault(10e-9), "")
        self.assertRegex(process.fault(12e-9), "laid 10 mm3; expected 12 mm3")

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


if __name__ == "__main__":
    unittest.main()
