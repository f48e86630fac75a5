# SPDX-License-Identifier: MIT
"""The wheel holds what it says, and works where it is unpacked."""
import base64
import glob
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest
import zipfile

MODULES = {"rtde_control": "RTDEControlInterface", "rtde_receive": "RTDEReceiveInterface", "rtde_io": "RTDEIOInterface",
           "dashboard_client": "DashboardClient", "script_client": "ScriptClient", "robotiq_gripper": "RobotiqGripper"}
MINE = """
import pytest
import tiller


def test_it_moves(tiller_robot):
    q = tiller_robot.state.q + [0.2, 0, 0, 0, 0, 0]
    tiller_robot.move_j(q).wait()
    assert abs(tiller_robot.state.q - q).max() < 1e-3


def test_it_stops(tiller_robot, tiller_simulator):
    move = tiller_robot.move_j(tiller_robot.state.q + [1.0, 0, 0, 0, 0, 0])
    tiller_simulator.step(0.3)
    tiller_simulator.fault("protective-stop")
    with pytest.raises(tiller.Error):
        move.wait()
"""


class TestWheel(unittest.TestCase):
    def setUp(self):
        wheels = glob.glob(os.path.join(os.environ["TILLER_WHEELS"], "*.whl"))
        self.assertEqual(len(wheels), 1)
        self.wheel = zipfile.ZipFile(wheels[0])

    def tearDown(self):
        self.wheel.close()

    def test_the_record_is_right(self):
        record = [name for name in self.wheel.namelist() if name.endswith("/RECORD")][0]
        listed = {}
        for line in self.wheel.read(record).decode().splitlines():
            name, digest, _ = line.rsplit(",", 2)
            listed[name] = digest
        self.assertEqual(sorted(listed), sorted(self.wheel.namelist()))
        for name, digest in listed.items():
            if name != record:
                actual = base64.urlsafe_b64encode(hashlib.sha256(self.wheel.read(name)).digest()).rstrip(b"=")
                self.assertEqual(digest, "sha256=" + actual.decode())

    def test_modules_and_stubs_work_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            self.wheel.extractall(folder)
            for module, name in MODULES.items():
                code = f"import {module}; assert {module}.__file__.startswith({folder!r}); {module}.{name}"
                environment = dict(os.environ, PYTHONPATH=folder)
                subprocess.run([sys.executable, "-B", "-c", code], check=True, env=environment)
                with open(os.path.join(folder, module + ".pyi"), encoding="utf-8") as stub:
                    text = stub.read()
                compile(text, module + ".pyi", "exec")
                self.assertIn(f"class {name}:", text)
            with open(os.path.join(folder, "rtde_control.pyi"), encoding="utf-8") as stub:
                self.assertIn("def moveJ(self, q: _Floats, speed: float = 1.05", stub.read())
            code = f"import tiller; assert tiller.__file__.startswith({folder!r}); tiller.Kinematics('UR5e')"
            subprocess.run([sys.executable, "-B", "-c", code], check=True, env=environment)
            self.assertTrue(os.path.exists(os.path.join(folder, "tiller", "py.typed")))
            self.assertTrue(os.path.exists(os.path.join(folder, "rtde_control-stubs", "__init__.pyi")))

    def test_pytest_finds_the_fixtures(self):
        """By the entry point alone, as after an installation: a program of somebody else's that is tested with them."""
        with tempfile.TemporaryDirectory() as folder:
            self.wheel.extractall(folder)
            tests = os.path.join(folder, "test_mine.py")
            with open(tests, "w", encoding="utf-8") as file:
                file.write(MINE)
            result = subprocess.run([sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", tests], text=True,
                                    env=dict(os.environ, PYTHONPATH=folder), capture_output=True, check=False)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("2 passed", result.stdout)


if __name__ == "__main__":
    unittest.main()
