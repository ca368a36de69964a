"""Plug-ins of the command: the one in examples/plugin fills a part with its own pattern."""
import csv
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from lamina_command import LAMINA, lamina

PLUGIN = sys.argv.pop(1)
SETTINGS = ["--set", "infill.strategy=dashes", "--set", "infill.pitch_mm=2", "--set", "walls.count=1", "--set", "skirt.count=0"]


class Plugin(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.output = str(pathlib.Path(folder.name) / "box.csv")

    def infill_runs(self):
        runs = {}
        with open(self.output, newline="", encoding="utf-8") as file:
            for row in csv.DictReader(line for line in file if not line.startswith("#")):
                if row["role"] == "infill":
                    place = (float(row["x_mm"]), float(row["y_mm"]))
                    runs.setdefault((row["layer"], row["path"]), []).append(place)
        return list(runs.values())

    def assert_dashes(self):
        runs = self.infill_runs()
        self.assertGreater(len(runs), 10)
        for (x1, y1), (x2, y2) in runs:
            self.assertAlmostEqual(y1, y2, places=3)
            self.assertAlmostEqual(abs(x2 - x1), 2.0, places=3)
            self.assertAlmostEqual(y1 / 2.0, round(y1 / 2.0), places=3)
            self.assertAlmostEqual(min(x1, x2) / 4.0, round(min(x1, x2) / 4.0), places=3)

    def test_fills_by_its_strategy(self):
        done = lamina("slice", "box", "-o", self.output, *SETTINGS, "--plugin", PLUGIN)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_dashes()

    def test_may_stand_before_the_subcommand(self):
        done = lamina("--plugin", PLUGIN, "--plugin", PLUGIN, "slice", "box", "-o", self.output, *SETTINGS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_dashes()

    def test_is_loaded_from_the_environment(self):
        done = subprocess.run([LAMINA, "slice", "box", "-o", self.output, *SETTINGS], capture_output=True, text=True, check=False,
                              env={**os.environ, "LAMINA_PLUGINS": PLUGIN})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_dashes()

    def test_names_its_strategy_in_the_settings(self):
        done = lamina("slice", "--print-config", "--plugin", PLUGIN)
        self.assertIn("contour | cubic | dashes | drops_contour", done.stdout)

    def test_states_the_words_of_its_dialect(self):
        program = self.output.replace(".csv", ".gcode")
        asked = ["--set", "program.dialect=house", "--set", "flow.advance_s=0.05", "--set", "program.progress=true"]
        done = lamina("slice", "box", "box", "-o", program, *asked, "--set", "plate.labels=exclude_object", "--plugin", PLUGIN)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = pathlib.Path(program).read_text(encoding="utf-8").splitlines()
        self.assertEqual([line for line in lines if "ADVANCE" in line or "M900" in line], ["SET_PRESSURE_ADVANCE ADVANCE=0.05"])
        self.assertIn("EXCLUDE_OBJECT_START NAME=box_1", lines)
        self.assertIn("M73 P50", lines)

    def test_lacks_the_words_that_its_dialect_does_not_state(self):
        program = self.output.replace(".csv", ".gcode")
        asked = ["-o", program, "--set", "program.dialect=house", "--plugin", PLUGIN]
        for setting in "plate.labels=m486", "program.accelerations=true":
            done = lamina("slice", "box", *asked, "--set", setting)
            self.assertEqual(done.returncode, 1, setting)
            self.assertIn(setting.split("=", maxsplit=1)[0], done.stderr)
            self.assertIn("'house'", done.stderr)

    def test_without_it_the_strategy_is_unknown(self):
        done = lamina("slice", "box", "-o", self.output, *SETTINGS)
        self.assertEqual(done.returncode, 1)
        self.assertIn("dashes", done.stderr)

    def test_that_cannot_be_loaded_is_named(self):
        done = lamina("slice", "box", "--plugin", "/nowhere/lib.so")
        self.assertEqual(done.returncode, 1)
        self.assertIn("FileError: cannot load plug-in '/nowhere/lib.so'", done.stderr)

    def test_that_is_none_is_refused(self):
        done = lamina("slice", "box", "--plugin", self.other_library())
        self.assertEqual(done.returncode, 1)
        self.assertIn("exports no lamina_plugin_interface", done.stderr)

    @staticmethod
    def other_library():
        with open("/proc/self/maps", encoding="utf-8") as maps:
            return next(line.split()[-1] for line in maps if "libc.so" in line or "libc-" in line)


if __name__ == "__main__":
    unittest.main()
