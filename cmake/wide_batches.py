# SPDX-FileCopyrightText: 2026 The Lamina authors
# SPDX-License-Identifier: BSD-3-Clause
"""Prints the batch of each source: as many as are allowed in one, of any folders of a target. No name in the anonymous
namespaces of a folder is a word in another's.

Usage: wide_batches.py N LIST   LIST holds a line "target path" for each source; prints "target batch path"
"""
import collections
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "test" / "architecture"))
sys.dont_write_bytecode = True
from anonymous_names import names_of  # noqa: E402


WORD = re.compile(r"(?<![.\w>])[A-Za-z_]\w*")  # not what is a member of something
INCLUDE = re.compile(r'^#include [<"]([^<">]+)[">]', re.MULTILINE)
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|"(?:\\.|[^"\\\n])*"')


def folder_of(path):
    """The folder within which names differ: of tests, however nested, that of their domain."""
    parts = pathlib.Path(path).relative_to(ROOT).parts
    return parts[:2] if parts[0] == "test" else parts[:-1]


class Batch:
    """Sources, and of those of each folder the names in their anonymous namespaces and all words they use."""

    def __init__(self):
        self.paths = []
        self.names = collections.defaultdict(set)
        self.words = collections.defaultdict(set)

    def takes(self, folder, names, words):
        """Whether no name of one folder is a word of another, which it would hide or meet. Names differ within a folder."""
        others = [other for other in self.names if other != folder]
        return not any(self.names[other] & words or self.words[other] & names for other in others)

    def add(self, folder, path, names, words):
        self.paths.append(path)
        self.names[folder] |= names
        self.words[folder] |= words


@functools.lru_cache(maxsize=None)
def words_of(path):
    """Words of a file and of those of our own headers that it includes."""
    text = path.read_text()
    words = frozenset(WORD.findall(COMMENT_OR_TEXT.sub("", text)))
    return words.union(*(words_of(header) for header in headers_of(path, text)))


def headers_of(path, text):
    for include in INCLUDE.findall(text):
        for folder in (path.parent, ROOT / "include", ROOT / "src" / "core", ROOT / "test"):
            if (folder / include).is_file():
                yield (folder / include).resolve()
                break


def batches_of(sources, most):
    """Batches as full as names allow, of sources by folder, each in the order of the sources."""
    batches = []
    for folder, path in sources:
        names, words = names_of(pathlib.Path(path).read_text()), words_of(pathlib.Path(path))
        fitting = next((batch for batch in batches if len(batch.paths) < most and batch.takes(folder, names, words)), None)
        if fitting is None:
            fitting = Batch()
            batches.append(fitting)
        fitting.add(folder, path, names, words)
    return [batch.paths for batch in batches]


def main():
    most = int(sys.argv[1])
    targets = collections.defaultdict(list)
    for line in pathlib.Path(sys.argv[2]).read_text().splitlines():
        target, path = line.split(" ", 1)
        targets[target].append((folder_of(path), path))
    for target, sources in targets.items():
        for number, batch in enumerate(batches_of(sources, most)):
            for path in batch:
                print(target, f"wide_{number}", path)


if __name__ == "__main__":
    main()
