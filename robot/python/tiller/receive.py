# SPDX-License-Identifier: MIT
"""Robot data: samples with named fields, arrays, conditions, and recordings."""
from __future__ import annotations

import asyncio
import os
import time
from collections.abc import AsyncIterator, Callable, Generator, Iterator
from contextlib import AbstractContextManager
from types import TracebackType
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import _native
from ._arguments import checked
from ._values import Array, Joints, Pose, one_of
from .errors import NotConnected, Timeout
from .modes import ROBOT_MODES, RUNTIME_STATES, SAFETY_MODES, RobotMode, RuntimeState, SafetyMode

if TYPE_CHECKING:
    import pandas

Layout = dict[str, tuple[int, int]]
_TYPES: dict[str, Any] = {"actual_q": Joints, "target_q": Joints, "actual_TCP_pose": Pose, "target_TCP_pose": Pose}
DIGITAL_PINS = range(18)


class Sample:
    """All values of one data packet. Values that the robot does not send are NaN.

    sample["actual_q"] returns a field by its RTDE name: an array, or a float if the field is a single number; Joints
    and Pose for joint positions and TCP poses. The modes are unknown in a sample that Robot.state returned while the link
    was lost.
    """

    __slots__ = ("sequence", "host_time", "connection", "lost_before", "values", "_layout", "_connected")

    def __init__(self, parts: tuple[int, int, int, int, Array], layout: Layout, connected: bool = True) -> None:
        self.sequence = parts[0]  #: 1 for the first packet; 0: no data yet
        self.host_time = parts[1] * 1e-9  #: time of arrival on this machine's monotonic clock [s]
        self.connection = parts[2]  #: a change means that the stream was interrupted
        self.lost_before = parts[3]  #: packets lost immediately before this packet
        self.values = parts[4]  #: all numbers in the order of the fields
        self._layout = layout
        self._connected = connected

    def __getitem__(self, field: str) -> Any:
        place = self._layout.get(field)
        if place is None:
            raise KeyError(f"{field} is not received: add the field to Robot(..., fields=[...])")
        first, count = place
        if count == 1:
            return float(self.values[first])
        return self.values[first:first + count].view(_TYPES.get(field, np.ndarray))

    def __contains__(self, field: str) -> bool:
        place = self._layout.get(field)
        return place is not None and not np.isnan(self.values[place[0]])

    def fields(self) -> list[str]:
        """Names of the received fields."""
        return list(self._layout)

    def as_dict(self) -> dict[str, Any]:
        """All fields with their values."""
        return {name: self[name] for name in self._layout}

    def _vector(self, field: str) -> Array:
        place = self._layout.get(field)
        return np.full(6, np.nan) if place is None else self.values[place[0]:place[0] + place[1]]

    def _number(self, field: str) -> float:
        place = self._layout.get(field)
        return float("nan") if place is None else float(self.values[place[0]])

    def _code(self, field: str) -> int | None:
        """The number of a mode; None if unknown."""
        value = self._number(field)
        return None if np.isnan(value) or not self._connected else int(value)

    @property
    def time(self) -> float:
        """Time since the start of the controller [s]."""
        return self._number("timestamp")

    @property
    def q(self) -> Joints:
        """Actual joint positions [rad]."""
        return self._vector("actual_q").view(Joints)

    @property
    def qd(self) -> Array:
        """Actual joint velocities [rad/s]."""
        return self._vector("actual_qd")

    @property
    def target_q(self) -> Joints:
        """Target joint positions [rad]."""
        return self._vector("target_q").view(Joints)

    @property
    def tcp_pose(self) -> Pose:
        """Actual pose of the TCP in the base frame: position and rotation vector [m, rad]."""
        return self._vector("actual_TCP_pose").view(Pose)

    @property
    def tcp_speed(self) -> Array:
        """Actual speed of the TCP in the base frame [m/s, rad/s]."""
        return self._vector("actual_TCP_speed")

    @property
    def tcp_force(self) -> Array:
        """Force and torque on the TCP in the base frame [N, Nm]."""
        return self._vector("actual_TCP_force")

    @property
    def joint_current(self) -> Array:
        """Actual joint currents [A]."""
        return self._vector("actual_current")

    @property
    def speed_slider(self) -> float:
        """The speed slider, 0 ... 1."""
        return self._number("target_speed_fraction")

    @property
    def robot_mode(self) -> RobotMode:
        """Robot mode, e.g. RUNNING; DISCONNECTED if unknown."""
        code = self._code("robot_mode")
        return RobotMode.DISCONNECTED if code is None else ROBOT_MODES.get(code) or RobotMode(f"UNKNOWN_{code}")

    @property
    def safety_mode(self) -> SafetyMode:
        """Safety mode, e.g. NORMAL; UNDEFINED_SAFETY_MODE if unknown."""
        code = self._code("safety_mode")
        return SafetyMode.UNDEFINED_SAFETY_MODE if code is None else (SAFETY_MODES.get(code) or
                                                                     SafetyMode(f"UNKNOWN_{code}"))

    @property
    def runtime_state(self) -> RuntimeState:
        """Runtime state, e.g. PLAYING; STOPPED if unknown."""
        code = self._code("runtime_state")
        return RuntimeState.STOPPED if code is None else RUNTIME_STATES.get(code) or RuntimeState(f"UNKNOWN_{code}")

    def digital_input(self, number: int) -> bool | None:
        """One digital input: 0-7 standard, 8-15 configurable, 16-17 tool; None if unknown. Raises InvalidArgument for
        any other number."""
        return self._bit("actual_digital_input_bits", number)

    def digital_output(self, number: int) -> bool | None:
        """One digital output: 0-7 standard, 8-15 configurable, 16-17 tool; None if unknown. Raises InvalidArgument for
        any other number."""
        return self._bit("actual_digital_output_bits", number)

    def _bit(self, field: str, number: int) -> bool | None:
        one_of(number, "number", DIGITAL_PINS)
        bits = self._number(field)
        return None if np.isnan(bits) else bool(int(bits) >> number & 1)

    def __repr__(self) -> str:
        return f"<tiller.Sample {self.sequence}, t = {self.time:.3f} s, q = {np.round(self.q, 4).tolist()}>"


#: A stream is considered interrupted if no packet arrives for this time [s].
SILENT = 2.5
#: Interval between checks for data in a coroutine [s]. A Subscription cannot wake up an event loop.
_POLL = 0.001


@checked
class Samples(Iterator[Sample], AsyncIterator[Sample]):
    """Iterates over all packets from now on: `for sample in robot.samples():`, or `async for` in a coroutine.

    A slow reader loses the oldest packets, which are counted in `lost`; the buffer holds 8 s at 500 Hz. Ends when the
    robot is closed.
    """

    def __init__(self, native: _native.Subscription, layout: Layout, timeout: float | None,
                 waiting: Callable[[], AbstractContextManager[Any]]) -> None:
        self._native = native
        self._layout = layout
        self._timeout = timeout
        self._waiting = waiting

    def __iter__(self) -> Samples:
        return self

    def __next__(self) -> Sample:
        try:
            return self._next(self._timeout)
        except NotConnected:
            raise StopIteration from None

    def __aiter__(self) -> Samples:
        return self

    async def __anext__(self) -> Sample:
        try:
            return await self._next_async()
        except NotConnected:
            raise StopAsyncIteration from None

    def _next(self, timeout: float | None) -> Sample:
        """Waits for the next packet, timeout [s]. Raises Timeout, NotConnected (the robot was closed)."""
        parts = self._native.try_next()
        if parts is None:
            with self._waiting():
                parts = self._native.next(timeout)
        return Sample(parts, self._layout)

    async def _next_async(self) -> Sample:
        """Like _next(), without blocking the event loop. Also runs the other tasks if a packet is already available."""
        await asyncio.sleep(0)
        parts = self._native.try_next()
        if parts is None:
            with self._waiting():
                parts = await self._arrival()
        return Sample(parts, self._layout)

    async def _arrival(self) -> _native.SampleParts:
        end = float("inf") if self._timeout is None else time.monotonic() + self._timeout
        while True:
            # The last attempt raises Timeout. The attempts before it detect that the robot was closed.
            for _ in range(50):
                await asyncio.sleep(_POLL)
                parts = self._native.try_next()
                if parts is not None:
                    return parts
            try:
                return self._native.next(0.0)
            except Timeout:
                if time.monotonic() > end:
                    raise

    @property
    def lost(self) -> int:
        """Packets that were overwritten before they were read."""
        return self._native.lost()

    @property
    def pending(self) -> int:
        """Packets not yet read."""
        return self._native.pending()


class Condition:
    """A condition on the robot's data, see Robot.until(). `condition.wait()` or `await condition` returns the first
    sample that meets it. Every packet since Robot.until() is checked, so short events are not missed."""

    def __init__(self, samples: Samples, newest: Sample, test: Callable[[Sample], Any]) -> None:
        self._samples = samples
        self._given: Sample | None = newest
        self._test = test

    def _met(self, sample: Sample) -> bool:
        """Checks a sample. A sample that meets the condition is returned again by the next call."""
        met = bool(self._test(sample))
        self._given = sample if met else None
        return met

    def wait(self, timeout: float | None = None) -> Sample:
        """Waits until the condition is met, timeout [s]; None: no limit. Raises Timeout, also if no packet arrives for
        2.5 s; NotConnected; and any exception raised by the condition."""
        end = float("inf") if timeout is None else time.monotonic() + timeout
        while True:
            left = end - time.monotonic()
            sample = self._given or self._samples._next(min(SILENT, max(left, 0.0)))
            if self._met(sample):
                return sample
            if left < 0:
                raise Timeout("wait for a condition", f"not met within {timeout} s")

    def __await__(self) -> Generator[Any, None, Sample]:
        return self._wait_async().__await__()

    async def _wait_async(self) -> Sample:
        while not self._met(sample := self._given or await self._samples._next_async()):
            pass
        return sample


class Recording:
    """A recording with one row per packet, until stop(), the end of its `with` block, or the end of the program."""

    def __init__(self, native: _native.Recorder, path: str) -> None:
        self._native = native
        self.path = path

    def stop(self) -> None:
        """Writes the remaining rows and closes the file. Raises DiskFull or FileNotWritable if writing failed."""
        self._native.stop()

    @property
    def rows(self) -> int:
        """Rows in the file so far."""
        return int(self._native.progress()["rows"])

    @property
    def lost(self) -> int:
        """Packets missing from the file."""
        return int(self._native.progress()["lost"])

    def frame(self) -> pandas.DataFrame:
        """The recording as a pandas DataFrame; call stop() first."""
        return read_recording(self.path)

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"<tiller.Recording {self.path}, {self.rows} rows>"


def read_recording(path: str | os.PathLike[str], *, time_column: str | None = None,
                   time_unit: Literal["s", "ms", "us", "ns"] | None = None, table_rate: float | None = None,
                   table_separator: str | None = None, table_decimal: str | None = None,
                   no_header: bool = False) -> pandas.DataFrame:
    """Reads a recording (CSV, MCAP or HDF5, detected from its first bytes) as a pandas DataFrame with one row per
    packet and one column per number (timestamp, actual_q_0 ...); in CSV recordings also packages_lost, the number of
    packets missing before the row.

    The keyword arguments describe a CSV or HDF5 table that another program wrote. With any of them, and for HDF5
    tables without `timestamp`, the column `seconds` is the time since the first row [s]. Without any of them, a CSV
    file is read by pandas.read_csv(), which does not detect the time column. Arguments:
    time_column      name of the time column; "none": the table has no time column
    time_unit        unit of the time column: "s", "ms", "us" or "ns"
    table_rate       rows per second of a table without a time column [Hz]
    table_separator  comma, ";", "|", tab, or a space for any number of blanks
    table_decimal    decimal separator: "." or ","
    no_header        the first row is data; columns are named "column 1", "column 2", ...

    Raises OSError (including FileNotReadable), FileCorrupt, and InvalidArgument if the time of a table, its unit or
    its separator cannot be detected; the error contains the arguments to set.
    """
    import pandas

    name = os.fspath(path)
    options = (time_column, time_unit, table_rate or 0.0, table_separator, table_decimal, no_header)
    with open(name, "rb") as file:
        is_text = _native.format_of_content(file.read(8)) == "CSV"
    if is_text and options == (None, None, 0.0, None, None, False):
        return pandas.read_csv(name)
    return pandas.DataFrame(_native.read_recording(name, *options))
