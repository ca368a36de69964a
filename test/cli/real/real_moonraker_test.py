#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints by upload to a real Moonraker before a real Klipper, whose microcontroller runs as a program of this computer.

    real_moonraker_test.py LAMINA

LAMINA_MOONRAKER_RUNNER names a program `RUNNER FOLDER` that runs all three until it is ended, and prints `ready`. By then it has put into FOLDER:
url (http://host:port), moonraker.pid, klippy.pid and record, to which Klipper adds each line of a file when it has run it. From its environment it
takes NOZZLE_C, the temperature that the nozzle shows all the time, and LOGINS=1: a person has an account and must log in; the API key is then in
FOLDER/key (docs/streaming/firmware/upload.md). Without a runner nothing is tested, and the exit code is 77.
"""
import contextlib
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import urllib.request

from spiral_program import spiral

LAMINA = os.path.abspath(sys.argv.pop())
RUNNER = os.environ.get("LAMINA_MOONRAKER_RUNNER", "")
PATIENCE_S = 120
QUERY = "/printer/objects/query?webhooks&print_stats&toolhead&extruder&heater_bed&idle_timeout"


class RealMoonraker(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = self.path("part.gcode")
        self.environment = {**os.environ, "XDG_STATE_HOME": self.path("state")}

    def path(self, name):
        return os.path.join(self.folder, name)

    def text_of(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read().strip()

    def run_moonraker(self, **environment):
        with open(self.path("reported"), "w", encoding="utf-8") as reported:
            runner = subprocess.Popen([RUNNER, self.folder], env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=reported, text=True,
                                      start_new_session=True)
        self.addCleanup(runner.stdout.close)
        self.addCleanup(runner.wait)
        self.addCleanup(os.killpg, runner.pid, signal.SIGTERM)
        self.assertEqual(runner.stdout.readline().strip(), "ready", self.text_of("reported"))
        self.url = self.text_of("url")

    def kill(self, name):
        os.kill(int(self.text_of(name + ".pid")), signal.SIGKILL)

    def ask(self, target, method="GET"):
        """Another client, behind the back of ours."""
        key = {"X-Api-Key": self.text_of("key")} if os.path.exists(self.path("key")) else {}
        with urllib.request.urlopen(urllib.request.Request(self.url + target, method=method, headers=key), timeout=30) as answer:
            return json.load(answer)["result"]

    def ask_in_vain(self, target):
        with contextlib.suppress(OSError):
            self.ask(target, "POST")

    def machine(self):
        return self.ask(QUERY)["status"]

    def files(self):
        return [file["path"] for file in self.ask("/server/files/list?root=gcodes")]

    def lamina(self, *words):
        return subprocess.run([LAMINA, *words, "--port", self.url], env=self.environment, capture_output=True, text=True, timeout=PATIENCE_S,
                              check=False)

    def begin(self, lines, *settings, live=False, text=None):
        with open(self.program, "wb") as program:
            program.write(text if text is not None else "".join(line + "\n" for line in lines).encode())
        command = [LAMINA, "stream", self.program, "--port", self.url] + [word for setting in settings for word in ("--set", setting)]
        job = subprocess.Popen(command + ["--live"] * live, env=self.environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (job.kill(), job.communicate()) if job.poll() is None else None)
        return job

    def end_of(self, job):
        out, reported = job.communicate(timeout=PATIENCE_S)
        self.skip_if_stalled(reported)
        return job.returncode, out, reported

    def print(self, lines, *settings, **how):
        return self.end_of(self.begin(lines, *settings, **how))

    def skip_if_stalled(self, reported):
        """A microcontroller that is a program of a busy computer comes too late, and Klipper shuts down."""
        if re.search("Timer too close|Stepper too far in past|Rescheduled timer in the past|Lost communication with MCU", reported):
            self.skipTest("the computer is too busy for Klipper: " + reported.strip())

    def ran(self):
        return self.text_of("record").splitlines()

    def await_lines(self, count):
        for _ in range(PATIENCE_S * 10):
            if len(self.ran()) >= count:
                return
            time.sleep(0.1)
        self.skip_if_stalled(self.machine()["webhooks"]["state_message"])
        self.fail("%d lines were run, not %d" % (len(self.ran()), count))

    def expect_stopped(self, reported, lines):
        """What was run is the beginning of the program, each line once; the machine has ended the print and is cold."""
        machine = self.machine()
        self.assertIn("its heaters are off", reported)
        self.assertEqual(self.ran(), lines[:len(self.ran())])
        self.assertLess(len(self.ran()), len(lines))
        self.assertEqual(machine["extruder"]["target"], 0)
        self.assertEqual(machine["heater_bed"]["target"], 0)
        self.assertNotIn(machine["print_stats"]["state"], ("printing", "paused"))
        self.assertEqual(self.files(), [])

    def test_every_line_is_run_once_and_complete_is_reported_when_motions_have_ended(self):
        self.run_moonraker()
        lines = spiral(300)
        code, out, reported = self.print(lines, "stream.firmware=klipper")
        toolhead = self.machine()["toolhead"]
        self.assertEqual(code, 0, reported)
        self.assertIn("Complete: 300 lines", out)
        self.assertIn("Klipper (Moonraker", out)
        self.assertEqual(self.ran(), lines)
        self.assertGreater(toolhead["estimated_print_time"], toolhead["print_time"])
        self.assertEqual(self.files(), [])

    def test_it_is_found_by_itself_and_prints_again(self):
        self.run_moonraker()
        lines = spiral(100)
        for _ in range(2):
            code, out, reported = self.print(lines)
            self.assertEqual(code, 0, reported)
            self.assertIn("Klipper (Moonraker", out)
        self.assertEqual(self.ran(), lines + lines)

    def test_files_of_all_kinds_are_read_as_they_are_meant(self):
        self.run_moonraker()
        self.program = self.path('Teil 1 "ä" (100%) #2;a&b=c+d.gcode')
        code, _, reported = self.print([], text="G90 ; nach außen\r\nM83\r\n\r\n; Öse\r\nG28\r\nG1 X10 F6000 ; 90°\r\nG1 X20".encode())
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), ["G90", "M83", "G28", "G1 X10 F6000", "G1 X20"])
        self.assertEqual(self.files(), [])

    def test_a_program_without_motion_is_complete(self):
        self.run_moonraker()
        code, _, reported = self.print(["G90"])
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), ["G90"])

    def test_an_interrupted_print_is_cancelled(self):
        self.run_moonraker()
        lines = ["M104 S180", "M140 S50"] + spiral(2000)
        job = self.begin(lines)
        self.await_lines(200)
        job.send_signal(signal.SIGINT)
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("stopped by the user", reported)
        self.expect_stopped(reported, lines)
        self.assertEqual(self.machine()["print_stats"]["state"], "cancelled")

    def test_a_print_that_its_file_has_paused_is_ended(self):
        self.run_moonraker()
        lines = ["M104 S180"] + spiral(100) + ["M25"] + spiral(100)
        job = self.begin(lines)
        self.await_lines(102)
        time.sleep(3.0)
        self.assertEqual(self.machine()["print_stats"]["state"], "paused")
        job.send_signal(signal.SIGINT)
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.expect_stopped(reported, lines)

    def test_a_stop_that_waits_for_heat_is_not_called_confirmed(self):
        self.run_moonraker()
        job = self.begin(spiral(10) + ["M109 S250"] + spiral(10), "stream.safe_stop_timeout_s=5")
        self.await_lines(10)
        time.sleep(3.0)
        job.send_signal(signal.SIGINT)
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("has not confirmed within 5 s", reported)

    def test_it_pauses_and_goes_on(self):
        self.run_moonraker()
        lines = spiral(500)
        job = self.begin(lines, live=True)
        self.await_lines(150)
        job.stdin.write("pause\n")
        job.stdin.flush()
        time.sleep(4.0)
        held = self.ran()
        self.assertEqual(self.machine()["print_stats"]["state"], "paused")
        time.sleep(3.0)
        self.assertEqual(self.ran(), held)
        job.stdin.write("resume\n")
        job.stdin.flush()
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), lines)

    def type(self, job, *lines):
        try:
            job.stdin.write("".join(line + "\n" for line in lines))
            job.stdin.flush()
        except BrokenPipeError:
            self.fail(self.end_of(job)[2])

    def await_machine(self, what, is_so):
        for _ in range(150):
            found = self.ask("/printer/objects/query?" + what)["status"]
            if is_so(found):
                return
            time.sleep(0.1)
        self.fail(str(found))

    def test_it_is_changed_while_it_prints(self):
        self.run_moonraker()
        if "exclude_object" not in self.ask("/printer/objects/list")["objects"]:
            self.skipTest("the configuration has no [exclude_object]")
        parts = ["EXCLUDE_OBJECT_DEFINE NAME=LEFT", "EXCLUDE_OBJECT_DEFINE NAME=RIGHT", "EXCLUDE_OBJECT_START NAME=LEFT"]
        lines = parts + spiral(1000)
        job = self.begin(lines, live=True)
        self.await_lines(100)
        self.type(job, "feed 80", "flow 105", "babystep -0.05", "cancel_part 1", "spindle 50", "cancel_part 7")
        self.await_machine("gcode_move&exclude_object", lambda found: (
            abs(found["gcode_move"]["speed_factor"] - 0.8) < 1e-6 and abs(found["gcode_move"]["extrude_factor"] - 1.05) < 1e-6
            and abs(found["gcode_move"]["homing_origin"][2] + 0.05) < 1e-6
            and found["exclude_object"]["excluded_objects"] == ["RIGHT"]))
        code, out, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertIn("feed 80: taken", reported)
        self.assertIn("spindle 50: Klipper has no spindle", reported)
        self.assertIn("cancel_part 7: part 7 is not in the program, which defines 2", reported)
        self.assertNotIn("not done", out)
        self.assertEqual(self.ran(), lines)

    def test_it_holds_in_a_layer(self):
        self.run_moonraker()
        path = spiral(500)
        job = self.begin([], live=True, text="\n".join(path[:200] + [";LAYER:0"] + path[200:350] + [";LAYER:1"] + path[350:] + [""]).encode())
        self.await_lines(50)
        self.type(job, "pause_at_layer 1")
        self.await_machine("print_stats", lambda found: found["print_stats"]["state"] == "paused")
        time.sleep(1.0)
        held = len(self.ran())
        self.assertGreater(held, 350)
        self.assertLess(held, 450)
        time.sleep(1.0)
        self.type(job, "resume")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), path)

    def test_commands_that_it_does_not_know_are_counted(self):
        self.run_moonraker()
        path = spiral(60)
        code, out, reported = self.print(path[:20] + ["NO_SUCH_MACRO A=1"] + path[20:] + ["M999"])
        self.assertEqual(code, 0, reported)
        self.assertIn("not done: 2 commands", out)
        self.assertIn('Unknown command:"NO_SUCH_MACRO"', out)
        code, out, reported = self.print(path)
        self.assertEqual(code, 0, reported)
        self.assertNotIn("not done", out)

    def test_an_emergency_stop_ends_a_wait_for_heat(self):
        for setting, is_halted in (("never", False), ("unconfirmed", True)):
            with self.subTest(setting):
                self.run_moonraker()
                job = self.begin(spiral(10) + ["M109 S250"] + spiral(10), "stream.safe_stop_timeout_s=5", "stream.emergency_stop=" + setting)
                self.await_lines(10)
                time.sleep(3.0)
                job.send_signal(signal.SIGINT)
                code, _, reported = self.end_of(job)
                self.assertEqual(code, 1)
                self.assertIn("was shut down by an emergency stop" if is_halted else "POST /printer/emergency_stop", reported)
                self.assertEqual(self.machine()["webhooks"]["state"], "shutdown" if is_halted else "ready")

    def test_a_print_goes_on_without_its_streamer_and_is_followed(self):
        self.run_moonraker()
        lines = spiral(1200)
        job = self.begin(lines)
        self.await_lines(150)
        job.kill()
        job.communicate()
        known = json.loads(self.lamina("stream", self.program, "--progress", "--json").stdout)
        self.assertEqual([known["uploaded_as"]], self.files())
        self.assertEqual(known["state"], "Execute")
        self.assertGreater(known["taken_through"], 0)
        self.assertLessEqual(known["taken_through"], len(self.ran()) + 50)  # Klipper counts what it has read
        offer = json.loads(self.lamina("resume", self.program, "--json").stdout)
        self.assertEqual(offer["from_line"], known["taken_through"] + 1)
        followed = self.lamina("stream", self.program, "--resume")
        self.skip_if_stalled(followed.stderr)
        self.assertEqual(followed.returncode, 0, followed.stderr)
        self.assertIn("Complete: %d lines" % len(lines), followed.stdout)
        self.assertEqual(self.ran(), lines)
        self.assertEqual(self.files(), [])
        again = self.lamina("stream", self.program, "--resume")
        self.assertEqual(again.returncode, 1)
        self.assertIn("the machine had read line 1200 of 1200", again.stderr)

    def test_it_follows_what_another_does(self):
        self.run_moonraker()
        lines = spiral(400)
        job = self.begin(lines)
        self.await_lines(150)
        self.ask("/printer/print/pause", "POST")
        time.sleep(3.0)
        self.ask("/printer/print/resume", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), lines)

        job = self.begin(lines)
        self.await_lines(550)
        self.ask("/printer/print/cancel", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("was cancelled at the machine", reported)
        self.assertEqual(self.files(), [])

    def test_an_earlier_print_that_was_cancelled_is_left_alone(self):
        self.run_moonraker()
        job = self.begin(spiral(1200))
        self.await_lines(150)
        job.kill()
        job.communicate()
        self.ask("/printer/print/cancel", "POST")
        self.ask("/printer/gcode/script?script=M104%20S170", "POST")  # for another job
        stored = self.files()
        followed = subprocess.run([LAMINA, "stream", self.program, "--port", self.url, "--resume"], capture_output=True, text=True,
                                  timeout=PATIENCE_S, check=False)
        self.skip_if_stalled(followed.stderr)
        self.assertEqual(followed.returncode, 1)
        self.assertIn("was cancelled at the machine; its heaters and its file were left as they are", followed.stderr)
        self.assertEqual(self.machine()["extruder"]["target"], 170)
        self.assertEqual(self.files(), stored)

    def test_changes_that_wait_for_heat_do_not_lose_the_print(self):
        self.run_moonraker()
        job = self.begin(spiral(10) + ["M109 S250"] + spiral(10), "stream.silence_timeout_s=15", live=True)
        self.await_lines(10)
        time.sleep(2.0)
        self.type(job, "feed 80", "feed 81", "feed 82", "feed 83")
        time.sleep(40.0)
        self.assertIsNone(job.poll(), "it is followed all the time")
        self.ask("/printer/emergency_stop", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("M220 S80: no answer within 10 s", reported)
        self.assertIn("the printer has shut itself down", reported)

    def test_no_part_is_left_out_where_klipper_cannot(self):
        self.run_moonraker()
        if "exclude_object" in self.ask("/printer/objects/list")["objects"]:
            self.skipTest("the configuration has [exclude_object]")
        job = self.begin(spiral(500), live=True)
        self.await_lines(100)
        time.sleep(1.5)  # until it is seen to print
        self.type(job, "cancel_part 0")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertIn("cancel_part 0: this Klipper leaves out no parts: its configuration has no [exclude_object]", reported)

    def test_an_error_ends_the_print_and_nothing_behind_it_is_run(self):
        self.run_moonraker(NOZZLE_C="25")
        lines = ["G90", "M140 S50", "G28", "M83", "G1 X20 E5 F6000", "G1 X30"]
        code, _, reported = self.print(lines)
        self.assertEqual(code, 1)
        self.assertIn("the print has ended with an error: Extrude below minimum temp", reported)
        self.assertIn("line 4 of 6 was the last acknowledged", reported)
        self.assertEqual(reported.count("\n"), 1, reported)
        self.assertEqual(self.ran(), lines[:4])
        self.expect_stopped(reported, lines)

    def test_another_print_is_left_alone(self):
        self.run_moonraker()
        theirs = spiral(1200)
        job = self.begin(theirs)
        self.await_lines(100)
        code, _, reported = self.print(["G91"])
        self.assertEqual(code, 1)
        self.assertIn("another print under way", reported)
        self.ask("/printer/print/pause", "POST")
        code, _, reported = self.print(["G91"])
        self.assertEqual(code, 1)
        self.assertIn("another print under way", reported)
        self.assertEqual(len(self.files()), 1)
        self.ask("/printer/print/resume", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), theirs)

    def test_nothing_is_started_behind_anothers_command(self):
        self.run_moonraker()
        other = threading.Thread(target=self.ask_in_vain, args=("/printer/gcode/script?script=M109%20S250",), daemon=True)
        other.start()
        time.sleep(2.0)
        code, _, reported = self.print(spiral(10))
        self.assertEqual(code, 1)
        self.assertIn("has been busy for 10 s", reported)
        machine = self.machine()
        self.assertEqual(machine["extruder"]["target"], 250)
        self.assertEqual(machine["print_stats"]["state"], "standby")
        self.assertEqual(self.files(), [])
        self.assertEqual(self.ran(), [])

    def test_the_key_is_asked_for(self):
        self.run_moonraker(LOGINS="1")
        code, _, reported = self.print(["G90"])
        self.assertEqual(code, 1)
        self.assertIn("Moonraker asks for an API key", reported)
        with open(self.path("wrong"), "w", encoding="utf-8") as key:
            key.write("0123456789abcdef0123456789abcdef\n")
        code, _, reported = self.print(["G90"], "stream.password_file=" + self.path("wrong"))
        self.assertEqual(code, 1)
        self.assertIn("does not take the key", reported)
        self.assertNotIn("0123456789abcdef", reported)
        self.assertEqual(self.ran(), [])
        code, _, reported = self.print(["G90", "M83"], "stream.password_file=" + self.path("key"))
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), ["G90", "M83"])
        self.assertEqual(self.files(), [])

    def test_a_shutdown_under_way_is_reported_with_its_reason(self):
        self.run_moonraker()
        job = self.begin(spiral(1000))
        self.await_lines(150)
        self.ask("/printer/emergency_stop", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("Shutdown due to", reported)
        self.assertLess(len(self.ran()), 1000)

        before = self.ran()
        code, _, reported = self.print(["G90"])
        self.assertEqual(code, 1)
        self.assertIn("the printer is not ready: Shutdown due to", reported)
        self.assertEqual(self.ran(), before)

    def test_a_shutdown_in_the_last_motion_is_not_complete(self):
        self.run_moonraker()
        job = self.begin(["G90", "G28", "G1 X100 F6000", "G1 X500 F600"])
        self.await_lines(4)
        time.sleep(4.0)
        self.assertEqual(self.machine()["print_stats"]["state"], "complete")
        self.ask("/printer/emergency_stop", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        self.assertIn("Shutdown due to", reported)

    def test_a_stop_in_the_last_motion_waits_for_it(self):
        self.run_moonraker()
        job = self.begin(["G90", "M104 S180", "G28", "G1 X100 F6000", "G1 X500 F3000"])
        self.await_lines(5)
        time.sleep(4.0)
        job.send_signal(signal.SIGINT)
        code, _, reported = self.end_of(job)
        machine = self.machine()
        self.assertEqual(code, 1)
        self.assertIn("its heaters are off", reported)
        self.assertNotIn("still moving", reported)
        self.assertEqual(machine["extruder"]["target"], 0)
        self.assertGreater(machine["toolhead"]["estimated_print_time"], machine["toolhead"]["print_time"])

    def test_a_restart_under_way_ends_the_job(self):
        for way in ("restart", "firmware_restart"):
            with self.subTest(way):
                self.run_moonraker()
                job = self.begin(spiral(1000))
                self.await_lines(150)
                self.ask("/printer/" + way, "POST")
                code, _, reported = self.end_of(job)
                self.assertEqual(code, 1)
                self.assertRegex(reported, "restarted|shut itself down")

    def test_a_server_that_restarts_is_waited_for(self):
        self.run_moonraker()
        lines = spiral(500)
        job = self.begin(lines)
        self.await_lines(150)
        self.ask("/server/restart", "POST")
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 0, reported)
        self.assertEqual(self.ran(), lines)

    def reported_without(self, process):
        """What is reported of a job amid which a process is killed."""
        self.run_moonraker()
        job = self.begin(spiral(1000), "stream.silence_timeout_s=5")
        self.await_lines(150)
        self.kill(process)
        code, _, reported = self.end_of(job)
        self.assertEqual(code, 1)
        return reported

    def test_a_server_that_is_gone_is_reported(self):
        reported = self.reported_without("moonraker")
        self.assertIn("nothing was heard of the machine for", reported)
        self.assertIn("it may still be printing", reported)

    def test_klipper_that_is_gone_is_reported(self):
        self.assertIn("Klippy", self.reported_without("klippy"))


if __name__ == "__main__":
    if not RUNNER:
        print("no real Moonraker is there: LAMINA_MOONRAKER_RUNNER is not set")
        sys.exit(77)
    unittest.main()
