#!/usr/bin/env python3
"""No two types of the core or of one program have the same name: they share the namespace lamina, and the linker would
keep the constructors of one of them for both.

Usage: one_definition.py [ROOT]   exits 1 and names each type that is defined in several headers
"""
import collections
import re

from rule_script import report

DEFINITION = re.compile(r"^(?:struct|class|enum class) (\w+)\b(?!::)(?:[^;]*$|[^;]*\{)")


def definitions(root):
    """Types that stand in no other type, function or namespace than lamina, with the headers that define them."""
    found = collections.defaultdict(list)
    for top in ("include", "src"):
        for path in sorted((root / top).rglob("*.hpp")):
            for line in path.read_text().splitlines():
                definition = DEFINITION.match(line)
                if definition:
                    found[definition.group(1)].append(str(path.relative_to(root)))
    return found


def faults(root):
    for name, headers in definitions(root).items():
        if len(headers) > 1:
            yield f"{name} is defined in {' and in '.join(headers)}; expected one definition"


if __name__ == "__main__":
    report(faults)
