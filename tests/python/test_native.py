# SPDX-License-Identifier: MIT
"""The package `tiller` against the simulated controller in this process, in virtual time but where a process is killed."""
import asyncio
import contextlib
import gc
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np
import tiller
from tiller import errors

PATIENCE = 60.0  # for hangs only
FAR = [1.5, 0, 0, 0, 0, 0]


def stands(simulator):
    return float(np.abs(simulator.truth["qd"]).max()) < 1e-3


def until(condition):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.005)
    return True


class VirtualCase(unittest.TestCase):
    software = ""  # the simulator's own

    def setUp(self):
        self.simulator = tiller.Simulator(virtual=True, software=self.software).start()
        self.addCleanup(self.simulator.stop)
        self.robot = self.simulator.robot(timeout=PATIENCE)
        self.addCleanup(self.robot.close)

    def take_control(self):
        self.robot.take_control(PATIENCE)

    def assert_brakes(self):
        """Within the contract's 250 ms of the robot's own time, and stays."""
        self.simulator.step(0.25)
        self.assertTrue(stands(self.simulator))
        q = self.simulator.truth["q"]
        self.simulator.step(0.5)
        self.assertLess(float(np.abs(self.simulator.truth["q"] - q).max()), 1e-3)


class TestReceive(VirtualCase):
    def test_samples_are_arrays_with_names(self):
        sample = self.robot.state
        self.assertEqual(sample.q.shape, (6,))
        self.assertLess(float(np.abs(sample.q - self.simulator.truth["q"]).max()), 1e-3)
        self.assertEqual(sample.robot_mode, "RUNNING")
        self.assertEqual(sample.safety_mode, "NORMAL")
        self.assertIsInstance(sample["timestamp"], float)
        self.assertIs(sample.digital_input(3), False)
        with self.assertRaisesRegex(KeyError, "is not followed"):
            sample["no_such_field"]
        q, pose = self.robot.snapshot("actual_q", "actual_TCP_pose")
        self.assertEqual((len(q), len(pose)), (6, 6))

    def test_no_data_is_never_a_number(self):
        few = self.simulator.robot(fields=["timestamp"], timeout=PATIENCE)
        self.addCleanup(few.close)
        self.assertTrue(np.isnan(few.state.q).all())
        self.assertTrue(math.isnan(few.state.speed_slider))
        self.assertIsNone(few.state.digital_input(0))
        self.assertEqual(few.state.robot_mode, "DISCONNECTED")
        self.take_control()
        with self.assertRaises(errors.InvalidArgument):
            self.robot.move_j(few.state.q + 0.1)

    def test_every_packet_comes_once(self):
        samples = self.robot.samples(timeout=PATIENCE)
        self.simulator.step(1.0)
        numbers = [next(samples).sequence for _ in range(500)]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + 500)))
        self.assertEqual(samples.lost, 0)
        self.assertGreater(next(samples).sequence, numbers[-1])  # waits: time goes on meanwhile
        self.robot.close()
        self.assertLess(len(list(samples)), 500)  # ends

    def test_misspelt_names_are_refused(self):
        with self.assertRaisesRegex(errors.FieldUnknown, 'did you mean "actual_q"'):
            self.simulator.robot(fields=["actual_qq"])
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(errors.FieldUnknown, "actual_qq"):
                self.robot.record(os.path.join(folder, "a.csv"), ["actual_qq"])
            self.assertEqual(os.listdir(folder), [])

    def test_recordings_become_frames(self):
        try:
            import pandas  # noqa: F401
        except ImportError:
            self.skipTest("pandas is not installed")
        with tempfile.TemporaryDirectory() as folder:
            with self.robot.record(os.path.join(folder, "a.csv"), ["actual_q"]) as recording:
                self.simulator.step(0.2)
            frame = recording.frame()
            self.assertGreaterEqual(len(frame), 100)
            self.assertIn("actual_q_5", frame.columns)
            self.assertEqual(int(frame.packages_lost.sum()), 0)


class TestErrors(unittest.TestCase):
    def test_nobody_there_is_said(self):
        with self.assertRaises(errors.ConnectionRefused) as caught:
            tiller.Robot("127.0.0.1", timeout=0.5, port_offset=17)
        self.assertEqual(caught.exception.code, "ConnectionRefused")
        self.assertIsInstance(caught.exception, ConnectionError)
        self.assertIsInstance(caught.exception, tiller.Error)
        self.assertIn("30021", str(caught.exception))

    def test_every_code_has_its_class(self):
        codes = [cls.code for cls in tiller.Error.__subclasses__()]
        self.assertEqual(len(codes), len(set(codes)))
        self.assertIs(errors.error_type("LinkLost"), errors.LinkLost)
        self.assertIs(errors.error_type("what is this"), errors.Internal)


class TestMotion(VirtualCase):
    def setUp(self):
        super().setUp()
        self.take_control()

    def begin(self):
        """A move under way."""
        move = self.robot.move_j(self.robot.state.q + FAR, 0.5, 1.0)
        self.simulator.step(0.5)
        self.assertFalse(stands(self.simulator))
        return move

    def test_moves_are_waited_for(self):
        target = self.robot.state.q + [0, 0, 0, 0, 0, 0.3]
        move = self.robot.move_j(target)
        self.assertTrue(move.active)
        move.wait(PATIENCE)
        self.assertEqual(move.cause, "Completed")
        self.assertEqual(move.progress.fraction, 1.0)
        self.assertLess(float(np.abs(self.simulator.truth["q"] - target).max()), 1e-3)
        pose = self.robot.state.tcp_pose
        pose[2] += 0.05
        self.robot.move_l(pose, 0.1).wait(PATIENCE)
        self.assertLess(float(np.abs(self.simulator.truth["tcp_pose"][:3] - pose[:3]).max()), 1e-3)
        pose[2] -= 0.05
        self.robot.move_j_to_pose(pose).wait(PATIENCE)
        path = [tiller.PathMove(self.robot.state.q + [0, 0, 0, 0, 0, x]) for x in (0.1, 0.2)]
        self.robot.move_path(path, PATIENCE).wait(PATIENCE)

    def test_silence_has_bounds(self):
        for silence in (0.05, 4.5, float("nan"), -1.0):
            with self.subTest(silence), self.assertRaisesRegex(errors.Error, "silence"):
                self.robot.move_j(self.robot.state.q, silence=silence)

    def test_moves_are_awaited(self):
        async def both():
            await self.robot.move_j(self.robot.state.q + [0, 0, 0, 0, 0, 0.2])
            with self.assertRaises(asyncio.CancelledError):
                task = asyncio.ensure_future(self.wait_for(self.begin()))
                await asyncio.sleep(0.01)
                task.cancel()
                await task

        asyncio.run(both())
        self.assert_brakes()

    @staticmethod
    async def wait_for(move):
        await move

    def test_wrong_targets_are_refused_by_name(self):
        for target in ([0] * 5, ["a"] * 6, [math.nan] * 6, [90.0] * 6):
            with self.assertRaises((errors.InvalidArgument, errors.LimitExceeded)):
                self.robot.move_j(target)

    def test_cancel_brakes(self):
        move = self.begin()
        self.assertTrue(move.cancel())
        self.assert_brakes()
        with self.assertRaises(errors.Stopped):
            move.wait(PATIENCE)
        self.assertFalse(move.cancel())

    def test_stop_brakes(self):
        move = self.begin()
        self.robot.stop()
        self.assert_brakes()
        self.assertFalse(move.active)

    def test_a_lost_handle_brakes(self):
        move = self.begin()
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            del move
            gc.collect()
        self.assertTrue(any(issubclass(one.category, ResourceWarning) for one in said))
        self.assert_brakes()

    def test_ctrl_c_in_wait_brakes(self):
        move = self.begin()
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        move._waiting = contextlib.nullcontext  # time stands still, so the move cannot come to its end
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            move.wait(PATIENCE)
        self.assert_brakes()

    def test_the_plan_says_how_long_and_what_slows_it_down(self):
        slow = self.robot.move_j(self.robot.state.q + FAR, 0.2, 1.0)
        self.assertEqual((slow.plan.limiter, slow.plan.scale), ("None", 1.0))
        self.assertGreater(slow.plan.duration, 1.0)
        fast = self.robot.move_j(self.robot.state.q + FAR, 3.0, 10.0)
        self.assertNotEqual(fast.plan.limiter, "None")
        self.assertLess(fast.plan.scale, 0.9)
        self.assertAlmostEqual(fast.plan.speed, 3.0 * fast.plan.scale)
        self.assertIsNone(self.robot._controller.stop_j(2.0).plan())

    def test_waiting_lets_other_threads_run(self):
        counted = []
        ended = threading.Event()

        def count():
            while not ended.is_set():
                counted.append(1)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        move = self.begin()
        thread.start()
        with self.assertRaises(errors.Timeout):
            move._native.wait(0.3)
        ended.set()
        thread.join()
        self.assertGreater(len(counted), 5)
        self.assertTrue(move.active)
        move.cancel()

    def test_streams_end_with_their_block(self):
        with self.assertRaises(ZeroDivisionError), self.robot.speed_l() as stream:
            for _ in range(20):
                stream.send([0, 0, 0.05, 0, 0, 0])
                self.simulator.step(0.02)
            self.assertFalse(stands(self.simulator))
            1 / 0
        self.assert_brakes()
        with self.assertRaises(errors.Stopped):
            stream.send([0, 0, 0.05, 0, 0, 0])

    def test_streams_that_fall_silent_end(self):
        stream = self.robot.speed_j()
        stream.send([0.2, 0, 0, 0, 0, 0])
        self.simulator.step(0.09)
        self.assertTrue(stream.active)
        self.simulator.step(0.3)
        self.assertFalse(stream.active)
        self.assert_brakes()

    def test_jogs_need_refreshing(self):
        with self.robot.jog([0, 0, 0.05, 0, 0, 0]) as jog:
            for _ in range(20):
                self.assertTrue(jog.refresh())
                self.simulator.step(0.02)
            self.assertFalse(stands(self.simulator))
            self.assertTrue(jog.refresh([0, 0, -0.05, 0, 0, 0]))
            self.simulator.step(0.5)
            self.assertFalse(jog.refresh())
        self.assert_brakes()
        jog = self.robot.jog([0.1, 0, 0, 0, 0, 0], "joints")
        self.simulator.step(0.05)
        del jog
        gc.collect()
        self.assert_brakes()

    def test_an_exception_in_a_jog_callback_brakes(self):
        calls = []

        def callback(sample):
            calls.append(sample.sequence)
            if len(calls) == 2:  # the first one after the jog has begun
                raise ValueError("mine")
            return [0, 0, 0.02, 0, 0, 0]

        with self.assertRaisesRegex(ValueError, "mine"):
            self.robot.jog_while(callback)
        self.assert_brakes()

    def test_packet_loops_call_back(self):
        q = self.robot.state.q
        seen = []

        def circle(cycle):
            seen.append(cycle["cycle"])
            if cycle["time"] > 1.0:
                return None
            return q + [0, 0, 0, 0, 0, 0.05 * math.sin(cycle["time"])]

        report = self.robot.packet_loop("servo_j", circle, timeout=PATIENCE)
        self.assertEqual(report.cycles, len(seen))
        self.assertGreater(report.cycles, 400)
        self.assert_brakes()

    def test_an_exception_in_a_packet_loop_brakes(self):
        def callback(cycle):
            if cycle["time"] > 0.3:
                raise ValueError("mine")
            return [0.3, 0, 0, 0, 0, 0]

        with self.assertRaisesRegex(ValueError, "mine"):
            self.robot.packet_loop("speed_j", callback, timeout=PATIENCE)
        self.assert_brakes()
        with self.assertRaisesRegex(errors.InvalidArgument, "callback"):
            self.robot.packet_loop("speed_j", lambda cycle: [1, 2], timeout=PATIENCE)

    def test_questions_settings_functions(self):
        pose = self.robot.forward_kinematics(self.robot.state.q, PATIENCE)
        near = self.robot.inverse_kinematics(pose, self.robot.state.q, PATIENCE)
        self.assertLess(float(np.abs(near - self.robot.state.q).max()), 1e-3)
        self.robot.set_payload(0.5, [0, 0, 0.02], PATIENCE)
        self.robot.set_tcp([0, 0, 0.1, 0, 0, 0], PATIENCE)
        self.robot.run_function("set_standard_digital_out(2, True)\nsync()", timeout=PATIENCE).wait(PATIENCE)
        self.assertTrue(self.simulator.truth["digital_outputs"] & 4)
        with self.assertRaises(errors.ScriptError):
            self.robot.run_function("b = = 2", timeout=PATIENCE)


class TestTorque(VirtualCase):
    software = "5.25.1"

    def setUp(self):
        super().setUp()
        self.take_control()

    def test_torques_move_the_arm_and_end_with_their_block(self):
        q = self.robot.state.q
        with self.robot.torque(coulomb_scale=[0.8] * 6) as stream:
            for _ in range(30):
                stream.send([8, 0, 0, 0, 0, 0])
                self.simulator.step(0.004)
            self.assertGreater(self.simulator.truth["qd"][0], 0.05)
            self.assertTrue(stream.active)
        self.assert_brakes()
        self.assertGreater(self.simulator.truth["q"][0], q[0])
        self.assertEqual(stream.cause, "ApiCall")

    def test_torques_end_at_the_speed_cap(self):
        stream = self.robot.torque()
        with self.assertRaises(errors.Stopped):
            for _ in range(500):
                stream.send([25, 0, 0, 0, 0, 0])
                self.simulator.step(0.002)
        self.assertEqual(stream.cause, "LimitReached")
        self.assert_brakes()

    def test_wrong_torques_are_refused(self):
        stream = self.robot.torque()
        with self.assertRaisesRegex(errors.LimitExceeded, "Wrist 1"):
            stream.send([0, 0, 0, 30, 0, 0])
        with self.assertRaises(errors.InvalidArgument):
            stream.send([0, math.nan, 0, 0, 0, 0])
        with self.assertRaisesRegex(errors.LimitExceeded, "viscousScale"):
            self.robot.torque([2, 0, 0, 0, 0, 0])
        stream.stop()

    def test_packet_loops_give_torques(self):
        def steady(cycle):
            return None if cycle["time"] > 0.3 else [40 * (0.2 - cycle["qd"][0]), 0, 0, 0, 0, 0]

        q = self.robot.state.q
        self.robot.packet_loop("torque", steady, timeout=PATIENCE)
        self.assert_brakes()
        self.assertGreater(self.simulator.truth["q"][0] - q[0], 0.01)


class TestNoTorque(VirtualCase):
    software = "5.24.0"

    def test_older_software_is_named(self):
        self.take_control()
        with self.assertRaisesRegex(errors.VersionUnsupported, r"5\.24\.0.*5\.25\.1.*10\.12\.1"):
            self.robot.torque()
        self.assertTrue(stands(self.simulator))


class TestServices(VirtualCase):
    def test_outputs_are_confirmed(self):
        self.robot.outputs.set_digital(3, True, PATIENCE)
        self.assertTrue(self.simulator.truth["digital_outputs"] & 8)
        self.robot.outputs.set_speed_slider(0.5, PATIENCE)
        self.assertEqual(self.simulator.truth["speed_slider"], 0.5)

    def test_recovery_needs_consent(self):
        self.simulator.fault("protective-stop")
        self.simulator.step(0.1)
        self.assertEqual(self.robot.state.safety_mode, "PROTECTIVE_STOP")
        with self.assertRaises(errors.Rejected):
            self.robot.recover(tiller.Consent(), PATIENCE)
        self.simulator.step(0.1)
        self.assertEqual(self.robot.state.safety_mode, "PROTECTIVE_STOP")
        steps = []
        self.robot.recover(tiller.Consent(cause_inspected=True, power_on=True, release_brakes=True), PATIENCE, steps.append)
        self.assertIn("Unlock", steps)
        self.simulator.step(0.1)
        self.assertEqual(self.robot.state.safety_mode, "NORMAL")


class TestWithoutARobot(unittest.TestCase):
    def test_kinematics(self):
        arm = tiller.Kinematics("ur5e", tcp=[0, 0, 0.1, 0, 0, 0])
        q = np.array([0.1, -1.2, 1.3, -0.4, 0.5, 0.6])
        pose = arm.forward(q)
        self.assertLess(float(np.abs(arm.inverse_nearest(pose, q) - q).max()), 1e-6)
        self.assertTrue(any(np.abs(one - q).max() < 1e-6 for one in arm.inverse(pose)))
        step = 1e-6
        numeric = (arm.forward(q + [step, 0, 0, 0, 0, 0])[:3] - pose[:3]) / step
        self.assertLess(float(np.abs(arm.jacobian(q)[:3, 0] - numeric).max()), 1e-4)
        with self.assertRaises(errors.NoSolution):
            arm.inverse_nearest([9, 0, 0, 0, 0, 0], q)
        with self.assertRaises(errors.InvalidArgument):
            tiller.Kinematics("UR5000")
        self.assertIn("UR5e", tiller.kinematics.models())
        back = tiller.kinematics.pose_product(pose, tiller.kinematics.pose_inverse(pose))
        self.assertLess(float(np.abs(back).max()), 1e-9)

    def test_the_doctor_examines(self):
        with tiller.Simulator() as simulator:
            report = tiller.examine(simulator.address, timeout=PATIENCE)
        self.assertEqual(len(report), 19)
        self.assertEqual({finding.condition: finding.verdict for finding in report}["protocol"], "good")
        self.assertIn("good", str(report))

    def test_everything_shows_itself(self):
        with tiller.Simulator(virtual=True) as simulator, simulator.robot(timeout=PATIENCE) as robot:
            self.assertIn(simulator.address, repr(simulator))
            self.assertIn("not in control", repr(robot))
            self.assertIn("tiller.Sample", repr(robot.state))
        self.assertIn("stopped", repr(simulator))


KILLED = """
import sys, time, tiller
robot = tiller.Robot(sys.argv[1], timeout=60)
robot.take_control(60)
what = sys.argv[2]
if what == "move":
    handle = robot.move_j(robot.state.q + [1.5, 0, 0, 0, 0, 0], 0.4, 1.0)
elif what == "jog":
    handle = robot.jog([0, 0, 0.05, 0, 0, 0])
else:
    handle = robot.speed_j()
print("moving", flush=True)
while True:
    if what == "jog":
        handle.refresh()
    elif what == "stream":
        handle.send([0.2, 0, 0, 0, 0, 0])
    time.sleep(0.005)
"""


SILENT = """
import sys, tiller
with tiller.Robot(sys.argv[1], timeout=60) as robot:
    robot.take_control(60)
    move = robot.move_j(robot.state.q + [1.5, 0, 0, 0, 0, 0], 0.4, 1.0, silence=3.0)
    print("moving", flush=True)
    move.wait(60)
    print(move.cause, flush=True)
"""


class TestSlowLoops(unittest.TestCase):
    """In real time: calls that take longer than a period."""

    def run_loop(self, work):
        """A packet loop of a second whose callback does some work: the cycles, and what ended the loop."""
        cycles = []

        def callback(cycle):
            cycles.append(dict(cycle))
            work()
            return None if cycle["time"] > 1.0 else [0] * 6

        with tiller.Simulator() as simulator, simulator.robot(timeout=PATIENCE) as robot:
            robot.take_control(PATIENCE)
            try:
                report = robot.packet_loop("speed_j", callback, timeout=PATIENCE)
            except errors.Stopped as stopped:  # a busy machine made a call even longer
                self.assertRegex(str(stopped), "a call of the callback took [0-9.]+ ms")
                report = None
        return cycles, report

    def check(self, cycles, report):
        for cycle in cycles:
            self.assertTrue(not cycle["fresh"] or cycle["age"] <= 2 * cycle["period"], cycle)
        # Calls do not fall behind the robot: no call is older at the end than at the beginning.
        ages = sorted(cycle["age"] for cycle in cycles)
        self.assertLess(ages[len(ages) // 2], 0.02)
        if report is not None:
            self.assertGreater(report.missed, 0)
            self.assertGreater(report.overruns, 0)

    def test_a_slow_callback_gets_the_newest_packet(self):
        self.check(*self.run_loop(lambda: time.sleep(0.01)))

    def test_a_busy_thread_delays_calls_but_not_the_data(self):
        over = threading.Event()

        def work():
            while not over.is_set():
                sum(range(100))

        busy = threading.Thread(target=work)
        busy.start()
        try:
            cycles, report = self.run_loop(lambda: None)
        finally:
            over.set()
            busy.join()
        self.check(cycles, report)
        if report is not None:
            self.assertGreater(report.longest_wait, 0.002)

    def test_a_callback_that_hangs_is_named(self):
        with tiller.Simulator() as simulator, simulator.robot(timeout=PATIENCE) as robot:
            robot.take_control(PATIENCE)
            with self.assertRaisesRegex(errors.Stopped, "a call of the callback took [0-9]{3,}"):
                robot.packet_loop("speed_j", lambda cycle: time.sleep(0.3) or [0] * 6, timeout=PATIENCE)


class TestEnds(unittest.TestCase):
    """In real time: another process is ended while it moves the arm."""

    def check(self, what, how):
        with tiller.Simulator() as simulator:
            process = subprocess.Popen([sys.executable, "-B", "-c", KILLED, simulator.address, what], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
            try:
                self.assertEqual(process.stdout.readline().strip(), "moving")
                self.assertTrue(until(lambda: not stands(simulator)))
                process.send_signal(how)
                process.wait(PATIENCE)
                self.assertTrue(until(lambda: stands(simulator)))
                q = simulator.truth["q"]
                then = simulator.truth["timestamp"]
                self.assertTrue(until(lambda: simulator.truth["timestamp"] > then + 0.5))
                self.assertLess(float(np.abs(simulator.truth["q"] - q).max()), 1e-2)
            finally:
                process.kill()
                process.wait()
                process.stdout.close()

    def test_killed(self):
        for what in ("move", "jog", "stream"):
            with self.subTest(what):
                self.check(what, signal.SIGKILL)

    def test_a_longer_silence_is_survived(self):
        """A process that is held for half a second, as a busy machine does it, and a move that allows it."""
        with tiller.Simulator() as simulator:
            process = subprocess.Popen([sys.executable, "-B", "-c", SILENT, simulator.address], stdout=subprocess.PIPE, text=True)
            try:
                self.assertEqual(process.stdout.readline().strip(), "moving")
                self.assertTrue(until(lambda: not stands(simulator)))
                process.send_signal(signal.SIGSTOP)
                then = simulator.truth["timestamp"]
                self.assertTrue(until(lambda: simulator.truth["timestamp"] > then + 0.5))
                self.assertFalse(stands(simulator))
                process.send_signal(signal.SIGCONT)
                self.assertEqual(process.stdout.readline().strip(), "Completed")
            finally:
                process.kill()
                process.wait()
                process.stdout.close()

    def test_ctrl_c(self):
        for what in ("move", "jog", "stream"):
            with self.subTest(what):
                self.check(what, signal.SIGINT)


if __name__ == "__main__":
    unittest.main()
