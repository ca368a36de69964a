#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streams to a real Marlin that runs as a program of this computer, with noise, resets and other senders on the line.

    real_marlin_test.py LAMINA

LAMINA_MARLIN_RUNNER names a program `RUNNER LINK` that runs Marlin behind a pseudo-terminal at LINK until it is ended, and prints `ready`. It takes
from its environment SPEED, BAUD, NOISE_DOWN, NOISE_UP, DROP_OK, RESET_AFTER, GLITCH, SAY_AFTER, SAY, SEED, and RECORD: the file for the commands that
Marlin has run (docs/streaming/streaming.md, "Against real firmware"). Without it nothing is tested, and the exit code is 77.
"""
import collections
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from spiral_program import spiral

LAMINA = os.path.abspath(sys.argv.pop())
RUNNER = os.environ.get("LAMINA_MARLIN_RUNNER", "")
PATIENCE_S = 120
NOISY = {"BAUD": "115200", "NOISE_DOWN": "0.001"}


def commands_of(record):
    """What Marlin has run, without numbers and checksums; the streamer's own questions left out."""
    found = []
    with open(record, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            line = re.sub(r"^N-?\d+\s*|\*\d+\s*$", "", line.strip())
            if line and not re.match(r";|M(105|108|110|115|154|155|400|410)\b|M1(04|40) S0", line):
                found.append(line)
    return found


class RealMarlin(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.port, self.record, self.program = (os.path.join(folder.name, name) for name in ("port", "record", "part.gcode"))

    def run_marlin(self, faults):
        environment = {**os.environ, "SPEED": "4", "RECORD": self.record, **faults}
        marlin = subprocess.Popen([RUNNER, self.port], env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  start_new_session=True)
        self.addCleanup(marlin.stdout.close)
        self.addCleanup(marlin.wait)
        self.addCleanup(os.killpg, marlin.pid, signal.SIGTERM)
        self.assertEqual(marlin.stdout.readline().strip(), "ready")

    def stream(self, lines, *options):
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("\n".join(lines) + "\n")
        return subprocess.run([LAMINA, "stream", self.program, "--port", self.port, "--set", "stream.link=lossy", *options],
                              capture_output=True, text=True, timeout=PATIENCE_S, check=False)

    def assert_ran(self, lines):
        """Every line once and in order; what is no whole line of the program was no command that Marlin knows."""
        ran = [command for command in commands_of(self.record) if command[:1] in "GMT" or command in lines]
        self.assertEqual(ran, lines)

    def test_every_line_is_run_once_on_a_noisy_line(self):
        lines = spiral(300)
        for seed in ("1", "2", "3"):
            with self.subTest(seed=seed):
                self.run_marlin({**NOISY, "NOISE_UP": "0.001", "DROP_OK": "0.01", "SEED": seed})
                done = self.stream(lines)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assert_ran(lines)
                self.doCleanups()
                self.setUp()

    def test_a_reset_ends_the_job_whatever_stands_before_the_greeting(self):
        lines = spiral(250)
        for glitch in ("", r"\xff", "xx"):
            with self.subTest(glitch=glitch):
                self.run_marlin({"BAUD": "115200", "RESET_AFTER": "120", "GLITCH": glitch})
                done = self.stream(lines)
                self.assertEqual(done.returncode, 1)
                self.assertIn("reset", done.stderr)
                counts = collections.Counter(commands_of(self.record))
                self.assertEqual([line for line, count in counts.items() if count > 1], [])
                self.doCleanups()
                self.setUp()

    def test_nothing_is_stopped_on_a_machine_that_heats_for_another_sender(self):
        self.run_marlin({"SPEED": "1"})
        with open(self.port, "wb", buffering=0) as port:
            port.write(b"M109 S150\n")
        time.sleep(1.0)  # the other sender goes away
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("G28\n")
        streaming = subprocess.Popen([LAMINA, "stream", self.program, "--port", self.port], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(3.0)
        streaming.send_signal(signal.SIGTERM)
        streaming.wait(PATIENCE_S)
        with open(self.record, encoding="utf-8", errors="replace") as lines:
            self.assertNotIn("M104 S0", lines.read())

    def test_messages_of_the_machine_are_obeyed(self):
        for say, expected in (("//action:cancel", "ends the job"), ("fatal: heater fault", "halted")):
            with self.subTest(say=say):
                self.run_marlin({"SAY_AFTER": "60", "SAY": say})
                done = self.stream(spiral(200))
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(expected, done.stderr)
                self.assertLess(len(commands_of(self.record)), 100)
                self.doCleanups()
                self.setUp()

    def test_cold_extrusion_is_reported(self):
        self.run_marlin({})
        done = self.stream(["G28", "G1 X10 F6000", "G1 X20 E5", "G1 X30"])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("not done: 1", done.stdout)
        self.assertIn("cold extrusion prevented", done.stdout)


if __name__ == "__main__":
    if not RUNNER:
        print("no real Marlin is there: LAMINA_MARLIN_RUNNER is not set")
        sys.exit(77)
    unittest.main()
