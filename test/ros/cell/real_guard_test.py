#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Real firmware whose gcode_streamer is killed is stopped by host_watch (docs/cell/hosts.md).

    real_guard_test.py STREAMER_NODE WATCH_NODE

LAMINA_MARLIN_RUNNER, LAMINA_GRBL_RUNNER and LAMINA_KLIPPER_RUNNER name the programs that real_marlin_test.py and its neighbours in test/cli/real describe.
Without any of them nothing is tested, and the exit code is 77.
"""
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

STREAMER, WATCH = sys.argv[1:3]
RUNNERS = {name: os.environ.get(f"LAMINA_{name.upper()}_RUNNER", "") for name in ("marlin", "grbl", "klipper")}
PATIENCE_S = 90
HOT = ["M140 S60", "M104 S200", "G28", "M106 S200", "G21", "G90", "M83"]
HOT_MOVES = [f"G1 X{10 + i % 50} Y{10 + (i * 7) % 50} E0.3 F1800" for i in range(2000)]
MILL = ["G21", "G90", "M3 S500"] + [f"G1 X{10 + i % 50} Y{10 + (i * 7) % 50} F600" for i in range(2000)]


def free_port():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


class LeftMachine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.port = self.path("port")
        master = free_port()
        self.environment = {**os.environ, "ROS_MASTER_URI": f"http://127.0.0.1:{master}", "ROS_IP": "127.0.0.1", "ROS_HOME": self.folder,
                            "ROSCONSOLE_STDOUT_LINE_BUFFERED": "1", "RECORD": self.path("ran"), "LOG": self.path("wire")}
        self.start("/usr/bin/rosmaster", "--core", "-p", str(master))
        self.wait_for(lambda: self.master_answers(master), "a ROS master")

    def path(self, name):
        return os.path.join(self.folder, name)

    def text(self, name):
        try:
            with open(self.path(name), encoding="utf-8", errors="replace") as file:
                return file.read()
        except FileNotFoundError:
            return ""

    def start(self, *command, said="said", without=()):
        environment = {name: value for name, value in self.environment.items() if name not in without}
        with open(self.path(said), "ab") as file:
            process = subprocess.Popen(command, env=environment, stdout=file, stderr=subprocess.STDOUT, start_new_session=True)
        self.addCleanup(process.wait)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGTERM)
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)

    @staticmethod
    def master_answers(port):
        with socket.socket() as look:
            return look.connect_ex(("127.0.0.1", port)) == 0

    def wait_for(self, holds, what):
        end = time.monotonic() + PATIENCE_S
        while not holds():
            self.assertLess(time.monotonic(), end, f"{what}: not within {PATIENCE_S} s; " + "".join(self.text(name)[-800:] for name in ("said", "firmware", "watch", "streamer")))
            time.sleep(0.1)

    def kill_at_work(self, firmware, program, link, moves):
        """Starts firmware, streamer and watch, kills the streamer amid the program, and returns what the wire has seen since."""
        if not RUNNERS[firmware]:
            self.skipTest(f"no real {firmware} is there")
        self.start(RUNNERS[firmware], self.port, said="firmware", without=("PYTHONPATH", "PYENV_VERSION"))
        self.wait_for(lambda: "ready" in self.text("firmware"), firmware)
        with open(self.path("part.gcode"), "w", encoding="utf-8") as file:
            file.write("\n".join(program) + "\n")
        streamer = self.start(STREAMER, f"_port:={self.port}", f"_guard/socket:={self.path('pulse')}", f"_stream/link:={link}", said="streamer")
        self.start(WATCH, f"_guard/socket:={self.path('pulse')}", "_guard/grace_s:=0", f"_disk/folder:={self.folder}", said="watch")
        self.wait_for(lambda: os.path.exists(self.path("pulse")), "the watch's socket")
        self.start("/usr/bin/rostopic", "pub", "-1", "/stream_program/goal", "lamina/StreamProgramActionGoal",
                   f"goal: {{program: '{self.path('part.gcode')}'}}", said="goal")
        self.wait_for(lambda: len(re.findall("G1 ?X", self.text("ran"))) >= moves, f"{moves} motions")
        streamer.kill()
        seen = len(self.text("wire"))
        self.wait_for(lambda: "2203: " in self.text("watch"), "2203, a machine that was stopped")
        self.assertIn("2201: ", self.text("watch"))
        return self.text("wire")[seen:]

    def assert_runs_nothing_more(self):
        ran = self.text("ran")
        time.sleep(3.0)
        self.assertEqual(re.findall("G1 ?X.*", self.text("ran")), re.findall("G1 ?X.*", ran))

    def test_marlin_is_stopped_and_cools(self):
        log = self.kill_at_work("marlin", HOT + ["M109 S200"] + HOT_MOVES, "lossy", 60)
        self.assertRegex(log, r"(?s)> (N\d+ )?M410.*> (N\d+ )?M104 S0.*> (N\d+ )?M140 S0.*< .*T:\S+ /0\.00 B:\S+ /0\.00")
        self.assertIn("its heaters are off", self.text("watch"))
        self.assert_runs_nothing_more()

    def test_grbl_is_slowed_down_and_reset(self):
        log = self.kill_at_work("grbl", MILL, "reliable", 3)
        self.assertIn("< Grbl 1.1", log)
        self.assertIn("it was slowed down and reset", self.text("watch"))
        self.assert_runs_nothing_more()

    def test_klipper_is_stopped_and_cools(self):
        log = self.kill_at_work("klipper", HOT + HOT_MOVES, "lossy", 60)
        self.assertRegex(log, r"(?s)> TURN_OFF_HEATERS.*< ok B:\S+ /0\.0 T0:\S+ /0\.0")
        self.assertIn("its heaters are off", self.text("watch"))
        self.assert_runs_nothing_more()


if __name__ == "__main__":
    if not any(RUNNERS.values()):
        print("no real firmware is there: neither LAMINA_MARLIN_RUNNER, LAMINA_GRBL_RUNNER nor LAMINA_KLIPPER_RUNNER is set")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
