#!/usr/bin/env python3
"""No two sources of src hold the same free function: of the same types and the same body, whatever it, its parameters and its locals
are called. Bodies of a few words, such as `return kindOf(role) == RoleKind::Wall;`, may stand twice.

Usage: equal_functions.py [ROOT]   exits 1 and names each function that stands more than once
"""
import collections
import re

from rule_script import report

LITERAL = r'R"\((?:.|\n)*?\)"|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)+\''
SKIPPED = re.compile(rf"({LITERAL})|//[^\n]*|/\*(?:.|\n)*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)
TOKEN = re.compile(rf"{LITERAL}|[\w.]*\d[\w.']*|\w+|::|->|&&|\|\||[<>=!+*/-]=|<<|\+\+|--|\S")
HEAD = re.compile(r"^(?:template <[^\n]*>\n)?([A-Za-z_\[][^;{}()=#]*?[\s&*])(\w+)\(([^;{}]*?)\)(?: noexcept)? \{", re.M)
QUALIFIERS = {"const", "constexpr", "inline", "static", "nodiscard", "noreturn", "maybe_unused"}
WORD = re.compile(r"[A-Za-z_]\w*$")
STATEMENTS = {"case", "delete", "else", "goto", "new", "return", "throw"}
FEWEST_TOKENS = 12


def code_of(text):
    """The source without comments and directives; lines stay lines."""
    return SKIPPED.sub(lambda found: found.group(1) or "\n" * found.group().count("\n"), text)


def type_of(tokens):
    return tuple(token for token in tokens if token not in QUALIFIERS and token not in ("&", "&&", "[", "]"))


def parameters_of(text):
    """Types and names of the parameters; no name where there is none."""
    split, depth = [[]], 0
    for token in TOKEN.findall(text):
        depth += (token in "<([{") - (token in ">)]}")
        if token == "," and depth == 0:
            split.append([])
        else:
            split[-1].append(token)
    types, names = [], []
    for tokens in split:
        is_named = len([token for token in tokens if WORD.match(token) and token not in QUALIFIERS]) > 1
        types.append(type_of(tokens[:-1] if is_named else tokens))
        names.append(tokens[-1] if is_named else "")
    return tuple(types), names


def locals_of(body):
    """Names that the body itself declares."""
    for before, name, after in zip(body, body[1:], body[2:]):
        declares = WORD.match(before) and before not in STATEMENTS and after in ("=", "{", ";", ":")
        if WORD.match(name) and (declares or before in ("&", "*", ">") and after in ("=", ":")):
            yield name


def body_from(text, begin):
    """The tokens from an opening brace to the one that closes it."""
    depth, body = 0, []
    for found in TOKEN.finditer(text, begin):
        token = found.group()
        depth += (token == "{") - (token == "}")
        if depth == 0:
            return body[1:]
        body.append(token)
    return body[1:]


def functions_of(text):
    """Name, line and what makes them equal, of the free functions of a source that are worth a comparison."""
    code = code_of(text)
    for head in HEAD.finditer(code):
        types, names = parameters_of(head.group(3))
        body = body_from(code, head.end() - 1)
        if len(body) < FEWEST_TOKENS:
            continue
        new_names = {head.group(2): "0"}
        for name in names + list(locals_of(body)):
            new_names.setdefault(name, str(len(new_names)))
        is_member = [False] + [token in (".", "->", "::") for token in body]
        renamed = (token if member else new_names.get(token, token) for token, member in zip(body, is_member))
        yield head.group(2), code.count("\n", 0, head.start(2)) + 1, (type_of(TOKEN.findall(head.group(1))), types, tuple(renamed))


def faults(root):
    places = collections.defaultdict(list)
    for path in sorted((root / "src").rglob("*.[ch]pp")):
        for name, line, function in functions_of(path.read_text()):
            places[function].append((path.relative_to(root), line, name))
    for found in sorted(places.values()):
        if len({path for path, _, _ in found}) > 1:
            names = " and ".join(f"{path}:{line} as {name}" for path, line, name in found)
            yield f"one function stands in {names}; expected it once, in the module of its idea"


if __name__ == "__main__":
    report(faults)
