# SPDX-License-Identifier: MIT
"""Handles of motions. A Move continues without its handle; a Stream or a Jog ends with it."""
from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Literal, Union

from . import _native
from ._arguments import checked
from ._values import Floats, Joints, Pose, floats, joint_positions, one_of, pose_numbers
from .errors import Error, InvalidArgument, Stopped, Timeout
from .modes import LimiterKind, StopCause

Waiting = Callable[[], AbstractContextManager[Any]]


@dataclass(frozen=True)
class Progress:
    """Progress of a motion.

    active: accepted and not ended. cause: cause of the end; see Move.cause. fraction: completed fraction of the path,
    0 ... 1, from the actual position of the arm; 0 for motions without a known end, and for motions that ended before the
    target. waypoint, waypoints: in a path, the current target (from 1) and the number of targets. executing: the robot has
    confirmed the execution of this motion. speed_fraction: the speed slider, 0 ... 1. speed_scaling: reduction by the
    controller's own limits, 0 ... 1.
    """

    active: bool  #: accepted and not ended
    cause: StopCause  #: cause of the end, e.g. COMPLETED, API_CALL, LINK_LOST; NONE while active
    fraction: float  #: completed fraction of the path, 0 ... 1; 0 for motions without a known end
    waypoint: int  #: in a path: current target, counted from 1
    waypoints: int  #: in a path: number of targets
    executing: bool  #: the robot has confirmed the execution of this motion
    speed_fraction: float  #: the speed slider, 0 ... 1
    speed_scaling: float  #: reduction by the controller's own limits, 0 ... 1


@dataclass(frozen=True)
class Plan:
    """Values computed at the start of a move. The speed slider and the robot's own limits may reduce the speed further.

    duration: from standstill to standstill, with the speed slider at 100 % [s]. speed: move_j: of the leading joint
    [rad/s]; move_l: of the TCP [m/s]. limiter: the limit that reduces the requested speed: TCP_SPEED or ELBOW_SPEED
    (the speed cap), ROTATION_SPEED; NONE: no limit. scale: factor applied to the requested speed, 0 ... 1.
    """

    duration: float  #: from standstill to standstill, with the speed slider at 100 % [s]
    speed: float  #: move_j: of the leading joint [rad/s]; move_l: of the TCP [m/s]
    limiter: LimiterKind  #: limit that reduces the requested speed: TCP_SPEED, ELBOW_SPEED, ROTATION_SPEED; NONE
    scale: float  #: factor applied to the requested speed, 0 ... 1


@checked
class Move:
    """An active motion. `move.wait()` or `await move` returns at its end and raises if it was stopped.

    The motion does not depend on this object: `robot.move_j(q)` alone also moves to its target. The arm stops on
    cancel(), Robot.stop(), the next motion, Robot.close() or the end of the robot's `with` block, on Ctrl+C or any
    other exception in wait(), when a task awaiting the motion is cancelled, on an uncaught exception (in a script, a thread,
    an interactive session or a notebook cell), and when the process ends.
    """

    def __init__(self, native: _native.Motion, waiting: Waiting) -> None:
        self._native = native
        self._waiting = waiting

    def wait(self, timeout: float | None = None) -> None:
        """Waits until the target is reached. timeout [s]; None: no limit.

        Raises Timeout (the motion continues), Stopped (with the cause), NoSolution, UnsafeState, LinkLost,
        NotInControl, ScriptError. On Ctrl+C the arm stops and KeyboardInterrupt is raised.
        """
        try:
            with self._waiting():
                self._native.wait(timeout)
        except Timeout:
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
        """Decelerates the arm and ends the motion, without waiting. Returns False if the motion has already ended; a motion
        that has replaced it is not affected."""
        return self._native.cancel()

    @property
    def active(self) -> bool:
        """True until the motion has ended."""
        return self._native.is_active()

    @property
    def cause(self) -> StopCause:
        """The cause of the end; NONE while the motion is active. `move.cause == "Completed"` is also possible.

        COMPLETED; API_CALL (cancelled, or its `with` block ended); SUPERSEDED (by a newer command); EVENT_LOOP_STALLED
        (not refreshed in time); LIMIT_REACHED; CONTACT; UNREACHABLE or TARGET_TOO_FAR (a target of a stream);
        UNSAFE_MODE (e.g. a protective stop); CONTROL_LOST (the control program ended or was paused); LINK_LOST;
        DATA_STALE (the robot's data arrived too late; wait() raises LinkLost with the measured times).
        """
        return StopCause(self._native.cause())

    @property
    def progress(self) -> Progress:
        """Progress of the motion."""
        values = self._native.progress()
        values["cause"] = StopCause(values["cause"])
        return Progress(**values)

    @property
    def plan(self) -> Plan | None:
        """Duration of the move and the limit that reduces its speed; None for paths and motions without a known end."""
        values = self._native.plan()
        if values is None:
            return None
        values["limiter"] = LimiterKind(values["limiter"])
        return Plan(**values)

    def __repr__(self) -> str:
        state = "active" if self.active else f"ended: {self.cause}"
        return f"<tiller.Move {self._native.kind()}, {state}>"


NativeStream = Union[_native.JointServo, _native.PoseServo, _native.CircularServo, _native.JointSpeed, _native.ToolSpeed,
                     _native.JointTorque]


def _at_standstill(native: NativeStream | _native.Jog, waiting: Waiting) -> None:
    with waiting():
        native.stop(5.0)


def _leave(native: NativeStream | _native.Jog, waiting: Waiting, error: BaseException | None) -> None:
    """Ends a `with` block; an exception that leaves the block is never replaced."""
    if error is None:
        _at_standstill(native, waiting)
        return
    native.cancel()
    with contextlib.suppress(Error):
        _at_standstill(native, waiting)


@checked
class Stream:
    """A stream of targets: call send() at least every 100 ms; otherwise, the arm stops and the stream ends.

    The stream does not provide timing: send one target, wait for the next control period (e.g. with `for sample in
    robot.samples():`), send the next. Robot.packet_loop() does this automatically, synchronized with the robot.
    Use it in a `with` block: the arm is at standstill when the block ends, even after an exception. The stream also
    ends when this object is deleted.
    """

    def __init__(self, native: NativeStream, waiting: Waiting, check: Callable[[Floats, str], list[float]]) -> None:
        self._native = native
        self._waiting = waiting
        self._check = check

    def send(self, target: Floats) -> None:
        """Sends the next target. Returns immediately and keeps only the newest target: if several are sent within a
        period, only the last one is used. Raises Stopped if the stream has ended, LimitExceeded for a target too far
        from the previous one; a refused target is not sent."""
        self._native.send(self._check(target, "target"))

    def stop(self) -> None:
        """Stops the arm and waits for standstill; returns immediately if another motion has replaced the stream.

        Raises Timeout if the arm still moves after 5 s, NotInControl if control was lost and standstill is not
        confirmed: the robot then decelerates automatically.
        """
        _at_standstill(self._native, self._waiting)

    @property
    def active(self) -> bool:
        """True until the stream has ended."""
        return self._native.is_active()

    @property
    def cause(self) -> StopCause:
        """The cause of the end; NONE while it is active."""
        return StopCause(self._native.cause())

    def __enter__(self) -> Stream:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        _leave(self._native, self._waiting, error)

    def __repr__(self) -> str:
        return f"<tiller.Stream, {'active' if self.active else f'ended: {self.cause}'}>"


@checked
class Jog:
    """A velocity of the arm that must be refreshed at least every 100 ms; otherwise, the arm stops and the jog ends.

    Use it in a `with` block: the arm is at standstill when the block ends, even after an exception. The jog also ends
    when this object is deleted. A jog that has ended cannot be refreshed: start a new jog.
    """

    def __init__(self, native: _native.Jog, frame: str, custom_frame: list[float], contact_force: float,
                 waiting: Waiting) -> None:
        self._native = native
        self._frame = frame
        self._custom_frame = custom_frame
        self._contact_force = contact_force
        self._waiting = waiting

    def refresh(self, velocity: Floats | None = None) -> bool:
        """Keeps the jog active, optionally with a new velocity. Returns False if the jog has ended."""
        if velocity is None:
            return self._native.refresh()
        return self._native.change(self._frame, floats(velocity, "velocity"), self._custom_frame, self._contact_force)

    def stop(self) -> None:
        """Stops the arm and waits for standstill, like Stream.stop()."""
        _at_standstill(self._native, self._waiting)

    @property
    def active(self) -> bool:
        """True until the jog has ended."""
        return self._native.is_active()

    @property
    def cause(self) -> StopCause:
        """The cause of the end, like Move.cause; NONE while it is active. EVENT_LOOP_STALLED: not refreshed in time."""
        return StopCause(self._native.cause())

    def __enter__(self) -> Jog:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None,
                 trace: TracebackType | None) -> None:
        _leave(self._native, self._waiting, error)

    def __repr__(self) -> str:
        return f"<tiller.Jog, {'active' if self.active else f'ended: {self.cause}'}>"


class ForceMode:
    """Force mode, active when Robot.force_mode() returns. Motions remain possible.

    In a `with` block, force mode always ends with the block; a nested block restores the settings of the outer block at
    its end. Without `with`, force mode lasts until stop(), Robot.end_force_mode(), Robot.stop(), Robot.close(), new
    settings, or 100 ms without a connection, even if this object is deleted. Settings ended by a stop are not restored at the
    end of a block.
    """

    def __init__(self, blocks: list[ForceMode], stops: Callable[[], int], begin: Callable[[list[float], int], None],
                 end: Callable[[], None], wrench: list[float]) -> None:
        self._blocks = blocks
        self._stops = stops
        self._send = begin
        self._end = end
        self._wrench = wrench
        self._begun_at = stops()
        self._ended = False
        self._begin()

    def _begin(self) -> None:
        self._send(self._wrench, self._begun_at)

    def change(self, wrench: Floats) -> None:
        """Changes the target wrench [N, Nm] without leaving force mode. Returns when the robot has confirmed it. In an
        outer `with` block, the change takes effect at the end of the inner block.

        Raises Stopped if force mode has ended, for example by a stop.
        """
        numbers = floats(wrench, "wrench")
        if self._ended or self._stops() != self._begun_at:
            raise Stopped("change the wrench of force mode", "force mode has ended: start it again")
        self._wrench = numbers
        if self not in self._blocks or self._blocks[-1] is self:
            self._begin()

    def stop(self) -> None:
        """Ends force mode, or restores the settings of the enclosing `with` block. No effect if it has ended.

        Raises NotInControl, LinkLost or Timeout if the robot does not confirm; force mode also ends with control.
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
            outermost_first[-1]._begin()
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


PathKind = Literal["j", "l", "p", "c"]
PATH_KINDS: tuple[PathKind, ...] = ("j", "l", "p", "c")


@dataclass(frozen=True)
class PathMove:
    """One move of a path.

    target, via: Joints [rad] or a Pose in the base frame [m, rad]. Six plain numbers are joint positions for kind "j"
    and a pose for all other kinds, unless `pose` is True (pose) or False (joint positions).
    Raises InvalidArgument for an unknown kind, for a `pose` that contradicts the type of target or via, and for values
    other than six numbers.
    """

    target: Floats
    kind: PathKind = "j"  #: "j": joint space, "l": line, "p": line at constant speed, "c": arc through `via`
    pose: bool | None = None  #: target and via are poses; None: depends on their class or on the kind
    via: Floats | None = None  #: "c": a point on the arc (orientation ignored)
    speed: float | None = None  #: "j" [rad/s], others [m/s]; None: 1.05 and 0.25, or the speed cap if lower
    acceleration: float | None = None  #: "j" [rad/s2], others [m/s2]; None: 1.4 and 1.2
    blend: float = 0.0  #: blend radius at the target [m]

    def __post_init__(self) -> None:
        one_of(self.kind, "kind", PATH_KINDS)
        self.row()

    def _place(self, values: Floats, name: str) -> tuple[bool, list[float]]:
        """Returns (True for a pose, the numbers)."""
        pose = self.pose
        if pose is None:
            pose = isinstance(values, Pose) or (self.kind != "j" and not isinstance(values, Joints))
        if not isinstance(pose, bool):
            raise InvalidArgument("pose", "must be True, False or None")
        return pose, pose_numbers(values, name) if pose else joint_positions(values, name)

    def row(self) -> _native.PathRow:
        """Converts the move to an argument for the C++ library."""
        via = None if self.via is None else self._place(self.via, "via")
        return (self.kind, self._place(self.target, "target"), via, self.speed, self.acceleration, self.blend)
