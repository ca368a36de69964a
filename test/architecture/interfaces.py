#!/usr/bin/env python3
"""What others see is used: options of the command by a test or tool, launch files and their arguments too, topics, services and
actions by a node and by a test, fields of messages by a source that fills them and by one that reads them.

Usage: interfaces.py [ROOT]   exits 1 and names what nothing outside its definition uses
"""
import pathlib
import re
import sys

OPTION = re.compile(r'add_(?:option|flag)\w*\(\s*"([^"]+)"')
TOPIC = re.compile(r"inline constexpr char (k\w+)\[\]")
FIELD = re.compile(r"^\s*[\w/]+(?:\[\w*\])?\s+(\w+)\s*(?:#.*)?$", re.MULTILINE)
ARGUMENT = re.compile(r'<arg\s+name="(\w+)"\s+default=')
USERS = ("test", "tools", "bench")
TEXTS = {".cpp", ".hpp", ".py", ".sh", ".test", ".launch", ".yaml", ".md", ""}


def texts(root, *folders):
    """Paths and texts of the sources in folders of the project; the checks themselves use nothing."""
    found = {}
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.is_file() and path.suffix in TEXTS and "architecture" not in path.parts:
                found[path.relative_to(root)] = path.read_text(errors="replace")
    return found


def stands(word, sources):
    return any(word in text for text in sources.values())


def option_faults(root):
    users = texts(root, *USERS)
    for path, text in texts(root, "src/cli").items():
        for names in OPTION.findall(text):
            options = [name for name in names.split(",") if name.startswith("-")]
            for option in options:
                if option.startswith("--") and not any(
                        re.search(re.escape(option) + r"(?![\w-])", user) for user in users.values()):
                    yield f"{path}: option {option} stands in no test, tool or benchmark"


def launch_faults(root):
    users = {**texts(root, *USERS), **texts(root, "launch")}
    for path, text in texts(root, "launch").items():
        others = {other: words for other, words in users.items() if other != path}
        if not stands(path.name, others):
            yield f"{path}: nothing starts it"
        for name in ARGUMENT.findall(text):
            if f"$(arg {name})" not in text and not re.search(rf"\beval\b[^\"]*\b{name}\b", text):
                yield f"{path}: argument {name} is passed to nothing"


def topic_faults(root):
    header = root / "src/ros_adapters/names.hpp"
    sources = {path: text for path, text in texts(root, "src").items() if path.name != "names.hpp"}
    tests = texts(root, "test")
    for name, value in re.findall(r'inline constexpr char (k\w+)\[\]\s*=\s*"([^"]+)"', header.read_text()) if header.exists() else []:
        if not re.search(rf"\b{name}\b", "\n".join(sources.values())):
            yield f"src/ros_adapters/names.hpp: {name} is used by no node"
        if not any(re.search(rf'\b{name}\b|["/ ]{value}\b', text) for text in tests.values()):
            yield f"src/ros_adapters/names.hpp: {name} stands in no test"


def messages(root):
    for kind in ("msg", "srv", "action"):
        for path in sorted((root / kind).glob("*." + kind)):
            lines = [line for line in path.read_text().splitlines() if "=" not in line.split("#")[0]]
            yield path, sorted(set(FIELD.findall("\n".join(lines))))


def field_faults(root):
    sources = "\n".join(texts(root, "src").values())
    tests = "\n".join(texts(root, "test").values())
    for path, fields in messages(root):
        for name in fields:
            use = rf"(?:\.|->){name}\b"
            if not re.search(use, sources):
                yield f"{path.relative_to(root)}: field {name} is neither filled nor read in src"
            elif len(re.findall(use, sources)) + len(re.findall(use, tests)) < 2:
                yield f"{path.relative_to(root)}: field {name} is filled or read, but not both"


def faults(root):
    for found in (option_faults, launch_faults, topic_faults, field_faults):
        yield from found(root)


def main():
    found = list(faults(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
