# SPDX-License-Identifier: MIT
"""Coroutines: packets with `async for`, conditions and moves with `await`, and their typed results."""
import asyncio
import time
import unittest

import tiller
from tiller import errors

LIMIT = 60.0  # [s]; only a hanging test reaches it


class TestAsync(unittest.TestCase):
    def setUp(self):
        self.simulator = tiller.Simulator(virtual=True).start()
        self.addCleanup(self.simulator.stop)
        self.robot = self.simulator.robot(timeout=LIMIT)
        self.addCleanup(self.robot.close)

    def run_limited(self, coroutine):
        return asyncio.run(asyncio.wait_for(coroutine, LIMIT))

    def test_async_for_returns_every_packet_and_other_tasks_run(self):
        turns = 0

        async def count():
            nonlocal turns
            while True:
                turns += 1
                await asyncio.sleep(0)

        async def read():
            counting = asyncio.ensure_future(count())
            seen = []
            async for sample in self.robot.samples():
                seen.append(sample.sequence)
                if len(seen) == 100:
                    break
            counting.cancel()
            return seen

        seen = self.run_limited(read())
        self.assertEqual(seen, list(range(seen[0], seen[0] + 100)))
        self.assertGreater(turns, 99)

    def test_async_for_ends_when_the_robot_is_closed(self):
        async def read():
            count = 0
            async for _ in self.robot.samples():
                count += 1
                if count == 5:
                    self.robot.close()
            return count

        self.assertGreaterEqual(self.run_limited(read()), 5)

    def test_async_for_raises_timeout_without_packets(self):
        async def read():
            async for _ in self.robot.samples(timeout=0.2):
                self.simulator.fault("silence on")

        with self.assertRaises(errors.Timeout):
            self.run_limited(read())

    def test_a_condition_sees_an_event_of_one_packet(self):
        condition = self.robot.until(lambda sample: sample.digital_input(3))
        self.simulator.step(0.05)
        self.simulator.set_digital_input(3, True)
        self.simulator.step(0.002)
        self.simulator.set_digital_input(3, False)
        self.simulator.step(0.05)
        self.assertFalse(self.robot.state.digital_input(3))
        sample = condition.wait(LIMIT)
        self.assertTrue(sample.digital_input(3))
        self.assertIs(condition.wait(LIMIT), sample)

    def test_conditions_and_moves_can_be_awaited_together(self):
        async def move():
            self.robot.take_control(LIMIT)
            start = self.robot.state.q
            halfway = self.robot.until(lambda sample: sample.q[5] - start[5] > 0.2)
            move = self.robot.move_j(start + [0, 0, 0, 0, 0, 0.4])
            sample, _ = await asyncio.gather(halfway, move)
            return sample.q[5] - start[5], self.robot.state.q[5] - start[5], move.cause

        halfway, end, cause = self.run_limited(move())
        self.assertTrue(0.2 < halfway < 0.25, halfway)
        self.assertAlmostEqual(end, 0.4, 3)
        self.assertIs(cause, tiller.StopCause.COMPLETED)

    def test_a_condition_on_the_current_state_returns_immediately(self):
        self.assertEqual(self.robot.until(lambda sample: sample.robot_mode is tiller.RobotMode.RUNNING).wait(0).robot_mode,
                         "RUNNING")

    def test_a_condition_that_is_not_met_raises_timeout(self):
        began = time.monotonic()
        with self.assertRaises(errors.Timeout):
            self.robot.until(lambda sample: False).wait(0.2)
        self.assertGreaterEqual(time.monotonic() - began, 0.2)

        async def wait():
            await asyncio.wait_for(self.robot.until(lambda sample: False), 0.2)

        with self.assertRaises(asyncio.TimeoutError):
            self.run_limited(wait())

    def test_errors_of_a_condition_are_raised(self):
        with self.assertRaises(ZeroDivisionError):
            self.robot.until(lambda sample: 1 / 0).wait(LIMIT)

    def test_outputs_can_be_awaited_in_a_thread(self):
        async def switch():
            switched = self.robot.until(lambda sample: sample.digital_output(2))
            await asyncio.gather(asyncio.to_thread(self.robot.outputs.set_digital, 2, True, LIMIT), switched)

        self.run_limited(switch())
        self.assertEqual(self.simulator.truth.digital_outputs, 4)


class TestTypes(unittest.TestCase):
    def test_results_are_typed(self):
        with tiller.Simulator(virtual=True) as simulator, simulator.robot(timeout=LIMIT) as robot:
            self.assertIs(robot.status.loss, tiller.ControlLoss.NOT_TAKEN)
            self.assertIs(robot.state.safety_mode, tiller.SafetyMode.NORMAL)
            self.assertEqual(f"{robot.state.safety_mode} {robot.state.runtime_state}", "NORMAL STOPPED")
            robot.take_control(LIMIT)
            self.assertTrue(robot.status.in_control)
            self.assertGreater(robot.link.packets, 0)
            self.assertIsInstance(simulator.truth.q, tiller.Joints)
            move = robot.move_j(robot.state.q + [0.1, 0, 0, 0, 0, 0])
            self.assertIs(move.cause, tiller.StopCause.NONE)
            self.assertIs(move.plan.limiter, tiller.LimiterKind.TCP_SPEED)
            cycles = []

            def callback(cycle):
                cycles.append(cycle)
                return None if cycle.cycle > 2 else [0.0] * 6

            robot.packet_loop("speed_j", callback, timeout=LIMIT)
            self.assertIsInstance(cycles[0], tiller.Cycle)
            self.assertIsInstance(cycles[0].tcp_pose, tiller.Pose)

    def test_a_mode_of_newer_software_keeps_its_number(self):
        self.assertEqual(tiller.SafetyMode("UNKNOWN_99"), "UNKNOWN_99")
        self.assertEqual(repr(str(tiller.SafetyMode("UNKNOWN_99"))), "'UNKNOWN_99'")
        with self.assertRaises(ValueError):
            tiller.SafetyMode("no mode")


if __name__ == "__main__":
    unittest.main()
