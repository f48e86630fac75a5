# SPDX-License-Identifier: MIT
"""Outputs, registers, and functions of the teach pendant: power, programs, recovery."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Literal

from . import _native
from ._arguments import checked
from .errors import InvalidArgument

Waiting = Callable[[], AbstractContextManager[Any]]
TIMEOUT = 3.0


@checked
class Outputs:
    """Sets outputs and the speed slider, with or without a running program. Each call returns when the robot reports
    the new value. Raises Timeout if it does not, RegisterInUse if another client or a fieldbus uses the RTDE input."""

    def __init__(self, native: _native.Outputs, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting

    def set_digital(self, output: int, on: bool, timeout: float | None = TIMEOUT) -> None:
        """Sets a digital output: 0-7 standard, 8-15 configurable, 16-17 tool."""
        with self._waiting():
            self._native.set_digital(output, on, timeout)

    def set_voltage(self, output: int, volts: float, timeout: float | None = TIMEOUT) -> None:
        """Sets analog output 0 or 1 to a voltage, 0 ... 10 [V]."""
        with self._waiting():
            self._native.set_analog(output, True, volts / 10.0, timeout)

    def set_current(self, output: int, amperes: float, timeout: float | None = TIMEOUT) -> None:
        """Sets analog output 0 or 1 to a current, 0.004 ... 0.020 [A]."""
        with self._waiting():
            self._native.set_analog(output, False, (amperes - 0.004) / 0.016, timeout)

    def set_speed_slider(self, fraction: float, timeout: float | None = TIMEOUT) -> None:
        """Sets the speed slider, 0.02 ... 1. Lower values are refused, because 0 has caused
        protective stops."""
        with self._waiting():
            self._native.set_speed_slider(fraction, timeout)


@checked
class Registers:
    """General purpose input registers, for programs on the robot that read them: see Robot.registers()."""

    def __init__(self, native: _native.InputRegisters, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting

    def set_int(self, number: int, value: int, timeout: float | None = TIMEOUT) -> None:
        """Writes an integer register listed in Robot.registers()."""
        with self._waiting():
            self._native.set_int(number, value, timeout)

    def set_double(self, number: int, value: float, timeout: float | None = TIMEOUT) -> None:
        """Writes a double register listed in Robot.registers()."""
        with self._waiting():
            self._native.set_double(number, value, timeout)

    def set_bit(self, number: int, value: bool, timeout: float | None = TIMEOUT) -> None:
        """Writes a bit register, 64-127, listed in Robot.registers()."""
        with self._waiting():
            self._native.set_bit(number, value, timeout)


@dataclass(frozen=True)
class Service:
    """State of the robot that RTDE does not report."""

    kind: Literal["Dashboard", "RobotApi"]
    remote_control: bool | None  #: None if the software does not report it
    operational_mode: str  #: "MANUAL", "AUTOMATIC"; empty: not set or not reported
    program: str  #: loaded program; empty: none or not reported


@checked
class Dashboard:
    """Power, programs and the teach pendant: the dashboard server of CB3 and e-Series, the Robot API of PolyScope X."""

    def __init__(self, host: str, port_offset: int, waiting: Waiting) -> None:
        self._host = host
        self._port_offset = port_offset
        self._waiting = waiting

    def _open(self, timeout: float | None) -> _native.Service:
        return _native.Service(self._host, self._port_offset, timeout)

    def _perform(self, command: str, timeout: float | None) -> None:
        with self._waiting():
            self._open(timeout).perform(command, timeout)

    def power_on(self, timeout: float | None = TIMEOUT) -> None:
        """Switches on the power of the arm."""
        self._perform("PowerOn", timeout)

    def release_brakes(self, timeout: float | None = TIMEOUT) -> None:
        """Releases the brakes; the arm may move slightly."""
        self._perform("ReleaseBrakes", timeout)

    def power_off(self, timeout: float | None = TIMEOUT) -> None:
        """Switches off the power of the arm."""
        self._perform("PowerOff", timeout)

    def restart_safety(self, timeout: float | None = TIMEOUT) -> None:
        """Restarts the safety system after a violation or a fault; leaves the arm powered off."""
        self._perform("RestartSafety", timeout)

    def close_popups(self, timeout: float | None = TIMEOUT) -> None:
        """Closes the popups on the teach pendant."""
        self._perform("ClosePopups", timeout)

    def play(self, timeout: float | None = TIMEOUT) -> None:
        """Starts or resumes the loaded program."""
        self._perform("Play", timeout)

    def pause(self, timeout: float | None = TIMEOUT) -> None:
        """Pauses the program."""
        self._perform("Pause", timeout)

    def stop_program(self, timeout: float | None = TIMEOUT) -> None:
        """Stops the program."""
        self._perform("StopProgram", timeout)

    def load_program(self, name: str, timeout: float | None = TIMEOUT) -> None:
        """Loads the program with this name from the controller's programs folder."""
        with self._waiting():
            self._open(timeout).load_program(name, timeout)

    def unlock_protective_stop(self, timeout: float | None = TIMEOUT) -> None:
        """Unlocks a protective stop. Requires an explicit confirmation by a person who has inspected the cause: see
        Robot.recover()."""
        with self._waiting():
            self._open(timeout).unlock_protective_stop(timeout)

    def look(self, timeout: float | None = TIMEOUT) -> Service:
        """Returns the operational mode, the loaded program, and whether the robot is in remote control."""
        with self._waiting():
            return Service(**self._open(timeout).look(timeout))


@dataclass(frozen=True)
class Consent:
    """The steps of one recovery that a person permits. The default permits nothing, so that error handling
    alone cannot unlock a robot."""

    cause_inspected: bool = False  #: the cause was inspected: required to unlock a protective stop
    restart_safety: bool = False  #: the safety system may be restarted after a violation or fault; the arm loses power
    power_on: bool = False  #: the arm may be powered on
    release_brakes: bool = False  #: the brakes may be released; the arm may move slightly


def registers(host: str, port: int, ints: Sequence[int], doubles: Sequence[int], bits: Sequence[int],
              timeout: float | None, waiting: Waiting) -> Registers:
    """Opens a connection that uses these input registers."""
    if not (ints or doubles or bits):
        raise InvalidArgument("registers", "specify at least one register")
    with waiting():
        return Registers(_native.InputRegisters(host, port, list(ints), list(doubles), list(bits), timeout), waiting)
