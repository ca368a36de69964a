#!/usr/bin/env python3
"""The rule file that is shipped closes ports of ROS nodes that are not Lamina's (docs/cell/security.md), tried from another host."""
import shutil
import subprocess
import sys
import unittest

from two_hosts import NOT_RUN, OTHER, TwoHosts, enter_namespace, listening

RULES = sys.argv[1]
ROSOUT = "/usr/lib/rosout/rosout"


class FirewallRule(TwoHosts):
    def setUp(self):
        super().setUp()
        self.master = self.start_master(ROS_IP="127.0.0.1")
        self.addCleanup(subprocess.run, ["nft", "flush", "ruleset"], check=True)
        self.node = self.start(ROSOUT, ROS_IP="127.0.0.1")
        self.await_that(lambda: self.open_ports(), "rosout does not come up")

    def open_ports(self):
        return [port for port, address in listening(self.node.pid).items() if address == "0.0.0.0"]

    def test_it_closes_what_roscpp_leaves_open(self):
        port, = self.open_ports()  # of the XML-RPC server
        self.assertTrue(self.is_reached(port))
        subprocess.run(["nft", "-f", RULES], check=True)
        self.assertFalse(self.is_reached(port))
        self.assertTrue(self.is_reached_from_here(port))

    def test_hosts_of_the_cell_get_through(self):
        port, = self.open_ports()
        subprocess.run(["nft", "-f", RULES], check=True)
        subprocess.run(["nft", "add", "element", "inet", "lamina", "cell_hosts", "{", OTHER, "}"], check=True)
        self.assertTrue(self.is_reached(port))


if __name__ == "__main__":
    if shutil.which("nft") is None:
        print("not run: nft is not installed")
        sys.exit(NOT_RUN)
    enter_namespace()
    sys.argv.pop(1)
    unittest.main()
