# SPDX-License-Identifier: MIT
"""Every public function of the C++ classes that control a robot has a Python counterpart, or a reason why it has none."""
import os
import pathlib
import re
import unittest

import tiller
from tiller import modes

ROBOT = pathlib.Path(os.environ["TILLER_SOURCE"], "robot")
HEADERS = {"control/controller.h": ("Controller",), "control/motions.h": ("Motions",),
           "control/compliance.h": ("Compliance",), "control/tool_setup.h": ("ToolSetup",),
           "control/arm_queries.h": ("ArmQueries",), "control/programs.h": ("Programs",),
           "control/output_pulses.h": ("OutputPulses",), "control/motion.h": ("Motion",),
           "control/packet_loop.h": ("PacketLoop",), "io/outputs.h": ("Outputs",),
           "collision/collision_check.h": ("CollisionCheck",),
           "io/input_registers.h": ("InputRegisters",), "recording/recorder.h": ("Recorder",),
           "receive/receiver.h": ("Receiver", "Subscription"),
           "station/program/execution/program_execution.h": ("ProgramExecution",)}


class Missing(str):
    """The reason why a function has no Python counterpart."""


UNLISTED_MOTION = Missing("moves the arm and is not part of the table of ENDS.md for Python")
INTERNAL = Missing("part of an object that Robot owns: Robot connects and disconnects it")
TABLE = {
    "Controller": {
        "takeControl": "Robot.take_control", "release": "Robot.release", "stop": "Robot.stop", "status": "Robot.status",
        "jointLimits": "Queries.joint_limits", "setSpeedCap": "Robot.speed_cap", "limits": "Robot.speed_cap",
        "version": "Robot.version", "motionState": "Move.cause", "end": "Move.cancel",
        "joinProgram": Missing("continues a program of another client"),
        "leave": Missing("lets the arm move without this process"),
        "stops": Missing("used by the handles"), "localPort": INTERNAL, "options": INTERNAL, "isConnected": "Robot.in_control",
        "setCollisionCheck": "Robot.set_collision_check"},
    "Motions": {
        "moveJ": "Robot.move_j", "moveJToPose": "Robot.move_j_to_pose", "moveL": "Robot.move_l",
        "moveLToJoints": "Robot.move_l_to_joints", "movePath": "Robot.move_path",
        "moveUntilContact": "Robot.move_until_contact", "startJog": "Robot.jog", "startServoJ": "Robot.servo_j",
        "startServoL": "Robot.servo_l", "startServoC": "Robot.servo_c", "startSpeedJ": "Robot.speed_j",
        "startSpeedL": "Robot.speed_l", "startTorque": "Robot.torque", "stopJ": "Robot.stop_j", "stopL": "Robot.stop_l",
        "preparePath": UNLISTED_MOTION, "startPath": UNLISTED_MOTION},
    "Compliance": {
        "setForceMode": "Robot.force_mode", "endForceMode": "Robot.end_force_mode",
        "setForceDamping": "Tool.set_force_damping", "setForceGainScaling": "Tool.set_force_gain_scaling",
        "startFreedrive": "Robot.freedrive", "startTeachMode": UNLISTED_MOTION,
        "startContactDetection": "Queries.start_contact_detection", "hasContact": "Queries.has_contact",
        "endContactDetection": "Queries.end_contact_detection"},
    "ToolSetup": {
        "setPayload": "Robot.set_payload", "setTargetPayload": "Tool.set_target_payload", "setTcp": "Robot.set_tcp",
        "setGravity": "Tool.set_gravity", "zeroForceSensor": "Robot.zero_force_sensor",
        "useExternalSensor": "Tool.use_external_sensor", "useOwnSensor": "Tool.use_own_sensor",
        "useExternalSensorLegacy": Missing("the function name of old software, for ur_rtde"),
        "setExternalWrench": "Tool.set_external_wrench", "setWatchdog": "Tool.set_watchdog",
        "kickWatchdog": "Tool.kick_watchdog", "triggerProtectiveStop": "Tool.trigger_protective_stop"},
    "ArmQueries": {
        "inverseKinematics": "Robot.inverse_kinematics", "hasInverseKinematics": "Queries.has_inverse_kinematics",
        "forwardKinematics": "Robot.forward_kinematics", "isWithinSafetyLimits": "Queries.is_within_safety_limits",
        "jointTorques": "Queries.joint_torques", "isSteady": "Queries.is_steady", "toolContact": "Queries.tool_contact",
        "targetWaypoint": "Queries.target_waypoint", "jointPositionsHistory": "Queries.joint_positions_history",
        "stepTime": "Queries.step_time", "tcpOffset": "Queries.tcp_offset", "flangePose": "Queries.flange_pose",
        "freedriveStatus": "Queries.freedrive_status"},
    "Programs": {
        "startFunction": "Robot.run_function", "runScript": "Robot.run_script",
        "endControlProgram": Missing("Robot.release() ends it"), "reupload": Missing("Robot.take_control() sends it"),
        "isProgramRunning": "Sample.runtime_state", "controlProgram": Missing("tiller-cli prints it")},
    "CollisionCheck": {
        "at": "CollisionCheck.at", "obstruction": "CollisionCheck.along",
        "along": Missing("along() of Python keeps the safety distance; 0 gives this result"),
        "surroundings": Missing("the arguments of the constructor"),
        "safetyDistance": Missing("an argument of the constructor"), "isInside": Missing("used by the window"),
        "capsules": Missing("drawn in the view of the window"), "pairs": Missing("used by jogs"),
        "place": Missing("used by jogs"), "distance": Missing("used by jogs")},
    "OutputPulses": {"begin": "Pulses.begin", "end": "Pulses.end"},
    "Motion": {
        "id": Missing("identifies a motion in the status of C++"), "kind": "Move.__repr__", "isActive": "Move.active",
        "state": "Move.cause", "progress": "Move.progress", "plan": "Move.plan", "wait": "Move.wait",
        "setGate": Missing("permits the steps of a program; the window uses it"),
        "cancel": "Move.cancel", "stop": "Stream.stop", "refresh": "Jog.refresh"},
    "PacketLoop": dict.fromkeys(("servoJ", "servoL", "speedJ", "speedL", "torque"), "Robot.packet_loop"),
    "Outputs": {
        "connect": INTERNAL, "disconnect": INTERNAL, "isConnected": INTERNAL,
        "setDigitalOutputs": Missing("several outputs in one packet"), "setDigitalOutput": "Outputs.set_digital",
        "setSpeedSlider": "Outputs.set_speed_slider", "setAnalogOutput": "Outputs.set_voltage",
        "canSetDigitalOutput": Missing("the setters raise the reason"),
        "canSetSpeedSlider": Missing("the setters raise the reason"),
        "canSetAnalogOutput": Missing("the setters raise the reason")},
    "InputRegisters": {
        "fromReceiver": INTERNAL, "connect": "Robot.registers", "disconnect": Missing("ends with the object"), "isConnected": INTERNAL,
        "setInt": "Registers.set_int", "setDouble": "Registers.set_double", "setBit": "Registers.set_bit"},
    "Recorder": {
        "start": "Robot.record", "stop": "Recording.stop", "progress": "Recording.rows", "error": "Recording.stop",
        "note": Missing("notes have no Python API"), "notesError": Missing("notes have no Python API"), "path": "Recording.__repr__"},
    "Receiver": {
        "start": INTERNAL, "stop": INTERNAL, "state": "Robot.__repr__", "localPort": INTERNAL,
        "lastError": "Robot.wait_for_data", "counters": "Robot.link", "resetCounters": Missing("not needed for totals"),
        "intervals": Missing("the histogram has no Python API"), "version": "Robot.version",
        "period": Missing("period of the received data: Queries.step_time for control"),
        "absentFields": "Sample.__contains__", "priority": Missing("tiller.doctor reports it"),
        "layout": "Sample.fields", "latest": "Robot.state", "waitForData": "Robot.wait_for_data",
        "ageNs": "Robot.data_age", "isFresh": "Robot.data_age", "subscribe": "Robot.samples"},
    "ProgramExecution": {
        "script": "Program.script", "status": "ProgramRun.state", "isActive": "ProgramRun.active", "pause": "ProgramRun.pause",
        "resume": "ProgramRun.resume", "stepOnce": "ProgramRun.step_once", "setEndsWithCycle": "ProgramRun.finish_cycle",
        "stop": "ProgramRun.stop", "wait": "ProgramRun.wait", "variables": "ProgramRun.variables",
        "changeVariable": "ProgramRun.set_variable"},
    "Subscription": {
        "next": "Samples.__next__", "lost": "Samples.lost", "pending": "Samples.pending",
        "isValid": Missing("Samples is always valid")},
}


def public_functions(header, name):
    text = (ROBOT / header).read_text(encoding="utf-8")
    body = re.search(rf"^class {name} ?[^;{{]*\{{(.*?)^\}};", text, re.S | re.M)[1]
    body = re.sub(r"//.*", "", body.split("private:")[0])
    found = re.findall(r"^    (?:static )?(?:const )?[\w:]+(?:<[^()]*?>)?[ &*]+(\w+)\(", body, re.M)
    return {function for function in found if function != name}


class TestCompleteness(unittest.TestCase):
    def test_every_function_of_the_library_is_in_the_table(self):
        for header, classes in HEADERS.items():
            for name in classes:
                with self.subTest(name):
                    self.assertEqual(sorted(public_functions(header, name)), sorted(TABLE[name]))

    def test_every_counterpart_exists_and_is_documented(self):
        count = 0
        for functions in TABLE.values():
            for counterpart in functions.values():
                if isinstance(counterpart, Missing):
                    self.assertGreater(len(counterpart), 10)
                    continue
                with self.subTest(counterpart):
                    name, function = counterpart.split(".")
                    self.assertTrue(getattr(getattr(tiller, name), function).__doc__ or function.startswith("__"))
                    count += 1
        self.assertGreater(count, 80)

    def test_the_enumerations_have_the_names_of_the_library(self):
        """The names are those of C++, or the spelling of the controller; the numbers are those of RTDE."""
        for header, name in (("motion_types.h", "StopCause"), ("control_status.h", "ControlLoss"),
                             ("control_status.h", "LimiterKind")):
            text = (ROBOT / "control" / header).read_text(encoding="utf-8")
            body = re.search(rf"^enum class {name} : [\w:]+ {{(.*?)^}};", text, re.S | re.M)[1]
            with self.subTest(name):
                self.assertEqual([str(one) for one in getattr(tiller, name)],
                                 re.findall(r"^    (\w+)(?:,| =)", body, re.M))
        header = (ROBOT / "core" / "modes.h").read_text(encoding="utf-8")
        source = (ROBOT / "core" / "modes.cpp").read_text(encoding="utf-8")
        lists = (ROBOT / "core" / "mode_lists.h").read_text(encoding="utf-8")
        for table, name, numbers in (("kRobotModes", "RobotMode", modes.ROBOT_MODES),
                                     ("kSafetyModes", "SafetyMode", modes.SAFETY_MODES),
                                     ("kRuntimeStates", "RuntimeState", modes.RUNTIME_STATES)):
            rows = re.search(rf"{table} = .*?{{(.*?)}}\);", source, re.S)[1]
            expected = {}
            for value, text in re.findall(r'{(?:\w+::)?(\w+), "(\w+)"}', rows):
                number = re.search(rf"^    {value} = (-?\d+),", header, re.M) or re.search(rf"{value} = .*?\((\d+)\)", lists)
                expected[int(number[1])] = text
            with self.subTest(name):
                self.assertEqual({number: str(mode) for number, mode in numbers.items()}, expected)
                self.assertEqual(list(getattr(tiller, name)), list(numbers.values()))

    def test_calls_that_move_the_arm_are_in_the_table_of_ends(self):
        """Every Python call that starts a motion must have a row in ENDS.md."""
        ends = (ROBOT / "ENDS.md").read_text(encoding="utf-8")
        rows = ends.split("### Python (`tiller.Robot`)")[1].split("### ")[0]
        for name, functions in (("Motions", TABLE["Motions"]), ("Programs", TABLE["Programs"])):
            for counterpart in functions.values():
                call = counterpart.removeprefix("Robot.")
                if isinstance(counterpart, Missing) or call.startswith("stop_") or "." in call:
                    continue
                with self.subTest(call):
                    self.assertRegex(rows, rf"\| `{call}`")
        for call in ("Program.run", "Program.start"):
            self.assertRegex(rows, rf"\| `{call}`")


if __name__ == "__main__":
    unittest.main()
