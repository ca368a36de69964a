# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program that tests of real firmware stream."""
import math


def spiral(lines):
    """A program of short motions, none like another; on real firmware 50 lines take about a second."""
    text = ["G90", "M83", "G28"]
    for i in range(lines - len(text)):
        text.append("G1 X%.3f Y%.3f F6000" % (100 + 20 * math.cos(0.1 * i), 100 + 20 * math.sin(0.1 * i) + 0.001 * i))
    return text
