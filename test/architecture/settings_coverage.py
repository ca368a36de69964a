#!/usr/bin/env python3
"""Every type of settings stands in a list whose test shows that each setting changes something, itself or as part of one that does.

Usage: settings_coverage.py [ROOT]   exits 1 and names each type that no list covers
"""
import collections
import re

from rule_script import report

# The lists, and how a type stands in them: the core's, those of nodes, and parts, each of whose parameters parts_test.cpp changes.
LISTS = {
    "test/job/settings/covered_schemas.cpp": re.compile(r"\bkeysOfAll<([^>.]+)>"),
    "test/ros/settings/node_settings_coverage_test.cpp": re.compile(r"\bkeysOf<(\w+)>"),
    "src/core/geometry/parts/parts.cpp": re.compile(r"\bpart<(\w+)>\("),
}
# What is described without being a choice of anybody's, by why.
FILE = "the form of a file that Lamina writes itself, which its test reads back"
FORM = "fields of a panel, which its test finds in what is asked for"
EXCEPTIONS = {"StatedCalibration": FILE, "StatedMemory": FILE, "InclineForm": FORM, "PrintForm": FORM}

DESCRIBED = re.compile(r"^void (describe\w*)\(SettingsSchema& (\w+), (\w+)& (\w+)[^)]*\) \{$(.*?)^\}$", re.MULTILINE | re.DOTALL)
PARTS = re.compile(r"\bdescribe\(\w+, (\w+)\.([\w.]+)")
TYPE = re.compile(r"^(?:struct|class) (\w+)(?: final)?(?: : [^{]*)? \{$(.*?)^\};$", re.MULTILINE | re.DOTALL)
MEMBER = re.compile(r"^  (?:std::\w+<)?([A-Z]\w+)>? (\w+)\b", re.MULTILINE)


class Described:
    """A type with settings: those of its own, and the members whose settings it takes over."""

    def __init__(self):
        self.is_described = self.has_own = False
        self.parts = set()

    def add(self, function, schema, value, body):
        self.is_described |= function == "describe"
        self.has_own |= f"{schema}." in body
        self.parts |= {path for of, path in PARTS.findall(body) if of == value}


def described(sources):
    found = collections.defaultdict(Described)
    for text in sources:
        for function, schema, name, value, body in DESCRIBED.findall(text):
            found[name].add(function, schema, value, body)
    return {name: one for name, one in found.items() if one.is_described}


def members_of(sources):
    """Of each type, the type of each member."""
    return {name: {member: of for of, member in MEMBER.findall(body)} for text in sources for name, body in TYPE.findall(text)}


def parts_of(name, types, members):
    """Types of the members whose settings a type takes over."""
    for path in types[name].parts if name in types else ():
        of = name
        for member in path.split("."):
            of = members.get(of, {}).get(member)
        yield of


def covered(listed, types, members):
    found, waiting = set(), list(listed)
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += parts_of(name, types, members)
    # A type without settings of its own is as covered as its parts are.
    return found | {name for name, one in types.items() if not one.has_own and found.issuperset(parts_of(name, types, members))}


def listed_in(root):
    for name, standing in LISTS.items():
        path = root / name
        for names in standing.findall(path.read_text()) if path.is_file() else ():
            yield from (one.strip() for one in names.split(","))


def faults(root, exceptions=None):
    exceptions = EXCEPTIONS if exceptions is None else exceptions
    sources = [path.read_text() for top in ("include", "src") for path in sorted((root / top).rglob("*.[ch]pp"))]
    types = described(sources)
    missing = set(types) - covered(listed_in(root), types, members_of(sources))
    for name in sorted(missing - set(exceptions)):
        yield f"{name} has settings that no test shows to change anything; expected it in one of {', '.join(LISTS)}"
    for name in sorted(set(exceptions) - missing):
        yield f"{name} is an exception without need"


if __name__ == "__main__":
    report(faults)
