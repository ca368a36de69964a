#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streams to a real Klipper whose microcontroller runs as a program of this computer.

    real_klipper_test.py LAMINA

LAMINA_KLIPPER_RUNNER names a program `RUNNER LINK` that runs Klipper behind a pseudo-terminal at LINK until it is ended, and prints `ready`. It takes
from its environment NOZZLE_C, the temperature that the nozzle shows all the time, LOG, a file of both directions (`>` to Klipper, `<` from it), and
RECORD: the file for the commands that Klipper has run (docs/streaming/firmware/klipper.md). Without it nothing is tested, and the exit code is 77.
"""
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
RUNNER = os.environ.get("LAMINA_KLIPPER_RUNNER", "")
PATIENCE_S = 120


class RealKlipper(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.port, self.record, self.log, self.program = (os.path.join(folder.name, name) for name in ("port", "record", "log", "part.gcode"))

    def run_klipper(self, **environment):
        environment = {**os.environ, "RECORD": self.record, "LOG": self.log, **environment}
        klipper = subprocess.Popen([RUNNER, self.port], env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                   start_new_session=True)
        self.addCleanup(klipper.stdout.close)
        self.addCleanup(klipper.wait)
        self.addCleanup(os.killpg, klipper.pid, signal.SIGTERM)
        self.assertEqual(klipper.stdout.readline().strip(), "ready")

    def begin(self, lines, *settings, live=False):
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("\n".join(lines) + "\n")
        command = [LAMINA, "stream", self.program, "--port", self.port] + [word for setting in settings for word in ("--set", setting)]
        return subprocess.Popen(command + ["--live"] * live, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def stream(self, lines):
        job = self.begin(lines)
        out, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        return job.returncode, out, reported

    def skip_if_stalled(self, reported):
        """A microcontroller that is a program of a busy computer comes too late, and Klipper shuts down."""
        if re.search("Timer too close|Stepper too far in past|Rescheduled timer in the past|Lost communication", reported):
            self.skipTest("the computer is too busy for Klipper: " + reported.strip())

    def say(self, command):
        """Another sender's command, behind the streamer's back."""
        with open(self.port, "wb", buffering=0) as port:
            port.write(command.encode() + b"\n")

    def ran(self):
        with open(self.record, encoding="utf-8", errors="replace") as lines:
            commands = [line.strip() for line in lines]
        own = re.compile(r"(M115|M105|M400|STATUS|ECHO|TURN_OFF_HEATERS|FIRMWARE_RESTART|;)")
        return [command for command in commands if command and not own.match(command)]

    def sent(self):
        with open(self.log, encoding="utf-8", errors="replace") as lines:
            return [line.split("> ", 1)[1].strip() for line in lines if "> " in line]

    def test_every_line_is_run_once(self):
        self.run_klipper()
        lines = spiral(500)
        code, _, reported = self.stream(lines)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), lines)

    def test_an_error_ends_the_job_and_nothing_behind_it_is_run(self):
        self.run_klipper(NOZZLE_C="25")
        code, _, reported = self.stream(["G90", "G28", "M83", "G1 X20 E5 F6000", "G1 X30"])
        self.assertEqual(code, 1)
        self.assertIn("Extrude below minimum temp", reported)
        self.assertNotIn("confirm", reported)
        self.assertNotIn("G1 X30", self.sent())
        self.assertIn("TURN_OFF_HEATERS", self.sent())

    def test_commands_that_it_does_not_know_are_counted(self):
        self.run_klipper()
        code, out, reported = self.stream(["G90", "M4242", "FROBNICATE A=1"])
        self.assertEqual(code, 0, reported)
        self.assertIn("not done: 2", out)

    def test_an_interrupted_job_stops_safely(self):
        self.run_klipper()
        job = self.begin(["M104 S180"] + spiral(2000))
        time.sleep(4.0)
        job.send_signal(signal.SIGINT)
        _, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        self.assertEqual(job.returncode, 1)
        self.assertNotIn("confirm", reported)
        self.assertIn("TURN_OFF_HEATERS", self.sent())

    def test_an_emergency_stop_ends_a_wait_for_heat(self):
        self.run_klipper()
        job = self.begin(spiral(10) + ["M109 S250"], "stream.safe_stop_timeout_s=5", "stream.emergency_stop=unconfirmed")
        time.sleep(4.0)
        job.send_signal(signal.SIGINT)
        _, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        self.assertEqual(job.returncode, 1)
        self.assertIn("an emergency stop was sent; the machine halted", reported)
        self.assertEqual(self.sent().count("M112"), 1)

    def test_an_emergency_stop_is_heard_behind_all_that_waits(self):
        """Klipper looks for it while it keeps fewer than twenty lines: questions, and a stop that is said again and again."""
        self.run_klipper()
        job = self.begin(["M106 S255", "M106 P1 S255", "G4 P900000"], "stream.probe_after_s=0.1", "stream.safe_stop_timeout_s=8",
                         "stream.emergency_stop=unconfirmed")
        time.sleep(10.0)
        job.send_signal(signal.SIGINT)
        _, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        self.assertIn("an emergency stop was sent; the machine halted", reported)
        waiting = self.sent()[self.sent().index("G4 P900000"):]
        self.assertEqual(waiting[-1], "M112")
        self.assertGreater(len(waiting), 10)
        self.assertLess(len(waiting), 20)

    def test_it_is_changed_between_two_lines(self):
        self.run_klipper()
        lines = spiral(300)
        job = self.begin(lines, live=True)
        time.sleep(3.0)
        job.stdin.write("feed 80\nbabystep -0.05\nspindle 50\n")
        job.stdin.close()
        job.stdin = None
        _, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        self.assertEqual(job.returncode, 0, reported)
        changes = ["M220 S80", "SET_GCODE_OFFSET Z_ADJUST=-0.05 MOVE=1"]
        self.assertEqual([line for line in self.ran() if line in changes], changes)
        self.assertEqual([line for line in self.ran() if line not in changes], lines)
        self.assertIn("spindle 50: Klipper has no spindle", reported)

    def test_a_machine_in_shutdown_is_left_alone(self):
        self.run_klipper()
        self.say("M112")
        time.sleep(1.0)
        code, _, reported = self.stream(spiral(10))
        self.assertEqual(code, 1)
        self.assertIn("Shutdown due to M112", reported)
        self.assertEqual(set(self.sent()), {"M112", "M115", "STATUS"})

    def test_a_shutdown_under_way_is_reported_with_its_reason(self):
        self.run_klipper()
        code, _, reported = self.stream(spiral(50) + ["M112"] + spiral(50))
        self.assertEqual(code, 1)
        self.assertIn("Shutdown due to M112", reported)
        self.assertIn("does not confirm", reported)

    def test_a_restart_under_way_ends_the_job(self):
        self.run_klipper()
        code, _, reported = self.stream(spiral(50) + ["FIRMWARE_RESTART"] + spiral(50))
        self.assertEqual(code, 1)
        self.assertIn("the machine was reset", reported)


if __name__ == "__main__":
    if not RUNNER:
        print("no real Klipper is there: LAMINA_KLIPPER_RUNNER is not set")
        sys.exit(77)
    unittest.main()
