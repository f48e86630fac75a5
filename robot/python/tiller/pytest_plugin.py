# SPDX-License-Identifier: MIT
"""Fixtures for pytest. The wheel registers them; elsewhere: pytest_plugins = ["tiller.pytest_plugin"]."""
from __future__ import annotations

from collections.abc import Iterator

import pytest

from .robot import Robot
from .simulator import Simulator


@pytest.fixture
def tiller_simulator() -> Iterator[Simulator]:
    """A simulated UR5e in virtual time, powered on with its brakes released."""
    with Simulator(virtual=True) as simulator:
        yield simulator


@pytest.fixture
def tiller_robot(tiller_simulator: Simulator) -> Iterator[Robot]:
    """A Robot connected to tiller_simulator and in control of it."""
    with tiller_simulator.robot() as robot:
        robot.take_control()
        yield robot
