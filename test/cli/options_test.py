"""Options of `lamina` that no other test beside this one gives, each with what it changes."""
import json
import os
import subprocess
import tempfile
import unittest

from lamina_command import LAMINA, lamina, reported


class Options(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.box = self.path("box.stl")
        reported("part", "box", "--set", "x_mm=10", "--set", "y_mm=10", "--set", "z_mm=1", "-o", self.box)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def content(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def test_units_and_scale_size_a_mesh(self):
        volume = reported("info", self.box)["volume_mm3"]
        self.assertAlmostEqual(reported("info", self.box, "--unit", "cm")["volume_mm3"] / volume, 1000.0, places=6)
        self.assertAlmostEqual(reported("info", self.box, "--scale", "2")["volume_mm3"] / volume, 8.0, places=6)

    def test_a_broken_mesh_is_refused_if_strict(self):
        broken = self.path("broken.stl")
        with open(broken, "wb") as file:
            stl = self.content("box.stl")
            file.write(stl[:80] + (11).to_bytes(4, "little") + stl[84:-50])
        self.assertEqual(lamina("slice", broken).returncode, 0)
        self.assertNotEqual(lamina("slice", broken, "--strict").returncode, 0)

    def test_density_weighs(self):
        for command in ("coordinates", "sweep"):
            light = json.dumps(reported(command, self.box, "--density-g-cm3", "1"))
            self.assertNotEqual(light, json.dumps(reported(command, self.box, "--density-g-cm3", "2")), command)

    def test_what_is_no_number_is_refused(self):
        for command in (("coordinates", self.box, "--density-g-cm3"), ("sweep", self.box, "--density-g-cm3"), ("lay", self.box, "--overhang-deg"),
                        ("calibrate", "tcp", self.path("touches.csv"), "--greatest-mm")):
            for text in ("nan", "inf"):
                refused = lamina(*command, text)
                self.assertNotEqual(refused.returncode, 0, command)
                self.assertIn(command[-1], refused.stderr)

    def test_pictures_have_views(self):
        for view in ("oblique", "top"):
            reported("preview", self.box, "--view", view, "-o", self.path(view + ".png"))
        self.assertNotEqual(self.content("oblique.png"), self.content("top.png"))

    def test_programs_have_dialects(self):
        for dialect in ("fullcontrol", "lamina"):
            reported("scaffold", "box", "--dialect", dialect, "-o", self.path(dialect + ".gcode"))
        self.assertNotEqual(self.content("fullcontrol.gcode"), self.content("lamina.gcode"))

    def test_overhangs_are_listed_as_many_as_asked_for(self):
        ball = self.path("ball.stl")
        reported("part", "sphere", "--set", "radius_mm=4", "--set", "segments=16", "-o", ball)
        self.assertEqual(len(reported("overhang", ball, "--worst", "0")["worst"]), 0)
        self.assertGreater(len(reported("overhang", ball, "--worst", "3")["worst"]), 0)

    def test_a_printed_part_is_softer_than_a_solid_one(self):
        coarse = ["--set", "deposition.voxel_mm=0.5", "--set", "stiffness.compression_mm=0.02"]
        solid = reported("stiffness", self.box, *coarse)["modulus_mpa"]
        self.assertLess(reported("stiffness", self.box, "--printed", *coarse)["modulus_mpa"], solid)

    def test_an_emulator_ends_after_one_job_and_strikes_with_its_faults(self):
        program, port = self.path("p.gcode"), self.path("machine")
        with open(program, "w", encoding="ascii") as file:
            file.write("G1 X1 F6000\n" * 20)
        emulator = subprocess.Popen([LAMINA, "emulate", "--pty", port, "--speed-up", "0", "--once", "--fault",
                                     "corrupted_line=5", "--json"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(emulator.stdout.close)
        self.addCleanup(emulator.wait)
        self.addCleanup(emulator.kill)
        while not os.path.exists(port):
            self.assertIsNone(emulator.poll())
        streamed = reported("stream", program, "--port", port, "--baud", "250000")
        self.assertEqual(emulator.wait(timeout=60), 0)
        self.assertGreaterEqual(streamed["resends"], 1)


if __name__ == "__main__":
    unittest.main()
