# SPDX-License-Identifier: MIT
"""Offline kinematics with the nominal dimensions of each model.

A real arm differs by its calibration, up to a few millimetres; Robot.inverse_kinematics() takes this into account.
"""
from __future__ import annotations

import numpy as np

from . import _native
from ._arguments import checked
from ._values import ZEROS, Array, Floats, Joints, Pose, joint_positions, pose_numbers
from .errors import NoSolution


def models() -> list[str]:
    """The names of the models, e.g. "UR5e"."""
    return _native.model_names()


@checked
class Kinematics:
    """Forward and inverse kinematics of a model. tcp: the TCP as a pose in the flange frame [m, rad]."""

    def __init__(self, model: str, tcp: Floats = ZEROS) -> None:
        facts = _native.model_facts(model)
        self.model: str = facts["name"]
        self.reach: float = facts["reach"]  #: [m]
        self.max_payload: float = facts["max_payload"]  #: [kg]
        self.max_joint_speed: Array = np.array(facts["max_joint_speed"])  #: [rad/s]
        self.tcp = pose_numbers(tcp, "tcp")

    def forward(self, q: Floats) -> Pose:
        """Pose of the TCP in the base frame [m, rad] for joint positions [rad]."""
        return Pose(_native.forward(self.model, joint_positions(q, "q"), self.tcp))

    def inverse(self, pose: Floats) -> Array:
        """All joint positions [rad] for this pose of the TCP, one per row (0 to 8), each joint in (-pi, pi]."""
        solutions = _native.inverse(self.model, pose_numbers(pose, "pose"), self.tcp)
        return np.array(solutions).reshape(len(solutions), 6)

    def inverse_nearest(self, pose: Floats, near: Floats) -> Joints:
        """The joint positions [rad] for this pose of the TCP that are nearest to `near`. Raises NoSolution."""
        q = _native.inverse_nearest(self.model, pose_numbers(pose, "pose"), self.tcp, joint_positions(near, "near"))
        if q is None:
            raise NoSolution("inverse kinematics", "the pose cannot be reached")
        return Joints(q)

    def jacobian(self, q: Floats) -> Array:
        """The 6 x 6 Jacobian: tool velocity in the base frame [m/s, rad/s] from joint velocities [rad/s]."""
        return _native.jacobian(self.model, joint_positions(q, "q"), self.tcp)

    def __repr__(self) -> str:
        return f"<tiller.Kinematics {self.model}, tcp {self.tcp}>"


def pose_product(a: Floats, b: Floats) -> Pose:
    """The product T_a_c = T_a_b * T_b_c of two poses [m, rad]."""
    return Pose(_native.pose_product(pose_numbers(a, "a"), pose_numbers(b, "b")))


def pose_inverse(pose: Floats) -> Pose:
    """T_b_a, the inverse of the pose T_a_b [m, rad]."""
    return Pose(_native.pose_inverse(pose_numbers(pose, "pose")))
