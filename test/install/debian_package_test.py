#!/usr/bin/env python3
"""The Debian package holds what is installed, names what it needs, and runs once it is unpacked."""
import unittest

from trees import (BUILD, HAS_ROS, SCRATCH, build_paths, empty_scratch, layers, leave_nothing_to_find, run,
                   run_commands_with_libraries_of_their_own, run_paths)

TREE = SCRATCH / "root/usr"


def setUpModule():
    empty_scratch()
    run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", SCRATCH / "made", cwd=BUILD)


def tearDownModule():
    leave_nothing_to_find()


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        (cls.package,) = (SCRATCH / "made").glob("lamina_*.deb")
        run("dpkg-deb", "-x", cls.package, SCRATCH / "root")

    def field(self, name):
        return run("dpkg-deb", "-f", self.package, name).strip()

    def test_it_names_what_it_needs(self):
        self.assertEqual(self.field("Package"), "lamina")
        needed = self.field("Depends")
        for name in ["libc6", "libyaml-cpp0.7", "libfcl0.7"] + (["ros-core", "ros-nav-msgs"] if HAS_ROS else []):
            self.assertIn(name, needed)
        self.assertNotIn("-dev", needed)

    def test_all_of_it_is_below_usr(self):
        self.assertEqual([path.name for path in (SCRATCH / "root").iterdir()], ["usr"])
        self.assertEqual({path.name for path in TREE.iterdir()}, {"bin", "include", "lib", "share"})

    def test_no_file_names_the_folders_it_was_built_in(self):
        self.assertEqual(list(build_paths(TREE)), [])
        for path, folders in run_paths(TREE):
            self.assertEqual([folder[:7] for folder in folders], ["$ORIGIN"], path)

    def test_the_command_runs_and_slices(self):
        self.assertIn("slice", run(TREE / "bin/lamina", "--help"))
        run_commands_with_libraries_of_their_own(TREE)
        run(TREE / "bin/lamina", "slice", "box", "-o", SCRATCH / "box.gcode")
        self.assertEqual(layers(SCRATCH / "box.gcode"), 100)  # 20 mm by 0.2 mm


if __name__ == "__main__":
    unittest.main()
