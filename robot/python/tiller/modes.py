# SPDX-License-Identifier: MIT
"""Modes and causes. Every member is equal to its name as a string: `sample.robot_mode == "RUNNING"`."""
from __future__ import annotations

import enum
from typing import Any


class Name(str, enum.Enum):
    """A name that compares and prints like a string."""

    def __str__(self) -> str:
        return str(self.value)

    @classmethod
    def _missing_(cls, value: object) -> Any:
        """Creates a member for a value that this version does not define: UNKNOWN_ and the number of the value."""
        if not isinstance(value, str) or not value.startswith("UNKNOWN_"):
            return None
        member = str.__new__(cls, value)
        member._name_ = member._value_ = value
        return member


class RobotMode(Name):
    """Robot mode, in the spelling of the controller."""

    NO_CONTROLLER = "NO_CONTROLLER"
    DISCONNECTED = "DISCONNECTED"
    CONFIRM_SAFETY = "CONFIRM_SAFETY"
    BOOTING = "BOOTING"
    POWER_OFF = "POWER_OFF"
    POWER_ON = "POWER_ON"
    IDLE = "IDLE"
    BACKDRIVE = "BACKDRIVE"
    RUNNING = "RUNNING"
    UPDATING_FIRMWARE = "UPDATING_FIRMWARE"


class SafetyMode(Name):
    """Safety mode, in the spelling of the controller."""

    NORMAL = "NORMAL"
    REDUCED = "REDUCED"
    PROTECTIVE_STOP = "PROTECTIVE_STOP"
    RECOVERY = "RECOVERY"
    SAFEGUARD_STOP = "SAFEGUARD_STOP"
    SYSTEM_EMERGENCY_STOP = "SYSTEM_EMERGENCY_STOP"
    ROBOT_EMERGENCY_STOP = "ROBOT_EMERGENCY_STOP"
    VIOLATION = "VIOLATION"
    FAULT = "FAULT"
    VALIDATE_JOINT_ID = "VALIDATE_JOINT_ID"
    UNDEFINED_SAFETY_MODE = "UNDEFINED_SAFETY_MODE"
    AUTOMATIC_MODE_SAFEGUARD_STOP = "AUTOMATIC_MODE_SAFEGUARD_STOP"
    SYSTEM_THREE_POSITION_ENABLING_STOP = "SYSTEM_THREE_POSITION_ENABLING_STOP"
    TP_THREE_POSITION_ENABLING_STOP = "TP_THREE_POSITION_ENABLING_STOP"
    IMMI_EMERGENCY_STOP = "IMMI_EMERGENCY_STOP"
    IMMI_SAFEGUARD_STOP = "IMMI_SAFEGUARD_STOP"
    PROFISAFE_WAITING_FOR_PARAMETERS = "PROFISAFE_WAITING_FOR_PARAMETERS"
    PROFISAFE_AUTOMATIC_MODE_SAFEGUARD_STOP = "PROFISAFE_AUTOMATIC_MODE_SAFEGUARD_STOP"
    PROFISAFE_SAFEGUARD_STOP = "PROFISAFE_SAFEGUARD_STOP"
    PROFISAFE_EMERGENCY_STOP = "PROFISAFE_EMERGENCY_STOP"
    SAFETY_API_SAFEGUARD_STOP = "SAFETY_API_SAFEGUARD_STOP"
    IO_PLANE_STOP = "IO_PLANE_STOP"


class RuntimeState(Name):
    """State of the program on the robot, in the spelling of the controller."""

    STOPPING = "STOPPING"
    STOPPED = "STOPPED"
    PLAYING = "PLAYING"
    PAUSING = "PAUSING"
    PAUSED = "PAUSED"
    RESUMING = "RESUMING"


class StopCause(Name):
    """Why a motion ended; NONE while it is active. See Move.cause."""

    NONE = "None"
    RELEASED = "Released"
    POINTER_LEFT = "PointerLeft"
    FOCUS_LOST = "FocusLost"
    WINDOW_DEACTIVATED = "WindowDeactivated"
    WINDOW_CLOSED = "WindowClosed"
    DIALOG_OPENED = "DialogOpened"
    SELECTION_CHANGED = "SelectionChanged"
    SECOND_BUTTON = "SecondButton"
    ESCAPE = "Escape"
    SPACE = "Space"
    STOP_BUTTON = "StopButton"
    DEVICE_LOST = "DeviceLost"
    DATA_STALE = "DataStale"
    UNSAFE_MODE = "UnsafeMode"
    EVENT_LOOP_STALLED = "EventLoopStalled"
    SLEEP = "Sleep"
    LINK_LOST = "LinkLost"
    LIMIT_REACHED = "LimitReached"
    CONTROL_LOST = "ControlLost"
    COMPLETED = "Completed"
    API_CALL = "ApiCall"
    SUPERSEDED = "Superseded"
    CONTACT = "Contact"
    UNREACHABLE = "Unreachable"
    TARGET_TOO_FAR = "TargetTooFar"
    HOLD_UNPROVEN = "HoldUnproven"
    HELD_TOO_LONG = "HeldTooLong"


class ControlLoss(Name):
    """Why motions cannot be commanded; NONE while in control."""

    NONE = "None"
    NOT_TAKEN = "NotTaken"
    TAKING = "Taking"
    RELEASED = "Released"
    SCRIPT_STOPPED = "ScriptStopped"
    ECHO_STALLED = "EchoStalled"
    LINK_LOST = "LinkLost"
    OWN_SCRIPT = "OwnScript"
    DATA_STALE = "DataStale"


class LimiterKind(Name):
    """The limit that reduces a speed."""

    NONE = "None"
    TCP_SPEED = "TcpSpeed"
    ELBOW_SPEED = "ElbowSpeed"
    JOG_SPEED = "JogSpeed"
    ROTATION_SPEED = "RotationSpeed"
    JOINT_SPEED = "JointSpeed"
    JOINT_LIMIT = "JointLimit"
    SINGULARITY = "Singularity"
    SELF_COLLISION = "SelfCollision"
    OBSTACLE = "Obstacle"
    BORDER = "Border"


# The members by RTDE number.
ROBOT_MODES = {-1: RobotMode.NO_CONTROLLER, 0: RobotMode.DISCONNECTED, 1: RobotMode.CONFIRM_SAFETY,
               2: RobotMode.BOOTING, 3: RobotMode.POWER_OFF, 4: RobotMode.POWER_ON, 5: RobotMode.IDLE,
               6: RobotMode.BACKDRIVE, 7: RobotMode.RUNNING, 8: RobotMode.UPDATING_FIRMWARE}
SAFETY_MODES = {1: SafetyMode.NORMAL, 2: SafetyMode.REDUCED, 3: SafetyMode.PROTECTIVE_STOP, 4: SafetyMode.RECOVERY,
                5: SafetyMode.SAFEGUARD_STOP, 6: SafetyMode.SYSTEM_EMERGENCY_STOP, 7: SafetyMode.ROBOT_EMERGENCY_STOP,
                8: SafetyMode.VIOLATION, 9: SafetyMode.FAULT, 10: SafetyMode.VALIDATE_JOINT_ID,
                11: SafetyMode.UNDEFINED_SAFETY_MODE, 12: SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP,
                13: SafetyMode.SYSTEM_THREE_POSITION_ENABLING_STOP, 14: SafetyMode.TP_THREE_POSITION_ENABLING_STOP,
                15: SafetyMode.IMMI_EMERGENCY_STOP, 16: SafetyMode.IMMI_SAFEGUARD_STOP,
                17: SafetyMode.PROFISAFE_WAITING_FOR_PARAMETERS,
                18: SafetyMode.PROFISAFE_AUTOMATIC_MODE_SAFEGUARD_STOP, 19: SafetyMode.PROFISAFE_SAFEGUARD_STOP,
                20: SafetyMode.PROFISAFE_EMERGENCY_STOP, 22: SafetyMode.SAFETY_API_SAFEGUARD_STOP,
                23: SafetyMode.IO_PLANE_STOP}
RUNTIME_STATES = {0: RuntimeState.STOPPING, 1: RuntimeState.STOPPED, 2: RuntimeState.PLAYING, 3: RuntimeState.PAUSING,
                  4: RuntimeState.PAUSED, 5: RuntimeState.RESUMING}
