#!/usr/bin/env python3
"""Each suite of lamina_rostests, which holds those of all rostests, is run by a .test file: no other would miss it.

Usage: suites_of_rostests.py [ROOT]   exits 1 and names each suite that no file runs
"""
import re

from rule_script import report

SOURCES = re.compile(r"\b(?:lamina_batch|target)_sources\(lamina_rostests\s([^)]*)\)")
SUITE = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+)", re.MULTILINE)
RUN = re.compile(r'type="lamina_rostests"\s+args="([^"]*)"')


def faults(root):
    folder = root / "test" / "ros"
    run = {suite for path in folder.rglob("*.test") for suites in RUN.findall(path.read_text()) for suite in suites.split()}
    for sources in SOURCES.findall((folder / "CMakeLists.txt").read_text()):
        for name in (word for word in sources.split() if word.endswith("_test.cpp")):
            for suite in sorted(set(SUITE.findall((folder / name).read_text())) - run):
                yield f"test/ros/{name}: suite {suite}; expected it among the args of a .test file"


if __name__ == "__main__":
    report(faults)
