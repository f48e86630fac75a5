# SPDX-License-Identifier: MIT
"""Writes the type stub of a module next to it: make_stub.py FOLDER MODULE.

pybind11 puts the signatures into the docstrings; this brings them into the form type checkers read.
"""
import importlib
import re
import sys

HEADER = "import datetime\nfrom typing import Any, ClassVar, List, Tuple, overload\n\n"


def signatures(name, doc):
    """The signatures in a docstring, without numbers and without the function's name in front."""
    found = re.findall(r"^(?:\d+\. )?%s(\(.*\)) -> (.+)$" % re.escape(name), doc or "", re.MULTILINE)
    return [(arguments, result) for arguments, result in found if "*args" not in arguments]


def cleaned(text, module):
    text = text.replace(module + ".", "")
    text = re.sub(r"<[^<>]*>", "...", text)  # defaults that are enumerators
    return re.sub(r"\b(RTDEControlInterface|RobotiqGripper|PathEntry)\.(\w+)\b", r"\1.\2", text)


def function_lines(name, function, module, indent):
    found = signatures(name, function.__doc__)
    lines = []
    for arguments, result in found:
        if len(found) > 1:
            lines.append(indent + "@overload")
        arguments = re.sub(r"\(self: [\w.]+", "(self", arguments)
        arguments = re.sub(r"\(arg0: [\w.]+", "(self", arguments) if name.startswith("__") else arguments
        lines.append(f"{indent}def {name}{cleaned(arguments, module)} -> {cleaned(result, module)}: ...")
    return lines


def class_lines(cls, module, indent=""):
    lines = [f"{indent}class {cls.__name__}:"]
    inner = indent + "    "
    members = getattr(cls, "__members__", None)
    if members is not None:  # an enumeration
        lines += [f"{inner}{name}: ClassVar[{cls.__name__}]" for name in members]
        return lines + [f"{inner}def __int__(self) -> int: ...", f"{inner}def __or__(self, other: Any) -> int: ..."]
    for name, member in sorted(vars(cls).items()):
        if isinstance(member, type):
            lines += class_lines(member, module, inner)
        elif hasattr(type(member), "__members__"):
            lines.append(f"{inner}{name}: ClassVar[{cls.__name__}.{type(member).__name__}]")
        elif name == "__init__" or not name.startswith("_"):
            lines += function_lines(name, member, module, inner)
    return lines


def main(folder, module):
    sys.path.insert(0, folder)
    loaded = importlib.import_module(module)
    lines = []
    for _, member in sorted(vars(loaded).items()):
        if isinstance(member, type):
            lines += class_lines(member, module) + [""]
    with open(f"{folder}/{module}.pyi", "w", encoding="utf-8") as stub:
        stub.write(HEADER + "\n".join(lines))


if __name__ == "__main__":
    main(*sys.argv[1:])
