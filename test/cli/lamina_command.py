"""The command `lamina` for the tests beside this file; each is called with its path as first argument."""
import json
import subprocess
import sys

LAMINA = sys.argv.pop(1)


def lamina(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, check=False)


def told(*arguments):
    done = lamina(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
