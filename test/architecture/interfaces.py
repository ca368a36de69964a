#!/usr/bin/env python3
"""What others see is used: options of the command by a test or tool, launch files and their arguments too, topics, services and
actions by a node and by a test. Fields of messages stand in a source, and once more in a source or test. Launch files keep nodes of
other packages on the loopback interface, and pass texts on as texts.

Usage: interfaces.py [ROOT]   exits 1 and names what nothing outside its definition uses
"""
import collections
import re

from rule_script import report

# What is not used yet, by why; nothing may be added, and what is used has to go.
PANEL = "starts RViz, which has no display in tests"
GAPS = {
    "incline.launch": PANEL, "layers.launch": PANEL,
}

OPTION = re.compile(r'add_(?:option|flag)\w*\(\s*"([^"]+)"')
TOPIC = re.compile(r'inline constexpr char (k\w+)\[\]\s*=\s*"([^"]+)"')
FIELD = re.compile(r"^\s*[\w/]+(?:\[\w*\])?\s+(\w+)\s*(?:#.*)?$", re.MULTILINE)
ARGUMENT = re.compile(r'<arg\s+name="(\w+)"\s+default=')
NODE_OR_PARAMETER = re.compile(r'<node\b[^>]*?\btype="(\w+)"|(</node>)|<param\b([^>]*\bvalue="\$\(arg [^>]*)>')
NAME = re.compile(r'\bname="([\w/]+)"')
NO_TEXT = re.compile(r"-?\d+(?:\.\d*)?(?:e-?\d+)?|true|false")
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


def found_in(pattern, sources):
    """How often each match of a pattern's group stands in the sources: found in one walk, where one per name would take long."""
    return collections.Counter(match for text in sources.values() for match in re.findall(pattern, text))


def option_faults(root):
    used = found_in(r"--[\w-]+", texts(root, *USERS))
    for path, text in texts(root, "src/cli").items():
        for option in sorted({name for names in OPTION.findall(text) for name in names.split(",") if name.startswith("--")}):
            if option not in used:
                yield option, f"{path}: option {option} stands in no test, tool or benchmark"


def launch_faults(root):
    users = {**texts(root, *USERS), **texts(root, "launch")}
    for path, text in texts(root, "launch").items():
        others = {other: words for other, words in users.items() if other != path}
        if not stands(path.name, others):
            yield path.name, f"{path}: nothing starts it"
        for name in ARGUMENT.findall(text):
            if f"$(arg {name})" not in text and not re.search(rf"\beval\b[^\"]*\b{name}\b", text):
                yield name, f"{path}: argument {name} is passed to nothing"
        if re.search(r'<node[^>]* pkg="(?!lamina")', text) and 'name="ROS_IP"' not in text:
            yield path.name, f"{path}: a node of another package is not kept on the loopback interface (docs/cell/security.md)"


def default_of(setting, config):
    """What a setting without its node is in a file of config/, as it is written there; nothing if it is absent."""
    *group, key = setting.split("/")
    lines = rf"^{group[0]}:\n(?:[ #].*\n)*?  {key}: (.*)$" if group else rf"^{key}: (.*)$"
    found = re.search(lines, config, re.MULTILINE)
    return found.group(1) if found else None


def text_faults(root):
    """roslaunch makes a number of a folder 2026 and a truth value of a word true, which nodes refuse, unless it is told the type."""
    configs = {path.stem: text for path, text in texts(root, "config").items()}
    for path, text in texts(root, "launch").items():
        node = None
        for opened, closed, parameter in NODE_OR_PARAMETER.findall(text):
            if opened or closed:
                node = opened
                continue
            name = NAME.search(parameter).group(1)
            of, _, setting = (node, "", name) if node else name.partition("/")
            default = default_of(setting, configs.get(of, ""))
            if default is not None and not NO_TEXT.fullmatch(default) and 'type="str"' not in parameter:
                yield name, f'{path}: parameter {name} of {of} is a text; expected type="str"'


def topic_faults(root):
    header = root / "src/ros_adapters/names.hpp"
    sources = found_in(r"\bk\w+", {path: text for path, text in texts(root, "src").items() if path.name != "names.hpp"})
    tests = texts(root, "test")
    tested = found_in(r"\bk\w+", tests)
    for name, value in TOPIC.findall(header.read_text() if header.exists() else ""):
        if name not in sources:
            yield name, f"src/ros_adapters/names.hpp: {name} is used by no node"
        if name not in tested and not any(re.search(rf'["/ ]{value}\b', text) for text in tests.values()):
            yield name, f"src/ros_adapters/names.hpp: {name} stands in no test"


def messages(root):
    for kind in ("msg", "srv", "action"):
        for path in sorted((root / kind).glob("*." + kind)):
            lines = [line for line in path.read_text().splitlines() if "=" not in line.split("#")[0]]
            yield path, sorted(set(FIELD.findall("\n".join(lines))))


def field_faults(root):
    use = r"(?:\.|->)(\w+)"
    sources = found_in(use, texts(root, "src"))
    tests = found_in(use, texts(root, "test"))
    for path, fields in messages(root):
        for name in fields:
            if name not in sources:
                yield name, f"{path.relative_to(root)}: field {name} is neither filled nor read in src"
            elif sources[name] + tests[name] < 2:
                yield name, f"{path.relative_to(root)}: field {name} is filled or read, but not both"


def faults(root, gaps=None):
    gaps = GAPS if gaps is None else gaps
    found = [fault for look in (option_faults, launch_faults, text_faults, topic_faults, field_faults) for fault in look(root)]
    yield from (text for name, text in found if name not in gaps)
    for name in sorted(gaps.keys() - {name for name, _ in found}):
        yield f"test/architecture/interfaces.py: {name} is used now; expected it to be no gap"


if __name__ == "__main__":
    report(faults)
