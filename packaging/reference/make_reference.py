# SPDX-License-Identifier: MIT
"""Creates the reference of the C++ library with Doxygen: make_reference.py OUTPUT. Warnings are errors.

Doxygen reads copies of the headers with converted comments. The paragraph at the start of a file becomes the description
of the class with the name of the file, indented text is not changed, and columns in a comment ("speed   [m/s]",
"Returns  a handle") become a list.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

TOP = pathlib.Path(__file__).resolve().parents[2]
# The same folders as excluded in packaging/cmake/TillerInstall.cmake.
HIDDEN = {"python", "detail", "examples", "simulator", "ur_rtde", "station"}
SIMULATOR = ("simulator.h", "options/assumptions.h", "options/simulator_options.h", "arm/arm_state.h",
             "arm/environment.h", "plant/personality.h")


def headers():
    """The installed public headers, relative to the top folder."""
    robot = TOP / "robot"
    found = [path.relative_to(TOP) for path in robot.rglob("*.h") if not HIDDEN & set(path.relative_to(robot).parts)]
    return sorted(found + [pathlib.Path("robot/simulator", name) for name in SIMULATOR])


def block(lines):
    """Converts lines that begin with "///" to one comment. Indented text is not changed."""
    out, inside = ["/**"], False
    for line in (line[3:] for line in lines):
        indented = line.startswith("   ") or (inside and not line)
        if indented != inside:
            out.append("@verbatim" if indented else "@endverbatim")
            inside = indented
        out.append(line if indented else re.sub(r"^ (\w+(?:, \w+)*)  +(?=\S)", r" - **\1**: ", line))
    return out + (["@endverbatim"] if inside else []) + ["*/"]


def for_doxygen(text, name):
    lines = text.split("\n")
    head, rest, at_head = [], [], False
    for line in lines:
        if line.startswith("#pragma once"):
            at_head = True
        elif at_head and re.match(r"//(?!/)", line):
            head.append("///" + line[2:])
            line = ""
        elif line.strip():
            at_head = at_head and not head
        rest.append(line)
    # Use the class with the name of the file, otherwise the first class without a comment.
    opens = [(at, match[1]) for at, line in enumerate(rest)
             if (match := re.match(r"(?:class|struct|enum class) (?:\[\[\w+\]\] )?(\w+)[^;]*$", line))]
    named = [at for at, what in opens if what.lower() == name.replace("_", "")]
    bare = [at for at, _ in opens if not rest[at - 1].startswith(("///", "template"))]
    for at in (named or bare)[:1] if head else []:
        began = at
        while rest[began - 1].startswith(("///", "template")):
            began -= 1
        own = [line for line in rest[began:at] if line.startswith("///")]
        templates = [line for line in rest[began:at] if line.startswith("template")]
        rest[began:at] = block(head + (["///"] + own if own else [])) + templates
    return "\n".join(re.sub(r"^(\s*///) (\w+(?:, \w+)*)  +(?=\S)", r"\1 - **\2**: ", line) for line in rest)


def main(output):
    output = pathlib.Path(output).resolve()
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    cmake = (TOP / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"project\(tiller VERSION (\S+)", cmake)[1]
    with tempfile.TemporaryDirectory() as source:
        for header in headers():
            copy = pathlib.Path(source, header)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(for_doxygen((TOP / header).read_text(encoding="utf-8"), header.stem), encoding="utf-8")
        return subprocess.run(["doxygen", str(TOP / "packaging/reference/Doxyfile")], cwd=source, check=False,
                              env=dict(os.environ, OUTPUT=str(output), VERSION=version)).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
