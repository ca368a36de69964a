#!/usr/bin/env python3
"""The include rule of docs/architecture.md: the core knows no ROS, and its folders use each other along the arrows only.

Usage: include_rule.py [ROOT]   exits 1 and names each offending line if the rule is broken
"""
import re

from rule_script import report

# An arrow of docs/architecture.md: a folder, with the folders within it, may include these folders and whatever those may include.
ARROWS = {
    "base": [],
    "geometry": ["base"],
    "parameterization": ["geometry"],
    "slicing": ["parameterization"],
    "toolpath": ["geometry"],
    "orientation": ["toolpath"],
    "infill": ["toolpath"],
    "voids": ["infill"],
    "planning": ["slicing", "voids"],
    "kinematics": ["toolpath"],
    "program": ["kinematics"],
    "gcode_rewrite": ["program"],
    "trajectory": ["kinematics"],
    "dynamics": ["trajectory"],
    "servo": ["trajectory"],
    "verification/overhang": ["toolpath"],
    "verification/collision": ["kinematics"],
    "streaming/transport": ["base", "streaming/upload"],
    "streaming/upload": ["streaming/job"],
    "streaming/job": ["base", "program"],
    "streaming/journal": ["streaming/job"],
    "streaming/resume": ["streaming/job"],
    "streaming/firmware": ["streaming/job"],
    "streaming/session": ["streaming/transport", "streaming/firmware", "streaming/journal"],
    "streaming/guard": ["streaming/session"],
    "streaming/emulator": ["streaming/transport", "streaming/firmware"],
    "startup": ["streaming/session", "gcode_rewrite"],
    "deposition": ["toolpath"],
    "sweep": ["toolpath"],
    "scaffold": ["infill"],
    "pores": ["geometry"],
    "stiffness": ["geometry"],
    "statistics": ["base"],
    "metrics": ["dynamics"],
    "optimisation": ["statistics"],
    "kriging": ["optimisation"],
    "study": ["optimisation", "picture"],
    "monitoring": ["toolpath"],
    "calibration": ["toolpath"],
    "control": ["toolpath"],
    "control/program": ["control", "gcode_rewrite"],
    "control/run": ["control", "deposition", "calibration"],
    "control/report": ["control/run", "picture"],
    "journal": ["base"],
    "cell": ["journal"],
    "modbus": ["cell"],
    "process_io": ["toolpath"],
    "process_io/devices": ["process_io", "modbus", "streaming/transport"],
    "web": ["cell"],
    "picture": ["verification/overhang", "pores"],
    "job": ["planning", "orientation", "gcode_rewrite", "dynamics", "startup", "streaming/emulator", "deposition", "sweep", "scaffold",
            "stiffness", "metrics", "study", "verification/collision", "monitoring", "control/program",
            "control/report"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROS_HEADER = re.compile(r"^(ros/|tf2|tf2_ros/|actionlib/|rosbag/|nodelet/|pluginlib/|diagnostic_updater/|[a-z0-9_]+_msgs/)")
ROS_WORD = re.compile(r"\bROS_(INFO|WARN|ERROR|DEBUG|FATAL)|\bros::")
OWN_HEADER = re.compile(r"^(?:lamina/)?((?:[a-z_]+/)+)[a-z0-9_]+\.hpp$")


def folder_of(path):
    """The folder of the rule that a path below src/core or include/lamina lies in; nothing if it lies in none."""
    parts = path.split("/")
    names = ("/".join(parts[:length]) for length in range(len(parts), 0, -1))
    return next((name for name in names if name in ARROWS), None)


def reachable(folder):
    found = {folder}
    for neighbour in ARROWS[folder]:
        found |= reachable(neighbour)
    return found


def faults_of_core_file(path, folder):
    allowed = reachable(folder)
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = INCLUDE.match(line)
        header = include.group(1) if include else ""
        if ROS_HEADER.match(header) or header.startswith("lamina/") and header.count("/") == 1:
            yield f"{path}:{number}: the core includes ROS: {header}"
        if ROS_WORD.search(line.split("//")[0]):
            yield f"{path}:{number}: the core uses ROS"
        own = OWN_HEADER.match(header)
        target = folder_of(own.group(1).rstrip("/")) if own else None
        if target and target not in allowed:
            yield f"{path}:{number}: {folder} may not include {target}"


def faults_of_outer_file(path, forbidden):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = INCLUDE.match(line)
        if include and forbidden(include.group(1)):
            yield f"{path}:{number}: may not include {include.group(1)}"


def faults(root):
    for top in ("include/lamina", "src/core"):
        for path in sorted((root / top).rglob("*.[ch]pp")):
            folder = folder_of(path.relative_to(root / top).parent.as_posix())
            if folder is None:
                yield f"{path}: no core folder of the rule holds it"
                continue
            yield from faults_of_core_file(path, folder)
    for path in sorted((root / "src/cli").rglob("*.[ch]pp")):
        yield from faults_of_outer_file(path, lambda header: ROS_HEADER.match(header))


if __name__ == "__main__":
    report(faults)
