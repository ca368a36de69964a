#!/usr/bin/env python3
"""An installed tree runs wherever it is moved to, and other projects are built against it."""
import os
import signal
import socket
import subprocess
import time
import unittest
import xmlrpc.client

from trees import (BUILD, DEVEL, ENVIRONMENT, HAS_ROS, SCRATCH, SOURCE, build_paths, deposited_mm, empty_scratch, layers,
                   leave_nothing_to_find, run, run_commands_with_libraries_of_their_own, run_paths)

TREE = SCRATCH / "moved"
PATIENCE = 60.0  # s: far above what a call takes, for loaded machines


def build(source, folder, *options, prefix=TREE):
    run("cmake", "-S", source, "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_FLAGS=-Wall -Werror",
        f"-DCMAKE_CXX_COMPILER_LAUNCHER={os.environ.get('LAMINA_COMPILER_LAUNCHER', '')}", *options)
    run("cmake", "--build", folder)


def build_consumer(folder, prefix):
    build(SOURCE / "examples/catkin_consumer", folder, f"-DCATKIN_DEVEL_PREFIX={folder}/devel", "-DPYTHON_EXECUTABLE=/usr/bin/python3",
          "-DPython3_EXECUTABLE=/usr/bin/python3", prefix=prefix)


def setUpModule():
    empty_scratch()
    run("cmake", "--install", BUILD, "--prefix", SCRATCH / "installed")
    (SCRATCH / "installed").rename(TREE)


def tearDownModule():
    leave_nothing_to_find()


class Tree(unittest.TestCase):
    def test_no_file_names_the_folders_it_was_built_in(self):
        self.assertEqual(list(build_paths(TREE)), [])

    def test_libraries_are_looked_for_in_the_tree(self):
        found = list(run_paths(TREE))
        self.assertGreater(len(found), 2)
        for path, folders in found:
            self.assertEqual([folder[:7] for folder in folders], ["$ORIGIN"], path)

    def test_the_command_runs(self):
        self.assertIn("slice", run(TREE / "bin/lamina", "--help"))
        run_commands_with_libraries_of_their_own(TREE)

    def test_profiles_are_found_in_the_tree(self):
        place = run(TREE / "bin/lamina", "slice", "--explain", "program.dialect", "--machine", "voron_2_4_250")
        self.assertIn(str(TREE / "share/lamina/profiles/machines/klipper_printer.yaml"), place)

    @unittest.skipUnless(HAS_ROS, "built without ROS")
    def test_ros_finds_package_nodes_and_launch_files(self):
        def in_environment(command):
            return run("bash", "-c", f"source {TREE}/setup.bash && {command}").strip()
        self.assertEqual(in_environment("rospack find lamina"), str(TREE / "share/lamina"))
        self.assertIn("slice", in_environment("rosrun lamina lamina --help"))
        self.assertIn("/gcode_streamer", in_environment("roslaunch --nodes lamina demo.launch"))
        self.assertIn("lamina/Status status", in_environment("rossrv show lamina/SliceMesh"))

    @unittest.skipUnless(HAS_ROS, "built without ROS")
    def test_the_setup_file_keeps_ros_on_the_loopback_interface_unless_set_otherwise(self):
        def address_with(setting):
            others = "unset ROS_IP ROS_HOSTNAME ROS_MASTER_URI"
            return run("bash", "-c", f"{others}; {setting}; source {TREE}/setup.bash; echo $ROS_IP").strip()
        self.assertEqual(address_with("true"), "127.0.0.1")
        self.assertEqual(address_with("export ROS_IP=192.168.50.2"), "192.168.50.2")
        self.assertEqual(address_with("export ROS_HOSTNAME=robot"), "")
        self.assertEqual(address_with("export ROS_MASTER_URI=http://robot:11311"), "")


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        build(SOURCE / "examples", SCRATCH / "examples")
        run(TREE / "bin/lamina", "part", "box", "-o", SCRATCH / "box.stl")

    def test_the_first_slices_as_the_command_does(self):
        run(SCRATCH / "examples/01_slice", SCRATCH / "box.stl", SCRATCH / "box.gcode")
        plain = ("--set", "skins.top_layers=0", "--set", "skins.bottom_layers=0")  # planning alone closes nothing
        run(TREE / "bin/lamina", "slice", SCRATCH / "box.stl", *plain, "-o", SCRATCH / "by_command.gcode")
        self.assertEqual(layers(SCRATCH / "box.gcode"), 100)  # 20 mm by 0.2 mm
        self.assertGreater(deposited_mm(SCRATCH / "box.gcode"), 0.0)
        self.assertAlmostEqual(deposited_mm(SCRATCH / "box.gcode"), deposited_mm(SCRATCH / "by_command.gcode"), places=1)

    def test_the_second_takes_settings(self):
        reported = run(SCRATCH / "examples/02_settings", SCRATCH / "blade.gcode", "slicing.layer_height_mm=0.4",
                   "slicing.first_layer_height_mm=0.4")
        self.assertIn("100 layers", reported)  # 40 mm by 0.4 mm
        self.assertEqual(layers(SCRATCH / "blade.gcode"), 100)


@unittest.skipUnless(HAS_ROS, "built without ROS")
class CatkinConsumer(unittest.TestCase):
    def setUp(self):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.environment = {**ENVIRONMENT, "ROS_IP": "127.0.0.1", "ROS_HOME": str(SCRATCH / "roshome"),
                            "ROS_MASTER_URI": f"http://127.0.0.1:{self.port}"}
        self.nodes = []

    def tearDown(self):
        for node in reversed(self.nodes):
            node.send_signal(signal.SIGINT)
            node.wait(PATIENCE)

    def start(self, command, output):
        return subprocess.Popen(["bash", "-c", command], env=self.environment, stdout=output, stderr=subprocess.STDOUT, text=True)

    def await_master(self):
        """A roscore gives up a master that a busy host starts late, and roslaunch waits for the identity that a roscore sets."""
        master = xmlrpc.client.ServerProxy(self.environment["ROS_MASTER_URI"])
        until = time.monotonic() + PATIENCE
        while True:
            try:
                return master.setParam("/installed_tree", "/run_id", "installed_tree")
            except ConnectionError:
                self.assertLess(time.monotonic(), until, "the master does not answer")
                time.sleep(0.1)

    def test_packages_are_built_against_the_devel_space_too(self):
        build_consumer(SCRATCH / "beside", DEVEL)

    def test_a_node_of_another_package_talks_to_the_installed_one(self):
        build_consumer(SCRATCH / "consumer", TREE)
        with (SCRATCH / "nodes.log").open("w") as log:
            self.nodes.append(self.start(f"exec rosmaster --core -p {self.port}", log))
            self.await_master()
            self.nodes.append(self.start(f"source {TREE}/setup.bash && exec roslaunch --wait lamina slicing_service.launch", log))
        counting = self.start(f"source {SCRATCH}/consumer/devel/setup.bash && exec rosrun lamina_consumer count_layers", subprocess.PIPE)
        try:
            reported, _ = counting.communicate(timeout=2 * PATIENCE)
        except subprocess.TimeoutExpired:
            counting.kill()
            self.fail("no answer; the nodes say:\n" + (SCRATCH / "nodes.log").read_text())
        self.assertEqual(counting.returncode, 0, reported)
        self.assertIn("100 layers by the node, 100 by the core", reported)  # 20 mm by 0.2 mm


if __name__ == "__main__":
    unittest.main()
