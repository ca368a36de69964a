#!/usr/bin/env python3
"""No two sources of a folder give the same name to what stands in their anonymous namespaces: a folder's sources are compiled
together, in batches. Sources under src/nodes, src/cli and src/core count; so does what a private header declares.

Usage: anonymous_names.py [ROOT]   exits 1 and names each name with the sources that use it
"""
import collections
import pathlib
import re
import sys

OPENS = re.compile(r"^namespace \{$")
CLOSES = re.compile(r"^\}  // namespace$")
TYPE = re.compile(r"^(?:struct|class|enum class|enum|union) (\w+)\b(?!.*;$)")
ALIAS = re.compile(r"^using (\w+) =|^namespace (\w+) =")
CONSTANT = re.compile(r"^(?:static |constexpr |const |inline |thread_local )+[^(=]*?\b(\w+)(?:\[\w*\])*\s*(?:=|\{|\()")
FUNCTION = re.compile(r"^[A-Za-z_][\w:<>,&*\s\[\]]*?[\s&*](\w+)\(")
WORDS = {"if", "for", "while", "switch", "return", "using", "static_assert", "template"}


def names_of(text):
    """Names that stand in the anonymous namespaces of a source, each once."""
    found, inside = set(), False
    for line in text.splitlines():
        if OPENS.match(line):
            inside = True
        elif CLOSES.match(line):
            inside = False
        elif inside:
            for pattern in (TYPE, ALIAS, CONSTANT, FUNCTION):
                named = pattern.match(line)
                if named:
                    found.add(next(group for group in named.groups() if group))
                    break
    return found - WORDS


def faults(root):
    for top in ("src/core", "src/cli", "src/nodes", "src/ros_adapters", "src/rviz_panel"):
        folders = collections.defaultdict(list)
        for path in sorted((root / top).rglob("*.cpp")):
            folders[path.parent].append(path)
        for folder, sources in sorted(folders.items()):
            users = collections.defaultdict(list)
            for path in sources:
                for name in names_of(path.read_text()):
                    users[name].append(path.name)
            for name, files in sorted(users.items()):
                if len(files) > 1:
                    yield f"{folder.relative_to(root)}: {name} stands in {' and in '.join(files)}; expected one source of the folder"


def main():
    found = list(faults(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
