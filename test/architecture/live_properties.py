#!/usr/bin/env python3
"""A property is asserted: rc::check states by its result alone whether it holds, so a call whose result is dropped cannot
fail.

Usage: live_properties.py [ROOT]   exits 1 and names each call whose result is dropped
"""
import re

from rule_script import report

CALL = re.compile(r"\brc\s*::\s*check\s*\(")
SILENT = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s"\\]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
# What stands before a statement: another one, a block, a label, the head of a loop or branch, or a cast to void.
STATEMENT_START = re.compile(r"(?:^|[;{})]|\b(?:else|do|default\s*:|case\b[^;{}?]*:))\s*(?:::\s*)?$")


def without_texts(source):
    """The source with each comment as a blank and each literal as one word, on the same lines."""
    def short(found):
        return (" " if found.group().startswith("/") else "text") + "\n" * found.group().count("\n")
    return SILENT.sub(short, source)


def dropped(source):
    """Numbers of the lines on which the result of rc::check is dropped."""
    code = without_texts(source)
    for call in CALL.finditer(code):
        if STATEMENT_START.search(code, 0, call.start()):
            yield code.count("\n", 0, call.start()) + 1


def faults(root):
    for path in sorted((root / "test").rglob("*.[ch]pp")):
        for number in dropped(path.read_text()):
            yield f"{path}:{number}: the result of rc::check is dropped; expected EXPECT_TRUE(rc::check(...))"


if __name__ == "__main__":
    report(faults)
