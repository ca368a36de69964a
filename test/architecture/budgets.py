#!/usr/bin/env python3
"""The size budget of CONTRIBUTING.md: files of at most 600 lines, functions of at most 60, folders of at most 40 files, no names that
say nothing, no unfinished work.

Usage: budgets.py [ROOT]   exits 1 and names each offending place
"""
import collections
import pathlib
import re
import subprocess

from rule_script import report

MAX_FILE_LINES = 600
MAX_FUNCTION_LINES = 60
MAX_FOLDER_FILES = 40
# Folders that hold more, by why; what holds no more has to go.
FULL_FOLDERS = {
    "msg": "genmsg takes the messages of a package from one folder",
}
EMPTY_NAMES = re.compile(r"(^|_)(utils?|helpers?|manager|misc|common)(_|\.|$)")
UNFINISHED = re.compile(r"\b(TODO|FIXME|XXX|HACK)\b")
FUNCTION_START = re.compile(r"^\s*[A-Za-z_].*\)\s*(const)?\s*(noexcept)?\s*(override)?\s*\{\s*$")
NO_FUNCTION = re.compile(r"^\s*(namespace|if|for|while|switch|else|do|try|catch|struct|class|enum|\}|case)\b|^\s*\[|.*=\s*\[")


def tracked(root, *patterns):
    listed = subprocess.run(["git", "-C", root, "ls-files", *patterns], capture_output=True, text=True, check=True)
    return [pathlib.Path(root) / name for name in listed.stdout.split("\n") if name]


def function_lengths(lines):
    """Yields (first line number, length) of each function definition, found by its indentation; one with
    initialisers may be found at the last of these, and ends further left."""
    start = indent = None
    for number, line in enumerate(lines, 1):
        if start is None and FUNCTION_START.match(line) and not NO_FUNCTION.match(line):
            start, indent = number, len(line) - len(line.lstrip())
        elif start is not None and line.strip() == "}" and line.index("}") <= indent:
            yield start, number - start + 1
            start = None


def faults(root):
    for path in tracked(root, "*.hpp", "*.cpp", "*.py", "tools/*"):
        lines = path.read_text().splitlines()
        if len(lines) > MAX_FILE_LINES:
            yield f"{path}: {len(lines)} lines; at most {MAX_FILE_LINES}"
        if EMPTY_NAMES.search(path.name):
            yield f"{path}: the name says nothing"
        for number, line in enumerate(lines, 1):
            if UNFINISHED.search(line) and "budgets" not in path.name:
                yield f"{path}:{number}: unfinished: {line.strip()}"
        if path.suffix in (".hpp", ".cpp"):
            for start, length in function_lengths(lines):
                if length > MAX_FUNCTION_LINES:
                    yield f"{path}:{start}: a function of {length} lines; at most {MAX_FUNCTION_LINES}"


def full_folders(root, exceptions=None):
    """Folders with more files than a name is found among by one look."""
    exceptions = FULL_FOLDERS if exceptions is None else exceptions
    counts = collections.Counter(path.parent.relative_to(root).as_posix() for path in tracked(root))
    full = {folder for folder, count in counts.items() if count > MAX_FOLDER_FILES}
    for folder in sorted(full - set(exceptions)):
        yield f"{folder}: {counts[folder]} files; at most {MAX_FOLDER_FILES}"
    for folder in sorted(set(exceptions) - full):
        yield f"{folder}: {counts[folder]} files; expected more of an exception"


def all_faults(root):
    yield from faults(root)
    yield from full_folders(root)


if __name__ == "__main__":
    report(all_faults)
