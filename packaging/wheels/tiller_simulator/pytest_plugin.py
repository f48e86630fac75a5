# SPDX-License-Identifier: MIT
"""The pytest fixture registered by the wheel."""
from __future__ import annotations

from collections.abc import Iterator

import pytest

from . import Simulator


@pytest.fixture
def simulated_controller() -> Iterator[Simulator]:
    """A simulated UR5e, powered on with its brakes released, at a separate address."""
    with Simulator() as simulator:
        yield simulator
