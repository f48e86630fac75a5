# SPDX-License-Identifier: MIT
"""Every method of rtde_control against the simulated robot."""
import datetime
import os
import signal
import tempfile
import threading
import time
import unittest

import rtde_control
import rtde_receive
from robot import START, Robot, moved, near, until
from rtde_control import AsyncOperationStatus, Path, PathEntry, RTDEControlInterface


class TestControl(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()
        cls.receive = rtde_receive.RTDEReceiveInterface(cls.robot.host)

    @classmethod
    def tearDownClass(cls):
        cls.receive.disconnect()
        cls.robot.close()

    def setUp(self):
        self.control = RTDEControlInterface(self.robot.host)
        self.assertTrue(self.control.moveJ(START))
        self.assertTrue(until(lambda: near(self.joints(), START, 1e-5)))

    def tearDown(self):
        self.control.stopScript()
        self.control.disconnect()

    def joints(self):
        return self.receive.getActualQ()

    def test_life(self):
        control = self.control
        self.assertTrue(control.isConnected())
        self.assertTrue(control.isProgramRunning())
        self.assertTrue(control.getRobotStatus() & 1)
        control.disconnect()
        self.assertFalse(control.isConnected())
        self.assertTrue(control.reconnect())
        control.stopScript()
        self.assertTrue(until(lambda: not control.isProgramRunning()))
        self.assertTrue(control.reuploadScript())
        begin = control.initPeriod()
        self.assertIsInstance(begin, datetime.timedelta)
        control.waitPeriod(begin)

    def test_flags_and_keywords(self):
        self.control.disconnect()
        flags = RTDEControlInterface.FLAG_UPLOAD_SCRIPT | RTDEControlInterface.FLAG_UPPER_RANGE_REGISTERS
        with self.assertRaises(TypeError):
            RTDEControlInterface(nonsense=1)
        self.control = RTDEControlInterface(hostname=self.robot.host, frequency=125.0, flags=flags, ur_cap_port=50002,
                                            rt_priority=0)
        self.assertTrue(self.control.moveJ(q=moved(START, 5, 0.1), speed=1.0, acceleration=1.4, asynchronous=False))
        self.assertTrue(self.control.moveJ(START, vel=1.0, acc=1.4))
        self.assertTrue(self.control.moveJ(START, 1.0, acc=1.4))

    def test_a_second_client_learns_who_uses_the_registers(self):
        self.assertEqual(repr(self.control), f"<rtde_control.RTDEControlInterface {self.robot.host}, connected>")
        try:
            second = RTDEControlInterface(self.robot.host)
        except RuntimeError as error:
            self.assertIn("still connected", str(error))
            self.assertIn("disconnect()", str(error))
        else:
            second.disconnect()
            self.fail("two objects have the same registers")
        self.control.disconnect()
        with RTDEControlInterface(self.robot.host) as control:
            self.assertTrue(control.isProgramRunning())
        self.assertFalse(control.isConnected())
        self.assertTrue(self.control.reconnect())

    def test_custom_scripts(self):
        control = self.control
        self.assertTrue(control.sendCustomScriptFunction("mine", "set_standard_digital_out(1, True)\nsync()"))
        self.assertTrue(until(lambda: self.receive.getDigitalOutState(1)))
        self.assertFalse(control.sendCustomScript("def b():\n  sync()\n  a = [1]\n  c = a[3]\nend\n"))
        self.assertIn("line 4", control.lastError())
        self.assertTrue(control.sendCustomScript("def a():\n  set_standard_digital_out(1, False)\n  sync()\nend\n"))
        self.assertTrue(until(lambda: not self.receive.getDigitalOutState(1)))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "b.script")
            with open(path, "w", encoding="utf-8") as file:
                file.write("def b():\n  set_standard_digital_out(2, True)\n  sync()\nend\n")
            self.assertTrue(control.sendCustomScriptFile(path))
            self.assertTrue(until(lambda: self.receive.getDigitalOutState(2)))
            control.setCustomScriptFile(path)
            control.setCustomScriptFile("")

    def test_moves(self):
        control = self.control
        pose = self.receive.getActualTCPPose()
        self.assertTrue(control.moveL(moved(pose, 2, 0.02), 0.25, 1.2))
        self.assertTrue(control.moveJ_IK(pose=pose, speed=1.0, acceleration=1.4))
        self.assertTrue(control.moveL_FK(q=START, speed=0.25, acceleration=1.2))
        self.assertTrue(control.moveJ([moved(START, 5, 0.1) + [1.0, 1.4, 0.0], START + [1.0, 1.4, 0.0]]))
        self.assertTrue(control.moveL(path=[pose + [0.25, 1.2, 0.0]], asynchronous=False))
        path = Path()
        path.addEntry(PathEntry(PathEntry.MoveJ, PathEntry.PositionJoints, moved(START, 5, 0.1) + [1.0, 1.4, 0.0]))
        path.appendMovelPath([pose + [0.25, 1.2, 0.0]])
        path.appendMovejPath([START + [1.0, 1.4, 0.0]])
        self.assertEqual(path.size(), 3)
        self.assertEqual(len(path.waypoints()), 3)
        self.assertIn("movel(p[", path.toScriptCode())
        self.assertIn("movej([", path.waypoints()[0].toScriptCode())
        self.assertTrue(control.movePath(path))
        path.clear()
        self.assertEqual(path.size(), 0)
        self.assertTrue(until(lambda: near(self.joints(), START, 1e-5)))

    def test_asynchronous(self):
        control = self.control
        self.assertTrue(control.moveJ(moved(START, 0, 0.5), 0.02, 1.4, True))
        self.assertGreaterEqual(control.getAsyncOperationProgress(), 0)
        status = control.getAsyncOperationProgressEx()
        self.assertTrue(status.isAsyncOperationRunning() or status.changeCount() >= 0)
        self.assertGreaterEqual(status.operationId(), 1)
        self.assertGreaterEqual(status.value(), 0)
        self.assertEqual(status.progress(), 0)
        self.assertTrue(status.equals(status))
        self.assertEqual(AsyncOperationStatus().value(), 0)
        self.assertEqual(AsyncOperationStatus().progress(), -1)
        self.assertEqual(AsyncOperationStatus(0x05018003).progress(), 3)
        self.assertEqual(AsyncOperationStatus(0x05018003).operationId(), 5)
        self.assertEqual(AsyncOperationStatus(0x05018003).changeCount(), 1)
        control.stopJ(a=4.0, asynchronous=False)
        self.assertTrue(until(lambda: control.getAsyncOperationProgress() < 0))
        control.stopL(10.0, True)

    def test_streams(self):
        control = self.control
        target = moved(START, 5, 0.1)
        self.assertTrue(until(lambda: control.servoJ(target, 0.0, 0.0, 0.002, 0.1, 300)
                              and near(self.joints(), target, 5e-3)))
        self.assertTrue(control.servoStop())
        pose = moved(self.receive.getActualTCPPose(), 2, 0.02)
        self.assertTrue(until(lambda: control.servoL(pose, 0.0, 0.0, 0.002, 0.1, 300)
                              and near(self.receive.getActualTCPPose(), pose, 5e-3)))
        self.assertTrue(control.servoStop(a=5.0))
        self.assertTrue(control.servoC(pose, speed=0.1, acceleration=1.0, blend=0.0))
        self.assertTrue(control.servoStop())
        self.assertTrue(control.speedJ([0, 0, 0, 0, 0, 0.2], acceleration=1.0, time=0.0))
        self.assertTrue(until(lambda: abs(self.receive.getActualQd()[5]) > 0.01))
        self.assertTrue(control.speedStop(a=10.0))
        self.assertTrue(control.speedL(xd=[0, 0, 0.02, 0, 0, 0], acceleration=0.5))
        self.assertTrue(control.speedStop())
        self.assertTrue(control.jogStart([0, 0, 0.02, 0, 0, 0], feature=RTDEControlInterface.FEATURE_TOOL, acc=0.5,
                                         custom_frame=[0.0] * 6))
        self.assertTrue(control.jogStop())

    def test_force_and_hands(self):
        control = self.control
        self.assertTrue(control.zeroFtSensor())
        self.assertTrue(control.forceModeSetDamping(0.1))
        self.assertTrue(control.forceModeSetGainScaling(1.0))
        self.assertTrue(control.forceMode([0.0] * 6, [0, 0, 1, 0, 0, 0], [0, 0, -5, 0, 0, 0], 2, [2, 2, 1, 1, 1, 1]))
        self.assertTrue(control.forceModeStop())
        self.assertTrue(control.setExternalForceTorque([0.0] * 6))
        self.assertTrue(control.enableExternalFtSensor(enable=True, sensor_mass=0.5))
        self.assertTrue(control.enableExternalFtSensor(False))
        self.assertTrue(control.ftRtdeInputEnable(enable=True, sensor_mass=0.5, sensor_measuring_offset=[0.0] * 3,
                                                  sensor_cog=[0.0] * 3))
        self.assertTrue(control.ftRtdeInputEnable(False))
        self.assertTrue(control.freedriveMode(free_axes=[1] * 6, feature=[0.0] * 6))
        self.assertEqual(control.getFreedriveStatus(), 0)
        self.assertTrue(control.endFreedriveMode())
        self.assertTrue(control.teachMode())
        self.assertTrue(control.endTeachMode())
        self.assertEqual(control.toolContact([0.0] * 6), 0)
        self.assertTrue(control.startContactDetection(direction=[0.0, 0.0, -1.0, 0.0, 0.0, 0.0]))
        self.assertFalse(control.readContactDetection())
        self.assertFalse(control.stopContactDetection())
        z = self.receive.getActualTCPPose()[2]
        pusher = threading.Thread(target=lambda: (until(lambda: self.receive.getActualTCPPose()[2] < z - 0.005),
                                                  self.robot.tell("hand")))
        pusher.start()
        self.assertTrue(control.moveUntilContact(xd=[0, 0, -0.02, 0, 0, 0], direction=[0.0] * 6, acceleration=1.2))
        pusher.join()
        self.robot.tell("free")

    def test_settings_and_questions(self):
        control = self.control
        pose = self.receive.getActualTCPPose()
        self.assertTrue(control.setPayload(1.0, [0, 0, 0.05]))
        self.assertTrue(control.setTcp([0.0] * 6))
        self.assertTrue(control.setGravity([0, 0, 9.82]))
        self.assertAlmostEqual(control.getStepTime(), 0.002)
        self.assertTrue(near(control.getActualJointPositionsHistory(0), START))
        self.assertEqual(len(control.getTargetWaypoint()), 6)
        self.assertTrue(near(control.getForwardKinematics(), pose))
        self.assertTrue(near(control.getForwardKinematics(q=START, tcp_offset=[0.0] * 6), pose))
        self.assertTrue(near(control.getInverseKinematics(x=pose, qnear=START, max_position_error=1e-10,
                                                          max_orientation_error=1e-10), START))
        self.assertTrue(control.getInverseKinematicsHasSolution(pose, qnear=START))
        self.assertTrue(near(control.poseTrans(p_from=[1, 0, 0, 0, 0, 0], p_from_to=[0, 2, 0, 0, 0, 0]),
                             [1, 2, 0, 0, 0, 0]))
        self.assertTrue(control.isPoseWithinSafetyLimits(pose))
        self.assertTrue(control.isJointsWithinSafetyLimits(START))
        self.assertEqual(len(control.getJointTorques()), 6)
        self.assertTrue(near(control.getTCPOffset(), [0.0] * 6))
        self.assertTrue(near(control.getActualToolFlangePose(), pose))
        self.assertIsInstance(control.isSteady(), bool)
        with self.assertRaisesRegex(ValueError, "q\\[0\\]"):
            control.moveJ([90.0, 0, 0, 0, 0, 0])
        self.assertTrue(control.setWatchdog(min_frequency=0.01))
        self.assertTrue(control.kickWatchdog())

    def test_zz_protective_stop(self):
        self.assertTrue(self.control.triggerProtectiveStop())
        self.assertFalse(self.control.moveJ(START))

    def test_ctrl_c_ends_a_wait(self):
        timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            self.control.moveJ(moved(START, 0, 1.0), 0.005, 1.4)
        timer.join()
        self.assertTrue(until(lambda: max(abs(v) for v in self.receive.getActualQd()) < 1e-3))
        self.assertLess(self.joints()[0], START[0] + 0.9)

    def test_other_threads_run_during_waits(self):
        counted = []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted.append(1)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = len(counted)
        self.assertTrue(self.control.moveJ(moved(START, 0, 0.5), 0.5, 1.4))
        after = len(counted)
        stop.set()
        thread.join()
        self.assertGreater(after, before)


if __name__ == "__main__":
    unittest.main()
