# SPDX-License-Identifier: MIT
"""Tests of dashboard_client, script_client and robotiq_gripper."""
import os
import socketserver
import tempfile
import threading
import unittest

from dashboard_client import DashboardClient, UserRole
from robot import Robot, until
from robotiq_gripper import RobotiqGripper
from rtde_receive import RTDEReceiveInterface
from script_client import ScriptClient


class Gripper(socketserver.StreamRequestHandler):
    """The socket of the URCap, with a gripper that reaches its target immediately."""
    values = {"ACT": 0, "STA": 0, "POS": 3, "PRE": 3, "OBJ": 3, "FLT": 0, "SPE": 0, "FOR": 0, "GTO": 0}

    def handle(self):
        for line in self.rfile:
            words = line.decode().split()
            if words[0] == "GET":
                self.wfile.write(f"{words[1]} {self.values[words[1]]}\n".encode())
                continue
            for name, value in zip(words[1::2], words[2::2]):
                self.values[name] = int(value)
                if name == "POS":
                    self.values.update(PRE=int(value), POS=min(max(int(value), 3), 230))
                elif name == "ACT":
                    self.values["STA"] = 3 if int(value) else 0
                elif name == "ATR" and int(value):
                    self.values["FLT"] = 0x0F
            self.wfile.write(b"ack")


class TestClients(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()

    @classmethod
    def tearDownClass(cls):
        cls.robot.close()

    def test_dashboard(self):
        dashboard = DashboardClient(hostname=self.robot.host, port=29999, verbose=False)
        dashboard.connect(timeout_ms=2000)
        self.assertTrue(dashboard.isConnected())
        dashboard.send("robotmode\n")
        self.assertEqual(dashboard.receive(), "Robotmode: RUNNING")
        self.assertEqual(dashboard.robotmode(), "Robotmode: RUNNING")
        self.assertEqual(dashboard.safetymode(), "Safetymode: NORMAL")
        self.assertEqual(dashboard.safetystatus(), "Safetystatus: NORMAL")
        self.assertTrue(dashboard.polyscopeVersion().startswith("5."))
        self.assertTrue(dashboard.getRobotModel().startswith("UR5"))
        self.assertTrue(dashboard.getSerialNumber().isdigit())
        self.assertTrue(dashboard.isInRemoteControl())
        self.assertTrue(dashboard.isProgramSaved())
        self.assertFalse(dashboard.running())
        self.assertTrue(dashboard.programState().startswith("STOPPED"))
        self.assertIsInstance(dashboard.getLoadedProgram(), str)
        dashboard.popup("hello")
        dashboard.closePopup()
        dashboard.closeSafetyPopup()
        dashboard.addToLog("a line")
        dashboard.stop()
        for refused in (dashboard.play, dashboard.pause, lambda: dashboard.loadURP("none.urp"),
                        lambda: dashboard.setUserRole(UserRole.OPERATOR)):
            with self.assertRaises(RuntimeError):
                refused()
        try:
            dashboard.unlockProtectiveStop()
        except RuntimeError:
            pass  # no protective stop to unlock
        dashboard.powerOff()
        self.assertTrue(until(lambda: dashboard.robotmode() == "Robotmode: POWER_OFF"))
        dashboard.restartSafety()
        dashboard.powerOn()
        self.assertTrue(until(lambda: dashboard.robotmode() == "Robotmode: IDLE"))
        dashboard.brakeRelease()
        self.assertTrue(until(lambda: dashboard.robotmode() == "Robotmode: RUNNING"))
        dashboard.disconnect()
        dashboard.connect()
        dashboard.quit()
        self.assertFalse(dashboard.isConnected())

    def test_shutdown(self):
        robot = Robot()
        dashboard = DashboardClient(ip=robot.host)
        dashboard.connect()
        dashboard.shutdown()
        self.assertFalse(dashboard.isConnected())
        robot.close()

    def test_scripts(self):
        receive = RTDEReceiveInterface(self.robot.host)
        client = ScriptClient(self.robot.host, major_control_version=5, minor_control_version=22)
        client.connect()
        self.assertTrue(client.isConnected())
        self.assertTrue(client.sendScriptCommand("set_standard_digital_out(0, True)"))
        self.assertTrue(until(lambda: receive.getDigitalOutState(0)))
        self.assertIn("rtde_control", client.getScript())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.script")
            with open(path, "w", encoding="utf-8") as file:
                file.write("def mine():\n  set_standard_digital_out(0, False)\n  sync()\nend\n")
            client.setScriptFile(path)
            self.assertTrue(client.sendScript())
            self.assertTrue(until(lambda: not receive.getDigitalOutState(0)))
            self.assertTrue(client.sendScript(path))
        client.disconnect()
        self.assertFalse(client.isConnected())

    def test_gripper(self):
        with socketserver.ThreadingTCPServer(("127.0.0.1", 0), Gripper) as server:
            server.daemon_threads = True
            threading.Thread(target=server.serve_forever, daemon=True).start()
            gripper = RobotiqGripper("127.0.0.1", Port=server.server_address[1])
            gripper.connect()
            self.assertTrue(gripper.isConnected())
            gripper.activate()
            self.assertTrue(gripper.isActive())
            gripper.autoCalibrate()
            self.assertEqual(gripper.getNativePositionRange(), (3, 230))
            gripper.setNativePositionRange(3, 230)
            gripper.setUnit(RobotiqGripper.POSITION, RobotiqGripper.UNIT_PERCENT)
            gripper.setPositionRange_mm(50)
            self.assertEqual(gripper.close(MoveMode=RobotiqGripper.WAIT_FINISHED), 3)
            self.assertTrue(gripper.isClosed())
            self.assertEqual(gripper.getClosedPosition(), 0.0)
            self.assertEqual(gripper.open(), RobotiqGripper.AT_DEST)
            self.assertEqual(gripper.waitForMotionComplete(), RobotiqGripper.AT_DEST)
            self.assertTrue(gripper.isOpen())
            self.assertEqual(gripper.getOpenPosition(), 100.0)
            self.assertEqual(gripper.move(50.0, Speed=1.0, Force=0.0, MoveMode=RobotiqGripper.WAIT_FINISHED), 3)
            self.assertAlmostEqual(gripper.getCurrentPosition(), 50.0, delta=0.5)
            self.assertEqual(gripper.setSpeed(2.0), 1.0)
            self.assertEqual(gripper.setForce(-1.0), 0.0)
            self.assertEqual(gripper.objectDetectionStatus(), RobotiqGripper.AT_DEST)
            self.assertTrue(gripper.setVar("FOR", 7))
            self.assertTrue(gripper.setVars([("SPE", 8)]))
            self.assertEqual(gripper.getVar("FOR"), 7)
            self.assertEqual(gripper.getVars(["FOR", "SPE"]), [7, 8])
            gripper.emergencyRelease(RobotiqGripper.OPEN)
            self.assertEqual(gripper.faultStatus(), 0x0F)
            gripper.disconnect()
            server.shutdown()


if __name__ == "__main__":
    unittest.main()
