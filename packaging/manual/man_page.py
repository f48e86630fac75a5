# SPDX-License-Identifier: MIT
"""Adds the help of each command to a manual page: man_page.py PROGRAM PAGE.rst, to standard output."""
import re
import subprocess
import sys


def said(*words):
    return subprocess.run([*words, "--help"], capture_output=True, text=True, check=True).stdout


def main(program, page):
    with open(page, encoding="utf-8") as file:
        text = file.read()
    part = said(program).partition("Commands:\n")[2].partition("\n\n")[0]
    sections = ""
    for command in re.findall(r"^  ([a-z][a-z-]*)", part, re.MULTILINE):
        lines = "".join(f"    {line}".rstrip() + "\n" for line in said(program, command).splitlines())
        sections += f"{command}\n{'=' * len(command)}\n\n::\n\n{lines}\n"
    before, mark, after = text.partition(".. The page of the package continues here")
    if not mark or not sections:
        sys.exit(f"{page} has no place for the commands, or {program} has none")
    print(before + sections + after.partition("\n\n")[2], end="")


if __name__ == "__main__":
    main(*sys.argv[1:])
