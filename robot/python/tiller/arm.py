# SPDX-License-Identifier: MIT
"""Settings and queries of the connected robot: Robot.tool, Robot.queries and Robot.pulses. They require control and
never start a motion."""
from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _native
from ._arguments import checked
from ._values import ZEROS, Array, Floats, Joints, Pose, floats, joint_positions, pose_numbers

Waiting = Callable[[], AbstractContextManager[Any]]
TIMEOUT = 1.0


@dataclass(frozen=True)
class JointLimits:
    """Limits of the joints according to the configuration of the arm; arrays from base to wrist 3."""

    min_position: Array  #: [rad]
    max_position: Array  #: [rad]
    max_speed: Array  #: [rad/s]


class _Part:
    """A part of a Robot."""

    def __init__(self, native: _native.Controller, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting


@checked
class Tool(_Part):
    """Settings for the tool, the force sensor, force mode and the watchdog. Each call returns when the robot has
    confirmed it; timeout [s]. Raises NotInControl, LinkLost, Timeout, InvalidArgument, LimitExceeded,
    VersionUnsupported."""

    def set_target_payload(self, mass: float, centre_of_gravity: Floats, inertia: Floats,
                           timeout: float | None = TIMEOUT) -> None:
        """Sets mass [kg], centre of gravity from the flange [m] and inertia Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m2]. Since
        PolyScope 5.10. Without inertia: Robot.set_payload()."""
        cog, moments = floats(centre_of_gravity, "centre_of_gravity", 3), floats(inertia, "inertia")
        with self._waiting():
            self._native.set_target_payload(mass, cog, moments, timeout)

    def set_gravity(self, direction: Floats, timeout: float | None = TIMEOUT) -> None:
        """Sets the acceleration that compensates gravity, in the base frame [m/s2]: [0, 0, 9.82] for an upright robot."""
        vector = floats(direction, "direction", 3)
        with self._waiting():
            self._native.set_gravity(vector, timeout)

    def use_external_sensor(self, mass: float, measuring_offset: Floats = (0.0, 0.0, 0.0),
                            centre_of_gravity: Floats = (0.0, 0.0, 0.0), timeout: float | None = TIMEOUT) -> None:
        """Uses the forces from set_external_wrench() instead of the robot's sensor. mass: mass of the sensor [kg].
        measuring_offset, centre_of_gravity: relative to the flange [m]. The robot pauses the program if it receives no
        value for 100 ms."""
        offset = floats(measuring_offset, "measuring_offset", 3)
        cog = floats(centre_of_gravity, "centre_of_gravity", 3)
        with self._waiting():
            self._native.use_external_sensor(mass, offset, cog, timeout)

    def use_own_sensor(self, timeout: float | None = TIMEOUT) -> None:
        """Ends use_external_sensor()."""
        with self._waiting():
            self._native.use_own_sensor(timeout)

    def set_external_wrench(self, wrench: Floats) -> None:
        """Sends one measurement [N, Nm] with the next cycle. Does not wait."""
        self._native.set_external_wrench(floats(wrench, "wrench"))

    def set_watchdog(self, min_frequency: float, timeout: float | None = TIMEOUT) -> None:
        """Makes the robot end the program if kick_watchdog() is called less often than `min_frequency` [Hz]."""
        with self._waiting():
            self._native.set_watchdog(min_frequency, timeout)

    def kick_watchdog(self) -> None:
        """Resets the watchdog set by set_watchdog(). Does not wait."""
        self._native.kick_watchdog()

    def trigger_protective_stop(self, timeout: float | None = TIMEOUT) -> None:
        """Triggers a protective stop; returns when the robot reports it."""
        with self._waiting():
            self._native.trigger_protective_stop(timeout)

    def set_force_damping(self, damping: float, timeout: float | None = TIMEOUT) -> None:
        """Sets the damping of force mode, 0 ... 1."""
        with self._waiting():
            self._native.set_force_damping(damping, timeout)

    def set_force_gain_scaling(self, scaling: float, timeout: float | None = TIMEOUT) -> None:
        """Sets the gain of force mode, 0 ... 2."""
        with self._waiting():
            self._native.set_force_gain_scaling(scaling, timeout)


@checked
class Queries(_Part):
    """Values that the robot computes with its calibration, limits and sensors. A query typically takes 6 ms; timeout
    [s]. Raises NotInControl, LinkLost, Timeout, InvalidArgument, VersionUnsupported."""

    @property
    def joint_limits(self) -> JointLimits:
        """Limits of the joints."""
        low, high, speed = (np.array(numbers) for numbers in self._native.joint_limits())
        return JointLimits(low, high, speed)

    def has_inverse_kinematics(self, pose: Floats, near: Floats | None = None, timeout: float | None = TIMEOUT) -> bool:
        """True if Robot.inverse_kinematics() has a solution for this pose of the TCP [m, rad]."""
        numbers = pose_numbers(pose, "pose")
        start = None if near is None else joint_positions(near, "near")
        with self._waiting():
            return self._native.has_inverse_kinematics(numbers, start, timeout)

    def is_within_safety_limits(self, target: Floats, timeout: float | None = TIMEOUT) -> bool:
        """True if a pose of the TCP in the base frame [m, rad], or Joints [rad], is within the safety limits. A plain
        sequence is interpreted as a pose."""
        with self._waiting():
            if isinstance(target, Joints):
                return self._native.joints_are_within_safety_limits(joint_positions(target, "target"), timeout)
            return self._native.pose_is_within_safety_limits(pose_numbers(target, "target"), timeout)

    def joint_torques(self, timeout: float | None = TIMEOUT) -> Array:
        """Torques of the joints without gravity and friction [Nm]."""
        with self._waiting():
            return np.array(self._native.joint_torques(timeout))

    def is_steady(self, timeout: float | None = TIMEOUT) -> bool:
        """True if the arm has been at standstill for half a second."""
        with self._waiting():
            return self._native.is_steady(timeout)

    def tool_contact(self, direction: Floats = ZEROS, timeout: float | None = TIMEOUT) -> int:
        """Number of control periods since the tool came into contact; 0: no contact. direction: in the base frame."""
        vector = floats(direction, "direction")
        with self._waiting():
            return self._native.tool_contact(vector, timeout)

    def target_waypoint(self, timeout: float | None = TIMEOUT) -> Pose:
        """Target TCP pose of the current move [m, rad]."""
        with self._waiting():
            return Pose(self._native.target_waypoint(timeout))

    def joint_positions_history(self, steps: int, timeout: float | None = TIMEOUT) -> Joints:
        """Joint positions `steps` control periods ago [rad]."""
        with self._waiting():
            return Joints(self._native.joint_positions_history(steps, timeout))

    def step_time(self, timeout: float | None = TIMEOUT) -> float:
        """Control period [s]."""
        with self._waiting():
            return self._native.step_time(timeout)

    def tcp_offset(self, timeout: float | None = TIMEOUT) -> Pose:
        """Pose of the TCP in the flange frame [m, rad]."""
        with self._waiting():
            return Pose(self._native.tcp_offset(timeout))

    def flange_pose(self, timeout: float | None = TIMEOUT) -> Pose:
        """Pose of the flange in the base frame [m, rad]."""
        with self._waiting():
            return Pose(self._native.flange_pose(timeout))

    def freedrive_status(self, timeout: float | None = TIMEOUT) -> int:
        """Freedrive status: 0 normal, 1 near a singularity, 2 too close to a singularity. Since PolyScope 5.10."""
        with self._waiting():
            return self._native.freedrive_status(timeout)

    def start_contact_detection(self, direction: Floats = ZEROS, timeout: float | None = TIMEOUT) -> None:
        """Starts contact detection: a contact ends the current motion with the cause CONTACT. direction: direction of the
        contact in the base frame; zeros: direction of the tool motion."""
        vector = floats(direction, "direction")
        with self._waiting():
            self._native.start_contact_detection(vector, timeout)

    def has_contact(self, timeout: float | None = TIMEOUT) -> bool:
        """True if a contact occurred since the start of the detection."""
        with self._waiting():
            return self._native.has_contact(timeout)

    def end_contact_detection(self, timeout: float | None = TIMEOUT) -> bool:
        """Ends the detection; True if a contact occurred."""
        with self._waiting():
            return self._native.end_contact_detection(timeout)


@checked
class Pulses(_Part):
    """Pulses on digital outputs. The robot measures the time, and switches the outputs back
    even if this process ends. Outputs: 0-7 standard, 8-15 configurable, 16-17 tool; bit 0 of a mask is output 0."""

    def begin(self, mask: int, values: int, duration: float, *, held: bool = True,
              timeout: float | None = TIMEOUT) -> None:
        """Sets the outputs in `mask` to the bits of `values`, and inverts them after `duration` [s], at most 3600 s.
        held: a missing heartbeat of this process for 100 ms also ends the pulse."""
        with self._waiting():
            self._native.begin_pulses(mask, values, duration, held, timeout)

    def end(self, mask: int, timeout: float | None = TIMEOUT) -> None:
        """Ends the pulses of these outputs."""
        with self._waiting():
            self._native.end_pulses(mask, timeout)
