"""The command `lamina` for the tests beside this file; each is called with its path as first argument."""
import json
import subprocess
import sys

LAMINA = sys.argv.pop(1)

# Without what is deposited by default so that parts come off a printer whole.
PLAIN = [word for setting in ("skins.top_layers=0", "skins.bottom_layers=0", "bridges.use=false", "overhangs.use=false",
                              "cooling.least_layer_time_s=0", "fan.use=false")
         for word in ("--set", setting)]


def lamina(*arguments):
    return subprocess.run([LAMINA, *arguments], capture_output=True, text=True, check=False)


class Motion:
    """A motion of a program: where it ends, what it is of, and the filament that it lays."""

    def __init__(self, start, end, words, state):
        self.start, self.end = start, end
        self.filament = words.get("E", 0.0)
        self.role, self.tool, self.layer, self.part = state["role"], state["tool"], state["layer"], state["part"]

    def lays(self):
        return self.filament > 0.0 and self.start[:2] != self.end[:2]


def motions(program):
    """The motions of a program in order, without tool offsets."""
    state = {"role": "", "tool": 0, "layer": -1, "part": ""}
    at, found = {"X": 0.0, "Y": 0.0, "Z": 0.0}, []
    for line in program.splitlines():
        if line.startswith(";TYPE:"):
            state["role"] = line[6:]
        elif line.startswith(";LAYER:"):
            state["layer"] = int(line[7:])
        elif line.startswith(";PART:"):
            state["part"] = line[6:]
        elif line[:1] == "T" and line[1:].isdigit():
            state["tool"] = int(line[1:])
        elif line[:3] in ("G0 ", "G1 "):
            words = {word[0]: float(word[1:]) for word in line.split()[1:]}
            start = tuple(at.values())
            at.update({axis: words[axis] for axis in at if axis in words})
            found.append(Motion(start, tuple(at.values()), words, state))
    return found


def reported(*arguments):
    done = lamina(*arguments, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
