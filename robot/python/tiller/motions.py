# SPDX-License-Identifier: MIT
"""Handles of what moves the arm. Whoever loses the handle lets the arm brake: keep it, or wait for it."""
from __future__ import annotations

import asyncio
import contextlib
import warnings
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Union

from . import _native
from ._values import ZEROS, Floats, floats
from .errors import Error

Waiting = Callable[[], AbstractContextManager[Any]]


@dataclass(frozen=True)
class Progress:
    """How far a motion is.

    active: accepted and not ended. cause: why it ended, as Move.cause. fraction: 0 ... 1 of the way, by the arm's actual
    place; 0 for motions without a known end, and again once it has ended before its target. waypoint, waypoints: of a
    path, the one headed for, from 1, and how many there are. executing: the robot confirmed that it executes this motion.
    speed_fraction: the speed slider, 0 ... 1. speed_scaling: what the controller's own limits leave of the speed, 0 ... 1.
    """

    active: bool  #: accepted and not ended
    cause: str  #: why it ended: "Completed", "ApiCall", "LinkLost"; "None" while it is active
    fraction: float  #: 0 ... 1 of the way, by the arm's actual place; 0 for motions without a known end
    waypoint: int  #: of a path, counted from 1: the one headed for
    waypoints: int  #: of a path: how many there are
    executing: bool  #: the robot confirmed that it executes this motion
    speed_fraction: float  #: the speed slider, 0 ... 1
    speed_scaling: float  #: what the controller's own limits leave of the speed, 0 ... 1


@dataclass(frozen=True)
class Plan:
    """What was decided when a move began; the speed slider and the robot's own limits may slow it down further.

    duration: from standstill to standstill, at a slider of 100 % [s]. speed: move_j: of the leading joint [rad/s]; move_l:
    of the TCP [m/s]. limiter: what keeps it below the speed asked for: "TcpSpeed" or "ElbowSpeed" (the speed cap),
    "RotationSpeed"; "None": nothing. scale: how much of the speed asked for that leaves, 0 ... 1.
    """

    duration: float  #: from standstill to standstill, at a slider of 100 % [s]
    speed: float  #: move_j: of the leading joint [rad/s]; move_l: of the TCP [m/s]
    limiter: str  #: what keeps it below the speed asked for: "TcpSpeed", "ElbowSpeed", "RotationSpeed"; "None"
    scale: float  #: how much of the speed asked for that leaves, 0 ... 1


class Move:
    """A motion with an end. `move.wait()` or `await move` returns when it is done and raises when it was stopped.

    Keep it: `robot.move_j(q)` alone starts and brakes at once. The arm brakes when the handle of the motion under way is
    dropped (one whose motion has ended, or gave way to a newer one, ends nothing), on Ctrl-C in wait(), when the task that
    awaits it is cancelled, and when the process dies.
    """

    def __init__(self, native: _native.Motion, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting

    def wait(self, timeout: float | None = None) -> None:
        """Returns when the target is reached. timeout [s]; None: as long as it takes.

        Raises Timeout (the motion goes on), Stopped (naming the cause), NoSolution, UnsafeState, LinkLost, NotInControl,
        ScriptError. On Ctrl-C the arm brakes and KeyboardInterrupt is raised.
        """
        try:
            with self._waiting():
                self._native.wait(timeout)
        except TimeoutError:
            raise
        except BaseException:
            self._native.cancel()
            raise

    def __await__(self) -> Generator[Any, None, None]:
        return self._finish().__await__()

    async def _finish(self) -> None:
        try:
            with self._waiting():
                while self._native.is_active():
                    await asyncio.sleep(0.002)
        except BaseException:
            self._native.cancel()
            raise
        self._native.wait(1.0)

    def cancel(self) -> bool:
        """Brakes the arm. Returns False when the motion had ended already; one that took its place goes on."""
        return self._native.cancel()

    @property
    def active(self) -> bool:
        """Whether the motion has not ended."""
        return self._native.is_active()

    @property
    def cause(self) -> str:
        """Why it ended, in a word; "None" while it is active.

        "Completed"; "ApiCall" (cancelled, or its `with` block ended); "Superseded" (by a newer command); "EventLoopStalled"
        (nobody refreshed it in time); "LimitReached"; "Contact"; "Unreachable" or "TargetTooFar" (a target of a stream);
        "UnsafeMode" (a protective stop and the like); "ControlLost" (the control program ended or was paused);
        "LinkLost"; "DataStale" (the robot's data came too late).
        """
        return self._native.cause()

    @property
    def progress(self) -> Progress:
        """How far it is."""
        return Progress(**self._native.progress())

    @property
    def plan(self) -> Plan | None:
        """How long it takes and what slows it down; None for paths and what has no known end."""
        told = self._native.plan()
        return None if told is None else Plan(**told)

    def __del__(self) -> None:
        native = getattr(self, "_native", None)
        if native is not None and native.kind() != "Stop" and native.is_active():
            native.cancel()
            warnings.warn("the handle of a move was dropped while the arm moved, so the arm brakes: keep the handle, "
                          "or call wait() on it", ResourceWarning, stacklevel=2)

    def __repr__(self) -> str:
        state = "active" if self.active else f"ended: {self.cause}"
        return f"<tiller.Move {self._native.kind()}, {state}>"


NativeStream = Union[_native.JointServo, _native.PoseServo, _native.JointSpeed, _native.ToolSpeed,
                     _native.JointTorque]


class Stream:
    """A stream of targets: send() a new one at least every 100 ms, or the arm brakes and the stream ends.

    It does not keep time for you: send one target, wait for the next control period (`for sample in robot.samples():`
    gives you one each), send the next. Robot.packet_loop() does that by itself, in step with the robot.
    Use it in a `with` block: at its end, whatever happened in it, the arm brakes.
    """

    def __init__(self, native: NativeStream, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting

    def send(self, target: Floats) -> None:
        """The next target. Returns at once and keeps only the newest: targets sent faster than one a period are never
        seen. Raises Stopped when the stream has ended, LimitExceeded for a target too far from the one
        before; a target that is refused has not been sent."""
        self._native.send(floats(target, "target"))

    def stop(self) -> None:
        """Brakes the arm and returns when it stands."""
        self._native.cancel()
        with self._waiting(), contextlib.suppress(Error):  # it was stopped: what else
            self._native.wait(5.0)

    @property
    def active(self) -> bool:
        """Whether the stream has not ended."""
        return self._native.is_active()

    @property
    def cause(self) -> str:
        """Why it ended; "None" while it is active."""
        return self._native.cause()

    def __enter__(self) -> Stream:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"<tiller.Stream, {'active' if self.active else 'ended: ' + self.cause}>"


class Jog:
    """A velocity the arm has while this is refreshed: at least every 100 ms, or the arm brakes and the jog ends.

    Use it in a `with` block: at its end, whatever happened in it, the arm brakes. A jog that ended takes a new one.
    """

    def __init__(self, native: _native.Jog, frame: str) -> None:
        self._native = native
        self._frame = frame

    def refresh(self, velocity: Floats | None = None) -> bool:
        """Keeps the jog alive, with another velocity if one is given. Returns False when it has ended."""
        if velocity is None:
            return self._native.refresh()
        return self._native.change(self._frame, floats(velocity, "velocity"), ZEROS, 0.0)

    def stop(self) -> None:
        """Brakes the arm and returns at once; it stands some 0.1 s later (robot.status["moving"])."""
        self._native.end()

    @property
    def active(self) -> bool:
        """Whether the jog has not ended."""
        return self._native.is_active()

    @property
    def cause(self) -> str:
        """Why it ended, as Move.cause; "None" while it is active. "EventLoopStalled": it was not refreshed in time."""
        return self._native.cause()

    def __enter__(self) -> Jog:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()

    def __repr__(self) -> str:
        return f"<tiller.Jog, {'active' if self.active else 'ended: ' + self.cause}>"


@dataclass(frozen=True)
class PathMove:
    """One move of a path. target and via: joint positions [rad], or with `pose` a pose in the base frame [m, rad]."""

    target: Floats
    kind: str = "j"  #: "j" in joint space, "l" a line, "p" a line at constant speed, "c" an arc through `via`
    pose: bool = False
    via: Floats | None = None
    speed: float = 1.0  #: "j" [rad/s], others [m/s]
    acceleration: float = 1.4  #: "j" [rad/s2], others [m/s2]
    blend: float = 0.0  #: radius around the target [m]

    def row(self) -> tuple[str, bool, list[float], list[float] | None, float, float, float]:
        """As the C++ library takes it."""
        via = None if self.via is None else floats(self.via, "via")
        return (self.kind, self.pose, floats(self.target, "target"), via, self.speed, self.acceleration, self.blend)
