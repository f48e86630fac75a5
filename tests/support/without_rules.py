#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Removes each rule that ends a held motion, one after the other, and prints which tests fail.

A rule is a row of the tables in hold_rules.cpp, or a line of the files below that ends in "// rule: NAME". The source
file without that line is compiled separately. It is linked before the libraries when the test is linked again. Neither
the source tree nor the build tree is changed. The script fails if there is a rule without which no test fails.

    tests/support/without_rules.py [BUILD_FOLDER] [NAME_CONTAINS]

Requires a build of the tests named below in BUILD_FOLDER (default build/dev), with a preset that compiles each file
separately.
"""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Files with rules, and the test that must fail without a rule. Functions that only read the list of rules do not count.
PLACES = [
    ("widgets/hold/hold_rules.cpp", "tst_hold_rules"),
    ("widgets/hold/hold_guard.cpp", "tst_hold_rules"),
    ("widgets/hold/physical_keys.cpp", "tst_keyboard_jog"),
    ("widgets/jog/keyboard_jog.cpp", "tst_keyboard_jog"),
    ("widgets/jog/axis_jog.cpp", "tst_hold_rules"),
    ("widgets/jog/device_jog.cpp", "tst_devices"),
]
NOT_COUNTED = {"everyRuleHasATestCase()"}
ROW = re.compile(r'^\s*\{"([^"]+)", &HoldRuleTable::\w+\},\s*$')
MARK = re.compile(r"// rule: (.+?)\s*$")


def rules_of(path):
    for number, line in enumerate(path.read_text().splitlines()):
        found = ROW.match(line) or MARK.search(line)
        if found:
            yield number, found.group(1)


def compile_command(build, path):
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if pathlib.Path(entry["file"]).resolve() == path.resolve():
            return shlex.split(entry["command"]), entry["directory"]
    sys.exit(f"no compile command for {path}: build the preset dev, others join files")


def link_command(build, test):
    out = subprocess.run(["ninja", "-C", str(build), "-t", "commands", "-s", f"bin/tests/{test}"],
                         check=True, capture_output=True, text=True).stdout
    return [line for line in out.splitlines() if " -o " in line][-1]


def listing(binary, option, environment):
    """The list that Qt Test prints on either output stream."""
    done = subprocess.run([binary, option], capture_output=True, text=True, env=environment)
    return (done.stdout + done.stderr).splitlines()


def run(binary, rule=""):
    """Names of the failing test functions; "ended badly" if the program did not finish.

    The rows with the name of the rule run first, because they are most likely to fail.
    """
    env = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    functions = [n[:-2] for n in listing(binary, "-functions", env) if n.endswith("()") and n not in NOT_COUNTED]
    if not functions:
        sys.exit(f"{binary} lists no functions")
    tags = [line.split(" ", 2)[1:] for line in listing(binary, "-datatags", env) if line.count(" ") >= 2]
    named = [f"{function}:{tag}" for function, tag in tags if rule and tag.endswith(": " + rule)]
    for chosen in ([named] if named else []) + [functions]:
        try:
            done = subprocess.run([binary, *chosen], capture_output=True, text=True, env=env, timeout=1200)
        except subprocess.TimeoutExpired:
            return ["ended badly: time out"]
        failed = re.findall(r"^FAIL!\s+: \w+::(.+?\)) ", done.stdout, re.MULTILINE)
        if failed:
            return failed
        if done.returncode != 0:
            return [f"ended badly: {done.returncode}"]
    return []


def main():
    build = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/dev").resolve()
    only = sys.argv[2] if len(sys.argv) > 2 else ""
    unmissed = []
    tried = 0
    with tempfile.TemporaryDirectory() as scratch:
        for place, test in PLACES:
            path = ROOT / place
            compiler, folder = compile_command(build, path)
            link = link_command(build, test)
            lines = path.read_text().splitlines(keepends=True)
            whole = run(str(build / "bin/tests" / test))
            if whole:
                sys.exit(f"{test} fails with all rules: {whole}")
            for number, name in rules_of(path):
                if only not in name:
                    continue
                source = pathlib.Path(scratch) / path.name
                source.write_text("".join(lines[:number] + lines[number + 1:]))
                made = pathlib.Path(scratch) / "without.o"
                command = list(compiler)
                command[command.index("-o") + 1] = str(made)
                command[command.index("-c") + 1] = str(source)
                subprocess.run(command, cwd=folder, check=True)
                binary = pathlib.Path(scratch) / test
                first = re.search(r"\S+\.o\b", link).group(0)
                relink = link.replace(first, f"{made} {first}", 1).replace(
                    f"-o bin/tests/{test}", f"-o {binary}")
                subprocess.run(relink, shell=True, cwd=build, check=True)
                failed = run(str(binary), name)
                tried += 1
                if not failed:
                    unmissed.append(name)
                more = f" and {len(failed) - 1} more" if len(failed) > 1 else ""
                print(f"{path.name:18} {name:40} {failed[0] + more if failed else 'NOBODY MISSES IT'}", flush=True)
    print(f"{tried} rules taken away, {len(unmissed)} missed by nobody")
    return 1 if unmissed or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
