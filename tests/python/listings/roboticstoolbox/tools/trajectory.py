# SPDX-License-Identifier: MIT
import numpy as np
from spatialmath import SE3, base


def ctraj(T0, T1, t):
    """Poses between T0 and T1 with a trapezoidal velocity profile."""
    s = np.asarray(t) / t[-1]
    blend = 0.25
    peak = 1 / (1 - blend)
    course = np.where(s < blend, peak * s ** 2 / (2 * blend),
                      np.where(s > 1 - blend, 1 - peak * (1 - s) ** 2 / (2 * blend), peak * (s - blend / 2)))
    angle, axis = base.tr2angvec(T0.R.T @ T1.R)
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    poses = []
    for part in course:
        turn = np.eye(3) + np.sin(part * angle) * K + (1 - np.cos(part * angle)) * K @ K
        poses.append(SE3(*(T0.t + part * (T1.t - T0.t)), R=T0.R @ turn))
    return poses
