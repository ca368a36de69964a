#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Streams to a real grbl that runs as a program of this computer, with resets, alarms and errors.

    real_grbl_test.py LAMINA

LAMINA_GRBL_RUNNER names a program `RUNNER LINK` that runs grbl behind a pseudo-terminal at LINK until it is ended, and prints `ready`. It takes from its
environment RESET_AFTER, SAY_AFTER, SAY, LOG: a file for the lines of both directions (` 1.2052 < <Idle|...>`), and RECORD: the file for the lines that grbl
has read, each behind its answer (`ok G1 X1`); `; reset` where it was reset. LAMINA_GRBL_MOVES is the length of the program that is streamed whole (2000).
Without the runner nothing is tested, and the exit code is 77.
"""
import os
import re
import select
import signal
import subprocess
import sys
import tempfile
import time
import tty
import unittest

LAMINA = os.path.abspath(sys.argv.pop())
RUNNER = os.environ.get("LAMINA_GRBL_RUNNER", "")
MOVES = int(os.environ.get("LAMINA_GRBL_MOVES", "2000"))
PATIENCE_S = 300
STANDING_S = 5.0  # in which a grbl that runs goes 25 mm at F300


def steps(count):
    """A program of short motions, none like another."""
    return ["G21", "G90", "F300"] + ["G1 X%.3f" % (0.02 * (i + 1)) for i in range(count)]


class RealGrbl(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.port, self.record, self.log, self.program = (os.path.join(folder.name, name) for name in ("port", "record", "log", "part.nc"))

    def run_grbl(self, **faults):
        grbl = subprocess.Popen([RUNNER, self.port], env={**os.environ, "RECORD": self.record, "LOG": self.log, **faults}, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, text=True, start_new_session=True)
        self.addCleanup(grbl.stdout.close)
        self.addCleanup(grbl.wait)
        self.addCleanup(os.killpg, grbl.pid, signal.SIGTERM)
        self.assertEqual(grbl.stdout.readline().strip(), "ready")

    def begin(self, lines, *options):
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("\n".join(lines) + "\n")
        streaming = subprocess.Popen([LAMINA, "stream", self.program, "--port", self.port, *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE, text=True)
        self.addCleanup(self.end, streaming)
        return streaming

    def end(self, streaming):
        """Whoever skips a test leaves it."""
        if streaming.poll() is None:
            streaming.kill()
            streaming.communicate()

    def stream(self, lines, *options):
        streaming = self.begin(lines, *options)
        output, errors = self.finish(streaming, lines)
        self.skip_if_defective(lines, errors)
        return streaming.returncode, output, errors

    def finish(self, streaming, lines):
        """Output and errors of a streaming that ends by itself. One that waits for a defective grbl does not."""
        try:
            return streaming.communicate(timeout=PATIENCE_S)
        except subprocess.TimeoutExpired:
            self.skip_if_defective(lines)
            raise

    def opened_port(self):
        """The port of a grbl that is at rest and reads."""
        descriptor = os.open(self.port, os.O_RDWR | os.O_NOCTTY)
        tty.setraw(descriptor)
        for _ in range(PATIENCE_S):
            if b"<Idle" in self.say(descriptor, b"?", b">", 1.0):
                return descriptor
        self.fail("grbl does not report that it is at rest")

    def say(self, descriptor, words, awaited, patience_s=PATIENCE_S):
        """What grbl sends until it has sent what is awaited, or until it is silent."""
        os.write(descriptor, words)
        heard = b""
        while awaited not in heard and select.select([descriptor], [], [], patience_s)[0]:
            heard += os.read(descriptor, 4096)
        return heard

    def wait_until(self, is_reached):
        """Waits for what grbl has recorded; the assertions behind it name what is missing."""
        for _ in range(int(PATIENCE_S / 0.05)):
            if os.path.exists(self.record) and os.path.exists(self.log) and is_reached():
                return
            time.sleep(0.05)

    def standing_time(self):
        """The longest time [s] for which grbl has said that it runs, all at one place."""
        longest, place, since = 0.0, None, 0.0
        if not os.path.exists(self.log):
            return longest
        with open(self.log, encoding="utf-8", errors="replace") as entries:
            for entry in entries:
                report = re.match(r"\s*([\d.]+) < <(\w+)[^|]*\|MPos:([^|>]*)", entry)
                if not report:
                    continue
                time_s, here = float(report[1]), report[3] if report[2] == "Run" else None
                if here is None or here != place:
                    place, since = here, time_s
                longest = max(longest, time_s - since if here else 0.0)
        return longest

    def skip_if_defective(self, lines, errors=""):
        """The interrupts of a simulated chip come amid any instruction of its program: now and then it loses the one that ends or makes a step. Whatever
        was sent must have been taken as it is, once and in order; what becomes of it behind that is no matter of the streamer."""
        if self.standing_time() > STANDING_S:
            self.assert_ran_the_start_of(lines)
            self.skipTest("the simulated grbl runs without a step for %.1f s" % self.standing_time())
        if "does not stand where they end" in errors and self.assert_ran_the_start_of(lines) == len(lines):
            self.skipTest("the simulated grbl has taken every line, and lacks steps: " + errors.strip())

    def ran(self):
        """The lines of the program that grbl has taken."""
        with open(self.record, encoding="utf-8", errors="replace") as lines:
            answered = [line.strip().split(" ", 1) for line in lines]
        return [words[1].replace(" ", "") for words in answered if words[0] == "ok" and len(words) > 1 and words[1][0] in "GFM"]

    def assert_ran_the_start_of(self, lines):
        ran = self.ran()
        self.assertEqual(ran, [line.replace(" ", "") for line in lines][:len(ran)])
        return len(ran)

    def test_every_line_is_run_once(self):
        self.run_grbl()
        lines = steps(MOVES)
        code, output, errors = self.stream(lines)
        self.assertEqual(code, 0, errors)
        self.assertIn("firmware: grbl 1.1", output)
        self.assertEqual(self.assert_ran_the_start_of(lines), len(lines))

    def test_a_reset_ends_the_job(self):
        self.run_grbl(RESET_AFTER="40")
        code, _, errors = self.stream(steps(200))
        self.assertEqual(code, 1)
        self.assertIn("the machine was reset", errors)
        self.assertNotIn("did not confirm", errors)
        ran = self.ran()
        self.assertEqual(len(ran), len(set(ran)))

    def test_an_alarm_ends_the_job(self):
        self.run_grbl(SAY_AFTER="30", SAY="ALARM:1")
        lines = steps(200)
        code, _, errors = self.stream(lines)
        self.assertEqual(code, 1)
        self.assertIn("a limit switch was hit", errors)
        self.assertNotIn("did not confirm", errors)
        self.assertLess(self.assert_ran_the_start_of(lines), 60)

    def test_an_interrupt_stops_the_machine_safely(self):
        self.run_grbl()
        lines = ["M3 S500"] + steps(0) + ["G1 X5", "G1 X1", "G1 X6", "G1 X2"]
        streaming = self.begin(lines)
        self.wait_until(lambda: len(self.ran()) > 4)  # in motion
        streaming.send_signal(signal.SIGINT)
        _, errors = self.finish(streaming, lines)
        self.assertEqual(streaming.returncode, 1, errors)
        self.assertIn("stopped by the user", errors)
        self.assertNotIn("did not confirm", errors)
        self.assertNotIn("position is lost", errors)
        self.assert_ran_the_start_of(lines)

    def overrides(self):
        """What grbl has reported last of feed, rapid motions and spindle [%]."""
        with open(self.log, encoding="utf-8", errors="replace") as lines:
            return ([""] + re.findall(r"Ov:(\d+,\d+,\d+)", lines.read()))[-1]

    def test_it_is_overridden_amid_its_lines(self):
        self.run_grbl()
        lines = ["M3 S500"] + steps(0) + ["G1 X5", "G1 X1"] * 20
        streaming = self.begin(lines, "--live")
        self.wait_until(lambda: len(self.ran()) > 4)
        streaming.stdin.write("spindle 73\nfeed 121\nrapid 50\nflow 90\n")
        streaming.stdin.flush()
        self.wait_until(lambda: self.overrides() == "121,50,73")
        self.assertEqual(self.overrides(), "121,50,73")
        streaming.send_signal(signal.SIGINT)
        _, errors = self.finish(streaming, lines)
        self.assertIn("flow 90: grbl has no flow", errors)
        self.assertNotIn("in time", errors)
        self.assert_ran_the_start_of(lines)

    def test_it_holds_in_front_of_a_layer(self):
        self.run_grbl()
        lines = steps(120)
        with_layers = lines[:3] + [";LAYER:0"] + lines[3:63] + [";LAYER:1"] + lines[63:]
        streaming = self.begin(with_layers, "--live")
        self.wait_until(lambda: len(self.ran()) > 5)
        streaming.stdin.write("pause_at_layer 1\n")
        streaming.stdin.flush()
        self.wait_until(lambda: len(self.ran()) >= 63 or self.standing_time() > STANDING_S)
        time.sleep(4.0)  # in which no further line may follow
        self.skip_if_defective(lines)
        self.assertEqual(self.assert_ran_the_start_of(lines), 63)
        streaming.stdin.write("resume\n")
        _, errors = self.finish(streaming, lines)
        self.skip_if_defective(lines, errors)
        self.assertEqual(streaming.returncode, 0, errors)
        self.assertIn("holds in front of layer 1", errors)
        self.assertEqual(self.assert_ran_the_start_of(lines), len(lines))

    def test_a_job_that_was_killed_goes_on_where_the_machine_stands(self):
        self.run_grbl()
        lines = steps(60)
        journal = ("--set", "stream.journal=" + self.record + ".progress")
        killed = self.begin(lines, *journal)
        self.wait_until(lambda: len(self.ran()) > 20)
        killed.kill()
        killed.communicate()
        time.sleep(1.0)
        streaming = self.begin(lines, "--resume", *journal)
        _, errors = self.finish(streaming, lines)
        self.skip_if_defective(lines, errors)
        self.assertEqual(streaming.returncode, 0, errors)
        self.assertEqual(self.assert_ran_the_start_of(lines), len(lines))

    def test_a_line_that_is_refused_ends_the_job(self):
        self.run_grbl()
        lines = steps(5) + ["G2 X5 Y5"] + ["G1 X9"]  # an arc without its centre
        code, _, errors = self.stream(lines)
        self.assertEqual(code, 1)
        self.assertIn("error:35", errors)
        self.assertIn("line 9", errors)
        self.assertNotIn("did not confirm", errors)

    def test_a_line_that_it_does_not_know_is_named_before_the_first(self):
        self.run_grbl()
        code, _, errors = self.stream(["G21", "M104 S200"])
        self.assertEqual(code, 1)
        self.assertIn("line 2", errors)
        self.assertIn("M104", errors)
        self.assertEqual(self.ran(), [])

    def test_a_laser_whose_beam_would_burn_on_is_reported(self):
        self.run_grbl()
        descriptor = self.opened_port()
        self.say(descriptor, b"$32=1\n", b"ok")
        os.close(descriptor)
        for power, is_reported in (("M3 S10", True), ("M4 S10", False)):
            code, _, errors = self.stream(["G21", "G90", power, "G1 X1 F300", "M5"])
            self.assertEqual(code, 0, errors)
            self.assertEqual("line 3: '%s' keeps the laser on" % power in errors, is_reported, errors)

    def test_a_locked_machine_is_unlocked_only_where_that_is_asked_for(self):
        self.run_grbl()
        descriptor = self.opened_port()
        self.say(descriptor, b"G1 X50 F60\n", b"ok")
        for _ in range(PATIENCE_S):
            if b"<Run" in self.say(descriptor, b"?", b">", 1.0):
                break
        self.say(descriptor, b"\x18", b"Grbl 1.1")  # in motion
        os.close(descriptor)
        lines = ["G21", "G90", "G1 X1 F300"]
        code, _, errors = self.stream(lines)
        self.assertEqual(code, 1)
        self.assertIn("the machine is locked", errors)
        self.assertIn("$H", errors)
        code, _, errors = self.stream(lines, "--set", "stream.unlock=once")
        self.assertEqual(code, 0, errors)


if __name__ == "__main__":
    if not RUNNER:
        print("no real grbl is there: LAMINA_GRBL_RUNNER is not set")
        sys.exit(77)
    unittest.main()
