#!/usr/bin/env python3
"""Every page of docs/ can be reached from its index, docs/README.md, and no page links to a file that is not there.

Usage: docs_links.py [ROOT]   exits 1 and names each page out of reach and each page with a link to nothing
"""
import pathlib
import re
from urllib.parse import unquote

from budgets import tracked

from rule_script import report

INDEX = "docs/README.md"
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


if __name__ == "__main__":
    report(faults)
