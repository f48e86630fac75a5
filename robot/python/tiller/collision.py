# SPDX-License-Identifier: MIT
"""Collisions of the arm with itself, boxes and planes, and limits of a move before it is executed.

    table = collision.Plane([0, 0, -0.02, 0, 0, 0], name="table")
    check = collision.CollisionCheck("UR5e", planes=[table], boxes=[collision.Box([0.5, 0, 0.1, 0, 0, 0], [0.2, 0.2, 0.2])])
    report = check.examine(robot.state.q, target)
    if report.blocked:
        print(report.limit, report.contact)

The model uses the nominal dimensions of the arm.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from . import _native
from ._arguments import checked
from ._values import ZEROS, Floats, Joints, floats, joint_positions, pose_numbers
from .errors import InvalidArgument

MoveLimit = Literal["out_of_reach", "joint_range", "singularity", "near_singularity", "collision"]
#: Smallest size [m], speed and acceleration.
SMALLEST = 1e-4
LINKS = {0: "base", 1: "shoulder", 2: "upper arm", 3: "forearm", 4: "wrist 1", 5: "wrist 2", 6: "wrist 3", 7: "tool"}


@dataclass(frozen=True)
class Box:
    """A solid box."""

    pose: Floats  #: pose of the centre in the base frame; the edges are parallel to the axes of this pose [m, rad]
    size: Floats  #: edges along X, Y, Z [m]
    name: str = "box"


@dataclass(frozen=True)
class Plane:
    """A plane that the arm must not cross: the XY plane of its pose. The arm stays on the +Z side."""

    pose: Floats  #: in the base frame [m, rad]
    name: str = "plane"


@dataclass(frozen=True)
class Contact:
    """Two bodies that touch, or are closer than the safety distance."""

    link: str  #: link of the arm: "base", "shoulder", "upper arm", "forearm", "wrist 1", "wrist 2", "wrist 3", "tool"
    other: str  #: the other link, or the name of the box or plane
    with_arm: bool  #: the other body is a link of the arm
    at: float  #: position on the path: 2.25 is a quarter of the distance from the third position to the fourth
    q: Joints  #: joint positions at the contact [rad]
    distance: float  #: between the bodies [m]; negative if they penetrate


@dataclass(frozen=True)
class MoveReport:
    """Result of CollisionCheck.examine()."""

    duration: float  #: duration of the whole move, with the speed slider at 100 % [s]
    limit: MoveLimit | None  #: the first limit; None: no limit
    blocked: bool  #: the move ends at this limit. Near a singularity, the move only slows down
    fraction: float  #: position of the limit on the path, 0 ... 1; 1: no limit
    joint: int | None  #: limiting joint 0-5 for "joint_range"; otherwise None
    contact: Contact | None  #: the contact for "collision"; otherwise None


def _number(value: float, name: str, least: float) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number) or number < least:
        raise InvalidArgument(name, f"{value!r} is not a number of at least {least:g}")
    return number


def _contact(parts: tuple[int, int | None, str | None, float, list[float], float] | None) -> Contact | None:
    if parts is None:
        return None
    link, other_link, name, at, q, distance = parts
    other = str(name) if other_link is None else LINKS[other_link]
    return Contact(LINKS[link], other, other_link is not None, at, Joints(q), distance)


@checked
class CollisionCheck:
    """Checks the distances of an arm from itself and its surroundings.

    model: e.g. "UR5e". boxes, planes: the surroundings, in the base frame. tcp: the TCP as a pose in the flange frame [m,
    rad]. tool_radius: radius of a cylinder from the flange to the TCP [m]; 0: no tool. safety_distance: kept by along(),
    examine() and jogs [m].
    """

    def __init__(self, model: str, *, boxes: Sequence[Box] = (), planes: Sequence[Plane] = (), tcp: Floats = ZEROS,
                 tool_radius: float = 0.0, safety_distance: float = 0.01) -> None:
        box_rows = [(box.name, pose_numbers(box.pose, "pose"), [_number(edge, "size", SMALLEST) for edge in
                                                                floats(box.size, "size", 3)]) for box in boxes]
        plane_rows = [(plane.name, pose_numbers(plane.pose, "pose")) for plane in planes]
        self._native = _native.CollisionCheck(model, box_rows, plane_rows, pose_numbers(tcp, "tcp"),
                                              _number(tool_radius, "tool_radius", 0),
                                              _number(safety_distance, "safety_distance", 0))

    def at(self, q: Floats) -> Contact | None:
        """The contact at these joint positions [rad], or None. The safety distance has no effect."""
        return _contact(self._native.at(joint_positions(q, "q")))

    def along(self, path: Sequence[Floats]) -> Contact | None:
        """The first position at which the safety distance is violated on a path of joint positions [rad]. All joints move
        uniformly between two positions. If the path starts within the safety distance,
        only positions closer than the start count."""
        return _contact(self._native.along([joint_positions(q, "path") for q in path]))

    def examine(self, start: Floats, target: Floats, *, linear: bool = False, speed: float | None = None,
                acceleration: float | None = None) -> MoveReport:
        """Examines a move between joint positions [rad]: move_j(), or with linear=True the straight line of
        move_l_to_joints(). speed, acceleration: as in these methods; None: their defaults."""
        values: dict[str, Any] = self._native.examine(
            joint_positions(start, "start"), joint_positions(target, "target"), linear,
            (0.25 if linear else 1.05) if speed is None else _number(speed, "speed", SMALLEST),
            (1.2 if linear else 1.4) if acceleration is None else _number(acceleration, "acceleration", SMALLEST))
        return MoveReport(values["duration"], values["limit"], values["ends"], values["fraction"], values["joint"],
                          _contact(values["contact"]))
