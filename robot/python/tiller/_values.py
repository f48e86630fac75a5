# SPDX-License-Identifier: MIT
"""Conversion and checks of arguments for the C++ library."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from .errors import InvalidArgument

Array = NDArray[np.float64]
Floats = Union[Sequence[float], NDArray[Any]]

if TYPE_CHECKING:
    _Base = np.ndarray[Any, np.dtype[np.float64]]
else:
    _Base = np.ndarray


def floats(values: Floats, name: str, count: int = 6) -> list[float]:
    """Converts to a list of `count` numbers; raises InvalidArgument with the name of the argument."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InvalidArgument(name, "the values are not numbers") from None
    if array.shape != (count,):
        raise InvalidArgument(name, f"{count} numbers are required, not {array.size}")
    if not np.isfinite(array).all():
        raise InvalidArgument(name, "contains NaN, possibly from a sample without data")
    return [float(value) for value in array]


class _SixNumbers(_Base):
    """An array of six numbers with a defined meaning. Adding or subtracting plain numbers keeps the meaning; the result
    of every other operation, slices included, is a plain array."""

    def __new__(cls: type[_Meaning], values: Floats) -> _Meaning:
        return np.array(floats(values, cls.__name__)).view(cls)

    def __getitem__(self, index: Any) -> Any:
        return self.view(np.ndarray)[index]

    def __array_ufunc__(self, ufunc: np.ufunc, method: Any, *inputs: Any, **options: Any) -> Any:
        def plain(values: Any) -> Any:
            return values.view(np.ndarray) if isinstance(values, _SixNumbers) else values

        out = options.get("out")
        if out is not None:
            options["out"] = tuple(plain(one) for one in out)
        result = getattr(ufunc, method)(*(plain(one) for one in inputs), **options)
        if out is not None:
            return out[0] if len(out) == 1 else out
        meanings = [type(one) for one in inputs if isinstance(one, _SixNumbers)]
        keeps = method == "__call__" and ufunc in (np.add, np.subtract) and len(meanings) == 1
        return result.view(meanings[0]) if keeps and result.shape == (6,) else result


_Meaning = TypeVar("_Meaning", bound=_SixNumbers)


class Pose(_SixNumbers):
    """A pose in the base frame: position and rotation vector [m, rad], shape (6,).

    Sample.tcp_pose and forward kinematics are of this type. Calls that expect joint positions refuse a Pose, so a
    pose is never interpreted as joint angles; a plain sequence of six numbers has the meaning that the argument documents.
    """


class Joints(_SixNumbers):
    """Joint positions, base to wrist 3 [rad], shape (6,).

    Sample.q and inverse kinematics are of this type. Calls that expect a pose refuse Joints.
    """


def joint_positions(values: Floats, name: str, other: str = "") -> list[float]:
    """Converts to six joint positions [rad]; raises InvalidArgument for a Pose. other: the function for
    poses."""
    if isinstance(values, Pose):
        hint = f"; use {other} for a pose" if other else ""
        raise InvalidArgument(name, "expected joint positions, got a Pose" + hint)
    return floats(values, name)


def pose_numbers(values: Floats, name: str, other: str = "") -> list[float]:
    """Converts to six numbers of a pose [m, rad]; raises InvalidArgument for Joints. other: the function for
    joint positions."""
    if isinstance(values, Joints):
        hint = f"; use {other} for joint positions" if other else ""
        raise InvalidArgument(name, "expected a pose, got Joints" + hint)
    return floats(values, name)


def one_of(value: Any, name: str, allowed: Iterable[Any]) -> Any:
    """Returns the value if it is allowed; otherwise raises InvalidArgument with a list of the allowed values."""
    values = list(allowed)
    if isinstance(value, bool) or value not in values:
        words = ", ".join(f'"{one}"' if isinstance(one, str) else str(one) for one in values)
        raise InvalidArgument(name, f"{value!r} is not one of {words}")
    return value


ZEROS = [0.0] * 6
