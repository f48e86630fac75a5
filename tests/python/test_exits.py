# SPDX-License-Identifier: MIT
"""Programs that exit while the library is in use, each in a separate process, several times (TILLER_EXIT_RUNS, e.g.
100). No program may crash or hang, each must have the expected exit status, and the arm must be at standstill."""
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import numpy as np
import tiller

RUNS = int(os.environ.get("TILLER_EXIT_RUNS", "1"))
HANG = 60.0  # [s]; only a hanging test reaches it
# If the computer is blocked for 100 ms, a motion ends as intended. Such a run does not test the exit.
LATE = ("too late", "LinkLost", "DataStale", "EventLoopStalled", "did not come in time")
ATTEMPTS = 5
CRASHES = ("Fatal Python error", "terminate called", "exception not rethrown", "Segmentation fault", "Aborted")

BEGIN = """
import atexit, multiprocessing, os, signal, sys, threading, time
at_last = []
atexit.register(lambda: [print(*call(), flush=True) for call in at_last])  # after those of the library
import tiller
def connected(in_control=True, **options):
    robot = tiller.Robot(sys.argv[1], timeout=30, **options)
    return robot.take_control(30) if in_control else robot
def turned(q, angle):  # there and back over many runs
    return [q[0] + (angle if q[0] < 0 else -angle), *q[1:]]
def far(robot):
    return turned(robot.state.q, 1.5)
def begin(robot):
    robot.move_j(far(robot), 0.3, 1.0)
    until(lambda: abs(robot.state.qd[0]) > 0.02)
def until(condition):
    end = time.monotonic() + 30
    while not condition():
        if time.monotonic() > end:
            sys.exit("too late")
        time.sleep(0.002)
"""

# name: (program, exit status, output)
CASES = {
    "a_daemon_thread_reads_samples": ("""
robot = connected(False)
seen = []
def read():
    for sample in robot.samples():
        seen.append(sample.sequence)
threading.Thread(target=read, daemon=True).start()
until(lambda: len(seen) > 10)
""", 0, ""),
    "a_daemon_thread_waits_for_a_move": ("""
robot = connected()
threading.Thread(target=lambda: robot.move_j(far(robot), 0.3, 1.0).wait(), daemon=True).start()
until(lambda: abs(robot.state.qd[0]) > 0.02)
""", 0, ""),
    "a_daemon_thread_runs_a_packet_loop": ("""
robot = connected()
seen = []
def turn(cycle):
    seen.append(cycle.cycle)
    return [0.2, 0, 0, 0, 0, 0]
threading.Thread(target=lambda: robot.packet_loop("speed_j", turn), daemon=True).start()
until(lambda: len(seen) > 10)
""", 0, ""),
    "daemon_threads_call_all_the_time": ("""
robot = connected()
def ask():
    while True:
        robot.forward_kinematics(robot.state.q, 30)
for _ in range(3):
    threading.Thread(target=ask, daemon=True).start()
time.sleep(0.1)
""", 0, ""),
    "a_daemon_thread_waits_in_the_compatibility_layer": ("""
import rtde_control, rtde_receive
control = rtde_control.RTDEControlInterface(sys.argv[1])
receive = rtde_receive.RTDEReceiveInterface(sys.argv[1])
q = receive.getActualQ()
threading.Thread(target=lambda: control.moveJ(turned(q, 1.5), 0.3, 1.0), daemon=True).start()
until(lambda: abs(receive.getActualQd()[0]) > 0.02)
""", 0, ""),
    "another_thread_finishes_its_work_first": ("""
robot = connected(False)
def read():
    samples = robot.samples()
    print(len([next(samples) for _ in range(100)]), flush=True)
threading.Thread(target=read).start()
""", 0, "100"),
    "os_exit_while_the_arm_moves": ("""
robot = connected()
begin(robot)
os._exit(3)
""", 3, ""),
    "sys_exit_while_the_arm_moves": ("""
robot = connected()
begin(robot)
sys.exit(3)
""", 3, ""),
    "sys_exit_in_a_callback": ("""
robot = connected()
robot.packet_loop("speed_j", lambda cycle: sys.exit(4) if cycle.cycle > 20 else [0.2, 0, 0, 0, 0, 0])
""", 4, ""),
    "an_exception_in_a_callback": ("""
robot = connected()
def fail(cycle):
    if cycle.cycle > 20:
        1 / 0
    return [0.2, 0, 0, 0, 0, 0]
try:
    robot.packet_loop("speed_j", fail)
except ZeroDivisionError:
    sys.exit(5)
""", 5, ""),
    "a_forked_child_exits_while_the_parent_moves": ("""
robot = connected()
move = robot.move_j(turned(robot.state.q, 0.3), 0.3, 1.0)
samples = robot.samples()
child = os.fork()
if child == 0:
    for use in (lambda: robot.state, robot.take_control, move.wait, lambda: list(samples), move.cancel):
        try:
            use()
        except tiller.errors.NotConnected:
            pass
    sys.exit(0)
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), flush=True)
move.wait(30)
print(move.cause, flush=True)
""", 0, "0\nCompleted"),
    "a_forked_child_leaves_the_blocks_of_its_parent": ("""
with tiller.Simulator() as simulator, tiller.Robot(simulator.address, timeout=30) as robot:
    robot.take_control(30)
    with robot.record(sys.argv[2] + ".csv"), robot.speed_j() as stream:
        child = os.fork()
        if child == 0:
            sys.exit(0)
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    print(status, robot.in_control, flush=True)
""", 0, "0 True"),
    "a_forked_worker_process_connects_itself": ("""
robot = connected()
def work(address):
    with tiller.Robot(address, timeout=30) as own:
        assert own.state.robot_mode == "RUNNING"
worker = multiprocessing.get_context("fork").Process(target=work, args=sys.argv[1:2])
worker.start()
worker.join()
print(worker.exitcode, robot.in_control, flush=True)
""", 0, "0 True"),
    "a_forked_child_of_the_compatibility_layer_exits": ("""
import rtde_control, rtde_receive
control = rtde_control.RTDEControlInterface(sys.argv[1])
receive = rtde_receive.RTDEReceiveInterface(sys.argv[1])
child = os.fork()
if child == 0:
    sys.exit(0)
status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
q = receive.getActualQ()
print(status, control.moveJ(turned(q, 0.1), 0.5, 1.0), receive.isConnected(), flush=True)
""", 0, "0 True True"),
    "exit_handlers_of_the_program_use_the_robot": ("""
robot = connected()
begin(robot)
atexit.register(lambda: print("first", robot.in_control, flush=True))
at_last.append(lambda: ("last", robot.in_control, robot.state.q.shape))
""", 0, "first True\nlast False (6,)"),
    "a_virtual_simulator_runs": ("""
simulator = tiller.Simulator(virtual=True).start()
robot = simulator.robot(timeout=30)
robot.take_control(30)
robot.move_j(far(robot))
seen = []
def read():
    for sample in robot.samples(timeout=30):
        seen.append(sample.sequence)
threading.Thread(target=read, daemon=True).start()
until(lambda: len(seen) > 10)
""", 0, ""),
    "simulators_run_and_are_not_stopped": ("""
simulators = [tiller.Simulator().start(), tiller.Simulator(virtual=True).start()]
robot = tiller.Robot(simulators[0].address, timeout=30)
""", 0, ""),
    "a_simulator_is_started_in_another_thread": ("""
simulators = []
thread = threading.Thread(target=lambda: simulators.append(tiller.Simulator().start()))
robot = connected()
robot.close()
thread.start()
thread.join()
with tiller.Robot(simulators[0].address, timeout=30) as robot:
    print(robot.take_control(30).in_control, flush=True)
""", 0, "True"),
    "a_recording_is_under_way": ("""
robot = connected(False)
recording = robot.record(sys.argv[2], ["actual_q"])
until(lambda: recording.rows > 50)
""", 0, ""),
    "an_uncaught_exception_brakes_although_threads_go_on": ("""
robot = connected()
begin(robot)
def watch():
    until(lambda: not robot.status.moving)
    print("at standstill", flush=True)
threading.Thread(target=watch).start()
sys.stderr = open(os.devnull, "w")
1 / 0
""", 1, "at standstill"),
    "an_uncaught_exception_of_a_thread_brakes": ("""
robot = connected()
begin(robot)
threading.excepthook = lambda arguments, earlier=threading.excepthook: (setattr(sys, "stderr", open(os.devnull, "w")),
                                                                        earlier(arguments))
threading.Thread(target=lambda: 1 / 0).start()
until(lambda: not robot.status.moving)
""", 0, ""),
    "a_notebook_cell_that_fails_brakes": ("""
import builtins, types
hooks = {}
events = types.SimpleNamespace(register=lambda name, call: hooks.update({name: call}))
builtins.get_ipython = lambda: types.SimpleNamespace(events=events)  # as IPython defines it
robot = connected()
begin(robot)
hooks["post_run_cell"](types.SimpleNamespace(success=True))
time.sleep(0.2)
print(robot.status.moving, flush=True)
hooks["post_run_cell"](types.SimpleNamespace(success=False))
until(lambda: not robot.status.moving)
""", 0, "True"),
    "ctrl_c_brakes_a_move_without_its_handle": ("""
robot = connected()
begin(robot)
sys.stderr = open(os.devnull, "w")
os.kill(os.getpid(), signal.SIGINT)
time.sleep(30)
""", -2, ""),
}


def at_standstill(simulator):
    return float(np.abs(simulator.truth.qd).max()) < 1e-3


class TestExits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.simulator = tiller.Simulator().start()

    @classmethod
    def tearDownClass(cls):
        cls.simulator.stop()

    def result_of(self, program):
        """Returns (exit status, output, error output, content of the recording or "")."""
        with tempfile.TemporaryDirectory() as folder:
            recording = os.path.join(folder, "recording.csv")
            process = subprocess.Popen([sys.executable, "-B", "-c", BEGIN + program, self.simulator.address, recording],
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)
            try:
                said, complaint = process.communicate(timeout=HANG)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)  # child processes also keep the pipes open
                said, complaint = process.communicate()
                self.fail(f"hangs\n{said}{complaint}")
            recorded = ""
            if os.path.exists(recording):
                with open(recording, encoding="utf-8") as file:
                    recorded = file.read()
            return process.returncode, said.strip(), complaint, recorded

    def run_once(self, program, status, output):
        for _ in range(ATTEMPTS):
            code, said, complaint, recorded = self.result_of(program)
            for word in CRASHES:
                self.assertNotIn(word, complaint)
            self.assertGreaterEqual(code, -signal.SIGINT, complaint)  # no signal other than SIGINT
            if not any(word in said + complaint for word in LATE):
                break
        self.assertEqual((code, said), (status, output), complaint)
        self.assertNotIn("Traceback", complaint)
        if "another_thread" not in self.id():
            self.assertNotIn("Application", complaint)  # no warnings of Qt
        if recorded:
            self.assertGreater(recorded.count("\n"), 50)
            self.assertTrue(recorded.endswith("\n"))
        end = time.monotonic() + HANG
        while not at_standstill(self.simulator) and time.monotonic() < end:
            time.sleep(0.01)
        q = self.simulator.truth.q
        then = self.simulator.truth.timestamp
        while self.simulator.truth.timestamp < then + 0.1:
            time.sleep(0.01)
        self.assertLess(float(np.abs(self.simulator.truth.q - q).max()), 1e-3)


def test_of(name):
    program, status, output = CASES[name]

    def test(self):
        for run in range(RUNS):
            with self.subTest(run=run):
                self.run_once(program, status, output)

    return test


for case in CASES:
    setattr(TestExits, "test_" + case, test_of(case))


if __name__ == "__main__":
    unittest.main()
