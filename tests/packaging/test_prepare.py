# SPDX-License-Identifier: MIT
"""Tests the output of packaging/run and packaging/test during installation and build, on a terminal and in a log."""
import os
import pty
import re
import select
import shutil
import subprocess
import tempfile
import time
import unittest

APT = """#!/bin/sh
case "$*" in
*update*) exit 0 ;;
esac
echo "Selecting previously unselected package ninja-build."
echo "dlstatus:1:20.4:Retrieving file 1 of 1"
echo "pmstatus:ninja-build:0.0:Preparing ninja-build (amd64)"
echo "pmstatus:ninja-build:50.0:Unpacking ninja-build (amd64)"
echo "pmstatus:ninja-build:100.0:Installed ninja-build (amd64)"
[ -z "$APT_FAILS" ] || { echo "E: no space left on device"; exit 100; }
"""
CMAKE = """#!/bin/sh
case "$1" in
--build)
    [ -n "$NOTHING_TO_DO" ] && { echo "ninja: no work to do."; exit 0; }
    touch "$2/.ninja_log"
    i=0
    while [ $i -lt 200 ]; do i=$((i + 1)); echo "[$i/200] Building CXX object $i"; done
    [ -z "$BUILD_FAILS" ] || { echo "arm.cpp:7: error: no such joint"; exit 1; } ;;
--preset) mkdir -p build/$2; touch build/$2/build.ninja ;;
esac
"""
SCRIPT = """#!/bin/bash
source packaging/prepare
tiller_steps=3
tiller_install run
tiller_configure release
tiller_build release tiller
echo "worked=$tiller_worked"
"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(cached CXX)
set(CMAKE_UNITY_BUILD ON)
add_library(cached OBJECT cached.cpp)
target_precompile_headers(cached PRIVATE once.h)
"""


class TestPrepare(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)
        os.makedirs(f"{self.folder}/packaging")
        os.makedirs(f"{self.folder}/bin")
        for name in ("prepare", "dependencies"):
            shutil.copy(os.path.join(os.environ["TILLER_SOURCE"], "packaging", name), f"{self.folder}/packaging")
        self.write("bin/apt-get", APT)
        self.write("bin/sudo", '#!/bin/sh\nexec "$@"\n')
        self.write("bin/cmake", CMAKE)
        self.write("bin/dpkg-query", "#!/bin/sh\n")
        self.write("script", SCRIPT)
        self.environment = dict(os.environ, PATH=f"{self.folder}/bin:{os.environ['PATH']}", TMPDIR=self.folder)

    def write(self, name, text):
        with open(f"{self.folder}/{name}", "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(f"{self.folder}/{name}", 0o755)

    def piped(self, **more):
        return subprocess.run(["./script"], cwd=self.folder, env=dict(self.environment, **more), text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, check=False)

    def on_a_terminal(self, **more):
        ours, theirs = pty.openpty()
        process = subprocess.Popen(["./script"], cwd=self.folder, env=dict(self.environment, **more), stdin=theirs,
                                   stdout=theirs, stderr=theirs)
        os.close(theirs)
        said = b""
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline:
            if select.select([ours], [], [], 1)[0]:
                try:
                    piece = os.read(ours, 65536)
                except OSError:  # the other end is closed
                    break
                if not piece:
                    break
                said += piece
        os.close(ours)
        return process.wait(), said.decode()

    def test_a_log_receives_few_complete_lines(self):
        ran = self.piped()
        self.assertEqual(ran.returncode, 0, ran.stdout)
        self.assertNotIn("\r", ran.stdout)
        self.assertNotIn("\033", ran.stdout)
        self.assertRegex(ran.stdout, r"(?m)^\[1/3\] Installing \d+ Debian packages: .*ninja-build")
        self.assertIn("[2/3] Configuring", ran.stdout)
        self.assertIn("[3/3] Building", ran.stdout)
        shares = [int(share) for share in re.findall(r"^  Building  (\d+) %", ran.stdout, re.MULTILINE)]
        self.assertEqual(shares, [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 100])
        shares = [int(share) for share in re.findall(r"^  Installing  (\d+) %", ran.stdout, re.MULTILINE)]
        self.assertEqual(shares, [10, 50, 75, 100])
        self.assertIn("worked=1", ran.stdout)

    def test_a_terminal_shows_one_updating_line(self):
        code, said = self.on_a_terminal()
        self.assertEqual(code, 0, said)
        self.assertIn("\r\033[K  Building   50 %  100 of 200", said)
        self.assertIn("\r\033[K  Installing   75 %  Unpacking ninja-build", said)
        # Only the steps and their results remain visible.
        kept = [line.rstrip("\r").split("\r")[-1].replace("\033[K", "").strip() for line in said.split("\n")]
        kept = [line for line in kept if line]
        self.assertEqual([line[:5] for line in kept if line.startswith("[")], ["[1/3]", "[2/3]", "[3/3]"])
        self.assertTrue(any(re.match(r"Built in \d+ s\.$", line) for line in kept), kept)

    def test_nothing_is_printed_when_there_is_nothing_to_do(self):
        self.assertEqual(self.piped().returncode, 0)
        with open(f"{self.folder}/packaging/dependencies", encoding="utf-8") as file:
            names = [line for line in file.read().splitlines() if line and line[0] not in "#["]
        self.write("bin/dpkg-query", "#!/bin/sh\n" + "".join(f"echo 'ii  {name}'\n" for name in names))
        ran = self.piped(NOTHING_TO_DO="1")
        self.assertEqual(ran.stdout, "worked=0\n")

    def test_a_failed_installation_prints_the_output_of_apt(self):
        ran = self.piped(APT_FAILS="1")
        self.assertNotEqual(ran.returncode, 0)
        self.assertIn("E: no space left on device", ran.stdout)
        self.assertIn("tiller-apt.log", ran.stdout.splitlines()[-1])

    def test_a_failed_build_prints_the_output_of_the_compiler(self):
        ran = self.piped(BUILD_FAILS="1")
        self.assertNotEqual(ran.returncode, 0)
        self.assertIn("arm.cpp:7: error: no such joint", ran.stdout)
        self.assertNotIn("worked", ran.stdout)

    @unittest.skipUnless(shutil.which("ccache"), "There is no ccache")
    def test_a_changed_comment_in_a_header_does_not_break_a_cached_build(self):
        settings = subprocess.run(["bash", "-c", 'source packaging/prepare; echo "$tiller_ccache"'], cwd=self.folder,
                                  text=True, stdout=subprocess.PIPE, check=True).stdout.strip()
        self.write("CMakeLists.txt", PROJECT)
        for version in ("old", "new"):
            self.write("once.h", f"#pragma once\n// A comment of the {version} version.\nstruct Once {{}};\n")
            self.write("cached.cpp", f'#include "once.h"\nOnce {version}Value;\n')
            environment = dict(os.environ, CCACHE_DIR=f"{self.folder}/cache")
            shutil.rmtree(f"{self.folder}/built", ignore_errors=True)
            for command in (["cmake", "-S", ".", "-B", "built", "-G", "Ninja",
                             f"-DCMAKE_CXX_COMPILER_LAUNCHER=env;{settings};ccache"],
                            ["cmake", "--build", "built"]):
                ran = subprocess.run(command, cwd=self.folder, env=environment, text=True, stdout=subprocess.PIPE,
                                     stderr=subprocess.STDOUT, check=False)
                self.assertEqual(ran.returncode, 0, ran.stdout)


if __name__ == "__main__":
    unittest.main()
