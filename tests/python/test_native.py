# SPDX-License-Identifier: MIT
"""The package `tiller` with the simulated controller in this process. Virtual time is used except in tests that kill a
process."""
import asyncio
import contextlib
import gc
import io
import math
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import weakref

import numpy as np
import tiller
from tiller import errors

TIMEOUT = 60.0  # [s]; only a hanging test reaches it
TEST_TIMEOUT = TIMEOUT
FAR = [1.5, 0, 0, 0, 0, 0]
SOFT = {"compliant": [False, False, True, False, False, False], "wrench": [0.0] * 6, "limits": [0.1] * 3 + [0.5] * 3}


def stands(simulator):
    return float(np.abs(simulator.truth.qd).max()) < 1e-3


def until(condition):
    end = time.monotonic() + TEST_TIMEOUT
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.005)
    return True


class VirtualCase(unittest.TestCase):
    software = ""  # empty: the default of the simulator

    def setUp(self):
        self.simulator = tiller.Simulator(virtual=True, software=self.software).start()
        self.addCleanup(self.simulator.stop)
        self.robot = self.simulator.robot(timeout=TEST_TIMEOUT)
        self.addCleanup(self.robot.close)

    def take_control(self):
        self.robot.take_control(TEST_TIMEOUT)

    def assert_brakes(self):
        """Verifies that the arm stops within the 250 ms of robot time in the jog contract and does not move again."""
        self.simulator.step(0.25)
        self.assertTrue(stands(self.simulator))
        q = self.simulator.truth.q
        self.simulator.step(0.5)
        self.assertLess(float(np.abs(self.simulator.truth.q - q).max()), 1e-3)


class TestHandles(VirtualCase):
    """A Robot without a variable stays open while a handle exists, because the functions that end motions need it."""
    BEGINNINGS = {"move": lambda robot: robot.move_j(robot.state.q + [1, 0, 0, 0, 0, 0]), "stream": lambda robot: robot.speed_j(),
                  "jog": lambda robot: robot.jog([0.1, 0, 0, 0, 0, 0], "joints"),
                  "force mode": lambda robot: robot.force_mode(**SOFT, timeout=None)}

    def test_an_uncaught_exception_stops_the_motion(self):
        for name, begin in self.BEGINNINGS.items():
            with self.subTest(name):
                handle = begin(self.simulator.robot(timeout=None).take_control(None))
                gc.collect()
                self.simulator.step(0.05)
                with contextlib.redirect_stderr(io.StringIO()):
                    sys.excepthook(ValueError, ValueError("uncaught"), None)
                self.assert_brakes()
                self.assertFalse(getattr(handle, "active", False))
                del handle

    def test_a_cell_that_is_rerun_gets_control(self):
        for _ in range(2):
            robot = self.simulator.robot(timeout=None)
            robot.take_control(None)
            move = robot.move_j(robot.state.q + [0.02, 0, 0, 0, 0, 0])
            move.wait(None)
        robot.close()


class TestReceive(VirtualCase):
    def test_samples_are_arrays_with_names(self):
        sample = self.robot.state
        self.assertEqual(sample.q.shape, (6,))
        self.assertLess(float(np.abs(sample.q - self.simulator.truth.q).max()), 1e-3)
        self.assertEqual(sample.robot_mode, "RUNNING")
        self.assertEqual(sample.safety_mode, "NORMAL")
        self.assertIsInstance(sample["timestamp"], float)
        self.assertIs(sample.digital_input(3), False)
        with self.assertRaisesRegex(KeyError, "is not received"):
            sample["no_such_field"]
        q, pose = self.robot.snapshot("actual_q", "actual_TCP_pose")
        self.assertEqual((len(q), len(pose)), (6, 6))

    def test_no_data_is_never_a_number(self):
        few = self.simulator.robot(fields=["timestamp"], timeout=TEST_TIMEOUT)
        self.addCleanup(few.close)
        self.assertTrue(np.isnan(few.state.q).all())
        self.assertTrue(math.isnan(few.state.speed_slider))
        self.assertIsNone(few.state.digital_input(0))
        self.assertEqual(few.state.robot_mode, "DISCONNECTED")
        self.take_control()
        with self.assertRaises(errors.InvalidArgument):
            self.robot.move_j(few.state.q + 0.1)

    def test_every_packet_comes_once(self):
        samples = self.robot.samples(timeout=TEST_TIMEOUT)
        self.simulator.step(1.0)
        numbers = [next(samples).sequence for _ in range(500)]
        self.assertEqual(numbers, list(range(numbers[0], numbers[0] + 500)))
        self.assertEqual(samples.lost, 0)
        self.assertGreater(next(samples).sequence, numbers[-1])  # waits until time has advanced
        self.robot.close()
        self.assertLess(len(list(samples)), 500)  # the iteration ends

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


    def test_the_suffix_selects_the_format(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, begin in (("a.mcap", b"\x89MCAP"), ("a.csv", b"timestamp,"), ("B.CSV", b"timestamp,")):
                path = os.path.join(folder, name)
                with self.robot.record(path) as recording:
                    self.simulator.step(0.2)
                with open(path, "rb") as file:
                    self.assertTrue(file.read().startswith(begin))
                try:
                    frame = recording.frame()
                except ImportError:
                    continue
                self.assertGreaterEqual(len(frame), 100)
                for column in ("actual_q_5", "target_moment_0", "timestamp"):
                    self.assertIn(column, frame.columns)
            for name in ("a.txt", "a", "mcap"):
                with self.assertRaisesRegex(errors.InvalidArgument, ".mcap"):
                    self.robot.record(os.path.join(folder, name))
            self.assertEqual(sorted(os.listdir(folder)), ["B.CSV", "a.csv", "a.mcap"])

    def test_one_file_is_recorded_once(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.csv")
            with self.robot.record(path, ["actual_q"]) as recording:
                self.simulator.step(0.2)
                other = os.path.join(folder, "link.csv")
                os.symlink(path, other)
                for name in (path, other):
                    with self.assertRaisesRegex(errors.FileNotWritable, "another recording"):
                        self.robot.record(name)
                self.simulator.step(0.2)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(len(file.read().splitlines()), recording.rows + 1)
            self.assertGreaterEqual(recording.rows, 200)
            with self.robot.record(path, ["actual_q"]) as recording:
                self.simulator.step(0.1)
            self.assertLess(recording.rows, 100)


def resident():
    """Memory of this process [MB]."""
    with open("/proc/self/statm", encoding="utf-8") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


class TestLife(VirtualCase):
    def test_a_closed_robot_raises_a_clear_error(self):
        self.take_control()
        q = self.robot.state.q
        samples = self.robot.samples()
        move = self.robot.move_j(q + FAR)
        self.robot.close()
        self.robot.close()
        self.assertFalse(self.robot.in_control)
        self.assertEqual(self.robot.data_age, math.inf)
        self.assertLess(float(np.abs(self.robot.state.q - q).max()), 1e-2)
        self.assertIn("closed", repr(self.robot))
        self.assertFalse(move.active)
        self.assertLess(len(list(samples)), 500)
        for call in (self.robot.take_control, self.robot.release, self.robot.stop, lambda: self.robot.move_j(q),
                     self.robot.samples, lambda: self.robot.outputs, lambda: self.robot.status, self.robot.wait_for_data,
                     lambda: self.robot.record("never.csv"), lambda: self.robot.registers(ints=[40]), self.robot.freedrive):
            with self.subTest(call), self.assertRaisesRegex(errors.NotConnected, "closed"):
                call()
        self.assertFalse(os.path.exists("never.csv"))

    def test_no_hidden_reference_keeps_a_robot_alive(self):
        robot = self.simulator.robot(timeout=TEST_TIMEOUT)
        robot.outputs.set_digital(1, True, TEST_TIMEOUT)
        gone = weakref.ref(robot)
        gc.disable()
        try:
            del robot
            self.assertIsNone(gone())
        finally:
            gc.enable()

    def test_a_notebook_cell_can_be_rerun(self):
        self.robot.close()
        kept = []  # a notebook keeps the value of a cell
        for _ in range(3):
            robot = self.simulator.robot(timeout=TEST_TIMEOUT)
            kept.append(robot.take_control(TEST_TIMEOUT))
        self.assertEqual([one.in_control for one in kept], [False, False, True])
        move = robot.move_j(robot.state.q + FAR)
        self.simulator.step(0.2)
        with self.assertRaisesRegex(errors.RegisterInUse, "another Robot object of this program"):
            kept[0].take_control(TEST_TIMEOUT)
        self.assertTrue(move.active)
        for one in kept:
            one.close()

    def test_repeated_connections_do_not_leak_memory(self):
        self.robot.close()
        for kept in ([], None):
            for _ in range(3):
                self.simulator.robot(timeout=TEST_TIMEOUT).close()
            before = resident()
            for _ in range(20):
                robot = self.simulator.robot(timeout=TEST_TIMEOUT)
                if kept is not None:
                    robot.close()
                    kept.append(robot)
            self.assertLess(resident() - before, 20)  # 120 MB if no memory were released


class TestErrors(unittest.TestCase):
    def test_a_missing_robot_is_reported(self):
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
        """Starts a move that is still active on return."""
        move = self.robot.move_j(self.robot.state.q + FAR, 0.5, 1.0)
        self.simulator.step(0.5)
        self.assertFalse(stands(self.simulator))
        return move

    def test_moves_are_waited_for(self):
        target = self.robot.state.q + [0, 0, 0, 0, 0, 0.3]
        move = self.robot.move_j(target)
        self.assertTrue(move.active)
        move.wait(TEST_TIMEOUT)
        self.assertEqual(move.cause, "Completed")
        self.assertEqual(move.progress.fraction, 1.0)
        self.assertLess(float(np.abs(self.simulator.truth.q - target).max()), 1e-3)
        pose = self.robot.state.tcp_pose
        pose[2] += 0.05
        self.robot.move_l(pose, 0.1).wait(TEST_TIMEOUT)
        self.assertLess(float(np.abs(self.simulator.truth.tcp_pose[:3] - pose[:3]).max()), 1e-3)
        pose[2] -= 0.05
        self.robot.move_j_to_pose(pose).wait(TEST_TIMEOUT)
        path = [tiller.PathMove(self.robot.state.q + [0, 0, 0, 0, 0, x]) for x in (0.1, 0.2)]
        self.robot.move_path(path, TEST_TIMEOUT).wait(TEST_TIMEOUT)

    def test_the_heartbeat_timeout_is_limited(self):
        for timeout in (0.05, 4.5, float("nan"), -1.0):
            with self.subTest(timeout), self.assertRaisesRegex(errors.Error, "heartbeat"):
                self.robot.move_j(self.robot.state.q, heartbeat_timeout=timeout)

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
            move.wait(TEST_TIMEOUT)
        self.assertFalse(move.cancel())

    def test_stop_brakes(self):
        move = self.begin()
        self.robot.stop()
        self.assert_brakes()
        self.assertFalse(move.active)

    def test_a_move_without_a_handle_continues(self):
        target = self.robot.state.q + [0, 0, 0, 0, 0, 0.3]
        self.robot.move_j(target)
        gc.collect()
        self.simulator.step(3.0)
        self.assertLess(float(np.abs(self.simulator.truth.q - target).max()), 1e-3)

    def test_stop_ends_a_move_without_a_handle(self):
        for stop in (self.robot.stop, self.robot.release):
            self.take_control()
            self.robot.move_j(self.robot.state.q + FAR, 0.5, 1.0)
            self.simulator.step(0.5)
            self.assertFalse(stands(self.simulator))
            stop()
            self.assert_brakes()

    def test_closing_ends_a_move_without_a_handle(self):
        with self.assertRaises(ZeroDivisionError), self.robot:
            self.begin()
            1 / 0
        self.assert_brakes()

    def test_a_robot_without_references_is_closed(self):
        self.begin()
        gone = weakref.ref(self.robot)
        self.robot = None
        self.doCleanups()  # otherwise a clean-up function would keep a reference to the robot
        self.assertIsNone(gone())

    def test_ctrl_c_in_wait_brakes(self):
        move = self.begin()
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        move._waiting = contextlib.nullcontext  # time does not advance, so the move cannot complete
        with self.assertRaises(KeyboardInterrupt):
            timer.start()
            move.wait(TEST_TIMEOUT)
        self.assert_brakes()

    def test_the_plan_reports_duration_and_limiter(self):
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

    def test_leaving_a_stream_or_a_jog_waits_for_standstill(self):
        for begin in (self.robot.speed_l, lambda: self.robot.jog([0, 0, 0.2, 0, 0, 0])):
            with self.subTest(begin), begin() as motion:
                for _ in range(20):
                    if isinstance(motion, tiller.Jog):
                        self.assertTrue(motion.refresh())
                    else:
                        motion.send([0, 0, 0.2, 0, 0, 0])
                    self.simulator.step(0.02)
                self.assertFalse(stands(self.simulator))
            self.assertTrue(stands(self.simulator))

    def test_stopping_a_stream_does_not_affect_the_next_motion(self):
        stream = self.robot.speed_j()
        move = self.begin()
        stream.stop()
        self.assertTrue(move.active)
        self.assertFalse(stands(self.simulator))

    def test_the_exception_of_a_block_is_never_replaced(self):
        def force():
            return self.robot.force_mode(**SOFT, timeout=TEST_TIMEOUT)

        for begin in (self.robot.speed_l, lambda: self.robot.jog([0, 0, 0.05, 0, 0, 0]), force):
            self.take_control()
            with self.subTest(begin), self.assertRaises(ZeroDivisionError), begin():
                self.robot.release()
                1 / 0

    def in_force_mode(self):
        self.simulator.step(0.02)  # the status is only as new as the latest packet
        return self.robot.status.force_mode

    def test_force_mode_starts_at_the_call(self):
        mode = self.robot.force_mode(**SOFT, timeout=TEST_TIMEOUT)
        self.assertTrue(self.in_force_mode())
        mode.stop()
        self.assertFalse(self.in_force_mode())
        mode.stop()
        self.robot.force_mode(**SOFT, timeout=TEST_TIMEOUT)
        gc.collect()
        self.assertTrue(self.in_force_mode())
        self.robot.end_force_mode(TEST_TIMEOUT)
        self.assertFalse(self.in_force_mode())

    def test_force_modes_nest(self):
        """The downward motion of the arm shows which of the two force modes is active."""
        down, rest = dict(SOFT, wrench=[0, 0, -20, 0, 0, 0]), dict(SOFT, compliant=[False] * 6)

        def sinks():
            self.simulator.step(0.3)
            before = self.simulator.truth.tcp_pose[2]
            self.simulator.step(0.3)
            return before - self.simulator.truth.tcp_pose[2] > 1e-4

        with self.robot.force_mode(**down, timeout=TEST_TIMEOUT):
            self.assertTrue(sinks())
            with self.robot.force_mode(**rest, timeout=TEST_TIMEOUT):
                self.assertFalse(sinks())
            self.assertTrue(sinks())
            with self.robot.force_mode(**rest, timeout=TEST_TIMEOUT):
                self.robot.stop()
            self.assertFalse(sinks())
            self.assertFalse(self.in_force_mode())
        self.assertFalse(self.in_force_mode())

    def test_the_wrench_of_force_mode_can_be_changed(self):
        def sinks():
            self.simulator.step(0.5)  # changes direction
            before = self.simulator.truth.tcp_pose[2]
            self.simulator.step(0.3)
            return before - self.simulator.truth.tcp_pose[2]

        down, up = [0, 0, -20, 0, 0, 0], [0, 0, 20, 0, 0, 0]
        with self.robot.force_mode(**dict(SOFT, wrench=down), timeout=TEST_TIMEOUT) as mode:
            self.assertGreater(sinks(), 1e-4)
            mode.change(up)
            self.assertLess(sinks(), -1e-4)
            with self.robot.force_mode(**dict(SOFT, wrench=down), timeout=TEST_TIMEOUT):
                mode.change(down)
                self.assertGreater(sinks(), 1e-4)
                mode.change(up)
                self.assertGreater(sinks(), 1e-4)
            self.assertLess(sinks(), -1e-4)
            with self.assertRaisesRegex(errors.InvalidArgument, "wrench"):
                mode.change([0.0] * 5)
            self.robot.stop()
            with self.assertRaises(errors.Stopped):
                mode.change(down)
            self.assertFalse(self.in_force_mode())
        with self.assertRaises(errors.Stopped):
            mode.change(down)

    def test_wrong_force_modes_are_refused_by_name(self):
        for name, value in (("compliant", [True] * 5), ("compliant", [2] * 6), ("wrench", [math.nan] * 6), ("kind", 4),
                            ("limits", [0.1] * 3), ("frame", self.robot.state.q)):
            with self.subTest(name), self.assertRaisesRegex(errors.InvalidArgument, name):
                self.robot.force_mode(**dict(SOFT, **{name: value}))

    def test_streams_without_new_targets_end(self):
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

    def test_a_refreshed_jog_keeps_its_frame_and_its_contact_force(self):
        quarter = [0, 0, 0, 0, 0, math.pi / 2]  # the X axis of this frame is Y of the base
        start = self.simulator.truth.tcp_pose
        with self.robot.jog([0.05, 0, 0, 0, 0, 0], "custom", custom_frame=quarter, contact_force=60) as jog:
            for _ in range(20):
                self.assertTrue(jog.refresh([0.05, 0, 0, 0, 0, 0]))
                self.simulator.step(0.02)
            way = self.simulator.truth.tcp_pose - start
            self.assertGreater(way[1], 0.005)
            self.assertLess(abs(way[0]), 0.001)
            self.simulator.press_hand([0, 150, 0, 0, 0, 0])
            for _ in range(10):
                jog.refresh([0.05, 0, 0, 0, 0, 0])
                self.simulator.step(0.02)
            self.assertEqual(jog.cause, "Contact")
        with self.assertRaisesRegex(errors.Error, "contactForce"):
            self.robot.jog([0, 0, 0.05, 0, 0, 0], contact_force=-5)

    def test_unknown_keywords_are_refused_with_the_valid_ones(self):
        q = self.robot.state.q
        self.assertTrue(issubclass(errors.InvalidArgument, ValueError))
        for call, listed in ((lambda: tiller.PathMove(q, kind="L"), '"j", "l", "p", "c"'),
                             (lambda: tiller.PathMove(q, kind=None), '"j", "l", "p", "c"'),
                             (lambda: tiller.PathMove(q, kind=""), '"j", "l", "p", "c"'),
                             (lambda: self.robot.jog([0] * 6, "Base"), '"base", "tool", "custom", "joints"'),
                             (lambda: self.robot.jog_while(lambda sample: [0] * 6, "base "), '"base", "tool", "custom"'),
                             (lambda: self.robot.packet_loop("servoj", lambda cycle: None), '"servo_j", "servo_l"'),
                             (lambda: self.robot._controller.jog("up", [0.0] * 6, [0.0] * 6, 0.0), '"base", "tool"'),
                             (lambda: self.robot._controller.packet_loop("up", lambda cycle, layout: None, False, 1.0), '"servo_j"'),
                             (lambda: self.robot._controller.move_path([("L", (False, list(q)), None, 1, 1, 0)], 1.0, 0.1),
                              '"j", "l", "p", "c"'),
                             (lambda: tiller.Simulator("ur5"[::-1]), "UR5e, "),
                             (lambda: tiller.Kinematics("UR6"), "UR5e, "),
                             (lambda: self.robot.state.digital_input(99), "16, 17"),
                             (lambda: self.robot.state.digital_output(-1), "16, 17"),
                             (lambda: self.simulator.set_digital_input(18, True), "16, 17"),
                             (lambda: self.simulator.set_analog_input(4, 1.0), "0, 1, 2, 3"),
                             (lambda: self.robot.force_mode(**dict(SOFT, kind=0)), "1, 2, 3"),
                             (lambda: self.robot.registers(ints=[999]), "0 to 47"),
                             (lambda: self.robot.registers(doubles=[48]), "0 to 47"),
                             (lambda: self.robot.registers(bits=[63]), "64 to 127")):
            with self.subTest(listed), self.assertRaisesRegex(errors.InvalidArgument, listed):
                call()
        self.simulator.step(0.5)
        self.assertTrue(stands(self.simulator))

    def test_six_numbers_are_read_according_to_the_kind_of_path_move(self):
        start = self.robot.state
        near = start.tcp_pose + [0, 0, 0.05, 0, 0, 0]
        for place in (list(near), np.array(near), near):
            self.robot.move_path([tiller.PathMove(place, kind="l", speed=0.2)], TEST_TIMEOUT).wait(TEST_TIMEOUT)
            self.assertLess(float(np.abs(self.simulator.truth.tcp_pose - near).max()), 1e-3)
            self.robot.move_path([tiller.PathMove(list(start.q))], TEST_TIMEOUT).wait(TEST_TIMEOUT)
            self.assertLess(float(np.abs(self.simulator.truth.q - start.q).max()), 1e-3)
        there = self.robot.inverse_kinematics(near, start.q, TEST_TIMEOUT)
        for move in (tiller.PathMove(near), tiller.PathMove(list(near), pose=True), tiller.PathMove(there, kind="l"),
                     tiller.PathMove(list(there), kind="l", pose=False)):
            self.robot.move_path([move], TEST_TIMEOUT).wait(TEST_TIMEOUT)
            self.assertLess(float(np.abs(self.simulator.truth.tcp_pose - near).max()), 1e-3)
            self.robot.move_path([tiller.PathMove(list(start.q))], TEST_TIMEOUT).wait(TEST_TIMEOUT)
        for wrong in ({"target": near, "pose": False}, {"target": start.q, "pose": True}, {"target": [0.1] * 5},
                      {"target": start.q, "kind": "c", "pose": False, "via": near}, {"target": start.q, "pose": 1}):
            with self.subTest(wrong), self.assertRaises(errors.InvalidArgument):
                tiller.PathMove(**wrong)

    def test_a_pose_is_never_used_as_joint_positions(self):
        q, pose = self.robot.state.q, self.robot.state.tcp_pose
        arm = tiller.Kinematics("UR5e")
        self.assertIsInstance(q, tiller.Joints)
        self.assertIsInstance(pose + [0, 0, 0.1, 0, 0, 0], tiller.Pose)
        self.assertIsInstance(arm.forward(q), tiller.Pose)
        for call in (lambda: self.robot.move_j(pose), lambda: self.robot.move_j(pose + [0, 0, 0.01, 0, 0, 0]),
                     lambda: self.robot.move_j_to_pose(q), lambda: self.robot.move_l(q), lambda: self.robot.move_l(q + 0.01),
                     lambda: self.robot.move_l_to_joints(pose), lambda: self.robot.servo_j().send(pose),
                     lambda: self.robot.servo_l().send(q), lambda: self.robot.set_tcp(q), lambda: arm.forward(pose),
                     lambda: self.robot.forward_kinematics(pose), lambda: self.robot.inverse_kinematics(q),
                     lambda: self.robot.packet_loop("servo_l", lambda cycle: cycle.q, timeout=TEST_TIMEOUT),
                     lambda: self.robot.packet_loop("servo_j", lambda cycle: cycle.tcp_pose, timeout=TEST_TIMEOUT)):
            with self.subTest(call), self.assertRaisesRegex(errors.InvalidArgument, "expected"):
                call()
        self.simulator.step(0.5)
        self.assertTrue(stands(self.simulator))
        # Only a sum of a pose and plain numbers is a pose. All other operations return plain arrays.
        for plain in (pose[:3], 2 * pose, pose - pose, pose + q, -q, np.round(pose @ np.eye(6), 3)):
            self.assertIs(type(plain), np.ndarray)
        up = pose.copy()
        up += [0, 0, 0.05, 0, 0, 0]
        up[2] -= 0.02
        self.robot.move_l(up).wait(TEST_TIMEOUT)
        self.assertLess(float(np.abs(self.simulator.truth.tcp_pose - up).max()), 1e-3)
        self.robot.move_l_to_joints(q).wait(TEST_TIMEOUT)
        self.assertLess(float(np.abs(self.simulator.truth.q - q).max()), 1e-3)

    def test_defaults_respect_the_speed_cap(self):
        self.robot.speed_cap = 0.1
        pose = self.robot.state.tcp_pose + [0, 0, 0.03, 0, 0, 0]
        self.assertAlmostEqual(self.robot.move_l(pose).plan.speed, 0.1)
        self.robot.stop_j().wait(TEST_TIMEOUT)
        self.robot.move_path([tiller.PathMove(pose, "l")], TEST_TIMEOUT).wait(TEST_TIMEOUT)

    def test_an_exception_in_a_jog_callback_brakes(self):
        calls = []

        def callback(sample):
            calls.append(sample.sequence)
            if len(calls) == 2:  # the first call after the start of the jog
                raise ValueError("mine")
            return [0, 0, 0.02, 0, 0, 0]

        with self.assertRaisesRegex(ValueError, "mine"):
            self.robot.jog_while(callback)
        self.assert_brakes()

    def test_servo_c_approaches_its_target_at_its_speed(self):
        target = self.robot.state.tcp_pose + [0, 0, 0.05, 0, 0, 0]
        with self.robot.servo_c(speed=0.1) as stream:
            for _ in range(300):
                stream.send(target)
                self.simulator.step(0.004)
                self.assertLess(abs(float(self.simulator.truth.tcp_speed[2])), 0.11)
        self.assertLess(float(np.abs(self.simulator.truth.tcp_pose - target).max()), 1e-3)
        self.assert_brakes()

    def test_queries_are_answered_by_the_robot(self):
        queries = self.robot.queries
        q = self.robot.state.q
        pose = self.robot.state.tcp_pose
        limits = queries.joint_limits
        self.assertTrue((limits.min_position < q).all() and (q < limits.max_position).all())
        self.assertTrue((limits.max_speed > 1).all())
        self.assertTrue(queries.has_inverse_kinematics(pose, q, TIMEOUT))
        self.assertFalse(queries.has_inverse_kinematics([2, 0, 0.5, 0, 0, 0], timeout=TIMEOUT))
        self.assertTrue(queries.is_within_safety_limits(pose, TIMEOUT))
        self.assertTrue(queries.is_within_safety_limits(q, TIMEOUT))
        self.assertEqual(queries.joint_torques(TIMEOUT).shape, (6,))
        self.simulator.step(1.0)
        self.assertTrue(queries.is_steady(TIMEOUT))
        self.assertEqual(queries.tool_contact(timeout=TIMEOUT), 0)
        self.assertLess(float(np.abs(queries.joint_positions_history(1, TIMEOUT) - q).max()), 1e-3)
        self.assertAlmostEqual(queries.step_time(TIMEOUT), 0.002)
        self.robot.set_tcp([0, 0, 0.1, 0, 0, 0], TEST_TIMEOUT)
        self.assertAlmostEqual(float(queries.tcp_offset(TIMEOUT)[2]), 0.1)
        self.assertLess(float(np.abs(queries.flange_pose(TIMEOUT) - pose).max()), 1e-3)
        self.assertEqual(queries.freedrive_status(TIMEOUT), 0)
        queries.start_contact_detection(timeout=TIMEOUT)
        self.assertFalse(queries.has_contact(TIMEOUT))
        self.assertFalse(queries.end_contact_detection(TIMEOUT))
        with self.assertRaises(errors.LimitExceeded):
            queries.joint_positions_history(-1, TIMEOUT)

    def test_settings_are_confirmed_by_the_robot(self):
        tool = self.robot.tool
        tool.set_target_payload(1.0, [0, 0, 0.05], [0.01, 0.01, 0.01, 0, 0, 0], TIMEOUT)
        self.assertAlmostEqual(self.simulator.robot(timeout=TIMEOUT).state["payload"], 1.0)
        tool.set_gravity([0, 0, 9.82], TIMEOUT)
        tool.set_force_damping(0.5, TIMEOUT)
        tool.set_force_gain_scaling(1.5, TIMEOUT)
        for call in (lambda: tool.set_force_damping(2.0, TIMEOUT), lambda: tool.set_force_gain_scaling(3.0, TIMEOUT),
                     lambda: tool.set_gravity([0, 0, math.nan], TIMEOUT), lambda: tool.set_watchdog(-1.0, TIMEOUT)):
            with self.assertRaises((errors.InvalidArgument, errors.LimitExceeded)):
                call()
        tool.use_external_sensor(0.1, timeout=TIMEOUT)
        tool.set_external_wrench([0, 0, 1, 0, 0, 0])
        tool.use_own_sensor(TIMEOUT)
        with self.assertRaisesRegex(TypeError, "mass must be a number"):
            tool.use_external_sensor("heavy")
        tool.trigger_protective_stop(TIMEOUT)
        self.assertEqual(self.robot.state.safety_mode, "PROTECTIVE_STOP")

    def test_the_watchdog_ends_the_program_without_kicks(self):
        self.robot.tool.set_watchdog(10.0, TIMEOUT)
        for _ in range(10):
            self.robot.tool.kick_watchdog()
            self.simulator.step(0.05)
        self.assertTrue(self.robot.in_control)
        self.simulator.step(0.5)
        self.assertFalse(self.robot.in_control)

    def test_pulses_are_timed_by_the_robot(self):
        self.robot.pulses.begin(0b101, 0b001, 0.2, timeout=TIMEOUT)
        self.assertEqual(self.simulator.truth.digital_outputs & 0b101, 0b001)
        self.simulator.step(0.3)
        self.assertEqual(self.simulator.truth.digital_outputs & 0b101, 0b100)
        self.robot.pulses.begin(1, 1, 10.0, held=False, timeout=TIMEOUT)
        self.robot.pulses.end(1, TIMEOUT)
        self.assertEqual(self.simulator.truth.digital_outputs & 1, 0)
        with self.assertRaises((errors.InvalidArgument, errors.LimitExceeded)):
            self.robot.pulses.begin(1, 1, 4000.0, timeout=TIMEOUT)

    def test_packet_loops_call_back(self):
        q = self.robot.state.q
        seen = []

        def circle(cycle):
            seen.append(cycle.cycle)
            if cycle.time > 1.0:
                return None
            return q + [0, 0, 0, 0, 0, 0.05 * math.sin(cycle.time)]

        report = self.robot.packet_loop("servo_j", circle, timeout=TEST_TIMEOUT)
        self.assertEqual(report.cycles, len(seen))
        self.assertGreater(report.cycles, 400)
        self.assert_brakes()

    def test_packet_loops_receive_every_field_of_the_packet(self):
        self.robot.close()
        robot = self.simulator.robot(fields=["actual_q", "actual_current"], timeout=TIMEOUT)
        self.addCleanup(robot.close)
        robot.take_control(TIMEOUT)
        packets = []

        def hold(cycle):
            packets.append(cycle.packet)
            self.assertEqual(list(cycle.packet.q), list(cycle.q))
            return None if cycle.cycle == 5 else [0.0] * 6

        robot.packet_loop("speed_j", hold, timeout=TIMEOUT)
        self.assertEqual(len({packet.time for packet in packets}), 6)
        for packet in packets:
            self.assertFalse(np.isnan(packet["actual_current"]).any())
            self.assertEqual(packet.robot_mode, "RUNNING")
            self.assertFalse(np.isnan(packet.tcp_force).any())
        with self.assertRaises(KeyError):
            packets[0]["joint_temperatures"]

    def test_an_exception_in_a_packet_loop_brakes(self):
        def callback(cycle):
            if cycle.time > 0.3:
                raise ValueError("mine")
            return [0.3, 0, 0, 0, 0, 0]

        with self.assertRaisesRegex(ValueError, "mine"):
            self.robot.packet_loop("speed_j", callback, timeout=TEST_TIMEOUT)
        self.assert_brakes()
        with self.assertRaisesRegex(errors.InvalidArgument, "callback"):
            self.robot.packet_loop("speed_j", lambda cycle: [1, 2], timeout=TEST_TIMEOUT)

    def test_a_packet_loop_in_a_packet_loop_is_refused(self):
        def inner(cycle):
            return None

        before = self.begin()
        before.cancel()

        def callback(cycle):
            for wait in (lambda: self.robot.packet_loop("speed_j", inner), self.robot.close, self.robot.release,
                         lambda: self.robot.set_payload(1.0), self.robot.wait_for_data,
                         before.wait):
                with self.assertRaisesRegex(errors.InvalidArgument, "callback"):
                    wait()
            return None

        self.robot.packet_loop("speed_j", callback, timeout=TEST_TIMEOUT)
        self.assertTrue(self.robot.in_control)

    def test_a_second_packet_loop_is_refused(self):
        refused = []

        def other():
            try:
                self.robot.packet_loop("speed_j", lambda cycle: None, timeout=TEST_TIMEOUT)
            except errors.InvalidArgument as error:
                refused.append(error)

        def callback(cycle):
            if cycle.cycle == 10:
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()
            return None if cycle.time > 0.3 else [0.1, 0, 0, 0, 0, 0]

        report = self.robot.packet_loop("speed_j", callback, timeout=TEST_TIMEOUT)
        self.assertEqual(len(refused), 1)
        self.assertGreater(report.cycles, 100)

    def test_a_function_cannot_end_its_own_body(self):
        for body in ("end\ndef other():\n  sync()", "if True:\n  sync()", "sync() end", 'x = "if" end',
                     "thread other():\n sync()"):
            with self.subTest(body), self.assertRaisesRegex(errors.InvalidArgument, "end"):
                self.robot.run_function(body, timeout=TEST_TIMEOUT)
        self.robot.run_function('# the end\nif True:\n  textmsg("end")\nend\nset_standard_digital_out(3, True)\nsync()',
                                timeout=TEST_TIMEOUT).wait(TEST_TIMEOUT)
        self.assertTrue(self.simulator.truth.digital_outputs & 8)

    def test_queries_settings_and_functions(self):
        pose = self.robot.forward_kinematics(self.robot.state.q, TEST_TIMEOUT)
        near = self.robot.inverse_kinematics(pose, self.robot.state.q, TEST_TIMEOUT)
        self.assertLess(float(np.abs(near - self.robot.state.q).max()), 1e-3)
        self.robot.set_payload(0.5, [0, 0, 0.02], TEST_TIMEOUT)
        self.robot.set_tcp([0, 0, 0.1, 0, 0, 0], TEST_TIMEOUT)
        self.robot.run_function("set_standard_digital_out(2, True)\nsync()", timeout=TEST_TIMEOUT).wait(TEST_TIMEOUT)
        self.assertTrue(self.simulator.truth.digital_outputs & 4)
        with self.assertRaises(errors.ScriptError):
            self.robot.run_function("b = = 2", timeout=TEST_TIMEOUT)


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
            self.assertGreater(self.simulator.truth.qd[0], 0.05)
            self.assertTrue(stream.active)
        self.assert_brakes()
        self.assertGreater(self.simulator.truth.q[0], q[0])
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

    def test_packet_loops_send_torques(self):
        def steady(cycle):
            return None if cycle.time > 0.3 else [40 * (0.2 - cycle.qd[0]), 0, 0, 0, 0, 0]

        q = self.robot.state.q
        self.robot.packet_loop("torque", steady, timeout=TEST_TIMEOUT)
        self.assert_brakes()
        self.assertGreater(self.simulator.truth.q[0] - q[0], 0.01)


class TestNoTorque(VirtualCase):
    software = "5.24.0"

    def test_older_software_is_named(self):
        self.take_control()
        with self.assertRaisesRegex(errors.VersionUnsupported, r"5\.24\.0.*5\.25\.1.*10\.12\.1"):
            self.robot.torque()
        self.assertTrue(stands(self.simulator))


class TestServices(VirtualCase):
    def test_outputs_are_confirmed(self):
        self.robot.outputs.set_digital(3, True, TEST_TIMEOUT)
        self.assertTrue(self.simulator.truth.digital_outputs & 8)
        self.robot.outputs.set_speed_slider(0.5, TEST_TIMEOUT)
        self.assertEqual(self.simulator.truth.speed_slider, 0.5)

    def test_recovery_needs_consent(self):
        self.simulator.fault("protective-stop")
        self.simulator.step(0.1)
        self.assertEqual(self.robot.state.safety_mode, "PROTECTIVE_STOP")
        with self.assertRaises(errors.Rejected):
            self.robot.recover(tiller.Consent(), TEST_TIMEOUT)
        self.simulator.step(0.1)
        self.assertEqual(self.robot.state.safety_mode, "PROTECTIVE_STOP")
        steps = []
        self.robot.recover(tiller.Consent(cause_inspected=True, power_on=True, release_brakes=True), TEST_TIMEOUT, steps.append)
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
        with self.assertRaisesRegex(errors.InvalidArgument, "UR5e"):
            tiller.Kinematics("UR5000")
        self.assertIn("UR5e", tiller.kinematics.models())
        back = tiller.kinematics.pose_product(pose, tiller.kinematics.pose_inverse(pose))
        self.assertLess(float(np.abs(back).max()), 1e-9)

    def test_the_doctor_checks_the_robot(self):
        with tiller.Simulator() as simulator:
            report = tiller.examine(simulator.address, timeout=TEST_TIMEOUT)
        self.assertEqual(len(report), 19)
        self.assertEqual({finding.condition: finding.verdict for finding in report}["protocol"], "good")
        self.assertIn("good", str(report))

    def test_every_object_has_a_repr(self):
        with tiller.Simulator(virtual=True) as simulator, simulator.robot(timeout=TEST_TIMEOUT) as robot:
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
    move = robot.move_j(robot.state.q + [1.5, 0, 0, 0, 0, 0], 0.4, 1.0, heartbeat_timeout=3.0)
    print("moving", flush=True)
    move.wait(60)
    print(move.cause, flush=True)
"""


class TestSlowLoops(unittest.TestCase):
    """Calls that take longer than a control period, in real time."""

    def run_loop(self, work):
        """Runs a packet loop with a slow callback for a second. Returns the cycles and the report of the loop."""
        cycles = []

        def callback(cycle):
            cycles.append(cycle)
            work()
            return None if cycle.time > 1.0 else [0] * 6

        with tiller.Simulator() as simulator, simulator.robot(timeout=TEST_TIMEOUT) as robot:
            robot.take_control(TEST_TIMEOUT)
            try:
                report = robot.packet_loop("speed_j", callback, timeout=TEST_TIMEOUT)
            except errors.Stopped as stopped:  # on a busy computer, a call took even longer
                self.assertRegex(str(stopped), "one call of the callback took [0-9.]+ ms")
                report = None
        return cycles, report

    def check(self, cycles, report):
        for cycle in cycles:
            self.assertTrue(not cycle.fresh or cycle.age <= 2 * cycle.period, cycle)
        if report is not None:
            # Calls must not fall behind the robot, so the age of the samples must not increase.
            ages = sorted(cycle.age for cycle in cycles)
            self.assertLess(ages[len(ages) // 2], 0.02)
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

    def test_a_hanging_callback_is_reported(self):
        with tiller.Simulator() as simulator, simulator.robot(timeout=TEST_TIMEOUT) as robot:
            robot.take_control(TEST_TIMEOUT)
            with self.assertRaisesRegex(errors.Stopped, "one call of the callback took [0-9]{3,}"):
                robot.packet_loop("speed_j", lambda cycle: time.sleep(0.3) or [0] * 6, timeout=TEST_TIMEOUT)


class TestEnds(unittest.TestCase):
    """Another process is ended while it moves the arm, in real time."""

    def check(self, what, how):
        with tiller.Simulator() as simulator:
            process = subprocess.Popen([sys.executable, "-B", "-c", KILLED, simulator.address, what], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
            try:
                self.assertEqual(process.stdout.readline().strip(), "moving")
                self.assertTrue(until(lambda: not stands(simulator)))
                process.send_signal(how)
                process.wait(TEST_TIMEOUT)
                self.assertTrue(until(lambda: stands(simulator)))
                q = simulator.truth.q
                then = simulator.truth.timestamp
                self.assertTrue(until(lambda: simulator.truth.timestamp > then + 0.5))
                self.assertLess(float(np.abs(simulator.truth.q - q).max()), 1e-2)
            finally:
                process.kill()
                process.wait()
                process.stdout.close()

    def test_killed(self):
        for what in ("move", "jog", "stream"):
            with self.subTest(what):
                self.check(what, signal.SIGKILL)

    def test_a_longer_heartbeat_timeout_is_respected(self):
        """A process is suspended for half a second, as on a busy computer, and the timeout of its move permits
        this."""
        with tiller.Simulator() as simulator:
            process = subprocess.Popen([sys.executable, "-B", "-c", SILENT, simulator.address], stdout=subprocess.PIPE, text=True)
            try:
                self.assertEqual(process.stdout.readline().strip(), "moving")
                self.assertTrue(until(lambda: not stands(simulator)))
                process.send_signal(signal.SIGSTOP)
                then = simulator.truth.timestamp
                self.assertTrue(until(lambda: simulator.truth.timestamp > then + 0.5))
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
