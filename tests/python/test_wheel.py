# SPDX-License-Identifier: MIT
"""The wheels contain the files listed in their metadata, and work where they are unpacked without any system library
except the C++ runtime."""
import base64
import glob
import hashlib
import os
import re
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


SIMULATED = """
import socket


def test_it_serves(simulated_controller):
    with socket.create_connection((simulated_controller.address, simulated_controller.ports["dashboard"])) as peer:
        assert peer.recv(100).startswith(b"Connected: Universal Robots Dashboard Server")
    assert simulated_controller.fault("protective-stop")
"""
SYSTEM = re.compile(r"linux-vdso|ld-linux|statically linked|lib(c|m|dl|rt|util|pthread|resolv|gcc_s|stdc\+\+)\.so")


def unpacked(wheel, folder):
    """Unpacks the wheel with file modes, as pip does."""
    for entry in wheel.infolist():
        path = wheel.extract(entry, folder)
        os.chmod(path, entry.external_attr >> 16 & 0o777)


def run_pytest(folder, text):
    tests = os.path.join(folder, "test_mine.py")
    with open(tests, "w", encoding="utf-8") as file:
        file.write(text)
    return subprocess.run([sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", tests], text=True,
                          env=dict(os.environ, PYTHONPATH=folder), capture_output=True, check=False)


class TestWheel(unittest.TestCase):
    def setUp(self):
        self.wheels = {}
        for path in glob.glob(os.path.join(os.environ["TILLER_WHEELS"], "*.whl")):
            self.wheels[os.path.basename(path).split("-")[0]] = zipfile.ZipFile(path)
        self.assertEqual(set(self.wheels), {"tiller", "tiller_simulator"})
        self.wheel = self.wheels["tiller"]

    def tearDown(self):
        for wheel in self.wheels.values():
            wheel.close()

    def test_the_record_file_is_correct(self):
        for wheel in self.wheels.values():
            record = [name for name in wheel.namelist() if name.endswith("/RECORD")][0]
            listed = {}
            for line in wheel.read(record).decode().splitlines():
                name, digest, _ = line.rsplit(",", 2)
                listed[name] = digest
            self.assertEqual(sorted(listed), sorted(wheel.namelist()))
            for name, digest in listed.items():
                if name != record:
                    actual = base64.urlsafe_b64encode(hashlib.sha256(wheel.read(name)).digest()).rstrip(b"=")
                    self.assertEqual(digest, "sha256=" + actual.decode())

    def test_the_wheels_contain_every_loaded_library(self):
        for wheel in self.wheels.values():
            glibc = re.search(r"manylinux_2_(\d+)_", wheel.filename)
            self.assertTrue(glibc, wheel.filename)
            with tempfile.TemporaryDirectory() as folder:
                unpacked(wheel, folder)
                for path in glob.glob(folder + "/**/*", recursive=True):
                    with open(path, "rb") if os.path.isfile(path) else open(os.devnull, "rb") as file:
                        if file.read(4) != b"\x7fELF":
                            continue
                    loaded = subprocess.run(["ldd", path], capture_output=True, text=True, check=True).stdout
                    for line in loaded.splitlines():
                        self.assertTrue(SYSTEM.search(line) or f"=> {folder}/" in os.path.normpath(line), f"{path}: {line}")
                    symbols = subprocess.run(["objdump", "-T", path], capture_output=True, text=True, check=True).stdout
                    wanted = [int(minor) for minor in re.findall(r"\bGLIBC_2\.(\d+)\b", symbols)]
                    self.assertLessEqual(max(wanted, default=0), int(glibc[1]), path)

    def test_every_library_has_its_licence(self):
        for name, wheel in self.wheels.items():
            paths = wheel.namelist()
            info = [path for path in paths if path.endswith("/RECORD")][0].replace("/RECORD", "/licenses")
            with open(os.path.join(os.environ["TILLER_SOURCE"], "app/LICENSE"), "rb") as file:
                self.assertEqual(wheel.read(info + "/app/LICENSE"), file.read())
            self.assertIn(info + "/robot/LICENSE", paths)
            listed = dict(re.findall(r"^(\S+)  (\S+) \S+$", wheel.read(info + "/libraries/LIST").decode(), re.MULTILINE))
            carried = {os.path.basename(path) for path in paths if path.startswith(name + ".libs/")}
            self.assertIn("libQt6Core-tiller.so.6", carried)
            self.assertEqual(set(listed), carried)
            for package in set(listed.values()):
                text = wheel.read(f"{info}/libraries/{package}.txt").decode(errors="replace")
                for common in re.findall(r"/usr/share/common-licenses/([\w.+-]*\w)", text):
                    if os.path.exists("/usr/share/common-licenses/" + common):
                        self.assertIn(f"{info}/libraries/common-licenses/{common}", paths, package)
            lesser = wheel.read(info + "/libraries/common-licenses/LGPL-3").decode()
            self.assertIn("GNU LESSER GENERAL PUBLIC LICENSE", lesser)

    def test_the_simulator_alone_serves_any_client(self):
        with tempfile.TemporaryDirectory() as folder:
            unpacked(self.wheels["tiller_simulator"], folder)
            result = run_pytest(folder, SIMULATED)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("1 passed", result.stdout)

    def test_the_package_runs_the_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            unpacked(self.wheel, folder)
            for words in (["--version"], ["simulate", "--help"], ["doctor", "--help"]):
                result = subprocess.run([sys.executable, "-B", "-m", "tiller", *words], capture_output=True, text=True,
                                        env=dict(os.environ, PYTHONPATH=folder, PATH="/nowhere"), check=True)
                self.assertIn("tiller-cli", result.stdout)

    def test_modules_and_stubs_work_unpacked(self):
        with tempfile.TemporaryDirectory() as folder:
            unpacked(self.wheel, folder)
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
        """Runs tests of a user that need the fixtures. As after an installation, pytest finds the fixtures only
        through the entry point."""
        with tempfile.TemporaryDirectory() as folder:
            unpacked(self.wheel, folder)
            result = run_pytest(folder, MINE)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn("2 passed", result.stdout)


if __name__ == "__main__":
    unittest.main()
