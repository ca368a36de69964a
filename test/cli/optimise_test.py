"""Runs `lamina optimise` as a person would, stops it and lets it go on."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from lamina_command import LAMINA, lamina

STUDIES = sys.argv.pop(1)

FRONT = """name: parabolas
variables: {x: [0, 4]}
commands:
  part: [lamina, part, box, --set, "x_mm={x}", -o, "{folder}/box.stl"]
  box: [lamina, info, "{folder}/box.stl", --json]
responses:
  volume: {command: box, pointer: /volume_mm3}
  height: {command: box, pointer: /size_mm/2}
objectives: {volume: minimise}
search: {nsga2.population: 6, nsga2.generations: 1}
"""

SLOW = """variables: {x: [0.5, 4]}
commands:
  wait: [sleep, "0.1"]
  tell: [awk, 'BEGIN {x = {x}; printf "{\\"a\\": %.9g, \\"b\\": %.9g}", x, 1 / x}']
responses:
  a: {command: tell, pointer: /a}
  b: {command: tell, pointer: /b}
objectives: {a: minimise, b: minimise}
search: {nsga2.population: 20, nsga2.generations: 2}
"""

SLICED = """variables: {infill.pitch_mm: [0.5, 2]}
slice:
  part: box
  parameters: {x_mm: 6, y_mm: 5, z_mm: 2}
  settings: {slicing.layer_height_mm: 0.5, slicing.first_layer_height_mm: 0.5}
  front_metrics: [material_mm, volume_error_mm3]
objectives: {material_mm: minimise, volume_error_mm3: minimise}
search: {nsga2.population: 6, nsga2.generations: 1}
"""


class Optimise(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def study(self, text, name="study.yaml"):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def read(self, *names):
        with open(self.path(*names), encoding="utf-8") as file:
            return file.read()

    def test_its_own_commands_measure(self):
        with open(self.study(FRONT), encoding="utf-8") as file:
            text = file.read().replace("{x: [0, 4]}", "{x: [1, 4]}")
        done = lamina("optimise", self.study(text), "-o", self.path("out"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        reported = json.loads(done.stdout)
        self.assertEqual(reported["failed"], 0)
        self.assertAlmostEqual(reported["chosen"]["responses"]["volume"],
                               400.0 * reported["chosen"]["variables"]["x"], delta=0.01)
        self.assertIn("generation 1:", done.stderr)
        self.assertIn("<h1>parabolas</h1>", self.read("out", "report.html"))

    def test_what_fails_is_reported_with_its_error(self):
        text = FRONT.replace("[0, 4]", "[-4, 4]")
        done = lamina("optimise", self.study(text), "-o", self.path("out"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(json.loads(done.stdout)["failed"], 0)
        self.assertIn("x_mm is &#39;-", self.read("out", "report.html"))
        self.assertIn("x_mm is '-", self.read("out", "evaluations.csv"))

    def test_slice_takes_the_chosen_configuration(self):
        done = lamina("optimise", self.study(SLICED), "-o", self.path("out"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        sliced = lamina("slice", "box", "--config", self.path("out", "chosen.yaml"), "-o", self.path("box.csv"))
        self.assertEqual(sliced.returncode, 0, sliced.stderr)

    def test_stopped_it_goes_on_and_ends_alike(self):
        study = self.study(SLOW)
        self.assertEqual(lamina("optimise", study, "-o", self.path("whole")).returncode, 0)
        with subprocess.Popen([LAMINA, "optimise", study, "-o", self.path("stopped")],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as run:
            journal = self.path("stopped", "journal.jsonl")
            for _ in range(600):
                if os.path.exists(journal) and self.read("stopped", "journal.jsonl").count("\n") > 3:
                    break
                time.sleep(0.05)
            run.send_signal(signal.SIGINT)
            _, errors = run.communicate(timeout=60)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("Cancelled", errors)
        self.assertFalse(os.path.exists(self.path("stopped", "report.html")))
        self.assertEqual(lamina("optimise", study, "-o", self.path("stopped")).returncode, 0)
        for name in ("front.csv", "evaluations.csv", "chosen.yaml"):
            self.assertEqual(self.read("stopped", name), self.read("whole", name))

    def test_what_failed_is_tried_again_if_asked_for(self):
        study = self.study(SLOW.replace('[sleep, "0.1"]', "[cat, gate]"))

        def failed(*options):
            done = lamina("optimise", study, "-o", self.path("out"), "--json", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)["failed"]

        self.assertGreater(failed(), 0)
        with open(self.path("gate"), "w", encoding="utf-8"):
            pass
        self.assertGreater(failed(), 0)
        self.assertEqual(failed("--retry-failed"), 0)
        both = lamina("optimise", study, "-o", self.path("out"), "--retry-failed", "--fresh")
        self.assertNotEqual(both.returncode, 0)
        self.assertIn("excludes", both.stderr)

    def test_errors_that_are_no_text_are_reported_all_the_same(self):
        study = self.study(SLOW.replace('[sleep, "0.1"]', "[echo]").replace(
            "{x = {x};", '{x = {x}; if (x == 2) {printf "a\\377z" > "/dev/stderr"; exit 3}')
                           + "published: {rows: {theirs: {x: 2}}}\n")
        done = subprocess.run([LAMINA, "optimise", study, "-o", self.path("out"), "--json"], capture_output=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("exit code 3: a\ufffdz", json.loads(done.stdout)["notes"][0])

    def test_what_cannot_be_run_is_refused_before_anything_is_written(self):
        for change, what in ((("x: [0, 4]", "y: [0, 4]"), "'{x}' is no variable"),
                             (("search: {", "search: {nsga2.popluation: 3, "), "nsga2.population"),
                             (("objectives: {volume", "objectives: {mass"), "no response 'mass'")):
            done = lamina("optimise", self.study(FRONT.replace(*change)), "-o", self.path("out"))
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(what, done.stderr)
        done = lamina("optimise", self.study(FRONT), "-o", self.path("out"), "--set", "kriging.corelation=x")
        self.assertIn("kriging.correlation", done.stderr)
        self.assertFalse(os.path.exists(self.path("out")))

    def test_shipped_studies_can_be_read(self):
        names = sorted(name for name in os.listdir(STUDIES) if name.endswith(".yaml"))
        self.assertGreaterEqual(len(names), 9)
        for name in names:
            done = lamina("optimise", os.path.join(STUDIES, name), "-o", self.path("out"), "--set",
                          "nsga2.population=none")
            self.assertIn("nsga2.population is 'none'", done.stderr, name)

    def test_published_tables_give_the_published_optima(self):
        for name, optimum in (("sinusoidal_scaffolds_table", [0.5, 0.15, 5, 5, "sine"]),
                              ("mirrored_scaffolds_table", [0.1, 0.15, 9, 9])):
            done = lamina("optimise", os.path.join(STUDIES, name + ".yaml"), "-o", self.path(name), "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(list(json.loads(done.stdout)["chosen"]["variables"].values()), optimum)

    def test_proposals_stand_beside_what_was_measured_of_them(self):
        study = os.path.join(STUDIES, "mini_specimens.yaml")
        done = lamina("optimise", study, "-o", self.path("mini"), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        reported = json.loads(done.stdout)
        self.assertEqual(reported["end"], "accepted")
        self.assertEqual(reported["chosen"]["variables"]["infill_percent"], 69.39)
        for proposal, infill, error in zip(reported["proposals"], (68.73, 69.39, 68.9, 69.19), (5.06, 3.99, 2.45, 0.93)):
            self.assertAlmostEqual(float(proposal["proposed"]["infill_percent"]), infill, delta=0.01)
            self.assertEqual(float(proposal["measured_at"]["infill_percent"]), infill)
            self.assertAlmostEqual(proposal["mape_percent"], error, delta=0.1)
            self.assertEqual(proposal["is_accepted"], infill == 69.39)
        done = lamina("optimise", study, "-o", self.path("mini"))
        self.assertIn("proposal 1:  layer_height_mm 0.3  infill_percent 68.7334  perimeters 1", done.stdout)
        self.assertIn("2199.92 predicted, 2166.62 measured", done.stdout)


if __name__ == "__main__":
    unittest.main()
