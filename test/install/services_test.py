#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""The shipped services: what systemd says of them, and what they need is there.

    services_test.py SOURCE LAMINA

Exit code 77 where systemd-analyze or ROS in /usr is missing.
"""
import grp
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE, LAMINA = (os.path.abspath(path) for path in sys.argv[1:3])
UNITS = ("lamina-master.service", "lamina@.service")
PATIENCE_S = 60


def lines_of(unit, key):
    """The values of a key of a unit, in order."""
    with open(os.path.join(SOURCE, "deploy", unit), encoding="utf-8") as text:
        found = [line.strip().split("=", 1) for line in text if line.startswith(key + "=")]
    return [value for _, value in found]


def environment_of(unit):
    words = [word for value in lines_of(unit, "Environment") for word in shlex.split(value)]
    return dict(word.split("=", 1) for word in words)


class Services(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.chmod(self.folder, 0o777)

    def complaints(self, change=lambda text: text):
        """What systemd has to say of the master and of a launch file's service."""
        for unit, name in zip(UNITS, ("lamina-master.service", "lamina@gcode_streamer.service")):
            with open(os.path.join(SOURCE, "deploy", unit), encoding="utf-8") as text:
                with open(os.path.join(self.folder, name), "w", encoding="utf-8") as copy:
                    copy.write(change(text.read()))
        names = [os.path.join(self.folder, name) for name in ("lamina-master.service", "lamina@gcode_streamer.service")]
        verified = subprocess.run(["systemd-analyze", "verify", "--man=no", *names], capture_output=True, text=True, check=False)
        reported = [line for line in verified.stderr.splitlines() if "lamina" in line]
        return reported + ["exit code %d" % verified.returncode] * (verified.returncode != 0)

    def test_systemd_reads_them(self):
        self.assertEqual(self.complaints(), [])
        self.assertNotEqual(self.complaints(lambda text: text.replace("NoNewPrivileges=", "NoNewPrivilegs=")), [])
        self.assertNotEqual(self.complaints(lambda text: text.replace("ExecStart=/usr/bin/", "ExecStart=/usr/bin/no_such_")
                                            .replace("ExecStart=/bin/", "ExecStart=/bin/no_such_")), [])

    def test_what_they_start_is_there(self):
        for unit in UNITS:
            (start,) = lines_of(unit, "ExecStart")
            self.assertTrue(os.access(shlex.split(start)[0], os.X_OK), start)
        self.assertTrue(os.access("/usr/bin/roslaunch", os.X_OK))
        (groups,) = lines_of("lamina@.service", "SupplementaryGroups")
        self.assertTrue(grp.getgrnam(groups))
        with open(os.path.join(SOURCE, "docs", "cell", "security.md"), encoding="utf-8") as page:
            guide = page.read()
        self.assertTrue(os.path.exists(os.path.join(SOURCE, "launch", "gcode_streamer.launch")))
        self.assertIn("systemctl enable --now lamina@gcode_streamer", guide)
        for unit in UNITS:
            (user,) = lines_of(unit, "User")
            self.assertIn("adduser --system --group " + user, guide)
            self.assertEqual(lines_of(unit, "NoNewPrivileges"), ["yes"])
            self.assertEqual(lines_of(unit, "AmbientCapabilities") + lines_of(unit, "RestrictRealtime"), [])

    def test_progress_is_kept_where_the_service_may_write(self):
        unit = "lamina@.service"
        (state,) = lines_of(unit, "StateDirectory")
        program = os.path.join(self.folder, "part.gcode")
        with open(program, "w", encoding="utf-8") as text:
            text.write("G28\n")
        reported = subprocess.run([LAMINA, "stream", program, "--port", "/dev/ttyUSB7", "--progress"], capture_output=True, text=True,
                              env={**os.environ, "HOME": "/nonexistent", **environment_of(unit)}, check=False).stderr
        self.assertIn("/var/lib/%s/lamina/" % state, reported)

    def test_the_streamer_gets_its_priority_without_rights(self):
        (priority,) = lines_of("lamina@.service", "LimitRTPRIO")
        if os.geteuid() != 0 or subprocess.run(["prlimit", "--rtprio=" + priority, "true"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
            self.skipTest("only a root that may raise limits can become such a user")
        self.assertEqual(self.policies(rtprio=priority), {"SCHED_RR"})
        self.assertEqual(self.policies(rtprio="0"), set())

    def policies(self, rtprio):
        """How the threads of a streamer are scheduled that has these limits and no rights, if otherwise than usual."""
        folder = tempfile.mkdtemp(dir=self.folder)
        os.chmod(folder, 0o777)
        port, program, journal = (os.path.join(folder, name) for name in ("port", "part.gcode", "progress"))
        with open(program, "w", encoding="utf-8") as text:
            text.write("G28\nG4 S20\n")
        machine = subprocess.Popen([LAMINA, "emulate", "--pty", port], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(lambda: (machine.kill(), machine.wait()))
        for _ in range(PATIENCE_S * 10):
            if os.path.exists(port):
                break
            time.sleep(0.1)
        os.chmod(os.path.realpath(port), 0o666)
        streaming = subprocess.Popen(["prlimit", "--rtprio=" + rtprio, "setpriv", "--reuid=65534", "--regid=65534", "--clear-groups",
                                      "--no-new-privs", "--inh-caps=-all", "--bounding-set=-all", LAMINA, "stream", program, "--port", port,
                                      "--set", "stream.journal=" + journal], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(lambda: (streaming.kill(), streaming.wait()))
        for _ in range(PATIENCE_S * 10):
            if os.path.exists(journal) or streaming.poll() is not None:
                break
            time.sleep(0.1)
        self.assertIsNone(streaming.poll(), "the streamer has ended")
        threads = os.listdir("/proc/%d/task" % streaming.pid)
        names = {os.SCHED_OTHER: "SCHED_OTHER", os.SCHED_RR: "SCHED_RR", os.SCHED_FIFO: "SCHED_FIFO"}
        return {names[os.sched_getscheduler(int(thread))] for thread in threads} - {"SCHED_OTHER"}


if __name__ == "__main__":
    if shutil.which("systemd-analyze") is None or not os.access("/usr/bin/roscore", os.X_OK):
        print("systemd-analyze, or ROS in /usr, is not there")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
