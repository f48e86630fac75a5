# SPDX-License-Identifier: MIT
"""Writes a version script for the linker with the symbols of the archives that are declared in public headers.

A symbol is public if every part of its name (namespace, class, function) occurs in a public header, no part is only
forward-declared there (a hidden implementation), and no part is in a `detail` namespace. Weak symbols are included,
because a template that is only declared in a header is instantiated in the library.
"""
import argparse
import pathlib
import re
import subprocess
import sys

# Members added by moc to a class with Q_OBJECT.
META_OBJECT = {"metaObject", "qt_metacast", "qt_metacall", "qt_static_metacall", "staticMetaObject"}
ABOUT = re.compile(r"^(vtable|typeinfo|typeinfo name|VTT|construction vtable|guard variable|non-virtual thunk|virtual thunk)"
                   r"(?: for| to) ")


def headers_of(top, names):
    for name in names:
        path = top / name
        if path.is_dir():
            yield from (header for header in sorted(path.rglob("*.h")) if "detail" not in header.relative_to(top).parts)
        else:
            yield path


def declared(texts):
    """The identifiers in these headers, and the classes that are only forward-declared."""
    text = "\n".join(re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:[^\"\\\n]|\\.)*\"", " ", part, flags=re.DOTALL) for part in texts)
    names = set(re.findall(r"[A-Za-z_]\w*", text))
    announced = set(re.findall(r"\b(?:class|struct)\s+(\w+)\s*;", text))
    # Also matches attributes, base classes and `final`.
    defined = set(re.findall(r"\b(?:class|struct)\s+(?:\[\[[^\]]*\]\]\s*|[A-Z_]+\s+)?(\w+)[^;{}()]*\{", text))
    if "Q_OBJECT" in names:
        names |= META_OBJECT
    return names, announced - defined


def without_arguments(symbol):
    """Converts tiller::Result<int>::value() const& to tiller::Result::value, and removes the symbols of operators."""
    symbol = re.sub(r"operator(?:\(\)|<=>|<<|>>|->\*?|<=?|>=?)", "operator", symbol)
    name, depth = "", 0
    for letter in symbol:
        if letter == "<":
            depth += 1
        elif letter == ">":
            depth -= 1
        elif letter == "(" and depth == 0:
            break
        elif depth == 0:
            name += letter
    return re.sub(r"\[abi:\w+\]", "", name)


def is_public(symbol, names, hidden):
    symbol = ABOUT.sub("", symbol)
    if "(anonymous namespace)" in symbol or "{lambda" in symbol:
        return False
    parts = without_arguments(symbol).split("::")
    if len(parts) < 2 or parts[0] not in ("tiller", "ur_rtde"):
        return False
    for part in parts:
        word = re.match(r"~?([A-Za-z_]\w*)", part.strip())
        if not word or word[1] == "detail" or word[1] in hidden or word[1] not in names:
            return False
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nm", required=True)
    parser.add_argument("--top", type=pathlib.Path, required=True, help="what the names of the headers begin behind")
    parser.add_argument("--headers", nargs="+", required=True, help="headers, or folders of them")
    parser.add_argument("--archives", nargs="+", required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    options = parser.parse_args()
    names, hidden = declared([path.read_text() for path in headers_of(options.top, options.headers)])
    lists = [subprocess.run([options.nm, *more, "--defined-only", "--extern-only", "--format=posix", *options.archives],
                            capture_output=True, text=True, check=True).stdout.splitlines() for more in ([], ["-C"])]
    exported = set()
    for raw, readable in zip(*lists):
        # posix format: name, kind, value, size. A demangled name may contain spaces.
        fields = raw.split(" ")
        if len(fields) < 3:
            continue
        name, kind = fields[0], fields[1]
        shown = re.match(r"^(.*) [A-Za-z] [0-9a-f]* ?[0-9a-f]*$", readable)
        if not shown or kind not in "TDRBVWu":
            continue
        if is_public(shown[1], names, hidden):
            exported.add(name)
    if not exported:
        sys.exit("nothing of the headers is in the archives")
    options.output.write_text("{\n  global:\n" + "".join(f"    {name};\n" for name in sorted(exported)) + "  local: *;\n};\n")


if __name__ == "__main__":
    main()
