# SPDX-License-Identifier: MIT
"""Every method of rtde_receive and rtde_io against the simulated robot."""
import os
import tempfile
import unittest

from robot import START, Robot, near, until
from rtde_io import RTDEIOInterface
from rtde_receive import RTDEReceiveInterface


class TestData(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()
        cls.receive = RTDEReceiveInterface(cls.robot.host)

    @classmethod
    def tearDownClass(cls):
        cls.receive.disconnect()
        cls.robot.close()

    def test_life(self):
        receive = RTDEReceiveInterface(ip=self.robot.host, frequency=125.0, variables=["actual_q", "timestamp"],
                                       verbose=False, use_upper_range_registers=False, rt_priority=0)
        self.assertTrue(receive.isConnected())
        receive.disconnect()
        self.assertFalse(receive.isConnected())
        self.assertTrue(receive.reconnect())
        begin = receive.initPeriod()
        receive.waitPeriod(begin)
        with self.assertRaisesRegex(RuntimeError, "target_q"):
            receive.getTargetQ()

    def test_a_failed_reconnect_leaves_the_automatic_one_running(self):
        receive = RTDEReceiveInterface(self.robot.host)
        self.robot.tell("freeze")
        try:
            self.assertFalse(receive.reconnect())
        finally:
            self.robot.tell("thaw")
        self.assertTrue(until(receive.isConnected))
        before = receive.getTimestamp()
        self.assertTrue(until(lambda: receive.getTimestamp() > before))
        receive.disconnect()
        self.assertFalse(receive.isConnected())

    def test_interfaces_close_with_their_block_and_have_a_repr(self):
        with RTDEReceiveInterface(self.robot.host) as receive:
            self.assertEqual(repr(receive), f"<rtde_receive.RTDEReceiveInterface {self.robot.host}, connected>")
        self.assertFalse(receive.isConnected())
        with RTDEIOInterface(self.robot.host) as io:
            self.assertTrue(io.setStandardDigitalOut(output_id=4, signal_level=False))
        self.assertIn("not connected", repr(io))

    def test_vectors(self):
        receive = self.receive
        self.assertTrue(near(receive.getActualQ(), START))
        self.assertTrue(near(receive.getTargetQ(), START))
        for values in (receive.getTargetQd(), receive.getTargetQdd(), receive.getTargetCurrent(),
                       receive.getTargetMoment(), receive.getActualQd(), receive.getActualCurrent(),
                       receive.getJointControlOutput(), receive.getActualTCPPose(), receive.getActualTCPSpeed(),
                       receive.getActualTCPForce(), receive.getTargetTCPPose(), receive.getTargetTCPSpeed(),
                       receive.getJointTemperatures(), receive.getActualJointVoltage(), receive.getFtRawWrench(),
                       receive.getPayloadInertia(), receive.getJointMode()):
            self.assertEqual(len(values), 6)
        self.assertEqual(len(receive.getActualToolAccelerometer()), 3)
        self.assertEqual(len(receive.getPayloadCog()), 3)

    def test_numbers(self):
        receive = self.receive
        self.assertGreaterEqual(receive.getTimestamp(), 60)
        self.assertEqual(receive.getRobotMode(), 7)
        self.assertEqual(receive.getSafetyMode(), 1)
        self.assertEqual(receive.getSafetyStatusBits(), 1)
        self.assertEqual(receive.getRobotStatus(), 1)
        self.assertEqual(receive.getRuntimeState(), 1)
        for value in (receive.getActualExecutionTime(), receive.getSpeedScaling(), receive.getTargetSpeedFraction(),
                      receive.getActualMomentum(), receive.getActualMainVoltage(), receive.getActualRobotVoltage(),
                      receive.getActualRobotCurrent(), receive.getStandardAnalogInput0(),
                      receive.getStandardAnalogInput1(), receive.getStandardAnalogOutput0(),
                      receive.getStandardAnalogOutput1(), receive.getSpeedScalingCombined(), receive.getPayload()):
            self.assertIsInstance(value, float)
        self.assertFalse(receive.isProtectiveStopped())
        self.assertFalse(receive.isEmergencyStopped())
        self.assertEqual(receive.getActualDigitalInputBits(), 0)
        self.assertFalse(receive.getDigitalInState(0))
        self.assertEqual(receive.getOutputIntRegister(12), 0)
        self.assertEqual(receive.getOutputDoubleRegister(12), 0.0)

    def test_recording(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "data.csv")
            self.assertTrue(self.receive.startFileRecording(path, variables=["timestamp", "actual_q"]))
            start = self.receive.getTimestamp()
            self.assertTrue(until(lambda: self.receive.getTimestamp() > start + 0.1))
            self.assertTrue(self.receive.stopFileRecording())
            with open(path, encoding="utf-8") as file:
                self.assertTrue(file.readline().startswith("timestamp,actual_q_0,"))

    def test_outputs(self):
        receive = self.receive
        io = RTDEIOInterface(ip=self.robot.host)
        self.assertTrue(io.setStandardDigitalOut(7, True))
        self.assertTrue(io.setConfigurableDigitalOut(0, True))
        self.assertTrue(io.setToolDigitalOut(0, True))
        self.assertTrue(until(lambda: receive.getActualDigitalOutputBits() == 1 << 7 | 1 << 8 | 1 << 16))
        self.assertTrue(receive.getDigitalOutState(7))
        self.assertTrue(io.setSpeedSlider(0.5))
        self.assertTrue(until(lambda: abs(receive.getTargetSpeedFraction() - 0.5) < 0.01))
        self.assertTrue(io.setSpeedSlider(1.0))
        self.assertTrue(io.setAnalogOutputVoltage(0, 0.5))
        self.assertTrue(until(lambda: abs(receive.getStandardAnalogOutput0() - 5.0) < 0.01))
        self.assertTrue(io.setAnalogOutputCurrent(1, 0.5))
        self.assertTrue(io.setInputIntRegister(18, 3))
        self.assertTrue(io.setInputDoubleRegister(18, 3.5))
        io.disconnect()
        self.assertFalse(io.setStandardDigitalOut(7, False))
        self.assertTrue(io.reconnect())
        self.assertTrue(io.setStandardDigitalOut(7, False))
        with self.assertRaisesRegex(ValueError, "output_id"):
            io.setStandardDigitalOut(8, True)
        upper = RTDEIOInterface(self.robot.host, verbose=False, use_upper_range_registers=True)
        self.assertTrue(upper.setInputIntRegister(42, 1))


if __name__ == "__main__":
    unittest.main()
