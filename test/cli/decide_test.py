"""Runs `lamina decide` as a person would, and slices with what it writes."""
import os
import tempfile
import unittest

from lamina_command import lamina, reported

# A front of three, with a setting of the slicer beside it.
FRONT = """# variables 2
slicing.layer_height_mm,infill.strategy,a,b
0.2,zigzag,1,0.2
0.25,zigzag,0.5,0.5
0.3,perimeters,0.2,1
"""


class Decide(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.front = self.path("front.csv")
        self.write("front.csv", FRONT)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def test_linmap_follows_the_weights(self):
        found = reported("decide", self.front)
        self.assertEqual((found["chosen"], found["line"], found["alternatives"]), (2, 4, 3))
        for index, expected in zip(found["indices"], (1.0198, 0.7071, 1.0198)):
            self.assertAlmostEqual(index, expected, delta=5e-5)
        weighted = reported("decide", self.front, "--weights", "a=9,b=1")
        self.assertEqual(weighted["chosen"], 3)
        self.assertEqual(weighted["weights"], {"a": 9.0, "b": 1.0})
        for index, expected in zip(weighted["indices"], (3.007, 1.581, 1.166)):
            self.assertAlmostEqual(index, expected, delta=5e-4)
        self.assertEqual(reported("decide", self.front, "--method", "topsis")["chosen"], 2)
        self.assertEqual(reported("decide", self.front, "--maximise", "a", "--maximise", "b")["chosen"], 2)
        self.assertEqual(reported("decide", self.front, "--weights", "b=0")["chosen"], 3)

    def test_the_text_states_values_and_what_was_to_be_had(self):
        text = lamina("decide", self.front).stdout
        self.assertIn("chosen       2 of 3, line 4, by linmap, index 0.707107", text)
        self.assertIn("of 0.2 to 1, weight 1", text)

    def test_slice_takes_what_is_written_as_it_is(self):
        self.write("base.yaml", "slicing: {layer_height_mm: 0.1}\nwalls: {count: 1}\n")
        reported("decide", self.front, "--weights", "a=9", "-o", self.path("best.yaml"), "--base", self.path("base.yaml"))
        self.assertEqual(self.read("best.yaml"), "slicing:\n  layer_height_mm: 0.3\nwalls:\n  count: 1\n"
                         "infill:\n  strategy: perimeters\n")
        sliced = reported("slice", "box", "--config", self.path("best.yaml"), "-o", self.path("box.gcode"))
        by_hand = reported("slice", "box", "--set", "slicing.layer_height_mm=0.3", "--set", "walls.count=1", "--set",
                       "infill.strategy=perimeters", "-o", self.path("by_hand.gcode"))
        self.assertEqual(sliced["layers"], by_hand["layers"])
        self.assertEqual(self.read("box.gcode"), self.read("by_hand.gcode"))

    def test_refusals_name_what_is_wrong_and_write_nothing(self):
        out = self.path("best.yaml")
        for arguments, message in (
                (["--weights", "c=1"], "no response 'c'; there are a, b"),
                (["--weights", "a=-1"], "weight of a is '-1'; must be a number from 0"),
                (["--weights", "a=0,b=0"], "all weights are 0"),
                (["--maximise", "c"], "no response 'c'"),
                (["--base", self.path("none.yaml")], "none.yaml")):
            done = lamina("decide", self.front, "-o", out, *arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn(message, done.stderr)
            self.assertFalse(os.path.exists(out))
        self.assertNotEqual(lamina("decide", self.front, "--method", "best").returncode, 0)
        self.assertNotEqual(lamina("decide", self.front, "-o", self.path("best.csv")).returncode, 0)
        self.assertEqual(self.read("front.csv"), FRONT)
        self.write("gap.csv", "# variables 1\nx,a,b\n1,,2\n")
        self.assertIn("alternative 1 has no a", lamina("decide", self.path("gap.csv")).stderr)


if __name__ == "__main__":
    unittest.main()
