# SPDX-License-Identifier: MIT
"""Type checkers must accept the stubs, the package, and a program that uses both. Checkers that are not installed are
skipped."""
import ast
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

MODULES = ("rtde_control", "rtde_receive", "rtde_io", "dashboard_client", "script_client", "robotiq_gripper")
EXAMPLES = os.path.join(os.environ["TILLER_SOURCE"], "robot", "examples", "python")
PROGRAM = '''
from __future__ import annotations

import numpy as np
import tiller
from dashboard_client import DashboardClient
from rtde_control import Path, PathEntry, RTDEControlInterface
from rtde_receive import RTDEReceiveInterface
from rtde_io import RTDEIOInterface

flags = RTDEControlInterface.FLAG_UPLOAD_SCRIPT | RTDEControlInterface.FLAG_VERBOSE
with RTDEControlInterface("127.0.0.1", 500.0, flags) as control, RTDEReceiveInterface("127.0.0.1") as receive:
    q: list[float] = receive.getActualQ()
    ok: bool = control.moveJ(np.array(q) + 0.1, speed=0.5)
    control.moveJ([q + [1.0, 1.4, 0.0]], asynchronous=True)
    control.moveL((0.1, 0.2, 0.3, 0.0, 3.1, 0.0), acceleration=0.5)
    control.jogStart([0.0] * 6, RTDEControlInterface.FEATURE_TOOL)
    path = Path()
    path.addEntry(PathEntry(PathEntry.MoveJ, PathEntry.PositionJoints, [0.0] * 9))
    name: str = repr(RTDEIOInterface("127.0.0.1"))
    DashboardClient("127.0.0.1").connect()
with tiller.Simulator(virtual=True) as simulator, simulator.robot() as robot:
    pose = robot.state.tcp_pose + 0.0
    robot.take_control().move_l(pose).wait(timeout=5.0)
    for sample in robot.samples():
        print(sample.q.mean(), sample.time + 1.0)


def target(cycle: tiller.Cycle) -> list[float] | None:
    return None if cycle.time > 1.0 else [0.1 * cycle.q[0], *cycle.packet.tcp_force[1:]]


async def watch(robot: tiller.Robot) -> tiller.SafetyMode:
    async for sample in robot.samples():
        if sample.robot_mode is tiller.RobotMode.IDLE:
            break
    loss: tiller.ControlLoss = robot.status.loss
    report = robot.packet_loop("speed_j", target)
    print(loss.value, report.cycles + robot.link.packets)
    return (await robot.until(lambda sample: sample.digital_input(1))).safety_mode
'''
WRONG = '''
import tiller
from rtde_control import RTDEControlInterface

RTDEControlInterface(7)
RTDEControlInterface("127.0.0.1").moveJ("up")
tiller.Kinematics("UR5e").forward(None)
tiller.Robot("127.0.0.1").jog([0.0] * 6, frame="bse")
tiller.Robot("127.0.0.1").packet_loop("servoj", lambda cycle: cycle.q)
print(tiller.Robot("127.0.0.1").status["moving"])
'''


def yield_to_others():
    """Lowers the priority, because other tests that run in parallel measure time."""
    os.nice(10)


class TestTypes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # mypy reads numpy and its own stubs once for each set of options.
        cls.caches = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.caches.cleanup)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.modules = os.environ["TILLER_PYTHON"]

    def write(self, text):
        path = os.path.join(self.folder.name, "program.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_checker(self, command, cache=""):
        result = subprocess.run(command, cwd=self.folder.name, text=True, capture_output=True, check=False,
                                preexec_fn=yield_to_others,
                                env=dict(os.environ, MYPYPATH=self.modules,
                                         MYPY_CACHE_DIR=os.path.join(self.caches.name, cache)))
        return result.returncode, result.stdout + result.stderr

    def mypy(self, *what, options=()):
        if subprocess.run([sys.executable, "-m", "mypy", "--version"], capture_output=True, check=False).returncode != 0:
            self.skipTest("mypy is not installed (Debian: mypy)")
        return self.run_checker([sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", *options, *what],
                                "_".join(options) or "strict")

    def pyright(self):
        """Checks all files of the folder after the stubs, the package and the examples were copied to it."""
        own = os.path.join(os.environ["TILLER_SOURCE"], "build", "npm", "node_modules", ".bin")
        checker = shutil.which("pyright", path=own + os.pathsep + os.environ["PATH"])
        if checker is None:
            self.skipTest("pyright is not installed (packaging/test takes it from npm)")
        for stub in self.stubs():
            shutil.copy(stub, self.folder.name)
        shutil.copytree(os.path.join(self.modules, "tiller"), os.path.join(self.folder.name, "tiller"))
        shutil.copytree(EXAMPLES, os.path.join(self.folder.name, "examples"))
        with open(os.path.join(self.folder.name, "pyrightconfig.json"), "w", encoding="utf-8") as file:
            file.write('{"extraPaths": ["."], "reportMissingModuleSource": false, "pythonVersion": "3.11"}')
        return self.run_checker([checker, "--pythonpath", sys.executable])

    def stubs(self):
        return [os.path.join(self.modules, module + ".pyi") for module in MODULES]

    def test_mypy_agrees(self):
        code, text = self.mypy(*self.stubs(), os.path.join(self.modules, "tiller"), self.write(PROGRAM))
        self.assertEqual(code, 0, text)

    def test_mypy_agrees_with_the_examples(self):
        for name in sorted(os.listdir(EXAMPLES)):
            with self.subTest(name):
                code, text = self.mypy(os.path.join(EXAMPLES, name),
                                       options=("--allow-untyped-defs", "--allow-untyped-calls"))
                self.assertEqual(code, 0, text)

    def test_mypy_finds_type_errors(self):
        code, text = self.mypy(self.write(WRONG))
        self.assertNotEqual(code, 0)
        self.assertIn("Found 6 errors", text)

    def test_pyright_agrees(self):
        self.write(PROGRAM)
        code, text = self.pyright()
        self.assertEqual(code, 0, text)

    def test_pyright_finds_type_errors(self):
        self.write(WRONG)
        code, text = self.pyright()
        self.assertNotEqual(code, 0)
        for line in range(5, 11):
            self.assertIn(f"program.py:{line}:", text)

    def test_the_stub_of_the_native_module_is_complete(self):
        from tiller import _native

        with open(os.path.join(self.modules, "tiller", "_native.pyi"), encoding="utf-8") as file:
            stub = ast.parse(file.read())
        classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}

        def methods(name):
            own = {node.name for node in classes[name].body if isinstance(node, ast.FunctionDef)}
            return own.union(*(methods(base.id) for base in classes[name].bases))

        public = {name: member for name, member in vars(_native).items() if not name.startswith("_")}
        types = {name for name, member in public.items() if isinstance(member, type)}
        self.assertEqual({name for name in classes if not name.startswith("_")}, types)
        self.assertEqual({node.name for node in stub.body if isinstance(node, ast.FunctionDef)}, set(public) - types)
        for name in types:
            with self.subTest(name):
                actual = {method for method in dir(public[name]) if not method.startswith("_")}
                self.assertEqual(methods(name) - {"__init__"}, actual)

    def test_packages_declare_that_they_are_typed(self):
        self.assertTrue(os.path.exists(os.path.join(self.modules, "tiller", "py.typed")))


if __name__ == "__main__":
    unittest.main()
