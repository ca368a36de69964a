#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kills `lamina stream` at random instants while a real Marlin prints, and goes on with the job.

    real_marlin_kill_test.py LAMINA

LAMINA_MARLIN_RUNNER as in real_marlin_test.py; without it nothing is tested, and the exit code is 77. LAMINA_KILLS is the number of kills (10). After
some of them the head of a line is sent, as a write that was cut off would leave it.
"""
import os
import random
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
KILLS = int(os.environ.get("LAMINA_KILLS", "10"))
PATIENCE_S = 120
LINES_A_JOB = 1500
KILLS_A_JOB = 10
OWN = re.compile(r";|M(105|108|110|115|154|155|400|410)\b|M1(04|40) S0")


def checksum(text):
    value = 0
    for byte in text.encode():
        value ^= byte
    return value


class KilledAtRealMarlin(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.port, self.record, self.program, self.journal = (os.path.join(folder.name, name)
                                                              for name in ("port", "record", "part.gcode", "progress"))

    def run_marlin(self):
        environment = {"SPEED": "4", **os.environ, "RECORD": self.record}
        marlin = subprocess.Popen([RUNNER, self.port], env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  start_new_session=True)
        self.addCleanup(marlin.stdout.close)
        self.addCleanup(marlin.wait)
        self.addCleanup(os.killpg, marlin.pid, signal.SIGTERM)
        self.assertEqual(marlin.stdout.readline().strip(), "ready")

    def stream(self, *options):
        return subprocess.Popen([LAMINA, "stream", self.program, "--port", self.port, "--set", f"stream.journal={self.journal}", *options],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def begin(self, lines):
        self.run_marlin()
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("\n".join(lines) + "\n")
        streaming = self.stream()
        end = time.monotonic() + PATIENCE_S
        while not os.path.exists(self.journal):
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(streaming.poll())
            time.sleep(0.005)
        return streaming

    def cut_off(self, instant):
        """Leaves the head of a line in Marlin's buffer: of the next line, of one without a number, or of one whose end is missing only."""
        with open(self.record, encoding="utf-8", errors="replace") as record:
            numbers = [int(number) for number in re.findall(r"^N(\d+)", record.read(), re.M)]
        if not numbers:
            return
        whole = f"N{numbers[-1] + 1} G1 X1.234 Y5.678 F6000"
        whole += f"*{checksum(whole)}"
        heads = (whole[:instant.randrange(1, len(whole) - 3)], "M1", "M4", "M104 S", "N")
        with open(self.port, "wb", buffering=0) as port:
            port.write(instant.choice(heads).encode())

    def ran(self):
        found = []
        with open(self.record, encoding="utf-8", errors="replace") as lines:
            for line in lines:
                command = re.sub(r"^N-?\d+\s*|\*\d+\s*$", "", line.strip())
                if command and not OWN.match(command):
                    found.append(command)
        return found

    def test_no_line_is_lost_or_run_twice(self):
        instant = random.Random(int(os.environ.get("SEED", "1")))
        killed = cut = jobs = 0
        while killed < KILLS:
            lines = spiral(LINES_A_JOB)
            streaming = self.begin(lines)
            jobs += 1
            for _ in range(min(KILLS_A_JOB, KILLS - killed)):
                time.sleep(instant.uniform(0.0, 1.2))
                if streaming.poll() is not None:
                    break
                streaming.kill()
                streaming.communicate()
                killed += 1
                if instant.random() < 0.3:
                    time.sleep(0.3)  # until what was sent has been read
                    self.cut_off(instant)
                    cut += 1
                streaming = self.stream("--resume")
            reported = streaming.communicate(timeout=PATIENCE_S)[0]
            self.assertEqual(streaming.returncode, 0, reported)
            self.assertEqual(self.ran(), lines)
            self.doCleanups()
            self.setUp()
        print(f"{killed} kills in {jobs} jobs of {LINES_A_JOB} lines, {cut} with a line cut off: 0 lost, 0 repeated, 0 fragments")


if __name__ == "__main__":
    if not RUNNER:
        print("no real Marlin is there: LAMINA_MARLIN_RUNNER is not set")
        sys.exit(77)
    unittest.main()
