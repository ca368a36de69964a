#!/usr/bin/env python3
"""No two sources of a folder give the same name to what stands in their anonymous namespaces: a folder's sources are compiled
together, in batches, and so are those of small folders that one call of lamina_batch_sources names. The tests of a core folder are one folder, however they are nested. Functions of the command may overload
each other: each prints what its own subcommand found.

Usage: anonymous_names.py [ROOT]   exits 1 and names each name with the sources that use it
"""
import collections
import re

from rule_script import report

OPENS = re.compile(r"^namespace \{$")
CLOSES = re.compile(r"^\}  // namespace$")
TYPE = re.compile(r"^(?:struct|class|enum class|enum|union) (\w+)\b(?!.*;$)")
ALIAS = re.compile(r"^using (\w+) =|^namespace (\w+) =")
CONSTANT = re.compile(r"^(?:static |constexpr |const |inline |thread_local )+[^(=]*?\b(\w+)(?:\[\w*\])*\s*(?:=|\{|\()")
BATCHED = re.compile(r"^lamina_batch_sources\(\w+\s+([^)]*)\)", re.MULTILINE)
FUNCTION = re.compile(r"^[A-Za-z_][\w:<>,&*\s\[\]]*?[\s&*](\w+)\(")
WORDS = {"if", "for", "while", "switch", "return", "using", "static_assert", "template"}


def names_of(text, functions="all"):
    """Names that stand in the anonymous namespaces of a source, each once; without its functions if these may overload."""
    found, inside = set(), False
    for line in text.splitlines():
        if OPENS.match(line):
            inside = True
        elif CLOSES.match(line):
            inside = False
        elif inside:
            for pattern in (TYPE, ALIAS, CONSTANT, FUNCTION):
                if pattern is FUNCTION and functions == "overloads":
                    continue
                named = pattern.match(line)
                if named:
                    found.add(next(group for group in named.groups() if group))
                    break
    return found - WORDS


def folders_of(root):
    """Folders with the sources that are compiled together."""
    folders = collections.defaultdict(list)
    for top in ("src/core", "src/cli", "src/nodes", "src/ros_adapters", "src/rviz_panel"):
        for path in sorted((root / top).rglob("*.cpp")):
            folders[path.parent].append(path)
    for path in sorted((root / "test").rglob("*.cpp")):
        domain = path.relative_to(root / "test").parts[0]
        if domain not in ("ros", "rviz_panel", "fuzz", "mpi"):
            folders[root / "test" / domain].append(path)
        elif path.parent.name == "adapters":
            folders[path.parent].append(path)
    return folders


def calls_of(root):
    """Sources of several folders that are compiled together."""
    for lists in sorted((root / "src").rglob("CMakeLists.txt")):
        for call in BATCHED.findall(lists.read_text()):
            sources = [lists.parent / source for source in call.split() if not source.startswith("$")]
            if len({source.parent for source in sources}) > 1:
                yield lists.parent, sources


def faults(root):
    for folder, sources in (*sorted(folders_of(root).items()), *calls_of(root)):
        users = collections.defaultdict(list)
        for path in sources:
            for name in names_of(path.read_text(), "overloads" if folder.name == "cli" else "all"):
                users[name].append(path.relative_to(folder).as_posix())
        for name, files in sorted(users.items()):
            if len(files) > 1:
                yield f"{folder.relative_to(root)}: {name} stands in {' and in '.join(files)}; expected one of the sources compiled together"


if __name__ == "__main__":
    report(faults)
