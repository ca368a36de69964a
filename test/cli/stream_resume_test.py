#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Kills `lamina stream` at the emulated machine, and goes on with its job.

    stream_resume_test.py LAMINA
"""
import contextlib
import json
import os
import random
import signal
import socket
import subprocess
import tempfile
import threading
import time
import unittest

from lamina_command import LAMINA, lamina, reported

LINES = 3000
KILLS = 8
PATIENCE_S = 60


class Cable:
    """A TCP connection to a machine, which can be unplugged: what is on the way is lost, and nobody is reached."""

    def __init__(self, machine_port):
        self.machine_port, self.port, self.sockets = machine_port, 0, []
        self.plug_in()

    def plug_in(self):
        listener = socket.create_server(("127.0.0.1", self.port))
        self.port = listener.getsockname()[1]
        self.sockets = [listener]
        threading.Thread(target=self.accept, args=(listener,), daemon=True).start()

    def accept(self, listener):
        with contextlib.suppress(OSError):
            near, _ = listener.accept()
            far = socket.create_connection(("127.0.0.1", self.machine_port))
            self.sockets += [near, far]
            for source, sink in ((near, far), (far, near)):
                threading.Thread(target=self.carry, args=(source, sink), daemon=True).start()

    @staticmethod
    def carry(source, sink):
        with contextlib.suppress(OSError):
            while received := source.recv(4096):
                sink.sendall(received)

    def unplug(self):
        for end in self.sockets:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()
        self.sockets = []


class StreamResume(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program, self.port, self.record, self.journal = map(self.path, ("part.gcode", "port", "record", "state/job.progress"))
        self.lines = ["G90", "M83"] + ["G1 X%d.%d Y%d F6000" % (i % 97, i % 10, i % 89) for i in range(LINES - 2)]
        with open(self.program, "w", encoding="utf-8") as program:
            for i, line in enumerate(self.lines):
                program.write((f";LAYER:{i // 100}\n" if i % 100 == 0 else "") + line + "\n")
        self.machine = subprocess.Popen([LAMINA, "emulate", "--pty", self.port, "--tcp", "0", "--speed-up", "10", "--record", self.record],
                                        stdout=subprocess.PIPE, text=True)
        self.addCleanup(self.machine.stdout.close)
        self.addCleanup(self.machine.wait)
        self.addCleanup(self.machine.kill)
        self.wait_for(lambda: os.path.exists(self.port))

    def path(self, name):
        return os.path.join(self.folder, name)

    def machine_port(self):
        """The TCP port that the machine has printed."""
        return next(int(line.rsplit(":", 1)[1]) for line in self.machine.stdout if line.startswith("tcp:"))

    def wait_for(self, condition):
        end = time.monotonic() + PATIENCE_S
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)

    def options(self):
        return ("--port", self.port, "--set", f"stream.journal={self.journal}")

    def stream(self, *more):
        return subprocess.Popen([LAMINA, "stream", self.program, *self.options(), *more], stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def known(self):
        return reported("stream", self.program, "--progress", *self.options())

    def kill_at(self, streaming, line):
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["taken_through"] >= line)
        streaming.kill()
        streaming.wait()

    def ran(self):
        """The lines that the machine has run, once it has ended."""
        self.machine.send_signal(signal.SIGINT)
        self.machine.wait(PATIENCE_S)
        with open(self.record, encoding="utf-8") as record:
            return [line.rstrip("\n") for line in record if not line.startswith(";")]

    def test_a_killed_job_goes_on_where_it_was(self):
        places = random.Random(1)
        streaming = self.stream()
        for line in sorted(places.sample(range(1, 2400), KILLS)):
            self.kill_at(streaming, line)
            known = self.known()
            self.assertEqual(known["state"], "Execute")
            self.assertIn(known["layer"], ((known["taken_through"] - 1) // 100, (known["taken_through"] + 7) // 100))
            self.assertLess(known["taken_through"], known["sent_through"])
            streaming = self.stream("--resume")
        self.assertEqual(streaming.wait(PATIENCE_S), 0)
        self.assertEqual(self.known()["state"], "Complete")
        self.assertEqual(self.known()["taken_through"], LINES)
        self.assertEqual(self.ran(), self.lines)
        self.assertEqual(os.stat(os.path.dirname(self.journal)).st_mode & 0o777, 0o700)
        self.assertEqual(os.stat(self.journal).st_mode & 0o777, 0o600)

    def test_a_job_whose_link_was_lost_for_good_goes_on_where_it_was(self):
        cable = Cable(self.machine_port())
        self.addCleanup(cable.unplug)
        options = ("--port", f"tcp:127.0.0.1:{cable.port}", "--set", f"stream.journal={self.journal}", "--set", "stream.safe_stop_timeout_s=1")
        streaming = subprocess.Popen([LAMINA, "stream", self.program, *options], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["taken_through"] >= 300)
        cable.unplug()
        self.assertIn("once it is reached again the job can be resumed", streaming.communicate(timeout=PATIENCE_S)[1])
        self.assertEqual(streaming.returncode, 1)
        self.assertEqual(self.known()["state"], "Execute")
        cable.plug_in()
        reported("stream", self.program, "--resume", *options)
        self.assertEqual(self.ran(), self.lines)

    def test_a_machine_that_has_done_something_else_is_left_alone(self):
        streaming = self.stream()
        self.kill_at(streaming, 200)
        with open(self.port, "wb", buffering=0) as port:
            port.write(b"N0 M110 N0*125\n")
        done = lamina("stream", self.program, *self.options(), "--resume")
        self.assertEqual(done.returncode, 1)
        self.assertIn("waits for line number 1;", done.stderr)
        self.assertIn("was certainly taken", done.stderr)
        ran = self.ran()
        self.assertLess(len(ran), LINES)
        self.assertEqual(ran, self.lines[:len(ran)])

    def test_another_program_or_port_is_refused_before_anything_is_sent(self):
        streaming = self.stream()
        self.kill_at(streaming, 200)
        with open(self.program, "a", encoding="utf-8") as program:
            program.write("G1 X1\n")
        done = lamina("stream", self.program, *self.options(), "--resume")
        self.assertEqual(done.returncode, 1)
        self.assertIn("another program", done.stderr)
        done = lamina("stream", self.program, "--port", "/dev/null", "--set", f"stream.journal={self.journal}", "--resume")
        self.assertIn("the job to go on with was at " + self.port, done.stderr)

    def test_a_job_that_was_stopped_does_not_just_go_on(self):
        streaming = self.stream()
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["taken_through"] >= 200)
        streaming.send_signal(signal.SIGTERM)
        self.assertNotEqual(streaming.wait(PATIENCE_S), 0)
        self.assertEqual(self.known()["state"], "Aborted")
        offer = reported("resume", self.program, *self.options())
        taken = self.known()["taken_through"]
        self.assertEqual((offer["from_line"], offer["from_layer"], offer["from_height"]), (taken + 1, taken // 100, 0))
        self.assertIn("line %d of 3000 was certainly taken" % taken, offer["known"])
        done = lamina("stream", self.program, *self.options(), "--resume", "--json")
        self.assertEqual(json.loads(done.stdout)["error"]["code"], "InvalidInput")

    def test_a_job_follows_what_is_typed_while_it_runs(self):
        streaming = subprocess.Popen([LAMINA, "stream", self.program, "--live", *self.options()], stdout=subprocess.DEVNULL,
                                     stdin=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["taken_through"] > 0)
        streaming.stdin.write("pause_at_layer 20\nfeed 200\nfeed 900\nhurry\n")
        streaming.stdin.flush()
        self.wait_for(lambda: self.known()["state"] == "Held")
        streaming.stdin.write("resume\n")
        said = streaming.communicate(timeout=PATIENCE_S)[1]
        self.assertEqual(streaming.returncode, 0, said)
        for answer in ("pause_at_layer 20: taken", "feed 200: taken", "feed 900: feed is 900 %; must be from 10 to 300 %",
                       "hurry: no number; expected such as feed 90", "resume: asked for"):
            self.assertIn(answer, said)
        self.assertEqual(self.ran(), self.lines)

    def stop_while_typing(self, *typed):
        """Types without end, and stops the job meanwhile."""
        typing = subprocess.Popen(typed, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        self.addCleanup(typing.stdout.close)
        self.addCleanup(typing.wait)
        self.addCleanup(typing.kill)
        streaming = subprocess.Popen([LAMINA, "stream", self.program, "--live", *self.options()], stdout=subprocess.DEVNULL,
                                     stdin=typing.stdout, stderr=subprocess.DEVNULL)
        self.addCleanup(streaming.wait)
        self.addCleanup(streaming.kill)
        self.wait_for(lambda: os.path.exists(self.journal) and self.known()["state"] == "Execute")
        streaming.send_signal(signal.SIGINT)
        self.assertEqual(streaming.wait(PATIENCE_S), 1)
        self.assertEqual(self.known()["state"], "Aborted")

    def test_lines_without_end_keep_no_job_from_being_stopped(self):
        self.stop_while_typing("yes")

    def test_a_line_without_end_keeps_no_job_from_being_stopped(self):
        self.stop_while_typing("cat", "/dev/zero")

    def test_without_a_journal_nothing_is_kept(self):
        done = lamina("stream", self.program, "--port", self.port, "--set", "stream.journal=")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(os.path.exists(os.path.dirname(self.journal)))
        done = lamina("stream", self.program, "--port", self.port, "--set", "stream.journal=", "--resume")
        self.assertIn("no progress file is kept", done.stderr)


class Rest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.program, self.rest = (os.path.join(folder.name, name) for name in ("part.gcode", "rest.gcode"))
        with open(self.program, "w", encoding="utf-8") as program:
            program.write("M140 S60\nG28\nM109 S200\nG1 X20 Y20 Z0.2\n;LAYER:0\nG1 X40 E1\n;LAYER:1\nG1 Z0.4\nG1 X20 E2\n")

    def test_line_layer_and_height_lead_to_the_same_rest(self):
        for where, line in (("--from-line=7", 7), ("--from-layer=1", 6), ("--from-height=0.4", 7)):
            made = reported("resume", self.program, where, "--nozzle-height=50", "-o", self.rest)
            self.assertEqual(made["from_line"], line)
            self.assertIn("z = 50 mm", " ".join(made["to_check"]))
            with open(self.rest, encoding="utf-8") as rest:
                text = rest.read()
            self.assertIn("G28 X Y\n", text)
            self.assertIn("G1 X20 E2\n", text)
            self.assertNotIn("G1 X40 E1\n", text)

    def test_a_line_below_zero_is_named_as_it_was_typed(self):
        done = lamina("resume", self.program, "--from-line=-5", "--nozzle-height=1", "-o", self.rest)
        self.assertEqual(done.returncode, 105, done.stderr)
        self.assertIn("--from-line: -5; expected 1 or more", done.stderr)

    def test_the_height_of_the_nozzle_must_be_stated(self):
        done = lamina("resume", self.program, "--from-line=7", "-o", self.rest)
        self.assertEqual(done.returncode, 1)
        self.assertIn("--nozzle-height", done.stderr)
        done = lamina("resume", self.program, "--nozzle-height=50", "-o", self.rest)
        self.assertIn("--from-line, --from-layer or --from-height", done.stderr)
        self.assertFalse(os.path.exists(self.rest))


if __name__ == "__main__":
    unittest.main()
