#!/usr/bin/env python3
"""Every citation, as [Deb2002] or [Deb2002, section 3], has an entry in docs/references.md.

Usage: references.py [ROOT]   exits 1 and names each citation without an entry, and each key with several
"""
import collections
import re

from budgets import tracked

from rule_script import report

LIST = "docs/references.md"
ENTRY = re.compile(r"^- \*\*\[(\w+)\]\*\*", re.MULTILINE)
CITATION = re.compile(r"\[([A-Z][A-Za-z]+(?:19|20)\d\d[a-z]?)(?=[],])")
OWN_FOLDER = "test/architecture"


def faults(root):
    files = [path for path in tracked(root) if path.is_file() and OWN_FOLDER not in path.as_posix()]
    entries = collections.Counter(key for path in tracked(root, LIST) for key in ENTRY.findall(path.read_text()))
    for key, count in entries.items():
        if count > 1:
            yield f"{LIST}: {count} entries of [{key}]; expected one"
    for path in files:
        for number, line in enumerate(path.read_text(errors="ignore").splitlines(), 1):
            for key in CITATION.findall(line):
                if key not in entries:
                    yield f"{path}:{number}: cites [{key}], which has no entry in {LIST}"


if __name__ == "__main__":
    report(faults)
