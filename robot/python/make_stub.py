# SPDX-License-Identifier: MIT
"""Writes the type stub of a module next to it: make_stub.py FOLDER MODULE.

pybind11 writes the signatures into the docstrings (TILLER_STUBS keeps them there); this script converts them for type
checkers: arguments accept any sequence of numbers, results are lists.
"""
import enum
import importlib
import re
import sys

HEADER = """# Written by make_stub.py.
import datetime
import enum
from collections.abc import Sequence
from typing import Any, ClassVar, Union, overload

from numpy.typing import NDArray
from typing_extensions import Self

__version__: str

_Floats = Union[Sequence[float], NDArray[Any]]
_Ints = Union[Sequence[int], NDArray[Any]]
_Rows = Union[Sequence[_Floats], NDArray[Any]]

"""


def signatures(name, doc):
    """The signatures in a docstring, without numbers and without the name of the function."""
    found = re.findall(r"^(?:\d+\. )?%s(\(.*\)) -> (.+)$" % re.escape(name), doc or "", re.MULTILINE)
    return [(arguments, result) for arguments, result in found if arguments != "(*args, **kwargs)"]


def cleaned(text, module):
    return re.sub(r"<[^<>]*>", "...", text.replace(module + ".", ""))  # defaults that are enumerators


def taken(arguments, module):
    """Converts the argument types: sequences are accepted for lists."""
    text = re.sub(r"^\((self|arg0): [\w.]+", "(self", arguments)
    text = text.replace("*args", "*args: Any").replace("**kwargs", "**kwargs: Any")
    for written, meant in (("List[List[float]]", "_Rows"), ("List[float]", "_Floats"), ("List[int]", "_Ints"),
                           (r"List[Tuple[str, int]]", "Sequence[tuple[str, int]]"), ("List[str]", "Sequence[str]"),
                           ("object", "Any")):
        text = text.replace(written, meant)
    return cleaned(text, module)


def given(result, module):
    return cleaned(re.sub(r"\bList\b", "list", re.sub(r"\bTuple\b", "tuple", result)), module)


def function_lines(name, function, module, indent):
    lines = []
    found = list(dict.fromkeys((taken(arguments, module), given(result, module))
                               for arguments, result in signatures(name, function.__doc__)))
    for arguments, result in found:
        if len(found) > 1:
            lines.append(indent + "@overload")
        if name == "__eq__":
            arguments = "(self, other: object)"
        elif name == "__enter__":
            result = "Self"
        lines.append(f"{indent}def {name}{arguments} -> {result}: ...")
    return lines


def enumeration_lines(cls, indent):
    inner = indent + "    "
    if issubclass(cls, enum.Enum):
        kind = "IntFlag" if issubclass(cls, enum.IntFlag) else "IntEnum"
        return [f"{indent}class {cls.__name__}(enum.{kind}):"] + [
            f"{inner}{name} = {int(member)}" for name, member in cls.__members__.items()]
    return ([f"{indent}class {cls.__name__}:"] + [f"{inner}{name}: ClassVar[{cls.__qualname__}]" for name in cls.__members__]
            + [f"{inner}def __init__(self, value: int) -> None: ...", f"{inner}def __int__(self) -> int: ...",
               f"{inner}def __index__(self) -> int: ...", f"{inner}@property", f"{inner}def name(self) -> str: ...",
               f"{inner}@property", f"{inner}def value(self) -> int: ..."])


def class_lines(cls, module, indent=""):
    if getattr(cls, "__members__", None) is not None:
        return enumeration_lines(cls, indent)
    lines = [f"{indent}class {cls.__name__}:"]
    inner = indent + "    "
    special = ("__init__", "__enter__", "__exit__", "__eq__")
    for name, member in sorted(vars(cls).items()):
        if isinstance(member, type):
            lines += class_lines(member, module, inner)
        elif hasattr(type(member), "__members__"):
            lines.append(f"{inner}{name}: ClassVar[{cls.__name__}.{type(member).__name__}]")
        elif name in special or not name.startswith("_"):
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
