#!/usr/bin/env python3
"""The commands in README.md, docs/printing/commands.md and the pages on programs run: all but those with a device, a bag or a cell and those that take minutes."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from lamina_command import LAMINA

SOURCE = pathlib.Path(sys.argv.pop(1))
LINE = re.compile(r"^    (lamina [^#\n]*)(#.*)?$")
WITH_DEVICE = re.compile(r"^lamina (?:audit|emulate|stream|estimate|record)\b|.*--port ")  # or a bag, or a cell


def commands(page):
    for line in (SOURCE / page).read_text().splitlines():
        found = LINE.match(line)
        if found and not WITH_DEVICE.match(found.group(1)) and "minutes" not in (found.group(2) or ""):
            yield found.group(1).strip()


class Pages(unittest.TestCase):
    def run_all_of(self, page, files=None):
        environment = {**os.environ, "PATH": f"{pathlib.Path(LAMINA).parent}:{os.environ['PATH']}"}
        with tempfile.TemporaryDirectory() as scratch:
            (pathlib.Path(scratch) / "examples").symlink_to(SOURCE / "examples")
            for name, content in (files or {}).items():
                (pathlib.Path(scratch) / name).write_bytes(content)
            lines = list(commands(page))
            self.assertGreater(len(lines), 5 if files is None else 0)
            for line in lines:
                done = subprocess.run(line, shell=True, cwd=scratch, env=environment, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, f"{page}: {line}\n{done.stderr}")

    def test_commands_of_the_readme_run(self):
        self.run_all_of("README.md")

    def test_commands_of_the_documentation_run(self):
        self.run_all_of("docs/printing/commands.md")

    def test_commands_of_the_pages_on_programs_run(self):
        with tempfile.TemporaryDirectory() as scratch:
            part = pathlib.Path(scratch) / "part.stl"
            subprocess.run([LAMINA, "part", "box", "-o", part], check=True, capture_output=True)
            files = {"part.stl": part.read_bytes(), "begin.gcode": b"M117 begin\n"}
        pages = ["docs/planning/runs.md", *sorted(f"docs/programs/{page.name}" for page in (SOURCE / "docs/programs").glob("*.md"))]
        for page in pages:
            with self.subTest(page):
                if list(commands(page)):
                    self.run_all_of(page, files)

    def test_every_command_is_described(self):
        help_text = subprocess.run([LAMINA, "--help"], capture_output=True, text=True, check=True).stdout
        names = re.findall(r"^  ([a-z][a-z-]+)\b", help_text.split("Subcommands:")[1], re.MULTILINE)
        page = (SOURCE / "docs/printing/commands.md").read_text()
        self.assertGreater(len(names), 10)
        for name in names:
            self.assertRegex(page, rf"(?m)^    lamina {name}\b")

    def test_every_line_that_slice_prints_is_explained(self):
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run([LAMINA, "slice", "cone", "-o", f"{scratch}/cone.gcode"], capture_output=True, text=True, check=True)
        labels = {line[:12].strip() for line in done.stdout.splitlines()}
        self.assertIn("repositions", labels)
        self.assertGreater(len(labels), 8)
        page = (SOURCE / "docs/printing/commands.md").read_text()
        for label in labels:
            self.assertRegex(page, rf"(?m)^\|.*`{label}`.*\|")

    def test_slicing_without_output_says_that_nothing_is_written(self):
        done = subprocess.run([LAMINA, "slice", "box"], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.splitlines()[-1], "written to  no file: -o FILE.gcode would write the program")

    def test_a_program_is_drawn_on_the_machine_of_a_profile(self):
        with tempfile.TemporaryDirectory() as scratch:
            program = f"{scratch}/box.gcode"
            options = ["--machine", "open5x_i3", "--set", "five_axis.use=always", "--set", "slicing.layer_height_mm=0.3"]
            subprocess.run([LAMINA, "slice", "box", *options, "-o", program], check=True, capture_output=True)
            drawn = [LAMINA, "preview", program, "-o", f"{scratch}/box.png"]
            self.assertNotEqual(subprocess.run(drawn, capture_output=True, check=False).returncode, 0)  # its axes are U and V
            subprocess.run([*drawn, "--machine", "open5x_i3"], check=True, capture_output=True)

    def test_the_example_of_the_readme_is_the_one_that_is_compiled(self):
        (example,) = re.findall(r"```cpp\n(.*?)```", (SOURCE / "README.md").read_text(), re.DOTALL)
        self.assertEqual(example, (SOURCE / "examples/01_slice.cpp").read_text())
        self.assertLessEqual(len(example.splitlines()), 25)


if __name__ == "__main__":
    unittest.main()
