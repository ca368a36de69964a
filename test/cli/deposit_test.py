# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs `lamina deposit` as a person or a script does.

    deposit_test.py LAMINA
"""
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
KEYS = ["path_mm", "extruded_mm3", "model_mm3", "voxels", "porosity_percent", "surface_mm2", "wall_s", "peak_memory_mb"]
AREA = 0.18 * 0.3 + math.pi * 0.09 / 4.0  # of a bead of 0.48 x 0.3 mm
FILAMENT = math.pi * 1.75 ** 2 / 4.0


def run(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, timeout=120)


class Deposit(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.program = self.path("lines.gcode")
        lines = ["G90", "M83"]
        for layer in range(3):
            for line in range(5):
                lines.append(f"G0 X10 Y{10 + 2 * line} Z{0.3 * (layer + 1):.1f}")
                lines.append(f"G1 X30 Y{10 + 2 * line} E{20.0 * AREA / FILAMENT:.7f} F1200")
        with open(self.program, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def reported(self, *arguments, code=0):
        done = run("deposit", *arguments, "--json")
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads(done.stdout)

    def test_a_program_is_deposited_volume_for_volume(self):
        reported = self.reported(self.program)
        for key in KEYS:
            self.assertIn(key, reported)
        self.assertAlmostEqual(reported["path_mm"], 300.0, places=3)
        self.assertAlmostEqual(reported["extruded_mm3"] / (300.0 * AREA), 1.0, places=4)
        self.assertAlmostEqual(reported["model_mm3"], reported["extruded_mm3"], delta=0.0011)
        self.assertAlmostEqual(reported["model_mm3"], reported["voxels"] * 1e-3, places=6)
        self.assertAlmostEqual(reported["highest_mm"], 0.9, places=6)
        low, high = reported["box_mm"]
        box = math.prod(b - a for a, b in zip(low, high))
        self.assertAlmostEqual(reported["porosity_percent"], 100.0 * (1.0 - reported["model_mm3"] / box), places=6)
        self.assertLess(reported["bits_per_voxel"], 2.0 * 64 / 20)  # bricks of 64 voxels hold thin walls
        self.assertIn("model", run("deposit", self.program).stdout)

    def test_finer_voxels_hold_the_same(self):
        reported = self.reported(self.program, "--voxel-mm", "0.05")
        self.assertEqual(reported["voxel_mm"], 0.05)
        self.assertAlmostEqual(reported["model_mm3"], reported["extruded_mm3"], delta=0.00013)

    def test_surface_and_pictures_are_written(self):
        surface, layer, section = (self.path(name) for name in ("out.stl", "layer.png", "section.png"))
        reported = self.reported(self.program, "-o", surface, "--layer-picture", "1", layer, "--section-picture", "x=20", section)
        with open(surface, "rb") as file:
            triangles = struct.unpack("<I", file.read(84)[80:])[0]
        self.assertEqual(triangles, reported["stl_triangles"])
        self.assertGreater(reported["surface_mm2"], reported["stl_surface_mm2"])
        for picture in (layer, section):
            with open(picture, "rb") as file:
                self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_a_crop_is_what_figures_are_of(self):
        whole = self.reported(self.program)
        reported = self.reported(self.program, "--crop", "15", "9.5", "0", "25", "10.5", "0.9")
        self.assertAlmostEqual(reported["model_mm3"], whole["model_mm3"])
        self.assertAlmostEqual(reported["voxels"] * 1e-3, 10.0 * 3.0 * AREA, delta=0.05 * 30.0 * AREA)
        self.assertEqual(reported["box_mm"][1][2], 0.9)

    def test_a_part_is_sliced_and_deposited(self):
        reported = self.reported("box", "--voxel-mm", "0.2", "--set", "slicing.layer_height_mm=0.4", "--set",
                         "slicing.first_layer_height_mm=0.4", "--set", "bead.width_mm=0.8", "--set", "infill.density=0.2")
        self.assertAlmostEqual(reported["model_mm3"] / reported["extruded_mm3"], 1.0, delta=1e-4)

    def test_what_cannot_be_is_refused_before_anything_is_written(self):
        surface = self.path("out.stl")
        for arguments in (["-o", self.path("out.obj")], ["--crop", "1", "1", "1", "0", "2", "2", "-o", surface],
                          ["--layer-picture", "3", self.path("p.png"), "-o", surface],
                          ["--section-picture", "w=3", self.path("p.png"), "-o", surface],
                          ["--voxel-mm", "-1", "-o", surface],
                          ["--voxel-mm", "0.01", "--set", "deposition.memory_limit_mb=0.5", "-o", surface]):
            self.assertIn("error", self.reported(self.program, *arguments, code=1))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["lines.gcode"])

    def test_the_voxel_that_fits_is_reported(self):
        limit = ["--set", "deposition.memory_limit_mb=0.5"]
        message = self.reported(self.program, "--voxel-mm", "0.01", *limit, code=1)["error"]["message"]
        fits = message.split("voxels of ")[1].split(" mm")[0]
        self.assertGreater(float(fits), 0.01)
        self.assertLessEqual(self.reported(self.program, "--voxel-mm", fits, *limit)["grid_mb"], 0.5)


if __name__ == "__main__":
    unittest.main()
