#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The structure of the source tree, from its #include lines and class declarations.

    structure.py --picture    prints the picture of packaging/reference/architecture.md
    structure.py --classes    prints the classes of widgets/ that neither derive from nor own a widget
    structure.py              checks that the picture is up to date, and that each of these classes has a reason below
"""
import collections
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "packaging/reference/architecture.md"
GROUPS = ["app", "widgets", "robot/python", "robot/station", "robot"]
INNER = "robot/simulator"  # a folder of a group, shown with its subfolders
WIDTH = 100
MARGIN = 17

PLOT = "the visible part of a plot"
MODEL = "a model for a view: it formats rows and columns"
FILTER = "the filter of a view"
EVENTS = "filters events of widgets"
DEVICE = "reads an input device"
PROBE = "asks the display server which keys are down"
VIEW = "values of the 3D view"
# Classes of widgets/ that neither derive from nor own a widget, and why they are in widgets/.
REASONS = {
    "AxisRange": PLOT, "Camera": VIEW, "DeviceSource": DEVICE, "Filter": FILTER, "FrameModel": MODEL,
    "Gamepad": DEVICE, "GamepadSource": DEVICE, "HoverKeeper": EVENTS, "InputDevice": DEVICE, "KeyGhosts": EVENTS,
    "KeyRepeat": EVENTS, "KeyStateProbe": PROBE, "LabelPlacer": VIEW, "Link": PROBE, "ListTyping": EVENTS,
    "LogFilter": FILTER, "NoKeyStateProbe": PROBE, "PaintWatch": EVENTS,
    "PaperColors": "selects the theme for printing", "PartModel": MODEL,
    "PhysicalKeys": "the pressed keys of the keyboard, from key events",
    "PlotComparison": "the recordings compared in the plots, and their offsets on the time axis",
    "ProgramModel": MODEL, "ProjectFiles": "wraps UndoableDocument, whose QUndoStack is part of Qt Gui",
    "SceneTrace": VIEW, "Shade": VIEW, "SingleClick": EVENTS, "SpaceMouse": DEVICE, "SpaceMouseSource": DEVICE,
    "StackingWatch": "the order of windows on the display server", "TimeWindow": PLOT,
    "VariableModel": MODEL, "WaypointModel": MODEL, "XcbKeyStateProbe": PROBE,
}


def sources(top):
    return sorted(path for path in (ROOT / top).rglob("*") if path.suffix in (".h", ".cpp"))


# ---- the picture ----------------------------------------------------------------------------------------

def part_of(file):
    """Group and folder of a source file, e.g. ("robot/station", "link"); None outside the groups."""
    for group in GROUPS:
        if file.startswith(group + "/"):
            rest = file[len(group) + 1:].split("/")
            return (group, rest[0] if len(rest) > 1 else group)
    return None


def inner_part_of(file):
    """Like part_of(), for the folders inside INNER."""
    if not file.startswith(INNER + "/"):
        return None
    folder = file[len(INNER) + 1:].rpartition("/")[0]
    return (INNER, folder or INNER.rpartition("/")[2])


def includes(part_of):
    """The folders included by each folder."""
    found = collections.defaultdict(set)
    for top in ("app", "widgets", "robot"):
        for path in sources(top):
            part = part_of(path.relative_to(ROOT).as_posix())
            if part is None:
                continue
            found[part]
            for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', path.read_text(), re.M):
                other = part_of(name) if (ROOT / name).exists() else None
                if other is not None and other != part:
                    found[part].add(other)
    return found


def levels(parts, found):
    """The level of each folder of a group: above all folders of the group that it includes."""
    level = {}

    def of(part, path=()):
        if part in path:
            sys.exit("cycle: " + " includes ".join("/".join(p) for p in path[path.index(part):] + (part,)))
        if part not in level:
            level[part] = 1 + max([of(other, path + (part,)) for other in found[part] if other in parts], default=-1)
        return level[part]

    for part in parts:
        of(part)
    return level


def picture():
    found = includes(part_of)
    lines = []
    for rank, group in enumerate(GROUPS):
        for upper in GROUPS[rank + 1:]:
            for part in (part for part in found if part[0] == upper):
                for other in found[part]:
                    if other[0] == group:
                        sys.exit(f"upward arrow: {'/'.join(part)} includes {'/'.join(other)}")
        lines += rows(group, found)
    lines += rows(INNER, includes(inner_part_of))
    return "\n".join(lines).rstrip() + "\n"


def rows(group, found):
    """The lines of a group, from its highest level down, and an empty line."""
    lines = []
    level = levels({part for part in found if part[0] == group}, found)
    title = group
    for height in sorted(set(level.values()), reverse=True):
        line = ""
        for name in sorted(name for (_, name), at in level.items() if at == height):
            if len(line) + len(name) > WIDTH - MARGIN:
                lines.append(f"{title:<{MARGIN}}{line}".rstrip())
                title, line = "", ""
            line += ("  " if line else "") + name
        lines.append(f"{title:<{MARGIN}}{line}".rstrip())
        title = ""
    return lines + [""]


# ---- classes without a widget ---------------------------------------------------------------------------

DECLARATION = re.compile(r"^(?:template *<[^>]*>\s*)?(class|struct)\s+(?:\w+::)*(\w+)(?:\s+final)?\s*(:[^{;]*)?\{",
                         re.M)


def display_types():
    """The types of Qt Gui, Widgets, Charts and Svg: QT_HEADERS lists the include folders of Qt, separated by |."""
    folders = [pathlib.Path(folder) for folder in os.environ["QT_HEADERS"].split("|") if folder]
    types = {entry.name for folder in folders for module in ("QtGui", "QtWidgets", "QtCharts", "QtSvg")
             for entry in [*(folder / module).glob("Q*"), *(folder.parent / module).glob("Q*")]}
    if "QWidget" not in types or "QObject" in types:
        sys.exit(f"no headers of Qt Widgets in {folders}")
    return types


def surface(body):
    """The body of a class without parameters and function bodies: the types of members and results."""
    for group in (r"\([^()]*\)", r"\{[^{}]*\}"):
        before = None
        while before != body:
            before, body = body, re.sub(group, "", body)
    return body


def classes_without_widget():
    display = display_types()
    types = {}    # class or struct: the types in its declaration
    classes = {}  # class: file. A struct holds values.
    for path in sources("widgets"):
        text = re.sub(r"//[^\n]*", "", path.read_text())
        for found in DECLARATION.finditer(text):
            depth, end = 1, found.end()
            while depth > 0:
                depth += {"{": 1, "}": -1}.get(text[end], 0)
                end += 1
            kind, name, bases = found.groups(default="")
            types[name] = set(re.findall(r"\b[A-Z]\w+", bases + " " + surface(text[found.end():end])))
            if kind == "class":
                classes[name] = path.relative_to(ROOT).as_posix()
    shown = set()
    while True:
        more = {name for name in types if name not in shown and types[name] & (display | shown)}
        if not more:
            return {name: classes[name] for name in classes if name not in shown}, len(classes)
        shown |= more


def main():
    if sys.argv[1:] == ["--picture"]:
        print(picture(), end="")
        return
    found, count = classes_without_widget()
    if sys.argv[1:] == ["--classes"]:
        for name, file in sorted(found.items(), key=lambda item: item[1]):
            print(f"{file}: {name}: {REASONS.get(name, 'NO REASON')}")
        print(f"{len(found)} of {count} classes")
        return
    problems = [f"{file}: class {name} neither derives from nor owns a widget: move it to robot/, or add a reason"
                for name, file in found.items() if name not in REASONS]
    problems += [f"class {name} needs no reason" for name in REASONS if name not in found]
    if count < 100:
        problems.append(f"only {count} classes found")
    if f"```\n{picture()}```\n" not in PAGE.read_text():
        problems.append(f"{PAGE.name} shows other folders than structure.py --picture")
    if problems:
        sys.exit("\n".join(problems))


if __name__ == "__main__":
    main()
