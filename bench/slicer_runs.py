# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs slicers and reads what they wrote, for the scripts that compare them."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

# What Lamina deposits for printers unless set otherwise, and what figures were measured without.
PLAIN = {"skins.top_layers": 0, "skins.bottom_layers": 0, "bridges.use": "false", "overhangs.use": "false",
         "cooling.least_layer_time_s": 0, "fan.use": "false"}


def built_lamina():
    """The executable of this source tree, or else the one on the path."""
    root = pathlib.Path(__file__).resolve().parent.parent
    built = [root / "devel" / "lib" / "lamina" / "lamina", root / "build" / "bin" / "lamina"]
    return next((str(path) for path in built if path.exists()), "lamina")


def run(command, environment):
    """Wall time [s], processor time [s] and peak memory [MB] of one run of a program, process start included.

    Until a process is another program it counts the memory of the one that started it: `time`, of Debian's package of that name,
    stands in between, as it takes less than any slicer.
    """
    with tempfile.NamedTemporaryFile("r", encoding="utf-8") as peak_kb:
        start = time.perf_counter()
        process = subprocess.Popen(["/usr/bin/time", "--quiet", "--format=%M", f"--output={peak_kb.name}", *command],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, **environment})
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        if os.waitstatus_to_exitcode(status) != 0:
            sys.exit(f"failed: {' '.join(map(str, command))}")
        return wall, usage.ru_utime + usage.ru_stime, int(peak_kb.read()) / 1024


def filament_of(path):
    """Filament extruded by a G-code file [m]."""
    total = position = 0.0
    is_relative = False
    with open(path, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            code = line.split(";")[0].strip()
            if code in ("M82", "M83"):
                is_relative = code == "M83"
            word = re.search(r"E(-?[\d.]+)", code)
            if not word:
                continue
            value = float(word.group(1))
            if code.startswith("G92"):
                position = value
            elif code.startswith(("G0", "G1")):
                total += value if is_relative else value - position
                position = value
    return total / 1000


def infill_runs_per_layer(path):
    """Mean number of runs of infill over the layers that have any: a run starts where extrusion does after a move
    without."""
    runs = layers = position = 0
    is_relative = is_infill = is_extruding = has_infill = False
    with open(path, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if line.startswith((";TYPE:", ";LAYER_CHANGE", ";LAYER:")):
                is_infill = "infill" in line.lower()
                is_extruding = False
                if not line.startswith(";TYPE:"):
                    layers += has_infill
                    has_infill = False
            code = line.split(";")[0].strip()
            if code in ("M82", "M83"):
                is_relative = code == "M83"
            if not code.startswith(("G0", "G1", "G92")):
                continue
            word = re.search(r"E(-?[\d.]+)", code)
            value = float(word.group(1)) if word else None
            extrudes = value is not None and (value if is_relative else value - position) > 0
            if value is not None:
                position = value
            moves = not code.startswith("G92") and ("X" in code or "Y" in code)
            if not moves:
                continue
            if is_infill and extrudes and not is_extruding:
                runs += 1
                has_infill = True
            is_extruding = extrudes
    return runs / max(1, layers + has_infill)
