# SPDX-License-Identifier: MIT
"""Numbers on their way into the C++ library."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidArgument

Array = NDArray[np.float64]
Floats = Union[Sequence[float], NDArray[Any]]


def floats(values: Floats, name: str, count: int = 6) -> list[float]:
    """So many numbers, or InvalidArgument that names the argument."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InvalidArgument(name, "these are not numbers") from None
    if array.shape != (count,):
        raise InvalidArgument(name, f"{count} numbers are needed, not {array.size}")
    if not np.isfinite(array).all():
        raise InvalidArgument(name, "not a number: is it from a sample that was not there?")
    return [float(value) for value in array]


ZEROS = [0.0] * 6
