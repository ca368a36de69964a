#!/usr/bin/env python3
"""Every page of docs/ can be reached from its index, docs/README.md, no page links to a file that is not there, and
the page on the architecture names no path that is not there.

Usage: docs_links.py [ROOT]   exits 1 and names each page out of reach, each page with a link to nothing, and each such path
"""
import pathlib
import re
from urllib.parse import unquote

from budgets import tracked

from rule_script import report

INDEX = "docs/README.md"
ARCHITECTURE = "docs/architecture.md"
BASES = ("", "src/core/", "include/lamina/")  # of paths on that page
QUOTED = re.compile(r"`([\w./-]+)`")
CODE = re.compile(r"^(```|~~~).*?^\1[^\n]*$|`[^`\n]*`", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)")
ELSEWHERE = re.compile(r"^([a-z][a-z0-9+.-]*:|#)", re.IGNORECASE)


def without_code(text):
    """The text without what stands in fences and backticks; line numbers stay."""
    return CODE.sub(lambda code: "\n" * code.group(0).count("\n"), text)


def links(page):
    """Yields (line number, file) of each relative link of a page."""
    for number, line in enumerate(without_code(page.read_text()).splitlines(), 1):
        for target in LINK.findall(line):
            if not ELSEWHERE.match(target):
                yield number, (page.parent / unquote(target.split("#")[0])).resolve()


def reached(index):
    found = set()
    waiting = [index]
    while waiting:
        page = waiting.pop()
        if page in found or page.suffix != ".md" or not page.is_file():
            continue
        found.add(page)
        waiting += [target for _, target in links(page)]
    return found


def is_there(name, files):
    """Whether one of the files is that one, lies in that folder, or has that name before its suffix."""
    return any(file.startswith((base + name + "/", base + name + ".")) or file == base + name for base in BASES for file in files)


def named_paths(text):
    """Yields (line number, folder, path) of each path in backticks, and of each folder that begins a row of the
    first table; a path that ends in "/" lies somewhere below the folder of its row."""
    in_folders = False
    for number, line in enumerate(text.splitlines(), 1):
        in_folders = line.startswith("| Folder ") or in_folders and line.startswith("|")
        cells = line.split("|")
        folders = QUOTED.findall(cells[1]) if in_folders else []
        yield from ((number, "", folder) for folder in folders)
        for path in QUOTED.findall("|".join(cells[2:]) if in_folders else line):
            if "/" in path:
                yield number, folders[0] if path.endswith("/") and folders else "", path.rstrip("/")


def path_faults(root):
    page = root / ARCHITECTURE
    if not page.is_file():
        return
    files = [str(file.relative_to(root)) for file in tracked(root)]
    for number, folder, path in named_paths(page.read_text()):
        below = [file for file in files if file.startswith(tuple(f"{base}{folder}/" for base in BASES)) and f"/{path}/" in file]
        if not (below if folder else is_there(path, files)):
            yield f"{ARCHITECTURE}:{number}: names {folder and folder + '/'}{path}, which is not there"


def faults(root):
    pages = [page.resolve() for page in tracked(root, "*.md") if page.is_file()]
    root = pathlib.Path(root).resolve()
    for page in pages:
        for number, target in links(page):
            if not target.exists():
                yield f"{page.relative_to(root)}:{number}: links to {target}, which is not there"
    known = reached(root / INDEX)
    for page in pages:
        if root / "docs" in page.parents and page not in known:
            yield f"{page.relative_to(root)}: cannot be reached from {INDEX}; expected a link"
    yield from path_faults(root)


if __name__ == "__main__":
    report(faults)
