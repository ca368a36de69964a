#!/usr/bin/env python3
"""A test writes its files into a folder of its own, test/support/scratch_folder.hpp: in the system's folder for such, names meet those
of another run, or of another test.

Usage: scratch_files.py [ROOT]   exits 1 and names each line that asks for the system's folder
"""
import re

from rule_script import report

SYSTEM_FOLDER = re.compile(r"\bTempDir\s*\(|\btemp_directory_path\s*\(|\btmpnam\s*\(|\btempnam\s*\(")
SCRATCH_FOLDER = "test/support/scratch_folder.hpp"


def faults(root):
    for path in sorted((root / "test").rglob("*.[ch]pp")):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if name != SCRATCH_FOLDER and SYSTEM_FOLDER.search(line):
                yield f"{name}:{number}: {line.strip()}; expected a file of test::ScratchFolder"


if __name__ == "__main__":
    report(faults)
