#!/usr/bin/env python3
"""The member functions of a class of src stand in one source. A class that is too long for one holds more than one idea: what has a
state of its own, or none, becomes a type or a function of its own.

Usage: one_source.py [ROOT]   exits 1 and names each class that is spread
"""
import collections
import re

from rule_script import report

MEMBER = re.compile(r"^(?:[A-Za-z_\[][^\n(){};=]*?[\s&*>])?((?:\w+::)+)(?:~?\w+|operator[^\n\w(]+)\(", re.M)


def is_declared(text, name):
    return re.search(rf"\b(?:class|struct) {name}(?!\w|::)[^;(]*?\{{", text) is not None


def classes_of(text):
    """The classes whose member functions a source defines, but for those that it declares itself."""
    for name in {found.group(1)[:-2] for found in MEMBER.finditer(text)}:
        if not is_declared(text, name) and not is_declared(text, name.split("::")[0]):
            yield name


def faults(root):
    places = collections.defaultdict(list)
    for path in sorted((root / "src").rglob("*.cpp")):
        for name in classes_of(path.read_text()):
            places[name].append(str(path.relative_to(root)))
    for name, paths in sorted(places.items()):
        if len(paths) > 1:
            yield f"member functions of {name} stand in {' and '.join(paths)}; expected one source for a class"


if __name__ == "__main__":
    report(faults)
