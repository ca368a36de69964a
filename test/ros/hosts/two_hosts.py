"""Two hosts on one cable, in network namespaces that are gone when the process ends, with a ROS master on one of them.

A test that imports this is started anew in the first namespace; it is listed as not run where that takes a privilege that is
not there.
"""
import os
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import time
import unittest
import xmlrpc.client

NOT_RUN = 77
HOST, OTHER = "198.51.100.1", "198.51.100.2"
MASTER_PORT = 11311
PATIENCE = 120.0  # s: far above what a start takes, for loaded machines
KNOCK_S = 2.0  # what is not answered by then is dropped


def enter_namespace():
    if os.environ.get("LAMINA_IN_NAMESPACE"):
        return
    if subprocess.run(["unshare", "--net", "true"], capture_output=True, check=False).returncode != 0:
        print("not run: a network namespace takes root")
        sys.exit(NOT_RUN)
    os.environ["LAMINA_IN_NAMESPACE"] = "1"
    os.execvp("unshare", ["unshare", "--net", sys.executable, "-B", *sys.argv])


def ip(*arguments):
    subprocess.run(["ip", *arguments], check=True)


def listening(pid):
    """Ports of a process that waits for connections: {port: address}."""
    reported = subprocess.run(["ss", "-ltnpH"], capture_output=True, text=True, check=True).stdout
    lines = [line.split() for line in reported.splitlines() if f"pid={pid}," in line]
    return {int(at.rsplit(":", 1)[1]): at.rsplit(":", 1)[0] for at in (columns[3] for columns in lines)}


class TwoHosts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.other = subprocess.Popen(["unshare", "--net", "sleep", "infinity"])
        cls.addClassCleanup(cls.other.wait)
        cls.addClassCleanup(cls.other.kill)
        own = os.stat("/proc/self/ns/net").st_ino
        while os.stat(f"/proc/{cls.other.pid}/ns/net").st_ino == own:
            time.sleep(0.01)
        ip("link", "set", "lo", "up")
        ip("link", "add", "cable", "type", "veth", "peer", "name", "far_end")
        ip("link", "set", "far_end", "netns", str(cls.other.pid))
        ip("address", "add", HOST + "/24", "dev", "cable")
        ip("link", "set", "cable", "up")
        cls.on_other("ip", "link", "set", "lo", "up")
        cls.on_other("ip", "address", "add", OTHER + "/24", "dev", "far_end")
        cls.on_other("ip", "link", "set", "far_end", "up")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    @classmethod
    def on_other(cls, *command):
        return subprocess.run(["nsenter", f"--net=/proc/{cls.other.pid}/ns/net", *command], check=False)

    def is_reached(self, port):
        """Whether the other host gets a connection."""
        knock = f"import socket; socket.create_connection(({HOST!r}, {port}), {KNOCK_S}).close()"
        done = self.on_other("bash", "-c", f'exec {sys.executable} -c "{knock}" 2>/dev/null')
        return done.returncode == 0

    def is_reached_from_here(self, port):
        with socket.create_connection(("127.0.0.1", port), PATIENCE):
            return True

    def start(self, *command, **environment):
        """A process with these variables, and none other that says where ROS is reached."""
        inherited = {name: value for name, value in os.environ.items() if name not in ("ROS_IP", "ROS_HOSTNAME", "ROS_MASTER_URI")}
        with open(self.folder / "output", "a", encoding="utf-8") as log:
            process = subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, env={
                **inherited, "ROS_HOME": str(self.folder), "PYENV_VERSION": "system", "PYTHONUNBUFFERED": "1", **environment})
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def log(self):
        return (self.folder / "output").read_text(encoding="utf-8")

    def start_master(self, **environment):
        master = self.start("/usr/bin/python3", "/usr/bin/rosmaster", "--core", "-p", str(MASTER_PORT), **environment)
        asked = xmlrpc.client.ServerProxy(f"http://127.0.0.1:{MASTER_PORT}")
        self.await_that(lambda: self.answers(asked), "the master does not answer")
        return master

    @staticmethod
    def answers(master):
        try:
            return master.getPid("/test")[0] == 1
        except ConnectionError:
            return False

    def start_node(self, path, **environment):
        """A node that has joined; its ports are open and guarded."""
        node = self.start(path, **environment)
        self.await_that(lambda: len(listening(node.pid)) == 2 and self.is_in_master(node), "the node does not come up")
        return node

    @staticmethod
    def is_in_master(node):
        offered = xmlrpc.client.ServerProxy(f"http://127.0.0.1:{MASTER_PORT}").getSystemState("/test")[2][2]
        name = "/" + re.sub(r".*/", "", node.args[0])
        return any(name in nodes for service, nodes in offered if not service.endswith(("get_loggers", "set_logger_level")))

    def await_that(self, condition, otherwise):
        until = time.monotonic() + PATIENCE
        while not condition():
            self.assertLess(time.monotonic(), until, otherwise + "\n" + self.log())
            time.sleep(0.05)
