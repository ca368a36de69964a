#!/usr/bin/env python3
"""The include rule of docs/architecture.md: the core knows no ROS, and its folders use each other along the arrows only.

Usage: include_rule.py [ROOT]   exits 1 and names each offending line if the rule is broken
"""
import pathlib
import re
import sys

# An arrow of docs/architecture.md: a folder may include these folders and whatever those may include.
ARROWS = {
    "base": [],
    "geometry": ["base"],
    "surface": ["geometry"],
    "slicing": ["surface"],
    "toolpath": ["geometry"],
    "orientation": ["toolpath", "surface"],
    "infill": ["geometry", "toolpath"],
    "voids": ["infill"],
    "planning": ["slicing", "infill", "voids", "toolpath"],
    "program": ["toolpath", "kinematics"],
    "transform": ["program"],
    "kinematics": ["toolpath"],
    "trajectory": ["kinematics"],
    "dynamics": ["trajectory"],
    "streaming": ["program"],
    "startup": ["streaming"],
    "deposition": ["toolpath"],
    "sweep": ["toolpath"],
    "scaffold": ["infill"],
    "pores": ["geometry"],
    "stiffness": ["geometry"],
    "statistics": ["base"],
    "metrics": ["dynamics", "surface"],
    "optimisation": ["statistics"],
    "kriging": ["optimisation"],
    "study": ["optimisation", "picture"],
    "overhang": ["toolpath", "surface"],
    "clearance": ["kinematics"],
    "monitoring": ["toolpath"],
    "picture": ["overhang", "pores"],
    "job": ["planning", "orientation", "voids", "program", "transform", "kinematics", "trajectory", "dynamics", "streaming", "startup", "deposition", "sweep", "scaffold", "pores", "stiffness", "statistics", "metrics", "optimisation", "study", "overhang", "clearance", "monitoring", "picture"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROS_HEADER = re.compile(r"^(ros/|tf2|tf2_ros/|actionlib/|rosbag/|nodelet/|pluginlib/|diagnostic_updater/|[a-z0-9_]+_msgs/)")
ROS_WORD = re.compile(r"\bROS_(INFO|WARN|ERROR|DEBUG|FATAL)|\bros::")
OWN_HEADER = re.compile(r"^(?:lamina/)?([a-z_]+)/[a-z0-9_]+\.hpp$")


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
        if own and own.group(1) in ARROWS and own.group(1) not in allowed:
            yield f"{path}:{number}: {folder} may not include {own.group(1)}"


def faults_of_outer_file(path, forbidden):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        include = INCLUDE.match(line)
        if include and forbidden(include.group(1)):
            yield f"{path}:{number}: may not include {include.group(1)}"


def faults(root):
    for top in ("include/lamina", "src/core"):
        for path in sorted((root / top).rglob("*.[ch]pp")):
            folder = path.relative_to(root / top).parts[0]
            if folder not in ARROWS:
                yield f"{path}: no such core folder in the rule: {folder}"
                continue
            yield from faults_of_core_file(path, folder)
    for path in sorted((root / "src/cli").rglob("*.[ch]pp")):
        yield from faults_of_outer_file(path, lambda header: ROS_HEADER.match(header))


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    found = list(faults(root))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
