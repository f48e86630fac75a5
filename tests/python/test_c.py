# SPDX-License-Identifier: MIT
"""The C interface, used by a program in C and by ctypes. Like MATLAB and LabVIEW, ctypes uses only the shared library."""
import ctypes
import os
import pathlib
import re
import subprocess
import unittest

from robot import Robot

LIBRARY = os.environ["TILLER_C_LIBRARY"]
PROGRAM = pathlib.Path(os.environ["TILLER_HELPERS"], "tiller_c_program")
HEADER = pathlib.Path(os.environ["TILLER_SOURCE"], "robot/c/tiller_c.h").read_text(encoding="utf-8")
TIMEOUT = 120  # [s]; only a hanging test reaches it
ATTEMPTS = 5


class TestC(unittest.TestCase):
    def test_a_program_in_c_uses_every_function(self):
        source = pathlib.Path(os.environ["TILLER_SOURCE"], "tests/integration/c/c_program.c").read_text(encoding="utf-8")
        for function in set(re.findall(r"^TILLER_C_API .*?(\w+)\(", HEADER, re.M)):
            self.assertIn(function, source)
        for attempt in range(ATTEMPTS):
            robot = Robot("real")
            try:
                done = subprocess.run([PROGRAM, robot.host], capture_output=True, text=True, timeout=TIMEOUT)
            finally:
                robot.close()
            late = re.search("LinkLost|DataStale|no data", done.stderr)  # this computer was blocked for 100 ms
            if done.returncode == 0 or not late:
                break
        self.assertEqual((done.returncode, done.stdout.strip()), (0, "done"), done.stderr)

    def test_ctypes_reads_with_the_library_alone(self):
        library = ctypes.CDLL(LIBRARY)
        library.tiller_last_error.restype = ctypes.c_char_p
        library.tiller_connect.argtypes = [ctypes.c_char_p, ctypes.c_double, ctypes.POINTER(ctypes.c_void_p)]
        library.tiller_read.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_double), ctypes.c_int,
                                        ctypes.POINTER(ctypes.c_int)]
        library.tiller_close.argtypes = [ctypes.c_void_p]
        robot = Robot("real")
        handle = ctypes.c_void_p()
        try:
            self.assertEqual(library.tiller_connect(robot.host.encode(), 30.0, ctypes.byref(handle)), 0,
                             library.tiller_last_error())
            values, count = (ctypes.c_double * 6)(), ctypes.c_int()
            self.assertEqual(library.tiller_read(handle, b"actual_TCP_pose", values, 6, ctypes.byref(count)), 0)
            self.assertEqual(count.value, 6)
            self.assertGreater(abs(values[0]) + abs(values[1]), 0.1)
        finally:
            library.tiller_close(handle)
            robot.close()

    def test_only_the_interface_is_exported(self):
        """Programs may load other versions of the same C++ libraries."""
        symbols = subprocess.run(["nm", "-D", "--defined-only", "--format=just-symbols", LIBRARY], capture_output=True,
                                 text=True, check=True).stdout.split()
        declared = set(re.findall(r"^TILLER_C_API .*?(\w+)\(", HEADER, re.M))
        self.assertGreater(len(declared), 10)
        self.assertEqual({symbol for symbol in symbols if symbol.startswith("tiller_")}, declared)
        self.assertEqual([symbol for symbol in symbols if "tiller" in symbol and symbol not in declared], [])

    def test_the_error_numbers_are_stable(self):
        numbers = dict(re.findall(r"^    TILLER_(\w+) = (\d+)", HEADER, re.M))
        self.assertEqual(list(map(int, numbers.values())), list(range(27)))
        self.assertEqual((numbers["TIMEOUT"], numbers["STOPPED"], numbers["INTERNAL"]), ("5", "19", "26"))


if __name__ == "__main__":
    unittest.main()
