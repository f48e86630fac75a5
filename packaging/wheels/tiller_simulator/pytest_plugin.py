# SPDX-License-Identifier: MIT
"""The fixture for pytest, which the wheel registers."""
from __future__ import annotations

from collections.abc import Iterator

import pytest

from . import Simulator


@pytest.fixture
def simulated_controller() -> Iterator[Simulator]:
    """A simulated UR5e, powered on with its brakes released, at an address of its own."""
    with Simulator() as simulator:
        yield simulator
