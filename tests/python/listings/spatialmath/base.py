# SPDX-License-Identifier: MIT
import numpy as np


def tr2angvec(R):
    """Angle and axis of a rotation, including half turns."""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    axis = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    if np.linalg.norm(axis) < 1e-6:
        values, vectors = np.linalg.eigh((R + R.T) / 2)
        axis = vectors[:, np.argmax(values)]
        axis = axis * np.sign(axis[np.argmax(np.abs(axis))])
    return angle, axis / np.linalg.norm(axis)
