# SPDX-License-Identifier: MIT
"""Common mistakes and faults: wrong arguments, a lost connection, fields that are not received. Each must raise a clear
error."""
import pathlib
import re
import tempfile
import time
import traceback
import unittest

import tiller
from tiller import errors

LIMIT = 60.0  # [s]; only a hanging test reaches it


class TestArguments(unittest.TestCase):
    """The error for a value of the wrong type names the argument and does not contain a signature of the binding."""

    def setUp(self):
        self.simulator = tiller.Simulator(virtual=True).start()
        self.addCleanup(self.simulator.stop)
        self.robot = self.simulator.robot(timeout=LIMIT).take_control(LIMIT)
        self.addCleanup(self.robot.close)

    def test_a_wrong_type_names_the_argument(self):
        robot, simulator = self.robot, self.simulator
        q = robot.state.q
        calls = {
            "speed": lambda: robot.move_j(q, speed="fast"), "heartbeat_timeout": lambda: robot.move_j(q, heartbeat_timeout=None),
            "mass": lambda: robot.set_payload("x"), "metres_per_second": lambda: setattr(robot, "speed_cap", "x"),
            "acceleration": lambda: robot.move_until_contact([0, 0, -0.05, 0, 0, 0], acceleration="x"),
            "lookahead": lambda: robot.servo_j(lookahead="x"), "timeout": lambda: robot.move_j(q).wait("x"),
            "output": lambda: robot.outputs.set_digital("a", True), "fraction": lambda: robot.outputs.set_speed_slider("x"),
            "ints": lambda: robot.registers(ints=["a"]), "words": lambda: simulator.fault(3),
            "seconds": lambda: simulator.step("x"), "on": lambda: robot.outputs.set_digital(1, []),
            "body": lambda: robot.run_function(3), "program": lambda: robot.run_script(None),
            "name": lambda: robot.dashboard.load_program(3), "contact_force": lambda: robot.jog([0] * 6, contact_force="x"),
            "model": lambda: tiller.Simulator(5), "address": lambda: tiller.Robot(5),
            "frequency": lambda: tiller.Robot("127.0.0.1", frequency="x"), "port_offset": lambda: tiller.Robot("a", port_offset=1.5),
            "fields": lambda: robot.record("a.csv", fields=[1])}
        for name, call in calls.items():
            with self.subTest(name), self.assertRaises(TypeError) as raised:
                call()
            text = str(raised.exception)
            self.assertIn(name, text)
            self.assertNotIn("incompatible", text)
            self.assertNotIn("_native", text)
            self.assertNotIn("\n", text)
        with self.assertRaises(TypeError) as raised:
            tiller.Kinematics(5)
        self.assertIn("model", str(raised.exception))

    def test_the_message_names_the_expected_and_actual_type(self):
        with self.assertRaisesRegex(TypeError, r"^Robot\.move_j\(\): speed must be a number, not 'fast' \(str\)$"):
            self.robot.move_j(self.robot.state.q, speed="fast")

    def test_type_errors_of_the_caller_are_not_changed(self):
        def callback(cycle):
            raise TypeError("mine: incompatible function arguments")

        with self.assertRaisesRegex(TypeError, "^mine: incompatible function arguments$"):
            self.robot.packet_loop("speed_j", callback, timeout=LIMIT)
        with self.assertRaisesRegex(TypeError, "no_such_option"):
            self.robot.move_j(self.robot.state.q, no_such_option=1)

    def test_the_name_of_an_error_is_printed_once(self):
        with self.assertRaises(errors.InvalidArgument) as raised:
            self.robot.outputs.set_digital(99, True)
        text = "".join(traceback.format_exception_only(raised.exception))
        self.assertEqual(text.count("InvalidArgument"), 1, text)
        self.assertEqual(raised.exception.code, "InvalidArgument")
        self.assertEqual(str(errors.Timeout()), "Timeout")


class TestLink(unittest.TestCase):
    def setUp(self):
        self.simulator = tiller.Simulator().start()
        self.addCleanup(self.simulator.stop)

    def robot(self, **options):
        robot = tiller.Robot(self.simulator.address, timeout=LIMIT, **options)
        self.addCleanup(robot.close)
        return robot

    def test_outputs_are_confirmed_whatever_fields_are_followed(self):
        robot = self.robot(fields=["actual_q"])
        robot.outputs.set_digital(1, True, LIMIT)
        self.assertEqual(self.simulator.truth.digital_outputs, 2)
        robot.outputs.set_speed_slider(0.5, LIMIT)
        robot.outputs.set_voltage(0, 5.0, LIMIT)
        self.assertEqual(robot.state.fields(), ["timestamp", "actual_q"])

    def test_modes_are_unknown_when_the_link_is_lost(self):
        robot = self.robot().take_control(LIMIT)
        self.assertEqual((robot.status.safety_mode, robot.state.safety_mode), ("NORMAL", "NORMAL"))
        self.simulator.stop()
        end = time.monotonic() + LIMIT
        while robot.state.safety_mode == "NORMAL" or robot.status.safety_mode == "NORMAL":
            self.assertLess(time.monotonic(), end)
            time.sleep(0.01)
        self.assertFalse(robot.in_control)
        self.assertFalse(robot.status.fresh)
        self.assertEqual((robot.state.robot_mode, robot.status.robot_mode), ("DISCONNECTED", "DISCONNECTED"))
        self.assertEqual((robot.state.safety_mode, robot.status.safety_mode), ("UNDEFINED_SAFETY_MODE",) * 2)
        self.assertEqual(robot.state.runtime_state, "STOPPED")
        self.assertEqual(robot.state["safety_mode"], 1.0)  # the packet is unchanged

    def test_a_move_that_ended_for_late_data_names_the_measured_times(self):
        with tiller.Simulator(virtual=True) as simulator, simulator.robot(timeout=LIMIT) as robot:
            robot.take_control(LIMIT)
            for timeout, limit in ((0.1, 100), (0.3, 300)):
                move = robot.move_j(robot.state.q + [1, 0, 0, 0, 0, 0], heartbeat_timeout=timeout)
                simulator.step(0.5)
                simulator.fault("silence on")
                with self.assertRaises(errors.LinkLost) as raised:
                    move.wait(LIMIT)
                simulator.fault("silence off")
                text = raised.exception.controller_message
                measured = re.match(rf"no data from the robot for (\d+) ms \(limit {limit} ms\): ", text)
                self.assertTrue(measured, text)
                self.assertTrue(limit < int(measured[1]) < 450, text)
                self.assertIn("heartbeat timeout", text)
                self.assertTrue(robot.until(lambda sample: robot.in_control).wait(LIMIT))

    def test_a_refused_connection_fails_immediately(self):
        self.simulator.stop()
        with self.assertRaises(errors.ConnectionRefused):
            tiller.Robot(self.simulator.address, timeout=None)  # would hang if it waited for the refused connection
        with self.assertRaises(errors.AddressInvalid):
            tiller.Robot("no host", timeout=None)

    def test_recover_waits_for_a_controller_that_restarts(self):
        robot = self.robot()
        self.simulator.fault("restart 1")
        steps = []
        robot.recover(tiller.Consent(power_on=True, release_brakes=True), LIMIT, steps.append)
        self.assertEqual(steps[0], "Look")
        self.assertEqual(steps[-1], "Done")
        self.assertEqual(self.simulator.truth.robot_mode, "RUNNING")


class TestTables(unittest.TestCase):
    """Tables of other programs."""

    def read(self, text, **options):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "table.csv")
            path.write_text(text, encoding="utf-8")
            return tiller.read_recording(path, **options)

    def test_the_arguments_describe_a_table(self):
        frame = self.read("tick|F\n0|1,5\n20|2,5\n", time_column="tick", time_unit="ms", table_separator="|", table_decimal=",")
        self.assertEqual(list(frame.columns), ["seconds", "tick", "F"])
        self.assertEqual(frame["seconds"].tolist(), [0, 0.02])
        self.assertEqual(frame["F"].tolist(), [1.5, 2.5])
        frame = self.read("1;2\n3;4\n", no_header=True, time_column="none", table_rate=4)
        self.assertEqual(frame["seconds"].tolist(), [0, 0.25])
        self.assertEqual(frame["column 2"].tolist(), [2, 4])

    def test_an_undecided_table_is_refused(self):
        with self.assertRaisesRegex(errors.InvalidArgument, 'Specify time_column, or time_column="none" and table_rate'):
            self.read("tick;F\n0;1,5\n20;2,5\n", time_unit="ms")
        with self.assertRaisesRegex(errors.InvalidArgument, "Specify time_unit s, ms, us or ns"):
            self.read("time,F\n0,1\n20,2\n", table_separator=",")
        with self.assertRaisesRegex(errors.InvalidArgument, "Specify table_separator or table_decimal"):
            self.read("0,5\n1,5\n2,5\n", time_column="none", table_rate=1)
        with self.assertRaisesRegex(errors.InvalidArgument, "time_unit"):
            self.read("t,F\n0,1\n20,2\n", time_unit="min")
        # Without arguments, pandas reads the file and does not look for a time.
        self.assertEqual(list(self.read("tick,F\n0,1\n20,2\n").columns), ["tick", "F"])


if __name__ == "__main__":
    unittest.main()
