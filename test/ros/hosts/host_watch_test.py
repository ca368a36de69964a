#!/usr/bin/env python3
"""The watch of a host of a cell (docs/cell/hosts.md), on two hosts: network namespaces with a cable between.

    host_watch_test.py NODE   and the launch file of another host
"""
import math
import os
import pathlib
import shutil
import signal
import socket
import sys
import time
import unittest
import uuid
import xmlrpc.client

from two_hosts import HOST, MASTER_PORT, OTHER, TwoHosts, enter_namespace, ip

NODE = sys.argv[1]
LAUNCH = str(pathlib.Path(__file__).resolve().parents[3] / "launch/cell_desk.launch")
NEEDED_SILENCE = 3.0  # s
DROP_A_THIRD = ("add table inet lossy; add chain inet lossy out { type filter hook output priority 0; }; "
                "add rule inet lossy out udp dport 11412 numgen random mod 10 < 3 drop")


class HostWatch(TwoHosts):
    def setUp(self):
        super().setUp()
        import rospy  # only now: the master's address is known to it from the environment
        from lamina.msg import AlarmReport, HostState
        self.master = self.start_master(ROS_IP=HOST)
        self.reports, self.state, self.hosts = [], None, set()
        if not rospy.core.is_initialized():
            rospy.init_node("host_watch_test", disable_signals=True)
        self.subscribers = [rospy.Subscriber("alarm_reports", AlarmReport, self.reports.append, queue_size=100),
                            rospy.Subscriber("host_state", HostState, self.on_state, queue_size=100)]
        for subscriber in self.subscribers:
            self.addCleanup(subscriber.unregister)

    def on_state(self, state):
        self.hosts.add(state.host)
        if state.host == "motion":
            self.state = state

    def watch(self, name, address, peer, other, *parameters):
        """A watch on one of the hosts, by the address of its end of the cable."""
        command = [NODE, f"__name:=host_watch_{name}", f"_hosts/name:={name}", f"_hosts/bind:={address}", f"_hosts/peers:={{{peer}: {other}}}",
                   f"_hosts/silence_s:={NEEDED_SILENCE}", *parameters]
        if address == OTHER:
            command = ["nsenter", f"--net=/proc/{self.other.pid}/ns/net", *command]
        return self.start(*command, ROS_IP=address, ROS_MASTER_URI=f"http://{HOST}:{MASTER_PORT}")

    def both(self, *parameters, shift_s=0.0):
        self.watch("sensing", OTHER, "motion", HOST, f"_clock/shift_s:={shift_s}")
        return self.watch("motion", HOST, "sensing", OTHER, "_hosts/needed:=sensing", "_master/silence_s:=5",
                          f"_disk/folder:={self.folder}", *parameters)

    def raised(self):
        return [report.id for report in self.reports if not report.is_gone and report.source == "host_watch of motion"]

    def is_gone(self, alarm):
        of_it = [report for report in self.reports if report.id == alarm and report.source == "host_watch of motion"]
        return bool(of_it) and of_it[-1].is_gone

    def peer(self):
        return self.state.peers[0] if self.state and self.state.peers else None

    def await_compared(self):
        self.await_that(lambda: self.peer() and self.peer().is_compared, "the clocks are not compared")

    def test_clocks_are_compared_and_a_pulled_cable_is_reported(self):
        self.both()
        self.await_compared()
        self.assertLess(abs(self.peer().clock_offset), self.peer().clock_uncertainty + 1e-4, "one machine has one clock")
        self.assertEqual(self.raised(), [])
        self.assertLess(self.peer().silent, NEEDED_SILENCE)
        self.assertGreater(self.state.free_space, 0.0)
        self.await_that(lambda: self.hosts == {"motion", "sensing"}, "the hosts are not named")
        ip("link", "set", "cable", "down")
        self.addCleanup(ip, "link", "set", "cable", "up")
        pulled = time.monotonic()
        self.await_that(lambda: 8001 in self.raised(), "the lost host is not reported")
        self.assertGreater(time.monotonic() - pulled, NEEDED_SILENCE - 0.5)
        ip("link", "set", "cable", "up")
        self.await_that(lambda: self.is_gone(8001), "the host does not come back")

    def test_clocks_apart_are_reported_with_their_offset(self):
        self.both("_clock/is_needed:=true", "_hosts/interval_s:=0.05", "_hosts/port:=11412", shift_s=0.050)
        self.await_that(lambda: 8004 in self.raised(), "8004 is not raised")
        report = next(report for report in self.reports if report.id == 8004 and not report.is_gone)
        self.assertAlmostEqual(report.value, 50.0, delta=5.0)
        self.await_compared()
        self.assertAlmostEqual(self.peer().clock_offset, 0.050, delta=0.005)

    def test_a_network_that_loses_a_third_raises_nothing(self):
        if shutil.which("nft") is None or self.on_other("nft", DROP_A_THIRD).returncode != 0:
            self.skipTest("nft drops nothing at random here")
        self.addCleanup(self.on_other, "nft", "delete table inet lossy")
        self.both("_clock/warn_s:=0.005")
        self.await_compared()
        until = time.monotonic() + 3.0
        while time.monotonic() < until:
            self.assertFalse(self.peer().is_lost)
            time.sleep(0.1)
        self.assertEqual(self.raised(), [])

    def test_a_master_that_died_and_one_that_was_started_anew_are_told(self):
        watched = self.both("_nodes:=/host_watch_sensing", "_disk/folder:=/nowhere")
        self.await_that(lambda: self.state and self.state.nodes and self.state.nodes[0].answers, "the watched node is not seen")
        self.assertTrue(self.state.has_master)
        self.assertTrue(math.isnan(self.state.free_space), "of a folder that is not there")
        self.master.send_signal(signal.SIGKILL)
        self.master.wait()
        self.await_that(lambda: 8002 in self.raised(), "the lost master is not reported")
        self.await_that(lambda: not self.state.has_master, "the state does not say so")
        self.start_master(ROS_IP=HOST)
        self.await_that(lambda: "started anew" in self.state.master_defect, "it is not seen that the master knows nobody")
        self.assertIsNone(watched.poll())

    def test_nodes_that_do_not_answer_leave_the_master_there(self):
        silent = socket.create_server((HOST, 0), backlog=100)
        self.addCleanup(silent.close)
        master = xmlrpc.client.ServerProxy(f"http://{HOST}:{MASTER_PORT}")
        names = [f"/silent_{number}" for number in range(4)]
        for name in names:
            master.registerSubscriber(name, "/of_silent", "std_msgs/String", f"http://{HOST}:{silent.getsockname()[1]}/")
        self.both("_nodes:=" + ",".join(names))
        self.await_that(lambda: self.state and len(self.state.nodes) == len(names), "the silent nodes are not looked at")
        until = time.monotonic() + 3.0
        while time.monotonic() < until:
            self.assertTrue(self.state.has_master)
            time.sleep(0.1)
        self.assertFalse(any(node.answers for node in self.state.nodes))
        self.assertNotIn(8002, self.raised())

    def test_a_node_that_was_started_anew_is_reported(self):
        # Without a run_id roslaunch waits for whoever sets one.
        xmlrpc.client.ServerProxy(f"http://{HOST}:{MASTER_PORT}").setParam("/test", "/run_id", str(uuid.uuid1()))
        self.start("nsenter", f"--net=/proc/{self.other.pid}/ns/net", "roslaunch", "--wait", LAUNCH, f"address:={OTHER}", f"motion:={HOST}",
                   ROS_IP=OTHER, ROS_MASTER_URI=f"http://{HOST}:{MASTER_PORT}")
        self.watch("motion", HOST, "desk", OTHER, "_nodes:=/host_watch_desk", "_disk/least_gib:=1000")
        self.await_that(lambda: self.state and self.state.nodes and self.state.nodes[0].answers, "the watched node is not seen")
        self.await_compared()
        os.kill(self.state.nodes[0].pid, signal.SIGKILL)
        self.await_that(lambda: 8005 in self.raised(), "the restart is not reported")
        self.assertIn(7002, self.raised())
        self.assertEqual(self.state.nodes[0].restarts, 1)


if __name__ == "__main__":
    enter_namespace()
    os.environ.update(ROS_MASTER_URI=f"http://{HOST}:{MASTER_PORT}", ROS_IP=HOST)
    sys.argv.pop(1)
    unittest.main()
