#!/usr/bin/env python3
"""Which ports of nodes and master another host reaches (docs/cell/security.md), tried from another host."""
import sys
import unittest

from two_hosts import HOST, MASTER_PORT, TwoHosts, enter_namespace, listening

SLICING_SERVICE = sys.argv[1]


class Reachability(TwoHosts):
    def test_a_node_is_reached_from_its_own_host_alone(self):
        self.start_master(ROS_IP="127.0.0.1")
        node = self.start_node(SLICING_SERVICE)
        for port in listening(node.pid):
            self.assertTrue(self.is_reached_from_here(port))
            self.assertFalse(self.is_reached(port), listening(node.pid))
        self.assertFalse(self.is_reached(MASTER_PORT))
        self.assertNotIn("whoever reaches this host", self.log())

    def test_a_node_that_is_given_its_address_is_reached_and_says_so(self):
        self.start_master(ROS_IP="127.0.0.1")
        node = self.start_node(SLICING_SERVICE, ROS_IP=HOST)
        for port in listening(node.pid):
            self.assertTrue(self.is_reached(port))
            self.assertIn(str(port), self.log())
        self.assertIn("whoever reaches this host commands this node", self.log())

    def test_a_node_reports_a_master_on_all_interfaces(self):
        self.start_master()
        self.start_node(SLICING_SERVICE)
        self.assertTrue(self.is_reached(MASTER_PORT))
        self.assertIn("whoever reaches this host commands every node", self.log())


if __name__ == "__main__":
    enter_namespace()
    sys.argv.pop(1)
    unittest.main()
