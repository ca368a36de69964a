#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""The rotation of a program as [Garcia2024, figures 4.11 to 4.16] lists it: line by line, with NumPy vectors and regular expressions.

    incline_listing.py IN.gcode OUT.gcode LAYER_HEIGHT [ANGLE_DEG]

Written afresh from the description as a yardstick for `lamina incline`; see bench/measure_incline. About X only.
"""
import re
import sys

import numpy as np

MARKS = (";LAYER:0", "; layer 0", "; layer 1")
NUMBER = r"([+-]?(?:\d+\.?\d*|\.\d+))"
COORDINATE = {letter: re.compile(letter + NUMBER) for letter in "XYZ"}
BEFORE = {letter: re.compile(r"(.*)\s" + letter + NUMBER) for letter in "XYZ"}
AFTER = {letter: re.compile(r".*" + letter + NUMBER + r"\s*(.*)") for letter in "XYZ"}


def read_lines(path):
    with open(path, encoding="utf-8") as file:
        lines = [line.strip() for line in file.readlines()]
    return [";Anulada: " + line if line.startswith("G28 ") else line for line in lines if line]


def is_motion(line):
    return line.startswith("G1") or line.startswith("G0")


def points_of(lines):
    in_part = False
    previous = {"X": 0.0, "Y": 0.0, "Z": 0.0}
    points = []
    for line in lines:
        if line.startswith(MARKS):
            in_part = True
        if not in_part or not is_motion(line):
            continue
        for letter, pattern in COORDINATE.items():
            if letter in line:
                found = pattern.search(line)
                if found:
                    previous[letter] = float(found.group(1))
        points.append((previous["X"], previous["Y"], previous["Z"]))
    return points


def rotated(points, angle_deg, layer_height):
    angle = -angle_deg * np.pi / 180.0
    cosine, sine = np.cos(angle), np.sin(angle)
    rows = np.array([[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]])
    result = []
    lowest = 999999.0
    for x, y, z in points:
        point = rows[0] * x + rows[1] * y + rows[2] * z
        lowest = min(lowest, point[2])
        result.append(point)
    for point in result:
        point[2] = point[2] - lowest + layer_height
    return result


def beside_first(letters, line, patterns, group):
    """What stands beside the first of the letters that the line holds."""
    for letter in letters:
        if letter in line:
            found = patterns[letter].match(line)
            return found.group(group) if found else ""
    return ""


def rewritten(line, point):
    before = beside_first("XYZ", line, BEFORE, 1)
    if not before:
        return line
    after = beside_first("ZYX", line, AFTER, 2)
    return f"{before} X{point[0]:.2f} Y{point[1]:.2f} Z{point[2]:.2f} {after}"


def main():
    source, target, layer_height = sys.argv[1], sys.argv[2], float(sys.argv[3])
    lines = read_lines(source)
    points = rotated(points_of(lines), float(sys.argv[4]) if len(sys.argv) > 4 else 45.0, layer_height)
    in_part = False
    index = 0
    with open(target, "w", encoding="utf-8") as file:
        for line in lines:
            if line.startswith(MARKS):
                in_part = True
            if in_part and is_motion(line):
                line = rewritten(line, points[index])
                index += 1
            file.write(line + "\n")


if __name__ == "__main__":
    main()
