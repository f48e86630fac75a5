# SPDX-License-Identifier: MIT
"""The part of Spatial Maths for Python that listing 5 uses."""
import numpy as np

from . import base


class SE3:
    def __init__(self, x=0.0, y=0.0, z=0.0, R=None):
        self.t = np.array([x, y, z], dtype=float)
        self.R = np.eye(3) if R is None else R

    @classmethod
    def Ry(cls, angle):
        c, s = np.cos(angle), np.sin(angle)
        return cls(R=np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]))

    def __matmul__(self, other):
        return SE3(*(self.R @ other.t + self.t), R=self.R @ other.R)
