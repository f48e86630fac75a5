# SPDX-License-Identifier: MIT
"""Handles of motions. A Move goes on without its handle; a Stream or a Jog ends with it."""
from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Union

from . import _native
from ._arguments import checked
from ._values import Floats, Joints, Pose, floats, joint_positions, one_of, pose_numbers
from .errors import Error, InvalidArgument

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


@checked
class Move:
    """A motion under way. `move.wait()` or `await move` returns at its end and raises when it was stopped.

    The motion does not depend on this object: `robot.move_j(q)` alone runs to its target too. The arm brakes on cancel(),
    Robot.stop(), the next motion, Robot.close() or the end of the robot's `with` block, on Ctrl-C or any other exception
    in wait(), when the task that awaits it is cancelled, on an exception that nothing catches (in a script, a thread, an
    interactive session or a notebook cell), and when the process ends.
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
        """Brakes the arm and returns at once. Returns False when the motion had ended already; a motion that took its
        place goes on."""
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

    def __repr__(self) -> str:
        state = "active" if self.active else f"ended: {self.cause}"
        return f"<tiller.Move {self._native.kind()}, {state}>"


NativeStream = Union[_native.JointServo, _native.PoseServo, _native.JointSpeed, _native.ToolSpeed,
                     _native.JointTorque]


def _at_standstill(native: NativeStream | _native.Jog, waiting: Waiting) -> None:
    with waiting():
        native.stop(5.0)


def _leave(native: NativeStream | _native.Jog, waiting: Waiting, error: BaseException | None) -> None:
    """The end of a `with` block; an exception on its way out of the block is never replaced."""
    if error is None:
        _at_standstill(native, waiting)
        return
    native.cancel()
    with contextlib.suppress(Error):
        _at_standstill(native, waiting)


@checked
class Stream:
    """A stream of targets: send() a new one at least every 100 ms, or the arm brakes and the stream ends.

    It does not keep time for you: send one target, wait for the next control period (`for sample in robot.samples():`
    gives you one each), send the next. Robot.packet_loop() does that by itself, in step with the robot.
    Use it in a `with` block: whatever happens in the block, the arm brakes at its end and is at standstill afterwards.
    The stream also ends when this object is dropped.
    """

    def __init__(self, native: NativeStream, waiting: Waiting, check: Callable[[Floats, str], list[float]]) -> None:
        self._native = native
        self._waiting = waiting
        self._check = check

    def send(self, target: Floats) -> None:
        """The next target. Returns at once and keeps only the newest: targets sent faster than one a period are never
        seen. Raises Stopped when the stream has ended, LimitExceeded for a target too far from the one
        before; a target that is refused has not been sent."""
        self._native.send(self._check(target, "target"))

    def stop(self) -> None:
        """Brakes the arm and returns when it is at standstill; at once when another motion has taken over.

        Raises Timeout when the arm still moves after 5 s, NotInControl when control was lost and standstill is not
        confirmed: then the robot brakes by itself.
        """
        _at_standstill(self._native, self._waiting)

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
        _leave(self._native, self._waiting, error)

    def __repr__(self) -> str:
        return f"<tiller.Stream, {'active' if self.active else 'ended: ' + self.cause}>"


@checked
class Jog:
    """A velocity the arm has while this is refreshed: at least every 100 ms, or the arm brakes and the jog ends.

    Use it in a `with` block: whatever happens in the block, the arm brakes at its end and is at standstill afterwards.
    The jog also ends when this object is dropped. A jog that has ended cannot be refreshed: begin a new one.
    """

    def __init__(self, native: _native.Jog, frame: str, custom_frame: list[float], contact_force: float,
                 waiting: Waiting) -> None:
        self._native = native
        self._frame = frame
        self._custom_frame = custom_frame
        self._contact_force = contact_force
        self._waiting = waiting

    def refresh(self, velocity: Floats | None = None) -> bool:
        """Keeps the jog alive, with another velocity if one is given. Returns False when it has ended."""
        if velocity is None:
            return self._native.refresh()
        return self._native.change(self._frame, floats(velocity, "velocity"), self._custom_frame, self._contact_force)

    def stop(self) -> None:
        """Brakes the arm and returns when it is at standstill, as Stream.stop()."""
        _at_standstill(self._native, self._waiting)

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
        _leave(self._native, self._waiting, error)

    def __repr__(self) -> str:
        return f"<tiller.Jog, {'active' if self.active else 'ended: ' + self.cause}>"


class ForceMode:
    """Force mode, on since Robot.force_mode() returned: motions may run meanwhile.

    In a `with` block it ends with the block, whatever happens in the block; a block inside another one restores the
    settings of the outer block at its end. Without `with` it lasts until stop(), Robot.end_force_mode(), Robot.stop(),
    Robot.close(), other settings or 100 ms without a connection, also when this object is dropped. What a stop has ended
    does not begin again at the end of a block.
    """

    def __init__(self, blocks: list[ForceMode], stops: Callable[[], int], begin: Callable[[int], None],
                 end: Callable[[], None]) -> None:
        self._blocks = blocks
        self._stops = stops
        self._begin = begin
        self._end = end
        self._begun_at = stops()
        self._ended = False
        begin(self._begun_at)

    def stop(self) -> None:
        """Ends force mode, or restores the settings of the enclosing `with` block. Harmless when it has ended.

        Raises NotInControl, LinkLost or Timeout when the robot does not confirm it; force mode does not outlive control.
        """
        if self._ended:
            return
        self._ended = True
        outermost_first = [block for block in self._blocks if block is not self]
        inner_goes_on = self in self._blocks and self._blocks[-1] is not self
        self._blocks[:] = outermost_first
        if inner_goes_on or self._stops() != self._begun_at:
            return
        if outermost_first and outermost_first[-1]._begun_at == self._begun_at:
            outermost_first[-1]._begin(self._begun_at)
        else:
            self._end()

    def __enter__(self) -> ForceMode:
        self._blocks.append(self)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        try:
            self.stop()
        except Error:
            if error is None:
                raise


PATH_KINDS = ("j", "l", "p", "c")


@dataclass(frozen=True)
class PathMove:
    """One move of a path.

    target, via: Joints [rad] or a Pose in the base frame [m, rad]. Six plain numbers are joint positions for kind "j" and
    a pose for all other kinds; `pose` says otherwise: True for a pose, False for joint positions.
    Raises InvalidArgument for an unknown kind, for a `pose` that contradicts the type of target or via, and for what is
    not six numbers.
    """

    target: Floats
    kind: str = "j"  #: "j" in joint space, "l" a line, "p" a line at constant speed, "c" an arc through `via`
    pose: bool | None = None  #: what target and via are; None: by their type, or by the kind
    via: Floats | None = None  #: "c": a point on the arc; only its position counts
    speed: float | None = None  #: "j" [rad/s], others [m/s]; None: 1.05 and 0.25, or the speed cap where that is lower
    acceleration: float | None = None  #: "j" [rad/s2], others [m/s2]; None: 1.4 and 1.2
    blend: float = 0.0  #: radius around the target [m]

    def __post_init__(self) -> None:
        one_of(self.kind, "kind", PATH_KINDS)
        self.row()

    def _place(self, values: Floats, name: str) -> tuple[bool, list[float]]:
        """(whether it is a pose, the numbers)"""
        pose = self.pose
        if pose is None:
            pose = isinstance(values, Pose) or (self.kind != "j" and not isinstance(values, Joints))
        if not isinstance(pose, bool):
            raise InvalidArgument("pose", "True, False or None")
        return pose, pose_numbers(values, name) if pose else joint_positions(values, name)

    def row(self) -> _native.PathRow:
        """As the C++ library takes it."""
        via = None if self.via is None else self._place(self.via, "via")
        return (self.kind, self._place(self.target, "target"), via, self.speed, self.acceleration, self.blend)
