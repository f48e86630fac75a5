# SPDX-License-Identifier: MIT
"""Exceptions, one class for each error code of the C++ library.

All are `tiller.Error`; those with a Python equivalent are derived from it as well (Timeout is a TimeoutError,
InvalidArgument a ValueError, LinkLost a ConnectionError), so that ordinary `except` clauses work.
"""
from __future__ import annotations


class Error(Exception):
    """Base class of all exceptions of this package; tiller.errors has a class for each code.

    code: stable name for programs ("ConnectionRefused"). context: the attempted action and its object;
    for a file: the path.
    controller_message: original message of the controller or the system, may be empty.
    """

    code = "Internal"

    def __init__(self, context: str = "", controller_message: str = "") -> None:
        super().__init__(context, controller_message)
        self.context = context
        self.controller_message = controller_message

    def __str__(self) -> str:
        """Context and message. A traceback prints the name of the class before it."""
        if self.context and self.controller_message:
            return f"{self.context} ({self.controller_message})"
        return self.context or self.controller_message or self.code


class AddressInvalid(Error, ValueError):
    """Not an IP address or a host name that can be resolved."""

    code = "AddressInvalid"


class HostUnreachable(Error, ConnectionError):
    """No route, or no response."""

    code = "HostUnreachable"


class ConnectionRefused(Error, ConnectionRefusedError):
    """The host responds, but no process listens on the port."""

    code = "ConnectionRefused"


class ConnectionClosed(Error, ConnectionError):
    """The peer ended the connection."""

    code = "ConnectionClosed"


class Timeout(Error, TimeoutError):
    """No response in time. The motion that the call waited for continues."""

    code = "Timeout"


class Cancelled(Error):
    """The caller cancelled the wait."""

    code = "Cancelled"


class LinkLost(Error, ConnectionError):
    """No more data arrive on an established connection."""

    code = "LinkLost"


class ProtocolError(Error):
    """The received bytes violate the protocol."""

    code = "ProtocolError"


class VersionUnsupported(Error):
    """Not supported by the controller's software version."""

    code = "VersionUnsupported"


class FieldUnknown(Error, LookupError):
    """The RTDE field does not exist, or this controller does not have it."""

    code = "FieldUnknown"


class RegisterInUse(Error):
    """An RTDE input is used by another client or a fieldbus."""

    code = "RegisterInUse"


class NotConnected(Error):
    """There is no connection."""

    code = "NotConnected"


class NotInControl(Error):
    """The control program is not running: call take_control()."""

    code = "NotInControl"


class UnsafeState(Error):
    """Not allowed in the current robot mode or safety mode."""

    code = "UnsafeState"


class RemoteControlRequired(Error):
    """The robot is in local control: switch it to remote control on the teach pendant."""

    code = "RemoteControlRequired"


class LimitExceeded(Error, ValueError):
    """A value or target is outside the allowed range."""

    code = "LimitExceeded"


class InvalidArgument(Error, ValueError):
    """An invalid argument: wrong size, NaN, not an allowed value, or a value that suggests a wrong unit."""

    code = "InvalidArgument"


class NoSolution(Error):
    """The arm cannot reach the pose."""

    code = "NoSolution"


class Stopped(Error):
    """Stopped before the command was complete; the message contains the cause."""

    code = "Stopped"


class Rejected(Error):
    """The controller refused the request."""

    code = "Rejected"


class ScriptError(Error):
    """The controller could not compile or run a script; the message contains line and text."""

    code = "ScriptError"


class FileNotReadable(Error, OSError):
    """A file cannot be read."""

    code = "FileNotReadable"


class FileNotWritable(Error, OSError):
    """A file cannot be written."""

    code = "FileNotWritable"


class FileCorrupt(Error, ValueError):
    """The content of a file is invalid."""

    code = "FileCorrupt"


class DiskFull(Error, OSError):
    """The disk is full."""

    code = "DiskFull"


class Internal(Error):
    """A defect of this library."""


_BY_CODE = {cls.code: cls for cls in Error.__subclasses__()}


def error_type(code: str) -> type[Error]:
    """The exception class of a code."""
    return _BY_CODE.get(code, Internal)
