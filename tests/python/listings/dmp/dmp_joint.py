# SPDX-License-Identifier: MIT
"""The part of a joint-space dynamic movement primitive that listing 4 uses: a spring towards the goal, and a forcing
term that is learned from the demonstration and decays with the phase."""
import numpy as np


class CanonicalSystem:
    ALPHA = 25.0

    def __init__(self):
        self.xi = 1.0

    def step(self, dt, tau):
        self.xi *= np.exp(-self.ALPHA * dt / tau)
        return self.xi


class JointDMP:
    K = 1000.0

    def __init__(self, n_bfs):
        self.cs = CanonicalSystem()
        self._centres = np.exp(-CanonicalSystem.ALPHA * np.linspace(0, 1, n_bfs))
        self._widths = 1.0 / np.gradient(self._centres) ** 2

    def _forcing(self, xi):
        psi = np.exp(-self._widths * (xi - self._centres) ** 2)
        return xi * psi / (psi.sum() + 1e-12)

    def train(self, positions, times, tau):
        d = 2 * np.sqrt(self.K)
        dq = np.gradient(positions, times, axis=0) * tau
        ddq = np.gradient(dq, times, axis=0) * tau
        self._start, self._goal = positions[0], positions[-1]
        wanted = ddq + d * dq - self.K * (self._goal - positions)
        phases = np.exp(-CanonicalSystem.ALPHA * times / tau)
        features = np.array([self._forcing(xi) for xi in phases])
        self._weights = np.linalg.lstsq(features, wanted, rcond=1e-6)[0]

    def reset(self):
        self.cs.xi = 1.0
        self._q = self._start.copy()
        self._dq = np.zeros_like(self._q)

    def step(self, xi, dt, tau):
        d = 2 * np.sqrt(self.K)
        ddq = self.K * (self._goal - self._q) - d * self._dq + self._forcing(xi) @ self._weights
        self._dq = self._dq + ddq * dt / tau
        self._q = self._q + self._dq * dt / tau
        return self._q, self._dq / tau, ddq / tau ** 2
