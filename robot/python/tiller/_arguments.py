# SPDX-License-Identifier: MIT
"""Readable type errors instead of those of the C++ binding."""
from __future__ import annotations

import functools
import inspect
import types
from collections.abc import Callable
from typing import Any, TypeVar

_Class = TypeVar("_Class", bound=type)
_Call = TypeVar("_Call", bound=Callable[..., Any])

_BINDING = ("incompatible function arguments. The following", "incompatible constructor arguments. The following")


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _is_whole(value: Any) -> bool:
    return hasattr(value, "__index__")


def _is_number(value: Any) -> bool:
    return hasattr(value, "__float__") or _is_whole(value)


def _is_truth(value: Any) -> bool:
    return hasattr(value, "__bool__")


def _each(check: Callable[[Any], bool]) -> Callable[[Any], bool]:
    def checked(values: Any) -> bool:
        return not isinstance(values, str) and hasattr(values, "__iter__") and all(check(value) for value in values)
    return checked


_KINDS: dict[str, tuple[str, Callable[[Any], bool]]] = {
    "float": ("a number", _is_number), "int": ("a whole number", _is_whole), "bool": ("True or False", _is_truth),
    "str": ("a string", _is_text), "Sequence[int]": ("whole numbers", _each(_is_whole)),
    "Sequence[str]": ("strings", _each(_is_text))}


def _explained(function: Callable[..., Any], args: tuple[Any, ...], options: dict[str, Any]) -> str:
    signature = inspect.signature(function)
    name = f"{function.__qualname__}()".replace(".__init__", "")
    for parameter, value in signature.bind(*args, **options).arguments.items():
        annotation = str(signature.parameters[parameter].annotation)
        kind = _KINDS.get(annotation.removesuffix(" | None"))
        if kind is None or (value is None and annotation.endswith(" | None")) or kind[1](value):
            continue
        return f"{name}: {parameter} must be {kind[0]}, not {value!r} ({type(value).__name__})"
    return f"{name}: an argument has the wrong type or is out of range"


def _is_of_binding(error: TypeError) -> bool:
    """True if the error was raised by a call into the C++ binding, not by a user callback."""
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    module = "" if trace is None else str(trace.tb_frame.f_globals.get("__name__", ""))
    return module.startswith(__package__ or "tiller") and any(text in str(error) for text in _BINDING)


def checked_call(function: _Call) -> _Call:
    """Returns a function whose TypeError names the argument, the expected type, and the value."""
    @functools.wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        try:
            return function(*args, **options)
        except TypeError as error:
            if not _is_of_binding(error):
                raise
            text = _explained(function, args, options)
        raise TypeError(text)

    return call  # type: ignore[return-value]


def checked(cls: _Class) -> _Class:
    """Applies checked_call() to every public method, the constructor and the setters of a class."""
    for name, member in list(vars(cls).items()):
        if name.startswith("_") and name != "__init__":
            continue
        if isinstance(member, types.FunctionType):
            setattr(cls, name, checked_call(member))
        elif isinstance(member, property) and member.fset is not None:
            setattr(cls, name, property(member.fget, checked_call(member.fset), member.fdel, member.__doc__))
    return cls
